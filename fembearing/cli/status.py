"""Exit statuses, and complaints on standard error.

0 done and all verdicts hold, 1 a comparison or a physical limit fails, 2 the input is at fault, 3 not solved to the
required accuracy, or a physical verdict is not known.
"""

import errno
import os
import sys

import typer

DONE, CHECK_FAILED, INPUT_AT_FAULT, NOT_SOLVED = 0, 1, 2, 3
STATUS = {"pass": DONE, "fail": CHECK_FAILED, "undecided": NOT_SOLVED}  # of a result's verdicts together
INTERRUPTED, PIPE_CLOSED, TERMINATED = 130, 141, 143  # what a shell makes of the three signals
OUTPUT_FULL = (errno.ENOSPC, errno.EDQUOT, errno.EFBIG, errno.EIO)  # standard output takes no more


def close_output() -> None:
    """Discard what is still buffered: Python would complain about it when it ends."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def complain(problem: object, status: int) -> int:
    """Write a problem in one line on standard error; the status, for `sys.exit`."""
    words = " ".join(str(problem).split())
    if words:  # empty where typer printed the help
        typer.echo(f"fembearing: {words}", err=True)
    return status


def print_warnings(warnings: tuple[str, ...]) -> None:
    for warning in warnings:
        typer.echo(f"fembearing: warning: {warning}", err=True)
