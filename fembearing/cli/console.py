"""Where the commands write: results on standard output, a bar of the progress on standard error."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import typer
from rich.console import Console

from fembearing.cli.status import PIPE_CLOSED, close_output
from fembearing.progress import silent


class Output(Console):
    """Standard output.

    Where its reader closes the pipe, Rich would end with status 1. Here that status means that a check failed.
    """

    def on_broken_pipe(self) -> None:
        close_output()
        raise typer.Exit(PIPE_CLOSED)


out, err = Output(highlight=False), Console(stderr=True)


@contextmanager
def shown_progress() -> Iterator[Callable[[float, str], None]]:
    """A bar with the time left on standard error, if that is a terminal."""
    if not err.is_terminal:
        yield silent
        return
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, console=err, transient=True) as bar:
        task = bar.add_task("starting", total=1.0)
        yield lambda share, step: bar.update(task, completed=share, description=step)


def print_json(content: dict[str, Any]) -> None:
    out.out(json.dumps(content, indent=1, allow_nan=False))
