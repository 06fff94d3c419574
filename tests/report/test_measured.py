"""Measured torques in a report: its section, its figure, its table, and report.json read again."""

from dataclasses import replace
from io import StringIO

import pytest
from rich.console import Console

from fembearing.report.figures.page_plots import PLOTS, plots_of
from fembearing.report.folder import report_page
from fembearing.report.report import Report
from fembearing.report.sections.validation import detail_sections
from fembearing.report.terminal import print_sections
from tests.report.specimens import TWO


@pytest.fixture
def with_measured(document: Report) -> Report:
    return replace(document, measured=TWO)


def test_the_section_stands_in_the_page_and_the_summary_says_what_is_missed(
    with_measured: Report, document: Report
) -> None:
    plots = [plot for plot in PLOTS if plot.section == "measured"]
    page = report_page(with_measured, plots_of(with_measured, plots))
    assert "Measured torques</h2>" in page
    assert "Missed: one of them." in page.partition("Appendix A")[0]
    assert page.count('alt="Measured and computed torque"') == 1
    assert "too high" in page
    assert "Measured torques</h2>" not in report_page(document)


def test_the_terminal_prints_the_table(with_measured: Report) -> None:
    out = Console(width=80, record=True, file=StringIO())
    print_sections(out, detail_sections(with_measured))
    assert "Missed: one of them." in out.export_text()
