"""The region that is meshed: a block of finite size, and a ring on its seat.

What lies beyond the block is computed once, on one level, and corrects every quantity. What a thin ring adds to the
approach stands beside it, as Hertz takes the approach as that of ball and half space. The ring on its seat is
stiffer than a half space: the seat is taken as rigid and the ring as bonded to it, as by an interference fit on a stiff
shaft or in a stiff housing.

Uncertainties are relative half-widths, 95 %, and the contacts that they come from stand beside them; docs/validation.md
has the coverage on other contacts.
"""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial

from analytic.rows import NotNegative
from analytic.scene import Contact
from fembearing.fem.ring_structure import block_compression, ring_compression
from fembearing.fem.solution import MeshSolution, solve_on_mesh
from fembearing.grid_convergence import Estimate
from fembearing.mesh.recipe import Recipe

# The effect of the far boundary on the pressure falls with this power of the block's size: a block twice as large shows
# 0.45 to 0.85 of it, over blocks up to eight times as large (validation/correction/far_boundary.py).
FADING = 1.6
# The approach has no limit: it changes with the logarithm of the size, in a seat too. It is that of the larger block,
# about 8 major semi-axes wide.
UP_TO_LARGER = ("approach", "stiffness")
STIFFNESS = 1.5  # relative change of load/approach^1.5 over that of the approach

# Where cells turn inside out under a steep land, a block is without the lands. These change the approach by at most
# STEEP times the sine of the angle, from 0.14 % on a land of 0.69 rad.
STEEP = 2.2e-3

# Uncertain share of the whole effect on semi-axes and pressure, and, by plain meshes, of the change of the approach
# between both blocks
UNCERTAIN, LEFT_BY_MESHES = 0.5, 0.5


@dataclass(frozen=True, kw_only=True)
class Boundary:
    """The fields of an `Estimate` that the size of the meshed region sets."""

    beyond: float = 0.0
    domain: float = 0.0


def far_boundary(mesh: MeshSolution, *, recipe: Recipe) -> dict[str, Boundary]:
    """The remaining effect of a block's far boundary on each quantity.

    It is 0 for half spaces: their far boundary is given the displacement of the half space, exact to the second moments
    of the pressure. It is 0 for a sheet, which has no such boundary.
    """
    if not has_boundary(mesh, recipe=recipe):
        return dict.fromkeys(measured(mesh), Boundary())
    place = {"recipe": recipe, "level": mesh.level, "semi_axes": mesh.pair.semi_axes, "upper": mesh.upper}
    solved = partial(solve_on_mesh, mesh.contact, **place)
    larger = solved(extended=True)
    if mesh.bodies.has_lands and larger.bodies.has_lands:
        return boundary_effect(mesh, larger)
    even = boundary_effect(solved(sides="even"), solved(sides="even", extended=True))
    return with_lands(even, lands_of(mesh.contact))


def lands_of(contact: Contact) -> float:
    """Uncertainty of the approach of a contact without its lands, relative."""
    return STEEP * abs(math.sin(contact.contact_angle))


def with_lands(found: dict[str, Boundary], lands: float) -> dict[str, Boundary]:
    """With the uncertainty of the approach by lands that are not meshed, relative."""
    powers = {"approach": 1.0, "stiffness": STIFFNESS}
    return {
        name: replace(part, domain=math.hypot(part.domain, powers.get(name, 0.0) * lands))
        for name, part in found.items()
    }


def has_boundary(mesh: MeshSolution, *, recipe: Recipe) -> bool:
    """Whether the lower body ends in a prescribed displacement that is only approximate."""
    return recipe.geometry != "hertzian" and mesh.pair.lower.far.size > 0


def boundary_effect(mesh: MeshSolution, larger: MeshSolution) -> dict[str, Boundary]:
    """The effect of the far boundary on each quantity, from a larger block with more cells all round.

    The larger block shows a part of the effect on the pressure; the rest follows from the power with which it falls.
    The approach is defined as that of the larger block.
    """
    size, further = (float(part.pair.lower.mesh.doflocs[0].max()) for part in (mesh, larger))
    return effects(changes(measured(mesh), measured(larger)), growth=further / size, left=LEFT_BY_MESHES)


def changes(before: dict[str, float], after: dict[str, float]) -> dict[str, float]:
    """Relative, of each quantity."""
    return {name: after[name] / value - 1 if value else 0.0 for name, value in before.items()}


def effects(relative: dict[str, float], *, growth: float, left: float) -> dict[str, Boundary]:
    """The effect of the far boundary from relative changes between two blocks.

    growth : size of the larger block over that of the other
    left : share of the change in the approach that stays as uncertainty
    """
    found = {}
    for name, change in relative.items():
        if name in UP_TO_LARGER:
            found[name] = Boundary(beyond=change, domain=left * abs(change))
        else:
            whole = change / (1 - growth**-FADING)
            found[name] = Boundary(beyond=whole, domain=UNCERTAIN * abs(whole))
    return found


def measured(mesh: MeshSolution) -> dict[str, float]:
    """All quantities of a solved mesh, with those at its shoulder."""
    return asdict(mesh.quantities) | ({} if mesh.shoulder is None else asdict(mesh.shoulder))


# From the first level to the second, with cells half as large, the difference of ring and block converges with order 3
# or 4. The uncertainty is 1/(2^2 - 1) of its change, as for order 2.
RING_LEFT = 1 / 3


@dataclass(frozen=True, kw_only=True)
class RingStructure:
    """What the ring on its rigid seat adds to the approach of the contact alone; negative: stiffer."""

    approach: float  # m
    share: float  # of the contact's approach
    mesh: float  # m, half-width from the meshes
    domain: float  # m, half-width from the block that stands for the half space
    reach: float  # m, half-width from the length of the meshed piece of the ring
    uncertainty: NotNegative  # m, the sum of all three, as they may depend on each other


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
        "mesh": RING_LEFT * abs(soft - rough),
        "domain": approach.domain * approach.value,
        "reach": abs(rough - stiff),
    }
    return RingStructure(approach=added, share=added / approach.value, **parts, uncertainty=sum(parts.values()))
