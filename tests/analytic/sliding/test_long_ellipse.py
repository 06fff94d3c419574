"""Micro-slip against quadrature of the sliding itself."""

from itertools import pairwise
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import example, given
from scipy.integrate import quad
from scipy.optimize import brentq, minimize_scalar

from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.kinematics import ball_kinematics
from analytic.oil.traction import PointLaw
from analytic.scene import Bearing, ContactAngle, SpinRule
from analytic.sliding.long_ellipse import (
    MicroslipTorque,
    line_slip,
    microslip_moments,
    microslip_torque,
    pure_rolling_lines,
)
from tests.analytic.specimens import contacts_under_thrust, rolling_contact

MU, Q, B, R, ROLL = 0.083, 470.0, 1.27e-3, 4.05e-3, 37.0  # friction, N, m, m, rad/s
RATIOS = [0.0, 0.05, -0.2, 0.31, 0.45, -0.4999, 0.5, 0.63, -1.7]  # eps
RULES: list[SpinRule] = ["balanced", "inner_control", "outer_control"]


def moments(eps: float) -> np.ndarray:
    return np.array(
        microslip_moments(friction_force=MU * Q, semi_axis_transverse=B, deformed_radius=R, spin_to_roll=eps)
    )


def integral(weight: np.polynomial.Polynomial, slip: np.polynomial.Polynomial, half_length: float) -> float:
    """Of weight(y) sign(slip(y)) over the line load 3/4 (1 - y^2) of a contact from -1 to 1."""
    roots = slip.roots()
    turns = [root.real for root in roots if abs(root.imag) < 1e-12 and abs(root.real) < 1]
    edges = [-1.0, *sorted(turns), 1.0]
    parts = [
        np.sign(slip((low + high) / 2))
        * quad(lambda y: 0.75 * (1 - y**2) * weight(half_length * y), low, high, epsabs=1e-16)[0]
        for low, high in pairwise(edges)
    ]
    return float(sum(parts))


def slid(*, force: float, b: float, radius: float, roll: float, spin: float) -> tuple[float, float, float]:
    """(spin moment, rolling moment, slip power) by quadrature, c by bisection on the net force; for roll > 0."""
    curved = np.polynomial.Polynomial([0.0, spin * b, roll * b**2 / (2 * radius)])  # v + c over y/b
    one, arm, sag = (np.polynomial.Polynomial(c) for c in ([1.0], [0.0, 1.0], [0.0, 0.0, 1 / (2 * radius)]))
    heights = curved(np.linspace(-1, 1, 1001))
    c = brentq(lambda c: integral(one, curved - c, b), heights.min() - 1e-9, heights.max(), xtol=1e-20, rtol=1e-15)
    slip = curved - c
    in_metres = np.polynomial.Polynomial([-c, spin, roll / (2 * radius)])
    spin_moment, rolling_moment, power = (force * integral(weight, slip, b) for weight in (arm, sag, in_metres))
    return spin_moment, rolling_moment, power


@pytest.mark.parametrize("eps", RATIOS)
def test_moments_are_those_of_the_sliding(eps: float) -> None:
    spin = eps * ROLL * B / R
    expected = slid(force=MU * Q, b=B, radius=R, roll=ROLL, spin=spin)
    found = moments(eps)
    # The line of slip comes from bisection to round-off of c; its share of the moments is of that order.
    np.testing.assert_allclose(found, expected[:2], rtol=1e-9, atol=1e-12 * MU * Q * B)
    np.testing.assert_allclose(found @ (spin, ROLL), expected[2], rtol=1e-9)


@given(eps=st.floats(-3, 3))
@example(eps=0.0)
@example(eps=0.5)
@example(eps=-np.nextafter(0.5, 0))
def test_the_lines_of_pure_rolling_leave_no_force(eps: float) -> None:
    first, second = pure_rolling_lines(eps)
    assert first <= second
    np.testing.assert_allclose(first + second, -2 * eps, rtol=1e-15, atol=1e-15)  # round-off

    def below(line: float) -> float:
        y = np.clip(line, -1, 1)
        return float(y - y**3 / 3)

    np.testing.assert_allclose(below(second) - below(first), 2 / 3, rtol=1e-14)  # round-off


@pytest.mark.parametrize("spin", [-0.47, -0.013, 0.0, 0.021, 0.31])
def test_the_slope_of_a_spin_moment_is_its_derivative(spin: float) -> None:
    """By central differences on both sides of 1/2 in spin_to_roll; the oil shears harder at a higher speed."""
    contact = ContactNumbers(Q, 0.13e-3, B, 310.0, 14.7, 1.1e11, R, 2.9, 8.3e-3)
    law = PointLaw(boundary=0.021, eyring=5.3e6, fluidity=0.061, share=0.8, alpha=9.1 * 0.62 * 5.1e-9, exponent=0.62)
    step = 1e-5 * (abs(spin) or 1e-3)
    (_, slope), (beyond, _), (before, _) = (line_slip(contact, law, 21.0, spin + d) for d in (0.0, step, -step))
    assert slope == pytest.approx(
        (beyond.spin_moment - before.spin_moment) / (2 * step), rel=1e-6 if spin else 1e-4
    )  # without spin of the four digits of its stiffness


def both_contacts(bearing: Bearing, *, angle: float) -> tuple[ContactNumbers, ContactNumbers]:
    """Inner and outer race of the 6205 at a given angle under 1000 N."""
    return contacts_under_thrust(bearing, ContactAngle(rule="given", value=angle), 1000.0)


def torque(
    contacts: tuple[ContactNumbers, ContactNumbers], mu: tuple[Any, Any], spin: Any, rule: SpinRule = "balanced"
) -> MicroslipTorque:
    forces = mu[0] * contacts[0].load, mu[1] * contacts[1].load
    return microslip_torque(contacts, friction_force=forces, spin_difference=spin, spin_rule=rule)


def slip_power(contact: ContactNumbers, mu: float, *, roll: float, spin: float) -> float:
    """By quadrature, W; a contact that rolls and spins in the opposite direction loses the same."""
    direction = np.sign(roll)
    _, _, power = slid(
        force=mu * float(contact.load),
        b=float(contact.semi_axis_transverse),
        radius=float(contact.deformed_radius),
        roll=direction * roll,
        spin=direction * spin,
    )
    return power


@pytest.mark.parametrize("rule", RULES)
@pytest.mark.parametrize(("inner_speed", "outer_speed"), [(52.4, 0.0), (-31.0, 0.0), (0.0, 52.4), (23.0, -41.0)])
@pytest.mark.parametrize(("angle", "mu"), [(0.18, (0.1, 0.07)), (0.47, (0.03, 0.11))])
def test_torque_times_speed_is_the_slip_power(
    bearing_6205: Bearing, rule: SpinRule, inner_speed: float, outer_speed: float, angle: float, mu: tuple[float, float]
) -> None:
    """For either ring and either direction: at the rates of the true speeds, from the sliding itself."""
    inner, outer = both_contacts(bearing_6205, angle=angle)
    found = torque((inner, outer), mu, np.sin(angle), rule)
    speed = inner_speed - outer_speed  # rates are those of the difference
    motion = ball_kinematics(speed, angle, angle, bearing_6205.pitch_diameter, bearing_6205.ball_diameter)
    spins = found.inner_spin_rate * speed, found.outer_spin_rate * speed
    np.testing.assert_allclose(spins[0] - spins[1], motion.spin_difference, rtol=1e-14)  # round-off
    power = slip_power(inner, mu[0], roll=float(motion.inner_rolling_rate), spin=float(spins[0]))
    power += slip_power(outer, mu[1], roll=float(motion.outer_rolling_rate), spin=float(spins[1]))
    np.testing.assert_allclose((found.spin + found.conformity) * abs(speed), power, rtol=1e-9)  # quadrature


@pytest.mark.parametrize(("angle", "mu"), [(0.18, (0.1, 0.07)), (0.47, (0.03, 0.11)), (0.9, (0.11, 0.02))])
def test_the_balanced_spin_leaves_no_moment_and_loses_least(
    bearing_6205: Bearing, angle: float, mu: tuple[float, float]
) -> None:
    inner, outer = both_contacts(bearing_6205, angle=angle)
    found = torque((inner, outer), mu, np.sin(angle))
    np.testing.assert_allclose(found.inner_spin_moment, -found.outer_spin_moment, rtol=1e-12)  # round-off of the share
    np.testing.assert_allclose(found.spin, found.inner_spin_moment * np.sin(angle), rtol=1e-12)  # equation 10

    def power(share: float) -> float:
        spin = np.sin(angle)
        lost = slip_power(inner, mu[0], roll=float(inner.rolling_rate), spin=share * spin)
        return lost + slip_power(outer, mu[1], roll=float(outer.rolling_rate), spin=(share - 1) * spin)

    least = minimize_scalar(power, bounds=(0, 1), method="bounded", options={"xatol": 1e-6})
    # The search stops within 1e-6 of the minimum, where the power is flat to 1e-12.
    np.testing.assert_allclose(found.spin + found.conformity, least.fun, rtol=1e-9)
    share = found.inner_spin_rate / np.sin(angle)
    np.testing.assert_allclose(share, least.x, atol=1e-4)  # a flat minimum is found to the root of its value


SIZES = st.one_of(st.just(0.0), st.floats(1e-9, 10.0))


@given(
    mu=st.tuples(SIZES, SIZES),
    load=st.tuples(SIZES, SIZES).map(lambda pair: (1e4 * pair[0], 1e4 * pair[1])),
    b=st.tuples(SIZES, SIZES).map(lambda pair: (1e-2 * pair[0], 1e-2 * pair[1])),
    spin=st.one_of(st.just(0.0), st.floats(1e-12, 1.0)),
)
@example(mu=(0.0, 0.0), load=(0.0, 0.0), b=(0.0, 0.0), spin=0.0)
@example(mu=(0.1, 0.1), load=(500.0, 500.0), b=(1e-3, 1e-3), spin=0.9)  # both saturate at the same moment
@example(mu=(0.1, 0.1), load=(500.0, 500.0), b=(1e-3, np.nextafter(1e-3, 1)), spin=0.717)  # and all but so
def test_every_limit_is_finite_and_balanced_loses_least(
    mu: tuple[float, float], load: tuple[float, float], b: tuple[float, float], spin: float
) -> None:
    inner, outer = (rolling_contact(load=q, semi_axis_transverse=half) for q, half in zip(load, b, strict=True))
    found = {rule: torque((inner, outer), mu, spin, rule) for rule in RULES}
    for each in found.values():
        assert np.all(np.isfinite(each))
        assert each.spin >= 0
        assert each.conformity >= 0

    def power(each: MicroslipTorque) -> float:
        return float(each.spin + each.conformity)

    for rule in RULES[1:]:
        assert power(found["balanced"]) <= power(found[rule]) * (1 + 1e-12)  # round-off
    if spin == 0:
        assert power(found["balanced"]) == power(found["inner_control"])
        assert found["balanced"].spin == 0
