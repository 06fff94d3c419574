"""The shared load against a root in 40 digits, both equations it solves, its limits, and units."""

from dataclasses import replace

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given

from analytic.errors import InputError
from analytic.oil.film import central_film, film_asymptotes
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.scene import Array, Autocorrelation
from analytic.surface.asperity import asperity_contact
from analytic.surface.asperity_table import AsperityTable, tabulated_asperities
from analytic.surface.moments import SpectralMoments, mccool_summits
from analytic.surface.roughness import spectral_moments
from tests.analytic.specimens import hertzian

E, H = 113.187e9, 7.8e9  # Pa
CONTACT = {
    "curvature_rolling": 310.0,
    "curvature_transverse": 14.7,
    "load": 613.0,
    "modulus": E,
    "entrainment_speed": 0.37,
}
OIL = {"viscosity": 0.061, "pressure_viscosity": 2.1e-8}
ACCURACY = 2e-8  # of the share: 1e-8 of the table, twice where both of its splines take part


def rough(sq: float, length: float = 60e-6, *, modulus: float = E, hardness: float = H) -> AsperityTable:
    """Two surfaces of this roughness against each other."""
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 30)
    moments = spectral_moments(rms_roughness=sq, autocorrelation=correlation)
    return tabulated_asperities(summits=mccool_summits(moments + moments), modulus=modulus, hardness=hardness)


def area(load: float = 613.0) -> float:
    return float(hertzian(CONTACT | {"load": load})[0].area)


def mixed(asperities: AsperityTable | None, **changed: object) -> MixedContact:
    contact, rest = hertzian(CONTACT | OIL | changed)
    return mixed_contact(contact, asperities=asperities, **rest)


def smooth_film(**changed: object) -> Array:
    contact, rest = hertzian(CONTACT | OIL | changed)
    return central_film(contact, **rest).thickness


def printed_film(share: mpmath.mpf, **changed: float) -> mpmath.mpf:
    """The film formula as printed, of the load F (1 - s) and the modulus E* (1 - s)."""
    q, given = mpmath.mpf, CONTACT | OIL | changed
    r_x, stiff = 1 / q(given["curvature_rolling"]), 2 * q(given["modulus"]) * (1 - share)
    u = 2 * q(given["viscosity"]) * given["entrainment_speed"] / (stiff * r_x)
    m = q(given["load"]) * (1 - share) / (stiff * r_x**2) * u ** q("-0.75")
    ell, lam = given["pressure_viscosity"] * stiff * mpmath.root(u, 4), q(given["curvature_transverse"]) * r_x
    elastic = 1 + q("0.006") * mpmath.log(lam) + q("0.63") * lam ** (q(4) / 7)
    ri = 145 * (1 + q("0.796") * lam ** (q(14) / 15)) ** (-q(15) / 7) / lam / m**2
    rp = q("1.29") * (1 + q("0.691") * lam) ** (-q(2) / 3) * ell ** (q(2) / 3)
    ei = q("3.18") * elastic ** (-q(14) / 25) * lam ** (-q(1) / 15) * m ** (-q(2) / 15)
    ep = q("1.48") * elastic ** (-q(7) / 20) * lam ** (-q(1) / 24) * m ** (-q(1) / 12) * ell ** q("0.75")
    s = 1.5 * (1 + mpmath.exp(-q("1.2") * ei / ep))
    left = (ri ** q("1.5") + (ei**-4 + (q("1.8") / lam) ** -4) ** (-q(3) / 8)) ** (2 * s / 3)
    return r_x * mpmath.sqrt(u) * (left + (rp**-8 + ep**-8) ** (-s / 8)) ** (1 / s)


def printed_pressure(h: mpmath.mpf, table: AsperityTable) -> mpmath.mpf:
    """Of the asperities, as printed, by quadrature over the heights of the summits."""
    q, summits = mpmath.mpf, table.summits
    radius, s = q(float(summits.radius)), q(float(summits.height_deviation))
    d = h - q(float(summits.mean_height))
    w1 = (3 * mpmath.pi * q("0.4") * q(H) / (4 * q(E))) ** 2 * radius
    w2 = 54 * w1

    def load(z: mpmath.mpf) -> mpmath.mpf:
        w = z - d
        if w < w1:
            force = q(4) / 3 * q(E) * mpmath.sqrt(radius) * w * mpmath.sqrt(w)
        elif w < w2:
            t = (w - w1) / (w2 - w1)
            pressure = q(H) * (1 - q("0.6") * (mpmath.log(w2) - mpmath.log(w)) / (mpmath.log(w2) - mpmath.log(w1)))
            force = pressure * mpmath.pi * radius * w * (1 - 2 * t**3 + 3 * t**2)
        else:
            force = 2 * mpmath.pi * radius * w * q(H)
        return force * mpmath.exp((max(d, 0) ** 2 - z**2) / (2 * s**2)) / (s * mpmath.sqrt(2 * mpmath.pi))

    bottom, top = max(d, -14 * s), mpmath.sqrt(max(d, 0) ** 2 + 200 * s**2)
    steps = [bottom + (top - bottom) * part / 16 for part in (1, 2, 4, 8)]
    breaks = {bottom, top, *(x for x in (d + w1, d + w2, *steps) if bottom < x < top)}
    return q(float(summits.density)) * mpmath.quad(load, sorted(breaks)) * mpmath.exp(-(max(d, 0) ** 2) / (2 * s**2))


@pytest.mark.parametrize(
    ("sq", "changed"),
    [
        (0.1e-6, {}),  # a small share
        (0.02e-6, {}),  # 1e-13 or so
        (1.0e-6, {"load": 48.0}),
        (0.6e-6, {"entrainment_speed": 3e-5}),  # most of the load
        (0.3e-6, {"entrainment_speed": 1e-9, "load": 3.7}),  # all but a thousandth of it
        (0.3e-6, {"pressure_viscosity": 1e-13, "entrainment_speed": 0.02}),  # all but isoviscous
    ],
)
def test_the_root_of_the_printed_equations_in_40_digits(sq: float, changed: dict[str, float]) -> None:
    table, given = rough(sq), CONTACT | changed
    found = mixed(table, **changed)
    with mpmath.workdps(40):
        nominal = mpmath.mpf(area(given["load"]))
        z0 = mpmath.log(float(found.asperity_share) / (1 - float(found.asperity_share)))

        def excess(z: mpmath.mpf) -> mpmath.mpf:
            share = 1 / (1 + mpmath.exp(-z))
            carried = printed_pressure(printed_film(share, **changed), table) * nominal
            return mpmath.log(carried / (share * given["load"]))

        with mpmath.workdps(20):
            z = mpmath.findroot(excess, (z0 * 1.01 + 0.01, z0 * 0.99 - 0.01), solver="secant", tol=1e-24)
        share = 1 / (1 + mpmath.exp(-z))
        film = printed_film(share, **changed)
    np.testing.assert_allclose(float(found.asperity_share), float(share), rtol=ACCURACY)
    np.testing.assert_allclose(float(found.film_thickness), float(film), rtol=ACCURACY)


loads, speeds = (st.floats(a, b).map(lambda power: 10.0**power) for a, b in ((-9, 5), (-9, 2)))
roughnesses = st.sampled_from([3e-9, 0.04e-6, 0.3e-6, 1.1e-6, 7e-6])  # each costs a table


@given(load=loads, speed=speeds, sq=roughnesses, alpha=st.sampled_from([0.0, 2.1e-8]), gap=st.floats(-7, 0))
def test_both_equations_hold(load: float, speed: float, sq: float, alpha: float, gap: float) -> None:
    table, largest_gap = rough(sq), 10.0**gap
    changed = {"load": load, "entrainment_speed": speed, "pressure_viscosity": alpha}
    found = mixed(table, largest_gap=largest_gap, **changed)
    share, h = float(found.asperity_share), float(found.film_thickness)
    assert 0 <= share <= 1
    assert np.isfinite(h)
    assert 0 <= found.area_fraction <= 1
    summits = table.summits
    pressure = float(asperity_contact(film_thickness=h, summits=summits, modulus=E, hardness=H).pressure)
    carried = pressure * area(load)
    if share > 1e-250:  # far below, the pressure of the asperities is no double
        np.testing.assert_allclose(carried, share * load, rtol=1e-7 * (1 + abs(np.log(share)) / 10))  # t in ln p
    if share < 1 - 1e-6:  # 1 - s has lost 6 digits or more beyond
        film = smooth_film(**(changed | {"load": load * (1 - share), "modulus": E * (1 - share)}))
        limit = min(largest_gap, 1 / (310.0 + 14.7))
        np.testing.assert_allclose(h, min(float(film), limit), rtol=1e-8)  # round-off of 1 - s
    assert found.asperity_load == share * load


@given(load=loads, speed=speeds, sq=roughnesses, more=st.floats(1.01, 4.0))
def test_more_speed_takes_load_off_the_asperities(load: float, speed: float, sq: float, more: float) -> None:
    slow, fast = (mixed(rough(sq), load=load, entrainment_speed=u) for u in (speed, speed * more))
    assert fast.asperity_share <= slow.asperity_share * (1 + 1e-12)
    assert fast.film_thickness >= slow.film_thickness * (1 - 1e-12)


def test_rougher_surfaces_bear_more() -> None:
    shares = [float(mixed(rough(sq), load=88.0).asperity_share) for sq in np.geomspace(0.01e-6, 30e-6, 9)]
    assert np.all(np.diff(shares) > 0)
    assert shares[0] < 1e-30
    assert shares[-1] > 0.8


def test_smooth_and_all_but_smooth_surfaces_leave_the_film_alone() -> None:
    film = smooth_film()
    smooth, almost = mixed(None), mixed(rough(1e-10))
    assert smooth.asperity_share == almost.asperity_share == 0
    np.testing.assert_allclose([smooth.film_thickness, almost.film_thickness], film, rtol=1e-15)
    assert smooth.area_fraction == almost.area_fraction == smooth.asperity_load == 0
    slight = mixed(rough(0.03e-6))
    assert 0 < slight.asperity_share < 1e-3
    np.testing.assert_allclose(slight.film_thickness, film, rtol=1e-3)  # no more than the share moves it


def test_standstill_is_not_the_limit_of_slow_running() -> None:
    table = rough(0.4e-6)
    still = mixed(table, entrainment_speed=0.0)
    assert still.without_film
    assert still.asperity_share == 1
    pressure = CONTACT["load"] / area()
    borne = asperity_contact(film_thickness=still.film_thickness, summits=table.summits, modulus=E, hardness=H).pressure
    np.testing.assert_allclose(borne, pressure, rtol=ACCURACY)
    assert still.film_thickness < 0
    speeds = 10.0 ** np.arange(-3, -250, -13)
    slow = mixed(table, entrainment_speed=speeds)
    assert not slow.without_film.any()
    assert np.all(np.diff(slow.asperity_share) >= 0)
    # The oil keeps what asperities leave at h = 0.
    touching = asperity_contact(film_thickness=0.0, summits=table.summits, modulus=E, hardness=H).pressure / pressure
    assert touching < 0.9
    np.testing.assert_allclose(slow.asperity_share[-1], touching, rtol=ACCURACY)
    assert 0 < slow.film_thickness[-1] < 1e-100
    # Under a light load asperities keep the surfaces apart, and standstill is the limit.
    still, slow = (mixed(table, entrainment_speed=u, load=0.02) for u in (0.0, speeds))
    assert still.film_thickness > 0
    np.testing.assert_allclose(slow.film_thickness[-1], still.film_thickness, rtol=1e-9)  # of the table's inverse
    np.testing.assert_allclose(slow.asperity_share[-1], 1, rtol=1e-15)
    still = mixed(table, entrainment_speed=0.0)
    heated = mixed(table, heating_factor=0.0)
    assert heated.without_film
    assert heated.film_thickness == still.film_thickness
    wall = mixed(None, entrainment_speed=0.0)
    assert (wall.asperity_share, wall.film_thickness, wall.area_fraction) == (1, 0, 1)


def test_deep_pressure_makes_the_separation_negative() -> None:
    still = mixed(rough(0.05e-6, 300e-6), entrainment_speed=0.0, load=3000.0)
    assert still.film_thickness < 0
    assert still.area_fraction > 0.05


def test_without_load_nothing_is_shared() -> None:
    table = rough(0.4e-6)
    found = mixed(table, load=np.array([0.0, 1e-300, 1e-12]), entrainment_speed=np.array([[0.3], [0.0]]))
    assert np.all(np.isfinite(found.film_thickness[0]))
    np.testing.assert_array_equal(found.asperity_load[:, 0], 0)
    assert found.capped[0, 0]
    np.testing.assert_allclose(found.film_thickness[0, 0], 1 / (310 + 14.7), rtol=1e-14)


def test_inlet_heating_thins_the_film() -> None:
    table = rough(0.2e-6)
    cold, warm = mixed(table), mixed(table, heating_factor=0.7)
    assert warm.asperity_share > cold.asperity_share
    share = float(warm.asperity_share)
    film = smooth_film(load=613.0 * (1 - share), modulus=E * (1 - share))
    np.testing.assert_allclose(warm.film_thickness, 0.7 * film, rtol=1e-12)


def test_a_pocket_keeps_the_film_within_its_clearance() -> None:
    """A circular, conformal contact under light load, where the formula gives more than the clearance."""
    ball, pocket, gap = 3.97e-3, 4.07e-3, 0.05e-3
    curvature = 1 / ball - 1 / pocket
    given = {
        "curvature_rolling": curvature,
        "curvature_transverse": curvature,
        "modulus": 2.3e9,
        "entrainment_speed": 0.6,
    }
    found = mixed(rough(0.8e-6, modulus=2.3e9), load=np.array([0.01, 28.0]), largest_gap=gap, **given)
    assert found.capped.tolist() == [True, False]
    np.testing.assert_allclose(found.film_thickness[0], gap, rtol=1e-14)
    assert found.film_thickness[1] < gap
    tight = mixed(rough(40e-6), load=3.0, largest_gap=2e-6)  # rougher than the clearance
    assert tight.asperity_share == 1
    assert tight.capped


def test_one_and_many_agree() -> None:
    """More than one block, and every broadcast shape."""
    table, load = rough(0.3e-6), np.geomspace(0.01, 4e3, 5003)
    many = mixed(table, load=load)
    for index in (0, 4095, 4096, 5002):
        np.testing.assert_allclose(many.asperity_share[index], mixed(table, load=load[index]).asperity_share, rtol=1e-9)
    grid = mixed(table, load=load[:3], entrainment_speed=np.array([[0.1], [0.7]]))
    assert grid.film_thickness.shape == grid.capped.shape == grid.outside_range.shape == (2, 3)
    np.testing.assert_allclose(
        grid.asperity_share[1, 2], mixed(table, load=load[2], entrainment_speed=0.7).asperity_share, rtol=1e-9
    )
    assert mixed(table, load=np.zeros(0)).asperity_share.shape == (0,)
    assert mixed(table, curvature_transverse=np.array([14.7, 500.0])).outside_range.tolist() == [False, True]


@given(metre=st.floats(1e-2, 1e2), pascal=st.floats(1e-2, 1e2), second=st.floats(1e-2, 1e2))
def test_physics_does_not_depend_on_the_units(metre: float, pascal: float, second: float) -> None:
    moments = SpectralMoments(height=(0.42e-6 * metre) ** 2, slope=1e-4, curvature=6e4 / metre**2)
    summits = mccool_summits(moments)
    table = tabulated_asperities(summits=summits, modulus=E * pascal, hardness=H * pascal)
    base_table = tabulated_asperities(
        summits=mccool_summits(SpectralMoments(height=0.42e-6**2, slope=1e-4, curvature=6e4)), modulus=E, hardness=H
    )
    found = mixed(
        table,
        curvature_rolling=310.0 / metre,
        curvature_transverse=14.7 / metre,
        load=613.0 * pascal * metre**2,
        modulus=E * pascal,
        entrainment_speed=0.37 * metre / second,
        viscosity=0.061 * pascal * second,
        pressure_viscosity=2.1e-8 / pascal,
    )
    base = mixed(base_table)
    np.testing.assert_allclose(found.asperity_share, base.asperity_share, rtol=1e-9)  # round-off in the knots
    np.testing.assert_allclose(found.film_thickness, base.film_thickness * metre, rtol=1e-9)


@given(share=st.floats(-30, -1e-6), speed=speeds, load=loads)
def test_the_shared_film_is_that_of_less_load_between_softer_bodies(share: float, speed: float, load: float) -> None:
    given = CONTACT | OIL | {"load": load, "entrainment_speed": speed}
    left = np.exp(share)
    softer = given | {"load": load * left, "modulus": E * left}
    # Without a limit by the clearance, which would hide the rest.
    contacts = (hertzian(each) for each in (softer, given))
    reduced, asymptotes = (replace(film_asymptotes(contact, **rest), clearance=np.inf) for contact, rest in contacts)
    log_h, slope = asymptotes.log_film(share)
    np.testing.assert_allclose(log_h, reduced.log_film(0.0)[0], atol=1e-12)  # round-off of logarithms up to 100
    step = 1e-5
    beyond, before = (asymptotes.log_film(share + d)[0] for d in (step, -step))
    np.testing.assert_allclose(slope, (beyond - before) / (2 * step), atol=1e-8)  # round-off of 1e-14 over the step
    full = replace(asymptotes, clearance=log_h - 0.1)
    assert full.log_film(share) == (full.clearance, 0.0)  # it cannot grow


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"semi_axis_rolling": 0.0}, "is 0 under load"),
        ({"semi_axis_transverse": 0.0}, "is 0 under load"),
        ({"semi_axis_transverse": -1e-4}, "semi_axis_transverse must be at least 0"),
        ({"heating_factor": np.nan}, "heating_factor must be at least 0 and finite"),
        ({"largest_gap": 0.0}, "largest_gap must be positive"),
        ({"load": -3.0}, "load must be at least 0"),
        ({"load": np.ones(3), "heating_factor": np.ones(2)}, "give equal lengths"),
        ({"load": np.ones(3), "semi_axis_rolling": np.ones(2)}, "give equal lengths"),
    ],
)
def test_nonsense_is_refused(changed: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        mixed(rough(0.3e-6), **changed)
