"""One call under watch: what it may do, how long it may take, and how much memory.

A call ends well with a result, or with a FembearingError of one clear line. Anything else is a fault: another
exception, a warning, too much time or memory, or an attempt to run a program, to unpickle, to reach the network or to
write a file. Processes of their own make the calls: one that dies or hangs in machine code costs one call.
"""

import faulthandler
import multiprocessing
import resource
import signal
import sys
import time
import warnings
from collections.abc import Callable, Generator, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing.connection import Connection, wait
from typing import Any, cast

import numpy as np

from analytic.errors import ConvergenceError, FembearingError
from analytic.numerics import machine_code
from fembearing.check.memory import peak_memory, peak_while

ADDRESSES = 8_000_000_000  # bytes: a call that takes all memory becomes a fault and does not stop the machine
SLOWEST = 10.0  # s of the processor
DEAF = 300.0  # s of the clock, after which a process that does not even hear its signal is ended
LARGEST = 1e9  # bytes above the memory before
LONGEST = 1000  # characters of an error message
FORBIDDEN = (
    *("os.system", "os.exec", "os.fork", "os.posix_spawn", "subprocess.Popen", "pickle.find_class", "socket.connect"),
)
FIRST_USES = (machine_code.__file__, "<frozen importlib._bootstrap>")  # whose actions are not those of the call
GOOD = ("done", "refused", "not solved")


class TooSlowError(BaseException):
    """The time limit; not an Exception, so that no reader takes it for a broken file."""


class ForbiddenError(BaseException):
    """An action that the call must not cause."""


class SilentError(Exception):
    """A number that is not finite, and for which no reason is given."""


@dataclass(frozen=True)
class Tried:
    """One call."""

    kind: str  # of input
    seed: int
    outcome: str  # one of GOOD, or the fault
    seconds: float  # of the processor
    memory: float  # bytes above those at the start of the process, at most
    content: bytes = b""  # of the input, where there is a fault

    @property
    def is_fault(self) -> bool:
        return self.outcome not in GOOD


@dataclass(frozen=True)
class Input:
    """An input, and what is done with it."""

    kind: str
    content: bytes
    run: Callable[[], object]


def tried(make: Callable[[int], Input], seeds: Iterable[int], *, jobs: int = 1) -> Generator[Tried]:
    """Make the input of each seed and run it, in `jobs` processes."""
    context = multiprocessing.get_context("fork")
    # In order, as every so many seeds make one kind of input, which may take longer than others.
    ahead = {number: part.tolist() for number, part in enumerate(np.array_split(list(seeds), jobs))}
    at_work: dict[Connection, tuple[int, Any]] = {}

    def start(number: int) -> None:
        if ahead[number]:
            receiver, sender = context.Pipe(duplex=False)
            process = context.Process(target=_work, args=(make, ahead[number], sender), daemon=True)
            process.start()
            sender.close()
            at_work[receiver] = number, process

    for number in ahead:
        start(number)
    try:
        while at_work:
            for receiver in cast("list[Connection]", wait([*at_work])):
                number, process = at_work[receiver]
                try:
                    result = receiver.recv()
                except EOFError:
                    del at_work[receiver]
                    process.join()
                    if ahead[number]:
                        seed = ahead[number].pop(0)
                        yield Tried("unknown", seed, f"the process ended with status {process.exitcode}", 0.0, 0.0)
                        start(number)
                else:
                    ahead[number].remove(result.seed)
                    yield result
    finally:
        for _, process in at_work.values():  # of results that nobody waits for
            process.terminate()
            process.join()


def _work(make: Callable[[int], Input], seeds: list[int], sender: Connection) -> None:
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESSES, ADDRESSES))
    base = peak_memory() or 0
    for seed in seeds:
        faulthandler.dump_traceback_later(DEAF, exit=True)
        given = make(seed)
        begun = time.process_time()
        outcome, peak = peak_while(lambda: outcome_of(given.run))  # noqa: B023 - called at once
        seconds, memory = time.process_time() - begun, (peak or 0) - base
        if outcome in GOOD and memory > LARGEST:
            outcome = f"{memory / 1e6:.0f} MB"
        content = b"" if outcome in GOOD else given.content
        sender.send(Tried(given.kind, seed, outcome, seconds, memory, content))
    faulthandler.cancel_dump_traceback_later()


def outcome_of(run: Callable[[], object]) -> str:
    """One of GOOD, or the fault."""
    try:
        with limited():
            run()
    except FembearingError as refusal:
        words = str(refusal)
        if "\n" in words or not 0 < len(words) < LONGEST or not words.isprintable():
            return f"an unclear error: {words!r:.300}"
        return "not solved" if isinstance(refusal, ConvergenceError) else "refused"
    except (Exception, TooSlowError, ForbiddenError) as problem:
        return f"{type(problem).__name__}: {' '.join(str(problem).split()):.200}"
    return "done"


_limiting = False


def _audit(event: str, arguments: tuple[Any, ...]) -> None:
    forbidden = event in FORBIDDEN or (event == "open" and _writes(*arguments[:2]))
    if _limiting and forbidden and not _is_first_use():
        raise ForbiddenError(f"{event} {arguments!r:.100}")


def _writes(path: Any, mode: Any) -> bool:
    """Whether a call of open writes; compiled code of Python itself does not count."""
    return isinstance(mode, str) and any(letter in mode for letter in "wax+") and "__pycache__" not in str(path)


def _is_first_use() -> bool:
    """Whether the call imports a module, or compiles a formula, which is kept."""
    frame = sys._getframe()
    while frame is not None and frame.f_code is not outcome_of.__code__:
        if frame.f_code.co_filename in FIRST_USES:
            return True
        frame = frame.f_back
    return False


sys.addaudithook(_audit)


@contextmanager
def limited() -> Iterator[None]:
    """Turn warnings into errors, limit the time, and forbid the actions above."""
    global _limiting

    def stop(*_: object) -> None:
        if not _is_first_use():
            raise TooSlowError(f"more than {SLOWEST:g} s")
        signal.setitimer(signal.ITIMER_PROF, SLOWEST)  # a formula is compiled once; the call has all its time after it

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, SLOWEST)
    _limiting = True
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            yield
    finally:
        _limiting = False
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)
