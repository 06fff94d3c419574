"""A friction torque with its 95 % interval: what it is made of, and which inputs make it."""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import ceil
from time import perf_counter
from types import MappingProxyType
from typing import Any, Unpack

import numpy as np
from scipy.special import ndtri

from analytic.any_scene import scene_by
from analytic.brief import Brief, span
from analytic.columns import COORDINATES, points_table
from analytic.errors import InputError, require_whole
from analytic.given import Quantity, SceneOptions
from analytic.labelled import Column, Labelled, dataset_of, frame_of
from analytic.prediction.evaluation import Problem, problem_of
from analytic.prediction.indices import indices_of
from analytic.prediction.interval import interval_of, least_samples, normal_points
from analytic.prediction.regression import Regression, regression_of
from analytic.prediction.rows import (
    COVERED,
    ENDS,
    Interval,
    SobolIndices,
)
from analytic.prediction.sampling import sampled
from analytic.prediction.spreads import NUMERICAL, UncertainInput, uncertain_inputs
from analytic.progress import Progress, silent
from analytic.result import POINT, FrictionTorque
from analytic.scene import Array, Scene
from analytic.scenefile.parts import with_tolerance
from analytic.torque import friction_torque
from analytic.words import NEWTON_MILLIMETRE, shown

SAMPLES, MOST_SAMPLES = 512, 4096  # by default: more until the ends are known well enough, and beyond this no more
LARGEST_SAMPLE = 1_000_000  # that a user may give: more is a slip
ENOUGH = 0.03  # standard error of each end of the total's interval, over that end
SEED, MOST_INPUTS = 1, 3  # inputs that a notebook names
ENDS_IN_WORDS = {"low": "lower end of the 95 % interval", "high": "upper end of the 95 % interval"}
INTERVAL = {
    **ENDS_IN_WORDS,
    "median": "median",
    **{f"{end}_error": f"standard error of the {words}" for end, words in ENDS_IN_WORDS.items()},
}
NOT_VARIED = (
    "laws and formulas other than those of film, gap, surfaces, rolling, elastic rolling and starvation: traction, "
    "spin and creep",
    "the number of balls, seats and their temperatures, the supply of oil, and neglected or missing effects",
    "the motion of a cage",
)


@dataclass(frozen=True, kw_only=True, eq=False)
class Prediction(Brief):
    """The torque at the n operating points of a scene, and how far to trust it."""

    nominal: FrictionTorque  # with the inputs as they are
    inputs: tuple[UncertainInput, ...]  # d of them, "numerical" the last one where it is known and not 0
    total: Interval
    parts: Mapping[str, Interval]  # by the parts of the torque, as far as they are computed
    # Each (2, n), N m: the interval of the total if nothing else were uncertain. By numerical, input, model, and each
    # formula, "model.film"; they do not add up to the whole.
    made_of: Mapping[str, Array]
    indices: SobolIndices
    explained: Array  # (n,) share of the variance of the total that the regression predicts for samples left out
    samples: int  # number that was drawn
    failed: int  # number of them without a torque
    reasons: tuple[str, ...]  # why
    seed: int
    seconds: float  # that all took
    evaluation_seconds: float  # of it, in torques alone, of the processor

    def _facts(self) -> Iterator[str]:
        shown = NEWTON_MILLIMETRE
        ends = (span(each, shown.factor) for each in (self.nominal.torque.total, self.total.low, self.total.high))
        total, low, high = ends
        yield self.nominal.provenance["scene"]
        yield f"{total} {shown.name}, 95 % from {low} to {high} {shown.name}, {self.samples} samples"

    @property
    def ranked(self) -> list[int]:
        """The inputs from the one whose total index is largest, at any point."""
        return np.argsort(-self.indices.total.max(axis=1), kind="stable").tolist()

    @property
    def not_varied(self) -> tuple[str, ...]:
        """What the interval does not know, in words."""
        return NOT_VARIED

    @property
    def ends(self) -> list[int]:
        """The slowest and the fastest operating point, by their numbers, of equal ones the first; one if they agree."""
        total = self.nominal.torque.total
        known = np.flatnonzero(np.isfinite(total))
        by_speed = known[np.argsort(np.abs(self.nominal.inner_speed[known]), kind="stable")].tolist()
        first, last = by_speed[0], by_speed[-1]
        return [first] if total[first] == total[last] else [first, last]

    @property
    def failures(self) -> str:
        """How many samples failed and why, in words; empty where none did."""
        words = f"{self.failed} of {self.samples} samples have no torque and are left out: {'; '.join(self.reasons)}."
        return words if self.failed else ""

    def columns(self) -> dict[str, Array]:
        """The intervals of the total and of its parts, and what the total's is made of, each (n,), N m."""
        intervals = {"total": self.total, **self.parts}
        found = {f"{name}_{end}": values for name, each in intervals.items() for end, values in vars(each).items()}
        for name, (low, high) in self.made_of.items():
            found |= {f"by_{name}_low": low, f"by_{name}_high": high}
        return found | {"explained": self.explained}

    def to_dataset(self) -> Any:
        """An xarray.Dataset over operating points and inputs, SI, with units and meanings as attributes."""
        return dataset_of(
            self._columns,
            coordinates=self._points
            | {
                "input": Labelled(("input",), [each.key for each in self.inputs], Column("", "uncertain input")),
                "cause": Labelled(("cause",), list(self.made_of), Column("", "what alone is uncertain")),
            },
            attributes={**self.nominal.provenance, "samples": self.samples, "failed": self.failed, "seed": self.seed},
        )

    @property
    def _points(self) -> dict[str, Labelled]:
        """The operating points."""
        return {name: Labelled((POINT,), getattr(self.nominal, name), each) for name, each in COORDINATES.items()}

    @property
    def _columns(self) -> dict[str, Labelled]:
        """What is known at them and of the inputs."""
        torque = "friction torque"
        rows = {"torque_total": Labelled((POINT,), self.nominal.torque.total, Column("N m", torque))}
        for name, interval in {"total": self.total, **self.parts}.items():
            of = torque if name == "total" else f"{torque} by {name}"
            for end, values in vars(interval).items():
                rows[f"torque_{name}_{end}"] = Labelled((POINT,), values, Column("N m", f"{INTERVAL[end]}, {of}"))
        for end, words in enumerate(ENDS_IN_WORDS.items()):
            ends = [each[end] for each in self.made_of.values()]
            meaning = f"{words[1]} if nothing else were uncertain, {torque}"
            rows[f"made_of_{words[0]}"] = Labelled(("cause", POINT), ends, Column("N m", meaning))
        for name, values in vars(self.indices).items():
            kind, _, error = name.partition("_")
            meaning = f"{'standard error of the ' if error else ''}Sobol index of the {torque}, {kind}"
            rows[f"index_{name}"] = Labelled(("input", POINT), values, Column("1", meaning))
        explained = Column("1", "variance that the regression predicts")
        return rows | {"explained": Labelled((POINT,), self.explained, explained)}

    def _repr_html_(self) -> str:
        """A table for a notebook: the torque with its 95 % interval, and the inputs that make most of its width."""
        ends = {f"interval_{end}": self._columns[f"torque_total_{end}"] for end in ("low", "high")}
        columns = self._points | {"torque_total": self._columns["torque_total"]} | ends
        most = ", ".join(self.inputs[each].key for each in self.ranked[:MOST_INPUTS])
        return points_table(columns, caption=f"95 % interval by {self.samples} samples", notes=[f"Most by {most}."])

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame of the intervals: a row for each operating point, SI. Inputs stand in `to_dataset`."""
        return frame_of(self._points | self._columns, POINT)


def predict(
    scene: Scene | str | os.PathLike[str],
    *,
    tolerance: float | str | Quantity | None = None,
    samples: int | None = None,
    seed: int = SEED,
    workers: int | None = None,
    progress: Progress = silent,
    **given: Unpack[SceneOptions],
) -> Prediction:
    """The friction torque of a scene with its 95 % interval by Latin hypercube sampling.

    Parameters
    ----------
    scene : Scene, str or path
        As in `friction_torque`.
    tolerance : float or str, optional
        Of the torque, relative (dimensionless), as in `friction_torque`.
    samples : int, optional
        Number of evaluations of the torque; None: 512, and more, at most 4096, until the standard error of each end of
        the total's interval is at most 3 % of that end.
    seed : int
        Number that fixes the points.
    workers : int, optional
        Number of threads; None: one for each core that the process may use. The result does not depend on it.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and a text with the time left.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    Prediction
        Torque and ends of its interval, N m, (n,); Sobol indices, (d, n), of d inputs.

    Raises
    ------
    InputError
        As `friction_torque` for the scene; where nothing is uncertain; for fewer samples than the ends need; where more
        than 1 % of the samples have no torque.

    Notes
    -----
    Standard deviations are those of `scene.uncertainty`, else of the origins of bearing, oil and surface, else
    defaults (`analytic.prediction.spreads`). Effects and methods stay as they are decided for the scene itself.
    Source: indices by [Saltelli2010]; the interval is derived here (`analytic.prediction.interval`).
    """
    begun = perf_counter()
    scene = scene_by(scene, given)
    if tolerance is not None:
        scene = with_tolerance(scene, tolerance)
    nominal = friction_torque(scene)
    require_whole(low=1, workers=workers)
    require_whole(low=0, seed=seed)
    problem = _problem(scene, nominal, samples)
    scores = normal_points(len(problem.inputs))
    first = SAMPLES if samples is None else samples
    found = sampled(problem, count=first, seed=(seed, 0), workers=workers, progress=progress)
    while samples is None and found.count < MOST_SAMPLES:
        totals = found.torque[:, 0]
        error = interval_of(regression_of(found.scores, totals), scores, totals).largest_error
        if error <= ENOUGH:
            break
        # The error falls with the root of the number; a tenth more, so that the next round is the last one.
        more = ceil(found.count * min(1.0, 1.1 * (error / ENOUGH) ** 2 - 1))
        more = min(more, MOST_SAMPLES - found.count)
        seeds = (seed, found.count)
        found = found.together(sampled(problem, count=more, seed=seeds, workers=workers, progress=progress))
    totals = found.torque[:, 0]
    regression = regression_of(found.scores, totals)
    parts = {}
    for name, values in zip(problem.parts[1:], np.moveaxis(found.torque[:, 1:], 1, 0), strict=True):
        parts[name] = interval_of(regression_of(found.scores, values), scores, values)
    return Prediction(
        nominal=nominal,
        inputs=problem.inputs,
        total=interval_of(regression, scores, totals),
        parts=MappingProxyType(parts),
        made_of=MappingProxyType(_made_of(regression, scores, problem, nominal.torque.total)),
        indices=indices_of(regression, found.scores, totals),
        explained=regression.explained,
        samples=found.count,
        failed=found.failed,
        reasons=found.reasons,
        seed=seed,
        seconds=perf_counter() - begun,
        evaluation_seconds=found.seconds,
    )


def predicted_interval(scene: Scene, nominal: FrictionTorque, *, samples: int) -> Interval:
    """The interval of the total alone, computed in this process; nominal, errors : as in `predict`."""
    problem = _problem(scene, nominal, samples)
    found = sampled(problem, count=samples, seed=(SEED, 0), workers=1, progress=silent)
    totals = found.torque[:, 0]
    return interval_of(regression_of(found.scores, totals), normal_points(len(problem.inputs)), totals)


def require_samples(samples: int, inputs: tuple[UncertainInput, ...]) -> None:
    """Raises InputError for fewer samples than an interval and its regression need, or too many."""
    require_whole(low=1, samples=samples)
    least = least_samples(len(inputs))
    if samples < least:
        raise InputError(
            f"samples = {samples}: an interval of {100 * COVERED:g} % with {len(inputs)} uncertain inputs "
            f"needs at least {least}; {SAMPLES} are usual"
        )
    if samples > LARGEST_SAMPLE:
        raise InputError(f"samples = {shown(samples)}: at most {LARGEST_SAMPLE}; {SAMPLES} are usual")


def _problem(scene: Scene, nominal: FrictionTorque, samples: int | None) -> Problem:
    """What is evaluated. Raises InputError for what has no interval, or too few samples for one."""
    problem = problem_of(scene, nominal, uncertain_inputs(scene))
    if not problem.inputs:
        raise InputError("no input of the scene is uncertain, so there is no interval: see [uncertainty]")
    if samples is not None:
        require_samples(samples, problem.inputs)
    return problem


def _made_of(regression: Regression, scores: Array, problem: Problem, nominal: Array) -> dict[str, Array]:
    """The interval of the total if only some inputs are uncertain, each (2, n); nominal : (n,), N m.

    The numerical factor is lognormal, so that its interval is known; the others are those of the regression.
    """
    keys = [each.key for each in problem.inputs]
    kinds = np.array([each.kind for each in problem.inputs])
    missed = nominal - regression.at(np.zeros((1, len(keys))))  # by the regression where every input has its value
    groups = {kind: kinds == kind for kind in ("input", "model") if np.any(kinds == kind)}
    groups |= {key: np.array(keys) == key for key in keys if key.startswith("model.")}
    ends = {}
    if NUMERICAL in keys:
        ends[NUMERICAL] = nominal * np.exp(np.multiply.outer(ndtri(ENDS), problem.numerical))
    for name, varies in groups.items():
        values = regression.at(np.where(varies, scores, 0.0))
        ends[name] = np.quantile(values, ENDS, axis=0) + missed
    return ends
