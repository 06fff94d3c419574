"""The table of measured torques, by its cells."""

from io import StringIO

import numpy as np
from rich.console import Console

from fembearing.report.document import Section
from fembearing.report.sections.measured import measured_table
from fembearing.report.terminal import print_sections
from tests.report.specimens import comparison, row


def test_a_terminal_has_what_varies() -> None:
    """The oil's temperature too; all rows at one load are in the golden texts."""
    rows = row(), row(inner_speed=30 * np.pi, axial_load=900.0, temperature=343.15)
    table = measured_table(comparison(*rows))
    heads = ["#", "rpm", "Fa, N", "degC", "meas.", "comp.", "95 %", "E, %", "u, %", "verdict"]
    assert [head.short or head.text for head in table.heads if not head.wide] == heads
    assert all(len(cells) == len(table.heads) for cells in table.groups[0].rows)
    out = Console(width=80, record=True, file=StringIO())
    print_sections(out, [Section("", [table])])
    assert "\N{HORIZONTAL ELLIPSIS}" not in out.export_text()  # nothing is cut off
