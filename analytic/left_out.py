"""Operating points of a scene that have no torque: which they are and why, and their places in what is shown."""

from collections.abc import Sequence
from dataclasses import dataclass, fields, is_dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.columns import COORDINATES
from analytic.errors import FembearingError
from analytic.prediction.formulas import with_model_uncertainty
from analytic.result import FrictionTorque
from analytic.rows import OperatingPoint
from analytic.scene import Array, Scene
from analytic.torque import friction_torque


@dataclass(frozen=True, kw_only=True)
class LeftOut(OperatingPoint):
    """An operating point without a torque."""

    point: int  # number of the operating point, from 0
    reason: str  # why, in words


@dataclass(frozen=True, kw_only=True)
class Places:
    """The operating points of a scene, some of which have no torque."""

    size: int  # number of all
    left_out: tuple[LeftOut, ...]

    @property
    def computed(self) -> list[int]:
        """The numbers of the points that have a torque, from 0."""
        return sorted({*range(self.size)} - {each.point for each in self.left_out})

    def columns(self, computed: dict[str, Array]) -> dict[str, Array]:
        """Columns over all points: speed and loads are known everywhere, all else is NaN where there is no torque.

        computed : each (m,), over the points that have a torque
        """
        whole = {name: np.full(self.size, np.nan) for name in computed}
        for name, values in computed.items():
            whole[name][self.computed] = values
        for each in self.left_out:
            for name in COORDINATES & whole.keys():
                whole[name][each.point] = getattr(each, name)
        return whole

    def rows(self, computed: Sequence[Any]) -> tuple[Any, ...]:
        """The same for rows: with NaN in the place of every number that is not known, and None of all else."""
        whole = [_without_values(computed[0])] * self.size
        for point, row in zip(self.computed, computed, strict=True):
            whole[point] = row
        for each in self.left_out:
            if isinstance(computed[0], OperatingPoint):
                whole[each.point] = replace(whole[each.point], **{name: getattr(each, name) for name in COORDINATES})
        return tuple(whole)


def torque_where_it_is(scene: Scene) -> tuple[Scene, FrictionTorque, tuple[LeftOut, ...]]:
    """The scene where it has a torque, the torque with its model uncertainty, and the other operating points.

    Raises the error of the first point where none has a torque.
    """
    operation = scene.operation.as_series()
    every = np.arange(operation.inner_speed.size)
    problems: dict[int, FembearingError] = {}

    def at(points: NDArray[np.intp]) -> Scene:
        return replace(scene, operation=operation.at(points))

    def try_out(points: NDArray[np.intp]) -> FrictionTorque | None:
        try:
            return _torque(at(points))
        except FembearingError as problem:
            if points.size == 1:
                problems[int(points[0])] = problem
            else:
                for half in np.array_split(points, 2):
                    try_out(half)
            return None

    friction = try_out(every)
    if friction is not None:
        return scene, friction, ()
    if len(problems) == every.size:
        raise problems[0]
    kept = at(np.delete(every, [*problems]))
    left_out = tuple(
        LeftOut(
            point=point,
            reason=str(problem),
            **{name: float(getattr(operation, name)[point]) for name in COORDINATES},
        )
        for point, problem in sorted(problems.items())
    )
    return kept, _torque(kept), left_out


def _torque(scene: Scene) -> FrictionTorque:
    return with_model_uncertainty(scene, friction_torque(scene).settled())


def _without_values(node: Any) -> Any:
    match node:
        case dict():
            return {name: _without_values(inside) for name, inside in node.items()}
        case tuple():
            return tuple(_without_values(inside) for inside in node)
        case float():
            return np.nan
    if is_dataclass(node) and not isinstance(node, type):
        parts = {part.name: getattr(node, part.name) for part in fields(node)}
        return replace(node, **{name: _without_values(part) for name, part in parts.items()})
    return None
