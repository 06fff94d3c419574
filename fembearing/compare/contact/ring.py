"""The ring's structure apart from the contact: a ring is thin, and Hertz's half space is not.

A contact's approach is that of ball and half space. The ring on its seat gives way less than a half space would: the
seat is taken as rigid and the ring as bonded to it, an interference fit on a stiff shaft or in a stiff housing.
"""

from collections.abc import Sequence
from dataclasses import dataclass

from fembearing.compare.contact.uncertainty import Estimate
from fembearing.fem.ring_structure import block_compression, ring_compression
from fembearing.fem.solution import MeshSolution
from fembearing.mesh.recipe import Recipe

# The difference of ring and block settles from the first level to the second, with cells half as large, as their third
# or fourth power; 1/(2^2 - 1) of that change is left as uncertainty, as if it were the second.
LEFT = 1 / 3


@dataclass(frozen=True, kw_only=True)
class RingStructure:
    """What the ring on its rigid seat adds to the approach of the contact alone; negative is stiffer."""

    approach: float  # m
    share: float  # of the contact's approach
    mesh: float  # m, half-width that the meshes leave
    domain: float  # m, from the block that stands for the half space
    reach: float  # m, from how far round the ring the piece goes

    @property
    def uncertainty(self) -> float:
        """All three added, m: nothing says that they are independent."""
        return self.mesh + self.domain + self.reach

    def to_json(self) -> dict[str, float]:
        """As plain numbers, SI; the share is relative."""
        return {"approach": self.approach, "share": self.share, "uncertainty": self.uncertainty}


def structure_of_ring(meshes: Sequence[MeshSolution], approach: Estimate, *, recipe: Recipe) -> RingStructure:
    """The structural part of a contact that was solved on `meshes`, of which the first two are used.

    approach : what the meshes say of the contact's
    recipe : that they were made with
    Raises InputError if the ring is not known or cannot be meshed.
    """
    coarse, fine = meshes[:2]
    rough, soft = (ring_compression(mesh, recipe=recipe) - block_compression(mesh) for mesh in (coarse, fine))
    stiff = ring_compression(coarse, recipe=recipe, end="held") - block_compression(coarse)
    found = soft - approach.beyond * approach.limit  # the endless half space in place of the block
    return RingStructure(
        approach=found,
        share=found / approach.value,
        mesh=LEFT * abs(soft - rough),
        domain=approach.domain * approach.value,
        reach=abs(rough - stiff),
    )
