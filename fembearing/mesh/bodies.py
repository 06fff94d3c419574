"""A body as a mesh with the sets of nodes that carry conditions, and what all bodies are built with."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from skfem import MeshHex2

from fembearing.mesh.patch import NODE, PatchMesh, depth_lines, far_square, outside_share
from fembearing.mesh.recipe import Cells, Recipe

Array = NDArray[np.float64]
Nodes = NDArray[np.intp]
BodyName = Literal["ball", "race", "pocket wall", "half space"]


@dataclass(frozen=True, kw_only=True, eq=False)
class BodyMesh:
    """One body's mesh and the sets of nodes that carry conditions."""

    name: BodyName
    mesh: MeshHex2  # positions in m, frame of `fembearing.mesh`
    touching: Nodes  # (m,) nodes that may come into contact, in the same order in both bodies
    surface: Nodes  # all nodes of the loaded surface
    far: Nodes  # nodes that carry the far-field displacement of a half space
    clamped: Nodes  # nodes that cannot move
    planes: tuple[Nodes, Nodes, Nodes]  # nodes with u_x = 0, u_y = 0, u_z = 0


def body_mesh(name: BodyName, patch: PatchMesh, position: Array) -> BodyMesh:
    """A body whose nodes lie at `position` (3, nodes), m. Its first layer is the loaded one where it lies at z > 0."""
    lower = position[2].min() < 0 and name != "ball"
    surface_layer = patch.cells.depth if lower else 0
    on_surface = np.abs(patch.layer - surface_layer) < NODE
    ring, column = patch.ring, patch.column
    order = np.full(ring.size, -1)
    order[column[on_surface]] = np.flatnonzero(on_surface)
    outermost = (ring > patch.cells.rings - NODE)[column]
    deepest = np.abs(patch.layer - (patch.cells.depth - surface_layer)) < NODE
    none = np.array([], dtype=np.intp)
    return BodyMesh(
        name=name,
        mesh=MeshHex2(np.ascontiguousarray(position), patch.topology.t),
        touching=order[patch.zone],
        surface=np.flatnonzero(on_surface),
        far=np.flatnonzero(outermost | deepest) if name in ("race", "half space") else none,
        clamped=np.flatnonzero(outermost) if name == "pocket wall" else none,
        planes=(
            np.flatnonzero((patch.u < NODE)[column]),
            np.flatnonzero((patch.v < NODE)[column]),
            np.flatnonzero(deepest) if name == "ball" else none,
        ),
    )


def cells_of(recipe: Recipe, level: int, *, growth: float) -> Cells:
    """Cell counts of a level; more of them where a far boundary `growth` times off the contact needs them."""
    needed = int(np.ceil(np.log(growth) / np.log(recipe.domain.growth)))
    base = recipe.cells
    return replace(base, outside=max(base.outside, needed), depth=max(base.depth, needed)).times(level)


@dataclass(frozen=True, kw_only=True)
class Block:
    """The grid of a block: columns under the patch out to `reach` and down to it."""

    recipe: Recipe
    level: int
    semi_axes: tuple[float, float]
    reach: float

    @property
    def whole(self) -> Cells:
        return cells_of(self.recipe, self.level, growth=self.reach / min(self.semi_axes))

    def cells(self, trimmed: bool) -> Cells:
        """All of them, or all but the outermost ring and layer."""
        whole = self.whole
        return replace(whole, outside=whole.outside - 1, depth=whole.depth - 1) if trimmed else whole

    def plane(self, patch: PatchMesh, zone: Array) -> Array:
        """x, y of the columns, (2, columns), m; `zone` is where they start, those further out on its rim."""
        growth = self.reach / (self.recipe.patch.margin_size * min(self.semi_axes))
        share = outside_share(patch, rings=self.whole.outside, growth=growth)
        return zone * (1 - share) + self.reach * far_square(patch.u, patch.v) * share

    def stack(self, patch: PatchMesh, plane: Array, height: Array, *, side: Literal[1, -1]) -> Array:
        """Positions (3, nodes) of columns that run from their `height` towards the plane z = side * reach.

        Layers of a body below are counted from the far boundary upwards, so that its cells stay right-handed.
        """
        lines = depth_lines(self.whole.depth, depth=self.recipe.depth, minor=min(self.semi_axes), extent=self.reach)
        lines = lines[: 2 * patch.cells.depth + 1]
        step = np.rint(2 * patch.layer).astype(int)
        share = lines[step if side > 0 else lines.size - 1 - step] / self.reach
        start = height[patch.column]
        x, y = plane[:, patch.column]
        return np.array([x, y, start + (side * self.reach - start) * share])
