"""Results as tables and lines of text for a terminal or a pipe of 80 characters."""

from collections import Counter
from collections.abc import Sequence

import numpy as np
from rich.console import Console
from rich.table import Table

from analytic.scene import Scene
from fembearing.compare.contact.discrepancy import ContactSolution
from fembearing.compare.contact.load_series import LoadSeries
from fembearing.compare.contact.subsurface import SubsurfaceComparison
from fembearing.compare.cost.scene_cost import Cost
from fembearing.compare.hard.case import HardOutcome
from fembearing.compare.torque.change import TorqueChange
from fembearing.compare.validation import Validation
from fembearing.provenance import provenance_of
from fembearing.report.words import (
    AXES,
    PLAIN,
    QUANTITIES,
    STRESSES,
    choices_line,
    friction_of,
    quantities_of,
    ring_line,
    short_name,
    shoulder_lines,
    title_of,
)

COLUMNS = {"quantity": 19, "Hertz": 9, "FE": 9, "Hertz/FE-1": 10, "+-": 6, "order": 5, "verdict": 9}  # characters


def print_validation(out: Console, result: Validation) -> None:
    for contact in result.contacts:
        print_contact(out, contact)
    if len(result.contacts) > 2:
        _print_pocket(out, *result.contacts[2:])
    if result.torque is not None:
        _print_torque(out, result.torque, result.scene)
    else:
        out.print(
            "No friction coefficient, lubricant or surface is given, so there is no torque.\n",
            highlight=False,
        )
    if result.hard:
        _print_hard(out, result.hard)
    out.print(f"{result.verdict}: tolerance {result.tolerance:g}, {result.seconds:.1f} s", highlight=False)


def print_contact(out: Console, contact: ContactSolution) -> None:
    told = contact.to_json()
    table = Table(title=title_of(told), **PLAIN)
    for head, width in COLUMNS.items():
        left = head in ("quantity", "verdict")
        table.add_column(head, justify="left" if left else "right", no_wrap=True, min_width=width)
    for name, shown in quantities_of(told).items():
        part, discrepancy = contact.estimates[name], contact.discrepancy[name]
        table.add_row(
            shown.heading(),
            f"{getattr(contact.hertz, name) * shown.factor:.5g}",
            f"{part.value * shown.factor:.5g}",
            f"{discrepancy:+.2%} {'*' if abs(discrepancy) > part.total else ' '}",
            f"{part.total:.2%}",
            "none" if part.order is None else f"{part.order:.1f}",
            contact.verdicts[name].removesuffix(" validity") if contact.judged else "shown",
        )
    out.print(table)
    _print_corrected(out, contact)
    for line in shoulder_lines(told):
        out.print(line, highlight=False)
    out.print(
        f"{AXES}. FE: finite elements; +-: their numerical uncertainty, "
        "95 %; *: the difference exceeds it; order: observed on the meshes.\n"
        f"{contact.method}, {contact.seconds:.1f} s\n",
        style="dim",
        highlight=False,
    )
    if contact.ring is not None:
        out.print(f"{ring_line(told['ring'])}\n", highlight=False)


def _print_corrected(out: Console, contact: ContactSolution) -> None:
    """The rung between Hertz and finite elements; the verdicts above are on Hertz as it is."""
    corrected = contact.corrected
    if corrected is None:
        return
    values = []
    for name, shown in QUANTITIES.items():
        value = getattr(corrected.quantities, name) * shown.factor
        values.append(f"{shown.name} {value:.5g} {shown.unit} ({contact.interpolation_error[name]:+.2%})")
    out.print(
        f"Hertz corrected for finite geometry (its interpolation error, over FE - 1): {', '.join(values)}; "
        f"stated 95 % uncertainty at most {max(corrected.uncertainty.values()):.2%}.",
        highlight=False,
    )


def print_subsurface(out: Console, below: SubsurfaceComparison) -> None:
    """Where fatigue begins, in the body under the ball."""
    table = Table(title="Greatest stress under the centre, in the lower body", **PLAIN)
    for head in ("quantity", "Hertz", "FE", "Hertz/FE-1", "+-"):
        table.add_column(head, justify="left" if head == "quantity" else "right", no_wrap=True, min_width=10)
    for name, shown in STRESSES.items():
        discrepancy, uncertain = below.discrepancy(name), below.uncertainty[name]
        is_depth = name.endswith("depth")
        table.add_row(
            shown.heading(),
            f"{below.hertz[name] * shown.factor:.4g}",
            f"{below.fe[name] * shown.factor:.4g}",
            f"{'-' if discrepancy is None else f'{discrepancy:+.2%}'} {'*' if below.exceeds(name) else ' '}",
            f"{uncertain * shown.factor:.2g} {shown.unit}" if is_depth else f"{uncertain / below.fe[name]:.2%}",
        )
    out.print(table)
    out.print()


def print_series(out: Console, series: LoadSeries) -> None:
    """Each load with approach and tangent stiffness, and the law through all of them."""
    table = Table(title=title_of(series.to_json()), **PLAIN)
    for head in ("load, N", "Hertz, um", "FE, um", "Hertz/FE-1", "+-", "tangent FE, N/um", "+-", "Hertz"):
        table.add_column(head, justify="right")
    for point in series.points:
        table.add_row(
            f"{point.load:.4g}",
            f"{point.hertz_approach * 1e6:.5g}",
            f"{point.approach.value * 1e6:.5g}",
            f"{point.discrepancy:+.2%} {'*' if abs(point.discrepancy) > point.approach.total else ' '}",
            f"{point.approach.total:.2%}",
            "-" if point.tangent is None else f"{point.tangent * 1e-6:.4g}",
            "-" if point.tangent_uncertainty is None else f"{point.tangent_uncertainty:.2%}",
            f"{point.hertz_tangent * 1e-6:.4g}",
        )
    out.print(table)
    if series.law is not None:
        law = series.law
        stiffness, exponent = f"{law.stiffness * 1e-9:.5g} GN/m^{law.exponent:.4f}", f"{law.exponent:.4f}"
        if law.stiffness_uncertainty is not None:
            stiffness += f" +- {law.stiffness_uncertainty:.2%}"
        if law.exponent_uncertainty is None:
            exponent += " (power law assumed)"
        else:
            exponent += f" +- {law.exponent_uncertainty:.4f}"
        out.print(
            f"F = K delta^n: K {stiffness}, n {exponent} by finite elements; "
            f"{series.hertz_stiffness * 1e-9:.5g} GN/m^1.5 and 1.5 by Hertz.",
            highlight=False,
        )
    out.print(
        "F: load; delta: approach; tangent: dF/d(delta), from a fit to all loads; +-: numerical uncertainty, 95 %; *: "
        f"the difference exceeds it.\nfinite elements, {series.geometry}, {series.meshes} "
        f"{'mesh' if series.meshes == 1 else 'meshes'} for all loads, {series.seconds:.1f} s\n",
        style="dim",
        highlight=False,
    )
    verdict = series.verdict if series.judged else "shown, not judged"
    out.print(f"{verdict}: tolerance {series.tolerance:g}", highlight=False)


def _print_pocket(out: Console, seat: ContactSolution, sheet: ContactSolution) -> None:
    """K_pb three ways: the half space's formula, a thick seat, and the sheet that is there."""
    shown = QUANTITIES["stiffness"]
    formula, thick, thin = (
        shown.factor * value for value in (seat.hertz.stiffness, seat.reference.stiffness, sheet.reference.stiffness)
    )
    out.print(
        f"Pocket, F = K_pb delta^1.5: K_pb {formula:.4g} {shown.unit} by Hertz, {thick:.4g} in a thick seat, "
        f"{thin:.4g} with the sheet on its rim ({thin / formula - 1:+.0%}).\n",
        highlight=False,
    )


def _print_torque(out: Console, change: TorqueChange, scene: Scene) -> None:
    """What an engineer acts on, at the operating point whose contacts were solved."""
    before, after = change.hertz, change.corrected
    point = int(before.ball_load.argmax())  # where the contacts were solved
    relative = change.relative("total")
    assert relative is not None  # the total is always there
    out.print(
        f"Race torque with Hertz's contacts {before.torque.total[point] * 1e3:.4g} N mm, with those of FE "
        f"{after.torque.total[point] * 1e3:.4g} N mm: {relative[point]:+.2%} +- {change.uncertainty:.2%} (numerical).\n"
        f"Contact angle {before.contact_angle[point]:.4f} rad and {after.contact_angle[point]:.4f} rad. "
        f"Friction: {friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)}.\n",
        highlight=False,
    )
    fitted = change.fitted
    known = fitted.relative[np.isfinite(fitted.relative)]
    if known.size:
        ends = dict.fromkeys(f"{end:+.2%}" for end in (known.max(), known.min()))
        out.print(
            f"With Hertz's contacts corrected for finite geometry {' to '.join(ends)} +- "
            f"{np.nanmax(fitted.uncertainty):.2%} over {known.size} of {fitted.relative.size} operating points.\n",
            highlight=False,
        )
    if change.verdict != "pass":
        out.print(f"The race contacts are not all within the tolerance: {change.verdict}.\n", highlight=False)


def _print_hard(out: Console, outcomes: Sequence[HardOutcome]) -> None:
    """What went wrong in full, the others by their names."""
    table = Table("hard case", "outcome", title="Hard cases", **PLAIN)
    for case in outcomes:
        table.add_row(case.case, case.outcome)
    out.print(table)
    for case in outcomes:
        if case.outcome == "wrong":
            out.print(f"{case.case}: {case.detail}", highlight=False, markup=False)
    count = Counter(case.outcome for case in outcomes)
    out.print(
        f"{len(outcomes)} hard cases: {count['right']} right, {count['refused']} refused as they should be, "
        f"{count['wrong']} wrong\n",
        highlight=False,
    )


def print_cost(out: Console, cost: Cost) -> None:
    """Each ladder with error, bound, time and memory; an arrow where the tolerance would stop."""
    for ladder in cost.ladders:
        title = f"{ladder.quantity[0].upper()}{ladder.quantity[1:]}"
        if ladder.absent is not None:
            out.print(f"{title}: does not apply: {ladder.absent}.\n", highlight=False, markup=False)
            continue
        table = Table(title=title, **PLAIN)
        for head in ("", "rung", "error", "bound", "seconds", "spread", "first", "GiB"):
            table.add_column(head, justify="left" if head in ("", "rung") else "right", no_wrap=True)
        for rung in ladder.methods:
            table.add_row(
                ">" if rung.chosen else "",
                short_name(rung.name),
                "failed" if rung.failed else "reference" if rung.error is None else f"{100 * rung.error:.2g} %",
                "" if rung.bound is None else f"{100 * rung.bound:.2g} %",
                "" if rung.seconds is None else f"{rung.seconds:.2g}",
                "" if rung.spread is None else f"{rung.spread:.1g}",
                "" if rung.warm_up is None else f"{rung.warm_up:.1g}",
                "" if rung.memory is None else f"{rung.memory / 2**30:.2f}",
            )
        out.print(table)
        for rung in ladder.methods:
            if rung.failed:
                out.print(f"{rung.name} failed: {rung.failed}", highlight=False, markup=False)
        out.print(f"Price of the next digit: {choices_line(ladder)}.", highlight=False)
        out.print(f"Reference: {ladder.reference}.\n", style="dim", highlight=False)
    machine = provenance_of(cost.scene)
    versions = ", ".join(f"{name} {version}" for name, version in machine["versions"].items() if version)
    out.print(
        f">: the cheapest rung that is known to be within the tolerance, {cost.tolerance:g}. Bound: on the error, "
        "known before the reference is. Seconds: median of the repeats; first: the call before them; GiB: resident "
        f"memory at most while it ran. {cost.seconds:.0f} s in all.\n"
        f"{machine['processor']}, {machine['cores']} cores, {machine['platform']}, Python {machine['python']}; "
        f"{versions}.",
        highlight=False,
    )
