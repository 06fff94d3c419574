"""What a thin ring adds to the approach of the contact, which Hertz takes as that of ball and half space.

The ring on its seat is stiffer than a half space: the seat is taken as rigid and the ring as bonded to it, as by an
interference fit on a stiff shaft or in a stiff housing.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from analytic.rows import NotNegative
from fembearing.check.contact.columns import require_finite_results
from fembearing.fem.ring_structure import block_compression, ring_compression
from fembearing.fem.solution import MeshSolution
from fembearing.grid_convergence import Estimate
from fembearing.mesh.recipe import Recipe

# From the first level to the second, with cells half as large, the difference of ring and block converges with order 3
# or 4. The uncertainty is 1/(2^2 - 1) of its change, as for order 2.
LEFT = 1 / 3


@dataclass(frozen=True, kw_only=True)
class RingStructure:
    """What the ring on its rigid seat adds to the approach of the contact alone; negative: stiffer."""

    approach: float  # m
    share: float  # of the contact's approach
    mesh: float  # m, half-width from the meshes
    domain: float  # m, half-width from the block that stands for the half space
    reach: float  # m, half-width from the length of the meshed piece of the ring
    uncertainty: NotNegative  # m, the sum of all three, as they may depend on each other

    def __post_init__(self) -> None:
        """Raises InputError for a number that is not finite."""
        require_finite_results({"part of the approach": self.approach, "uncertainty": self.uncertainty}, of="ring")


def structure_of_ring(meshes: Sequence[MeshSolution], approach: Estimate, *, recipe: Recipe) -> RingStructure:
    """The ring's part of the approach, from the first two of the `meshes` on which the contact was solved.

    approach : estimate of the contact's
    recipe : by which the meshes were made
    Raises InputError if the ring is not known or cannot be meshed.
    """
    coarse, fine = meshes[:2]
    rough, soft = (ring_compression(mesh, recipe=recipe) - block_compression(mesh) for mesh in (coarse, fine))
    stiff = ring_compression(coarse, recipe=recipe, end="held") - block_compression(coarse)
    added = soft - approach.beyond * approach.limit  # the larger block, which the approach counts
    parts = {
        "mesh": LEFT * abs(soft - rough),
        "domain": approach.domain * approach.value,
        "reach": abs(rough - stiff),
    }
    return RingStructure(approach=added, share=added / approach.value, **parts, uncertainty=sum(parts.values()))
