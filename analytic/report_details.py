"""What the report of a scene says beside its numbers: who signs it, and in which units.

Nothing here changes a number.
"""

from dataclasses import dataclass

from analytic.noun import Noun
from analytic.units import UnitSystem


@dataclass(frozen=True, kw_only=True)
class ReportDetails(Noun):
    """Names and dates are texts as the scene gives them; None: a blank to fill in by hand."""

    author: str | None = None  # who made it
    checker: str | None = None  # who checked it
    revision: str | None = None  # of the report
    date: str | None = None  # of the revision, not of the computation
    units: UnitSystem = "metric"  # that pages and tables show
