"""Slip over the whole contact: tractions with an exact answer, limits of Coulomb friction, a direct sum, power."""

from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings
from scipy.special import ellipe

from analytic.contact.rolling_contact import ContactNumbers, RollingContact
from analytic.errors import ConvergenceError, InputError
from analytic.oil.traction import PointLaw
from analytic.sliding.ellipse import (
    SlipMoments,
    SlipSums,
    quadrature_of,
    slider_of,
    slip_along_axis,
    slip_over_ellipse,
    slip_sums,
)
from analytic.sliding.long_ellipse import microslip_moments
from tests.analytic.specimens import rolling_contact

MU, Q, B, R, ROLL = 0.083, 470.0, 1.27e-3, 4.05e-3, 37.0  # friction, N, m, m, rad/s
SPINS = [0.01, -0.1, 0.3, 0.49, -0.5, 0.6, 2.0]  # eps
# Of mu Q b with 16 nodes a side, measured against 48 for b/a from 0.4 to 200 and eps from 0 to 1e9: 6e-6 at worst.
QUADRATURE = 1e-5
ALL = (slip_over_ellipse, slip_along_axis)


COULOMB = PointLaw(boundary=MU)
SINH = PointLaw(limit=0.06, eyring=5e6, fluidity=1e3)  # Eyring's law, capped by a share of the pressure


def contact(k: float, **changed: Any) -> RollingContact:
    """Of the ellipticity b/a, under the load Q."""
    axes = {"semi_axis_rolling": B / k, "semi_axis_transverse": B}
    return rolling_contact(**({"load": Q, **axes, "deformed_radius": R, "rolling_rate": ROLL} | changed))


def of_long_ellipse(eps: float) -> tuple[np.ndarray, np.ndarray]:
    """Spin and rolling moment of Coulomb friction in closed form."""
    return microslip_moments(friction_force=MU * Q, semi_axis_transverse=B, deformed_radius=R, spin_to_roll=eps)


def spin_of(eps: float) -> float:
    return eps * ROLL * B / R


def scaled(found: SlipMoments) -> np.ndarray:
    return np.array([found.spin_moment / (MU * Q * B), found.rolling_moment / (MU * Q * B**2 / R)])


@pytest.mark.parametrize("k", [0.4, 1.0, 1.5, 3.0, 5.71, 9.28])
def test_full_spin_of_an_ellipse(k: float) -> None:
    """(3/8) mu Q E(m) times the longer semi-axis: 0.589 mu Q a of a circle, 1.8 % above the line at b/a = 9.28."""
    found = slip_over_ellipse(contact(k), law=COULOMB, spin_rate=spin_of(1e6))
    integral = ellipe(1 - min(k, 1 / k) ** 2) * max(1, 1 / k)
    np.testing.assert_allclose(found.spin_moment, 0.375 * MU * Q * B * integral, rtol=1e-6)
    if k == 1:
        np.testing.assert_allclose(found.spin_moment / (MU * Q * B), 0.589, atol=0.5e-3)
    above = {1.5: (0.32, 0.005), 3.0: (0.11, 0.005), 5.71: (0.041, 0.0005), 9.28: (0.018, 0.0005)}  # two digits
    if k in above:
        np.testing.assert_allclose(found.spin_moment / (0.375 * MU * Q * B) - 1, above[k][0], atol=above[k][1])


@pytest.mark.parametrize("eps", [0.0, *SPINS])
def test_a_long_ellipse_is_a_line(eps: float) -> None:
    expected = of_long_ellipse(eps) / np.array([MU * Q * B, MU * Q * B**2 / R])
    moments = (
        slip_over_ellipse(contact(k), law=COULOMB, spin_rate=spin_of(eps), nodes=(32, 32)) for k in (1e2, 1e3, 1e4)
    )
    gaps = [np.abs(scaled(each) - expected) for each in moments]
    np.testing.assert_allclose(gaps[2], 0, atol=3e-5)  # falls with a/b where a line of pure rolling nears the end
    assert np.all(gaps[2] <= gaps[0] + QUADRATURE)


@pytest.mark.parametrize("k", [0.7, 9.28])
@given(eps=st.floats(-3, 3))
@settings(max_examples=25)
def test_along_the_axis_coulomb_friction_is_that_of_a_long_ellipse(k: float, eps: float) -> None:
    """The panels meet where the slip changes its direction, so the quadrature meets no kink."""
    found = slip_along_axis(contact(k), law=COULOMB, spin_rate=spin_of(eps))
    expected = of_long_ellipse(eps)
    np.testing.assert_allclose(found.spin_moment, expected[0], rtol=0, atol=1e-9 * MU * Q * B)
    np.testing.assert_allclose(found.rolling_moment, expected[1], rtol=0, atol=1e-9 * MU * Q * B**2 / R)


@pytest.mark.parametrize(("k", "eps"), [(1.3, 0.3), (5.71, -0.1), (9.28, 0.45)])
def test_a_direct_sum_over_the_ellipse_agrees(k: float, eps: float) -> None:
    """Midpoints of two million cells of the rectangle around the contact, at the computed c."""
    spin, a = spin_of(eps), B / k
    found = slip_over_ellipse(contact(k), law=COULOMB, spin_rate=spin, nodes=(32, 32))
    x, y = (np.arange(count) * 2.0 / count - 1 + 1 / count for count in (1000, 2000))
    x, y = a * x, B * y[:, None]
    inside = np.maximum(0, 1 - (x / a) ** 2 - (y / B) ** 2)
    friction = MU * 1.5 * Q / (np.pi * a * B) * np.sqrt(inside) * (2 * a / 1000) * (2 * B / 2000)
    v_x, v_y = ROLL * y**2 / (2 * R) + spin * y - found.creep_speed, -spin * x
    speed = np.hypot(v_x, v_y)
    close = 2e-5 * MU * Q  # of the midpoints across the pressure's steep rim and the points where nothing slides
    np.testing.assert_allclose(np.sum(friction * v_x / speed), 0, atol=close)
    np.testing.assert_allclose(found.spin_moment, np.sum(friction * (v_x * y - v_y * x) / speed), atol=close * B)
    rolling = np.sum(friction * v_x * y**2 / (2 * R) / speed)
    np.testing.assert_allclose(found.rolling_moment, rolling, atol=close * B**2 / R)
    np.testing.assert_allclose(found.slip_power, np.sum(friction * speed), rtol=1e-4)


@pytest.mark.parametrize(("k", "eps"), [(1.3, 0.0), (0.6, 0.2), (9.28, -0.7)])
def test_a_newtonian_film_has_moments_in_closed_form(k: float, eps: float) -> None:
    """tau = g v over the area A: c = w_roll b^2/(8 R), M_s = g w_s A (a^2 + b^2)/4, M_r = g A w_roll b^4/(64 R^2).

    An Eyring stress far above all stresses leaves tau/(g v) = 1 - (v/(5 km/s))^2/6.
    """
    g, spin, a = 3.1e7, spin_of(eps), B / k
    area = np.pi * a * B
    for slip, polar in ((slip_over_ellipse, a**2 + B**2), (slip_along_axis, B**2)):
        film = PointLaw(limit=1e9, eyring=g * 5e3, fluidity=1 / 5e3)
        found = slip(contact(k), law=film, spin_rate=spin)
        np.testing.assert_allclose(found.creep_speed, ROLL * B**2 / (8 * R), rtol=1e-8)  # quadrature of the rim
        np.testing.assert_allclose(found.spin_moment, g * spin * area * polar / 4, rtol=1e-8)
        np.testing.assert_allclose(found.rolling_moment, g * area * ROLL * B**4 / (64 * R**2), rtol=1e-8)


def test_a_constant_stress_in_full_spin() -> None:
    """tau times the area's first polar moment, 2 pi tau a^3/3 for a circle; a wrong pressure or arm would show."""
    found = slip_over_ellipse(
        contact(1.0, rolling_rate=0.0),
        law=PointLaw(plain=5e6),
        spin_rate=23.0,
    )
    np.testing.assert_allclose(found.spin_moment, 2 / 3 * np.pi * 5e6 * B**3, rtol=1e-6)
    np.testing.assert_allclose(found.creep_speed, 0, atol=1e-12)
    np.testing.assert_allclose(found.rolling_moment, 0, atol=1e-12)


@pytest.mark.parametrize("law", [COULOMB, SINH])
@pytest.mark.parametrize("slip", ALL)
@pytest.mark.parametrize("k", [1.3, 9.28])
def test_the_power_is_that_of_the_moments(slip, law: PointLaw, k: float) -> None:
    spin = np.array([spin_of(eps) for eps in (0.0, *SPINS)])
    found = slip(contact(k), law=law, spin_rate=spin)
    done = found.spin_moment * spin + found.rolling_moment * ROLL
    np.testing.assert_allclose(found.slip_power, done, rtol=1e-12)  # the same nodes; c leaves 1e-14 of force
    assert np.all(found.spin_moment * spin >= 0)


@pytest.mark.parametrize("slip", ALL)
@pytest.mark.parametrize("eps", [0.1, 0.3, -0.45])
def test_the_moments_are_the_slopes_of_the_power(slip, eps: float) -> None:
    """Coulomb friction does not depend on speed: the power's slope by spin is M_spin, and by rolling M_roll."""
    step = 1e-4

    def power(spin: float, roll: float) -> float:
        moments = slip(contact(3.0, rolling_rate=roll), law=COULOMB, spin_rate=spin, nodes=(32, 32))
        return float(moments.slip_power)

    spin = spin_of(eps)
    found = slip(contact(3.0), law=COULOMB, spin_rate=spin, nodes=(32, 32))
    slope = (power(spin + step * ROLL, ROLL) - power(spin - step * ROLL, ROLL)) / (2 * step * ROLL)
    np.testing.assert_allclose(found.spin_moment, slope, rtol=1e-4)  # the step squared, and quadrature over the step
    slope = (power(spin, ROLL * (1 + step)) - power(spin, ROLL * (1 - step))) / (2 * step * ROLL)
    np.testing.assert_allclose(found.rolling_moment, slope, rtol=1e-4)


@pytest.mark.parametrize("k", [0.4, 1.5, 9.28])
def test_more_nodes_converge_and_the_default_is_enough(k: float) -> None:
    spin = np.array([spin_of(eps) for eps in (0.0, *SPINS)])
    results = [
        scaled(slip_over_ellipse(contact(k), law=COULOMB, spin_rate=spin, nodes=(nodes, nodes)))
        for nodes in (8, 16, 32, 48)
    ]
    coarse, default, fine = (np.abs(result - results[-1]).max() for result in results[:-1])
    assert default < QUADRATURE
    assert fine < default / 10 < coarse


def test_the_spin_moment_is_odd_and_the_rolling_moment_even() -> None:
    for slip in ALL:
        there, back = (slip(contact(3.0), law=SINH, spin_rate=sign * spin_of(0.2)) for sign in (1, -1))
        assert there.spin_moment == -back.spin_moment > 0
        assert there.rolling_moment == back.rolling_moment > 0


def test_a_contact_that_neither_rolls_nor_spins_has_no_friction() -> None:
    for slip in ALL:
        found = slip(contact(3.0, rolling_rate=0.0), law=COULOMB, spin_rate=0.0)
        assert (
            found.spin_moment == found.rolling_moment == found.slip_power == found.unit_power == found.creep_speed == 0
        )
        unloaded = slip(contact(3.0, load=0.0), law=COULOMB, spin_rate=2.0)
        assert unloaded.spin_moment == unloaded.rolling_moment == unloaded.slip_power == 0


def test_points_broadcast_and_the_traction_may_have_numbers_of_its_own() -> None:
    mu = np.array([0.03, 0.11])
    spin = np.array([[0.0], [spin_of(0.2)], [spin_of(1.7)]])
    table = slip_over_ellipse(
        contact(3.0, rolling_rate=np.array([ROLL, 1.1 * ROLL])),
        law=PointLaw(boundary=mu),
        spin_rate=spin,
    )
    assert table.spin_moment.shape == table.creep_speed.shape == (3, 2)
    for i, j in np.ndindex(3, 2):
        alone = slip_over_ellipse(
            contact(3.0, rolling_rate=ROLL * (1.0, 1.1)[j]),
            law=PointLaw(boundary=mu[j]),
            spin_rate=spin[i, 0],
        )
        for name, values in vars(table).items():
            assert values[i, j] == getattr(alone, name)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"load": -1.0}, "load must be at least 0"),
        ({"semi_axis_rolling": 0.0}, "semi_axis_rolling must be positive"),
        ({"rolling_rate": -2.0}, "rolling_rate must be at least 0"),
        ({"spin_rate": np.nan}, "spin_rate must be finite"),
        ({"nodes": (0, 7)}, "nodes must be positive"),
        ({"load": np.ones(3), "spin_rate": np.ones(2)}, "give equal lengths"),
    ],
)
def test_nonsense_is_refused(changed: dict[str, Any], message: str) -> None:
    of_contact = {name: value for name, value in changed.items() if name not in ("spin_rate", "nodes")}
    of_slip: dict[str, Any] = {"spin_rate": 2.0} | {name: changed[name] for name in changed.keys() - of_contact.keys()}
    for slip in ALL:
        with pytest.raises(InputError, match=message):
            slip(contact(3.0, **of_contact), law=COULOMB, **of_slip)


@pytest.mark.parametrize("law", [COULOMB, SINH])
@pytest.mark.parametrize("k", [1.3, 9.28])
def test_the_forceless_creep_takes_few_sums(law: PointLaw, k: float) -> None:
    """Newton's slopes double the digits each time; halving the bracket alone would take fifty."""
    for slip in ALL:
        found = slip(contact(k), law=law, spin_rate=np.array([spin_of(eps) for eps in (0.0, 1e-9, 1e-4, *SPINS)]))
        assert found.sums.max() <= 12


def test_a_law_that_is_not_a_number_does_not_converge() -> None:
    with pytest.raises(ConvergenceError, match="traction is finite"):
        slip_over_ellipse(contact(3.0), law=PointLaw(boundary=np.nan), spin_rate=2.0)


@pytest.mark.parametrize("law", [COULOMB, PointLaw(boundary=0.03, limit=1e3, eyring=5e6, fluidity=1e3)])
@pytest.mark.parametrize("sideways", [False, True])
def test_the_slopes_of_the_sums_are_their_differences(law: PointLaw, sideways: bool) -> None:
    """Newton's slopes, with the jump of the stress where slip along one axis turns round."""
    slider, spin, nodes = (
        slider_of(ContactNumbers(Q, B / 3, B, 0.0, 0.0, 0.0, R, ROLL, 0.0)),
        0.7,
        quadrature_of((48, 48)),
    )
    creep = 0.4 * slider.roll
    step = 1e-5 * slider.roll

    def sums(c: float, w: float) -> SlipSums:
        return slip_sums(slider, law, c, w, nodes, sideways)

    at, close = sums(creep, spin), 2e-3  # of the nodes near the line where the slip turns round
    by_creep = [(a - b) / (2 * step) for a, b in zip(sums(creep + step, spin), sums(creep - step, spin), strict=True)]
    by_spin = [(a - b) / (2 * step) for a, b in zip(sums(creep, spin + step), sums(creep, spin - step), strict=True)]
    np.testing.assert_allclose([at.by_creep, at.mixed], [-by_creep[0], by_spin[0]], rtol=close)
    np.testing.assert_allclose([at.mixed, at.by_spin], [-by_creep[1], by_spin[1]], rtol=close)
