"""A contact cut off at one shoulder, against an uncut quarter, boundary elements, and equilibrium."""

import importlib
from dataclasses import replace
from types import ModuleType

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Contact
from fembearing.check.contact.refinement import COMPARED
from fembearing.check.contact.solution import ContactSolution
from fembearing.fem.condensation import held_stiffness, middle_plane
from fembearing.fem.farfield import point_load, pressed_ellipse
from fembearing.fem.measure import STRIP
from fembearing.fem.ring_structure import ring_compression
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.fem.subsurface import subsurface_stress
from fembearing.mesh import pair as pair_module
from fembearing.mesh.footprint import Footprint, Sides
from fembearing.mesh.recipe import load_recipe
from tests.contacts import INNER
from tests.fem.assembly import stiffness

SEMI_AXES = (0.103e-3, 0.939e-3)  # m, on the far side of the contact below


@pytest.fixture(scope="module")
def cut() -> MeshSolution:
    """Hertz's ellipse would be 0.946 mm across."""
    contact = replace(INNER, shoulder=0.8e-3)
    return solve_on_mesh(contact, recipe=load_recipe("race"), level=2, semi_axes=SEMI_AXES)


@pytest.mark.parametrize("recipe", ["race", "hertzian"])
def test_half_of_a_symmetric_contact_is_its_quarter_twice(monkeypatch: pytest.MonkeyPatch, recipe: str) -> None:
    contact = replace(INNER, far_shoulder=INNER.shoulder, contact_angle=0.0)
    made = load_recipe(recipe)
    quarter = solve_on_mesh(contact, recipe=made, level=1, semi_axes=SEMI_AXES)
    monkeypatch.setattr(pair_module, "footprint_of", lambda _, axes: Footprint(semi_axes=axes, half=True))
    half = solve_on_mesh(contact, recipe=made, level=1, semi_axes=SEMI_AXES)
    for name in COMPARED:
        found, expected = (getattr(part.quantities, name) for part in (half, quarter))
        assert found == pytest.approx(expected, rel=1e-9), name  # round-off of two factorisations
    assert half.force.sum() == pytest.approx(2 * quarter.force.sum(), rel=1e-9)


@pytest.fixture
def calibrations() -> ModuleType:
    """The script that measures the constants; it holds the boundary elements."""
    pytest.importorskip("tamaas", reason="its wheels are for Linux on x86-64 only")
    return importlib.import_module("validation.benchmarks.calibrations")


def test_boundary_elements_agree_on_a_paraboloid_that_ends_at_the_shoulder(calibrations: ModuleType) -> None:
    """Two methods that share no code, where Hertz's ellipse is 1.7 times the distance of the shoulder."""
    contact = replace(INNER, shoulder=0.55e-3)
    semi_axes = fitted_solution(contact, recipe=load_recipe("hertzian")).pair.semi_axes
    ours = solve_on_mesh(contact, recipe=load_recipe("hertzian"), level=2, semi_axes=semi_axes)
    assert ours.shoulder is not None
    other = calibrations.boundary_elements(contact, semi_axes=semi_axes, points=128)
    for name in ("semi_axis_rolling", "semi_axis_transverse", "approach"):
        # the second level is up to 0.4 % off the fourth, 128 points up to 0.15 % off 512
        assert getattr(ours.quantities, name) == pytest.approx(other[name], rel=6e-3), name
    assert other["centroid"] < -0.06e-3
    assert ours.shoulder.centroid == pytest.approx(other["centroid"], rel=0.07)  # 2.5 % and 1 %, alike
    assert ours.shoulder.strip_share == pytest.approx(other["strip_share"], rel=0.08)  # 3 % and 2 %
    hertz_share = strip_share_of_an_ellipse(0.946e-3, contact.shoulder)
    assert abs(other["strip_share"] / hertz_share - 1) > 0.2  # what neglecting the edge's own load would say


def strip_share_of_an_ellipse(semi_axis: float, shoulder: float) -> float:
    """Share of the line load 3/4 (1 - t^2) of an ellipse between t = 0.9 s/b and s/b."""
    far, near = shoulder / semi_axis, (1 - STRIP) * shoulder / semi_axis
    return 0.75 * (far - near - (far**3 - near**3) / 3)


def test_the_meshes_converge(cut_contact: ContactSolution) -> None:
    """The last changes are well below the ones before: by 2.3 at order 1, the lowest order that three meshes show."""
    assert [mesh.level for mesh in cut_contact.meshes] == [1, 2, 3]
    for read in (
        lambda part: part.quantities.approach,
        lambda part: part.quantities.semi_axis_rolling,
        lambda part: part.quantities.semi_axis_transverse,
        lambda part: part.shoulder.centroid,
        lambda part: part.shoulder.strip_share,
    ):
        first, middle, last = (read(mesh) for mesh in cut_contact.meshes)
        assert abs(last - middle) < abs(middle - first) / 3


def test_forces_and_moments_balance(cut: MeshSolution) -> None:
    """For each body: contact forces, reactions, and the moments of both about the centre of the ball."""
    contact, pair = cut.contact, cut.pair
    centre = np.array([[0.0], [0.0], [contact.ball_radius]])
    sides = ((pair.upper, contact.ball_material, -pair.normal), (pair.lower, contact.race_material, pair.normal))
    for body, material, towards in sides:
        system = held_stiffness(body, material=material, semi_axes=pair.semi_axes, shoulders=pair.footprint.shoulders)
        push = system.forces(body.touching, towards) @ cut.force
        across = float(towards[1] @ cut.force)
        if body.pinned:
            push = push - across * middle_plane(system, body)
        moved = system.displacement(push, load=contact.load)
        force = (stiffness(body.mesh, material) @ moved.ravel()).reshape(3, -1)
        on_contact = force[:, body.touching].sum(axis=1)
        assert 2 * on_contact[2] == pytest.approx(np.sign(towards[2].mean()) * contact.load, rel=1e-9)  # round-off
        assert on_contact[1] == pytest.approx(across, rel=1e-9)
        # the load's line is off the centre, so that the ball is pushed aside
        assert cut.shoulder is not None
        sideways = np.sign(towards[2].mean()) * cut.shoulder.centroid / contact.ball_radius * contact.load / 2
        assert -across == pytest.approx(sideways, rel=0.05)  # the third moment, (b/r)^2
        np.testing.assert_allclose(force[1:].sum(axis=1), 0.0, atol=1e-9 * contact.load)
        arm = body.mesh.doflocs - centre
        about_x = arm[1] * force[2] - arm[2] * force[1]
        largest = np.abs(arm[1] * force[2]).sum()
        assert about_x.sum() == pytest.approx(0.0, abs=1e-9 * largest)
        if body.pinned:
            pin = body.planes[1]
            assert abs(force[1, pin].sum()) < 0.05 * abs(across)  # its share of the plane, no more


@pytest.mark.parametrize("shoulders", [(np.inf, 0.41e-3), (0.33e-3, np.inf), (0.52e-3, 0.17e-3)])
def test_the_far_field_of_a_cut_ellipse_is_that_of_its_points(shoulders: tuple[float, float]) -> None:
    """Against a fine sum of point loads over the rest of the ellipse."""
    material, (a, b) = INNER.race_material, (0.31e-3, 0.63e-3)
    ticks = (np.arange(400) + 0.5) / 400 * 2 - 1
    x, y = (part.ravel() for part in np.meshgrid(a * ticks, b * ticks))
    weight = np.sqrt(np.maximum(0.0, 1 - (x / a) ** 2 - (y / b) ** 2)) * ((-shoulders[0] < y) & (y < shoulders[1]))
    for place in ((0.7e-3, 1.3e-3, 0.9e-3), (0.3e-3, -1.9e-3, 0.2e-3)):
        shifted = place[0] - x, place[1] - y, np.full_like(x, place[2])
        expected = point_load(*shifted, material=material) @ weight / weight.sum()
        at = [np.array([part]) for part in place]
        found = pressed_ellipse(*at, semi_axes=(a, b), shoulders=shoulders, material=material)
        np.testing.assert_allclose(found[:, 0], expected, rtol=2e-3)  # the sum's own: its strips end between points


def test_functions_for_a_symmetric_contact_refuse_half_of_one(cut: MeshSolution) -> None:
    with pytest.raises(InputError, match="no axis of symmetry"):
        subsurface_stress(cut)
    with pytest.raises(InputError, match="reaches over"):
        ring_compression(cut, recipe=load_recipe("race"))


def sided(contact: Contact, *, near: float, far: float, sides: Sides) -> MeshSolution:
    """With shoulders at `near` and `far`, m, and lands parallel to the tangent plane."""
    even = replace(contact, shoulder=near, far_shoulder=far, contact_angle=0.0)
    return solve_on_mesh(even, recipe=load_recipe("race"), level=1, semi_axes=SEMI_AXES, sides=sides)


def test_each_side_acts_by_itself_at_a_contact_angle_too() -> None:
    """Half of the contact, with tilted lands, is the mean of a quarter with either side, or of their bodies."""
    contact, recipe = replace(INNER, shoulder=1.2e-3, far_shoulder=2.0e-3), load_recipe("race")
    even, half, above, below, mean = (
        solve_on_mesh(contact, recipe=recipe, level=2, semi_axes=SEMI_AXES, sides=sides).quantities
        for sides in ("even", "both", "above", "below", "mean")
    )
    for name in COMPARED:
        found, one, other, together = (getattr(part, name) for part in (half, above, below, mean))
        # 4e-5: a tenth of what each side does, 4e-4, for what two do together and for the mirrored tilt of the groove
        assert found == pytest.approx((one + other) / 2, rel=4e-5), name
        assert found == pytest.approx(together, rel=4e-5), name
    assert abs(half.approach / even.approach - 1) > 2e-4
    assert abs(above.approach / below.approach - 1) > 2e-4


def test_a_far_shoulder_that_is_reached_cuts_the_contact_like_a_near_one() -> None:
    one, other = (sided(INNER, near=near, far=far, sides="even") for near, far in ((0.7e-3, 3.1e-3), (3.1e-3, 0.7e-3)))
    assert one.shoulder is not None
    assert other.shoulder is not None
    assert other.shoulder.centroid == pytest.approx(-one.shoulder.centroid, rel=1e-9)  # round-off
    assert other.shoulder.strip_share == pytest.approx(one.shoulder.strip_share, rel=1e-9)
    np.testing.assert_allclose(other.semi_axes, one.semi_axes, rtol=1e-9)
    for name in COMPARED:
        assert getattr(other.quantities, name) == pytest.approx(getattr(one.quantities, name), rel=1e-9), name
