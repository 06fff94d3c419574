"""Equations 13 to 17 of [Paper] with arrays in the frame of the pocket, beside the compiled push of a ball."""

import numpy as np
from numpy.typing import ArrayLike

from analytic.scene import Array

SHELLS = np.array([1.0, -1.0])  # s


def penetration(offset: ArrayLike, *, half_clearance: float, centre_offset: float) -> tuple[Array, Array]:
    """(delta, normal) of both shells by equation 13; delta (..., 2), m, 0 without contact; normal (..., 2, 3).

    offset : u, (..., 3), of the ball in the frame of the pocket, m;  half_clearance : nabla, m
    centre_offset : D_p/2 - k, m
        u_s = u + s (D_p/2 - k) x,  delta_s = |u_s| - nabla where that is positive and s u_sx > 0
    Where u_sx = 0 only the shell s = +1 acts.
    """
    along_axis = SHELLS[:, None] * np.array([centre_offset, 0.0, 0.0])
    from_centre = np.asarray(offset, dtype=np.float64)[..., None, :] + along_axis
    distance = np.linalg.norm(from_centre, axis=-1)
    side = SHELLS * from_centre[..., 0]
    facing = (side > 0) | ((side == 0) & (SHELLS > 0))
    normal = np.divide(from_centre, distance[..., None], out=np.zeros(from_centre.shape), where=distance[..., None] > 0)
    return np.where(facing, np.maximum(distance - half_clearance, 0.0), 0.0), normal


def normal_force(
    deformation: ArrayLike, *, rate: ArrayLike, impact_speed: ArrayLike, stiffness: float, damping: float
) -> Array:
    """K delta^1.5 (1 + damping delta'/v), N, at least 0: equation 14 with the loss of [Hunt1975]; all broadcast.

    deformation : delta, m, >= 0;  rate : delta', m/s;  impact_speed : v, at which the contact began to close, m/s, > 0
    stiffness : K_pb, N/m^1.5;  damping : `impact_damping` of the restitution
    """
    elastic = stiffness * np.asarray(deformation) ** 1.5
    return np.maximum(elastic * (1 + damping * np.asarray(rate) / np.asarray(impact_speed)), 0.0)


def friction_force(normal: ArrayLike, sliding: ArrayLike, *, friction_coefficient: float, smoothing: float) -> Array:
    """mu N tanh(|v|/v0) v/|v|, (..., 3), N: equation 16, of the ball on the cage, smoothed to be defined at v = 0.

    normal : N, (...), N;  sliding : v, (..., 3), tangential velocity of the ball relative to the cage, m/s
    friction_coefficient : mu;  smoothing : v0, m/s, > 0
    """
    velocity = np.asarray(sliding, dtype=np.float64)
    speed = np.linalg.norm(velocity, axis=-1)
    per_speed = np.divide(np.tanh(speed / smoothing), speed, out=np.full(speed.shape, 1 / smoothing), where=speed > 0)
    return (friction_coefficient * np.asarray(normal) * per_speed)[..., None] * velocity
