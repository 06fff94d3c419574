"""The friction torque of two bearings on one shaft: the sum over both, each under the loads that it takes.

Both are computed as one series of operating points. Where a bearing is relieved, centrifugal force may still press its
balls on the inner ring, which gives it the torque of that load. Where the inner ring presses on no ball, only what the
scene declares is left: how far balls and cage are dragged along is not known.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from analytic.brief import points_of
from analytic.contact.factors import ContactCorrection
from analytic.errors import InputError
from analytic.loads.pair import PairContacts, PairEquilibrium, pair_equilibrium
from analytic.loads.turning import Inertia
from analytic.numerics.elements import share_in
from analytic.result import BEARINGS, FrictionTorque, PairPart, TorqueParts
from analytic.scene import Arrangement, Array, Operation, Scene


@dataclass(frozen=True, kw_only=True, eq=False)
class PairSeries:
    """Both bearings of a pair as one series of operating points of one bearing."""

    scene: Scene  # without arrangement: the points at which the first bearing is pressed, then the second one's
    equilibrium: PairEquilibrium
    points: tuple[NDArray[np.intp], NDArray[np.intp]]  # of the pair, at which each inner ring presses

    @property
    def rows(self) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Where each bearing's points stand in the series."""
        first, second = (points.size for points in self.points)
        return np.arange(first), first + np.arange(second)


def pair_in_series(scene: Scene, arrangement: Arrangement, correction: ContactCorrection | None) -> PairSeries:
    """The loads of both bearings, and the scene of one bearing that has them one after another.

    correction : factors on Hertz's contacts, one for all points
    Raises InputError as pair_equilibrium, for factors that differ from point to point, and where neither inner ring
    presses on its balls.
    """
    operation = scene.operation.as_series()
    if correction is not None and any(
        np.ndim(factor) for side in (correction.inner, correction.outer) for factor in side
    ):
        raise InputError("correction has a factor for each point, which a pair of bearings does not take: give numbers")

    def computed(effect: str) -> bool:
        return scene.effects.get(effect) != "off"

    found = pair_equilibrium(
        scene.bearing,
        scene.contact_angle,
        arrangement,
        operation,
        PairContacts(
            load_distribution=computed("load_distribution"),
            inertia=Inertia(centrifugal=computed("centrifugal"), gyroscopic=computed("gyroscopic")),
            finite_geometry=computed("finite_geometry"),
            correction=correction,
        ),
    )
    if not found.is_pressed.any():
        raise InputError(
            f"neither inner ring of the pair presses on its balls at {points_of(operation.points)}: their centrifugal "
            "force holds them in the outer races; raise the preload or the axial load, or lower the speed"
        )
    first, second = (np.flatnonzero(pressed) for pressed in found.is_pressed)
    points = first, second

    def loads(of_bearings: Array) -> Array:
        return np.concatenate([of_bearing[at] for of_bearing, at in zip(of_bearings, points, strict=True)])

    # A bearing that is pressed the other way is the mirror image of one that is not.
    way = np.where(loads(found.axial_load) < 0, -1.0, 1.0)
    series = Operation(
        axial_load=way * loads(found.axial_load),
        inner_speed=np.concatenate([operation.inner_speed[at] for at in points]),
        radial_load=loads(found.radial_load),
        moment=way * loads(found.moment),
        tilt="free",
    )
    one = replace(scene, arrangement=None, operation=series, down=None if _is_weight_mirrored(scene) else scene.down)
    return PairSeries(scene=one, equilibrium=found, points=points)


def _is_weight_mirrored(scene: Scene) -> bool:
    """Whether the balls' weight loads one bearing of the pair and relieves the other, which one series cannot show."""
    assert scene.arrangement is not None
    return scene.arrangement.kind != "tandem" and scene.down is not None and scene.down[2] != 0


def pair_torque(scene: Scene, both: PairSeries, each: FrictionTorque) -> FrictionTorque:
    """The torque of the pair; each : friction_torque(both.scene)"""
    assert scene.arrangement is not None
    operation, found = scene.operation.as_series(), both.equilibrium
    count = operation.inner_speed.size
    at_rest = scene.losses.total

    def apart(values: Array, unloaded: float = 0.0) -> Array:
        """(2, n) of each bearing; unloaded : where its inner ring does not press."""
        found = np.full((2, count), unloaded)
        for of_bearing, points, rows in zip(found, both.points, both.rows, strict=True):
            of_bearing[points] = values[rows]
        return found

    def summed(part: Array | None, unloaded: float = 0.0) -> Array | None:
        return None if part is None else apart(part, unloaded).sum(axis=0)

    by_bearing = apart(each.torque.total, at_rest or 0.0)
    parts = {name: summed(part) for name, part in vars(each.torque).items() if name not in ("total", "declared")}
    total = by_bearing.sum(axis=0)
    unsure = summed(each.numerical_uncertainty * each.torque.total)
    assert unsure is not None
    # Where both bearings are pressed, the one with the heaviest ball stands for the pair.
    place = apart(np.arange(float(each.inner_speed.size))).astype(np.intp)
    heavier = np.where(found.is_pressed, found.ball_load, -1.0).argmax(axis=0)
    first, second = (each.at(rows) if rows.size else None for rows in both.rows)
    return replace(
        each.at(place[heavier, np.arange(count)]),
        limits=each.limits.worst(both.rows, both.points, count),
        inner_speed=operation.inner_speed,
        axial_load=operation.axial_load,
        radial_load=np.asarray(operation.radial_load),
        moment=np.asarray(operation.moment),
        torque=TorqueParts(
            **{**parts, "total": total, "declared": summed(each.torque.declared, at_rest or 0.0)},
        ),
        numerical_uncertainty=share_in(unsure, total),
        ring=None,
        pair=PairPart(
            kind=scene.arrangement.kind,
            equilibrium=found,
            bearings=(first, second),
            points=both.points,
            total=by_bearing,
        ),
        warnings=(*each.warnings, *_mirrored(scene), *_relieved(found)),
        provenance=MappingProxyType({**each.provenance, "arrangement": scene.arrangement.kind}),
    )


def _mirrored(scene: Scene) -> Iterator[str]:
    if _is_weight_mirrored(scene) and scene.effects.get("weight") != "off":
        yield (
            "operation.down is partly along the axis: there the balls' weight loads one bearing of the pair and "
            "relieves the other; the weight is taken across the axis"
        )


def _relieved(found: PairEquilibrium) -> Iterator[str]:
    count = found.is_relieved.shape[1]
    for name, relieved in zip(BEARINGS, found.is_relieved, strict=True):
        if relieved.any():
            yield (
                f"the loads relieve the {name} bearing of the pair at {np.count_nonzero(relieved)} of {count} "
                "operating points: its balls have clearance and may skid; its torque has the parts by centrifugal "
                "force and the declared losses only; raise the preload"
            )
