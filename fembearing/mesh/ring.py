"""The ring under a groove: half of a piece of it, from groove, shoulders and side faces to its seat.

The block of `fembearing.mesh.race` represents a half space; this is the real ring, which shows the effect of its
structure. At a contact angle the ball does not press on the middle of the ring, so that the only plane of symmetry is
the radial plane through the ball, x = 0. The frame is that of the ring: the origin is the bottom of the groove, x the
rolling direction, y the axis of the bearing, and z the direction from the seat to the ball.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from skfem import MeshHex2

from analytic.errors import InputError
from analytic.scene import Array, Contact, Ring
from analytic.words import angle_of, length_of
from fembearing.mesh.bodies import Block, BodyMesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.patch import NODE, PatchMesh, contact_zone, depth_lines, far_square, patch_mesh
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.race import LEAST_FURTHER, WIDEST_BLOCK, meeting_places, profile_rise, race_height
from fembearing.mesh.recipe import Recipe

Nodes = NDArray[np.intp]
LENGTH = 4.0  # of the piece from x = 0, in thicknesses under the groove or major semi-axes
LONGEST = 0.9 * np.pi  # rad: largest angle of the piece from x = 0
COARSENING = 3.0  # largest ratio by which one ring or layer of cells per level unit extends those inside


@dataclass(frozen=True, kw_only=True, eq=False)
class RingPiece:
    """Half of a piece of a ring on a rigid shaft or in a rigid housing."""

    body: BodyMesh  # touching: the nodes that half of the race would have, both sides of y = 0
    end: Nodes  # nodes where the piece is cut from the rest of the ring: free in `body`
    side: NDArray[np.intp]  # (m,) of the touching nodes: the sign of y
    quarter: Nodes  # (m,) the touching node of a quarter of the race that each is or mirrors

    @property
    def held(self) -> BodyMesh:
        """The body with clamped cut end: stiffer than the whole ring, while `body` is softer."""
        return replace(self.body, clamped=np.union1d(self.body.clamped, self.end))


def ring_piece(contact: Contact, recipe: Recipe, level: int, semi_axes: tuple[float, float]) -> RingPiece:
    """A piece of the ring on the same patch as the race of that recipe, level and `semi_axes` (m).

    Near the contact its cells are those of the race, so that the difference is the effect of the structure.
    Raises InputError if the ring is not given, or too narrow for the contact.
    """
    ring = known_ring(contact)
    thickness = abs(ring.bottom_radius - ring.seat_radius)
    length = min(LENGTH * max(thickness, *semi_axes), LONGEST * ring.bottom_radius)
    to_side = ring.width / 2 - contact.groove_radius * np.sin(contact.contact_angle)
    reach = min(
        recipe.domain.extent * max(semi_axes),
        WIDEST_BLOCK * abs(contact.rolling_radius) / LEAST_FURTHER,
        WIDEST_BLOCK * to_side,
    )
    if not reach > recipe.patch.margin_size * max(semi_axes):
        raise InputError(
            f"{contact.pair}: {contact.load:g} N spread the contact to a semi-axis of {length_of(max(semi_axes))}, "
            f"too wide for the {length_of(to_side)} from it to the ring's side: lower the load or raise bearing.width"
        )
    block = Block(recipe=recipe, level=level, semi_axes=semi_axes, reach=reach)
    whole, extent = block.whole, min(reach, thickness)
    further, deeper = _added(max(length, ring.width) / reach, level), _added(thickness / extent, level)
    patch = patch_mesh(
        replace(whole, outside=whole.outside + further.size - 1, depth=whole.depth + deeper.size - 1), half=True
    )
    footprint = Footprint(semi_axes=semi_axes, half=True)
    zone = meeting_places(contact, contact_zone(patch, shape=recipe.patch, footprint=footprint))
    x, y = block.plane(patch, zone)[:, patch.column]
    angle, axial = _columns(contact, ring, x, y)
    # Outside the reach of the race's block, further columns extend to the side faces and to the cut end.
    share = np.interp(patch.ring - whole.rings, np.arange(further.size), further)[patch.column]
    far_u, far_v = far_square(patch.u, patch.v)[:, patch.column]
    angle = angle * (1 - share) + length / ring.bottom_radius * far_u * share
    axial = axial * (1 - share) + ring.width / 2 * far_v * share
    lines = depth_lines(whole.depth, depth=recipe.depth, minor=min(semi_axes), extent=extent)
    corners = np.append(lines[::2], extent + (thickness - extent) * deeper[1:]) / thickness
    below = patch.cells.depth - patch.layer  # layers are counted upwards from the seat
    down = np.interp(below, np.arange(corners.size), corners)
    position = _position(contact, ring, angle, axial, down)
    body = _body(patch, patch.placed(position), below)
    quality = mesh_quality(body.mesh)
    if not quality.valid:
        raise InputError(
            f"{contact.pair}: cell {quality.worst_cell} of the ring is inside out, meshed for an ellipse of "
            f"{length_of(semi_axes[0])} by {length_of(semi_axes[1])} at {angle_of(contact.contact_angle)}: lower the "
            "load"
        )
    end = (patch.ring > patch.cells.rings - NODE) & (patch.u > np.abs(patch.v) - NODE)
    u, v = np.rint(np.array([patch.u, patch.v])[:, patch.zone] / NODE).astype(np.intp)
    numbers = {place: number for number, place in enumerate(zip(u[v >= 0], v[v >= 0], strict=True))}
    quarter = np.array([numbers[place] for place in zip(u, np.abs(v), strict=True)])
    return RingPiece(body=body, end=np.flatnonzero(end[patch.column]), side=np.sign(v), quarter=quarter)


def known_ring(contact: Contact) -> Ring:
    """The ring of a contact. Raises InputError where it has none, or its seat and width are not given."""
    if contact.pair == "pocket":
        raise InputError("geometry 'ring' is that of a race; the pocket has 'real', 'hertzian' and 'wall'")
    if np.isinf(contact.rolling_radius):
        raise InputError(f"{contact.pair}: the structure of a thrust washer is not computed")
    if contact.ring is None:
        seat = "bore_diameter" if contact.pair == "inner" else "outside_diameter"
        raise InputError(f"{contact.pair}: the ring's structure needs bearing.{seat} and bearing.width; give both")
    return contact.ring


def into_ring(contact: Contact, vector: Array) -> Array:
    """Directions (3, ...), given in the frame of the contact, in that of the ring."""
    x, y, z = vector
    sine, cosine = np.sin(contact.contact_angle), np.cos(contact.contact_angle)
    return np.array([x, y * cosine - z * sine, y * sine + z * cosine])


def ring_surface(contact: Contact, ring: Ring, axial: Array) -> Array:
    """Radius of the groove and its lands, m, at `axial`, m, from the middle of the ring."""
    above, below = ring.shoulder_half_widths
    rise = profile_rise(contact.groove_radius, np.clip(axial, -below, above))
    return ring.bottom_radius + np.sign(contact.rolling_radius) * rise


def _columns(contact: Contact, ring: Ring, x: Array, y: Array) -> tuple[Array, Array]:
    """Angle about the bearing axis, rad, and axial position, m, of the points of the race over x, y of the contact."""
    tilt, radius = contact.contact_angle, contact.groove_radius
    place = into_ring(contact, np.array([x, y, race_height(contact, x, y)]))
    above = radius * (1 - np.cos(tilt)) + place[2]
    angle = np.arctan2(x, ring.bottom_radius + np.sign(contact.rolling_radius) * above)
    return angle, radius * np.sin(tilt) + place[1]


def _position(contact: Contact, ring: Ring, angle: Array, axial: Array, down: Array) -> Array:
    """Positions (3, nodes), m, of columns along radii of the ring; `down` is 0 on the surface, 1 on the seat."""
    surface = ring_surface(contact, ring, axial)
    radius = surface * (1 - down) + ring.seat_radius * down
    # Height over the bottom of the groove without the round-off of a difference of two radii, which may be large.
    height = radius - ring.bottom_radius - 2 * radius * np.sin(angle / 2) ** 2
    return np.array([radius * np.sin(angle), axial, np.sign(contact.rolling_radius) * height])


def _body(patch: PatchMesh, mesh: MeshHex2, below: Array) -> BodyMesh:
    surface = np.flatnonzero(below < NODE)
    order = np.empty(patch.u.size, dtype=np.intp)
    order[patch.column[surface]] = surface
    none = np.array([], dtype=np.intp)
    return BodyMesh(
        name="ring",
        mesh=mesh,
        touching=order[patch.zone],
        surface=surface,
        far=none,
        clamped=np.flatnonzero(below > patch.cells.depth - NODE),
        planes=(np.flatnonzero((patch.u < NODE)[patch.column]), none, none),
    )


def _added(ratio: float, level: int) -> Array:
    """Rings or layers from a size to `ratio` times it, from 0 to 1 in steps of constant ratio; 0 alone for none."""
    if ratio <= 1:
        return np.array([0.0])
    count = level * int(np.ceil(np.log(ratio) / np.log(COARSENING)))
    return (ratio ** (np.arange(count + 1) / count) - 1) / (ratio - 1)
