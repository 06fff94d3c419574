"""The check of a scene as tables and lines of text for a terminal or a pipe of 80 characters."""

from rich.console import Console

from analytic.result import COORDINATES, TorquePoint
from analytic.words import angle_of, percent_of
from fembearing.quantities import CONTACT, NEWTON_MILLIMETRE, RPM, TANGENT
from fembearing.report.contact import ContactRecord, sheet_in_series
from fembearing.report.phrases import (
    film_change_words,
    friction_of,
    interval_at,
    interval_words,
    loads_of,
    percent,
    present_loads,
)
from fembearing.report.report import ChangeRecord, Report
from fembearing.report.terminal.contacts import print_contact
from fembearing.report.terminal.film import print_film
from fembearing.report.terminal.table import table_of
from fembearing.report.terminal.torque import point_columns, shown_points
from fembearing.report.terminal.verdicts import print_notes, print_numerical, print_physical
from fembearing.report.torque import TorqueRecord


def print_validation(out: Console, document: Report) -> None:
    """Print the check of a scene: contacts, torque, and the verdicts, in the last line in a word each."""
    for contact in document.contacts:
        verdicts = {name: row.verdict for name, row in document.verdicts_on(contact).items()}
        print_contact(out, contact, verdicts)
    for film in document.films:
        print_film(out, film)
    if len(document.contacts) > 2:
        _print_pocket(out, *document.contacts[2:])
    if document.torque is not None and document.torque_change is not None:
        scene = document.scene
        friction = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.is_lubricated)
        _print_totals(out, document.torque, friction)
        _print_change(out, document.torque, document.torque_change)
    else:
        out.print("No friction coefficient, lubricant or surface is given, so there is no torque.\n")
    if document.film_change is not None:
        out.print(f"{film_change_words(document.film_change)}\n")
    print_physical(out, document.physical)
    if document.torque is not None:
        print_notes(out, document.torque.notes)
        print_numerical(out, document.torque.verdicts.numerical)
    out.print(f"Tolerance {percent_of(document.tolerance)}, {document.cost.seconds:.1f} s.")
    out.print(document.verdict.words)


def _print_pocket(out: Console, seat: ContactRecord, sheet: ContactRecord) -> None:
    """K_pb by three models: the half space's formula, a thick seat, and the sheet that is there."""
    shown = CONTACT["stiffness"].shown
    formula, thick, thin = (
        shown.factor * value for value in (seat.hertz.stiffness, seat.fe.stiffness, sheet.fe.stiffness)
    )
    series = sheet_in_series(seat, sheet)
    bends = series and (
        f" In series with the seat the sheet has {TANGENT.written(series.stiffness, '.4g')} "
        f"+- {percent_of(series.uncertainty, 2)}."
    )
    out.print(
        f"Pocket, F = K_pb delta^1.5: K_pb {formula:.4g} {shown.name} by Hertz, {thick:.4g} in a thick seat, "
        f"{thin:.4g} with the sheet on its rim ({thin / formula - 1:+.0%}).{bends or ''}\n"
    )


def _print_totals(out: Console, torque: TorqueRecord, friction: str) -> None:
    """The total at every operating point, as `fembearing torque` computes it."""
    points = torque.points
    columns, fixed = point_columns({name: [getattr(point, name) for point in points] for name in COORDINATES})
    low, high = torque.catalogue_band.low, torque.catalogue_band.high
    sides = None if low is None or high is None else list(zip(low, high, strict=True))
    factor = NEWTON_MILLIMETRE.factor
    predicted = torque.prediction
    optional = (*(() if predicted is None else ("95 %",)), *(() if sides is None else ("catalogue",)))
    heads = ("#", *columns, f"total, {NEWTON_MILLIMETRE.name}", "+-", *optional)
    table = table_of(heads, title=", ".join(["Friction torque", *fixed]), fixed=heads)
    shown = shown_points(len(points))
    for number in shown:
        table.add_row(
            str(number + 1),
            *(values[number] for values in columns.values()),
            f"{points[number].torque.total * factor:.4g}",
            percent(points[number].uncertainty.numerical),
            *(() if predicted is None else (interval_at(predicted.points[number]),)),
            *(() if sides is None else (f"{sides[number][0] * factor:.3g}-{sides[number][1] * factor:.3g}",)),
        )
    out.print(table)
    if len(shown) < len(points):
        out.print(f"{len(shown)} of {len(points)} operating points; --json has all of them.")
    out.print(
        f"Total about the bearing axis, as `fembearing torque` computes it; +-: numerical uncertainty. Friction: "
        f"{friction}.\n",
        style="dim",
    )
    if predicted is not None:
        out.print(f"{interval_words(predicted)}\n", style="dim", markup=False)


def _print_change(out: Console, torque: TorqueRecord, change: ChangeRecord) -> None:
    """What the contacts of finite elements change, at the operating point whose contacts were solved."""
    angles, totals = change.contact_angle, change.torque
    columns = (totals.production, totals.corrected, angles.production, angles.corrected, change.change.total)
    solved = [row for row in zip(torque.points, *columns, strict=True) if row[2] is not None]
    point, before, after, angle, corrected, relative = max(solved, key=lambda row: _heaviest(row[0]))
    before, after = (NEWTON_MILLIMETRE.written(total, ".4g") for total in (before, after))
    place = f"{RPM.written(point.inner_speed, '.5g')}, {loads_of(point, present_loads(torque.points))}"
    out.print(
        f"What finite-element contacts change at {place}: production {before}, with contacts of FE {after}: "
        f"{relative:+.2%} +- {change.uncertainty:.2%} (numerical); contact angle "
        f"{angle_of(angle)} and {angle_of(corrected)}.\n{change.note}\n"
    )
    fitted = change.finite_geometry
    known = [] if fitted is None else [value for value in fitted.change if value is not None]
    if fitted is not None and known:
        ends = dict.fromkeys(f"{end:+.2%}" for end in (max(known), min(known)))
        out.print(
            f"With Hertz's contacts corrected for finite geometry {' to '.join(ends)} +- "
            f"{max(value for value in fitted.uncertainty if value is not None):.2%} over {len(known)} of "
            f"{len(fitted.change)} operating points.\n"
        )
    if change.verdict != "pass":
        out.print(f"The race contacts are not all within the tolerance: {change.verdict}.\n")


def _heaviest(point: TorquePoint) -> float:
    """The load of the heaviest ball, N."""
    return max(point.contact.inner.load, point.contact.outer.load)
