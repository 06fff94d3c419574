"""The command line: one file a command. `console` writes the results, `status` names the exit statuses.

`validate` checks Hertz: its tolerance is the limit of the check. `contact` solves a contact: its tolerance is the
accuracy required of the finite elements, and the deviation of Hertz is shown, not checked.

A command's file is imported when the command runs, shows its help or is completed, so that `--help` stays quick.
"""

import gc
import sys
from dataclasses import dataclass
from importlib import import_module
from typing import Annotated, Any

import typer
from typer.core import TyperGroup

from fembearing.cli.boundary import DEBUG, guarded


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
    "film": Entry(
        "film",
        "Solve the lubricated contact of a ball on a race and compare the formulas of film and rolling with it.",
        'film bearing.toml --pair inner --load "372 N" --speed "500 rpm" --tolerance "1 %"',
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
    "schema": Entry(
        "schema",
        "Print the JSON Schema of a file: scene and grid, by which editors complete keys, or a JSON result.",
        "schema grid",
    ),
    "warmup": Entry(
        "warmup",
        "Compile the formulas of ordinary scenes, so that later commands need not.",
        "warmup",
    ),
}
# Between two searches for garbage: imports make many objects, all of which stay. It saves a tenth of a second.
OBJECTS = 100_000
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


STATUSES = """Exit status: 0 done, all verdicts hold; 1 a check failed; 2 the input is at fault; 3 not solved to the
accuracy, or a verdict is not known; 70 a defect of fembearing; 71 not enough memory; 74 a file or stream cannot be
written or read; 130, 141, 143 ended by Ctrl-C, a closed pipe, a signal."""
app = typer.Typer(
    cls=OnDemand,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog=STATUSES,
    **PLAIN,
)
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
    debug: Annotated[bool, typer.Option("--debug", help="Show where in the code a failure is.")] = False,
) -> None:
    """Friction and contact of a ball bearing: closed forms, checked by finite elements."""
    DEBUG.set(debug)


def main() -> None:
    """Run the command line; `boundary` has what becomes of failures."""
    gc.set_threshold(OBJECTS)
    sys.exit(guarded(lambda: app(standalone_mode=False)))
