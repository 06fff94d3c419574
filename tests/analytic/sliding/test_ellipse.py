"""Slip over the whole contact: tractions with an exact answer, limits of Coulomb friction, a direct sum, power."""

from typing import Any

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe

from analytic.contact.rolling_contact import ContactNumbers
from analytic.oil.traction import PointLaw
from analytic.sliding.ellipse import SlipSums, quadrature_of, slider_of, slip_sums
from analytic.sliding.long_ellipse import Slip, microslip_moments
from tests.analytic.sliding.slips import ball_slip, contact_slip
from tests.analytic.specimens import rolling_contact

MU, Q, B, R = 0.083, 470.0, 1.27e-3, 4.05e-3  # friction, N, m, m
ROLL, SPEED = 2.9, 12.8  # w_roll/w, and w, rad/s
SPINS = [0.01, -0.1, 0.3, 0.49, -0.5, 0.6, 2.0]  # eps
# Of mu Q b with 16 nodes a side, measured against 48 for b/a from 0.4 to 200 and eps from 0 to 1e9: 6e-6 at worst.
QUADRATURE = 1e-5
COULOMB = PointLaw(boundary=MU)
SINH = PointLaw(limit=0.06, eyring=5e6, fluidity=1e3)  # Eyring's law, capped by a share of the pressure


def contact(k: float, **changed: Any) -> ContactNumbers:
    """Of the ellipticity b/a, under the load Q."""
    axes = {"semi_axis_rolling": B / k, "semi_axis_transverse": B}
    return rolling_contact(**({"load": Q, **axes, "deformed_radius": R, "rolling_rate": ROLL} | changed))


def of_long_ellipse(eps: float) -> tuple[np.ndarray, np.ndarray]:
    """Spin and rolling moment of Coulomb friction in closed form."""
    return microslip_moments(friction_force=MU * Q, semi_axis_transverse=B, deformed_radius=R, spin_to_roll=eps)


def spin_of(eps: float) -> float:
    return eps * ROLL * B / R


def slip(contact: ContactNumbers, law: PointLaw, spin_rate: float, nodes: int = 16) -> Slip:
    """With so many nodes a side."""
    return contact_slip(contact, law, spin_rate, ring_speed=SPEED, nodes=(nodes, nodes))


def power(found: Slip, load: float = Q) -> float:
    """Of the sliding, over the ring speed, N m."""
    return found.coefficient * load * found.slip_speed / SPEED


def scaled(found: Slip) -> np.ndarray:
    return np.array([found.spin_moment / (MU * Q * B), found.rolling_moment / (MU * Q * B**2 / R)])


@pytest.mark.parametrize("k", [0.4, 1.0, 1.5, 3.0, 5.71, 9.28])
def test_full_spin_of_an_ellipse(k: float) -> None:
    """(3/8) mu Q E(m) times the longer semi-axis."""
    found = slip(contact(k), COULOMB, spin_of(1e6))
    integral = ellipe(1 - min(k, 1 / k) ** 2) * max(1, 1 / k)
    np.testing.assert_allclose(found.spin_moment, 0.375 * MU * Q * B * integral, rtol=1e-6)


@pytest.mark.parametrize("eps", [0.0, *SPINS])
def test_a_long_ellipse_is_a_line(eps: float) -> None:
    expected = of_long_ellipse(eps) / np.array([MU * Q * B, MU * Q * B**2 / R])
    gaps = [np.abs(scaled(slip(contact(k), COULOMB, spin_of(eps), 32)) - expected) for k in (1e2, 1e3, 1e4)]
    np.testing.assert_allclose(gaps[2], 0, atol=3e-5)  # falls with a/b where a line of pure rolling nears the end
    assert np.all(gaps[2] <= gaps[0] + QUADRATURE)


@pytest.mark.parametrize(("k", "eps"), [(1.3, 0.3), (5.71, -0.1), (9.28, 0.45)])
def test_a_direct_sum_over_the_ellipse_agrees(k: float, eps: float) -> None:
    """Midpoints of two million cells of the rectangle around the contact, at the computed c."""
    spin, a = spin_of(eps), B / k
    found = slip(contact(k), COULOMB, spin, 32)
    x, y = (np.arange(count) * 2.0 / count - 1 + 1 / count for count in (1000, 2000))
    x, y = a * x, B * y[:, None]
    inside = np.maximum(0, 1 - (x / a) ** 2 - (y / B) ** 2)
    friction = MU * 1.5 * Q / (np.pi * a * B) * np.sqrt(inside) * (2 * a / 1000) * (2 * B / 2000)
    v_x, v_y = ROLL * y**2 / (2 * R) + spin * y - found.creep, -x * (spin + ROLL * y / R)
    speed = np.hypot(v_x, v_y)
    close = 2e-5 * MU * Q  # of the midpoints across the pressure's steep rim and the points where nothing slides
    np.testing.assert_allclose(np.sum(friction * v_x / speed), 0, atol=close)
    np.testing.assert_allclose(found.spin_moment, np.sum(friction * (v_x * y - v_y * x) / speed), atol=close * B)
    rolling = np.sum(friction * (v_x * y**2 / 2 - v_y * x * y) / R / speed)
    np.testing.assert_allclose(found.rolling_moment, rolling, atol=close * B**2 / R)
    np.testing.assert_allclose(power(found), np.sum(friction * speed), rtol=1e-4)  # of the same midpoints


def of_rigid_bodies(k: float, spin: float, radius: float) -> np.ndarray:
    """Power, spin and rolling moment of Coulomb friction over mu Q, m, by Gauss's nodes over a paraboloid.

    The velocity of a rigid body, in the plane that touches the paraboloid
    """
    r, weight = np.polynomial.legendre.leggauss(300)
    angles = 2 * np.pi * (np.arange(600) + 0.5) / 600
    r, weight = (1 - ((1 - r) / 2) ** 2)[:, None], (weight * (1 - r) / 2)[:, None]  # smooth where the pressure ends
    x, y = B / k * r * np.cos(angles), B * r * np.sin(angles)
    share = 1.5 * np.sqrt(1 - r**2) * r * weight / 300
    place = np.stack([x, y, -(y**2) / (2 * radius)], axis=-1)
    tangent = np.stack([0 * y, 1 + 0 * y, -y / radius], axis=-1)
    tangent /= np.linalg.norm(tangent, axis=-1)[..., None]

    def carried(turn: tuple[float, float, float]) -> tuple[np.ndarray, np.ndarray]:
        velocity = np.cross(turn, place)
        return velocity[..., 0], np.sum(velocity * tangent, axis=-1)

    of_spin, of_roll = carried((0.0, 0.0, -1.0)), carried((0.0, -1.0, 0.0))
    moved = [spin * one + ROLL * other for one, other in zip(of_spin, of_roll, strict=True)]

    def pulls(c: float) -> tuple[np.ndarray, np.ndarray]:
        speed = np.hypot(moved[0] - c, moved[1])
        return (moved[0] - c) * share / speed, moved[1] * share / speed

    ends = float(moved[0].min()), float(moved[0].max())
    creep = brentq(lambda c: float(np.sum(pulls(c)[0])), *ends, xtol=1e-14 * np.ptp(ends))
    forward, sideways = pulls(float(creep))  # pyright: ignore[reportArgumentType]
    spun, rolled = (float(np.sum(forward * one + sideways * other)) for one, other in (of_spin, of_roll))
    return np.array([np.sum(forward * (moved[0] - creep) + sideways * moved[1]), spun, rolled])


@pytest.mark.parametrize("eps", [0.0, 0.1, -0.3, 0.6])
@pytest.mark.parametrize("k", [1.3, 4.0, 9.3, 20.0])
def test_bodies_that_slide_are_rigid(k: float, eps: float) -> None:
    """On a surface so little curved, at the same spin-to-roll ratio, that its paraboloid is a cylinder to 1e-6."""
    flat = 300 * R
    spin = eps * ROLL * B / flat
    found = slip(contact(k, deformed_radius=flat), COULOMB, spin, 32)
    power_over, spun, rolled = of_rigid_bodies(k, spin, flat)
    size, close = MU * Q, 1e-4  # of 180 000 nodes that see points where nothing slides
    np.testing.assert_allclose(power(found), size * power_over, rtol=close)
    np.testing.assert_allclose(found.spin_moment, size * spun, atol=close * size * B)
    np.testing.assert_allclose(found.rolling_moment, size * rolled, atol=close * size * B**2 / flat)


@pytest.mark.parametrize(("k", "moment"), [(4.0, 0.0926), (9.3, 0.0837), (20.0, 0.0814), (1e4, 0.0806)])
def test_published_moments_of_conformity(k: float, moment: float) -> None:
    """M_roll R/(mu Q b^2) without spin, by a separate program on polar nodes."""
    np.testing.assert_allclose(scaled(slip(contact(k), COULOMB, 0.0)), [0, moment], atol=6e-5)  # its digits


@pytest.mark.parametrize("g", [3.1e7, 75.0])  # Pa s/m; the last one leaves 1e-9 of the load as friction
@pytest.mark.parametrize(("k", "eps"), [(1.3, 0.0), (0.6, 0.2), (9.28, -0.7)])
def test_a_newtonian_film_has_moments_in_closed_form(k: float, eps: float, g: float) -> None:
    """tau = g v over the area A: c = w_roll b^2/(8 R), M_s = g w_s A (a^2 + b^2)/4.

    M_r = g A w_roll (b^4/64 + a^2 b^2/24)/R^2, whose second part is that of v_y. An Eyring stress far above all
    stresses leaves tau/(g v) = 1 - (v/(5 km/s))^2/6.
    """
    film, spin, a = PointLaw(limit=1e9, eyring=g * 5e3, fluidity=1 / 5e3), spin_of(eps), B / k
    per_rate = g * SPEED * np.pi * a * B
    found = slip(contact(k), film, spin, 64)
    np.testing.assert_allclose(found.creep, ROLL * B**2 / (8 * R), rtol=1e-5)  # of 64 nodes, whose rim is round
    np.testing.assert_allclose(found.spin_moment, per_rate * spin * (a**2 + B**2) / 4, rtol=1e-5)
    turned = B**4 / 64 + a**2 * B**2 / 24
    np.testing.assert_allclose(found.rolling_moment, per_rate * ROLL * turned / R**2, rtol=1e-5)


@pytest.mark.parametrize("law", [COULOMB, SINH])
@pytest.mark.parametrize("k", [1.3, 9.28])
def test_the_power_is_that_of_the_moments(law: PointLaw, k: float) -> None:
    for spin in map(spin_of, (0.0, *SPINS)):
        found = slip(contact(k), law, spin)
        done = found.spin_moment * spin + found.rolling_moment * ROLL
        np.testing.assert_allclose(power(found), done, rtol=3e-9)  # the same nodes; c leaves 1e-9 of force
        assert found.spin_moment * spin >= 0


def test_a_contact_that_neither_rolls_nor_spins_or_has_no_load_has_no_friction() -> None:
    still = slip(contact(3.0, rolling_rate=0.0), COULOMB, 0.0)
    assert still.spin_moment == still.rolling_moment == still.slip_speed == still.creep == 0
    unloaded = slip(contact(3.0, load=0.0), COULOMB, 2.0)
    assert unloaded.spin_moment == unloaded.rolling_moment == unloaded.slip_speed == 0


def sums_of(law: PointLaw, k: float, eps: float) -> float:
    """Integrals of both contacts of a ball, one of which does not spin."""
    speeds = {"ring_speed": SPEED, "spin_difference": spin_of(eps), "spin_rule": "outer_control"}
    found = ball_slip((contact(k), contact(k)), (law, law), **speeds)  # pyright: ignore[reportArgumentType]
    return float(found.sums)


@pytest.mark.parametrize("law", [COULOMB, SINH])
@pytest.mark.parametrize("k", [1.3, 9.28])
def test_the_forceless_creep_takes_few_sums(law: PointLaw, k: float) -> None:
    """Newton's slopes double the digits each time; halving the bracket alone would take fifty in each contact."""
    for eps in (0.0, 1e-9, 1e-4, *map(abs, SPINS)):
        assert 2 <= sums_of(law, k, eps) <= 24


def test_a_law_that_is_not_a_number_does_not_converge() -> None:
    assert sums_of(PointLaw(boundary=np.nan), 3.0, 0.2) == 0


@pytest.mark.parametrize("law", [COULOMB, PointLaw(boundary=0.03, limit=1e3, eyring=5e6, fluidity=1e3)])
@pytest.mark.parametrize("narrow", [3.0, 3e5])
def test_the_slopes_of_the_sums_are_their_differences(law: PointLaw, narrow: float) -> None:
    """Newton's slopes, with the jump of the stress where slip along one axis turns round."""
    slider = slider_of(ContactNumbers(Q, B / narrow, B, 0.0, 0.0, 0.0, R, ROLL, 0.0))
    creep, spin, nodes = 0.4 * slider.roll, 0.055, quadrature_of((48, 48))
    step = 1e-5 * slider.roll

    def sums(c: float, w: float) -> SlipSums:
        return slip_sums(slider, law, c, w, nodes)

    at, close = sums(creep, spin), 2e-3  # of the nodes near the line where the slip turns round
    by_creep = [(a - b) / (2 * step) for a, b in zip(sums(creep + step, spin), sums(creep - step, spin), strict=True)]
    by_spin = [(a - b) / (2 * step) for a, b in zip(sums(creep, spin + step), sums(creep, spin - step), strict=True)]
    np.testing.assert_allclose([at.by_creep, at.mixed], [-by_creep[0], by_spin[0]], rtol=close)
    np.testing.assert_allclose([at.mixed, at.by_spin], [-by_creep[1], by_spin[1]], rtol=close)
