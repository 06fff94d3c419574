"""A contact under many loads: its stiffness law F = K delta^n by finite elements, and Hertz's F = K delta^1.5.

F: load, N; delta: approach, m. Loads of a true shape that end before the shoulder are solved by the compliance of the
pair, see `fembearing.check.contact.compliance`. Each other approach comes from the second and third level of a
recipe, with value and uncertainty as for a single contact. These loads share meshes, and a load whose ellipse differs
from that of its mesh is more uncertain: see `OFF_MESH`. A load whose approach is then too uncertain for the required
accuracy is solved again on its own meshes.
"""

import os
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, Unpack

import numpy as np
from numpy.typing import ArrayLike

from analytic.any_scene import scene_by
from analytic.brief import Brief, span
from analytic.errors import InputError, require_non_negative
from analytic.given import SceneOptions
from analytic.labelled import Column, Labelled, dataset_of, frame_of
from analytic.progress import Progress, part_of, silent
from analytic.rows import Count, NotNegative, Positive
from analytic.scene import Contact, Pair, Scene
from analytic.scenefile.parts import Given, with_tolerance
from fembearing.check.comparison import Comparison, ShownVerdict, compared_with, could_be_decided, verdict_on, worst
from fembearing.check.contact.columns import COLUMNS, VERDICT, require_finite_results
from fembearing.check.contact.compliance import ends_before_shoulder, pair_series
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.meshed_region import Boundary, boundary_effect, has_boundary, has_sides, with_sides
from fembearing.check.contact.refinement import Estimates, estimates_of, solve_reference
from fembearing.check.contact.scene_contact import Shape, as_meshed, contact_of, recipe_of, traced_to_load
from fembearing.check.contact.stiffness_law import (
    LawData,
    PocketLaw,
    StiffnessLaw,
    fit_law,
    fit_pocket_law,
    fit_tangents,
)
from fembearing.check.contact.uncertainty import OFF_FROM, OFF_MESH
from fembearing.check.contact.warnings import (
    near_shoulder,
    series_shoulder_warning,
    sheet_warnings,
    solve_warnings,
    two_loads_warning,
)
from fembearing.check.memory import peak_memory
from fembearing.fem.pixel_contact import PixelSolution
from fembearing.fem.series import checked_loads, off_mesh, on_level, solve_series
from fembearing.fem.solution import MeshSolution
from fembearing.grid_convergence import Estimate, mesh_allowed
from fembearing.mesh.recipe import Geometry, Recipe


class SolvedLoad(NamedTuple):
    """One load of a series."""

    mesh: MeshSolution | PixelSolution  # on the finest level
    estimates: Estimates  # of the approach, and of the other quantities where the compliance of the pair gives them
    off_mesh: float  # relative, the part of the approach's uncertainty by `OFF_MESH`


@dataclass(frozen=True, kw_only=True)
class LoadPoint:
    """One load of a series, compared with Hertz. Tangents are dF/d(delta), N/m; uncertainties relative half-widths."""

    load: Positive  # N
    quantities: dict[str, Comparison]  # the approach, and all others where the compliance of the pair gives them
    tangent: Positive | None  # by finite elements; None for a single load
    tangent_uncertainty: NotNegative | None  # None without a third load, which shows the deviation from a power law
    hertz_tangent: Positive  # 1.5 times load over approach

    def __post_init__(self) -> None:
        """Raises InputError for a number that is not finite."""
        approach = self.approach
        found = {
            "uncertainty of the approach": approach.uncertainty,
            "approach by Hertz": approach.production,
            **{name: each.reference for name, each in self.quantities.items()},
            "tangent": self.tangent,
            "uncertainty of the tangent": self.tangent_uncertainty,
        }
        require_finite_results(found, of=f"under {self.load:g} N")

    @property
    def approach(self) -> Comparison:
        """The approach, on which the verdict is."""
        return self.quantities["approach"]


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadSeries(Brief):
    """A contact under a series of loads by Hertz and by finite elements, SI, in the order given."""

    pair: Pair
    geometry: Geometry  # which shapes were meshed
    contact_angle: float  # rad
    tolerance: NotNegative  # of the verdicts, relative
    points: tuple[LoadPoint, ...]
    law: StiffnessLaw | None  # None for a single load
    pocket_law: PocketLaw | None  # of the sheet of a pocket under two loads or more; else None
    hertz_stiffness: Positive  # K of Hertz's F = K delta^1.5, N/m^1.5
    verdict: ShownVerdict  # the worst of all loads; shown: a sheet, which Hertz's half space does not describe
    meshes: Count  # number of meshes of one level that the loads share
    seconds: NotNegative
    peak_memory: Count | None  # of the process when the series was solved, bytes
    warnings: tuple[str, ...]  # one line each

    def _facts(self) -> Iterator[str]:
        yield from (self.pair, self.geometry, f"{span([point.load for point in self.points])} N")
        yield from (f"{len(self.points)} loads", self.verdict)

    @property
    def _loads(self) -> Labelled:
        return Labelled(("load",), [point.load for point in self.points], COLUMNS["load"])

    def _columns(self) -> dict[str, Labelled]:
        """What is computed at each load, SI."""
        described = {name: COLUMNS[name] for name in COLUMNS if name.endswith("approach")} | {
            "tangent": Column("N/m", "dF/d(approach), finite elements"),
            "uncertainty_tangent": Column("1", "numerical uncertainty of dF/d(approach), relative"),
            "hertz_tangent": Column("N/m", "dF/d(approach), Hertz"),
            VERDICT: Column("", "on Hertz's approach"),
        }
        rows = [
            {
                "approach": point.approach.reference,
                "uncertainty_approach": point.approach.uncertainty / point.approach.reference,
                "hertz_approach": point.approach.production,
                "discrepancy_approach": point.approach.difference,
                "tangent": np.nan if point.tangent is None else point.tangent,
                "uncertainty_tangent": np.nan if point.tangent_uncertainty is None else point.tangent_uncertainty,
                "hertz_tangent": point.hertz_tangent,
                VERDICT: point.approach.verdict,
            }
            for point in self.points
        ]
        return {name: Labelled(("load",), [row[name] for row in rows], column) for name, column in described.items()}

    def to_dataset(self) -> Any:
        """An xarray.Dataset over the loads, SI, with units and meanings as attributes."""
        return dataset_of(
            self._columns(),
            coordinates={"load": self._loads},
            attributes={"pair": self.pair, "geometry": self.geometry, "tolerance": self.tolerance},
        )

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with the columns of `to_dataset`: a row for each load, SI."""
        return frame_of({"load": self._loads} | self._columns(), "load")


def solve_load_series(
    scene: Scene | str | os.PathLike[str],
    *,
    pair: Pair,
    loads: ArrayLike,
    tolerance: Given | None = None,
    accuracy: float | None = None,
    geometry: Shape = "real",
    progress: Progress = silent,
    **options: Unpack[SceneOptions],
) -> LoadSeries:
    """Solve one contact of a scene under each of `loads` and compare Hertz with it.

    Parameters
    ----------
    scene : Scene, str or path
        With a cage for the pair "pocket".
    pair : {"inner", "outer", "pocket"}
        What the ball touches.
    loads : array_like, shape (n,)
        Of the ball, N, > 0, in any order; the contact angle stays that of the scene's largest load.
    tolerance : float or str, optional
        Relative (dimensionless), for the verdict; None: the scene's.
    accuracy : float, optional
        Required of each approach, relative half-width of its 95 % interval (dimensionless); None: the tolerance.
    geometry : {"real", "hertzian", "wall"}
        As in `solve_contact`.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and the name of the current step.
    **options : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    LoadSeries
        Points in the order of `loads`, SI, and the law F = K delta^n with its uncertainty.

    Raises
    ------
    InputError
        Loads are missing or not positive, or a contact cannot be meshed.
    ConvergenceError
        A contact does not converge.

    Notes
    -----
    Sources: those of `solve_contact`; the fit of the law is derived here (`fembearing.check.contact.stiffness_law`).
    """
    scene = scene_by(scene, options)
    given = checked_loads(loads)
    tolerance = scene.tolerance if tolerance is None else with_tolerance(scene, tolerance).tolerance
    require_non_negative(accuracy=tolerance if accuracy is None else accuracy)
    if geometry == "ring":
        raise InputError("geometry 'ring' is that of one load, not of a series: give one --load")
    recipe = recipe_of(geometry, pair=pair)
    largest = float(given.max())
    contact = replace(contact_of(scene, pair=pair, load=largest), load=float(given[0]))
    with traced_to_load(scene, pair=pair, load=largest):
        series = compare_series(
            contact, recipe=recipe, loads=given, tolerance=tolerance, accuracy=accuracy, progress=progress
        )
    return replace(series, warnings=(*scene.warnings, *series.warnings))


def compare_series(
    contact: Contact,
    *,
    recipe: Recipe,
    loads: ArrayLike,
    tolerance: float,
    accuracy: float | None = None,
    progress: Progress = silent,
) -> LoadSeries:
    """Solve `contact` under each of `loads`, (n,) N, by the compliance of the pair or on two levels of `recipe`.

    tolerance : relative, for the verdict;  accuracy : of each approach, relative; the tolerance unless given
    A load whose approach misses the accuracy, or whose verdict is undecided, is solved again on its own meshes.
    """
    start = time.perf_counter()
    accuracy = tolerance if accuracy is None else accuracy
    contact = as_meshed(contact, recipe=recipe)
    given = checked_loads(loads)
    solved, meshes = _solved(contact, recipe=recipe, loads=sorted(set(given.tolist())), progress=progress)
    solved |= _refined(
        solved, recipe=recipe, tolerance=tolerance, accuracy=accuracy, progress=part_of(progress, 0.6, 1.0)
    )
    finest, estimates, off = zip(*(solved[load] for load in given.tolist()), strict=True)
    approaches = [part["approach"] for part in estimates]
    data = LawData.of(given, approaches, off)
    law = fit_law(data)
    tangents = [(None, None)] * given.size if law is None else fit_tangents(data, given, approaches)
    thin = recipe.geometry == "wall"
    over = [part.contact.load for part in finest if near_shoulder(part, contact)]
    heaviest = finest[int(given.argmax())]
    bending = ()
    if thin and isinstance(heaviest, MeshSolution):  # a sheet is solved on meshes
        bending = sheet_warnings(heaviest, hertz=hertz_quantities(heaviest.contact).peak_pressure)
    every = [(part, {"approach": approach}) for part, approach in zip(finest, approaches, strict=True)]
    points = tuple(
        _point_of(*each, tolerance=tolerance, judged=not thin, valid=each[0].contact.load not in over)
        for each in zip(finest, estimates, tangents, strict=True)
    )
    return LoadSeries(
        pair=contact.pair,
        geometry=recipe.geometry,
        contact_angle=contact.contact_angle,
        tolerance=tolerance,
        points=points,
        law=law,
        pocket_law=fit_pocket_law(data) if thin else None,
        hertz_stiffness=hertz_quantities(finest[0].contact).stiffness,
        verdict=worst(point.approach.verdict for point in points),
        meshes=meshes,
        seconds=time.perf_counter() - start,
        peak_memory=peak_memory(),
        warnings=(
            *bending,
            *((series_shoulder_warning(contact, load=min(over)),) if over else ()),
            *solve_warnings(every, accuracy=accuracy, quantities=("approach",), thin=thin),
            *((two_loads_warning(contact),) if law is not None and not data.redundant else ()),
        ),
    )


def _solved(
    contact: Contact, *, recipe: Recipe, loads: list[float], progress: Progress
) -> tuple[dict[float, SolvedLoad], int]:
    """Each of `loads`, and the number of meshes of one level.

    loads : N, ascending, each once
    Two loads or more of a true shape that end before the shoulder share the compliance of the pair.
    """
    progress(0.0, f"{contact.pair}: {len(loads)} loads")
    shared = []
    if recipe.geometry == "real":
        shared = [load for load in loads if ends_before_shoulder(replace(contact, load=load))]
    if len(shared) < 2:
        return _on_shared_meshes(contact, recipe=recipe, loads=loads, progress=progress)
    series = pair_series(contact, recipe=recipe, loads=shared)
    progress(0.4, f"{contact.pair}: {len(shared)} loads by the compliance of the pair")
    solved = {load: SolvedLoad(*series.under(load), 0.0) for load in shared}
    others, meshes = {}, 0
    if len(shared) < len(loads):
        over = [load for load in loads if load not in solved]
        others, meshes = _on_shared_meshes(contact, recipe=recipe, loads=over, progress=progress)
    return solved | others, len(series.sampled) + meshes


def _on_shared_meshes(
    contact: Contact, *, recipe: Recipe, loads: list[float], progress: Progress
) -> tuple[dict[float, SolvedLoad], int]:
    """Each of `loads` on plain levels, and the number of meshes of one level; arguments as above."""
    middle, fine = recipe.levels[1:3]
    second = solve_series(contact, recipe=recipe, level=middle, loads=loads)
    progress(0.3, f"{contact.pair}: far boundary")
    bounded = has_boundary(second[0], recipe=recipe)
    larger = on_level(second, recipe=recipe, level=middle, extended=True) if bounded else (None,) * len(loads)
    # Where one load needs the true sides all get them; a mesh that is cut off is half of the contact already.
    sided = any(has_sides(part, recipe=recipe) for part in second)
    both = [
        on_level(second, recipe=recipe, level=middle, sides=side) if sided else (None,) * len(loads)
        for side in ("above", "below")
    ]
    progress(0.5, f"{contact.pair}: level {fine}")
    third = on_level(second, recipe=recipe, level=fine)
    solved = {
        parts[1].contact.load: SolvedLoad(parts[1], {"approach": _approach(*parts)}, off_mesh_uncertainty(parts[1]))
        for parts in zip(second, third, larger, *both, strict=True)
    }
    return solved, len({id(part.bodies) for part in third})


def _point_of(
    part: MeshSolution | PixelSolution,
    estimates: Estimates,
    tangent: tuple[float | None, float | None],
    *,
    tolerance: float,
    judged: bool,
    valid: bool,
) -> LoadPoint:
    """One load of the series.

    part : on the finest level;  tangent : stiffness and its uncertainty
    judged : whether Hertz describes the bodies;  valid : whether the contact ends before its shoulder
    """
    hertz, load = vars(hertz_quantities(part.contact)), part.contact.load
    found = {name: compared_with(each, hertz[name]) for name, each in estimates.items()}
    if judged:
        verdict = verdict_on(hertz["approach"], estimates["approach"], tolerance=tolerance, valid=valid)
        found["approach"] = replace(found["approach"], verdict=verdict)
    return LoadPoint(
        load=load,
        quantities=found,
        tangent=tangent[0],
        tangent_uncertainty=tangent[1],
        hertz_tangent=1.5 * load / hertz["approach"],
    )


def _refined(
    solved: dict[float, SolvedLoad], *, recipe: Recipe, tolerance: float, accuracy: float, progress: Progress
) -> dict[float, SolvedLoad]:
    """The loads whose approach is too uncertain or whose verdict is undecided, each solved on its own meshes."""

    def undecided(part: Estimate, contact: Contact) -> bool:
        formula = hertz_quantities(contact).approach
        return recipe.geometry != "wall" and could_be_decided(formula, part, tolerance=tolerance)

    refined = {}
    for number, (load, (mesh, estimates, _)) in enumerate(solved.items()):
        contact, part = mesh.contact, estimates["approach"]
        decided = mesh.shoulder is not None or not undecided(part, contact)  # at a shoulder Hertz is not judged
        if part.mesh <= mesh_allowed(accuracy, domain=part.domain) and decided:
            continue
        try:
            single = solve_reference(
                contact,
                recipe=recipe,
                accuracy=accuracy,
                quantities=("approach",),
                undecided=lambda estimates, contact=contact: undecided(estimates["approach"], contact),
                progress=part_of(progress, number / len(solved), (number + 1) / len(solved)),
            )
        except InputError:  # an ellipse too wide for its own mesh: the result on its neighbour's stays
            continue
        refined[load] = SolvedLoad(single.meshes[-1], single.estimates, 0.0)
    return refined


def off_mesh_uncertainty(solution: MeshSolution) -> float:
    """Relative uncertainty of an approach whose ellipse differs from that of its mesh."""
    return OFF_MESH * min(1.0, off_mesh(solution) / OFF_FROM)


def _approach(
    second: MeshSolution,
    third: MeshSolution,
    larger: MeshSolution | None,
    above: MeshSolution | None,
    below: MeshSolution | None,
) -> Estimate:
    estimate = estimates_of((second, third))["approach"]
    boundary = {"approach": Boundary()} if larger is None else boundary_effect(second, larger)
    if above is not None and below is not None:
        boundary = with_sides(boundary, second, above, below, farther=None)
    return replace(estimate, mesh=estimate.mesh + off_mesh_uncertainty(third), **vars(boundary["approach"]))
