"""What the commands write: results on standard output, progress and complaints on standard error, and a status.

Exit status: 0 done and all verdicts hold, 1 a comparison or a physical limit fails, 2 the input is at fault, 3 not
solved to the required accuracy, or a physical verdict is not known.
"""

import errno
import json
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import typer
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

DONE, CHECK_FAILED, INPUT_AT_FAULT, NOT_SOLVED = 0, 1, 2, 3
STATUS = {"pass": DONE, "fail": CHECK_FAILED, "undecided": NOT_SOLVED}  # of a result's verdicts together
INTERRUPTED, PIPE_CLOSED, TERMINATED = 130, 141, 143  # what a shell makes of the three signals
OUTPUT_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)  # standard output takes no more


class Output(Console):
    """Standard output.

    Where its reader closes the pipe, Rich would end with status 1. Here that status means that a check failed.
    """

    def on_broken_pipe(self) -> None:
        close_output()
        raise typer.Exit(PIPE_CLOSED)


out, err = Output(highlight=False), Console(stderr=True)


def close_output() -> None:
    """Discard what is still buffered: Python would complain about it when it ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(problem: object, status: int) -> int:
    """Write a problem in one line on standard error; the status, for `sys.exit`."""
    words = " ".join(str(problem).split())
    if words:  # empty where typer printed the help
        typer.echo(f"fembearing: {words}", err=True)
    return status


@contextmanager
def shown_progress() -> Iterator[Callable[[float, str], None]]:
    """A bar with the time left on standard error, if that is a terminal."""
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, console=err, transient=True, disable=not err.is_terminal) as bar:
        task = bar.add_task("starting", total=1.0)
        yield lambda share, step: bar.update(task, completed=share, description=step)


def print_json(content: dict[str, Any]) -> None:
    out.out(json.dumps(content, indent=1, allow_nan=False))


def print_warnings(warnings: tuple[str, ...]) -> None:
    for warning in warnings:
        typer.echo(f"fembearing: warning: {warning}", err=True)
