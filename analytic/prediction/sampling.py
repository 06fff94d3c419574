"""The torque of many scenes: Latin hypercube points of the uncertain inputs, computed on all cores."""

from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from itertools import chain
from math import ceil
from time import perf_counter

import numpy as np
from scipy.special import ndtri
from scipy.stats import qmc

from analytic.errors import InputError
from analytic.prediction.evaluation import Problem, cores, evaluated
from analytic.progress import Progress
from analytic.scene import Array

LARGEST_FAILURE = 0.01  # share of samples without a torque, beyond which the interval would be that of the others
PIECES = 16  # of work for each thread; progress is told after each piece
SHOWN_REASONS = 3


@dataclass(frozen=True, kw_only=True, eq=False)
class Samples:
    """The N samples that have a torque, of `count`."""

    scores: Array  # (N, d) of the inputs, normal with the standard deviation 1
    torque: Array  # (N, parts, n) N m
    count: int
    reasons: tuple[str, ...]  # why samples failed, with how often
    seconds: float  # of the processor that the evaluations took, summed over the threads

    @property
    def failed(self) -> int:
        return self.count - self.scores.shape[0]

    def together(self, more: "Samples") -> "Samples":
        """These and more."""
        return Samples(
            scores=np.concatenate([self.scores, more.scores]),
            torque=np.concatenate([self.torque, more.torque]),
            count=self.count + more.count,
            reasons=tuple(dict.fromkeys(self.reasons + more.reasons)),
            seconds=self.seconds + more.seconds,
        )


def sampled(problem: Problem, *, count: int, seed: Sequence[int], workers: int | None, progress: Progress) -> Samples:
    """The torque at `count` Latin hypercube points; the same numbers for any number of threads.

    seed : numbers that the points follow from
    workers : threads; None: one for each core that this process may use
    Raises InputError where more than 1 % of the samples have no torque.
    """
    cube = qmc.LatinHypercube(len(problem.inputs), rng=np.random.default_rng(list(seed)))
    scores = ndtri(cube.random(count))
    width = cores() if workers is None else workers
    each = ceil(count / (PIECES * width))
    pieces = [scores[start : start + each] for start in range(0, count, each)]
    done, seconds, begun = 0, 0.0, perf_counter()
    torque = np.full((count, len(problem.parts), problem.held.size), np.nan)
    failed: list[list[str]] = []
    threads = ThreadPoolExecutor(width)  # the kernel, which takes most of the time, leaves the interpreter to others
    try:
        for values, why, spent in threads.map(lambda piece: evaluated(problem, piece), pieces):
            torque[done : done + len(values)] = values
            failed.append(why)
            seconds += spent
            done += len(values)
            left = (perf_counter() - begun) / done * (count - done)
            progress(done / count, f"{done} of {count} samples, {left:.0f} s left")
    finally:
        threads.shutdown(cancel_futures=True)
    good = np.isfinite(torque[:, 0]).all(axis=-1)
    reasons = Counter(chain.from_iterable(failed))
    words = tuple(f"{reason} ({times} times)" for reason, times in reasons.most_common(SHOWN_REASONS))
    if np.count_nonzero(~good) > LARGEST_FAILURE * count:
        raise InputError(
            f"{np.count_nonzero(~good)} of {count} samples have no torque, limit {100 * LARGEST_FAILURE:g} %; an "
            f"interval of the others is biased: give smaller spreads in [uncertainty]; {'; '.join(words)}"
        )
    return Samples(scores=scores[good], torque=torque[good], count=count, reasons=words, seconds=seconds)
