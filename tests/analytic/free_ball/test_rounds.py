"""Loads and rotation of free balls by a general root finder, the secant of their rounds, the stress of a point."""

import numpy as np
import pytest
from scipy.optimize import brentq, root

from analytic.contact.factors import FactorNumbers
from analytic.free_ball import kernel, turning
from analytic.free_ball.rotation import quadratures_of
from analytic.free_ball.stress import Shear, sheared
from analytic.loads.numbers import bearing_numbers
from analytic.loads.race_contacts import unit_contact_on
from analytic.loads.state import ball_states
from analytic.numerics.records import as_record
from analytic.scene import Array, Bearing, ContactAngle
from tests.analytic.free_ball.specimens import FINE, angular_contact, under_thrust
from tests.analytic.specimens import BEARING_6205

RACES = (-1.0, 1.0)  # which way the contact's normal points out of the ball, radially
AS_HERTZ = FactorNumbers(1.0, 1.0, 1.0, np.nan)


@pytest.mark.parametrize(
    ("bearing", "free_angle", "running"),
    [
        (BEARING_6205, 0.18, (130.0, 1430.0, 0.06)),
        (BEARING_6205, 0.18, (21.0, 2900.0, 0.05)),  # the outer race carries ten times as much as the inner one
        (angular_contact(), None, (480.0, 610.0, 0.11)),
    ],
)
def test_a_root_finder_settles_loads_and_rotation_at_the_same_place(
    bearing: Bearing, free_angle: float | None, running: tuple[float, float, float]
) -> None:
    """All eight unknowns of a ball under thrust at once: two angles, two loads and four speeds."""
    load, speed, friction = running
    balls = under_thrust(bearing, free_angle, load=load, speed=speed, friction=friction, creep="closed")
    numbers = bearing_numbers(bearing, ContactAngle(rule="solved", free=free_angle))
    nodes, contacts, ball = (
        as_record(quadratures_of("closed")[FINE]),
        balls.work.contacts[0],
        as_record(balls.work.balls[0]),
    )
    passing = np.array([kernel._passing(as_record(contacts[race]), ball, ball.velocity) for race in range(2)])
    flows = np.zeros((2, nodes.strips, 2, nodes.nodes))  # Coulomb friction has none
    found = np.array([*balls.angle, *balls.load, *ball.velocity])
    scale = np.array([1.0, 1.0, *balls.load, *np.full(4, np.abs(found[4:]).max())])

    # The grooves' centres lie about the pitch circle, and farther out by half of what the inner groove is wider.
    middle = bearing.pitch_diameter / 2 + (bearing.inner.groove_radius - bearing.outer.groove_radius) / 2
    between = numbers.groove_centre_distance - numbers.play

    def lacks(unknown: Array) -> Array:
        angle, loads, velocity = (unknown * scale)[:2], (unknown * scale)[2:4], (unknown * scale)[4:]
        reach, outer_reach = -numbers.groove_centre_distance + numbers.play, 0.0
        for race, side in enumerate(RACES):
            groove = numbers.inner if race == 0 else numbers.outer
            unit, contact = unit_contact_on(groove, angle[race], AS_HERTZ), contacts[race]
            contact["load"] = loads[race]
            contact["semi_axis_rolling"] = unit.semi_axis_x * np.cbrt(loads[race])
            contact["semi_axis_transverse"] = unit.semi_axis_y * np.cbrt(loads[race])
            contact["normal_radial"], contact["normal_axial"] = side * np.cos(angle[race]), side * np.sin(angle[race])
            outer_reach = groove.groove_radius - numbers.ball_radius + unit.approach * np.cbrt(loads[race]) ** 2
            reach += outer_reach * np.cos(angle[race])
        orbit = middle - between / 2 + outer_reach * np.cos(angle[1])
        ball.orbit_radius, ball.inertia = orbit, 0.4 * bearing.ball_mass * speed**2
        force = np.zeros(4)
        kernel._residual(contacts, ball, velocity, passing, nodes, flows, (force, np.zeros((4, 4)), np.zeros((3, 4))))
        across, push = contacts["across"], load / bearing.ball_count
        centrifugal = bearing.ball_mass * orbit * (velocity[0] / orbit * speed) ** 2
        axial = loads * np.sin(angle) - across * np.cos(angle) - push
        radial = loads * np.cos(angle) + across * np.sin(angle)
        outward = radial[1] - radial[0] - centrifugal
        return np.array([*axial / push, outward / push, *force / push, reach / numbers.groove_centre_distance])

    begin = found / scale * (1 + 1e-4 * np.array([3, -2, 5, -7, 0.1, 2, -1, 0.3]))
    solved = root(lacks, begin, tol=1e-13).x * scale
    # The last round changes angles by 1e-6 at most, those that were not made by a few times as much; sin(al) is 0.03.
    np.testing.assert_allclose(found[:2], solved[:2], atol=1e-5)
    np.testing.assert_allclose(found[2:4], solved[2:4], rtol=1e-4)
    np.testing.assert_allclose(found[4:], solved[4:], atol=1e-5 * np.abs(solved[4:]).max())


@pytest.mark.parametrize("slope", [-0.4, -1.7, -3.0, 0.6])
def test_forces_that_swing_from_round_to_round_settle_by_a_secant(slope: float) -> None:
    """Forces that come of a round are c + slope (those it had): plain rounds diverge from a slope of -1 on."""
    ball, constant = as_record(ball_states(1)[0]), np.array([9.2, -0.013, 0.31])
    ball.given, ball.gave, ball.left = np.array([4.0, 0.002, -0.05]), np.nan, np.nan
    for _ in range(5):
        came = constant + slope * ball.given
        turning._mix(ball, (came[0], came[1], came[2]))
    np.testing.assert_allclose(ball.given, constant / (1 - slope), rtol=1e-9)


def test_the_stress_of_a_creeping_point_by_a_bracketing_search() -> None:
    """g + compliance T(g) = reach, T(g) = steady + min(eyring asinh(fluidity g), limit); and its slope by reach."""
    random = np.random.default_rng(5)
    sticks = flows = yields = 0
    for _ in range(400):
        steady, limit, eyring = 10 ** random.uniform(4, 8), 10 ** random.uniform(5, 8), 10 ** random.uniform(6, 7)
        fluidity, compliance = 10 ** random.uniform(-1, 30), 10 ** random.uniform(-18, -12)
        reach = compliance * (steady + limit) * 10 ** random.uniform(-3, 1)
        stress, slope = sheared(
            reach, compliance, Shear(steady, limit, eyring, fluidity, np.sinh(limit / eyring) / fluidity)
        )

        def slips(flowing: float, reach=reach, compliance=compliance, steady=steady, eyring=eyring, fluidity=fluidity):
            """What is left of the reach at this stress of the oil."""
            return reach - compliance * (steady + flowing) - np.sinh(flowing / eyring) / fluidity

        if reach <= compliance * steady:
            sticks += 1
            expected, rise = reach / compliance, 1 / compliance
        elif slips(limit) >= 0:
            yields += 1
            expected, rise = steady + limit, 0.0
        else:
            flows += 1
            oil = brentq(slips, 0.0, limit, xtol=1e-300, rtol=1e-15)
            expected, rise = steady + oil, 1 / (compliance + np.cosh(oil / eyring) / (eyring * fluidity))
        assert stress == pytest.approx(expected, rel=1e-12)  # of the search
        assert slope == pytest.approx(rise, rel=1e-6)  # it is for Newton's method
    assert min(sticks, flows, yields) > 30
