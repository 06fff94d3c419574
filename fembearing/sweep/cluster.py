"""Tasks on a Dask cluster; when a worker dies, no other task is lost."""

import logging
from collections.abc import Callable, Generator, Mapping
from concurrent.futures import CancelledError
from importlib.metadata import version
from typing import Any

from analytic.errors import InputError
from analytic.numerics.processes import LostWorkerError, Task

PATIENCE = 10.0  # s, within which a cluster has to answer


def each_done_by_cluster(
    function: Callable[..., Any], tasks: Mapping[Any, Task], *, address: str
) -> Generator[tuple[Any, Any]]:
    """As `each_done`, by an existing Dask cluster, which runs a task again elsewhere when its worker dies.

    The tasks that the cluster gives up run again one at a time.
    Raises InputError where Dask is not installed, no cluster answers at the address or it goes away, or a worker has
    another version of fembearing.
    """
    try:
        from distributed import Client, as_completed
        from distributed.scheduler import KilledWorker
    except ImportError as problem:
        raise InputError(
            "--scheduler needs Dask, which is not installed: pip install 'fembearing[cluster]'"
        ) from problem
    place, here = f"--scheduler {address!r}", version("fembearing")
    logging.getLogger("distributed.client").setLevel(logging.CRITICAL)  # errors are reported here, in one line
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
                except KilledWorker:  # perhaps by another task of that worker
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
        except (ImportError, RuntimeError) as problem:  # raised by the scheduler, which reads the tasks too
            raise InputError(
                f"{place}: the cluster cannot read what it is sent; its scheduler needs fembearing {here} as here"
            ) from problem
