"""Stresses at the nodes of a deformed body, for its mesh file."""

import numpy as np
from skfem import Basis, ElementHex2, MeshHex2

from analytic.scene import Array, Material
from fembearing.fem.elasticity import lame_parameters
from fembearing.fem.subsurface import GAUSS

ROWS, COLUMNS = (0, 1, 2, 0, 1, 0), (0, 1, 2, 1, 2, 2)  # of xx, yy, zz, xy, yz and xz, as VTK orders a symmetric tensor


def stress_at_nodes(mesh: MeshHex2, displacement: Array, material: Material) -> Array:
    """Stress (6, nodes), Pa: xx, yy, zz, xy, yz, xz; tensile stress is positive.

    displacement : (3, nodes), m
    In each cell the stress at 2 x 2 x 2 Gauss points, where that of a quadratic cell is most accurate [Barlow1976],
    goes to the nodes by a function that is linear along each edge; a node takes the mean over its cells. On the surface
    of a contact it is extrapolated: the pressure there is the more accurate one.
    """
    points = np.array(np.meshgrid(GAUSS, GAUSS, GAUSS, indexing="ij")).reshape(3, -1)
    basis = Basis(mesh, ElementHex2(), quadrature=(points, np.ones(points.shape[1])))
    slope = np.array([basis.interpolate(part).grad for part in displacement])  # (3, 3, cells, points)
    lam, mu = lame_parameters(material)
    stress = mu * (slope + slope.swapaxes(0, 1))
    stress[range(3), range(3)] += lam * np.trace(slope)
    place = ElementHex2().doflocs  # (27, 3) of the nodes in the unit cube
    along = np.stack([GAUSS[1] - place, place - GAUSS[0]], axis=-1) / (GAUSS[1] - GAUSS[0])  # (27, 3, 2)
    to_nodes = np.einsum("ni,nj,nk->nijk", *along.swapaxes(0, 1)).reshape(len(place), -1)
    values = np.einsum("np,qcp->qnc", to_nodes, stress[ROWS, COLUMNS])
    numbers, count = basis.element_dofs.ravel(), mesh.doflocs.shape[1]
    sums = np.array([np.bincount(numbers, part.ravel(), minlength=count) for part in values])
    return sums / np.bincount(numbers, minlength=count)
