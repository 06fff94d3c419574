"""How the bearing of a scene is installed: on its seats, at its temperatures, and beside a second one."""

from collections.abc import Iterator
from dataclasses import replace

from analytic.errors import InputError
from analytic.mounting.clearance import Mounting, mounted, mounting_faults
from analytic.scene import Arrangement, Bearing, Clearances, ContactAngle, Material
from analytic.scenefile.fit import arrangement_misfits, bearing_misfits
from analytic.scenefile.tables import ArrangementTable, ContactAngleTable, MountingTable, SceneTable


def installation_faults(table: SceneTable) -> Iterator[tuple[str, str]]:
    """(path of the key, problem) for keys of mounting and arrangement in conflict with others."""
    angle = table.bearing.contact_angle
    if table.bearing.kind == "thrust":
        yield from _washer_faults(table)
        return
    if table.mounting is not None:
        yield from _mounting_faults(table.mounting, angle)
    if table.arrangement is not None and table.operation.tilt not in (None, "free", 0.0):
        yield "operation.tilt", "is of a single bearing, and the loads tilt the shaft of a pair; leave it out"
    if table.arrangement is not None and angle.rule == "given":
        yield (
            "bearing.contact_angle.rule",
            'fixes the contact angle, which the loads of a pair change: use "solved", or leave out [arrangement]',
        )


def _washer_faults(table: SceneTable) -> Iterator[tuple[str, str]]:
    """The same for tables that a thrust bearing does not take."""
    for key in ("mounting", "arrangement"):
        if getattr(table, key) is not None:
            yield key, "is not modelled for a thrust bearing; leave the table out"
    if table.cage is not None:
        for key in ("start", "land"):
            if getattr(table.cage, key) is not None:
                yield f"cage.{key}", "is not modelled in a thrust bearing, whose cage rests on its balls; leave it out"
    if table.operation.tilt not in (None, "free", 0.0):
        yield "operation.tilt", "is not modelled for a thrust bearing, whose washers are parallel; leave it out"
    for key in ("radial_load", "moment"):
        if any(getattr(table.operation, key)):
            yield (
                f"operation.{key}",
                "is not modelled for a thrust bearing, which carries axial_load alone; leave it out",
            )


def in_operation(bearing: Bearing, given: MountingTable) -> tuple[Bearing, Clearances | None, list[tuple[str, str]]]:
    """The bearing on its seats, its clearances, and (path of the key, problem) for what cannot be.

    given : without faults; rings without a temperature stay as they were mounted
    """
    mounting = _mounting(given)
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


def _mounting(given: MountingTable) -> Mounting:
    cold, inner, outer = given.mounting_temperature, given.inner_temperature, given.outer_temperature
    derived = {"shaft_material", "housing_material", "inner_temperature", "outer_temperature"}
    return Mounting(
        **given.model_dump(exclude=derived),
        shaft_material=Material(**given.shaft_material.model_dump()),
        housing_material=Material(**given.housing_material.model_dump()),
        inner_temperature=cold if inner is None else inner,
        outer_temperature=cold if outer is None else outer,
    )


def arranged(
    given: ArrangementTable, bearing: Bearing, angle: ContactAngle
) -> tuple[Arrangement | None, list[tuple[str, str]]]:
    """The pair of a table, and (path of the key, problem) for what is missing or cannot be."""
    try:
        arrangement = Arrangement(**given.model_dump())
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


def _mounting_faults(given: MountingTable, angle: ContactAngleTable) -> Iterator[tuple[str, str]]:
    if angle.free is not None:
        yield (
            "bearing.contact_angle.free",
            "leaves the clearance open, which [mounting] changes: give contact_angle = { nominal = ... } or "
            "bearing.clearance instead",
        )
    elif angle.rule == "given":
        yield (
            "bearing.contact_angle.rule",
            'fixes the contact angle, which [mounting] changes: use "solved", or leave out [mounting]',
        )
    known = [key for key in ("inner_temperature", "outer_temperature") if getattr(given, key) is not None]
    if len(known) == 1:
        (other,) = {"inner_temperature", "outer_temperature"} - set(known)
        yield f"mounting.{other}", f"is missing: {known[0]} alone does not give the temperature difference of the rings"
    elif not known and given.ball_temperature is not None:
        yield "mounting.ball_temperature", "goes with inner_temperature and outer_temperature: give these too"
