"""A bearing from the keys of a scene, of which an engineer gives those that he has.

The catalogue fills what the scene leaves open. The bottom radii of the grooves follow from pitch diameter and
clearance, the clearance from its group or from the unloaded contact angle.
"""

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from analytic import catalog
from analytic.catalog.bearing_rows import BEARING_STEEL, CatalogBearing, find_bearing
from analytic.catalog.suffixes import seal_contact
from analytic.declared import read_only
from analytic.scene import Bearing, Origin
from analytic.scenefile.fill import BALL, BOTTOMS, GAP, PITCH, RIVALS, rivals_of
from analytic.scenefile.keys import GIVEN, RINGS, Values, catalog_solid, read_document, scene_table
from analytic.scenefile.usual import assumed_cage

OF_RADIAL = ("bottom_radius", "shoulder_diameter", "far_shoulder_diameter")  # keys of rings that washers do not have
MATERIALS = ("ball_material", *(f"{ring}.material" for ring in RINGS))
NO_DIMENSIONS = ("catalog", "name", "kind")
BALLS = ("ball_count", "ball_diameter")
RATINGS = ("static_load_rating", "dynamic_load_rating")
AS_PRINTED = 1e-5  # relative: `fembearing init` prints seven digits, and neighbouring sizes differ by 3e-3


def instead_of(key: str) -> tuple[tuple[str, ...], ...]:
    """The keys that stand in the place of one of the catalogue; of each group all have to be given."""
    angle = ("bearing.contact_angle.nominal",)
    same = tuple((other,) for other in rivals_of(key))
    if key in ("bearing.clearance", *angle):
        return (*same, BOTTOMS)
    if key == "bearing.pitch_diameter":
        return (BOTTOMS,)
    if key in BOTTOMS:
        return ("bearing.clearance",), angle, ("bearing.pitch_diameter",)
    both = (("bearing.conformity",),) if key.endswith(("conformity", "groove_radius")) else ()
    return same + both


def fill_from_catalog(v: Values) -> None:
    """Put what the catalogue has on bearing and cage into the values, and its row of the bearing.

    A key that the document gives, or whose rivals it gives, stays. A bearing with its own file has no row.
    """
    name, variant = v["bearing.catalog"], v["cage.variant"]
    entry: dict[str, Any] = {}
    if name is not None and name in catalog.names("bearings"):
        entry = _file_entry(v)
    elif name is not None:
        v.row = find_bearing(name)
        entry = _row_entry(v.row) | {"bearing.name": " ".join(name.split())} | _row_cage(v, v.row)
    variants: dict[str, Any] = entry.pop("variants", {})
    if variant is not None and variant not in variants:
        known = f"give one of {', '.join(variants)}" if variants else "this bearing has none"
        v.misfits.append(("cage.variant", f"is not a variant of the cage; {known}"))
    elif variant is not None:
        pockets = [f"cage.{key}" for key in ("pocket_clearance", "pocket_diameter", "pocket_depth", "pocket_approach")]
        own = [key for key in pockets if key in v.said]
        if own and any(key in pockets for key in variants[variant]):
            v.misfits.append((own[0], "comes with cage.variant; leave out one of them"))
        if "cage.pocket_diameter" in variants[variant]:
            entry.pop("cage.pocket_clearance", None)
        entry |= variants[variant]
    if v["bearing.kind"] == "thrust":  # whose balls touch at 90 degrees
        entry = {key: value for key, value in entry.items() if key not in RIVALS[0]}
    for path, value in entry.items():
        is_ours = path not in v and (not path.startswith("cage.") or "cage" in v.said)
        if is_ours and not any(all(key in v.said for key in keys) for keys in instead_of(path)):
            v[path] = value
    if v.row is not None and v.row.seal_suffixes and "lubricant" in v.said:
        v.setdefault("lubricant.supply", "grease")  # seals and shields hold grease for life


def _file_entry(values: Values) -> dict[str, Any]:
    """The same of a bearing that has its own file, with the variants of its cage."""
    document = catalog.entry("bearings", values["bearing.catalog"])
    document.pop("origins", None)
    cage = document.pop("cage", {})
    variants = cage.pop("variants", {})
    entry = read_document({"bearing": document, "cage": cage}, scene_table())
    inner, outer = (entry[key] for key in BOTTOMS)
    if inner is not None and outer is not None:
        entry["bearing.pitch_diameter"] = inner + outer
        if "bearing.pitch_diameter" in values.said:
            entry["bearing.clearance"] = 2 * (outer - inner - values.get(BALL, entry[BALL]))
    return {
        **entry,
        "variants": {name: {**read_document({"cage": keys}, scene_table())} for name, keys in variants.items()},
    }


def _row_entry(row: CatalogBearing) -> dict[str, Any]:
    """The values of a bearing of the catalogue by their keys, SI."""
    entry: dict[str, Any] = {
        "bearing.ball_count": row.ball_count,
        "bearing.ball_material": catalog_solid(row.ball_material),
        "bearing.ball_diameter": row.ball_diameter,
        "bearing.pitch_diameter": row.pitch_diameter,
        "bearing.bore_diameter": row.bore,
        "bearing.outside_diameter": row.outside,
        "bearing.width": row.width,
        "bearing.static_load_rating": row.static_load_rating,
        "bearing.dynamic_load_rating": row.dynamic_load_rating,
    }
    for name, conformity, height, far in zip(
        RINGS, row.conformity, row.shoulder_height, row.far_half_width, strict=True
    ):
        ring = f"bearing.{name}"
        entry |= {f"{ring}.conformity": conformity, f"{ring}.material": catalog_solid(BEARING_STEEL)}
        if height is not None:  # the height, which stays what it is with other balls
            entry[f"{ring}.shoulder_height"] = height
            if far is not None:
                entry[f"{ring}.far_shoulder_height"] = height if far else 0.0
    if row.nominal_angle is None:
        entry["bearing.clearance"] = row.clearance_group or "CN"
    else:
        entry["bearing.contact_angle.nominal"] = row.nominal_angle
    return {key: value for key, value in entry.items() if value is not None}


def _row_cage(v: Values, row: CatalogBearing) -> dict[str, Any]:
    """The usual cage of the scene's balls by its keys, SI; empty: they leave no web."""
    balls = replace(
        row,
        ball_count=v["bearing.ball_count"] or row.ball_count,
        ball_diameter=v[BALL] or row.ball_diameter,
        pitch_diameter=v[PITCH] or row.pitch_diameter,
    )
    sizes = assumed_cage(balls, row.suffixes.values(), material=v["cage.material"])
    return {f"cage.{key}": catalog_solid(value) if key == "material" else value for key, value in sizes.items()}


def bearing_faults(v: Values) -> Iterator[tuple[str, str]]:
    """(path of the key, problem) for what [bearing] lacks, or says twice."""
    both = v["bearing.conformity"]
    for name in RINGS:
        ring = f"bearing.{name}"
        for keys in (keys for keys in RIVALS if keys[0].startswith(ring)):
            said = [key for key in keys if v[key] is not None]
            if len(said) > 1:
                yield said[1], f"says the same as {said[0].rpartition('.')[2]}; leave one of them out"
        has_own = v[f"{ring}.groove_radius"] is not None or v[f"{ring}.conformity"] is not None
        if both is not None and has_own:
            yield "bearing.conformity", f"is of both rings, and the {name} ring has its own; leave one of them out"
        if both is None and not has_own:
            yield f"{ring}.groove_radius", "is missing; give it, or for both rings conformity = 0.52 of [bearing]"
    if v["bearing.kind"] == "thrust":
        yield from _thrust_faults(v)
        return
    bottoms = [key for key in BOTTOMS if v[key] is not None]
    if len(bottoms) == 1:
        (other,) = {*BOTTOMS} - {*bottoms}
        yield other, f"is missing; give it too, or leave out {bottoms[0]}, and give pitch_diameter and clearance"
    elif not bottoms and v["bearing.pitch_diameter"] is None:
        yield "bearing.pitch_diameter", 'is missing; give for example "39 mm", or the bottom_radius of both rings'
    clearance = v["bearing.clearance"]
    angles = [name for name in ("nominal", "free") if v[f"bearing.contact_angle.{name}"] is not None]
    if clearance is not None and angles:
        problem = f"and contact_angle.{angles[0]} both determine the clearance; leave one of them out"
        yield "bearing.clearance", problem
    if len(angles) == 2:
        yield "bearing.contact_angle.nominal", "and free both give the unloaded angle; leave one of them out"
    if not bottoms and clearance is None and not angles and v["bearing.contact_angle.value"] is None:
        yield (
            "bearing.clearance",
            'is missing; give a length like "10 um", a group like "CN", or contact_angle = { nominal = "15 deg" }',
        )
    if {*BOTTOMS} <= v.said:
        rivals = ("bearing.pitch_diameter", "bearing.clearance", "bearing.contact_angle.nominal")
        for key in (key for key in rivals if key in v.said):
            yield key, "follows from the bottom_radius of both rings; leave one of them out"
    row = v.row
    if isinstance(clearance, str) and row is not None and row.nominal_angle is not None:
        angle_of_row = f'contact_angle = {{ nominal = "{np.degrees(row.nominal_angle):g} deg" }}'
        yield "bearing.clearance", f"is a group of deep groove bearings; give {angle_of_row}, or a length"
    elif isinstance(clearance, str) and v["bearing.bore_diameter"] is None:
        yield "bearing.clearance", "is a group, which depends on the bore: give bore_diameter, or a length"


def shoulder_faults(v: Values) -> Iterator[tuple[str, str]]:
    """The same, after the rules, for shoulders that are not between groove bottom and middle of the profile."""
    for name, side, key in zip(RINGS, (1, -1), BOTTOMS, strict=True):
        ring, profile, bottom = f"bearing.{name}", v[f"bearing.{name}.groove_radius"], v[key]
        for side_name, lowest in (("", "above"), ("far_", "at least")):
            height, diameter = (v[f"{ring}.{side_name}shoulder_{each}"] for each in ("height", "diameter"))
            if height is None or (height < profile and (height >= 0 if side_name else height > 0)):
                continue
            if diameter is None:
                limits = f"{lowest} 0 and below the groove radius {1e3 * profile:.5g} mm"
            else:
                ends = (1e3 * 2 * (bottom + side * part) for part in (0.0, profile))
                limits = "between that of the groove's bottom, {:.6g} mm, and {:.6g} mm".format(*ends)
            yield f"{ring}.{side_name}shoulder_{'height' if diameter is None else 'diameter'}", f"must be {limits}"


def _thrust_faults(v: Values) -> Iterator[tuple[str, str]]:
    """The same for what only a thrust bearing lacks, or does not take."""
    if v["bearing.pitch_diameter"] is None:
        yield "bearing.pitch_diameter", 'is missing; give the circle of the ball centres, for example "36 mm"'
    angle = [f"contact_angle.{name}" for name in ("value", "free", "nominal")]
    for key in ("clearance", *angle, *(f"{ring}.{key}" for ring in RINGS for key in OF_RADIAL)):
        if v[f"bearing.{key}"] is not None:
            yield (
                f"bearing.{key.partition('.')[0] if key in angle else key}",
                'goes with kind = "radial": the balls of a thrust bearing touch at 90 deg; leave it out',
            )
    profiles = {_conformity(v, name) for name in RINGS}
    if len(profiles) > 1 and not np.isnan([*profiles]).any():
        yield "bearing.outer.groove_radius", "must be that of the inner ring: a thrust bearing has two equal grooves"


def bearing_of(v: Values) -> Bearing:
    """The bearing of values that the rules have filled."""
    row, origin = v.row, v.origins.get(GAP)
    if origin and row is not None and row.clearance_group is None and isinstance(v["bearing.clearance"], str):
        # A designation without a group is that of CN.
        origin = replace(origin, status="printed" if "bearing.clearance" in v.said else "assumed")
    is_own = row is not None and _is_replaced(v, row)
    lost = {key for key in RATINGS if f"bearing.{key}" not in v.said} if is_own else set()  # of the original bearing
    name = v["bearing.name"] or v["bearing.catalog"] or v["name"]
    origins = _origins(v) | ({} if origin is None else {"clearance": origin})
    return Bearing(
        **v.fields(
            Bearing,
            "bearing",
            **dict.fromkeys(lost),
            name=f"own bearing (from {name})" if is_own and "bearing.name" not in v.said else name,
            series=None if is_own else _series(v),
            seals=None if row is None else row.seals,
            seals_rub=row is not None and any(seal_contact(suffix) != "none" for suffix in row.seal_suffixes),
            grade=None if row is None or is_own else row.grade,
            origins=read_only({key: each for key, each in origins.items() if key not in lost}),
        )
    )


def _is_replaced(v: Values, row: CatalogBearing) -> bool:
    """Whether the scene gives the row's bearing other balls or other grooves: it is no longer the maker's."""
    grooves = [_conformity(v, ring) for ring in RINGS]
    same_grooves = np.allclose(grooves, row.conformity, rtol=AS_PRINTED, atol=0)
    return has_other_balls(v) or not same_grooves


def has_own_balls(v: Values) -> bool:
    """Whether the document says how many balls there are, or how large."""
    return any(f"bearing.{key}" in v.said for key in BALLS)


def has_other_balls(v: Values) -> bool:
    """Whether the scene gives the catalogue's bearing other balls."""
    if v.row is None or not has_own_balls(v):
        return False
    balls = (v["bearing.ball_count"], v["bearing.ball_diameter"]), (v.row.ball_count, v.row.ball_diameter)
    return not np.allclose(*balls, rtol=AS_PRINTED, atol=0)


def _series(v: Values) -> str | None:
    """That of the row, unless the scene gives the bearing other boundary dimensions."""
    sizes = tuple(v[f"bearing.{key}"] for key in ("bore_diameter", "outside_diameter", "width"))
    row = v.row
    return row.series if row is not None and sizes == (row.bore, row.outside, row.width) else None


def _conformity(v: Values, ring: str) -> float:
    """Groove radius over ball diameter; NaN: not given."""
    radius, conformity = v[f"bearing.{ring}.groove_radius"], v[f"bearing.{ring}.conformity"]
    if radius is not None:
        return radius / v[BALL]
    known = v["bearing.conformity"] if conformity is None else conformity
    return np.nan if known is None else known


def _origins(v: Values) -> dict[str, Origin]:
    """Where each dimension comes from: the catalogue's row, or the scene where it gives its own."""
    origins = dict(v.row.origins) if v.row is not None else {}
    if v.row is None and v["bearing.catalog"] is not None:
        entry = catalog.entry("bearings", v["bearing.catalog"]).get("origins", {})
        origins = {key: Origin(uncertainty=None, **origin) for key, origin in entry.items()}
    said = set()
    for path in v.said:
        table, _, name = path.rpartition(".")
        if name not in NO_DIMENSIONS and table == "bearing" and name not in (*RINGS, "contact_angle"):
            said |= {f"{ring}.conformity" for ring in RINGS} if name == "conformity" else {name}
        elif table in ("bearing.inner", "bearing.outer"):
            said.add(f"{table.partition('.')[2]}.{_said_by(table, name)}")
    if "inner.bottom_radius" in said:
        said |= {"pitch_diameter", "clearance"}
    return origins | {key: GIVEN for key in sorted(said) if key not in MATERIALS or key in origins}


def _said_by(ring: str, key: str) -> str:
    """The key of a ring that stands for this one and its rivals."""
    if key in ("groove_radius", "conformity"):
        return "conformity"
    keys = next((keys for keys in RIVALS if f"{ring}.{key}" in keys), (key,))
    return keys[0].rpartition(".")[2]
