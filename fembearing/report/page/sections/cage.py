"""The cage: the stiffness of its pockets by each model, and its motion."""

from collections.abc import Sequence
from typing import NamedTuple

from analytic.cage.grip import LARGEST_GRIP
from fembearing.quantities import CONTACT, MICRO, NEWTON_MILLIMETRE, RPM
from fembearing.report.document.contact import Contact
from fembearing.report.document.report import Report
from fembearing.report.document.torque import MovedCage
from fembearing.report.page.sections.grid import Grid, Head, Row, grid_of
from fembearing.report.phrases import digits, percent, place_of, shown

NM = NEWTON_MILLIMETRE.factor


class CageSection(NamedTuple):
    """Tables of the section; None where there is nothing to show."""

    pocket: Grid | None
    load: str  # of the pocket, N
    motion: Grid | None
    regimes: Grid | None
    largest_grip: float


def cage_section(document: Report) -> CageSection:
    """What the section shows."""
    moved = [each for each in document.cage_motion or () if isinstance(each, MovedCage)]
    return CageSection(
        pocket=_pocket(document.contacts),
        load=f"{document.contacts[-1].load:g}",
        motion=_motion(moved) if moved else None,
        regimes=_regimes(moved) if moved else None,
        largest_grip=LARGEST_GRIP,
    )


def _pocket(contacts: Sequence[Contact]) -> Grid | None:
    """Each model of the pocket, Hertz first; None without a cage."""
    if len(contacts) < 4:
        return None
    approach, stiffness = CONTACT["approach"].shown, CONTACT["stiffness"].shown
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


def _motion(moved: Sequence[MovedCage]) -> Grid:
    heads = [
        Head(f"speed, {RPM.name}"),
        *(Head(name, "text") for name in ("regime", "start")),
        *(Head(name) for name in ("torque, N mm", "95 %, N mm", "signed moment, N mm", "all forces, N", "largest, N")),
        Head("95 %, N"),
    ]
    rows = [
        [
            shown(point.inner_speed, ".5g", RPM.factor),
            point.state,
            point.start,
            shown(point.torque, ".3g", NM),
            _between(point.interval.torque, NM),
            shown(point.signed_moment, ".2g", NM),
            shown(point.mean_force, ".3g"),
            shown(point.max_force, ".3g"),
            _between(point.interval.max_force, 1.0),
        ]
        for point in moved
    ]
    return grid_of("motion of the cage", heads, rows)


def _other(point: MovedCage) -> str:
    other = point.other
    if other is None:
        return "the cage cannot whirl: one steady motion"
    decides = "" if other.state == point.state else ": the start decides"
    return f"{other.state} from {other.start}, {NEWTON_MILLIMETRE.written(other.torque, '.3g')}{decides}"


def _regimes(moved: Sequence[MovedCage]) -> Grid:
    names = ("whirl, rpm", f"wobble, {MICRO.name}", f"ball lead, {MICRO.name}", "grip used", "grip number")
    heads = [Head(f"speed, {RPM.name}"), Head("regime", "text"), *(Head(name) for name in names)]
    heads += [Head("duration", "text"), Head("another start", "text")]
    rows = [
        [
            shown(point.inner_speed, ".5g", RPM.factor),
            point.state,
            shown(point.whirl_speed, ".4g", RPM.factor),
            shown(point.wobble, ".3g", MICRO.factor),
            shown(point.ball_lead, ".3g", MICRO.factor),
            percent(point.grip_share),
            shown(point.grip_number, ".2g", absent="unknown"),
            f"{point.duration:.3g} s in blocks of {point.block:.3g} s",
            _other(point),
        ]
        for point in moved
    ]
    return grid_of("regime of the cage", heads, rows)


def _between(ends: Sequence[float], factor: float) -> str:
    return f"{ends[0] * factor:.3g} to {ends[1] * factor:.3g}"
