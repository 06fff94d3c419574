"""The compliance of a pair: that of two half spaces, and what the true shapes add to it.

Two half spaces have an exact compliance, in closed form on any grid. What the shapes of ball and race add is smooth: a
coarse mesh knows it, once the error of the mesh is taken out of it, which the twin on the same cells shares:

    compliance = exact half spaces + [meshed bodies - their twin]

The bracket is sampled under a few pressures. It becomes a displacement, a polynomial in x^2 and y^2, in proportion to
moments of the force with the same polynomials. A contact, a rough race, friction and a film need nothing else of the
bodies.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import CubicSpline

from analytic.scene import Contact
from fembearing.fem.half_space import contact_modulus
from fembearing.fem.solution import CondensedPair, condensed_pair
from fembearing.fem.twin import QUARTERS, twin_of
from fembearing.mesh.recipe import Recipe

Array = NDArray[np.float64]
POWERS = ((0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2))  # of (x/a)^2 and (y/b)^2, in a term each
INSIDE = 1 + 1e-6  # the ellipse's edge is a line of nodes
WIDEST = 1.2  # semi-axes from the centre, up to which the polynomials hold


@dataclass(frozen=True, kw_only=True, eq=False)
class PairCompliance:
    """How far both surfaces of a pair yield, together and along their normals."""

    contact: Contact  # under the load for which it was sampled
    level: int  # number of the mesh of its recipe
    semi_axes: tuple[float, float]  # m, of the ellipse in which it was sampled: the unit of x and y in the terms
    added: Array  # (terms, terms) m/N: of each term in the displacement, for each moment of the force

    @property
    def modulus(self) -> float:
        """E* of the half spaces, Pa: under normal forces f they yield by f/(pi E* distance)."""
        return contact_modulus(self.contact)

    def added_displacement(self, x: Array, y: Array, force: Array) -> Array:
        """What the true shapes add to the displacement of the half spaces.

        Parameters
        ----------
        x, y : ndarray, shape (m,)
            Places in the plane tangent at the centre of the contact, m, of the whole contact or of a quarter.
        force : ndarray, shape (m,)
            Normal force on the surface around each place, N; four times that of a quarter.

        Returns
        -------
        ndarray, shape (m,)
            Relative displacement of the surfaces along their normals, m, from each other. It holds for places up to
            1.2 semi-axes from the centre.
        """
        values = terms(x / self.semi_axes[0], y / self.semi_axes[1])
        return values @ (self.added @ (values.T @ force))


def terms(x: Array, y: Array) -> Array:
    """(m, terms) of the polynomials at places in semi-axes."""
    return np.column_stack([x ** (2 * first) * y ** (2 * second) for first, second in POWERS])


def pair_compliance(contact: Contact, *, recipe: Recipe, level: int, semi_axes: tuple[float, float]) -> PairCompliance:
    """The compliance of ball and race of true shape, from one level of a recipe.

    semi_axes : of the contact, m, to a per cent, see `fembearing.fem.twin.shared_axes`
    Raises InputError if the bodies cannot be meshed, SingularError as `condense`.
    """
    bodies = condensed_pair(contact, recipe=recipe, level=level, semi_axes=semi_axes)
    return sampled_compliance(bodies, recipe=recipe)


def sampled_compliance(bodies: CondensedPair, *, recipe: Recipe, extended: bool = False) -> PairCompliance:
    """The compliance of a condensed quarter that no shoulder cuts off.

    recipe : of its mesh
    extended : whether cells were added around its block
    It is sampled under sqrt(1 - x^2/a^2 - y^2/b^2) times each of the terms.
    """
    footprint = bodies.pair.footprint
    assert footprint.parts == QUARTERS  # half a contact has another twin
    assert not footprint.cut
    twin = twin_of(bodies.contact, recipe=recipe, level=bodies.level, footprint=footprint, extended=extended)
    pair = bodies.pair
    x, y, _ = pair.upper.mesh.doflocs[:, pair.upper.touching]
    place = x / pair.semi_axes[0], y / pair.semi_axes[1]
    squared = place[0] ** 2 + place[1] ** 2
    values, lever = terms(*place), -pair.normal[2]
    force = bodies.mass @ (np.sqrt(np.maximum(0, 1 - squared))[:, None] * values)
    unit = 1 / (contact_modulus(bodies.contact) * pair.semi_axes[0])  # of the twin's compliance
    compliance = bodies.upper.compliance + bodies.lower.compliance - unit * twin.compliance
    drift, of_twin = bodies.upper.drift + bodies.lower.drift, unit * twin.drift
    displacement = compliance @ force + QUARTERS * (
        np.outer(drift, lever @ force) - np.outer(of_twin, force.sum(axis=0))
    )
    inside = squared <= INSIDE
    weight = np.sqrt(np.asarray(bodies.mass.sum(axis=1)).ravel()[inside])[:, None]
    fitted = np.linalg.lstsq(values[inside] * weight, displacement[inside] * weight, rcond=None)[0]
    added = np.linalg.solve(QUARTERS * (values.T @ force).T, fitted.T).T
    return PairCompliance(contact=bodies.contact, level=bodies.level, semi_axes=pair.semi_axes, added=added)


@dataclass(frozen=True, kw_only=True, eq=False)
class ComplianceOverLoad:
    """The compliance of one contact under any load of a range: a spline over the logarithm of the load."""

    sample: PairCompliance  # at the least load
    spline: CubicSpline  # of ln(semi-axes) and of `added`

    def at(self, load: float) -> PairCompliance:
        """The compliance for the ellipse of a load, N."""
        found = self.spline(np.log(load))
        return replace(
            self.sample,
            contact=replace(self.sample.contact, load=load),
            semi_axes=(float(np.exp(found[0])), float(np.exp(found[1]))),
            added=found[2:].reshape(self.sample.added.shape),
        )


def compliance_over_load(sampled: Sequence[PairCompliance]) -> ComplianceOverLoad:
    """Between the loads of two samples of one contact or more, in ascending order."""
    values = [np.append(np.log(each.semi_axes), each.added.ravel()) for each in sampled]
    spline = CubicSpline(np.log([each.contact.load for each in sampled]), values)
    return ComplianceOverLoad(sample=sampled[0], spline=spline)
