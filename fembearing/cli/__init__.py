"""The command line. What it writes where, and the exit status: `fembearing.cli.console`.

`validate` checks Hertz: its tolerance is the limit of the check. `contact` solves a contact: its tolerance is the
accuracy asked of the finite elements, and how far Hertz is off is shown, not checked.
"""

import signal
import sys
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.box import SIMPLE_HEAD
from rich.table import Table
from typer.exceptions import Abort, TyperException

from analytic.errors import ConvergenceError, FembearingError, InputError
from analytic.scene import Scene
from analytic.scenefile.read import builtin_scene, load_scene
from fembearing.cli.console import (
    CHECK_FAILED,
    DONE,
    INPUT_AT_FAULT,
    INTERRUPTED,
    NO_ROOM,
    NOT_SOLVED,
    PIPE_CLOSED,
    TERMINATED,
    close_output,
    complain,
    out,
    print_json,
    print_warnings,
    shown_progress,
)
from fembearing.cli.options import (
    LOAD,
    TOLERANCE,
    Accuracy,
    AsJson,
    Folder,
    Geometry,
    GeometryName,
    Load,
    Loads,
    PairName,
    ScenePath,
    Tolerance,
    read_option,
)
from fembearing.cli.report import EXAMPLE, report
from fembearing.cli.sweep import sweep

if TYPE_CHECKING:  # the solver takes a second to import: only the commands that solve pay for it
    from fembearing.compare.contact.verdict import Verdict

BUILTIN = "6205"

app = typer.Typer(no_args_is_help=True, add_completion=False, pretty_exceptions_enable=False)


def main() -> None:
    """Run the command line; a user's mistake is one line, anything else is our bug and keeps its traceback."""
    if sys.stdout is None:
        sys.exit(complain("standard output is closed; give the result somewhere to go", INPUT_AT_FAULT))
    signal.signal(signal.SIGTERM, end)
    try:
        status = app(standalone_mode=False)
        sys.stdout.flush()
    except ConvergenceError as problem:
        status = complain(problem, NOT_SOLVED)
    except (FembearingError, TyperException) as problem:
        status = complain(problem.format_message() if isinstance(problem, TyperException) else problem, INPUT_AT_FAULT)
    except Abort:
        status = INTERRUPTED
    except BrokenPipeError:
        close_output()
        status = PIPE_CLOSED
    except OSError as problem:
        if problem.errno not in NO_ROOM:
            raise
        close_output()
        status = complain(f"cannot write the result: {problem.strerror}; check where it goes", INPUT_AT_FAULT)
    sys.exit(status)


def end(*_: object) -> None:
    """An exception clears up on its way, the signal not; another signal does not stop that."""
    signal.signal(signal.SIGTERM, signal.SIG_IGN)
    sys.exit(TERMINATED)


@app.callback()
def about() -> None:
    """Friction and contact of a ball bearing: closed forms, checked by finite elements."""


@app.command(epilog='Example: fembearing validate bearing.toml --tolerance "1 %" --out report-of-my-bearing')
def validate(
    scene: ScenePath = None,
    tolerance: Tolerance = None,
    folder: Folder = None,
    hard: Annotated[bool, typer.Option("--hard", help="Run the table of hard cases too.")] = False,
    with_cost: Annotated[bool, typer.Option("--cost", help="Measure every way to compute each quantity too.")] = False,
    as_json: AsJson = False,
) -> None:
    """Check the contacts of a scene: what Hertz gives, what finite elements give, and the difference."""
    given = _scene(scene)
    asked = _tolerance(tolerance, given)
    from fembearing.report.document.build import report_of
    from fembearing.report.folder import validate as run
    from fembearing.report.terminal.validation import print_validation

    with shown_progress() as report:
        result = run(given, out=folder, tolerance=asked, hard=hard, cost=with_cost, progress=report)
    document = report_of(result)
    if as_json:
        print_json(document.to_json())
    else:
        print_validation(out, document)
        print_warnings(result.warnings)
        if folder is not None:
            out.print(f"report: {folder / 'report.html'}", highlight=False, soft_wrap=True, markup=False)
    raise typer.Exit(_status(result.verdict))


@app.command(epilog='Example: fembearing torque bearing.toml --tolerance "1 %" --out torque-of-my-bearing')
def torque(
    scene: ScenePath = None,
    tolerance: Tolerance = None,
    folder: Folder = None,
    as_json: AsJson = False,
) -> None:
    """Friction torque of a scene by effect, and which effects were computed or left out."""
    given = _scene(scene)
    given = replace(given, tolerance=_tolerance(tolerance, given))
    from fembearing.report.terminal.torque import print_torque
    from fembearing.report.torque_folder import torque_with_folder

    with shown_progress() as report:
        result, lacking = torque_with_folder(given, out=folder, progress=report)
    if as_json:
        print_json(result.to_json())
    else:
        print_torque(out, result)
        print_warnings(result.friction.warnings)
        if folder is not None:
            out.print(f"folder: {folder}", highlight=False, soft_wrap=True, markup=False)
    if lacking is not None:
        typer.echo(f"fembearing: {lacking}", err=True)
    raise typer.Exit(DONE if result.within_tolerance else NOT_SOLVED)


@app.command(epilog='Example: fembearing contact --pair inner --load "620 N" --tolerance "0.1 %"')
def contact(
    scene: ScenePath = None,
    pair: Annotated[PairName, typer.Option(help="Which contact.")] = PairName.inner,
    load: Loads = None,
    geometry: Geometry = GeometryName.real,
    accuracy: Accuracy = None,
    as_json: AsJson = False,
) -> None:
    """Solve one contact and set Hertz beside it; give --load again and again for a series with its stiffness law.

    Exit status 0: solved to the asked accuracy, whatever Hertz's verdict; 3: not; 2: the input is at fault.
    """
    given = _scene(scene)
    asked = _tolerance(accuracy, given)
    forces = [read_option("--load", LOAD, text) for text in load or ()]
    which: dict[str, Any] = {"pair": pair.value, "geometry": geometry.value}
    if len(forces) > 1:
        _load_series(given, forces, accuracy=asked, as_json=as_json, **which)
    else:
        _one_contact(given, forces[0] if forces else None, accuracy=asked, as_json=as_json, **which)


def _one_contact(given: Scene, load: float | None, *, accuracy: float, as_json: bool, **which: Any) -> None:
    from fembearing.compare.contact.discrepancy import SHOWN_OF_A_SHEET, solve_contact
    from fembearing.compare.contact.reference import COMPARED
    from fembearing.compare.contact.subsurface import compare_subsurface
    from fembearing.report.document.build import contact_table
    from fembearing.report.terminal.contacts import print_contact, print_subsurface

    with shown_progress() as report:
        result = solve_contact(given, load=load, accuracy=accuracy, progress=report, **which)
        report(0.8, f"{result.contact.pair}: stress under the contact")
        below = None
        try:
            below = compare_subsurface(result)
        except InputError as problem:  # half a contact; all else of it is there
            result = replace(result, warnings=(*result.warnings, str(problem)))
    if as_json:
        added = {"tolerance": result.tolerance, "accuracy": accuracy, "subsurface": below and below.to_json()}
        print_json(result.to_json() | added)
    else:
        print_contact(out, contact_table(result), result.verdicts)
        if below is not None:
            print_subsurface(out, below)
        if result.judged:
            out.print(f"Hertz by the scene's tolerance of {result.tolerance:.3g}: {result.verdict}", highlight=False)
        print_warnings(result.warnings)
    asked = COMPARED if result.judged else SHOWN_OF_A_SHEET
    raise typer.Exit(_solved({name: result.estimates[name].total for name in asked}, accuracy))


def _load_series(given: Scene, loads: list[float], *, accuracy: float, as_json: bool, **which: Any) -> None:
    from fembearing.compare.contact.stiffness_law import solve_load_series
    from fembearing.report.terminal.contacts import print_series

    with shown_progress() as report:
        result = solve_load_series(given, loads=loads, accuracy=accuracy, progress=report, **which)
    if as_json:
        print_json(result.to_json())
    else:
        print_series(out, result)
        print_warnings(result.warnings)
    raise typer.Exit(_solved({f"approach at {part.load:g} N": part.approach.total for part in result.points}, accuracy))


@app.command(epilog='Example: fembearing cost bearing.toml --tolerance "1 %" --out cost-of-my-bearing')
def cost(
    scene: ScenePath = None,
    tolerance: Tolerance = None,
    folder: Folder = None,
    as_json: AsJson = False,
) -> None:
    """Measure error and time of every way to compute the same quantity, cheap to exact, on this machine."""
    given = _scene(scene)
    asked = _tolerance(tolerance, given)
    from fembearing.compare.cost.scene_cost import measure_cost
    from fembearing.report.folder import write_cost
    from fembearing.report.new_folder import whole_folder
    from fembearing.report.terminal.cost import print_cost

    with shown_progress() as report, nullcontext() if folder is None else whole_folder(folder) as place:
        result = measure_cost(given, tolerance=asked, progress=report)
        if place is not None:
            write_cost(result, place)
    if as_json:
        print_json(result.to_json())
    else:
        print_cost(out, result)
        print_warnings(given.warnings)


app.command(epilog="Example: fembearing sweep map.toml --out map-of-my-bearing")(sweep)
app.command(epilog=EXAMPLE)(report)


@app.command(epilog="Example: fembearing mesh --pair inner --level 2 --out meshes-of-the-inner-race")
def mesh(
    folder: Annotated[Path, typer.Option("--out", help="Folder for the .vtu files; made if it is missing.")],
    scene: ScenePath = None,
    pair: Annotated[PairName, typer.Option(help="Which contact.")] = PairName.inner,
    geometry: Geometry = GeometryName.real,
    level: Annotated[int | None, typer.Option(help="Level of the recipe; its finest without it.")] = None,
    load: Load = None,
    as_json: AsJson = False,
) -> None:
    """Write the two meshes of a contact and report their worst cells."""
    given = _scene(scene)
    force = _load(load)
    if str(folder) in ("", ".") or (folder.exists() and not folder.is_dir()):
        raise InputError(f"--out {str(folder)!r}: give a folder for the meshes; it is made if it is missing")
    from dataclasses import asdict

    from fembearing.compare.contact.discrepancy import as_meshed, contact_of, recipe_of, traced_to_load
    from fembearing.fem.guess import expected_semi_axes
    from fembearing.mesh.meshfile import write_body
    from fembearing.mesh.pair import pair_mesh
    from fembearing.mesh.quality import mesh_quality
    from fembearing.mesh.ring import ring_piece

    recipe = recipe_of(geometry.value, pair=pair.value)
    chosen = recipe.levels[-1] if level is None else level
    if chosen not in recipe.levels:
        raise InputError(f"--level {chosen}: recipe {recipe.name} has levels {', '.join(map(str, recipe.levels))}")
    found = as_meshed(contact_of(given, pair=pair.value, load=force), recipe=recipe)
    with traced_to_load(given, pair=pair.value, load=force):
        expected = expected_semi_axes(found)
        bodies = pair_mesh(found, recipe=recipe, level=chosen, semi_axes=expected)
        is_ring = geometry is GeometryName.ring
        lower = ring_piece(found, recipe, chosen, expected).body if is_ring else bodies.lower
    written = {}
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with TemporaryDirectory(dir=folder, prefix=".") as apart:  # both files or none
            for side, body in (("upper", bodies.upper), ("lower", lower)):
                name = f"{pair}-{geometry}-{side}.vtu"
                write_body(Path(apart) / name, body)
                written[str(folder / name)] = asdict(mesh_quality(body.mesh)) | {"body": body.name}
            for path in written:
                (Path(apart) / Path(path).name).replace(path)
    except OSError as problem:
        raise InputError(f"--out {str(folder)!r}: {problem.strerror}") from problem
    if as_json:
        print_json(
            {
                "pair": pair.value,
                "geometry": geometry.value,
                "level": chosen,
                "meshes": written,
                "warnings": given.warnings,
            }
        )
        return
    print_warnings(given.warnings)
    table = Table("file", "body", "cells", "nodes", "least det J/mean", "there x, y, z, mm", box=SIMPLE_HEAD)
    for path, quality in written.items():
        place = ", ".join(f"{1e3 * part:.3g}" for part in quality["worst_place"])
        share = f"{quality['least_determinant']:.3f}"
        table.add_row(path, quality["body"], str(quality["cells"]), str(quality["nodes"]), share, place)
    out.print(table)


def _scene(path: Path | None) -> Scene:
    return load_scene(builtin_scene(BUILTIN) if path is None else path)


def _tolerance(given: str | None, scene: Scene) -> float:
    return scene.tolerance if given is None else read_option("--tolerance", TOLERANCE, given)


def _load(given: str | None) -> float | None:
    return None if given is None else read_option("--load", LOAD, given)


def _status(found: "Verdict") -> int:
    return {"pass": DONE, "fail": CHECK_FAILED, "outside validity": CHECK_FAILED, "undecided": NOT_SOLVED}[found]


def _solved(uncertainties: dict[str, float], accuracy: float) -> int:
    """Status of a solution, by what was asked and how uncertain each quantity is left, both relative."""
    name = max(uncertainties, key=lambda name: uncertainties[name])
    if uncertainties[name] <= accuracy:
        return DONE
    return complain(
        f"not solved to {accuracy:.2g}: {name.replace('_', ' ')} is left uncertain by {uncertainties[name]:.2g}; "
        "ask for a larger --tolerance",
        NOT_SOLVED,
    )

