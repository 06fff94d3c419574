"""Linear elasticity: the stiffness of one body. Degrees of freedom run u_x of all nodes, then u_y, then u_z."""

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import bmat, csr_matrix
from skfem import Basis, BilinearForm, ElementHex2, FacetBasis, MeshHex2

from analytic.scene import Material

QUADRATURE = 5  # degree: 3 points each way integrate a quadratic cell's products exactly where it is a brick
# Above this Poisson ratio the change of volume is integrated with 2 points each way. With 3 a quadratic cell locks: at
# 0.4999 the peak pressure comes out 60 % high on 35 000 unknowns, with 2 it is right to 0.02 %. Below, both agree.
NEARLY_INCOMPRESSIBLE = 0.45
REDUCED = 3  # degree: 2 points each way


def lame_parameters(material: Material) -> tuple[float, float]:
    """lambda and mu, Pa. Source: any text book, for example Timoshenko and Goodier, Theory of Elasticity."""
    modulus, ratio = material.youngs_modulus, material.poisson_ratio
    return modulus * ratio / ((1 + ratio) * (1 - 2 * ratio)), modulus / (2 * (1 + ratio))


def scalar_basis(mesh: MeshHex2) -> Basis:
    """Quadratic shape functions of one displacement component; its numbering is that of the mesh's nodes."""
    return Basis(mesh, ElementHex2(), intorder=QUADRATURE)


def stiffness(basis: Basis, material: Material) -> csr_matrix:
    """Stiffness matrix (3 n, 3 n), N/m, of the weak form lambda div u div v + 2 mu eps(u) : eps(v).

    Built from the nine products of derivatives d_i v d_j u: one vector form over all 81 functions
    of a cell takes about five times as long (measured on 512 cells).
    """
    lam, mu = lame_parameters(material)
    product = dilation = _products(basis)
    if material.poisson_ratio > NEARLY_INCOMPRESSIBLE:
        dilation = _products(Basis(basis.mesh, ElementHex2(), intorder=REDUCED))
    laplace = product[0, 0] + product[1, 1] + product[2, 2]
    blocks = [
        [lam * dilation[i, j] + mu * product[j, i] + (mu * laplace if i == j else 0 * laplace) for j in range(3)]
        for i in range(3)
    ]
    return csr_matrix(bmat(blocks, format="csr"))


def _products(basis: Basis) -> dict[tuple[int, int], csr_matrix]:
    """The integrals of d_i v d_j u, m."""
    product: dict[tuple[int, int], csr_matrix] = {}
    for i in range(3):
        for j in range(i, 3):
            product[i, j] = BilinearForm(lambda u, v, _, i=i, j=j: v.grad[i] * u.grad[j]).assemble(basis)
            product[j, i] = product[i, j].T
    return product


def surface_mass(mesh: MeshHex2, nodes: NDArray[np.intp]) -> csr_matrix:
    """Mass matrix (m, m), m^2, of the surface facets whose corners are all among `nodes`; rows follow `nodes`.

    It turns nodal forces into a pressure: the forces are the integrals of pressure times shape function.
    """
    corners = np.isin(mesh.facets, nodes).all(axis=0)
    facets = np.intersect1d(np.flatnonzero(corners), mesh.boundary_facets())
    basis = FacetBasis(mesh, ElementHex2(), facets=facets, intorder=QUADRATURE)
    mass = BilinearForm(lambda u, v, _: u * v).assemble(basis)
    return csr_matrix(mass[nodes][:, nodes])
