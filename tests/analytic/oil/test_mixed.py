"""The shared load: both equations that it solves, its limits, a root in 40 digits, and digits of another program."""

from typing import Any

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import example, given
from scipy.optimize import brentq
from scipy.special import erfc

from analytic.oil.film import Inflow, asymptotes_of, central_film, log_film_of
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.scene import Array, AsperityLaw, Autocorrelation, Surface
from analytic.surface.asperity import log_pressure_at, summit_area
from analytic.surface.gap import GapNumbers, gap_law
from analytic.surface.roughness import gap_roughness
from analytic.surface.truncated_gap import log_mean_gap
from tests.analytic.specimens import hertzian
from tests.contacts import STEEL

E, H = 113.187e9, 7.8e9  # Pa
CONTACT = {
    "curvature_rolling": 310.0,
    "curvature_transverse": 14.7,
    "load": 613.0,
    "modulus": E,
    "entrainment_speed": 0.37,
}
OIL: dict[str, Any] = {"viscosity": 0.061, "pressure_viscosity": 2.1e-8}


def finish(sq: float, length: float = 60e-6, asperities: AsperityLaw = "zhao_maietta_chang") -> Surface:
    """Two surfaces of this roughness against each other, that are cut off where they overlap."""
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 30)
    return Surface(rms_roughness=sq, autocorrelation=correlation, hardness=H, gap="truncated", asperities=asperities)


def rough(
    sq: float, length: float = 60e-6, asperities: AsperityLaw = "zhao_maietta_chang", *, modulus: float = E
) -> GapNumbers:
    surface = finish(sq, length, asperities)
    return gap_law(surface, gap_roughness(surface), modulus=modulus, bodies=(STEEL, STEEL))


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
    found: Any = mixed(rough(0.4e-6), load=np.array([0.0, 1e-300, 1e-12]), entrainment_speed=np.array([[0.3], [0.0]]))
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
