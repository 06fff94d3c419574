"""The cage in motion."""

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING

from analytic.cage.drive import LARGEST_GRIP
from analytic.columns import Point
from analytic.scene_torque import SceneTorque
from analytic.units import METRIC, Units
from fembearing.report.document import Head, Section, Table, table_of
from fembearing.report.phrases import between, percent, shown

if TYPE_CHECKING:  # a torque alone needs no solver, which the report of a check loads
    from fembearing.report.report import Report

Moved = Mapping[int, Point]  # by the number of the operating point
MOTION = (
    "Motion of the cage under the forces of its balls, by time stepping. Torque: power of sliding and drag over the "
    "speed of the ring, included in the total. All forces: mean of their sum. Largest: force of one ball on its "
    "pocket, median over blocks. 95 %: interval of the mean over seeds. Signed moment: of the balls on the cage about "
    "the bearing's axis; its mean is 0 without other brakes of the cage."
)
REGIME = (
    "Whirl: mean speed of the cage's centre about the axis. Wobble: root mean square change of its distance. "
    "Grip used: mean force over the friction of the races along the orbit. Grip number: the same of a whirl, by the "
    f"weakest ball; balls slide above {LARGEST_GRIP:g}. Races: additional friction of the races by the drag of the "
    "cage, where balls and cage move together; part of the cage's torque. Ball lead: lead of the balls on one side of "
    "the bearing, equal to their lag on the other. Another start: final motion of the same cage from another start."
)


def cage_tables(
    motion: Sequence[Point] | None, torque: SceneTorque, places: Collection[int], units: Units = METRIC
) -> list[Table]:
    """Forces and regime at those of the points where a cage moved; none where none did.

    motion : at each point that has a torque
    """
    points = zip(torque.places.computed, motion or (), strict=motion is not None)
    moved = {place + 1: point for place, point in points if place in places and point["torque"] is not None}
    return [motion_table(moved, units), regime_table(moved, units)] if moved else []


def motion_table(moved: Moved, units: Units = METRIC) -> Table:
    """Forces and torque with their intervals."""
    torque, force = units.torque, units.force
    heads = [*_first(units), Head("start", "text", wide=True)]
    heads += [Head(f"{name}, {force.name}") for name in ("all forces", "largest")]
    heads += [Head("95 %"), Head(f"torque, {torque.name}"), Head("95 %")]
    heads += [Head(f"signed moment, {torque.name}", wide=True)]
    rows = [
        [
            *_named(number, point, units),
            point["start"] or "-",
            shown(point["mean_force"], ".3g", force.factor),
            shown(point["max_force"], ".3g", force.factor),
            between(point["interval"] and point["interval"]["max_force"], force),
            shown(point["torque"], ".3g", torque.factor),
            between(point["interval"] and point["interval"]["torque"], torque),
            shown(point["signed_moment"], ".2g", torque.factor),
        ]
        for number, point in moved.items()
    ]
    return table_of("Cage in motion", heads, rows, [MOTION])


def regime_table(moved: Moved, units: Units = METRIC) -> Table:
    """How the cage goes round, and what that asks of the races."""
    speed, small, torque = units.speed, units.small_length, units.torque
    names = (f"whirl, {speed.name}", f"wobble, {small.name}", f"ball lead, {small.name}", "grip used", "grip number")
    heads = [*_first(units), *map(Head, names), Head(f"races, {torque.name}")]
    heads += [Head("duration", "text", wide=True), Head("another start", "text", wide=True)]
    rows = [
        [
            *_named(number, point, units),
            shown(point["whirl_speed"], ".4g", speed.factor),
            shown(point["wobble"], ".3g", small.factor),
            shown(point["ball_lead"], ".3g", small.factor),
            percent(point["grip_share"]),
            shown(point["grip_number"], ".2g", absent="unknown"),
            shown(point["race_excess"], "+.3g", torque.factor, absent=""),
            f"{shown(point['duration'], '.3g')} s in blocks of {shown(point['block'], '.3g')} s",
            _other(point, units),
        ]
        for number, point in moved.items()
    ]
    return table_of("Regime of the cage", heads, rows, [REGIME])


def _first(units: Units) -> list[Head]:
    return [Head("#"), Head(f"speed, {units.speed.name}", wide=True), Head("state", "text")]


def _named(number: int, point: Point, units: Units) -> list[str]:
    return [str(number), shown(point["inner_speed"], ".5g", units.speed.factor), point["state"] or "-"]


def _other(point: Point, units: Units) -> str:
    other = point["other"]
    if other is None:
        return "no whirl: one steady motion"
    decides = "" if other["state"] == point["state"] else ": the start decides"
    return f"{other['state']} from {other['start']}, {units.torque.written(other['torque'], '.3g')}{decides}"


def cage_section(document: "Report") -> Section:
    """The cage in motion; without blocks: no cage moved."""
    torque = document.solved
    every = () if torque is None else range(len(torque.points))
    tables = [] if torque is None else cage_tables(document.cage_motion, torque, every, document.units)
    return Section("Cage", tables)
