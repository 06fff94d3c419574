"""Scene files in TOML: `ball_diameter = "7.94 mm"` is 0.00794 (m) in Python.

`analytic.scenefile.tables` lists the keys. Every message is one line with the key, the value and what is accepted.
"""

import os
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import Any, Unpack

import numpy as np
from pydantic import ValidationError

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.errors import InputError
from analytic.report_details import ReportDetails
from analytic.scene import (
    Array,
    Bearing,
    Cage,
    ContactAngle,
    Land,
    Losses,
    Material,
    Operation,
    Scene,
    Surface,
)
from analytic.scenefile import fit
from analytic.scenefile.assumption import usual_document
from analytic.scenefile.bearing import BALLS, bearing_faults, bearing_of, catalog_row, has_other_balls, with_catalog
from analytic.scenefile.by_temperature import SceneByTemperature, thermal_faults
from analytic.scenefile.choice import KEYS, OperatingOptions, SceneOptions, require_nothing_beside
from analytic.scenefile.find import FoundScene, find_scene
from analytic.scenefile.installation import arranged, in_operation, installation_faults
from analytic.scenefile.keys import fault_at, faults_of, with_key
from analytic.scenefile.losses import losses_of
from analytic.scenefile.measured import read_measured, with_oils
from analytic.scenefile.oil import lubricant_of
from analytic.scenefile.setting import read_choice, read_setting, with_columns, with_settings
from analytic.scenefile.spread_tables import given_assumptions, given_spreads
from analytic.scenefile.surface import surface_conflicts, surface_of
from analytic.scenefile.tables import (
    BearingTable,
    CageTable,
    FrictionTable,
    OperationTable,
    SceneTable,
    SurfaceTable,
)
from analytic.scenefile.text import parse_text
from analytic.scenefile.usual_cage import FRICTION, ORIGINS, entry_of_cage
from analytic.words import shown

AS_PRINTED = "as_printed"  # the cage of the paper: the only variant whose pockets may overlap, with a warning
# Thrust over radial load times tan(angle) at which all balls of a bearing whose ring stays straight, and half of them,
# are loaded: 1.67 and 1.22 by the integrals of the load distribution [Harris2007], rounded up.
SEATED, HALF_SEATED = 1.7, 1.25
NOTHING_SET: Mapping[str, Any] = MappingProxyType({})
LEAST_CAGED = 1e-4  # m: the assumed cage of a smaller ball would be thinner than a scene may say
MOST_FAULTS = 5  # in one message; the others are counted


def load_scene(
    scene: str | os.PathLike[str],
    *,
    measured: str | os.PathLike[str] | None = None,
    settings: Mapping[str, Any] = NOTHING_SET,
    **options: Unpack[OperatingOptions],
) -> Scene:
    """The scene that a TOML file describes; or a built-in scene, or a bearing of the catalog, by its name.

    Parameters
    ----------
    scene : str or path
        A file, a built-in scene as "6205-dry", or a bearing of the catalog as "6206".
    measured : str or path, optional
        CSV file of measured torques, in place of the scene's [measured]; None: that one, if there is one. A bearing of
        the catalog has no usual load beside the loads of this file.
    settings : mapping of str to value, optional
        Values by keys of a scene, as {"lubricant.supply": "grease"}, in place of the scene's own: numbers in SI, texts
        as they are typed ("60C", "2,5 kN"), quantities, or lists.
    **options : float, str or list
        Likewise, with the names of the options of `fembearing torque`: axial_load and radial_load, N, speed, rad/s,
        oil, temperature, K, and supply. A text without a unit for a speed is in rpm.

    Returns
    -------
    Scene
        In SI.

    Raises
    ------
    InputError
        A name that is none of these; a file that cannot be read, is too large or is not TOML; a key that is unknown,
        missing, without its unit, out of range or in conflict with other keys; measured torques likewise.
    """
    return load_by_temperature(scene, measured=measured, settings=settings, **options).fixed


def load_by_temperature(
    scene: str | os.PathLike[str],
    *,
    measured: str | os.PathLike[str] | None = None,
    settings: Mapping[str, Any] = NOTHING_SET,
    columns: Mapping[str, Any] = NOTHING_SET,
    **options: Unpack[OperatingOptions],
) -> SceneByTemperature:
    """The scene at any temperature of its oil; arguments and errors of `load_scene`, which refuses [thermal].

    columns : of a file of operating points, by name, SI; with `measured` those of that file. A bearing of the catalog
        then has no usual load beside theirs.
    """
    choice, notes = read_choice(options)
    found = find_scene(scene, choice=choice)
    if found.designation is None:
        return _with_settings(found, _with_options(settings, options), measured)
    columns = columns if measured is None else vars(read_measured(measured))
    found = find_scene(scene, choice=with_settings(with_columns(choice, columns), settings))
    _with_options(settings, options)  # refuses a key that both give
    read = _with_settings(found, settings, measured)
    _refuse_temperature(read, "temperature", options)
    return _warned(read, notes)


def _with_options(settings: Mapping[str, Any], options: Mapping[str, Any]) -> dict[str, Any]:
    """The settings with the keys of options. Raises InputError for a key that both give, or an unknown option."""
    given = {KEYS[name]: value for name, value in options.items() if value is not None}
    for name, value in options.items():
        if value is not None and KEYS[name] in settings:
            raise InputError(f"{name} = {shown(value)} and {KEYS[name]} are the same: leave one of them out")
    return {**settings, **given}


def any_by_temperature(
    scene: str | os.PathLike[str] | Scene, *, columns: Mapping[str, Any] = NOTHING_SET, **given: Unpack[SceneOptions]
) -> SceneByTemperature:
    """The scene of a name, by `load_by_temperature`; or a Scene, whose oil has one temperature.

    Raises InputError as that, and for an argument that goes with a name alone.
    """
    if not isinstance(scene, Scene):
        return load_by_temperature(scene, columns=columns, **given)
    require_nothing_beside(given)
    return SceneByTemperature(scene=scene, origin=scene.name, oil=None, thermal=None)


def parse_scene(
    text: str,
    *,
    origin: str,
    folder: Path = Path(),
    measured: str | os.PathLike[str] | None = None,
    settings: Mapping[str, Any] = NOTHING_SET,
) -> Scene:
    """The scene that TOML text describes.

    Parameters
    ----------
    text : str
        Of a scene file.
    origin : str
        Names the text in messages.
    folder : Path
        That the paths in the text start from; the working folder by default.
    measured : str or path, optional
        As in `load_scene`.
    settings : mapping of str to value, optional
        As in `load_scene`.

    Returns
    -------
    Scene
        In SI.

    Raises
    ------
    InputError
        As `load_scene`.
    """
    return parse_by_temperature(text, origin=origin, folder=folder, measured=measured, settings=settings).fixed


def parse_by_temperature(
    text: str,
    *,
    origin: str,
    folder: Path = Path(),
    measured: str | os.PathLike[str] | None = None,
    settings: Mapping[str, Any] = NOTHING_SET,
    **options: Unpack[OperatingOptions],
) -> SceneByTemperature:
    """The scene at any temperature of its oil; arguments and errors of `parse_scene`, which refuses [thermal].

    options : as of `load_scene`
    """
    read_choice(options)  # refuses unknown ones
    return _with_settings(
        FoundScene(document=parse_text(text, origin=origin), origin=origin, folder=folder),
        _with_options(settings, options),
        measured,
    )


def _with_settings(
    found: FoundScene, settings: Mapping[str, Any], measured: str | os.PathLike[str] | None
) -> SceneByTemperature:
    document, notes = usual_document(found, settings), []
    for path, given in settings.items():
        value, told = read_setting(path, given)
        document = with_key(document, path, value)
        notes += told
    read = _by_temperature(document, origin=found.origin, folder=found.folder, measured=measured)
    _refuse_temperature(read, KEYS["temperature"], settings)
    return _warned(read, notes)


def _refuse_temperature(read: SceneByTemperature, name: str, given: Mapping[str, Any]) -> None:
    """Raises InputError for a temperature that someone gives beside a scene whose file may have one unused."""
    if read.thermal is not None and given.get(name) is not None:
        raise InputError(
            f"{read.origin}: {name} = {shown(given[name])} and [thermal] both determine the oil temperature: leave one "
            "of them out"
        )


def _warned(read: SceneByTemperature, notes: Iterable[str]) -> SceneByTemperature:
    return replace(read, scene=replace(read.scene, warnings=(*read.scene.warnings, *notes)))


def scene_of(
    document: dict[str, Any],
    *,
    origin: str,
    folder: Path = Path(),
    measured: str | os.PathLike[str] | None = None,
) -> Scene:
    """The scene that a parsed TOML document describes; the arguments and errors of load_scene and parse_scene.

    The entries of the catalog are put into the document.
    """
    return _by_temperature(document, origin=origin, folder=folder, measured=measured).fixed


def _by_temperature(
    document: dict[str, Any], *, origin: str, folder: Path, measured: str | os.PathLike[str] | None
) -> SceneByTemperature:
    bearing, cage, row = document.get("bearing"), document.get("cage"), None
    own, own_cage = (table if isinstance(table, dict) else {} for table in (bearing, cage))
    try:
        row = catalog_row(own)
    except InputError as problem:
        faults = [f"bearing.catalog: {problem}"]
    else:
        faults = _put_catalog(document, row)
    if not faults:
        try:
            table = SceneTable.model_validate(document)
        except ValidationError as problem:
            faults = faults_of(document, problem.errors(include_url=False))
        else:
            scene, found = None, list(_conflicts(document, table, own, row))
            if not found:
                scene, found = _scene(table, (own, own_cage), row, folder)
            if scene is not None and not found:
                read = _with_measured(scene, table, folder, measured)
                return SceneByTemperature(scene=read, origin=origin, oil=table.lubricant, thermal=table.thermal)
            faults = [fault_at(document, key, problem) for key, problem in found]
    more = f"; and {len(faults) - MOST_FAULTS} more" if len(faults) > MOST_FAULTS else ""
    raise InputError(f"{origin}: " + "; ".join(faults[:MOST_FAULTS]) + more)


def _put_catalog(document: dict[str, Any], row: CatalogBearing | None) -> list[str]:
    """Put bearing, grease and cage of the catalog into the document, whose own keys win; return the faults."""
    bearing, cage = document.get("bearing"), document.get("cage")
    catalog_cage: dict[str, Any] = {}
    if isinstance(bearing, dict):
        bearing = with_catalog(bearing, row)
        catalog_cage = bearing.pop("cage", {})
        document["bearing"] = bearing
    oil, is_closed = document.get("lubricant"), row is not None and bool(row.seal_suffixes)
    if is_closed and isinstance(oil, dict):
        document["lubricant"] = {"supply": "grease"} | oil  # seals and shields hold grease for life
    variants = catalog_cage.pop("variants", {})
    if isinstance(cage, dict):
        own_pocket = [key for key in cage if key.startswith("pocket_")]
        if "variant" in cage:
            if cage["variant"] not in tuple(variants):
                known = f"give one of {', '.join(variants)}" if variants else "this bearing has none"
                return [fault_at(document, "cage.variant", f"is not a variant of the cage; {known}")]
            if own_pocket and any(key.startswith("pocket_") for key in variants[cage["variant"]]):
                return [fault_at(document, f"cage.{own_pocket[0]}", "comes with cage.variant; leave out one of them")]
            cage = variants[cage["variant"]] | cage
        if "pocket_clearance" in cage or "pocket_diameter" in cage:
            catalog_cage.pop("pocket_clearance", None)
        document["cage"] = catalog_cage | cage
    return []


def _conflicts(
    document: dict[str, Any], table: SceneTable, own: Mapping[str, Any], row: CatalogBearing | None
) -> Iterator[tuple[str, str]]:
    """(key, problem) of keys that are valid on their own and in conflict with each other; own, row : as for _scene."""
    angle, cage, loads = table.bearing.contact_angle, table.cage, table.operation
    if angle.rule == "given" and not angle.value:
        yield "bearing.contact_angle.value", 'must be above 0 with rule = "given", for example "0.18 rad"'
    elif angle.rule == "given" and angle.free is not None:
        yield "bearing.contact_angle.free", 'goes with rule = "solved"; leave it out'
    if angle.rule == "solved" and angle.value is not None:
        yield "bearing.contact_angle.value", 'goes with rule = "given"; use free = ... or leave it out'
    yield from bearing_faults(table.bearing, own, row)
    yield from installation_faults(table)
    if isinstance(loads.tilt, float) and "moment" in loads.model_fields_set:
        yield "operation.tilt", "holds the ring, and operation.moment tilts it; leave one of them out"
    if loads.tilt not in (None, "free", 0.0) and angle.rule == "given":
        yield "operation.tilt", 'changes the contact angles, which rule = "given" holds; use "solved", or leave it out'
    given = {key: getattr(loads, key) for key in document["operation"] if key not in ("down", "tilt")}
    lists = {key: each for key, each in given.items() if len(each) > 1 or isinstance(document["operation"][key], list)}
    if len({len(each) for each in lists.values()}) > 1:
        counts = " and ".join(f"operation.{key} has {len(each)}" for key, each in lists.items())
        yield "", f"{counts} values; lists are paired: give equal lengths, or one quantity for the whole series"
    else:
        is_preloaded = table.arrangement is not None and table.arrangement.kind != "tandem"
        points = np.broadcast(loads.axial_load, loads.radial_load, loads.moment)
        if not is_preloaded and not all(any(point) for point in points):
            problem = 'leaves a point without any load; give for example "1000 N", or a radial load or a moment'
            yield "operation.axial_load", problem
        yield from (("operation.axial_load", problem) for problem in _apart(table, row))
    if cage is not None and (cage.pocket_clearance is None) == (cage.pocket_diameter is None):
        yield "", "cage needs exactly one of pocket_clearance and pocket_diameter"
    if table.friction is not None and table.friction.coefficient is None and table.lubricant is None:
        problem = "is missing; give for example 0.1, or the tables [lubricant] and [surface] instead"
        yield "friction.coefficient", problem
    if table.surface is not None:
        yield from surface_conflicts(table.surface)
    yield from thermal_faults(table)
    if table.lubricant is not None:
        try:
            lubricant_of(table.lubricant, ball_radius=table.bearing.ball_diameter / 2)
        except InputError as problem:
            yield "", str(problem)
    for name in ("cage", "cage_dynamics", "ball_dynamics"):
        has_cage = cage is not None or _assumes_cage(table, row)
        if not has_cage and getattr(table.effects, name) == "on":
            yield f"effects.{name}", "needs a table [cage]; give one, or leave the effect out"


def _seating(table: SceneTable, row: CatalogBearing | None) -> Iterator[tuple[float, float]]:
    """(thrust, radial load times tan(angle)), N, of each point of a single angular contact bearing of the catalogue."""
    if row is None or row.nominal_angle is None or table.arrangement is not None:
        return
    tangent = float(np.tan(row.nominal_angle))
    for thrust, side in np.broadcast(table.operation.axial_load, table.operation.radial_load):
        yield float(thrust), abs(float(side)) * tangent


def _apart(table: SceneTable, row: CatalogBearing | None) -> Iterator[str]:
    """Why a radial load alone is none that a single angular contact bearing carries."""
    alone = [spread for thrust, spread in _seating(table, row) if spread and not thrust]
    if alone:
        needed = float(f"{SEATED * max(alone):.3g}")
        yield f"lets an angular contact bearing slide apart; give some {needed:g} N of thrust, or an [arrangement]"


def _loose(table: SceneTable, row: CatalogBearing | None) -> Iterator[str]:
    """A warning where too little thrust loads fewer than half of the balls."""
    if any(thrust < HALF_SEATED * spread for thrust, spread in _seating(table, row)):
        yield (
            f"the thrust loads fewer than half of the balls of this angular contact bearing: {HALF_SEATED:g} times the "
            "radial load times tan(contact angle) loads half of them where the ring is held straight, "
            + ("and a ring that tilts freely needs more" if table.operation.is_free else f"{SEATED:g} times all")
        )


def _scene(
    table: SceneTable, tables: tuple[Mapping[str, Any], Mapping[str, Any]], row: CatalogBearing | None, folder: Path
) -> tuple[Scene, list[tuple[str, str]]]:
    """The scene, and (key, problem) for everything in it that does not fit together.

    tables, row : the scene's own tables of bearing and cage, and the bearing's row of the catalogue
    """
    own, own_cage = tables
    bearing = bearing_of(table.bearing, own=own, row=row)
    if row is not None and row.other_candidate is not None and row.grade == "C" and not {*BALLS} & {*own}:
        others = table.bearing.model_copy(update=dict(zip(BALLS, row.other_candidate, strict=True)))
        bearing = replace(bearing, other_candidate=bearing_of(others, own=own, row=row))
    angle = ContactAngle(**table.bearing.contact_angle.model_dump(exclude={"nominal"}))
    if bearing.kind == "thrust":
        angle = ContactAngle(rule="given", value=np.pi / 2)
    misfits = list(fit.bearing_misfits(bearing, gap_key=_gap_key(table.bearing), own=own))
    delivered, clearances = bearing, None
    if table.mounting is not None and not misfits:
        bearing, clearances, problems = in_operation(bearing, table.mounting)
        misfits += problems
    arrangement, unplaced = None, []
    if table.arrangement is not None and not misfits:
        arrangement, unplaced = arranged(table.arrangement, bearing, angle)
    cage = None
    if not misfits:
        misfits += fit.angle_misfits(bearing, angle) if bearing.kind == "radial" else ()
        cage, unfit = _cage_of(table, delivered, own_cage, row)
        misfits += unfit
    surface, unread = _surface(table.surface, folder)
    misfits += [*unread, *fit.surface_misfits(surface, bearing, cage, is_lubricated=table.lubricant is not None)]
    losses = Losses()
    if not misfits:
        try:
            losses = losses_of(table.losses, delivered, row)
        except InputError as problem:
            misfits.append(("losses.seals", f"is refused: {problem}"))
    friction = table.friction or FrictionTable()
    is_left_out = cage is None and (row is not None or "cage" in table.model_fields_set)
    effects = table.effects.model_copy(update={"cage": "off"}) if is_left_out else table.effects
    scene = Scene(
        name=table.name,
        tolerance=table.tolerance,
        bearing=bearing,
        contact_angle=angle,
        clearances=clearances,
        arrangement=arrangement,
        operation=_operation(table.operation),
        down=table.operation.down,
        cage=cage,
        lubricant=table.lubricant and lubricant_of(table.lubricant, ball_radius=bearing.ball_diameter / 2),
        surface=surface,
        friction_coefficient=friction.coefficient,
        **friction.model_dump(exclude={"coefficient"}),
        losses=losses,
        effects=MappingProxyType(effects.model_dump()),
        calibration=table.calibration,
        report=ReportDetails(**table.report.model_dump()),
        warnings=(*_of_designation(table.bearing, own, row), *_loose(table, row), *fit.warnings(bearing, cage)),
    )
    spreads, unfitting = given_spreads(table.uncertainty, scene)
    sources, unmatched = given_assumptions(table.assumed, scene)
    scene = replace(scene, uncertainty=MappingProxyType(spreads), assumed=MappingProxyType(sources))
    return scene, [*misfits, *unplaced, *unfitting, *unmatched]


def _of_designation(given: BearingTable, own: Mapping[str, Any], row: CatalogBearing | None) -> Iterator[str]:
    """The warnings of the catalogue's row, without those on balls that the scene replaces."""
    if row is not None:
        replaced = row.ball_warnings if has_other_balls(given, own, row) else ()
        yield from (warning for warning in row.warnings if warning not in replaced)


def _surface(given: SurfaceTable | None, folder: Path) -> tuple[Surface | None, list[tuple[str, str]]]:
    """The surface, and (key, problem) for a height map that cannot be read."""
    if given is None:
        return None, []
    try:
        surface = surface_of(given, folder)
    except InputError as problem:
        return None, [("surface.height_map.path", str(problem))]
    if surface.height_map is None or os.path.isfile(surface.height_map.path):
        return surface, []
    return None, [("surface.height_map.path", "is not a file; give its path from the scene file's folder")]


def _with_measured(scene: Scene, table: SceneTable, folder: Path, given: str | os.PathLike[str] | None) -> Scene:
    """The scene with its measured torques, if there are any; given : their file, in place of that of [measured]."""
    if given is None and table.measured is not None:
        given = folder / table.measured.file
    if given is None:
        return scene
    found = read_measured(given)
    radius = scene.bearing.ball_radius
    return replace(scene, measured=with_oils(found, table.lubricant, scene.lubricant, ball_radius=radius))


def _gap_key(given: BearingTable) -> str:
    """The path of the key that says how far the rings are apart."""
    if given.clearance is not None:
        return "bearing.clearance"
    said = given.contact_angle.nominal is not None
    return "bearing.contact_angle.nominal" if said else fit.BOTTOM


def _assumes_cage(table: SceneTable, row: CatalogBearing | None) -> bool:
    """Whether the scene says nothing of the cage of a bearing of the catalogue, nor of its pockets."""
    return row is not None and "cage" not in table.model_fields_set and table.losses.pockets is None


def _cage_of(
    table: SceneTable, bearing: Bearing, own: Mapping[str, Any], row: CatalogBearing | None
) -> tuple[Cage | None, list[tuple[str, str]]]:
    """The cage of a bearing as it is delivered, and (key, problem) for what does not fit; own : the scene's own table.

    One that is assumed fits, and rests on its balls; None where the balls leave no web, or are tiny.
    """
    if _assumes_cage(table, row):
        entry = entry_of_cage(bearing, () if row is None else row.suffixes.values())
        if not entry or bearing.ball_diameter < LEAST_CAGED:
            return None, []
        usual = CageTable.model_validate(entry | {"friction_coefficient": FRICTION})
        return replace(_cage(usual, bearing, assumed=ORIGINS), gives_way=True), []
    if table.cage is None:
        return None, []
    cage = _cage(table.cage, bearing, assumed=() if row is None else {*ORIGINS} - {*own})
    pocket = "pocket_clearance" if table.cage.pocket_diameter is None else "pocket_diameter"
    overlaps = table.cage.variant == AS_PRINTED
    return cage, [*fit.cage_misfits(bearing, cage, pocket=pocket, pockets_may_overlap=overlaps)]


def _cage(given: CageTable, bearing: Bearing, *, assumed: Collection[str]) -> Cage:
    """assumed : keys that the scene leaves to the catalogue, as far as they are given"""
    diameter = given.pocket_diameter or bearing.ball_diameter + (given.pocket_clearance or 0.0)
    approach = given.pocket_approach
    derived = {"variant", "pocket_clearance", "pocket_diameter", "pocket_depth", "pocket_approach", "material", "land"}
    said = {key for key in ORIGINS if getattr(given, key) is not None}
    return Cage(
        **given.model_dump(exclude=derived),
        origins=MappingProxyType({key: ORIGINS[key] for key in assumed if key in said}),
        pocket_diameter=diameter,
        pocket_depth=diameter / 2 if given.pocket_depth is None else given.pocket_depth,
        pocket_stiffness=None if approach is None else approach.load / approach.approach**1.5,
        material=Material(**given.material.model_dump()),
        land=None if given.land is None else Land(**given.land.model_dump()),
    )


def _operation(given: OperationTable) -> Operation:
    series = given.model_dump(exclude={"down", "tilt"})
    values = np.broadcast_arrays(*(np.array(value) for value in series.values()))
    tilt = "free" if given.is_free else given.tilt
    return Operation(tilt=tilt, **{key: _frozen(value) for key, value in zip(series, values, strict=True)})


def _frozen(values: Array) -> Array:
    values = values.copy()
    values.flags.writeable = False
    return values
