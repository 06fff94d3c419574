"""What the commands write: results on standard output, progress and complaints on standard error, and a status.

Exit status: 0 done and within tolerance, 1 done but a check failed, 2 the input is at fault, 3 could not be solved to
the asked accuracy.
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
INTERRUPTED, PIPE_CLOSED, TERMINATED = 130, 141, 143  # what a shell makes of the three signals
NO_ROOM = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)  # standard output can take no more


class Output(Console):
    """Standard output. Rich would end with status 1 when the reader goes away, and that means a failed check here."""

    def on_broken_pipe(self) -> None:
        close_output()
        raise typer.Exit(PIPE_CLOSED)


out, err = Output(), Console(stderr=True)


def close_output() -> None:
    """Let what is still buffered go nowhere: Python would complain of it on its way out."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(problem: object, status: int) -> int:
    words = " ".join(str(problem).split())
    if words:  # typer has none where it printed the help
        typer.echo(f"fembearing: {words}", err=True)
    return status


@contextmanager
def shown_progress() -> Iterator[Callable[[float, str], None]]:
    """A bar on standard error with the time left; silent where that is no terminal."""
    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, console=err, transient=True, disable=not err.is_terminal) as bar:
        task = bar.add_task("starting", total=1.0)
        yield lambda share, step: bar.update(task, completed=share, description=step)


def print_json(content: dict[str, Any]) -> None:
    out.out(json.dumps(content, indent=1, allow_nan=False), highlight=False)


def print_warnings(warnings: tuple[str, ...]) -> None:
    for warning in warnings:
        typer.echo(f"fembearing: warning: {warning}", err=True)
