"""A contact under many loads: its stiffness law F = K delta^n by finite elements, and Hertz's F = K delta^1.5.

F: load, N; delta: approach, m. Loads of a true shape that end before the shoulder are solved by the compliance of the
pair, see `fembearing.check.contact.reference`. Each other approach comes from the second and third level of a
recipe, with value and uncertainty as for a single contact. These loads share meshes, and a load whose ellipse differs
from that of its mesh is more uncertain: see `OFF_MESH`. A load whose approach is then too uncertain for the required
accuracy is solved again on its own meshes.

In the sheet of a cage pocket delta = (F/K)^(2/3) + F/k, a local contact and a sheet that bends, of stiffness k, N/m.
Bending is linear in the load and the local contact is not: one stiffness K of both holds at a single load. Laws are
fitted with F exact and each delta with its own half-width.
"""

import os
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple, Unpack

import numpy as np
from numpy.typing import ArrayLike
from scipy.special import stdtrit
from threadpoolctl import threadpool_limits

from analytic.any_scene import scene_by
from analytic.brief import Brief, span
from analytic.columns import CONTACT_COLUMNS, VERDICT
from analytic.errors import InputError, require_non_negative
from analytic.given import SceneOptions
from analytic.labelled import Column, Labelled, dataset_of, frame_of
from analytic.progress import Progress, part_of, silent
from analytic.rows import Count, NotNegative, Positive
from analytic.scene import Array, Contact, Pair, Scene
from analytic.scenefile.parts import Given, with_tolerance
from fembearing.check.comparison import Comparison, ShownVerdict, worst
from fembearing.check.contact.hertz import beside_hertz, hertz_quantities
from fembearing.check.contact.meshed_region import Boundary, boundary_effect, has_boundary
from fembearing.check.contact.reference import ends_before_shoulder, pair_series, solve_reference
from fembearing.check.contact.refinement import Estimates, Wanted, estimates_of
from fembearing.check.contact.scene_contact import Shape, as_meshed, contact_of, recipe_of, traced_to_load
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
from fembearing.grid_convergence import Estimate
from fembearing.mesh.recipe import Geometry, Recipe

# A series on plain levels: where the edge of an ellipse crosses cells made for another ellipse, the error of the
# approach oscillates with the load, alike on all levels. On 14 idealised contacts at 33 sizes from 0.65 to 1.35 of
# the mesh's it exceeded the error that the levels show by 0.21 % in 95 of 100 and 0.43 % at worst
# (validation/benchmarks/calibrations.py); it is smaller where the ellipse is close to the mesh's.
OFF_MESH = 3e-3
OFF_FROM = 0.1  # difference of the ellipses, in semi-axes, from which OFF_MESH applies in full; in proportion below
APPROACH = ("approach",)  # on which the verdict of a series is
ALIKE = 0.3  # in ln F, a tenth of a semi-axis: farther apart, off-mesh errors of two loads are independent
CONFIDENCE = 0.95
ENOUGH = 5  # distinct loads from which the tangents may depart from a power law


@dataclass(frozen=True, kw_only=True)
class StiffnessLaw:
    """F = K delta^n, fitted to a series. Uncertainties except `propagated` are None for two loads, which always fit."""

    stiffness: float  # K, N/m^n: extrapolated to 1 m, to be used only with n
    exponent: float  # n
    stiffness_uncertainty: float | None  # of K, relative half-width, 95 %: large, as 1 m is far from any approach
    misfit: float | None  # of the exponent, from the deviation of the loads from a power law
    propagated: float  # of the exponent, from uncertain approaches
    exponent_uncertainty: float | None  # absolute, 95 %: the sum of both parts, as they may depend on each other


@dataclass(frozen=True, kw_only=True, eq=False)
class LawData:
    """The data of the fit, (n,) each: distinct loads, ascending, and relative half-widths of their approaches."""

    load: Array  # N
    approach: Array  # m
    common: Array  # errors that may have one cause at all loads
    crossing: Array  # off-mesh errors

    @classmethod
    def of(cls, loads: Array, approaches: Sequence[Estimate], crossing: Sequence[float]) -> "LawData":
        """From loads in any order, which may repeat."""
        load, index = np.unique(loads, return_index=True)
        total = np.array([approaches[i].total for i in index])
        off = np.array([crossing[i] for i in index])
        value = np.array([approaches[i].value for i in index])
        return cls(load=load, approach=value, common=total - off, crossing=off)

    @property
    def redundant(self) -> bool:
        """Whether there are more loads than a power law has parameters."""
        return self.load.size > 2


def fit_law(data: LawData) -> StiffnessLaw | None:
    """F = K delta^n; None for a single load.

    Loads are exact and approaches are not: ln delta is fitted over ln F by least squares, with slope 1/n. Two loads
    cannot show a departure from the law: it is assumed, without an interval.
    """
    if data.load.size < 2:
        return None
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load)])
    (intercept, slope), weights, deviation, propagated = _fitted(data, basis, of=np.array([[0.0, 1.0]]))
    exponent = 1 / slope
    logarithm = -intercept * exponent  # of K
    _, moves, _, uncertain = _fitted(data, basis, of=np.array([[-exponent, -logarithm * exponent]]))  # d ln K
    propagation = float(exponent**2 * propagated[0])
    misfit = float(exponent**2 * deviation * np.linalg.norm(weights)) if data.redundant else None
    return StiffnessLaw(
        stiffness=float(np.exp(logarithm)),
        exponent=float(exponent),
        stiffness_uncertainty=float(deviation * np.linalg.norm(moves) + uncertain[0]) if data.redundant else None,
        misfit=misfit,
        propagated=propagation,
        exponent_uncertainty=None if misfit is None else misfit + propagation,
    )


def fit_tangents(data: LawData, loads: Array, approaches: Sequence[Estimate]) -> list[tuple[float, float | None]]:
    """dF/d(delta), N/m, and its relative uncertainty, at each of `loads`, (n,) N, with their `approaches`.

    Five loads or more give the slope of ln delta = c0 + c1 ln F + c2 F^(1/3): a groove departs from its power law as
    the ratio of contact size to body size, which grows as F^(1/3). Fewer loads give the slope of the power law itself,
    two without an uncertainty.
    """
    terms = 3 if data.load.size >= ENOUGH else 2
    largest = data.load[-1]
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load), (data.load / largest) ** (1 / 3)])
    of = np.column_stack([np.zeros(loads.size), np.ones(loads.size), (loads / largest) ** (1 / 3) / 3])[:, :terms]
    coefficients, weights, deviation, propagated = _fitted(data, basis[:, :terms], of=of)
    slope = of @ coefficients  # of ln delta over ln F
    # Residuals of a power law are systematic, not random: neighbouring loads share their sign.
    misfit = deviation * np.linalg.norm(weights, ord=1 if terms == 2 else 2, axis=1)
    tangent = loads / np.array([part.value for part in approaches]) / slope
    uncertainty = (misfit + propagated) / np.abs(slope) + np.array([part.total for part in approaches])
    known = uncertainty.tolist() if data.redundant else [None] * loads.size
    return list(zip(tangent.tolist(), known, strict=True))


def _fitted(data: LawData, basis: Array, *, of: Array) -> tuple[Array, Array, float, Array]:
    """Least squares of ln delta over `basis` (n, k), for combinations `of` (m, k) of its coefficients.

    Returns the coefficients (k,); the absolute weight of each load in each combination (m, n); the deviation from the
    fit, 95 %, 0 without redundant loads; and the half-width (m,) of each combination from uncertain approaches.
    Common errors, and off-mesh errors of neighbouring loads, count with the most unfavourable signs. Off-mesh errors
    of loads farther apart add as squares.
    """
    inverse = np.asarray(np.linalg.pinv(basis), dtype=np.float64)  # its type stub allows any float
    values = np.log(data.approach)
    coefficients = inverse @ values
    weights = np.abs(of @ inverse)
    left = basis.shape[0] - basis.shape[1]
    deviation = 0.0
    if left > 0:
        scatter = np.sqrt(np.sum((values - basis @ coefficients) ** 2) / left)
        deviation = float(stdtrit(left, (1 + CONFIDENCE) / 2) * scatter)  # Student's t
    cell = np.floor(np.log(data.load) / ALIKE)
    alike = (cell[:, None] == np.unique(cell)).astype(float)
    crossing = np.sqrt(np.sum(((weights * data.crossing) @ alike) ** 2, axis=1))
    return coefficients, weights, deviation, weights @ data.common + crossing


@dataclass(frozen=True, kw_only=True)
class PocketLaw:
    """The law fitted to a series. Uncertainties are relative half-widths, 95 %; None for two loads: they always fit."""

    stiffness: float  # K, N/m^1.5
    stiffness_uncertainty: float | None
    sheet: float  # k, N/m
    sheet_uncertainty: float | None


def fit_pocket_law(data: LawData) -> PocketLaw | None:
    """The law through two loads or more, by least squares of relative errors; None for one, or without bending.

    The uncertainty is the deviation of the loads from the law plus what the uncertain approaches bring, with the most
    unfavourable signs.
    """
    if data.load.size < 2:
        return None
    basis = np.column_stack([data.load ** (2 / 3), data.load]) / data.approach[:, None]
    inverse = np.asarray(np.linalg.pinv(basis), dtype=np.float64)
    local, bending = inverse.sum(axis=1)
    if min(local, bending) <= 0:
        return None
    left = data.load.size - 2
    relative = [None, None]
    if left > 0:
        deviation = np.sqrt(np.sum((basis @ [local, bending] - 1) ** 2) / left) * stdtrit(left, (1 + CONFIDENCE) / 2)
        uncertain = np.linalg.norm(inverse, axis=1) * deviation + np.abs(inverse) @ (data.common + data.crossing)
        relative = [float(1.5 * uncertain[0] / local), float(uncertain[1] / bending)]
    return PocketLaw(
        stiffness=float(local**-1.5),
        stiffness_uncertainty=relative[0],
        sheet=float(1 / bending),
        sheet_uncertainty=relative[1],
    )


class SolvedLoad(NamedTuple):
    """One load of a series."""

    mesh: MeshSolution | PixelSolution  # on the finest level
    estimates: Estimates  # of the approach, and of the other quantities where the compliance of the pair gives them
    off_mesh: float = 0.0  # relative, the part of the approach's uncertainty by `OFF_MESH`


@dataclass(frozen=True, kw_only=True)
class LoadPoint:
    """One load of a series, compared with Hertz. Tangents are dF/d(delta), N/m; uncertainties relative half-widths."""

    load: Positive  # N
    quantities: dict[str, Comparison]  # the approach, and all others where the compliance of the pair gives them
    tangent: Positive | None  # by finite elements; None for a single load
    tangent_uncertainty: NotNegative | None  # None without a third load, which shows the deviation from a power law
    hertz_tangent: Positive  # 1.5 times load over approach

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

    def _columns(self) -> dict[str, Labelled]:
        """Each load and what is computed there, SI."""
        described = CONTACT_COLUMNS | {
            "tangent": Column("N/m", "dF/d(approach), finite elements"),
            "uncertainty_tangent": Column("1", "numerical uncertainty of dF/d(approach), relative"),
            "hertz_tangent": Column("N/m", "dF/d(approach), Hertz"),
            VERDICT: Column("", "on Hertz's approach"),
        }
        approaches = [point.approach for point in self.points]
        columns = {
            "load": [point.load for point in self.points],
            "approach": [each.reference for each in approaches],
            "uncertainty_approach": [each.uncertainty / each.reference for each in approaches],
            "hertz_approach": [each.production for each in approaches],
            "discrepancy_approach": [each.difference for each in approaches],
            "tangent": np.array([point.tangent for point in self.points], dtype=np.float64),
            "uncertainty_tangent": np.array([point.tangent_uncertainty for point in self.points], dtype=np.float64),
            "hertz_tangent": [point.hertz_tangent for point in self.points],
            VERDICT: [each.verdict for each in approaches],
        }
        return {name: Labelled(("load",), values, described[name]) for name, values in columns.items()}

    def to_dataset(self) -> Any:
        """An xarray.Dataset over the loads, SI, with units and meanings as attributes."""
        columns, attributes = self._columns(), ("pair", "geometry", "tolerance")
        return dataset_of(
            columns,
            coordinates={"load": columns.pop("load")},
            attributes={name: getattr(self, name) for name in attributes},
        )

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with the columns of `to_dataset`: a row for each load, SI."""
        return frame_of(self._columns(), "load")


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
    Sources: those of `solve_contact`; the fit of the law is derived here (`fembearing.check.contact.load_series`).
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
    with traced_to_load(scene, pair=pair, load=largest), threadpool_limits(1, "blas"):
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
    thin = recipe.geometry == "wall"
    wanted = Wanted(recipe, accuracy, APPROACH, None if thin else tolerance, APPROACH, part_of(progress, 0.6, 1.0))
    solved, meshes = _solved(contact, recipe=recipe, loads=sorted(set(given.tolist())), progress=progress)
    solved |= _refined(solved, wanted)
    finest, estimates, off = zip(*(solved[load] for load in given.tolist()), strict=True)
    approaches = [part["approach"] for part in estimates]
    data = LawData.of(given, approaches, off)
    law = fit_law(data)
    tangents = [(None, None)] * given.size if law is None else fit_tangents(data, given, approaches)
    over = [part.contact.load for part in finest if near_shoulder(part, contact)]
    heaviest = finest[int(given.argmax())]
    bending = ()
    if thin and isinstance(heaviest, MeshSolution):  # a sheet is solved on meshes
        bending = sheet_warnings(heaviest, hertz=hertz_quantities(heaviest.contact).peak_pressure)
    points = []
    for load, part, found, tangent in zip(given.tolist(), finest, estimates, tangents, strict=True):
        hertz, judged = hertz_quantities(part.contact), () if thin else APPROACH
        points.append(
            LoadPoint(
                load=load,
                quantities=beside_hertz(hertz, found, tolerance=tolerance, valid=load not in over, judged=judged),
                tangent=tangent[0],
                tangent_uncertainty=tangent[1],
                hertz_tangent=1.5 * load / hertz.approach,
            )
        )
    every = [(part, {"approach": approach}) for part, approach in zip(finest, approaches, strict=True)]
    return LoadSeries(
        pair=contact.pair,
        geometry=recipe.geometry,
        contact_angle=contact.contact_angle,
        tolerance=tolerance,
        points=tuple(points),
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
            *solve_warnings(every, accuracy=accuracy, quantities=APPROACH, thin=thin),
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
    true = recipe.geometry == "real"
    shared = [load for load in loads if true and ends_before_shoulder(replace(contact, load=load))]
    solved, meshes = {}, 0
    if len(shared) > 1:
        series = pair_series(contact, recipe=recipe, loads=shared)
        progress(0.4, f"{contact.pair}: {len(shared)} loads by the compliance of the pair")
        solved, meshes = {load: SolvedLoad(*series.under(load)) for load in shared}, len(series.sampled)
    others = [load for load in loads if load not in solved]
    if others:
        on_meshes, count = _on_shared_meshes(contact, recipe=recipe, loads=others, progress=progress)
        solved, meshes = solved | on_meshes, meshes + count
    return solved, meshes


def _on_shared_meshes(
    contact: Contact, *, recipe: Recipe, loads: list[float], progress: Progress
) -> tuple[dict[float, SolvedLoad], int]:
    """Each of `loads` on plain levels, and the number of meshes of one level; arguments as above."""
    middle, fine = recipe.levels[1:3]
    second = solve_series(contact, recipe=recipe, level=middle, loads=loads)
    progress(0.3, f"{contact.pair}: far boundary")
    bounded = has_boundary(second[0], recipe=recipe)
    larger = on_level(second, recipe=recipe, level=middle, extended=True) if bounded else ()
    progress(0.5, f"{contact.pair}: level {fine}")
    third = on_level(second, recipe=recipe, level=fine)
    solved = {}
    for number, (coarse, mesh) in enumerate(zip(second, third, strict=True)):
        region = boundary_effect(coarse, larger[number]) if bounded else {"approach": Boundary()}
        part, off = estimates_of((coarse, mesh))["approach"], OFF_MESH * min(1.0, off_mesh(mesh) / OFF_FROM)
        part = replace(part, mesh=part.mesh + off, **vars(region["approach"]))
        solved[mesh.contact.load] = SolvedLoad(mesh, {"approach": part}, off)
    return solved, len({id(part.bodies) for part in third})


def _refined(solved: dict[float, SolvedLoad], wanted: Wanted) -> dict[float, SolvedLoad]:
    """The loads whose approach is too uncertain or whose verdict is undecided, each solved on its own meshes."""
    refined = {}
    for number, (load, (mesh, estimates, _)) in enumerate(solved.items()):
        if wanted.is_met(mesh, estimates):
            continue
        step = part_of(wanted.progress, number / len(solved), (number + 1) / len(solved))
        try:
            single = solve_reference(mesh.contact, wanted._replace(progress=step))
        except InputError:  # an ellipse too wide for its own mesh: the result on its neighbour's stays
            continue
        refined[load] = SolvedLoad(single.meshes[-1], single.estimates)
    return refined
