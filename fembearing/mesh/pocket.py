"""The real cage pocket: half a sphere of sheet metal, held at its rim."""

import numpy as np

from analytic.errors import InputError
from analytic.scene import Contact
from analytic.words import length_of
from fembearing.mesh.bodies import BodyMesh, body_mesh, cells_of
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.patch import contact_zone, depth_lines, outside_share, patch_mesh, ray
from fembearing.mesh.race import meeting_places
from fembearing.mesh.recipe import Recipe


def pocket_wall(contact: Contact, recipe: Recipe, level: int, footprint: Footprint) -> BodyMesh:
    """Half a spherical pocket of sheet metal, from its pole to its rim in the plane where the halves join.

    The patch is laid on the sphere so that distances from the pole stay the same; the rim is clamped, as by rivets.
    Raises InputError if the contact would reach the rim.
    """
    if contact.wall is None:
        raise InputError("a pocket wall needs the cage's wall thickness and pocket depth")
    semi_axes = footprint.semi_axes
    radius, thickness = contact.groove_radius, contact.wall.thickness
    rim = float(np.arccos(1 - contact.wall.depth / radius))
    patch = patch_mesh(cells_of(recipe, level, growth=max(rim * radius, thickness) / min(semi_axes)))
    zone = meeting_places(contact, contact_zone(patch, shape=recipe.patch, footprint=footprint))
    distance = np.hypot(*zone)
    if distance.max() >= radius * np.sin(rim):
        raise InputError(
            f"pocket: {contact.load:g} N spread the contact with its margin to {length_of(distance.max())}, past the "
            f"rim of a pocket {length_of(contact.wall.depth)} deep: lower the load or raise cage.pocket_depth"
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
    return body_mesh("pocket wall", patch, reach * direction + np.array([[0.0], [0.0], [radius]]))
