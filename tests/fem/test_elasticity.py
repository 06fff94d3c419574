"""The stiffness of a body against the laws of elasticity."""

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.sparse.linalg import spsolve
from skfem import Basis, ElementHex2, ElementVector, Functional, LinearForm, MeshHex1, MeshHex2
from skfem.models.elasticity import linear_elasticity

from analytic.scene import Array, Material
from fembearing.fem.elasticity import lame_parameters, surface_mass
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import OUTER
from tests.fem.assembly import stiffness

RUBBERY = Material(name="rubbery", youngs_modulus=2.7, poisson_ratio=0.37, density=1.3, source="test")
SIDES = np.array([1.3, 0.7, 1.9])


def box(cells: tuple[int, int, int]) -> MeshHex1:
    return MeshHex1.init_tensor(*(np.linspace(0.0, side, n + 1) for side, n in zip(SIDES, cells, strict=True)))


def on_boundary(mesh: MeshHex2) -> NDArray[np.bool_]:
    place = mesh.doflocs
    return (np.abs(place) < 1e-12).any(axis=0) | (np.abs(place - SIDES[:, None]) < 1e-12).any(axis=0)


@pytest.fixture(scope="module")
def distorted() -> MeshHex2:
    """Cells with straight edges and every inner corner moved, which must reproduce linear fields.

    With curved edges, three points in each direction would not integrate the products exactly.
    """
    straight = box((3, 2, 2))
    inner = ((straight.p > 1e-9) & (straight.p < SIDES[:, None] - 1e-9)).all(axis=0)
    shift = np.where(inner, np.random.default_rng(8).uniform(-0.09, 0.09, straight.p.shape), 0.0)
    assert inner.any()
    return MeshHex2.from_mesh(MeshHex1(straight.p + shift, straight.t))


def solved(mesh: MeshHex2, fixed: NDArray[np.bool_], value: Array, body_force: Array) -> Array:
    """Displacement (3, nodes), `value` on the fixed nodes."""
    matrix = stiffness(mesh, RUBBERY)
    held = np.tile(fixed, 3)
    displacement = np.where(held, value.ravel(), 0.0)
    right = (body_force - matrix @ displacement)[~held]
    displacement[~held] = spsolve(matrix[~held][:, ~held].tocsc(), right)
    return displacement.reshape(3, -1)


def test_pulling_a_bar_needs_youngs_modulus_times_strain(distorted: MeshHex2) -> None:
    """Forces on the faces of a constant stress: E and nu enter by their definitions, not through lambda and mu."""
    modulus, ratio, strain = RUBBERY.youngs_modulus, RUBBERY.poisson_ratio, 0.021
    for axis in range(3):
        others = np.delete(np.arange(3), axis)
        displacement = -ratio * strain * distorted.doflocs
        displacement[axis] = strain * distorted.doflocs[axis]
        force = (stiffness(distorted, RUBBERY) @ displacement.ravel()).reshape(3, -1)
        pulled = distorted.doflocs[axis] > SIDES[axis] - 1e-12
        pull = force[axis, pulled].sum()
        np.testing.assert_allclose(pull, modulus * strain * np.prod(SIDES[others]), rtol=1e-12)  # round-off
        assert np.abs(force[others]).max() < 1e-13 * modulus  # the sides are free: no force on any of their nodes


def test_stiffness_equals_the_vector_form(distorted: MeshHex2) -> None:
    """The nine products, put together, are scikit-fem's own form over vector-valued functions."""
    vector = Basis(distorted, ElementVector(ElementHex2()), intorder=5)
    expected = linear_elasticity(*lame_parameters(RUBBERY)).assemble(vector)
    node, axis = np.divmod(np.arange(vector.N), 3)  # a vector basis numbers x, y, z of one function together
    places = node + axis * distorted.doflocs.shape[1]
    np.testing.assert_array_equal(vector.doflocs, distorted.doflocs[:, node])
    ours = stiffness(distorted, RUBBERY)[places][:, places]
    assert abs(ours - expected).max() < 1e-13 * abs(expected).max()  # round-off


WAVES = np.array([[1.1, -0.7, 0.9], [0.8, 1.3, -0.6], [-0.5, 0.9, 1.2]])  # of u_x, u_y, u_z
SIZES, PHASES = np.array([0.8, -1.1, 0.6]), np.array([0.3, 1.1, 2.0])


def exact(place: Array) -> Array:
    """u_i = size_i sin(wave_i . x + phase_i), (3, ...)."""
    phase = np.einsum("ij,j...->i...", WAVES, place) + PHASES.reshape(3, *[1] * (place.ndim - 1))
    return SIZES.reshape(3, *[1] * (place.ndim - 1)) * np.sin(phase)


def density_of_force(place: Array) -> Array:
    """-(lambda + mu) grad div u - mu laplace u of `exact`: d_i d_j u_j = -wave_ji wave_jj u_j."""
    lam, mu = lame_parameters(RUBBERY)
    u = exact(place)
    push = np.einsum("ji,j,j...->i...", WAVES, np.diag(WAVES), u)
    return (lam + mu) * push + mu * np.einsum("i,i...->i...", np.sum(WAVES**2, axis=1), u)


def test_displacement_error_falls_with_order_three() -> None:
    """A manufactured solution on smoothly curved cells; order 2 would be linear cells, or a wrong middle node."""
    errors = []
    for cells in (2, 3, 4, 6):
        mesh = MeshHex2.from_mesh(box((cells, cells, cells)))
        bend = 0.06 * np.prod(np.sin(np.pi * mesh.doflocs / SIDES[:, None]), axis=0)  # nothing on the boundary
        mesh = MeshHex2(mesh.doflocs + np.outer([1.0, -0.6, 0.8], bend), mesh.t)
        basis = Basis(mesh, ElementHex2(), intorder=7)
        parts = [LinearForm(lambda v, w, i=i: density_of_force(w.x)[i] * v).assemble(basis) for i in range(3)]
        u = solved(mesh, on_boundary(mesh), exact(mesh.doflocs), np.concatenate(parts))
        squared = [
            Functional(lambda w, i=i: (w["u"] - exact(w.x)[i]) ** 2).assemble(basis, u=basis.interpolate(u[i]))
            for i in range(3)
        ]
        errors.append(np.sqrt(sum(squared)))
    orders = np.diff(np.log(errors)) / np.diff(np.log([1 / 2, 1 / 3, 1 / 4, 1 / 6]))
    np.testing.assert_allclose(orders, 3.0, atol=0.3)  # the coarsest, of two cells a side, is not yet asymptotic
    assert errors[-1] < 2e-3


def test_surface_mass_sums_to_the_area() -> None:
    """Over the face that bears the contact: a third of an octant's sphere; over the touching nodes: less."""
    pair = pair_mesh(OUTER, recipe=load_recipe("race"), level=2, semi_axes=(0.13e-3, 0.77e-3))
    mass = surface_mass(pair.upper.mesh, pair.upper.surface)
    radius = OUTER.ball_radius
    np.testing.assert_allclose(mass.sum(), 4 * np.pi * radius**2 / 24, rtol=5e-3)  # coarse cells far from the pole
    touching = surface_mass(pair.upper.mesh, pair.upper.touching)
    margin = 1.4**2 * np.pi * 0.13e-3 * 0.77e-3 / 4
    assert 0.5 * margin < touching.sum() < margin  # the outermost ring of facets has rim nodes and does not count
