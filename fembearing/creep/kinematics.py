"""Slip of rigid bodies between a ball and one of its races.

Normals n point out of the ball, t lies across the groove, t x n along the orbit. Rates are per unit speed of the inner
ring, and the outer one rests, so velocities are lengths. With W = w_ball - w_ring z and the contact surface of radius R
across rolling, a point at x along the orbit and y along t slips by
    s_phi = r_m (w_c - w_ring) + W_t (r - y^2/2R) - W_n y,  s_t = x (W_n + W_t y/R) - W_phi r
in the surface, whose normal is n + t y/R. W_phi slides all points alike but for (y^2/2R)(1/r - 1/R) of itself.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from analytic.scene import Array
from fembearing.creep.rolling import Creepages

RADIAL, AXIAL = 2, 3  # of a ball's velocity v = (r_m w_c, r w_phi, r w_rho, r w_z)


@dataclass(frozen=True, kw_only=True)
class RaceMotion:
    """What the kinematics of a contact need to know."""

    sign: float  # of n along the contact angle: -1 on the inner race, 1 on the outer one
    ball_radius: float  # r, m
    surface_radius: float  # R, m

    @property
    def ring_rate(self) -> float:
        """Speed of the race's ring."""
        return 1.0 if self.sign < 0 else 0.0


class RigidSlip(NamedTuple):
    """Slip on one race, in the contact's own axes."""

    side: float  # 1 where x of the contact, which points to its leading edge, is along the orbit, else -1
    rolling_speed: float  # V: mean of both surfaces through the contact, m
    creepages: Creepages
    rates: Array  # (4, 4) of the creepages times V by the ball's velocity


def slip_rates(race: RaceMotion, angle: float, orbit: float) -> tuple[Array, Array]:
    """Creepages times V with x along the orbit: rates by the ball's velocity, (4, 4), and what the ring adds, (4,).

    angle : al, rad;  orbit : r_m, m
    """
    r, ring = race.ball_radius, race.ring_rate
    n_r, n_z = race.sign * np.cos(angle), race.sign * np.sin(angle)
    bend = -1 / (2 * race.surface_radius * r)
    turn, ring_turn = np.array([0, 0, -n_z, n_r]), -ring * n_r * r  # r W_t
    rates = np.stack(
        [turn + np.array([1, 0, 0, 0]), bend * turn, np.array([0, -1, 0, 0]), np.array([0, 0, n_r, n_z]) / r]
    )
    return rates, np.array([ring_turn - ring * orbit, bend * ring_turn, 0, -ring * n_z])


def rigid_slip(race: RaceMotion, angle: float, orbit: float, velocity: Array) -> RigidSlip:
    """Slip of a ball on its race; arguments of `slip_rates`;  velocity : v, (4,), m"""
    r, ring = race.ball_radius, race.ring_rate
    n_r, n_z = race.sign * np.cos(angle), race.sign * np.sin(angle)
    round_axis = velocity[0] / orbit
    ball_passes = -n_z * velocity[RADIAL] + n_r * (velocity[AXIAL] - r * round_axis)
    passes = (ball_passes + (ring - round_axis) * (orbit + r * n_r)) / 2
    side = -1.0 if passes >= 0 else 1.0  # what enters the contact comes from where its surfaces do not go
    turned = np.array([side, side, 1, side])
    rates, added = slip_rates(race, angle, orbit)
    creepages = turned * (rates @ velocity + added) / abs(passes)
    return RigidSlip(side, abs(passes), Creepages(*creepages.tolist()), turned[:, None] * rates)
