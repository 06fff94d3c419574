"""A sweep with its maps, and what the terminal says of it."""

from pathlib import Path

from rich.console import Console

from fembearing.compare.progress import Progress, silent
from fembearing.sweep.run import Sweep, run_sweep


def sweep_with_maps(
    grid: Path,
    *,
    out: Path,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Progress = silent,
) -> tuple[Sweep, list[Path]]:
    """Do the sweep, see `run_sweep`, and write its maps beside the dataset where they are not newer than that."""
    result = run_sweep(grid, out=out, workers=workers, scheduler=scheduler, progress=progress)
    written = Path(result.file).stat().st_mtime_ns
    maps = sorted(file for file in out.glob("*.png") if file.stat().st_mtime_ns >= written)
    if not maps:
        progress(1.0, "maps")
        from fembearing.report.sweep_maps import write_maps  # with matplotlib: not for a sweep that is there

        maps = write_maps(result.dataset(), out)
    return result, maps


def print_sweep(out: Console, result: Sweep, maps: list[Path]) -> None:
    def line(text: str) -> None:
        out.print(text, highlight=False, soft_wrap=True, markup=False)

    line(
        f"{result.points} points: {result.computed} computed, {result.kept} from before, {result.failed} failed; "
        f"{result.seconds:.1f} s"
    )
    for reason in result.reasons:
        line(f"failed: {reason}")
    if result.lost:
        line(f"{result.lost} of them will be tried again when the sweep is started again")
    for file in (result.file, *maps):
        line(f"written: {file}")
