"""Hard cases of the cage: a ball in its pocket, impacts, and the motion of the whole."""

import math
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.cage.motion import CageMotion
from analytic.cage.pocket import friction_force, impact, impact_damping, normal_force, penetration, pocket_shape
from analytic.cage.statistics import measured_motion
from analytic.cage.steady import STANDARD_GRAVITY, DrivenCage, rest_torque
from analytic.scene import Array
from fembearing.compare.hard.case import HardCase
from fembearing.compare.hard.contacts import ROUND_OFF

BALL, ROOM, STIFFNESS = 7.94e-3, 0.1e-3, 6e10  # m, m, N/m^1.5
POCKET = BALL + 2 * ROOM  # m
ACROSS = 0.13e-3  # m, of a ball across its pocket's axis: 0.03 mm deep in a whole sphere
SPEED = 0.37  # m/s, of impacts
LONGEST_CONTACT = 1000  # steps: one contact takes some 100, of several balls in a row a few times that
NONE, DOWN = (0.0, 0.0, 0.0), (0.0, -STANDARD_GRAVITY, 0.0)
FREE = DrivenCage(  # of friction, losses and weight, its balls turning on the spot
    mass=6.58e-3,
    ball_count=9,
    ball_radius=BALL / 2,
    pitch_radius=19.505e-3,
    half_clearance=ROOM,
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
HANGING = (1e-10, "a depth of 10 nm as the difference of lengths of 0.1 mm, which are 1e4 times as long")
DRIFT = (1e-3, "the step's error, which accumulates: up to 4e-4 in 150 random throws")
ONE_BLOW = (1e-3, "the step's error: up to 4e-4 at 200 random speeds")


def pushed(along: float, *, centre_offset: float) -> Array:
    """(3,) N: of a ball on its pocket, `along` the axis and ACROSS off it, m."""
    depth, normal = penetration(np.array([along, ACROSS, 0.0]), half_clearance=ROOM, centre_offset=centre_offset)
    force = normal_force(depth, rate=0.0, impact_speed=SPEED, stiffness=STIFFNESS, damping=0.0)
    return np.sum(force[..., None] * normal, axis=-2)


def clearance(*, pocket: float = POCKET, depth: float = POCKET / 2) -> tuple[float, float]:
    return pocket_shape(ball_diameter=BALL, pocket_diameter=pocket, pocket_depth=depth)


def rubbed(speed: float) -> float:
    """N, of a ball pressed with 7 N that slides so fast, m/s, with a coefficient of 0.13 and a smoothing of 1 mm/s."""
    found = friction_force(7.0, np.array([0.6 * speed, -0.8 * speed, 0.0]), friction_coefficient=0.13, smoothing=1e-3)
    return float(np.linalg.norm(found))


def thrown(cage: DrivenCage, *, velocity: tuple[float, float, float], turning: float = 0.0) -> CageMotion:
    """From the middle of its room, turning about its axis and across it, rad/s."""
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.array(velocity), angular_velocity=turning * np.array([0.6, -0.9, 1.4]))
    return motion


def after_one_blow(velocity: tuple[float, float, float], **changed: Any) -> CageMotion:
    """Past the first impact at SPEED and before the next."""
    motion = thrown(replace(FREE, **changed), velocity=velocity)
    motion.advance(1.6 * ROOM / SPEED)
    return motion


def energy_kept(restitution: float) -> float:
    """Energy after an impact on all balls at once over that before, over the square of the restitution."""
    motion = after_one_blow((0.0, 0.0, SPEED), restitution=restitution)
    return motion.kinetic_energy / (FREE.mass * SPEED**2 / 2) / restitution**2


def energy_over_bounces() -> float:
    """Energy after 20 ms with all six freedoms under way over that before; NaN unless balls were hit."""
    motion = thrown(FREE, velocity=(0.31, -0.22, 0.17), turning=10.0)
    before = motion.kinetic_energy
    passed = motion.advance(0.02)
    for _ in range(LONGEST_CONTACT):  # springs hold energy too: told where nothing touches
        if not motion.forces().any():
            return motion.kinetic_energy / before if passed.max_force > 10 else math.nan
        motion.advance(motion.step)
    return math.nan


def untouched() -> float:
    """Largest force in 50 ms, N, on a cage without weight that turns as fast as its balls go round."""
    motion = CageMotion(replace(FREE, friction_coefficient=0.1, orbit_speed=21.0), begin="rest")
    return motion.advance(0.05).max_force


def hung(centre_offset: float) -> float:
    """N, of the only ball on a cage that hangs on it at rest."""
    cage = replace(FREE, ball_count=1, gravity=DOWN, centre_offset=centre_offset)
    return float(CageMotion(cage, begin="rest").forces()[0, 1])


def led(lead: float) -> float:
    """Largest force at once, N, of balls that lead and lag so far, m, on a cage that has gone along."""
    return float(np.abs(CageMotion(replace(FREE, ball_lead=lead), begin="sudden").forces()).max())


def spread(*, duration: float = 0.0065) -> float:
    """Width of the interval of the torque, N m, of a cage without friction that rests on its balls."""
    cage = replace(FREE, gravity=DOWN, orbit_speed=20.0, restitution=0.8, ball_speed=1.0)
    found = measured_motion(cage, start="rest", seeds=2, duration=duration)
    return found.torque + found.torque_interval[1] - found.torque_interval[0]


CAGE_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="pocket: across its plane",
        asked="a ball exactly between both half-shells of one whole sphere",
        right="K (|u| - room)^1.5 once, by 40 digits: neither twice nor not at all",
        evaluate=lambda: float(pushed(0.0, centre_offset=0.0)[1]),
        expected=9859.0060350929900422,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="pocket: on either side of its plane",
        asked="the same 1e-15 m to one side over that to the other",
        right="1: what was one shell's becomes the other's, without a jump",
        evaluate=lambda: float(pushed(1e-15, centre_offset=0.0)[1] / pushed(-1e-15, centre_offset=0.0)[1]),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="pocket: beside its plane",
        asked="the same 1e-15 m to one side over that on the plane",
        right="1: the plane itself is no exception",
        evaluate=lambda: float(pushed(1e-15, centre_offset=0.0)[1] / pushed(0.0, centre_offset=0.0)[1]),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="pocket: both shells",
        asked="a ball on the plane of a pocket whose shells' centres lie 0.04 mm off it",
        right="the forces of both shells, by 40 digits; along the axis they cancel",
        evaluate=lambda: float(np.sum(pushed(0.0, centre_offset=0.04e-3))),
        expected=24788.972654966894041,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="pocket: as deep as half of its diameter",
        asked="one and how far the shells' centres lie off the middle, over the room",
        right="1: both are one sphere",
        evaluate=lambda: 1 + clearance()[1] / ROOM,
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="pocket: deeper than half of its diameter",
        asked="shells of more than half a sphere",
        right="a refusal that names both: no ball comes in",
        evaluate=lambda: clearance(depth=POCKET / 2 * (1 + 1e-12))[1],
        refusal="and at most half of pocket_diameter",
    ),
    HardCase(
        name="pocket: less deep than the ball's radius",
        asked="shells that meet before the ball has room",
        right="a refusal: they clamp it",
        evaluate=lambda: clearance(depth=BALL / 2)[1],
        refusal="else the ball is clamped",
    ),
    HardCase(
        name="pocket: narrower than the ball",
        asked="a pocket 0.1 mm too narrow",
        right="a refusal that names both diameters",
        evaluate=lambda: clearance(pocket=BALL - 0.1e-3, depth=BALL / 2 - 0.05e-3)[0],
        refusal="must exceed ball_diameter",
    ),
    HardCase(
        name="pocket: as wide as the ball",
        asked="a pocket of exactly the ball's diameter, where Hertz's seat has no curvature",
        right="a refusal that names both diameters",
        evaluate=lambda: clearance(pocket=BALL, depth=BALL / 2)[0],
        refusal="must exceed ball_diameter",
    ),
    HardCase(
        name="pocket: no sliding",
        asked="one and the friction where nothing slides, over mu N",
        right="1: none, though its direction is 0/0",
        evaluate=lambda: 1 + rubbed(0.0) / (0.13 * 7.0),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="pocket: all but no sliding",
        asked="friction over speed at 1e-12 m/s",
        right="mu N/v0 = 910 N s/m, the slope at rest",
        evaluate=lambda: rubbed(1e-12) / 1e-12,
        expected=910.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="impact: restitution 0.05",
        asked="the damping of an impact that keeps a twentieth of its speed",
        right="the root of l (1 + e) = ln((1 + l)/(1 - l e)), by 40 digits: 4e-7 below its pole at 1/e",
        evaluate=lambda: impact_damping(0.05),
        expected=19.999999681532360365,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="impact: restitution 1 - 2^-16",
        asked="the damping of an impact that loses next to nothing",
        right="the same root, by 40 digits: both sides of the equation agree to 10 digits, and its other root is 0",
        evaluate=lambda: impact_damping(1 - 2.0**-16),
        expected=0.000022888532844511709324,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="impact: restitution 0.04",
        asked="an impact that keeps less than the least",
        right="a refusal with the limit",
        evaluate=lambda: impact_damping(0.04),
        refusal="restitution must be 0.05 to 1, got 0.04",
    ),
    HardCase(
        name="impact: 1e-12 m/s",
        asked="how long 0.31 kg touch that come so slowly: it goes as speed^(-1/5)",
        right="2 d/v int_0^1 dz/sqrt(1 - z^2.5), by 40 digits",
        evaluate=lambda: float(impact(mass=0.31, speed=1e-12, stiffness=STIFFNESS).duration),
        expected=0.024710358791853260259,
        tolerance=(1e-9, "the integral is written with ten digits"),
    ),
    HardCase(
        name="cage: an impact at restitution 0.05",
        asked="energy after an impact on all balls at once, over e^2 of that before",
        right="1, where the damping is 20 times the elastic force",
        evaluate=lambda: energy_kept(0.05),
        expected=1.0,
        tolerance=ONE_BLOW,
    ),
    HardCase(
        name="cage: an impact at restitution 1 - 2^-16",
        asked="the same, all but without loss",
        right="1: what is lost is less than the step's error, and is not made up",
        evaluate=lambda: energy_kept(1 - 2.0**-16),
        expected=1.0,
        tolerance=ONE_BLOW,
    ),
    HardCase(
        name="cage: without friction and damping",
        asked="energy after dozens of impacts in six freedoms over that before",
        right="1: no force does work on balls that stand",
        evaluate=energy_over_bounces,
        expected=1.0,
        tolerance=DRIFT,
    ),
    HardCase(
        name="cage: no weight and matched speed",
        asked="one and the largest force in 50 ms, N",
        right="1: nothing ever touches, and no round-off grows into a touch",
        evaluate=lambda: 1 + untouched(),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="cage: a single ball",
        asked="the force of the only ball on a cage that hangs on it",
        right="the weight, m g",
        evaluate=lambda: hung(0.0),
        expected=6.58e-3 * 9.80665,
        tolerance=HANGING,
    ),
    HardCase(
        name="cage: a single ball between both shells",
        asked="the same in a pocket whose shells' centres lie 0.04 mm off, as deep as the weight takes one sphere",
        right="equation 14 of both shells, by 40 digits",
        evaluate=lambda: hung(0.04e-3),
        expected=0.10378619684230233518,
        tolerance=HANGING,
    ),
    HardCase(
        name="cage: a single ball, hit through the middle",
        asked="speed after an impact outward over that before",
        right="-1: all of the mass turns back",
        evaluate=lambda: float(after_one_blow((SPEED, 0.0, 0.0), ball_count=1).velocity[0]) / SPEED,
        expected=-1.0,
        tolerance=ONE_BLOW,
    ),
    HardCase(
        name="cage: a single ball, hit beside the middle",
        asked="turning after an impact along the pitch circle, times its radius over the speed before",
        right="-1: a ring's centre stops dead, 1/m + r^2/(m r^2) = 2/m, and all of its energy turns",
        evaluate=lambda: (
            float(after_one_blow((0.0, SPEED, 0.0), ball_count=1).angular_velocity[2]) * FREE.pitch_radius / SPEED
        ),
        expected=-1.0,
        tolerance=ONE_BLOW,
    ),
    HardCase(
        name="cage: balls that lead by all but the clearance",
        asked="one and the largest force on a cage between balls that lead and lag by 0.99 of it",
        right="1: there is a place that clears them all",
        evaluate=lambda: 1 + led(0.99 * 2 * ROOM),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="cage: balls that lead by more than the clearance",
        asked="a lead of 1.01 of it: no place clears them all",
        right="a refusal with the largest lead",
        evaluate=lambda: led(1.01 * 2 * ROOM),
        refusal="is beyond the clearance: below 0.0002 m",
    ),
    HardCase(
        name="cage: shells that clamp the ball",
        asked="shells' centres as far off the middle as there is room",
        right="a refusal that names both",
        evaluate=lambda: hung(ROOM),
        refusal="the shells clamp the ball",
    ),
    HardCase(
        name="cage: thrown at 10 km/s",
        asked="an impact that would drive balls through the pockets",
        right="a refusal with time and place, and no result",
        evaluate=lambda: thrown(FREE, velocity=(1e4, 0.0, 0.0)).advance(1e-3).max_force,
        refusal="the cage's motion came apart",
    ),
    HardCase(
        name="cage: friction beyond bounds",
        asked="the torque of a resting cage at mu = 1e9, where friction alone carries it",
        right="m g r (w_b/w) (2/pi) E(sin^2 al), by 40 digits: friction never exceeds the weight",
        evaluate=lambda: float(
            rest_torque(
                friction_coefficient=1e9, cage_mass=6.58e-3, ball_rate=2.358, ball_radius=3.97e-3, contact_angle=0.18
            )
        ),
        expected=0.00059919134709185737831,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="cage: torque of no friction",
        asked="one and the torque of two seeds and the width of its interval, N m: a spread of nothing",
        right="1: exactly none, and no 0/0",
        evaluate=lambda: 1 + spread(),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="cage: a moment too short",
        asked="statistics over 1 ms, in which the cage does not once cross its pockets",
        right="a refusal with the time that it takes",
        evaluate=lambda: spread(duration=1e-3),
        refusal="the cage crosses its pockets once in 0.00639 s",
    ),
)
