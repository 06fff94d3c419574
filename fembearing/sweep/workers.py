"""Tasks spread over processes of this machine or over a Dask cluster; one that dies takes no other task with it."""

import logging
import multiprocessing
import os
import signal
import threading
from collections import Counter, deque
from collections.abc import Callable, Generator, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ProcessPoolExecutor, wait
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from importlib.metadata import version
from typing import Any

from analytic.errors import FembearingError, InputError

THREADS = ("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS")
TRIES = 2  # of a task alone in its process, until it is blamed for that process's death
PATIENCE = 10.0  # s, in which a cluster has to answer
Task = tuple[Any, ...]  # arguments


class LostWorkerError(FembearingError):
    """A process that ended in the middle of a task."""


def each_done(
    function: Callable[..., Any], tasks: Mapping[Any, Task], *, workers: int | None = None
) -> Generator[tuple[Any, Any]]:
    """Key and result of every task as it gets done, by processes of this machine.

    workers : how many; None: one a core that this process may use. Each has its share of the cores for its threads.
    When a process dies, those that stood in it are suspects, and after all others they run again one at a time: a task
    whose process dies then too, twice, has a LostWorkerError as its result. What a task raises is raised here.
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
                    while queue and len(flying) < (1 if alone else width + 1):  # one more, so that none has to wait
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
                if future.done() and future.exception() is None:  # while another died
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


def each_done_by_cluster(
    function: Callable[..., Any], tasks: Mapping[Any, Task], *, address: str
) -> Generator[tuple[Any, Any]]:
    """The same by an existing Dask cluster, which runs a task again elsewhere when its worker dies.

    Those that it gives up run again one at a time, as here.

    Raises InputError where there is no Dask, no cluster at the address, no longer one, or one with another fembearing.
    """
    try:
        from distributed import Client, as_completed
        from distributed.scheduler import KilledWorker
    except ImportError as problem:
        raise InputError(
            "--scheduler needs Dask, which is not installed: pip install 'fembearing[cluster]'"
        ) from problem
    place, here = f"--scheduler {address!r}", version("fembearing")
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # what goes wrong is said here, in one line
    try:
        client: Any = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError) as problem:
        raise InputError(f"{place}: no Dask cluster answers there; start one, or check it") from problem
    with client:
        try:
            for there in client.run(version, "fembearing", on_error="return").values():
                if there != here:
                    raise InputError(f"{place}: a worker has not fembearing {here} as here ({there}); install the same")
            keys = {client.submit(function, *task, pure=False): key for key, task in tasks.items()}
            suspects = []
            for future in as_completed(list(keys), loop=client.loop, raise_errors=False):
                key = keys.pop(future)
                try:
                    result = future.result()
                except KilledWorker:  # another task of that worker may have been the one
                    suspects.append(key)
                else:
                    yield key, result
                future.release()
            for key in suspects:
                try:
                    result = client.submit(function, *tasks[key], pure=False).result()
                except KilledWorker as problem:
                    result = LostWorkerError(f"every worker that took it died: {' '.join(str(problem).split())}")
                yield key, result
        except (CancelledError, OSError) as problem:
            raise InputError(
                f"{place}: the cluster went away; what is done is kept: the same command goes on"
            ) from problem
        except (ImportError, RuntimeError) as problem:  # of the scheduler, which reads the tasks too
            raise InputError(
                f"{place}: the cluster cannot read what it is sent; its scheduler needs fembearing {here} as here"
            ) from problem


def cores() -> int:
    """That this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def _pool(width: int) -> Iterator[ProcessPoolExecutor]:
    """Fresh processes, none of which outlives the block, however that is left."""
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
    """A worker leaves it to its parent to be stopped, and ends with it, even where that was killed."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    assert parent is not None

    def follow() -> None:
        parent.join()
        os._exit(1)

    threading.Thread(target=follow, daemon=True).start()


@contextmanager
def _threads(count: int) -> Iterator[None]:
    """What processes that start meanwhile are told about threads of their own, where a person has not told them."""
    untold = [name for name in THREADS if name not in os.environ]
    os.environ.update(dict.fromkeys(untold, str(count)))
    try:
        yield
    finally:
        for name in untold:
            del os.environ[name]
