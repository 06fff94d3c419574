"""The motion of the cage: six degrees of freedom, driven by balls whose motion is given.

Each ball acts on the cage by equations 13 to 17 of [Paper] (`analytic.cage.pocket`); equations 18 and 19 sum the
forces and the moments about the centre of the cage. Everything is in the fixed frame, z is the axis of the bearing, and
ball i starts at the azimuth 2 pi i/Z. `analytic.cage.kernel` integrates in compiled steps; it is compiled for the first
motion.
"""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from analytic.cage.pocket import impact_damping
from analytic.cage.steady import DrivenCage, whirl_speed
from analytic.errors import ConvergenceError, FembearingError, InputError, require_non_negative, require_positive
from analytic.scene import Array, Cage, CageStart

if TYPE_CHECKING:
    from analytic.cage.law import Law

LEAST_IMPACT = 1e-3  # m/s: a contact that begins to close more slowly is damped as if it had closed with this speed
DISTURBANCE = 1e-3  # of the half clearance and of the impact speed: by which seeds change the beginning of a motion
DEEPEST = 0.5  # of the ball radius: no elastic contact is so deep
RESTING_STEP = 1e-4  # s, the longest step: no impact limits the step of a cage at rest
SHARPEST = 1 / 400  # largest v0 of the friction over the speed of the ball surfaces; with more, slow balls would creep

# Parts of the kernel's state
PLACE, VELOCITY, ORIENTATION, MOMENTUM = slice(3), slice(3, 6), slice(6, 10), slice(10, 13)
TIME, ORBIT_ANGLE = 13, 14


class MotionError(ConvergenceError):
    """A motion that diverged; nothing of it is a result."""

    def __init__(self, *, time: float, place: Array, speed: float, step: float) -> None:
        self.time, self.place, self.speed, self.step = time, place, speed, step
        self.iterations, self.residual, self.tolerance = 0, np.inf, 0.0  # no iteration converged
        FembearingError.__init__(
            self,
            f"the cage's motion came apart at {time:.6g} s: centre at ({', '.join(f'{p:.3g}' for p in place)}) m, "
            f"speed {speed:.3g} m/s, with a step of {step:.3g} s. Raise cage.steps_per_contact, or check stiffness, "
            "mass and speed of the cage",
        )


@dataclass(frozen=True, kw_only=True)
class Passage:
    """A part of a motion: means over its time, and the largest force of one contact."""

    duration: float  # s
    slip_power: float  # of friction in the pockets, W
    land_power: float  # of friction at the land, W
    damping_power: float  # lost in impacts, W
    drag_power: float  # of the oil around the cage, W
    ball_power: float  # from the balls to the cage, W
    force: float  # sum of the normal forces in the pockets, N
    max_force: float  # largest normal force of one ball on one shell, N
    moment: float  # of the balls on the cage about z, N m
    circling: float  # angular speed of the cage centre about z, rad/s
    place: tuple[float, float]  # x and y of the cage centre, m
    distance: float  # of the cage centre from z, m
    place_deviation: float  # root mean square distance of the cage centre from its mean place, m
    distance_deviation: float  # root mean square deviation of the distance from z, m


def means(tally: Array, time: float) -> dict[str, Any]:
    """Fields of a Passage from the sums that both compiled loops begin with."""
    slip, land, damping, drag, balls, force, circling, distance, square, x, y = tally[1:12] / time
    return {
        "duration": time,
        "slip_power": slip,
        "land_power": land,
        "damping_power": damping,
        "drag_power": drag,
        "ball_power": balls,
        "force": force,
        "moment": tally[0] / time,
        "circling": circling,
        "place": (x, y),
        "distance": distance,
        "place_deviation": float(np.sqrt(max(square - x**2 - y**2, 0.0))),
        "distance_deviation": float(np.sqrt(max(square - distance**2, 0.0))),
    }


def cage_law(cage: DrivenCage, *, ramp: float) -> "Law":
    """Constants of the compiled loops; ramp : time in which all speeds rise, s, 0: full speed at once."""
    from analytic.cage.law import Law

    axial, transverse = cage.inertia
    land, surface = cage.land, abs(cage.ball_speed) * cage.ball_radius
    return Law(
        mass=cage.mass,
        axial_inertia=axial,
        transverse_inertia=transverse,
        pitch_radius=cage.pitch_radius,
        ball_radius=cage.ball_radius,
        half_clearance=cage.half_clearance,
        centre_offset=cage.centre_offset,
        axial_pockets=cage.pocket_axis == "axial",
        stiffness=cage.stiffness,
        damping=impact_damping(cage.restitution),
        least_impact=LEAST_IMPACT,
        friction=cage.friction_coefficient,
        smoothing=min(cage.smoothing, SHARPEST * surface) if surface > 0 else cage.smoothing,
        gravity_x=cage.gravity[0],
        gravity_y=cage.gravity[1],
        gravity_z=cage.gravity[2],
        drag=cage.drag,
        orbit_speed=cage.orbit_speed,
        # Against the orbit, about an axis that leans inward: the ball rolls on the outer race.
        spin_axial=-cage.ball_speed * np.cos(cage.contact_angle),
        spin_radial=cage.ball_speed * np.sin(cage.contact_angle),
        lead=cage.ball_lead / cage.pitch_radius,
        ramp=ramp,
        land_radius=0.0 if land is None else land.radius,
        land_half_clearance=0.0 if land is None else land.half_clearance,
        land_side=0.0 if land is None else (1.0 if land.outside else -1.0),
        land_speed=0.0 if land is None else land.speed,
        land_half_width=0.0 if land is None else land.half_width,
        deepest=DEEPEST * cage.ball_radius,
    )


class CageMotion:
    """A motion that `advance` continues.

    cage : what moves
    begin : `rest`: the cage hangs on its balls and turns with them. `ramp`: it hangs on its balls at standstill, and
        all speeds rise evenly over the time `ramp`. `sudden`: it is at standstill in the middle of its clearance, and
        the balls run at full speed. `whirl`: it rolls in its pockets
    seed : of a small disturbance of the beginning; None: undisturbed
    ramp : s;  steps_per_contact : steps in the shortest impact to expect, which set the accuracy in time
    """

    def __init__(
        self,
        cage: DrivenCage,
        *,
        begin: CageStart,
        seed: int | None = None,
        ramp: float = 0.0,
        steps_per_contact: float = Cage.steps_per_contact,
    ) -> None:
        from analytic.cage.kernel import STATE, TALLY, advance

        require_positive(steps_per_contact=steps_per_contact)
        require_non_negative(ramp=ramp)
        if begin not in ("rest", "ramp", "sudden", "whirl"):
            raise InputError(f'start must be "rest", "ramp", "sudden" or "whirl", got {begin!r}')
        if begin == "ramp" and not ramp > 0:
            raise InputError('start "ramp" needs the time over which the speeds rise, above 0')
        self.cage = cage
        self.step = min(cage.contact_time / steps_per_contact, RESTING_STEP)
        self._advance, self._sums = advance, TALLY
        self._law = cage_law(cage, ramp=ramp if begin == "ramp" else 0.0)
        azimuth = 2 * np.pi * np.arange(cage.ball_count) / cage.ball_count
        self._azimuth = np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)
        self._touch = np.zeros((cage.ball_count, 2))
        self._state = np.zeros(STATE)
        self._state[ORIENTATION] = [1.0, 0.0, 0.0, 0.0]
        self._place(begin)
        if seed is not None:
            random = np.random.default_rng(seed)
            self._state[PLACE] += DISTURBANCE * cage.half_clearance * random.uniform(-1, 1, 3)
            self._state[VELOCITY] += DISTURBANCE * cage.impact_speed * random.uniform(-1, 1, 3)

    def advance(self, duration: float) -> Passage:
        """Continue the motion for the duration, at least by one step.

        duration : s, > 0
        Raises MotionError if the motion diverges.
        """
        from analytic.cage.kernel import LARGEST

        tally, time = self._summed(duration)
        return Passage(max_force=tally[LARGEST], **means(tally, time))

    def forces(self) -> Array:
        """(Z, 3) N: the present force of each ball on the cage."""
        now = np.zeros((self.cage.ball_count, 3))
        self._go(np.zeros(self._sums), 0, now)
        return now

    @property
    def time(self) -> float:
        return float(self._state[TIME])

    @property
    def centre(self) -> Array:
        """(3,) m: from the centre of the bearing to that of the cage."""
        return self._state[PLACE].copy()

    @property
    def velocity(self) -> Array:
        """(3,) m/s: of the cage centre."""
        return self._state[VELOCITY].copy()

    @property
    def orientation(self) -> Array:
        """(3, 3): the columns are the axes of the cage in the fixed frame."""
        from scipy.spatial.transform import Rotation  # a tenth of a second to import

        return Rotation.from_quat(self._state[ORIENTATION], scalar_first=True).as_matrix()

    @property
    def angular_velocity(self) -> Array:
        """(3,) rad/s, in the fixed frame."""
        axial, transverse = self.cage.inertia
        axis, momentum = self.orientation[:, 2], self._state[MOMENTUM]
        return momentum / transverse + axis * (axis @ momentum) * (1 / axial - 1 / transverse)

    @property
    def ball_angle(self) -> float:
        """Angle through which the balls have orbited, rad."""
        return float(self._state[ORBIT_ANGLE])

    @property
    def offsets(self) -> Array:
        """(Z, 3) m: from the centre of each pocket to that of its ball, in the fixed frame."""
        pockets = self.centre + self.cage.pocket_places @ self.orientation.T
        return self.cage.ball_places(self.ball_angle) - pockets

    @property
    def kinetic_energy(self) -> float:
        """Of the cage, J."""
        turning = self._state[MOMENTUM] @ self.angular_velocity
        return float(self.cage.mass * self.velocity @ self.velocity + turning) / 2

    def launch(self, *, velocity: Array, angular_velocity: Array) -> None:
        """Give the cage another velocity, (3,) m/s, and angular velocity, (3,) rad/s."""
        axial, transverse = self.cage.inertia
        axis = self.orientation[:, 2]
        self._state[VELOCITY] = velocity
        about_axis = axis * (axis @ angular_velocity)
        self._state[MOMENTUM] = axial * about_axis + transverse * (np.asarray(angular_velocity) - about_axis)

    def _place(self, begin: CageStart) -> None:
        """Set the place and the velocities with which the motion begins."""
        from scipy.spatial.transform import Rotation

        cage, turning = self.cage, np.array([0.0, 0.0, self.cage.orbit_speed])
        pull = np.linalg.norm(cage.gravity)
        self._state[PLACE] = cage.middle
        if begin == "whirl":
            outward = np.array([1.0, 0.0, 0.0])
            distance = cage.free_path(outward)
            self._state[PLACE] += distance * outward
            circling = cage.orbit_speed + whirl_speed(
                ball_speed=cage.ball_speed,
                ball_radius=cage.ball_radius,
                contact_angle=cage.contact_angle,
                half_clearance=distance,
            )
            self.launch(velocity=np.array([0.0, circling * distance, 0.0]), angular_velocity=turning)
        elif begin != "sudden":
            if pull > 0:
                # Friction of the rotating balls holds the cage off the vertical; at standstill it swings from there.
                leaning = np.arctan(cage.friction_coefficient) * np.sign(cage.ball_speed)
                down = Rotation.from_rotvec([0.0, 0.0, leaning]).apply(np.array(cage.gravity) / pull)
                sag = (cage.mass * pull / cage.ball_count / cage.stiffness) ** (2 / 3)
                self._state[PLACE] += down * (cage.free_path(down) + sag)
            if begin == "rest":
                self.launch(velocity=np.zeros(3), angular_velocity=turning)

    def _summed(self, duration: float) -> tuple[Array, float]:
        """The sums of a duration, which becomes a number of steps, and its time, s."""
        require_positive(duration=duration)
        tally = np.zeros(self._sums)
        steps = max(1, round(duration / self.step))
        self._go(tally, steps, np.empty((0, 3)))
        return tally, steps * self.step

    def _go(self, tally: Array, steps: int, now: NDArray[np.float64]) -> None:
        done = self._advance(self._law, self._azimuth, self._state, self._touch, now, tally, self.step, steps)
        if done < steps or not np.all(np.isfinite(self._state)) or not np.all(np.isfinite(tally)):
            raise MotionError(
                time=self.time, place=self.centre, speed=float(np.linalg.norm(self.velocity)), step=self.step
            )
