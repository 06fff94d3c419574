"""The shared load: both equations that it solves, its limits, a root in 40 digits, and digits of another program."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import example, given
from mpmath import mpf
from scipy.optimize import brentq
from scipy.special import erfc

from analytic.oil.film import Inflow, asymptotes_of, central_film, log_film_of
from analytic.oil.mixed import MOLECULAR_FILM, MixedContact, mixed_contact, oil_beside
from analytic.scene import Array, AsperityLaw, Autocorrelation, Surface
from analytic.surface.asperity import log_pressure_at, separation_of, summit_area
from analytic.surface.gap import SMOOTH_GAP, GapNumbers, gap_law
from analytic.surface.moments import Summits
from analytic.surface.roughness import gap_roughness
from analytic.surface.truncated_gap import log_mean_gap
from tests.analytic.specimens import hertzian
from tests.contacts import STEEL
from tests.validation.hard.lubrication_exact import film, log_over_summits, mean_gap

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


def finish(sq: float, length: float = 60e-6, asperities: AsperityLaw = "zhao_maietta_chang") -> Surface:
    """Two surfaces of this roughness against each other, that are cut off where they overlap."""
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 30)
    return Surface(rms_roughness=sq, autocorrelation=correlation, hardness=H, gap="truncated", asperities=asperities)


def rough(
    sq: float, length: float = 60e-6, asperities: AsperityLaw = "zhao_maietta_chang", *, modulus: float = E
) -> GapNumbers:
    surface = finish(sq, length, asperities)
    return gap_law(surface, gap_roughness(surface), modulus=modulus, bodies=(STEEL, STEEL))


def summits_of(sq: float) -> Summits:
    return gap_roughness(finish(sq)).summits


def area(load: float = 613.0) -> float:
    contact, _ = hertzian(CONTACT | {"load": load})
    return float(np.pi * contact.semi_axis_rolling * contact.semi_axis_transverse)


def mixed(gap: GapNumbers, **changed: object) -> MixedContact:
    contact, rest = hertzian(CONTACT | OIL | changed)
    factors = {name: rest.pop(name) for name in ("film_factor", "pressure_factor", "share_step") if name in rest}
    inflow = Inflow(rest.pop("entrainment_speed"), **rest)
    return mixed_contact(contact, asymptotes_of(contact, inflow), gap, **factors)


def smooth_film(**changed: object) -> Array:
    contact, rest = hertzian(CONTACT | OIL | changed)
    return central_film(contact, **rest).thickness


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
    heated = mixed(gap, film_factor=0.0)
    assert heated.without_film
    assert heated.film_thickness == still.film_thickness
    assert heated.boundary_share == 1
    wall = mixed(SMOOTH_GAP, entrainment_speed=0.0)
    assert (wall.asperity_share, wall.film_thickness, wall.area_fraction) == (1, 0, 1)
    assert (wall.boundary_share, *oil_beside(wall)) == (1, 0, 0)


@pytest.mark.parametrize("sq", [0.2e-6, 0.6e-6])
def test_a_step_leads_to_the_measured_share(sq: float) -> None:
    """Of friction in a ball-on-disc rig, erfc(lambda/2); the power between is that of the ratio of both shares."""
    gap, speeds = rough(sq), np.geomspace(1e-6, 2.0, 60)
    own = mixed(gap, entrainment_speed=speeds)
    assert np.all(own.asperity_share > 0)
    wanted = erfc(smooth_film(entrainment_speed=speeds) / gap.truncated.deviation / 2)
    powers = np.minimum(own.asperity_share**0.6 * wanted**0.4, 1.0)
    shares = {step: mixed(gap, entrainment_speed=speeds, share_step=step) for step in (-7.0, -1.0, 0.4, 1.0, 7.0)}
    for step, found in shares.items():
        # The film and the area that asperities touch are those of the gap.
        np.testing.assert_array_equal(found.film_thickness, own.film_thickness)
        np.testing.assert_array_equal(found.area_fraction, own.area_fraction)
        assert np.all(np.diff(found.asperity_share) <= 0), step  # with the speed
    for step, expected in ((1.0, wanted), (0.4, powers)):
        np.testing.assert_allclose(
            shares[step].asperity_share, expected, rtol=1e-12
        )  # round-off of the film's logarithm
    np.testing.assert_array_equal(shares[7.0].asperity_share, shares[1.0].asperity_share)  # no law is beyond
    np.testing.assert_array_equal(shares[-7.0].asperity_share, shares[-1.0].asperity_share)


def test_without_load_nothing_is_shared() -> None:
    found = mixed(rough(0.4e-6), load=np.array([0.0, 1e-300, 1e-12]), entrainment_speed=np.array([[0.3], [0.0]]))
    assert np.all(np.isfinite(found.film_thickness[0]))
    np.testing.assert_array_equal(found.asperity_share[:, 0], 0)
    np.testing.assert_array_equal(found.boundary_share[:, 0], [0, 1])
    assert found.capped[0, 0]
    np.testing.assert_allclose(found.film_thickness[0, 0], 1 / (310 + 14.7), rtol=1e-14)


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


def film_of(share: mpf, given: dict[str, float]) -> mpf:
    """Of the load F (1 - s) and the modulus E* (1 - s)."""
    names = {
        "along": "curvature_rolling",
        "across": "curvature_transverse",
        "load": "load",
        "modulus": "modulus",
        "speed": "entrainment_speed",
        "alpha": "pressure_viscosity",
    }
    return film(**{name: given[key] for name, key in names.items()}, borne=1 - share)


@pytest.mark.parametrize(
    ("sq", "changed"),
    [
        (0.1e-6, {}),  # a small share
        (0.016e-6, {}),  # 1e-11 or so
        (0.6e-6, {"entrainment_speed": 3e-5}),  # most of the load
        (0.3e-6, {"entrainment_speed": 1e-9, "load": 3.7}),  # all but 1e-6 of it
    ],
)
def test_the_root_of_the_printed_equations_in_40_digits(sq: float, changed: dict[str, float]) -> None:
    """The unknown is the separation of the mean planes, from which everything follows without an inverse."""
    gap, given = rough(sq), CONTACT | OIL | changed
    found = mixed(gap, **changed)
    log_pressure = np.log(found.asperity_share * given["load"] / area(given["load"]))
    start, slope = (float(part) for part in separation_of(gap.cubics, gap.truncated.summits, log_pressure))
    step = -0.1 * slope * (1 - float(found.asperity_share))  # a tenth of 1 - s
    with mpmath.workdps(40):
        nominal, summits = mpf(area(given["load"])), summits_of(sq)
        of = tuple(
            mpf(float(each))
            for each in (summits.density, summits.radius, summits.height_deviation, summits.mean_height)
        )

        def share(d: mpf) -> mpf:
            return mpmath.exp(log_over_summits((d - of[3]) / of[2], of, modulus=E)) * nominal / given["load"]

        def excess(d: mpf) -> mpf:
            return mpmath.log(mean_gap(d, mpf(gap.truncated.deviation)) / film_of(share(d), given))

        with mpmath.workdps(20):
            d = mpmath.findroot(excess, (start + step, start + step / 2), solver="secant", tol=1e-24)
        exact = share(d)
        thickness = film_of(exact, given)
        remaining = float(1 - exact)
    np.testing.assert_allclose(float(found.asperity_share), float(exact), rtol=ACCURACY)
    np.testing.assert_allclose(float(found.film_thickness), float(thickness), rtol=ACCURACY)
    # The splines' error in the gap is that of the film, which grows at least as (1 - s)^-1/2; round-off of 1 - s.
    if remaining < 0.5:
        np.testing.assert_allclose(1 - found.asperity_share, remaining, rtol=2 * ACCURACY, atol=1e-15)
