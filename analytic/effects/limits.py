"""Effects that the model does not compute: how near each is to its limit, with a warning beyond it.

Each is off, with the number of the worst ball and operating point as its reason.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.contact.geometry import RACES, USUAL_SHOULDERS, shoulder_distances, with_shoulders
from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES, MOST_CUT, PER_CUT_SHARE, STATIC_LIMIT
from analytic.errors import InputError
from analytic.loads.balls import LoadedBalls
from analytic.scene import Array, Bearing, Operation, Scene
from analytic.words import NEWTON, NEWTON_MILLIMETRE, angle_of, length_of, percent_of, pressure_of, speed_of

CHECKED = "checked, not modelled"  # how a reason begins


@dataclass(frozen=True, kw_only=True, eq=False)
class LimitNumbers:
    """What is judged against a limit, by the worst ball at each of n operating points; None: not in the scene.

    `analytic.verdicts` has the limits.
    """

    peak_pressure: Array  # (2, n) Pa, of each race
    cut_off: Array  # (2, n) share of a contact's load beyond a shoulder; by the lowest usual one where it is not known
    knows_shoulder: NDArray[np.bool_]  # (2,) of each race
    sliding_number: Array | None = None  # (2, n) rolling force of the oil over the most friction of each race
    gyroscopic_hold: Array | None = None  # (n,) ratio of gyroscopic moment to the most that friction holds
    cage_grip: Array | None = None  # (n,) share of the grip of the races that the cage uses; NaN: not known

    def at(self, points: NDArray[np.intp]) -> "LimitNumbers":
        """The same at some operating points.

        Parameters
        ----------
        points : ndarray, shape (k,)
            Numbers of the points, from 0.

        Returns
        -------
        LimitNumbers
            Of k points.
        """
        changed = {n: v[..., points] for n, v in vars(self).items() if v is not None and n != "knows_shoulder"}
        return replace(self, **changed)

    def worst(self, rows: Sequence[NDArray[np.intp]], points: Sequence[NDArray[np.intp]], count: int) -> "LimitNumbers":
        """The worst of several balls or bearings at each operating point.

        Parameters
        ----------
        rows : sequence of ndarray, shape (k,)
            Numbers of the elements of these arrays.
        points : sequence of ndarray, shape (k,)
            Numbers of the operating points that they belong to.
        count : int
            Number of operating points.

        Returns
        -------
        LimitNumbers
            Of `count` points.
        """

        def largest(values: Array) -> Array:
            found = np.zeros((*values.shape[:-1], count))
            for row, point in zip(rows, points, strict=True):
                found[..., point] = np.maximum(found[..., point], values[..., row])
            return found

        changed = {n: largest(v) for n, v in vars(self).items() if v is not None and n != "knows_shoulder"}
        return replace(self, **changed)


@dataclass(frozen=True, kw_only=True, eq=False)
class Limits:
    """What is past a limit."""

    warnings: tuple[str, ...]
    uncertainty: Array  # (n,) of the torque by contacts past a limit, relative; infinite where nothing is known of it
    unknown: tuple[str, ...]  # why, where it is infinite
    numbers: LimitNumbers  # of the contacts alone


def check_limits(scene: Scene, operation: Operation, balls: LoadedBalls, ledger: Ledger) -> Limits:
    """Settle every effect of the kind "limit" with its number as the reason; say what is past its limit.

    operation : every array (n,)
    Raises InputError for a contact that has left its race.
    """
    distance = require_on_grooves(scene.bearing, operation, balls)
    low = with_shoulders(scene.bearing, USUAL_SHOULDERS[0])
    lowest = distance if low is scene.bearing else _shoulder_distance(low, balls)
    warnings = (
        *_shoulder(distance, balls, ledger),
        *_plasticity(balls, ledger),
    )
    cut_off = cut_off_share(np.maximum(lowest, 0.0), balls.contact.semi_axis_y).max(axis=2)
    share = cut_off.max(axis=0)
    plastic = balls.contact.peak_pressure.max(axis=(0, 2)) > STATIC_LIMIT
    unknown = []
    if np.any(share > MOST_CUT) and np.isnan(distance).any():
        unknown.append(
            f"shoulder not known: a low one, of {USUAL_SHOULDERS[0]:g} ball diameters, would cut off "
            f"{percent_of(share.max(), 2)} of a contact's load, more than {percent_of(MOST_CUT)}; give "
            "shoulder_height of both rings"
        )
    elif np.any(share > MOST_CUT):
        unknown.append(
            f"a shoulder cuts off {percent_of(share.max(), 2)} of a contact's load by Hertz, more than "
            f"{percent_of(MOST_CUT)}: its pressure and its place are no longer Hertz's; raise shoulder_half_width or "
            "lower the load"
        )
    if np.any(plastic):
        unknown.append(
            f"a peak pressure above the static limit, {pressure_of(STATIC_LIMIT)}: the contact is plastic, and no "
            "formula here is; lower the load"
        )
    return Limits(
        warnings=warnings,
        uncertainty=np.where(plastic | (share > MOST_CUT), np.inf, PER_CUT_SHARE * share),
        unknown=tuple(unknown),
        numbers=LimitNumbers(
            peak_pressure=balls.contact.peak_pressure.max(axis=2),
            cut_off=cut_off,
            knows_shoulder=np.array([not np.isnan(of_race).any() for of_race in distance]),
        ),
    )


def require_on_grooves(bearing: Bearing, operation: Operation, balls: LoadedBalls) -> Array:
    """(2, n, m) from the contacts' centres to their nearer shoulders, m; infinite without load, NaN if not known.

    operation : every array (n,)
    Raises InputError for a contact that has left its race.
    """
    distance = _shoulder_distance(bearing, balls)
    for index, name in enumerate(RACES):
        if not np.any(distance[index] <= 0):
            continue
        point, ball = np.unravel_index(np.nanargmin(distance[index]), distance[index].shape)
        angles = balls.contact_angle[:, point, ball]
        # The ball's inertia separates its two angles: without it both would be near their mean.
        separated = np.min(shoulder_distances(bearing, name, contact_angle=angles.mean())) > 0
        speed = f"the speed of {speed_of(operation.inner_speed[point])}, whose centrifugal force moves it there"
        raise InputError(
            f"{_loads(operation, int(point))}: the contact moves to {angle_of(angles[index])}, beyond the {name} "
            f"race's shoulder: lower {speed if separated else 'the load'}, reduce the clearance or raise "
            "shoulder_half_width"
        )
    return distance


def cut_off_share(distance: Array, semi_axis: Array) -> Array:
    """Share of an ellipse's load beyond a line across it, of one shape: (2 - 3 t + t^3)/4, t = distance/semi_axis.

    distance : of the line from the centre, m, >= 0;  semi_axis : b, to which the line is perpendicular, m, >= 0
    Hertz's pressure, integrated along rolling, is a parabola over b.
    """
    reach = np.minimum(distance, semi_axis)
    t = np.divide(reach, semi_axis, out=np.ones(np.shape(semi_axis)), where=semi_axis > 0)
    return (1 - t) ** 2 * (2 + t) / 4


def _shoulder_distance(bearing: Bearing, balls: LoadedBalls) -> Array:
    """(2, n, m) from the contacts' centres to their nearer shoulders, m; infinite without load, NaN if not known."""
    distance = np.stack(
        [
            np.minimum(*shoulder_distances(bearing, race, contact_angle=angle))
            for race, angle in zip(RACES, balls.contact_angle, strict=True)
        ]
    )
    return np.where(balls.load > 0, distance, np.inf)


def _shoulder(distance: Array, balls: LoadedBalls, ledger: Ledger) -> Iterator[str]:
    b = balls.contact.semi_axis_y
    left, nearest, unknown = np.inf, ENTRIES["shoulder"].idle, []
    for index, name in enumerate(RACES):
        if np.isnan(distance[index]).any():
            unknown.append(name)
            continue
        worst = np.unravel_index(np.argmin(distance[index] - b[index]), distance[index].shape)
        axis, space = b[index][worst], distance[index][worst]
        if space - axis < left:
            left = space - axis
            nearest = f"semi-axis {length_of(axis)} of {length_of(space)} to the {name} race's shoulder"
        if axis > space:
            yield (
                f"the contact ellipse passes the {name} race's shoulder: semi-axis {length_of(axis)}, distance "
                f"{length_of(space)}; the true contact is cut off there and its pressure higher"
            )
    if unknown:
        rings = " and ".join(f"bearing.{name}.shoulder_height" for name in unknown)
        nearest = f"shoulder not known: give {rings}" + (f"; {nearest}" if np.isfinite(left) else "")
    ledger.settle("shoulder", on=False, reason=f"{CHECKED}: {nearest}")


def _plasticity(balls: LoadedBalls, ledger: Ledger) -> Iterator[str]:
    peaks = balls.contact.peak_pressure.max(axis=(1, 2))
    share = peaks.max() / STATIC_LIMIT
    ledger.settle(
        "plasticity",
        on=False,
        reason=f"{CHECKED}: peak pressure {pressure_of(peaks.max())}, {percent_of(share)} of the static limit, "
        f"{pressure_of(STATIC_LIMIT)}",
    )
    for name, peak in zip(RACES, peaks, strict=True):
        if peak > STATIC_LIMIT:
            yield (
                f"peak pressure on the {name} race, {pressure_of(peak)}, is above the static limit, "
                f"{pressure_of(STATIC_LIMIT)}: the contact is no longer elastic"
            )


def _loads(operation: Operation, point: int) -> str:
    """The loads at an operating point as the scene gives them."""
    found = f"operation.axial_load = {operation.axial_load[point]:g} N"
    for name, unit in (("radial_load", NEWTON), ("moment", NEWTON_MILLIMETRE)):
        value = np.asarray(getattr(operation, name))[point]
        if value:
            found += f", operation.{name} = {unit.written(value, 'g')}"
    return found
