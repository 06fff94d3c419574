"""Every hard case: right, refused or wrong. python -m validation.hard.run [--write]

The table has problems on which such programs go wrong, each with its right answer and why, in cases.csv; a tolerance is
relative, absolute for an expected 0. An expected number is exact, a limit, or 40-digit arithmetic on the inputs written
in the case, never our own output. Where no number is right, the right answer is an error that says so; any other
answer, also infinity, is wrong.
"""

import json
import math
import sys
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from fractions import Fraction
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Literal

import typer
from rich.progress import track

from analytic.errors import ConvergenceError, FembearingError, InputError
from analytic.torque import MODEL_VERSION
from fembearing.check.hard_record import RECORD
from fembearing.plain_types import plain
from validation.hard.cage import CAGE_CASES
from validation.hard.contacts import CONTACT_CASES
from validation.hard.friction import FRICTION_CASES
from validation.hard.lubrication import LUBRICATION_CASES
from validation.hard.numerical_film import NUMERICAL_FILM_CASES
from validation.hard.numerical_friction import NUMERICAL_FRICTION_CASES
from validation.study import Row, out, progress, read, run

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


def main(
    write: Annotated[bool, typer.Option("--write", help=f"Store {RECORD.name}, which reports cite.")] = False,
) -> None:
    """Print every case, and the counts; the status is 1 where one is wrong."""
    outcomes = [outcome_of(case) for case in track(HARD_CASES, "hard cases", console=progress)]
    for each in outcomes:
        words = f"{each.outcome:8}{each.case}" + (f": {each.detail}" if each.outcome == "wrong" else "")
        out.print(words, soft_wrap=True)
    count = Counter(each.outcome for each in outcomes)
    out.print(
        f"{len(outcomes)} hard cases: {count['right']} right, {count['refused']} refused as they should be, "
        f"{count['wrong']} wrong"
    )
    if write:
        record = {
            "date": f"{datetime.now(UTC):%Y-%m-%d}",
            "fembearing": version("fembearing"),
            "model_version": MODEL_VERSION,
            "outcomes": plain(outcomes),
        }
        RECORD.write_text(json.dumps(record, indent=1) + "\n", "utf-8")
    sys.exit(int(count["wrong"] > 0))


if __name__ == "__main__":
    run(main)
