"""The rolling of a ball that is off a race, or off both, in the oil of its clearance."""

from analytic.loads.ball_balance import Grooves, gap_to_race
from analytic.loads.kinematics import ruled_motion
from analytic.loads.ring_rounds import RingNumbers
from analytic.loads.thrust_ball import in_groove
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record
from analytic.oil.race_resistance import RaceResistance, ResistedContact, gap_off_race, torque_off_race
from analytic.oil.viscosity import OilNumbers


@compiled
def clearance_of(grooves: Grooves, ball: Record) -> float:
    """Clearance of a ball that is off a race, or off both: between them and the ball, m."""
    arms = (ball.inner_arm[0], ball.inner_arm[1]), (ball.outer_arm[0], ball.outer_arm[1])
    loads = ball.load[0], ball.load[1]
    far = 0 if loads[1] > 0.0 else 1
    to_far = gap_to_race(grooves, arms[0], arms[1], loads, far)
    return to_far if loads[1 - far] > 0.0 else 2 * to_far


@compiled
def more_in_clearance(
    ring: RingNumbers,
    resistance: RaceResistance,
    oil: OilNumbers,
    speed: float,
    ball: Record,
    resisted: tuple[ResistedContact, ResistedContact],
) -> float:
    """Torque by rolling of a ball with clearance, N m, beyond that of its load; the cage pushes it.

    speed : of the inner ring, rad/s;  resisted : the contacts with both races
    A ball without load lies in the middle of its clearance and turns as if loaded. One that its own force presses
    lightly on a race floats on its oil, at most up to the middle: that race resists as at this gap at least, and the
    other one at the rest of the clearance.
    """
    motion = ruled_motion(ring.bearing, 1.0, in_groove(ball.angle[0]), in_groove(ball.angle[1]))
    entrainment = motion.inner_entrainment, motion.outer_entrainment
    near = 1 if ball.load[1] > 0.0 else 0  # race that is pressed, if one is
    far, clearance, own = 1 - near, clearance_of(ring.grooves, ball), resisted[near].rolling_torque
    gap = gap_off_race(resistance, oil, near, resisted[near].contact, entrainment[near], own, speed)
    gap = min(gap, clearance / 2)
    floating = torque_off_race(resistance, oil, near, resisted[near].contact, entrainment[near], gap, speed)
    other = torque_off_race(resistance, oil, far, resisted[far].contact, entrainment[far], clearance - gap, speed)
    return max(floating - own, 0.0) + other
