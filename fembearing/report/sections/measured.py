"""What measured torques beside the computed ones show."""

from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.quantities import METRIC, Units
from fembearing.report.document import Bullets, Drawing, Section, Text
from fembearing.report.figures.measured import caption_of
from fembearing.report.tables.measured import COLUMNS, measured_table


def measured_sections(comparison: MeasuredComparison, units: Units = METRIC, *, figure: str = "") -> list[Section]:
    """Verdict and conclusions, the figure, a row for each measured torque;  figure : data address; empty: none"""
    count = f"{comparison.inside} of {len(comparison.rows)} measured torques inside their 95 % intervals"
    rows = measured_table(comparison, units)._replace(notes=[*comparison.notes, COLUMNS])
    first = [Text(f"Scene: {comparison.scene}. Measured torques: {comparison.file}."), Text(count, comparison.verdict)]
    drawn = [Drawing(figure, caption_of(comparison))] if figure else []
    sections = [Section("", [*first, Bullets(comparison.conclusions), *drawn, rows])]
    if comparison.warnings:
        sections.append(Section("Warnings", [Bullets(comparison.warnings)]))
    return [*sections, Section("", [Text(f"{comparison.samples} samples, seed {comparison.seed}.")])]
