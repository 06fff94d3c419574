"""Run a sweep: compute the pieces that its folder does not hold yet, and gather all of them."""

import time
from collections.abc import Callable, Container, Iterable, Iterator
from contextlib import closing
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path
from typing import Any

from analytic.brief import Brief
from analytic.errors import InputError
from analytic.scene import Scene
from fembearing.progress import Progress, silent
from fembearing.sweep.cluster import LostWorkerError, each_done
from fembearing.sweep.dataset import write_dataset
from fembearing.sweep.grid import Grid, load_grid
from fembearing.sweep.parts import Part, Piece, compute_part, pieces
from fembearing.sweep.store import RESULT, Store, opened_store
from fembearing.verify.contact.mesh_seconds import about

SHOWN_REASONS = 5


@dataclass(frozen=True, kw_only=True)
class Sweep(Brief):
    """The outcome of a sweep."""

    folder: str  # where its files are
    file: str  # the dataset, netCDF
    points: int  # number of all
    computed: int  # number in this run
    kept: int  # number from runs before
    failed: int  # number without a result
    lost: int  # number whose process died; the next run tries them again
    reasons: tuple[str, ...]  # why points failed, the first `SHOWN_REASONS` different ones
    seconds: float

    def to_dataset(self, *names: str) -> Any:
        """The results as an xarray.Dataset in memory.

        Parameters
        ----------
        *names : str
            Of the variables; none: all of them.

        Returns
        -------
        xarray.Dataset
            SI, with units as attributes; of `names` those that it holds.
        """
        import xarray  # on demand: it takes a second

        with xarray.open_dataset(self.file, engine="netcdf4") as dataset:
            return (dataset[[name for name in names if name in dataset]] if names else dataset).load()

    def to_json(self) -> dict[str, Any]:
        """Plain types."""
        return asdict(self)


def run_sweep(
    grid: Grid | Path | str,
    *,
    out: Path | str,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Progress = silent,
    announce: Callable[[str], None] | None = None,
) -> Sweep:
    """Compute every point of a grid and gather all in `out`/sweep.nc; a stopped sweep continues when started again.

    Parameters
    ----------
    grid : Grid, str or path
        From `load_grid`, or the path of a grid file.
    out : str or path
        Folder, made if it is missing; a folder of the same sweep is continued.
    workers : int, optional
        Number of processes on this machine; None: one for each core.
    scheduler : str, optional
        Address of a Dask cluster that computes instead.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and a text with the number of points and the time left.
    announce : callable, optional
        Called with the address of Dask's dashboard, if there is one.

    Returns
    -------
    Sweep
        Number of points that were computed, kept and failed, and the folder; `to_dataset` reads the results, SI.

    Raises
    ------
    InputError
        A mistake in the grid, or a folder that holds something else. Where a point cannot be computed, `failure` in the
        dataset gives the reason, and the others continue.
    """
    begun = time.perf_counter()
    if workers is not None and workers < 1:
        raise InputError(f"--workers {workers}: give a whole number from 1, or leave it out for one a core")
    read = grid if isinstance(grid, Grid) else load_grid(grid)
    with opened_store(Path(out), read) as store:
        finished = store.finished()
        if finished is not None:
            return _outcome(store, read, begun, computed=0, **finished)
        all_pieces = list(pieces(read))
        missing = [piece for piece in all_pieces if store.load(piece) is None]
        _require_samples(read, read.first_scene())  # which raises where no point is a valid scene
        tasks = {piece: (read, piece) for piece in missing}
        results = each_done(compute_part, tasks, workers=workers, scheduler=scheduler, announce=announce)
        with closing(results):
            lost = _keep(store, read, missing, results, progress)
        progress(1.0, "gathering")
        reasons: list[str] = []
        store.keep_result(
            lambda file: reasons.extend(write_dataset(file, read, partial(_parts, store, all_pieces, lost)))
        )
        counts = {
            "failed": len(reasons),
            "lost": sum(piece.stop - piece.start for piece in lost),
            "reasons": tuple(dict.fromkeys(reasons))[:SHOWN_REASONS],
        }
        if not lost:
            store.finish(counts)
        done = sum(piece.stop - piece.start for piece in missing if piece not in lost)
        return _outcome(store, read, begun, computed=done, **counts)


def _require_samples(grid: Grid, scene: Scene) -> None:
    """Raises InputError for fewer samples than the interval needs, before any point is computed."""
    if grid.samples is None:
        return
    from analytic.prediction.prediction import require_samples  # with SciPy's statistics: half a second
    from analytic.prediction.spreads import uncertain_inputs

    try:
        require_samples(grid.samples, uncertain_inputs(scene))
    except InputError as problem:
        raise InputError(f"{grid.origin}: {problem}") from None


def _keep(
    store: Store, grid: Grid, missing: list[Piece], results: Iterable[tuple[Piece, Any]], progress: Progress
) -> dict[Piece, str]:
    """Keep the results of the missing pieces as they come; the lost ones and why."""
    lost: dict[Piece, str] = {}
    left, failed, begun = sum(piece.stop - piece.start for piece in missing), 0, time.perf_counter()
    kept = grid.size - left
    progress(kept / grid.size, f"{kept} of {grid.size} points")
    for piece, part in results:
        if isinstance(part, LostWorkerError):
            lost[piece] = str(part)
        else:
            store.save(piece, part)
            failed += len(part.reasons)
        left -= piece.stop - piece.start
        done = grid.size - left
        words = f"{done} of {grid.size} points" + (f", {failed} failed" if failed else "")
        expected = (time.perf_counter() - begun) / (done - kept) * left
        progress(done / grid.size, f"{words}, {about(expected)} left" if left else words)
    return lost


def _parts(
    store: Store, all_pieces: list[Piece], lost: dict[Piece, str], names: Container[str]
) -> Iterator[tuple[Piece, Part]]:
    """The pieces one after the other, so that memory holds one at a time."""
    for piece in all_pieces:
        if piece in lost:
            reasons = dict.fromkeys(range(piece.stop - piece.start), lost[piece])
            yield piece, Part(columns={}, reasons=reasons, warnings=())
        else:
            part = store.load(piece, names)
            assert part is not None, piece
            yield piece, part


def _outcome(store: Store, grid: Grid, begun: float, *, computed: int, failed: int, lost: int, reasons: Any) -> Sweep:
    return Sweep(
        folder=str(store.folder),
        file=str(store.folder / RESULT),
        points=grid.size,
        computed=computed,
        kept=grid.size - computed - lost,
        failed=failed,
        lost=lost,
        reasons=tuple(reasons),
        seconds=time.perf_counter() - begun,
    )
