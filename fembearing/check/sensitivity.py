"""Which inputs move a scene's torque most: one at a time, to both ends of its 95 % range.

The inputs and their spreads are those of an interval (`analytic.prediction.spreads`). Where the scene gives no
friction, the peak pressure of both races takes the torque's place. Inputs are not moved together. The cage rests.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from statistics import NormalDist
from typing import Annotated, Literal

import numpy as np
from annotated_types import MinLen

from analytic.columns import COORDINATES
from analytic.contact.geometry import RACES
from analytic.errors import FembearingError
from analytic.prediction.evaluation import moved_scene, problem_of, torque_at
from analytic.prediction.spreads import UncertainInput, uncertain_inputs
from analytic.rows import OperatingPoint
from analytic.scene import Array, Scene
from analytic.torque import friction_torque
from analytic.units import unit_for
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.scene_contact import bearings_of, heaviest_contact

SAME = 1e-9  # relative: torques at two points that differ by less are one
END = NormalDist().inv_cdf(0.975)  # standard deviations from the value to an end of its 95 % range


@dataclass(frozen=True, kw_only=True)
class Output:
    """What the inputs change."""

    quantity: Literal["total_torque", "peak_pressure"]  # what is compared
    pair: Literal["inner", "outer"] | None  # None of a torque
    inner_speed: float | None  # rad/s, None of a pressure, which is the heaviest ball's at any point
    axial_load: float | None  # N, likewise
    radial_load: float | None  # N, likewise
    moment: float | None  # N m, likewise
    value: float  # N m or Pa

    @property
    def point(self) -> OperatingPoint | None:
        """The operating point of a torque; None of a pressure."""
        numbers = {name: value for name in COORDINATES if (value := getattr(self, name)) is not None}
        return OperatingPoint(**numbers) if len(numbers) == len(COORDINATES) else None


@dataclass(frozen=True, kw_only=True)
class Input:
    """One input with its range, SI, and what its ends do to each output, relative; None at an end that is refused."""

    name: str  # as readers see it
    unit: str  # of the next three; "1" without a dimension
    value: float  # the scene's, SI
    low: float  # end of the range, SI
    high: float  # end of the range, SI
    source: str  # of the range
    change_low: tuple[float, ...] | None  # of each output, relative
    change_high: tuple[float, ...] | None  # of each output, relative
    refused: tuple[str, ...]  # why an end was

    @property
    def swing(self) -> float:
        """The largest change of any output, relative."""
        changes = [*(self.change_low or ()), *(self.change_high or ())]
        return max(map(abs, changes), default=0.0)


@dataclass(frozen=True, kw_only=True)
class Sensitivity:
    """Outputs, and inputs from the one that moves them most."""

    outputs: Annotated[tuple[Output, ...], MinLen(1)]
    inputs: tuple[Input, ...]


def sensitivity_of(scene: Scene) -> Sensitivity:
    """Sensitivity at the slowest and the fastest operating point.

    Among points of equal speed the slowest is that with the least load and the fastest that with the largest. Where
    both have the same torque, the first is shown alone. Effects and methods stay as they were decided there.
    Raises InputError as friction_torque and heaviest_contact do for the scene itself. Where they refuse an end of a
    range, that end has the reason in place of a change.
    """
    inputs, values_at, outputs = _torques(scene) if scene.has_friction else _pressures(scene)
    base = values_at(np.zeros(len(inputs)))
    moved = [
        _moved(each, base, lambda score, place=place: values_at(score * np.eye(len(inputs))[place]))
        for place, each in enumerate(inputs)
    ]
    return Sensitivity(outputs=tuple(outputs), inputs=tuple(sorted(moved, key=lambda each: each.swing, reverse=True)))


def _moved(given: UncertainInput, base: Array, values_at: Callable[[float], Array]) -> Input:
    """One input at both ends of its range; values_at : its score gives the outputs, whose values now are `base`."""
    unit = given.unit.replace("*", " ") or "1"
    ends = [float(given.at(np.asarray(score))) for score in (-END, END)]
    changes: list[tuple[float, ...] | None] = [None, None]
    refused = []
    for end, score in enumerate((-END, END)):
        try:
            after = values_at(score)
        except FembearingError as problem:
            refused.append(f"{unit_for(unit, given.value).written(ends[end], '.4g')}: {problem}")
        else:
            changes[end] = tuple((np.divide(after, base, out=np.ones_like(base), where=base != 0) - 1).tolist())
    return Input(
        name=given.key,
        unit=unit,
        value=given.value,
        low=ends[0],
        high=ends[1],
        source=given.source,
        change_low=changes[0],
        change_high=changes[1],
        refused=tuple(refused),
    )


Varied = tuple[tuple[UncertainInput, ...], Callable[[Array], Array], list[Output]]  # inputs, outputs at a score, names


def _torques(scene: Scene) -> Varied:
    operation = scene.operation.as_series()
    order = np.lexsort((operation.axial_load, np.abs(operation.inner_speed)))
    ends = np.array(list(dict.fromkeys([order[0], order[-1]])))
    # A cage whose pockets are too narrow for its balls moves with them unless both are off: minutes for each input.
    at_rest = {"cage_dynamics": "off", "ball_dynamics": "off"}
    varied = replace(scene, operation=operation.at(ends), effects={**scene.effects, **at_rest})
    friction = friction_torque(varied)
    problem = problem_of(varied, friction, uncertain_inputs(varied))
    shown = slice(1 if np.ptp(friction.torque.total) <= SAME * friction.torque.total.max() else None)
    outputs = [
        Output(
            quantity="total_torque",
            pair=None,
            **{name: float(getattr(friction, name)[point]) for name in COORDINATES},
            value=float(value),
        )
        for point, value in enumerate(friction.torque.total[shown])
    ]
    return problem.inputs, lambda score: torque_at(problem, score)[0, shown], outputs


def _pressures(scene: Scene) -> Varied:
    inputs = uncertain_inputs(scene)

    def peaks(score: Array) -> Array:
        moved, _ = moved_scene(scene, inputs, score)
        bearings = [each.scene for each in bearings_of(moved)]
        return np.array(
            [max(hertz_quantities(heaviest_contact(each, race)).peak_pressure for each in bearings) for race in RACES]
        )

    outputs = [
        Output(quantity="peak_pressure", pair=race, value=float(value), **dict.fromkeys(COORDINATES))
        for race, value in zip(RACES, peaks(np.zeros(len(inputs))), strict=True)
    ]
    return inputs, peaks, outputs
