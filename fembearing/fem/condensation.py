"""Static condensation: a body reduced to the response of its contact nodes.

Under normal forces f, N, on the touching nodes and the far-field displacement of a load Q, N, the touching nodes move
by compliance @ f + drift * Q, m, along the direction of their force.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError
from scipy.sparse import csr_matrix, hstack

from analytic.errors import SingularError
from analytic.scene import Array, Material
from fembearing.fem.contact import is_positive_definite
from fembearing.fem.elasticity import CELL, PAIRS, cell_stiffness, surface_mass
from fembearing.fem.farfield import pressed_ellipse
from fembearing.fem.topology import Topology, topology_of
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.footprint import UNCUT

UNBALANCED = 1e-8  # relative residual force; round-off leaves less than 1e-12
RIGID = 6  # motions without deformation
REMEDY = "Check that it is held, its modulus, Poisson ratio (below 0.5) and mesh."


@dataclass(frozen=True, kw_only=True, eq=False)
class CondensedBody:
    """A body reduced to its m touching nodes."""

    compliance: Array  # (m, m) m/N, symmetric
    drift: Array  # (m,) m/N, for each newton of the whole load
    unknowns: int  # number before condensation


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
    further = middle_plane(system, body) if body.pinned else system.far_force
    with system.solving():
        moved = system.topology.complement(system.upper, csr_matrix(hstack([push, _column(further)])))
        compliance, drift, own = moved[:-1, :-1], moved[:-1, -1], float(moved[-1, -1])
        if body.pinned:
            transverse = drift[:, None] * force[1]
            compliance = compliance + own * force[1][:, None] * force[1] - transverse - transverse.T
            drift = np.zeros_like(drift)
        compliance = (compliance + compliance.T) / 2
        if not (np.isfinite(compliance).all() and is_positive_definite(compliance)):
            raise LinAlgError("touching nodes yield without resistance")
    return CondensedBody(compliance=compliance, drift=drift, unknowns=system.free.size)


def _column(values: Array) -> csr_matrix:
    """(n, 1) with all values stored, zeros too: then the sparsity is that of every other load."""
    count = values.size
    return csr_matrix((values, np.zeros(count, dtype=np.int32), np.arange(count + 1)), shape=(count, 1))


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
    topology: Topology
    upper: csr_matrix  # (n, n) N/m, upper triangle of a symmetric matrix
    far_force: Array  # (n,) force that the far field of a unit load puts on the free degrees of freedom
    held: Array  # (3, nodes) displacement of the held ones in the far field of a unit load, m/N; 0 at free ones

    @property
    def free(self) -> NDArray[np.intp]:
        """(n,) numbers of the free degrees of freedom."""
        return self.topology.free

    @property
    def nodes(self) -> int:
        return self.held.shape[1]

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
        moved = load * self.held.ravel()
        right = push + load * self.far_force
        with self.solving():
            free = self.topology.solution(self.upper, right)
            balanced = self.upper @ free + self.upper.T @ free - self.upper.diagonal() * free
            residual = np.linalg.norm(balanced - right)
            if not residual <= UNBALANCED * np.linalg.norm(right):
                raise LinAlgError(f"forces of {residual:.1e} N stay without balance")
        moved[self.free] = free
        return moved.reshape(3, self.nodes)

    @contextmanager
    def solving(self) -> Iterator[None]:
        """For the call of a factor: its error becomes a SingularError that names the body."""
        equations = f"{self.name}: its {self.free.size} equations"
        try:
            diagonal = self.upper.diagonal()
            if not (np.isfinite(self.upper.data).all() and (diagonal > 0).all()):  # an empty row would crash PARDISO
                raise LinAlgError("a stiffness that is not finite and positive")
            yield
        except (LinAlgError, MemoryError) as problem:
            if isinstance(problem, MemoryError):
                remedy = "Ask for a larger tolerance, which takes a coarser mesh."
                raise SingularError(problem=f"{equations} do not fit into memory", remedy=remedy) from problem
            raise SingularError(
                problem=f"{equations} have no single answer: {str(problem).rstrip('.')}", remedy=REMEDY
            ) from problem


def _rigid_motions(places: Array) -> Array:
    """(3, n, 6): three translations and three rotations of nodes at (3, n), over the size of the body."""
    x = places - places.mean(axis=1, keepdims=True)
    x /= np.abs(x).max()
    motions = np.zeros((*x.shape, RIGID))
    for axis in range(3):
        following, last = (axis + 1) % 3, (axis + 2) % 3
        motions[axis, :, axis] = 1.0
        motions[following, :, 3 + axis], motions[last, :, 3 + axis] = -x[last], x[following]
    return motions


def held_stiffness(
    body: BodyMesh, *, material: Material, semi_axes: tuple[float, float], shoulders: tuple[float, float] = UNCUT
) -> HeldBody:
    """Assemble a body and hold its planes of symmetry and its far boundary.

    Raises SingularError for a body that can move without deformation: on some processors round-off factors it.
    """
    entries = cell_stiffness(body.mesh, material)
    cells, count = body.mesh.dofs.element_dofs, body.mesh.doflocs.shape[1]
    is_held = np.zeros((3, count), dtype=bool)
    for axis, plane in enumerate(body.planes):
        is_held[axis, plane] = True
    is_held[:, body.far] = True
    is_held[:, body.clamped] = True
    if np.count_nonzero(is_held) < RIGID or np.linalg.matrix_rank(_rigid_motions(body.mesh.doflocs)[is_held]) < RIGID:
        raise SingularError(
            problem=f"{body.name}: its {int(np.sum(~is_held))} equations have no single answer: it can move without "
            "deformation",
            remedy=REMEDY,
        )
    x, y, z = body.mesh.doflocs[:, body.far]
    side = 1.0 if z.size and z.min() >= 0 else -1.0
    displacement = np.zeros((3, count))
    displacement[:, body.far] = pressed_ellipse(
        x, y, side * z, semi_axes=semi_axes, shoulders=shoulders, material=material
    )
    displacement[2] *= side
    displacement[~is_held] = 0.0
    topology = topology_of(cells, is_held)
    return HeldBody(
        name=body.name,
        topology=topology,
        upper=topology.assembled(entries),
        far_force=-nodal_forces(displacement, cells, entries)[topology.free],
        held=displacement,
    )


def nodal_forces(displacement: Array, cells: NDArray[np.intp], entries: Array) -> Array:
    """Forces (3 nodes,), N/m times the unit of `displacement`, (3, nodes), on all degrees of freedom.

    entries : `cell_stiffness` of the `cells`; few of them have nodes that move
    """
    moving = np.flatnonzero((displacement != 0).any(axis=0)[cells].any(axis=0))
    stiffness = np.empty((moving.size, CELL, CELL))
    first, second = PAIRS
    stiffness[:, first, second] = stiffness[:, second, first] = entries[moving]
    nodes = displacement.shape[1]
    numbers = (np.arange(3)[:, None, None] * nodes + cells[:, moving]).reshape(CELL, -1).T
    forces = stiffness @ displacement.ravel()[numbers][:, :, None]
    return np.bincount(numbers.ravel(), forces.ravel(), minlength=3 * nodes).astype(np.float64)
