"""The region that is meshed: a block of finite size, a quarter whose sides are alike, and a ring on its seat.

What the true contact differs in is computed once, on one level, and corrects every quantity. What a thin ring adds to
the approach stands beside it, as Hertz takes the approach as that of ball and half space. The ring on its seat is
stiffer than a half space: the seat is taken as rigid and the ring as bonded to it, as by an interference fit on a stiff
shaft or in a stiff housing.

Uncertainties are relative half-widths, 95 %, and the contacts that they come from stand beside them; docs/validation.md
has the coverage on other contacts.
"""

import math
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial

import numpy as np

from analytic.errors import InputError
from analytic.rows import NotNegative
from analytic.scene import Contact
from fembearing.fem.ring_structure import block_compression, ring_compression
from fembearing.fem.series import on_level
from fembearing.fem.solution import MeshSolution, solve_on_mesh
from fembearing.fem.twin import TwinSolution, twin_factors
from fembearing.grid_convergence import FINEST, Estimate
from fembearing.mesh.footprint import Sides, is_symmetric
from fembearing.mesh.recipe import Recipe

# The effect of the far boundary on the pressure falls with this power of the block's size: a block twice as large shows
# 0.45 to 0.85 of it, over blocks up to eight times as large (validation/correction/far_boundary.py).
FADING = 1.6
# The approach has no limit: it changes with the logarithm of the size, in a seat too. It is that of the larger block,
# about 8 major semi-axes wide.
UP_TO_LARGER = ("approach", "stiffness")
STIFFNESS = 1.5  # relative change of load/approach^1.5 over that of the approach

# Far boundary: share of the whole effect on semi-axes and pressure. Of the change of the approach between the blocks
# the cells outside leave LEFT_WITH_TWIN open; without twins all cells do. Of what the twins correct in that change
# LEFT_BY_TWIN stays.
UNCERTAIN, LEFT_WITH_TWIN, LEFT_BY_MESHES, LEFT_BY_TWIN = 0.5, 0.25, 0.5, 0.1

# Sides: their effect on the second level differs from that on the third by at most these shares of the largest
# effect, which is that on the approach, and SIDES_COARSE (b/r)^2: on 26 contacts with shoulders 1.13 to 2 semi-axes
# away.
SIDES_COARSE = 1e-3
SIDES_LEFT = {"semi_axis_rolling": 0.15, "semi_axis_transverse": 0.15, "peak_pressure": 0.15, "approach": 0.3}
SIDES_LEFT_IN_OTHERS = STIFFNESS * SIDES_LEFT["approach"]
# Bound on their effect over (b/r)^2 b/s, where s is the distance of the nearer shoulder; below a tenth of the least
# uncertainty claimed it is not computed.
SIDES_BOUND, SIDES_LEAST = 0.1, 0.1 * FINEST

# Lands: what they add to the effect on the approach up to the larger block, 0.05 to 0.08 % at 40 degrees, differs on
# the first level from that on the second by up to 23 %, or 4e-5, and on the second from the third by up to 11 %: 16
# and 12 contacts at 0.08 to 0.61 rad, a 6205 and seeds 107 to 155 of validation/intervals/twin.py. Where cells of the
# larger block turn inside out under a steep land it is not known: at most STEEP times the sine of the angle, from
# 0.14 % on a land of 0.69 rad.
FARTHER_LEFT, FARTHER_LEFT_ON_SECOND, STEEP = 0.25, 0.125, 2.2e-3


@dataclass(frozen=True, kw_only=True)
class Boundary:
    """The fields of an `Estimate` that the meshed region sets: its size, and that it is symmetric."""

    beyond: float = 0.0
    sides: float = 0.0
    domain: float = 0.0


def far_boundary(mesh: MeshSolution, *, recipe: Recipe) -> dict[str, Boundary]:
    """The remaining effect of a block's far boundary on each quantity.

    It is 0 for half spaces: their far boundary is given the displacement of the half space, exact to the second moments
    of the pressure. It is 0 for a sheet, which has no such boundary.
    """
    if not has_boundary(mesh, recipe=recipe):
        return dict.fromkeys(measured(mesh), Boundary())
    return boundary_effect(mesh, *on_level([mesh], recipe=recipe, level=mesh.level, extended=True))


def has_sides(mesh: MeshSolution, *, recipe: Recipe) -> bool:
    """Whether a quarter stands for a contact whose sides differ, by more than a tenth of the least uncertainty."""
    if mesh.pair.footprint.half or recipe.geometry != "real":
        return False
    return sides_matter(mesh.contact, transverse=mesh.pair.semi_axes[1])


def sides_matter(contact: Contact, *, transverse: float) -> bool:
    """Whether the sides of an uncut contact of a transverse semi-axis, m, change it by more than that tenth."""
    if is_symmetric(contact):
        return False
    return SIDES_BOUND * (transverse / contact.ball_radius) ** 2 * transverse > SIDES_LEAST * contact.nearer_shoulder


def each_side(mesh: MeshSolution, *, recipe: Recipe) -> list[MeshSolution]:
    """A quarter with the true side y > 0, and one with the true side y < 0."""
    sides: tuple[Sides, ...] = ("above", "below")
    return [part for side in sides for part in on_level([mesh], recipe=recipe, level=mesh.level, sides=side)]


def sides_farther(contact: Contact, *, recipe: Recipe, level: int, semi_axes: tuple[float, float]) -> float | None:
    """Relative change of the approach by the true sides on the larger block, over that on the block of an ellipse, m.

    None where the larger block cannot be meshed with them.
    """
    solved = partial(solve_on_mesh, contact, recipe=recipe, level=level, semi_axes=semi_axes)
    even = solved()
    try:
        larger, *both = (
            [solved(sides=side, extended=extended, upper=even.upper).quantities.approach for extended in (False, True)]
            for side in ("even", "above", "below")
        )
    except InputError:
        return None
    by_sides = np.mean(both, axis=0) / larger
    return float(by_sides[1] / by_sides[0] - 1)


def with_sides(
    boundary: dict[str, Boundary],
    mesh: MeshSolution,
    *each: MeshSolution,
    farther: float | None,
    left: float = FARTHER_LEFT,
) -> dict[str, Boundary]:
    """The same with the effect of the true sides, from a quarter with each of them on the cells of `mesh`.

    Shoulders and lands of both sides change the contact by less than 0.3 %, and to first order each by itself: half of
    the contact gives the mean of the two quarters to 0.0015 % (validation/correction/sides.py).
    farther : from `sides_farther`
    left : share of it that stays as uncertainty
    """
    even, *both = (measured(part) for part in (mesh, *each))
    sides = {name: (both[0][name] + both[1][name]) / (2 * value) - 1 if value else 0.0 for name, value in even.items()}
    return with_effect_of_sides(
        boundary, sides, mesh.contact, transverse=mesh.pair.semi_axes[1], farther=farther, left=left
    )


def with_effect_of_sides(
    boundary: dict[str, Boundary],
    sides: dict[str, float],
    contact: Contact,
    *,
    transverse: float,
    farther: float | None,
    left: float = FARTHER_LEFT,
) -> dict[str, Boundary]:
    """The same with a known effect of the true sides, relative, on a contact of a transverse semi-axis, m."""
    largest = max(abs(sides[name]) for name in SIDES_LEFT)
    coarse = SIDES_COARSE * (transverse / contact.ball_radius) ** 2
    unknown = STEEP * abs(math.sin(contact.contact_angle)) if farther is None else left * abs(farther)
    found = {}
    for name, part in boundary.items():
        power = {"approach": 1.0, "stiffness": -STIFFNESS}.get(name, 0.0)  # the other quantities are those of the block
        of_block = SIDES_LEFT.get(name, SIDES_LEFT_IN_OTHERS) * largest
        found[name] = replace(
            part,
            sides=(1 + sides[name]) * (1 + (farther or 0.0)) ** power - 1,
            # Sides and lands come from different blocks and levels: their errors are independent.
            domain=part.domain + math.hypot(of_block, power * unknown) + coarse,
        )
    return found


def has_boundary(mesh: MeshSolution, *, recipe: Recipe) -> bool:
    """Whether the lower body ends in a prescribed displacement that is only approximate."""
    return recipe.geometry != "hertzian" and mesh.pair.lower.far.size > 0


def boundary_effect(mesh: MeshSolution, larger: MeshSolution) -> dict[str, Boundary]:
    """The effect of the far boundary on each quantity, from a larger block with more cells all round.

    The larger block shows a part of the effect on the pressure; the rest follows from the power with which it falls.
    The approach is defined as that of the larger block.
    """
    return effects(changes(measured(mesh), measured(larger)), growth=_growth(mesh, larger), left=LEFT_BY_MESHES)


def boundary_effect_with_twin(solution: TwinSolution, *, recipe: Recipe) -> dict[str, Boundary]:
    """The same with twins of both blocks: the added cells change the error of the mesh."""
    mesh = solution.mesh
    (larger,) = on_level([mesh], recipe=recipe, level=mesh.level, extended=True)
    after = TwinSolution(mesh=larger, factors=twin_factors(larger, recipe=recipe, extended=True)).corrected
    growth = _growth(mesh, larger)
    found = effects(changes(solution.corrected, after), growth=growth, left=LEFT_WITH_TWIN)
    plain = effects(changes(measured(mesh), measured(larger)), growth=growth, left=LEFT_WITH_TWIN)
    return {
        name: replace(part, domain=part.domain + LEFT_BY_TWIN * abs(part.beyond - plain[name].beyond))
        for name, part in found.items()
    }


def changes(before: dict[str, float], after: dict[str, float]) -> dict[str, float]:
    """Relative, of each quantity."""
    return {name: after[name] / value - 1 if value else 0.0 for name, value in before.items()}


def _growth(mesh: MeshSolution, larger: MeshSolution) -> float:
    """Size of the larger block over that of the other."""
    size, further = (float(part.pair.lower.mesh.doflocs[0].max()) for part in (mesh, larger))
    return further / size


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
