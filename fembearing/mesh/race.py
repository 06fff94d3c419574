"""The race: a block of the ring under its groove. A thick seat of a cage pocket is one too, with two equal radii."""

import numpy as np
from numpy.typing import NDArray

from analytic.scene import Contact
from fembearing.mesh.bodies import FURTHER, Block, BodyMesh, body_mesh
from fembearing.mesh.footprint import Footprint, farther_shoulder
from fembearing.mesh.patch import contact_zone, patch_mesh
from fembearing.mesh.recipe import Recipe

Array = NDArray[np.float64]
LEAST_FURTHER = 1.5  # times its reach: the least by which a block that fills its ring can be extended
WIDEST_BLOCK = 0.7  # of the rolling radius: further round, an inner ring's surface falls too steeply


def race_block(contact: Contact, recipe: Recipe, level: int, footprint: Footprint, extended: bool) -> BodyMesh:
    """A block of the ring under its groove; columns start where the ball's normals meet the race, the rim's too.

    Where a shoulder cuts the contact off, the patch is the race's instead, so that a line of the mesh is the shoulder.
    """
    semi_axes = footprint.semi_axes
    widest = WIDEST_BLOCK * abs(contact.rolling_radius)
    reach = min(recipe.domain.extent * max(semi_axes), widest / LEAST_FURTHER)
    further = min(FURTHER * reach, widest) if extended else None
    block = Block(recipe=recipe, level=level, semi_axes=semi_axes, reach=reach, further=further)
    patch = patch_mesh(block.cells, ends=footprint.ends, half=footprint.half)
    zone = contact_zone(patch, shape=recipe.patch, footprint=footprint)
    if not footprint.cut:
        zone = meeting_places(contact, zone)
    plane = block.plane(patch, zone)
    return body_mesh("race", patch, block.stack(patch, plane, race_height(contact, *plane), side=-1))


def race_height(contact: Contact, x: Array, y: Array) -> Array:
    """z of the race's surface over the tangent plane, m: a torus, and the land beyond each shoulder.

    The profile's height r_g - sqrt(r_g^2 - y^2) adds to the ring's radius on the inner ring and
    takes from it on the outer; the ring turns about an axis parallel to y.
    """
    across = np.clip(y, -farther_shoulder(contact), contact.shoulder)
    rise = across**2 / (contact.groove_radius + np.sqrt(contact.groove_radius**2 - across**2))
    side, radius = np.sign(contact.rolling_radius), abs(contact.rolling_radius)
    # The square of the ring's radius at y, less x^2, less the square of its radius at the bottom of the groove.
    out = (side * 2 * radius + rise) * rise - x**2
    return side * out / (np.sqrt(radius**2 + out) + radius)


def distance_to_race(contact: Contact, normal: Array) -> Array:
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


def meeting_places(contact: Contact, zone: Array) -> Array:
    """x, y where the ball's normals through its surface points above `zone` (2, ...) meet the race, m."""
    across = zone / contact.ball_radius
    normal = np.vstack([across, -np.sqrt(1 - np.sum(across**2, axis=0))])
    return zone + distance_to_race(contact, normal) * normal[:2]


def places_facing(contact: Contact, zone: Array) -> Array:
    """x, y on the ball's surface of those of its normals that meet the race at `zone` (2, ...), m."""
    radius = contact.ball_radius
    return radius * zone / np.sqrt(np.sum(zone**2, axis=0) + (radius - race_height(contact, *zone)) ** 2)
