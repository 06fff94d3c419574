"""The law of friction on rectangles and its fixed point."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import brentq

from analytic.oil.law_table import law_address
from analytic.oil.own_law import own_traction
from analytic.oil.traction import PointLaw, stress_and_slope
from analytic.scene import Array
from fembearing.creep.friction import settle, sliding_law

OIL = PointLaw(
    boundary=0.011, limit=0.055, eyring=5e6, fluidity=3.1e-3, share=0.9, alpha=9.2 * 0.61 * 5.1e-9, exponent=0.61
)
RISING = OIL._replace(exponent=0.0, bend=0.46e-9, rises=1.0)  # whose Eyring stress follows the pressure
PRESSURE, SPEED = np.array([1.3e9, 0.4e9, 2e7]), 0.83


CARREAU = own_traction("carreau", lambda x: x * (1 + x * x) ** ((0.46 - 1) / 2))
OWN = OIL._replace(own=law_address(CARREAU))


@given(reach=st.floats(1e3, 3e9), stiffness=st.floats(1e8, 1e14), oil=st.sampled_from([OIL, RISING, OWN]))
def test_a_point_resists_by_the_law_at_the_slip_that_is_left(reach: float, stiffness: float, oil: PointLaw) -> None:
    """T + rho s = reach with the scalar law of `analytic.oil.traction`, whose slip is a speed."""
    law = sliding_law(oil, pressure=PRESSURE, speed=SPEED)
    stress, slope = law.resist(np.full(3, reach), np.full(3, stiffness))
    for pressure, found in zip(PRESSURE, stress, strict=True):

        def left(slip: float, pressure: float = pressure) -> float:
            return stress_and_slope(oil, pressure, slip * SPEED)[0] + stiffness * slip - reach

        if left(0.0) >= 0:
            expected = reach
        else:
            slip = brentq(left, 0.0, reach / stiffness, xtol=1e-300, rtol=1e-15)
            expected = reach - stiffness * slip
        np.testing.assert_allclose(found, expected, rtol=1e-7, atol=1e-9 * reach)  # of the difference reach - rho s
    assert np.all((slope >= 0) & (slope <= 1))


@pytest.mark.parametrize("oil", [OIL, RISING, OWN])
def test_slopes_are_derivatives(oil: PointLaw) -> None:
    law = sliding_law(oil, pressure=PRESSURE, speed=SPEED)
    stiffness, reach, step = np.array([3e11, 4e10, 7e9]), np.array([5e7, 1.5e7, 6e5]), 1e-6
    slope = law.resist(reach, stiffness)[1]
    above, below = (law.resist(reach * (1 + sign * step), stiffness)[0] for sign in (1, -1))
    expected = (above - below) / (2 * step * reach)
    np.testing.assert_allclose(slope, expected, rtol=1e-5, atol=1e-9)  # round-off of 1e-16 over the step


@pytest.mark.parametrize(
    ("law", "speed", "expected"),
    [
        (PointLaw(boundary=0.07), 0.3, 0.07 * PRESSURE),
        (OIL._replace(fluidity=np.inf), 0.3, 0.066 * PRESSURE),  # no film: the oil shears at its limit
        (OIL, 0.0, 0.011 * PRESSURE),  # standing oil does not resist
        (OWN._replace(fluidity=3.1), 0.3, 0.066 * PRESSURE),
        (OWN._replace(fluidity=np.inf), 0.3, 0.066 * PRESSURE),
        (OWN, 0.0, 0.011 * PRESSURE),
        (PointLaw(boundary=0.02, plain=3e6), 0.3, 0.02 * PRESSURE + 3e6),
    ],
)
def test_the_most_that_a_law_resists(law: PointLaw, speed: float, expected: Array) -> None:
    stress, slope = sliding_law(law, pressure=PRESSURE, speed=speed).resist(np.full(3, 1e12), np.full(3, 1e11))
    np.testing.assert_allclose(stress, expected, rtol=1e-9)  # round-off of far sliding
    assert np.all(slope < 1e-6)


def test_a_fixed_point_obeys_the_law_and_follows_its_derivatives() -> None:
    random = np.random.default_rng(7)
    n = 12
    root = random.normal(size=(2 * n, 2 * n))
    matrix = (root @ root.T / n + 0.3 * np.eye(2 * n)) * 1e-11
    law = sliding_law(PointLaw(boundary=0.08), pressure=random.uniform(2e8, 1e9, n), speed=0.3)
    slip, pattern = random.normal(size=2 * n) * 2e-4, random.normal(size=(2 * n, 1))

    def solved(slip: Array):
        return settle(matrix, slip, law, stiffness=np.full(n, 4e10), patterns=pattern, start=np.zeros(2 * n))

    found = solved(slip)
    traction, left = found.traction.reshape(2, n), found.slip.reshape(2, n)
    np.testing.assert_allclose(left.ravel(), slip + matrix @ found.traction, atol=1e-16)  # round-off of 1e-4
    size, speed = np.hypot(*traction), np.hypot(*left)
    sticks = speed < 1e-9 * speed.max()
    assert 0 < sticks.sum() < n
    assert np.all(size <= law.steady * (1 + 1e-9))
    np.testing.assert_allclose(size[~sticks], law.steady[~sticks], rtol=1e-8)  # settled to 1e-10 of the largest
    opposed = np.sum(traction * left, axis=0)[~sticks] / (size * speed)[~sticks]
    np.testing.assert_allclose(opposed, -1.0, rtol=1e-8)
    step = 1e-9
    above, below = (solved(slip + sign * step * pattern[:, 0]).traction for sign in (1, -1))
    np.testing.assert_allclose(
        found.response[:, 0], (above - below) / (2 * step), atol=1e-4 * np.max(np.abs(found.response))
    )  # of tractions settled to 1e-10 over a step of 1e-5


def test_without_pressure_there_is_no_resistance() -> None:
    """Neither a share of the pressure nor a plain stress."""
    law = sliding_law(PointLaw(boundary=0.02, plain=3e6), pressure=np.array([[0.0, 2e8]]), speed=0.3)
    np.testing.assert_allclose(law.steady, [0.0, 7e6])
