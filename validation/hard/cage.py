"""Hard cases of the cage: a ball in its pocket, impacts, and the motion of the cage."""

import math
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
from validation.hard.case import HardCase

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

# Tolerances, relative, with their reasons
HANGING = (1e-10, "a depth of 10 nm, the difference of lengths that are 1e4 times as long")
DRIFT = (1e-3, "the error of the steps, which accumulates: up to 4e-4 in 150 random motions")
ONE_BLOW = (1e-3, "the step's error: up to 4e-4 at 200 random speeds")


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


def untouched() -> float:
    """Largest force in 50 ms, N, on a cage without weight that rotates as fast as its balls orbit."""
    motion = CageMotion(replace(FREE, friction_coefficient=0.1, orbit_speed=21.0), begin="rest")
    return motion.advance(0.05).max_force


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


CAGE_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("pocket: ball on the plane", "a ball exactly on the plane between both half-shells of one whole sphere",
        "K (|u| - clearance)^1.5 once, by 40 digits: neither twice nor never",
        lambda: float(pushed(0.0, centre_offset=0.0)[1]), 9859.0060350929900422),
    HardCase("pocket: ball on either side of the plane",
        "the force 1e-15 m to one side of the plane over that 1e-15 m to the other",
        "1: the contact passes from one shell to the other without a jump",
        lambda: float(pushed(1e-15, centre_offset=0.0)[1] / pushed(-1e-15, centre_offset=0.0)[1]), 1.0),
    HardCase("pocket: ball just off the plane", "the force 1e-15 m to one side of the plane over that on the plane",
        "1: the plane itself is no exception",
        lambda: float(pushed(1e-15, centre_offset=0.0)[1] / pushed(0.0, centre_offset=0.0)[1]), 1.0),
    HardCase("pocket: both shells", "a ball on the plane of a pocket whose shells' centres are 0.04 mm off the plane",
        "the forces of both shells, by 40 digits; along the axis they cancel",
        lambda: float(np.sum(pushed(0.0, centre_offset=0.04e-3))), 24788.972654966894041),
    HardCase("pocket: half as deep as wide", "the offset of the shells' centres from the middle, over the clearance",
        "0: both shells are one sphere", lambda: clearance()[1] / CLEARANCE, 0.0),
    HardCase("pocket: deeper than half of its width", "shells of more than half a sphere",
        "a refusal that names both: no ball gets in", lambda: clearance(depth=POCKET / 2 * (1 + 1e-12))[1],
        refusal="and at most half of pocket_diameter"),
    HardCase("pocket: less deep than the ball's radius", "shells that meet inside the ball", "a refusal: they clamp it",
        lambda: clearance(depth=BALL / 2)[1], refusal="else the ball is clamped"),
    HardCase("pocket: narrower than the ball", "a pocket 0.1 mm too narrow", "a refusal that names both diameters",
        lambda: clearance(pocket=BALL - 0.1e-3, depth=BALL / 2 - 0.05e-3)[0], refusal="must exceed ball_diameter"),
    HardCase("pocket: as wide as the ball",
        "a pocket of exactly the ball's diameter, where Hertz's seat has no curvature",
        "a refusal that names both diameters", lambda: clearance(pocket=BALL, depth=BALL / 2)[0],
        refusal="must exceed ball_diameter"),
    HardCase("pocket: no sliding", "the friction without sliding, over mu N", "0, although its direction is 0/0",
        lambda: rubbed(0.0) / (0.13 * 7.0), 0.0),
    HardCase("pocket: sliding at 1e-12 m/s", "friction over speed at 1e-12 m/s",
        "mu N/v0 = 910 N s/m, the slope at rest", lambda: rubbed(1e-12) / 1e-12, 910.0),
    HardCase("impact: restitution 0.05", "the damping of an impact that keeps a twentieth of its speed",
        "the root of l (1 + e) = ln((1 + l)/(1 - l e)), by 40 digits: 4e-7 below its pole at 1/e",
        lambda: impact_damping(0.05), 19.999999681532360365),
    HardCase("impact: restitution 1 - 2^-16", "the damping of an impact that loses almost nothing",
        "the same root, by 40 digits: both sides of the equation agree to 10 digits, and its other root is 0",
        lambda: impact_damping(1 - 2.0**-16), 0.000022888532844511709324),
    HardCase("impact: restitution 0.04", "an impact that keeps less than the least restitution",
        "a refusal with the limit", lambda: impact_damping(0.04), refusal="restitution must be 0.05 to 1, got 0.04"),
    HardCase("impact: 1e-12 m/s", "the contact time of 0.31 kg at 1e-12 m/s: it goes as speed^(-1/5)",
        "2 d/v int_0^1 dz/sqrt(1 - z^2.5), by 40 digits",
        lambda: impact(mass=0.31, speed=1e-12, stiffness=STIFFNESS).duration, 0.024710358791853260259,
        tolerance=(1e-9, "the integral is written with ten digits")),
    HardCase("cage: impact at restitution 0.05", "energy after an impact on all balls at once, over e^2 of that before",
        "1, where the damping is 20 times the elastic force", lambda: energy_kept(0.05), 1.0, tolerance=ONE_BLOW),
    HardCase("cage: impact at restitution 1 - 2^-16", "the same, almost without loss",
        "1: the loss is less than the step's error, and no energy is gained", lambda: energy_kept(1 - 2.0**-16), 1.0,
        tolerance=ONE_BLOW),
    HardCase("cage: without friction and damping",
        "energy after dozens of impacts in six degrees of freedom, over that before",
        "1: no force does work on balls at rest", energy_over_bounces, 1.0, tolerance=DRIFT),
    HardCase("cage: no weight and matched speed", "the largest force in 50 ms, N",
        "0: nothing ever touches, and round-off does not grow into a contact", lambda: untouched(), 0.0),
    HardCase("cage: one ball", "the force on the only ball of a cage that hangs on it", "the weight, m g",
        lambda: hung(0.0), 6.58e-3 * 9.80665, tolerance=HANGING),
    HardCase("cage: one ball between both shells",
        "the same, with shells' centres 0.04 mm off, as deep as the weight would press it into one sphere",
        "equation 14 of [Paper] for both shells, by 40 digits", lambda: hung(0.04e-3), 0.10378619684230233518,
        tolerance=HANGING),
    HardCase("cage: one ball, central impact", "velocity after a radial impact over that before",
        "-1: the whole mass turns back",
        lambda: float(after_one_blow((SPEED, 0.0, 0.0), ball_count=1).velocity[0]) / SPEED, -1.0, tolerance=ONE_BLOW),
    HardCase("cage: one ball, tangential impact",
        "rotation after an impact along the pitch circle, times its radius, over the speed before",
        "-1: a ring's centre stops dead, 1/m + r^2/(m r^2) = 2/m, and all of its energy becomes rotation",
        lambda: float(after_one_blow((0.0, SPEED, 0.0), ball_count=1).angular_velocity[2]) * FREE.pitch_radius / SPEED,
        -1.0, tolerance=ONE_BLOW),
    HardCase("cage: balls that lead by almost the clearance",
        "the largest force on a cage between balls that lead and lag by 0.99 of it, N",
        "0: one position of the cage clears them all", lambda: led(0.99 * 2 * CLEARANCE), 0.0),
    HardCase("cage: balls that lead by more than the clearance", "a lead of 1.01 of it: no position clears them all",
        "a refusal with the largest lead", lambda: led(1.01 * 2 * CLEARANCE),
        refusal="is beyond the clearance: below 0.2 mm"),
    HardCase("cage: shells that clamp the ball", "shells' centres as far off the middle as the clearance",
        "a refusal that names both", lambda: hung(CLEARANCE), refusal="the shells clamp the ball"),
    HardCase("cage: thrown at 10 km/s", "an impact that would drive balls through the pockets",
        "a refusal with time and place instead of a result",
        lambda: thrown(FREE, velocity=(1e4, 0.0, 0.0)).advance(1e-3).max_force, refusal="the cage's motion came apart"),
    HardCase("cage: very large friction", "the torque of a resting cage at mu = 1e9, where friction alone carries it",
        "m g r (w_b/w) (2/pi) E(sin^2 al), by 40 digits: friction never exceeds the weight",
        lambda: hanging_torque(1e9, 6.58e-3 * STANDARD_GRAVITY, 2.358 * 3.97e-3, 0.18), 0.00059919134709185737831),
    HardCase("cage: torque without friction", "the torque of two seeds and the width of its interval, N m",
        "0 exactly, without 0/0", lambda: spread(), 0.0),
    HardCase("cage: too short a motion", "statistics over 1 ms, less than the cage takes to cross its pockets",
        "a refusal with the time needed", lambda: spread(duration=1e-3),
        refusal="the cage crosses its pockets once in 0.00639 s"),
)  # fmt: skip
