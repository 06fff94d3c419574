"""The motion of balls and cage together: the cage has six freedoms, each ball four.

A ball has a speed along its orbit and a rotation about three axes. The tractions of both races (`analytic.cage.races`),
the gyroscopic moment and the push and friction of its pocket change them. So a cage can press a ball no harder than the
races hold it, but for impacts, which the inertia of the ball carries. Balls that run at different speeds over a turn
lead and lag by themselves.
Left out: weight and oil drag of the balls, motion of the rings, the ball's inertia across its races, and what the orbit
speed changes in the centrifugal force. `analytic.cage.free_kernel` integrates in compiled steps.
"""

from dataclasses import dataclass, replace

import numpy as np

from analytic.cage.motion import MOMENTUM, RESTING_STEP, CageMotion, MotionError, Passage, cage_law, means
from analytic.cage.pocket import impact
from analytic.cage.races import Races
from analytic.cage.steady import DrivenCage, lead_room
from analytic.errors import InputError, SingularError
from analytic.scene import Array, Cage, CageStart

LEAST_STEPS = 10  # in an impact: fewer do not follow its force
LEAST_STEPS_SEEN = 5  # in the hardest impact that came, which may be harder than the one expected
NARROW = 0.9  # of the room that balls may lead and lag by at the beginning: the cage still moves between them


@dataclass(frozen=True, kw_only=True)
class FreePassage(Passage):
    """A part of a motion of balls and cage; ball_power and ring_power less all losses become kinetic energy."""

    ring_power: float  # from the inner ring to the balls, W
    race_power: float  # of slip in the contacts with both races, W
    alone_power: float  # the same of these balls without a cage, at full speed, W
    numerical_power: float  # lost by the implicit steps of the balls, W
    tilt: float  # root mean square angle between the axes of cage and bearing, rad
    grip: float  # largest traction along the orbit over its limit, of one ball on one race


class FreeCageMotion(CageMotion):
    """A motion of balls and cage that `advance` continues.

    cage : what moves; its `orbit_speed` and `ball_lead` follow from the races
    begin, seed, ramp, steps_per_contact : as for CageMotion. But for `ramp` the balls begin as they run without a cage
    Raises InputError for a cage and races of different speed, for a given lead of the balls, and for fewer than
    LEAST_STEPS steps per contact; SingularError if a ball alone on its races does not settle.
    """

    def __init__(
        self,
        cage: DrivenCage,
        races: Races,
        *,
        begin: CageStart,
        seed: int | None = None,
        ramp: float = 0.0,
        steps_per_contact: float = Cage.steps_per_contact,
    ) -> None:
        from analytic.cage.free_kernel import BALL, TALLY, advance
        from analytic.cage.race_law import ALONE

        if not np.isclose(cage.ring_speed, races.inner_speed, rtol=1e-9):
            raise InputError(
                f"the cage belongs to a ring at {cage.ring_speed!r} rad/s and the races to one at "
                f"{races.inner_speed!r} rad/s: take both at one operating point"
            )
        if cage.ball_lead != 0:
            raise InputError(
                f"ball_lead = {cage.ball_lead!r} m says where the balls run, and free balls lead and lag by what their "
                "races do: give 0"
            )
        if steps_per_contact < LEAST_STEPS:
            raise InputError(
                f"steps_per_contact = {steps_per_contact!r} is too coarse for the stiffness of the pocket: free balls "
                f"need {LEAST_STEPS} or more, {Cage.steps_per_contact} are usual"
            )
        self.races, alone = races, races.alone
        cage = replace(cage, orbit_speed=alone.orbit_speed)
        # Half the clearance is the cage's to give way, so balls that lead by more than a whole one start with that.
        room = lead_room(
            half_clearance=cage.half_clearance,
            centre_offset=cage.centre_offset,
            land_half_clearance=np.inf if cage.land is None else cage.land.half_clearance,
        )
        lead = float(np.clip(alone.lead, -NARROW * room, NARROW * room))
        super().__init__(
            replace(cage, ball_lead=lead), begin=begin, seed=seed, ramp=ramp, steps_per_contact=steps_per_contact
        )
        self.cage = cage
        self.step = min(self._contact_time / steps_per_contact, RESTING_STEP)
        self._advance, self._sums = advance, TALLY
        self._laws = (cage_law(cage, ramp=ramp if begin == "ramp" else 0.0), races.law())
        self._table = races.table.copy()
        self._table[:, 0, ALONE] = alone.slip_power
        self._balls = np.zeros((cage.ball_count, BALL))
        places = replace(cage, ball_lead=lead).ball_places(0.0)
        angle = np.arctan2(places[:, 1], places[:, 0]) % (2 * np.pi)
        self._balls[:, 0], self._first = angle, angle
        if begin != "ramp":
            grid = 2 * np.pi * np.arange(len(alone.speeds)) / len(alone.speeds)
            for speed in range(4):
                self._balls[:, 1 + speed] = np.interp(angle, grid, alone.speeds[:, speed], period=2 * np.pi)

    def advance(self, duration: float) -> FreePassage:
        """Continue the motion for the duration, at least by one step.

        duration : s, > 0
        Raises MotionError if the motion diverges, InputError if an impact was too hard for the steps, and
        SingularError if the speeds of a ball did not settle in a step.
        """
        from analytic.cage.free_kernel import GRIP, LARGEST, UNSETTLED

        tally, time = self._summed(duration)
        if tally[UNSETTLED]:
            raise SingularError(
                problem=f"the speeds of balls between races and cage did not settle {tally[UNSETTLED]:.0f} times in "
                f"{time:.3g} s",
                remedy="Raise cage.steps_per_contact, or the friction of the races",
            )
        self._require_fine_steps(float(tally[LARGEST]))
        ring, race, alone, numerical, tilt = tally[12:17] / time
        return FreePassage(
            max_force=tally[LARGEST],
            ring_power=ring,
            race_power=race,
            alone_power=alone,
            numerical_power=numerical,
            tilt=float(np.sqrt(tilt)),
            grip=tally[GRIP],
            **means(tally, time),
        )

    @property
    def ball_angle(self) -> float:
        """Mean angle through which the balls have orbited, rad."""
        return float(np.mean(self._balls[:, 0] - self._first))

    @property
    def ball_angles(self) -> Array:
        """(Z,) rad: azimuths of the balls, which go on growing."""
        return self._balls[:, 0].copy()

    @property
    def ball_speeds(self) -> Array:
        """(Z, 4) m/s: r_m w_c, r w_phi, r w_rho and r w_z, the rotation absolute, in directions that turn with w_c."""
        return self._balls[:, 1:5].copy()

    @property
    def offsets(self) -> Array:
        """(Z, 3) m: from the centre of each pocket to that of its ball, in the fixed frame."""
        angle = self._balls[:, 0]
        places = self.cage.pitch_radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
        return places - (self.centre + self.cage.pocket_places @ self.orientation.T)

    @property
    def kinetic_energy(self) -> float:
        """Of balls and cage, J."""
        squares = np.sum(self._balls[:, 1:5] ** 2, axis=0)
        return super().kinetic_energy + self.races.bearing.ball_mass / 2 * float(squares @ [1.0, 0.4, 0.4, 0.4])

    @property
    def axial_momentum(self) -> float:
        """Angular momentum of balls and cage about the axis of the bearing, N m s."""
        cage, bearing = self.cage, self.races.bearing
        (x, y, _), (vx, vy, _) = self.centre, self.velocity
        along, turning = self._balls[:, 1].sum(), 0.4 * self._balls[:, 4].sum()
        of_balls = bearing.ball_mass * (cage.pitch_radius * along + cage.ball_radius * turning)
        return float(of_balls + cage.mass * (x * vy - y * vx) + self._state[MOMENTUM][2])

    @property
    def _contact_time(self) -> float:
        """Duration of the shortest impact to expect: as for a ball that cannot give way, but it can, s."""
        cage = self.cage
        if not cage.impact_speed > 0:
            return np.inf
        return float(impact(mass=self._mass, speed=cage.impact_speed, stiffness=cage.stiffness).duration)

    @property
    def _mass(self) -> float:
        """Of an impact between the cage and a ball, kg."""
        return 1 / (max(self.cage.ball_count, 3) / self.cage.mass + 1 / self.races.bearing.ball_mass)

    def _require_fine_steps(self, force: float) -> None:
        """Raise InputError if the hardest impact, with this force, N, had too few steps."""
        stiffness = 1.5 * np.cbrt(self.cage.stiffness**2 * max(force, 1e-300))
        steps = float(np.pi * np.sqrt(self._mass / stiffness)) / self.step
        if steps < LEAST_STEPS_SEEN:
            raise InputError(
                f"an impact of {force:.3g} N had {steps:.2g} steps: the stiffness of the pocket needs "
                f"{LEAST_STEPS_SEEN} or more; raise cage.steps_per_contact {LEAST_STEPS_SEEN / steps:.2g} times"
            )

    def _go(self, tally: Array, steps: int, now: Array) -> None:
        done = self._advance(
            self._laws,
            self._azimuth,
            self._table,
            self._state,
            self._balls,
            self._touch,
            now,
            tally,
            self.step,
            steps,
        )
        if done < steps or not np.all(np.isfinite(self._state)) or not np.all(np.isfinite(tally)):
            raise MotionError(
                time=self.time, place=self.centre, speed=float(np.linalg.norm(self.velocity)), step=self.step
            )
