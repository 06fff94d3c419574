"""The cage: the stiffness of its pockets by each model, and its motion."""

from collections.abc import Sequence
from typing import NamedTuple

from analytic.cage.drive import LARGEST_GRIP
from fembearing.quantities import Units
from fembearing.report.contact import ContactRecord
from fembearing.report.page.sections.grid import Grid, Head, Row, grid_of
from fembearing.report.phrases import digits, percent, place_of, shown
from fembearing.report.report import CageMotionPoint, Report


class CageSection(NamedTuple):
    """Tables of the section; None where there is nothing to show."""

    pocket: Grid | None
    load: str  # of the pocket
    motion: Grid | None
    regimes: Grid | None
    largest_grip: float


def cage_section(document: Report) -> CageSection:
    """What the section shows."""
    units = document.units
    moved = [each for each in document.cage_motion or () if each.torque is not None]
    return CageSection(
        pocket=_pocket(document.contacts, units),
        load=units.force.written(document.contacts[-1].load, ".4g"),
        motion=_motion(moved, units) if moved else None,
        regimes=_regimes(moved, units) if moved else None,
        largest_grip=LARGEST_GRIP,
    )


def _pocket(contacts: Sequence[ContactRecord], units: Units) -> Grid | None:
    """Each model of the pocket, Hertz first; None without a cage."""
    if len(contacts) < 4:
        return None
    approach, stiffness = units.small_length, units.stiffness
    models = [("Hertz: two half spaces", contacts[2].hertz, None)]
    models += [(place_of(each.pair, each.geometry), each.fe, each.uncertainty.stiffness) for each in contacts[2:]]
    heads = [
        Head("model", "text"),
        Head(f"K_pb, {stiffness.name}"),
        Head("uncertainty"),
        Head("less Hertz's, of Hertz's"),
        Head(f"approach, {approach.name}"),
    ]
    rows: list[Row] = [
        [
            model,
            digits(values.stiffness, stiffness.factor, 4),
            shown(uncertainty, ".2%", absent=""),
            f"{values.stiffness / contacts[2].hertz.stiffness - 1:+.1%}",
            digits(values.approach, approach.factor, 4),
        ]
        for model, values, uncertainty in models
    ]
    return grid_of("stiffness of the pocket", heads, rows)


def _motion(moved: Sequence[CageMotionPoint], units: Units) -> Grid:
    torque, force = units.torque, units.force
    heads = [
        Head(f"speed, {units.speed.name}"),
        *(Head(name, "text") for name in ("regime", "start")),
        *(Head(f"{name}, {torque.name}") for name in ("torque", "95 %", "signed moment")),
        *(Head(f"{name}, {force.name}") for name in ("all forces", "largest", "95 %")),
    ]
    rows = [
        [
            shown(point.inner_speed, ".5g", units.speed.factor),
            point.state or "-",
            point.start or "-",
            shown(point.torque, ".3g", torque.factor),
            _between(point.interval and point.interval.torque, torque.factor),
            shown(point.signed_moment, ".2g", torque.factor),
            shown(point.mean_force, ".3g", force.factor),
            shown(point.max_force, ".3g", force.factor),
            _between(point.interval and point.interval.max_force, force.factor),
        ]
        for point in moved
    ]
    return grid_of("motion of the cage", heads, rows)


def _other(point: CageMotionPoint, units: Units) -> str:
    other = point.other
    if other is None:
        return "the cage cannot whirl: one steady motion"
    decides = "" if other.state == point.state else ": the start decides"
    return f"{other.state} from {other.start}, {units.torque.written(other.torque, '.3g')}{decides}"


def _regimes(moved: Sequence[CageMotionPoint], units: Units) -> Grid:
    speed, small = units.speed, units.small_length
    names = (f"whirl, {speed.name}", f"wobble, {small.name}", f"ball lead, {small.name}", "grip used", "grip number")
    heads = [Head(f"speed, {speed.name}"), Head("regime", "text"), *(Head(name) for name in names)]
    heads += [Head("duration", "text"), Head("another start", "text")]
    rows = [
        [
            shown(point.inner_speed, ".5g", units.speed.factor),
            point.state or "-",
            shown(point.whirl_speed, ".4g", units.speed.factor),
            shown(point.wobble, ".3g", small.factor),
            shown(point.ball_lead, ".3g", small.factor),
            percent(point.grip_share),
            shown(point.grip_number, ".2g", absent="unknown"),
            f"{shown(point.duration, '.3g')} s in blocks of {shown(point.block, '.3g')} s",
            _other(point, units),
        ]
        for point in moved
    ]
    return grid_of("regime of the cage", heads, rows)


def _between(ends: Sequence[float] | None, factor: float) -> str:
    return "-" if ends is None else f"{ends[0] * factor:.3g} to {ends[1] * factor:.3g}"
