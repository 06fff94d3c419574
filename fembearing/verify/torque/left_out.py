"""Operating points of a scene that have no torque: which they are and why, and their places in what is shown."""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.errors import FembearingError
from analytic.prediction.formulas import with_model_uncertainty
from analytic.result import COORDINATES, FrictionTorque
from analytic.scene import Array, Scene
from analytic.torque import friction_torque


@dataclass(frozen=True, kw_only=True)
class LeftOut:
    """An operating point without a torque."""

    point: int  # number of the operating point, from 0
    inner_speed: float  # rad/s
    axial_load: float  # N
    radial_load: float  # N
    moment: float  # N m
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
            for name in COORDINATES:
                whole[name][each.point] = getattr(each, name)
        return whole

    def rows(self, computed: Sequence[Any]) -> list[Any]:
        """The same for rows of JSON: with None in the place of every number that is not known."""
        whole = [_without_values(computed[0])] * self.size
        for point, row in zip(self.computed, computed, strict=True):
            whole[point] = row
        for each in self.left_out:
            if isinstance(computed[0], dict):
                known = {name: getattr(each, name) for name in COORDINATES if name in computed[0]}
                whole[each.point] = whole[each.point] | known
        return whole

    def to_json(self) -> list[dict[str, Any]]:
        """Each point without a torque, SI."""
        return [asdict(each) for each in self.left_out]


def torque_where_it_is(scene: Scene) -> tuple[Scene, FrictionTorque, tuple[LeftOut, ...]]:
    """The scene where it has a torque, the torque with its model uncertainty, and the other operating points.

    Raises the error of the first point where none has a torque.
    """
    operation = scene.operation.as_series()
    every = np.arange(operation.inner_speed.size)
    problems: dict[int, FembearingError] = {}

    def at(points: NDArray[np.intp]) -> Scene:
        return replace(
            scene, operation=replace(operation, **{name: each[points] for name, each in vars(operation).items()})
        )

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
    return with_model_uncertainty(scene, friction_torque(scene))


def _without_values(node: Any) -> Any:
    match node:
        case dict():
            return {name: _without_values(inside) for name, inside in node.items()}
        case list():
            return [_without_values(inside) for inside in node]
    return None
