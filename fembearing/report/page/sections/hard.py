"""The outcomes of the hard cases."""

from fembearing.report.document.report import Report
from fembearing.report.page.sections.grid import Grid, Head, grid_of


def hard_grid(document: Report) -> Grid:
    """A row for each case."""
    heads = [Head("case", "text"), Head("outcome", "verdict"), Head("detail", "text")]
    return grid_of("hard cases", heads, [[case.case, case.outcome, case.detail] for case in document.hard])
