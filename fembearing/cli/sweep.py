"""`fembearing sweep`: it computes a grid, draws maps of the dataset, and prints a summary."""

import shlex
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fembearing.cli.options import AsJson, Talk, require_folder_name
from fembearing.cli.status import DONE, INTERRUPTED, NOT_SOLVED, complain, say

if TYPE_CHECKING:
    from fembearing.sweep.run import Sweep

MAPS = "maps"


def sweep(
    talk: Talk,
    grid: Annotated[Path, typer.Argument(metavar="GRID", help="Grid file (TOML): a scene and axes.")],
    folder: Annotated[
        Path, typer.Option("--out", "-o", help="Folder of the sweep: new, or of a stopped sweep to continue.")
    ],
    workers: Annotated[int | None, typer.Option(help="Processes on this machine (default: one per core).")] = None,
    scheduler: Annotated[str | None, typer.Option(help="Address of a Dask cluster (default: this machine).")] = None,
    as_json: AsJson = False,
) -> None:
    """Compute a scene at every point of a grid of axes. The same command continues a stopped sweep.

    GRID holds scene = "bearing.toml", what = "torque" or "contact", and a table of axes, with lines as
    operation.axial_load = { from = "100 N", to = "2 kN", count = 20, spacing = "log" } or conformity = [0.51, 0.52].
    """
    require_folder_name(folder, option="--out")
    from fembearing.cli.console import print_json
    from fembearing.plain_types import plain
    from fembearing.sweep.run import run_sweep

    if scheduler is not None and not scheduler.startswith("tls://"):
        say(f"warning: --scheduler {scheduler!r}: whoever reaches it can run code as you; tls:// takes certificates")
    try:
        with talk.progress() as progress:
            result = run_sweep(grid, out=folder, workers=workers, scheduler=scheduler, progress=progress)
            progress(1.0, "maps")
            maps = _maps(result)
    except KeyboardInterrupt:
        kept = f"finished points are in {folder}; the same command continues"
        complain(f"stopped; {kept if folder.exists() else 'no point is finished'}", INTERRUPTED)
        raise
    if as_json:
        print_json(plain(result) | {"maps": plain(maps)})
    else:
        _print(result, maps)
        _tell_assumed(grid)
    raise typer.Exit(NOT_SOLVED if result.failed else DONE)


def _tell_assumed(path: Path) -> None:
    from analytic.catalog.bearing_rows import find_bearing
    from analytic.scenefile.usual import told_values
    from fembearing.cli.console import tell_assumed
    from fembearing.sweep.grid import load_grid

    grid = load_grid(path)
    if grid.designation:
        told = told_values(
            grid.usual,
            find_bearing(grid.designation),
            grid.first_scene(),
            {axis.key: axis.values for axis in grid.axes},
        )
        tell_assumed(told, change=f"in a scene file: fembearing init {shlex.quote(grid.designation)}")


def _maps(result: "Sweep") -> list[Path]:
    """The maps of the dataset, in place of those of an earlier run."""
    from analytic.writing import new_folder
    from fembearing.report.figures.sweep_maps import PLOTTED, write_maps  # takes matplotlib

    folder = Path(result.folder) / MAPS
    with new_folder(folder, force=True) as apart:
        write_maps(result.to_dataset(*PLOTTED), apart)
    return sorted(folder.glob("[!.]*"))


def _print(result: "Sweep", maps: list[Path]) -> None:
    from fembearing.cli.console import out

    out.tell(
        f"{result.points} points: {result.computed} computed, {result.kept} from before, {result.failed} failed; "
        f"{result.seconds:.1f} s"
    )
    for reason in result.reasons:
        out.tell(f"failed: {reason}")
    if result.lost:
        out.tell(f"{result.lost} of them are retried by the next run")
    for file in (result.file, *maps):
        out.tell(f"written: {file}")
