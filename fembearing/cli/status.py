"""Exit statuses, and complaints on standard error.

0 done and all verdicts hold, 1 a comparison or a physical limit fails, 2 the input is at fault, 3 not solved to the
required accuracy, or a physical verdict is not known; 70, 71 and 74 are those of sysexits.h.
"""

import os
import sys
from collections.abc import Iterable
from contextlib import suppress
from typing import TextIO

import typer

DONE, CHECK_FAILED, INPUT_AT_FAULT, NOT_SOLVED = 0, 1, 2, 3
STATUS = {"pass": DONE, "fail": CHECK_FAILED, "undecided": NOT_SOLVED}  # of a result's verdicts together
STANDING_STATUS = {  # of the word that says how far a torque can be trusted
    "fail": CHECK_FAILED,
    "incomplete": NOT_SOLVED,
    "undecided": NOT_SOLVED,
    "check": DONE,
}
DEFECT, NO_MEMORY, NO_STORAGE = 70, 71, 74
INTERRUPTED, PIPE_CLOSED = 130, 141  # what a shell makes of the two signals


def discard(stream: TextIO) -> None:
    """Discard what is still buffered, and all that follows: Python would complain about it when it ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


def say(line: str) -> None:
    """Write a line on standard error. Where that takes no more, the line is lost, and the result is not."""
    try:
        typer.echo(f"fembearing: {line}", err=True)
    except OSError:
        with suppress(OSError):
            discard(sys.stderr)


def complain(problem: object, status: int) -> int:
    """Write a problem in one line on standard error; the status, for `sys.exit`."""
    words = " ".join(str(problem).split())
    if words:  # empty where typer printed the help
        say(words)
    return status


def reached(accuracy: float, quantity: str, uncertainty: float) -> int:
    """Whether a relative uncertainty is within the accuracy; a line on standard error says if it is not."""
    if uncertainty <= accuracy:
        return DONE
    from analytic.words import percent_of

    return complain(
        f"not solved to {percent_of(accuracy, 2)}: the {quantity.replace('_', ' ')} has an uncertainty of "
        f"{percent_of(uncertainty, 2)}; give a larger --tolerance",
        NOT_SOLVED,
    )


def print_warnings(warnings: Iterable[str]) -> None:
    """Say warnings."""
    for warning in warnings:
        say(f"warning: {warning}")
