"""What each digit costs: the methods for a quantity from cheap to exact, with error, bound and seconds.

An error is relative to the reference, one of the ladder's methods, which has no error itself. A bound is known without
the reference, so a method is chosen by it. Seconds are wall time on this machine, memory is resident.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, Any, NamedTuple

import numpy as np
from annotated_types import Gt, Lt
from numpy.typing import ArrayLike

from analytic.errors import FembearingError
from analytic.progress import Progress, silent
from analytic.rows import Count, NotNegative
from analytic.scene import Array
from fembearing.check.memory import peak_while

REPEATS, FEWEST = 15, 3  # timings: their median leaves out the effect of other programs on a short one
LONGEST, DEAR = 1.0, 10.0  # s: limit for more than the fewest together; what takes longer is timed once
SAMPLE, MOST_CALLS = 5e-3, 1000  # least s of one timing: 1000 times the cost of clock and loop; calls in it
ROUND_OFF = 1e-12  # bound of an exact method: the hard cases hold the closed forms to less, against 40-digit arithmetic


@dataclass(frozen=True, kw_only=True)
class Method:
    """A method to compute a quantity, compared with the others of its ladder."""

    name: str  # as readers see it
    error: float | None = None  # worst relative deviation from the reference; None for the reference and without one
    bound: float | None = None  # on the true error, relative, known without the reference; None: unknown
    seconds: Annotated[float, Gt(0), Lt(1e12)] | None = None  # median of the repeats; None if it failed
    spread: NotNegative | None = None  # longest less shortest repeat, s
    repeats: int = 0  # number of timed runs
    warm_up: NotNegative | None = None  # s, of the first call, which is in no repeat
    memory: Count | None = None  # largest resident memory of the process while it ran, bytes; see `memory.peak_while`
    unknowns: Count | None = None  # number, of a mesh
    known_error: float | None = None  # relative, compared with a tolerance, see `measured`; None: unknown
    chosen: bool = False  # the cheapest within the tolerance
    failed: str | None = None  # why it gave no answer, in one line


@dataclass(frozen=True, kw_only=True)
class Ladder:
    """The methods for one quantity, from cheap to exact."""

    quantity: str  # what the methods compute
    reference: str = "none"  # what the errors are relative to
    methods: tuple[Method, ...] = ()
    absent: str | None = None  # why the scene has no such ladder; then there are no methods

    def cheapest(self, tolerance: float) -> Method | None:
        """The cheapest method whose error is known to be within a tolerance.

        Parameters
        ----------
        tolerance : float
            Relative.

        Returns
        -------
        Method or None
            None where there is none.
        """
        known = (each for each in self.methods if each.seconds and each.known_error is not None)
        within = (each for each in known if (each.known_error or 0.0) <= tolerance)
        return min(within, key=lambda each: each.seconds or 0.0, default=None)


class Candidate(NamedTuple):
    """A method that has not run yet."""

    name: str
    run: Callable[[], Any]
    answer: Callable[[Any], ArrayLike] = np.asarray  # the compared numbers of a result, of one shape along a ladder
    bound: float | Callable[[Any], float | None] | None = None  # on the relative error of the answer, or of a result
    may_refer: bool = False  # the last of these that gave an answer is the reference
    once: bool = False  # without warm-up and repeats: too slow, or not to be repeated
    spent: float = 0.0  # s, on its result before it runs
    after: tuple[str, ...] = ()  # methods whose results it takes: their seconds are part of its own


def measured(
    quantity: str,
    reference: str,
    candidates: Sequence[Candidate],
    *,
    tolerance: float,
    repeats: int = REPEATS,
    progress: Progress = silent,
) -> Ladder:
    """Run every method of a ladder, compare it with the reference, and choose the cheapest within a tolerance.

    What is known of a method's error is its bound, or the measured error if that is larger. Without a bound it is the
    measured error and the bound of the reference together.

    reference : what the last that may refer is, in words;  tolerance : relative
    repeats : of a fast method at most; 1: errors matter, seconds do not
    """
    methods: dict[str, Method] = {}
    answers: dict[str, Array] = {}
    for number, each in enumerate(candidates):
        progress(number / len(candidates), f"{quantity}: {each.name}")
        before = [methods[name] for name in each.after if name in answers]
        try:
            methods[each.name], answers[each.name] = _timed(each, before, repeats)
        except FembearingError as problem:
            methods[each.name] = Method(name=each.name, failed=str(problem))
    able = [each.name for each in candidates if each.may_refer]
    exact = next((name for name in reversed(able) if name in answers), None)
    if exact != able[-1]:
        reference = f"{'none' if exact is None else exact}: {able[-1]} failed"
    for name, answer in answers.items():
        error = None if exact is None or name == exact else deviation(answer, answers[exact])
        known, uncertainty = methods[name].bound, None if exact is None else methods[exact].bound
        if error is not None and (known is not None or uncertainty is not None):
            known = error + (uncertainty or 0.0) if known is None else max(known, error)
        methods[name] = replace(methods[name], error=error, known_error=known)
    ladder = Ladder(quantity=quantity, reference=reference, methods=tuple(methods.values()))
    chosen = ladder.cheapest(tolerance)
    return replace(ladder, methods=tuple(replace(method, chosen=method is chosen) for method in ladder.methods))


def deviation(answer: Array, exact: Array) -> float:
    """The largest relative deviation of all numbers; 0 from 0 is none."""
    off = np.abs(answer - exact)
    return float(np.max(np.divide(off, np.abs(exact), out=np.where(off > 0, np.inf, 0.0), where=exact != 0)))


def clocked(run: Callable[[], Any], calls: int = 1) -> tuple[float, Any]:
    """Mean seconds of a call, and the last result."""
    start = time.perf_counter()
    for _ in range(calls - 1):
        run()
    result = run()
    return (time.perf_counter() - start) / calls, result


def _timed(candidate: Candidate, before: Sequence[Method], repeats: int) -> tuple[Method, Array]:
    """A method with its answer: one call to warm up, one for its memory, and samples long enough for the clock."""
    warm_up, memory = None, max((each.memory for each in before if each.memory), default=None)
    spent = candidate.spent + sum(each.seconds or 0.0 for each in before)
    if candidate.once:
        once, result = clocked(candidate.run)
    else:
        warm_up, _ = clocked(candidate.run)
        (once, result), memory = peak_while(partial(clocked, candidate.run))
    seconds = [spent + once]
    if not candidate.once and repeats > 1 and once <= DEAR:
        calls = int(np.clip(np.ceil(SAMPLE / once), 1, MOST_CALLS))
        count = int(np.clip(LONGEST / once, min(FEWEST, repeats), repeats))
        seconds = seconds[: calls == 1]  # a single call is no sample among means of many
        seconds += [clocked(candidate.run, calls)[0] for _ in range(count - len(seconds))]
    bound = candidate.bound(result) if callable(candidate.bound) else candidate.bound
    method = Method(
        name=candidate.name,
        bound=bound if bound is not None and np.isfinite(bound) else None,
        seconds=float(np.median(seconds)),
        spread=max(seconds) - min(seconds),
        repeats=len(seconds),
        warm_up=warm_up,
        memory=memory,
        unknowns=getattr(result, "unknowns", None),
    )
    return method, np.asarray(candidate.answer(result), dtype=float)
