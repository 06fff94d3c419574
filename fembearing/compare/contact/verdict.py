"""The verdict on one quantity: does the production value stay within the tolerance of the reference?"""

from collections.abc import Iterable
from dataclasses import replace
from typing import Literal

from fembearing.compare.contact.uncertainty import Estimate

Verdict = Literal["pass", "fail", "undecided", "outside validity"]
AGREE = 0.1  # meshes that do not settle still agree when they differ by less than this share of the tolerance


def judge(
    *, discrepancy: float, uncertainty: float, tolerance: float, settled: bool, spread: float, valid: bool = True
) -> Verdict:
    """All arguments relative.

    settled : the meshes close in on a value
    spread : largest difference between the meshes
    valid : the contact is one that the production formula is made for
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
    """Of a production value beside what the meshes say.

    formula : in the unit of `part`
    tolerance, valid : as of `judge`
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
    """Whether a quantity is undecided and a finer mesh could decide it: the far boundary's share it would not lower."""
    perfect = replace(part, mesh=0.0, settled=True)
    now, then = (verdict_on(formula, each, tolerance=tolerance, valid=True) for each in (part, perfect))
    return now == "undecided" != then


def worst(verdicts: Iterable[Verdict]) -> Verdict:
    """The one that a person must act on first."""
    order: tuple[Verdict, ...] = ("fail", "outside validity", "undecided", "pass")
    return min(verdicts, key=order.index)
