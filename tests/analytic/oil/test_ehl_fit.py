"""The fit to numerical solutions against them, against what defines it far ahead of a contact, and where it ends."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.rolling_contact import ContactNumbers, elliptic_contact
from analytic.oil.ehl_fit import (
    OilSupply,
    Regime,
    covered,
    effective_reach,
    film_correction,
    fitted_force,
    gap_force,
    inlet_length,
    regime_of,
)
from analytic.oil.film import Inflow, central_film
from analytic.scene import Bearing, Groove
from tests.analytic.specimens import BEARING_6205
from tests.contacts import STEEL
from validation.ehl.effective_reach import log_ratio
from validation.ehl.run import contact_of, known, loading_of

SUPPLY = OilSupply(mean_diameter=0.04, degree=np.nan, rate=np.nan, ahead=2.9e-3, behind=2.1e-3, tension=0.0)
RADIUS, ACROSS, MODULUS = 3.2e-3, 58e-3, 113e9  # R_x, R_y, m; E*, Pa


def contact(load: float) -> ContactNumbers:
    return elliptic_contact(curvature_rolling=1 / RADIUS, curvature_transverse=1 / ACROSS, load=load, modulus=MODULUS)


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


def test_the_regime_is_that_of_moes() -> None:
    """N = M sqrt(lambda) with M = W U^(-3/4), L = alpha E' U^(1/4), by their definitions."""
    load, speed = 41.0, 0.47
    stiff = 2 * MODULUS
    u, w = 2 * 0.031 * speed / (stiff * RADIUS), load / (stiff * RADIUS**2)
    found = np.exp(regime_of(contact(load), inflow(speed)))
    expected = w * u**-0.75 * (RADIUS / ACROSS) ** 0.5, 2.1e-8 * stiff * u**0.25, RADIUS / ACROSS
    np.testing.assert_allclose(found, expected, rtol=1e-12)  # of logarithms up to 20
    for still in (regime_of(contact(0.0), inflow()), regime_of(contact(load), inflow(0.0))):
        assert covered(still) == 0
    assert covered(regime_of(contact(load), inflow()._replace(pressure_viscosity=0.0))) == 0


INSIDE = Regime(*np.log((90.0, 5.1, 0.23)))
RANGES = {"loading": (6.0, 4000.0), "thickening": (2.0, 20.0), "ellipticity": (0.02, 1.0)}  # N, L and lambda


@pytest.mark.parametrize("name", RANGES)
def test_each_number_leaves_the_fit_over_a_factor_of_one_and_a_half(name: str) -> None:
    """On either side of its range: all of the fit at the limit, half of it halfway, and then none."""
    low, high = RANGES[name]

    def share(value: float) -> float:
        return covered(INSIDE._replace(**{name: float(np.log(value))}))

    for limit, factor in ((low, 1 / 1.5), (high, 1.5)):
        assert share(limit * factor**-0.01) == 1
        assert share(limit * factor**0.01) > 0.999  # it leaves with the square
        assert share(limit * factor**0.5) == pytest.approx(0.5, abs=1e-12)
        assert 0 < share(limit * factor**0.99) < 1e-3
        assert share(limit * factor**1.001) == 0
        # as 1 - 3 x^2 + 2 x^3 of the way x
        assert share(limit * factor**0.25) == pytest.approx(1 - 3 / 16 + 2 / 64, rel=1e-12)


def test_film_and_force_are_those_of_the_numerical_solutions() -> None:
    """Of some within the range; tolerances: the errors that left-out ones have (`validation/ehl/fit.json`)."""
    rows = [row for row in known() if not row.trouble and 6.0 <= loading_of(row) <= 4000.0][::7]
    assert len(rows) > 20
    errors = []
    for row in rows:
        solved = contact_of(row.loading, row.thickening, row.ellipticity)
        assert solved is not None
        rolling, transverse = (1 / radius for radius in solved.shape.radii)
        numbers = elliptic_contact(
            curvature_rolling=rolling, curvature_transverse=transverse, load=solved.load, modulus=solved.modulus
        )
        oil = {"viscosity": solved.oil.viscosity, "pressure_viscosity": solved.oil.pressure_viscosity}
        inlet = Inflow(solved.speed, oil["viscosity"], oil["pressure_viscosity"], True, np.inf)
        regime = regime_of(numbers, inlet)
        supply = SUPPLY._replace(ahead=solved.reach.ahead)
        force = fitted_force(numbers, inlet, regime, supply) / solved.force_scale
        film = central_film(numbers, entrainment_speed=solved.speed, **oil, compressible=True).thickness
        height = float(film) / solved.film_scale * np.exp(film_correction(regime))
        errors.append((force / row.rolling_force - 1, height / row.central_film - 1))
    of_force, of_film = np.abs(errors).T
    assert of_force.max() < 0.0155
    assert of_film.max() < 0.0437
    assert np.sqrt(np.mean(of_force**2)) < 0.0037
    assert np.sqrt(np.mean(of_film**2)) < 0.0133


def test_beyond_the_range_the_inlet_is_as_long_as_at_its_end() -> None:
    numbers, inlet = contact(41.0), inflow()
    for name, (low, high) in RANGES.items():
        for end, beyond in ((low, 0.7 * low), (high, 1.3 * high)):
            at, outside = (
                inlet_length(numbers, inlet, INSIDE._replace(**{name: float(np.log(each))})) for each in (end, beyond)
            )
            assert outside == pytest.approx(at, rel=1e-12)
            inner = inlet_length(numbers, inlet, INSIDE._replace(**{name: float(np.log(end * (end / beyond) ** 0.3))}))
            assert inner != pytest.approx(at, rel=1e-3)


def test_the_inlet_is_as_long_as_the_contact_is_large() -> None:
    """Contacts of one regime are alike: s goes as R_x U^(1/4)."""
    numbers, inlet = contact(41.0), inflow()
    larger = numbers._replace(curvature_rolling=numbers.curvature_rolling / 1.7)
    faster = inlet._replace(speed=2.3 * inlet.speed)
    lengths = [
        inlet_length(each, flow, INSIDE) for each, flow in ((numbers, inlet), (larger, inlet), (numbers, faster))
    ]
    np.testing.assert_allclose(lengths[1:], lengths[0] * np.array([1.7**0.75, 2.3**0.25]), rtol=1e-12)


def test_a_narrow_gap_has_the_far_field_of_a_contact_and_a_wide_one_the_area_of_its_oil() -> None:
    """Each e-fold of a narrow gap adds S/2, but below 1e-4 radii nothing; in a wide one the force goes as X^2/h."""
    shear, radius, ellipticity, ahead = 0.07, 4.4e-3, 0.031, 3.3e-3
    slope = 12 * np.pi * shear * radius / ((3 + 2 * ellipticity) * ellipticity**0.5)
    narrow = [gap_force(shear, radius, ellipticity, gap * radius, ahead) for gap in (1.1e-4, 1.3e-4)]
    near = 7.5 * 1.3e-4 * radius**2 / ahead**2  # over 1 in the logarithm
    assert narrow[0] - narrow[1] == pytest.approx(slope / 2 * np.log(1.3 / 1.1), rel=2 * near)
    assert near < 2e-3
    wide = gap_force(shear, radius, ellipticity, 2e3 * radius, ahead)
    assert wide == pytest.approx(slope / 2 * ahead**2 / (7.5 * 2e3 * radius**2), rel=1e-4)  # half of its argument
    least = [gap_force(shear, radius, ellipticity, gap * radius, ahead) for gap in (1e-4, 0.9e-4, 0.0)]
    assert least[0] == least[1] == least[2] > narrow[0]
