"""Linear elasticity: the stiffness of one body. Degrees of freedom: u_x of all nodes, then u_y, then u_z."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import bmat, csr_matrix
from skfem import Basis, ElementHex2, MeshHex2
from skfem.quadrature import get_quadrature
from skfem.refdom import RefHex, RefQuad

from analytic.errors import InputError, require_positive
from analytic.scene import Contact, Material

Array = NDArray[np.float64]

QUADRATURE = 5  # degree: 3 points in each direction, exact for a quadratic cell that is a brick
# Above this Poisson ratio the change of volume is integrated with 2 points in each direction. With 3 a quadratic cell
# locks: at 0.4999 and 35 000 unknowns the peak pressure is 60 % too high; with 2, 0.02 %. Below, both agree.
NEARLY_INCOMPRESSIBLE = 0.45
REDUCED = 3  # degree: 2 points in each direction
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


def stiffness(mesh: MeshHex2, material: Material) -> csr_matrix:
    """Stiffness matrix (3 n, 3 n), N/m, of the weak form lambda div u div v + 2 mu eps(u) : eps(v).

    One matrix product gives the nine products of derivatives of a cell, and all nine blocks share the sparsity of one
    displacement component. A `Basis` would invert the map of every cell once for each of its 27 functions.
    """
    lam, mu = lame_parameters(material)
    product = dilation = _products(mesh, QUADRATURE)
    if material.poisson_ratio > NEARLY_INCOMPRESSIBLE:
        dilation = _products(mesh, REDUCED)
    laplace = np.trace(product, axis1=1, axis2=2)
    sum_up = _summation(mesh.dofs.element_dofs.T, mesh.doflocs.shape[1])
    blocks = [
        [sum_up(lam * dilation[:, i, j] + mu * product[:, j, i] + (mu * laplace if i == j else 0.0)) for j in range(3)]
        for i in range(3)
    ]
    return csr_matrix(bmat(blocks, format="csr"))


def _products(mesh: MeshHex2, degree: int) -> Array:
    """Integrals of d_i v d_j u over each cell, (cells, 3, 3, 27, 27), m; v runs along the last axis but one."""
    points, weights = get_quadrature(RefHex, degree)
    mapping, element = mesh.mapping(), mesh.elem()
    functions = mesh.dofs.element_dofs.shape[0]
    local = np.array([element.lbasis(points, number)[1] for number in range(functions)])  # (27, 3, points)
    gradient = np.einsum("fip,ijcp->cjfp", local, mapping.invDF(points), optimize=True)
    cells, axes, *_ = gradient.shape
    rows = gradient.reshape(cells, axes * functions, -1)
    volume = np.abs(mapping.detDF(points)) * weights  # (cells, points), m^3
    product = (rows * volume[:, None]) @ rows.transpose(0, 2, 1)
    return product.reshape(cells, axes, functions, axes, functions).transpose(0, 1, 3, 2, 4)


def _summation(nodes: NDArray[np.intp], count: int) -> Callable[[Array], csr_matrix]:
    """A function that adds cell matrices (cells, f, f) into one over `count` nodes; `nodes` (cells, f) of each cell."""
    rows, columns = np.broadcast_arrays(nodes[:, :, None], nodes[:, None, :])
    entries, place = np.unique(rows.ravel().astype(np.int64) * count + columns.ravel(), return_inverse=True)
    start = np.searchsorted(entries, np.arange(count + 1, dtype=np.int64) * count)

    def sum_up(parts: Array) -> csr_matrix:
        total = np.bincount(place, weights=parts.ravel(), minlength=entries.size)
        return csr_matrix((total, entries % count, start), shape=(count, count))

    return sum_up


def surface_mass(mesh: MeshHex2, nodes: NDArray[np.intp]) -> csr_matrix:
    """Mass matrix (m, m), m^2, of the surface facets whose corners are all among `nodes`; rows follow `nodes`.

    It turns nodal forces into a pressure: a force is the integral of the pressure times the shape function. All facets
    must be the same side of their cells, as those of a patch are: then the points are the same in every cell.
    """
    basis, area = _surface(mesh, nodes, *get_quadrature(RefQuad, QUADRATURE))
    shape = _shape_functions(basis, area)
    mass = _summation(basis.element_dofs.T, basis.N)(np.einsum("icp,jcp,cp->cij", shape, shape, area, optimize=True))
    return csr_matrix(mass[nodes][:, nodes])


def strip_integrals(mesh: MeshHex2, nodes: NDArray[np.intp], *, low: float, high: float) -> Array:
    """(m,) m^2: integrals of the shape functions of `nodes` over the part of their surface where low < y < high, m.

    The borders of the strip cross facets: each facet is summed over `FINE` by `FINE` points of equal weight.
    """
    ticks = (np.arange(FINE) + 0.5) / FINE
    points = np.array(np.meshgrid(ticks, ticks)).reshape(2, -1)
    basis, area = _surface(mesh, nodes, points, np.full(FINE**2, FINE**-2.0))
    y = np.asarray(basis.global_coordinates())[1]
    inside = area * ((low < y) & (y < high))
    whole = np.zeros(basis.N)
    np.add.at(whole, basis.element_dofs, np.einsum("icp,cp->ic", _shape_functions(basis, area), inside))
    return whole[nodes]


def _surface(mesh: MeshHex2, nodes: NDArray[np.intp], points: Array, weights: Array) -> tuple[Basis, Array]:
    """Quadrature over the facets whose corners are all among `nodes`: the basis, and areas (cells, points), m^2.

    points, weights : (2, p) and (p,) on the unit square
    """
    among = np.isin(mesh.t, nodes)
    cells = np.flatnonzero(among.sum(axis=0) == CORNERS)
    side = among[:, cells[0]]
    assert (among[:, cells] == side[:, None]).all()
    corners = ElementHex2.refdom.p[:, side]
    normal = int(np.flatnonzero(np.ptp(corners, axis=1) == 0)[0])  # axis normal to the facet
    points = np.insert(points, normal, corners[normal, 0], axis=0)
    basis = Basis(mesh, ElementHex2(), elements=cells, quadrature=(points, weights))
    first, second = np.delete(basis.mapping.DF(points, tind=cells), normal, axis=1).swapaxes(0, 1)
    return basis, np.linalg.norm(np.cross(first, second, axis=0), axis=0) * weights


def _shape_functions(basis: Basis, area: Array) -> Array:
    """Values of the shape functions, (27, cells, points)."""
    return np.array([np.broadcast_to(np.asarray(each[0]), area.shape) for each in basis.basis])
