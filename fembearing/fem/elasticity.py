"""Linear elasticity: the stiffness of one body. Degrees of freedom: u_x of all nodes, then u_y, then u_z."""

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from skfem import ElementHex2, MeshHex2
from skfem.quadrature import get_quadrature
from skfem.refdom import RefQuad

from analytic.errors import InputError, require_positive
from analytic.scene import Array, Contact, Material
from fembearing.mesh.hexahedron import ShapeFunctions, cofactors, gauss_points, jacobian, shape_functions

QUADRATURE = 5  # degree: 3 points in each direction, exact for a quadratic cell that is a brick
# Above this Poisson ratio the change of volume is integrated with 2 points in each direction. With 3 a quadratic cell
# locks: at 0.4999 and 35 000 unknowns the peak pressure is 60 % too high; with 2, 0.02 %. Below, both agree.
NEARLY_INCOMPRESSIBLE = 0.45
REDUCED = 3  # degree: 2 points in each direction
CELL = 81  # degrees of freedom of a cell
PAIRS = np.tril_indices(CELL)  # two degrees of freedom of a cell: each pair once
AT_ONCE = 64  # cells whose products fit into a processor's cache together
CORNERS = 4  # of a facet
FINE = 30  # points in each direction over a facet that the border of a strip crosses


def require_elastic(contact: Contact) -> None:
    """Raise InputError unless both bodies of a contact are stable elastic ones and the load is positive."""
    require_positive(load=contact.load, ball_radius=contact.ball_radius)
    if not contact.groove_radius > 0:  # infinite: a flat
        raise InputError(f"groove_radius must be positive, got {contact.groove_radius!r}; check sign and unit")
    for material in (contact.ball_material, contact.race_material):
        require_positive(youngs_modulus=material.youngs_modulus)
        if not -1 < material.poisson_ratio < 0.5:
            raise InputError(
                f"{material.name}: poisson_ratio must lie above -1 and below 0.5, got {material.poisson_ratio:g}; "
                "0.4999 stands for an incompressible body"
            )


def lame_parameters(material: Material) -> tuple[float, float]:
    """lambda and mu, Pa. Source: any textbook, for example [Timoshenko1970]."""
    modulus, ratio = material.youngs_modulus, material.poisson_ratio
    return modulus * ratio / ((1 + ratio) * (1 - 2 * ratio)), modulus / (2 * (1 + ratio))


def cell_stiffness(mesh: MeshHex2, material: Material) -> Array:
    """Stiffness of each cell, (cells, 3321), N/m, of the weak form lambda div u div v + 2 mu eps(u) : eps(v).

    An entry belongs to two degrees of freedom of the cell, rows and columns of `PAIRS`; the other triangle is the same.
    Of a cell they are u_x of its 27 nodes, then u_y, then u_z.
    """
    lam, mu = lame_parameters(material)
    reduced = material.poisson_ratio > NEARLY_INCOMPRESSIBLE
    count = mesh.dofs.element_dofs.shape[1]
    entries = np.empty((count, PAIRS[0].size))
    for start in range(0, count, AT_ONCE):
        cells = slice(start, start + AT_ONCE)
        product = _products(mesh, QUADRATURE, cells)
        dilation = _products(mesh, REDUCED, cells) if reduced else product
        whole = lam * dilation + mu * product.transpose(0, 3, 2, 1, 4)
        laplace = mu * np.trace(product, axis1=1, axis2=3)
        for axis in range(3):
            whole[:, axis, :, axis] += laplace
        entries[cells] = whole.reshape(-1, CELL, CELL)[:, *PAIRS]
    return entries


def _products(mesh: MeshHex2, degree: int, cells: slice) -> Array:
    """Integrals of d_i v d_j u over each cell, (cells, 3, 27, 3, 27), m: i and v are the first two axes of four.

    A `Basis` would invert the map of every cell once for each of its 27 functions.
    """
    shape = gauss_points(degree)
    inverse, determinant = cofactors(jacobian(mesh, shape, cells))
    inverse *= np.sqrt(shape.weights / np.abs(determinant))[:, None, None]  # its sign does not matter to a product
    rows = np.einsum("fjp,cijp->cifp", shape.gradients, inverse)
    count, axes, functions, points = rows.shape
    rows = rows.reshape(count, axes * functions, points)
    return (rows @ rows.transpose(0, 2, 1)).reshape(count, axes, functions, axes, functions)


def surface_mass(mesh: MeshHex2, nodes: NDArray[np.intp]) -> csr_matrix:
    """Mass matrix (m, m), m^2, of the surface facets whose corners are all among `nodes`; rows follow `nodes`.

    It turns nodal forces into a pressure: a force is the integral of the pressure times the shape function. All facets
    must be the same side of their cells, as those of a patch are: then the points are the same in every cell.
    """
    cells, shape, area = _surface(mesh, nodes, *get_quadrature(RefQuad, QUADRATURE))
    mass = np.einsum("ip,jp,cp->cij", shape.values, shape.values, area, optimize=True)
    numbers = mesh.dofs.element_dofs[:, cells].T
    rows, columns = np.broadcast_arrays(numbers[:, :, None], numbers[:, None, :])
    count = mesh.doflocs.shape[1]
    whole = csr_matrix((mass.ravel(), (rows.ravel(), columns.ravel())), shape=(count, count))
    return csr_matrix(whole[nodes][:, nodes])


def strip_integrals(mesh: MeshHex2, nodes: NDArray[np.intp], *, low: float, high: float) -> Array:
    """(m,) m^2: integrals of the shape functions of `nodes` over the part of their surface where low < y < high, m.

    The borders of the strip cross facets: each facet is summed over `FINE` by `FINE` points of equal weight.
    """
    ticks = (np.arange(FINE) + 0.5) / FINE
    points = np.array(np.meshgrid(ticks, ticks)).reshape(2, -1)
    cells, shape, area = _surface(mesh, nodes, points, np.full(FINE**2, FINE**-2.0))
    numbers = mesh.dofs.element_dofs[:, cells]
    y = mesh.doflocs[1, numbers].T @ shape.values
    inside = area * ((low < y) & (y < high))
    weights = (shape.values @ inside.T).ravel()
    return np.bincount(numbers.ravel(), weights, minlength=mesh.doflocs.shape[1]).astype(np.float64)[nodes]


def _surface(
    mesh: MeshHex2, nodes: NDArray[np.intp], points: Array, weights: Array
) -> tuple[NDArray[np.intp], ShapeFunctions, Array]:
    """Quadrature over the facets whose corners are all among `nodes`.

    points, weights : (2, p) and (p,) on the unit square
    Returns the numbers of the facets' cells, the functions at the points, and areas (cells, p), m^2.
    """
    among = np.isin(mesh.t, nodes)
    cells = np.flatnonzero(among.sum(axis=0) == CORNERS)
    side = among[:, cells[0]]
    assert (among[:, cells] == side[:, None]).all()
    corners = ElementHex2.refdom.p[:, side]
    normal = int(np.flatnonzero(np.ptp(corners, axis=1) == 0)[0])  # axis normal to the facet
    shape = shape_functions(np.insert(points, normal, corners[normal, 0], axis=0), weights)
    along = jacobian(mesh, shape, cells)
    first, second = (along[:, :, axis] for axis in range(3) if axis != normal)
    return cells, shape, np.linalg.norm(np.cross(first, second, axis=1), axis=1) * weights
