"""A contact under many loads: its stiffness law F = K delta^n by finite elements, beside Hertz's F = K delta^1.5.

F: load, N; delta: approach, m. Each approach is extrapolated from the second and third level of a recipe with order 4,
and past the far boundary as that of a single contact; half of the extrapolation's step is its uncertainty. Loads share
meshes, and one whose ellipse is not that of its mesh is less certain: see `OFF_MESH`. One whose approach is then less
certain than the tolerance asks for is solved once more as a contact of its own.
"""

import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.stats import t as student

from analytic.errors import InputError
from analytic.scene import Contact, Pair, Scene
from fembearing.compare.discrepancy import (
    RECIPES,
    Shape,
    contact_of,
    could_be_decided,
    hertz_quantities,
    near_shoulder,
    sheet_warning,
    traced_to_load,
)
from fembearing.compare.progress import Progress, part_of, silent
from fembearing.compare.provenance import peak_memory
from fembearing.compare.reference import FORMAL_ORDERS, boundary_effect, has_boundary, solve_reference
from fembearing.compare.uncertainty import FINEST, HALF, Estimate
from fembearing.compare.verdict import Verdict, judge, worst
from fembearing.fem.series import checked_loads, off_mesh, on_level, solve_series
from fembearing.fem.solution import MeshSolution
from fembearing.mesh.recipe import Geometry, Recipe, load_recipe

Array = NDArray[np.float64]
# Where the edge of an ellipse runs through cells that were made for another one, the approach goes up and down with the
# load, alike on all levels. Seen on 14 idealised contacts at 33 sizes from 0.65 to 1.35 of the mesh's, beyond what the
# levels show: up to 0.33 %, 0.3 % in 95 of 100; less where the ellipse is nearly the mesh's.
OFF_MESH = 3e-3
ALIKE = 0.3  # in ln F, a tenth of a semi-axis: of loads further apart, these errors have nothing in common
OFF_FROM = 0.1  # an ellipse so far from its mesh's, in semi-axes, is off in full; in proportion below
CONFIDENCE = 0.95
Solved = tuple[MeshSolution, Estimate, float]  # on the finest mesh, its approach, and its share that is off the mesh
ENOUGH = 5  # distinct loads, for the tangents to bend away from a power law


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadPoint:
    """One load of a series. Tangents are dF/d(delta), N/m; uncertainties relative half-widths."""

    load: float  # N
    approach: Estimate  # m
    hertz_approach: float  # m
    tangent: float | None  # by finite elements; None where one load makes the series
    tangent_uncertainty: float | None
    verdict: Verdict  # on Hertz's approach

    @property
    def discrepancy(self) -> float:
        """Hertz's approach over that of finite elements, less one."""
        return self.hertz_approach / self.approach.value - 1

    @property
    def hertz_tangent(self) -> float:
        return 1.5 * self.load / self.hertz_approach


@dataclass(frozen=True, kw_only=True)
class StiffnessLaw:
    """F = K delta^n, fitted to a series."""

    stiffness: float  # K, N/m^n: extrapolated to 1 m, to be used with n alone
    exponent: float  # n
    stiffness_uncertainty: float  # of K, relative half-width, 95 %: large, as it is far from any load
    misfit: float | None  # what n owes to loads that are no power law; None where two loads fit it always
    propagated: float  # what it owes to uncertain approaches

    @property
    def exponent_uncertainty(self) -> float:
        """Half-width, 95 %, absolute: both parts added, since nothing says that they are independent."""
        return (self.misfit or 0.0) + self.propagated

    def load(self, approach: ArrayLike) -> Array:
        """N, at approaches of any shape, m."""
        return self.stiffness * np.asarray(approach, dtype=np.float64) ** self.exponent


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadSeries:
    """A contact under a series of loads, in the order given."""

    contact: Contact  # under the first load
    geometry: Geometry
    tolerance: float
    points: tuple[LoadPoint, ...]
    law: StiffnessLaw | None  # None of a single load
    hertz_stiffness: float  # K of Hertz, N/m^1.5
    solutions: tuple[MeshSolution, ...]  # on the finest level, in the order of the points
    seconds: float
    warnings: tuple[str, ...]

    @property
    def meshes(self) -> int:
        """How many meshes of a level the loads share."""
        return len({id(part.bodies) for part in self.solutions})

    @property
    def judged(self) -> bool:
        """A sheet is shown, not judged: Hertz's half space is not made for it."""
        return self.geometry != "wall"

    @property
    def verdict(self) -> Verdict:
        """The worst of all loads."""
        return worst(point.verdict for point in self.points)

    def to_json(self) -> dict[str, Any]:
        """The series as plain types; SI, discrepancies and uncertainties relative but that of the exponent."""
        law = None
        if self.law is not None:
            law = asdict(self.law) | {"exponent_uncertainty": self.law.exponent_uncertainty}
        return {
            "pair": self.contact.pair,
            "geometry": self.geometry,
            "contact_angle": self.contact.contact_angle,
            "loads": [
                {
                    "load": point.load,
                    "approach": {
                        "fe": point.approach.value,
                        "uncertainty": point.approach.total,
                        "hertz": point.hertz_approach,
                        "discrepancy": point.discrepancy,
                        "values": list(point.approach.values),
                    },
                    "tangent": {
                        "fe": point.tangent,
                        "uncertainty": point.tangent_uncertainty,
                        "hertz": point.hertz_tangent,
                    },
                    "verdict": point.verdict,
                }
                for point in self.points
            ],
            "law": law,
            "hertz_law": {"stiffness": self.hertz_stiffness, "exponent": 1.5},
            "verdict": self.verdict if self.judged else "shown",
            "cost": {"seconds": self.seconds, "meshes": self.meshes, "peak_memory": peak_memory()},
            "warnings": list(self.warnings),
        }


def solve_load_series(
    scene: Scene,
    *,
    pair: Pair,
    loads: ArrayLike,
    tolerance: float | None = None,
    geometry: Shape = "real",
    progress: Progress = silent,
) -> LoadSeries:
    """Solve one contact of a scene under each of `loads` and set Hertz beside it.

    loads : (n,) of the ball, N, in any order; the contact angle stays that of the scene's largest load
    tolerance : relative, for the verdict; the scene's unless given
    geometry : as of `solve_contact`, but for "ring"
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for loads that are none or not positive or a contact that cannot be meshed, ConvergenceError for
    one that does not settle.
    """
    given = checked_loads(loads)
    if geometry == "ring":
        raise InputError("geometry 'ring' is that of one load, not of a series: give one --load")
    if geometry == "wall" and pair != "pocket":
        raise InputError(f"geometry 'wall' is that of a pocket; the {pair} race has 'real' and 'hertzian'")
    largest = float(given.max())
    contact = replace(contact_of(scene, pair=pair, load=largest), load=float(given[0]))
    asked = scene.tolerance if tolerance is None else tolerance
    with traced_to_load(scene, pair=pair, load=largest):
        found = compare_series(
            contact, recipe=load_recipe(RECIPES[geometry]), loads=given, tolerance=asked, progress=progress
        )
    return replace(found, warnings=(*scene.warnings, *found.warnings))


def compare_series(
    contact: Contact, *, recipe: Recipe, loads: ArrayLike, tolerance: float, progress: Progress = silent
) -> LoadSeries:
    """Solve `contact` under each of `loads`, (n,) N, on the second and third level of `recipe`.

    tolerance : relative; loads whose approach it leaves too uncertain or undecided are solved again, each on its own
    """
    start = time.perf_counter()
    given = checked_loads(loads)
    middle, fine = recipe.levels[1:3]
    progress(0.0, f"{contact.pair}: {given.size} loads")
    second = solve_series(contact, recipe=recipe, level=middle, loads=given)
    progress(0.3, f"{contact.pair}: far boundary")
    bounded = has_boundary(second[0], recipe=recipe)
    larger = on_level(second, recipe=recipe, level=middle, extended=True) if bounded else (None,) * given.size
    progress(0.5, f"{contact.pair}: level {fine}")
    third = on_level(second, recipe=recipe, level=fine)
    solved = {
        parts[1].contact.load: (parts[1], _approach(*parts), off_mesh_uncertainty(parts[1]))
        for parts in zip(second, third, larger, strict=True)
    }
    solved |= _refined(solved, recipe=recipe, tolerance=tolerance, progress=part_of(progress, 0.6, 1.0))
    third, approaches, crossing = zip(*(solved[load] for load in given.tolist()), strict=True)
    data = LawData.of(given, approaches, crossing)
    law = fit_law(data)
    tangents = [(None, None)] * given.size if law is None else _tangents(data, given, approaches)
    thin = recipe.geometry == "wall"
    over = np.array([near_shoulder(part, contact) for part in third])
    points = []
    for part, approach, tangent, overrun in zip(third, approaches, tangents, over, strict=True):
        formula = hertz_quantities(part.contact).approach
        points.append(
            LoadPoint(
                load=part.contact.load,
                approach=approach,
                hertz_approach=formula,
                tangent=tangent[0],
                tangent_uncertainty=tangent[1],
                verdict=judge(
                    discrepancy=formula / approach.value - 1,
                    uncertainty=approach.total,
                    tolerance=tolerance,
                    settled=approach.settled,
                    spread=approach.spread,
                    valid=not thin and not (overrun and recipe.geometry == "real"),
                ),
            )
        )
    return LoadSeries(
        contact=third[0].contact,
        geometry=recipe.geometry,
        tolerance=tolerance,
        points=tuple(points),
        law=law,
        hertz_stiffness=hertz_quantities(third[0].contact).stiffness,
        solutions=third,
        seconds=time.perf_counter() - start,
        warnings=(
            *((sheet_warning(contact),) if thin else ()),
            *_warnings(contact, points, over if recipe.geometry == "real" else over & False, tolerance=tolerance),
        ),
    )


def _refined(
    solved: dict[float, Solved], *, recipe: Recipe, tolerance: float, progress: Progress
) -> dict[float, Solved]:
    """The loads that have to be solved on meshes of their own: their approach is too uncertain, or its verdict open."""

    def is_open(part: Estimate, contact: Contact) -> bool:
        formula = hertz_quantities(contact).approach
        return recipe.geometry != "wall" and could_be_decided(part, formula, tolerance=tolerance)

    found = {}
    for number, (load, (solution, part, _)) in enumerate(solved.items()):
        contact = solution.contact
        if part.mesh <= max(tolerance - part.domain, part.domain / 2) and not is_open(part, contact):
            continue
        try:
            single = solve_reference(
                contact,
                recipe=recipe,
                accuracy=tolerance,
                watched=("approach",),
                is_open=lambda estimates, contact=contact: is_open(estimates["approach"], contact),
                progress=part_of(progress, number / len(solved), (number + 1) / len(solved)),
            )
        except InputError:  # an ellipse too wide for a mesh of its own: what it has on its neighbour's stays
            continue
        found[load] = single.meshes[-1], single.estimates["approach"], 0.0
    return found


def off_mesh_uncertainty(solution: MeshSolution) -> float:
    """Relative, of an approach: what its ellipse loses on a mesh that was made for another."""
    return OFF_MESH * min(1.0, off_mesh(solution) / OFF_FROM)


def _approach(second: MeshSolution, third: MeshSolution, larger: MeshSolution | None) -> Estimate:
    order = FORMAL_ORDERS["approach"]
    assert order is not None
    values = second.quantities.approach, third.quantities.approach
    step = (values[1] - values[0]) / ((third.level / second.level) ** order - 1)
    return Estimate(
        values=values,
        order=None,  # two levels show none
        richardson=values[1] + step,
        mesh=HALF * abs(step) / values[1] + FINEST + off_mesh_uncertainty(third),
        **({} if larger is None else vars(boundary_effect(second, larger)["approach"])),
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class LawData:
    """What a law is fitted to, (n,) each: distinct loads, rising, and relative half-widths of their approaches."""

    load: Array  # N
    approach: Array  # m
    common: Array  # errors that may have one cause at all loads
    crossing: Array  # errors off the mesh

    @classmethod
    def of(cls, loads: Array, approaches: Sequence[Estimate], crossing: Sequence[float]) -> "LawData":
        """From loads in any order, each as often as may be."""
        load, index = np.unique(loads, return_index=True)
        total = np.array([approaches[i].total for i in index])
        off = np.array([crossing[i] for i in index])
        value = np.array([approaches[i].value for i in index])
        return cls(load=load, approach=value, common=total - off, crossing=off)


def fit_law(data: LawData) -> StiffnessLaw | None:
    """F = K delta^n; None where there is only one load.

    Loads are exact and approaches are not: ln delta is fitted over ln F by least squares, and 1/n is its slope.
    """
    if data.load.size < 2:
        return None
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load)])
    (intercept, slope), scatter, propagated = _fitted(data, basis, of=np.array([[0.0, 1.0]]))
    exponent = 1 / slope
    logarithm = -intercept * exponent  # of K
    _, *parts = _fitted(data, basis, of=np.array([[-exponent, -logarithm * exponent]]))  # its derivatives
    return StiffnessLaw(
        stiffness=float(np.exp(logarithm)),
        exponent=float(exponent),
        stiffness_uncertainty=float(sum(part[0] for part in parts)),
        misfit=None if data.load.size == 2 else float(exponent**2 * scatter[0]),
        propagated=float(exponent**2 * propagated[0]),
    )


def _tangents(data: LawData, loads: Array, approaches: Sequence[Estimate]) -> list[tuple[float, float]]:
    """dF/d(delta), N/m, and its relative uncertainty, at each of `loads`.

    From five loads on, the slope of ln delta = c0 + c1 ln F + c2 F^(1/3): a groove departs from its power law as the
    contact's size over the body's, which goes as F^(1/3). Fewer loads give the slope of the power law itself.
    """
    terms = 3 if data.load.size >= ENOUGH else 2
    largest = data.load[-1]
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load), (data.load / largest) ** (1 / 3)])
    of = np.column_stack([np.zeros(loads.size), np.ones(loads.size), (loads / largest) ** (1 / 3) / 3])[:, :terms]
    coefficients, scatter, propagated = _fitted(data, basis[:, :terms], of=of)
    slope = of @ coefficients  # of ln delta over ln F
    tangent = loads / np.array([part.value for part in approaches]) / slope
    uncertainty = (scatter + propagated) / np.abs(slope) + np.array([part.total for part in approaches])
    return list(zip(tangent.tolist(), uncertainty.tolist(), strict=True))


def _fitted(data: LawData, basis: Array, *, of: Array) -> tuple[Array, Array, Array]:
    """Coefficients (k,) of ln delta over `basis` (n, k), and for each row of `of` (m, k), a combination of them, two
    half-widths (m,): that of the scatter about the fit, 95 %, 0 where nothing is left over; and that of the approaches.

    Common errors count as if each had the sign that hurts most, and so do those off the mesh at neighbouring loads;
    apart from each other these add as squares.
    """
    inverse = np.asarray(np.linalg.pinv(basis), dtype=np.float64)  # its stub promises any float
    values = np.log(data.approach)
    coefficients = inverse @ values
    weights = np.abs(of @ inverse)
    left = basis.shape[0] - basis.shape[1]
    scatter = np.zeros(of.shape[0])
    if left > 0:
        deviation = np.sqrt(np.sum((values - basis @ coefficients) ** 2) / left)
        scatter = student.ppf((1 + CONFIDENCE) / 2, left) * deviation * np.sqrt(np.sum(weights**2, axis=1))
    cell = np.floor(np.log(data.load) / ALIKE)
    alike = (cell[:, None] == np.unique(cell)).astype(float)
    crossing = np.sqrt(np.sum(((weights * data.crossing) @ alike) ** 2, axis=1))
    return coefficients, scatter, weights @ data.common + crossing


def _warnings(
    contact: Contact, points: Sequence[LoadPoint], over: NDArray[np.bool_], *, tolerance: float
) -> tuple[str, ...]:
    found = []
    if over.any():
        least = min(point.load for point, overrun in zip(points, over, strict=True) if overrun)
        found.append(
            f"{contact.pair}: from {least:g} N on the contact reaches its shoulder, {contact.shoulder * 1e3:.3f} mm "
            "away: outside Hertz"
        )
    least_sure = max(points, key=lambda point: point.approach.total)
    if least_sure.approach.total > tolerance:
        found.append(
            f"{contact.pair}: an uncertainty of {tolerance:.2g} was asked for; at {least_sure.load:g} N it is "
            f"{least_sure.approach.total:.2g}"
        )
    return tuple(found)
