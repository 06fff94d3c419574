"""Five freedoms of the inner ring: every ball takes its own load and contact angle on each race.

The outer ring is fixed. The inner ring is loaded and displaced along the bearing axis z, along x and y, and tilted
about x and y, right-handed. The rings are rigid apart from the contacts, tilts are small. Displacement, load and moment
refer to the centre of the circle on which the inner groove's centre of curvature lies. Its radius is
R = bottom_radius + groove_radius: a tilt about it moves each groove along the axis. Ball j sits at the azimuth
psi_j = 2 pi j/Z, from x towards y. A groove reaches equally far to both sides.

With the contacts' stiffness held, the energy of the ring is convex in its place. There is no second equilibrium, and
with three balls or more there is always one. The loads of the balls are unique. The place is not where the loaded balls
leave a freedom, as in a bearing with clearance that hangs on one ball: it is then one of the possible places.
Source: [Jones1960] and [Harris2007b] sections 1 and 3: derived here from energy and Euler's equation of a ball.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.brief import Brief
from analytic.contact.factors import ContactCorrection
from analytic.errors import InputError, require_finite, require_positive
from analytic.loads.numbers import play_and_free_angle
from analytic.loads.ring_balance import require_enough_balls
from analytic.loads.ring_series import RowsOfBalls, settled_rings
from analytic.loads.turning import WHOLE_INERTIA, Inertia
from analytic.numerics.records import Records
from analytic.scene import Array, Bearing, ContactAngle


@dataclass(frozen=True, kw_only=True, eq=False)
class RingEquilibrium(Brief):
    """Balls and ring under load; (...) is the broadcast shape of the loads and the speed, Z the number of balls."""

    azimuth: Array  # (Z,) psi, rad
    moment: Array  # (..., 2) about x and y, N m: given, or what holds the ring at its tilts
    displacement: Array  # (..., 5) axial, x, y, m; tilt about x, about y, rad; from concentric rings, grooves in line
    stiffness: Array  # (..., 5, 5) dF/d displacement with each contact's K held, N/m, N, N m
    balls: Records  # (..., Z) of `state.BALL_STATE`: loads, N, and angles, rad, negative towards -z; forces, contacts
    residual: Array  # (...) largest unbalanced force, or moment over R, N
    iterations: NDArray[np.intp]  # (...) Newton steps


def ring_equilibrium(
    bearing: Bearing,
    contact_angle: ContactAngle,
    *,
    axial_load: ArrayLike = 0.0,
    radial_load_x: ArrayLike = 0.0,
    radial_load_y: ArrayLike = 0.0,
    moment_x: ArrayLike = 0.0,
    moment_y: ArrayLike = 0.0,
    tilts: tuple[ArrayLike, ArrayLike] | None = None,
    inner_speed: ArrayLike = 0.0,
    inertia: Inertia = WHOLE_INERTIA,
    ball_weight: tuple[float, float, float] = (0.0, 0.0, 0.0),
    correction: ContactCorrection | None = None,
) -> RingEquilibrium:
    """Ball loads, contact angles and ring displacement under any load.

    Parameters
    ----------
    bearing : Bearing
        Rings and Z balls.
    contact_angle : ContactAngle
        Rule `solved`; `free`, where given, replaces the clearance by A0 (1 - cos al0), rad.
    axial_load, radial_load_x, radial_load_y : array_like
        In N, any sign; loads and speed broadcast to (...).
    moment_x, moment_y : array_like
        About x and y, N m, any sign.
    tilts : tuple of 2 array_like, optional
        About x and y, rad, at which the ring is held, without moments; None: it tilts freely.
    inner_speed : array_like
        rad/s, any sign.
    inertia : Inertia
        What counts of the balls' inertia, by closed kinematics.
    ball_weight : tuple of 3 floats
        Of each ball along x, y and z, N; the cage carries its part along the orbit.
    correction : ContactCorrection, optional
        Factors on Hertz's contacts, dimensionless, each a number or (..., Z); None: Hertz as it is.

    Returns
    -------
    RingEquilibrium
        Displacements, m and rad, and moments, N m, shape (...); loads, N, and angles, rad, shape (..., Z).

    Raises
    ------
    InputError
        A number is not finite, the rule is `given`, a moment acts on a ring whose tilt is held, a radial load, moment
        or tilt acts on fewer than three balls, a load drives a ball out of its groove (an angle beyond pi/2), and as
        `thrust_equilibrium` for the bearing.
    ConvergenceError
        The iteration stopped short.

    Notes
    -----
    Each ball settles between groove centres that are V = (A0 cos al0 + u_r, u_a) apart
    (`analytic.loads.ball_balance`), with ::

        u_r = x cos psi + y sin psi,  u_a = z + R (t_x sin psi - t_y cos psi)

    and the load is the sum of the ball forces. K of a contact is Hertz's at its own angle, and its force acts along the
    normal. The work of a K that changes with the angle, (2/5)(delta/A0) d ln K/d al of the force, is left out.
    Centrifugal force F_c and friction across the grooves F_t (`analytic.loads.turning`) follow from loads and angles of
    the last round, at the cage speed w_m, the ball speed w_b and the pitch B ::

        F_c = m (d_m/2) w_m^2,  M_g = (m D^2/10) w_b w_m sin B

    and friction carries M_g, on each race in proportion to its load.
    Without load on a bearing with clearance nothing touches, and the ring is left in the middle of its play.
    Fewer than three balls carry thrust alone: the other freedoms of the ring are then held, with stiffness 0.
    Source: [Jones1960] and [Harris2007b] sections 1 to 3; derived here.
    """
    loads = {"axial_load": axial_load, "radial_load_x": radial_load_x, "radial_load_y": radial_load_y}
    given = loads | {"moment_x": moment_x, "moment_y": moment_y, "inner_speed": inner_speed}
    given |= {} if tilts is None else {"tilt_x": tilts[0], "tilt_y": tilts[1]}
    require_finite(**given, ball_weight=ball_weight)
    require_positive(ball_count=bearing.ball_count)
    if contact_angle.rule == "given":
        raise InputError(
            "the rule 'given' holds the contact angle that a ring equilibrium solves for: use the rule 'solved'"
        )
    play, free = play_and_free_angle(bearing, contact_angle)
    arrays = np.broadcast_arrays(*(np.asarray(value, dtype=np.float64) for value in given.values()))
    shape, (axial, x, y, about_x, about_y, speed, *held) = arrays[0].shape, (array.ravel() for array in arrays)
    factors = (correction or ContactCorrection()).mapped(lambda array: array.reshape(-1, bearing.ball_count))
    ring = RowsOfBalls(
        bearing=bearing, play=play, correction=factors, speed=speed, inertia=inertia, ball_weight=ball_weight
    )
    arm = ring.travel.arm
    load = np.stack([axial, x, y, about_x / arm, about_y / arm], axis=-1)
    if held and np.any(load[:, 3:]):
        raise InputError("tilts hold the ring, and a moment tilts it: leave one of them out")
    if np.any(load[:, 1:]) or np.any(held):
        require_enough_balls(bearing)
    found = settled_rings(ring, load, angle=free or 0.0, tilts=arm * np.stack(held, axis=-1) if held else None)
    unit, rings = np.array([1.0, 1.0, 1.0, arm, arm]), found.rings
    return RingEquilibrium(
        azimuth=ring.travel.azimuth,
        moment=(rings["load"][:, 3:] * arm).reshape(*shape, 2),
        displacement=(rings["place"] / unit).reshape(*shape, 5),
        stiffness=(rings["tangent"] * np.outer(unit, unit)).reshape(*shape, 5, 5),
        balls=found.balls.reshape(*shape, bearing.ball_count),
        residual=found.ends["left"].reshape(shape),
        iterations=found.ends["steps"].reshape(shape),
    )
