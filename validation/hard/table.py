"""The table of hard cases, where such programs go wrong: each with its problem, and its right answer and why.

An expected number is exact, a limit, or 40-digit arithmetic on the inputs written in the case, never our own output.
Where no number is right, the right answer is an error that says so; any other answer, also infinity, is wrong.
cases.csv has problems and answers; a tolerance is relative, absolute for an expected 0.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Literal

from analytic.errors import ConvergenceError, FembearingError, InputError
from validation.hard.cage import CAGE_CASES
from validation.hard.contacts import CONTACT_CASES
from validation.hard.friction import FRICTION_CASES
from validation.hard.lubrication import LUBRICATION_CASES
from validation.hard.numerical_film import NUMERICAL_FILM_CASES
from validation.hard.numerical_friction import NUMERICAL_FRICTION_CASES
from validation.study import Row, read

Outcome = Literal["right", "refused", "wrong"]
ROUND_OFF = (1e-13, "a few hundred roundings of a double")


@dataclass(frozen=True)
class HardCase:
    """One case: its answer is a number within a tolerance, or an error with given words."""

    name: str
    problem: str
    answer: str  # the right one, and why
    evaluate: Callable[[], float]
    expected: float | None = None
    tolerance: tuple[float, str] = ROUND_OFF  # relative, absolute for an expected 0; and its reason
    refusal: str | None = None  # words that the error's message must contain

    def __post_init__(self) -> None:
        if (self.expected is None) == (self.refusal is None):
            raise InputError(f"hard case {self.name!r} needs either a number or a refusal")


@dataclass(frozen=True, kw_only=True)
class HardOutcome:
    """How a case ended. "refused" is right too, for a case whose answer is a refusal."""

    case: str  # its name
    outcome: Outcome  # how it ended
    detail: str  # numbers, or the message of a refusal


def outcome_of(case: HardCase) -> HardOutcome:
    """Evaluate one case and judge the result."""
    try:
        value = float(case.evaluate())
    except (InputError, ConvergenceError) as refusal:
        expected = case.refusal is not None and case.refusal in str(refusal)
        return HardOutcome(case=case.name, outcome="refused" if expected else "wrong", detail=f"refused: {refusal}")
    except FembearingError as problem:
        return HardOutcome(case=case.name, outcome="wrong", detail=f"{type(problem).__name__}: {problem}")
    except Exception as problem:  # a bug of the library: the table shows it
        return HardOutcome(case=case.name, outcome="wrong", detail=f"bug, {type(problem).__name__}: {problem}")
    if case.expected is None:
        return HardOutcome(case=case.name, outcome="wrong", detail=f"{value:.6g} instead of a refusal: {case.answer}")
    limit, reason = case.tolerance
    off = value / case.expected - 1 if case.expected else value
    right = math.isfinite(value) and abs(off) <= limit
    detail = f"{value:.10g}, expected {case.expected:.10g}: off by {off:.1e}, allowed {limit:.1e} ({reason})"
    return HardOutcome(case=case.name, outcome="right" if right else "wrong", detail=detail)


EVALUATIONS = (
    CONTACT_CASES | FRICTION_CASES | NUMERICAL_FRICTION_CASES | LUBRICATION_CASES | NUMERICAL_FILM_CASES | CAGE_CASES
)


def _case(row: Row) -> HardCase:
    return HardCase(
        name=row["name"],
        problem=row["problem"],
        answer=row["answer"],
        evaluate=EVALUATIONS[row["name"]],
        expected=float(Fraction(row["expected"])) if row["expected"] else None,
        tolerance=(float(row["tolerance"]), row["why"]) if row["tolerance"] else ROUND_OFF,
        refusal=row["refusal"] or None,
    )


HARD_CASES = tuple(map(_case, read(Path(__file__).with_name("cases.csv"))))
