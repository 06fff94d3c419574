"""The command line: one file a command. `console` writes the results and names the exit statuses.

`validate` checks Hertz: its tolerance is the limit of the check. `contact` solves a contact: its tolerance is the
accuracy required of the finite elements, and the deviation of Hertz is shown, not checked.

The commands import the solver and the pictures when they run, so that `--help` stays quick.
"""

import signal
import sys
from importlib.metadata import version
from typing import Annotated

import typer
from typer.exceptions import Abort, TyperException

from analytic.errors import ConvergenceError, FembearingError
from fembearing.cli.console import (
    INPUT_AT_FAULT,
    INTERRUPTED,
    NOT_SOLVED,
    OUTPUT_FULL,
    PIPE_CLOSED,
    TERMINATED,
    close_output,
    complain,
)
from fembearing.cli.contact import contact
from fembearing.cli.cost import cost
from fembearing.cli.init import init
from fembearing.cli.listing import listing
from fembearing.cli.mesh import mesh
from fembearing.cli.report import report
from fembearing.cli.sweep import sweep
from fembearing.cli.torque import torque
from fembearing.cli.validate import validate

PYDANTICS = "Value error, "  # how typer's message about a word begins where pydantic reads it
EXAMPLES = {
    validate: 'validate bearing.toml --tolerance "1 %" --out report-of-my-bearing',
    torque: 'torque bearing.toml --tolerance "1 %" --out torque-of-my-bearing',
    contact: 'contact --pair inner --load "620 N" --tolerance "0.1 %"',
    cost: 'cost bearing.toml --tolerance "1 %" --out cost-of-my-bearing',
    sweep: "sweep map.toml --out map-of-my-bearing",
    report: "report report-of-my-bearing/report.json --out for-my-customer.html",
    mesh: "mesh --pair inner --level 2 --out meshes-of-the-inner-race",
    init: "init 6206 --out my-bearing.toml",
    listing: "list bearings 62",
}

app = typer.Typer(
    no_args_is_help=True, pretty_exceptions_enable=False, context_settings={"help_option_names": ["-h", "--help"]}
)
for command, example in EXAMPLES.items():
    app.command(example.split()[0], epilog=f"Example: fembearing {example}")(command)


def print_version(wanted: bool) -> None:
    if wanted:
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
    except ConvergenceError as problem:
        status = complain(problem, NOT_SOLVED)
    except (FembearingError, TyperException) as problem:
        words = problem.format_message() if isinstance(problem, TyperException) else str(problem)
        status = complain(words.replace(PYDANTICS, ""), INPUT_AT_FAULT)
    except Abort:
        status = INTERRUPTED
    except BrokenPipeError:
        close_output()
        status = PIPE_CLOSED
    except OSError as problem:
        if problem.errno not in OUTPUT_FULL:
            raise
        close_output()
        status = complain(f"cannot write the result: {problem.strerror}; check where it goes", INPUT_AT_FAULT)
    sys.exit(status)


def end(*_: object) -> None:
    """Leave by an exception, which cleans up as a signal does not. A second signal does not interrupt the clean-up."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    sys.exit(TERMINATED)
