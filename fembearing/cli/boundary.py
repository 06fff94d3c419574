"""The outer boundary: every failure of every command ends here, in one line on standard error and an exit status.

Errors that a user can act on carry their own words (`analytic.errors`); what the system says gets words here; any other
exception is a defect of ours.
"""

import errno
import os
import signal
import sys
import traceback
import warnings
from collections.abc import Callable
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

TyperException: Any = BadParameter.__mro__[-4]  # base of typer's errors; older versions take that of click
ENDED = ("SIGTERM", "SIGHUP")  # signals by which a process is asked to end
# How libraries say that memory is short: the loader, and Python where a thread has no stack.
SHORT = ("failed to map segment", "annot allocate memory", "can't start new thread")
REMEDIES = ("ossible", "id you mean", "hoose from", "is not one of")  # as typer words them
OURS = tuple(str(Path(__file__).parents[2] / name) + os.sep for name in ("analytic", "fembearing"))


def guarded(run: Callable[[], int | None]) -> int:
    """The exit status of a command. Whatever fails in it, standard error gets one line for it."""
    if not _streams_are_open():
        return complain("standard output is closed; redirect it to a file or a pipe", NO_STORAGE)
    if not sys.warnoptions:
        warnings.simplefilter("ignore")  # of libraries, about what nobody but us can mend; ours are lines of the result
    for number in (getattr(signal, name) for name in ENDED if hasattr(signal, name)):
        if signal.getsignal(number) != signal.SIG_IGN:  # as nohup leaves it
            signal.signal(number, end)
    try:
        status = run() or 0
        sys.stdout.flush()
    except SystemExit as stop:
        if not isinstance(
            stop.__context__, BrokenPipeError
        ):  # for which Typer leaves with the status of a failed check
            raise
        status = PIPE_CLOSED
    except BaseException as problem:  # some libraries have failures that are no Exception
        if "--debug" in sys.argv and not isinstance(problem, BrokenPipeError):
            traceback.print_exception(problem)
        status = status_of(problem)
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


def status_of(problem: BaseException) -> int:
    """The exit status of a problem, which is said in one line."""
    from analytic import errors  # with NumPy

    said = f"{type(problem).__name__}: {problem}".removesuffix(": ")
    match problem:
        case BrokenPipeError():
            return PIPE_CLOSED
        case Abort() | KeyboardInterrupt():
            return INTERRUPTED
        case errors.FembearingError():
            kinds = ((errors.ConvergenceError, NOT_SOLVED), (errors.StorageError, NO_STORAGE))
            kinds += ((errors.ResourceError, NO_MEMORY), (errors.FembearingError, INPUT_AT_FAULT))
            return complain(problem, next(status for kind, status in kinds if isinstance(problem, kind)))
        case ModuleNotFoundError() if problem.name in errors.BROUGHT_BY:
            command = next((word for word in sys.argv[1:] if not word.startswith("-")), "fembearing")
            return complain(errors.MissingPackageError(command, problem.name), INPUT_AT_FAULT)
        case TyperException():
            return complain(_of_typer(problem), INPUT_AT_FAULT)
        case _ if (
            isinstance(problem, MemoryError)
            or getattr(problem, "errno", 0) == errno.ENOMEM
            or any(words in f"{problem} {problem.__context__}" for words in SHORT)
        ):
            remedy = "free some, raise its limit (ulimit -v), or give fewer points at a time"
            return complain(f"out of memory ({said}): {remedy}", NO_MEMORY)
        case OSError():
            place = "the result or another process" if problem.filename is None else repr(str(problem.filename))
            reason = problem.strerror or said
            return complain(
                f"{place} cannot be read or written: {reason}; check disk, folder and permissions", NO_STORAGE
            )
    frames = [frame for frame in traceback.extract_tb(problem.__traceback__) if frame.filename.startswith(OURS)]
    place = (
        f" ({Path(frames[-1].filename).relative_to(Path(__file__).parents[2])}:{frames[-1].lineno})" if frames else ""
    )
    report = "fembearing --debug shows where it is; please report that, as docs/commands.md says"
    return complain(f"a defect of fembearing, not of your input: {said}{place}; {report}", DEFECT)


def _of_typer(problem: Any) -> str:
    """What typer says of arguments and options, the commands that have an unknown option, and a remedy without one."""
    words = problem.format_message().replace("Value error, ", "").rstrip(".")  # how pydantic begins
    if problem.ctx is None:
        return words
    every = problem.ctx.find_root().command.commands
    option = getattr(problem, "option_name", None)
    having = [name for name, command in every.items() if any(option in each.opts for each in command.params)]
    if having:
        return f"{words}; {', '.join(having)} {'has' if len(having) == 1 else 'have'} it"
    if any(remedy in words for remedy in REMEDIES):
        return words
    example = problem.ctx.command.epilog
    return (
        f"{words}; {example.replace('Example:', 'for example') if problem.ctx.parent else 'fembearing -h lists them'}"
    )


def _streams_are_open() -> bool:
    """Whether standard output is; the others are made to lead nowhere, so that no file takes their place."""
    for number in range(3):
        try:
            os.fstat(number)
        except OSError:
            os.open(os.devnull, os.O_RDWR)  # takes the lowest number that is free
    if sys.stderr is None:
        sys.stderr = open(os.devnull, "w", encoding="utf-8")  # noqa: SIM115 - as long as the process
    if isinstance(sys.stdout, TextIOWrapper):
        sys.stdout.reconfigure(errors="backslashreplace")  # what the locale has no letter for
    return sys.stdout is not None
