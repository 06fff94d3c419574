"""Measured torques beside the computed ones."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from analytic.scenefile.measured import OPERATING
from analytic.units import METRIC, Units, speed_words
from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.check.measured.rows import MeasuredRow
from fembearing.report.document import Bullets, Drawing, Head, Row, Section, Table, Text, table_of
from fembearing.report.phrases import between, digits
from fembearing.report.sections.points import fixed_loads, point_cells, point_heads

if TYPE_CHECKING:
    from fembearing.report.report import Report

MOST_VARYING = 2  # operating columns beside which a terminal has room for the uncertainty of the measured torque
COLUMNS = (
    "95 %: interval of the measured torque from the uncertainties of solver, inputs, formulas and measurement; too "
    "low, too high: the model. E: computed less measured, over measured. u: u_val over measured, u_val^2 = u_num^2 + "
    "u_input^2 + u_D^2 [ASME2009]; u and +- are standard uncertainties."
)


def measured_table(comparison: MeasuredComparison, units: Units = METRIC) -> Table:
    """A row for each measured torque, and below it what the rows show."""
    rows, torque = comparison.rows, units.torque
    points = [vars(row) for row in rows]
    varying = [name for name in OPERATING if len({getattr(row, name) for row in rows}) > 1]
    heated = "temperature" in varying
    heads = point_heads(points, units)
    heads += [Head(f"oil, {units.temperature.name}", short=units.temperature.name)] if heated else []
    heads += [Head("measured", short="meas."), Head("+-", wide=len(varying) > MOST_VARYING)]
    heads += [Head("computed", short="comp."), Head("95 %", fixed=True)]
    heads += [Head("E, %"), Head("u_num, %", wide=True), Head("u_input, %", wide=True), Head("u_D, %", wide=True)]
    heads += [Head("u_val, %", short="u, %"), Head("formulas, %", wide=True), Head("beyond, %", wide=True)]
    heads += [Head("verdict", "verdict")]

    def cells(place: int, row: MeasuredRow) -> Row:
        oil = [] if row.temperature is None or not heated else [f"{units.temperature.number(row.temperature):.4g}"]
        return [
            *point_cells(points, place, units),
            *oil,
            digits(row.measured, torque.factor, 4),
            "-" if row.measurement is None else f"{torque.number(row.measurement):.2g}",
            digits(row.computed, torque.factor, 4),
            between((row.low, row.high), torque),
            f"{100 * row.relative:+.1f}",
            *(_percent(part, row) for part in (row.numerical, row.input, row.measurement, row.validation)),
            _percent(row.formulas, row),
            _percent(row.beyond, row) if row.beyond else "-",
            row.verdict.removeprefix("model "),
        ]

    fixed = fixed_loads(points, units)
    if "inner_speed" not in varying:
        fixed.append(f"inner speed {speed_words(rows[0].inner_speed, units)}")
    if rows[0].temperature is not None and not heated:
        fixed.append(f"oil at {units.temperature.written(rows[0].temperature, '.4g')}")
    words = [f"Measured and computed torque, {torque.name}", *fixed]
    listed = [cells(place, row) for place, row in enumerate(rows)]
    return table_of(", ".join(words), heads, listed, [*comparison.notes, COLUMNS])


def _percent(part: float | None, row: MeasuredRow) -> str:
    """A part of the uncertainty over the measured torque."""
    return "-" if part is None else f"{100 * part / row.measured:.2g}"


def measured_sections(
    comparison: MeasuredComparison, units: Units = METRIC, drawn: Sequence[Drawing] = ()
) -> list[Section]:
    """Verdict and conclusions, the figure, a row for each measured torque;  drawn : the figure"""
    count = f"{comparison.inside} of {len(comparison.rows)} measured torques inside their 95 % intervals"
    first = [Text(f"Scene: {comparison.scene}. Measured torques: {comparison.file}."), Text(count, comparison.verdict)]
    samples = Text(f"{comparison.samples} samples, seed {comparison.seed}.")
    table = measured_table(comparison, units)
    return [Section("", [*first, Bullets(comparison.conclusions), *drawn, table, samples])]


def measured_section(document: "Report") -> Section:
    """The measured torques of a check; without blocks: there are none."""
    if document.measured is None:
        return Section("Measured torques", [])
    words = (
        "This appendix compares the computed with the measured torques, row by row. It is not part of the overall "
        "verdict."
    )
    table, conclusions = measured_table(document.measured, document.units), Bullets(document.measured.conclusions)
    return Section("Measured torques", [Text(words, wide=True), conclusions, table])
