"""Measured torques in a report: its section, its figure, its table, and report.json read again."""

from dataclasses import replace
from io import StringIO
from pathlib import Path

import pytest
from rich.console import Console

from fembearing.report.figures.page_plots import PLOTS
from fembearing.report.page import write as page_module
from fembearing.report.page.write import page_of
from fembearing.report.report import Report
from fembearing.report.terminal.validation import print_details
from tests.report.measured_rows import TWO


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


def test_the_terminal_prints_the_table(with_measured: Report) -> None:
    out = Console(width=80, record=True, file=StringIO())
    print_details(out, with_measured)
    assert "Missed: one of them." in out.export_text()
