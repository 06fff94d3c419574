"""The friction torque of a scene, as the command `torque` computes it, with what is shown next to it."""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Literal, Unpack

import numpy as np
from numpy.typing import NDArray

from analytic.any_scene import scene_by
from analytic.brief import Brief, span
from analytic.columns import COLUMNS, COORDINATES, Point, points_table, rows_of
from analytic.errors import FembearingError, InputError
from analytic.given import SceneOptions
from analytic.labelled import Labelled, dataset_of, frame_of
from analytic.left_out import Places
from analytic.makers import BesideCatalogue, beside_catalogue
from analytic.prediction.formulas import with_model_uncertainty
from analytic.progress import Progress, silent
from analytic.result import POINT, FrictionTorque
from analytic.scene import Array, Bearing, Scene
from analytic.scenefile.inputs import StatedInput, stated_inputs
from analytic.standing import Standing, standing_of
from analytic.torque import friction_torque
from analytic.units import SYSTEMS, oil_words
from analytic.verdicts import Verdicts, numerical_check, physical_checks
from analytic.words import NEWTON_MILLIMETRE

if TYPE_CHECKING:  # with SciPy's statistics, which take half a second to import, and Matplotlib
    from matplotlib.figure import Figure

    from analytic.figures.torque import DrawnTorque
    from analytic.prediction.prediction import Prediction

MOST_ESTIMATED = 50  # operating points with an interval to first order, which costs some 40 torques
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
    # Both ends of the 95 % interval at each operating point, N m, (2, n), by samples or to first order; None: not known
    interval: Array | None = None
    prediction: "Prediction | None" = None  # the samples of the interval; None: not asked for
    without: Places | None = None  # some points without a torque among all; None: the scene here has all

    def __post_init__(self) -> None:
        """Raises InputError for a number that is not finite, so that no face shows it: terminal, files or page."""
        self.friction.checked()
        for name, values in self._beside():
            if not np.isfinite(values).all():
                raise InputError(
                    f"the {COLUMNS[name].meaning} is {values[~np.isfinite(values)][0]:g} N m: the numbers of the scene "
                    "are outside the computable range; give usual ones"
                )

    def _facts(self) -> Iterator[str]:
        yield self.scene.name
        yield f"{span(self.friction.torque.total, NEWTON_MILLIMETRE.factor)} {NEWTON_MILLIMETRE.name}"
        yield f"+- {span(self.friction.numerical_uncertainty, 100.0)} %, tolerance {100 * self.scene.tolerance:g} %"

    @property
    def inputs(self) -> tuple[StatedInput, ...]:
        """Where the inputs come from."""
        return stated_inputs(self.scene)

    @cached_property
    def verdicts(self) -> Verdicts:
        """Whether it is solved within the tolerance, and the bearing within its physical limits."""
        numbers = self.places.computed
        return Verdicts(
            numerical=numerical_check(self.friction, tolerance=self.scene.tolerance),
            physical=tuple(replace(each, point=numbers[each.point]) for each in physical_checks(self.friction)),
        )

    @cached_property
    def standing(self) -> Standing:
        """How far it can be trusted, in one word."""
        torque, effects = self.friction.torque, self.friction.effects.unmeasured
        return standing_of(self.scene, torque=torque, effects=effects, verdicts=self.verdicts, band=self.catalogue.band)

    @property
    def places(self) -> Places:
        """All operating points of the scene as it was given."""
        return self.without or Places(operation=self.scene.operation.as_series(), failures={})

    @property
    def notes(self) -> tuple[str, ...]:
        """What else to know of the torque, a sentence each: other balls. None is judged."""
        other, given = self.scene.bearing.other_candidate, self.scene.bearing
        if other is None or self.other_candidate is None:
            return ()
        first, second = self.friction.torque.total, self.other_candidate.torque.total
        return (
            f"The ratings of {given.name} fit {_balls(other)} nearly as well as {_balls(given)}: the torque is "
            f"then {_span(second * 1e3, '.4g')} N mm, not {_span(first * 1e3, '.4g')} N mm "
            f"({_span(100 * (second / first - 1), '+.2g')} %).",
        )

    def columns(self) -> dict[str, Labelled]:
        """Every number that stands at each operating point, SI: the points, and what is computed and known there.

        NaN at the points that have no torque.
        """
        known = self.places.columns(self.friction.columns() | dict(self._beside()))
        return {name: Labelled((POINT,), values, COLUMNS[name]) for name, values in known.items()}

    @cached_property
    def points(self) -> tuple[Point, ...]:
        """A row for each operating point of the scene, by the names of `columns`."""
        return rows_of({name: each.values for name, each in self.columns().items()})

    @cached_property
    def makers(self) -> Mapping[str, Array]:
        """(n,) N m by each maker's formula, by its name; NaN where it does not hold."""
        return {} if self.catalogue.band is None else self.places.columns(dict(self.catalogue.band.values))

    def _beside(self) -> Iterator[tuple[str, Array]]:
        if self.interval is not None:
            yield from zip(("interval_low", "interval_high"), self.interval, strict=True)
        if (band := self.catalogue.band) is not None:
            yield from (("catalogue_low", band.low), ("catalogue_high", band.high))

    def to_dataset(self) -> Any:
        """An xarray.Dataset over the operating points, SI, with units and meanings as attributes."""
        columns = self.columns()
        coordinates = {name: columns.pop(name) for name in COORDINATES}
        return dataset_of(columns, coordinates=coordinates, attributes=self.friction.attributes())

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with the columns of `to_dataset`: a row for each operating point, SI."""
        return frame_of(self.columns(), POINT)

    def _repr_html_(self) -> str:
        """A table for a notebook, with the 95 % interval, how far to trust the torque, and the warnings below."""
        notes = [f"{self.standing.word}: {self.standing.reason}", *self.friction.warnings]
        return points_table(self.columns(), caption=f"friction torque of {self.scene.name}", notes=notes)

    @property
    def drawn(self) -> "DrawnTorque":
        """What its figure shows."""
        from analytic.figures.torque import DrawnTorque

        bearing, units = self.scene.bearing.name, SYSTEMS[self.scene.report.units]
        band, computed = self.catalogue.band, self.places.computed
        return DrawnTorque(
            columns={name: np.asarray(each.values)[computed] for name, each in self.columns().items()},
            makers={} if band is None else band.values,
            title=f"{bearing if self.friction.pair is None else f'two {bearing}'}, "
            f"{oil_words(self.scene.lubricant, units)}",
            units=units,
        )

    def plot(self) -> "Figure":
        """The torque by effect over the operating points, with its 95 % interval and the makers' formulas.

        Lines over speed or load where that alone varies, on logarithmic axes from a decade on; else bars. The figure
        is that of the report and of `fembearing torque --out`, in the units of the scene.

        Returns
        -------
        matplotlib.figure.Figure
            In a notebook it shows itself; `savefig` writes it.

        Raises
        ------
        MissingPackageError
            Matplotlib is not installed.
        """
        from analytic.figures.torque import torque_figure

        return torque_figure(self.drawn)


def _balls(bearing: Bearing) -> str:
    return f"{bearing.ball_count} balls of {bearing.ball_diameter * 1e3:.4g} mm"


def _span(values: Array, form: str) -> str:
    """The values at every operating point, in words."""
    low, high = (format(float(end), form) for end in (np.min(values), np.max(values)))
    return low if low == high else f"{low} to {high}"


def torque_of_scene(
    scene: Scene | str | os.PathLike[str],
    *,
    samples: Samples = None,
    estimate: bool = True,
    keep_going: bool = False,
    progress: Progress = silent,
    **given: Unpack[SceneOptions],
) -> SceneTorque:
    """The torque of a scene as `fembearing torque` computes it, with interval, verdict and the makers' formulas.

    Parameters
    ----------
    scene : Scene, str or path
        As in `friction_torque`.
    samples : int or "enough", optional
        Of the 95 % interval, as in `predict`; None: an estimate to first order, for at most 50 operating points.
    estimate : bool
        Whether to estimate the interval without samples. It takes most of the time; `with_interval` does it later.
    keep_going : bool
        Skip operating points without a torque, with the reason.
    progress : callable
        Called with the share of the samples done, 0 to 1 (dimensionless), and a text.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    SceneTorque
        Torque and interval, N m, at the operating points.

    Raises
    ------
    InputError
        As `friction_torque`, and with samples as `predict`; with keep_going where no point has a torque.
    """
    scene = scene_by(scene, given)
    places, friction = _where_it_is(scene, keep_going=keep_going)
    if places.failures:
        scene = replace(scene, operation=places.operation.at(np.array(places.computed)))
        size, lost = places.operation.inner_speed.size, places.failures.items()
        words = (f"operating point {number + 1} of {size} is left out: {why}" for number, why in lost)
        friction = replace(friction, warnings=(*friction.warnings, *words))
    other, friction = _with_other_balls(scene, friction)
    prediction, interval = None, None
    if samples is None:
        interval = _estimated(scene, friction) if estimate else None
    else:
        from analytic.prediction.prediction import predict

        prediction = predict(scene, samples=None if samples == "enough" else samples, progress=progress)
        interval = np.array(prediction.total.ends)
    return SceneTorque(
        scene=scene,
        friction=friction,
        catalogue=beside_catalogue(scene, friction.pair),
        other_candidate=other,
        interval=interval,
        prediction=prediction,
        without=places if places.failures else None,
    )


def _where_it_is(scene: Scene, *, keep_going: bool) -> tuple[Places, FrictionTorque]:
    """The operating points of a scene, and the torque where there is one; raises the first error where there is none.

    keep_going : whether points may lack a torque
    """
    operation = scene.operation.as_series()
    failures: dict[int, FembearingError] = {}

    def torque_at(points: NDArray[np.intp]) -> FrictionTorque:
        some = scene if points.size == operation.inner_speed.size else replace(scene, operation=operation.at(points))
        return with_model_uncertainty(some, friction_torque(some).settled())

    def tried(points: NDArray[np.intp]) -> FrictionTorque | None:
        try:
            return torque_at(points)
        except FembearingError as problem:
            if not keep_going:
                raise
            if points.size == 1:
                failures[int(points[0])] = problem
            else:
                for half in np.array_split(points, 2):
                    tried(half)
            return None

    friction, places = tried(np.arange(operation.inner_speed.size)), Places(operation=operation, failures=failures)
    if not places.computed:
        raise failures[0]
    return places, friction or torque_at(np.array(places.computed))


def with_interval(result: SceneTorque) -> SceneTorque:
    """The same torque with its 95 % interval to first order, as `torque_of_scene` has it without samples."""
    return replace(result, interval=_estimated(result.scene, result.friction))


def _estimated(scene: Scene, friction: FrictionTorque) -> Array | None:
    """Both ends of the interval to first order; None for too many operating points, or where it is not known."""
    if friction.inner_speed.size > MOST_ESTIMATED:
        return None
    from analytic.prediction.first_order import first_order_ends

    return first_order_ends(scene, friction)


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
