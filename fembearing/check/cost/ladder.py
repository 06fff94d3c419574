"""What each digit costs: the methods for a quantity from cheap to exact, with error, bound and seconds.

An error is relative to the reference, one of the ladder's methods, which has no error itself. A bound is known without
the reference, so a method is chosen by it. Seconds are wall time on this machine, memory is resident.
"""

import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated

import numpy as np
from annotated_types import Gt, Lt

from analytic.errors import FembearingError
from analytic.rows import Count, NotNegative
from analytic.scene import Array
from fembearing.check.memory import peak_while

FORMULA_REPEATS = 15  # their median leaves out the effect of other programs on a short timing
FEWEST_REPEATS, LONGEST = 3, 1.0  # of a slow formula; s, limit for all repeats together
SAMPLE = 5e-3  # s, least duration of one timing of a formula: 1000 times the cost of clock and loop
MOST_CALLS = 1000  # in one timing
ROUND_OFF = 1e-12  # bound of an exact method: the hard cases hold the closed forms to less, against 40-digit arithmetic
DIGITS = (0.1, 0.01, 0.001, 0.0001)  # tolerances whose choices are shown, whatever the tolerance


@dataclass(frozen=True, kw_only=True)
class Method:
    """A method to compute a quantity, compared with the others of its ladder."""

    name: str  # as readers see it
    error: float | None  # worst relative deviation from the reference; None for the reference and without one
    bound: float | None = None  # on the true error, relative, known without the reference; None: unknown
    seconds: Annotated[float, Gt(0), Lt(1e12)] | None  # median of the repeats; None if it failed
    spread: NotNegative | None  # longest less shortest repeat, s
    repeats: int  # number of timed runs
    warm_up: NotNegative | None = None  # s, of the first call, which is in no repeat
    predicted: NotNegative | None = None  # s, of a mesh, predicted before it was solved
    memory: Count | None  # largest resident memory of the process while it ran, bytes; see `memory.peak_while`
    unknowns: Count | None = None  # number, of a mesh
    known_error: float | None = None  # relative, compared with a tolerance, see `known_error`; None: unknown
    chosen: bool = False  # the cheapest within the tolerance
    failed: str | None = None  # why it gave no answer, in one line


@dataclass(frozen=True, kw_only=True)
class Choice:
    """The method that a tolerance needs."""

    tolerance: float  # relative
    method: str | None  # its name; None where no method is within the tolerance
    seconds: NotNegative | None  # of the method
    price: NotNegative | None  # seconds over those of the next looser choice; None for the first and without a method

    def __post_init__(self) -> None:
        """Raises ValueError for a method without its time, and for a time without a method."""
        if (self.method is None) != (self.seconds is None):
            raise ValueError("has a method without seconds, or the other way round")


@dataclass(frozen=True, kw_only=True)
class Ladder:
    """The methods for one quantity, from cheap to exact."""

    quantity: str  # what the methods compute
    reference: str  # what the errors are relative to
    methods: tuple[Method, ...]
    absent: str | None = None  # why the scene has no such ladder; then there are no methods
    choices: tuple[Choice, ...] = ()  # the method for each of DIGITS, and the price of the next digit

    @property
    def chosen(self) -> Method | None:
        """The cheapest within the tolerance; None where no method is."""
        return next((method for method in self.methods if method.chosen), None)

    def choose(self, tolerance: float) -> Method | None:
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
        within = [
            (method.seconds, number)
            for number, method in enumerate(self.methods)
            if method.seconds is not None and method.known_error is not None and method.known_error <= tolerance
        ]
        return self.methods[min(within)[1]] if within else None


def with_choices(ladder: Ladder) -> Ladder:
    """The ladder with the method for each of DIGITS."""
    methods = [ladder.choose(digit) for digit in DIGITS]
    seconds = [None if method is None else method.seconds for method in methods]
    prices = [None, *(tight / loose if loose and tight else None for loose, tight in pairwise(seconds))]
    choices = (
        Choice(tolerance=digit, method=None if method is None else method.name, seconds=taken, price=price)
        for digit, method, taken, price in zip(DIGITS, methods, seconds, prices, strict=True)
    )
    return replace(ladder, choices=tuple(choices))


@dataclass(frozen=True, kw_only=True, eq=False)
class UntimedMethod:
    """A method that has not run yet: a function, and the bound on its error."""

    name: str
    run: Callable[[], Array]  # the compared numbers, of one shape along a ladder
    bound: Callable[[], float]  # on the relative error of the result of `run`; its time does not count
    may_refer: bool = False  # the last of these that gave an answer is the reference


@dataclass(frozen=True, kw_only=True, eq=False)
class UntimedLadder:
    """A quantity and its methods from cheap to exact, before they have run."""

    quantity: str
    reference: str
    methods: tuple[UntimedMethod, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class TimedMethod:
    """A method that has run, before it is compared with the others."""

    name: str
    answer: Array | None  # the compared numbers, of one shape along a ladder; None if it failed
    bound: float | None = None
    seconds: tuple[float, ...] = ()  # of each repeat
    warm_up: float | None = None
    predicted: float | None = None
    memory: int | None = None
    unknowns: int | None = None
    may_refer: bool = False
    failed: str | None = None


def measured(ladder: UntimedLadder, *, tolerance: float) -> Ladder:
    """Run every method of a ladder: its error and its price."""
    methods = [timed(method) for method in ladder.methods]
    return ladder_of(ladder.quantity, ladder.reference, methods, tolerance=tolerance)


def timed(method: UntimedMethod) -> TimedMethod:
    """One call to warm up, then samples long enough for the clock; an error of the library is kept as its message."""
    try:
        start = time.perf_counter()
        method.run()
        warm_up = time.perf_counter() - start
        answer, memory = peak_while(method.run)
        once = _seconds(method.run, calls=1)
        calls = int(np.clip(np.ceil(SAMPLE / once), 1, MOST_CALLS))
        repeats = int(np.clip(LONGEST / once, min(FEWEST_REPEATS, FORMULA_REPEATS), FORMULA_REPEATS))
        seconds = tuple(_seconds(method.run, calls=calls) for _ in range(repeats))
        bound = method.bound()
    except FembearingError as problem:
        return TimedMethod(name=method.name, answer=None, failed=str(problem))
    return TimedMethod(
        name=method.name,
        answer=answer,
        bound=bound if np.isfinite(bound) else None,
        seconds=seconds,
        warm_up=warm_up,
        memory=memory,
        may_refer=method.may_refer,
    )


def ladder_of(quantity: str, reference: str, runs: Sequence[TimedMethod], *, tolerance: float) -> Ladder:
    """Compare each method with the reference and choose the cheapest within `tolerance` (relative)."""
    exact = next((each for each in reversed(runs) if each.may_refer and each.answer is not None), None)
    methods = []
    for each in runs:
        error = None
        if exact is not None and each is not exact and each.answer is not None and exact.answer is not None:
            error = deviation(each.answer, exact.answer)
        methods.append(
            Method(
                name=each.name,
                error=error,
                bound=each.bound,
                known_error=known_error(each.bound, error, None if exact is None else exact.bound),
                seconds=float(np.median(each.seconds)) if each.seconds else None,
                spread=max(each.seconds) - min(each.seconds) if each.seconds else None,
                repeats=len(each.seconds),
                warm_up=each.warm_up,
                predicted=each.predicted,
                memory=each.memory,
                unknowns=each.unknowns,
                failed=each.failed,
            )
        )
    ladder = Ladder(quantity=quantity, reference=reference, methods=tuple(methods))
    chosen = ladder.choose(tolerance)
    return with_choices(replace(ladder, methods=tuple(replace(method, chosen=method is chosen) for method in methods)))


def known_error(bound: float | None, error: float | None, reference: float | None) -> float | None:
    """What is known of a method's error: its bound, or the measured error if that is larger.

    reference : bound on the reference's own error, which is added to `error` where the method has no bound
    """
    if bound is not None:
        return bound if error is None else max(bound, error)
    return None if error is None or reference is None else error + reference


def deviation(answer: Array, exact: Array) -> float:
    """The largest relative deviation of all numbers; 0 from 0 is none."""
    off = np.abs(answer - exact)
    return float(np.max(np.divide(off, np.abs(exact), out=np.where(off > 0, np.inf, 0.0), where=exact != 0)))


def _seconds(run: Callable[[], object], *, calls: int) -> float:
    start = time.perf_counter()
    for _ in range(calls):
        run()
    return (time.perf_counter() - start) / calls
