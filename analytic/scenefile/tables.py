"""Tables of a scene beside bearing, cage and oil: seats and temperatures, a second bearing, surfaces and losses.

Surfaces are given by rms roughness, by Ra, by a finish of the catalog, or by a height map. Losses are as declared, or
the drag of the seals by SKF's formula, which seals that rub have by default.
"""

import math
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from analytic.catalog.seals import seal_spread, seal_torque, seal_type
from analytic.declared import read_only
from analytic.errors import InputError
from analytic.mounting.clearance import Mounting, mounted, mounting_faults
from analytic.scene import (
    Arrangement,
    Autocorrelation,
    Bearing,
    Clearances,
    ContactAngle,
    HeightMapFile,
    Losses,
    Origin,
    Surface,
)
from analytic.scenefile.fit import arrangement_misfits, bearing_misfits
from analytic.scenefile.keys import GIVEN, Values
from analytic.surface.heightmap import HAVE_NO_SPACING, READERS

WAYS = ("rms_roughness", "Ra", "finish", "height_map")  # to say how rough a surface is
ROUGHNESSES = ("rms_roughness", "ball_rms_roughness")
# Neither Ra nor a finish says how long the waves of a surface are. A judgement, no source seen: 10 to 40 um.
ASSUMED_CORRELATION = Autocorrelation(kind="gaussian", length=20e-6, spacing=1e-6)
LENGTH_DEVIATION = 15e-6 / math.sqrt(3)  # m: of 30 um between the limits
SHOULDER = 0.2  # height over the ball diameter, where the catalogue has none: usual


def installation_faults(v: Values) -> Iterator[tuple[str, str]]:
    """(path of the key, problem) for keys of mounting and arrangement in conflict with others."""
    is_tilted = v["operation.tilt"] not in (None, "free", 0.0)
    if v["bearing.kind"] == "thrust":
        yield from _washer_faults(v)
        return
    if "mounting" in v.said:
        yield from _mounting_faults(v)
    if "arrangement" in v.said and is_tilted:
        yield "operation.tilt", "is of a single bearing, and the loads tilt the shaft of a pair; leave it out"
    if "arrangement" in v.said and v["bearing.contact_angle.rule"] == "given":
        yield (
            "bearing.contact_angle.rule",
            'fixes the contact angle, which the loads of a pair change: use "solved", or leave out [arrangement]',
        )


def _washer_faults(v: Values) -> Iterator[tuple[str, str]]:
    """The same for tables that a thrust bearing does not take."""
    for keys, why in (
        (("mounting", "arrangement"), "for a thrust bearing; leave the table out"),
        (("cage.start", "cage.land"), "in a thrust bearing, whose cage rests on its balls; leave it out"),
    ):
        yield from ((key, f"is not modelled {why}") for key in keys if key in v.said)
    if v["operation.tilt"] not in (None, "free", 0.0):
        yield "operation.tilt", "is not modelled for a thrust bearing, whose washers are parallel; leave it out"
    for key in ("operation.radial_load", "operation.moment"):
        if any(v[key]):
            yield key, "is not modelled for a thrust bearing, which carries axial_load alone; leave it out"


def in_operation(bearing: Bearing, v: Values) -> tuple[Bearing, Clearances | None]:
    """The bearing on its seats, and its clearances; rings without a temperature stay as they were mounted."""
    mounting = Mounting(**v.fields(Mounting, "mounting"))
    v.misfits += mounting_faults(bearing, mounting)
    if v.misfits:
        return bearing, None
    warm, clearances = mounted(bearing, mounting)
    if bearing.other_candidate is not None:
        warm = replace(warm, other_candidate=mounted(bearing.other_candidate, mounting)[0])
    for key, why in bearing_misfits(warm):
        v.misfits.append(("mounting", f"leads to a bearing in operation whose {key} {why}"))
    return warm, clearances


def arranged(v: Values, bearing: Bearing, angle: ContactAngle) -> Arrangement | None:
    """The pair of [arrangement]; None: its table has conflicts."""
    try:
        arrangement = Arrangement(**v.fields(Arrangement, "arrangement"))
    except InputError as problem:
        key, _, words = str(problem).partition(" ")
        v.misfits.append((key, words))
        return None
    width, distance = bearing.width, arrangement.distance
    if distance is None and width is None:
        problem = "is missing: give it or bearing.width, which it is by default"
        v.misfits.append(("arrangement.distance", problem))
    elif distance is not None and width is not None and distance < width:
        problem = f"must be at least bearing.width {width * 1e3:.6g} mm, else the rings overlap"
        v.misfits.append(("arrangement.distance", problem))
    else:
        v.misfits += arrangement_misfits(bearing, angle, arrangement)
    return arrangement


def _mounting_faults(v: Values) -> Iterator[tuple[str, str]]:
    if v["bearing.contact_angle.free"] is not None:
        yield (
            "bearing.contact_angle.free",
            "leaves the clearance open, which [mounting] changes: give contact_angle = { nominal = ... } or "
            "bearing.clearance instead",
        )
    elif v["bearing.contact_angle.rule"] == "given":
        yield (
            "bearing.contact_angle.rule",
            'fixes the contact angle, which [mounting] changes: use "solved", or leave out [mounting]',
        )
    known = [key for key in ("inner_temperature", "outer_temperature") if v[f"mounting.{key}"] is not None]
    if len(known) == 1:
        (other,) = {"inner_temperature", "outer_temperature"} - set(known)
        yield f"mounting.{other}", f"is missing: {known[0]} alone does not give the temperature difference of the rings"
    elif not known and v["mounting.ball_temperature"] is not None:
        yield "mounting.ball_temperature", "goes with inner_temperature and outer_temperature: give these too"


def surface_conflicts(v: Values) -> Iterator[tuple[str, str]]:
    """(key, problem) of keys of [surface] that are valid on their own and in conflict with each other."""
    path, has_own_law = v["surface.height_map.path"], "surface.asperities" in v
    ways = [key for key in WAYS if f"surface.{key}" in v.said]
    has_correlation = "surface.autocorrelation" in v.said
    if len(ways) != 1:
        has = f", it has {' and '.join(ways)}" if ways else ""
        yield "", f"surface needs exactly one of {', '.join(WAYS[:-1])} and {WAYS[-1]}{has}"
    elif ways == ["height_map"] and has_correlation:
        yield "", "surface.autocorrelation does not go with height_map, which has its own; leave it out"
    elif ways == ["rms_roughness"] and not has_correlation:
        yield (
            "surface.autocorrelation",
            f"is missing, which goes with rms_roughness; {Autocorrelation.HINT}, or Ra or finish that assume one",
        )
    if has_own_law and v["surface.gap"] != "truncated":
        yield "", 'surface.asperities is the law of summits of gap = "truncated": leave it out, or give that gap'
    ending = "" if path is None else Path(path).suffix.lower()
    if path is not None and ending not in READERS:
        yield "surface.height_map.path", f"is not one of {', '.join(READERS)}"
    elif ending in HAVE_NO_SPACING and v["surface.height_map.spacing"] is None:
        yield "surface.height_map.spacing", 'is missing; give that of the points, for example "2 um"'


def surface_of(v: Values, folder: Path) -> Surface | None:
    """The surface that the table describes, if there is one; folder : that the path of a height map starts from."""
    if "surface" not in v.said:
        return None
    height_map: HeightMapFile | None = v.noun(HeightMapFile, "surface.height_map")
    if height_map is not None:
        path = folder / height_map.path
        height_map = replace(height_map, path=str(path))
        if not path.is_file():
            problem = "is not a file; give its path from the scene file's folder"
            v.misfits.append(("surface.height_map.path", problem))
            return None
    roughness: float | None = v["surface.rms_roughness"]
    correlation: Autocorrelation | None = v.noun(Autocorrelation, "surface.autocorrelation")
    given = {key: GIVEN for key in ROUGHNESSES if f"surface.{key}" in v.said}
    origins = given | {key: v.origins[f"surface.{key}"] for key in ROUGHNESSES if f"surface.{key}" in v.origins}
    if correlation is not None:
        origins["autocorrelation.length"] = GIVEN
    elif roughness is not None:
        source = "length and spacing are a judgement, 10 to 40 um and a twentieth of the length; no source seen"
        origins["autocorrelation.length"] = Origin(status="assumed", uncertainty=LENGTH_DEVIATION, source=source)
    assumed = None if roughness is None else ASSUMED_CORRELATION
    return Surface(
        **v.fields(
            Surface,
            "surface",
            autocorrelation=assumed if correlation is None else correlation,
            height_map=height_map,
            asperities=v["surface.asperities"] or Surface.asperities,
            origins=read_only(origins),
        )
    )


def losses_of(v: Values, bearing: Bearing) -> Losses:
    """The losses of [losses] of a bearing as it is delivered. Raises InputError for seals that nobody names."""
    seals = v["losses.seals"]
    if isinstance(seals, float) or seals == "off" or (seals is None and not bearing.seals_rub):
        return Losses(**v.fields(Losses, "losses", seals=0.0 if seals == "off" else seals))
    row = v.row
    if row is None:
        raise InputError('it needs seals by a designation of the catalogue, for example catalog = "6205-2RS1"')
    inner = bearing.inner
    height = SHOULDER * bearing.ball_diameter
    if inner.shoulder_half_width is not None:
        height = inner.groove_radius - math.sqrt(inner.groove_radius**2 - inner.shoulder_half_width**2)
    counterface = 2 * (inner.bottom_radius + height)
    drag = seal_torque(row, counterface=counterface)
    kinds = sorted({kind for seals in row.seal_suffixes if (kind := seal_type(seals)) is not None})
    if not kinds:
        return Losses(**v.fields(Losses, "losses", seals=drag))
    words = f"SKF's formula for {' and '.join(kinds)} seals [SKFSeals], on a diameter of {1e3 * counterface:.4g} mm"
    origin = Origin(status="assumed", uncertainty=seal_spread(row) * drag, source=words)
    return Losses(**v.fields(Losses, "losses", seals=drag, origins=read_only({"seals": origin})))
