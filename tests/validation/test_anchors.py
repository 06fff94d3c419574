"""The numbers that the model is compared with: units of their files, formulas by hand, order of the table."""

import numpy as np
import pytest

from analytic.catalog.bearing_rows import find_bearing
from analytic.errors import InputError
from analytic.makers import CatalogueCase
from analytic.torque import friction_torque
from validation.catalogue.torque import scene_at
from validation.intervals.makers import MAKERS, makers_torques
from validation.measured.anchor import Anchor, first_what_is_missed, published_columns, published_rows
from validation.measured.bearings import (
    HOT_OIL,
    cage_speeds,
    film_6016,
    heat_35mm,
    heat_scene,
    heat_with_oil,
    rolling_cage,
)
from validation.measured.fag import fag_torque

NU, N = 27e-6, 1000 * np.pi / 30  # m2/s, rad/s: nu n = 27 000 mm2/s 1/min, whose power 2/3 is 900


def case(series: str, bore: float, outside: float, rating: float, axial: float, radial: float) -> CatalogueCase:
    """Diameters in mm."""
    return CatalogueCase(series, 1e-3 * bore, 1e-3 * outside, rating, axial, radial, N, NU)


def test_fags_torque_of_a_deep_groove_bearing_by_hand() -> None:
    """d_m 38.5 mm. M_0 = 1e-7 900 38.5^3 f_0 = 5.1360 f_0; M_1 = f_1 sqrt(1000/7800) 1000 38.5 = 13785 f_1, N mm."""
    low, high = fag_torque(case("62", 25, 52, 7800, axial=0, radial=1000))
    assert low == pytest.approx((5.1360 * 1.5 + 13785 * 0.0005) / 1e3, rel=1e-4)  # the digits of the numbers by hand
    assert high == pytest.approx((5.1360 * 2 + 13785 * 0.0009) / 1e3, rel=1e-4)


def test_fags_torque_of_an_angular_contact_bearing_under_both_loads_by_hand() -> None:
    """d_m 60 mm. P_1 = 2000 - 50, P_0 = 250 + 520 N; M_0 = 38.88, M_1 = 0.001 0.0385^0.33 1950 60 = 39.94 N mm."""
    low, high = fag_torque(case("72 B", 40, 80, 20000, axial=2000, radial=500))
    assert low == high == pytest.approx(78.82e-3, rel=1e-4)


def test_fags_torque_at_hardly_any_speed_is_refused() -> None:
    with pytest.raises(InputError, match="at least 2000"):
        fag_torque(case("62", 25, 52, 7800, axial=0, radial=1000)._replace(ring_speed=1.0))


def test_the_film_of_a_6016_in_the_units_of_its_file() -> None:
    film, load = film_6016()
    assert (film.theirs, film.unit) == (0.75, "um")
    # Factor 2: another film formula with the printed radius and ellipticity has 0.71 um
    assert 0.35 < float(np.squeeze(film.ours)) < 1.5
    # Stribeck's 4.37 W/n without clearance, 15 kN on 14 balls; 1 % for the few balls
    assert load.ours == pytest.approx(4.37 * 15e3 / 14, rel=0.01)
    assert load.theirs == pytest.approx(5 * 15e3 / 14, rel=1e-4)  # printed digits


def test_the_heat_is_torque_times_speed() -> None:
    """The measured one as a torque: 350 W at 28 000 rpm, 2932 rad/s, are 0.119 N m."""
    rows, anchor = published_columns("heat_35mm.csv"), heat_35mm()
    assert rows["speed_rpm"].tolist() == [28000, 48000, 64000, 72000]
    assert rows["heat_W"][0] / (rows["speed_rpm"][0] * np.pi / 30) == pytest.approx(0.1194, rel=1e-3)
    power = np.asarray(anchor.ours)
    # Friction of the races alone, whose torque rises with speed: below the heat, above a quarter of it
    assert np.all((0.25 * rows["heat_W"] < power) & (power < rows["heat_W"]))
    assert np.all(np.diff(power / rows["speed_rpm"]) > 0)


def test_the_losses_of_the_oil_grow_faster_than_those_of_the_races() -> None:
    """From the stated flow alone, 760 cm3/min: at least mdot v^2 more than the races have in the thin oil."""
    rows = published_columns("heat_35mm.csv")
    low, high = heat_with_oil(rows["speed_rpm"])
    speed = rows["speed_rpm"] * np.pi / 30
    centre = speed * (46.5e-3 - 7.14e-3 * np.cos(np.deg2rad(24))) / 4
    flow = 760e-6 / 60 * 900 * centre**2  # the ester has 940 kg/m^3 at 15 degC and less when warm
    races = [friction_torque(heat_scene(rows["speed_rpm"], each)).torque.total * speed for each in HOT_OIL]
    assert np.all(low > races[0] + flow)
    assert np.all(high > races[1] + 4 * flow)
    assert np.all((low < rows["heat_W"]) & (rows["heat_W"] < high))


def test_cage_speeds_are_shares_of_pure_rolling() -> None:
    loaded, unknown = cage_speeds()
    assert np.asarray(loaded.theirs) == pytest.approx([0.9995, 0.9984, 0.9994, 1.0026])
    assert np.all(np.asarray(unknown.ours) == 1.0)


def test_a_contact_angle_makes_the_cage_faster() -> None:
    """A radial load leaves the balls in the middle of their grooves: exactly the kinematic speed."""
    row = next(published_rows("cage_speed.csv"))
    assert rolling_cage(row) == pytest.approx(1.0, abs=1e-6)  # of the equilibrium


def test_error_and_uncertainty_are_over_theirs() -> None:
    anchor = made([50.0, 20.0], [40.0, 23.0], uncertainty=[3.0, 2.0])
    np.testing.assert_allclose(anchor.error, [-0.2, 0.15])
    assert anchor.relative_uncertainty == pytest.approx([0.06, 0.1])
    assert anchor.missed == 1  # 10 of 50 is more than 2 times 3; 3 of 20 is less than 2 times 2
    assert made(5.0, [4.0], uncertainty=None).missed is None


def test_what_is_missed_comes_first() -> None:
    held = made(10.0, [12.0], uncertainty=2.0)
    near, far = made(10.0, [9.0], uncertainty=None), made(10.0, [30.0], uncertainty=None)
    missed = made(10.0, [11.0], uncertainty=0.1)
    assert first_what_is_missed([held, near, far, missed]) == [missed, far, near, held]


def made(theirs: float | list[float], ours: list[float], uncertainty: float | list[float] | None) -> Anchor:
    return Anchor(
        what="", source="", kind="measured", theirs=theirs, ours=ours, unit="1", uncertainty=uncertainty, worth=""
    )


def test_all_makers_have_a_torque_of_a_6205_and_no_moment_of_an_angular_contact_bearing_is_in_it() -> None:
    deep = makers_torques(scene_at(find_bearing("6205"), "radial"))
    assert set(deep) == set(MAKERS.values()) - {"Palmgren"}
    assert all(2e-3 < torque < 50e-3 for torque in deep.values())  # N m; the catalogue's own figure is 12 N mm
    angular = makers_torques(scene_at(find_bearing("7208 B"), "radial"))
    assert {name for name in angular if name in MAKERS.values()} >= {"SKF", "Palmgren", "FAG, least factors"}
