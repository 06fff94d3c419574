"""The outer boundary: every failure of every command ends here, in one line on standard error and an exit status.

Errors that a user can act on carry their own words (`analytic.errors`); what the system says gets words here; any other
exception is a defect of ours.
"""

import errno
import os
import select
import signal
import sys
import traceback
import warnings
from collections.abc import Callable
from contextvars import ContextVar
from io import TextIOWrapper
from pathlib import Path
from typing import Any

from typer import Abort, BadParameter

from fembearing.cli.status import (
    DEFECT,
    INPUT_AT_FAULT,
    INTERRUPTED,
    NO_MEMORY,
    NO_STORAGE,
    NOT_SOLVED,
    PIPE_CLOSED,
    complain,
    discard,
)

DEBUG = ContextVar("DEBUG", default=False)  # whether a failure shows where in the code it is
COMMAND = ContextVar("COMMAND", default="fembearing")  # name of the one that runs
TyperException: Any = BadParameter.__mro__[-4]  # base of typer's errors; older versions take that of click
ENDED = ("SIGTERM", "SIGHUP")  # signals by which a process is asked to end
PYDANTICS = "Value error, "  # how typer's message about a word begins where pydantic reads it
OURS = ("analytic", "fembearing")
REPORT = "fembearing --debug shows where it is; please report that, as docs/commands.md says"


def guarded(run: Callable[[], int | None]) -> int:
    """The exit status of a command. Whatever fails in it, standard error gets one line for it."""
    if not _streams_are_open():
        return complain("standard output is closed; redirect it to a file or a pipe", NO_STORAGE)
    if not sys.warnoptions:
        warnings.simplefilter("ignore")  # of libraries, about what nobody but us can mend; ours are lines of the result
    for name in ENDED:
        if hasattr(signal, name) and signal.getsignal(getattr(signal, name)) != signal.SIG_IGN:  # as nohup leaves it
            signal.signal(getattr(signal, name), end)
    try:
        status = run() or 0
        sys.stdout.flush()
    except SystemExit as stop:
        if not isinstance(stop.__context__, BrokenPipeError):
            raise
        status = _failed(stop.__context__)  # Typer leaves with 1, which means that a check failed
    except BaseException as problem:  # some libraries have failures that are no Exception
        status = _failed(problem)
    for stream in (sys.stdout, sys.stderr):
        try:
            stream.flush()
        except OSError:  # said already, or there is nowhere to say it; Python would say it when it ends
            discard(stream)
    return status


def end(number: int, _frame: object) -> None:
    """Leave by an exception, which cleans up as a signal does not. A second signal does not interrupt the clean-up."""
    signal.signal(number, signal.SIG_IGN)
    sys.exit(128 + number)  # what a shell makes of the signal


def _failed(problem: BaseException) -> int:
    """The exit status of a problem, which is said; with --debug, where it is too."""
    is_quiet = isinstance(problem, BrokenPipeError) and _reader_is_gone()
    if DEBUG.get() and not is_quiet:
        traceback.print_exception(problem)
    return PIPE_CLOSED if is_quiet else status_of(problem)


def status_of(problem: BaseException) -> int:
    """The exit status of a problem, which is said in one line."""
    from analytic.errors import (  # with NumPy
        BROUGHT_BY,
        ConvergenceError,
        FembearingError,
        MissingPackageError,
        ResourceError,
        StorageError,
    )

    match problem:
        case ConvergenceError():
            return complain(problem, NOT_SOLVED)
        case StorageError():
            return complain(problem, NO_STORAGE)
        case ResourceError():
            return complain(problem, NO_MEMORY)
        case FembearingError():
            return complain(problem, INPUT_AT_FAULT)
        case ModuleNotFoundError() if problem.name in BROUGHT_BY:
            return complain(MissingPackageError(COMMAND.get(), problem.name), INPUT_AT_FAULT)
        case TyperException():
            words = problem.format_message().replace(PYDANTICS, "")
            if words.startswith("Missing argument"):
                from fembearing.cli import COMMANDS

                words = f"{words.rstrip('.')}; for example fembearing {COMMAND.get()} {COMMANDS[COMMAND.get()][1]}"
            nothing_near = words.startswith("No such option") and "ossible" not in words and "ean" not in words
            return complain(
                f"{words}; the command with -h lists its options" if nothing_near else words, INPUT_AT_FAULT
            )
        case Abort() | KeyboardInterrupt():
            return INTERRUPTED
        case _ if _lacks_memory(problem):
            return complain(
                f"out of memory ({_words(problem)}): free some, raise its limit (ulimit -v), or give fewer points at a "
                "time",
                NO_MEMORY,
            )
        case TimeoutError() | ConnectionError() if problem.filename is None:  # no file, but another process
            return complain(f"another process does not answer ({_words(problem)}): start the command again", NO_STORAGE)
        case OSError():
            return complain(_of_the_system(problem), NO_STORAGE)
    return complain(f"a defect of fembearing, not of your input: {_words(problem)}{_place(problem)}; {REPORT}", DEFECT)


def _streams_are_open() -> bool:
    """Whether standard output is; the others are made to lead nowhere, so that no file takes their place."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest number that is free
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 - as long as the process
    if sys.stdout is None:
        return False
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # what the locale has no letter for
    return True


def _reader_is_gone() -> bool:
    """Whether standard output or error is a pipe that nobody reads any more; True where the system does not say."""
    if not hasattr(select, "poll"):
        return True
    streams = select.poll()
    for number in (1, 2):
        streams.register(number, 0)  # what is wrong is said always
    return any(said & (select.POLLERR | select.POLLHUP) for _, said in streams.poll(0))


def _lacks_memory(problem: BaseException) -> bool:
    if isinstance(problem, MemoryError) or (isinstance(problem, OSError) and problem.errno == errno.ENOMEM):
        return True
    said = f"{problem} {problem.__context__}"  # of the loader of libraries, and of Python where a thread has no stack
    return isinstance(problem, ImportError | RuntimeError | OSError) and (
        "failed to map segment" in said or "cannot allocate memory" in said.lower() or "can't start new thread" in said
    )


def _of_the_system(problem: OSError) -> str:
    reason = problem.strerror or _words(problem)
    if problem.filename is not None:
        return f"{str(problem.filename)!r} cannot be read or written: {reason}; check its disk, folder and permissions"
    try:
        Path.cwd()
    except OSError:
        return "the working folder no longer exists; run the command in another one"
    return f"cannot write the result: {reason}; check the place of the output"


def _words(problem: BaseException) -> str:
    """The class and the text of an exception."""
    return f"{type(problem).__name__}: {problem}" if str(problem) else type(problem).__name__


def _place(problem: BaseException) -> str:
    """Where in our own files an exception comes from."""
    root = Path(__file__).parents[2]
    for frame in reversed(traceback.extract_tb(problem.__traceback__)):
        file = Path(frame.filename)
        if file.is_relative_to(root) and file.relative_to(root).parts[0] in OURS:
            return f" ({file.relative_to(root).as_posix()}:{frame.lineno})"
    return ""
