"""Friction on meshed bodies: the influence against its parts, limits, and what true shapes change in a 6205."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import Contact
from fembearing.check.creep.meshed_bodies import MeshedBodies
from fembearing.check.creep.scene_creep import creep_of
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.rolling import pressed_slip, rolling_surfaces
from fembearing.creep.strips import Strips, ellipse_strips, hertz_pressure
from fembearing.fem.compliance import WHOLE, PairCompliance, meshed_pair
from fembearing.fem.traction import ALONG, NORMAL, Axis, Term
from tests.check.creep.test_scene_creep import THRUST, scene_of
from tests.contacts import NITRIDE


@pytest.fixture(scope="module")
def contact(contacts: dict[str, Contact]) -> Contact:
    return replace(contacts["inner"], race_material=NITRIDE)


@pytest.fixture(scope="module")
def pair(contact: Contact) -> PairCompliance:
    return meshed_pair(contact)


@pytest.fixture(scope="module")
def half_spaces(contact: Contact) -> HalfSpaces:
    return HalfSpaces(ball=contact.ball_material, race=contact.race_material)


@pytest.fixture(scope="module")
def strips(pair: PairCompliance) -> Strips:
    a, b = pair.semi_axes
    return ellipse_strips(semi_axis_rolling=1.01 * a, semi_axis_transverse=0.98 * b, count=7, cells=5)


def only(pair: PairCompliance, moves: Term, by: Term, value: float) -> PairCompliance:
    """One entry of the compliance in place of all."""
    added = np.zeros((len(WHOLE), len(WHOLE)))
    added[WHOLE.index(moves), WHOLE.index(by)] = value
    return replace(pair, added=added)


@pytest.mark.parametrize("moves", [Term(0, 2, 1), Term(1, 0, 3)])
@pytest.mark.parametrize("by", [Term(0, 1, 0), Term(1, 1, 2)])
def test_a_traction_moves_as_its_moment_says(
    pair: PairCompliance, half_spaces: HalfSpaces, strips: Strips, moves: Term, by: Term
) -> None:
    """u = c X^i Y^j int X^k Y^l t dA, of the one component by the one traction and of nothing else."""
    bodies = MeshedBodies(half_spaces=half_spaces, compliance=only(pair, moves, by, 3.1e-9))
    a, b = pair.semi_axes
    x, y = np.array([0.31, -0.52]) * a, np.array([-0.44, 0.13]) * b
    traction = 1e8 * np.random.default_rng(3).uniform(-1, 1, (2, strips.x.size))
    added = bodies.by_traction(strips, x, y) - half_spaces.by_traction(strips, x, y)
    found = np.einsum("ijpn,jn->ip", added, traction)
    at_x, at_y = strips.x.ravel() / a, strips.y.ravel() / b
    inwards = 1 / np.maximum(1, np.hypot(at_x, at_y))
    moment = (inwards * at_x) ** by.of_x * (inwards * at_y) ** by.of_y * strips.area.ravel() @ traction[by.axis]
    expected = np.zeros((2, 2))
    expected[moves.axis] = 3.1e-9 * moment * (x / a) ** moves.of_x * (y / b) ** moves.of_y
    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-6 * np.abs(expected).max())  # of a difference


@pytest.mark.parametrize("moves", [Term(0, 2, 1), Term(1, 0, 1)])
def test_a_pressure_moves_as_its_moment_says(
    pair: PairCompliance, half_spaces: HalfSpaces, strips: Strips, moves: Term
) -> None:
    by = Term(NORMAL, 1, 0)
    bodies = MeshedBodies(half_spaces=half_spaces, compliance=only(pair, moves, by, 3.1e-9))
    a, b = pair.semi_axes
    x, y = np.array([0.31, -0.52]) * a, np.array([-0.44, 0.13]) * b
    pressure = 1e9 * np.random.default_rng(4).uniform(0, 1, strips.x.shape)
    found = bodies.by_pressure(strips, pressure, x, y) - half_spaces.by_pressure(strips, pressure, x, y)
    at_x, at_y = strips.x / a, strips.y / b
    moment = np.sum(at_x / np.maximum(1, np.hypot(at_x, at_y)) * pressure * strips.area)
    expected = np.zeros((2, 2))
    expected[moves.axis] = 3.1e-9 * moment * (x / a) ** moves.of_x * (y / b) ** moves.of_y
    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-6 * np.abs(expected).max())  # of a difference


def test_work_is_mutual(pair: PairCompliance, half_spaces: HalfSpaces, strips: Strips) -> None:
    """Betti: the displacement of one rectangle by a force on another one is that the other way round."""
    bodies = MeshedBodies(half_spaces=half_spaces, compliance=pair)
    middles = strips.x.ravel(), strips.y.ravel()
    added = bodies.by_traction(strips, *middles) - half_spaces.by_traction(strips, *middles)
    by_force = added / strips.area.ravel()
    size = np.abs(by_force).max()
    assert np.abs(by_force[0, 1]).max() > 0.02 * size  # the components are coupled
    np.testing.assert_allclose(by_force, by_force.transpose(1, 0, 3, 2), atol=0.02 * size)  # of a first level


def test_pressure_stretches_without_a_part_in_the_rolling_radius(
    pair: PairCompliance, half_spaces: HalfSpaces, strips: Strips
) -> None:
    """The slip by pressure that the shapes add changes across the contact, and is 0 in its centre."""
    even = replace(half_spaces, race=half_spaces.ball)
    bodies = MeshedBodies(half_spaces=even, compliance=pair)
    slip = pressed_slip(strips, bodies, hertz_pressure(strips, load=pair.contact.load))
    middle = strips.middle.size // 2
    centre = slip[:, middle, slip.shape[2] // 2 - 1 : slip.shape[2] // 2 + 1].mean(axis=1)
    assert np.abs(slip[0]).max() > 1e-5
    assert abs(centre[0]) < 0.1 * np.abs(slip[0]).max()  # of the rectangles beside the centre
    shifted = only(pair, Term(ALONG, 1, 0), Term(NORMAL, 0, 0), 1e-9)
    nothing = pressed_slip(strips, replace(bodies, compliance=shifted), hertz_pressure(strips, load=pair.contact.load))
    inside = np.abs(strips.edges[middle]) < 0.8 * pair.semi_axes[0]
    assert np.abs(nothing[0, middle, inside]).max() < 1e-9  # a uniform stretch is none


def test_rolling_softens_by_what_is_added(pair: PairCompliance, half_spaces: HalfSpaces, strips: Strips) -> None:
    """A stretch in proportion to the traction's own stretch adds its own term to the slip, against the motion."""
    axis: Axis = ALONG
    soft = MeshedBodies(half_spaces=half_spaces, compliance=only(pair, Term(axis, 1, 0), Term(axis, 1, 0), 2e-9))
    plain, softened = rolling_surfaces(strips, half_spaces), rolling_surfaces(strips, soft)
    a, _ = pair.semi_axes
    traction = np.concatenate([1e8 * strips.x.ravel() / a, np.zeros(strips.x.size)])
    change = ((softened.gradient - plain.gradient) @ traction)[0]
    force = 1e8 * (strips.x / a * strips.area).ravel()
    at = strips.x.ravel() / a, strips.y.ravel() / pair.semi_axes[1]
    moment = float(force @ (at[0] / np.maximum(1, np.hypot(*at))))
    middle = strips.middle.size // 2
    inside = np.abs(strips.edges[middle]) < 0.6 * a
    # s/V = v - du/dx
    np.testing.assert_allclose(change[middle, inside], -2e-9 * moment / a, rtol=1e-6)  # of a difference


def test_true_shapes_change_the_friction_of_a_6205_by_parts_in_a_hundred() -> None:
    scene = scene_of(THRUST)
    plain, meshed = (creep_of(scene, compliance=kind).numbers for kind in ("half-space", "meshed"))
    assert (plain.compliance, meshed.compliance) == ("half-space", "meshed")
    change = meshed.torque.reference / plain.torque.reference - 1
    assert 5e-4 < abs(change) < 0.02
    assert meshed.torque.production == plain.torque.production
