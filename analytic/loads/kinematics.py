"""How a ball rolls and spins between two rings that turn at different speeds.

Assumes no gross slip, and a ball that turns about an axis in its axial plane at the mean of both contact angles. These
differ where something else than the races loads the ball. w is the speed of the inner ring minus that of the outer,
about the bearing axis. Every speed takes its sign from w, except the cage's, which belongs to the fixed frame. Rates of
a contact are those of the ball relative to the race: rolling about the transverse axis, spin about the normal.
Source: [Harris2007b] section 2; the relations here follow from no slip of rigid bodies at both contacts' centres.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_finite, require_positive
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
    spin_difference: Array  # w_s,i - w_s,o, rad/s


def ball_kinematics(
    *,
    inner_speed: ArrayLike,
    inner_angle: ArrayLike,
    outer_angle: ArrayLike,
    pitch_diameter: float,
    ball_diameter: float,
    outer_speed: ArrayLike = 0.0,
) -> BallKinematics:
    """Speeds of one ball; speeds and angles broadcast.

    inner_speed, outer_speed : of the rings, any sign, rad/s
    inner_angle, outer_angle : al_i, al_o, contact angles, rad, in [-pi/2, pi/2]
    pitch_diameter, ball_diameter : d_m > D = 2 r, m
    With h = (al_o - al_i)/2, so that the ball's axis makes the angle al_i + h with the radial plane's normal:
        R_i = d_m/2 - r cos(al_i),  R_o = d_m/2 + r cos(al_o),  w = w_inner - w_outer
        cage (w_inner R_i + w_outer R_o)/(R_i + R_o),  u = w R_i R_o/(R_i + R_o),  w_b = u/(r cos h)
        w_roll,i = w_b cos h + (u/R_i) cos(al_i),  w_roll,o = w_b cos h - (u/R_o) cos(al_o)
        w_s,i - w_s,o = (u/R_i) sin(al_i) + (u/R_o) sin(al_o) - 2 w_b sin h
    At equal angles R_i + R_o = d_m, w_roll,i = w R_o/(2 r), w_roll,o = w R_i/(2 r) and the last is w sin(al). A ball
    that turns about an axis a little off the mean spins faster on both races by the same amount: kinematics alone do
    not say how the spin is shared. All are linear in w: inner_speed 1 gives the rates per unit w, which exist at
    standstill too.
    Raises InputError for a speed that is not finite, an angle outside its range, or a ball no smaller than d_m.
    """
    require_finite(inner_speed=inner_speed, outer_speed=outer_speed, inner_angle=inner_angle, outer_angle=outer_angle)
    require_positive(pitch_diameter=pitch_diameter, ball_diameter=ball_diameter)
    for name, angle in (("inner_angle", inner_angle), ("outer_angle", outer_angle)):
        largest = float(np.max(np.abs(angle), initial=0.0))
        if largest > np.pi / 2:
            raise InputError(f"{name} must be at most pi/2 rad, got {largest!r}; is it in degrees?")
    if not ball_diameter < pitch_diameter:
        raise InputError(f"ball_diameter {ball_diameter!r} m must be below pitch_diameter {pitch_diameter!r} m")
    inner, outer, at_inner, at_outer = np.broadcast_arrays(
        *(np.asarray(value, dtype=np.float64) for value in (inner_speed, outer_speed, inner_angle, outer_angle))
    )
    speed, radius, half = inner - outer, ball_diameter / 2, (at_outer - at_inner) / 2
    cosine_inner, cosine_outer = np.cos(at_inner), np.cos(at_outer)
    inner_radius = pitch_diameter / 2 - radius * cosine_inner
    outer_radius = pitch_diameter / 2 + radius * cosine_outer
    both = inner_radius + outer_radius
    entrainment = speed * inner_radius * outer_radius / both
    ball_speed = entrainment / radius / np.cos(half)
    # Speed of each race relative to the ball's orbit, about the bearing axis.
    passes_inner, passes_outer = speed * outer_radius / both, speed * inner_radius / both
    return BallKinematics(
        inner_radius=inner_radius,
        outer_radius=outer_radius,
        cage_speed=(inner * inner_radius + outer * outer_radius) / both,
        ball_speed=ball_speed,
        entrainment_speed=entrainment,
        inner_rolling_rate=entrainment / radius + passes_inner * cosine_inner,
        outer_rolling_rate=entrainment / radius - passes_outer * cosine_outer,
        spin_difference=passes_inner * np.sin(at_inner)
        + passes_outer * np.sin(at_outer)
        - 2 * ball_speed * np.sin(half),
    )
