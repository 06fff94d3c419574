"""Hard cases of the cage: a ball in its pocket, impacts, and the motion of the cage."""

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.cage.motion import CAGE, CageMotion
from analytic.cage.pocket import BallInPocket, Body, impact, impact_damping, pocket_shape, rubbing
from analytic.cage.pocket import pushed as pushed_by
from analytic.cage.statistics import measured_motion
from analytic.cage.steady import STANDARD_GRAVITY, DrivenCage, hanging_torque
from analytic.numerics.records import Record, as_record
from analytic.scene import Array

BALL, CLEARANCE, STIFFNESS = 7.94e-3, 0.1e-3, 6e10  # m, m, N/m^1.5
POCKET = BALL + 2 * CLEARANCE  # m
OFF_AXIS = 0.13e-3  # m, of a ball off its pocket's axis: 0.03 mm deep in a whole sphere
SPEED = 0.37  # m/s, of impacts
LONGEST_CONTACT = 1000  # steps: one contact takes about 100, several balls in a row a few times that
NONE, DOWN = (0.0, 0.0, 0.0), (0.0, -STANDARD_GRAVITY, 0.0)
FREE = DrivenCage(  # without friction, losses and weight; its balls spin without orbiting
    mass=6.58e-3,
    ball_count=9,
    ball_radius=BALL / 2,
    pitch_radius=19.505e-3,
    half_clearance=CLEARANCE,
    stiffness=STIFFNESS,
    restitution=1.0,
    friction_coefficient=0.0,
    orbit_speed=0.0,
    ball_speed=100.0,
    contact_angle=0.18,
    ring_speed=52.36,
    gravity=NONE,
)


def in_pocket(**fields: float) -> Record:
    """A pocket of this stiffness and clearance without losses."""
    cage = np.zeros(1, CAGE)
    cage["half_clearance"], cage["stiffness"], cage["ball_radius"] = CLEARANCE, STIFFNESS, BALL / 2
    cage["smoothing"] = 1e-3
    for name, value in fields.items():
        cage[name] = value
    return as_record(cage[0])


def pushed(along: float, *, centre_offset: float) -> Array:
    """(3,) force, N, of a ball on its pocket, `along` the axis and OFF_AXIS from it, m."""
    ball = BallInPocket((along, OFF_AXIS, 0.0), (1.0, 0.0, 0.0), NONE, NONE, NONE)
    at_rest = Body(NONE, NONE, (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0), NONE)
    cage = in_pocket(centre_offset=centre_offset, least_impact=SPEED)
    return np.array(pushed_by(cage, ball, at_rest, np.zeros(2)).force)


def clearance(*, pocket: float = POCKET, depth: float = POCKET / 2) -> tuple[float, float]:
    return pocket_shape(ball_diameter=BALL, pocket_diameter=pocket, pocket_depth=depth)


def rubbed(speed: float) -> float:
    """Friction, N, at 7 N and this sliding speed, m/s, with a coefficient of 0.13 and a smoothing of 1 mm/s."""
    return rubbing(in_pocket(friction=0.13), 7.0, speed) * speed


def thrown(cage: DrivenCage, *, velocity: tuple[float, float, float], turning: float = 0.0) -> CageMotion:
    """Launched from the middle of its clearance, rotating about its axis and transverse to it, rad/s."""
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.array(velocity), angular_velocity=turning * np.array([0.6, -0.9, 1.4]))
    return motion


def after_one_blow(velocity: tuple[float, float, float], **changed: Any) -> CageMotion:
    """The motion after the first impact at SPEED and before the next."""
    motion = thrown(replace(FREE, **changed), velocity=velocity)
    motion.advance(1.6 * CLEARANCE / SPEED)
    return motion


def energy_kept(restitution: float) -> float:
    """Energy after an impact on all balls at once, over that before and over the square of the restitution."""
    motion = after_one_blow((0.0, 0.0, SPEED), restitution=restitution)
    return motion.kinetic_energy / (FREE.mass * SPEED**2 / 2) / restitution**2


def energy_over_bounces() -> float:
    """Energy after 20 ms in all six degrees of freedom, over that before; NaN unless balls were hit."""
    motion = thrown(FREE, velocity=(0.31, -0.22, 0.17), turning=10.0)
    before = motion.kinetic_energy
    passed = motion.advance(0.02)
    for _ in range(LONGEST_CONTACT):  # the springs hold energy too: read it when nothing touches
        if not motion.forces().any():
            return motion.kinetic_energy / before if passed.max_force > 10 else math.nan
        motion.advance(motion.step)
    return math.nan


def hung(centre_offset: float) -> float:
    """Force, N, of the only ball on a cage that hangs on it at rest."""
    cage = replace(FREE, ball_count=1, gravity=DOWN, centre_offset=centre_offset)
    return float(CageMotion(cage, begin="rest").forces()[0, 1])


def led(lead: float) -> float:
    """Largest force at the start, N, of balls that lead and lag so far, m, on a cage in the best position."""
    return float(np.abs(CageMotion(replace(FREE, ball_lead=lead), begin="sudden").forces()).max())


def spread(*, duration: float = 0.0065) -> float:
    """Torque and width of its interval, N m, of a cage without friction that rests on its balls."""
    cage = replace(FREE, gravity=DOWN, orbit_speed=20.0, restitution=0.8, ball_speed=1.0)
    motion = measured_motion(cage, start="rest", seeds=2, duration=duration)
    return motion.torque + motion.torque_interval[1] - motion.torque_interval[0]


CAGE_CASES: dict[str, Callable[[], float]] = {
    "pocket: ball on the plane": lambda: float(pushed(0.0, centre_offset=0.0)[1]),
    "pocket: ball on either side of the plane": lambda: float(
        pushed(1e-15, centre_offset=0.0)[1] / pushed(-1e-15, centre_offset=0.0)[1]
    ),
    "pocket: ball just off the plane": lambda: float(
        pushed(1e-15, centre_offset=0.0)[1] / pushed(0.0, centre_offset=0.0)[1]
    ),
    "pocket: both shells": lambda: float(np.sum(pushed(0.0, centre_offset=0.04e-3))),
    "pocket: half as deep as wide": lambda: clearance()[1] / CLEARANCE,
    "pocket: deeper than half of its width": lambda: clearance(depth=POCKET / 2 * (1 + 1e-12))[1],
    "pocket: less deep than the ball's radius": lambda: clearance(depth=BALL / 2)[1],
    "pocket: narrower than the ball": lambda: clearance(pocket=BALL - 0.1e-3, depth=BALL / 2 - 0.05e-3)[0],
    "pocket: as wide as the ball": lambda: clearance(pocket=BALL, depth=BALL / 2)[0],
    "pocket: no sliding": lambda: rubbed(0.0) / (0.13 * 7.0),
    "pocket: sliding at 1e-12 m/s": lambda: rubbed(1e-12) / 1e-12,
    "impact: restitution 0.05": lambda: impact_damping(0.05),
    "impact: restitution 1 - 2^-16": lambda: impact_damping(1 - 2.0**-16),
    "impact: restitution 0.04": lambda: impact_damping(0.04),
    "impact: 1e-12 m/s": lambda: impact(mass=0.31, speed=1e-12, stiffness=STIFFNESS).duration,
    "cage: impact at restitution 0.05": lambda: energy_kept(0.05),
    "cage: impact at restitution 1 - 2^-16": lambda: energy_kept(1 - 2.0**-16),
    "cage: without friction and damping": energy_over_bounces,
    "cage: no weight and matched speed": lambda: (
        CageMotion(replace(FREE, friction_coefficient=0.1, orbit_speed=21.0), begin="rest").advance(0.05).max_force
    ),
    "cage: one ball": lambda: hung(0.0),
    "cage: one ball between both shells": lambda: hung(0.04e-3),
    "cage: one ball, central impact": lambda: (
        float(after_one_blow((SPEED, 0.0, 0.0), ball_count=1).velocity[0]) / SPEED
    ),
    "cage: one ball, tangential impact": lambda: (
        float(after_one_blow((0.0, SPEED, 0.0), ball_count=1).angular_velocity[2]) * FREE.pitch_radius / SPEED
    ),
    "cage: balls that lead by almost the clearance": lambda: led(0.99 * 2 * CLEARANCE),
    "cage: balls that lead by more than the clearance": lambda: led(1.01 * 2 * CLEARANCE),
    "cage: shells that clamp the ball": lambda: hung(CLEARANCE),
    "cage: thrown at 10 km/s": lambda: thrown(FREE, velocity=(1e4, 0.0, 0.0)).advance(1e-3).max_force,
    "cage: very large friction": lambda: hanging_torque(1e9, 6.58e-3 * STANDARD_GRAVITY, 2.358 * 3.97e-3, 0.18),
    "cage: torque without friction": spread,
    "cage: too short a motion": lambda: spread(duration=1e-3),
}
