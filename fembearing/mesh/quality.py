"""Quality of the cells of a mesh."""

from dataclasses import dataclass

import numpy as np
from skfem import MeshHex2

from fembearing.mesh.hexahedron import cofactors, gauss_points, jacobian


@dataclass(frozen=True, kw_only=True)
class Quality:
    """Counts, volume, and the Jacobian determinant det J over the integration points of all cells."""

    cells: int
    nodes: int
    volume: float  # m^3
    least_determinant: float  # smallest det J over the mean |det J| of its cell; must be positive
    worst_cell: int  # the cell with the smallest value
    worst_place: tuple[float, float, float]  # its centre, m
    negative_points: int  # integration points with det J <= 0

    @property
    def valid(self) -> bool:
        return self.negative_points == 0


def mesh_quality(mesh: MeshHex2, *, degree: int = 5) -> Quality:
    """Quality at the integration points of a quadrature `degree`; the stiffness is integrated with 5."""
    shape = gauss_points(degree)
    _, determinant = cofactors(jacobian(mesh, shape))
    determinant = -determinant  # scikit-fem's reference cell is left-handed: det J = -1 on a unit cube
    relative = determinant.min(axis=1) / np.abs(determinant).mean(axis=1)
    worst = int(np.argmin(relative))
    x, y, z = mesh.p[:, mesh.t[:, worst]].mean(axis=1)
    return Quality(
        cells=mesh.t.shape[1],
        nodes=mesh.doflocs.shape[1],
        volume=float((determinant * shape.weights).sum()),
        least_determinant=float(relative[worst]),
        worst_cell=worst,
        worst_place=(float(x), float(y), float(z)),
        negative_points=int(np.count_nonzero(determinant <= 0)),
    )
