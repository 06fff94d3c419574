"""The bodies of a contact as meshes: half space, octant of a ball, block of a grooved ring.

Both bodies of a pair are meshed over the same patch, so their contact nodes face each other:
a ball's node and the race's node where the ball's normal meets the race.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray
from skfem import MeshHex2

from analytic.errors import InputError
from analytic.scene import Contact
from fembearing.mesh.patch import (
    NODE,
    PatchMesh,
    contact_zone,
    depth_lines,
    far_square,
    outside_share,
    patch_mesh,
    ray,
)
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.recipe import Cells, Recipe

Array = NDArray[np.float64]
Nodes = NDArray[np.intp]
WIDEST_BLOCK = 0.7  # of the rolling radius: further round, an inner ring's surface falls too steeply
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


@dataclass(frozen=True, kw_only=True, eq=False)
class PairMesh:
    """Two bodies, the gap between them and the direction in which they touch."""

    upper: BodyMesh
    lower: BodyMesh
    gap: Array  # (m,) along the normal, m
    normal: Array  # (3, m) unit vectors out of the upper body
    semi_axes: tuple[float, float]  # along rolling and transverse, m: where the mesh expects the edge


def pair_mesh(
    contact: Contact, *, recipe: Recipe, level: int, semi_axes: tuple[float, float], trimmed: bool = False
) -> PairMesh:
    """Mesh both bodies of a contact on one level of a recipe.

    semi_axes : expected semi-axes along rolling and transverse, m; they size the mesh
    trimmed : leave off the outermost ring and layer of a block's cells; the others stay where they are, so that the
        difference shows what the far boundary does and nothing else
    Raises InputError if the bodies cannot be meshed at that size.
    """
    make = _half_spaces if recipe.geometry == "hertzian" else _ball_on_race
    pair = make(contact, recipe, level, semi_axes, trimmed)
    for body in (pair.upper, pair.lower):
        quality = mesh_quality(body.mesh)
        if not quality.valid:
            x, y, z = quality.worst_place
            raise InputError(
                f"{contact.pair}: cell {quality.worst_cell} of the {body.name} is inside out at ({x:.3g}, {y:.3g}, "
                f"{z:.3g}) m, meshed for an ellipse of {semi_axes[0]:.3g} by {semi_axes[1]:.3g} m: lower the load, or "
                f"give mesh recipe {recipe.name} more outer cells"
            )
    return pair


def _half_spaces(
    contact: Contact, recipe: Recipe, level: int, semi_axes: tuple[float, float], trimmed: bool
) -> PairMesh:
    block = _Block(recipe=recipe, level=level, semi_axes=semi_axes, reach=recipe.domain.extent * max(semi_axes))
    patch = patch_mesh(block.cells(trimmed))
    x, y = plane = block.plane(patch, contact_zone(patch, shape=recipe.patch, semi_axes=semi_axes))
    flat = np.zeros_like(x)
    upper = _body("half space", patch, block.stack(patch, plane, flat, side=1))
    lower = _body("half space", patch, block.stack(patch, plane, flat, side=-1))
    curvature_x = 1 / contact.ball_radius + 1 / contact.rolling_radius
    curvature_y = 1 / contact.ball_radius - 1 / contact.groove_radius
    gap = ((curvature_x * x**2 + curvature_y * y**2) / 2)[patch.zone]
    normal = np.tile([[0.0], [0.0], [-1.0]], gap.size)
    return PairMesh(upper=upper, lower=lower, gap=gap, normal=normal, semi_axes=semi_axes)


def _ball_on_race(
    contact: Contact, recipe: Recipe, level: int, semi_axes: tuple[float, float], trimmed: bool
) -> PairMesh:
    radius = contact.ball_radius
    widest = 0.7 * radius / recipe.patch.margin_size
    if max(semi_axes) > widest:
        raise InputError(
            f"{contact.pair}: {contact.load:g} N spread the contact to a semi-axis of {max(semi_axes):.3g} m, too wide "
            f"for a ball of radius {radius:.3g} m: the mesh holds up to {widest:.3g} m. Lower the load, widen the "
            "groove_radius or raise youngs_modulus."
        )
    upper = _ball(radius, recipe, level, semi_axes)
    touching = upper.mesh.doflocs[:, upper.touching]
    normal = touching / radius - np.array([[0.0], [0.0], [1.0]])
    gap = _distance_to_race(contact, normal)
    if recipe.geometry == "wall":
        lower = _pocket_wall(contact, recipe, level, semi_axes)
    else:
        lower = _race(contact, recipe, level, semi_axes, trimmed)
    return PairMesh(upper=upper, lower=lower, gap=gap, normal=normal, semi_axes=semi_axes)


def _ball(radius: float, recipe: Recipe, level: int, semi_axes: tuple[float, float]) -> BodyMesh:
    """The octant of a ball, from its pole to its middle plane, by a smooth map of the cube [0, 1]^3.

    The map x = X sqrt(1 - Y^2/2 - Z^2/2 + Y^2 Z^2/3) and its permutations sends the cube's faces
    X, Y, Z = 1 to the sphere and X, Y, Z = 0 to the octant's planes.
    Source: P. Nowell, "Mapping a cube to a sphere" (2005), not seen; the ball's volume checks it.
    """
    patch = patch_mesh(_cells(recipe, level, growth=radius / min(semi_axes)))
    zone_x, zone_y = contact_zone(patch, shape=recipe.patch, semi_axes=semi_axes) / radius
    square, difference = np.array([zone_x, zone_y]) ** 2, zone_x**2 - zone_y**2
    linear = 3 + 2 * np.array([difference, -difference])
    near = np.sqrt(12 * square / (linear + np.sqrt(linear**2 - 24 * square)))  # the map's inverse on the face Z = 1
    growth = radius / (recipe.patch.margin_size * min(semi_axes))
    share = outside_share(patch, rings=patch.cells.outside, growth=growth, straight=False)
    # Not straight: at the cube's far corner the map is flat, and cells with middle nodes half way turn inside out.
    cube = near * (1 - share) + far_square(patch.u, patch.v) * share
    lines = depth_lines(patch.cells.depth, depth=recipe.depth, minor=min(semi_axes), extent=radius)
    at_x, at_y = cube[:, patch.column]
    at_z = 1 - lines[np.rint(2 * patch.layer).astype(int)] / radius
    xx, yy, zz = at_x**2, at_y**2, at_z**2
    position = radius * np.array(
        [
            at_x * np.sqrt(1 - yy / 2 - zz / 2 + yy * zz / 3),
            at_y * np.sqrt(1 - zz / 2 - xx / 2 + zz * xx / 3),
            1 - at_z * np.sqrt(1 - xx / 2 - yy / 2 + xx * yy / 3),
        ]
    )
    return _body("ball", patch, position)


def _race(contact: Contact, recipe: Recipe, level: int, semi_axes: tuple[float, float], trimmed: bool) -> BodyMesh:
    """A block of the ring under its groove; columns start where the ball's normals meet the race, the rim's too."""
    reach = min(recipe.domain.extent * max(semi_axes), WIDEST_BLOCK * abs(contact.rolling_radius))
    block = _Block(recipe=recipe, level=level, semi_axes=semi_axes, reach=reach)
    patch = patch_mesh(block.cells(trimmed))
    zone = _meeting(contact, contact_zone(patch, shape=recipe.patch, semi_axes=semi_axes))
    plane = block.plane(patch, zone)
    return _body("race", patch, block.stack(patch, plane, race_height(contact, *plane), side=-1))


def _pocket_wall(contact: Contact, recipe: Recipe, level: int, semi_axes: tuple[float, float]) -> BodyMesh:
    """Half a spherical pocket of sheet metal, from its pole to its rim in the plane where the halves join.

    The patch is laid on the sphere with distances from the pole kept; the rim is held as rivets hold it.
    Raises InputError if the contact would reach the rim.
    """
    if contact.wall is None:
        raise InputError("a pocket wall needs the cage's wall thickness and pocket depth")
    radius, thickness = contact.groove_radius, contact.wall.thickness
    rim = float(np.arccos(1 - contact.wall.depth / radius))
    patch = patch_mesh(_cells(recipe, level, growth=max(rim * radius, thickness) / min(semi_axes)))
    zone = _meeting(contact, contact_zone(patch, shape=recipe.patch, semi_axes=semi_axes))
    distance = np.hypot(*zone)
    if distance.max() >= radius * np.sin(rim):
        raise InputError(
            f"pocket: {contact.load:g} N spread the contact with its margin to {distance.max():.3g} m, past the rim "
            f"of a pocket {contact.wall.depth:.3g} m deep: lower the load or raise cage.pocket_depth"
        )
    polar = np.arcsin(distance / radius)
    near = zone / np.maximum(distance, np.finfo(float).tiny) * polar
    growth = rim * radius / (recipe.patch.margin_size * min(semi_axes))
    share = outside_share(patch, rings=patch.cells.outside, growth=growth)
    plane = near * (1 - share) + rim * ray(patch.u, patch.v) * share
    angle = np.hypot(*plane)
    out = plane / np.maximum(angle, np.finfo(float).tiny) * np.sin(angle)
    direction = np.vstack([out, -np.cos(angle)])[:, patch.column]
    lines = depth_lines(patch.cells.depth, depth=recipe.depth, minor=min(semi_axes), extent=thickness)
    reach = radius + lines[lines.size - 1 - np.rint(2 * patch.layer).astype(int)]
    return _body("pocket wall", patch, reach * direction + np.array([[0.0], [0.0], [radius]]))


def _meeting(contact: Contact, zone: Array) -> Array:
    """x, y where the ball's normals through its surface points above `zone` (2, ...) meet the race, m."""
    across = zone / contact.ball_radius
    normal = np.vstack([across, -np.sqrt(1 - np.sum(across**2, axis=0))])
    return zone + _distance_to_race(contact, normal) * normal[:2]


def race_height(contact: Contact, x: Array, y: Array) -> Array:
    """z of the race's surface over the tangent plane, m: a torus, and the land beyond its shoulder.

    The profile's height r_g - sqrt(r_g^2 - y^2) adds to the ring's radius on the inner ring and
    takes from it on the outer; the ring turns about an axis parallel to y.
    """
    across = np.minimum(np.abs(y), contact.shoulder)
    rise = across**2 / (contact.groove_radius + np.sqrt(contact.groove_radius**2 - across**2))
    side, radius = np.sign(contact.rolling_radius), abs(contact.rolling_radius)
    out = (
        side * 2 * radius + rise
    ) * rise - x**2  # square of the ring's radius at y, less x^2, less that at the bottom
    return side * out / (np.sqrt(radius**2 + out) + radius)


def _distance_to_race(contact: Contact, normal: Array) -> Array:
    """Along each of the ball's normals (3, m): how far the race lies from the ball, m.

    Heights are formed as sagittas, not as differences of radii: a light contact's gap is far below their round-off.
    """
    radius, across = contact.ball_radius, normal[0] ** 2 + normal[1] ** 2
    height = radius * across / (1 + np.sqrt(1 - across))  # of the ball's surface over the tangent plane

    def miss(distance: Array) -> Array:
        reach = radius + distance
        return height + normal[2] * distance - race_height(contact, normal[0] * reach, normal[1] * reach)

    step = 1e-6 * radius
    distance = np.zeros_like(across)
    for _ in range(8):  # Newton, the slope by difference: six digits a round from the ball's own surface
        found = miss(distance)
        distance = distance - found * step / (miss(distance + step) - found)
    return distance


@dataclass(frozen=True, kw_only=True)
class _Block:
    """The grid of a block: columns under the patch out to `reach` and down to it."""

    recipe: Recipe
    level: int
    semi_axes: tuple[float, float]
    reach: float

    @property
    def whole(self) -> Cells:
        return _cells(self.recipe, self.level, growth=self.reach / min(self.semi_axes))

    def cells(self, trimmed: bool) -> Cells:
        return (
            replace(self.whole, outside=self.whole.outside - 1, depth=self.whole.depth - 1) if trimmed else self.whole
        )

    def plane(self, patch: PatchMesh, zone: Array) -> Array:
        """x, y of the columns, (2, columns), m; `zone` is where they start, those further out on its rim."""
        growth = self.reach / (self.recipe.patch.margin_size * min(self.semi_axes))
        share = outside_share(patch, rings=self.whole.outside, growth=growth)
        return zone * (1 - share) + self.reach * far_square(patch.u, patch.v) * share

    def stack(self, patch: PatchMesh, plane: Array, height: Array, *, side: Literal[1, -1]) -> Array:
        """Positions (3, nodes) of columns that run from their `height` towards the plane z = side * reach.

        Layers of a body below are counted from the far boundary upwards, so that its cells stay right-handed.
        """
        lines = depth_lines(self.whole.depth, depth=self.recipe.depth, minor=min(self.semi_axes), extent=self.reach)[
            : 2 * patch.cells.depth + 1
        ]
        step = np.rint(2 * patch.layer).astype(int)
        share = lines[step if side > 0 else lines.size - 1 - step] / self.reach
        start = height[patch.column]
        x, y = plane[:, patch.column]
        return np.array([x, y, start + (side * self.reach - start) * share])


def _cells(recipe: Recipe, level: int, *, growth: float) -> Cells:
    """Cell counts of a level; more of them where a far boundary `growth` times off the contact needs them."""
    needed = int(np.ceil(np.log(growth) / np.log(recipe.domain.growth)))
    base = recipe.cells
    return replace(base, outside=max(base.outside, needed), depth=max(base.depth, needed)).times(level)


def _body(name: BodyName, patch: PatchMesh, position: Array) -> BodyMesh:
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
