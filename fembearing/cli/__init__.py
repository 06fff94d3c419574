"""The command line: one file a command. `console` writes the results, `status` names the exit statuses.

`validate` checks Hertz: its tolerance is the limit of the check. `contact` solves a contact: its tolerance is the
accuracy required of the finite elements, and the deviation of Hertz is shown, not checked.

What a command computes with is imported in its function, so that `--help` stays quick.
"""

import atexit
import gc
import os
import sys
from collections.abc import Callable
from typing import Annotated, Any

import typer

from analytic.processes import ignore_settings
from fembearing.cli import (
    compare,
    contact,
    cost,
    creep,
    draw,
    duty,
    export,
    film,
    init,
    listing,
    sweep,
    torque,
    validate,
)
from fembearing.cli.app import app as page
from fembearing.cli.boundary import guarded
from fembearing.cli.options import with_groups

_COMMANDS: dict[str, tuple[Callable[..., None], str]] = {  # with an example of what follows the name
    "validate": (validate.validate, 'bearing.toml --tolerance "1 %" --out report-of-my-bearing'),
    "torque": (torque.torque, "6308 --radial-load 3kN --speed 3000rpm --oil 'ISO VG 68' --temperature 60C"),
    "app": (page, "--port 8081"),
    "compare": (compare.compare, "bearing.toml data.csv --out comparison-of-my-bearing"),
    "duty": (duty.duty, "6308 cycle.csv --oil 'ISO VG 68' --out losses-of-my-cycle"),
    "contact": (contact.contact, '--pair inner --load "620 N" --tolerance "0.1 %"'),
    "film": (film.film, 'bearing.toml --pair inner --load "372 N" --speed "500 rpm" --tolerance "1 %"'),
    "creep": (creep.creep, 'bearing.toml --friction 0.1 --tolerance "1 %" --out friction-of-my-bearing'),
    "draw": (draw.draw, "6206 --out drawing-of-6206.svg"),
    "cost": (cost.cost, 'bearing.toml --tolerance "1 %" --out cost-of-my-bearing'),
    "sweep": (sweep.sweep, "map.toml --out map-of-my-bearing"),
    "export": (export.export, "6206 --to fmu --radial-load '500 N to 5 kN in 7' --out my-bearing.fmu"),
    "init": (init.init, "6206 --out my-bearing.toml"),
    "list": (listing.listing, "bearings 62"),
}
COMMANDS = {name: (with_groups(function), example) for name, (function, example) in _COMMANDS.items()}
# Between two searches for garbage: imports make many objects, all of which stay. It saves a tenth of a second.
OBJECTS = 500_000
STATUSES = """Exit status: 0 done, no check failed; 1 a check failed; 2 input error; 3 required accuracy not reached, or
a verdict not known; 70 defect of fembearing; 71 out of memory; 74 file or stream not readable or writable; 130, 141,
143 ended by Ctrl-C, a closed pipe, a signal."""
app = typer.Typer(
    invoke_without_command=True,
    context_settings={"help_option_names": ["-h", "--help"]},
    epilog=STATUSES,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,  # help without rich, which is slow
)
for _name, (_function, _example) in COMMANDS.items():
    _summary = " ".join(str(_function.__doc__).partition("\n\n")[0].split())
    app.command(_name, short_help=_summary, epilog=f"Example: fembearing {_name} {_example}".rstrip())(_function)


def print_version(wanted: bool) -> None:
    if wanted:
        from importlib.metadata import version

        typer.echo(f"fembearing {version('fembearing')}")
        raise typer.Exit


@app.callback()
def about(
    context: typer.Context,
    _version: Annotated[
        bool, typer.Option("--version", is_eager=True, callback=print_version, help="Print the version and exit.")
    ] = False,
    _debug: Annotated[bool, typer.Option("--debug", help="Print a traceback on failure.")] = False,
) -> None:
    """Friction and contact of a ball bearing: closed forms, checked by finite elements."""
    if context.invoked_subcommand is None:
        typer.echo(context.get_help())


def main() -> None:
    """Run the command line; `boundary` has what becomes of failures."""
    # Before NumPy is loaded: the threads of its BLAS take 0.3 s of the processor to start, and solvers use one.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    ignore_settings()
    gc.set_threshold(OBJECTS)
    atexit.register(gc.freeze)  # at its end Python would search all objects once more, for up to 0.2 s
    sys.exit(guarded(lambda: app(standalone_mode=False)))


def command_of(name: str) -> Any:
    """The command itself, with its options."""
    group: Any = typer.main.get_command(app)
    return group.commands[name]
