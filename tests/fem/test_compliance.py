"""The compliance of a pair against direct condensation, against Hertz, and against finer meshes."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import dblquad
from scipy.interpolate import LinearNDInterpolator
from scipy.spatial import cKDTree

from analytic.errors import ConvergenceError
from analytic.scene import Array, Contact
from fembearing.check.contact.refinement import COMPARED
from fembearing.fem.compliance import PairCompliance, compliance_over_load, sampled_compliance, sampled_pair
from fembearing.fem.condensation import held_stiffness
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.half_space import (
    approach_under,
    contact_modulus,
    exact_quantities,
    hertz_ellipse,
    pressed_rectangle,
)
from fembearing.fem.pixel_contact import press_pair
from fembearing.fem.solution import condensed_pair, solve_on_mesh
from fembearing.fem.twin import flat_race, shared_axes
from fembearing.mesh.ball import block_of_ball, flat_ball
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.race import block_of_race
from fembearing.mesh.recipe import load_recipe
from tests.contacts import CONTACTS, INNER, OUTER, PEEK

RECIPE = load_recipe("race")


def axes_of(contact: Contact) -> tuple[float, float]:
    return shared_axes(expected_semi_axes(contact, geometry="real"))


def sampled(contact: Contact, *, level: int) -> PairCompliance:
    return sampled_pair(contact, recipe=RECIPE, level=level, semi_axes=axes_of(contact))[1]


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_outside_the_ellipse_it_is_near_the_meshed_bodies(pair: str) -> None:
    """On all nodes of the ball's surface over the block, under Hertz's pressure: the stated errors of what is held."""
    contact, axes, level = CONTACTS[pair], axes_of(CONTACTS[pair]), 2
    bodies = condensed_pair(contact, recipe=RECIPE, level=level, semi_axes=axes, sides="even")
    upper, lower, footprint = bodies.pair.upper, bodies.pair.lower, bodies.pair.footprint
    place = upper.mesh.doflocs[:2, upper.touching]
    force = bodies.mass @ np.sqrt(np.maximum(0, 1 - np.sum((place.T / axes) ** 2, axis=1)))

    def sunk(body: BodyMesh, push: Array, normal: Array) -> tuple[Array, Array]:
        """x, y of the surface and its displacement along `normal` under forces along `push`."""
        system = held_stiffness(body, material=contact.ball_material, semi_axes=axes)
        moved = system.displacement(system.forces(body.touching, push) @ force, load=4 * force.sum())
        return body.mesh.doflocs[:2, body.surface].T, np.sum(normal * moved[:, body.surface], axis=0)

    def into_ball(body: BodyMesh) -> Array:
        plane = body.mesh.doflocs[:2, body.surface] / contact.ball_radius
        return np.vstack([-plane, np.sqrt(np.maximum(0, 1 - np.sum(plane**2, axis=0)))])

    upright, flat_normal = np.tile([[0.0], [0.0], [-1.0]], force.size), np.array([[0.0], [0.0], [-1.0]])
    at, of_ball = sunk(upper, -bodies.pair.normal, into_ball(upper))
    _, of_flat_ball = sunk(flat_ball(block_of_ball(contact, RECIPE, level, footprint)), upright, flat_normal)
    race_at, of_race = sunk(lower, bodies.pair.normal, -into_ball(lower))
    block = block_of_race(contact, RECIPE, level, footprint, False)
    flat_at, of_flat_race = sunk(flat_race(block), upright, flat_normal)
    added_by_race = of_race - of_flat_race[cKDTree(flat_at).query(race_at)[1]]  # columns are nearly the same
    added = of_ball - of_flat_ball + LinearNDInterpolator(race_at, added_by_race)(at)

    compliance = sampled_compliance(bodies, recipe=RECIPE)
    x, y = np.concatenate([at, place.T]).T  # displacements are read at the first, forces act at the others
    held = compliance.added_displacement(x, y, np.concatenate([np.zeros(len(at)), 4 * force]))[: len(at)]
    approach = approach_under(axes, load=4 * force.sum(), modulus=contact_modulus(contact))
    error, far = np.abs(held - added) / approach, np.linalg.norm(at / axes, axis=1)
    for nearest, farthest, stated in ((0, 1, 1e-3), (1, 1.5, 3e-3), (1.5, 3, 1.2e-2), (3, 99, 3e-2)):
        among = (far >= nearest * (1 + 1e-6)) & (far <= farthest * (1 + 1e-6)) & np.isfinite(added)
        assert among.sum() > 15
        assert error[among].max() < stated, (nearest, farthest)


def test_without_addition_a_light_contact_is_hertzs() -> None:
    contact = replace(OUTER, load=1e-3, groove_radius=4.9e-3)
    modulus = contact_modulus(contact)
    curvatures = 1 / contact.ball_radius + 1 / contact.rolling_radius, 1 / contact.ball_radius - 1 / 4.9e-3
    ellipse = hertz_ellipse(curvatures, load=1e-3, modulus=modulus)
    nothing = PairCompliance(contact=contact, level=0, semi_axes=axes_of(contact), added=np.zeros((6, 6)))
    found = press_pair(nothing, load=1e-3)
    for name, value in vars(exact_quantities(ellipse, load=1e-3, modulus=modulus)).items():
        # 0.001 %: the square of the semi-axis over the ball's radius is 3e-6
        assert getattr(found.quantities, name) == pytest.approx(value, rel=1e-5), name
    assert 4 * found.force.sum() == pytest.approx(1e-3, rel=1e-5)


@pytest.mark.parametrize("pair", ["inner", "outer"])
@pytest.mark.parametrize(("level", "allowed"), [(1, 5e-3), (2, 1.5e-3)])
def test_pixels_agree_with_a_finer_mesh(pair: str, level: int, allowed: float) -> None:
    """The third level, whose own error is 0.1 %; a first level without extrapolation is off by some tenths."""
    contact = replace(CONTACTS[pair], race_material=PEEK, load=20.0)
    found = press_pair(sampled(contact, level=level), load=contact.load)
    mesh = solve_on_mesh(contact, recipe=RECIPE, level=3, semi_axes=axes_of(contact))
    for name in COMPARED:
        assert getattr(found.quantities, name) == pytest.approx(getattr(mesh.quantities, name), rel=allowed), name


def test_a_spline_over_the_load_goes_through_its_samples() -> None:
    loads = (90.0, 230.0, 610.0)
    samples = [sampled(replace(OUTER, load=load), level=1) for load in loads]
    series = compliance_over_load(samples)
    for load, sample in zip(loads, samples, strict=True):
        again = series.at(load)
        assert again.contact.load == load
        np.testing.assert_allclose(again.semi_axes, sample.semi_axes, rtol=1e-12)  # round-off
        np.testing.assert_allclose(again.added, sample.added, rtol=1e-9, atol=1e-12 * np.abs(sample.added).max())


def test_an_addition_far_larger_than_the_half_spaces_is_refused() -> None:
    sample = sampled(INNER, level=1)
    with pytest.raises(ConvergenceError, match="the shapes of ball and race add to half spaces") as caught:
        press_pair(replace(sample, added=-300 * sample.added), load=INNER.load)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("place", [(0.0, 0.0), (0.31, -0.17), (0.9, 2.3)])
def test_a_rectangle_yields_as_the_point_loads_on_it(place: tuple[float, float]) -> None:
    """1/distance integrated over the rectangle by quadrature, piecewise where it holds the place."""
    sides, (x, y) = (0.42, 0.77), place
    total = 0.0
    for low_x, high_x in ((-sides[0], min(x, sides[0])), (min(x, sides[0]), sides[0])):
        for low_y, high_y in ((-sides[1], min(y, sides[1])), (min(y, sides[1]), sides[1])):
            part, _ = dblquad(lambda v, u: 1 / np.hypot(u - x, v - y), low_x, high_x, low_y, high_y)
            total += part
    found = pressed_rectangle(np.array([x]), np.array([y]), half_sides=sides)
    np.testing.assert_allclose(found, total / (4 * sides[0] * sides[1]), rtol=1e-6)  # of the quadrature
