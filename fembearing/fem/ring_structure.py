"""The change of the approach of a solved contact by the structure of its ring.

The contact forces are kept. They minimise an energy whose derivative is the approach; therefore replacing one body by
another changes the approach, to first order, by the difference of the two bodies' displacements along the forces,
averaged with the forces as weights.
"""

from typing import Literal

import numpy as np

from analytic.errors import InputError
from analytic.scene import Array
from analytic.words import length_of
from fembearing.fem.condensation import held_stiffness
from fembearing.fem.solution import MeshSolution
from fembearing.mesh.recipe import Recipe
from fembearing.mesh.ring import RingPiece, into_ring, ring_piece

End = Literal["free", "held"]
HALVES = 2  # the meshed piece is one half of the loaded ring


def ring_compression(solution: MeshSolution, *, recipe: Recipe, end: End = "free") -> float:
    """Mean displacement of the ring's surface along the forces of `solution`, m; the seat is rigid.

    recipe : of the mesh of the contact
    end : the cut ends of the piece of the ring are free or clamped; the whole ring lies between the two
    Raises InputError if the ring is not known or cannot be meshed, or the contact reaches over its shoulder.
    """
    contact, pair = solution.contact, solution.pair
    if pair.footprint.cut:
        raise InputError(
            f"{contact.pair}: the ring's structure is that of a contact that ends before its shoulder, "
            f"{length_of(contact.nearer_shoulder)} away; this one reaches over: lower the load or the contact angle"
        )
    piece = ring_piece(contact, recipe, solution.level, pair.semi_axes)
    body = piece.body if end == "free" else piece.held
    system = held_stiffness(body, material=contact.race_material, semi_axes=pair.semi_axes)
    normal, force = _on_both_sides(solution, piece)
    push = system.forces(body.touching, into_ring(contact, normal)) @ force
    moved = system.displacement(push, load=0.0).ravel()[system.free]  # no far field: the seat holds the ring
    return float(push @ moved) / (contact.load / HALVES)


def _on_both_sides(solution: MeshSolution, piece: RingPiece) -> tuple[Array, Array]:
    """Normals (3, m) and forces (m,) on the touching nodes of the ring."""
    normal, force = solution.pair.normal, solution.force
    if solution.pair.footprint.half:
        return normal, force
    mirrored = np.array([np.ones(piece.side.size), np.where(piece.side < 0, -1.0, 1.0), np.ones(piece.side.size)])
    # Nodes on the plane of symmetry carry the force of both sides.
    return normal[:, piece.quarter] * mirrored, force[piece.quarter] * np.where(piece.side == 0, 2, 1)


def block_compression(solution: MeshSolution) -> float:
    """As `ring_compression`, m, for the block of the solution, which is held by the far field of a half space."""
    force, load, block = solution.force, solution.contact.load, solution.bodies.lower
    return float(force @ (block.compliance @ force + block.drift * load)) / (load / solution.pair.footprint.parts)
