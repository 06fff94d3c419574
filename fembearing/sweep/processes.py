"""Tasks in processes of this machine, each with one thread; when one dies, no other task is lost.

Each process runs this module. Tasks come by its standard input and results leave by its standard output, so that no
port is open. It ends with its standard input, and so with the process that started it, however that ends.
"""

import os
import pickle
import signal
import subprocess
import sys
from collections.abc import Callable, Generator, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor, as_completed
from contextlib import contextmanager, suppress
from queue import SimpleQueue
from threading import Thread, local
from typing import IO, Any

from analytic.errors import FembearingError, ResourceError
from analytic.processes import MODULE, environment

ENVIRONMENT = {  # where the user has not set it
    **dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1"),
    # Of glibc: freed arrays go back to the system. Without these lines a process of contacts keeps 70 MB more.
    **dict.fromkeys(("MALLOC_TRIM_THRESHOLD_", "MALLOC_MMAP_THRESHOLD_"), "8000000"),
    "MALLOC_ARENA_MAX": "1",
}
GONE = (EOFError, OSError, pickle.UnpicklingError)  # what a pipe says whose other end is no more

Compute = Callable[[Sequence[Any]], Generator[tuple[Any, Any]]]  # every task with its result, as it is finished


class LostWorkerError(FembearingError):
    """A process ended in the middle of a task, each time that the task was tried."""

    def __init__(self) -> None:
        super().__init__(
            "every process that took it was ended by the system, as one that takes too much memory is, or killed; free "
            "some memory, or compute it on a larger machine"
        )


@contextmanager
def processes_here(function: Callable[[Any], Any], count: int) -> Iterator[Compute]:
    """`count` processes, which end with the block, however it is left.

    The result of a task whose process dies is a LostWorkerError. What the function raises is raised.
    Raises ResourceError where a process cannot start.
    """
    processes, threads = _Processes(function), ThreadPoolExecutor(count)  # each thread waits for its process

    def compute(tasks: Sequence[Any]) -> Generator[tuple[Any, Any]]:
        running = {threads.submit(processes.result, task): task for task in tasks}
        for future in as_completed(running):
            yield running.pop(future), future.result()

    try:
        yield compute
    finally:
        threads.shutdown(wait=False, cancel_futures=True)
        processes.kill()
        threads.shutdown()
        processes.close()


class _Processes:
    """One process for each thread that asks for a result, started at the first."""

    def __init__(self, function: Callable[[Any], Any]) -> None:
        self._function, self._own = function, local()
        self._started: list[subprocess.Popen[bytes]] = []
        self._is_over = False

    def result(self, task: Any) -> Any:
        """What the function makes of the task, or a LostWorkerError."""
        process = self._own.process = getattr(self._own, "process", None) or self._start()
        try:
            found = _asked(process, task)
        except GONE:
            self._own.process = None
            return LostWorkerError()
        if isinstance(found, Exception):
            raise found
        return found

    def kill(self) -> None:
        """End the processes, with those that a thread is about to start."""
        self._is_over = True
        for process in self._started:
            process.kill()

    def close(self) -> None:
        """Close the pipes of killed processes."""
        for process in self._started:
            with suppress(BrokenPipeError), process:  # of half a task that nobody took
                pass

    def _start(self) -> subprocess.Popen[bytes]:
        try:
            process = subprocess.Popen(
                [*MODULE, __name__],
                env=ENVIRONMENT | environment(),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                start_new_session=True,  # Ctrl-C is for the process that has them
            )
            self._started.append(process)
            if self._is_over:
                process.kill()
            _asked(process, self._function)
        except GONE as problem:
            raise ResourceError(
                "the processes that compute end as soon as they start; free some memory: finished points are kept, and "
                "the same command continues"
            ) from problem
        return process


def _asked(process: "subprocess.Popen[bytes]", given: Any) -> Any:
    """What the process answers. Raises one of GONE where it has ended."""
    assert process.stdin is not None
    assert process.stdout is not None
    _send(process.stdin, given)
    return pickle.load(process.stdout)


def _send(pipe: IO[bytes], content: Any) -> None:
    pipe.write(pickle.dumps(content))
    pipe.flush()


def work() -> None:
    """Answer the function, which comes first, by nothing, and each task by its result, or by what is raised."""
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what a library prints is no answer
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Windows has no sessions
    function, tasks = pickle.load(sys.stdin.buffer), SimpleQueue[Any]()
    Thread(target=_receive, args=(tasks,), daemon=True).start()
    found: Any = None
    while True:
        with suppress(BrokenPipeError):  # `_receive` sees that too
            _send(answers, found)
        try:
            found = function(tasks.get())
        except Exception as problem:
            found = problem


def _receive(tasks: SimpleQueue[Any]) -> None:
    """Pass tasks on until there are no more; then end the process in the middle of its work."""
    try:
        while True:
            tasks.put(pickle.load(sys.stdin.buffer))
    finally:
        os._exit(0)


if __name__ == "__main__":
    work()
