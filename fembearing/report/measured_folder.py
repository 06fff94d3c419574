"""What a comparison with measured torques is written to: a page, numbers, a table of the rows and the figure."""

from pathlib import Path

from analytic.scene import Scene
from analytic.writing import write
from fembearing.check.measured.comparison import ROW, MeasuredComparison
from fembearing.csv_text import csv_of_columns
from fembearing.plain_types import json_of
from fembearing.provenance import provenance_of
from fembearing.quantities import SYSTEMS, unit_for


def write_comparison(comparison: MeasuredComparison, scene: Scene, folder: Path) -> None:
    """Write compare.html, compare.json, compare.csv, compare.png and compare.svg into a folder."""
    from fembearing.report.figures.measured import measured_figure
    from fembearing.report.figures.page_plots import embedded
    from fembearing.report.figures.style import png, svg
    from fembearing.report.page.document import page_of_sections
    from fembearing.report.sections.measured import measured_sections

    figure = measured_figure(comparison, SYSTEMS[scene.report.units])
    picture, origin = (
        png(figure),
        provenance_of(scene, seeds={"samples beside the measured torques": [comparison.seed]}),
    )
    write(folder / "compare.json", json_of("compare", comparison, run=origin))
    write(folder / "compare.csv", csv_of(comparison))
    write(folder / "compare.png", picture)
    write(folder / "compare.svg", svg(figure))
    sections = measured_sections(comparison, SYSTEMS[scene.report.units], figure=embedded(picture))
    write(folder / "compare.html", page_of_sections("Measured and computed torque", sections, origin))


def csv_of(comparison: MeasuredComparison) -> str:
    """A line for each row, with its verdict."""
    columns = {name: (unit_for(column.unit, 0.0), values) for name, (_, values, column) in comparison.columns().items()}
    return csv_of_columns(
        columns,
        first={ROW: range(1, len(comparison.rows) + 1)},
        last={"verdict": [row.verdict for row in comparison.rows]},
    )
