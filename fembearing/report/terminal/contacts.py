"""Contacts as tables and lines of text for a terminal or a pipe of 80 characters."""

from collections.abc import Mapping

from rich.console import Console

from analytic.words import percent_of
from fembearing.quantities import CONTACT, MICRO, STIFFNESS, STRESSES, TANGENT
from fembearing.report.contact import ContactRecord
from fembearing.report.phrases import AXES, contact_title, quantities_of, ring_line, shoulder_lines, title_of
from fembearing.report.phrases import shown as shown_as
from fembearing.report.terminal.table import table_of
from fembearing.verify.contact.load_series import LoadSeries
from fembearing.verify.contact.pocket_law import PocketLaw
from fembearing.verify.contact.subsurface import SubsurfaceComparison

COLUMNS = {"quantity": 19, "Hertz": 9, "FE": 9, "Hertz/FE-1": 10, "+-": 6, "order": 5, "verdict": 9}  # characters


def print_contact(out: Console, contact: ContactRecord, verdicts: Mapping[str, str]) -> None:
    """Print one contact: its quantities by Hertz and by finite elements, with their verdicts if it is judged."""
    table = table_of(COLUMNS, title=contact_title(contact), left=("quantity", "verdict"), fixed=COLUMNS)
    for column, width in zip(table.columns, COLUMNS.values(), strict=True):
        column.min_width = width
    for name, quantity in quantities_of(contact).items():
        discrepancy, uncertainty, factor = contact.discrepancy[name], contact.uncertainty[name], quantity.shown.factor
        study = contact.convergence[name]
        table.add_row(
            quantity.heading,
            f"{contact.hertz[name] * factor:.5g}",
            f"{contact.fe[name] * factor:.5g}",
            f"{discrepancy:+.2%} {'*' if abs(discrepancy) > uncertainty else ' '}",
            f"{uncertainty:.2%}",
            "twin" if study.corrected else "none" if study.order is None else f"{study.order:.1f}",
            verdicts[name].removesuffix(" validity") if contact.judged else "shown",
        )
    out.print(table)
    _print_corrected(out, contact)
    for line in shoulder_lines(contact):
        out.print(line)
    is_twin = contact.refinement == "twin"
    order = "twin: corrected by half spaces on the same cells" if is_twin else "order: observed on the meshes"
    out.print(
        f"{AXES}. FE: finite elements; +-: their numerical uncertainty, "
        f"95 %; *: the difference exceeds it; {order}.\n"
        f"{contact.method}, {contact.cost.seconds:.1f} s\n",
        style="dim",
    )
    if contact.ring is not None:
        out.print(f"{ring_line(contact.ring)}\n")


def _print_corrected(out: Console, contact: ContactRecord) -> None:
    """Hertz corrected for finite geometry; the verdicts above are on Hertz as it is."""
    corrected = contact.corrected
    if corrected is None:
        return
    values = []
    for name, quantity in CONTACT.items():
        value = corrected.values[name] * quantity.shown.factor
        error = corrected.interpolation_error[name]
        values.append(f"{quantity.name} {value:.5g} {quantity.shown.name} ({error:+.2%})")
    out.print(
        f"Hertz corrected for finite geometry (its interpolation error, over FE - 1): {', '.join(values)}; "
        f"stated 95 % uncertainty at most {max(corrected.uncertainty.values):.2%}."
    )


def print_subsurface(out: Console, below: SubsurfaceComparison) -> None:
    """Where fatigue begins, in the body under the ball."""
    title, heads = (
        "Greatest stress under the centre, in the lower body",
        ("quantity", "Hertz", "FE", "Hertz/FE-1", "+-"),
    )
    table = table_of(heads, title=title, left=("quantity",), fixed=heads)
    for column in table.columns:
        column.min_width = 10
    for name, quantity in STRESSES.items():
        shown = quantity.shown
        discrepancy, uncertain = below.discrepancy[name], below.uncertainty[name]
        is_depth = name.endswith("depth")
        table.add_row(
            quantity.heading,
            f"{below.hertz[name] * shown.factor:.4g}",
            f"{below.fe[name] * shown.factor:.4g}",
            f"{shown_as(discrepancy, '+.2%')} {'*' if below.exceeds_uncertainty[name] else ' '}",
            f"{uncertain * shown.factor:.2g} {shown.name}" if is_depth else f"{uncertain / below.fe[name]:.2%}",
        )
    out.print(table)
    out.print()


def print_series(out: Console, series: LoadSeries) -> None:
    """Each load with approach and tangent stiffness, and the law through all of them."""
    place = series.contact.pair, series.geometry, series.contact.contact_angle
    um, tangent = MICRO.name, TANGENT.name
    heads = ("load, N", f"Hertz, {um}", f"FE, {um}", "Hertz/FE-1", "+-", f"tangent FE, {tangent}", "+-", "Hertz")
    table = table_of(heads, title=title_of(*place, f"{len(series.points)} loads"))
    for point in series.points:
        table.add_row(
            f"{point.load:.4g}",
            f"{point.hertz_approach * MICRO.factor:.5g}",
            f"{point.approach.value * MICRO.factor:.5g}",
            f"{point.discrepancy:+.2%} {'*' if abs(point.discrepancy) > point.approach.total else ' '}",
            f"{point.approach.total:.2%}",
            "-" if point.tangent is None else f"{point.tangent * TANGENT.factor:.4g}",
            "-" if point.tangent_uncertainty is None else f"{point.tangent_uncertainty:.2%}",
            f"{point.hertz_tangent * TANGENT.factor:.4g}",
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
            f"{STIFFNESS.written(series.hertz_stiffness, '.5g')} and 1.5 by Hertz."
        )
    if series.pocket_law is not None:
        out.print(_sheet_law(series.pocket_law, largest=max(point.load for point in series.points)))
    out.print(
        "F: load; delta: approach; tangent: dF/d(delta), from a fit to all loads; +-: numerical uncertainty, 95 %; *: "
        f"the difference exceeds it.\nfinite elements, {series.geometry}, {series.meshes} "
        f"{'mesh' if series.meshes == 1 else 'meshes'} for all loads, {series.seconds:.1f} s\n",
        style="dim",
    )
    verdict = series.verdict if series.judged else "shown, not judged"
    out.print(f"{verdict}: tolerance {percent_of(series.tolerance)}")


def _sheet_law(law: PocketLaw, *, largest: float) -> str:
    """The law of the sheet of a pocket, and the keys of a scene that take it; largest : load of the series, N."""
    local, sheet = STIFFNESS.written(law.stiffness, ".5g"), f"{law.sheet * TANGENT.factor:.5g} {TANGENT.name}"
    if law.stiffness_uncertainty is not None:
        local += f" +- {law.stiffness_uncertainty:.2%}"
    if law.sheet_uncertainty is not None:
        sheet += f" +- {law.sheet_uncertainty:.2%}"
    contact = f"{(largest / law.stiffness) ** (2 / 3) * MICRO.factor:.4g} {MICRO.name}"
    return (
        f"delta = (F/K)^(2/3) + F/k, contact and sheet in series: K {local}, k {sheet}. In a scene:\n"
        f'cage.pocket_approach = {{ load = "{largest:.4g} N", approach = "{contact}" }}\n'
        f'cage.sheet_stiffness = "{law.sheet * TANGENT.factor:.4g} {TANGENT.name}"'
    )
