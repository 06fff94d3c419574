"""The physical limits."""

from collections.abc import Sequence

from analytic.verdicts import PhysicalCheck
from fembearing.quantities import METRIC, Units
from fembearing.report.phrases import CHECKS, capital, limit_of, worst_of
from fembearing.report.tables.table import Head, Table, table_of

HEADS = (
    Head("check", "name"),
    Head("where", "name"),
    Head("#"),
    Head("worst"),
    Head("limit"),
    Head("verdict", "verdict"),
)
POINT = "#: the worst operating point. Parts that are missing in the scene are not checked."


def physical_table(checks: Sequence[PhysicalCheck], units: Units = METRIC) -> Table:
    """Each number with its limit, at the operating point where it is worst."""
    rows = [
        [
            CHECKS[check.name],
            check.where,
            str(check.point + 1),
            worst_of(check, units),
            limit_of(check.limit, check.unit, units),
            check.verdict,
        ]
        for check in checks
    ]
    return table_of("Physical limits", HEADS, rows, [*failures(checks), POINT])


def failures(checks: Sequence[PhysicalCheck]) -> list[str]:
    """Why limits do not hold, or are not known to hold, in sentences."""
    open_ = [check for check in checks if check.verdict != "pass"]
    return list(dict.fromkeys(f"{capital(CHECKS[check.name])}: {check.note}" for check in open_))
