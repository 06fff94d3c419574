"""How a ball rolls and spins between two rings, by closed forms.

Assumes no gross slip, and a ball that turns about an axis in its axial plane. The axis has the pitch B to the bearing
axis: that of outer control, where the ball does not spin on its outer race, unless another is given. Where both contact
angles are equal, no speed but the spins depends on it. A free ball (`analytic.free_ball`) has its own pitch.
w is the speed of the inner ring about the bearing axis; the outer ring stands still. Every speed takes its sign from
w, and all are linear in it: w = 1 gives the rates per unit w, which exist at standstill too. Rates of a contact are
those of the ball relative to the race: rolling about the transverse axis, spin about the normal.
Source: [Harris2007b] section 2; the relations here follow from no slip of rigid bodies at both contacts' centres.
"""

from typing import NamedTuple

import numpy as np

from analytic.loads.numbers import BearingNumbers
from analytic.numerics.compilation import compiled

MOST_LEAN = np.pi / 2 - 0.01  # rad, of the ball's axis to the rolling direction's normal plane at a contact


class BallMotion(NamedTuple):
    """Radii and speeds of one ball."""

    inner_radius: float  # R_i, bearing axis to the inner contact, m
    outer_radius: float  # R_o, bearing axis to the outer contact, m
    cage_speed: float  # of the ball's orbit, rad/s
    ball_speed: float  # w_b, of the ball about its own axis relative to the cage, rad/s
    inner_entrainment: float  # u_i, of both surfaces relative to the contact, m/s
    outer_entrainment: float  # u_o
    inner_rolling_rate: float  # w_roll,i, rad/s
    outer_rolling_rate: float  # w_roll,o, rad/s
    spin_difference: float  # w_s,i - w_s,o, rad/s
    pitch: float  # B, of the ball's axis to the bearing axis, rad


@compiled
def outer_control_pitch(inner_angle: float, outer_angle: float, ratio: float) -> float:
    """tan B = sin(al_o)/(cos(al_o) + D/d_m), of outer control; B, rad.

    inner_angle, outer_angle : al_i, al_o, rad, in [-pi/2, pi/2];  ratio : D/d_m, below 1
    """
    pitch = np.arctan2(np.sin(outer_angle), np.cos(outer_angle) + ratio)
    # A ball that its inner race hardly presses may lie so steep there that outer control would not turn it at all.
    return min(max(pitch, inner_angle - MOST_LEAN), inner_angle + MOST_LEAN)


@compiled
def ball_motion(
    speed: float, inner_angle: float, outer_angle: float, pitch: float, pitch_diameter: float, ball_diameter: float
) -> BallMotion:
    """Speeds of one ball whose axis is known.

    speed : w, rad/s;  inner_angle, outer_angle : al_i, al_o, contact angles, rad, in [-pi/2, pi/2]
    pitch : B, rad, less than a right angle from both contact angles;  pitch_diameter, ball_diameter : d_m > D = 2 r, m
        R_i = d_m/2 - r cos(al_i),  R_o = d_m/2 + r cos(al_o)
        cage w/[1 + R_o cos(B - al_i)/(R_i cos(B - al_o))]
        w_b = cage R_o/(r cos(B - al_o)),  u_i = r w_b cos(B - al_i),  u_o = r w_b cos(B - al_o)
        w_roll,i = u_i/r + (u_i/R_i) cos(al_i),  w_roll,o = u_o/r - (u_o/R_o) cos(al_o)
        w_s,i - w_s,o = (u_i/R_i) sin(al_i) + (u_o/R_o) sin(al_o) - w_b [sin(B - al_i) + sin(al_o - B)]
    At equal angles R_i + R_o = d_m, w_roll,i = w R_o/(2 r), w_roll,o = w R_i/(2 r) and the last is w sin(al). Between
    inner and outer control the spin difference hardly depends on the pitch: kinematics alone do not say how the spin is
    shared.
    """
    radius = ball_diameter / 2
    inner_radius = pitch_diameter / 2 - radius * np.cos(inner_angle)
    outer_radius = pitch_diameter / 2 + radius * np.cos(outer_angle)
    rolls_inner, rolls_outer = np.cos(pitch - inner_angle), np.cos(pitch - outer_angle)
    # Speed of each race relative to the ball's orbit, about the bearing axis.
    both = inner_radius * rolls_outer + outer_radius * rolls_inner
    passes_inner, passes_outer = speed * outer_radius * rolls_inner / both, speed * inner_radius * rolls_outer / both
    inner_entrainment, outer_entrainment = passes_inner * inner_radius, passes_outer * outer_radius
    ball_speed = speed * inner_radius * outer_radius / (both * radius)
    return BallMotion(
        inner_radius,
        outer_radius,
        passes_outer,
        ball_speed,
        inner_entrainment,
        outer_entrainment,
        inner_entrainment / radius + passes_inner * np.cos(inner_angle),
        outer_entrainment / radius - passes_outer * np.cos(outer_angle),
        passes_inner * np.sin(inner_angle)
        + passes_outer * np.sin(outer_angle)
        - ball_speed * (np.sin(pitch - inner_angle) + np.sin(outer_angle - pitch)),
        pitch,
    )


@compiled
def ball_kinematics(
    speed: float, inner_angle: float, outer_angle: float, pitch_diameter: float, ball_diameter: float
) -> BallMotion:
    """Speeds of one ball at the pitch of outer control; arguments of `ball_motion`."""
    pitch = outer_control_pitch(inner_angle, outer_angle, ball_diameter / pitch_diameter)
    return ball_motion(speed, inner_angle, outer_angle, pitch, pitch_diameter, ball_diameter)


@compiled
def ruled_motion(bearing: BearingNumbers, speed: float, inner_angle: float, outer_angle: float) -> BallMotion:
    """Speeds of a ball of a bearing at the pitch of outer control; arguments of `ball_motion`."""
    return ball_kinematics(speed, inner_angle, outer_angle, bearing.pitch_diameter, 2 * bearing.ball_radius)
