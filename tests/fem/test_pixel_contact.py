"""The pixels of a contact and their half spaces, against the rectangles themselves and against point forces."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import Array
from fembearing.fem.compliance import PairCompliance
from fembearing.fem.half_space import contact_modulus, pressed_rectangle
from fembearing.fem.pixel_contact import PIXELS, WIDEST, pixels_of, press_pair
from fembearing.mesh.footprint import as_quarter
from fembearing.mesh.race import distance_to_race
from tests.contacts import INNER

RATIO = 3.3201169227365472  # exp(1.2): one of the axis ratios that pixels have
ROLLING = 0.11e-3  # m


@pytest.fixture(scope="module")
def even() -> PairCompliance:
    return PairCompliance(contact=INNER, level=1, semi_axes=(ROLLING, RATIO * ROLLING), added=np.zeros((6, 6)))


def test_a_pixel_yields_under_four_rectangles(even: PairCompliance) -> None:
    """A force on each pixel and on its images beyond both axes."""
    pixels = pixels_of(even)
    half_sides = WIDEST / PIXELS * ROLLING / 2, WIDEST / PIXELS * ROLLING * RATIO / 2
    random = np.random.default_rng(8)
    place, loaded = random.integers(pixels.x.size, size=(2, 40))
    loaded[:5] = place[:5]
    expected = np.zeros(40)
    for side_x in (1, -1):
        for side_y in (1, -1):
            apart = pixels.x[place] - side_x * pixels.x[loaded], pixels.y[place] - side_y * pixels.y[loaded]
            # A corner straight above or beside a place would have no logarithm: its part is 0.
            expected += pressed_rectangle(*(each + 1e-13 for each in apart), half_sides=half_sides)
    expected /= np.pi * contact_modulus(even.contact)
    np.testing.assert_allclose(pixels.compliance[place, loaded], expected, rtol=1e-7)  # 1e-13 m of a pixel of 8e-6


def test_a_pressed_pair_yields_as_its_own_force_has_it(even: PairCompliance) -> None:
    """Pressed on the gap that its displacement leaves, it has the same force: the rounds have come to their end."""
    root = np.random.default_rng(5).normal(size=(6, 6))
    pair = replace(even, added=0.03 * root @ root.T / (even.modulus * ROLLING))
    load = 23.0  # N
    found, pixels = press_pair(pair, load=load), pixels_of(pair)
    plane = np.array([pixels.x, pixels.y]) / pair.contact.ball_radius
    lever = np.sqrt(1 - np.sum(plane**2, axis=0))
    gap = distance_to_race(as_quarter(pair.contact, "even"), np.vstack([plane, -lever]))
    added = pair.added_displacement(pixels.x, pixels.y, 4 * found.force)

    def force_on(gap: Array) -> Array:
        return pixels.pressed(gap=gap, lever=lever, load=load, start=found.force > 0)[0]

    assert found.force @ lever == pytest.approx(load / 4, rel=1e-9)
    largest = found.force.max()
    assert np.abs(force_on(gap + added) - found.force).max() < 1e-5 * largest  # of 1e-7 of the approach
    assert np.abs(force_on(gap) - found.force).max() > 0.01 * largest
