"""Equilibrium of solved bodies: stresses, reactions and displacements against the load."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.sparse.linalg import splu
from skfem import ElementHex2, FacetBasis
from skfem.generic_utils import OrientedBoundary

from analytic.scene import Array, Material
from fembearing.fem.condensation import held_stiffness
from fembearing.fem.elasticity import lame_parameters
from fembearing.fem.farfield import pressed_ellipse
from fembearing.fem.solution import MeshSolution, solve_on_mesh
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import CONTACTS
from tests.fem.assembly import symmetric

CASES = [("outer", "race"), ("inner", "hertzian")]
SEMI_AXES = {"inner": (0.100e-3, 0.936e-3), "outer": (0.135e-3, 0.771e-3)}  # m, about those of 372 N
CERAMIC = Material(name="silicon nitride", youngs_modulus=310e9, poisson_ratio=0.26, density=3200.0, source="test")
LEVEL = 2


@dataclass(frozen=True, kw_only=True, eq=False)
class Loaded:
    """One whole body, solved under the forces of the contact solution."""

    solution: MeshSolution
    body: BodyMesh
    material: Material
    displacement: Array  # (3, nodes) m
    push: Array  # (3, m) unit vectors of the nodal forces

    def traction(self, facets: object) -> float:
        """z-component of the force on the material within `facets` from outside, N, of the quarter."""
        basis = FacetBasis(self.body.mesh, ElementHex2(), facets=facets, intorder=5)
        gradient = np.array([np.asarray(basis.interpolate(part).grad) for part in self.displacement])
        lam, mu = lame_parameters(self.material)
        stress = mu * (gradient[2] + gradient[:, 2])
        stress[2] += lam * np.einsum("ii...->...", gradient)
        return float(np.sum(stress * np.asarray(basis.normals) * basis.dx))


@pytest.fixture(scope="module", params=CASES, ids=lambda case: " ".join(case))
def loaded(request: pytest.FixtureRequest) -> list[Loaded]:
    pair, recipe = request.param
    contact = replace(CONTACTS[pair], ball_material=CERAMIC)  # unlike the race, so that a mix-up shows
    made = load_recipe(recipe)
    found = solve_on_mesh(contact, recipe=made, level=LEVEL, semi_axes=SEMI_AXES[pair], sides="above")
    bodies = []
    sides = (
        (found.pair.upper, CERAMIC, found.pair.normal),
        (found.pair.lower, contact.race_material, -found.pair.normal),
    )
    for body, material, outwards in sides:
        system = held_stiffness(body, material=material, semi_axes=found.pair.semi_axes)
        right = system.forces(body.touching, -outwards) @ found.force + contact.load * system.far_force
        displacement = np.zeros(3 * system.nodes)
        factor = splu(symmetric(system.upper).tocsc(), permc_spec="MMD_AT_PLUS_A", options={"SymmetricMode": True})
        displacement[system.free] = factor.solve(right)
        whole = displacement.reshape(3, -1)
        x, y, z = body.mesh.doflocs[:, body.far]
        side = np.sign(z.sum())  # the far field belongs to a half space pressed at depth > 0
        far = pressed_ellipse(x, y, side * z, semi_axes=found.pair.semi_axes, material=material)
        whole[:, body.far] = contact.load * far * np.array([[1.0], [1.0], [side]])
        for axis, plane in enumerate(body.planes):
            whole[axis, plane] = 0.0
        bodies.append(Loaded(solution=found, body=body, material=material, displacement=whole, push=-outwards))
    return bodies


def layers(body: BodyMesh) -> NDArray[np.intp]:
    """Number of cells between each cell and the loaded surface, (cells,)."""
    mesh = body.mesh
    layer = np.full(mesh.t.shape[1], -1)
    layer[mesh.f2t[0, np.isin(mesh.facets, body.surface).all(axis=0)]] = 0
    while (layer < 0).any():
        nodes = np.unique(mesh.t[:, layer == layer.max()])
        layer[np.isin(mesh.t, nodes).any(axis=0) & (layer < 0)] = layer.max() + 1
    return layer


@pytest.mark.parametrize("depth", [0, 1])
def test_traction_over_an_inner_section_equals_the_load(loaded: list[Loaded], depth: int) -> None:
    """The faces under a layer of cells, and those where it ends at the far boundary, enclose the contact."""
    for part in loaded:
        mesh, contact = part.body.mesh, part.solution.contact
        layer = layers(part.body)
        assert layer.max() >= 5
        sheet = mesh.facets_around(np.flatnonzero(layer <= depth))
        rim = np.isin(mesh.facets[:, sheet], part.body.far).all(axis=0)
        inner = mesh.f2t[1, sheet] != -1
        assert inner.sum() == np.count_nonzero(layer == depth)  # a face a cell: nothing is left out
        cut = OrientedBoundary(np.asarray(sheet)[inner | rim], sheet.ori[inner | rim])
        pushed_back = -np.sign(part.push[2].mean()) * contact.load  # the rest of the body holds against the load
        # 0.4 %: stresses at the far rim of the second level; those under the contact are within 0.1 %
        np.testing.assert_allclose(4 * part.traction(cut), pushed_back, rtol=5e-3)


def test_touching_nodes_meet_and_no_others_overlap(loaded: list[Loaded]) -> None:
    """The gap after the displacements of the two whole bodies and the approach of the solution."""
    found = loaded[0].solution
    normal = found.pair.normal
    moved = [part.displacement[:, part.body.touching] for part in loaded]
    closing = np.sum(normal * (moved[0] - moved[1]), axis=0) + found.quantities.approach * -normal[2]
    left = found.pair.gap - closing
    touching = found.force > 0
    round_off = 1e-9 * found.quantities.approach
    assert 10 < touching.sum() < touching.size
    assert np.abs(left[touching]).max() < round_off
    assert left[~touching].min() > -round_off
    assert found.quantities.approach > 1e-6
