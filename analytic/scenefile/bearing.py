"""A bearing from the keys of a scene, of which an engineer gives those that he has.

The catalogue fills what the scene leaves open. The bottom radii of the grooves follow from pitch diameter and
clearance, the clearance from its group or from the unloaded contact angle.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np

from analytic import catalog
from analytic.catalog.bearing_rows import BEARING_STEEL, CatalogBearing, clearance_group, find_bearing
from analytic.catalog.suffixes import seal_contact
from analytic.errors import InputError
from analytic.scene import Bearing, Groove, Material, Origin
from analytic.scenefile.tables import BearingTable, ContactAngleTable, GrooveTable
from analytic.scenefile.usual_cage import entry_of_cage
from analytic.words import shown

RINGS = ("inner", "outer")
# Keys of a ring; each says the same as the others of its line.
RIVALS = (
    ("groove_radius", "conformity"),
    ("shoulder_half_width", "shoulder_height", "shoulder_diameter"),
    ("far_shoulder_half_width", "far_shoulder_height", "far_shoulder_diameter"),
)
OF_RADIAL = ("bottom_radius", "shoulder_diameter", "far_shoulder_diameter")  # keys of rings that washers do not have
MATERIALS = ("ball_material", *(f"{ring}.material" for ring in RINGS))
NO_DIMENSIONS = ("catalog", "name", "kind")
BALLS = ("ball_count", "ball_diameter")
RATINGS = ("static_load_rating", "dynamic_load_rating")
AS_PRINTED = 1e-5  # relative: `fembearing init` prints seven digits, and neighbouring sizes differ by 3e-3
SPAN = 12**0.5  # of a uniform distribution, over its standard deviation
ANGLE_SPREAD = np.radians(1.5)  # standard deviation of a nominal contact angle; judgement, no tolerance was read


def catalog_row(given: Mapping[str, Any]) -> CatalogBearing | None:
    """The catalogue's row of the table's bearing; None where the table names none, or one that has its own file.

    Raises InputError for a designation that the catalogue does not have.
    """
    name = given.get("catalog")
    if name is not None and not isinstance(name, str):
        raise InputError(f'{shown(name)} is no designation; give it in quotes, for example "6206"')
    return None if name is None or name in catalog.names("bearings") else find_bearing(name)


def with_catalog(given: Mapping[str, Any], row: CatalogBearing | None) -> dict[str, Any]:
    """The table [bearing] filled from the catalogue; its own keys replace those of the entry that say the same."""
    entry = {key: value for key, value in _entry(given, row).items() if key != "origins"}
    angle = given.get("contact_angle")
    bottoms_given = all("bottom_radius" in _dict(given, ring) for ring in RINGS)
    if bottoms_given or "clearance" in given or (isinstance(angle, dict) and "free" in angle):
        entry.pop("contact_angle", None)
    if bottoms_given or (isinstance(angle, dict) and ("nominal" in angle or "free" in angle)):
        entry.pop("clearance", None)
    if bottoms_given:
        entry.pop("pitch_diameter", None)
    merged = {**entry, **given}
    for name in (*RINGS, "contact_angle"):
        inside, own = entry.get(name), given.get(name)
        if isinstance(inside, dict) and (own is None or isinstance(own, dict)):
            merged[name] = _without_rivals(inside, {**given, **(own or {})}) | (own or {})
    return merged


def bearing_faults(
    given: BearingTable, own: Mapping[str, Any], row: CatalogBearing | None
) -> Iterator[tuple[str, str]]:
    """(path of the key, problem) for what the table of a bearing lacks, says twice, or cannot be.

    own : the table as the scene has it, before the catalogue filled it;  row : of the catalogue
    """
    faults = [*_gaps_and_doubles(given, own, row)]
    yield from faults or _shoulder_faults(given)


def _gaps_and_doubles(
    given: BearingTable, own: Mapping[str, Any], row: CatalogBearing | None
) -> Iterator[tuple[str, str]]:
    for name in RINGS:
        ring: GrooveTable = getattr(given, name)
        for keys in RIVALS:
            said = [key for key in keys if getattr(ring, key) is not None]
            if len(said) > 1:
                yield f"bearing.{name}.{said[1]}", f"says the same as {said[0]}; leave one of them out"
        if given.conformity is not None and (ring.groove_radius is not None or ring.conformity is not None):
            yield "bearing.conformity", f"is of both rings, and the {name} ring has its own; leave one of them out"
        if ring.groove_radius is None and ring.conformity is None and given.conformity is None:
            yield (
                f"bearing.{name}.groove_radius",
                "is missing; give it, or for both rings conformity = 0.52 of [bearing]",
            )
    if given.kind == "thrust":
        yield from _thrust_faults(given)
        return
    bottoms = [name for name in RINGS if getattr(given, name).bottom_radius is not None]
    if len(bottoms) == 1:
        (other,) = set(RINGS) - set(bottoms)
        yield f"bearing.{other}.bottom_radius", "is missing; give it for both rings, or pitch_diameter and clearance"
    elif not bottoms and given.pitch_diameter is None:
        yield "bearing.pitch_diameter", 'is missing; give for example "39 mm", or the bottom_radius of both rings'
    angle = given.contact_angle
    angles = [name for name in ("nominal", "free") if getattr(angle, name) is not None]
    if given.clearance is not None and angles:
        problem = f"and contact_angle.{angles[0]} both determine the clearance; leave one of them out"
        yield "bearing.clearance", problem
    if len(angles) == 2:
        yield "bearing.contact_angle.nominal", "and free both give the unloaded angle; leave one of them out"
    if not bottoms and given.clearance is None and not angles and angle.value is None:
        yield (
            "bearing.clearance",
            'is missing; give a length like "10 um", a group like "CN", or contact_angle = { nominal = "15 deg" }',
        )
    if all("bottom_radius" in _dict(own, ring) for ring in RINGS):
        for key in (key for key in ("pitch_diameter", "clearance") if key in own):
            yield f"bearing.{key}", "follows from the bottom_radius of both rings; leave one of them out"
    if isinstance(given.clearance, str) and row is not None and row.nominal_angle is not None:
        angle_of_row = f'contact_angle = {{ nominal = "{np.degrees(row.nominal_angle):g} deg" }}'
        yield "bearing.clearance", f"is a group of deep groove bearings; give {angle_of_row}, or a length"
    elif isinstance(given.clearance, str) and given.bore_diameter is None:
        yield "bearing.clearance", "is a group, which depends on the bore: give bore_diameter, or a length"


def _shoulder_faults(given: BearingTable) -> Iterator[tuple[str, str]]:
    """Shoulders that do not stand between the bottom of their groove and the middle of its profile."""
    bottoms = _bottoms_of(given)
    for name, side, bottom in zip(RINGS, (1, -1), bottoms, strict=True):
        ring: GrooveTable = getattr(given, name)
        profile = _profile(given, ring)
        for side_name, lowest in (("", "above"), ("far_", "at least")):
            for key, height in (
                ("shoulder_diameter", _height_of(getattr(ring, f"{side_name}shoulder_diameter"), bottom, side)),
                ("shoulder_height", getattr(ring, f"{side_name}shoulder_height")),
            ):
                if height is None or (height < profile and (height >= 0 if side_name else height > 0)):
                    continue
                if key == "shoulder_height":
                    limits = f"{lowest} 0 and below the groove radius {1e3 * profile:.5g} mm"
                else:
                    ends = (1e3 * 2 * (bottom + side * part) for part in (0.0, profile))
                    limits = "between that of the groove's bottom, {:.6g} mm, and {:.6g} mm".format(*ends)
                yield f"bearing.{name}.{side_name}{key}", f"must be {limits}"


def _thrust_faults(given: BearingTable) -> Iterator[tuple[str, str]]:
    """The same for what only a thrust bearing lacks, or does not take."""
    if given.pitch_diameter is None:
        yield "bearing.pitch_diameter", 'is missing; give the circle of the ball centres, for example "36 mm"'
    radial = [("clearance", given.clearance is not None), ("contact_angle", given.contact_angle != ContactAngleTable())]
    for name in RINGS:
        ring: GrooveTable = getattr(given, name)
        radial += [(f"{name}.{key}", getattr(ring, key) is not None) for key in OF_RADIAL]
    for key, said in radial:
        if said:
            yield (
                f"bearing.{key}",
                'goes with kind = "radial": the balls of a thrust bearing touch at 90 deg; leave it out',
            )
    profiles = {_profile(given, getattr(given, name)) for name in RINGS}
    if len(profiles) > 1 and not np.isnan([*profiles]).any():
        yield "bearing.outer.groove_radius", "must be that of the inner ring: a thrust bearing has two equal grooves"


def bearing_of(given: BearingTable, *, own: Mapping[str, Any], row: CatalogBearing | None) -> Bearing:
    """The bearing of a table without faults.

    own : the table as the scene has it, before the catalogue filled it;  row : of the catalogue
    Raises InputError for a bore that the groups of clearance do not cover.
    """
    profiles = {name: _profile(given, getattr(given, name)) for name in RINGS}
    bottoms = _bottoms_of(given)
    origin = None if given.kind == "thrust" else _clearance(given)[1]
    if origin is not None and row is not None and row.clearance_group is None and isinstance(given.clearance, str):
        status = "printed" if "clearance" in own else "assumed"  # a designation without a group is that of CN
        origin = replace(origin, status=status)
    is_own = row is not None and is_replaced(given, own, row)
    lost = {*RATINGS} - {*own} if is_own else set()  # makers' values of the original bearing
    name = given.name or given.catalog or "unnamed"
    ball = Material(**given.ball_material.model_dump())
    solid = ball.density * np.pi / 6 * given.ball_diameter**3
    origins = _origins(own, row) | ({} if origin is None else {"clearance": origin})
    return Bearing(
        **given.model_dump(include={"ball_count", "ball_diameter", "bore_diameter", "outside_diameter", "width"}),
        **given.model_dump(include={*RATINGS} - lost),
        kind=given.kind,
        name=f"own bearing (from {name})" if is_own and "name" not in own else name,
        ball_mass=float(solid) if given.ball_mass is None else given.ball_mass,
        ball_material=ball,
        inner=_groove(given.inner, bottom=bottoms[0], profile=profiles["inner"], side=1),
        outer=_groove(given.outer, bottom=bottoms[1], profile=profiles["outer"], side=-1),
        series=None if is_own else _series(given, row),
        seals=None if row is None else row.seals,
        seals_rub=row is not None and any(seal_contact(suffix) != "none" for suffix in row.seal_suffixes),
        grade=None if row is None or is_own else row.grade,
        origins=MappingProxyType({key: each for key, each in origins.items() if key not in lost}),
    )


def is_replaced(given: BearingTable, own: Mapping[str, Any], row: CatalogBearing) -> bool:
    """Whether the scene gives the row's bearing other balls or other grooves: it is no longer the maker's.

    own : the table as the scene has it, before the catalogue filled it
    """
    grooves = [_profile(given, getattr(given, ring)) / given.ball_diameter for ring in RINGS]
    same_grooves = np.allclose(grooves, row.conformity, rtol=AS_PRINTED, atol=0)
    return has_other_balls(given, own, row) or not same_grooves


def has_other_balls(given: BearingTable, own: Mapping[str, Any], row: CatalogBearing) -> bool:
    """The same of the balls alone."""
    balls = (given.ball_count, given.ball_diameter), (row.ball_count, row.ball_diameter)
    return bool({*BALLS} & {*own}) and not np.allclose(*balls, rtol=AS_PRINTED, atol=0)


def _series(given: BearingTable, row: CatalogBearing | None) -> str | None:
    """That of the row, unless the scene gives the bearing other boundary dimensions."""
    sizes = (given.bore_diameter, given.outside_diameter, given.width)
    return row.series if row is not None and sizes == (row.bore, row.outside, row.width) else None


def _entry(given: Mapping[str, Any], row: CatalogBearing | None) -> dict[str, Any]:
    """What the catalogue has on the table's bearing, in the form of a scene file."""
    if row is not None:
        return _entry_of_row(row) | {"name": " ".join(given["catalog"].split())}
    return catalog.entry("bearings", given["catalog"]) if given.get("catalog") is not None else {}


def _entry_of_row(row: CatalogBearing) -> dict[str, Any]:
    rings: dict[str, dict[str, Any]] = {}
    for name, conformity, height, far in zip(
        RINGS, row.conformity, row.shoulder_height, row.far_half_width, strict=True
    ):
        rings[name] = {"conformity": conformity, "material": BEARING_STEEL}
        if height is not None:  # the height, which stays what it is with other balls
            rings[name]["shoulder_height"] = _length(height)
            if far is not None:
                rings[name]["far_shoulder_height"] = _length(height if far else 0.0)
    if row.nominal_angle is None:
        play: dict[str, Any] = {"clearance": row.clearance_group or "CN"}
    else:
        play = {"contact_angle": {"rule": "solved", "nominal": f"{row.nominal_angle!r} rad"}}
    lengths = {
        "ball_diameter": row.ball_diameter,
        "pitch_diameter": row.pitch_diameter,
        "bore_diameter": row.bore,
        "outside_diameter": row.outside,
        "width": row.width,
    }
    ratings = {"static_load_rating": row.static_load_rating, "dynamic_load_rating": row.dynamic_load_rating}
    return {
        "ball_count": row.ball_count,
        "ball_material": row.ball_material,
        **{key: _length(value) for key, value in lengths.items() if value is not None},
        **{key: f"{value!r} N" for key, value in ratings.items() if value is not None},
        **rings,
        **play,
        "cage": entry_of_cage(row, row.suffixes.values()),
    }


def _length(value: float) -> str:
    return f"{value!r} m"


def _without_rivals(entry: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    """The keys of a ring's entry that the given keys do not replace by others that say the same."""
    replaced = {key for keys in RIVALS if any(each in own for each in keys) for key in keys}
    return {key: value for key, value in entry.items() if key not in replaced}


def _profile(given: BearingTable, ring: GrooveTable) -> float:
    """Radius of the groove's profile, m."""
    if ring.groove_radius is not None:
        return ring.groove_radius
    conformity = given.conformity if ring.conformity is None else ring.conformity
    return conformity * given.ball_diameter if conformity is not None else np.nan


def _clearance(given: BearingTable) -> tuple[float | None, Origin | None]:
    """The clearance that keys other than the bottom radii give, m, and where it comes from."""
    if isinstance(given.clearance, str) and given.bore_diameter is not None:
        low, high = clearance_group(given.bore_diameter, given.clearance)
        group = f"middle of the group {given.clearance} of [ISO5753], {low * 1e6:g} to {high * 1e6:g} um, unmounted"
        return (low + high) / 2, Origin(status="printed", uncertainty=(high - low) / SPAN, source=group)
    if isinstance(given.clearance, float):
        return given.clearance, None
    angle = given.contact_angle
    bottoms_known = given.inner.bottom_radius is not None
    unloaded = angle.nominal if angle.nominal is not None or bottoms_known else angle.free or angle.value
    if unloaded is None:
        return None, None
    distance = sum(_profile(given, getattr(given, name)) for name in RINGS) - given.ball_diameter  # A_0
    spread = 2 * distance * np.sin(unloaded) * ANGLE_SPREAD
    words = f"closes at the unloaded contact angle of {np.degrees(unloaded):.4g} deg"
    return float(2 * distance * (1 - np.cos(unloaded))), Origin(
        status="derived", uncertainty=float(spread), source=words
    )


def _bottoms_of(given: BearingTable) -> tuple[float, float]:
    """Bottom radii of the inner and outer groove, m; those of a thrust bearing are the circle of its ball centres."""
    if given.kind == "thrust":
        assert given.pitch_diameter is not None, "bearing_faults says so before"
        return given.pitch_diameter / 2, given.pitch_diameter / 2
    clearance, _ = _clearance(given)
    inner, outer = given.inner.bottom_radius, given.outer.bottom_radius
    if inner is not None and outer is not None:
        if clearance is None and given.pitch_diameter is None:
            return inner, outer
        if clearance is None:
            clearance = 2 * (outer - inner - given.ball_diameter)
        pitch = inner + outer if given.pitch_diameter is None else given.pitch_diameter
    else:
        assert clearance is not None, "bearing_faults says so before"
        assert given.pitch_diameter is not None, "bearing_faults says so before"
        pitch = given.pitch_diameter
    opening = given.ball_diameter + clearance / 2
    return (pitch - opening) / 2, (pitch + opening) / 2


def _groove(given: GrooveTable, *, bottom: float, profile: float, side: int) -> Groove:
    """side : 1 for the inner ring, whose shoulders are larger than its groove; -1 for the outer ring."""

    def half_width(half: float | None, height: float | None, diameter: float | None) -> float | None:
        height = _height_of(diameter, bottom, side) if height is None else height
        return half if height is None else float(np.sqrt(height * (2 * profile - height)))

    return Groove(
        bottom_radius=bottom,
        groove_radius=profile,
        shoulder_half_width=half_width(given.shoulder_half_width, given.shoulder_height, given.shoulder_diameter),
        far_shoulder_half_width=half_width(
            given.far_shoulder_half_width, given.far_shoulder_height, given.far_shoulder_diameter
        ),
        material=Material(**given.material.model_dump()),
    )


def _height_of(diameter: float | None, bottom: float, side: int) -> float | None:
    """Height of a shoulder of this diameter above the bottom of its groove, m; side as in `_groove`."""
    return None if diameter is None else side * (diameter / 2 - bottom)


def _dict(table: Mapping[str, Any], key: str) -> Mapping[str, Any]:
    """The table inside; empty if there is none."""
    inside = table.get(key)
    return inside if isinstance(inside, dict) else {}


def _origins(own: Mapping[str, Any], row: CatalogBearing | None) -> dict[str, Origin]:
    """Where each dimension comes from: the catalogue's row, or the scene where it gives its own."""
    if row is None:
        entry = _entry(own, None).get("origins", {})
        origins = {key: Origin(uncertainty=None, **origin) for key, origin in entry.items()}
    else:
        origins = dict(row.origins)
    said = {key for key, value in own.items() if not isinstance(value, dict) and key not in NO_DIMENSIONS}
    for ring in RINGS:
        inside = own.get(ring)
        keys = {*inside} - {*NO_DIMENSIONS} if isinstance(inside, dict) else ()
        said |= {f"{ring}.{_said_by(key)}" for key in keys}
    if "conformity" in said:
        said = said - {"conformity"} | {f"{ring}.conformity" for ring in RINGS}
    if "inner.bottom_radius" in said:
        said |= {"pitch_diameter", "clearance"}
    given = Origin(status="given", uncertainty=None, source="the scene")
    return origins | {key: given for key in sorted(said) if key not in MATERIALS or key in origins}


def _said_by(key: str) -> str:
    """The key that stands for this one and its rivals."""
    return next((keys[0] if "conformity" not in keys else "conformity" for keys in RIVALS if key in keys), key)
