"""Static condensation: a body reduced to what its contact nodes feel.

With unit normal forces f on the touching nodes and the far-field displacement that belongs to a
load Q, the touching nodes move by compliance @ f + drift * Q along the direction of their force.
"""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError
from scipy.sparse import csr_matrix, diags_array, hstack, triu, vstack
from scipy.sparse.linalg import splu

from analytic.errors import SingularError
from analytic.scene import Material
from fembearing.fem.contact import is_positive_definite
from fembearing.fem.elasticity import stiffness, surface_mass
from fembearing.fem.farfield import pressed_ellipse
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.footprint import UNCUT

# Where MKL's own packages put it: pypardiso, told nothing, searches all of the environment for half a second.
for library in Path(sys.prefix, "lib").glob("libmkl_rt.so*"):
    os.environ.setdefault("PYPARDISO_MKL_RT", str(library))
try:
    from pypardiso import PyPardisoSolver
    from pypardiso.pardiso_wrapper import PyPardisoError
except ImportError:  # other processors than x86-64 have no MKL
    PyPardisoSolver, PyPardisoError = None, LinAlgError

Array = NDArray[np.float64]
UNBALANCED = 1e-8  # relative: round-off leaves less than 1e-12
OUT_OF_MEMORY = (-2, -8, -9)  # of PARDISO's status codes: too little memory, too many entries to count, disk full


@dataclass(frozen=True, kw_only=True, eq=False)
class CondensedBody:
    compliance: Array  # (m, m) m/N, symmetric
    drift: Array  # (m,) m/N, for each newton of the whole load
    unknowns: int


def condense(
    body: BodyMesh,
    *,
    material: Material,
    force: Array,
    semi_axes: tuple[float, float],
    room: tuple[float, float] = UNCUT,
) -> CondensedBody:
    """Reduce a body to its touching nodes.

    force : (3, m) unit vectors along which the contact pushes this body
    semi_axes, room : of the pressure whose far field holds the body, m
    Raises SingularError for a body that is not held, or whose equations are not those of an elastic one.

    Half a ball has no plane of symmetry across the contact: its middle plane is held there, at rest on the average, by
    forces spread evenly over it. A unit force f then comes with -f_y of those, and what it moves is told from where the
    middle plane is: P^T K^-1 P with P = push - (forces of the plane) f_y, K held at a single node that feels nothing.
    """
    system = held_stiffness(body, material=material, semi_axes=semi_axes, room=room)
    push = system.forces(body.touching, force)
    solve = _by_superlu if PyPardisoSolver is None else _by_pardiso
    with system.solving():
        beside = middle_plane(system, body) if body.pinned else system.far_force
        compliance, drift, own = solve(system.matrix, push, beside)
        if body.pinned:
            across = drift[:, None] * force[1]
            compliance = compliance + own * force[1][:, None] * force[1] - across - across.T
            drift = np.zeros_like(drift)
        compliance = (compliance + compliance.T) / 2
        if not (np.isfinite(compliance).all() and is_positive_definite(compliance)):
            raise LinAlgError("touching nodes yield without resistance")
    return CondensedBody(compliance=compliance, drift=drift, unknowns=system.free.size)


def middle_plane(system: "HeldBody", body: BodyMesh) -> Array:
    """(n,) a unit force across, spread evenly over a ball's middle plane."""
    plane = body.planes[2]
    area = np.asarray(surface_mass(body.mesh, plane).sum(axis=1)).ravel()
    full = np.zeros((3, system.nodes))
    full[1, plane] = area / area.sum()
    return full.ravel()[system.free]


@dataclass(frozen=True, kw_only=True, eq=False)
class HeldBody:
    """The equations of one body after its held degrees of freedom are taken out."""

    name: str  # of the body
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
        """Displacement (3, nodes), m, under the forces `push` (n,), N, and the far field of `load`, N.

        Raises SingularError where no displacement balances the forces.
        """
        solve = _solution_by_superlu if PyPardisoSolver is None else _solution_by_pardiso
        moved = load * self.held.ravel()
        right = push + load * self.far_force
        with self.solving():
            found = solve(self.matrix, right)
            left = np.linalg.norm(self.matrix @ found - right)
            if not left <= UNBALANCED * np.linalg.norm(right):
                raise LinAlgError(f"forces of {left:.1e} N stay without balance")
        moved[self.free] = found
        return moved.reshape(3, self.nodes)

    @contextmanager
    def solving(self) -> Iterator[None]:
        """Around a call of either solver: its own complaint becomes a SingularError that names the body."""
        equations = f"{self.name}: its {self.free.size} equations"
        try:
            diagonal = self.matrix.diagonal()
            if not (np.isfinite(self.matrix.data).all() and (diagonal > 0).all()):  # an empty row would crash PARDISO
                raise LinAlgError("a stiffness that is not finite and positive")
            yield
        except (LinAlgError, RuntimeError, PyPardisoError, MemoryError) as problem:
            if isinstance(problem, MemoryError) or getattr(problem, "value", 0) in OUT_OF_MEMORY:
                remedy = "Ask for a larger tolerance, which takes a coarser mesh."
                raise SingularError(problem=f"{equations} do not fit into memory", remedy=remedy) from problem
            raise SingularError(
                problem=f"{equations} have no single answer: {str(problem).rstrip('.')}",
                remedy="Check that it is held, its modulus, Poisson ratio (below 0.5) and mesh.",
            ) from problem


def held_stiffness(
    body: BodyMesh, *, material: Material, semi_axes: tuple[float, float], room: tuple[float, float] = UNCUT
) -> HeldBody:
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
    displacement[:, body.far] = pressed_ellipse(x, y, side * z, semi_axes=semi_axes, room=room, material=material)
    displacement[2] *= side
    held, free = np.flatnonzero(is_held), np.flatnonzero(~is_held)
    rows = matrix[free]
    displacement[~is_held] = 0.0
    return HeldBody(
        name=body.name,
        matrix=rows[:, free],
        far_force=-(rows[:, held] @ displacement.ravel()[held]),
        free=free,
        held=displacement,
        nodes=count,
    )


def _by_pardiso(matrix: csr_matrix, push: csr_matrix, far_force: Array) -> tuple[Array, Array, float]:
    """push.T K^-1 push, push.T K^-1 far_force and far_force.T K^-1 far_force from one factorisation.

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
    try:
        # pypardiso has no public call that hands out a Schur complement: its own `factorize` gives PARDISO a vector
        left = solver._call_pardiso(upper, np.zeros(max(size + columns, columns**2)))[: columns**2]
    finally:
        solver.free_memory(everything=True)
    moved = -left.reshape(columns, columns) / np.outer(scale, scale)
    return moved[:-1, :-1], moved[:-1, -1], float(moved[-1, -1])


def _solution_by_pardiso(matrix: csr_matrix, right: Array) -> Array:
    """K^-1 right."""
    upper = triu(matrix, format="csr")
    upper.sort_indices()
    solver = _pardiso(schur=False)
    try:
        return solver.solve(upper, right)
    finally:
        solver.free_memory(everything=True)


def _pardiso(*, schur: bool) -> Any:
    assert PyPardisoSolver is not None  # the caller asked
    solver = PyPardisoSolver(mtype=2)  # symmetric positive definite, upper triangle
    for number, value in ((1, 1), (2, 2), (10, 8), (36, int(schur))):  # own settings, METIS, pivot 1e-8, complement
        solver.set_iparm(number, value)
    return solver


def _by_superlu(matrix: csr_matrix, push: csr_matrix, far_force: Array) -> tuple[Array, Array, float]:
    """The same from one solution for each touching node."""
    moved = _solution_by_superlu(matrix, np.column_stack([push.toarray(), far_force]))
    return push.T @ moved[:, :-1], push.T @ moved[:, -1], float(far_force @ moved[:, -1])


def _solution_by_superlu(matrix: csr_matrix, right: Array) -> Array:
    """K^-1 right."""
    factor = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    return factor.solve(right)
