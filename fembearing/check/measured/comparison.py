"""The comparison of a scene with all measured torques of a file, and what it shows."""

import os
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from itertools import chain
from pathlib import Path
from statistics import fmean, stdev
from time import perf_counter
from typing import TYPE_CHECKING, Annotated, Any, Unpack

import numpy as np
from annotated_types import MinLen
from numpy.typing import NDArray

from analytic.any_scene import scene_by
from analytic.brief import Brief
from analytic.columns import COLUMNS, COORDINATES
from analytic.errors import InputError
from analytic.given import SceneOptions
from analytic.labelled import Column, Labelled, dataset_of, frame_of
from analytic.progress import Progress, part_of, silent
from analytic.rows import Count, NotNegative
from analytic.scene import MeasuredTorque, Scene
from analytic.scenefile.columns import operating_points, read_measured, require_loads
from analytic.verdicts import Overall
from fembearing.check.measured.conclusions import conclusions_of, notes_of
from fembearing.check.measured.rows import MeasuredRow, row_of

if TYPE_CHECKING:  # with SciPy's statistics, which take half a second to import
    from analytic.prediction.prediction import Prediction

SEED = 1
LEADING = 3  # inputs that are named
ROW = "row"  # the dimension of a dataset


@dataclass(frozen=True, kw_only=True)
class MeasuredComparison(Brief):
    """Measured torques beside the computed ones."""

    scene: str  # its name
    file: str  # of the measured torques
    rows: Annotated[tuple[MeasuredRow, ...], MinLen(1)]
    inside: int  # number of rows whose measured torque lies in its 95 % interval
    mean_error: float  # of E/D over the rows, dimensionless
    scatter: float | None  # standard deviation of E/D about its mean, dimensionless; None: one row
    shares: Mapping[str, float]  # of the variance of S, the largest at any row, by the inputs that matter most
    samples: Count  # number that the intervals are computed from
    seed: int  # of the samples, a number
    seconds: NotNegative
    conclusions: tuple[str, ...]  # what the rows show, what is missed first
    notes: tuple[str, ...]  # what was taken from the scene, or is not known
    warnings: tuple[str, ...]  # of the file and the computed torque

    def _facts(self) -> Iterator[str]:
        yield from (self.file, f"{self.inside} of {len(self.rows)} inside", f"E {self.mean_error:+.1%}")

    @property
    def verdict(self) -> Overall:
        """ "pass" where every measured torque lies in its interval, else "fail"."""
        return "pass" if all(row.verdict == "inside" for row in self.rows) else "fail"

    def columns(self) -> dict[str, Labelled]:
        """Every number of the rows, SI, NaN where it is not known, the operating points first."""
        described, names = COLUMNS, [part.name for part in fields(MeasuredRow) if part.name != "verdict"]
        found = {name: np.array([getattr(row, name) for row in self.rows], dtype=np.float64) for name in names}
        return {name: Labelled((ROW,), values, described[name]) for name, values in found.items()}

    def to_dataset(self) -> Any:
        """An xarray.Dataset over the rows, SI, with units and meanings as attributes."""
        columns = self._labelled()
        coordinates = {name: columns.pop(name) for name in COORDINATES}
        return dataset_of(
            columns,
            coordinates=coordinates,
            attributes={"scene": self.scene, "file": self.file, "samples": self.samples, "seed": self.seed},
        )

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with the columns of `to_dataset`: a row for each measured torque, SI."""
        return frame_of(self._labelled(), ROW)

    def _labelled(self) -> dict[str, Labelled]:
        """Numbers and verdicts of the rows."""
        verdicts = [row.verdict for row in self.rows]
        words = {"verdict": Labelled((ROW,), verdicts, Column("", "place of the measured torque"))}
        return self.columns() | words


def compare_measured(
    scene: Scene | str | os.PathLike[str],
    data: str | os.PathLike[str] | None = None,
    *,
    samples: int | None = None,
    seed: int = SEED,
    progress: Progress = silent,
    **given: Unpack[SceneOptions],
) -> MeasuredComparison:
    """Compare the torque of a scene with measured torques.

    Parameters
    ----------
    scene : Scene, str or path
        What a row of the measured torques does not say is that of the scene.
    data : str or path, optional
        CSV or .xlsx file, each column with its unit (docs/how-to/compare-with-measurements.md); None: the measured
        torques of the scene, which `analytic.load_scene` reads.
    samples : int, optional
        Number of torques that the intervals are computed from; None: 512 or more, as `analytic.predict`.
    seed : int
        Number that fixes the samples. All rows have the same ones, where their number is the same.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and a word on the step at hand.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    MeasuredComparison
        A row for each measured torque, N m, and what they show together.

    Raises
    ------
    InputError
        A file that cannot be read, a wrong column or row, a quantity that neither a row nor the scene gives; and as
        `analytic.predict`.

    Notes
    -----
    Source: [ASME2009]; the intervals are those of `analytic.predict`.
    """
    from analytic.prediction.prediction import predict

    begun = perf_counter()
    if data is not None and not isinstance(scene, Scene):  # a bearing has no usual load beside loads of the file
        given = {**given, "measured": data}
    scene = scene_by(scene, given)
    measured = scene.measured if data is None else read_measured(data)
    if measured is None:
        raise InputError(
            "the scene has no table [measured]; give a CSV file of measured torques with the scene, or write file = "
            '"data.csv" into that table'
        )
    scenes = list(_scenes(scene, measured))
    predictions = [
        predict(
            each,
            samples=samples,
            seed=seed,
            progress=part_of(progress, number / len(scenes), (number + 1) / len(scenes)),
        )
        for number, (_, each) in enumerate(scenes)
    ]
    found: dict[int, MeasuredRow] = {}
    for (places, each), prediction in zip(scenes, predictions, strict=True):
        for point, place in enumerate(places.tolist()):
            found[place] = row_of(measured, place, prediction, point, each)
    rows = tuple(found[place] for place in range(measured.torque.size))
    relative, shares = [row.relative for row in rows], leading(predictions)
    mean_error, scatter = fmean(relative), stdev(relative) if len(relative) > 1 else None
    return MeasuredComparison(
        scene=scene.name,
        file=Path(measured.file).name,
        rows=rows,
        inside=sum(row.verdict == "inside" for row in rows),
        mean_error=mean_error,
        scatter=scatter,
        shares=shares,
        samples=max(each.samples for each in predictions),
        seed=seed,
        seconds=perf_counter() - begun,
        conclusions=tuple(conclusions_of(rows, mean_error, scatter, shares)),
        notes=tuple(notes_of(measured, rows)),
        warnings=tuple(dict.fromkeys(chain(measured.warnings, *(each.nominal.warnings for each in predictions)))),
    )


def _scenes(scene: Scene, measured: MeasuredTorque) -> Iterator[tuple[NDArray[np.intp], Scene]]:
    """The rows of each temperature of the oil, and the scene there: another temperature is another oil.

    What the file lacks of the operating points is that of the scene, if it has one value of it.
    """
    points = operating_points(scene, measured.file, vars(measured), measured.torque.size)
    require_loads(scene, measured.file, points)
    operation, own = replace(scene.operation, **points), scene.lubricant
    temperatures, oils = measured.temperature, measured.oils
    if temperatures is None:
        yield np.arange(measured.torque.size), replace(scene, operation=operation)
        return
    if own is not None and oils.get(own.temperature, own) != own:
        raise InputError(
            "the oil of the scene was changed after its file was read, which has the oils at the measured "
            "temperatures; change the file"
        )
    for temperature in np.unique(temperatures).tolist():
        oil = oils.get(temperature) or (own if own is not None and own.temperature == temperature else None)
        if oil is None:
            has = "no oil" if own is None else f"its oil at {own.temperature - 273.15:.4g} degC alone"
            raise InputError(
                f"{measured.file}: temperature = {temperature - 273.15:.4g} degC: the scene has {has}; read both "
                "together, analytic.load_scene(scene, measured=data)"
            )
        places = np.flatnonzero(temperatures == temperature)
        yield places, replace(scene, operation=operation.at(places), lubricant=oil)


def leading(predictions: Sequence["Prediction"]) -> dict[str, float]:
    """The inputs with the largest total indices at any row."""
    largest: dict[str, float] = {}
    for each in predictions:
        for one, index in zip(each.inputs, each.indices.total.max(axis=1).tolist(), strict=True):
            largest[one.key] = max(index, largest.get(one.key, 0.0))
    return dict(sorted(largest.items(), key=lambda item: -item[1])[:LEADING])
