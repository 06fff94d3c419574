"""How a ball rolls and spins between two rings that turn at different speeds, by closed forms.

Assumes no gross slip, and a ball that turns about an axis in its axial plane. The axis has the pitch B to the bearing
axis: that of outer control, where the ball does not spin on its outer race, unless another is given. Where both contact
angles are equal, no speed but the spins depends on it. A free ball (`analytic.free_ball`) has its own pitch.
w is the speed of the inner ring minus that of the outer, about the bearing axis. Every speed takes its sign from w,
except the cage's, which belongs to the fixed frame. Rates of a contact are those of the ball relative to the race:
rolling about the transverse axis, spin about the normal.
Source: [Harris2007b] section 2; the relations here follow from no slip of rigid bodies at both contacts' centres.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_finite, require_positive
from analytic.loads.numbers import BearingNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import mapped
from analytic.scene import Array

MOST_LEAN = np.pi / 2 - 0.01  # rad, of the ball's axis to the rolling direction's normal plane at a contact


@dataclass(frozen=True, kw_only=True, eq=False)
class BallKinematics:
    """Radii and speeds of one ball; every field has the broadcast shape of speeds and contact angle."""

    inner_radius: Array  # R_i, bearing axis to the inner contact, m
    outer_radius: Array  # R_o, bearing axis to the outer contact, m
    cage_speed: Array  # of the ball's orbit, in the fixed frame, rad/s
    ball_speed: Array  # w_b, of the ball about its own axis relative to the cage, rad/s
    inner_entrainment: Array  # u_i, of both surfaces relative to the contact, m/s
    outer_entrainment: Array  # u_o
    inner_rolling_rate: Array  # w_roll,i, rad/s
    outer_rolling_rate: Array  # w_roll,o, rad/s
    spin_difference: Array  # w_s,i - w_s,o, rad/s
    pitch: Array  # B, of the ball's axis to the bearing axis, rad

    @property
    def entrainment_speed(self) -> Array:
        """(2, ...) u on inner and outer race, m/s."""
        return np.stack([self.inner_entrainment, self.outer_entrainment])


class BallMotion(NamedTuple):
    """The `BallKinematics` of one ball in numbers, for compiled formulas."""

    inner_radius: float
    outer_radius: float
    cage_speed: float
    ball_speed: float
    inner_entrainment: float
    outer_entrainment: float
    inner_rolling_rate: float
    outer_rolling_rate: float
    spin_difference: float
    pitch: float


@compiled
def outer_control_pitch(inner_angle: float, outer_angle: float, ratio: float) -> float:
    """B of outer control, rad; ratio : D/d_m."""
    pitch = np.arctan2(np.sin(outer_angle), np.cos(outer_angle) + ratio)
    # A ball that its inner race hardly presses may lie so steep there that outer control would not turn it at all.
    return min(max(pitch, inner_angle - MOST_LEAN), inner_angle + MOST_LEAN)


@compiled
def ball_motion(
    inner_speed: float,
    outer_speed: float,
    inner_angle: float,
    outer_angle: float,
    pitch: float,
    pitch_diameter: float,
    ball_diameter: float,
) -> BallMotion:
    """`ball_kinematics` of one ball, whose pitch is known."""
    speed, radius = inner_speed - outer_speed, ball_diameter / 2
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
        outer_speed + passes_outer,
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
def ruled_motion(bearing: BearingNumbers, inner_speed: float, inner_angle: float, outer_angle: float) -> BallMotion:
    """Speeds of a ball at the pitch of outer control, the outer ring at rest; arguments as of `ball_kinematics`."""
    ball_diameter, pitch_diameter = 2 * bearing.ball_radius, bearing.pitch_diameter
    pitch = outer_control_pitch(inner_angle, outer_angle, ball_diameter / pitch_diameter)
    return ball_motion(inner_speed, 0.0, inner_angle, outer_angle, pitch, pitch_diameter, ball_diameter)


def ball_kinematics(
    *,
    inner_speed: ArrayLike,
    inner_angle: ArrayLike,
    outer_angle: ArrayLike,
    pitch_diameter: float,
    ball_diameter: float,
    outer_speed: ArrayLike = 0.0,
    pitch: ArrayLike | None = None,
) -> BallKinematics:
    """Speeds of one ball; speeds and angles broadcast.

    inner_speed, outer_speed : of the rings, any sign, rad/s
    inner_angle, outer_angle : al_i, al_o, contact angles, rad, in [-pi/2, pi/2]
    pitch_diameter, ball_diameter : d_m > D = 2 r, m
    pitch : B of the ball's axis, rad, less than a right angle from both contact angles; None: tan B = sin(al_o)/
        (cos(al_o) + D/d_m), outer control
    With g = D/d_m and w = w_inner - w_outer:
        R_i = d_m/2 - r cos(al_i),  R_o = d_m/2 + r cos(al_o)
        cage w_outer + w/[1 + R_o cos(B - al_i)/(R_i cos(B - al_o))]
        w_b = (cage - w_outer) R_o/(r cos(B - al_o)),  u_i = r w_b cos(B - al_i),  u_o = r w_b cos(B - al_o)
        w_roll,i = u_i/r + (u_i/R_i) cos(al_i),  w_roll,o = u_o/r - (u_o/R_o) cos(al_o)
        w_s,i - w_s,o = (u_i/R_i) sin(al_i) + (u_o/R_o) sin(al_o) - w_b [sin(B - al_i) + sin(al_o - B)]
    At equal angles R_i + R_o = d_m, w_roll,i = w R_o/(2 r), w_roll,o = w R_i/(2 r) and the last is w sin(al). Between
    inner and outer control the spin difference hardly depends on the pitch: kinematics alone do not say how the spin is
    shared. All are linear in w: inner_speed 1 gives the rates per unit w, which exist at standstill too.
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
    if pitch is None:
        pitch = mapped(outer_control_pitch, inner_angle, outer_angle, ball_diameter / pitch_diameter)
    fields = mapped(
        ball_motion, inner_speed, outer_speed, inner_angle, outer_angle, pitch, pitch_diameter, ball_diameter
    )
    return BallKinematics(**dict(zip(BallMotion._fields, fields, strict=True)))
