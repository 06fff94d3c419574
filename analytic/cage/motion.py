"""The cage in motion: six freedoms, driven by balls whose motion is prescribed, in steps of a compiled loop.

Each ball acts by equations 13 to 17 (`analytic.cage.pocket`), and equations 18 and 19 sum their forces and moments about the
cage's centre. Everything is in the fixed frame, z the bearing's axis; ball i starts at the azimuth 2 pi i/Z.
`analytic.cage.kernel` holds the loop and is compiled on the first motion, not before.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.cage.pocket import impact_damping
from analytic.cage.steady import DrivenCage, whirl_speed
from analytic.errors import ConvergenceError, FembearingError, InputError, require_non_negative, require_positive
from analytic.scene import Array, CageStart

STEPS_PER_CONTACT = 40  # of the shortest impact to expect
LEAST_IMPACT = 1e-3  # m/s: a contact that begins slower is damped as if it had begun so fast
DISTURBANCE = 1e-3  # of the room and of the fastest impact: how far seeds set the beginnings apart
DEEPEST = 0.5  # of the ball's radius: no elastic contact goes so deep
RESTING_STEP = 1e-4  # s, where nothing moves that would set one
SHARPEST = 1 / 400  # of the speed of the balls' surfaces: v0 of the friction is at most so large, else slow balls creep


class MotionError(ConvergenceError):
    """A motion that came apart; nothing of it is a result."""

    def __init__(self, *, time: float, place: Array, speed: float, step: float) -> None:
        self.time, self.place, self.speed, self.step = time, place, speed, step
        self.iterations, self.residual, self.tolerance = 0, np.inf, 0.0  # no iteration, and nothing of it settled
        FembearingError.__init__(
            self,
            f"the cage's motion came apart at {time:.6g} s: centre at ({', '.join(f'{p:.3g}' for p in place)}) m, "
            f"speed {speed:.3g} m/s, with a step of {step:.3g} s. Raise cage.steps_per_contact, or check stiffness, "
            "mass and speed of the cage",
        )


@dataclass(frozen=True, kw_only=True)
class Passage:
    """What happened over a stretch of the motion: means over time, and one largest force."""

    duration: float  # s
    slip_power: float  # of friction in the pockets, W
    land_power: float  # of friction at the land, W
    damping_power: float  # of impacts, W
    drag_power: float  # of the oil around the cage, W
    ball_power: float  # that the balls give to the cage, W
    force: float  # sum of the normal forces in the pockets, N
    max_force: float  # the largest of one ball on a shell, N
    moment: float  # of the balls on the cage about z, N m
    circling: float  # speed at which the centre goes round the bearing's axis, rad/s
    place: tuple[float, float]  # of the centre, x and y, m
    distance: float  # of the centre from the axis, m
    unrest: float  # root mean square of the centre's place about its mean, m
    wobble: float  # root mean square of its distance from the axis about the mean, m


class CageMotion:
    """A motion that goes on when asked.

    cage : what moves
    begin : `rest`: the cage hangs on its balls and turns with them; `ramp`: the same at standstill, and all speeds rise
        evenly over the time `ramp`; `sudden`: it hovers at standstill while the balls run at full speed; `whirl`: it
        rolls round in its pockets
    seed : of a small disturbance of the beginning; None: undisturbed
    steps_per_contact : of the shortest impact to expect: the knob for accuracy
    """

    def __init__(
        self,
        cage: DrivenCage,
        *,
        begin: CageStart,
        seed: int | None = None,
        ramp: float = 0.0,
        steps_per_contact: float = STEPS_PER_CONTACT,
    ) -> None:
        from analytic.cage.kernel import STATE, Law, advance

        require_positive(steps_per_contact=steps_per_contact)
        require_non_negative(ramp=ramp)
        if begin not in ("rest", "ramp", "sudden", "whirl"):
            raise InputError(f'start must be "rest", "ramp", "sudden" or "whirl", got {begin!r}')
        if begin == "ramp" and not ramp > 0:
            raise InputError('start "ramp" needs the time over which the speeds rise, above 0')
        self.cage = cage
        self.step = min(cage.contact_time / steps_per_contact, RESTING_STEP)
        axial, transverse = cage.inertia
        land, surface = cage.land, abs(cage.ball_speed) * cage.ball_radius
        self._advance = advance
        self._law = Law(
            mass=cage.mass,
            axial_inertia=axial,
            transverse_inertia=transverse,
            pitch_radius=cage.pitch_radius,
            ball_radius=cage.ball_radius,
            room=cage.room,
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
            # The ball rolls against the outer race: backwards, about an axis that leans inward.
            spin_axial=-cage.ball_speed * np.cos(cage.contact_angle),
            spin_radial=cage.ball_speed * np.sin(cage.contact_angle),
            lead=cage.ball_lead / cage.pitch_radius,
            ramp=ramp if begin == "ramp" else 0.0,
            land_radius=0.0 if land is None else land.radius,
            land_room=0.0 if land is None else land.room,
            land_side=0.0 if land is None else (1.0 if land.outside else -1.0),
            land_speed=0.0 if land is None else land.speed,
            land_half_width=0.0 if land is None else land.half_width,
            deepest=DEEPEST * cage.ball_radius,
        )
        azimuth = 2 * np.pi * np.arange(cage.ball_count) / cage.ball_count
        self._azimuth = np.stack([np.cos(azimuth), np.sin(azimuth)], axis=1)
        self._touch = np.zeros((cage.ball_count, 2))
        self._state = np.zeros(STATE)
        self._state[6] = 1.0
        self._place(begin)
        if seed is not None:
            random = np.random.default_rng(seed)
            self._state[:3] += DISTURBANCE * cage.room * random.uniform(-1, 1, 3)
            self._state[3:6] += DISTURBANCE * cage.fastest * random.uniform(-1, 1, 3)

    def advance(self, duration: float) -> Passage:
        """Go on for so long, at least one step, and tell what happened.

        duration : s, > 0
        Raises MotionError where it comes apart.
        """
        from analytic.cage.kernel import LARGEST, TALLY

        require_positive(duration=duration)
        tally = np.zeros(TALLY)
        steps = max(1, round(duration / self.step))
        self._go(tally, steps, np.empty((0, 3)))
        time = steps * self.step
        moment, slip, rubbed, damped, dragged, given, force, wound, far, square, x, y = tally[:LARGEST] / time
        return Passage(
            duration=time,
            slip_power=slip,
            land_power=rubbed,
            damping_power=damped,
            drag_power=dragged,
            ball_power=given,
            force=force,
            max_force=tally[LARGEST],
            moment=moment,
            circling=wound,
            place=(x, y),
            distance=far,
            unrest=float(np.sqrt(max(square - x**2 - y**2, 0.0))),
            wobble=float(np.sqrt(max(square - far**2, 0.0))),
        )

    def forces(self) -> Array:
        """(Z, 3) N: of each ball on the cage, now."""
        from analytic.cage.kernel import TALLY

        now = np.zeros((self.cage.ball_count, 3))
        self._go(np.zeros(TALLY), 0, now)
        return now

    @property
    def time(self) -> float:
        return float(self._state[13])

    @property
    def centre(self) -> Array:
        """(3,) m: of the cage, from the bearing's."""
        return self._state[:3].copy()

    @property
    def velocity(self) -> Array:
        """(3,) m/s."""
        return self._state[3:6].copy()

    @property
    def orientation(self) -> Array:
        """(3, 3): columns are the cage's own axes in the fixed frame."""
        from scipy.spatial.transform import Rotation  # a tenth of a second to import

        return Rotation.from_quat(self._state[6:10], scalar_first=True).as_matrix()

    @property
    def angular_velocity(self) -> Array:
        """(3,) rad/s, in the fixed frame."""
        axial, transverse = self.cage.inertia
        axis, momentum = self.orientation[:, 2], self._state[10:13]
        return momentum / transverse + axis * (axis @ momentum) * (1 / axial - 1 / transverse)

    @property
    def ball_angle(self) -> float:
        """rad: how far the balls have gone round."""
        return float(self._state[14])

    @property
    def offsets(self) -> Array:
        """(Z, 3) m: of each ball's centre from its pocket's, in the fixed frame."""
        pockets = self.centre + self.cage.pocket_places @ self.orientation.T
        return self.cage.ball_places(self.ball_angle) - pockets

    @property
    def kinetic_energy(self) -> float:
        """J."""
        turning = self._state[10:13] @ self.angular_velocity
        return float(self.cage.mass * self.velocity @ self.velocity + turning) / 2

    def launch(self, *, velocity: Array, angular_velocity: Array) -> None:
        """Give the cage another velocity, (3,) m/s, and angular velocity, (3,) rad/s."""
        axial, transverse = self.cage.inertia
        axis = self.orientation[:, 2]
        self._state[3:6] = velocity
        about_axis = axis * (axis @ angular_velocity)
        self._state[10:13] = axial * about_axis + transverse * (np.asarray(angular_velocity) - about_axis)

    def _place(self, begin: CageStart) -> None:
        from scipy.spatial.transform import Rotation

        cage, turning = self.cage, np.array([0.0, 0.0, self.cage.orbit_speed])
        pull = np.linalg.norm(cage.gravity)
        self._state[:3] = cage.middle
        if begin == "whirl":
            outward = np.array([1.0, 0.0, 0.0])
            distance = cage.free_way(outward)
            self._state[:3] += distance * outward
            circling = cage.orbit_speed + whirl_speed(
                ball_speed=cage.ball_speed,
                ball_radius=cage.ball_radius,
                contact_angle=cage.contact_angle,
                room=distance,
            )
            self.launch(velocity=np.array([0.0, circling * distance, 0.0]), angular_velocity=turning)
        elif begin != "sudden":
            if pull > 0:
                # Friction of the turning balls holds it off the vertical; at standstill it swings from there.
                leaning = np.arctan(cage.friction_coefficient) * np.sign(cage.ball_speed)
                down = Rotation.from_rotvec([0.0, 0.0, leaning]).apply(np.array(cage.gravity) / pull)
                sag = (cage.mass * pull / cage.ball_count / cage.stiffness) ** (2 / 3)
                self._state[:3] += down * (cage.free_way(down) + sag)
            if begin == "rest":
                self.launch(velocity=np.zeros(3), angular_velocity=turning)

    def _go(self, tally: Array, steps: int, now: NDArray[np.float64]) -> None:
        done = self._advance(self._law, self._azimuth, self._state, self._touch, now, tally, self.step, steps)
        if done < steps or not np.all(np.isfinite(self._state)) or not np.all(np.isfinite(tally)):
            raise MotionError(
                time=self.time, place=self.centre, speed=float(np.linalg.norm(self.velocity)), step=self.step
            )
