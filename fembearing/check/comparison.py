"""One quantity by production and by a reference, and the verdict: is production within the tolerance of the reference?

In the terms of [ASME2009] E = S - D is the comparison error, of the simulation S less the datum D, and u_val =
sqrt(u_num^2 + u_input^2 + u_D^2). Here S is production, solved to round-off, and D another model with the same
dimensions, loads and materials: u_num and u_input are 0, and u_val is the numerical uncertainty u_D of the reference.
The model's error lies within E +- u_val, half-widths at 95 %; where |E| <= u_val the uncertainty hides it. As D is a
model, this is a cross-check, not a validation.
"""

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Literal, overload

from analytic.errors import InputError
from analytic.rows import NotNegative
from analytic.verdicts import Verdict
from fembearing.grid_convergence import Estimate

AGREE = 0.1  # meshes that do not converge still agree if they differ by less than this share of the tolerance
ShownVerdict = Verdict | Literal["shown"]  # shown: not judged


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """One quantity, SI: by a closed form, as production takes it, and by the reference."""

    formula: float | None = None  # a closed form of the literature; None: production itself is one
    production: float  # as the torque takes it; in a contact Hertz's, without the fit for finite geometry
    reference: float  # by finite elements, or the numerical solution of film or friction
    uncertainty: NotNegative  # numerical, of the reference: half-width at 95 %, in the unit of the quantity
    relative_uncertainty: NotNegative | None  # the same over the reference; None where that may be 0
    discrepancy: float | None  # production over the reference, less 1; None where that may be 0
    verdict: ShownVerdict
    study: Estimate | None = None  # the reference on its meshes or grids; None: no such estimate

    @property
    def difference(self) -> float:
        """Production over the reference, less 1, whether or not that may be 0."""
        return self.production / self.reference - 1

    @property
    def resolved(self) -> bool:
        """Whether the difference exceeds the uncertainty, E beyond u_val on either side."""
        return abs(self.production - self.reference) > self.uncertainty


def compared(
    production: float,
    reference: float,
    uncertainty: float,
    *,
    formula: float | None = None,
    verdict: ShownVerdict = "shown",
    study: Estimate | None = None,
) -> Comparison:
    """Production beside a reference; arguments as the fields of `Comparison`.

    Raises InputError for a number that is not finite, so that no face of the result shows it.
    """
    if not all(map(math.isfinite, (production, reference, uncertainty))):
        raise InputError(
            f"production gives {production:g}, the reference {reference:g} +- {uncertainty:g}: the numbers of the "
            "scene are outside the computable range; give usual ones"
        )
    known = abs(reference) > uncertainty
    return Comparison(
        formula=formula,
        production=production,
        reference=reference,
        uncertainty=uncertainty,
        relative_uncertainty=uncertainty / abs(reference) if known else None,
        discrepancy=production / reference - 1 if known else None,
        verdict=verdict,
        study=study,
    )


def compared_with(
    study: Estimate, production: float, *, formula: float | None = None, verdict: ShownVerdict = "shown"
) -> Comparison:
    """Production beside the estimate from meshes or grids."""
    return compared(production, study.value, study.uncertainty, formula=formula, verdict=verdict, study=study)


def verdict_on(production: float, study: Estimate, *, tolerance: float, valid: bool = True) -> Verdict:
    """Whether production, in the unit of `study`, is within the relative tolerance of the reference for certain.

    valid : whether the contact is within the validity of the production formula
    """
    if not valid:
        return "outside validity"
    if not study.settled and study.spread > AGREE * tolerance:
        return "undecided"
    return verdict_within(production / study.value - 1, study.total, tolerance=tolerance)


def verdict_within(difference: float, uncertainty: float, *, tolerance: float) -> Verdict:
    """Whether a difference is within the tolerance for certain; all relative."""
    if abs(difference) + uncertainty <= tolerance:
        return "pass"
    return "fail" if abs(difference) - uncertainty > tolerance else "undecided"


def could_be_decided(production: float, study: Estimate, *, tolerance: float) -> bool:
    """Whether a quantity is undecided and a finer mesh could decide it. The far boundary's part would stay."""
    perfect = replace(study, mesh=0.0, settled=True)
    now, then = (verdict_on(production, each, tolerance=tolerance) for each in (study, perfect))
    return now == "undecided" != then


@overload
def worst(verdicts: Iterable[Verdict]) -> Verdict: ...
@overload
def worst(verdicts: Iterable[ShownVerdict]) -> ShownVerdict: ...
def worst(verdicts: Iterable[ShownVerdict]) -> ShownVerdict:
    """The most serious verdict."""
    order: tuple[ShownVerdict, ...] = ("fail", "outside validity", "undecided", "pass", "shown")
    return min(verdicts, key=order.index)
