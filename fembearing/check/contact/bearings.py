"""The bearings of a scene, each as a scene of its own under the loads that it takes."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from analytic.pair import pair_in_series
from analytic.scene import Scene

OfPair = Literal["first", "second"]
NAMES: tuple[OfPair, OfPair] = ("first", "second")  # as in the torque of a pair


def which_bearing(name: str | None) -> str:
    """What follows the name of a part of one bearing; empty where there is one."""
    return "" if name is None else f" of the {name} bearing"


def place_of(pair: str, geometry: str, bearing: str | None = None) -> str:
    """Where the ball sits, for example "ball on inner race"; bearing : "first" or "second" of a pair"""
    if pair == "pocket":
        return "ball in cage pocket, " + ("sheet on its rim" if geometry == "wall" else "thick seat")
    return f"ball on {pair} race{which_bearing(bearing)}" + (", idealised" if geometry == "hertzian" else "")


@dataclass(frozen=True, kw_only=True, eq=False)
class OneBearing:
    """One bearing at the operating points at which its inner ring presses."""

    name: OfPair | None  # None: the scene has one
    scene: Scene  # without arrangement
    points: NDArray[np.intp]  # numbers of its operating points in the scene, from 0


def bearings_of(scene: Scene) -> list[OneBearing]:
    """The bearing of a scene, or those of a pair, with loads by Hertz's contacts.

    A bearing whose inner ring presses nowhere is not among them. Raises InputError as friction_torque does.
    """
    if scene.arrangement is None:
        return [OneBearing(name=None, scene=scene, points=np.arange(scene.operation.as_series().inner_speed.size))]
    return list(_of_pair(scene))


def _of_pair(scene: Scene) -> Iterator[OneBearing]:
    assert scene.arrangement is not None
    by_hertz = replace(scene, effects={**scene.effects, "finite_geometry": "off"})
    both = pair_in_series(by_hertz, scene.arrangement, None)
    for name, points, rows in zip(NAMES, both.points, both.rows, strict=True):
        if points.size:
            operation = both.scene.operation.as_series().at(rows)
            yield OneBearing(name=name, scene=replace(scene, arrangement=None, operation=operation), points=points)
