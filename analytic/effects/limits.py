"""Effects that the model does not compute: how near each is to its limit, with a warning beyond it.

Each is off, with the number of the worst ball and operating point as its reason.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.contact.geometry import RACES, USUAL_SHOULDERS
from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES, MOST_CUT, MOST_STARVED, PER_CUT_SHARE, STATIC_LIMIT
from analytic.oil.inlets import replenishment_exponent
from analytic.scene import Array, Bearing, Scene
from analytic.solve.solution import Solution
from analytic.words import length_of, percent_of, pressure_of, speed_of

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
    tilt: Array | None = None  # (n,) of the inner ring, rad, where it is not held straight
    replenishment: Array | None = None  # (n,) -ln of the replenishment factor that starves the inlets

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


def check_limits(scene: Scene, found: Solution, ledger: Ledger) -> Limits:
    """Settle every effect of the kind "limit" with its number as the reason; say what is past its limit."""
    exponent = _replenishment(scene, ledger)
    warnings = (*_shoulder(scene.bearing, found, ledger), *_plasticity(found, ledger), *_starved(scene, exponent))
    cut_off, peaks = found.points["cut_off"], found.points["peak_pressure"]
    share, knows_shoulder = cut_off.max(axis=1), np.array(known_shoulders(scene.bearing))
    plastic = peaks.max(axis=1) > STATIC_LIMIT
    unknown = []
    if np.any(share > MOST_CUT) and not knows_shoulder.all():
        unknown.append(
            f"shoulder not known: a low one, {USUAL_SHOULDERS[0]:g} ball diameters high, cuts off "
            f"{percent_of(share.max(), 2)} of a contact's load, limit {percent_of(MOST_CUT)}; give shoulder_height of "
            "both rings"
        )
    elif np.any(share > MOST_CUT):
        unknown.append(
            f"a shoulder cuts off {percent_of(share.max(), 2)} of a contact's load by Hertz, limit "
            f"{percent_of(MOST_CUT)}: Hertz does not hold for pressure and position; raise shoulder_half_width or "
            "lower the load"
        )
    if np.any(plastic):
        unknown.append(
            f"the peak pressure exceeds the static limit, {pressure_of(STATIC_LIMIT)}: plastic contact, elastic "
            "formulas; lower the load"
        )
    return Limits(
        warnings=warnings,
        uncertainty=np.where(plastic | (share > MOST_CUT), np.inf, PER_CUT_SHARE * share),
        unknown=tuple(unknown),
        numbers=LimitNumbers(
            peak_pressure=peaks.T.copy(),
            cut_off=cut_off.T.copy(),
            knows_shoulder=knows_shoulder,
            replenishment=exponent,
        ),
    )


def _replenishment(scene: Scene, ledger: Ledger) -> Array | None:
    if scene.lubricant is None or not ledger.is_on("starvation"):
        return None
    return replenishment_exponent(scene.bearing, scene.lubricant, scene.operation.as_series().inner_speed)


def _starved(scene: Scene, exponent: Array | None) -> Iterator[str]:
    if exponent is not None and (worst := exponent.max(initial=0.0)) > MOST_STARVED:
        speed = speed_of(float(np.abs(scene.operation.as_series().inner_speed).max()))
        yield (
            f"starved to flooded: SKF's replenishment factor leaves {percent_of(np.exp(-worst), 2)} of rolling at "
            f"{speed}, a law for running bearings; at a start oil lies in the races, and the interval contains both; "
            "give lubricant.starvation_degree"
        )


def known_shoulders(bearing: Bearing) -> tuple[bool, bool]:
    """Whether the shoulder of the inner and of the outer race is known."""
    return bearing.inner.shoulder_half_width is not None, bearing.outer.shoulder_half_width is not None


def _shoulder(bearing: Bearing, found: Solution, ledger: Ledger) -> Iterator[str]:
    left, nearest, unknown = np.inf, ENTRIES["shoulder"].idle, []
    for race, (name, is_known) in enumerate(zip(RACES, known_shoulders(bearing), strict=True)):
        if not is_known:
            unknown.append(name)
            continue
        b, distance = (found.balls[field][..., race] for field in ("semi_axis_transverse", "shoulder_distance"))
        worst = np.unravel_index(np.argmin(distance - b), distance.shape)
        axis, space = b[worst], distance[worst]
        if space - axis < left:
            left = space - axis
            nearest = f"semi-axis {length_of(axis)} of {length_of(space)} to the {name} race's shoulder"
        if axis > space:
            yield (
                f"the contact ellipse exceeds the shoulder of the {name} race: semi-axis {length_of(axis)}, distance "
                f"{length_of(space)}; the real contact is cut off there, with a higher pressure"
            )
    if unknown:
        rings = " and ".join(f"bearing.{name}.shoulder_height" for name in unknown)
        nearest = f"shoulder not known: give {rings}" + (f"; {nearest}" if np.isfinite(left) else "")
    ledger.settle("shoulder", on=False, reason=f"{CHECKED}: {nearest}")


def _plasticity(found: Solution, ledger: Ledger) -> Iterator[str]:
    peaks = found.points["peak_pressure"].max(axis=0)
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
                f"the peak pressure on the {name} race, {pressure_of(peak)}, exceeds the static limit, "
                f"{pressure_of(STATIC_LIMIT)}: the contact is no longer elastic"
            )
