"""A ball between two races: published torques of a separate program, limits, invariants, and oil."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.oil.traction import PointLaw
from analytic.scene import Bearing
from fembearing.creep.ball import Elasticity, Grid, TurnedBall, TurningBall, turn_ball
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.place import HeldBall, free_lengths, unit_under
from fembearing.creep.strips import hertz_pressure
from tests.analytic.free_ball.specimens import under_thrust
from tests.analytic.specimens import BEARING_6205
from tests.contacts import NITRIDE, STEEL

ROUGH, GRID = Grid(8, 4), Grid(12, 6)


def centre_of(bearing: Bearing) -> float:
    """Of the outer groove, whose bottom radius fits the pitch diameter."""
    return bearing.outer.bottom_radius - bearing.outer.groove_radius


def thrust_ball(
    friction: float, load: float, *, speed: float = 52.36, bearing: Bearing = BEARING_6205, free: float = 0.18
) -> TurningBall:
    """Of a bearing under thrust, N; friction of both races."""
    radial = bearing.groove_centre_distance * np.cos(free)
    held = HeldBall(bearing=bearing, centre=centre_of(bearing), thrust=load / bearing.ball_count, radial=radial)
    law = PointLaw(boundary=friction)
    return TurningBall(held=held, laws=(law, law), speed=speed)


def torque(turned: TurnedBall) -> float:
    """Of nine balls, N mm."""
    return 9e3 * turned.torque


def test_a_ball_is_in_equilibrium() -> None:
    """Forces and moments of both contacts, by their maps, against inertia, in axes of the bearing."""
    ball = thrust_ball(0.08, 160.0, speed=900.0)
    turned = turn_ball(ball, GRID)
    bearing = BEARING_6205
    r, force, moment, friction = bearing.ball_radius, np.zeros(3), np.zeros(3), 0.0
    for race, sign in zip(turned.races, (-1.0, 1.0), strict=True):
        n = sign * np.array([np.cos(race.angle), 0.0, np.sin(race.angle)])  # radial, along the orbit, axial
        t, along = np.array([-n[2], 0.0, n[0]]), race.side * np.array([0.0, 1.0, 0.0])
        strips, (t_x, t_y) = race.friction.strips, race.friction.traction
        for part_x, part_y, area, x, y in zip(
            *(each.ravel() for each in (t_x, t_y, strips.area, strips.x, strips.y)), strict=True
        ):
            force += area * (part_x * along + part_y * t)  # what acts along n is in the load
            # Linear in y but for the curvature, which moves the surface by y^2/2R along n, and turns it by y/R.
            curvature = 1 / r - 0.5 * (1 / r - 1 / _groove(sign))
            moment += area * part_x * np.cross((r - y**2 * curvature / 2) * n + y * t, along)
            moment += area * part_y * (np.cross(x * along, t - y * curvature * n) + np.cross(r * n, t))
            friction += np.hypot(part_x, part_y) * area
        bends = np.sum((t_x * strips.y**2 / 2 - t_y * strips.x * strips.y) * strips.area)
        np.testing.assert_allclose(race.rolling_moment, bends * (1 / r - 0.5 * (1 / r - 1 / _groove(sign))), rtol=1e-9)
        force -= race.load * n
    w = 900.0
    orbit = w * turned.velocity[0] / turned.orbit
    spin = w * np.array([turned.velocity[2], turned.velocity[1], turned.velocity[3]]) / r
    inertia = 0.4 * bearing.ball_mass * r**2
    outward = bearing.ball_mass * turned.orbit * orbit**2
    np.testing.assert_allclose(force + np.array([outward, 0, 0]), 0.0, atol=3e-6 * friction)  # settled to 1e-6
    # (t x n = along) is a right-handed frame of radial, orbit and axial: the moment turns the ball with the orbit.
    np.testing.assert_allclose(moment, inertia * np.cross([0, 0, orbit], spin), atol=3e-6 * friction * r)


def _groove(sign: float) -> float:
    return (BEARING_6205.inner if sign < 0 else BEARING_6205.outer).groove_radius


def test_power_is_that_of_the_ring() -> None:
    """Friction on the inner ring about the bearing axis times its speed is what both contacts lose at low speed."""
    turned = turn_ball(thrust_ball(0.1, 1000.0, speed=1.0), GRID)
    inner = turned.races[0]
    strips, t_x = inner.friction.strips, inner.friction.traction[0]
    n_r, n_z, r = -np.cos(inner.angle), -np.sin(inner.angle), BEARING_6205.ball_radius
    curvature = 1 / r - 0.5 * (1 / r - 1 / BEARING_6205.inner.groove_radius)
    arm = turned.orbit + (r - strips.y**2 * curvature / 2) * n_r - strips.y * n_z
    turned_n = n_z + strips.y * curvature * n_r  # what acts across follows the surface
    moment = inner.side * np.sum((t_x * arm + inner.friction.traction[1] * strips.x * turned_n) * strips.area)
    np.testing.assert_allclose(moment, turned.torque, rtol=1e-4)  # settled to 1e-6 of forces 100 times as large


def test_little_friction_has_the_torque_of_rigid_surfaces() -> None:
    """38.04/0.1 N mm per friction without creep, the least power of rigid bodies over the ball's rotation.

    `tests/analytic/free_ball/test_rotation.py` computes it; creep is 1 % here.
    """
    ball = thrust_ball(0.004, 1000.0)
    turned = turn_ball(ball, Grid(20, 6), turn_ball(ball, ROUGH))
    np.testing.assert_allclose(torque(turned) / 0.004, 380.4, rtol=0.025)  # and of 20 strips
    angles = [race.angle for race in turned.races]
    np.testing.assert_allclose(angles, 0.3031, rtol=5e-3)  # no push parts them; of rigid balls 0.30313


def test_spin_parts_the_angles_and_friction_does_not_change_the_thrust() -> None:
    turned = turn_ball(thrust_ball(0.1, 1000.0), GRID)
    inner, outer = turned.races
    strips = under_thrust(BEARING_6205, 0.18, load=1000.0, speed=52.36, friction=0.1)
    # Strips overrate the push by a quarter of this small rest of opposite pushes at both ends; a grid of 12 by 6
    assert inner.angle - outer.angle == pytest.approx(strips.angle[0] - strips.angle[1], rel=0.4)
    for race in (inner, outer):
        push = race.load * np.sin(race.angle) - race.transverse_force * np.cos(race.angle)
        np.testing.assert_allclose(push, 1000.0 / 9, rtol=1e-6)  # settled


def test_a_held_ring_and_a_free_one_agree() -> None:
    ball = thrust_ball(0.07, 700.0)
    free = turn_ball(ball, GRID)
    inner, outer = free.races
    held = ball.held
    lengths = free_lengths(held.bearing)
    units = unit_under(held.bearing, "inner", inner.angle), unit_under(held.bearing, "outer", outer.angle)
    axial = sum(
        (length + unit.approach * race.load ** (2 / 3)) * np.sin(race.angle)
        for length, unit, race in zip(lengths, units, free.races, strict=True)
    )
    again = turn_ball(replace(ball, held=replace(held, axial=float(axial))), GRID)
    np.testing.assert_allclose(again.races[0].load, inner.load, rtol=2e-3)  # curvatures of slightly other angles
    np.testing.assert_allclose(again.torque, free.torque, rtol=0.01)


def test_a_hybrid_and_oil_turn_too() -> None:
    hybrid = replace(BEARING_6205, ball_material=NITRIDE, ball_mass=0.41 * BEARING_6205.ball_mass)
    dry = thrust_ball(0.05, 300.0, bearing=hybrid)
    oil = PointLaw(
        boundary=0.01, limit=0.05, eyring=5e6, fluidity=2.5e-3, share=0.9, alpha=9.0 * 0.6 * 5.1e-9, exponent=0.6
    )
    turned, oiled = turn_ball(dry, GRID), turn_ball(replace(dry, laws=(oil, oil)), GRID)
    assert 0 < oiled.torque < 1.3 * turned.torque  # at most 0.06 of the pressure
    for race in oiled.races:
        stress = np.hypot(*race.friction.traction)
        assert np.all(stress <= 0.06 * race.friction.pressure * (1 + 1e-9))


def test_other_elasticity_and_pressure_take_the_place_of_half_spaces_and_hertz() -> None:
    ball = thrust_ball(0.1, 500.0)
    plain = turn_ball(ball, ROUGH)
    same = Elasticity(
        influence=HalfSpaces(ball=STEEL, race=STEEL), pressure=lambda strips: hertz_pressure(strips, load=3.0)
    )
    again = turn_ball(replace(ball, elasticity=(same, same)), ROUGH)
    np.testing.assert_allclose(again.torque, plain.torque, rtol=1e-3)  # where slip is taken is settled so far
    stiff = replace(STEEL, youngs_modulus=3 * STEEL.youngs_modulus)
    stiffer = Elasticity(influence=HalfSpaces(ball=stiff, race=stiff))
    other = turn_ball(replace(ball, elasticity=(stiffer, stiffer)), ROUGH)
    assert abs(other.races[0].angle - other.races[1].angle) < abs(plain.races[0].angle - plain.races[1].angle)


def test_a_ball_that_one_race_does_not_touch_is_refused() -> None:
    ball = thrust_ball(0.1, 500.0)
    loose = replace(ball, held=replace(ball.held, axial=0.0))
    with pytest.raises(InputError, match="the inner race does not touch the ball: give it a load"):
        turn_ball(loose, ROUGH)


def test_a_symmetric_radial_ball_does_not_spin_and_slips_by_conformity_only() -> None:
    bearing, radial = BEARING_6205, sum(free_lengths(BEARING_6205)) + 9e-6
    held = HeldBall(bearing=bearing, centre=centre_of(bearing), thrust=0.0, radial=radial, axial=0.0)
    law = PointLaw(boundary=0.08)
    turned = turn_ball(TurningBall(held=held, laws=(law, law), speed=0.0), GRID)
    for race in turned.races:
        assert abs(race.angle) < 1e-5
        assert abs(race.spin_torque) < 1e-6 * race.torque  # settled
        assert abs(race.transverse_force) < 1e-4 * law.boundary * race.load
    assert turned.torque > 0
