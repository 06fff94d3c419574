"""A body: its mesh and the sets of nodes that carry conditions; and the grid of a block."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from skfem import MeshHex2

from analytic.scene import Array
from fembearing.mesh.patch import NODE, PatchMesh, depth_lines, far_square, outside_share
from fembearing.mesh.recipe import Cells, Recipe

FURTHER = 2.0  # size of an extended block over its own, to measure the effect of its far boundary

Nodes = NDArray[np.intp]
BodyName = Literal["ball", "race", "pocket wall", "half space", "ring"]


@dataclass(frozen=True, kw_only=True, eq=False)
class BodyMesh:
    """One body's mesh and the sets of nodes that carry conditions."""

    name: BodyName  # which body it is
    mesh: MeshHex2  # positions in m, frame of `fembearing.mesh`
    touching: Nodes  # (m,) nodes that may come into contact, in the same order in both bodies
    surface: Nodes  # numbers of all nodes of the loaded surface
    far: Nodes  # numbers of the nodes that carry the far-field displacement of a half space
    clamped: Nodes  # numbers of the nodes that cannot move
    planes: tuple[Nodes, Nodes, Nodes]  # numbers of those with u_x, u_y, u_z = 0; for u_y, half a ball has its centre

    @property
    def pinned(self) -> bool:
        """Whether a single node holds the body transversely: the centre of a ball without that plane of symmetry."""
        return self.planes[1].size == 1


def body_mesh(name: BodyName, patch: PatchMesh, position: Array) -> BodyMesh:
    """A body with nodes at `position` (3, nodes), m. The loaded layer is the first one if z > 0, else the last."""
    lower = position[2].min() < 0 and name != "ball"
    surface_layer = patch.cells.depth if lower else 0
    on_surface = np.abs(patch.layer - surface_layer) < NODE
    ring, column = patch.ring, patch.column
    order = np.full(ring.size, -1)
    order[column[on_surface]] = np.flatnonzero(on_surface)
    outermost = (ring > patch.cells.rings - NODE)[column]
    deepest = np.abs(patch.layer - (patch.cells.depth - surface_layer)) < NODE
    none = np.array([], dtype=np.intp)
    still = (np.abs(patch.v) < NODE)[column]
    if patch.half:
        still &= deepest & (patch.u < NODE)[column] & (name == "ball")
    return BodyMesh(
        name=name,
        mesh=patch.placed(position),
        touching=order[patch.zone],
        surface=np.flatnonzero(on_surface),
        far=np.flatnonzero(outermost | deepest) if name in ("race", "half space") else none,
        clamped=np.flatnonzero(outermost) if name == "pocket wall" else none,
        planes=(
            np.flatnonzero((patch.u < NODE)[column]),
            np.flatnonzero(still),
            np.flatnonzero(deepest) if name == "ball" else none,
        ),
    )


def cells_of(recipe: Recipe, level: int, *, growth: float) -> Cells:
    """Cell counts of a level; more than in the recipe where a far boundary `growth` semi-axes away needs them."""
    needed = int(np.ceil(np.log(growth) / np.log(recipe.domain.growth)))
    base = recipe.cells
    return replace(base, outside=max(base.outside, needed), depth=max(base.depth, needed)).times(level)


@dataclass(frozen=True, kw_only=True)
class Block:
    """The grid of a block: columns under the patch, outwards and downwards to `reach`, or to `further`, m."""

    recipe: Recipe
    level: int
    semi_axes: tuple[float, float]
    reach: float
    further: float | None = None

    @property
    def extent(self) -> float:
        """Distance of the far boundary, m."""
        return self.reach if self.further is None else self.further

    @property
    def whole(self) -> Cells:
        """Cell counts up to `reach`."""
        return cells_of(self.recipe, self.level, growth=self.reach / min(self.semi_axes))

    @property
    def growth(self) -> float:
        """Ratio of `reach` to the rim of the margin."""
        return self.reach / (self.recipe.patch.margin_size * min(self.semi_axes))

    @property
    def added(self) -> Array:
        """Rings and layers from `reach` to `further`, over `reach`; they grow by the ratio of the rings inside."""
        if self.further is None:
            return np.array([])
        ratio = self.further / self.reach
        each = int(np.ceil(np.log(ratio) * self.whole.outside / self.level / np.log(self.growth)))
        count = each * self.level
        return ratio ** (np.arange(1, count + 1) / count)

    @property
    def cells(self) -> Cells:
        """Cell counts of the whole block."""
        return replace(
            self.whole, outside=self.whole.outside + self.added.size, depth=self.whole.depth + self.added.size
        )

    def plane(self, patch: PatchMesh, zone: Array) -> Array:
        """x, y of the columns, (2, columns), m; `zone` holds those in the contact, and its rim for the others."""
        share = outside_share(patch, rings=self.whole.outside, growth=self.growth)
        added = np.interp(patch.ring - self.whole.rings, np.arange(self.added.size + 1), [1.0, *self.added])
        return zone * (1 - share) + self.reach * share * added * far_square(patch.u, patch.v)

    def stack(self, patch: PatchMesh, plane: Array, height: Array, *, side: Literal[1, -1]) -> Array:
        """Positions (3, nodes), m, of columns from their `height` to the plane z = side * reach.

        Layers of the lower body are counted upwards from the far boundary, so that its cells stay right-handed.
        """
        lines = depth_lines(self.whole.depth, depth=self.recipe.depth, minor=min(self.semi_axes), extent=self.reach)
        corners = np.append(lines[::2], self.reach * self.added)
        lines = np.interp(np.arange(2 * corners.size - 1) / 2, np.arange(corners.size), corners)
        step = np.rint(2 * patch.layer).astype(int)
        share = lines[step if side > 0 else lines.size - 1 - step] / self.reach
        start = height[patch.column]
        x, y = plane[:, patch.column]
        return np.array([x, y, start * np.maximum(1 - share, 0) + side * self.reach * share])
