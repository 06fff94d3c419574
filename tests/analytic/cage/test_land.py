"""The motion of a cage that is guided by the land of a ring."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.cage.motion import CageMotion
from analytic.cage.steady import LandGuidance
from tests.analytic.cage.specimens import CAGE, WEIGHTLESS, W


@pytest.mark.parametrize(("outside", "speed"), [(False, 50.0), (True, -40.0)])
def test_a_rotating_land_drives_the_cage(outside: bool, speed: float) -> None:
    """A cage at standstill hangs on its land and touches no ball: mu m g times the radius of the land turns it."""
    land = LandGuidance(radius=17e-3, half_clearance=0.05e-3, outside=outside, speed=speed, half_width=5e-3)
    cage = replace(CAGE, land=land, half_clearance=1e-3, orbit_speed=0.0, ball_speed=0.0)
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-3)  # its swing, in which friction also moves it sideways, takes 14 ms
    turned = 0.1 * cage.mass * 9.80665 * 17e-3 * np.sign(speed) / cage.inertia[0] * motion.time
    np.testing.assert_allclose(motion.angular_velocity[2], turned, rtol=0.05)


def test_a_land_holds_a_cage_whose_balls_lead() -> None:
    """The motion begins within land and pockets, and the forces of the balls do not include that of the land."""
    land = LandGuidance(radius=17e-3, half_clearance=0.05e-3, outside=False, speed=W, half_width=5e-3)
    cage = replace(CAGE, land=land, ball_lead=0.14e-3, gravity=WEIGHTLESS)
    for begin in ("rest", "sudden", "whirl"):
        motion = CageMotion(cage, begin=begin)
        assert np.linalg.norm(motion.centre) < 1.001 * land.half_clearance
        assert not motion.forces().any()
    hanging = CageMotion(replace(cage, ball_lead=0.06e-3, gravity=CAGE.gravity), begin="rest")
    np.testing.assert_allclose(np.linalg.norm(hanging.centre), land.half_clearance, rtol=0.01)  # and the elastic sag
    motion = CageMotion(replace(cage, ball_lead=0.0, friction_coefficient=0.0, orbit_speed=0.0), begin="sudden")
    motion.launch(velocity=np.array([0.0, 0.37, 0.0]), angular_velocity=np.zeros(3))
    passed = motion.advance(3 * land.half_clearance / 0.37)
    assert motion.velocity[1] < 0
    assert passed.max_force == 0


def test_a_tilting_cage_touches_its_land_with_both_rims() -> None:
    """Without friction it rebounds at 0.01 rad, after a millisecond, with the same speed; its centre stays at rest."""
    land = LandGuidance(radius=17e-3, half_clearance=0.05e-3, outside=True, speed=W, half_width=5e-3)
    cage = replace(CAGE, land=land, half_clearance=1e-3, friction_coefficient=0.0, gravity=WEIGHTLESS, orbit_speed=0.0)
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.zeros(3), angular_velocity=np.array([6.0, 8.0, 0.0]))
    motion.advance(0.9e-3)
    np.testing.assert_allclose(motion.angular_velocity, [6.0, 8.0, 0.0], atol=1e-9)
    motion.advance(0.4e-3)
    np.testing.assert_allclose(motion.angular_velocity, [-6.0, -8.0, 0.0], rtol=1e-3, atol=1e-9)  # the step's error
    np.testing.assert_allclose(motion.velocity, 0, atol=1e-9)


@pytest.mark.parametrize("outside", [False, True])
def test_friction_of_the_land_acts_at_the_radius_of_the_rim(outside: bool) -> None:
    """The moment about the centre of the cage has this lever arm, and it accelerates the cage."""
    radius, gap = (
        1.7e-3,
        0.9e-3,
    )  # a small land with a wide gap: the radius of the rim is 2.6 mm in the bore, 0.8 mm outside
    land = LandGuidance(radius=radius, half_clearance=gap, outside=outside, speed=900.0, half_width=5e-3)
    cage = replace(CAGE, land=land, half_clearance=2e-3, orbit_speed=0.0, ball_speed=0.0, axial_inertia=1e-3)
    motion = CageMotion(cage, begin="rest")
    passed = motion.advance(2e-4)
    arm = radius - gap if outside else radius + gap
    push = passed.land_power / (900.0 * radius)  # friction force, as the cage hardly moves
    np.testing.assert_allclose(motion.angular_velocity[2] * 1e-3, push * arm * motion.time, rtol=0.02)
