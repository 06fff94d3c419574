"""Stresses at nodes: exact for an even strain on curved cells, and close to the closed form under a contact."""

import numpy as np

from fembearing.fem.elasticity import lame_parameters
from fembearing.fem.nodal_stress import stress_at_nodes
from fembearing.fem.subsurface import von_mises
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import INNER, STEEL

SLOPE = 1e-4 * np.array([[3.0, -1.2, 0.7], [0.4, -2.0, 1.9], [2.3, 0.6, 0.8]])  # du_i/dx_j


def test_an_even_strain_has_its_stress_at_every_node() -> None:
    pair = pair_mesh(INNER, recipe=load_recipe("race"), level=1, semi_axes=(0.11e-3, 0.83e-3))
    lam, mu = lame_parameters(STEEL)
    strain = (SLOPE + SLOPE.T) / 2
    exact = 2 * mu * strain + lam * np.trace(strain) * np.eye(3)
    for body in (pair.upper, pair.lower):
        found = stress_at_nodes(body.mesh, SLOPE @ body.mesh.doflocs, STEEL)
        wanted = exact[[0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]
        # rounding: positions of millimetres to 1e-16 m, differences over cells of micrometres
        np.testing.assert_allclose(found, np.broadcast_to(wanted[:, None], found.shape), rtol=0, atol=1e-6 * mu * 1e-4)


def test_a_strain_that_varies_evenly_is_exact_along_depth() -> None:
    """u_x = c x z: the stress is linear, as its extrapolation to the nodes is."""
    pair = pair_mesh(INNER, recipe=load_recipe("hertzian"), level=1, semi_axes=(0.11e-3, 0.83e-3))
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
