"""The patch under a contact: cells that follow the ellipse, from its centre to the far boundary.

Pressure ends at the edge of a contact like a square root; an edge that crosses cells would cause a first-order error of
the semi-axes. Here a ring of cell faces lies on the expected edge, and the cells shrink towards it from both sides. A
quarter of the patch is a square core with rings of cells around it:

    v        ____________
    |       |\\    |     |        u, v: coordinates of the patch; ring number max(u, v) - 1
    |       | \\___|_____|        core: max(u, v) <= 1
    |       |__|_\\      |        along a ring v/u (or u/v) runs from 0 on the axis
    |       |__|__|\\____|        to 1 on the diagonal
    +-----------------------u

A half of it has v < 0 too. Where a shoulder cuts the ellipse off, the ring on the edge follows the shoulder, and the
diagonal runs through the point where the shoulder meets the ellipse. That side gets twice as many cells along v, since
its ring turns through a larger angle.

`layer` counts cells along depth. Nodes of the quadratic cells sit at half steps of all three.
"""

from copy import copy
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray
from scipy.special import lambertw
from skfem import MeshHex1, MeshHex2

from analytic.scene import Array
from fembearing.mesh.footprint import UNCUT, Footprint
from fembearing.mesh.recipe import Cells, Depth, Patch

NODE = 1e-6  # tolerance of patch coordinates, which are multiples of 1/(2 cells)
# Taper of the core towards a shoulder that just touches the ellipse, over its width. Without it the cells between the
# corner of the core and that of the edge, where the edge has turned far, turn inside out.
CORNER = 0.6
KEPT = 16  # patches; a check of a scene uses fewer, and the largest holds 2 MB


@dataclass(frozen=True, kw_only=True, eq=False)
class PatchMesh:
    """The patch before it gets a shape: columns of nodes under (u, v), and the cells that connect them."""

    cells: Cells
    ends: tuple[float, float]  # where the contact is cut off, at v < 0 and at v > 0, in semi-axes; inf where it is not
    topology: MeshHex2  # with positions (u, v, layer)
    u: Array  # (columns,)
    v: Array  # (columns,)
    column: NDArray[np.intp]  # (nodes,) the column of each node
    layer: Array  # (nodes,) 0 to cells.depth, in half steps

    @property
    def ring(self) -> Array:
        """(columns,) number of rings outside the core; negative inside it."""
        return np.maximum(self.u, np.abs(self.v)) - 1.0

    def placed(self, position: Array) -> MeshHex2:
        """The cells with their nodes at `position` (3, nodes), m.

        A copy keeps the numbers of nodes, faces and edges that scikit-fem would work out again for a new mesh.
        """
        mesh = copy(self.topology)
        mesh.doflocs = np.ascontiguousarray(position)
        return mesh

    @property
    def half(self) -> bool:
        """Whether the patch has both sides of v = 0."""
        return bool(self.v.min() < -NODE)

    @property
    def zone(self) -> NDArray[np.bool_]:
        """(columns,) where contact is possible: inside the rim of the margin."""
        return self.ring < self.cells.inside + self.cells.margin - NODE


def patch_mesh(cells: Cells, *, ends: tuple[float, float] = UNCUT, half: bool = False) -> PatchMesh:
    """27-node hexahedra over the patch.

    ends : where the contact is cut off at v < 0 and at v > 0, in semi-axes, below 1; inf where it is not
    half : whether the patch has both sides of v = 0
    """
    below, above = (cells.core * (2 if np.isfinite(end) else 1) for end in ends)  # cells of the core
    return replace(_uncut(cells, below=below if half else 0, above=above), ends=ends)


@lru_cache(maxsize=KEPT)
def _uncut(cells: Cells, *, below: int, above: int) -> PatchMesh:
    """A patch with so many cells of the core at v < 0 and at v > 0; it serves every contact, whatever its `ends`."""
    corners: dict[tuple[float, float], int] = {}
    places = _quads(cells, below=below, above=above)
    quads = np.array(
        [[corners.setdefault((round(u, 9), round(v, 9)), len(corners)) for u, v in quad] for quad in places]
    ).T
    count = len(corners)
    plane = np.array(list(corners)).T
    points = np.hstack([np.vstack([plane, np.full(count, float(layer))]) for layer in range(cells.depth + 1)])
    low = np.hstack([quads + layer * count for layer in range(cells.depth)])
    high = low + count
    hexahedra = np.vstack([low[0], high[0], low[1], low[2], high[1], high[2], low[3], high[3]])  # scikit-fem's order
    topology = MeshHex2.from_mesh(MeshHex1(np.ascontiguousarray(points), np.ascontiguousarray(hexahedra)))
    assert topology.doflocs.shape[1] == topology.dofs.N  # numbered here, once for all its copies
    u, v, layer = topology.doflocs
    columns, column = np.unique(np.round(np.array([u, v]) / NODE).astype(np.int64), axis=1, return_inverse=True)
    return PatchMesh(
        cells=cells,
        ends=UNCUT,
        topology=topology,
        u=columns[0] * NODE,
        v=columns[1] * NODE,
        column=column.ravel(),
        layer=layer,
    )


def _quads(cells: Cells, *, below: int, above: int) -> list[list[tuple[float, float]]]:
    """Corners of every quadrilateral, in the order (0, 0), (0, 1), (1, 0), (1, 1) of its own axes.

    below, above : cells of the core at v < 0 and at v > 0
    """
    ends = [(di, dj) for di in (0, 1) for dj in (0, 1)]
    step = 1 / cells.core
    lines = [*(j / below for j in range(-below, 0)), *(j / above for j in range(above + 1))]
    strips = list(pairwise(lines))
    quads: list[list[tuple[float, float]]] = [
        [((i + di) * step, strip[dj]) for di, dj in ends] for i in range(cells.core) for strip in strips
    ]
    for ring in range(1, cells.rings + 1):
        quads += [[(float(ring + di), (ring + di) * strip[dj]) for di, dj in ends] for strip in strips]
        for j in range(cells.core):
            quads.append([((ring + dj) * (j + di) * step, float(ring + dj)) for di, dj in ends])
            if below:
                quads.append([((ring + 1 - dj) * (j + di) * step, -float(ring + 1 - dj)) for di, dj in ends])
    return quads


def contact_zone(patch: PatchMesh, *, shape: Patch, footprint: Footprint) -> Array:
    """x, y of the columns up to the margin, (2, columns), m; columns further out are put on its rim."""
    u, v, ring, cells = patch.u, patch.v, patch.ring, patch.cells
    direction = ray(u, v, ends=patch.ends)
    scale = np.maximum(1.0, np.maximum(u, np.abs(v)))
    core_u, core_v = u / scale, v / scale
    height = np.where(v < 0, *np.minimum(patch.ends, 1.0))  # the core is flattened like the contact
    taper = 1 - CORNER * np.maximum(0, 1 - np.sqrt(2 * (1 - height**2))) * np.abs(core_v) * (height < 1)
    bulge = shape.core_bulge / 2
    core = shape.core_size * np.array(
        [taper * core_u * np.sqrt(1 - bulge * core_v**2), height * core_v * np.sqrt(1 - bulge * core_u**2)]
    )
    inwards = np.clip(1 - ring / cells.inside, 0, 1) ** shape.edge_grading  # 1 at the core, 0 on the edge
    outwards = np.clip((ring - cells.inside) / cells.margin, 0, 1) ** shape.edge_grading  # 0 on the edge
    inside = core * inwards + direction * (1 - inwards)
    outside = direction * (1 + (shape.margin_size - 1) * outwards)
    place = np.where(ring <= NODE, core, np.where(ring <= cells.inside + NODE, inside, outside))
    rolling, transverse = footprint.semi_axes
    scales = [
        transverse if np.isinf(end) else shoulder / end
        for shoulder, end in zip(footprint.shoulders, patch.ends, strict=True)
    ]
    return np.array([rolling * place[0], np.where(v < 0, *scales) * place[1]])


def outside_share(patch: PatchMesh, *, rings: int, growth: float, straight: bool = True) -> Array:
    """(columns,) from 0 on the rim of the margin to 1 `rings` further out; `growth` is the ratio of the two radii.

    straight : middle nodes are centred; else they lie on the smooth curve through the rings, as far as their cell does
        not turn inside out, as it does with a middle node in its outer quarter
    """
    steps = np.arange(2 * rings + 1) / 2
    share = np.expm1(steps / rings * np.log(growth)) / (growth - 1)
    near, far = share[:-1:2], share[2::2]
    least = 0.5 if straight else 0.35
    share[1::2] = np.maximum(share[1::2], near + least * (far - near))
    return np.interp(patch.ring - patch.cells.inside - patch.cells.margin, steps, share)


def far_square(u: Array, v: Array) -> Array:
    """Where the ray of the patch through (u, v) meets the unit square, (2, ...): u from 0 to 1, v from -1 to 1."""
    reach = np.maximum(np.maximum(u, np.abs(v)), np.finfo(float).tiny)
    return np.array([u, v]) / reach


def depth_lines(layers: int, *, depth: Depth, minor: float, extent: float) -> Array:
    """Depths of the 2 layers + 1 nodes, m: layers are even down to `depth.layer`, then grow.

    Middle nodes are centred: on the smooth curve through the layers a thick cell would turn inside out.
    """
    even, share = depth.layer * minor, depth.share
    slope = even / share
    steps = np.linspace(0.0, 1.0, layers + 1)
    if slope >= extent:
        lines = steps * extent
    else:
        # The last line is at `extent`: expm1(x) = c x with x = rate (1 - share), which Lambert's W solves.
        c = (extent - even) / (slope * (1 - share))
        rate = (-1 / c - lambertw(-np.exp(-1 / c) / c, -1).real) / (1 - share)
        thicker = even + slope * np.expm1(rate * np.maximum(steps - share, 0)) / rate
        lines = np.where(steps <= share, slope * steps, thicker)
    return np.interp(np.arange(2 * layers + 1) / 2, np.arange(layers + 1), lines)


def ray(u: Array, v: Array, *, ends: tuple[float, float] = UNCUT) -> Array:
    """Vector from the centre to the edge, in semi-axes, (2, ...); its angle is even along a ring.

    It is a unit vector, or shorter where the contact is cut off at one of `ends`.
    """
    square_u, square_v = far_square(u, v)
    end = np.where(v < 0, *ends)
    cut = np.isfinite(end)
    height = np.where(cut, end, np.sqrt(0.5))  # of the point of the ellipse on the diagonal
    diagonal = np.where(cut, np.arcsin(height), np.pi / 4)
    sideways = np.abs(v) <= u
    angle = np.where(sideways, np.abs(square_v) * diagonal, np.pi / 2 - square_u * (np.pi / 2 - diagonal))
    x, y = np.cos(angle), np.sin(angle)
    flat = cut & ~sideways
    return np.array(
        [np.where(flat, square_u * np.cos(diagonal), x), np.where(v < 0, -1.0, 1.0) * np.where(flat, end, y)]
    )
