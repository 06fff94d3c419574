"""A cage driven by its balls, and the closed forms of its two steady motions.

z is the axis of the bearing. The motion of the balls is given: each runs on the pitch circle with the speed of the
orbit and turns about an axis at the contact angle to z. The cage is rigid, a thin ring through the middles of the
pockets. A cage at rest hangs on its balls with its weight, and all balls slide on it. A whirling cage is thrown outward
against all balls at once and rolls in its pockets like a ring on a peg. Both motions are stable over a wide range of
speeds, so the start decides between them (`analytic.cage.motion`).
Torques are the power of sliding over the speed of the ring. The moment of the balls on the cage about z cannot serve:
it averages to zero in every steady motion that nothing else brakes.
Source: derived here.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.cage.pocket import impact
from analytic.contact.hertz import elliptic_integrals
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.numerics.compilation import compiled
from analytic.scene import STANDARD_GRAVITY, Array, PocketAxis
from analytic.words import length_of

LEAST_GRAVITY = 1e-3 * STANDARD_GRAVITY  # m/s^2, of a cage without gravity, for the load of its film


@dataclass(frozen=True, kw_only=True)
class LandGuidance:
    """The land of a ring that the rims of the cage touch before the pockets do; as stiff a contact as a pocket's."""

    radius: float  # of the land, m
    half_clearance: float  # half of the diametral clearance, m
    outside: bool  # True: land of the outer ring; False: of the inner ring, in the bore of the cage
    speed: float  # of that ring, rad/s
    half_width: float  # from the middle of the cage to each rim, m

    def __post_init__(self) -> None:
        lengths = {name: getattr(self, name) for name in ("radius", "half_clearance", "half_width")}
        require_positive(**{f"land.{name}": length for name, length in lengths.items()})
        require_finite(**{"land.speed": self.speed})


@dataclass(frozen=True, kw_only=True)
class DrivenCage:
    """A cage and the balls that drive it, at one operating point."""

    mass: float  # kg
    ball_count: int  # Z
    ball_radius: float  # r, m
    pitch_radius: float  # r_m, m
    half_clearance: float  # nabla, half of the pocket's clearance, m
    centre_offset: float = 0.0  # D_p/2 - k, m
    pocket_axis: PocketAxis = "axial"  # x in `analytic.cage.pocket`: the line through the centres of both shells
    stiffness: float  # K_pb, N/m^1.5
    sheet_softness: float = 0.0  # 1/k, m/N, of the sheet in series with the contact
    restitution: float  # e, of an impact, a share
    friction_coefficient: float  # mu, of ball on pocket
    orbit_speed: float  # w_c, of the balls about the bearing's axis, rad/s
    ball_speed: float  # w_b, of each ball about its own axis relative to the orbit, with the sign of w, rad/s
    contact_angle: float  # al, between the axis of a ball's rotation and that of the bearing, rad
    ring_speed: float  # w, rad/s
    gravity: tuple[float, float, float] = (0.0, -STANDARD_GRAVITY, 0.0)  # m/s^2
    drag: float = 0.0  # c, braking torque of the oil over the speed of the cage, N m s
    ball_lead: float = 0.0  # how far balls lead on one side of the bearing and lag on the other, m
    land: LandGuidance | None = None
    smoothing: float = 1e-3  # v0 of the friction's direction, m/s; reduced where the balls turn slowly
    axial_inertia: float | None = None  # about z, kg m^2; None: that of a thin ring of the pitch radius
    transverse_inertia: float | None = None  # about an axis across z, kg m^2; None: that of a thin ring

    def __post_init__(self) -> None:
        require_positive(
            mass=self.mass,
            ball_radius=self.ball_radius,
            pitch_radius=self.pitch_radius,
            half_clearance=self.half_clearance,
            stiffness=self.stiffness,
            smoothing=self.smoothing,
        )
        if not self.ball_count >= 1:
            raise InputError(f"ball_count must be at least 1, got {self.ball_count!r}: without balls nothing drives")
        if self.pocket_axis not in ("axial", "radial"):
            raise InputError(f'pocket_axis must be "axial" or "radial", got {self.pocket_axis!r}')
        axial, transverse = self.inertia
        require_positive(axial_inertia=axial, transverse_inertia=transverse)
        require_non_negative(
            centre_offset=self.centre_offset,
            sheet_softness=self.sheet_softness,
            friction_coefficient=self.friction_coefficient,
            drag=self.drag,
        )
        require_finite(
            orbit_speed=self.orbit_speed,
            ball_speed=self.ball_speed,
            contact_angle=self.contact_angle,
            ring_speed=self.ring_speed,
            gravity=self.gravity,
            ball_lead=self.ball_lead,
        )
        if not self.centre_offset < self.half_clearance:
            raise InputError(
                f"centre_offset {self.centre_offset!r} m must be below half_clearance {self.half_clearance!r} m: the "
                "shells clamp the ball"
            )
        require_loose_balls(
            ball_lead=self.ball_lead,
            half_clearance=self.half_clearance,
            centre_offset=self.centre_offset,
            land_half_clearance=np.inf if self.land is None else self.land.half_clearance,
        )

    @property
    def inertia(self) -> tuple[float, float]:
        """Moments of inertia about z and about an axis across it, kg m^2; m r_m^2 and m r_m^2/2 by default."""
        ring = self.mass * self.pitch_radius**2
        axial, transverse = self.axial_inertia, self.transverse_inertia
        return ring if axial is None else axial, ring / 2 if transverse is None else transverse

    @property
    def impact_speed(self) -> float:
        """Speed of the fastest impacts to expect, m/s: of the ball's surface, or of a fall through the pocket."""
        fall = np.sqrt(4 * np.linalg.norm(self.gravity) * self.half_clearance)
        return float(max(abs(self.ball_speed) * self.ball_radius, fall))

    @property
    def middle(self) -> Array:
        """(3,) m: the place of the cage with equal distances to all balls, or the nearest one that the land allows."""
        shift = self.ball_lead / 2
        if self.land is not None:
            shift = float(np.clip(shift, -self.land.half_clearance, self.land.half_clearance))
        return np.array([-shift, 0.0, 0.0])

    @property
    def pocket_places(self) -> Array:
        """(Z, 3) m: the middles of the pockets in the cage's own frame."""
        azimuth = 2 * np.pi * np.arange(self.ball_count) / self.ball_count
        return self.pitch_radius * np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth], axis=1)

    def ball_places(self, angle: float) -> Array:
        """The centres of the balls in the fixed frame.

        Parameters
        ----------
        angle : float
            Through which they have orbited, rad.

        Returns
        -------
        ndarray, shape (Z, 3)
            In m.
        """
        azimuth = angle + 2 * np.pi * np.arange(self.ball_count) / self.ball_count
        azimuth += self.ball_lead / self.pitch_radius * np.sin(azimuth)
        return self.pitch_radius * np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth], axis=1)

    def free_path(self, direction: Array) -> float:
        """Distance that the level cage can move from `middle` until a ball or the land stops it.

        Parameters
        ----------
        direction : ndarray, shape (3,)
            Of length 1, dimensionless.

        Returns
        -------
        float
            In m. The balls are where a motion begins, at the azimuths 2 pi i/Z.
        """
        pockets = self.pocket_places
        axes = np.broadcast_to([0.0, 0.0, 1.0], pockets.shape)
        if self.pocket_axis == "radial":
            axes = pockets / self.pitch_radius
        offset = self.ball_places(0.0) - pockets - self.middle
        offsets = np.concatenate([offset + side * self.centre_offset * axes for side in (1, -1)])
        ahead = offsets @ direction
        distance = np.min(ahead + np.sqrt(ahead**2 + self.half_clearance**2 - np.sum(offsets**2, axis=1)))
        sideways = np.hypot(*direction[:2])
        if self.land is not None and sideways > 0:
            outward = self.middle @ direction / sideways
            reach = np.sqrt(outward**2 + self.land.half_clearance**2 - self.middle @ self.middle) - outward
            distance = min(distance, reach / sideways)
        return float(distance)

    @property
    def crossing_time(self) -> float:
        """Time in which the cage falls through its pockets, or without gravity is carried through by the balls, s."""
        pull, surface = np.linalg.norm(self.gravity), abs(self.ball_speed) * self.ball_radius
        if pull > 0:
            return float(np.sqrt(4 * self.half_clearance / pull))
        return 2 * self.half_clearance / surface if surface > 0 else 0.0

    @property
    def contact_time(self) -> float:
        """Duration of the shortest impact to expect, the fastest on all balls at once, s; infinite at standstill.

        A sheet that bends only makes impacts longer.
        """
        if not self.impact_speed > 0:
            return np.inf
        mass = self.mass / max(self.ball_count, 3)  # a single ball far from the centre meets a third of the mass
        return impact(mass=mass, speed=self.impact_speed, stiffness=self.stiffness).duration


def lead_room(*, half_clearance: float, centre_offset: float, land_half_clearance: float = np.inf) -> float:
    """The largest lead A of the balls, m, for which there is a place of the cage that clears them all.

    half_clearance : nabla of the pocket;  centre_offset : D_p/2 - k;  land_half_clearance : all m
    A lead of A sin(phi) shifts the cage by A/2 and leaves each ball A/2 off the middle of its pocket, each in another
    direction. If a land stops the cage after land_half_clearance < A/2, the farthest ball is A - land_half_clearance
    off.
    """
    free = half_clearance - centre_offset
    return free + min(free, land_half_clearance)


def require_loose_balls(
    *, ball_lead: float, half_clearance: float, centre_offset: float, land_half_clearance: float = np.inf
) -> None:
    """Refuse balls that lead and lag so far that no place of the cage clears them all; arguments of `lead_room`."""
    largest = lead_room(
        half_clearance=half_clearance, centre_offset=centre_offset, land_half_clearance=land_half_clearance
    )
    if not abs(ball_lead) < largest:
        raise InputError(
            f"ball_lead {length_of(ball_lead)} is beyond the clearance: below {length_of(largest, '.6g')} the cage "
            "still goes between balls that lead on one side and lag on the other; give less, or a wider pocket"
        )


def whirl_number(
    *, ball_speed: ArrayLike, ball_radius: ArrayLike, half_clearance: ArrayLike, gravity: ArrayLike = STANDARD_GRAVITY
) -> Array:
    """(w_b r)^2/(g nabla): centrifugal over gravitational force of a cage that rolls in its pockets; all broadcast.

    ball_speed : w_b, rad/s, >= 0;  ball_radius : r, m, >= 0;  half_clearance : nabla, m, > 0;  gravity : g, m/s^2, >= 0
    Below 1 the cage cannot whirl and rests on its balls. Without gravity: infinite, or 0 where the balls stand still.
    """
    require_positive(half_clearance=half_clearance)
    require_non_negative(ball_speed=ball_speed, ball_radius=ball_radius, gravity=gravity)
    surface = np.asarray(ball_speed) * np.asarray(ball_radius)
    thrown, weight = np.broadcast_arrays(surface**2, np.asarray(gravity) * np.asarray(half_clearance))
    return np.divide(thrown, weight, out=np.where(thrown > 0, np.inf, 0.0), where=weight > 0)


@compiled
def hanging_torque(mu: float, weight: float, surface_rate: float, contact_angle: float) -> float:
    """T = mu m g r (w_b/w) (2/pi) E(sin^2 al)/sqrt(1 + mu^2), N m: a cage that hangs on its balls.

    mu : of ball on pocket;  weight : m g, across the axis, N;  surface_rate : r w_b/w, m;  contact_angle : al, rad
    The cage hangs off the vertical by atan(mu), where normal forces and friction together carry it. A ball at the angle
    phi from there slides with w_b r sqrt(1 - sin^2(al) sin^2(phi)); the mean is a complete elliptic integral.
    """
    square = np.cos(contact_angle) ** 2
    integral, share = elliptic_integrals(square)  # K(m) and D/K at m = sin^2 al; E = K - m D
    slip = surface_rate * 2 / np.pi * integral * (1 - np.sin(contact_angle) ** 2 * share)
    return mu * weight / np.sqrt(1 + mu**2) * slip


@compiled
def braking_torque(
    drag: float, mu: float, cage_rate: float, orbit_speed: float, ball_surface_speed: float, pitch_radius: float
) -> float:
    """T = c (w_c/w) (w_c + mu r w_b/r_m), N m: a cage that oil brakes and balls push.

    drag : c, torque over speed, N m s;  cage_rate : w_c/w;  orbit_speed : w_c, rad/s;  pitch_radius : r_m, m, > 0
    ball_surface_speed : r w_b, m/s; all >= 0
    The normal forces of the balls add up to c w_c/r_m, and the balls slide under them with w_b r. Added to
    `hanging_torque` this is an upper bound, as the same normal forces may both carry and push the cage.
    """
    return drag * cage_rate * (orbit_speed + mu * ball_surface_speed / pitch_radius)


class RestingCage(NamedTuple):
    """A cage that rests on its balls, in numbers."""

    mass: float  # kg
    gravity: float  # g along or across the axis, m/s^2
    lies_along: bool  # gravity is along the axis
    drag: float  # N m s
    room: float  # lead of the balls that the pockets leave free, m
    ball_count: int
    ball_radius: float  # m
    pitch_radius: float  # m


class DrivingBalls(NamedTuple):
    """How the balls drive a cage: means over balls and races."""

    orbit_rate: float  # w_c/w
    ball_rate: float  # w_b/w
    contact_angle: float  # al, rad


@compiled
def resting_load(cage: RestingCage) -> float:
    """Of each ball, N, > 0: without gravity a little of the weight, as a film needs a load."""
    return cage.mass * max(cage.gravity, LEAST_GRAVITY) / cage.ball_count


@compiled
def resting_torque(cage: RestingCage, balls: DrivingBalls, mu: float, ring_speed: float) -> tuple[float, float]:
    """Torque, N m, and sum of the normal forces, N, of a cage that rests on its balls; mu : of ball on pocket."""
    weight, surface_rate = cage.mass * cage.gravity, balls.ball_rate * cage.ball_radius
    orbit_speed, surface_speed = balls.orbit_rate * abs(ring_speed), surface_rate * abs(ring_speed)
    if cage.lies_along:  # the cage lies on its balls where their surfaces are slowest
        force, torque = weight, mu * weight * surface_rate * np.sin(balls.contact_angle)
    else:
        force = weight / np.sqrt(1 + mu**2)
        torque = hanging_torque(mu, weight, surface_rate, balls.contact_angle)
    braking = braking_torque(cage.drag, mu, balls.orbit_rate, orbit_speed, surface_speed, cage.pitch_radius)
    return torque + braking, force + cage.drag * orbit_speed / cage.pitch_radius


def whirl_speed(
    *, ball_speed: ArrayLike, ball_radius: ArrayLike, contact_angle: ArrayLike, half_clearance: ArrayLike
) -> Array:
    """Omega = w_b r cos(al)/nabla, rad/s, relative to the orbit: a cage that rolls on its balls; all broadcast.

    ball_speed : w_b, rad/s, of any sign;  ball_radius : r, m;  half_clearance : nabla, m, > 0
    contact_angle : al, rad, of a cage that cannot tilt. A cage that can tilt follows the leaning axes of its balls:
        give 0 for it (good to 2 % at 0.18 rad, see the tests)
    The cage is displaced by nabla and goes round so fast that it moves with the surfaces of the balls.
    """
    require_positive(half_clearance=half_clearance)
    surface = np.asarray(ball_speed) * np.asarray(ball_radius) * np.cos(contact_angle)
    return np.asarray(surface / np.asarray(half_clearance))


def whirl_force(*, cage_mass: ArrayLike, whirl: ArrayLike, orbit_speed: ArrayLike, half_clearance: ArrayLike) -> Array:
    """m (Omega + w_c)^2 nabla, N: sum of the normal forces that hold a whirling cage on its circle; all broadcast.

    cage_mass : m, kg;  whirl : Omega;  orbit_speed : w_c, both rad/s, of one sign;  half_clearance : nabla, m
    """
    turning = np.asarray(whirl) + np.asarray(orbit_speed)
    return np.asarray(np.asarray(cage_mass) * turning**2 * np.asarray(half_clearance))


def sliding_torque(
    *, friction_coefficient: ArrayLike, force: ArrayLike, ball_rate: ArrayLike, ball_radius: ArrayLike
) -> Array:
    """T = mu (sum N) r (w_b/w), N m: a cage that slides on its balls under the normal forces N; all broadcast.

    With the force of a whirling cage this is a bound on its torque: what it would lose if it slid instead of rolling.
    """
    slip = np.asarray(ball_rate) * np.asarray(ball_radius)
    return np.asarray(np.asarray(friction_coefficient) * np.asarray(force) * slip)
