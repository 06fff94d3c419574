"""What a torque is written to: a folder with all, or one file.

The folder has the numbers, the table, the figure, and for each point whose cage moved a series in time, a plot and a
picture.
"""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.errors import MissingPackageError, require_packages
from analytic.progress import Progress, part_of, silent
from analytic.scene import HeightMapFile, Scene
from analytic.scene_torque import Samples, SceneTorque, torque_of_scene
from analytic.units import METRIC
from analytic.writing import being_written, new_file, new_folder, require_utf8, write
from fembearing.report.torque_file import image_of, numbers_file, table_file, writer_of

if TYPE_CHECKING:
    from analytic.prediction.prediction import Prediction
    from fembearing.check.cage_record import CageRecord

COMPUTED, RECORDED = 0.4, 0.8  # of the whole job, when the torque is there, and when the series are
WITHOUT_FIGURE = (".csv", ".json")  # endings of files


def torque_with_files(
    scene: Scene,
    *,
    out: Path | None = None,
    force: bool = False,
    samples: Samples = None,
    keep_going: bool = False,
    progress: Progress = silent,
) -> tuple[SceneTorque, str | None]:
    """Compute the torque, and write it.

    out : folder, or file whose ending says what it holds (`torque_file`); None writes nothing
    force : it takes the place of what fembearing wrote there; else it must not exist yet
    samples : of the 95 % interval, or "enough"; None: no interval
    keep_going : leave out the operating points that have no torque
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Gives the torque, and a sentence on what a folder lacks and why: None where it lacks nothing.
    Raises InputError for a scene that has no torque or a name that cannot be written, MotionError where a cage's motion
    comes apart; MissingPackageError where a figure lacks matplotlib.
    """

    def computed(most: float) -> SceneTorque:
        progress(0.0, "torque")
        part = part_of(progress, 0.0, most)
        return torque_of_scene(scene, samples=samples, keep_going=keep_going, progress=part)

    if out is None:
        return computed(1.0), None
    content = writer_of(out) if out.suffix else None
    if out.suffix.casefold() not in WITHOUT_FIGURE:
        require_packages(f"--out {str(out)!r}", "matplotlib")
    if content is not None:
        with new_file(out, force=force) as file:
            result = computed(RECORDED)
            file.write_bytes(content(result))
        return result, None
    if scene.cage is not None:
        require_utf8(out)  # for the series of its motion
    with new_folder(out, force=force) as folder:
        result = computed(COMPUTED)
        return result, write_torque(result, folder, progress=progress)


def write_torque(
    result: SceneTorque, folder: Path, *, renderer: Sequence[str] | None = None, progress: Progress = silent
) -> str | None:
    """Write torque.json, torque.csv, torque.png and torque.svg, with an interval interval.png, with a measured
    surface height-map.png, and of each operating point whose cage moved NUMBER-cage.nc, -cage.png and
    -cage-forces.png.

    renderer : the command that draws; VTK's without it
    Gives what the folder lacks, as `torque_with_files`.
    """
    from fembearing.check.cage_record import record_cage

    records, numbers = [], result.places.computed
    points = result.friction.inner_speed.size
    for point in range(points):
        progress(COMPUTED + (RECORDED - COMPUTED) * point / points, f"cage, point {point + 1}")
        record = record_cage(result.scene, result.friction, point)
        if record is not None:
            records.append(replace(record, point=numbers[point] + 1))
    if records:
        progress(RECORDED, "plots and pictures")
        written, lacking = _write_motions(records, folder, renderer)
    else:
        written, lacking = [], _why_at_rest(result)
    if result.prediction is not None:
        _write_prediction(result.prediction, folder)
    if (surface := result.scene.surface) is not None and surface.height_map is not None:
        _write_height_map(surface.height_map, folder)
    write(folder / "torque.csv", table_file(result))
    for ending in (".png", ".svg"):
        write(folder / f"torque{ending}", image_of(result.plot(), ending))
    motion = {"points": written, "lacking": lacking}
    write(folder / "torque.json", numbers_file(result, cage_motion=motion))
    return lacking


def _write_prediction(prediction: "Prediction", folder: Path) -> None:
    """Write interval.png: what the interval is made of, and the inputs that make it."""
    from fembearing.report.figures.prediction import interval_figure
    from fembearing.report.figures.style import png

    write(folder / "interval.png", png(interval_figure(prediction, METRIC)))


def _write_height_map(file: HeightMapFile, folder: Path) -> None:
    """Write height-map.png: the map without its form."""
    from fembearing.report.figures.height_map import height_map_figure
    from fembearing.report.figures.style import png

    write(folder / "height-map.png", png(height_map_figure(file, METRIC, captioned=True)[0]))


def _write_motions(
    records: "list[CageRecord]", folder: Path, renderer: Sequence[str] | None
) -> tuple[list[dict[str, Any]], str | None]:
    """Write series, plot and picture of each motion; gives the entries of torque.json, and what is lacking."""
    from fembearing.report.figures.cage import cage_caption, orbit_figure  # with matplotlib: only a folder pays for it
    from fembearing.report.figures.style import png
    from fembearing.report.pictures.cage import cage_job, picture_caption
    from fembearing.report.pictures.draw import RENDERER, rendered

    pictures = [folder / f"{record.point}-cage.png" for record in records]
    jobs = [cage_job(record, file) for record, file in zip(records, pictures, strict=True)]
    trouble = rendered(jobs, RENDERER if renderer is None else renderer)
    unpictured = None if trouble is None else f"there is no picture of the cage: {trouble}"
    unwritten = _write_series(records, folder)
    written = []
    for record, picture in zip(records, pictures, strict=True):
        plot = folder / f"{record.point}-cage-forces.png"
        motion = record.drawn()
        write(plot, png(orbit_figure(motion, METRIC, captioned=True)))
        written.append(
            {
                "point": record.point,
                "state": record.statistics.state,
                "series": None if unwritten else _series_of(record, folder).name,
                "plot": {"file": plot.name, "caption": cage_caption(motion)},
                "picture": None if trouble else {"file": picture.name, "caption": picture_caption(record)},
            }
        )
    return written, "; ".join(filter(None, (unwritten, unpictured))) or None


def _series_of(record: "CageRecord", folder: Path) -> Path:
    return folder / f"{record.point}-cage.nc"


def _write_series(records: "list[CageRecord]", folder: Path) -> str | None:
    """Write the series of each motion; gives why there is none where a package is missing."""
    try:
        require_packages("it", "xarray", "netCDF4")
    except MissingPackageError as problem:
        return f"there is no series of the cage's motion: {problem}"
    for record in records:
        dataset = record.to_dataset()
        packed = {name: {"zlib": True, "complevel": 1} for name in dataset.data_vars}  # most forces are 0
        with being_written(_series_of(record, folder)):
            dataset.to_netcdf(_series_of(record, folder), engine="netcdf4", encoding=packed)
    return None


def _why_at_rest(result: SceneTorque) -> str | None:
    """Why no cage moved; None for a scene that has none."""
    if result.scene.cage is None:
        return None
    reason = next(effect.reason for effect in result.friction.effects.unmeasured if effect.name == "cage_dynamics")
    if result.friction.cage is not None and not np.any(result.friction.inner_speed):
        reason = "nothing turns"
    return f"the cage did not move, so that there is no series, plot or picture of it: {reason}"
