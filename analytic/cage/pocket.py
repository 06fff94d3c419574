"""A ball in its cage pocket: two half-shells that join in a plane, and the force of the ball on them.

Frame of the pocket, the paper's frame p: x is the pocket's axis, from one half-shell to the other. Of a stamped cage,
whose halves are riveted together from both sides, that is the axis of the bearing; `Cage.pocket_axis` names it.
Shell s = +1 or -1 is half a sphere of radius D_p/2 on the side of s x, k deep, so that its centre lies at
x = -s (D_p/2 - k). Offsets are those of the ball's centre from the pocket's, forces those of the ball on the cage.
The ball slides inside nearly equal radii: Hertz's K_pb is an estimate there, which finite elements can replace.
Both shells are summed: contact with both at once needs |x| < D_p/2 - k, not x = 0.
Source: equations 13 to 17 of the paper; damping by K. H. Hunt and F. R. E. Crossley, J. Appl. Mech. 42 (1975) 440
(not seen: the loss of an impact is derived here).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.scene import Array

SHELLS = np.array([1.0, -1.0])  # s
LEAST_RESTITUTION = 0.05  # below, the damping passes twenty times the elastic force
SMALL_LOSS = 0.03  # of (1 - e)/(1 + e): below, a series of four terms leaves 4e-13, and cancellation would leave more


def pocket_stiffness(*, ball_diameter: ArrayLike, pocket_diameter: ArrayLike, modulus: ArrayLike) -> Array:
    """K_pb = (4/3) E* sqrt(R), N/m^1.5, by Hertz: a ball in a spherical seat; the arguments broadcast.

    ball_diameter, pocket_diameter : D_b < D_p, m;  modulus : E*, Pa;  1/R = 2/D_b - 2/D_p
    Raises InputError for a pocket no wider than the ball.
    """
    _require_room(ball_diameter, pocket_diameter)
    require_positive(modulus=modulus)
    ball, pocket = np.asarray(ball_diameter), np.asarray(pocket_diameter)
    return np.asarray(4 / 3 * np.asarray(modulus) * np.sqrt(ball * pocket / (2 * (pocket - ball))))


def half_clearance(*, ball_diameter: float, pocket_diameter: float, pocket_depth: float) -> tuple[float, float]:
    """(nabla, D_p/2 - k), m: room of a ball in one whole sphere, and how far the shells' centres lie off the middle.

    Raises InputError unless D_b < D_p and D_b/2 < k <= D_p/2: a shell less deep than the ball's radius clamps it.
    """
    _require_room(ball_diameter, pocket_diameter)
    require_positive(pocket_depth=pocket_depth)
    if not ball_diameter / 2 < pocket_depth <= pocket_diameter / 2:
        raise InputError(
            f"pocket_depth {pocket_depth!r} m must be above half of ball_diameter {ball_diameter!r} m, else the ball "
            f"is clamped, and at most half of pocket_diameter {pocket_diameter!r} m"
        )
    return (pocket_diameter - ball_diameter) / 2, pocket_diameter / 2 - pocket_depth


def penetration(offset: ArrayLike, *, room: float, centre_offset: float) -> tuple[Array, Array]:
    """(delta, normal): equation 13 of both shells; delta (..., 2), m, 0 where there is no contact, normal (..., 2, 3).

    offset : u, (..., 3), of the ball in the pocket's frame, m;  room : nabla, m;  centre_offset : D_p/2 - k, m
        u_s = u + s (D_p/2 - k) x,  delta_s = |u_s| - nabla where that is positive and s u_sx > 0
    Where u_sx = 0 the shell s = +1 alone acts.
    """
    along_axis = SHELLS[:, None] * np.array([centre_offset, 0.0, 0.0])
    from_centre = np.asarray(offset, dtype=np.float64)[..., None, :] + along_axis
    distance = np.linalg.norm(from_centre, axis=-1)
    side = SHELLS * from_centre[..., 0]
    facing = (side > 0) | ((side == 0) & (SHELLS > 0))
    normal = np.divide(from_centre, distance[..., None], out=np.zeros(from_centre.shape), where=distance[..., None] > 0)
    return np.where(facing, np.maximum(distance - room, 0.0), 0.0), normal


def normal_force(
    deformation: ArrayLike, *, rate: ArrayLike, impact_speed: ArrayLike, stiffness: float, damping: float
) -> Array:
    """K delta^1.5 (1 + damping delta'/v), N, never pulling: equation 14 with Hunt and Crossley's loss; all broadcast.

    deformation : delta, m, >= 0;  rate : delta', m/s;  impact_speed : v, of approach as the contact began, m/s, > 0
    stiffness : K_pb, N/m^1.5;  damping : `impact_damping` of the restitution
    """
    require_non_negative(deformation=deformation)
    require_positive(impact_speed=impact_speed)
    elastic = stiffness * np.asarray(deformation) ** 1.5
    return np.maximum(elastic * (1 + damping * np.asarray(rate) / np.asarray(impact_speed)), 0.0)


def friction_force(normal: ArrayLike, sliding: ArrayLike, *, friction_coefficient: float, smoothing: float) -> Array:
    """mu N tanh(|v|/v0) v/|v|, (..., 3), N: equation 16, of the ball on the cage, with a direction at rest too.

    normal : N, (...), N;  sliding : v, (..., 3), of the ball past the cage, tangential, m/s;  smoothing : v0, m/s, > 0
    """
    require_positive(smoothing=smoothing)
    velocity = np.asarray(sliding, dtype=np.float64)
    speed = np.linalg.norm(velocity, axis=-1)
    per_speed = np.divide(np.tanh(speed / smoothing), speed, out=np.full(speed.shape, 1 / smoothing), where=speed > 0)
    return (friction_coefficient * np.asarray(normal) * per_speed)[..., None] * velocity


def impact_damping(restitution: float) -> float:
    """The damping factor with which an impact leaves with the share e of its speed; 0 for e = 1.

    restitution : e, LEAST_RESTITUTION to 1
    With y = delta'/v, m y dy = -K delta^1.5 (1 + l y) ddelta/v^2 takes y from 1 to -e over the same indentation:
        l (1 + e) = ln((1 + l)/(1 - l e)),  or  coth(h) - 1/h = (1 - e)/(1 + e)  with  h = l (1 + e)/2
    For small losses that is l = 1.5 (1 - e), the factor in common use, with which e = 0.5 leaves with 0.6 of the speed.
    """
    if not LEAST_RESTITUTION <= restitution <= 1:
        raise InputError(
            f"restitution must be {LEAST_RESTITUTION:g} to 1, got {restitution!r}: the share of its speed that an "
            "impact keeps"
        )
    loss = (1 - restitution) / (1 + restitution)
    if loss < SMALL_LOSS:
        square = loss**2
        half = loss * (3 + square * (9 / 5 + square * (297 / 175 + square * 1539 / 875)))
    else:
        from scipy.optimize import brentq  # a quarter of a second to import

        # 1 - 1/h < coth(h) - 1/h < h/3
        half = brentq(lambda h: 1 / np.tanh(h) - 1 / h - loss, 3 * loss, 1 / (1 - loss), xtol=1e-15, rtol=1e-14)
    return float(2 * half / (1 + restitution))


class Impact(NamedTuple):
    """A body that hits without friction or loss; each with the broadcast shape of the arguments."""

    indentation: Array  # the largest, m
    force: Array  # the largest, N
    duration: Array  # of the contact, s


def impact(*, mass: ArrayLike, speed: ArrayLike, stiffness: ArrayLike) -> Impact:
    """A mass m that meets the spring K delta^1.5 with the speed v: d = (5 m v^2/(4 K))^0.4, F = K d^1.5, t = 2.943 d/v.

    mass : m, reduced, kg;  speed : v, m/s;  stiffness : K, N/m^1.5; all > 0, and they broadcast
    The number is 2 int_0^1 dz/sqrt(1 - z^2.5) = 2 sqrt(pi) Gamma(1.4)/Gamma(0.9). The force grows with v^1.2.
    """
    require_positive(mass=mass, speed=speed, stiffness=stiffness)
    m, v, k = np.asarray(mass), np.asarray(speed), np.asarray(stiffness)
    deepest = (1.25 * m * v**2 / k) ** 0.4
    return Impact(np.asarray(deepest), np.asarray(k * deepest**1.5), np.asarray(2.943275184 * deepest / v))


def _require_room(ball_diameter: ArrayLike, pocket_diameter: ArrayLike) -> None:
    require_positive(ball_diameter=ball_diameter, pocket_diameter=pocket_diameter)
    ball, pocket = np.broadcast_arrays(ball_diameter, pocket_diameter)
    tight = np.flatnonzero(~(pocket > ball))
    if tight.size:
        raise InputError(
            f"pocket_diameter {float(pocket.flat[tight[0]])!r} m must exceed ball_diameter "
            f"{float(ball.flat[tight[0]])!r} m: the ball has no room; usual is 0.1 to 0.3 mm more"
        )
