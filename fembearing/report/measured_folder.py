"""What a comparison with measured torques is written to: a page, numbers, a table of the rows and the figure."""

import csv
import json
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from typing import Literal

import numpy as np

from analytic.scene import Scene
from analytic.writing import write
from fembearing.check.measured.comparison import ROW, MeasuredComparison
from fembearing.plain_types import plain
from fembearing.provenance import provenance_of
from fembearing.quantities import SYSTEMS, unit_for

KIND, FORMAT = "fembearing compare", 1  # what the JSON is; the number rises when a key changes its name or meaning


@dataclass(frozen=True, kw_only=True)
class ComparisonFile(MeasuredComparison):
    """What `compare --json` prints."""

    kind: Literal["fembearing compare"] = KIND
    format: Literal[1] = FORMAT


def write_comparison(comparison: MeasuredComparison, scene: Scene, folder: Path) -> None:
    """Write compare.html, compare.json, compare.csv, compare.png and compare.svg into a folder."""
    from fembearing.report.figures.measured import measured_figure
    from fembearing.report.figures.style import png, svg
    from fembearing.report.page.measured_alone import comparison_page

    figure = measured_figure(comparison, SYSTEMS[scene.report.units])
    picture, origin = (
        png(figure),
        provenance_of(scene, seeds={"samples beside the measured torques": [comparison.seed]}),
    )
    content = plain(ComparisonFile(**vars(comparison))) | {"run": plain(origin)}
    write(folder / "compare.json", json.dumps(content, indent=1, allow_nan=False))
    write(folder / "compare.csv", csv_of(comparison))
    write(folder / "compare.png", picture)
    write(folder / "compare.svg", svg(figure))
    write(folder / "compare.html", comparison_page(comparison, scene, picture))


def csv_of(comparison: MeasuredComparison) -> str:
    """A line for each row, to 15 digits; heads have the unit in brackets. A cell is empty where nothing is known."""
    columns = comparison.columns()
    units = {name: unit_for(each.column.unit, 0.0) for name, each in columns.items()}
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([ROW, *(f"{name} [{units[name].name}]" for name in columns), "verdict"])
    values = [units[name].number(np.asarray(each.values)).tolist() for name, each in columns.items()]
    for number, (row, *cells) in enumerate(zip(comparison.rows, *values, strict=True), start=1):
        writer.writerow([number, *("" if np.isnan(cell) else f"{cell:.15g}" for cell in cells), row.verdict])
    return text.getvalue()
