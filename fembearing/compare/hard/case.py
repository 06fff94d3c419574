"""One hard case: what is asked, what is right, and the judgement of an answer."""

import math
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

from analytic.errors import ConvergenceError, FembearingError, InputError

Outcome = Literal["right", "refused", "wrong"]


@dataclass(frozen=True, kw_only=True)
class HardCase:
    """One case: a number with its tolerance, or the words of a refusal."""

    name: str
    asked: str
    right: str  # what is right, and why
    evaluate: Callable[[], float]
    expected: float | None = None
    tolerance: tuple[float, str] | None = None  # relative, and its reason
    refusal: str | None = None  # words that the message must hold

    def __post_init__(self) -> None:
        if (self.expected is None) == (self.refusal is None) or (self.expected is None) != (self.tolerance is None):
            raise InputError(f"hard case {self.name!r} needs either a number with its tolerance, or a refusal")
        if self.expected == 0:
            raise InputError(f"hard case {self.name!r} expects 0, of which no relative deviation can be told")


@dataclass(frozen=True, kw_only=True)
class HardOutcome:
    """How a case ended: "refused" is a right answer too, where a refusal was asked for."""

    case: str
    outcome: Outcome
    detail: str

    def to_json(self) -> dict[str, Any]:
        return dict(vars(self))


def outcome_of(case: HardCase) -> HardOutcome:
    """Ask one case and judge the answer."""
    try:
        found = float(case.evaluate())
    except (InputError, ConvergenceError) as refusal:
        met = case.refusal is not None and case.refusal in str(refusal)
        return HardOutcome(case=case.name, outcome="refused" if met else "wrong", detail=f"refused: {refusal}")
    except FembearingError as problem:
        return HardOutcome(case=case.name, outcome="wrong", detail=f"{type(problem).__name__}: {problem}")
    except Exception as problem:  # a bug of the library: the table shows it
        return HardOutcome(case=case.name, outcome="wrong", detail=f"bug, {type(problem).__name__}: {problem}")
    if case.expected is None or case.tolerance is None:
        return HardOutcome(case=case.name, outcome="wrong", detail=f"{found:.6g} instead of a refusal: {case.right}")
    limit, reason = case.tolerance
    off = found / case.expected - 1
    right = math.isfinite(found) and abs(off) <= limit
    detail = f"{found:.10g}, expected {case.expected:.10g}: off by {off:.1e}, allowed {limit:.1e} ({reason})"
    return HardOutcome(case=case.name, outcome="right" if right else "wrong", detail=detail)


@contextmanager
def passing_file(name: str) -> Iterator[Path]:
    """A path for one case's file. A refusal tells it without its folder, which has another name every time."""
    with TemporaryDirectory() as folder:
        try:
            yield Path(folder) / name
        except InputError as refusal:
            raise InputError(str(refusal).replace(f"{folder}{os.sep}", "")) from refusal
