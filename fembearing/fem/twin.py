"""The twin of a contact: two half spaces on the same cells, whose exact answer shows the error of the mesh.

The pressure of a contact falls like a square root at its edge, where most of a mesh's error arises. Half spaces with
the same cells as the ball and the race share that error: what the true shapes add to them is smooth, and a coarse mesh
knows it.

Each half space has the columns and the layers of its body, with the surface in the plane tangent to it; its far
boundary is held by the exact displacement. Both are lower bodies, like the race, whose topology they share if they have
as many cells. What stays is the error that the shape of the bodies adds.
The twin counts lengths in rolling semi-axes of the mesh, and forces in E* times their square. Meshes of one axis ratio
and one reach share it.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from analytic.scene import Array, Contact, Material
from fembearing.fem.condensation import CondensedBody, condense
from fembearing.fem.half_space import contact_modulus, plane_strain_modulus
from fembearing.mesh.ball import block_of_ball, flat_ball
from fembearing.mesh.bodies import Block, BodyMesh
from fembearing.mesh.footprint import Footprint
from fembearing.mesh.half_space import flat_block
from fembearing.mesh.race import block_of_race
from fembearing.mesh.recipe import Recipe

STEP = 0.01  # of the logarithm of the axis ratio, by which the meshes of contacts with a twin differ
KEPT = 64  # half spaces of one process: 0.1 MB each on the second level, 2 MB on the fourth
QUARTERS = 4


def shared_axes(semi_axes: tuple[float, float]) -> tuple[float, float]:
    """Semi-axes, m, of nearly the same ellipse, with one of the axis ratios that meshes with a twin have."""
    rolling, transverse = semi_axes
    ratio = math.log(transverse / rolling)
    stretch = math.exp((STEP * round(ratio / STEP) - ratio) / 2)
    return rolling / stretch, transverse * stretch


@dataclass(frozen=True, kw_only=True, eq=False)
class Twin:
    """Two half spaces in place of ball and race, reduced to the m nodes that may touch; in the twin's units."""

    compliance: Array  # (m, m)
    drift: Array  # (m,)


def twin_of(contact: Contact, *, recipe: Recipe, level: int, footprint: Footprint, extended: bool = False) -> Twin:
    """The twin on the cells of a contact; arguments as those of `solve_on_mesh`."""
    rolling, _ = footprint.semi_axes
    ball = _in_units(block_of_ball(contact, recipe, level, footprint), of=rolling)
    race = _in_units(block_of_race(contact, recipe, level, footprint, extended), of=rolling)
    above = _condensed(flat_ball, ball, contact.ball_material.poisson_ratio)
    below = _condensed(flat_race, race, contact.race_material.poisson_ratio)
    share = contact_modulus(contact) / plane_strain_modulus(contact.ball_material)
    return Twin(
        compliance=share * above.compliance + (1 - share) * below.compliance,
        drift=share * above.drift + (1 - share) * below.drift,
    )


def _in_units(block: Block, *, of: float) -> Block:
    """The block with lengths in units of a length, without round-off: equal blocks are the same key of a cache."""

    def share(length: float) -> float:
        return float(f"{length / of:.9g}")

    rolling, transverse = block.semi_axes
    return Block(
        recipe=block.recipe,
        level=block.level,
        semi_axes=(share(rolling), share(transverse)),
        reach=share(block.reach),
        further=None if block.further is None else share(block.further),
    )


@lru_cache(KEPT)
def _condensed(mesh: Callable[[Block], BodyMesh], block: Block, poisson_ratio: float) -> CondensedBody:
    """A half space with E/(1 - nu^2) = 1, on the cells that `mesh` makes of a block."""
    body = mesh(block)
    material = Material(
        name="half space",
        youngs_modulus=1 - poisson_ratio**2,
        poisson_ratio=poisson_ratio,
        density=1.0,
        source="unit of the twin",
    )
    inwards = np.tile([[0.0], [0.0], [-1.0]], body.touching.size)
    return condense(body, material=material, force=inwards, semi_axes=block.semi_axes)


def flat_race(block: Block) -> BodyMesh:
    """A half space on the grid of the block of a race, z < 0."""
    return flat_block(block, Footprint(semi_axes=block.semi_axes), side=-1)
