"""How a ball rolls and spins between two rings that turn at different speeds.

Assumes no gross slip, no centrifugal force, the same contact angle on both races and a ball that turns about an axis
in its axial plane. w is the speed of the inner ring minus that of the outer, about the bearing axis; every speed takes
its sign from w, except the cage's, which belongs to the fixed frame. Rates of a contact are those of the ball relative
to the race: rolling about the transverse axis, spin about the normal.
Source: T. A. Harris and M. N. Kotzalas, Advanced Concepts of Bearing Technology, 5th ed. (2007), section 2
(not seen: the relations here follow from no slip of rigid bodies at both contacts' centres).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class BallKinematics:
    """Radii and speeds of one ball; every field has the broadcast shape of speeds and contact angle."""

    inner_radius: Array  # R_i, bearing axis to the inner contact, m
    outer_radius: Array  # R_o, bearing axis to the outer contact, m
    cage_speed: Array  # of the ball's orbit, in the fixed frame, rad/s
    ball_speed: Array  # w_b, of the ball about its own axis relative to the cage, rad/s
    entrainment_speed: Array  # u, mean of both surfaces relative to the contact, the same on both races, m/s
    inner_rolling_rate: Array  # w_roll,i, rad/s
    outer_rolling_rate: Array  # w_roll,o, rad/s
    spin_difference: Array  # w_s,i - w_s,o = w sin(al), rad/s


def ball_kinematics(
    *,
    inner_speed: ArrayLike,
    contact_angle: ArrayLike,
    pitch_diameter: float,
    ball_diameter: float,
    outer_speed: ArrayLike = 0.0,
) -> BallKinematics:
    """Speeds of one ball; inner_speed, outer_speed and contact_angle broadcast.

    inner_speed, outer_speed : of the rings, any sign, rad/s
    contact_angle : al, rad, in [0, pi/2]
    pitch_diameter, ball_diameter : d_m > D = 2 r, m

        R_i, R_o = d_m/2 -/+ r cos(al),  w = w_inner - w_outer
        cage (w_inner R_i + w_outer R_o)/d_m,  ball w R_i R_o/(r d_m),  entrainment w R_i R_o/d_m
        w_roll,i = w R_o/(2 r),  w_roll,o = w R_i/(2 r),  w_s,i - w_s,o = w sin(al)
    All are linear in w: called with inner_speed 1 it gives the rates per unit w, which exist at standstill too.
    Raises InputError for a speed that is not finite, an angle outside its range, or a ball no smaller than d_m.
    """
    require_finite(inner_speed=inner_speed, outer_speed=outer_speed)
    require_non_negative(contact_angle=contact_angle)
    require_positive(pitch_diameter=pitch_diameter, ball_diameter=ball_diameter)
    if np.any(np.asarray(contact_angle) > np.pi / 2):
        raise InputError(
            f"contact_angle must be at most pi/2 rad, got {float(np.max(contact_angle))!r}; is it in degrees?"
        )
    if not ball_diameter < pitch_diameter:
        raise InputError(f"ball_diameter {ball_diameter!r} m must be below pitch_diameter {pitch_diameter!r} m")
    inner, outer, angle = np.broadcast_arrays(
        *(np.asarray(value, dtype=np.float64) for value in (inner_speed, outer_speed, contact_angle))
    )
    speed, radius = inner - outer, ball_diameter / 2
    inner_radius = pitch_diameter / 2 - radius * np.cos(angle)
    outer_radius = pitch_diameter / 2 + radius * np.cos(angle)
    entrainment = speed * inner_radius * outer_radius / pitch_diameter
    return BallKinematics(
        inner_radius=inner_radius,
        outer_radius=outer_radius,
        cage_speed=(inner * inner_radius + outer * outer_radius) / pitch_diameter,
        ball_speed=entrainment / radius,
        entrainment_speed=entrainment,
        inner_rolling_rate=speed * outer_radius / ball_diameter,
        outer_rolling_rate=speed * inner_radius / ball_diameter,
        spin_difference=speed * np.sin(angle),
    )
