"""The friction torque of a scene, as the command `torque` computes it, with what is shown next to it."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, Literal

import numpy as np

from analytic.brief import Brief, span
from analytic.effects.table import STATIC_LIMIT
from analytic.errors import FembearingError
from analytic.inputs import StatedInput, stated_inputs
from analytic.labelled import Column, Labelled, dataset_of, frame_of
from analytic.result import COLUMNS, COORDINATES, NEWTON_MILLIMETRE, POINT, FrictionTorque
from analytic.scene import Array, Bearing, Scene
from analytic.torque import friction_torque
from analytic.uncertainty import with_model_uncertainty
from fembearing.compare.torque.catalogue import BesideCatalogue, beside_catalogue
from fembearing.progress import Progress, silent

if TYPE_CHECKING:  # with SciPy's statistics, which take half a second to import
    from analytic.prediction.prediction import Prediction

BESIDE: dict[str, Column] = {  # what stands beside the torque, one number at each operating point
    "interval_low": Column("N m", "lower end of the 95 % interval of the friction torque"),
    "interval_high": Column("N m", "upper end of the 95 % interval of the friction torque"),
    "catalogue_low": Column("N m", "lower end of the catalogue band"),
    "catalogue_high": Column("N m", "upper end of the catalogue band"),
}
Samples = int | Literal["enough"] | None  # of an interval: a number, until its ends are known well enough, or none


@dataclass(frozen=True, kw_only=True, eq=False)
class SceneTorque(Brief):
    """Torque, uncertainties and catalogue band of one scene."""

    scene: Scene
    friction: FrictionTorque
    catalogue: BesideCatalogue
    other_candidate: FrictionTorque | None = (
        None  # with the balls that the ratings fit nearly as well, if there are any
    )
    prediction: "Prediction | None" = None  # the interval; None: not asked for

    def _facts(self) -> Iterator[str]:
        yield self.scene.name
        yield f"{span(self.friction.torque.total, NEWTON_MILLIMETRE.factor)} {NEWTON_MILLIMETRE.name}"
        yield f"+- {span(self.friction.numerical_uncertainty, 100.0)} %, tolerance {100 * self.scene.tolerance:g} %"

    @property
    def inputs(self) -> tuple[StatedInput, ...]:
        """Where the inputs come from."""
        return stated_inputs(self.scene)

    @property
    def within_tolerance(self) -> bool:
        """Whether the numerical uncertainty is, at every operating point."""
        return bool(np.all(self.friction.numerical_uncertainty <= self.scene.tolerance))

    @property
    def doubts(self) -> tuple[str, ...]:
        """Why the total may be far from the truth although it is computed within the tolerance; a sentence each."""
        return tuple(self._doubts())

    def _doubts(self) -> Iterator[str]:
        if not self.within_tolerance:
            worst = float(np.max(self.friction.numerical_uncertainty))
            limit = self.scene.tolerance
            if np.isfinite(worst):
                yield f"The numerical uncertainty of the torque, {worst:.2g}, is beyond the tolerance {limit:g}."
            else:
                yield f"The numerical uncertainty of the torque is not known: {'; '.join(self.friction.unknown)}."
        for race in ("inner", "outer"):
            yield from static_doubt(race, getattr(self.friction, race).peak_pressure)
        other, given = self.scene.bearing.other_candidate, self.scene.bearing
        if other is not None and self.other_candidate is not None:
            first, second = self.friction.torque.total, self.other_candidate.torque.total
            yield (
                f"The ratings of {given.name} fit {_balls(other)} nearly as well as {_balls(given)}: with them the "
                f"torque is {_span(second * 1e3, '.4g')} N mm, not {_span(first * 1e3, '.4g')} N mm "
                f"({_span(100 * (second / first - 1), '+.2g')} %)."
            )
        band, total = self.catalogue.band, self.friction.torque.total
        if band is not None and (outside := np.count_nonzero((total < band.low) | (total > band.high))):
            yield f"The torque is outside the catalogue band at {outside} of {total.size} operating points."

    def columns(self) -> dict[str, Labelled]:
        """Every number that stands at each operating point, SI: the points, and what is computed and known there."""
        given = {name: (getattr(self.friction, name), column) for name, column in COORDINATES.items()}
        computed = {name: (values, COLUMNS[name]) for name, values in self.friction.columns().items()}
        beside = {name: (values, BESIDE[name]) for name, values in self._beside()}
        return {
            name: Labelled((POINT,), values, column) for name, (values, column) in (given | computed | beside).items()
        }

    def _beside(self) -> Iterator[tuple[str, Array]]:
        interval = None if self.prediction is None else self.prediction.total
        for name, group in (("interval", interval), ("catalogue", self.catalogue.band)):
            if group is not None:
                yield from ((f"{name}_{end}", getattr(group, end)) for end in ("low", "high"))

    def to_dataset(self) -> Any:
        """An xarray.Dataset over the operating points, SI, with units and meanings as attributes."""
        columns = self.columns()
        coordinates = {name: columns.pop(name) for name in COORDINATES}
        return dataset_of(columns, coordinates=coordinates, attributes=self.friction.attributes())

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame of `to_dataset`: a row for each operating point, SI."""
        return frame_of(self.to_dataset(), POINT)

    def to_json(self) -> dict[str, Any]:
        """The torque as plain types, SI, with the catalogue band, None where there is none."""
        return self.friction.to_json() | {
            "tolerance": self.scene.tolerance,
            "catalogue_band": self.catalogue.to_json(),
            "doubts": list(self.doubts),
            "inputs": [_input_to_json(each) for each in self.inputs],
            "other_candidate": self._other_to_json(),
            "prediction": None if self.prediction is None else self.prediction.to_json(),
        }

    def _other_to_json(self) -> dict[str, Any] | None:
        """Balls and total of the other candidate."""
        other = self.scene.bearing.other_candidate
        if other is None or self.other_candidate is None:
            return None
        balls = {"ball_count": other.ball_count, "ball_diameter": other.ball_diameter}
        return balls | {"total": self.other_candidate.torque.total.tolist()}


def _input_to_json(given: StatedInput) -> dict[str, Any]:
    return {"key": given.key, "value": given.value, "unit": given.unit} | vars(given.origin)


def _balls(bearing: Bearing) -> str:
    return f"{bearing.ball_count} balls of {bearing.ball_diameter * 1e3:.4g} mm"


def _span(values: Array, form: str) -> str:
    """The values at every operating point, in words."""
    low, high = (format(float(end), form) for end in (np.min(values), np.max(values)))
    return low if low == high else f"{low} to {high}"


def static_doubt(race: str, peak_pressure: Any) -> Iterator[str]:
    """One sentence where a peak pressure by Hertz, Pa, one or an array, is past the static limit."""
    largest = float(np.max(peak_pressure))
    if largest > STATIC_LIMIT:
        yield (
            f"The peak pressure on the {race} race, {largest * 1e-9:.2f} GPa, is past the static limit of "
            f"{STATIC_LIMIT * 1e-9:g} GPa: the race yields, and elastic contact no longer describes it."
        )


def torque_of_scene(scene: Scene, *, samples: Samples = None, progress: Progress = silent) -> SceneTorque:
    """The torque of a scene.

    samples : of its 95 % interval, or "enough"; None: no interval
    progress : called with the share of the samples done
    Raises InputError as friction_torque, and with samples as predict.
    """
    friction = with_model_uncertainty(scene, friction_torque(scene))
    other, friction = _with_other_balls(scene, friction)
    prediction = None
    if samples is not None:
        from analytic.prediction.prediction import predict

        prediction = predict(scene, samples=None if samples == "enough" else samples, progress=progress)
    return SceneTorque(
        scene=scene,
        friction=friction,
        catalogue=beside_catalogue(scene),
        other_candidate=other,
        prediction=prediction,
    )


def _with_other_balls(scene: Scene, friction: FrictionTorque) -> tuple[FrictionTorque | None, FrictionTorque]:
    """The torque of the other candidate, if there is one; where it has none, a warning says why."""
    bearing = scene.bearing.other_candidate
    if bearing is None:
        return None, friction
    try:
        return friction_torque(replace(scene, bearing=bearing)), friction
    except FembearingError as problem:
        warning = f"with {_balls(bearing)}, which the ratings fit nearly as well, there is no torque: {problem}"
        return None, replace(friction, warnings=(*friction.warnings, warning))
