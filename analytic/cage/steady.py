"""A cage driven by its balls: what moves and rubs, and the two steady motions that have closed forms.

z is the axis of the bearing. The balls' motion is prescribed: on the pitch circle with the speed of the orbit, each
turning about an axis at the contact angle to z. The cage is rigid, a thin ring through the pockets' middles.
At rest it hangs on its balls with its weight and slides on all of them. Whirling it is thrown outward against all of
them at once, and rolls round in its pockets like a ring on a peg. Both are stable over a wide range: how the motion
began decides (`analytic.cage.motion`). Torques are the power of sliding over the speed of the ring: the moment of the
balls on the cage about its axis averages to nothing in any steady motion that nothing else brakes.
Source: derived here.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import ellipe

from analytic.cage.pocket import impact
from analytic.effects.bounds import STANDARD_GRAVITY
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.scene import Array, PocketAxis


@dataclass(frozen=True, kw_only=True)
class LandGuidance:
    """A ring whose land the cage's rims touch before the pockets do: the contact is as stiff as a pocket's."""

    radius: float  # of the land, m
    room: float  # half of the diametral clearance, m
    outside: bool  # the outer ring's land; else the inner ring's, in the bore of the cage
    speed: float  # of that ring, rad/s
    half_width: float  # from the middle of the cage to each of its rims, m

    def __post_init__(self) -> None:
        require_positive(**{"land.radius": self.radius, "land.room": self.room, "land.half_width": self.half_width})
        require_finite(**{"land.speed": self.speed})


@dataclass(frozen=True, kw_only=True)
class DrivenCage:
    """A cage and the balls that drive it, at one operating point."""

    mass: float  # kg
    ball_count: int  # Z
    ball_radius: float  # r, m
    pitch_radius: float  # r_m, m
    room: float  # nabla, half of the pocket's clearance, m
    centre_offset: float = 0.0  # D_p/2 - k, m
    pocket_axis: PocketAxis = "axial"  # x of `analytic.cage.pocket`, the line through the centres of both shells
    stiffness: float  # K_pb, N/m^1.5
    restitution: float  # e, of an impact
    friction_coefficient: float  # mu, of ball on pocket
    orbit_speed: float  # w_c, of the balls about the bearing's axis, rad/s
    ball_speed: float  # w_b, of each ball about its own axis relative to the orbit, with the sign of w, rad/s
    contact_angle: float  # al: the ball's axis leans so far from the bearing's, rad
    ring_speed: float  # w, rad/s
    gravity: tuple[float, float, float] = (0.0, -STANDARD_GRAVITY, 0.0)  # m/s^2
    drag: float = 0.0  # torque over speed with which the oil brakes the cage, N m s
    ball_lead: float = 0.0  # how far balls lead on one side of the bearing and lag on the other, m
    land: LandGuidance | None = None
    smoothing: float = 1e-3  # v0 of the friction's direction, m/s; less where the balls turn slowly
    axial_inertia: float | None = None  # about z, kg m^2; None: of a thin ring of the pitch radius
    transverse_inertia: float | None = None  # likewise, across z

    def __post_init__(self) -> None:
        require_positive(
            mass=self.mass,
            ball_radius=self.ball_radius,
            pitch_radius=self.pitch_radius,
            room=self.room,
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
            centre_offset=self.centre_offset, friction_coefficient=self.friction_coefficient, drag=self.drag
        )
        require_finite(
            orbit_speed=self.orbit_speed,
            ball_speed=self.ball_speed,
            contact_angle=self.contact_angle,
            ring_speed=self.ring_speed,
            gravity=self.gravity,
            ball_lead=self.ball_lead,
        )
        if not self.centre_offset < self.room:
            raise InputError(
                f"centre_offset {self.centre_offset!r} m must be below room {self.room!r} m: the shells clamp the ball"
            )
        require_loose_balls(
            ball_lead=self.ball_lead,
            room=self.room,
            centre_offset=self.centre_offset,
            land_room=np.inf if self.land is None else self.land.room,
        )

    @property
    def inertia(self) -> tuple[float, float]:
        """About the axis and across it, kg m^2: m r_m^2 and m r_m^2/2 where none are given."""
        ring = self.mass * self.pitch_radius**2
        axial, transverse = self.axial_inertia, self.transverse_inertia
        return ring if axial is None else axial, ring / 2 if transverse is None else transverse

    @property
    def fastest(self) -> float:
        """Speed of the fastest impacts to expect, m/s: of the ball's surface, or of a fall through the pocket."""
        fall = np.sqrt(4 * np.linalg.norm(self.gravity) * self.room)
        return float(max(abs(self.ball_speed) * self.ball_radius, fall))

    @property
    def middle(self) -> Array:
        """(3,) m: from where balls that lead and lag are all equally far, or as near to it as a land lets the cage."""
        aside = self.ball_lead / 2
        if self.land is not None:
            aside = float(np.clip(aside, -self.land.room, self.land.room))
        return np.array([-aside, 0.0, 0.0])

    @property
    def pocket_places(self) -> Array:
        """(Z, 3) m: of the pockets' middles in the cage's own frame."""
        azimuth = 2 * np.pi * np.arange(self.ball_count) / self.ball_count
        return self.pitch_radius * np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth], axis=1)

    def ball_places(self, angle: float) -> Array:
        """(Z, 3) m: of the balls' centres in the fixed frame; angle : how far they have gone round, rad."""
        azimuth = angle + 2 * np.pi * np.arange(self.ball_count) / self.ball_count
        azimuth += self.ball_lead / self.pitch_radius * np.sin(azimuth)
        return self.pitch_radius * np.stack([np.cos(azimuth), np.sin(azimuth), 0 * azimuth], axis=1)

    def free_way(self, direction: Array) -> float:
        """How far the cage, level, goes from the middle of its room before a ball stops it, or the land, m.

        direction : (3,), of length 1;  the balls are where a motion begins, at the azimuths 2 pi i/Z
        """
        pockets = self.pocket_places
        axes = np.broadcast_to([0.0, 0.0, 1.0], pockets.shape)
        if self.pocket_axis == "radial":
            axes = pockets / self.pitch_radius
        offset = self.ball_places(0.0) - pockets - self.middle
        offsets = np.concatenate([offset + side * self.centre_offset * axes for side in (1, -1)])
        ahead = offsets @ direction
        way = np.min(ahead + np.sqrt(ahead**2 + self.room**2 - np.sum(offsets**2, axis=1)))
        sideways = np.hypot(*direction[:2])
        if self.land is not None and sideways > 0:
            outward = self.middle @ direction / sideways
            reach = np.sqrt(outward**2 + self.land.room**2 - self.middle @ self.middle) - outward
            way = min(way, reach / sideways)
        return float(way)

    @property
    def crossing_time(self) -> float:
        """s, in which the cage once falls through its pockets, or without gravity is carried through by the balls."""
        pull, surface = np.linalg.norm(self.gravity), abs(self.ball_speed) * self.ball_radius
        if pull > 0:
            return float(np.sqrt(4 * self.room / pull))
        return 2 * self.room / surface if surface > 0 else 0.0

    @property
    def contact_time(self) -> float:
        """s, of the shortest impact to expect: the fastest, on all balls at once; infinite where nothing moves."""
        if not self.fastest > 0:
            return np.inf
        mass = self.mass / max(self.ball_count, 3)  # a single ball far from the centre meets a third of the mass
        return float(impact(mass=mass, speed=self.fastest, stiffness=self.stiffness).duration)


def require_loose_balls(*, ball_lead: float, room: float, centre_offset: float, land_room: float = np.inf) -> None:
    """Refuse balls that lead and lag so far that no place of the cage clears them all.

    A lead of A sin(phi) takes the cage half along and leaves each ball A/2 off its pocket's middle, in all directions.
    Where a land holds the cage after a way of land_room < A/2, m, the farthest ball is A - land_room off.
    """
    free = room - centre_offset
    largest = free + min(free, land_room)
    if not abs(ball_lead) < largest:
        raise InputError(
            f"ball_lead {ball_lead!r} m is beyond the clearance: below {largest:.6g} m the cage still goes between "
            "balls that lead on one side and lag on the other; give less, or a wider pocket"
        )


def rest_torque(
    *,
    friction_coefficient: ArrayLike,
    cage_mass: ArrayLike,
    ball_rate: ArrayLike,
    ball_radius: ArrayLike,
    contact_angle: ArrayLike,
    gravity: ArrayLike = STANDARD_GRAVITY,
) -> Array:
    """T = mu m g r (w_b/w) (2/pi) E(sin^2 al)/sqrt(1 + mu^2), N m: a cage that hangs on its balls; all broadcast.

    friction_coefficient : mu;  cage_mass : m, kg;  ball_rate : w_b/w;  ball_radius : r, m;  contact_angle : al, rad
    gravity : g, across the axis, m/s^2; all >= 0
    It hangs off the vertical by atan(mu), where normal forces and friction together carry it; the ball phi round from
    there slides with w_b r sqrt(1 - sin^2(al) sin^2(phi)), whose mean is a complete elliptic integral.
    """
    require_non_negative(
        friction_coefficient=friction_coefficient,
        cage_mass=cage_mass,
        ball_rate=ball_rate,
        ball_radius=ball_radius,
        contact_angle=contact_angle,
        gravity=gravity,
    )
    mu = np.asarray(friction_coefficient)
    force = np.asarray(cage_mass) * np.asarray(gravity) / np.sqrt(1 + mu**2)
    slip = np.asarray(ball_rate) * np.asarray(ball_radius) * 2 / np.pi * ellipe(np.sin(contact_angle) ** 2)
    return np.asarray(mu * force * slip)


def braked_torque(
    *,
    drag: ArrayLike,
    friction_coefficient: ArrayLike,
    cage_rate: ArrayLike,
    orbit_speed: ArrayLike,
    pitch_radius: ArrayLike,
    ball_speed: ArrayLike,
    ball_radius: ArrayLike,
) -> Array:
    """T = c (w_c/w) (w_c + mu r w_b/r_m), N m: a cage that oil brakes, and balls that push it on; all broadcast.

    drag : c, torque over speed, N m s;  friction_coefficient : mu;  cage_rate : w_c/w;  orbit_speed : w_c, rad/s
    pitch_radius : r_m, m, > 0;  ball_speed : w_b, rad/s;  ball_radius : r, m; all >= 0
    The balls press with c w_c/r_m together and slide on that with w_b r. Beside `rest_torque` it is at most so much:
    the same normal forces then carry and push.
    """
    require_positive(pitch_radius=pitch_radius)
    require_non_negative(
        drag=drag,
        friction_coefficient=friction_coefficient,
        cage_rate=cage_rate,
        orbit_speed=orbit_speed,
        ball_speed=ball_speed,
        ball_radius=ball_radius,
    )
    surface = np.asarray(ball_speed) * np.asarray(ball_radius)
    slip = np.asarray(friction_coefficient) * surface / np.asarray(pitch_radius)
    return np.asarray(np.asarray(drag) * np.asarray(cage_rate) * (np.asarray(orbit_speed) + slip))


def whirl_speed(*, ball_speed: ArrayLike, ball_radius: ArrayLike, contact_angle: ArrayLike, room: ArrayLike) -> Array:
    """Omega = w_b r cos(al)/nabla, rad/s, relative to the orbit: a cage that rolls on its balls; all broadcast.

    ball_speed : w_b, rad/s, of any sign;  ball_radius : r, m;  room : nabla, m, > 0
    contact_angle : al of a cage that cannot tilt, rad; one that is free to follows the balls' leaning axes, as if at 0
        (to 2 % at 0.18 rad, see the tests)
    The displacement nabla of the cage goes round so fast that its speed is that of the balls' surfaces.
    """
    require_positive(room=room)
    return np.asarray(np.asarray(ball_speed) * np.asarray(ball_radius) * np.cos(contact_angle) / np.asarray(room))


def whirl_force(*, cage_mass: ArrayLike, whirl: ArrayLike, orbit_speed: ArrayLike, room: ArrayLike) -> Array:
    """Sum of the normal forces m (Omega + w_c)^2 nabla, N: what holds the whirling cage on its circle; all broadcast.

    cage_mass : m, kg;  whirl : Omega;  orbit_speed : w_c, rad/s, with one sign;  room : nabla, m
    """
    return np.asarray(np.asarray(cage_mass) * (np.asarray(whirl) + np.asarray(orbit_speed)) ** 2 * np.asarray(room))


def whirl_torque(
    *,
    friction_coefficient: ArrayLike,
    force: ArrayLike,
    ball_rate: ArrayLike,
    ball_radius: ArrayLike,
    contact_angle: ArrayLike,
) -> Array:
    """T = (2/pi) mu (sum N) r sin(al) (w_b/w), N m: a whirling cage that cannot tilt; all broadcast.

    friction_coefficient : mu;  force : sum N, N;  ball_rate : w_b/w;  ball_radius : r, m;  contact_angle : al, rad
    What rolls in the plane slides along the axis, by the part of each ball's turning that leans out of it. A cage free
    to tilt follows that, and loses far less: an upper bound.
    """
    slip = np.asarray(ball_rate) * np.asarray(ball_radius) * np.sin(contact_angle)
    return np.asarray(2 / np.pi * np.asarray(friction_coefficient) * np.asarray(force) * slip)


def whirl_bound(
    *, friction_coefficient: ArrayLike, force: ArrayLike, ball_rate: ArrayLike, ball_radius: ArrayLike
) -> Array:
    """mu (sum N) r (w_b/w), N m: a cage thrown outward as if it whirled, that slides on its balls instead."""
    slip = np.asarray(ball_rate) * np.asarray(ball_radius)
    return np.asarray(np.asarray(friction_coefficient) * np.asarray(force) * slip)
