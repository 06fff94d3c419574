"""Tasks on Dask workers, of this machine or of a cluster elsewhere; when a worker dies, no other task is lost.

`distributed` is imported when tasks begin: it takes half a second.
"""

import logging
import os
from asyncio import gather, run, wait_for
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import CancelledError
from contextlib import contextmanager
from importlib.metadata import version
from importlib.util import find_spec
from typing import Any

from analytic.errors import FembearingError, InputError, ResourceError

PATIENCE = 5.0  # s, within which a cluster elsewhere has to answer
MEMORY = 1.0  # share of this machine's that each worker may take: all, since a task that needs much runs alone at last
ENVIRONMENT = {  # of the workers on this machine, where the user has not set it
    **dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"), 1),
    # Of glibc: freed arrays go back to the system. Without these lines a worker of contacts keeps 70 MB more.
    **dict.fromkeys(("MALLOC_TRIM_THRESHOLD_", "MALLOC_MMAP_THRESHOLD_"), 8_000_000),
    "MALLOC_ARENA_MAX": 1,
}
SETTINGS = {  # of the workers on this machine
    "distributed.nanny.pre-spawn-environ": ENVIRONMENT,
    "distributed.scheduler.allowed-failures": 1,  # a task runs again once before it is tried alone
    "distributed.scheduler.no-workers-timeout": "60s",  # else a sweep without workers would wait for ever
    "distributed.scheduler.work-stealing-interval": "100ms",
    "distributed.deploy.lost-worker-timeout": "60s",  # a worker that died is not given up while it starts again
    # A worker keeps one result at a time. Nothing of it goes to the disk, and a full worker does not wait for ever.
    "distributed.worker.memory.target": False,
    "distributed.worker.memory.spill": False,
    "distributed.worker.memory.pause": False,
    "distributed.worker.profile.enabled": False,
    "distributed.admin.large-graph-warning-threshold": "1GB",  # a grid of a million values is sent with each task
}
DEAF = "import signal; signal.signal(signal.SIGINT, signal.SIG_IGN)"  # Ctrl-C is for the process that has the workers


class LostWorkerError(FembearingError):
    """A worker ended in the middle of a task, each time that the task was tried."""


def each_done(
    function: Callable[[Any], Any],
    tasks: Sequence[Any],
    *,
    workers: int | None = None,
    scheduler: str | None = None,
    announce: Callable[[str], None] | None = None,
) -> Generator[tuple[Any, Any]]:
    """Every task with the function's result as it is finished, by workers of this machine or of a Dask cluster.

    workers : number of processes of this machine, each with one thread; None: one for each core that this process may
        use. They end with the generator, and with this process
    scheduler : address of a Dask cluster that computes instead
    announce : called with the address of the dashboard, if there is one
    A task runs again when its worker dies. If that one dies too, the task runs once more after all others, alone; if
    that fails as well, its result is a LostWorkerError. An exception of a task is raised here.
    Raises InputError where no cluster answers at the address, it goes away, or it has another version of fembearing;
    FembearingError where the processes of this machine cannot start, ResourceError where all of them end.
    """
    if not tasks:
        return
    with _workers_here(workers, len(tasks)) if scheduler is None else _workers_at(scheduler) as client:
        if announce is not None and client.run_on_scheduler(_draws_dashboard):
            announce(client.dashboard_link)
        suspects = []
        for task, result in _each_done(client, function, tasks):
            if isinstance(result, LostWorkerError):  # perhaps by another task of that worker
                suspects.append(task)
            else:
                yield task, result
        for task in suspects:
            yield from _each_done(client, function, [task])


def _each_done(client: Any, function: Callable[[Any], Any], tasks: Sequence[Any]) -> Generator[tuple[Any, Any]]:
    from distributed import as_completed
    from distributed.scheduler import KilledWorker

    running = dict(zip(client.map(function, tasks, pure=False), tasks, strict=True))
    for future in as_completed(running, loop=client.loop):
        try:
            result = future.result()
        except KilledWorker:
            result = LostWorkerError(
                "every process that took it was ended by the system, as one that takes too much memory is, or killed; "
                "free some memory, or compute it on a larger machine"
            )
        yield running.pop(future), result


@contextmanager
def _workers_here(workers: int | None, tasks: int) -> Iterator[Any]:
    """A client of new processes of this machine, which end with the block, however it is left."""
    import dask.config
    from dask.system import CPU_COUNT
    from distributed import Client, LocalCluster
    from distributed.scheduler import NoWorkerError

    options: dict[str, Any] = {
        "n_workers": min(CPU_COUNT if workers is None else workers, max(1, tasks)),
        "threads_per_worker": 1,
        "memory_limit": MEMORY,
        "preload": [DEAF],
        "dashboard_address": "127.0.0.1:0",  # any free port; without Bokeh, it only says that
        "silence_logs": logging.CRITICAL,  # errors are reported here, in one line
    }
    before = set(os.environ)  # Dask adds to it what it sets for the processes that it starts
    with dask.config.set(SETTINGS):
        try:
            cluster = LocalCluster(**options)
        except RuntimeError as problem:
            logging.getLogger("distributed.process").setLevel(logging.CRITICAL)  # at exit it names what it ends
            raise FembearingError(
                "the processes that are to compute end as soon as they start: free some memory, and begin a script of "
                'your own with if __name__ == "__main__":'
            ) from problem
        try:
            with Client(cluster, set_as_default=False) as client:
                yield client
        except NoWorkerError as problem:
            raise ResourceError(
                "the processes that compute ended and none starts again; free some memory: finished points are kept, "
                "and the same command continues"
            ) from problem
        finally:
            cluster.sync(_end, cluster)
            cluster.close()
            for name in os.environ.keys() - before:
                del os.environ[name]


async def _end(cluster: Any) -> None:
    """End the processes. What still computes has half a second to come to an end, and is killed then."""
    await gather(*(worker.close(timeout=0.5) for worker in cluster.workers.values()), return_exceptions=True)


@contextmanager
def _workers_at(address: str) -> Iterator[Any]:
    """A client of a Dask cluster. Errors of the cluster in the block are raised as InputError."""
    from distributed import Client

    place, here = f"--scheduler {address!r}", version("fembearing")
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # errors are reported here, in one line
    try:
        run(wait_for(_greet(address), PATIENCE))
        client: Any = Client(address, timeout=PATIENCE, set_as_default=False)
    except (OSError, ValueError, MemoryError) as problem:  # MemoryError: of a size that something else wrote
        raise InputError(f"{place}: no Dask cluster answers there; start one, or check it") from problem
    with client:
        try:
            for there in client.run(version, "fembearing", on_error="return").values():
                if there != here:
                    raise InputError(f"{place}: a worker has not fembearing {here} as here ({there}); install the same")
            yield client
        except (CancelledError, OSError) as problem:
            raise InputError(
                f"{place}: the cluster went away; finished points are kept: the same command continues"
            ) from problem
        except (ImportError, RuntimeError) as problem:  # raised by the scheduler, which reads the tasks too
            raise InputError(
                f"{place}: the cluster cannot read what it is sent; its scheduler needs fembearing {here} as here"
            ) from problem


async def _greet(address: str) -> None:
    """Raise an error where no Dask answers; a client would take half a minute to find out, and leave a traceback."""
    from distributed.comm.core import connect

    greeted = await connect(address, timeout=PATIENCE)
    await greeted.close()


def _draws_dashboard() -> bool:
    """Whether a scheduler in this process has a dashboard: Dask needs Bokeh for it."""
    return find_spec("bokeh") is not None
