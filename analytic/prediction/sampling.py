"""The torque of many scenes: Latin hypercube points of the uncertain inputs, computed on all cores."""

import multiprocessing
import os
import signal
import threading
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor, ThreadPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from dataclasses import dataclass
from itertools import chain
from math import ceil
from time import perf_counter

import numpy as np
from scipy.special import ndtri
from scipy.stats import qmc

from analytic.errors import InputError, ResourceError
from analytic.prediction.evaluation import Problem, evaluated
from analytic.scene import Array

Progress = Callable[[float, str], None]  # share done, 0 to 1, and what is being done
LARGEST_FAILURE = 0.01  # share of samples without a torque, beyond which the interval would be that of the others
SHORT = 2.0  # s: work that new processes, which take a second or two to start, hardly shorten
EACH = 0.2  # s: of a task
SHOWN_REASONS = 3


def silent(_share: float, _step: str) -> None:
    """Progress that is not shown."""


@dataclass(frozen=True, kw_only=True, eq=False)
class Samples:
    """The N samples that have a torque, of `count`."""

    scores: Array  # (N, d) of the inputs, normal with the standard deviation 1
    torque: Array  # (N, parts, n) N m
    count: int
    reasons: tuple[str, ...]  # why samples failed, with how often
    seconds: float  # that the evaluations took, summed over the processes

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
    """The torque at `count` Latin hypercube points; the same numbers for any number of processes.

    seed : numbers that the points follow from
    workers : processes, with this one; None: one for each core that it may use, or no other where the work is short
    Raises InputError where more than 1 % of the samples have no torque; ResourceError where a process dies.
    """
    cube = qmc.LatinHypercube(len(problem.inputs), rng=np.random.default_rng(list(seed)))
    scores = ndtri(cube.random(count))
    width = _cores() if workers is None else workers
    if workers is None and count * problem.seconds < SHORT:
        width = 1
    each = max(1, min(ceil(count / width), ceil(EACH / problem.seconds)))
    pieces = [scores[start : start + each] for start in range(0, count, each)]
    done, seconds, begun = 0, 0.0, perf_counter()
    torque = np.full((count, len(problem.parts), problem.held.size), np.nan)
    failed: dict[int, list[str]] = {}
    for place, (values, why, spent) in _on_processes(problem, pieces, width):
        first = place * each
        torque[first : first + len(values)] = values
        failed[place] = why
        seconds += spent
        done += len(values)
        left = (perf_counter() - begun) / done * (count - done)
        progress(done / count, f"{done} of {count} samples, {left:.0f} s left")
    good = np.isfinite(torque[:, 0]).all(axis=-1)
    reasons = Counter(chain.from_iterable(failed[place] for place in range(len(pieces))))
    words = tuple(f"{reason} ({times} times)" for reason, times in reasons.most_common(SHOWN_REASONS))
    if np.count_nonzero(~good) > LARGEST_FAILURE * count:
        raise InputError(
            f"{np.count_nonzero(~good)} of {count} samples have no torque, limit {100 * LARGEST_FAILURE:g} %; an "
            f"interval of the others is biased: give smaller spreads in [uncertainty]; {'; '.join(words)}"
        )
    return Samples(scores=scores[good], torque=torque[good], count=count, reasons=words, seconds=seconds)


def _on_processes(
    problem: Problem, pieces: Sequence[Array], width: int
) -> Iterator[tuple[int, tuple[Array, list[str], float]]]:
    """The number of each piece and `evaluated` for it, by this process and by others that end with the iterator.

    This one takes pieces from the end that no other has begun, also while the others start.
    """
    if width == 1 or multiprocessing.current_process().daemon:  # which may start no other, as in a Pool
        yield from enumerate(evaluated(problem, piece) for piece in pieces)
        return
    context = multiprocessing.get_context("spawn")
    pool = ProcessPoolExecutor(width - 1, mp_context=context, initializer=_begin)
    # Each process has a thread that hands it one piece after another: a pool of processes that breaks while a piece of
    # its own is cancelled waits for ever.
    threads = ThreadPoolExecutor(width - 1)
    try:
        begun = [threads.submit(lambda each: pool.submit(evaluated, problem, each).result(), each) for each in pieces]
        for place in reversed(range(len(pieces))):
            yield place, evaluated(problem, pieces[place]) if begun[place].cancel() else begun[place].result()
    except BrokenProcessPool as fault:
        raise ResourceError(
            "a process for the samples ended: too little memory, or a script without "
            'if __name__ == "__main__":; predict(..., workers=1) computes without processes'
        ) from fault
    finally:
        threads.shutdown(cancel_futures=True)
        pool.shutdown()


def _begin() -> None:
    """Leave Ctrl-C to the parent process, and end with it, even if it is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    assert parent is not None

    def follow() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=follow, daemon=True).start()


def _cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
