"""What a cage can ask of its balls: the force that the races carry, how much of it a whirl needs, and balls that lead.

A cage drives and brakes its balls only as far as the races hold them along the orbit. Two races share the force N of
the cage on a ball, and the friction mu_c N in the pocket loads one of them and relieves the other.
Under a radial load or a moment the contact angle changes with the azimuth, and with it the speed of the orbit: balls
lead on one side of the bearing and lag on the other. The cage gives way by half of that. Where its pockets are too
tight for the rest, it presses on all balls and drags them along by creep.
Balls whose motion is given are right as long as the cage uses little of the grip. Beyond LARGEST_GRIP balls slide, the
whirl breaks down or the torque of the races rises several-fold, and only a motion of balls and cage together shows it.
Source: derived here.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_non_negative, require_positive
from analytic.loads.balls import LoadedBalls
from analytic.numerics.root import Sought, bracketed_root
from analytic.scene import Array
from analytic.words import speed_of

# Of the grip number. Below, motions of balls and cage together give the forces of given balls within 2 %; beyond, balls
# slide at the peaks of the force.
LARGEST_GRIP = 0.9
# Of the cage's torque at LARGEST_GRIP: there the races take up to this share of the sliding. Slip in the races is in
# proportion to the force, so the share is too: at a grip number of 0.026 those motions differ by 0.7 %, this by 0.9 %.
LOST_TO_RACES = 0.3
# Of the torque of squeezed balls. Marched motions with creep that saturates have 0.62 to 1.32 of their forces (some of
# them in tests/analytic/cage/test_grip.py), but only a rigid cage is squeezed so: one that bends, or whose pockets are
# longer along the orbit, may rest. The whole of it is therefore uncertain.
SQUEEZE_SPREAD = 1.0
ANGLE_TOLERANCE = 1e-12  # of beta: Newton's last step reaches it at once
SQUEEZE = Sought("the angle of squeezed balls did not settle", "rad", "check the pocket's stiffness")


def carried_force(*, inner_grip: ArrayLike, outer_grip: ArrayLike, pocket_friction: ArrayLike) -> Array:
    """N = min(2 mu Q_i/(1 + mu_c), 2 mu Q_o/|1 - mu_c|), N: what a cage can brake a ball with; all broadcast.

    inner_grip, outer_grip : mu Q_i, mu Q_o, the friction of each race, N, >= 0;  pocket_friction : mu_c, >= 0
    The pocket's friction mu_c N turns against the ball's rotation. So the inner race holds N (1 + mu_c)/2 and the outer
    one N (1 - mu_c)/2; at mu_c = 1 the outer race holds nothing, and beyond it pushes the other way. For a cage that
    drives a ball the races change places: exchange the first two arguments.
    Left out: the radial part of the force, which changes Q. It counts once N exceeds Q/2.
    """
    require_non_negative(inner_grip=inner_grip, outer_grip=outer_grip, pocket_friction=pocket_friction)
    inner, outer, mu = np.broadcast_arrays(np.asarray(inner_grip), np.asarray(outer_grip), np.asarray(pocket_friction))
    relieved = np.abs(1 - mu)
    by_outer = np.divide(2 * outer, relieved, out=np.full(mu.shape, np.inf), where=relieved > 0)
    return np.minimum(2 * inner / (1 + mu), by_outer)


def grip_number(*, whirl_force: ArrayLike, ball_count: ArrayLike, carried_force: ArrayLike) -> Array:
    """rho = m (w_b r/nabla + w_c)^2 nabla/(Z N): the whirl's force over what the races carry; all broadcast.

    whirl_force : m (w_b r/nabla + w_c)^2 nabla of `analytic.cage.steady.whirl_force`, N, >= 0;  ball_count : Z, > 0
    carried_force : N of the weakest ball in either direction, 2 mu min(Q)/(1 + mu_c), N, >= 0
    The force on a ball of a whirling cage brakes and drives it in turn. Infinite where a ball has no grip.
    Regimes, of motions of balls and cage together that start in whirl: below 0.9 the balls hold their motion; up to 1.7
    the whirl lasts and balls slide at the peaks; up to 3 it breaks down within tens of milliseconds; further beyond it
    dies into rattling or rest.
    """
    require_non_negative(whirl_force=whirl_force, carried_force=carried_force)
    require_positive(ball_count=ball_count)
    return used_share(whirl_force, np.asarray(ball_count) * np.asarray(carried_force))


def used_share(force: ArrayLike, available: ArrayLike) -> Array:
    """force/available; infinite where nothing is available for a force, 0 without a force."""
    used, limit = np.broadcast_arrays(np.asarray(force, dtype=np.float64), np.asarray(available, dtype=np.float64))
    return np.divide(used, limit, out=np.where(used > 0, np.inf, 0.0), where=limit > 0)


def ball_lead(orbit_rate: ArrayLike, *, pitch_radius: float) -> Array:
    """A, m, signed: balls at the azimuth psi lead an even orbit by A sin(psi), or lag behind it; (...).

    orbit_rate : (..., Z) w_c of the balls at psi_j = 2 pi j/Z over any speed, > 0;  pitch_radius : r_m, m
    A ball that passes psi with w_c(psi) is ahead by r_m times the integral of 1 - W/w_c over psi; W is its mean speed.
    A is the first harmonic of that integral. Where the contact angle is al + a cos(psi), with g = D/d_m, this is
        A = r_m g sin(al) a/(1 - g cos al)
    The higher harmonics are 1 % of it under a radial load as large as the thrust, less under smaller loads.
    One column stands for balls that are alike: they do not lead.
    """
    require_positive(orbit_rate=orbit_rate, pitch_radius=pitch_radius)
    time = 1 / np.asarray(orbit_rate, dtype=np.float64)
    balls = time.shape[-1]
    wave = 2 * np.sum(time * np.cos(2 * np.pi * np.arange(balls) / balls), axis=-1) / np.sum(time, axis=-1)
    return np.asarray(-pitch_radius * wave if balls > 1 else np.zeros_like(wave))


def squeeze_force(
    *,
    ball_lead: ArrayLike,
    room: ArrayLike,
    pocket_friction: ArrayLike,
    pocket_stiffness: ArrayLike,
    creep_stiffness: ArrayLike,
    outer_radius: ArrayLike,
) -> Array:
    """N = 2 G a b C11 |A| sin(beta)/R_o, N, of each ball: pockets too tight for balls that lead; all broadcast.

        2 nabla + 2 (N/K_pb)^(2/3) = |A| (cos(beta) + mu_c sin(beta))
    In stiff pockets without friction this is N = 2 G a b C11 sqrt(A^2 - (2 nabla)^2)/R_o.
    ball_lead : A, m;  room : 2 nabla, the lead that the pockets leave free, m, > 0;  0 where |A| <= 2 nabla
    pocket_friction : mu_c;  pocket_stiffness : K_pb, N/m^1.5, > 0
    creep_stiffness : G a b C11, N, of a race, > 0, see `race_grip`;  outer_radius : R_o, m, > 0
    The cage holds each ball nabla + (N/K_pb)^(2/3) off the middle of its pocket, in directions that turn twice as fast
    as the azimuth, so that all press alike. The cage has gone off the axis of the load by the angle beta; along the
    orbit act N sin(psi + beta) and mu_c N cos(psi + beta), and the races let a ball creep at this force times
    u/(2 G a b C11). In the steady motion creep takes from the lead what the pockets do not leave. This holds at any
    speed, as creep and conflict are both in proportion to it. The angle takes some radians of the orbit to grow.
    Valid for a rigid cage and small creep, N below half of `carried_force`, which limits N.
    """
    require_positive(
        room=room, pocket_stiffness=pocket_stiffness, creep_stiffness=creep_stiffness, outer_radius=outer_radius
    )
    require_non_negative(pocket_friction=pocket_friction)
    lead, free, mu, pocket, creep = np.broadcast_arrays(
        np.abs(np.asarray(ball_lead, dtype=np.float64)),
        np.asarray(room, dtype=np.float64),
        np.asarray(pocket_friction, dtype=np.float64),
        np.asarray(pocket_stiffness, dtype=np.float64),
        2 * np.asarray(creep_stiffness) / np.asarray(outer_radius),
    )
    softness = 2 * (creep * lead / pocket) ** (2 / 3)  # m, of the lead, at beta = pi/2

    def surplus(beta: Array) -> tuple[Array, Array]:
        """Over the lead, of what pockets and compliance leave, with its slope."""
        sine, cosine = np.sin(beta), np.cos(beta)
        with np.errstate(divide="ignore", invalid="ignore"):
            slope = softness * (2 / 3) * cosine / np.cbrt(sine) + lead * (sine - mu * cosine)
        return free + softness * np.cbrt(sine) ** 2 - lead * (cosine + mu * sine), slope

    end = np.where(lead > free, np.pi / 2, 0.0)
    beta = bracketed_root(
        surplus, start=end / 4, low=np.zeros_like(end), high=end, relative=ANGLE_TOLERANCE, sought=SQUEEZE
    )
    return creep * lead * np.sin(beta)


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceGrip:
    """How the races hold the balls along their orbit, at n operating points for m balls in columns."""

    friction: Array | None  # (2, n, m) mu Q of each contact, N; None: the friction of the races is not known
    alike: int  # balls that each column stands for
    ball_lead: Array  # (n,) A, m
    creep_stiffness: Array  # (n,) G a b C11, mean over balls and races, N
    outer_radius: Array  # (n,) R_o, m

    def carried(self, pocket_friction: Array) -> Array | None:
        """(n, m) N: what each ball carries in either direction; pocket_friction : mu_c, (n,)."""
        if self.friction is None:
            return None
        (inner, outer), mu = self.friction, pocket_friction[:, None]
        braked = carried_force(inner_grip=inner, outer_grip=outer, pocket_friction=mu)
        return np.minimum(braked, carried_force(inner_grip=outer, outer_grip=inner, pocket_friction=mu))

    def require_grip(self, inner_speed: Array) -> None:
        """Raise InputError for races or a ball that cannot drive a cage; inner_speed : w, (n,), rad/s."""
        if self.friction is None:
            return
        if not np.any(self.friction):
            raise InputError(
                "races with a friction of 0 drive no cage: balls then neither roll nor push it; give [friction] "
                'coefficient above 0, usual are 0.05 to 0.12, or effects.cage = "off"'
            )
        free = (self.friction.max(axis=0) == 0) & (inner_speed != 0)[:, None]
        if np.any(free):
            point, ball = (int(index) for index in np.argwhere(free)[0])
            raise InputError(
                f"ball {ball + 1} of {free.shape[1]} has a load of 0 N on both races at "
                f"{speed_of(inner_speed[point])}: nothing turns it, and it cannot drive the cage; leave "
                'effects.centrifugal on "auto", raise operation.axial_load, or give effects.cage = "off"'
            )


def race_grip(balls: LoadedBalls, friction_coefficient: Array | float | None, *, pitch_radius: float) -> RaceGrip:
    """The grip of loaded balls; friction_coefficient : mu of each race contact, (2, n, m) or broadcasting to it.

    Creep along rolling has G C11 = pi^2 G/(4 (1 - nu)), the limit of a long ellipse: pi^2 E*/4 for like bodies.
    """
    stiffness = np.pi**2 / 4 * balls.modulus * balls.contact.semi_axis_x * balls.contact.semi_axis_y
    friction = None
    if friction_coefficient is not None:
        friction = np.where(balls.load > 0, friction_coefficient * balls.load, 0.0)
    return RaceGrip(
        friction=friction,
        alike=balls.alike,
        ball_lead=ball_lead(balls.motion.cage_speed, pitch_radius=pitch_radius),
        creep_stiffness=stiffness.mean(axis=(0, 2)),
        outer_radius=balls.motion.outer_radius.mean(axis=1),
    )
