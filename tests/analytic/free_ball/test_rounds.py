"""Balance of free balls, the stress of a point, their flexibility and their motion."""

import numpy as np
import pytest
from scipy.optimize import brentq

from analytic.contact.factors import AS_HERTZ
from analytic.free_ball import turning
from analytic.free_ball.stress import Shear, flow_at, sheared, yielding
from analytic.loads.numbers import bearing_numbers
from analytic.loads.race_contacts import unit_contact_on
from analytic.loads.thrust import thrust_equilibrium
from analytic.oil.traction import PointLaw
from analytic.scene import Bearing, ContactAngle
from tests.analytic.free_ball.specimens import angular_contact, under_thrust
from tests.analytic.specimens import BEARING_6205, loaded_contacts


@pytest.mark.parametrize(
    ("bearing", "free_angle", "running"),
    [
        (BEARING_6205, 0.18, (130.0, 1430.0, 0.06)),
        (BEARING_6205, 0.18, (21.0, 2900.0, 0.05)),  # the outer race carries ten times as much as the inner one
        (angular_contact(), None, (480.0, 610.0, 0.11)),
    ],
)
def test_loads_angles_and_friction_of_a_free_ball_balance(
    bearing: Bearing, free_angle: float | None, running: tuple[float, float, float]
) -> None:
    """Under thrust and centrifugal force, where both deformed contacts lie between the grooves' centres."""
    load, speed, friction = running
    balls = under_thrust(bearing, free_angle, load=load, speed=speed, friction=friction)
    numbers = bearing_numbers(bearing, ContactAngle(rule="solved", free=free_angle))
    (inner, outer), orbit = balls.work.contacts[0], balls.work.balls[0]["orbit_radius"]
    assert inner["along"] == pytest.approx(-outer["along"], abs=1e-6 * friction * balls.load.min())  # settled to 1e-7
    across = np.array([inner["across"], outer["across"]])
    axial = balls.load * np.sin(balls.angle) - across * np.cos(balls.angle)
    radial = balls.load * np.cos(balls.angle) + across * np.sin(balls.angle)
    # The last round changes angles by 1e-6 at most, those that were not made by a few times as much; sin(al) is 0.03.
    assert axial == pytest.approx(load / bearing.ball_count, rel=2e-4)
    rate = balls.work.balls[0]["velocity"][0] / orbit * speed
    assert radial[1] - radial[0] == pytest.approx(bearing.ball_mass * orbit * rate**2, rel=2e-4)
    grooves = zip((numbers.inner, numbers.outer), balls.angle, balls.load, strict=True)
    reach = [
        (groove.groove_radius - numbers.ball_radius + unit_contact_on(groove, angle, AS_HERTZ).approach * q ** (2 / 3))
        * np.cos(angle)
        for groove, angle, q in grooves
    ]
    assert sum(reach) == pytest.approx(numbers.groove_centre_distance - numbers.play, rel=2e-6)
    # The grooves' centres lie about the pitch circle, and farther out by half of what the inner groove is wider.
    middle = bearing.pitch_diameter / 2 + (bearing.inner.groove_radius - bearing.outer.groove_radius) / 2
    between = numbers.groove_centre_distance - numbers.play
    assert orbit == pytest.approx(middle - between / 2 + reach[1], rel=1e-6)


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


def test_oil_that_slides_has_the_slope_of_its_stress_and_none_at_its_limit() -> None:
    shear = Shear(3.1e5, 1.9e7, 4.7e6, 2.3e4, float(np.sinh(1.9 / 0.47)) / 2.3e4)
    for slip in (1e-7, 3e-5, 0.9999 * shear.most):
        found, slope = yielding(slip, shear)
        assert found == pytest.approx(3.1e5 + 4.7e6 * np.arcsinh(2.3e4 * slip), rel=1e-12)
        step = 1e-4 * slip
        ends = [yielding(slip + side * step, shear)[0] for side in (-1, 1)]
        assert slope == pytest.approx((ends[1] - ends[0]) / (2 * step), rel=1e-6)
    assert yielding(shear.most, shear) == yielding(7 * shear.most, shear) == (3.1e5 + 1.9e7, 0.0)


def test_oil_flows_up_to_the_slip_at_which_it_shears_at_its_limit() -> None:
    """Thickened by the pressure in it; solid oil, and a law without an Eyring stress, shear at their limit at once."""
    law = PointLaw(
        boundary=0.02, limit=0.05, eyring=4.7e6, fluidity=3e3, share=0.9, alpha=7.0 * 0.6 * 5.1e-9, exponent=0.6
    )
    pressure = 0.31e9
    eyring, fluidity, most = flow_at(law, pressure)
    assert eyring == 4.7e6
    thicker = np.exp(7.0 * ((1 + 5.1e-9 * 0.9 * pressure) ** 0.6 - 1))
    assert fluidity == pytest.approx(3e3 * thicker, rel=1e-9)
    assert 4.7e6 * np.arcsinh(fluidity * most) == pytest.approx(0.05 * pressure, rel=1e-9)
    for changed in ({"eyring": 0.0}, {"fluidity": np.inf}, {"fluidity": 2e250}, {"fluidity": 1e248}):
        assert flow_at(law._replace(**changed), pressure)[1:] == (0.0, 0.0)
    assert flow_at(law._replace(fluidity=1e248 / thicker), pressure)[1] == pytest.approx(1e248, rel=1e-6)
    rising = law._replace(exponent=0.0, bend=0.31e-9, rises=1.0)
    rise = 1 + 0.31e-9 * 0.9 * pressure  # of the modulus A + B p
    assert flow_at(rising, pressure)[0] == pytest.approx(4.7e6 * rise, rel=1e-12)
    assert flow_at(rising, pressure)[1] == pytest.approx(
        3e3 / rise * np.exp(7.0 * 0.6 * 5.1e-9 * 0.9 * pressure / rise), rel=1e-12
    )


@pytest.mark.parametrize(("creeps", "along"), [(True, 1.35), (False, 1.35e-3)])
def test_the_flexibility_is_that_of_a_6205_by_another_program(creeps: bool, along: float) -> None:
    """s_c/u = L p0 mu/a is 0.0020845 inside and 0.0018872 outside, under 1000 N at 0.18 rad and mu = 0.1.

    Fitted factors multiply it along and across; surfaces without creep are a thousand times as stiff.
    """
    ball = thrust_equilibrium(BEARING_6205, ContactAngle(rule="given", value=0.18), axial_load=1000.0)
    peak = np.array([contact.peak_pressure for contact in loaded_contacts(ball)])
    found = turning.free_numbers(BEARING_6205, orbit=0.02, creeps=creeps, inertia=(True, False))
    np.testing.assert_allclose(np.array(found.flexibility) * peak * 0.1 / along, [0.0020845, 0.0018872], rtol=2e-4)
    assert found.lean == pytest.approx(0.8 / 1.35, rel=1e-12)
    assert (found.orbit, found.centrifugal, found.gyroscopic) == (0.02, True, False)


def test_the_motion_of_a_ball_is_that_of_its_vectors() -> None:
    """Surfaces of ball and rings at both contacts, relative to the orbit; radial, along the orbit, and axial."""
    radius, orbit, angles = 4.1e-3, 0.0203, (0.41, 0.23)
    velocity = np.array([8.1e-3, 3.7e-4, 1.9e-3, -7.7e-3])
    found = turning.free_motion(radius, angles, orbit, velocity)
    rate = velocity[0] / orbit
    turns = np.array([velocity[2], velocity[1], velocity[3]]) / radius - [0, 0, rate]
    assert found.cage_speed == pytest.approx(rate, rel=1e-12)
    assert found.ball_speed == pytest.approx(np.linalg.norm(turns), rel=1e-12)
    np.testing.assert_allclose(np.tan(found.pitch), turns[0] / -turns[2], rtol=1e-12)
    spins = []
    for angle, side, ring, name in ((angles[0], -1, 1.0 - rate, "inner"), (angles[1], 1, -rate, "outer")):
        normal = side * np.array([np.cos(angle), 0.0, np.sin(angle)])
        place = np.array([orbit, 0.0, 0.0]) + radius * normal
        of_ball, of_ring = np.cross(turns, radius * normal), np.cross([0.0, 0.0, ring], place)
        along = np.array([0.0, 1.0, 0.0])
        past = turns - [0.0, 0.0, ring]
        assert getattr(found, f"{name}_radius") == pytest.approx(place[0], rel=1e-12)
        assert getattr(found, f"{name}_entrainment") == pytest.approx(abs((of_ball + of_ring) @ along) / 2, rel=1e-12)
        assert getattr(found, f"{name}_rolling_rate") == pytest.approx(abs(past @ np.cross(along, normal)), rel=1e-12)
        spins.append(past @ normal)
    assert found.spin_difference == pytest.approx(abs(spins[0] + spins[1]), rel=1e-12)
