"""One contact by Hertz's closed forms and by finite elements on the meshed bodies, and how far Hertz is off."""

import math
import os
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal, Unpack

import numpy as np
from annotated_types import MinLen
from threadpoolctl import threadpool_limits

from analytic.any_scene import scene_by
from analytic.brief import Brief, html_table
from analytic.columns import CONTACT, CONTACT_COLUMNS, VERDICT
from analytic.errors import require_non_negative, require_packages
from analytic.given import SceneOptions
from analytic.labelled import Labelled, dataset_of
from analytic.progress import Progress, silent
from analytic.rows import Count, NotNegative, Positive
from analytic.scene import Contact, Pair, Scene
from analytic.scenefile.parts import Given, with_tolerance
from analytic.units import METRIC
from fembearing.check.comparison import Comparison, ShownVerdict, worst
from fembearing.check.contact.hertz import (
    ApproachCurve,
    CorrectedHertz,
    Profiles,
    approach_over_load,
    beside_hertz,
    corrected_hertz,
    hertz_quantities,
    profiles_of,
)
from fembearing.check.contact.meshed_region import RingStructure, structure_of_ring
from fembearing.check.contact.reference import ORDER, solve_reference
from fembearing.check.contact.refinement import (
    COMPARED,
    FORMAL_ORDERS,
    Estimates,
    Reference,
    Refinement,
    Wanted,
)
from fembearing.check.contact.scene_contact import (
    OfPair,
    Shape,
    as_meshed,
    contact_of,
    place_of,
    recipe_of,
    traced_to_load,
)
from fembearing.check.contact.warnings import near_shoulder, sheet_warnings, shoulder_warning, solve_warnings
from fembearing.check.memory import peak_memory
from fembearing.fem.measure import STRIP, Quantities
from fembearing.fem.nodal_stress import stress_at_nodes
from fembearing.fem.solution import MeshSolution
from fembearing.fem.subsurface import Side, body_displacement, body_of, von_mises
from fembearing.mesh.recipe import Recipe
from fembearing.mesh.ring import known_ring

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN_OF_A_SHEET = ("approach",)  # what its bending changes; the stiffness follows from it


@dataclass(frozen=True, kw_only=True)
class MeshCost:
    """One mesh of a contact."""

    level: int
    unknowns: Count
    seconds: NotNegative


@dataclass(frozen=True, kw_only=True)
class AtShoulder:
    """A quantity at a shoulder, by finite elements."""

    reference: float
    relative_uncertainty: NotNegative  # 95 %
    values: tuple[float, ...]  # coarse to fine
    order: float | None


@dataclass(frozen=True, kw_only=True)
class Shoulder:
    """What a contact does at the shoulder that cuts it off, the nearer one of two."""

    sides: dict[Literal["above", "below"], float]  # distance of each shoulder from y = 0, m
    half: bool  # whether half of the contact is meshed, not a quarter
    peak_pressure_at: float  # y, m: where peak pressures are compared, not the largest, which is at the edge
    strip_width: float  # of the strip beside the shoulder whose load is shown, m
    hertz_line_load: Positive  # greatest of Hertz's ellipse, 3 Q/(4 b), N/m: pressure summed along rolling, at y = 0
    centroid: AtShoulder  # y of the load's centroid, m
    strip_share: AtShoulder  # of the load
    strip_line_load: AtShoulder  # mean over the strip, N/m

    @property
    def cuts(self) -> list[float]:
        """y of each shoulder that cuts the contact off, the nearer one first, m."""
        return sorted((y if side == "above" else -y for side, y in self.sides.items()), key=abs)


@dataclass(frozen=True, kw_only=True)
class ContactNumbers:
    """One contact by Hertz and by finite elements, SI; keyed by quantity: the names of `Quantities`.

    The verdicts are on uncorrected Hertz: the correction was fitted to these same finite elements.
    """

    pair: Pair
    geometry: Shape  # which shapes were meshed
    load: Positive  # of the ball, N
    contact_angle: float  # rad
    tolerance: NotNegative  # of the verdicts, relative
    quantities: dict[str, Comparison]
    formal_order: dict[str, float | None]  # of convergence; None at a shoulder, as a cut edge has none
    corrected: CorrectedHertz | None  # for finite geometry; None outside the range of the fit
    interpolation_error: dict[str, float]  # corrected Hertz over finite elements, less one; empty outside that range
    verdict: ShownVerdict  # the worst; shown: a sheet, which Hertz's half space does not describe
    method: str  # how the reference was computed, in words
    refinement: Refinement  # how the error of the meshes was removed
    meshes: Annotated[tuple[MeshCost, ...], MinLen(2)]  # coarse to fine
    ring: RingStructure | None = None  # part of no quantity and not judged; None where not computed
    pressure_profile: Profiles
    approach_curve: ApproachCurve
    shoulder: Shoulder | None  # None where the contact ends before it
    seconds: NotNegative
    peak_memory: Count | None  # of the process when the contact was solved, bytes
    warnings: tuple[str, ...]  # one line each
    bearing: OfPair | None = None  # of a pair; None: there is one, or both have this contact

    @property
    def judged(self) -> bool:
        """False for a sheet: it is shown with the thick seat only."""
        return self.geometry != "wall"

    @property
    def hertz(self) -> Quantities:
        """By Hertz."""
        return Quantities(**{name: each.production for name, each in self.quantities.items()})

    @property
    def reference(self) -> Quantities:
        """By finite elements, extrapolated from all meshes."""
        return Quantities(**{name: each.reference for name, each in self.quantities.items()})

    @property
    def estimates(self) -> Estimates:
        """Each quantity on its meshes."""
        return {name: each.study for name, each in self.quantities.items() if each.study is not None}


@dataclass(frozen=True, kw_only=True)
class SheetInSeries:
    """What the sheet of a pocket adds to the contact with a thick seat, as a spring in series."""

    stiffness: float  # k, N/m: load over the approach that the sheet adds
    uncertainty: float  # relative, 95 %


def sheet_in_series(seat: ContactNumbers, sheet: ContactNumbers) -> SheetInSeries | None:
    """From both models of a pocket under one load; None where the sheet adds no more than is uncertain."""
    thick, thin = (each.quantities["approach"] for each in (seat, sheet))
    added, off = thin.reference - thick.reference, thin.uncertainty + thick.uncertainty
    return SheetInSeries(stiffness=seat.load / added, uncertainty=off / added) if added > off else None


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactSolution(Brief):
    """The numbers of a contact, and the meshes on which it was solved."""

    numbers: ContactNumbers
    contact: Contact
    meshes: tuple[MeshSolution, ...]  # coarse to fine

    def _facts(self) -> Iterator[str]:
        found = self.numbers
        approach = found.quantities["approach"]
        yield from (found.pair, found.geometry, f"{found.load:.4g} N", found.verdict)
        yield f"approach {1e6 * approach.reference:.5g} um, Hertz {100 * approach.difference:+.2f} %"

    def with_numbers(self, **changes: Any) -> "ContactSolution":
        """The same contact with some of its numbers changed.

        Parameters
        ----------
        **changes : any
            Fields of `ContactNumbers`, SI.

        Returns
        -------
        ContactSolution
            On the same meshes.
        """
        return replace(self, numbers=replace(self.numbers, **changes))

    @property
    def stem(self) -> str:
        """How the names of its files begin."""
        found = self.numbers
        return f"{f'{found.bearing}-' if found.bearing else ''}{found.pair}-{found.geometry}"

    def plot(self) -> "Figure":
        """Pressure, GPa, along both axes over the position in semi-axes, as the report has it; below, nodes less Hertz.

        Raises MissingPackageError where Matplotlib is not installed.
        """
        require_packages("a figure", "matplotlib")
        from fembearing.check.contact.figure import DrawnPressure, pressure_figure

        found, shoulder = self.numbers, self.numbers.shoulder
        place = place_of(found.pair, found.geometry, found.bearing)
        drawn = DrawnPressure(
            title=f"{place.capitalize()}\n{METRIC.force.written(found.load, '.4g')}",
            profiles=found.pressure_profile,
            hertz=found.hertz,
            fe=found.reference,
            shoulders=() if shoulder is None else tuple(shoulder.cuts),
            is_half=self.meshes[-1].pair.footprint.half,
        )
        return pressure_figure([drawn], METRIC)

    def write_meshes(self, folder: Path) -> dict[str, Path]:
        """Write both bodies of the finest mesh with pressure and stress, Pa, and displacement, m, as .vtu.

        The stress is a symmetric tensor, with xx, yy, zz, xy, yz and xz at each node; von_mises is the equivalent one.

        Parameters
        ----------
        folder : Path
            Where both files go.

        Returns
        -------
        dict
            The paths, by "upper" and "lower".
        """
        from fembearing.mesh.meshfile import write_body  # with meshio: only a file pays for it

        finest = self.meshes[-1]
        written: dict[str, Path] = {}
        sides: tuple[Side, ...] = ("upper", "lower")
        for side in sides:
            body, material = body_of(finest, side)
            pressure = np.zeros(body.mesh.doflocs.shape[1])
            # A node without force does not touch: the fitted nodal pressure there is noise.
            pressure[body.touching] = np.where(finest.force > 0, finest.pressure, 0.0)
            displacement = body_displacement(finest, side=side)
            stress = stress_at_nodes(body.mesh, displacement, material)
            written[side] = folder / f"{self.stem}-{side}.vtu"
            fields = {"pressure": pressure, "displacement": displacement.T, "stress": stress.T}
            write_body(written[side], body, **fields, von_mises=von_mises(stress))
        return written

    def columns(self) -> dict[str, float]:
        """The values of `analytic.columns.CONTACT_COLUMNS`, SI."""
        compared = self.numbers.quantities
        return {
            "load": self.contact.load,
            "contact_angle": self.contact.contact_angle,
            **{name: each.reference for name, each in compared.items()},
            **{f"uncertainty_{name}": each.uncertainty / abs(each.reference) for name, each in compared.items()},
            **{f"hertz_{name}": each.production for name, each in compared.items()},
            **{f"discrepancy_{name}": each.difference for name, each in compared.items()},
            "unknowns": float(self.meshes[-1].unknowns),
        }

    def to_dataset(self) -> Any:
        """An xarray.Dataset of what is compared, without dimensions, with units and meanings as attributes."""
        found = self.numbers
        attributes = {
            "pair": found.pair,
            "geometry": found.geometry,
            "rung": found.method,
            "tolerance": found.tolerance,
            VERDICT: found.verdict,
            "warnings": "\n".join(found.warnings),
        }
        variables = {name: Labelled((), value, CONTACT_COLUMNS[name]) for name, value in self.columns().items()}
        return dataset_of(variables, coordinates={}, attributes=attributes)

    def _repr_html_(self) -> str:
        """A table for a notebook: a row for each quantity."""
        found, values = self.numbers, self.columns()
        rows = [
            [
                f"{each.meaning}, {each.unit}",
                f"{values[name]:.5g}",
                f"{100 * values[f'uncertainty_{name}']:.2g}",
                f"{values[f'hertz_{name}']:.5g}",
                f"{100 * values[f'discrepancy_{name}']:+.2f}",
            ]
            for name, each in CONTACT.items()
        ]
        heads = ["", "finite elements", "uncertainty, %", "Hertz", "Hertz off by, %"]
        return html_table(heads, rows, f"{found.pair}, {found.geometry}, {found.load:.4g} N: {found.verdict}")


def solve_contact(
    scene: Scene | str | os.PathLike[str],
    *,
    pair: Pair,
    load: float | None = None,
    tolerance: Given | None = None,
    accuracy: float | None = None,
    geometry: Shape = "real",
    progress: Progress = silent,
    **given: Unpack[SceneOptions],
) -> ContactSolution:
    """Solve one contact of a scene by finite elements and compare Hertz with it.

    Parameters
    ----------
    scene : Scene, str or path
        With a cage for the pair "pocket".
    pair : {"inner", "outer", "pocket"}
        What the ball touches.
    load : float, optional
        Of the ball, N, > 0; None: the scene's largest, and 28 N in the pocket.
    tolerance : float or str, optional
        Relative (dimensionless), for the verdict; None: the scene's.
    accuracy : float, optional
        Required of the finite elements: relative half-width of the 95 % intervals of semi-axes, peak pressure and
        approach (dimensionless); None: the tolerance.
    geometry : {"real", "hertzian", "wall", "ring"}
        "hertzian": the idealisation whose exact answer is Hertz; "wall", for a pocket only: the cage's sheet on its own
        support, where "real" has a thick seat; "ring", for a race only: "real", and separately what the ring on a rigid
        seat adds to the approach.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and the name of the current step.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    ContactSolution
        Both answers with the numerical uncertainty, SI, and the verdicts.

    Raises
    ------
    InputError
        The contact cannot be meshed.
    ConvergenceError
        It does not converge.

    Notes
    -----
    Sources: linear elasticity [Timoshenko1970]; uncertainty of the meshes [Roache1998], [Celik2008].
    """
    scene = scene_by(scene, given)
    contact = contact_of(scene, pair=pair, load=load)
    tolerance = scene.tolerance if tolerance is None else with_tolerance(scene, tolerance).tolerance
    require_non_negative(accuracy=tolerance if accuracy is None else accuracy)
    recipe = recipe_of(geometry, pair=pair)
    if geometry == "ring":
        known_ring(contact)
    with traced_to_load(scene, pair=pair, load=load), threadpool_limits(1, "blas"):
        solution = compare_contact(contact, recipe=recipe, tolerance=tolerance, accuracy=accuracy, progress=progress)
        if geometry == "ring":
            progress(1.0, f"{pair}: ring")
            solution = with_ring(solution).with_numbers(geometry=geometry)
    return solution.with_numbers(warnings=(*scene.warnings, *solution.numbers.warnings))


def with_ring(solution: ContactSolution) -> ContactSolution:
    """A solved race contact with what its ring adds. Raises InputError if the ring is not known or cannot be meshed."""
    recipe, approach = recipe_of("ring", pair=solution.contact.pair), solution.numbers.estimates["approach"]
    return solution.with_numbers(ring=structure_of_ring(solution.meshes, approach, recipe=recipe))


def compare_contact(
    contact: Contact, *, recipe: Recipe, tolerance: float, accuracy: float | None = None, progress: Progress = silent
) -> ContactSolution:
    """Solve `contact` on two levels of `recipe` or more, until the accuracy is reached.

    accuracy : required of the finite elements, relative; the tolerance unless given
    Finer levels follow where one misses the accuracy, or leaves a verdict undecided that a finer mesh could decide. A
    sheet has no verdict; only its approach and stiffness must reach the accuracy.
    """
    start = time.perf_counter()
    contact, geometry = as_meshed(contact, recipe=recipe), recipe.geometry
    accuracy = tolerance if accuracy is None else accuracy
    hertz = hertz_quantities(contact)
    thin = geometry == "wall"
    quantities = SHOWN_OF_A_SHEET if thin else COMPARED
    limit = None if thin else tolerance
    reference = solve_reference(contact, Wanted(recipe, accuracy, quantities, limit, progress=progress))
    meshes, finest = reference.meshes, reference.meshes[-1]
    overrun = near_shoulder(finest, contact)
    judged = () if thin else FORMAL_ORDERS
    compared = beside_hertz(hertz, reference.estimates, tolerance=tolerance, valid=not overrun, judged=judged)
    correctable = geometry == "real" and contact.pair != "pocket"  # ball and race in their true shapes
    corrected, beyond = corrected_hertz(contact, hertz=hertz) if correctable else (None, ())
    values = {} if corrected is None else vars(corrected.quantities)
    part = "half of the contact, " if finest.pair.footprint.half else ""
    by_pair = reference.refinement == "pair"
    orders = dict.fromkeys(FORMAL_ORDERS, ORDER) if by_pair else FORMAL_ORDERS
    way = "compliance of the pair, " if by_pair else ""
    numbers = ContactNumbers(
        pair=contact.pair,
        geometry=geometry,
        load=contact.load,
        contact_angle=contact.contact_angle,
        tolerance=tolerance,
        quantities=compared,
        formal_order={name: None if reference.shoulder else orders[name] for name in compared},
        corrected=corrected,
        interpolation_error={name: value / compared[name].reference - 1 for name, value in values.items()},
        verdict=worst(each.verdict for each in compared.values()),
        method=f"finite elements, {geometry}, {part}{way}{finest.unknowns} unknowns",
        refinement=reference.refinement,
        meshes=tuple(MeshCost(level=mesh.level, unknowns=mesh.unknowns, seconds=mesh.seconds) for mesh in meshes),
        pressure_profile=profiles_of(finest, hertz),
        approach_curve=approach_over_load(contact, hertz=hertz, correctable=correctable),
        shoulder=_shoulder(contact, reference, hertz),
        seconds=time.perf_counter() - start,
        peak_memory=peak_memory(),
        warnings=(
            *(sheet_warnings(finest, hertz=hertz.peak_pressure) if thin else ()),
            *((shoulder_warning(contact, reference),) if overrun else ()),
            *solve_warnings([(finest, reference.estimates)], accuracy=accuracy, quantities=quantities, thin=thin),
            *beyond,
        ),
    )
    return ContactSolution(numbers=numbers, contact=contact, meshes=meshes)


def _shoulder(contact: Contact, reference: Reference, hertz: Quantities) -> Shoulder | None:
    """The contact at the nearer shoulder that cuts it off; None where it ends before it."""
    if not reference.shoulder:
        return None
    footprint = reference.meshes[-1].pair.footprint
    ends: list[tuple[Literal["above", "below"], float]] = list(
        zip(("below", "above"), footprint.shoulders, strict=True)
    )
    return Shoulder(
        sides={side: y for side, y in ends if math.isfinite(y)},
        half=footprint.half,
        peak_pressure_at=0.0,
        strip_width=STRIP * contact.nearer_shoulder,
        hertz_line_load=3 * contact.load / (4 * hertz.semi_axis_transverse),
        **{
            name: AtShoulder(
                reference=part.value, relative_uncertainty=part.total, values=part.values, order=part.order
            )
            for name, part in reference.shoulder.items()
        },
    )
