"""The race: a block of the ring under its groove. A thick seat of a cage pocket is a race with two equal radii."""

import numpy as np

from analytic.scene import Array, Contact
from fembearing.mesh.bodies import FURTHER, Block, BodyMesh, body_mesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.patch import contact_zone, patch_mesh
from fembearing.mesh.recipe import Recipe

NEWTON, LAST = 8, 1e-9  # rounds at most; the step, over the radius, that the last one has: round-off is left
STEEPEST = 1.2  # rad, profile angle up to which a groove is meshed as a height over the tangent plane
LEAST_OUTSIDE = 1.06  # end of the block over the contact with its margin; nearer, the cells between them fold
LEAST_FURTHER = 1.5  # smallest size of an extended block over its own, where the ring limits it
WIDEST_BLOCK = 0.7  # over the rolling radius; beyond, the surface of an inner ring is too steep


def race_block(contact: Contact, recipe: Recipe, level: int, footprint: Footprint, extended: bool) -> BodyMesh:
    """A block of the ring under its groove; columns start where the normals of the ball meet the race.

    Where a shoulder cuts the contact off, the patch lies on the race instead, and the shoulder is a line of the mesh.
    """
    block = block_of_race(contact, recipe, level, footprint, extended)
    patch = patch_mesh(block.cells, ends=footprint.ends, half=footprint.half)
    zone = contact_zone(patch, shape=recipe.patch, footprint=footprint)
    if not footprint.cut:
        zone = meeting_places(contact, zone)
    plane = block.plane(patch, zone)
    return body_mesh("race", patch, block.stack(patch, plane, race_height(contact, *plane), side=-1))


def widest_on_race(contact: Contact) -> float:
    """Half the length of the largest contact with its margin that a block holds, m; infinite on a plane."""
    return WIDEST_BLOCK * abs(contact.rolling_radius) / LEAST_FURTHER / LEAST_OUTSIDE


def block_of_race(contact: Contact, recipe: Recipe, level: int, footprint: Footprint, extended: bool) -> Block:
    """The grid of the block of a race, which the radius of the ring may limit."""
    widest = WIDEST_BLOCK * abs(contact.rolling_radius)
    reach = min(recipe.domain.extent * max(footprint.semi_axes), widest / LEAST_FURTHER)
    further = min(FURTHER * reach, widest) if extended else None
    return Block(recipe=recipe, level=level, semi_axes=footprint.semi_axes, reach=reach, further=further)


def race_height(contact: Contact, x: Array, y: Array) -> Array:
    """z of the race's surface over the tangent plane, m: a torus, and the land beyond each shoulder.

    The axis of the ring is tilted by the contact angle against y, and the lands are cylinders about it. Where the tilt
    is zero, the height of the profile, r_g - sqrt(r_g^2 - y^2), is added to the radius of an inner ring and subtracted
    from that of an outer ring. The groove of a thrust washer is straight: its bend within the tangent plane moves the
    bottom by x^2/d_m, some thousandth of the contact's length.
    """
    groove, side, radius = contact.groove_radius, np.sign(contact.rolling_radius), abs(contact.rolling_radius)
    steepest = groove * np.sin(STEEPEST)
    low, high = -min(contact.far_shoulder, steepest), min(contact.shoulder, steepest)
    rise = profile_rise(groove, np.clip(y, low, high))
    if np.isinf(radius):
        return np.broadcast_to(rise, np.broadcast_shapes(x.shape, y.shape)).copy()
    # Square of the ring's radius at y, minus x^2, minus the square of its radius at the bottom of the groove.
    out = (side * 2 * radius + rise) * rise - x**2
    height = side * out / (np.sqrt(radius**2 + out) + radius)
    if contact.tilt == 0:
        return height
    sine, cosine = np.sin(contact.tilt), np.cos(contact.tilt)
    bottom = radius * cosine - side * groove * (1 - cosine)  # from the ring's axis to the bottom of the groove
    # Axial places of the shoulders: their distances are measured along the tangent plane.
    first, last = (distance * cosine + np.sqrt(groove**2 - distance**2) * sine for distance in (low, high))
    for _ in range(NEWTON):  # the surface in the frame of the ring, whose origin is the bottom of the groove
        over = groove * (1 - cosine) + y * sine + height * cosine
        axial = groove * sine + y * cosine - height * sine
        inside = np.clip(axial, first, last)
        from_axis = np.hypot(bottom + side * over, x)
        # Radius over that of the bottom, as a sagitta, less the profile's
        left = side * ((side * 2 * bottom + over) * over + x**2) / (from_axis + bottom) - profile_rise(groove, inside)
        slope = (bottom + side * over) / from_axis * cosine
        slope = slope + np.where(axial == inside, axial / np.sqrt(groove**2 - inside**2) * sine, 0.0)
        height = height - left / slope
        if np.abs(left / slope).max() < LAST * groove:
            break
    return height


def profile_rise(groove: float, axial: Array) -> Array:
    """Height of a groove's profile over its bottom, m."""
    return axial**2 / (groove + np.sqrt(groove**2 - axial**2))


def distance_to_race(contact: Contact, normal: Array) -> Array:
    """Distance of the race from the ball along each of the ball's normals (3, m), m.

    Heights are computed as sagittas. Differences of radii have a round-off far above the gap of a light contact.
    """
    radius, square = contact.ball_radius, normal[0] ** 2 + normal[1] ** 2
    height = radius * square / (1 + np.sqrt(1 - square))  # of the ball's surface over the tangent plane

    def miss(distance: Array) -> Array:
        reach = radius + distance
        return height + normal[2] * distance - race_height(contact, normal[0] * reach, normal[1] * reach)

    step = 1e-6 * radius
    distance = np.zeros_like(square)
    for _ in range(NEWTON):  # with the slope by difference, which gains six digits in each round
        left = miss(distance)
        change = left * step / (miss(distance + step) - left)
        distance = distance - change
        if np.abs(change).max() < LAST * radius:
            break
    return distance


def meeting_places(contact: Contact, zone: Array) -> Array:
    """x, y where the normals of the ball at its points above `zone` (2, ...) meet the race, m."""
    plane = zone / contact.ball_radius
    normal = np.vstack([plane, -np.sqrt(1 - np.sum(plane**2, axis=0))])
    return zone + distance_to_race(contact, normal) * normal[:2]


def places_facing(contact: Contact, zone: Array) -> Array:
    """x, y of the points of the ball whose normals meet the race at `zone` (2, ...), m."""
    radius = contact.ball_radius
    return radius * zone / np.sqrt(np.sum(zone**2, axis=0) + (radius - race_height(contact, *zone)) ** 2)
