"""Scene files in TOML: `ball_diameter = "7.94 mm"` is 0.00794 (m) in Python.

`analytic.scenefile.keys` has the keys. File, options, settings and keywords make one document; the usual values of a
bearing fill what nobody gives, its keys are read into SI, and the catalogue fills what is still open. Every message is
one line with the key, the value and what is accepted.

An oil is known over the temperature by its name or by two viscosities; a single viscosity with a slope is not enough
for the tens of kelvins over which a bearing warms.
"""

import os
from collections.abc import Collection, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any, Unpack, get_args

import numpy as np

from analytic.declared import read_only
from analytic.errors import InputError
from analytic.given import OperatingOptions, SceneOptions
from analytic.quantity import SI
from analytic.scene import Array, Bearing, Cage, ContactAngle, Decision, EffectName, Losses, Operation, Scene, Thermal
from analytic.scenefile import fit
from analytic.scenefile.bearing import (
    BALLS,
    bearing_faults,
    bearing_of,
    fill_from_catalog,
    has_other_balls,
    has_own_balls,
    shoulder_faults,
)
from analytic.scenefile.columns import OPERATING, key_of_column, operating_column, read_measured, with_oils
from analytic.scenefile.fill import BALL, apply_rules, rivals_of
from analytic.scenefile.find import FoundScene, find_scene, parse_text
from analytic.scenefile.inputs import with_spreads
from analytic.scenefile.keys import (
    BESIDE,
    Values,
    fault_at,
    faults_of,
    read_document,
    scene_table,
    with_key,
    without_key,
)
from analytic.scenefile.kinds import GivenViscosity
from analytic.scenefile.oil import lubricant_of
from analytic.scenefile.setting import given_values, in_si, require_nothing_beside
from analytic.scenefile.tables import (
    arranged,
    in_operation,
    installation_faults,
    losses_of,
    surface_conflicts,
    surface_of,
)
from analytic.scenefile.usual import FRICTION, ORIGINS, assumed_cage, told_values, usual_values
from analytic.words import shown

AS_PRINTED = "as_printed"  # the cage of the paper: the only variant whose pockets may overlap, with a warning
# Thrust over radial load times tan(angle) at which all balls of a bearing whose ring stays straight, and half of them,
# are loaded: 1.67 and 1.22 by the integrals of the load distribution [Harris2007], rounded up.
SEATED, HALF_SEATED = 1.7, 1.25
NOTHING_SET: Mapping[str, Any] = MappingProxyType({})
LEAST_CAGED = 1e-4  # m: the assumed cage of a smaller ball would be thinner than a scene may say
NO_CAGE = "cage = none"
SERIES = ("axial_load", "inner_speed", "radial_load", "moment")
MOST_FAULTS = 5  # in one message; the others are counted

ZERO_CELSIUS = 273.15  # K


@dataclass(frozen=True, kw_only=True)
class SceneByTemperature:
    """A scene at any temperature of its oil."""

    scene: Scene  # with the oil at the temperature of its file
    origin: str  # names the file in messages
    values: Values | None = None  # of its keys; None: a Scene of Python
    thermal: Thermal | None = None  # None: the temperature of the oil is given

    @property
    def is_known_elsewhere(self) -> bool:
        """Whether the oil is known at other temperatures than that of the scene."""
        return self._oil is not None and not _is_known_at_one(self._oil)

    @property
    def _oil(self) -> Values | None:
        """The values of a scene with oil."""
        return self.values if self.values is not None and "lubricant" in self.values.said else None

    @property
    def fixed(self) -> Scene:
        """The scene at the temperature of its file. Raises InputError where friction settles the temperature."""
        if self.thermal is not None:
            raise InputError(
                f"{self.origin}: the scene has [thermal], so friction determines the oil temperature: leave the table "
                "out and give lubricant.temperature, or run fembearing torque (in Python analytic.steady_scene)"
            )
        return self.scene

    def at(self, temperature: float) -> Scene:
        """The scene with its oil at another temperature.

        Parameters
        ----------
        temperature : float
            Of the oil, K.

        Returns
        -------
        Scene
            Otherwise the same.

        Raises
        ------
        InputError
            Another temperature than the scene's without the table of an oil, with a viscosity that replaces that of a
            named oil at one temperature, or beyond the oil's data.
        """
        if self.scene.lubricant is not None and temperature == self.scene.lubricant.temperature:
            return self.scene
        oil = self._oil
        if oil is None:
            if self.scene.lubricant is None:
                raise InputError(f"{self.origin}: the scene has no [lubricant]; give the file of a scene with one")
            raise InputError(f"{self.origin}: a Scene holds its oil at one temperature; give the file of the scene")
        if _is_known_at_one(oil):
            text = oil["lubricant.viscosity"].text
            raise InputError(
                f"{self.origin}: oil at {temperature - ZERO_CELSIUS:.4g} degC: lubricant.viscosity = {text} beside "
                "lubricant.name holds at lubricant.temperature alone; give two "
                'viscosities, as ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]'
            )
        try:
            warm = lubricant_of(oil.at(temperature), ball_radius=self.scene.bearing.ball_radius)
        except InputError as problem:
            raise InputError(f"{self.origin}: oil at {temperature - ZERO_CELSIUS:.4g} degC: {problem}") from problem
        return replace(self.scene, lubricant=warm)


def _is_known_at_one(oil: Values) -> bool:
    """Whether one viscosity replaces that of a named oil, which then has no law over the temperature."""
    viscosity: GivenViscosity | None = oil["lubricant.viscosity"]
    return oil["lubricant.name"] is not None and viscosity is not None and not viscosity.is_pair


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
        CSV or .xlsx file of measured torques, in place of the scene's [measured]; None: that one, if there is one. A
        bearing of the catalog has no usual load beside the loads of this file.
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
    scene: str | os.PathLike[str] | Scene | SceneByTemperature,
    *,
    columns: Mapping[str, Any] = NOTHING_SET,
    **given: Unpack[SceneOptions],
) -> SceneByTemperature:
    """The scene at any temperature of its oil; arguments and errors of `load_scene`, which refuses [thermal].

    scene : also a Scene, whose oil has one temperature, or what is read already; beside both nothing is given
    columns : of a file of operating points, by name, SI; with `measured` those of that file. A bearing of the catalog
        then has no usual load beside theirs.
    """
    if isinstance(scene, Scene | SceneByTemperature):
        require_nothing_beside(given)
        return SceneByTemperature(scene=scene, origin=scene.name) if isinstance(scene, Scene) else scene
    found, measured = find_scene(scene), given.get("measured")
    points = columns if measured is None or found.bearing is None else vars(read_measured(measured))
    return _read(found, columns=points, **given)


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
    found = FoundScene(document=parse_text(text, origin=origin), origin=origin, folder=folder)
    return _read(found, measured=measured, settings=settings, **options)


def scene_of(document: dict[str, Any], *, origin: str, folder: Path = Path()) -> Scene:
    """The scene that a parsed TOML document describes; the arguments and errors of parse_scene."""
    return _read(FoundScene(document=document, origin=origin, folder=folder)).fixed


def _read(
    found: FoundScene,
    *,
    measured: str | os.PathLike[str] | None = None,
    settings: Mapping[str, Any] = NOTHING_SET,
    columns: Mapping[str, Any] = NOTHING_SET,
    **options: Unpack[OperatingOptions],
) -> SceneByTemperature:
    """The scene of a document with what is given beside it."""
    given, notes = given_values(settings, options)
    document, usual = whole_document(found, given, columns)
    v = _values_of(document, found.origin)
    scene = _scene(v, found.folder)
    # Spreads and sources of a file need not fit the scene that what is given beside it changes.
    counts = [each for each in v.misfits if not given or each[0] in given or not each[0].startswith(BESIDE)]
    _refuse(found.origin, v, counts)
    scene = _with_measured(scene, v, found.folder, measured)
    thermal = v.noun(Thermal, "thermal")
    if thermal is not None and given.get("lubricant.temperature") is not None:
        temperature = shown(given["lubricant.temperature"])
        raise InputError(
            f"{found.origin}: lubricant.temperature = {temperature} and [thermal] both determine the oil temperature: "
            "leave one of them out"
        )
    told = {} if found.bearing is None else told_values(usual, found.bearing, scene, given)
    scene = replace(scene, usual=read_only(told), warnings=(*scene.warnings, *notes))
    return SceneByTemperature(scene=scene, origin=found.origin, values=v, thermal=thermal)


def whole_document(
    found: FoundScene, given: Mapping[str, Any], columns: Mapping[str, Any] = NOTHING_SET
) -> tuple[dict[str, Any], dict[str, Any]]:
    """The document with what is given beside it, and the values of a bearing of the catalogue that nobody gave, by key.

    given : by key, as a scene file has it;  columns : as of `load_by_temperature`
    """
    if found.bearing is None:
        document, usual = found.document, {}
        for rival in (rival for path in given for rival in rivals_of(path) if rival not in given):
            document = without_key(document, rival.removesuffix(".path"))  # of a height map, with its spacing
    else:
        given = {**given, **_point(columns, given)}
        if "bearing.catalog" in given:
            name = shown(given["bearing.catalog"])
            raise InputError(
                f"{found.designation} and bearing.catalog = {name} both name the bearing: give one of them"
            )
        usual = usual_values(found.designation, found.bearing, given)
        document = {}
    for path, value in (*usual.items(), *given.items()):
        document = with_key(document, path, value)
    return document, usual


def _point(columns: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """Loads of the heaviest row, speed and temperature of the fastest one, by key; what is given stays."""
    known = {name: values for name in OPERATING if (values := columns.get(name)) is not None}
    loads = [np.abs(known[name]) for name in ("axial_load", "radial_load") if name in known]
    heaviest = int(np.argmax(np.sum(loads, axis=0))) if loads else 0
    fastest = int(np.argmax(np.abs(known["inner_speed"]))) if "inner_speed" in known else 0
    rows = {name: heaviest if name in ("axial_load", "radial_load") else fastest for name in known}
    point = {key_of_column(name): SI(known[name][row], operating_column(name).unit) for name, row in rows.items()}
    return {key: value for key, value in point.items() if key not in given}


def _values_of(document: dict[str, Any], origin: str) -> Values:
    """The values of a document, filled by catalogue and rules. Raises InputError for what is wrong with them."""
    table = scene_table()
    v = read_document(document, table)
    if not any(path == "bearing.catalog" for path, _, _ in v.faults):
        fill_from_catalog(v)
    _refuse(origin, v, v.misfits, faults=faults_of(table, v))
    _refuse(origin, v, _conflicts(v))
    apply_rules(v)
    _refuse(origin, v, shoulder_faults(v))
    return v


def _refuse(origin: str, v: Values, misfits: Iterable[tuple[str, str]], *, faults: Iterable[str] = ()) -> None:
    """Raise InputError for faults in words, and for (key, problem) of values, if there are any."""
    said = [*faults, *(fault_at(v.document, *each) for each in misfits)]
    more = f"; and {len(said) - MOST_FAULTS} more" if len(said) > MOST_FAULTS else ""
    if said:
        raise InputError(f"{origin}: " + "; ".join(said[:MOST_FAULTS]) + more)


def _conflicts(v: Values) -> Iterator[tuple[str, str]]:
    """(key, problem) of keys that are valid on their own and in conflict with each other."""
    rule, value, tilt = (
        v[key] for key in ("bearing.contact_angle.rule", "bearing.contact_angle.value", "operation.tilt")
    )
    if rule == "given" and not value:
        yield "bearing.contact_angle.value", 'must be above 0 with rule = "given", for example "0.18 rad"'
    elif rule == "given" and v["bearing.contact_angle.free"] is not None:
        yield "bearing.contact_angle.free", 'goes with rule = "solved"; leave it out'
    if rule == "solved" and value is not None:
        yield "bearing.contact_angle.value", 'goes with rule = "given"; use free = ... or leave it out'
    yield from bearing_faults(v)
    yield from installation_faults(v)
    if isinstance(tilt, float) and "operation.moment" in v.said:
        yield "operation.tilt", "holds the ring, and operation.moment tilts it; leave one of them out"
    if tilt not in (None, "free", 0.0) and rule == "given":
        yield "operation.tilt", 'changes the contact angles, which rule = "given" holds; use "solved", or leave it out'
    given = {name: each for name, each in v.document["operation"].items() if name not in ("down", "tilt")}
    lists = {name: v[f"operation.{name}"] for name in given}
    lists = {name: each for name, each in lists.items() if len(each) > 1 or isinstance(given[name], list)}
    if len({len(each) for each in lists.values()}) > 1:
        counts = " and ".join(f"operation.{name} has {len(each)}" for name, each in lists.items())
        yield "", f"{counts} values; lists are paired: give equal lengths, or one quantity for the whole series"
    else:
        is_preloaded = v["arrangement.kind"] not in (None, "tandem")
        points = np.broadcast(v["operation.axial_load"], v["operation.radial_load"], v["operation.moment"])
        if not is_preloaded and not all(any(point) for point in points):
            problem = 'leaves a point without any load; give for example "1000 N", or a radial load or a moment'
            yield "operation.axial_load", problem
        yield from (("operation.axial_load", problem) for problem in _apart(v))
    has_cage = "cage" in v.said
    if has_cage and (v["cage.pocket_clearance"] is None) == (v["cage.pocket_diameter"] is None):
        yield "", "cage needs exactly one of pocket_clearance and pocket_diameter"
    if "friction" in v.said and v["friction.coefficient"] is None and "lubricant" not in v.said:
        problem = "is missing; give for example 0.1, or the tables [lubricant] and [surface] instead"
        yield "friction.coefficient", problem
    if "surface" in v.said:
        yield from surface_conflicts(v)
    yield from _thermal_faults(v)
    if "lubricant" in v.said:
        try:
            lubricant_of(v, ball_radius=v["bearing.ball_diameter"] / 2)
        except InputError as problem:
            yield "", str(problem)
    for name in ("cage", "cage_dynamics", "ball_dynamics"):
        if not (has_cage or _assumes_cage(v)) and v[f"effects.{name}"] == "on":
            yield f"effects.{name}", "needs a table [cage]; give one, or leave the effect out"


def _thermal_faults(v: Values) -> Iterator[tuple[str, str]]:
    """(key, problem) of a scene with [thermal] whose oil is not known at other temperatures."""
    viscosity: GivenViscosity | None = v["lubricant.viscosity"]
    if "thermal" not in v.said:
        return
    if "lubricant" not in v.said:
        yield "thermal", "warms the oil, and the scene has no [lubricant]; add one, or leave [thermal] out"
    elif viscosity is not None and not viscosity.is_pair:
        yield (
            "lubricant.viscosity",
            "is known at one temperature alone, and [thermal] changes the temperature; give two viscosities, as "
            '["46 cSt at 40 degC", "6.8 cSt at 100 degC"], or name = "ISO VG 46" in its place',
        )


def _seating(v: Values) -> Iterator[tuple[float, float]]:
    """(thrust, radial load times tan(angle)), N, of each point of a single angular contact bearing of the catalogue."""
    if v.row is None or v.row.nominal_angle is None or "arrangement" in v.said:
        return
    tangent = float(np.tan(v.row.nominal_angle))
    for thrust, side in np.broadcast(v["operation.axial_load"], v["operation.radial_load"]):
        yield float(thrust), abs(float(side)) * tangent


def _apart(v: Values) -> Iterator[str]:
    """Why a radial load alone is none that a single angular contact bearing carries."""
    alone = [spread for thrust, spread in _seating(v) if spread and not thrust]
    if alone:
        needed = float(f"{SEATED * max(alone):.3g}")
        yield f"lets an angular contact bearing slide apart; give some {needed:g} N of thrust, or an [arrangement]"


def _loose(v: Values) -> Iterator[str]:
    """A warning where too little thrust loads fewer than half of the balls."""
    if any(thrust < HALF_SEATED * spread for thrust, spread in _seating(v)):
        yield (
            f"the thrust loads fewer than half of the balls of this angular contact bearing: {HALF_SEATED:g} times the "
            "radial load times tan(contact angle) loads half of them where the ring is held straight, "
            + ("and a ring that tilts freely needs more" if _is_free(v) else f"{SEATED:g} times all")
        )


def _is_free(v: Values) -> bool:
    """Whether the ring tilts as its loads and moment have it."""
    tilt = v["operation.tilt"]
    return tilt == "free" or (tilt is None and "operation.moment" in v.said)


def _scene(v: Values, folder: Path) -> Scene:
    """The scene; what in it does not fit together is noted in the values."""
    bearing = bearing_of(v)
    if v.row is not None and v.row.other_candidate is not None and v.row.grade == "C" and not has_own_balls(v):
        others = read_document(v.document, scene_table())
        others |= dict(zip((f"bearing.{key}" for key in BALLS), v.row.other_candidate, strict=True))
        fill_from_catalog(others)
        apply_rules(others)
        bearing = replace(bearing, other_candidate=bearing_of(others))
    angle = ContactAngle(**v.fields(ContactAngle, "bearing.contact_angle"))
    if bearing.kind == "thrust":
        angle = ContactAngle(rule="given", value=np.pi / 2)
    own = {path.removeprefix("bearing.") for path in v.said if path.startswith("bearing.")}
    v.misfits += fit.bearing_misfits(bearing, gap_key=_gap_key(v), own=own)
    delivered, clearances, cage, losses = bearing, None, None, Losses()
    if "mounting" in v.said and not v.misfits:
        bearing, clearances = in_operation(bearing, v)
    fits = not v.misfits
    if fits:
        v.misfits += fit.angle_misfits(bearing, angle) if bearing.kind == "radial" else ()
        cage = _cage_of(v, delivered)
    surface, is_lubricated = surface_of(v, folder), "lubricant" in v.said
    v.misfits += fit.surface_misfits(surface, bearing, cage, is_lubricated=is_lubricated)
    if not v.misfits:
        try:
            losses = losses_of(v, delivered)
        except InputError as problem:
            v.misfits.append(("losses.seals", f"is refused: {problem}"))
    parts = {
        "bearing": bearing,
        "contact_angle": angle,
        "clearances": clearances,
        "arrangement": arranged(v, bearing, angle) if "arrangement" in v.said and fits else None,
        "operation": _operation(v),
        "down": v["operation.down"],
        "cage": cage,
        "lubricant": lubricant_of(v, ball_radius=bearing.ball_diameter / 2) if is_lubricated else None,
        "surface": surface,
        "losses": losses,
        "effects": _effects(v, has_no_cage=cage is None and (v.row is not None or NO_CAGE in v.said)),
        "warnings": (*_of_designation(v), *_loose(v), *fit.warnings(bearing, cage)),
    }
    scene = Scene(**v.fields(Scene, "", **parts))
    return scene if v.misfits else with_spreads(v, scene)


def _effects(v: Values, *, has_no_cage: bool) -> Mapping[str, Decision]:
    effects = {name: v[f"effects.{name}"] for name in get_args(EffectName)}
    return read_only(effects | ({"cage": "off"} if has_no_cage else {}))


def _of_designation(v: Values) -> Iterator[str]:
    """The warnings of the catalogue's row, without those on balls that the scene replaces."""
    if v.row is not None:
        replaced = v.row.ball_warnings if has_other_balls(v) else ()
        yield from (warning for warning in v.row.warnings if warning not in replaced)


def _with_measured(scene: Scene, v: Values, folder: Path, given: str | os.PathLike[str] | None) -> Scene:
    """The scene with its measured torques, if there are any; given : their file, in place of that of [measured]."""
    if given is None and v["measured.file"] is not None:
        given = folder / v["measured.file"]
    if given is None:
        return scene
    measured = with_oils(read_measured(given), v, scene.lubricant, ball_radius=scene.bearing.ball_radius)
    return replace(scene, measured=measured)


def _gap_key(v: Values) -> str:
    """The path of the key that says how far the rings are apart."""
    keys = ("bearing.clearance", "bearing.contact_angle.nominal")
    return next((key for key in keys if v[key] is not None), fit.BOTTOM)


def _assumes_cage(v: Values) -> bool:
    """Whether the scene says nothing of the cage of a bearing of the catalogue, nor of its pockets."""
    return v.row is not None and not {"cage", NO_CAGE, "losses.pockets"} & v.said


def _cage_of(v: Values, bearing: Bearing) -> Cage | None:
    """The cage of a bearing as it is delivered.

    One that is assumed fits, and rests on its balls; None where the balls leave no web, or are tiny.
    """
    if _assumes_cage(v):
        sizes = assumed_cage(bearing, () if v.row is None else v.row.suffixes.values())
        if not sizes or bearing.ball_diameter < LEAST_CAGED:
            return None
        usual = read_document({"cage": in_si(sizes | {"friction_coefficient": FRICTION}, "cage")}, scene_table())
        usual[BALL] = bearing.ball_diameter
        apply_rules(usual)
        return replace(_cage(usual, assumed=ORIGINS), gives_way=True)
    if "cage" not in v.said:
        return None
    own = {path.removeprefix("cage.") for path in v.said}
    cage = _cage(v, assumed=() if v.row is None else {*ORIGINS} - own)
    pocket = "pocket_clearance" if "cage.pocket_clearance" in v else "pocket_diameter"
    overlaps = v["cage.variant"] == AS_PRINTED
    v.misfits += fit.cage_misfits(bearing, cage, pocket=pocket, pockets_may_overlap=overlaps)
    return cage


def _cage(v: Values, *, assumed: Collection[str]) -> Cage:
    """assumed : keys that the scene leaves to the catalogue, as far as they are given"""
    return Cage(
        **v.fields(
            Cage,
            "cage",
            origins=read_only({key: ORIGINS[key] for key in assumed if v[f"cage.{key}"] is not None}),
            pocket_stiffness=v["cage.pocket_stiffness"],
        )
    )


def _operation(v: Values) -> Operation:
    series = {name: np.array(v[f"operation.{name}"]) for name in SERIES}
    values = np.broadcast_arrays(*series.values())
    tilt = "free" if _is_free(v) else v["operation.tilt"]
    return Operation(tilt=tilt, **{name: _frozen(value) for name, value in zip(series, values, strict=True)})


def _frozen(values: Array) -> Array:
    values = values.copy()
    values.flags.writeable = False
    return values
