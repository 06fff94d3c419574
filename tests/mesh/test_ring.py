"""The mesh of a ring: its nodes on seat, groove and sides, and its contact nodes at those of the race."""

from dataclasses import replace

import numpy as np
import pytest
from skfem import Basis, ElementHex2

from analytic.errors import InputError
from analytic.scene import Contact, Ring
from fembearing.mesh.footprint import Footprint, as_quarter
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.race import race_block
from fembearing.mesh.recipe import load_recipe
from fembearing.mesh.ring import COARSENING, into_ring, ring_piece
from tests import contacts
from tests.contacts import INNER_RING, OUTER_RING

STEEPER = 1 / np.cos(0.3)
INNER = replace(
    contacts.INNER, contact_angle=0.3, rolling_radius=15.53e-3 * STEEPER + 4.13e-3 * (STEEPER - 1), ring=INNER_RING
)
OUTER = replace(
    contacts.OUTER,
    contact_angle=0.3,
    rolling_radius=-23.48e-3 * STEEPER + 4.21e-3 * (STEEPER - 1),
    shoulder=2.14e-3,
    ring=OUTER_RING,
)
AXES = (0.103e-3, 0.93e-3)
RACE = load_recipe("race")
BOTH = pytest.mark.parametrize("contact", [INNER, OUTER], ids=["inner", "outer"])


def ring_of(contact: Contact) -> Ring:
    assert contact.ring is not None
    return contact.ring


def radii(contact: Contact, place: np.ndarray) -> np.ndarray:
    """Distance from the bearing's axis, m."""
    return np.hypot(place[0], ring_of(contact).bottom_radius + np.sign(contact.rolling_radius) * place[2])


@BOTH
def test_nodes_lie_on_seat_groove_and_lands(contact: Contact) -> None:
    ring, body = ring_of(contact), ring_piece(contact, RACE, 2, AXES).body
    place = body.mesh.doflocs
    np.testing.assert_allclose(radii(contact, place[:, body.clamped]), ring.seat_radius, rtol=1e-12)  # round-off
    assert body.clamped.size == body.surface.size  # every column reaches the seat
    surface = place[:, body.surface]
    radius, side = radii(contact, surface), np.sign(contact.rolling_radius)
    in_groove = np.abs(surface[1]) < ring.shoulder_half_widths[0]
    centre = ring.bottom_radius + side * contact.groove_radius
    profile = np.hypot(radius - centre, surface[1])[in_groove]
    np.testing.assert_allclose(profile, contact.groove_radius, rtol=1e-12)
    assert np.ptp(radius[~in_groove]) < 1e-12  # m: the lands are cylinders
    np.testing.assert_allclose([place[1].min(), place[1].max()], [-ring.width / 2, ring.width / 2], rtol=1e-12)
    assert mesh_quality(body.mesh).valid


@pytest.mark.parametrize(("thickness", "reach"), [(3.1e-3, 4 * 3.1e-3), (14.7e-3, 0.9 * np.pi * 15.53e-3)])
def test_the_piece_reaches_four_thicknesses_and_never_round_the_whole_ring(thickness: float, reach: float) -> None:
    """Along the bottom of the groove, from under the ball to the cut."""
    ring = replace(INNER_RING, seat_radius=INNER_RING.bottom_radius - thickness)
    piece = ring_piece(replace(INNER, ring=ring), RACE, 2, AXES)
    end = piece.body.mesh.doflocs[:, piece.end]
    angle = np.arctan2(end[0], ring.bottom_radius + end[2])
    np.testing.assert_allclose(angle * ring.bottom_radius, reach, rtol=1e-9)  # round-off


@pytest.mark.parametrize("wider", [1, 6])
def test_cells_beyond_the_block_of_the_race_grow_by_steps_to_the_side(wider: int) -> None:
    """Threefold in two steps on the second level, also where the side, at 45 mm, is beyond the end of the piece."""
    ring = replace(INNER_RING, width=wider * INNER_RING.width)
    body = ring_piece(replace(INNER, ring=ring), RACE, 2, AXES).body
    surface = body.mesh.doflocs[:, body.surface]
    across = np.unique(np.round(surface[1, np.abs(surface[0]) < 1e-9], 9))  # m: under the ball, to a nanometre
    steps = np.diff(across)[-10:]
    assert (steps[1:] / steps[:-1]).max() < 1.01 * COARSENING ** (1 / 2)  # the frame of the ring is tilted


@BOTH
def test_its_volume_is_that_of_the_revolved_section(contact: Contact) -> None:
    ring, piece = ring_of(contact), ring_piece(contact, RACE, 3, AXES)
    basis = Basis(piece.body.mesh, ElementHex2(), intorder=5)
    end = piece.body.mesh.doflocs[:, piece.end]
    angle = np.arctan2(end[0], ring.bottom_radius + np.sign(contact.rolling_radius) * end[2])
    assert np.ptp(angle) < 1e-9  # rad: the cut lies on a plane through the axis
    y = np.linspace(-ring.width / 2, ring.width / 2, 20001)
    across = np.minimum(np.abs(y), ring.shoulder_half_widths[0])
    rise = contact.groove_radius - np.sqrt(contact.groove_radius**2 - across**2)
    radius = ring.bottom_radius + np.sign(contact.rolling_radius) * rise
    section = np.trapezoid(np.abs(radius**2 - ring.seat_radius**2) / 2, y)
    # 0.3 %: the shoulders' kinks run through cells, whose sides are curves of second degree.
    np.testing.assert_allclose(basis.dx.sum(), section * angle.mean(), rtol=3e-3)


@BOTH
def test_touching_nodes_are_those_of_the_race(contact: Contact) -> None:
    piece = ring_piece(contact, RACE, 2, AXES)
    body = piece.body
    race = race_block(contact, RACE, 2, Footprint(semi_axes=AXES, half=True), False)
    tilt, radius = contact.contact_angle, contact.groove_radius
    centre = np.array([[0.0], [radius * np.sin(tilt)], [radius * (1 - np.cos(tilt))]])
    places = race.mesh.doflocs[:, race.touching]
    found = body.mesh.doflocs[:, body.touching]
    np.testing.assert_allclose(found, centre + into_ring(contact, places), rtol=0, atol=1e-9 * AXES[0])
    assert np.unique(body.touching).size == race.touching.size
    quarter = race_block(as_quarter(contact, "even"), RACE, 2, Footprint(semi_axes=AXES), False)
    mirrored = np.abs(quarter.mesh.doflocs[:2, quarter.touching][:, piece.quarter])
    np.testing.assert_allclose(mirrored, np.abs(places[:2]), rtol=0, atol=1e-3 * AXES[0])  # the tilt moves them by 1e-4
    np.testing.assert_array_equal(piece.side, np.sign(np.where(np.abs(places[1]) < 1e-12 * AXES[0], 0.0, places[1])))


def test_the_frames_differ_by_a_rotation() -> None:
    turned = into_ring(INNER, np.eye(3))
    np.testing.assert_allclose(turned @ turned.T, np.eye(3), atol=1e-15)
    # The load's direction at contact angle 0.3, on the side where y > 0: into the ring and away from its middle.
    np.testing.assert_allclose(into_ring(INNER, np.array([0.0, 0.0, -1.0])), [0, np.sin(0.3), -np.cos(0.3)], rtol=1e-15)


@pytest.mark.parametrize(
    ("contact", "words"),
    [
        (replace(INNER, ring=None), ("bore_diameter", "width")),
        (replace(OUTER, ring=None), ("outside_diameter", "width")),
        (replace(INNER, ring=replace(ring_of(INNER), width=4.4e-3)), ("372 N", "lower the load", "bearing.width")),
        (replace(INNER, pair="pocket"), ("pocket", "'wall'")),
    ],
)
def test_a_ring_that_cannot_be_meshed_is_refused(contact: Contact, words: tuple[str, ...]) -> None:
    with pytest.raises(InputError) as problem:
        ring_piece(contact, RACE, 1, AXES)
    assert all(word in str(problem.value) for word in words), problem.value
