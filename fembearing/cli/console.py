"""Where the commands write: results on standard output, the progress on standard error."""

import json
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import Any

from rich.console import Console

from analytic.progress import Progress, silent
from fembearing.cli.status import say


class Stream(Console):
    """A stream whose closed pipe is a failure as any other; Rich would end the command with status 1."""

    def on_broken_pipe(self) -> None:
        raise  # the error that is being handled

    def tell(self, text: str) -> None:
        """Print a text as it is."""
        self.print(text, soft_wrap=True, markup=False)


out, err = Stream(highlight=False), Stream(stderr=True)


@contextmanager
def shown_progress(*, quiet: bool, verbose: bool) -> Iterator[Callable[[float, str], None]]:
    """A bar with the time left on standard error, if that is a terminal.

    A verbose command says each step and its time instead, and a quiet one nothing.
    """
    if verbose:
        begin = time.perf_counter()
        yield _said_steps(begin)
        say(f"{time.perf_counter() - begin:.1f} s in all")
        return
    if quiet or not err.is_terminal:
        yield silent
        return
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn, TimeRemainingColumn

    columns = (TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn(), TimeRemainingColumn())
    with Progress(*columns, console=err, transient=True) as bar:
        task = bar.add_task("starting", total=1.0)

        def update(share: float, step: str) -> None:
            bar.update(task, completed=share, description=step)

        yield update


def _said_steps(begin: float) -> Progress:
    """Progress in lines, one for each step; begin : s, on the clock of `time.perf_counter`."""
    last = [""]

    def tell(share: float, step: str) -> None:
        if step != last[0]:
            last[0] = step
            say(f"{time.perf_counter() - begin:.1f} s, {share:.0%} done: {step}")

    return tell


def tell_assumed(assumed: Mapping[str, str], *, before: str = "", change: str = "with --set KEY=VALUE") -> None:
    """Print what the scene of a bearing assumes, and how to change it; nothing where it assumes nothing."""
    if assumed:
        words = ", ".join(f"{key} = {value}" for key, value in assumed.items())
        out.tell(f"{before}assumed: {words}; change {change}")


def print_json(content: dict[str, Any]) -> None:
    out.out(json.dumps(content, indent=1, allow_nan=False))
