"""Where the commands write: results on standard output, a bar of the progress on standard error."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from rich.console import Console

from fembearing.progress import silent


class Stream(Console):
    """A stream whose closed pipe is a failure as any other; Rich would end the command with status 1."""

    def on_broken_pipe(self) -> None:
        raise  # the error that is being handled


out, err = Stream(highlight=False), Stream(stderr=True)


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
