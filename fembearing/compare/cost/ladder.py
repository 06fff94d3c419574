"""What each digit costs: for a quantity, the ways to compute it from cheap to exact, with error, bound and seconds.

An error is relative to the ladder's reference rung, which has none of its own to show. A bound is what is known of it
without that reference, and so what a rung is chosen by. Seconds are wall time on this machine, memory is resident.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from analytic.errors import FembearingError
from analytic.scene import Array
from fembearing.memory import peak_while

FORMULA_REPEATS = 15  # the median of 15 leaves out what other programs do to a short timing
FEWEST_REPEATS, LONGEST = 3, 1.0  # of a formula that is slow; s, that all repeats should take together
SAMPLE = 5e-3  # s that one timing of a formula lasts at least: 1000 times what the clock and the loop take
MOST_CALLS = 1000  # in one timing
ROUND_OFF = 1e-12  # bound of a rung that is exact: the hard cases hold the closed forms to less in 40-digit arithmetic
DIGITS = (0.1, 0.01, 0.001, 0.0001)  # tolerances whose choices are told, whatever tolerance is asked


@dataclass(frozen=True, kw_only=True)
class Rung:
    """One way to compute a quantity."""

    name: str
    error: float | None  # worst relative deviation from the reference; None for the reference and where there is none
    bound: float | None = None  # on the true error, relative, known without the reference; None: none is known
    seconds: float | None  # median of the repeats; None if it failed
    spread: float | None  # longest less shortest repeat, s
    repeats: int
    warm_up: float | None = None  # s, of the first call, which is in no repeat
    predicted: float | None = None  # s, of a mesh, told before it was solved
    memory: int | None  # largest resident memory of the process while it ran, bytes; see `memory.peak_while`
    unknowns: int | None = None  # of a mesh
    known_error: float | None = None  # what a tolerance is compared with, see `known_error`; None: nothing is known
    chosen: bool = False  # the cheapest within the tolerance
    failed: str | None = None  # why it gave no answer, in one line

    def to_json(self) -> dict[str, Any]:
        return dict(vars(self))


@dataclass(frozen=True, kw_only=True)
class Choice:
    """What a tolerance takes."""

    tolerance: float  # relative
    rung: Rung | None  # None where no rung is that good
    price: float | None  # seconds over those of the choice one step looser; None at the first and where there is none

    def to_json(self) -> dict[str, Any]:
        return {
            "tolerance": self.tolerance,
            "rung": None if self.rung is None else self.rung.name,
            "seconds": None if self.rung is None else self.rung.seconds,
            "price": self.price,
        }


@dataclass(frozen=True, kw_only=True)
class Ladder:
    """The rungs of one quantity, from cheap to exact."""

    quantity: str
    reference: str  # what the errors are taken against
    rungs: tuple[Rung, ...]
    absent: str | None = None  # why the scene has no such ladder; then there are no rungs

    @property
    def chosen(self) -> Rung | None:
        """The cheapest within the tolerance; None where no rung is."""
        return next((rung for rung in self.rungs if rung.chosen), None)

    def choose(self, tolerance: float) -> Rung | None:
        """The cheapest rung whose error is known to be within `tolerance`, relative; None where none is."""
        within = [
            (rung.seconds, number)
            for number, rung in enumerate(self.rungs)
            if rung.seconds is not None and rung.known_error is not None and rung.known_error <= tolerance
        ]
        return self.rungs[min(within)[1]] if within else None

    @property
    def choices(self) -> tuple[Choice, ...]:
        """The rung that each of DIGITS takes, and what the next digit costs."""
        rungs = [self.choose(digit) for digit in DIGITS]
        seconds = [None if rung is None else rung.seconds for rung in rungs]
        prices = [None, *(tight / loose if loose and tight else None for loose, tight in pairwise(seconds))]
        return tuple(
            Choice(tolerance=digit, rung=rung, price=price)
            for digit, rung, price in zip(DIGITS, rungs, prices, strict=True)
        )

    def to_json(self) -> dict[str, Any]:
        return {
            "quantity": self.quantity,
            "reference": self.reference,
            "absent": self.absent,
            "rungs": [rung.to_json() for rung in self.rungs],
            "choices": [choice.to_json() for choice in self.choices],
        }


@dataclass(frozen=True, kw_only=True, eq=False)
class Way:
    """One way to compute a quantity by a formula."""

    name: str
    run: Callable[[], Array]  # what is compared, of one shape along a ladder
    bound: Callable[[], float]  # on the relative error of what `run` gives; need not be part of its price
    may_refer: bool = False  # the last of these that gave an answer is the reference


@dataclass(frozen=True, kw_only=True, eq=False)
class Question:
    """A quantity and the ways to compute it, from cheap to exact."""

    quantity: str
    reference: str
    ways: tuple[Way, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Trial:
    """One way that has run: a rung before it is compared."""

    name: str
    answer: Array | None  # what is compared, of one shape along a ladder; None if it failed
    bound: float | None = None
    seconds: tuple[float, ...] = ()  # of each repeat
    warm_up: float | None = None
    predicted: float | None = None
    memory: int | None = None
    unknowns: int | None = None
    may_refer: bool = False
    failed: str | None = None


def measured(question: Question, *, tolerance: float) -> Ladder:
    """Every way of a question with its error and its price."""
    trials = [timed(way) for way in question.ways]
    return ladder_of(question.quantity, question.reference, trials, tolerance=tolerance)


def timed(way: Way) -> Trial:
    """One call to warm up, then samples long enough for the clock; a refusal is told in its words."""
    try:
        start = time.perf_counter()
        way.run()
        warm_up = time.perf_counter() - start
        answer, memory = peak_while(way.run)
        once = _seconds(way.run, calls=1)
        calls = int(np.clip(np.ceil(SAMPLE / once), 1, MOST_CALLS))
        repeats = int(np.clip(LONGEST / once, min(FEWEST_REPEATS, FORMULA_REPEATS), FORMULA_REPEATS))
        seconds = tuple(_seconds(way.run, calls=calls) for _ in range(repeats))
        bound = way.bound()
    except FembearingError as problem:
        return Trial(name=way.name, answer=None, failed=str(problem))
    return Trial(
        name=way.name,
        answer=answer,
        bound=bound if np.isfinite(bound) else None,
        seconds=seconds,
        warm_up=warm_up,
        memory=memory,
        may_refer=way.may_refer,
    )


def ladder_of(quantity: str, reference: str, trials: Sequence[Trial], *, tolerance: float) -> Ladder:
    """Compare each trial with the reference and choose the cheapest within `tolerance` (relative)."""
    exact = next((trial for trial in reversed(trials) if trial.may_refer and trial.answer is not None), None)
    rungs = []
    for trial in trials:
        error = None
        if exact is not None and trial is not exact and trial.answer is not None and exact.answer is not None:
            error = deviation(trial.answer, exact.answer)
        rungs.append(
            Rung(
                name=trial.name,
                error=error,
                bound=trial.bound,
                known_error=known_error(trial.bound, error, None if exact is None else exact.bound),
                seconds=float(np.median(trial.seconds)) if trial.seconds else None,
                spread=max(trial.seconds) - min(trial.seconds) if trial.seconds else None,
                repeats=len(trial.seconds),
                warm_up=trial.warm_up,
                predicted=trial.predicted,
                memory=trial.memory,
                unknowns=trial.unknowns,
                failed=trial.failed,
            )
        )
    ladder = Ladder(quantity=quantity, reference=reference, rungs=tuple(rungs))
    chosen = ladder.choose(tolerance)
    return replace(ladder, rungs=tuple(replace(rung, chosen=rung is chosen) for rung in rungs))


def known_error(bound: float | None, error: float | None, reference: float | None) -> float | None:
    """What is known of a rung's error: its bound, or what was measured where that is more.

    reference : the bound of what `error` was measured against, by which it may be off where the rung has no bound
    """
    if bound is not None:
        return bound if error is None else max(bound, error)
    return None if error is None or reference is None else error + reference


def deviation(answer: Array, exact: Array) -> float:
    """The worst of all numbers, relative; 0 against 0 is none."""
    off = np.abs(answer - exact)
    return float(np.max(np.divide(off, np.abs(exact), out=np.where(off > 0, np.inf, 0.0), where=exact != 0)))


def _seconds(run: Callable[[], object], *, calls: int) -> float:
    start = time.perf_counter()
    for _ in range(calls):
        run()
    return (time.perf_counter() - start) / calls
