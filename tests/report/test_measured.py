"""Measured torques in a report: its section, its figure, its table, and report.json read again."""

import json
from dataclasses import replace
from io import StringIO
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from rich.console import Console

from fembearing.plain_types import plain
from fembearing.quantities import INCH_POUND, METRIC
from fembearing.report.figures.measured import axis_of, measured_figure, measured_plot
from fembearing.report.figures.page_plots import PLOTS
from fembearing.report.page import write as page_module
from fembearing.report.page.write import page_of
from fembearing.report.report import Report, report_in
from fembearing.report.tables.measured import measured_table
from fembearing.report.terminal.table import show
from fembearing.report.terminal.validation import print_details
from fembearing.verify.measured.comparison import MeasuredComparison
from fembearing.verify.measured.rows import MeasuredRow
from tests.report.figures.figure_reader import require_legible


def row(**changed: Any) -> MeasuredRow:
    given: dict[str, Any] = {
        "inner_speed": 20 * np.pi,  # 600 rpm
        "axial_load": 700.0,
        "radial_load": 0.0,
        "moment": 0.0,
        "temperature": 333.15,
        "measured": 0.04,
        "computed": 0.05,
        "error": 0.01,
        "numerical": 0.0004,
        "input": 0.003,
        "measurement": 0.002,
        "validation": 0.0036,
        "formulas": 0.005,
        "computed_low": 0.041,
        "computed_high": 0.062,
        "low": 0.0405,
        "high": 0.063,
        "beyond": 0.0005,
        "verdict": "model too high",
    }
    return MeasuredRow(**given | changed)


def comparison(*rows: MeasuredRow) -> MeasuredComparison:
    return MeasuredComparison(
        scene="a scene",
        file="data.csv",
        rows=rows,
        inside=sum(each.verdict == "inside" for each in rows),
        mean_error=0.21,
        scatter=0.03,
        shares={"lubricant.viscosity": 0.61},
        samples=640,
        seed=7,
        seconds=2.5,
        conclusions=("Missed: one of them.",),
        notes=("From the scene: all else.",),
        warnings=(),
    )


FASTER = row(inner_speed=30 * np.pi, verdict="inside", beyond=0.0)
TWO = comparison(row(), FASTER)


@pytest.fixture
def with_measured(document: Report) -> Report:
    return replace(document, measured=TWO)


def test_the_section_stands_in_the_page_and_the_summary_says_what_is_missed(
    with_measured: Report, document: Report, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(page_module, "PLOTS", [plot for plot in PLOTS if plot.section == "measured"])
    page = page_of(with_measured, tmp_path)
    assert "Measured torques</h2>" in page
    assert "Missed: one of them." in page.partition("Appendix A")[0]
    assert page.count('alt="Measured and computed torque"') == 1
    assert "too high" in page
    assert "Measured torques</h2>" not in page_of(document, tmp_path)


def test_report_json_is_read_again(with_measured: Report) -> None:
    again = report_in(json.loads(json.dumps(plain(with_measured))))
    assert again.measured == TWO


def test_the_terminal_prints_the_table(with_measured: Report) -> None:
    out = Console(width=80, record=True, file=StringIO())
    print_details(out, with_measured)
    assert "Missed: one of them." in out.export_text()


@pytest.mark.parametrize(
    ("rows", "heads"),
    [
        ((row(), FASTER), ["#", "rpm", "meas.", "+-", "comp.", "95 %", "E, %", "u, %", "verdict"]),
        (
            (row(), row(inner_speed=30 * np.pi, axial_load=900.0, temperature=343.15)),
            ["#", "rpm", "Fa, N", "degC", "meas.", "comp.", "95 %", "E, %", "u, %", "verdict"],
        ),
    ],
)
def test_a_terminal_has_what_varies(rows: tuple[MeasuredRow, ...], heads: list[str]) -> None:
    table = measured_table(comparison(*rows))
    assert [head.short or head.text for head in table.heads if not head.wide] == heads
    assert all(len(cells) == len(table.heads) for cells in table.groups[0].rows)
    out = Console(width=80, record=True, file=StringIO())
    show(out, table)
    assert "\N{HORIZONTAL ELLIPSIS}" not in out.export_text()  # nothing is cut off


def test_the_cells_are_the_numbers_of_the_row() -> None:
    table = measured_table(comparison(row(), FASTER))
    cells = dict(zip([head.text for head in table.heads], table.groups[0].rows[0], strict=True))
    expected = {
        "speed, rpm": "600",
        "axial load, N": "700",
        "measured": "40.00",
        "+-": "2",
        "computed": "50.00",
        "95 %": "40.5-63",
        "E, %": "+25.0",
        "u_num, %": "1",
        "u_input, %": "7.5",
        "u_D, %": "5",
        "u_val, %": "9",
        "formulas, %": "12",
        "beyond, %": "1.2",
        "verdict": "too high",
    }
    assert {name: cells[name] for name in expected} == expected
    assert "axial load 700 N, oil at 60 degC" in table.label
    assert table.notes[:2] == ["Missed: one of them.", "From the scene: all else."]
    inch = measured_table(comparison(row()), INCH_POUND)
    assert "157.4 lbf" in inch.label or "157.37 lbf" in inch.label
    assert "oil at 140 degF" in inch.label


@pytest.mark.parametrize(
    ("changes", "label", "values", "curves"),
    [
        ([{}, {}], "row", [1, 2], ["computed"]),
        ([{}, {"inner_speed": 15 * np.pi}], "inner speed, rpm", [600, 450], ["computed"]),
        ([{}, {"axial_load": 300.0}], "axial load, N", [700, 300], ["computed"]),
        ([{}, {"temperature": 323.15}], "temperature of the oil, degC", [60, 50], ["computed"]),
        (
            [{}, {"inner_speed": 15 * np.pi}, {"axial_load": 300.0}],
            "inner speed, rpm",
            [600, 450, 600],
            ["computed, 700 N", "computed, 300 N"],
        ),
    ],
)
def test_the_figure_is_over_the_first_quantity_that_varies(
    changes: list[dict[str, float]], label: str, values: list[float], curves: list[str]
) -> None:
    axis = axis_of([row(**each) for each in changes], METRIC)
    assert axis.label == label
    np.testing.assert_allclose(axis.values, values, rtol=1e-12)  # of a unit
    assert [*axis.curves] == curves
    for places in axis.curves.values():
        assert list(axis.values[places]) == sorted(axis.values[places])


def drawn(panel: Axes) -> dict[str, tuple[list[float], list[float]]]:
    """Places of the points of a panel, by their mark."""
    lines = [(str(line.get_marker()), np.asarray(line.get_xydata())) for line in panel.lines]
    return {mark: (xy[:, 0].tolist(), xy[:, 1].tolist()) for mark, xy in lines if mark in ("o", "D") and xy.size}


def test_points_bars_and_bands_are_where_the_rows_are(with_measured: Report) -> None:
    figure, caption = measured_plot(with_measured)
    assert figure is not None
    assert "1 of 2 points miss" in caption
    above, below = figure.axes
    band = above.collections[0].get_paths()[0].vertices
    assert {round(float(y), 9) for y in np.asarray(band)[:, 1]} == {41.0, 62.0}  # N mm, of the computed torque alone
    assert drawn(above) == {"o": ([pytest.approx(900)], [40.0]), "D": ([pytest.approx(600)], [40.0])}
    assert drawn(below) == {mark: (speeds, [pytest.approx(25.0)]) for mark, (speeds, _) in drawn(above).items()}
    for panel, middle, half in ((above, 40, 1.96 * 2), (below, 25, 1.96 * 9)):
        drawn_bars = [each.get_segments() for each in panel.collections if isinstance(each, LineCollection)]
        ends = [np.sort(np.asarray(segment)[:, 1]) for segments in drawn_bars for segment in segments if len(segment)]
        np.testing.assert_allclose(ends, 2 * [(middle - half, middle + half)], rtol=1e-3)  # 1.96 has three digits
    assert measured_plot(replace(with_measured, measured=None)) == (None, "")
    require_legible(figure)


def test_more_curves_than_colours_are_drawn_as_points() -> None:
    rows = [row(axial_load=100.0 * number, inner_speed=speed) for number in range(2, 9) for speed in (30.0, 60.0)]
    figure = measured_figure(comparison(*rows))
    words = [text.get_text() for text in figure.legends[0].get_texts()]
    assert words == ["computed, 95 %", "measured, missed"]
