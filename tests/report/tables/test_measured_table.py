"""The table of measured torques, by its cells."""

from io import StringIO

import numpy as np
import pytest
from rich.console import Console

from fembearing.check.measured.rows import MeasuredRow
from fembearing.quantities import INCH_POUND
from fembearing.report.tables.measured import measured_table
from fembearing.report.terminal.table import show
from tests.report.measured_rows import FASTER, comparison, row


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
