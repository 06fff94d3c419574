"""The ball: an octant or a quarter, from the pole, where the contact is, to the middle plane."""

from dataclasses import replace

import numpy as np

from analytic.scene import Array, Contact
from fembearing.mesh.bodies import Block, BodyMesh, body_mesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.patch import PatchMesh, contact_zone, depth_lines, far_square, outside_share, patch_mesh
from fembearing.mesh.race import places_facing
from fembearing.mesh.recipe import Recipe


def block_of_ball(contact: Contact, recipe: Recipe, level: int, footprint: Footprint) -> Block:
    """The grid of the ball, which reaches to its middle plane."""
    return Block(recipe=recipe, level=level, semi_axes=footprint.semi_axes, reach=contact.ball_radius)


def ball_octant(contact: Contact, recipe: Recipe, level: int, footprint: Footprint) -> BodyMesh:
    """The ball as a smooth map of the cube [0, 1]^3, with the face Z = 1 under the contact.

    The map x = X sqrt(1 - Y^2/2 - Z^2/2 + Y^2 Z^2/3) and its permutations takes the faces X, Y, Z = 1 of the cube to
    the sphere and the faces X, Y, Z = 0 to the planes of the octant. Half a contact gets the mirror image as well.
    Source: [Nowell2005]; the volume of the ball checks it.
    """
    block = block_of_ball(contact, recipe, level, footprint)
    patch = patch_mesh(block.whole, ends=footprint.ends, half=footprint.half)
    zone = contact_zone(patch, shape=recipe.patch, footprint=footprint)
    cube = _in_cube(block, patch, places_facing(contact, zone) if footprint.cut else zone)
    across, (at_x, at_y, at_z) = _across(cube), cube
    height = at_z * np.sqrt(1 - at_x**2 / 2 - at_y**2 / 2 + at_x**2 * at_y**2 / 3)
    return body_mesh("ball", patch, contact.ball_radius * np.vstack([across, 1 - height]))


def flat_ball(block: Block) -> BodyMesh:
    """A half space, z < 0, with the columns and layers of the ball on the grid of `block`: its surface is a plane."""
    footprint = Footprint(semi_axes=block.semi_axes)
    patch = patch_mesh(block.whole)
    upside_down = replace(patch, layer=patch.cells.depth - patch.layer)
    cube = _in_cube(block, upside_down, contact_zone(patch, shape=block.recipe.patch, footprint=footprint))
    return body_mesh("half space", patch, block.reach * np.vstack([_across(cube), cube[2] - 1]))


def _in_cube(block: Block, patch: PatchMesh, zone: Array) -> Array:
    """Place of each node in the cube, (3, nodes); `zone` (2, columns), m, is the place of the columns on the ball."""
    radius = block.reach
    zone_x, zone_y = zone = zone / radius
    square, difference = zone**2, zone_x**2 - zone_y**2
    linear = 3 + 2 * np.array([difference, -difference])
    near = np.sqrt(12 * square / (linear + np.sqrt(linear**2 - 24 * square)))  # inverse of the map on the face Z = 1
    near = np.copysign(near, zone)
    share = outside_share(patch, rings=patch.cells.outside, growth=block.growth, straight=False)
    # Not straight: the map is flat at the cube's far corner, where cells with centred middle nodes turn inside out.
    plane = near * (1 - share) + far_square(patch.u, patch.v) * share
    lines = depth_lines(patch.cells.depth, depth=block.recipe.depth, minor=min(block.semi_axes), extent=radius)
    return np.vstack([plane[:, patch.column], 1 - lines[np.rint(2 * patch.layer).astype(int)] / radius])


def _across(cube: Array) -> Array:
    """x and y of places in the cube, (2, ...), in radii."""
    xx, yy, zz = cube**2
    return cube[:2] * np.sqrt([1 - yy / 2 - zz / 2 + yy * zz / 3, 1 - zz / 2 - xx / 2 + zz * xx / 3])
