"""The finite-element reference of a contact, by the cheapest way that holds: the compliance of its pair, or levels.

A contact of true shape that ends before its shoulder is solved on pixels, by the compliance of its pair on two levels
of a recipe or more: the last two are extrapolated and give the uncertainty. The effect of the far boundary comes from
a larger block. Under many loads the compliances are sampled at a few of them and interpolated; each load then takes
pixels alone. All other contacts are solved on plain levels, see `fembearing.check.contact.refinement`.
"""

import math
import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from analytic.scene import Contact
from analytic.words import about
from fembearing.check.contact.meshed_region import STIFFNESS, Boundary, changes, effects, lands_of, with_lands
from fembearing.check.contact.refinement import (
    COMPARED,
    FORMAL_ORDERS,
    Estimates,
    Reference,
    Wanted,
    predicted_seconds,
    solve_by_levels,
)
from fembearing.fem.compliance import ComplianceOverLoad, PairCompliance, compliance_over_load, sampled_pair
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.pixel_contact import PixelSolution, press_pair
from fembearing.fem.solution import CondensedPair, MeshSolution, pressed
from fembearing.fem.twin import shared_axes
from fembearing.grid_convergence import Estimate, observed_order
from fembearing.mesh.footprint import Footprint, Sides, is_symmetric
from fembearing.mesh.race import block_of_race
from fembearing.mesh.recipe import Recipe

APART = 3.0  # largest ratio of neighbouring loads at which compliances are sampled
AWAY = 1.05  # least distance of the nearer shoulder in semi-axes: nearer, a load is solved on levels
FARTHEST = 0.3  # largest deviation of an ellipse from that of its mesh, in semi-axes

# Chosen on the calibration contacts of validation/intervals/levels.py, which tests them on others: with the larger
# semi-axis c and the ball's radius r, the curved cells of a level leave CURVED_CELLS (c/r)^2/level^2 of the approach,
# and the rest of an error falls with the power ORDER of the cell size.
ORDER, CURVED_CELLS = 3.0, 1.4e-2
# Relative uncertainty of a quantity: LEAST, CURVED (c/r)^2, and the share LEFT of what was extrapolated. NEARER times
# (c/r)^2 is added for each semi-axis by which the nearer of two unlike shoulders lies inside the zone of fine cells.
LEAST, CURVED, LEFT, NEARER = 2e-4, 1e-3, 0.7, 1.5e-2
# Between sampled loads: at most 0.008 % on the inner and the outer race of a 6205, in ranges of 6 and of 100, against a
# compliance sampled at the load itself.
BETWEEN = 1e-4
# Uncertain share of what a larger block changes in the approach: on the first level, and on the second.
OF_LARGER, OF_LARGER_ON_SECOND = 0.25, 0.125


def solve_reference(contact: Contact, wanted: Wanted) -> Reference:
    """Solve `contact` on as many levels of the recipe as the accuracy needs; `Reference.refinement` says how."""
    by_pair = None
    if wanted.recipe.geometry == "real" and ends_before_shoulder(contact):
        by_pair = solve_by_pair(contact, wanted)
    return by_pair or solve_by_levels(contact, wanted)


def ends_before_shoulder(contact: Contact) -> bool:
    """Whether the expected ellipse of a contact leaves room to the nearer shoulder."""
    return AWAY * expected_semi_axes(contact, geometry="real")[1] < contact.nearer_shoulder


class OnLevel(NamedTuple):
    """A contact on one level of a recipe, under the loads at which its compliance is sampled."""

    bodies: tuple[CondensedPair, ...]
    compliance: ComplianceOverLoad

    def ellipses(self) -> list[tuple[float, float]]:
        """Semi-axes under the sampled loads, m."""
        found = [press_pair(self.compliance.at(each.contact.load), load=each.contact.load) for each in self.bodies]
        return [each.semi_axes for each in found]


def on_level(
    contacts: Sequence[Contact],
    semi_axes: Sequence[tuple[float, float]],
    *,
    recipe: Recipe,
    level: int,
    extended: bool = False,
    sides: Sides = "mean",
    known: OnLevel | None = None,
) -> OnLevel:
    """Sample the compliance of one contact under several loads.

    semi_axes : expected under each of them, m
    extended, sides : of `solve_on_mesh`;  known : the same level with other blocks, whose balls are taken
    Raises InputError and SingularError as `condensed_pair`.
    """
    bodies, compliances = zip(
        *(
            sampled_pair(
                contact,
                recipe=recipe,
                level=level,
                semi_axes=shared_axes(axes),
                extended=extended,
                sides=sides,
                upper=None if known is None else known.bodies[number].upper,
            )
            for number, (contact, axes) in enumerate(zip(contacts, semi_axes, strict=True))
        ),
        strict=True,
    )
    return OnLevel(bodies, compliance_over_load(compliances))


class Blocks(NamedTuple):
    """Compliances of a contact on one level with the block of its recipe, and with a larger one."""

    block: ComplianceOverLoad
    larger: ComplianceOverLoad
    lands: float  # uncertainty of the approach by lands that both are without, relative
    left: float  # uncertain share of what the larger one changes in the approach

    def effect(self, load: float, recipe: Recipe) -> dict[str, Boundary]:
        """Of the far boundary on each quantity under a load, N."""
        compliance = self.block.at(load)
        block, larger = (vars(press_pair(each, load=load).quantities) for each in (compliance, self.larger.at(load)))
        found = effects(changes(block, larger), growth=growth(compliance, recipe), left=self.left)
        return with_lands(found, self.lands)


def growth(compliance: PairCompliance, recipe: Recipe) -> float:
    """Size of the larger block over that of the other for the ellipse of a compliance: the ring limits both."""
    footprint = Footprint(semi_axes=compliance.semi_axes)
    larger, block = (
        block_of_race(compliance.contact, recipe, compliance.level, footprint, extended).extent
        for extended in (True, False)
    )
    return larger / block


def blocks_of(own: OnLevel, *, recipe: Recipe, left: float) -> Blocks:
    """The same level with a larger block; left : as in `Blocks`"""
    contacts, axes = [each.contact for each in own.bodies], [each.pair.semi_axes for each in own.bodies]
    level = own.bodies[0].level

    def other(*, extended: bool, sides: Sides) -> OnLevel:
        return on_level(contacts, axes, recipe=recipe, level=level, extended=extended, sides=sides, known=own)

    block, larger = own, other(extended=True, sides="mean")
    if all(each.has_lands for each in (*block.bodies, *larger.bodies)):
        return Blocks(block.compliance, larger.compliance, 0.0, left)
    block, larger = (other(extended=extended, sides="even") for extended in (False, True))
    return Blocks(block.compliance, larger.compliance, lands_of(contacts[0]), left)


def region_of(blocks: Blocks, levels: Sequence[OnLevel], *, load: float, recipe: Recipe) -> dict[str, Boundary]:
    """The effect of the far boundary, less certain where one of the levels is without a steep land."""
    found = blocks.effect(load, recipe)
    bodies = [each for level in levels for each in level.bodies]
    return found if all(each.has_lands for each in bodies) else with_lands(found, lands_of(bodies[0].contact))


def estimates_of_pair(
    solved: Sequence[PixelSolution], region: dict[str, Boundary], *, recipe: Recipe, between: float = 0.0
) -> Estimates:
    """Each quantity from the last two of its levels, coarse to fine.

    region : effect of the far boundary
    between : uncertainty of a load between those at which compliances are sampled, relative
    """
    contact, (before, last) = solved[-1].contact, solved[-2:]
    shape = (max(last.semi_axes) / contact.ball_radius) ** 2
    near = 0.0 if is_symmetric(contact) else recipe.patch.margin_size - contact.nearer_shoulder / last.semi_axes[1]
    common = LEAST + CURVED * shape + NEARER * shape * max(near, 0.0)
    finer, sizes = last.level / before.level, [1 / each.level for each in solved[-3:]]
    curved = {"approach": CURVED_CELLS * shape}

    def on(level: PixelSolution, name: str) -> float:
        return getattr(level.quantities, name) * (1 + curved.get(name, 0.0) / level.level**2)

    limits, mesh = {}, {}
    for name in COMPARED:
        step = (on(last, name) - on(before, name)) / (finer**ORDER - 1)
        limits[name] = on(last, name) + step
        mesh[name] = math.hypot(common + LEFT * abs(step / limits[name]), between)
    limits["stiffness"] = contact.load / limits["approach"] ** 1.5
    mesh["stiffness"] = STIFFNESS * mesh["approach"]
    found = {}
    for name in FORMAL_ORDERS:
        values = tuple(getattr(each.quantities, name) for each in solved)
        order = observed_order(values[-3:], sizes) if len(values) > 2 else None
        found[name] = Estimate(
            values=values, order=order, richardson=limits[name], mesh=mesh[name], **vars(region[name])
        )
    return found


def solve_by_pair(contact: Contact, wanted: Wanted) -> Reference | None:
    """Solve `contact` by the compliance of its pair on two levels or more.

    The effect of the far boundary comes from the first level, and from the second where that is not certain enough.
    None where the ellipse is far from the expected one, or nearer to its shoulder.
    """
    recipe, load = wanted.recipe, contact.load
    levels: list[OnLevel] = []
    solved: list[PixelSolution] = []
    meshes: list[MeshSolution] = []
    blocks: Blocks | None = None
    estimates: Estimates = {}
    semi_axes = expected_semi_axes(contact, geometry="real")
    for number, level in enumerate(recipe.levels):
        expected = f", {about(predicted_seconds(level, known=meshes[-1]))}" if meshes else ""
        wanted.progress(number / len(recipe.levels), f"{contact.pair}: level {level}{expected}")
        begun = time.perf_counter()
        levels.append(on_level([contact], [semi_axes], recipe=recipe, level=level))
        solved.append(press_pair(levels[-1].compliance.at(load), load=load))
        deviation = max(abs(new / old - 1) for new, old in zip(solved[-1].semi_axes, semi_axes, strict=True))
        semi_axes = solved[-1].semi_axes
        if deviation > FARTHEST or AWAY * semi_axes[1] > contact.nearer_shoulder:
            return None
        mesh = pressed(levels[-1].bodies[0], load=load, expected=semi_axes)
        meshes.append(replace(mesh, seconds=time.perf_counter() - begun))
        if number == 0:
            continue
        blocks = blocks or blocks_of(levels[0], recipe=recipe, left=OF_LARGER)
        region = region_of(blocks, levels, load=load, recipe=recipe)
        estimates = estimates_of_pair(solved, region, recipe=recipe)
        rough = any(estimates[name].total > wanted.accuracy for name in wanted.quantities)
        if number == 1 and (rough or wanted.leaves_undecided(contact, estimates)):
            blocks = blocks_of(levels[1], recipe=recipe, left=OF_LARGER_ON_SECOND)
            region = region_of(blocks, levels, load=load, recipe=recipe)
            estimates = estimates_of_pair(solved, region, recipe=recipe)
        if wanted.is_met(mesh, estimates):
            break
    return Reference(meshes=tuple(meshes), estimates=estimates, shoulder={}, refinement="pair")


@dataclass(frozen=True, kw_only=True, eq=False)
class PairSeries:
    """The compliances of a contact over a range of load."""

    levels: tuple[OnLevel, OnLevel]  # the first two
    blocks: Blocks  # on the first level
    recipe: Recipe
    sampled: tuple[float, ...]  # loads, N

    def under(self, load: float) -> tuple[PixelSolution, Estimates]:
        """The contact under a load of the range, N, and all quantities with their uncertainty.

        Raises ConvergenceError as `press_pair`.
        """
        solved = [press_pair(each.compliance.at(load), load=load) for each in self.levels]
        between = 0.0 if load in self.sampled else BETWEEN
        region = region_of(self.blocks, self.levels, load=load, recipe=self.recipe)
        return solved[-1], estimates_of_pair(solved, region, recipe=self.recipe, between=between)


def pair_series(contact: Contact, *, recipe: Recipe, loads: Sequence[float]) -> PairSeries:
    """Sample the compliances of a contact of true shape for a range of loads, N.

    Raises InputError and ConvergenceError as `condensed_pair` and `press_pair`.
    """
    sampled = sampling_loads(loads)
    contacts = [replace(contact, load=load) for load in sampled]
    guesses = [expected_semi_axes(each, geometry="real") for each in contacts]
    first = on_level(contacts, guesses, recipe=recipe, level=recipe.levels[0])
    second = on_level(contacts, first.ellipses(), recipe=recipe, level=recipe.levels[1])
    blocks = blocks_of(first, recipe=recipe, left=OF_LARGER)
    return PairSeries(levels=(first, second), blocks=blocks, recipe=recipe, sampled=sampled)


def sampling_loads(loads: Sequence[float]) -> tuple[float, ...]:
    """Loads at which a compliance is sampled, N: both ends of `loads`, and some between, at most `APART` apart."""
    low, high = min(loads), max(loads)
    count = int(np.ceil(np.log(high / low) / np.log(APART))) + 1
    return low, *np.geomspace(low, high, count)[1:-1].tolist(), high
