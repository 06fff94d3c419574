"""What a ring's structure takes from the approach of a solved contact, or adds to it.

The contact's forces are known, and they are kept: as the approach is the derivative of an energy that is least for
them, the change that another body makes is, to first order, the difference of the two bodies' own displacements along
the forces, averaged with them as weights.
"""

from typing import Literal

import numpy as np

from analytic.errors import InputError
from fembearing.fem.condensation import held_stiffness
from fembearing.fem.solution import MeshSolution
from fembearing.mesh.recipe import Recipe
from fembearing.mesh.ring import into_ring, ring_piece

End = Literal["free", "held"]
HALVES = 2  # a piece of the ring is a half of what is loaded


def ring_compression(solution: MeshSolution, *, recipe: Recipe, end: End = "free") -> float:
    """Mean displacement of the ring's surface along the forces of `solution`, m, its seat on a rigid shaft or housing.

    recipe : that the contact was meshed with
    end : whether the piece of the ring is free where it is cut off, or clamped: the whole ring lies between
    Raises InputError if the ring is not known or cannot be meshed, or the contact reaches over its shoulder.
    """
    contact, pair = solution.contact, solution.pair
    if pair.footprint.cut:
        raise InputError(
            f"{contact.pair}: the ring's structure is that of a contact that ends before its shoulder, "
            f"{contact.shoulder:.3g} m away; this one reaches over: lower the load or the contact angle"
        )
    piece = ring_piece(contact, recipe, solution.level, pair.semi_axes)
    body = piece.body if end == "free" else piece.held
    image = pair.normal * np.array([[1.0], [-1.0], [1.0]])
    system = held_stiffness(body, material=contact.race_material, semi_axes=pair.semi_axes)
    direction = into_ring(contact, np.hstack([pair.normal, image]))
    push = system.forces(body.touching, direction) @ np.tile(solution.force, 2)
    moved = system.displacement(push, load=0.0).ravel()[system.free]  # no far field: the ring ends on its seat
    return float(push @ moved) / (contact.load / HALVES)


def block_compression(solution: MeshSolution) -> float:
    """The same of the solution's own block, which ends in the displacement of a half space, m."""
    force, load, block = solution.force, solution.contact.load, solution.bodies.lower
    return float(force @ (block.compliance @ force + block.drift * load)) / (load / solution.pair.footprint.parts)
