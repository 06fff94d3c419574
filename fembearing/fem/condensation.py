"""Static condensation: a body reduced to what its contact nodes feel.

With unit normal forces f on the touching nodes and the far-field displacement that belongs to a
load Q, the touching nodes move by compliance @ f + drift * Q along the direction of their force.
"""

import os
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix, diags_array, hstack, triu, vstack
from scipy.sparse.linalg import splu

from analytic.scene import Material
from fembearing.fem.elasticity import stiffness
from fembearing.fem.farfield import pressed_ellipse
from fembearing.mesh.bodies import BodyMesh

# Where MKL's own packages put it: pypardiso, told nothing, searches all of the environment for half a second.
for library in Path(sys.prefix, "lib").glob("libmkl_rt.so*"):
    os.environ.setdefault("PYPARDISO_MKL_RT", str(library))
try:
    from pypardiso import PyPardisoSolver
except ImportError:  # other processors than x86-64 have no MKL
    PyPardisoSolver = None

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class CondensedBody:
    compliance: Array  # (m, m) m/N, symmetric
    drift: Array  # (m,) m/N
    unknowns: int


def condense(body: BodyMesh, *, material: Material, force: Array, semi_axes: tuple[float, float]) -> CondensedBody:
    """Reduce a body to its touching nodes.

    force : (3, m) unit vectors along which the contact pushes this body
    semi_axes : of the pressure whose far field holds the body, m
    """
    system = held_stiffness(body, material=material, semi_axes=semi_axes)
    push = system.forces(body.touching, force)
    solve = _by_superlu if PyPardisoSolver is None else _by_pardiso
    compliance, drift = solve(system.matrix, push, system.far_force)
    return CondensedBody(compliance=(compliance + compliance.T) / 2, drift=drift, unknowns=system.free.size)


@dataclass(frozen=True, kw_only=True, eq=False)
class HeldBody:
    """The equations of one body after its held degrees of freedom are taken out."""

    matrix: csr_matrix  # (n, n) N/m
    far_force: Array  # (n,) force on the free ones from the far field of a unit load
    free: NDArray[np.intp]  # (n,) degrees of freedom
    held: Array  # (3, nodes) displacement that the far field of a unit load gives the held ones, m/N; 0 elsewhere
    nodes: int

    def forces(self, nodes: NDArray[np.intp], direction: Array) -> csr_matrix:
        """(n, m): unit forces on `nodes` along `direction` (3, m)."""
        count = nodes.size
        rows = np.concatenate([nodes + axis * self.nodes for axis in range(3)])
        full = csr_matrix((direction.ravel(), (rows, np.tile(np.arange(count), 3))), shape=(3 * self.nodes, count))
        return full[self.free]

    def displacement(self, push: Array, *, load: float) -> Array:
        """Displacement (3, nodes), m, under the forces `push` (n,), N, and the far field of `load`, N."""
        solve = _solution_by_superlu if PyPardisoSolver is None else _solution_by_pardiso
        moved = load * self.held.ravel()
        moved[self.free] = solve(self.matrix, push + load * self.far_force)
        return moved.reshape(3, self.nodes)


def held_stiffness(body: BodyMesh, *, material: Material, semi_axes: tuple[float, float]) -> HeldBody:
    """Assemble a body and hold its planes of symmetry and its far boundary."""
    matrix = stiffness(body.mesh, material)
    count = body.mesh.doflocs.shape[1]
    displacement = np.zeros((3, count))
    is_held = np.zeros((3, count), dtype=bool)
    for axis, plane in enumerate(body.planes):
        is_held[axis, plane] = True
    is_held[:, body.far] = True
    is_held[:, body.clamped] = True
    x, y, z = body.mesh.doflocs[:, body.far]
    side = 1.0 if z.size and z.min() >= 0 else -1.0
    displacement[:, body.far] = pressed_ellipse(x, y, side * z, semi_axes=semi_axes, material=material)
    displacement[2] *= side
    held, free = np.flatnonzero(is_held), np.flatnonzero(~is_held)
    rows = matrix[free]
    displacement[~is_held] = 0.0
    return HeldBody(
        matrix=rows[:, free],
        far_force=-(rows[:, held] @ displacement.ravel()[held]),
        free=free,
        held=displacement,
        nodes=count,
    )


def _by_pardiso(matrix: csr_matrix, push: csr_matrix, far_force: Array) -> tuple[Array, Array]:
    """push.T K^-1 push and push.T K^-1 far_force from one factorisation.

    PARDISO eliminates all degrees of freedom of [K B; B.T 0] but those that stand for the columns of B, the pushes and
    the far field: what is left of them is -B.T K^-1 B.
    """
    size, columns = matrix.shape[0], push.shape[1] + 1
    stiffest = matrix.diagonal().max()
    scale = stiffest / np.append(np.ones(columns - 1), np.abs(far_force).max() or 1.0)  # one size with the matrix
    border = hstack([push, csr_matrix(far_force[:, None])]) @ diags_array(scale)
    corner = csr_matrix((np.zeros(columns), (np.arange(columns),) * 2), shape=(columns, columns))  # stored, though zero
    upper = triu(vstack([hstack([matrix, border]), hstack([csr_matrix((columns, size)), corner])]), format="csr")
    upper.sort_indices()
    solver = _pardiso(schur=True)
    solver.perm = np.repeat(np.array([0, 1], dtype=np.int32), [size, columns])
    solver.set_phase(12)
    # pypardiso has no public call that hands out a Schur complement: its own `factorize` gives PARDISO a vector
    left = solver._call_pardiso(upper, np.zeros(max(size + columns, columns**2)))[: columns**2]
    solver.free_memory(everything=True)
    moved = -left.reshape(columns, columns) / np.outer(scale, scale)
    return moved[:-1, :-1], moved[:-1, -1]


def _solution_by_pardiso(matrix: csr_matrix, right: Array) -> Array:
    """K^-1 right."""
    upper = triu(matrix, format="csr")
    upper.sort_indices()
    solver = _pardiso(schur=False)
    solution = solver.solve(upper, right)
    solver.free_memory(everything=True)
    return solution


def _pardiso(*, schur: bool) -> Any:
    assert PyPardisoSolver is not None  # the caller asked
    solver = PyPardisoSolver(mtype=2)  # symmetric positive definite, upper triangle
    for number, value in ((1, 1), (2, 2), (10, 8), (36, int(schur))):  # own settings, METIS, pivot 1e-8, complement
        solver.set_iparm(number, value)
    return solver


def _by_superlu(matrix: csr_matrix, push: csr_matrix, far_force: Array) -> tuple[Array, Array]:
    """The same from one solution for each touching node."""
    moved = _solution_by_superlu(matrix, np.column_stack([push.toarray(), far_force]))
    return push.T @ moved[:, :-1], push.T @ moved[:, -1]


def _solution_by_superlu(matrix: csr_matrix, right: Array) -> Array:
    """K^-1 right."""
    factor = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    return factor.solve(right)
