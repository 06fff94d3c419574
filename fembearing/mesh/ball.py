"""The ball: an octant or a quarter, from the pole, where the contact is, to the middle plane."""

import numpy as np

from analytic.scene import Contact
from fembearing.mesh.bodies import BodyMesh, body_mesh, cells_of
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.patch import contact_zone, depth_lines, far_square, outside_share, patch_mesh
from fembearing.mesh.race import places_facing
from fembearing.mesh.recipe import Recipe


def ball_octant(contact: Contact, recipe: Recipe, level: int, footprint: Footprint) -> BodyMesh:
    """The ball as a smooth map of the cube [0, 1]^3, with the face Z = 1 under the contact.

    The map x = X sqrt(1 - Y^2/2 - Z^2/2 + Y^2 Z^2/3) and its permutations takes the faces X, Y, Z = 1 of the cube to
    the sphere and the faces X, Y, Z = 0 to the planes of the octant. Half a contact gets the mirror image as well.
    Source: [Nowell2005]; the volume of the ball checks it.
    """
    radius, semi_axes = contact.ball_radius, footprint.semi_axes
    cells = cells_of(recipe, level, growth=radius / min(semi_axes))
    patch = patch_mesh(cells, ends=footprint.ends, half=footprint.half)
    zone = contact_zone(patch, shape=recipe.patch, footprint=footprint)
    zone_x, zone_y = zone = (places_facing(contact, zone) if footprint.cut else zone) / radius
    square, difference = np.array([zone_x, zone_y]) ** 2, zone_x**2 - zone_y**2
    linear = 3 + 2 * np.array([difference, -difference])
    near = np.sqrt(12 * square / (linear + np.sqrt(linear**2 - 24 * square)))  # inverse of the map on the face Z = 1
    near = np.copysign(near, zone)
    growth = radius / (recipe.patch.margin_size * min(semi_axes))
    share = outside_share(patch, rings=patch.cells.outside, growth=growth, straight=False)
    # Not straight: the map is flat at the cube's far corner, where cells with centred middle nodes turn inside out.
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
