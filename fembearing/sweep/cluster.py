"""Tasks on processes of this machine, or on a Dask cluster; when a process dies, no other task is lost.

`distributed` is imported when tasks for a cluster begin: it takes half a second.
"""

import logging
from asyncio import run, wait_for
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import CancelledError, ThreadPoolExecutor
from contextlib import contextmanager
from importlib.metadata import version
from typing import Any

from analytic.errors import InputError, require_packages
from analytic.prediction.evaluation import cores
from fembearing.sweep.processes import Compute, LostWorkerError, processes_here

PATIENCE = 5.0  # s, within which a cluster has to answer


def each_done(
    function: Callable[[Any], Any],
    tasks: Sequence[Any],
    *,
    workers: int | None = None,
    scheduler: str | None = None,
) -> Generator[tuple[Any, Any]]:
    """Every task with the function's result as it is finished.

    workers : number of processes of this machine; None: one for each core that this process may use
    scheduler : address of a Dask cluster that computes instead
    A task whose process dies runs once more after all others, alone. If that fails as well, its result is a
    LostWorkerError. An exception of a task is raised here.
    Raises InputError where no cluster answers at the address, it goes away, or it has another version of fembearing;
    ResourceError where processes of this machine cannot start.
    """
    if not tasks:
        return
    if scheduler is None:
        place = processes_here(function, min(cores() if workers is None else workers, len(tasks)))
    else:
        place = _cluster_at(scheduler, function)
    with place as compute:
        suspects = []
        for task, result in compute(tasks):
            if isinstance(result, LostWorkerError):  # on a cluster perhaps by another task of that worker
                suspects.append(task)
            else:
                yield task, result
        for task in suspects:
            yield from compute([task])


@contextmanager
def _cluster_at(address: str, function: Callable[[Any], Any]) -> Iterator[Compute]:
    """A Dask cluster. Its errors in the block are raised as InputError."""
    require_packages("--scheduler", "dask", "distributed")
    from distributed import Client, KilledWorker, as_completed

    place, here = f"--scheduler {address!r}", version("fembearing")
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # errors are reported here, in one line
    try:
        with ThreadPoolExecutor(1) as thread:  # of its own: that of a notebook has a loop already
            thread.submit(run, wait_for(_greet(address), PATIENCE)).result()
        client: Any = Client(address, timeout=PATIENCE, set_as_default=False)
    # MemoryError: of a size that something else wrote; the next ones: of TLS without a certificate, or not wanted
    except (OSError, ValueError, MemoryError, TypeError, RuntimeError) as problem:
        remedy = "start one, or check it; tls:// takes the certificates that Dask is configured with"
        raise InputError(f"{place}: no Dask cluster answers there; {remedy}") from problem

    def compute(tasks: Sequence[Any]) -> Generator[tuple[Any, Any]]:
        running = dict(zip(client.map(function, tasks, pure=False), tasks, strict=True))
        for future in as_completed(running, loop=client.loop):
            try:
                result = future.result()
            except KilledWorker:
                result = LostWorkerError()
            yield running.pop(future), result

    with client:
        try:
            for there in client.run(version, "fembearing", on_error="return").values():
                if there != here:
                    raise InputError(f"{place}: a worker has not fembearing {here} as here ({there}); install the same")
            yield compute
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
    from distributed import Security, connect

    greeted = await connect(address, timeout=PATIENCE, **Security().get_connection_args("client"))
    await greeted.close()
