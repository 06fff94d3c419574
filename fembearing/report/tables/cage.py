"""The cage in motion."""

from collections.abc import Mapping, Sequence

from fembearing.quantities import METRIC, Units
from fembearing.report.phrases import percent, shown
from fembearing.report.tables.table import Head, Table, table_of
from fembearing.report.torque import CageMotionPoint

Moved = Mapping[int, CageMotionPoint]  # by the number of the operating point


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
            point.start or "-",
            shown(point.mean_force, ".3g", force.factor),
            shown(point.max_force, ".3g", force.factor),
            _between(point.interval and point.interval.max_force, force.factor),
            shown(point.torque, ".3g", torque.factor),
            _between(point.interval and point.interval.torque, torque.factor),
            shown(point.signed_moment, ".2g", torque.factor),
        ]
        for number, point in moved.items()
    ]
    return table_of("Cage in motion", heads, rows)


def regime_table(moved: Moved, units: Units = METRIC) -> Table:
    """How the cage goes round, and what that asks of the races."""
    speed, small, torque = units.speed, units.small_length, units.torque
    names = (f"whirl, {speed.name}", f"wobble, {small.name}", f"ball lead, {small.name}", "grip used", "grip number")
    heads = [*_first(units), *map(Head, names), Head(f"races, {torque.name}")]
    heads += [Head("duration", "text", wide=True), Head("another start", "text", wide=True)]
    rows = [
        [
            *_named(number, point, units),
            shown(point.whirl_speed, ".4g", speed.factor),
            shown(point.wobble, ".3g", small.factor),
            shown(point.ball_lead, ".3g", small.factor),
            percent(point.grip_share),
            shown(point.grip_number, ".2g", absent="unknown"),
            shown(point.race_excess, "+.3g", torque.factor, absent=""),
            f"{shown(point.duration, '.3g')} s in blocks of {shown(point.block, '.3g')} s",
            _other(point, units),
        ]
        for number, point in moved.items()
    ]
    return table_of("Regime of the cage", heads, rows)


def _first(units: Units) -> list[Head]:
    return [Head("#"), Head(f"speed, {units.speed.name}", wide=True), Head("state", "text")]


def _named(number: int, point: CageMotionPoint, units: Units) -> list[str]:
    return [str(number), shown(point.inner_speed, ".5g", units.speed.factor), point.state or "-"]


def _other(point: CageMotionPoint, units: Units) -> str:
    other = point.other
    if other is None:
        return "the cage cannot whirl: one steady motion"
    decides = "" if other.state == point.state else ": the start decides"
    return f"{other.state} from {other.start}, {units.torque.written(other.torque, '.3g')}{decides}"


def _between(ends: Sequence[float] | None, factor: float) -> str:
    return "-" if ends is None else "-".join(f"{end * factor:.3g}" for end in ends)
