"""A contact under many loads: its stiffness law F = K delta^n by finite elements, beside Hertz's F = K delta^1.5.

F: load, N; delta: approach, m. Each approach comes from the second and third level of a recipe, with value and
uncertainty by the rules of a single contact. Loads share meshes, and one whose ellipse is not that of its mesh is less
certain: see `OFF_MESH`. One whose approach is then less certain than the tolerance asks for is solved once more as a
contact of its own.
"""

import time
from dataclasses import asdict, dataclass, replace
from typing import Any

from numpy.typing import ArrayLike

from analytic.errors import InputError
from analytic.scene import Contact, Pair, Scene
from fembearing.compare.contact.discrepancy import (
    Shape,
    as_meshed,
    contact_of,
    hertz_quantities,
    recipe_of,
    traced_to_load,
)
from fembearing.compare.contact.law_fit import LawData, StiffnessLaw, fit_law, fit_tangents
from fembearing.compare.contact.reference import boundary_effect, estimates_of, has_boundary, solve_reference
from fembearing.compare.contact.uncertainty import Estimate
from fembearing.compare.contact.verdict import Verdict, could_be_decided, verdict_on, worst
from fembearing.compare.contact.warnings import (
    near_shoulder,
    series_shoulder_warning,
    sheet_warning,
    solve_warnings,
    two_loads_warning,
)
from fembearing.fem.series import checked_loads, off_mesh, on_level, solve_series
from fembearing.fem.solution import MeshSolution
from fembearing.memory import peak_memory
from fembearing.mesh.recipe import Geometry, Recipe
from fembearing.progress import Progress, part_of, silent

# Where the edge of an ellipse runs through cells that were made for another one, the approach goes up and down with the
# load, alike on all levels. Seen on 14 idealised contacts at 33 sizes from 0.65 to 1.35 of the mesh's, beyond what the
# levels show: 0.21 % in 95 of 100, 0.43 % at worst (validation/benchmarks/calibrations.py); less where the ellipse is
# nearly the mesh's.
OFF_MESH = 3e-3
OFF_FROM = 0.1  # an ellipse so far from its mesh's, in semi-axes, is off in full; in proportion below
Solved = tuple[MeshSolution, Estimate, float]  # on the finest mesh, its approach, and its share that is off the mesh


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadPoint:
    """One load of a series. Tangents are dF/d(delta), N/m; uncertainties relative half-widths."""

    load: float  # N
    approach: Estimate  # m
    hertz_approach: float  # m
    tangent: float | None  # by finite elements; None where one load makes the series
    tangent_uncertainty: float | None  # None where no third load shows how far from a power law the series is
    verdict: Verdict  # on Hertz's approach

    @property
    def discrepancy(self) -> float:
        """Hertz's approach over that of finite elements, less one."""
        return self.hertz_approach / self.approach.value - 1

    @property
    def hertz_tangent(self) -> float:
        return 1.5 * self.load / self.hertz_approach


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
    accuracy: float | None = None,
    geometry: Shape = "real",
    progress: Progress = silent,
) -> LoadSeries:
    """Solve one contact of a scene under each of `loads` and set Hertz beside it.

    loads : (n,) of the ball, N, in any order; the contact angle stays that of the scene's largest load
    tolerance : relative, for the verdict; the scene's unless given
    accuracy : asked of each approach, relative half-width of its 95 % interval; the tolerance unless given
    geometry : as of `solve_contact`, but for "ring"
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for loads that are none or not positive or a contact that cannot be meshed, ConvergenceError for
    one that does not settle.
    """
    given = checked_loads(loads)
    if geometry == "ring":
        raise InputError("geometry 'ring' is that of one load, not of a series: give one --load")
    recipe = recipe_of(geometry, pair=pair)
    largest = float(given.max())
    contact = replace(contact_of(scene, pair=pair, load=largest), load=float(given[0]))
    asked = scene.tolerance if tolerance is None else tolerance
    with traced_to_load(scene, pair=pair, load=largest):
        found = compare_series(
            contact, recipe=recipe, loads=given, tolerance=asked, accuracy=accuracy, progress=progress
        )
    return replace(found, warnings=(*scene.warnings, *found.warnings))


def compare_series(
    contact: Contact,
    *,
    recipe: Recipe,
    loads: ArrayLike,
    tolerance: float,
    accuracy: float | None = None,
    progress: Progress = silent,
) -> LoadSeries:
    """Solve `contact` under each of `loads`, (n,) N, on the second and third level of `recipe`.

    tolerance : relative, for the verdict;  accuracy : of each approach, relative; the tolerance unless given
    Loads whose approach is more uncertain than that, or undecided, are solved again, each on its own.
    """
    start = time.perf_counter()
    wanted = tolerance if accuracy is None else accuracy
    contact = as_meshed(contact, recipe=recipe)
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
    solved |= _refined(
        solved, recipe=recipe, tolerance=tolerance, accuracy=wanted, progress=part_of(progress, 0.6, 1.0)
    )
    third, approaches, crossing = zip(*(solved[load] for load in given.tolist()), strict=True)
    data = LawData.of(given, approaches, crossing)
    law = fit_law(data)
    tangents = [(None, None)] * given.size if law is None else fit_tangents(data, given, approaches)
    thin = recipe.geometry == "wall"
    over = [part.contact.load for part in third if near_shoulder(part, contact)]
    points = []
    for part, approach, tangent in zip(third, approaches, tangents, strict=True):
        formula = hertz_quantities(part.contact).approach
        valid = not thin and part.contact.load not in over
        points.append(
            LoadPoint(
                load=part.contact.load,
                approach=approach,
                hertz_approach=formula,
                tangent=tangent[0],
                tangent_uncertainty=tangent[1],
                verdict=verdict_on(formula, approach, tolerance=tolerance, valid=valid),
            )
        )
    every = [(part, {"approach": approach}) for part, approach in zip(third, approaches, strict=True)]
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
            *((series_shoulder_warning(contact, load=min(over)),) if over else ()),
            *solve_warnings(every, accuracy=wanted, watched=("approach",), thin=thin),
            *((two_loads_warning(contact),) if law is not None and not data.redundant else ()),
        ),
    )


def _refined(
    solved: dict[float, Solved], *, recipe: Recipe, tolerance: float, accuracy: float, progress: Progress
) -> dict[float, Solved]:
    """The loads that have to be solved on meshes of their own: their approach is too uncertain, or its verdict open."""

    def is_open(part: Estimate, contact: Contact) -> bool:
        formula = hertz_quantities(contact).approach
        return recipe.geometry != "wall" and could_be_decided(formula, part, tolerance=tolerance)

    found = {}
    for number, (load, (solution, part, _)) in enumerate(solved.items()):
        contact = solution.contact
        decided = solution.shoulder is not None or not is_open(part, contact)  # at a shoulder Hertz is not judged
        if part.mesh <= max(accuracy - part.domain, part.domain / 2) and decided:
            continue
        try:
            single = solve_reference(
                contact,
                recipe=recipe,
                accuracy=accuracy,
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
    found = estimates_of((second, third))["approach"]
    return replace(
        found,
        mesh=found.mesh + off_mesh_uncertainty(third),
        **({} if larger is None else vars(boundary_effect(second, larger)["approach"])),
    )
