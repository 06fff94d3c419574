"""The verdict on one quantity: does the production value stay within the tolerance of the reference?"""

from collections.abc import Iterable
from typing import Literal

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


def worst(verdicts: Iterable[Verdict]) -> Verdict:
    """The one that a person must act on first."""
    order: tuple[Verdict, ...] = ("fail", "outside validity", "undecided", "pass")
    return min(verdicts, key=order.index)
