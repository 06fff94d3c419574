"""Whole matrices from the entries of cells, added one by one: nothing is kept, held or left out."""

import numpy as np
from scipy.sparse import csr_matrix, triu
from skfem import MeshHex2

from analytic.scene import Material
from fembearing.fem.elasticity import CELL, PAIRS, cell_stiffness


def stiffness(mesh: MeshHex2, material: Material) -> csr_matrix:
    """(3 nodes, 3 nodes), N/m; u_x of all nodes come first, then u_y, then u_z."""
    size = mesh.doflocs.size
    cells = np.zeros((mesh.t.shape[1], CELL, CELL))
    first, second = PAIRS
    cells[:, first, second] = cells[:, second, first] = cell_stiffness(mesh, material)
    numbers = np.concatenate([mesh.dofs.element_dofs + axis * mesh.doflocs.shape[1] for axis in range(3)]).T
    rows, columns = np.broadcast_arrays(numbers[:, :, None], numbers[:, None, :])
    return csr_matrix((cells.ravel(), (rows.ravel(), columns.ravel())), shape=(size, size))


def symmetric(upper: csr_matrix) -> csr_matrix:
    """The whole of a matrix given by its upper triangle."""
    return csr_matrix(upper + triu(upper, 1).T)
