"""Two bodies in contact as meshes.

Both have the same patch, so that their contact nodes face each other: a node of the ball, and the node of the race
where the normal of the ball meets it.
"""

from dataclasses import dataclass, replace

import numpy as np

from analytic.errors import InputError
from analytic.scene import Array, Contact
from analytic.words import MILLIMETRE, length_of
from fembearing.mesh.ball import ball_octant
from fembearing.mesh.bodies import FURTHER, Block, BodyMesh
from fembearing.mesh.footprint import Footprint, Sides, as_quarter, footprint_of
from fembearing.mesh.half_space import flat_block
from fembearing.mesh.pocket import pocket_wall
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.race import distance_to_race, race_block, widest_on_race
from fembearing.mesh.recipe import Recipe

WIDEST_CONTACT = 0.7  # over the ball's radius, margin included; the map of the octant folds beyond


@dataclass(frozen=True, kw_only=True, eq=False)
class PairMesh:
    """Two bodies, the gap between them and the direction in which they touch."""

    upper: BodyMesh
    lower: BodyMesh
    gap: Array  # (m,) along the normal, m
    normal: Array  # (3, m) unit vectors out of the upper body
    footprint: Footprint  # the contact that the mesh expects

    @property
    def semi_axes(self) -> tuple[float, float]:
        """Rolling and transverse, m."""
        return self.footprint.semi_axes


def pair_mesh(
    contact: Contact,
    *,
    recipe: Recipe,
    level: int,
    semi_axes: tuple[float, float],
    extended: bool = False,
    sides: Sides = "even",
) -> PairMesh:
    """Mesh both bodies of a contact on one level of a recipe.

    semi_axes : expected semi-axes, rolling and transverse, m; they size the mesh
    extended : add rings and layers of cells to a block, which is then up to twice as large; the other cells stay where
        they are, so that the difference is the effect of the far boundary and little else
    sides : of y = 0 that are meshed where no shoulder cuts the contact off, see `fembearing.mesh.footprint.as_quarter`;
        "both": half of the contact, as where one shoulder cuts it off
    Raises InputError if the bodies cannot be meshed at that size.
    """
    footprint = footprint_of(contact, semi_axes)
    if sides == "both":
        footprint = replace(footprint, half=True)
    make = _half_spaces if recipe.geometry == "hertzian" else _ball_on_race
    pair = make(contact if footprint.half else as_quarter(contact, sides), recipe, level, footprint, extended)
    for body in (pair.upper, pair.lower):
        quality = mesh_quality(body.mesh)
        if not quality.valid:
            place = ", ".join(MILLIMETRE.written(each, ".3g") for each in quality.worst_place)
            raise InputError(
                f"{contact.pair}: cell {quality.worst_cell} of the {body.name} is inside out at ({place}), "
                f"meshed for an ellipse of {length_of(semi_axes[0])} by {length_of(semi_axes[1])}: lower the load, or "
                f"give mesh recipe {recipe.name} more outer cells"
            )
    return pair


def _half_spaces(contact: Contact, recipe: Recipe, level: int, footprint: Footprint, extended: bool) -> PairMesh:
    """Two half spaces; no node beyond a shoulder can touch."""
    reach = recipe.domain.extent * max(footprint.semi_axes)
    further = FURTHER * reach if extended else None
    block = Block(recipe=recipe, level=level, semi_axes=footprint.semi_axes, reach=reach, further=further)
    upper, lower = flat_block(block, footprint, side=1), flat_block(block, footprint, side=-1)
    x, y, _ = upper.mesh.doflocs[:, upper.touching]
    curvature_x = 1 / contact.ball_radius + 1 / contact.rolling_radius
    curvature_y = 1 / contact.ball_radius - 1 / contact.groove_radius
    inside = footprint.holds(y)
    upper, lower = (replace(body, touching=body.touching[inside]) for body in (upper, lower))
    gap = ((curvature_x * x**2 + curvature_y * y**2) / 2)[inside]
    normal = np.tile([[0.0], [0.0], [-1.0]], gap.size)
    return PairMesh(upper=upper, lower=lower, gap=gap, normal=normal, footprint=footprint)


def _ball_on_race(contact: Contact, recipe: Recipe, level: int, footprint: Footprint, extended: bool) -> PairMesh:
    radius, semi_axes = contact.ball_radius, footprint.semi_axes
    widest = WIDEST_CONTACT * radius
    if recipe.geometry == "real":  # a pocket curves as much along rolling as its ball
        widest = min(widest, widest_on_race(contact))
    widest /= recipe.patch.margin_size
    if max(semi_axes) > widest:
        most = contact.load * (widest / max(semi_axes)) ** 3  # the ellipse grows with the cube root of the load
        remedy = "pocket_clearance" if contact.pair == "pocket" else "groove_radius"
        raise InputError(
            f"{contact.pair}: {contact.load:g} N spread the contact to a semi-axis of {length_of(max(semi_axes))}, "
            f"too wide for a ball of radius {length_of(radius)}: the mesh holds up to {length_of(widest)}, about "
            f"{most:.2g} N. Lower the load, or raise {remedy} or youngs_modulus"
        )
    upper = ball_octant(contact, recipe, level, footprint)
    touching = upper.mesh.doflocs[:, upper.touching]
    normal = touching / radius - np.array([[0.0], [0.0], [1.0]])
    gap = distance_to_race(contact, normal)
    if recipe.geometry == "wall":
        lower = pocket_wall(contact, recipe, level, footprint)
    else:
        lower = race_block(contact, recipe, level, footprint, extended)
    return PairMesh(upper=upper, lower=lower, gap=gap, normal=normal, footprint=footprint)
