"""A cage in motion that is guided by a land of a ring."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.cage.motion import CageMotion
from analytic.cage.steady import LandGuidance
from tests.analytic.cage.specimens import CAGE, WEIGHTLESS, W


def test_a_land_that_starts_with_the_ring_turns_no_faster() -> None:
    """Ramped over half a second, a land at 1 ms has hardly left its standstill."""
    land = LandGuidance(radius=17e-3, half_clearance=0.05e-3, outside=False, speed=2.0, half_width=5e-3)
    found = []
    for ramp in (0.5, 1e-4):
        cage = replace(CAGE, land=land, half_clearance=1e-3, orbit_speed=0.0, ball_speed=0.0)
        motion = CageMotion(cage, begin="ramp", ramp=ramp)
        found.append(motion.advance(1e-3).land_power)
    assert found[0] < 0.02 * found[1]  # it has come to 2 per mille of 34 mm/s by then


def test_land_guides_the_cage_before_its_pockets_do() -> None:
    land = LandGuidance(radius=17e-3, half_clearance=0.05e-3, outside=False, speed=W, half_width=5e-3)
    motion = CageMotion(replace(CAGE, land=land), begin="rest", seed=2)
    motion.advance(0.05)
    passed = motion.advance(0.05)
    assert passed.land_power > 0
    assert passed.distance < 0.06e-3


@pytest.mark.parametrize(("outside", "speed"), [(False, 50.0), (True, -40.0)])
def test_a_turning_land_takes_the_cage_along(outside: bool, speed: float) -> None:
    """A cage at standstill that hangs on its land, clear of its balls: mu m g times the land's radius turns it."""
    land = LandGuidance(radius=17e-3, half_clearance=0.05e-3, outside=outside, speed=speed, half_width=5e-3)
    cage = replace(CAGE, land=land, half_clearance=1e-3, orbit_speed=0.0, ball_speed=0.0)
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-3)  # of its swing of 14 ms, in which friction also pushes it aside
    turned = 0.1 * cage.mass * 9.80665 * 17e-3 * np.sign(speed) / cage.inertia[0] * motion.time
    np.testing.assert_allclose(motion.angular_velocity[2], turned, rtol=0.05)


def test_a_land_holds_a_cage_whose_balls_lead() -> None:
    """The motion begins within land and pockets, and no force of one ball on its pocket counts the land's."""
    land = LandGuidance(radius=17e-3, half_clearance=0.05e-3, outside=False, speed=W, half_width=5e-3)
    cage = replace(CAGE, land=land, ball_lead=0.14e-3, gravity=WEIGHTLESS)
    for begin in ("rest", "sudden", "whirl"):
        motion = CageMotion(cage, begin=begin)
        assert np.linalg.norm(motion.centre) < 1.001 * land.half_clearance
        assert not motion.forces().any()
    hanging = CageMotion(replace(cage, ball_lead=0.06e-3, gravity=CAGE.gravity), begin="rest")
    np.testing.assert_allclose(np.linalg.norm(hanging.centre), land.half_clearance, rtol=0.01)  # and the sag
    motion = CageMotion(replace(cage, ball_lead=0.0, friction_coefficient=0.0, orbit_speed=0.0), begin="sudden")
    motion.launch(velocity=np.array([0.0, 0.37, 0.0]), angular_velocity=np.zeros(3))
    passed = motion.advance(3 * land.half_clearance / 0.37)
    assert motion.velocity[1] < 0
    assert passed.max_force == 0


def test_a_cage_that_tilts_meets_its_land_with_both_rims() -> None:
    """Without friction they throw it back as fast: 0.01 rad after a millisecond, its centre at rest."""
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
def test_friction_of_the_land_has_the_arm_of_the_rim(outside: bool) -> None:
    """Where the rim meets the land, from the cage's own centre: its moment is what speeds the cage up."""
    radius, gap = (
        1.7e-3,
        0.9e-3,
    )  # a small land with a wide gap: the radius of the rim is 2.6 mm in the bore, 0.8 mm outside
    land = LandGuidance(radius=radius, half_clearance=gap, outside=outside, speed=900.0, half_width=5e-3)
    cage = replace(CAGE, land=land, half_clearance=2e-3, orbit_speed=0.0, ball_speed=0.0, axial_inertia=1e-3)
    motion = CageMotion(cage, begin="rest")
    passed = motion.advance(2e-4)
    arm = radius - gap if outside else radius + gap
    push = passed.land_power / (900.0 * radius)  # of friction: the cage hardly moves
    np.testing.assert_allclose(motion.angular_velocity[2] * 1e-3, push * arm * motion.time, rtol=0.02)
