"""The command line: one file a command. `console` writes the results, `status` names the exit statuses.

`validate` checks Hertz: its tolerance is the limit of the check. `contact` solves a contact: its tolerance is the
accuracy required of the finite elements, and the deviation of Hertz is shown, not checked.

A command's file is imported when the command runs, shows its help or is completed, so that `--help` stays quick.
"""

import signal
import sys
from dataclasses import dataclass
from importlib import import_module
from typing import Annotated, Any

import typer
from typer.core import TyperGroup
from typer.exceptions import Abort, TyperException

from fembearing.cli.status import (
    INPUT_AT_FAULT,
    INTERRUPTED,
    NOT_SOLVED,
    OUTPUT_FULL,
    PIPE_CLOSED,
    TERMINATED,
    close_output,
    complain,
)

PYDANTICS = "Value error, "  # how typer's message about a word begins where pydantic reads it


@dataclass(frozen=True)
class Entry:
    """A command before its file is imported."""

    file: str  # in this folder, and the function in it
    summary: str  # first line of the function's docstring
    example: str


COMMANDS = {
    "validate": Entry(
        "validate",
        "Check the contacts of a scene: what Hertz gives, what finite elements give, and the difference.",
        'validate bearing.toml --tolerance "1 %" --out report-of-my-bearing',
    ),
    "torque": Entry(
        "torque",
        "Friction torque of a scene by effect, and which effects were computed or left out.",
        'torque bearing.toml --tolerance "1 %" --out torque-of-my-bearing',
    ),
    "contact": Entry(
        "contact",
        "Solve one contact and compare Hertz with it; repeat --load for a series of loads with its stiffness law.",
        'contact --pair inner --load "620 N" --tolerance "0.1 %"',
    ),
    "cost": Entry(
        "cost",
        "Measure error and time of every method to compute the same quantity, cheap to exact, on this machine.",
        'cost bearing.toml --tolerance "1 %" --out cost-of-my-bearing',
    ),
    "sweep": Entry(
        "sweep",
        "Compute a scene at every point of a product of axes; a stopped sweep continues when it is started again.",
        "sweep map.toml --out map-of-my-bearing",
    ),
    "report": Entry(
        "report",
        "Make the page of a report again from its numbers and the pictures in the same folder.",
        "report report-of-my-bearing/report.json --out for-my-customer.html",
    ),
    "mesh": Entry(
        "mesh",
        "Write the two meshes of a contact and report their worst cells.",
        "mesh --pair inner --level 2 --out meshes-of-the-inner-race",
    ),
    "init": Entry(
        "init",
        "Write the scene of a bearing of the catalogue, ready to run and to edit. No file is replaced.",
        "init 6206 --out my-bearing.toml",
    ),
    "list": Entry(
        "listing",
        "List what a scene may name: bearings of the catalogue, oils, materials, built-in scenes, effects.",
        "list bearings 62",
    ),
}
PLAIN: dict[str, Any] = {
    "pretty_exceptions_enable": False,
    "rich_markup_mode": None,
}  # help without rich, which is slow


class OnDemand(TyperGroup):
    """Commands that stand for those in the files, until one of them is called."""

    def resolve_command(self, ctx: Any, args: list[str]) -> tuple[str | None, Any, list[str]]:
        name, command, rest = super().resolve_command(ctx, args)
        return name, command if name is None else command_of(name), rest


def command_of(name: str) -> Any:
    """The command itself."""
    entry = COMMANDS[name]
    alone = typer.Typer(add_completion=False, **PLAIN)
    function = getattr(import_module(f"fembearing.cli.{entry.file}"), entry.file)
    alone.command(name, epilog=f"Example: fembearing {entry.example}")(function)
    return typer.main.get_command(alone)


def _stand_in() -> None: ...


app = typer.Typer(cls=OnDemand, no_args_is_help=True, context_settings={"help_option_names": ["-h", "--help"]}, **PLAIN)
for _name, _entry in COMMANDS.items():
    app.command(_name, short_help=_entry.summary)(_stand_in)


def print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        typer.echo(f"fembearing {version('fembearing')}")
        raise typer.Exit


@app.callback()
def about(
    _version: Annotated[
        bool, typer.Option("--version", is_eager=True, callback=print_version, help="Show the version and end.")
    ] = False,
) -> None:
    """Friction and contact of a ball bearing: closed forms, checked by finite elements."""


def main() -> None:
    """Run the command line. A user's mistake gives one line; any other error is our bug and keeps its traceback."""
    if sys.stdout is None:
        sys.exit(complain("standard output is closed; give the result somewhere to go", INPUT_AT_FAULT))
    signal.signal(signal.SIGTERM, end)
    try:
        status = app(standalone_mode=False)
        sys.stdout.flush()
    except Exception as problem:
        status = status_of(problem)
    sys.exit(status)


def end(*_: object) -> None:
    """Leave by an exception, which cleans up as a signal does not. A second signal does not interrupt the clean-up."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    sys.exit(TERMINATED)


def status_of(problem: Exception) -> int:
    """The exit status of a problem, which is said in one line. Raises an exception that is our bug again."""
    from analytic.errors import ConvergenceError, FembearingError  # with NumPy

    match problem:
        case ConvergenceError():
            return complain(problem, NOT_SOLVED)
        case FembearingError():
            return complain(problem, INPUT_AT_FAULT)
        case TyperException():
            return complain(problem.format_message().replace(PYDANTICS, ""), INPUT_AT_FAULT)
        case Abort():
            return INTERRUPTED
        case BrokenPipeError():
            close_output()
            return PIPE_CLOSED
        case OSError() if problem.errno in OUTPUT_FULL:
            close_output()
            return complain(f"cannot write the result: {problem.strerror}; check where it goes", INPUT_AT_FAULT)
    raise problem
