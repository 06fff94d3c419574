"""Run a sweep: compute the pieces that its folder does not hold yet, and gather all of them."""

import time
from collections import Counter
from collections.abc import Iterable
from contextlib import closing
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.brief import Brief
from analytic.errors import InputError, require_packages
from analytic.progress import Progress, silent
from analytic.scene import Scene
from analytic.words import about
from analytic.writing import replaced_file
from fembearing.sweep.cluster import each_done
from fembearing.sweep.dataset import write_dataset
from fembearing.sweep.grid import Grid, load_grid
from fembearing.sweep.parts import REASON, Part, Piece, blank, compute_part, pieces
from fembearing.sweep.processes import LostWorkerError
from fembearing.sweep.store import Store, opened_store

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


@dataclass(frozen=True, kw_only=True)
class Gathered:
    """The results of a sweep, as they come."""

    grid: Grid
    values: dict[str, NDArray[Any]]  # (size,) by the name of the column
    warnings: Counter[str] = field(default_factory=Counter)  # number of pieces that gave each
    defects: list[str] = field(default_factory=list)  # tracebacks

    def add(self, piece: Piece, part: Part) -> None:
        for name, values in part.values.items():
            self.values[name][piece.start : piece.stop] = values
        self.warnings.update([*part.warnings])
        self.defects.extend(part.defects)

    @property
    def reasons(self) -> list[str]:
        """Why points failed, in the order of the grid."""
        return [reason for reason in self.values[REASON] if reason]


def run_sweep(
    grid: Grid | Path | str,
    *,
    out: Path | str,
    workers: int | None = None,
    scheduler: str | None = None,
    progress: Progress = silent,
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
        Address of a Dask cluster that computes instead. Without TLS, whoever reaches it can run code there and here.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and a text with the number of points and the time left.

    Returns
    -------
    Sweep
        Number of points that were computed, kept and failed, and the folder; `to_dataset` reads the results, SI.

    Raises
    ------
    MissingPackageError
        The extra `sweep` is not installed.
    InputError
        A mistake in the grid, or a folder that holds something else. Where a point cannot be computed, `failure` in the
        dataset gives the reason, and the others continue.
    RuntimeError
        A defect of fembearing at some points, when all others are computed and the dataset is written.
    """
    require_packages("sweep", "xarray", "netCDF4")
    begun = time.perf_counter()
    if workers is not None and workers < 1:
        raise InputError(f"--workers {workers}: give a whole number from 1, or leave it out for one a core")
    read = grid if isinstance(grid, Grid) else load_grid(grid)
    with opened_store(Path(out), read) as store:
        gathered, missing = Gathered(grid=read, values=blank(read, read.size)), []
        for piece in pieces(read):
            part = store.load(piece)
            if part is None:
                missing.append(piece)
            else:
                gathered.add(piece, part)
        _require_samples(read, read.first_scene())  # which raises where no point is a valid scene
        results = each_done(partial(compute_part, read), missing, workers=workers, scheduler=scheduler)
        with closing(results):
            lost = _keep(store, gathered, missing, results, progress)
        progress(1.0, "gathering")
        with replaced_file(store.result) as file:
            write_dataset(file, read, gathered.values, gathered.warnings)
    if gathered.defects:
        raise RuntimeError(
            f"{len(gathered.defects)} times in this sweep; {store.result} has the points without it; the first is\n"
            f"{gathered.defects[0]}"
        )
    reasons = gathered.reasons
    left = sum(map(len, missing))
    return Sweep(
        folder=str(store.folder),
        file=str(store.result),
        points=read.size,
        computed=left - lost,
        kept=read.size - left,
        failed=len(reasons),
        lost=lost,
        reasons=tuple(dict.fromkeys(reasons))[:SHOWN_REASONS],
        seconds=time.perf_counter() - begun,
    )


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
    store: Store, gathered: Gathered, missing: list[Piece], results: Iterable[tuple[Piece, Any]], progress: Progress
) -> int:
    """Keep and gather the results of the missing pieces as they come; the number of lost points."""
    size, left = gathered.grid.size, sum(map(len, missing))
    kept, failed, lost, begun = size - left, 0, 0, time.perf_counter()
    progress(kept / size, f"{kept} of {size} points")
    for piece, result in results:
        if isinstance(result, LostWorkerError):
            lost += len(piece)
            result = Part(values={REASON: np.full(len(piece), str(result), dtype=object)})
        else:
            failed += np.count_nonzero(result.values[REASON])
            if not result.defects:  # a part with one is computed again when the sweep is started again
                store.save(piece, result)
        gathered.add(piece, result)
        left -= len(piece)
        done = size - left
        words = f"{done} of {size} points" + (f", {failed} failed" if failed else "")
        expected = (time.perf_counter() - begun) / (done - kept) * left
        progress(done / size, f"{words}, {about(expected)} left" if left else words)
    return lost
