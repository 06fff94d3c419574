"""Catalogue models: the printed formulas by hand in printed units, and the bearings that have them."""

import functools
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.makers import (
    CatalogueCase,
    bearing_series,
    iso_torque,
    palmgren_inclined_torque,
    palmgren_torque,
    scene_band,
    skf_parts,
)
from analytic.scene import Bearing, Operation, Scene
from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import load_scene, parse_scene, scene_of
from analytic.scenefile.template import scene_text
from fembearing.plain_types import plain
from fembearing.report.torque import content_of

RINGS = {"bore_diameter": 25e-3, "outside_diameter": 52e-3}
CASE = {
    "series": "62",
    **RINGS,
    "static_rating": 7.8e3,
    "axial_load": 1000.0,
    "radial_load": 0.0,
    "ring_speed": 500 * math.pi / 30,
    "kinematic_viscosity": 32e-6,
}


def case_of(changed: dict[str, Any]) -> tuple[CatalogueCase, dict[str, Any]]:
    """The case with its changes, and what is no part of it."""
    rest = {name: value for name, value in changed.items() if name not in CASE}
    return CatalogueCase(**{name: changed.get(name, value) for name, value in CASE.items()}), rest


def skf(**changed: object) -> np.ndarray:
    case, rest = case_of({"lubrication": "oil_bath"} | changed)
    return np.add(*skf_parts(case, **rest))


def palmgren(**changed: object) -> np.ndarray:
    case, rest = case_of({"load_factor": 5e-4} | changed)
    return palmgren_torque(case, **rest)


def by_hand(
    g_rr: float, g_sl: float, *, rpm: float, nu: float, rings: tuple[float, float] = (25, 52), k_z=3.1, k_rs=3e-8
) -> float:
    """The sum of SKF's worksheet, line after line, in mm, mm^2/s, rev/min, N mm."""
    bore, outside = rings
    d_m = (bore + outside) / 2
    phi_ish = 1 / (1 + 1.84e-9 * (rpm * d_m) ** 1.28 * nu**0.64)
    phi_rs = 1 / math.exp(k_rs * nu * rpm * (bore + outside) * math.sqrt(k_z / (2 * (outside - bore))))
    phi_bl = 1 / math.exp(2.6e-8 * (rpm * nu) ** 1.4 * d_m)
    return phi_ish * phi_rs * g_rr * (nu * rpm) ** 0.6 + g_sl * (phi_bl * 0.12 + (1 - phi_bl) * 0.05)


PRINTED = {  # SKF's table 3 typed in again: R_1, R_2, S_1, S_2
    "60": (4.1e-7, 1.7, 0.00373, 14.6),
    "62": (3.9e-7, 1.7, 0.00323, 36.5),
    "63": (3.7e-7, 1.7, 0.00284, 92.8),
    "64": (3.6e-7, 1.7, 0.00243, 198),
    "160": (4.3e-7, 1.7, 0.00463, 4.25),
    "161": (4.3e-7, 1.7, 0.00463, 4.25),
    "618": (4.7e-7, 1.7, 0.0065, 0.78),
    "619": (4.3e-7, 1.7, 0.00475, 3.6),
}


@pytest.mark.parametrize("series", PRINTED)
@pytest.mark.parametrize("thrust", [0.0, 130.0, 1000.0])
@pytest.mark.parametrize("radial", [0.0, 370.0])
@pytest.mark.parametrize(("lubrication", "k_rs"), [("oil_bath", 3e-8), ("grease", 6e-8)])
def test_the_skf_worksheet(series: str, thrust: float, radial: float, lubrication: str, k_rs: float) -> None:
    r_1, r_2, s_1, s_2 = PRINTED[series]
    g_rr = r_1 * 38.5**1.96 * radial**0.54
    g_sl = s_1 * 38.5**-0.26 * radial ** (5 / 3)
    if thrust > 0:
        sine = math.sin(math.radians(24.6 * (thrust / 7800) ** 0.24))
        g_rr = r_1 * 38.5**1.96 * (radial + r_2 / sine * thrust) ** 0.54
        g_sl = s_1 * 38.5**-0.145 * (radial**5 + s_2 * 38.5**1.5 / sine * thrust**4) ** (1 / 3)
    loads = {"axial_load": thrust, "radial_load": radial}
    for rpm, nu in ((100.0, 68.0), (3000.0, 17.0)):
        runs = {"ring_speed": rpm * 2 * math.pi / 60, "kinematic_viscosity": nu * 1e-6}
        found = skf(series=series, **loads, **runs, lubrication=lubrication)
        expected = by_hand(g_rr, g_sl, rpm=rpm, nu=nu, k_rs=k_rs)
        np.testing.assert_allclose(found * 1e3, expected, rtol=1e-12)  # round-off


@pytest.mark.parametrize(("thrust", "radial"), [(0.0, 370.0), (1300.0, 0.0), (1300.0, 900.0)])
@pytest.mark.parametrize("rpm", [130.0, 7000.0])
def test_skf_of_angular_contact_bearings_by_hand(thrust: float, radial: float, rpm: float) -> None:
    """A 7208 B, 40 x 80 mm, with 17 mm^2/s: SKF's own form, with the centrifugal force on the balls."""
    g_rr = 5.03e-7 * 60**1.97 * (radial + 1.9e-12 * 60**4 * rpm**2 + 1.97 * thrust) ** 0.54
    g_sl = 0.013 * 60**0.26 * ((radial + 1.91e-12 * 60**4 * rpm**2) ** (4 / 3) + 0.68 * thrust ** (4 / 3))
    expected = by_hand(g_rr, g_sl, rpm=rpm, nu=17, rings=(40, 80), k_z=4.4)
    found = skf(**SEVEN, axial_load=thrust, radial_load=radial, ring_speed=rpm * math.pi / 30)
    np.testing.assert_allclose(found * 1e3, expected, rtol=1e-12)  # round-off


SEVEN: dict[str, Any] = {
    "series": "72 B",
    "bore_diameter": 40e-3,
    "outside_diameter": 80e-3,
    "static_rating": 24e3,
    "kinematic_viscosity": 17e-6,
}


@pytest.mark.parametrize(("supply", "viscous"), [("oil_bath", 3.3), ("grease", 2.0), ("oil_jet", 6.6)])
def test_palmgren_of_angular_contact_bearings_by_hand(supply: Any, viscous: float) -> None:
    """At 700 rev/min and 40 deg, cot = 1.191754: P_1 and P_0 by the larger alternative."""
    for thrust, radial, static, working in (
        (1300.0, 0.0, 338.0, 1394.35),
        (900.0, 950.0, 950.0, 950.0),
        (1300.0, 850.0, 850.0, 1309.35),
    ):
        case, _ = case_of(SEVEN | {"axial_load": thrust, "radial_load": radial, "ring_speed": 700 * math.pi / 30})
        expected = 1e-7 * viscous * (17 * 700) ** (2 / 3) * 60**3 + 1e-3 * (static / 24e3) ** 0.33 * working * 60
        found = palmgren_inclined_torque(case, lubrication=supply)
        np.testing.assert_allclose(found * 1e3, expected, rtol=2e-6)  # six digits


@pytest.mark.parametrize(("rpm", "nu"), [(130.0, 41.0), (2600.0, 17.0)])
def test_thrust_ball_bearings_by_hand(rpm: float, nu: float) -> None:
    """A 51106, 30 x 47 mm, C_0 of 43 kN, under 2.3 kN."""
    rings = {"series": "thrust", "bore_diameter": 30e-3, "outside_diameter": 47e-3, "static_rating": 43e3}
    point = {"axial_load": 2300.0, "ring_speed": rpm * math.pi / 30, "kinematic_viscosity": nu * 1e-6}
    g_rr, g_sl = 1.03e-6 * 38.5**1.83 * 2300**0.54, 0.016 * 38.5**0.05 * 2300 ** (4 / 3)
    expected = by_hand(g_rr, g_sl, rpm=rpm, nu=nu, rings=(30, 47), k_z=3.8)
    np.testing.assert_allclose(skf(**rings, **point) * 1e3, expected, rtol=1e-12)  # round-off
    case, _ = case_of(rings | point)
    expected = 1e-7 * 1.5 * (nu * rpm) ** (2 / 3) * 38.5**3 + 8e-4 * (2300 / 43e3) ** 0.33 * 2300 * 38.5
    found = palmgren_inclined_torque(case, lubrication="oil_bath")
    np.testing.assert_allclose(found * 1e3, expected, rtol=1e-12)  # round-off


# Table A.1 of ISO 15312, typed in again: dimension series, f_0r, f_1r.
DIMENSION_SERIES = {
    "618": ("18", 1.7, 0.0001),
    "619": ("19", 1.7, 0.00015),
    "160": ("00", 1.7, 0.00015),
    "60": ("10", 1.7, 0.00015),
    "62": ("02", 2, 0.0002),
    "63": ("03", 2.3, 0.0002),
    "64": ("04", 2.3, 0.0002),
    "72 B": ("02", 2, 0.00025),
    "73 B": ("03", 3, 0.00035),
}


@pytest.mark.parametrize("series", DIMENSION_SERIES)
def test_iso_15312_at_its_reference_load(series: str) -> None:
    """P_1r = 0.05 C_0r, here with 12 mm^2/s at 2900 rev/min; a thrust that decides is out of its range."""
    _, f_0, f_1 = DIMENSION_SERIES[series]
    here = {"series": series, "radial_load": 390.0, "ring_speed": 2900 * math.pi / 30, "kinematic_viscosity": 12e-6}
    thrusts = np.array([0.0, 140.0, 145.0, 420.0, 435.0])
    case, _ = case_of(here | {"axial_load": thrusts})
    found = iso_torque(case)
    expected = 1e-7 * f_0 * (12 * 2900) ** (2 / 3) * 38.5**3 + f_1 * 0.05 * 7800 * 38.5
    within = thrusts <= (429 if "B" in series else 130)  # 1.1 F_r, F_r/3
    np.testing.assert_allclose(found[within] * 1e3, expected, rtol=1e-12)  # round-off
    assert np.all(np.isnan(found[~within]))


def test_a_pair_has_the_sum_over_both_bearings_at_their_own_loads() -> None:
    settings = {"arrangement.kind": "O", "arrangement.preload": "300 N"}
    given: dict[str, Any] = {"axial_load": "250 N", "speed": "1500 rpm", "supply": "grease"}
    result = torque_of_scene(load_scene("7014C", settings=settings, **given), estimate=False)
    pair, found = result.friction.pair, result.catalogue.band
    assert pair is not None
    assert found is not None
    one = load_scene("7014C", **given)
    for name, value in found.values.items():
        each = [
            scene_band(replace(one, operation=replace(one.operation, axial_load=np.abs(thrust)))).values[name]
            for thrust in pair.equilibrium.axial_load
        ]
        assert each[0] != each[1]
        np.testing.assert_allclose(value, each[0] + each[1], rtol=1e-12)  # round-off
    assert "summed over both" in result.catalogue.note


def test_a_bearing_of_the_catalogue_knows_its_series() -> None:
    def of(**own: Any) -> Bearing:
        operation = {"axial_load": "100 N", "inner_speed": "300 rpm"}
        table = {"name": "by designation", "tolerance": "5 %", "bearing": own, "operation": operation}
        return scene_of(table | {"friction": {"coefficient": 0.07}}, origin="test").bearing

    assert bearing_series(of(catalog="7208 BEP")) == "72 B"
    assert of(catalog="6205", outside_diameter="53 mm").series is None
    assert bearing_series(of(catalog="7208 C")) == "NSK 72 C"
    assert bearing_series(replace(of(catalog="7208 BEP"), series=None)) == "angular contact"
    assert bearing_series(replace(of(catalog="7208 BEP"), kind="thrust")) == "thrust"


def test_palmgren_by_hand() -> None:
    """At 700 rev/min and 41 mm^2/s, 130 N and 370 N: whole worksheet, P_1 and P_0 by the larger alternative."""
    cases = [
        (1000.0, 0.0, 500.0, 3300.0),
        (130.0, 370.0, 370.0, 392.0),  # P_0: 0.6 370 + 65 = 287 < 370;  P_1: 429 - 37
        (10.0, 370.0, 370.0, 370.0),  # P_1: 33 - 37 < 370
        (900.0, 370.0, 672.0, 2933.0),
    ]
    for thrust, radial, static, working in cases:
        found = palmgren(
            axial_load=thrust, radial_load=radial, ring_speed=700 * math.pi / 30, kinematic_viscosity=41e-6
        )
        viscous = 1e-7 * 2 * (41 * 700) ** (2 / 3) * 38.5**3
        expected = viscous + 5e-4 * (static / 7800) ** 0.55 * working * 38.5
        np.testing.assert_allclose(found * 1e3, expected, rtol=1e-12)  # round-off
    still = palmgren(axial_load=0.0, ring_speed=0.0)
    np.testing.assert_allclose(still * 1e3, 160e-7 * 2 * 38.5**3, rtol=1e-12)


def oiled(**changed: Any) -> Scene:
    scene = load_scene(Path(__file__).parents[2] / "validation" / "scenes" / "6205_physical.toml")
    return replace(scene, **changed)


def test_the_band_of_a_scene_takes_its_oil_and_its_bearing() -> None:
    """0.06 Pa s at 870 kg/m^3; the 6205's 25 and 52 mm and 7.8 kN typed in again."""
    series = Operation(
        axial_load=np.array([1000.0, 620.0]), inner_speed=np.array([-10.5, 47.0]), radial_load=np.array([-370.0, 0.0])
    )
    found = scene_band(oiled(operation=series))
    for name, model in (("SKF", skf), ("Palmgren, z = 0.0006", functools.partial(palmgren, load_factor=6e-4))):
        extra = {"lubrication": "oil_bath"} if name == "SKF" else {}
        expected = model(
            axial_load=[1000.0, 620.0],
            radial_load=[370.0, 0.0],
            ring_speed=[10.5, 47.0],
            kinematic_viscosity=0.06 / 870,
            **extra,
        )
        np.testing.assert_allclose(found.values[name], expected, rtol=1e-13)  # round-off
    assert np.all(found.low < found.high)
    oil = oiled().lubricant
    assert oil is not None
    hotter = replace(oil, temperature=353.15)  # thinner by the factor exp(0.045 x 40) or so
    at_500_rpm = [scene_band(of).values["Palmgren, z = 0.0006"][-1] for of in (oiled(lubricant=hotter), oiled())]
    assert at_500_rpm[0] < at_500_rpm[1]  # SKF's is not: the film breaks down


def test_a_scene_without_a_band_says_why() -> None:
    scene = oiled()
    for change, words in (
        ({"lubricant": None}, "no lubricant"),
        ({"bearing": replace(scene.bearing, static_load_rating=None)}, "static_load_rating is not given"),
        ({"bearing": replace(scene.bearing, bore_diameter=None)}, "bore_diameter is not given"),
        ({"bearing": replace(scene.bearing, outside_diameter=53e-3)}, "25 mm and outside diameter 53 mm fit no"),
        ({"operation": replace(scene.operation, moment=3.0)}, "moment"),
        ({"operation": replace(scene.operation, axial_load=np.array([-3.0]))}, "-3 N is below 0"),
    ):
        with pytest.raises(InputError, match=words):
            scene_band(oiled(**change))


@pytest.mark.parametrize(("rating", "has_band"), [("0.1 N", False), ("899 N", False), ("901 N", True)])
def test_beyond_the_static_rating_there_is_no_band(rating: str, has_band: bool) -> None:
    """The loaded contact angle of the models would pass 90 deg, and their forces would have no root."""
    text = scene_text("6206", axial_load="900 N").replace("[bearing]", f'[bearing]\nstatic_load_rating = "{rating}"', 1)
    result = torque_of_scene(parse_scene(text, origin="here"))
    assert (result.catalogue.band is not None) == has_band
    if not has_band:
        assert "900 N exceeds the static load rating" in result.catalogue.note
    json.dumps(plain(content_of(result)), allow_nan=False)
