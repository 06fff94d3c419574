"""The friction torque over speed, loads and oil temperature, with its 95 % interval to first order.

The torque is that of `analytic.torque_function`, one for each temperature, with the oil that the scene's table has
there.

The interval is an estimate, and its ends over the torque vary less than the torque. So they are computed with
`spin_rule` "balanced", at up to NODES values of each axis, and between these
their logarithms are linear. Of a 6206 in oil, 1 to 4 kN, 40 to 80 degC, the ends from 12 of 16 speeds, 3 of 5 loads and
3 of 5 temperatures are up to 15 % off those of every node, 90 % of them less than 4.1 %. Free balls change them by up
to 6 %.

A bearing that stands has the torque at which it begins to turn. The model has it as its limit for small speeds: there
the films vanish and the whole load is on asperities, or on the given coefficient. It is computed at CREEPING times the
first speed above 0.
"""

import math
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from analytic.errors import InputError
from analytic.function import AT_REST, TorqueFunction, torque_function
from analytic.prediction.first_order import first_order_ends
from analytic.progress import Progress, silent
from analytic.result import FrictionTorque
from analytic.scene import Array, Operation, Scene
from analytic.scenefile.read import SceneByTemperature
from analytic.torque import friction_torque
from fembearing.formats.axes import SLOWEST, Axes

OF_OPERATION = {"speed": "inner_speed", "axial_load": "axial_load", "radial_load": "radial_load"}
CREEPING = 1e-6  # speed at which a bearing begins to turn, over the first speed of the axis above 0
NODES = {"speed": 20, "axial_load": 3, "radial_load": 3, "temperature": 3}  # most of an axis, that have an interval
LOW, NOMINAL, HIGH = range(3)


class TorqueOverAxes:
    """Torques of a scene at points of its axes, by one torque function for each temperature of the oil."""

    def __init__(self, found: SceneByTemperature, axes: Axes) -> None:
        """Raises InputError and ConvergenceError as `torque_function`."""
        scene = found.scene
        self.moment = _moment(scene)
        ends = {name: values[[0, -1]] for name, values in axes.items() if name in OF_OPERATION}
        own = torque_function(replace(scene, operation=_operation(ends, scene.operation)))
        self.found = replace(found, scene=own.scene)  # whose cage rests
        oil = own.scene.lubricant
        self._functions: dict[float, TorqueFunction] = {0.0 if oil is None else oil.temperature: own}

    def at(self, points: Axes) -> Array:
        """Torques, (n,), N m, at points, (n,) of each axis, rad/s, N and K. Raises as `torque_function`."""
        count = points["speed"].size
        temperature = points.get("temperature", np.zeros(count))
        torques = np.empty(count)
        for warm in np.unique(temperature).tolist():
            at = temperature == warm
            given = {OF_OPERATION[name]: values[at] for name, values in points.items() if name in OF_OPERATION}
            torques[at] = self._function(warm).series(**given, moment=self.moment)
        return torques

    def _function(self, temperature: float) -> TorqueFunction:
        if temperature not in self._functions:
            self._functions[temperature] = torque_function(self.found.at(temperature))
        return self._functions[temperature]


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueMap:
    """Torques at every product of the values of some axes."""

    scene: Scene
    axes: Axes
    torque: Array  # (3, *sizes of the axes) low, nominal and high, N m
    law: TorqueOverAxes  # that the nominal torque is of

    @property
    def nominal(self) -> Array:
        """The torque, of the shape of the axes, N m."""
        return self.torque[NOMINAL]

    @cached_property
    def curve(self) -> tuple[Array, Array]:
        """Speeds (s,), rad/s, and torques (3, s), N m, of a map with one load and temperature."""
        return self.axes["speed"], self.torque.reshape(3, -1)


def mapped_torque(found: SceneByTemperature, axes: Axes, *, progress: Progress = silent) -> TorqueMap:
    """The torque of a scene over axes.

    found : without [thermal], which has one temperature
    axes : of `fembearing.formats.axes.axes_of`
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError and ConvergenceError as `torque_function` at its points, and InputError as `found.at`, and where
    an uncertain input at its end leaves no torque.
    """
    progress(0.0, "torque")
    law = TorqueOverAxes(found, axes)
    moving = {**axes, "speed": moving_speeds(axes["speed"])}
    nominal = law.at(_product(moving)).reshape([values.size for values in axes.values()])
    low, high = nominal * np.exp(_interval(law, moving, progress))
    return TorqueMap(scene=found.scene, axes=axes, torque=np.stack([low, nominal, high]), law=law)


def moving_speeds(speeds: Array) -> Array:
    """Speeds with that of a bearing which begins to turn in the place of 0; of 0 alone it is CREEPING rad/s."""
    above = speeds[speeds > 0]
    return np.where(speeds > 0, speeds, CREEPING * (above[0] if above.size else 1.0))


def from_standstill(axes: Axes) -> Axes:
    """The same axes with speed 0 and slow ones, each twice the one before, in front: what models of motion need.

    Films form, and the torque falls by half, long before the first speed of an even range.
    Raises InputError for a table without a speed above 0.
    """
    above = axes["speed"][axes["speed"] > 0]
    if not above.size:
        raise InputError("the table has speed 0 alone; give speed as a range, for example '0 rpm to 6000 rpm in 15'")
    steps = max(math.ceil(math.log2(above[0] / (SLOWEST * above[-1]))), 0)
    return {**axes, "speed": np.concatenate([[0.0], above[0] * 2.0 ** -np.arange(steps, 0, -1), above])}


def _product(axes: Axes) -> dict[str, Array]:
    """Every product of the values of the axes, (n,) of each."""
    grid = np.meshgrid(*axes.values(), indexing="ij")
    return {name: values.ravel() for name, values in zip(axes, grid, strict=True)}


def torques_at_nodes(found: SceneByTemperature, axes: Axes) -> list[tuple[Scene, FrictionTorque]]:
    """The torque with limits and solver error at up to NODES values of each axis, and the scene of each temperature.

    The cage rests on its balls, as in the map. Raises InputError and ConvergenceError as `friction_torque`.
    """
    moving = {**axes, "speed": moving_speeds(axes["speed"])}
    chosen = {name: moving[name][places] for name, places in _places(moving).items()}
    temperatures = chosen.pop("temperature", [None])
    own = replace(found, scene=replace(found.scene, operation=_operation(chosen, found.scene.operation)))
    scenes = [own.scene if each is None else own.at(float(each)) for each in temperatures]
    still = [replace(scene, effects={**scene.effects, **AT_REST}) for scene in scenes]
    return [(scene, friction_torque(scene)) for scene in still]


def _moment(scene: Scene) -> float:
    """The one moment of a scene, N m."""
    return float(np.ravel(scene.operation.as_series().moment)[0])


def _places(axes: Axes) -> dict[str, NDArray[np.intp]]:
    """Numbers of up to NODES values of each axis, with its ends."""
    return {
        name: np.unique(np.linspace(0, values.size - 1, min(NODES[name], values.size)).round().astype(int))
        for name, values in axes.items()
    }


def _operation(axes: Axes, own: Operation) -> Operation:
    """Every product of speeds and loads, with the one moment or tilt of the scene's own operation."""
    points = {OF_OPERATION[name]: values for name, values in _product(axes).items()}
    return replace(own, **points, moment=np.full(points["inner_speed"].size, np.ravel(own.moment)[0]))


def _interval(law: TorqueOverAxes, axes: Axes, progress: Progress) -> Array:
    """(2, *sizes) logarithm of both ends of the interval over the torque."""
    places = _places(axes)
    chosen = {name: values[places[name]] for name, values in axes.items()}
    sizes = [values.size for values in chosen.values()]
    temperatures = chosen.pop("temperature", [None])
    settled = law.found.scene
    balanced = replace(settled, operation=_operation(chosen, settled.operation), spin_rule="balanced")
    found = []
    for number, temperature in enumerate(temperatures):
        progress((1 + number) / (1 + len(temperatures)), "interval")
        there = replace(law.found, scene=balanced)
        found.append(_logarithms(balanced if temperature is None else there.at(float(temperature))))
    values = np.stack(found, axis=-1).reshape(2, *sizes)
    for axis, (name, at) in enumerate(places.items(), start=1):
        every = np.arange(axes[name].size)
        values = np.apply_along_axis(lambda known, every=every, at=at: np.interp(every, at, known), axis, values)
    return values


def _logarithms(scene: Scene) -> Array:
    """(2, n) of both ends over the torque at the scene's points; 0 where nothing resists."""
    nominal = friction_torque(scene)
    ends = first_order_ends(scene, nominal)
    if ends is None:
        raise InputError(
            "the torque has no interval in this range: an uncertain input at its end leaves no torque; narrow the "
            "range of the loads, or give smaller spreads in [uncertainty]"
        )
    total = nominal.torque.total
    return np.log(np.divide(ends, total, out=np.ones_like(ends), where=total > 0))
