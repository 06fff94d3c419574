"""Two equal bearings on one rigid shaft: which load each of them takes.

The bearings share the shaft's five displacements. Their outer rings stand in one rigid housing. With a preload,
clamping has brought the inner rings (O) or the outer rings (X) nearer to each other by the offset, which stays as it
is: shaft and spacers neither give way nor grow. In `O` and `X` the axial load presses on the first bearing and relieves
the second one.
The equilibrium is that of `analytic.loads.ring` with two rows of balls. A row's own frame has its z along the thrust
that loads it. In `O` the first bearing stands on the side that the axial load comes from; the lines of contact then
meet the axis outside the pair. Loads refer to the middle of the pair, halfway between the circles of the inner groove
centres. The weight of the balls is left out here.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection
from analytic.errors import InputError, require_positive
from analytic.loads.finite_geometry import corrections_of
from analytic.loads.numbers import play_and_free_angle
from analytic.loads.ring_balance import LEAST_BALLS, Row, require_enough_balls
from analytic.loads.ring_series import RowsOfBalls, SettledRings, settled_rings
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium
from analytic.loads.turning import WHOLE_INERTIA, Inertia
from analytic.scene import Arrangement, Array, Bearing, ContactAngle, Operation

# Load of a ball on the inner race over that on the outer one, below which it hangs in the outer race by its centrifugal
# force and skids.
HANGING = 2e-3
ROUND_OFF = 1e-14  # of a stiffness, over the largest


@dataclass(frozen=True, kw_only=True, eq=False)
class PairEquilibrium:
    """Two bearings at n operating points; an axis of both is in front. Loads are in each bearing's own frame."""

    preload: float  # axial force between the bearings at standstill without other loads, N; 0 in tandem
    offset: float  # axial distance that clamping has closed, m; 0 in tandem
    distance: float  # between the middles of both bearings, m
    displacement: Array  # (n,) of the shaft along the axial load, from its place without load (tandem: with play), m
    tilt: Array  # (n,) of the shaft about y, rad
    stiffness: Array  # (n,) dF/dz of the pair at constant radial load and moment, with each contact's K held, N/m
    axial_load: Array  # (2, n) N
    radial_load: Array  # (2, n) N
    moment: Array  # (2, n) about y, N m
    ball_load: Array  # (2, n) of the heaviest ball on the race where it is larger, N
    is_pressed: NDArray[np.bool_]  # (2, n) whether the inner ring presses on a ball
    # (2, n) whether the rings leave every ball room; at speed centrifugal force may still press it on the inner ring
    is_relieved: NDArray[np.bool_]  # (2, n) whether no ball would touch both grooves without its own forces


@dataclass(frozen=True, kw_only=True)
class PairContacts:
    """How the contacts of a pair are computed."""

    load_distribution: bool = True  # whether radial load and moment count
    inertia: Inertia = WHOLE_INERTIA
    finite_geometry: bool = True  # whether Hertz's contacts are corrected for the finite geometry, at their loads
    correction: ContactCorrection | None = None  # factors, one for all balls and points, in its place


def pair_equilibrium(
    bearing: Bearing,
    contact_angle: ContactAngle,
    arrangement: Arrangement,
    operation: Operation,
    contacts: PairContacts,
) -> PairEquilibrium:
    """The loads that each of two equal bearings takes.

    contact_angle : rule "solved"
    operation : of the pair, every array (n,); axial_load >= 0; radial load and moment act at the middle of the pair
    Raises InputError for the rule "given", a distance that is not known, fewer than three balls under a radial load or
    a moment, and balls that leave their grooves; ConvergenceError where the iteration stops short.
    """
    if contact_angle.rule == "given":
        raise InputError('arrangement needs contact_angle.rule = "solved": the angles of a pair follow from its loads')
    distance = bearing.width if arrangement.distance is None else arrangement.distance
    if distance is None:
        raise InputError("arrangement.distance is missing: give it, or bearing.width, which it is by default")
    require_positive(**{"arrangement.distance": distance})
    distributed = contacts.load_distribution and not operation.is_thrust
    if distributed:
        require_enough_balls(bearing)
    pair = _Pair(bearing, contact_angle, arrangement, contacts, distance)
    count = operation.axial_load.size
    preload = arrangement.preload
    if preload is None:
        at_rest = pair.settled(np.zeros((1, 5)), np.zeros(1)) if arrangement.kind != "tandem" else None
        preload = 0.0 if at_rest is None else float(pair.loads(at_rest)[0][0, 0])
    load = np.zeros((count, 5))
    load[:, 0] = operation.axial_load
    if distributed:
        load[:, 1] = operation.radial_load
        load[:, 4] = np.asarray(operation.moment) / pair.arm
    state = pair.settled(load, operation.inner_speed)
    axial, radial, moment = pair.loads(state)
    inner, outer = np.moveaxis(pair.by_row(state.balls["load"]).max(axis=2), -1, 0)
    return PairEquilibrium(
        preload=preload,
        offset=pair.closed,
        distance=distance,
        displacement=state.rings["place"][:, 0],
        tilt=state.rings["place"][:, 4] / pair.arm,
        stiffness=_axial_stiffness(state.rings["tangent"], alone=bearing.ball_count < LEAST_BALLS),
        axial_load=axial,
        radial_load=radial if distributed else np.zeros_like(radial),
        moment=moment if distributed else np.zeros_like(moment),
        ball_load=np.maximum(inner, outer),
        is_pressed=inner > HANGING * outer,
        is_relieved=pair.is_relieved(state),
    )


class _Pair:
    """The rows of a pair, and their equilibrium."""

    def __init__(
        self,
        bearing: Bearing,
        contact_angle: ContactAngle,
        arrangement: Arrangement,
        contacts: PairContacts,
        distance: float,
    ) -> None:
        self.bearing, self.contacts = bearing, contacts
        self.play, free = play_and_free_angle(bearing, contact_angle)
        self.free_angle = free or 0.0
        self.arm = bearing.inner.bottom_radius + bearing.inner.groove_radius
        touching = float(np.sqrt(max(self.play, 0.0) * (2 * bearing.groove_centre_distance - self.play)))
        if arrangement.kind == "tandem":
            each, self.closed = 0.0, 0.0
        elif arrangement.preload is not None:
            require_positive(**{"arrangement.preload": arrangement.preload})
            each = _displacement(bearing, contact_angle, arrangement.preload, contacts)
            self.closed = 2 * (each - touching)
        else:
            assert arrangement.offset is not None, "Arrangement refuses it"
            require_positive(**{"arrangement.offset": arrangement.offset})
            self.closed = arrangement.offset
            each = touching + self.closed / 2
        first = distance / 2 if arrangement.kind == "X" else -distance / 2
        second = Row(side=1 if arrangement.kind == "tandem" else -1, position=-first, offset=each)
        self.rows = (Row(position=first, offset=each), second)
        self.ring = self._ring(ContactCorrection(), np.zeros(1))  # for its geometry

    def settled(self, load: Array, speed: Array) -> SettledRings:
        """The shaft under loads (n, 5), N, at speeds (n,), rad/s; with contacts corrected at the loads by Hertz."""
        factors = self.contacts.correction or ContactCorrection()
        state = self._with(factors, load, speed, place=None)
        if self.contacts.correction is None and self.contacts.finite_geometry:
            corrected = corrections_of(self.bearing, state.balls).correction
            state = self._with(corrected, load, speed, place=state.rings["place"])
        return state

    def by_row(self, of_balls: Array) -> Array:
        """(2, n, Z, ...) of each bearing from (n, 2 Z, ...)."""
        rows = of_balls.reshape(len(of_balls), 2, self.bearing.ball_count, *of_balls.shape[2:])
        return np.moveaxis(rows, 1, 0)

    def loads(self, state: SettledRings) -> Sequence[Array]:
        """Axial load, radial load and moment of each bearing in its own frame, each (2, n)."""
        radial, axial = np.moveaxis(self.by_row(state.balls["force"] + state.balls["friction"]), -1, 0)
        cosine = np.cos(2 * np.pi * np.arange(self.bearing.ball_count) / self.bearing.ball_count)
        return axial.sum(axis=-1), radial @ cosine, -self.arm * (axial @ cosine)

    def is_relieved(self, state: SettledRings) -> NDArray[np.bool_]:
        """(2, n) whether no ball of a bearing would touch both grooves without forces of its own."""
        radial, axial = self.ring.displaced(state.rings["place"])
        distance = self.bearing.groove_centre_distance
        # |V| <= A0, without the difference of large numbers
        beyond = radial - self.play
        return self.by_row(beyond * (2 * distance + beyond) + axial**2).max(axis=-1) <= 0

    def _with(self, factors: ContactCorrection, load: Array, speed: Array, *, place: Array | None) -> SettledRings:
        ring = self._ring(factors, speed)
        if place is None and self.rows[0].offset > 0:
            place = np.zeros_like(load)
        return settled_rings(ring, load, angle=self.free_angle, place=place)

    def _ring(self, factors: ContactCorrection, speed: Array) -> RowsOfBalls:
        return RowsOfBalls(
            bearing=self.bearing,
            play=self.play,
            correction=factors,
            speed=speed,
            inertia=self.contacts.inertia,
            rows=self.rows,
        )


def _displacement(bearing: Bearing, contact_angle: ContactAngle, preload: float, contacts: PairContacts) -> float:
    """Of one inner ring along its axis under a thrust at rest, from grooves in line, m."""
    thrust, factors = np.array([preload]), contacts.correction
    if factors is None and contacts.finite_geometry:
        by_hertz = thrust_equilibrium(bearing, contact_angle, axial_load=thrust)
        factors = corrections_of(bearing, by_hertz).correction
    balls = thrust_equilibrium(bearing, contact_angle, axial_load=thrust, correction=factors)
    stretched = bearing.groove_centre_distance + approaches(balls).sum(axis=-1)
    return float((stretched * np.sin(balls["angle"][:, 0]))[0])


def _axial_stiffness(tangent: Array, *, alone: bool) -> Array:
    """(n,) N/m; tangent : (n, 5, 5);  alone : whether the balls hold the shaft along its axis alone

    A few loaded balls may leave the shaft free across the load: a stiffness of round-off holds it there.
    """
    if alone:
        return tangent[:, 0, 0]
    along = np.zeros((len(tangent), 5, 1))
    along[:, 0] = 1.0
    stiffest = np.abs(tangent).max(axis=(1, 2))
    held = tangent + (ROUND_OFF * stiffest)[:, None, None] * np.eye(5)
    return 1 / np.linalg.solve(held, along)[:, 0, 0]
