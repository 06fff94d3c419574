"""The map of a quadratic cell from the unit cube to its place, for all cells of a mesh at once."""

from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import NDArray
from skfem import ElementHex2, MeshHex2
from skfem.quadrature import get_quadrature
from skfem.refdom import RefHex

from analytic.scene import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class ShapeFunctions:
    """The 27 functions of a cell at p points of the unit cube."""

    weights: Array  # (p,) of the points in a sum that integrates over the cube
    values: Array  # (27, p)
    gradients: Array  # (27, 3, p)


def shape_functions(points: Array, weights: Array) -> ShapeFunctions:
    """The functions at `points` (3, p)."""
    element = ElementHex2()
    each = [element.lbasis(points, number) for number in range(element.doflocs.shape[0])]
    values = np.array([np.broadcast_to(value, points.shape[1]) for value, _ in each])
    return ShapeFunctions(weights=weights, values=values, gradients=np.array([gradient for _, gradient in each]))


@cache
def gauss_points(degree: int) -> ShapeFunctions:
    """The functions at Gauss points that integrate polynomials of a degree; the same for every mesh."""
    return shape_functions(*get_quadrature(RefHex, degree))


def jacobian(mesh: MeshHex2, shape: ShapeFunctions, cells: NDArray[np.intp] | slice = slice(None)) -> Array:
    """Derivatives of the place with respect to the unit cube, (cells, 3, 3, p), m: the first axis of two is the place.

    One matrix product serves all cells, as the functions are the same in each.
    """
    nodes = mesh.doflocs[:, mesh.dofs.element_dofs[:, cells]]  # (3, 27, cells)
    functions, axes, points = shape.gradients.shape
    places = np.moveaxis(nodes, 2, 0).reshape(-1, functions)
    return (places @ shape.gradients.reshape(functions, -1)).reshape(-1, axes, axes, points)


def cofactors(jacobians: Array) -> tuple[Array, Array]:
    """Of each Jacobian, (cells, 3, 3, p): its inverse, transposed, times its determinant; and that, (cells, p)."""
    following, after = np.roll(jacobians, -1, axis=1), np.roll(jacobians, -2, axis=1)
    found = np.cross(following, after, axis=2)
    return found, np.sum(jacobians[:, 0] * found[:, 0], axis=1)
