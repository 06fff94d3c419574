"""The compliance of a pair: that of two half spaces, and what the true shapes add to it.

Two half spaces have an exact compliance, in closed form on any grid. What the shapes of ball and race add is smooth: a
coarse mesh knows it, once the error of the mesh is taken out of it, which the twin on the same cells shares:

    compliance = exact half spaces + [meshed bodies - their twin]

The bracket is sampled under a few pressures and tractions. It becomes a displacement, a polynomial in x and y, in
proportion to moments of the force with the same polynomials. A contact, a rough race, friction and a film need nothing
else of the bodies.
"""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from analytic.errors import InputError
from analytic.scene import Array, Contact
from analytic.words import length_of
from fembearing.fem.condensation import CondensedBody
from fembearing.fem.elasticity import require_elastic, surface_mass
from fembearing.fem.factor import solver_threads
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.half_space import contact_modulus
from fembearing.fem.solution import CondensedPair, condensed_pair
from fembearing.fem.traction import ACROSS, ALONG, NORMAL, Axis, Term, worked
from fembearing.fem.twin import QUARTERS, flat_race, twin_of
from fembearing.mesh.ball import block_of_ball, flat_ball
from fembearing.mesh.footprint import Footprint, Sides, as_quarter
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.race import block_of_race, race_height
from fembearing.mesh.recipe import Recipe, load_recipe

if TYPE_CHECKING:
    from scipy.interpolate import CubicSpline

Places = tuple[Array, Array]  # x and y
DEGREES: tuple[tuple[Axis, int], ...] = ((ALONG, 3), (ACROSS, 3), (NORMAL, 4))  # of all that is sampled
EVEN = tuple(Term(NORMAL, *powers) for powers in ((0, 0), (2, 0), (0, 2), (4, 0), (2, 2), (0, 4)))
WHOLE = tuple(
    Term(axis, of_x, of_y)
    for axis, degree in DEGREES
    for of_x in range(degree + 1)
    for of_y in range(degree + 1 - of_x)
)
INSIDE = 1 + 1e-6  # the ellipse's edge is a line of nodes


@dataclass(frozen=True, kw_only=True, eq=False)
class PairCompliance:
    """How far both surfaces of a pair yield to pressure, and to tractions, less what two half spaces would.

    Outside the ellipse the addition keeps its value of the edge on the ray from the centre, for forces and for
    displacements. Under Hertz's pressure on a 6205 it is within 0.1 % of the approach in the ellipse, 0.3 % up to 1.5
    semi-axes, 1.2 % up to 3, and 3 % at the far boundary of the mesh, where the gap is that many times wider.
    """

    contact: Contact  # under the load for which it was sampled
    level: int  # number of the mesh of its recipe
    semi_axes: tuple[float, float]  # m, of the ellipse in which it was sampled: the unit of x and y in the terms
    added: Array  # (terms, terms) m/N: of each term in the displacement, for each moment of the force
    terms: tuple[Term, ...] = EVEN

    @property
    def modulus(self) -> float:
        """E* of the half spaces, Pa: under normal forces f they yield by f/(pi E* distance)."""
        return contact_modulus(self.contact)

    def added_displacement(self, x: Array, y: Array, force: Array) -> Array:
        """What the true shapes add to the displacement of the half spaces, under a pressure even in x and y.

        x, y : (m,) places in the plane tangent at the centre of the contact, m, of the whole contact or of a quarter
        force : (m,) normal force on the surface around each place, N; four times that of a quarter
        The displacement, (m,), m, is that of the surfaces along their normals, from each other.
        """
        own = [number for number, term in enumerate(self.terms) if term in EVEN]
        values = self._values(x, y)[:, own]
        return values @ (self.added[np.ix_(own, own)] @ (values.T @ force))

    def added_influence(self, place: Places, loaded: Places, *, moves: Axis, by: Axis) -> Array:
        """What the true shapes add to the displacement along one axis by unit forces along another one.

        place, loaded : x and y, (m,) and (n,), of the displacement and of the forces in the plane tangent at the centre
            of the contact, m
        moves, by : along rolling, across it, or along the normals
        A tangential force acts on the ball and its opposite on the race, and the displacement, (m, n), m/N, is that of
        the ball less that of the race; along the normals the surfaces are pushed, and move, from each other.
        """
        moving, pushing = (
            [number for number, term in enumerate(self.terms) if term.axis == axis] for axis in (moves, by)
        )
        assert len(self.terms) > len(EVEN)  # else only pressure was sampled
        added = self.added[np.ix_(moving, pushing)]
        return self._values(*place)[:, moving] @ added @ self._values(*loaded)[:, pushing].T

    def normal_influence(self, place: Places, loaded: Places) -> Array:
        """As `added_influence`, along the normals under normal forces."""
        return self.added_influence(place, loaded, moves=NORMAL, by=NORMAL)

    def _values(self, x: Array, y: Array) -> Array:
        """(m, terms) at places, m."""
        return values_of(self.terms, x / self.semi_axes[0], y / self.semi_axes[1])


def values_of(terms: Sequence[Term], x: Array, y: Array) -> Array:
    """(m, terms) of the polynomials at places in semi-axes; outside the ellipse, as on its edge towards the centre."""
    inwards = 1 / np.maximum(np.hypot(x, y), 1.0)
    return np.column_stack([(inwards * x) ** term.of_x * (inwards * y) ** term.of_y for term in terms])


def sampled_pair(
    contact: Contact,
    *,
    recipe: Recipe,
    level: int,
    semi_axes: tuple[float, float],
    extended: bool = False,
    sides: Sides = "mean",
    upper: CondensedBody | None = None,
) -> tuple[CondensedPair, PairCompliance]:
    """Ball and race of true shape on one level of a recipe, and their compliance under a pressure even in x and y.

    semi_axes : of the contact, m, to a per cent, see `fembearing.fem.twin.shared_axes`
    extended, sides, upper : as those of `solve_on_mesh`
    Raises InputError if the bodies cannot be meshed, SingularError as `condense`.
    """
    with ThreadPoolExecutor(1) as beside:
        if solver_threads() > 1:  # half spaces are condensed, and kept, while the bodies are
            footprint = Footprint(semi_axes=semi_axes)
            beside.submit(twin_of, contact, recipe=recipe, level=level, footprint=footprint, extended=extended)
        bodies = condensed_pair(
            contact, recipe=recipe, level=level, semi_axes=semi_axes, extended=extended, sides=sides, upper=upper
        )
    return bodies, sampled_compliance(bodies, recipe=recipe, extended=extended)


Compliance = Literal["half-space", "meshed"]


def meshed_pair(contact: Contact) -> PairCompliance:
    """The compliance of a ball on its race for pressure and tractions, from the first level of their recipe.

    Raises InputError as `whole_compliance`.
    """
    recipe, semi_axes = load_recipe("race"), expected_semi_axes(contact, geometry="real")
    return whole_compliance(contact, recipe=recipe, level=recipe.levels[0], semi_axes=semi_axes)


def whole_compliance(contact: Contact, *, recipe: Recipe, level: int, semi_axes: tuple[float, float]) -> PairCompliance:
    """The compliance of ball and race of true shape for any pressure and tractions, from one level of a recipe.

    semi_axes : of the contact, m, to a few per cent
    Pressure has the polynomials up to the fourth degree, each traction those up to the third. Loads and displacements
    lie along each body's own surface and normals, which turn over the contact; but pressure and the displacement that
    closes the gap lie along the ball's on both, as in the contact of two meshes. That tractions move the surfaces
    along their normals, and so change the pressure, is in it too.
    Raises InputError if the bodies cannot be meshed and where a shoulder cuts the contact off, SingularError as
    `condense`.
    """
    require_elastic(contact)
    pair = pair_mesh(contact, recipe=recipe, level=level, semi_axes=semi_axes)
    footprint, nodes = pair.footprint, pair.upper.touching
    if footprint.cut:
        raise InputError(
            f"{contact.pair}: {contact.load:g} N spread the contact to {length_of(semi_axes[1])} across, past its "
            f"shoulder at {length_of(contact.nearer_shoulder)}: the compliance of meshed bodies is that of a whole "
            "ellipse. Lower the load or the contact angle, or take half spaces"
        )
    x, y = (pair.upper.mesh.doflocs[axis, nodes] / pair.semi_axes[axis] for axis in range(2))
    values = values_of(WHOLE, x, y)
    root = np.sqrt(np.maximum(0, 1 - x**2 - y**2))
    force = surface_mass(pair.upper.mesh, nodes) @ (root[:, None] * values)
    into_ball, upright = tangent_frame(pair.normal), np.eye(3)[:, :, None]
    into_race = -tangent_frame(_normal_of_race(contact, *pair.lower.mesh.doflocs[:2, pair.lower.touching]))
    flat_upper = flat_ball(block_of_ball(contact, recipe, level, footprint))
    flat_lower = flat_race(block_of_race(contact, recipe, level, footprint, False))
    ball, race = contact.ball_material, contact.race_material
    downwards, opposite = (np.array([side, side, -1])[:, None, None] * upright for side in (1, -1))  # both lie at z < 0
    as_ball = np.array([*into_race[:NORMAL], pair.normal])
    pressed = worked(pair.lower, material=race, directions=as_ball, terms=WHOLE, force=force, depth=-1)
    work = worked(pair.lower, material=race, directions=into_race, terms=WHOLE, force=force, depth=-1)
    normal = np.array([term.axis == NORMAL for term in WHOLE])
    work = np.where(np.outer(normal, normal), pressed, work)
    work += worked(pair.upper, material=ball, directions=into_ball, terms=WHOLE, force=force)
    work -= worked(flat_upper, material=ball, directions=downwards, terms=WHOLE, force=force, depth=-1)
    work -= worked(flat_lower, material=race, directions=opposite, terms=WHOLE, force=force, depth=-1)
    alike = np.array([[one.axis == other.axis and one.parity == other.parity for other in WHOLE] for one in WHOLE])
    moments = np.where(alike, force.T @ values, 0.0)  # of a quarter; over the contact, those of unlike parity vanish
    added = np.linalg.solve(moments, np.linalg.solve(moments, work.T).T) / QUARTERS
    return PairCompliance(contact=contact, level=level, semi_axes=pair.semi_axes, added=added, terms=WHOLE)


def tangent_frame(normal: Array) -> Array:
    """Unit vectors along rolling, across and upwards on a surface, (3, 3, m): x, y, z turned by the least angle.

    normal : (3, m) downwards
    """
    x, y, down = normal[0], normal[1], -normal[2]
    along = np.array([1 - x**2 / (1 + down), -x * y / (1 + down), x])
    across = np.array([-x * y / (1 + down), 1 - y**2 / (1 + down), y])
    return np.array([along, across, -normal])


def _normal_of_race(contact: Contact, x: Array, y: Array) -> Array:
    """(3, m) into the race at places of its quarter, m."""
    quarter, step = as_quarter(contact, "even"), 1e-6 * contact.ball_radius
    slopes = [
        (race_height(quarter, x + dx, y + dy) - race_height(quarter, x - dx, y - dy)) / (2 * step)
        for dx, dy in ((step, 0.0), (0.0, step))
    ]
    inwards = np.array([*slopes, -np.ones_like(x)])
    return inwards / np.linalg.norm(inwards, axis=0)


def sampled_compliance(bodies: CondensedPair, *, recipe: Recipe, extended: bool = False) -> PairCompliance:
    """The compliance under a pressure even in x and y, of a condensed quarter that no shoulder cuts off.

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
    values, lever = values_of(EVEN, *place), -pair.normal[2]
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
    spline: "CubicSpline | None"  # of ln(semi-axes) and of `added`; None: the least load is the only one

    def at(self, load: float) -> PairCompliance:
        """The compliance for the ellipse of a load, N."""
        if self.spline is None:
            return self.sample
        found = self.spline(np.log(load))
        return replace(
            self.sample,
            contact=replace(self.sample.contact, load=load),
            semi_axes=(float(np.exp(found[0])), float(np.exp(found[1]))),
            added=found[2:].reshape(self.sample.added.shape),
        )


def compliance_over_load(sampled: Sequence[PairCompliance]) -> ComplianceOverLoad:
    """Between the loads of samples of one contact, in ascending order."""
    if len(sampled) == 1:
        return ComplianceOverLoad(sample=sampled[0], spline=None)
    from scipy.interpolate import CubicSpline  # a tenth of a second to import, and a single load needs none

    values = [np.append(np.log(each.semi_axes), each.added.ravel()) for each in sampled]
    spline = CubicSpline(np.log([each.contact.load for each in sampled]), values)
    return ComplianceOverLoad(sample=sampled[0], spline=spline)
