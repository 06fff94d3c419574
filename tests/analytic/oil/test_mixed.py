"""The shared load: both equations that it solves, and its limits."""

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import example, given
from scipy.optimize import brentq
from scipy.special import erfc

from analytic.oil.film import Inflow, asymptotes_of, log_film_of
from analytic.oil.mixed import MOLECULAR_FILM, oil_beside
from analytic.surface.asperity import log_pressure_at, summit_area
from analytic.surface.gap import SMOOTH_GAP, GapNumbers
from analytic.surface.truncated_gap import log_mean_gap
from tests.analytic.oil.mixed_contacts import ACCURACY, CONTACT, OIL, E, area, mixed, rough, smooth_film
from tests.analytic.specimens import hertzian

loads, speeds = (st.floats(a, b).map(lambda power: 10.0**power) for a, b in ((-9, 5), (-9, 2)))
roughnesses = st.sampled_from([3e-9, 0.04e-6, 0.3e-6, 1.1e-6, 7e-6])  # each costs a table


def separation(height: float, gap: GapNumbers) -> float:
    """d, m, at which the mean gap is this: not by the table's inverse, from which the height follows."""
    deviation = gap.truncated.deviation
    wanted = np.log(height / deviation)
    low, high = -np.sqrt(2 * max(-wanted, 0.0)) - 2, height / deviation + 1
    return deviation * float(brentq(lambda x: float(log_mean_gap(x)[0]) - wanted, low, high, xtol=1e-15))  # pyright: ignore[reportArgumentType]


@given(load=loads, speed=speeds, sq=roughnesses, alpha=st.sampled_from([0.0, 2.1e-8]), room=st.floats(-7, 0))
@example(load=1.3, speed=1.1, sq=1.1e-6, alpha=0.0, room=-5.75)  # the film fills a clearance narrower than the gap
def test_both_equations_hold(load: float, speed: float, sq: float, alpha: float, room: float) -> None:
    gap, largest_gap = rough(sq), 10.0**room
    changed = {"load": load, "entrainment_speed": speed, "pressure_viscosity": alpha}
    found = mixed(gap, largest_gap=largest_gap, **changed)
    share, h = float(found.asperity_share), float(found.film_thickness)
    assert 0 <= share <= found.boundary_share <= 1
    assert np.isfinite(h)
    assert 0 <= found.area_fraction <= 1
    np.testing.assert_allclose(found.boundary_share, share + (1 - share) * np.exp(-h / 1e-9), rtol=1e-15)
    if h > 1e-300:  # far below, it is no double
        d = separation(h, gap)
        table = gap.cubics, gap.truncated.summits
        carried = float(np.exp(log_pressure_at(*table, d))) * area(load)
        if share > 0:
            # The table's 1e-8, and that of d as pressure and area amplify it.
            np.testing.assert_allclose(carried, share * load, rtol=1e-7 * (1 + abs(np.log(share)) / 10))
            np.testing.assert_allclose(
                found.area_fraction, summit_area(*table, d), rtol=1e-7 * (1 + abs(np.log(share)) / 10)
            )
        else:
            assert carried < 5e-18 * load  # e^-40: nothing beside it
    if share < 1 - 1e-6:  # 1 - s has lost 6 digits or more beyond
        film = smooth_film(**(changed | {"load": load * (1 - share), "modulus": E * (1 - share)}))
        limit = min(largest_gap, 1 / (310.0 + 14.7))
        np.testing.assert_allclose(h, min(float(film), limit), rtol=1e-8)  # round-off of 1 - s


def test_smooth_and_all_but_smooth_surfaces_leave_the_film_alone() -> None:
    film = smooth_film()
    smooth, almost = mixed(SMOOTH_GAP), mixed(rough(1e-10))
    assert smooth.asperity_share == almost.asperity_share == 0
    np.testing.assert_allclose([smooth.film_thickness, almost.film_thickness], film, rtol=1e-15)
    assert smooth.area_fraction == almost.area_fraction == 0
    np.testing.assert_allclose(smooth.boundary_share, np.exp(-film / MOLECULAR_FILM), rtol=1e-12)
    slight = mixed(rough(0.03e-6))
    assert 0 < slight.asperity_share < 1e-3
    np.testing.assert_allclose(slight.film_thickness, film, rtol=1e-3)  # no more than the share moves it


def test_standstill_is_the_limit_of_slow_running() -> None:
    gap = rough(0.4e-6)
    still = mixed(gap, entrainment_speed=0.0)
    assert still.without_film
    assert still.asperity_share == still.boundary_share == 1
    assert oil_beside(still)[0] == 0
    pressure = CONTACT["load"] / area()
    d = separation(float(still.film_thickness), gap)
    table = gap.cubics, gap.truncated.summits
    np.testing.assert_allclose(log_pressure_at(*table, d), np.log(pressure), atol=ACCURACY)
    np.testing.assert_allclose(summit_area(*table, d), still.area_fraction, rtol=ACCURACY)
    speeds = 10.0 ** np.arange(-3, -250, -13)
    slow = mixed(gap, entrainment_speed=speeds)
    assert not slow.without_film.any()
    assert np.all(np.diff(slow.asperity_share) >= 0)
    for name in ("asperity_share", "boundary_share", "film_thickness", "area_fraction"):
        np.testing.assert_allclose(getattr(slow, name)[-1], getattr(still, name), rtol=1e-12)
    np.testing.assert_allclose(
        oil_beside(slow)[0][-1], (1 - still.area_fraction) * still.film_thickness / 1e-9, rtol=1e-3
    )
    heated = mixed(gap, film_factor=0.0)
    assert heated.without_film
    assert heated.film_thickness == still.film_thickness
    assert heated.boundary_share == 1
    wall = mixed(SMOOTH_GAP, entrainment_speed=0.0)
    assert (wall.asperity_share, wall.film_thickness, wall.area_fraction) == (1, 0, 1)
    assert (wall.boundary_share, *oil_beside(wall)) == (1, 0, 0)


def test_oil_shears_beside_the_asperities_alone() -> None:
    found = mixed(rough(0.4e-6, 20e-6), entrainment_speed=np.array([1e-4, 1e-2, 1.0]))
    area_fraction, h, (sheared, thickness) = found.area_fraction, found.film_thickness, oil_beside(found)
    assert np.all(area_fraction > 0.05)
    np.testing.assert_allclose(sheared, (1 - area_fraction) * (1 - np.exp(-h / 1e-9)), rtol=1e-12)
    np.testing.assert_allclose(thickness * (1 - area_fraction), h, rtol=1e-14)  # the same volume
    assert sheared[0] < 0.9 * sheared[-1]
    full = mixed(rough(0.05e-6, 300e-6), load=3000.0, entrainment_speed=0.0)
    assert full.area_fraction == 1
    assert oil_beside(full) == (0, 0)


@pytest.mark.parametrize("sq", [0.2e-6, 0.6e-6])
def test_a_step_leads_to_the_measured_share(sq: float) -> None:
    """Of friction in a ball-on-disc rig, erfc(lambda/2); the power between is that of the ratio of both shares."""
    gap, speeds = rough(sq), np.geomspace(1e-6, 2.0, 60)
    own = mixed(gap, entrainment_speed=speeds)
    assert np.all(own.asperity_share > 0)
    film_ratio = smooth_film(entrainment_speed=speeds) / gap.truncated.deviation
    shares = {step: mixed(gap, entrainment_speed=speeds, share_step=step) for step in (-7.0, -1.0, -0.3, 0.4, 1.0, 7.0)}
    wanted = erfc(film_ratio / 2)
    np.testing.assert_allclose(shares[1.0].asperity_share, wanted, rtol=1e-12)  # round-off of the film's logarithm
    for step, found in shares.items():
        # The film and the area that asperities touch are those of the gap.
        np.testing.assert_array_equal(found.film_thickness, own.film_thickness)
        np.testing.assert_array_equal(found.area_fraction, own.area_fraction)
        assert np.all((found.asperity_share >= 0) & (found.asperity_share <= 1))
        assert np.all(np.diff(found.asperity_share) <= 0), step  # with the speed
        boundary = found.asperity_share + (1 - found.asperity_share) * np.exp(-own.film_thickness / MOLECULAR_FILM)
        np.testing.assert_allclose(found.boundary_share, boundary, rtol=1e-15)
    powers = np.minimum(own.asperity_share**0.6 * wanted**0.4, 1.0)
    np.testing.assert_allclose(shares[0.4].asperity_share, powers, rtol=1e-12)
    np.testing.assert_array_equal(shares[7.0].asperity_share, shares[1.0].asperity_share)  # no law is beyond
    np.testing.assert_array_equal(shares[-7.0].asperity_share, shares[-1.0].asperity_share)
    above = np.stack([found.asperity_share for found in shares.values()])[:, wanted > own.asperity_share]
    assert np.all(np.diff(above, axis=0) >= 0)  # with the step


def test_both_laws_of_the_share_have_the_same_limits() -> None:
    gap = rough(0.4e-6)
    for step in (-1.0, 0.5, 1.0):
        still = mixed(gap, entrainment_speed=0.0, share_step=step)
        assert still.asperity_share == still.boundary_share == 1
        slow = mixed(gap, entrainment_speed=1e-200, share_step=step)
        np.testing.assert_allclose(slow.asperity_share, 1.0, rtol=1e-12)
        # A film of 20 rms heights: what a power of the ratio leaves of a share below 1e-40.
        assert mixed(gap, entrainment_speed=1e4, share_step=step).asperity_share < 1e-15
        assert mixed(SMOOTH_GAP, entrainment_speed=0.3, share_step=step).asperity_share == 0
        assert mixed(gap, load=0.0, share_step=step).asperity_share == 0


def test_without_load_nothing_is_shared() -> None:
    found = mixed(rough(0.4e-6), load=np.array([0.0, 1e-300, 1e-12]), entrainment_speed=np.array([[0.3], [0.0]]))
    assert np.all(np.isfinite(found.film_thickness[0]))
    np.testing.assert_array_equal(found.asperity_share[:, 0], 0)
    np.testing.assert_array_equal(found.boundary_share[:, 0], [0, 1])
    assert found.capped[0, 0]
    np.testing.assert_allclose(found.film_thickness[0, 0], 1 / (310 + 14.7), rtol=1e-14)


def test_a_factor_thins_the_film() -> None:
    gap = rough(0.2e-6)
    cold, warm = mixed(gap), mixed(gap, film_factor=0.7)
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
    tight = mixed(rough(25e-6), load=3.0, largest_gap=2e-6)  # rougher than the clearance
    assert tight.asperity_share == 1
    assert tight.capped


@given(share=st.floats(-30, -1e-6), speed=speeds, load=loads)
def test_the_shared_film_is_that_of_less_load_between_softer_bodies(share: float, speed: float, load: float) -> None:
    left, films = np.exp(share), []
    for factor in (left, 1.0):
        contact, _ = hertzian(CONTACT | {"load": load * factor, "modulus": E * factor})
        # Without a limit by the clearance, which would hide the rest.
        films.append(asymptotes_of(contact, Inflow(speed, **OIL))._replace(clearance=np.inf))
    reduced, film = films
    log_h, slope = log_film_of(film, share)
    np.testing.assert_allclose(log_h, log_film_of(reduced, 0.0)[0], atol=1e-12)  # round-off of logarithms up to 100
    step = 1e-5
    beyond, before = (log_film_of(film, share + d)[0] for d in (step, -step))
    np.testing.assert_allclose(slope, (beyond - before) / (2 * step), atol=1e-8)  # round-off of 1e-14 over the step
    full = film._replace(clearance=log_h - 0.1)
    assert log_film_of(full, share) == (full.clearance, 0.0)  # it cannot grow
