"""Energy and torque of a duty cycle, with their 95 % intervals.

A step of duration t at the speed w takes the energy |w| t M. The errors of oil, surfaces, loads and formulas are those
of one bearing: in all steps they are the same, and the intervals of the steps do not average out. So each uncertain
input moves to both ends of its 95 % in all steps together, and energy, mean and worst torque are computed anew with the
moved torques. The changes of their logarithms by different inputs, which are independent, add up in squares, as in
`analytic.prediction.first_order`.
"""

import os
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from time import perf_counter
from typing import Annotated, Any, NamedTuple, Unpack

import numpy as np
from annotated_types import MinLen
from numpy.typing import NDArray

from analytic.brief import Brief
from analytic.errors import InputError
from analytic.given import SceneOptions
from analytic.prediction.first_order import MovedTotals, end_factors, moved_totals
from analytic.prediction.steady import SteadyTemperature, steady_temperature, with_steady_oil
from analytic.result import FrictionTorque
from analytic.rows import NotNegative, OperatingPoint, Positive
from analytic.scene import Array, Scene
from analytic.scenefile.columns import Cycle, operating_points, read_cycle, require_loads
from analytic.scenefile.find import require_no_data
from analytic.scenefile.read import SceneByTemperature, load_by_temperature
from analytic.torque import friction_torque
from analytic.words import torque_of

Places = NDArray[np.intp]
Torques = tuple[tuple[Scene, FrictionTorque], ...]  # of the turning steps of each temperature, with their scene


@dataclass(frozen=True, kw_only=True)
class Estimate:
    """A number with its 95 % interval to first order."""

    value: NotNegative  # with the inputs as they are, in the unit of the quantity
    low: NotNegative | None  # lower end, in the same unit; None: an input at its end leaves no torque
    high: NotNegative | None  # upper end, in the same unit; likewise


@dataclass(frozen=True, kw_only=True)
class DutyStep(OperatingPoint):
    """A step of a duty cycle."""

    duration: Positive  # s
    temperature: float | None  # of the oil, K; None: the scene has no oil
    torque: Estimate  # N m; 0 in a pause
    power: NotNegative  # W
    energy: NotNegative  # J


@dataclass(frozen=True, kw_only=True)
class DutyCycle(Brief):
    """What a bearing loses in a duty cycle."""

    scene: str  # its name
    file: str  # of the cycle
    steps: Annotated[tuple[DutyStep, ...], MinLen(1)]
    duration: Positive  # of the cycle, s
    energy: Estimate  # of friction in one cycle, J
    mean_torque: Estimate  # energy over the angle that the ring turns, N m
    worst_torque: Estimate  # the largest of all steps, N m; each end is that of the then worst step
    worst_step: int  # number of its step, from 0
    mean_power: Estimate  # energy over the duration with its pauses, W
    steady: SteadyTemperature | None  # of the oil; None: the temperatures are given, or there is no oil
    warnings: tuple[str, ...]  # of the computed torques
    seconds: NotNegative  # that the computation took

    def _facts(self) -> Iterator[str]:
        yield from (self.file, f"{len(self.steps)} steps", f"{self.energy.value:.4g} J")
        yield f"mean torque {torque_of(self.mean_torque.value)}"


class Steps(NamedTuple):
    """The steps of a cycle in numbers, each (n,)."""

    duration: Array  # s
    points: Mapping[str, Array]  # loads and speed, SI
    temperature: Array | None  # K

    @property
    def turned(self) -> Array:
        """Angle that the ring turns in each step, rad."""
        return np.abs(self.points["inner_speed"]) * self.duration


class Group(NamedTuple):
    """The steps of one temperature, equal ones computed once."""

    places: Places  # (k,) numbers of the steps
    which: Places  # (k,) numbers of their points in `totals`
    totals: MovedTotals


class Computed(NamedTuple):
    """The torques of all steps, (n,), 0 in a pause."""

    torque: Array  # N m
    totals: MovedTotals | None  # the same as the inputs move; None: no interval
    warnings: tuple[str, ...]
    results: Torques


def duty_cycle(
    scene: str | os.PathLike[str] | Scene, cycle: str | os.PathLike[str], **given: Unpack[SceneOptions]
) -> DutyCycle:
    """Energy, torque and power of a bearing in a duty cycle, each with its 95 % interval.

    Parameters
    ----------
    scene : str, path or Scene
        What `load_scene` reads. What a step does not say is that of the scene; a bearing of the catalog has no usual
        load beside the loads of the steps.
    cycle : str or path
        CSV or .xlsx file, each column with its unit: duration, and one or more of inner_speed, axial_load, radial_load
        and temperature (docs/how-to/duty-cycle.md).
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`, as settings={"lubricant.supply": "grease"}.

    Returns
    -------
    DutyCycle
        Energy, J, torques, N m, and power, W, of the cycle, and a row for each step.

    Raises
    ------
    InputError
        A file that cannot be read, a wrong column or row, a quantity that neither a step nor the scene gives, a cycle
        in which nothing turns; and as `friction_torque`.
    ConvergenceError
        As `friction_torque` and `steady_scene`.

    Notes
    -----
    Every step is steady: inertia, and the time that films and temperatures take to follow, are neglected. With
    [thermal] the oil has one temperature, steady under the mean power of the cycle, which holds for cycles that are
    short beside the time that the bearing takes to warm. The interval keeps that temperature, with its usual spread.
    The interval is to first order, with the errors of each input the same in all steps.
    """
    require_no_data(scene)
    read = read_cycle(cycle)
    return cycle_with_torques(load_by_temperature(scene, columns=vars(read), **given), read)[0]


def cycle_with_torques(found: SceneByTemperature, cycle: Cycle) -> tuple[DutyCycle, Torques]:
    """What `duty_cycle` returns, of a scene and a cycle that are read, and the torques that it is computed from."""
    begun = perf_counter()
    steps = _steps(found, cycle)
    steady = None
    if found.thermal is not None:
        power = partial(_mean_power, found, steps)
        steady = steady_temperature(power, found.thermal, tolerance=found.scene.tolerance)
        warm = with_steady_oil(found, steady)
        found = replace(found, scene=warm, thermal=None)
    computed = _computed(found, steps, with_interval=True)
    result = DutyCycle(
        scene=found.scene.name,
        file=Path(cycle.file).name,
        steps=tuple(_rows(found.scene, steps, computed)),
        duration=float(steps.duration.sum()),
        **_of_cycle(steps, computed),
        worst_step=int(np.argmax(computed.torque)),
        steady=steady,
        warnings=(*cycle.warnings, *computed.warnings),
        seconds=perf_counter() - begun,
    )
    return result, computed.results


def _steps(found: SceneByTemperature, cycle: Cycle) -> Steps:
    """Raises InputError for what neither cycle nor scene gives, for steps without a load, and where nothing turns."""
    if found.thermal is not None and cycle.temperature is not None:
        raise InputError(
            f"{cycle.file}: the column temperature and [thermal] of the scene both determine the oil temperature: "
            "leave one of them out"
        )
    points = operating_points(found.scene, cycle.file, vars(cycle), cycle.duration.size)
    steps = Steps(cycle.duration, points, cycle.temperature)
    if not steps.turned.any():
        raise InputError(f"{cycle.file}: nothing turns in any step; give inner_speed")
    require_loads(found.scene, cycle.file, {name: np.where(steps.turned > 0, points[name], 1.0) for name in points})
    return steps


def _mean_power(found: SceneByTemperature, steps: Steps, temperature: float) -> float:
    """Of friction with all oil at one temperature, K; W, over the whole cycle."""
    warm = replace(found, scene=found.at(temperature))
    return float(steps.turned @ _computed(warm, steps, with_interval=False).torque / steps.duration.sum())


def _computed(found: SceneByTemperature, steps: Steps, *, with_interval: bool) -> Computed:
    """The torques of all steps; equal steps are computed once."""
    torque, scenes = np.zeros(steps.duration.size), [*_scenes(found, steps)]
    warnings: list[str] = []
    results: list[tuple[Scene, FrictionTorque]] = []
    groups: list[Group] = []
    for places, scene in scenes:
        names = tuple(steps.points)
        given = np.array([steps.points[name][places] for name in names])
        different, which = np.unique(given, axis=1, return_inverse=True)
        at_them = replace(scene, operation=replace(scene.operation, **dict(zip(names, different, strict=True))))
        result = friction_torque(at_them)
        torque[places] = result.torque.total[which]
        warnings += result.warnings
        every = replace(scene, operation=replace(scene.operation, **dict(zip(names, given, strict=True))))
        results.append((every, result.at(which)))
        totals = moved_totals(at_them, result) if with_interval else None
        if totals is not None:
            groups.append(Group(places, which, totals))
    totals = _joined(torque.size, groups) if len(groups) == len(scenes) else None
    return Computed(torque, totals, tuple(dict.fromkeys(warnings)), tuple(results))


def _scenes(found: SceneByTemperature, steps: Steps) -> Iterator[tuple[Places, Scene]]:
    """The turning steps of each temperature, and the scene there."""
    turning = np.flatnonzero(steps.turned)
    if steps.temperature is None:
        yield turning, found.scene
        return
    for temperature in np.unique(steps.temperature[turning]).tolist():
        yield turning[steps.temperature[turning] == temperature], found.at(temperature)


def _joined(count: int, groups: list[Group]) -> MovedTotals:
    """The totals of all steps; an input that a group does not have does not move it."""
    base, moved = np.zeros(count), {}
    for places, which, totals in groups:
        base[places] = totals.base[which]
        moved |= dict.fromkeys(totals.moved)
    moved = {key: np.array([base, base]) for key in moved}
    for places, which, totals in groups:
        for key, ends in totals.moved.items():
            moved[key][:, places] = ends[:, which]
    return MovedTotals(base, moved)


def _of_cycle(steps: Steps, computed: Computed) -> dict[str, Estimate]:
    """Energy, mean and worst torque and mean power."""
    turned = steps.turned

    def energy_and_worst(torque: Array) -> Array:
        """(..., 2) of (..., n)."""
        return np.stack([torque @ turned, torque.max(axis=-1)], axis=-1)

    energy, worst = energy_and_worst(computed.torque).tolist()
    low = high = np.full(2, np.nan)
    if computed.totals is not None:
        moved = map(energy_and_worst, computed.totals.moved.values())
        low, high = end_factors(energy_and_worst(computed.totals.base), moved)
    of_energy, of_worst = ((low[place], high[place]) for place in range(2))
    return {
        "energy": _estimate(energy, of_energy),
        "mean_torque": _estimate(energy / float(turned.sum()), of_energy),
        "worst_torque": _estimate(worst, of_worst),
        "mean_power": _estimate(energy / float(steps.duration.sum()), of_energy),
    }


def _rows(scene: Scene, steps: Steps, computed: Computed) -> Iterator[DutyStep]:
    torque, totals = computed.torque, computed.totals
    ends = np.full((2, torque.size), np.nan) if totals is None else end_factors(totals.base, totals.moved.values())
    own = None if scene.lubricant is None else scene.lubricant.temperature
    for place, value in enumerate(torque.tolist()):
        power = value * abs(float(steps.points["inner_speed"][place]))
        yield DutyStep(
            **{name: float(values[place]) for name, values in steps.points.items()},
            duration=float(steps.duration[place]),
            temperature=own if steps.temperature is None else float(steps.temperature[place]),
            torque=_estimate(value, ends[:, place]),
            power=power,
            energy=power * float(steps.duration[place]),
        )


def _estimate(value: float, factors: Any) -> Estimate:
    """factors : of both ends, NaN where there is no interval."""
    low, high = (float(value * factor) for factor in factors)
    return Estimate(value=value, low=None if np.isnan(low) else low, high=None if np.isnan(high) else high)
