"""The fit to numerical solutions against what defines it far ahead of a contact, and where it ends."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.rolling_contact import ContactNumbers, elliptic_contact
from analytic.oil.asymptotes import Inflow
from analytic.oil.ehl_fit import (
    OilSupply,
    covered,
    effective_reach,
    film_correction,
    fitted_force,
    gap_force,
    gap_of_force,
    regime_of,
)
from analytic.scene import Bearing, Groove
from tests.analytic.specimens import BEARING_6205
from tests.contacts import STEEL
from validation.ehl.effective_reach import log_ratio

SUPPLY = OilSupply(mean_diameter=0.04, degree=np.nan, rate=np.nan, ahead=2.9e-3, behind=2.1e-3, tension=0.0)
RADIUS, ACROSS, MODULUS = 3.2e-3, 58e-3, 113e9  # R_x, R_y, m; E*, Pa


def contact(load: float) -> ContactNumbers:
    found = elliptic_contact(curvature_rolling=1 / RADIUS, curvature_transverse=1 / ACROSS, load=load, modulus=MODULUS)
    return ContactNumbers._make([*(float(each) for each in found.fields[:6]), np.nan, np.nan, 1.0])


def inflow(speed: float = 0.47) -> Inflow:
    return Inflow(speed, 0.031, 2.1e-8, True, np.inf)


def force(load: float, supply: OilSupply = SUPPLY, speed: float = 0.47) -> float:
    numbers, inlet = contact(load), inflow(speed)
    return fitted_force(numbers, inlet, regime_of(numbers, inlet), supply)


def test_more_oil_adds_the_force_of_rigid_bodies_far_ahead() -> None:
    """f grows by 12 pi eta u R_x/((3 + 2 lambda) sqrt(lambda)) for each e-fold of the reach, but for a/X of it."""
    ellipticity = RADIUS / ACROSS
    slope = 12 * np.pi * 0.031 * 0.47 * RADIUS / ((3 + 2 * ellipticity) * ellipticity**0.5)
    for load in (23.0, 370.0):
        more = force(load, SUPPLY._replace(ahead=1.7 * SUPPLY.ahead)) - force(load)
        near = contact(load).semi_axis_rolling / SUPPLY.ahead
        assert more == pytest.approx(slope * np.log(1.7), rel=near)
        assert near < 0.05
        assert force(load, SUPPLY._replace(ahead=contact(load).semi_axis_rolling)) == 0


def test_an_outlet_full_of_oil_adds_its_own_logarithm_and_a_weak_oil_nothing() -> None:
    """The pressure 12 eta u x/((3 + 2 lambda) h^2), mirrored, is the tension at x; oil reaches from there on."""
    ellipticity = RADIUS / ACROSS
    place = 0.6e-3  # m behind the contact
    tension = 12 * 0.031 * 0.47 * place / ((3 + 2 * ellipticity) * (place**2 / (2 * RADIUS)) ** 2)
    slope = 12 * np.pi * 0.031 * 0.47 * RADIUS / ((3 + 2 * ellipticity) * ellipticity**0.5)
    more = force(370.0, SUPPLY._replace(tension=tension)) - force(370.0)
    assert more == pytest.approx(slope * np.log(SUPPLY.behind / place), rel=1e-9)
    assert force(370.0, SUPPLY._replace(tension=1e-9 * tension)) == force(370.0)


def test_the_fit_ends_smoothly_and_covers_no_standstill_no_load_and_no_constant_viscosity() -> None:
    loads = np.geomspace(1e-4, 3e5, 4000)
    share = np.array([covered(regime_of(contact(load), inflow())) for load in loads])
    assert share.min() == 0
    assert share.max() == 1
    assert np.abs(np.diff(share)).max() < 0.03  # 1.5/ln 1.5 over steps of 0.0055 in ln N is 0.02
    correction = np.array([film_correction(regime_of(contact(load), inflow())) for load in loads])
    assert np.abs(np.diff(correction)).max() < 0.02
    for load, inlet in ((0.0, inflow()), (41.0, inflow(0.0)), (41.0, inflow()._replace(pressure_viscosity=0.0))):
        assert covered(regime_of(contact(load), inlet)) == 0


@pytest.mark.parametrize(
    ("race", "groove", "width", "reach"),
    [("inner", 1.043, 0.62, 0.9), ("outer", 1.06, 0.71, 0.53), ("inner", 1.12, 0.44, 0.74), ("outer", 1.3, 0.86, 0.95)],
)
def test_the_effective_reach_is_that_of_a_direct_solution(race: str, groove: float, width: float, reach: float) -> None:
    """Grooves beside those of the fit; 0.02 in ln X_e, its stated largest error, is 0.4 % of a usual force."""
    bearing = with_groove(groove, width)
    ring = getattr(bearing, race)
    ball = bearing.ball_diameter / 2
    curved = ball / (ring.bottom_radius * (1 if race == "inner" else -1))
    direct = log_ratio(curved, 1 - 1 / groove, width * np.cos(0.31), reach)
    found = effective_reach(bearing, race, reach=reach, contact_angle=0.31)  # pyright: ignore[reportArgumentType]
    assert np.log(found / (reach * ball)) == pytest.approx(direct, abs=0.02)
    assert direct < -0.05  # circles open the gap and shoulders end it: a paraboloid needs less oil


def with_groove(groove: float, width: float) -> Bearing:
    """A 6205 with other grooves; both arguments over the ball's radius."""
    ball = BEARING_6205.ball_diameter / 2

    def changed(ring: Groove) -> Groove:
        return replace(ring, groove_radius=groove * ball, shoulder_half_width=width * ball, material=STEEL)

    return replace(BEARING_6205, inner=changed(BEARING_6205.inner), outer=changed(BEARING_6205.outer))


def test_the_gap_of_a_force_is_the_inverse_of_the_force_in_a_gap() -> None:
    for gap in (2e-6, 3e-5, 4e-4):  # m, wider than the least of 1e-4 radii
        force = gap_force(0.07, 4.4e-3, 0.031, gap, 3.3e-3)
        np.testing.assert_allclose(gap_of_force(0.07, 4.4e-3, 0.031, force, 3.3e-3), gap, rtol=1e-12)
