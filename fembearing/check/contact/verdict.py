"""The verdict on one quantity: is the production value within the tolerance of the reference?"""

from collections.abc import Iterable
from dataclasses import replace

from analytic.verdicts import Verdict
from fembearing.grid_convergence import Estimate

AGREE = 0.1  # meshes that do not converge still agree if they differ by less than this share of the tolerance


def judge(
    *, discrepancy: float, uncertainty: float, tolerance: float, settled: bool, spread: float, valid: bool = True
) -> Verdict:
    """All arguments relative.

    settled : the meshes converge
    spread : largest difference between the meshes
    valid : the contact is within the validity of the production formula
    """
    if not valid:
        return "outside validity"
    if not settled and spread > AGREE * tolerance:
        return "undecided"
    if abs(discrepancy) + uncertainty <= tolerance:
        return "pass"
    if abs(discrepancy) - uncertainty > tolerance:
        return "fail"
    return "undecided"


def verdict_on(formula: float, part: Estimate, *, tolerance: float, valid: bool) -> Verdict:
    """The verdict on a production value, against the estimate from the meshes.

    formula : production value, in the unit of `part`
    tolerance, valid : as in `judge`
    """
    return judge(
        discrepancy=formula / part.value - 1,
        uncertainty=part.total,
        tolerance=tolerance,
        settled=part.settled,
        spread=part.spread,
        valid=valid,
    )


def could_be_decided(formula: float, part: Estimate, *, tolerance: float) -> bool:
    """Whether a quantity is undecided and a finer mesh could decide it. The far boundary's part would stay."""
    perfect = replace(part, mesh=0.0, settled=True)
    now, then = (verdict_on(formula, each, tolerance=tolerance, valid=True) for each in (part, perfect))
    return now == "undecided" != then


def worst(verdicts: Iterable[Verdict]) -> Verdict:
    """The most serious verdict."""
    order: tuple[Verdict, ...] = ("fail", "outside validity", "undecided", "pass")
    return min(verdicts, key=order.index)
