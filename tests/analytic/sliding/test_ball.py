"""The friction of one ball over both ellipses: Coulomb's closed forms, exact sums, power, and another program."""

from dataclasses import dataclass, replace
from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings
from scipy.optimize import brentq

from analytic.contact.rolling_contact import ContactNumbers, deformed_radius, elliptic_contact
from analytic.loads.kinematics import ball_kinematics
from analytic.oil.film import Inflow, asymptotes_of
from analytic.oil.mixed import mixed_contact
from analytic.oil.rolling import hysteresis_moment
from analytic.oil.traction import PointLaw, law_of_oil, mean_force, mixed_traction, stress_and_slope
from analytic.oil.viscosity import oil_numbers
from analytic.scene import Array, Autocorrelation, SpinRule, Surface
from analytic.sliding.ball import at_ring_speed
from analytic.sliding.long_ellipse import microslip_torque
from analytic.surface.gap import gap_law
from analytic.surface.roughness import gap_roughness
from tests import contacts as materials
from tests.analytic import specimens
from tests.analytic.sliding.slips import BallSlip, ball_slip
from tests.analytic.specimens import rolling_contact

Pair = tuple[ContactNumbers, ContactNumbers]
COULOMB = PointLaw(boundary=0.083)
BALLS, BALL, PITCH = 9, 7.94e-3, 39.01e-3  # m, of a 6205
STEEL, HARDNESS = 206e9 / (2 * (1 - 0.3**2)), 7.8e9  # Pa
OIL = replace(specimens.OIL, viscosity=0.06, pressure_viscosity=2e-8, eyring_stress=5e6, traction="eyring_constant")


@dataclass(frozen=True)
class Running:
    contacts: Pair
    traction: tuple[PointLaw, PointLaw]  # on inner and outer race
    ring_speed: Array
    spin_difference: float

    def friction(self, *, line: bool = False) -> BallSlip:
        given = {"ring_speed": self.ring_speed, "spin_difference": self.spin_difference, "line": line}
        return ball_slip(self.contacts, self.traction, **given)  # pyright: ignore[reportArgumentType]


def running(
    *,
    rpm: object,
    sq: float,
    length: float = 150e-6,
    angle: float = 0.18,
    load: float = 1000.0,
    traction: str = "eyring_constant",
) -> Running:
    """A ball of a 6205 under thrust at a given contact angle."""
    speed, ball_load = np.asarray(rpm, dtype=np.float64) * np.pi / 30, load / (BALLS * np.sin(angle))
    rates = ball_kinematics(1.0, angle, angle, PITCH, BALL)
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 20)
    surface = Surface(rms_roughness=sq, autocorrelation=correlation, hardness=HARDNESS, gap="truncated")
    gap = gap_law(surface, gap_roughness(surface), modulus=STEEL, bodies=(materials.STEEL, materials.STEEL))

    def race(groove: float, side: int, radius: float, rolling_rate: float) -> tuple[ContactNumbers, PointLaw]:
        ellipse = elliptic_contact(
            curvature_rolling=2 / BALL + side * np.cos(angle) / radius,
            curvature_transverse=2 / BALL - 1 / groove,
            load=ball_load,
            modulus=STEEL,
        )
        contact = ellipse._replace(
            deformed_radius=deformed_radius(groove_radius=groove, ball_diameter=BALL),
            rolling_rate=rolling_rate,
        )
        entrainment: Any = np.abs(speed * rates.inner_entrainment)
        inflow = Inflow(entrainment, OIL.viscosity, OIL.pressure_viscosity)
        shared = mixed_contact(contact, asymptotes_of(contact, inflow), gap)
        oil = oil_numbers(replace(OIL, traction=traction))  # pyright: ignore[reportArgumentType]
        return contact, mixed_traction(oil, 0.12, shared, 1.0)

    inner, inner_law = race(4.13e-3, 1, rates.inner_radius, rates.inner_rolling_rate)
    outer, outer_law = race(4.21e-3, -1, rates.outer_radius, rates.outer_rolling_rate)
    return Running((inner, outer), (inner_law, outer_law), speed, rates.spin_difference)


def race_torque(case: Running, hysteresis_loss: float) -> Array:
    """Slip and hysteresis of all balls, N mm."""
    hysteresis = sum(
        hysteresis_moment(contact, hysteresis_loss=hysteresis_loss) * contact.rolling_rate for contact in case.contacts
    )
    return 1e3 * BALLS * (case.friction(line=True).torque + hysteresis)


RING_SPEEDS = np.array([0.0, 1e-6, 1e-4, 0.01, 0.1, 1.0, 10.471976, 52.359878])  # rad/s; the last two are 100, 500 rpm
FROM_REST = {  # N mm at these speeds, by another program, for a correlation length of 165 um
    1e-6: [85.757, 85.743, 85.269, 75.898, 57.621, 44.638, 34.325, 26.369],
    0.1e-6: [85.757, 85.688, 84.537, 64.375, 24.394, 9.1001, 8.0995, 7.4999],
}


@pytest.mark.parametrize("sq", FROM_REST)
def test_the_race_torque_from_rest_to_the_film(sq: float) -> None:
    """The other program slides each contact by one coefficient, over the whole ellipse, without turn by conformity."""
    case = running(rpm=RING_SPEEDS * 30 / np.pi, sq=sq, length=165e-6)
    # A single coefficient on a long ellipse loses E(m) - 1 of the ellipse, with m = 1 - (a/b)^2: up to 1.1 % of all.
    np.testing.assert_allclose(race_torque(case, 0.007), FROM_REST[sq], rtol=0.012)


def pair(**changed: object) -> Pair:
    """Inner and outer contact."""
    outer = {
        "semi_axis_rolling": 0.16e-3,
        "semi_axis_transverse": 0.93e-3,
        "deformed_radius": 4.1e-3,
        "rolling_rate": 1.93,
    }
    return rolling_contact(**changed), rolling_contact(**(outer | changed))


def friction(contacts: Pair, law: PointLaw, **changed: object) -> BallSlip:
    given = {"ring_speed": 31.0, "spin_difference": 0.179} | changed
    return ball_slip(contacts, (law, law), **given)  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("rule", ["balanced", "inner_control", "outer_control"])
def test_coulomb_friction_is_that_of_the_closed_forms(rule: SpinRule) -> None:
    contacts = pair(load=np.array([3.0, 613.0]))
    found = friction(contacts, COULOMB, spin_rule=rule, line=True)
    forces = 0.083 * np.asarray(contacts[0].load), 0.083 * np.asarray(contacts[1].load)
    expected = microslip_torque(contacts, friction_force=forces, spin_difference=0.179, spin_rule=rule)
    for race in ("inner", "outer"):
        for name in ("spin_rate", "spin_moment", "rolling_moment"):
            closed = getattr(expected, f"{race}_{name}")
            np.testing.assert_allclose(getattr(getattr(found, race), name), closed, rtol=1e-13)  # round-off
    np.testing.assert_allclose(found.inner.coefficient, 0.083, rtol=1e-15)
    narrow, long = pair(semi_axis_rolling=1e-6), {"spin_rule": rule, "line": True}
    over, closed = friction(narrow, COULOMB, spin_rule=rule), friction(narrow, COULOMB, **long)
    np.testing.assert_allclose(over.torque, closed.torque, rtol=1e-4)  # a long ellipse tends to it as (a/b)^2 ln(b/a)
    np.testing.assert_allclose([over.inner.coefficient, over.outer.coefficient], 0.083, rtol=1e-12)


def test_oil_without_a_film_shears_at_its_limit_at_standstill_too() -> None:
    for speed in (0.0, 31.0):
        law = PointLaw(limit=0.06, eyring=5e6, fluidity=np.inf, own=3.0)
        assert at_ring_speed(law, speed) == law
        assert at_ring_speed(law._replace(fluidity=7.0), speed) == law._replace(fluidity=7.0 * speed)


@pytest.mark.parametrize("traction", ["eyring_constant", "eyring_sinh"])
def test_the_torque_is_the_power_lost_at_every_point(traction: str) -> None:
    """Against a midpoint sum over polar cells, with its own c of no net force."""
    case = running(rpm=230.0, sq=0.4e-6, traction=traction)
    found = case.friction()
    # Equal areas of the half x > 0: the other half has the same speeds
    r, angle = np.sqrt((np.arange(130) + 0.5) / 130)[:, None], np.pi * ((np.arange(110) + 0.5) / 110 - 0.5)
    total = 0.0
    rates = (found.inner.spin_rate, found.outer.spin_rate)
    for race, law, spin in zip(case.contacts, case.traction, rates, strict=True):
        a, b = float(race.semi_axis_rolling), float(race.semi_axis_transverse)
        x, y = a * r * np.cos(angle), b * r * np.sin(angle)
        pressure = 1.5 * race.load / (np.pi * a * b) * np.sqrt(1 - r**2) + 0 * x
        turn = spin + race.rolling_rate * y / race.deformed_radius
        across = -turn * x
        slide = race.rolling_rate * y**2 / (2 * race.deformed_radius) + spin * y

        def stress(c: float) -> tuple[Array, Array]:
            speed = np.hypot(slide - c, across)  # noqa: B023
            return stress_and_slope(law, pressure, case.ring_speed * speed)[0], speed  # noqa: B023

        def force(c: float) -> float:
            tau, speed = stress(c)
            along = np.divide(slide - c, speed, out=np.zeros_like(speed), where=speed > 0)  # noqa: B023
            return float(np.sum(tau * along))

        # 1e-7 of the range moves the power by as little
        tau, speed = stress(brentq(force, slide.min(), slide.max(), xtol=1e-7 * np.ptp(slide)))  # pyright: ignore[reportArgumentType]
        total += np.pi * a * b * float(np.mean(tau * speed))
    np.testing.assert_allclose(found.torque, total, rtol=6e-4)  # a hundred cells across, kinks where slide turns


@pytest.mark.parametrize("traction", ["eyring_constant", "eyring_sinh"])
def test_a_coefficient_along_the_axis_belongs_to_its_own_speed(traction: str) -> None:
    case = running(rpm=[40.0, 400.0], sq=0.2e-6, traction=traction)
    found = case.friction(line=True)
    power = np.zeros(2)
    for race, law, mu, speed in zip(
        case.contacts,
        case.traction,
        (found.inner.coefficient, found.outer.coefficient),
        (found.inner.slip_speed, found.outer.slip_speed),
        strict=True,
    ):
        np.testing.assert_allclose(mu * race.load, mean_force(law, race, speed), rtol=1e-12)  # round-off
        power += mu * race.load * speed
    # Torque times w is the power, friction force times mean speed.
    np.testing.assert_allclose(found.torque * case.ring_speed, power, rtol=1e-12)


def test_standstill() -> None:
    """At rest there is only boundary friction, as oil with a stress that follows the speed has none in slow sliding."""
    still = running(rpm=np.array([0.0, 1e-9]), sq=0.3e-6, traction="eyring_sinh")
    found = still.friction()
    np.testing.assert_allclose(found.inner.coefficient[0], 0.12, rtol=1e-12)
    assert np.all(np.isfinite(found.torque))


def test_without_load_there_is_no_friction() -> None:
    point = {"load": np.array([0.0, 613.0]), "semi_axis_rolling": np.array([0.0, 0.12e-3])}
    point["semi_axis_transverse"] = np.array([0.0, 1.1e-3])
    law = law_of_oil(oil_numbers(OIL), 0.11 * 0.21, 1 - 0.2, 0.99, 90e-9)
    found = friction(pair(**point), law)
    assert found.torque[0] == found.inner.coefficient[0] == found.outer.slip_speed[0] == 0
    assert found.torque[1] > 0
    inner, outer = pair(**{name: values[1] for name, values in point.items()})
    lifted = inner._replace(load=0.0, semi_axis_rolling=0.0, semi_axis_transverse=0.0)
    # The ball follows the outer race, to the tolerance of the spin's share; the contact can hold 0.1 N mm.
    assert friction((lifted, outer), law).outer.spin_moment == pytest.approx(0, abs=1e-8)


@settings(max_examples=25)
@given(
    load=st.floats(-6, 5),
    speed=st.floats(-6, 5),
    spin=st.floats(-8, 3),
    share=st.floats(0, 1),
    film=st.floats(-12, -4),
    traction=st.sampled_from(["eyring_constant", "eyring_sinh"]),
)
def test_always_a_number(load: float, speed: float, spin: float, share: float, film: float, traction: str) -> None:
    oil = oil_numbers(replace(OIL, traction=traction))  # pyright: ignore[reportArgumentType]
    law = law_of_oil(oil, 0.12 * share**0.7, 1 - share, 1 - share / 9, 10.0**film)
    size = np.cbrt(10.0**load / 613.0)
    contacts = pair(load=10.0**load, semi_axis_rolling=0.13e-3 * size, semi_axis_transverse=1.04e-3 * size)
    found = friction(contacts, law, ring_speed=10.0**speed, spin_difference=10.0**spin)
    assert np.all(np.isfinite([*found.inner, *found.outer]))
    balance = found.inner.spin_moment + found.outer.spin_moment
    assert abs(balance) <= 1e-5 * abs(found.inner.spin_moment) + 1e-300  # 1e-9 of a share, at up to 1e3 rad/s
    assert found.spin >= 0
    assert found.conformity >= -1e-9 * found.spin  # round-off of the sums where spin is full
