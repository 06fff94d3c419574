"""The compliance of a pair of true shape: for a contact under many loads, and for film and friction.

The compliance is sampled at a few loads and interpolated between them; each load then takes one solution on pixels. Two
levels of a recipe are extrapolated and give the uncertainty. The effects of far boundary and true sides come from the
compliances of other blocks, at the same loads.
"""

from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from typing import Literal

import numpy as np
from scipy.interpolate import CubicSpline

from analytic.scene import Contact
from fembearing.check.contact.meshed_region import (
    LEFT_WITH_TWIN,
    changes,
    effects,
    sides_farther,
    sides_matter,
    with_effect_of_sides,
)
from fembearing.check.contact.refinement import Estimates, extrapolated
from fembearing.check.contact.scene_contact import recipe_of
from fembearing.fem.compliance import (
    ComplianceOverLoad,
    PairCompliance,
    compliance_over_load,
    sampled_compliance,
    whole_compliance,
)
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.pixel_contact import PixelSolution, press_pair
from fembearing.fem.solution import condensed_pair
from fembearing.fem.twin import shared_axes
from fembearing.grid_convergence import Estimate
from fembearing.mesh.footprint import Footprint, Sides
from fembearing.mesh.race import block_of_race
from fembearing.mesh.recipe import Recipe

APART = 3.0  # largest ratio of neighbouring loads at which the compliance is sampled
# What the curved cells of the second level leave of the approach, over (c/r)^2; chosen as those of twins.
CURVED_CELLS = 3e-3
# Uncertainty: as of meshes with a twin, with FEW_SAMPLES times (c/r)^2 in place of CURVED, for what few samples miss of
# the compliance. BETWEEN is added between samples: at most 0.008 % on the inner and the outer race of a 6205, in ranges
# of 6 and of 100, against a compliance sampled at the load itself.
FEW_SAMPLES, BETWEEN = 3e-3, 1e-4
AWAY = 1.05  # least distance of the nearer shoulder in semi-axes: nearer, a load is solved on meshes


@dataclass(frozen=True, kw_only=True, eq=False)
class PairSeries:
    """The compliances of a contact over a range of load."""

    coarse: ComplianceOverLoad  # first level
    fine: ComplianceOverLoad  # second level
    beyond: ComplianceOverLoad  # first level, on a larger block
    sides: tuple[ComplianceOverLoad, ...]  # second level, with each of the true sides; empty where they do not matter
    farther: CubicSpline | None  # of `sides_farther` over ln(load); None where it is not known
    recipe: Recipe
    sampled: tuple[float, ...]  # loads, N

    def under(self, load: float) -> tuple[PixelSolution, Estimates]:
        """The contact under a load of the range, N, and all quantities with their uncertainty.

        Raises ConvergenceError as `press_pair`.
        """
        compliance = self.coarse.at(load)
        first, last, larger = (
            press_pair(each, load=load) for each in (compliance, self.fine.at(load), self.beyond.at(load))
        )
        coarse, fine = asdict(first.quantities), asdict(last.quantities)
        region = effects(
            changes(coarse, asdict(larger.quantities)), growth=_growth(compliance, self.recipe), left=LEFT_WITH_TWIN
        )
        transverse = last.quantities.semi_axis_transverse
        if self.sides:
            sides = [each.at(load) for each in self.sides]
            mean = replace(sides[0], added=np.mean([each.added for each in sides], axis=0))
            region = with_effect_of_sides(
                region,
                changes(fine, asdict(press_pair(mean, load=load).quantities)),
                last.contact,
                transverse=transverse,
                farther=None if self.farther is None else float(self.farther(np.log(load))),
            )
        shape = (max(last.quantities.semi_axis_rolling, transverse) / last.contact.ball_radius) ** 2
        limits, mesh = extrapolated(
            coarse,
            fine,
            finer=last.level / first.level,
            load=load,
            curved=CURVED_CELLS * shape,
            left=FEW_SAMPLES * shape + (0.0 if load in self.sampled else BETWEEN),
        )
        return last, {
            name: Estimate(
                values=(coarse[name], fine[name]),
                order=None,
                richardson=limits[name],
                mesh=mesh[name],
                **asdict(region[name]),
            )
            for name in fine
        }


def _growth(compliance: PairCompliance, recipe: Recipe) -> float:
    """Size of the larger block over that of the other for the ellipse of a compliance: the ring limits both."""
    footprint = Footprint(semi_axes=compliance.semi_axes)
    larger, block = (
        block_of_race(compliance.contact, recipe, compliance.level, footprint, extended).extent
        for extended in (True, False)
    )
    return larger / block


def pair_series(contact: Contact, *, recipe: Recipe, loads: Sequence[float]) -> PairSeries:
    """Sample the compliances of a contact of true shape for a range of loads, N.

    Raises InputError and ConvergenceError as `condensed_pair` and `press_pair`.
    """
    sampled = sampling_loads(loads)
    _, widest = expected_semi_axes(replace(contact, load=sampled[-1]), geometry="real")
    sided = sides_matter(contact, transverse=widest)
    samples = [_sampled(replace(contact, load=load), recipe=recipe, sided=sided) for load in sampled]
    known = [
        sides_farther(each[0].contact, recipe=recipe, level=each[0].level, semi_axes=each[0].semi_axes)
        if sided
        else None
        for each in samples
    ]
    farther = None if None in known else CubicSpline(np.log(sampled), known)
    coarse, fine, beyond, *sides = (compliance_over_load(each) for each in zip(*samples, strict=True))
    return PairSeries(
        coarse=coarse,
        fine=fine,
        beyond=beyond,
        sides=tuple(sides),
        farther=farther,
        recipe=recipe,
        sampled=sampled,
    )


def _sampled(contact: Contact, *, recipe: Recipe, sided: bool) -> list[PairCompliance]:
    """The compliances under one load, in the order of the fields of `PairSeries`."""
    first, second = recipe.levels[:2]
    meshed = partial(condensed_pair, contact, recipe=recipe)
    guess = shared_axes(expected_semi_axes(contact, geometry="real"))
    bodies = meshed(level=first, semi_axes=guess)
    coarse = sampled_compliance(bodies, recipe=recipe)
    larger = meshed(level=first, semi_axes=guess, extended=True, upper=bodies.upper)
    found = press_pair(coarse, load=contact.load).quantities
    on_second = partial(
        meshed, level=second, semi_axes=shared_axes((found.semi_axis_rolling, found.semi_axis_transverse))
    )
    fine = on_second()
    sides: tuple[Sides, ...] = ("above", "below") if sided else ()
    return [
        coarse,
        sampled_compliance(fine, recipe=recipe),
        sampled_compliance(larger, recipe=recipe, extended=True),
        *(sampled_compliance(on_second(sides=side, upper=fine.upper), recipe=recipe) for side in sides),
    ]


def sampling_loads(loads: Sequence[float]) -> tuple[float, ...]:
    """Loads at which a compliance is sampled, N: both ends of `loads`, and some between, at most `APART` apart."""
    low, high = min(loads), max(loads)
    count = int(np.ceil(np.log(high / low) / np.log(APART))) + 1
    return low, *np.geomspace(low, high, count)[1:-1].tolist(), high


def ends_before_shoulder(contact: Contact) -> bool:
    """Whether the expected ellipse of a contact leaves room to the nearer shoulder."""
    return AWAY * expected_semi_axes(contact, geometry="real")[1] < contact.nearer_shoulder


Compliance = Literal["half-space", "meshed"]


def meshed_pair(contact: Contact) -> PairCompliance:
    """The compliance of a ball on its race for pressure and tractions, from the first level of their recipe.

    Raises InputError as `whole_compliance`.
    """
    recipe = recipe_of("real", pair=contact.pair)
    semi_axes = expected_semi_axes(contact, geometry=recipe.geometry)
    return whole_compliance(contact, recipe=recipe, level=recipe.levels[0], semi_axes=semi_axes)
