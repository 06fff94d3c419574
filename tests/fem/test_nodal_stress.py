"""Stresses at nodes: exact for an even strain on curved cells, and close to the closed form under a contact."""

import numpy as np
import pytest

from analytic.contact.hertz import contact_modulus, hertz_contact, relative_curvatures
from analytic.contact.subsurface import subsurface_maximum
from analytic.scene import Contact
from fembearing.fem.elasticity import lame_parameters
from fembearing.fem.nodal_stress import stress_at_nodes, von_mises
from fembearing.fem.solution import solve_on_mesh
from fembearing.fem.subsurface import Side, body_displacement, body_of
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import STEEL

SLOPE = 1e-4 * np.array([[3.0, -1.2, 0.7], [0.4, -2.0, 1.9], [2.3, 0.6, 0.8]])  # du_i/dx_j


def test_an_even_strain_has_its_stress_at_every_node(contacts: dict[str, Contact]) -> None:
    pair = pair_mesh(contacts["inner"], recipe=load_recipe("race"), level=1, semi_axes=(0.11e-3, 0.83e-3))
    lam, mu = lame_parameters(STEEL)
    strain = (SLOPE + SLOPE.T) / 2
    exact = 2 * mu * strain + lam * np.trace(strain) * np.eye(3)
    for body in (pair.upper, pair.lower):
        found = stress_at_nodes(body.mesh, SLOPE @ body.mesh.doflocs, STEEL)
        wanted = exact[[0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]
        # rounding: positions of millimetres to 1e-16 m, differences over cells of micrometres
        np.testing.assert_allclose(found, np.broadcast_to(wanted[:, None], found.shape), rtol=0, atol=1e-6 * mu * 1e-4)


def test_a_strain_that_varies_evenly_is_exact_along_depth(contacts: dict[str, Contact]) -> None:
    """u_x = c x z: the stress is linear, as its extrapolation to the nodes is."""
    pair = pair_mesh(contacts["inner"], recipe=load_recipe("hertzian"), level=1, semi_axes=(0.11e-3, 0.83e-3))
    mesh, slope = pair.lower.mesh, 0.3  # 1/m
    x, _, z = mesh.doflocs
    lam, mu = lame_parameters(STEEL)
    found = stress_at_nodes(mesh, np.array([slope * x * z, 0 * x, 0 * x]), STEEL)
    nothing = 0 * x
    exact = np.array([(lam + 2 * mu) * z, lam * z, lam * z, nothing, nothing, mu * x]) * slope
    np.testing.assert_allclose(found[:5], exact[:5], rtol=0, atol=1e-12 * np.abs(exact).max())  # rounding
    # Around the ellipse x is no linear function within a cell.
    np.testing.assert_allclose(found[5], exact[5], rtol=0, atol=2e-3 * np.abs(exact).max())


def test_the_equivalent_stress_of_plain_states() -> None:
    tension, shear = np.array([5.0, 0, 0, 0, 0, 0]), np.array([0, 0, 0, 0, 3.0, 0])
    pressure = np.array([-7.0, -7.0, -7.0, 0, 0, 0])
    np.testing.assert_allclose(von_mises(np.stack([tension, shear, pressure], axis=1)), [5.0, 3.0 * 3**0.5, 0.0])


def test_the_greatest_equivalent_stress_is_that_of_the_closed_form(contacts: dict[str, Contact]) -> None:
    contact = contacts["inner"]
    curvatures = relative_curvatures(contact)
    modulus = contact_modulus(contact.ball_material, contact.race_material)
    hertz = hertz_contact(curvature_x=curvatures[0], curvature_y=curvatures[1], load=contact.load, modulus=modulus)
    semi_axes = float(hertz.semi_axis_x), float(hertz.semi_axis_y)
    solution = solve_on_mesh(contact, recipe=load_recipe("hertzian"), level=3, semi_axes=semi_axes)
    sides: tuple[Side, ...] = ("upper", "lower")
    for side in sides:
        body, material = body_of(solution, side)
        stress = stress_at_nodes(body.mesh, body_displacement(solution, side=side), material)
        exact = subsurface_maximum(
            poisson_ratio=material.poisson_ratio,
            peak_pressure=float(hertz.peak_pressure),
            semi_axis_x=semi_axes[0],
            semi_axis_y=semi_axes[1],
        )
        equivalent = von_mises(stress)
        axis = np.intersect1d(body.planes[0], body.planes[1])
        at = axis[np.argmax(equivalent[axis])]
        # 5 %: nodes lie a sixth of a semi-axis apart there, and each takes the mean over its cells
        assert equivalent[at] == pytest.approx(exact.max_von_mises, rel=0.05), side
        # between two nodes
        assert abs(body.mesh.doflocs[2, at]) == pytest.approx(exact.max_von_mises_depth, rel=0.35), side
