"""The ball: an octant from its pole, where the contact is, to its middle plane."""

import numpy as np

from fembearing.mesh.bodies import BodyMesh, body_mesh, cells_of
from fembearing.mesh.patch import contact_zone, depth_lines, far_square, outside_share, patch_mesh
from fembearing.mesh.recipe import Recipe


def ball_octant(radius: float, recipe: Recipe, level: int, semi_axes: tuple[float, float]) -> BodyMesh:
    """A smooth map of the cube [0, 1]^3, its face Z = 1 under the contact.

    The map x = X sqrt(1 - Y^2/2 - Z^2/2 + Y^2 Z^2/3) and its permutations sends the cube's faces
    X, Y, Z = 1 to the sphere and X, Y, Z = 0 to the octant's planes.
    Source: P. Nowell, "Mapping a cube to a sphere" (2005), not seen; the ball's volume checks it.
    """
    patch = patch_mesh(cells_of(recipe, level, growth=radius / min(semi_axes)))
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
    return body_mesh("ball", patch, position)
