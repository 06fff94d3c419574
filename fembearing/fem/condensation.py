"""Static condensation: a body reduced to the response of its contact nodes.

Under normal forces f, N, on the touching nodes and the far-field displacement of a load Q, N, the touching nodes move
by compliance @ f + drift * Q, m, along the direction of their force.
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

# MKL's own packages install it here. Without this hint pypardiso searches the whole environment for half a second.
for library in Path(sys.prefix, "lib").glob("libmkl_rt.so*"):
    os.environ.setdefault("PYPARDISO_MKL_RT", str(library))
try:
    from pypardiso import PyPardisoSolver
    from pypardiso.pardiso_wrapper import PyPardisoError
except ImportError:  # other processors than x86-64 have no MKL
    PyPardisoSolver, PyPardisoError = None, LinAlgError

Array = NDArray[np.float64]
UNBALANCED = 1e-8  # relative residual force; round-off leaves less than 1e-12
OUT_OF_MEMORY = (-2, -8, -9)  # status codes of PARDISO: too little memory, too many entries to count, disk full


@dataclass(frozen=True, kw_only=True, eq=False)
class CondensedBody:
    """A body reduced to its m touching nodes."""

    compliance: Array  # (m, m) m/N, symmetric
    drift: Array  # (m,) m/N, for each newton of the whole load
    unknowns: int


def condense(
    body: BodyMesh,
    *,
    material: Material,
    force: Array,
    semi_axes: tuple[float, float],
    shoulders: tuple[float, float] = UNCUT,
) -> CondensedBody:
    """Reduce a body to its touching nodes.

    force : (3, m) unit vectors along which the contact pushes this body
    semi_axes, shoulders : size of the pressure whose far field holds the body, m, as in `Footprint`
    Raises SingularError for a body that is not held, or whose stiffness is not that of an elastic body.

    Half a ball has no plane of symmetry y = 0. Forces spread evenly over its middle plane keep that plane at rest on
    average in the transverse direction. A unit force f on a node is therefore balanced by -f_y on the plane, and
    displacements are relative to the plane: P^T K^-1 P with P = push - (forces on the plane) f_y. K is held at a single
    node, whose reaction is zero.
    """
    system = held_stiffness(body, material=material, semi_axes=semi_axes, shoulders=shoulders)
    push = system.forces(body.touching, force)
    solve = _by_superlu if PyPardisoSolver is None else _by_pardiso
    with system.solving():
        further = middle_plane(system, body) if body.pinned else system.far_force
        compliance, drift, own = solve(system.matrix, push, further)
        if body.pinned:
            transverse = drift[:, None] * force[1]
            compliance = compliance + own * force[1][:, None] * force[1] - transverse - transverse.T
            drift = np.zeros_like(drift)
        compliance = (compliance + compliance.T) / 2
        if not (np.isfinite(compliance).all() and is_positive_definite(compliance)):
            raise LinAlgError("touching nodes yield without resistance")
    return CondensedBody(compliance=compliance, drift=drift, unknowns=system.free.size)


def middle_plane(system: "HeldBody", body: BodyMesh) -> Array:
    """(n,) a unit force in the transverse direction, spread evenly over the middle plane of a ball."""
    plane = body.planes[2]
    area = np.asarray(surface_mass(body.mesh, plane).sum(axis=1)).ravel()
    full = np.zeros((3, system.nodes))
    full[1, plane] = area / area.sum()
    return full.ravel()[system.free]


@dataclass(frozen=True, kw_only=True, eq=False)
class HeldBody:
    """The equations of one body without its held degrees of freedom."""

    name: str  # of the body
    matrix: csr_matrix  # (n, n) N/m
    far_force: Array  # (n,) force that the far field of a unit load puts on the free degrees of freedom
    free: NDArray[np.intp]  # (n,) numbers of the free degrees of freedom
    held: Array  # (3, nodes) displacement of the held ones in the far field of a unit load, m/N; 0 at free ones
    nodes: int

    def forces(self, nodes: NDArray[np.intp], direction: Array) -> csr_matrix:
        """(n, m): one column for the unit force on each of `nodes` along `direction` (3, m)."""
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
            free = solve(self.matrix, right)
            residual = np.linalg.norm(self.matrix @ free - right)
            if not residual <= UNBALANCED * np.linalg.norm(right):
                raise LinAlgError(f"forces of {residual:.1e} N stay without balance")
        moved[self.free] = free
        return moved.reshape(3, self.nodes)

    @contextmanager
    def solving(self) -> Iterator[None]:
        """For the call of either solver: its own error becomes a SingularError that names the body."""
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
    body: BodyMesh, *, material: Material, semi_axes: tuple[float, float], shoulders: tuple[float, float] = UNCUT
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
    displacement[:, body.far] = pressed_ellipse(
        x, y, side * z, semi_axes=semi_axes, shoulders=shoulders, material=material
    )
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

    The columns of B are those of `push`, and `far_force`. PARDISO eliminates the degrees of freedom of K from
    [K B; B.T 0]; the Schur complement that remains is -B.T K^-1 B.
    """
    size, columns = matrix.shape[0], push.shape[1] + 1
    stiffest = matrix.diagonal().max()
    scale = stiffest / np.append(np.ones(columns - 1), np.abs(far_force).max() or 1.0)  # same magnitude as the matrix
    border = hstack([push, csr_matrix(far_force[:, None])]) @ diags_array(scale)
    corner = csr_matrix((np.zeros(columns), (np.arange(columns),) * 2), shape=(columns, columns))  # stored zeros
    upper = triu(vstack([hstack([matrix, border]), hstack([csr_matrix((columns, size)), corner])]), format="csr")
    upper.sort_indices()
    solver = _pardiso(schur=True)
    solver.perm = np.repeat(np.array([0, 1], dtype=np.int32), [size, columns])
    solver.set_phase(12)
    try:
        # pypardiso has no public call that returns a Schur complement; its `factorize` passes a vector to PARDISO
        complement = solver._call_pardiso(upper, np.zeros(max(size + columns, columns**2)))[: columns**2]
    finally:
        solver.free_memory(everything=True)
    moved = -complement.reshape(columns, columns) / np.outer(scale, scale)
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
    assert PyPardisoSolver is not None  # the caller has checked it
    solver = PyPardisoSolver(mtype=2)  # symmetric positive definite, upper triangle
    for number, value in ((1, 1), (2, 2), (10, 8), (36, int(schur))):  # own settings, METIS, pivot 1e-8, complement
        solver.set_iparm(number, value)
    return solver


def _by_superlu(matrix: csr_matrix, push: csr_matrix, far_force: Array) -> tuple[Array, Array, float]:
    """As `_by_pardiso`, from one solution for each touching node."""
    moved = _solution_by_superlu(matrix, np.column_stack([push.toarray(), far_force]))
    return push.T @ moved[:, :-1], push.T @ moved[:, -1], float(far_force @ moved[:, -1])


def _solution_by_superlu(matrix: csr_matrix, right: Array) -> Array:
    """K^-1 right."""
    factor = splu(matrix.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options={"SymmetricMode": True})
    return factor.solve(right)
