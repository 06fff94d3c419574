"""Rolling resistance: the printed formula in 40 digits, values of another program; hysteresis."""

from typing import Any, Literal

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given
from scipy.integrate import dblquad

from analytic.contact.geometry import race_curvatures
from analytic.contact.rolling_contact import ContactNumbers
from analytic.oil.rolling import (
    RollingResistance,
    elastic_rolling,
    houpert_rolling,
    hydrodynamic_rolling,
    hysteresis_moment,
    inlet_shear_factor,
    replenishment_factor,
    slow_rolling_moment,
)
from analytic.scene import Bearing, Supply
from tests.analytic.specimens import hertzian, rolling_contact
from tests.refusals import refused
from tests.validation.hard.hertz_exact import hertz

ROUND_OFF = 1e-13  # a few hundred roundings of a double
CASE = {
    "curvature_rolling": 310.0,
    "curvature_transverse": 14.7,
    "load": 613.0,
    "modulus": 1.13e11,
    "viscosity": 0.061,
    "entrainment_speed": 0.37,
    "ball_diameter": 7.94e-3,
}
loads = st.floats(-6, 5).map(lambda power: 10.0**power)
speeds = st.floats(-4, 2).map(lambda power: 10.0**power)
ratios = st.floats(0.003, 0.9) | st.floats(1.1, 1.7)


def on_ball(changed: dict[str, object]) -> tuple[ContactNumbers, dict[str, Any]]:
    """The contact of a ball of that diameter, and the arguments besides."""
    contact, rest = hertzian(CASE | changed)
    mean_curvature = 2 / np.asarray(rest.pop("ball_diameter")) - np.asarray(contact.curvature_transverse) / 2
    return contact._replace(deformed_radius=1 / mean_curvature), rest


def rolling(**changed: object) -> RollingResistance:
    contact, rest = on_ball(changed)
    return hydrodynamic_rolling(contact, **rest)


def houpert(**changed: object) -> RollingResistance:
    contact, rest = on_ball({"pressure_viscosity": 2e-8} | changed)
    return houpert_rolling(contact, **rest)


def groups(**changed: float) -> dict[str, mpmath.mpf]:
    """The printed quantities in 40 digits."""
    given = CASE | changed
    with mpmath.workdps(40):
        r_x, stiff = 1 / mpmath.mpf(given["curvature_rolling"]), 2 * mpmath.mpf(given["modulus"])
        ratio = mpmath.mpf(given["curvature_transverse"]) * r_x  # R_x/R_y
        ellipse = hertz(1 / r_x, ratio / r_x, mpmath.mpf(given["load"]), mpmath.mpf(given["modulus"]))
        along, across = ("minor", "major") if ratio < 1 else ("major", "minor")
        kappa, semi_axis = ellipse[along] / ellipse[across], ellipse[across]
        slender = min(kappa, 1)  # counts in C
        integral = mpmath.ellipe(1 - min(kappa, 1 / kappa) ** 2)
        u = 2 * mpmath.mpf(given["viscosity"]) * abs(given["entrainment_speed"]) / (stiff * r_x)
        w = given["load"] / (stiff * r_x**2)
        beta = 4 / mpmath.pi * integral / (1 + ratio)
        rigid = mpmath.mpf("0.77") * beta ** (-mpmath.mpf(1) / 3) * kappa ** mpmath.mpf("0.12")
        m = mpmath.root(beta, 4) * kappa * w / u ** mpmath.mpf("0.75")
        falling = slender ** (mpmath.mpf("0.484") * m ** mpmath.mpf("0.165"))
        whole = mpmath.mpf("0.85") / (1 + mpmath.mpf("4.72") * m ** mpmath.mpf("-0.39") * falling)
        reach = min(2 * semi_axis / mpmath.mpf(given["ball_diameter"]), 1)
        power = (2 - slender) * (mpmath.mpf("0.0018") * m + mpmath.mpf("1.33"))
        return {
            "truncation": 1 / (1 + (1 / whole - 1) * reach**power),
            "scale": stiff * r_x**2 * 2 * semi_axis / r_x,
            "u": u,
            "m": m,
            "rigid": rigid * u ** (-mpmath.mpf(1) / 12),
            "elastic": mpmath.mpf("1.8") / mpmath.root(beta, 4),
        }


def printed(**changed: float) -> float:
    g = groups(**changed)
    with mpmath.workdps(40):
        bracket = (g["rigid"] - g["elastic"]) / (1 + g["m"] / mpmath.mpf("6.6")) + g["elastic"]
        return float(g["truncation"] * g["scale"] * bracket * g["u"] ** mpmath.mpf("0.75"))


@given(load=loads, speed=speeds, ratio=ratios)
def test_the_printed_formula_in_40_digits(load: float, speed: float, ratio: float) -> None:
    changed = {"load": load, "entrainment_speed": speed, "curvature_transverse": ratio * CASE["curvature_rolling"]}
    found = rolling(**changed)
    # round-off, of the semi-axes too
    np.testing.assert_allclose(found.force, printed(**changed), rtol=ROUND_OFF)
    np.testing.assert_allclose(found.power, 2 * speed * found.force, rtol=ROUND_OFF)


# Inner race of a 6205 but for the fourth row; f without C, C and the ratio by an independent program, in its digits.
BY_HAND = [
    (0.18, 620.630, "inner", 100, 22.3735, 1.0000, 1.3561),
    (0.18, 620.630, "inner", 500, 75.1371, 0.9999, 1.1627),
    (0.18, 620.630, "inner", 3000, 291.724, 0.9975, 0.9763),
    (0.18, 620.630, "outer", 500, 68.8829, 1.0000, 1.1284),
    (0.30194, 373.64, "inner", 500, 63.9421, 0.9998, 1.0835),
]


@pytest.mark.parametrize(("angle", "load", "race", "rpm", "millinewton", "truncation", "ratio"), BY_HAND)
def test_both_formulas_by_another_program(
    bearing_6205: Bearing,
    angle: float,
    load: float,
    race: Literal["inner", "outer"],
    rpm: float,
    millinewton: float,
    truncation: float,
    ratio: float,
) -> None:
    curvature_rolling, curvature_transverse = race_curvatures(bearing_6205, race, contact_angle=angle)
    case = {
        "curvature_rolling": float(curvature_rolling),
        "curvature_transverse": float(curvature_transverse),
        "load": load,
        "modulus": 206e9 / (2 * (1 - 0.3**2)),
        "viscosity": 0.06,
        "entrainment_speed": rpm * 2 * np.pi / 60 * (39.01e-3**2 - (7.94e-3 * np.cos(angle)) ** 2) / (4 * 39.01e-3),
    }
    found = rolling(**case)
    np.testing.assert_allclose(found.force, 1e-3 * millinewton * truncation, rtol=6e-5)  # half of the last digit given
    assert not found.outside_range
    np.testing.assert_allclose(houpert(**case).force, 1e-3 * millinewton * ratio, rtol=6e-5)


def test_the_older_formula_has_the_powers_it_prints() -> None:
    """Of speed and load where one kind of body rules; standstill and no load leave nothing."""
    for here, by_speed, by_load in (({"load": 1e-12}, 0.636, 0.364), ({"load": 1e14}, 0.656, 0.466)):
        force = houpert(**here).force
        faster = houpert(**here, entrainment_speed=0.37 * 1.1).force
        np.testing.assert_allclose(np.log(faster / force) / np.log(1.1), by_speed, atol=1e-4)  # the other one's rest
        heavier = houpert(load=here["load"] * 1.1).force
        np.testing.assert_allclose(np.log(heavier / force) / np.log(1.1), by_load, atol=1e-4)
    thicker = houpert(load=1e14, pressure_viscosity=4e-8).force / houpert(load=1e14).force
    np.testing.assert_allclose(np.log2(thicker), 0.022, atol=1e-5)
    assert houpert(entrainment_speed=0.0).force == houpert(load=0.0).force == 0
    assert houpert(entrainment_speed=-0.37).force == houpert().force
    assert houpert(entrainment_speed=-0.37).power == 2 * 0.37 * houpert().force


def test_standstill_no_load_and_backwards() -> None:
    for load in (0.0, 613.0):
        still = rolling(entrainment_speed=0.0, load=load)
        assert still.force == 0
        assert still.power == 0
        assert not still.outside_range
    slow: Any = rolling(entrainment_speed=np.array([1e-60, 1e-40, 1e-20])).force
    assert np.all(np.diff(slow) > 0)
    assert slow[0] < 1e-30  # N: u^(2/3) or faster
    back = rolling(entrainment_speed=-0.37)
    assert back.force == rolling().force
    assert back.power == rolling().power
    unloaded: Any = rolling(load=np.array([0.0, 1e-300, 1e-30])).force
    assert unloaded[0] == 0
    assert np.all(np.diff(unloaded) > 0)


def test_contacts_outside_the_range_of_the_formula_are_marked() -> None:
    assert rolling(curvature_transverse=311.0).outside_range  # longer in the direction of rolling
    assert not rolling(curvature_transverse=310.0).outside_range
    assert rolling(entrainment_speed=1e8).outside_range  # U = 2e-2: rigid bodies would resist less than elastic ones
    assert rolling(curvature_transverse=311.0).force > 0


def test_inlets_are_heated_as_skf_has_it() -> None:
    """phi_ish = 1/(1 + 1.84e-9 (n d_m)^1.28 nu^0.64) in 1/min, mm and mm2/s; 1 at standstill."""
    n, mean, nu = 3700.0, 43.0, 23.0
    found = inlet_shear_factor(mean_diameter=43e-3, ring_speed=n * 2 * np.pi / 60, kinematic_viscosity=23e-6)
    np.testing.assert_allclose(found, 1 / (1 + 1.84e-9 * (n * mean) ** 1.28 * nu**0.64), rtol=1e-12)
    assert 0.5 < found < 0.95
    assert inlet_shear_factor(mean_diameter=43e-3, ring_speed=0.0, kinematic_viscosity=23e-6) == 1


@pytest.mark.parametrize(
    ("supply", "constant"), [("oil_bath", 3e-8), ("oil_jet", 3e-8), ("oil_spot", 6e-8), ("grease", 6e-8)]
)
def test_inlets_are_replenished_as_skf_has_it(supply: Supply, constant: float) -> None:
    """phi_rs = exp(-K_rs nu n (d + D) sqrt(K_Z/(2 (D - d)))) in 1/min, mm and mm2/s; K_Z 3.1 of deep grooves."""
    n, bore, outside, nu = 3700.0, 30.0, 62.0, 23.0
    rings = {"bore_diameter": 30e-3, "outside_diameter": 62e-3}
    runs = {"ring_speed": n * 2 * np.pi / 60, "kinematic_viscosity": 23e-6}
    for geometry, own in ((3.1, {}), (4.4, {"geometry": 4.4})):
        found = replenishment_factor(**rings, **runs, supply=supply, **own)
        expected = np.exp(-constant * nu * n * (bore + outside) * np.sqrt(geometry / (2 * (outside - bore))))
        np.testing.assert_allclose(found, expected, rtol=1e-12)
    assert replenishment_factor(**rings, **runs | {"ring_speed": 0.0}, supply=supply) == 1
    for wrong in ({"bore_diameter": 62e-3}, {"bore_diameter": 0.0}, {"outside_diameter": 29e-3}):
        refused(lambda: replenishment_factor(**rings | wrong, **runs, supply=supply), "_diameter")  # noqa: B023
    unknown: Any = "pump"
    refused(lambda: replenishment_factor(**rings, **runs, supply=unknown), "supply must be one of oil_bath", "'pump'")


def test_hysteresis_takes_its_share_of_the_work_of_the_front_half() -> None:
    """Pressing down the surface ahead of the centre takes the moment of the pressure there, 3/16 Q a."""
    load, a, loss = 470.0, 0.12e-3, 0.0063

    def pressure_times_arm(x: float, y: float) -> float:
        return 3 * load / (2 * np.pi) * np.sqrt(max(0.0, 1 - x**2 - y**2)) * a * x  # unit disc: dA = a b dx dy

    moment, _ = dblquad(pressure_times_arm, -1, 1, 0, lambda y: np.sqrt(1 - y**2), epsabs=1e-12)
    found = hysteresis_moment(rolling_contact(load=load, semi_axis_rolling=a), hysteresis_loss=loss)
    np.testing.assert_allclose(found, loss * moment, rtol=1e-6)  # quadrature across the square-root edge


def test_slow_rolling_of_dry_contacts_is_snares() -> None:
    """0.00021 Q D on a flat race, where R_x = D/2 [Snare1968]; the moment goes as the friction coefficient."""
    load, diameter = 37.0, 7.94e-3
    flat = rolling_contact(load=load, curvature_rolling=2 / diameter)
    dry = slow_rolling_moment(flat, friction_coefficient=0.11)
    np.testing.assert_allclose(dry, 0.00021 * load * diameter, rtol=0.005 / 0.21)  # its last digit
    np.testing.assert_allclose(slow_rolling_moment(flat, friction_coefficient=0.05) / dry, 5 / 11, rtol=1e-12)


def test_a_step_leads_from_one_law_of_elastic_rolling_to_the_other() -> None:
    """One step is the other law, half of it their geometric mean; no step passes the law of dry contacts."""
    contact = rolling_contact(load=370.0, semi_axis_rolling=0.11e-3)
    laws = [float(hysteresis_moment(contact, hysteresis_loss=0.0063))]
    laws += [float(slow_rolling_moment(contact, friction_coefficient=mu)) for mu in (0.05, 0.11)]
    assert laws == sorted(laws)

    def moment(by_houpert: bool, step: float) -> float:
        return float(elastic_rolling(contact, 0.0063, by_houpert, step))

    for by_houpert, own, other in ((False, *laws[:2]), (True, laws[1], laws[0])):
        assert moment(by_houpert, 0.0) == own
        np.testing.assert_allclose(moment(by_houpert, 1.0), other, rtol=1e-12)
        np.testing.assert_allclose(moment(by_houpert, 0.5), np.sqrt(own * other), rtol=1e-12)
    assert moment(True, -3.0) == moment(False, 7.0) == laws[2]
    assert elastic_rolling(contact, 0.0, False, 1.0) == 0.0  # a scene without loss has none
    given = 2 * laws[2] / laws[0] * 0.0063  # a loss factor beyond that of dry contacts
    np.testing.assert_allclose(elastic_rolling(contact, given, False, 0.0), 2 * laws[2], rtol=1e-12)
