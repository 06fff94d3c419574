"""How the bearing of a scene is installed: on its seats, at its temperatures, and beside a second one."""

from collections.abc import Iterator
from dataclasses import replace

from analytic.errors import InputError
from analytic.mounting.clearance import Mounting, mounted, mounting_faults
from analytic.scene import Arrangement, Bearing, Clearances, ContactAngle
from analytic.scenefile.fit import arrangement_misfits, bearing_misfits
from analytic.scenefile.keys import Values


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
    for key in {"mounting", "arrangement"} & v.said:
        yield key, "is not modelled for a thrust bearing; leave the table out"
    for key in {"cage.start", "cage.land"} & v.said:
        yield key, "is not modelled in a thrust bearing, whose cage rests on its balls; leave it out"
    if v["operation.tilt"] not in (None, "free", 0.0):
        yield "operation.tilt", "is not modelled for a thrust bearing, whose washers are parallel; leave it out"
    for key in ("operation.radial_load", "operation.moment"):
        if any(v[key]):
            yield key, "is not modelled for a thrust bearing, which carries axial_load alone; leave it out"


def in_operation(bearing: Bearing, v: Values) -> tuple[Bearing, Clearances | None, list[tuple[str, str]]]:
    """The bearing on its seats, its clearances, and (path of the key, problem) for what cannot be.

    Rings without a temperature stay as they were mounted.
    """
    mounting = _mounting(v)
    problems = list(mounting_faults(bearing, mounting))
    if problems:
        return bearing, None, problems
    warm, clearances = mounted(bearing, mounting)
    if bearing.other_candidate is not None:
        warm = replace(warm, other_candidate=mounted(bearing.other_candidate, mounting)[0])
    misfits = bearing_misfits(warm)
    return (
        warm,
        clearances,
        [("mounting", f"leads to a bearing in operation whose {key} {why}") for key, why in misfits],
    )


def _mounting(v: Values) -> Mounting:
    solids = {key: v[f"mounting.{key}"] for key in ("shaft_material", "housing_material")}
    return Mounting(**v.fields(Mounting, "mounting", **solids))


def arranged(v: Values, bearing: Bearing, angle: ContactAngle) -> tuple[Arrangement | None, list[tuple[str, str]]]:
    """The pair of [arrangement], and (path of the key, problem) for what is missing or cannot be."""
    try:
        arrangement = Arrangement(**v.fields(Arrangement, "arrangement"))
    except InputError as problem:
        key, _, words = str(problem).partition(" ")
        return None, [(key, words)]
    width, distance = bearing.width, arrangement.distance
    if distance is None and width is None:
        return arrangement, [("arrangement.distance", "is missing: give it or bearing.width, which it is by default")]
    if distance is not None and width is not None and distance < width:
        least = f"bearing.width {width * 1e3:.6g} mm"
        return arrangement, [("arrangement.distance", f"must be at least {least}, else the rings overlap")]
    return arrangement, list(arrangement_misfits(bearing, angle, arrangement))


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
