"""Tasks on processes of this machine; when a process dies, no other task is lost."""

import multiprocessing
import os
import signal
import threading
from collections import Counter, deque
from collections.abc import Callable, Generator, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from typing import Any

from analytic.errors import FembearingError

THREADS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS")
TRIES = 2  # times that the process of a task dies while the task runs alone, before the task is given up
Task = tuple[Any, ...]  # arguments


class LostWorkerError(FembearingError):
    """A process ended in the middle of a task."""


def each_done(
    function: Callable[..., Any], tasks: Mapping[Any, Task], *, workers: int | None = None
) -> Generator[tuple[Any, Any]]:
    """Key and result of every task as it is finished, by processes of this machine.

    workers : number of processes; None: one for each core that this process may use. They share the cores equally for
        their threads.
    When a process dies, its unfinished tasks become suspects. They run again after all others, one at a time: a task
    whose process then dies twice gets a LostWorkerError as its result. An exception of a task is raised here.
    """
    width = min(cores() if workers is None else workers, max(1, len(tasks)))
    waiting, suspects, deaths = deque(tasks), deque(), Counter()
    while waiting or suspects:
        alone = not waiting
        queue = suspects if alone else waiting
        with _pool(1 if alone else width) as pool:
            flying: dict[Future, Any] = {}
            lost: list[Any] = []
            while (queue or flying) and not lost:
                try:
                    while queue and len(flying) < (
                        1 if alone else width + 1
                    ):  # one more than processes, so that none is idle
                        flying[pool.submit(function, *tasks[queue[0]])] = queue[0]
                        queue.popleft()
                except BrokenProcessPool:
                    break
                for future in wait(flying, return_when=FIRST_COMPLETED).done:
                    key = flying.pop(future)
                    try:
                        result = future.result()
                    except BrokenProcessPool:
                        lost.append(key)
                    else:
                        yield key, result
            for future, key in flying.items():
                if future.done() and future.exception() is None:  # finished while another process died
                    yield key, future.result()
                else:
                    lost.append(key)
        if alone:
            deaths.update(lost)
        blamed = [key for key in lost if deaths[key] >= TRIES]
        suspects.extend(key for key in lost if key not in blamed)
        for key in blamed:
            yield (
                key,
                LostWorkerError("its process was ended by the system, as one that takes too much memory is, or killed"),
            )


def cores() -> int:
    """Number of cores that this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def _pool(width: int) -> Iterator[ProcessPoolExecutor]:
    """New processes, which end with the block, however it is left."""
    before = set(multiprocessing.active_children())
    with _threads(max(1, cores() // width)):
        pool = ProcessPoolExecutor(width, mp_context=multiprocessing.get_context("spawn"), initializer=_begin)
        try:
            try:
                pool.submit(os.getpid).result()
            except BrokenProcessPool as problem:
                raise FembearingError(
                    "the processes that are to compute end as soon as they start; a script of your own has to begin "
                    'with if __name__ == "__main__":'
                ) from problem
            yield pool
        finally:
            for child in set(multiprocessing.active_children()) - before:
                child.kill()
            pool.shutdown(cancel_futures=True)


def _begin() -> None:
    """Let only the parent process stop a worker, and end the worker with its parent, even if that is killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    assert parent is not None

    def follow() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=follow, daemon=True).start()


@contextmanager
def _threads(count: int) -> Iterator[None]:
    """Set the number of threads of the processes that start in this block, unless the user has set it."""
    unset = [name for name in THREADS if name not in os.environ]
    os.environ.update(dict.fromkeys(unset, str(count)))
    try:
        yield
    finally:
        for name in unset:
            del os.environ[name]
