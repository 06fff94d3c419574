"""One contact by Hertz's closed forms and by finite elements on the meshed bodies, and how far Hertz is off."""

import math
import os
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

import numpy as np

from analytic.any_scene import scene_by
from analytic.brief import Brief
from analytic.errors import require_non_negative, require_packages
from analytic.given import SceneOptions
from analytic.progress import Progress, silent
from analytic.scene import Contact, Pair, Scene
from analytic.scenefile.parts import Given, with_tolerance
from analytic.units import METRIC
from fembearing.check.contact.approach_curve import ApproachCurve, approach_over_load
from fembearing.check.contact.bearings import OfPair, place_of
from fembearing.check.contact.columns import COLUMNS, VERDICT, contact_dataset, contact_html, require_finite_results
from fembearing.check.contact.comparison_error import Comparison, comparison_of
from fembearing.check.contact.hertz import CorrectedHertz, corrected_hertz, hertz_quantities
from fembearing.check.contact.mesh_refinement import COMPARED, FORMAL_ORDERS, Estimates, Refinement
from fembearing.check.contact.pressure_profile import Profiles, profiles_of
from fembearing.check.contact.reference import solve_reference
from fembearing.check.contact.ring import RingStructure, structure_of_ring
from fembearing.check.contact.scene_contact import Shape, as_meshed, contact_of, recipe_of, traced_to_load
from fembearing.check.contact.verdict import Verdict, could_be_decided, verdict_on, worst
from fembearing.check.contact.warnings import (
    annular_warning,
    near_shoulder,
    sheet_warning,
    shoulder_warning,
    solve_warnings,
)
from fembearing.check.memory import peak_memory
from fembearing.fem.measure import STRIP, Quantities
from fembearing.fem.nodal_stress import stress_at_nodes, von_mises
from fembearing.fem.solution import MeshSolution
from fembearing.fem.subsurface import Side, body_displacement, body_of
from fembearing.grid_convergence import Estimate
from fembearing.mesh.meshfile import write_body
from fembearing.mesh.recipe import Recipe
from fembearing.mesh.ring import known_ring

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SHOWN_OF_A_SHEET = ("approach",)  # what its bending changes; the stiffness follows from it


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactSolution(Brief):
    """A contact by the production formula and by finite elements.

    Estimates, discrepancies and verdicts are keyed by the field names of `Quantities`. The verdicts are on uncorrected
    Hertz: the torque is built on it, and the correction was fitted to these same finite elements.
    """

    contact: Contact
    geometry: Shape  # which shapes were meshed
    tolerance: float  # of the verdicts, relative
    hertz: Quantities
    estimates: dict[str, Estimate]
    shoulder: dict[str, Estimate]  # keyed by the names of `ShoulderLoad`; empty where the contact ends before it
    meshes: tuple[MeshSolution, ...]  # coarse to fine
    seconds: float
    warnings: tuple[str, ...]  # one line each
    valid: bool  # whether the verdicts count: no sheet, and no contact beyond its shoulder
    ring: RingStructure | None = None  # part of no quantity and not judged; None where not computed
    corrected: CorrectedHertz | None = None  # None outside the range of the correction's fit
    approach_curve: ApproachCurve
    pressure_profile: Profiles
    refinement: Refinement = "levels"  # how the error of the meshes was removed
    peak_memory: int | None  # of the process when the contact was solved, bytes
    bearing: OfPair | None = None  # of a pair; None: there is one, or both have this contact

    def __post_init__(self) -> None:
        """Raises InputError for a number that is not finite."""
        found = {COLUMNS[name].meaning: value for name, value in self.columns().items()}
        require_finite_results(found, of=f"{self.contact.pair} under {self.contact.load:g} N")

    def _facts(self) -> Iterator[str]:
        yield from (self.contact.pair, self.geometry, f"{self.contact.load:.4g} N", self.shown_verdict)
        yield f"approach {1e6 * self.reference.approach:.5g} um, Hertz {100 * self.discrepancy['approach']:+.2f} %"

    @property
    def reference(self) -> Quantities:
        """The finite-element values, extrapolated from all meshes."""
        return Quantities(**{name: part.value for name, part in self.estimates.items()})

    @property
    def discrepancy(self) -> dict[str, float]:
        """The production value over the reference, less one."""
        return {name: getattr(self.hertz, name) / part.value - 1 for name, part in self.estimates.items()}

    @property
    def interpolation_error(self) -> dict[str, float]:
        """Corrected Hertz over the reference, less one; not a contact of the fit's data. Empty outside its range."""
        if self.corrected is None:
            return {}
        values = vars(self.corrected.quantities)
        return {name: values[name] / part.value - 1 for name, part in self.estimates.items()}

    @property
    def comparisons(self) -> dict[str, Comparison]:
        """Hertz's value against the reference, in the unit of the quantity."""
        return {name: comparison_of(getattr(self.hertz, name), part) for name, part in self.estimates.items()}

    @property
    def exceeds_uncertainty(self) -> dict[str, bool]:
        """Whether the discrepancy is larger than the uncertainty of the reference."""
        return {name: abs(self.discrepancy[name]) > part.total for name, part in self.estimates.items()}

    @property
    def formal_orders(self) -> dict[str, float | None]:
        """The order at which each quantity should converge; None at a shoulder, as a cut edge has none."""
        return {name: None if self.shoulder else FORMAL_ORDERS[name] for name in self.estimates}

    @property
    def verdicts(self) -> dict[str, Verdict]:
        """The verdict on each of the five quantities, by its name."""
        return {
            name: verdict_on(getattr(self.hertz, name), part, tolerance=self.tolerance, valid=self.valid)
            for name, part in self.estimates.items()
        }

    @property
    def verdict(self) -> Verdict:
        """The worst verdict of all quantities."""
        return worst(self.verdicts.values())

    @property
    def judged(self) -> bool:
        """False for a sheet, which Hertz's half space does not describe: it is shown with the thick seat only."""
        return self.geometry != "wall"

    @property
    def shown_verdict(self) -> str:
        """The verdict; "shown" for a contact that is not judged."""
        return self.verdict if self.judged else "shown"

    @property
    def method(self) -> str:
        """How the reference was computed, in words."""
        part = "half of the contact, " if self.meshes[-1].pair.footprint.half else ""
        way = "corrected by a half-space twin, " if self.refinement == "twin" else ""
        return f"finite elements, {self.geometry}, {part}{way}{self.meshes[-1].unknowns} unknowns"

    @property
    def centroid(self) -> float:
        """y of the load's centroid, m: not 0 where one shoulder cuts the contact off."""
        return self.shoulder["centroid"].value if self.shoulder else 0.0

    @property
    def shoulders(self) -> tuple[float, ...]:
        """y of the shoulders that cut the contact off, m."""
        if not self.shoulder:
            return ()
        below, above = self.meshes[-1].pair.footprint.shoulders
        return tuple(y for y in (-below, above) if math.isfinite(y))

    @property
    def sides(self) -> dict[str, float]:
        """Distance from y = 0, m, of each shoulder that cuts the contact off: "above" and "below"."""
        return {"above" if y > 0 else "below": abs(y) for y in self.shoulders}

    @property
    def strip_width(self) -> float:
        """Width of the strip next to the nearer shoulder whose load is shown, m."""
        return STRIP * self.contact.nearer_shoulder

    @property
    def hertz_line_load(self) -> float:
        """Greatest line load of Hertz's ellipse, 3 Q/(4 b), N/m: the pressure summed along rolling, at its centre."""
        return 3 * self.contact.load / (4 * self.hertz.semi_axis_transverse)

    @property
    def stem(self) -> str:
        """How the names of its files begin."""
        return f"{f'{self.bearing}-' if self.bearing else ''}{self.contact.pair}-{self.geometry}"

    def plot(self) -> "Figure":
        """Pressure along both axes by finite elements and by Hertz, as the report has it.

        Returns
        -------
        matplotlib.figure.Figure
            GPa over the position in semi-axes; below, the nodes less Hertz.

        Raises
        ------
        MissingPackageError
            Matplotlib is not installed.
        """
        require_packages("a figure", "matplotlib")
        from fembearing.check.contact.figure import DrawnPressure, pressure_figure

        place = place_of(self.contact.pair, self.geometry, self.bearing)
        drawn = DrawnPressure(
            title=f"{place.capitalize()}\n{METRIC.force.written(self.contact.load, '.4g')}",
            profiles=self.pressure_profile,
            hertz=self.hertz,
            fe=self.reference,
            shoulders=self.shoulders,
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
        """The values of `fembearing.check.contact.columns.COLUMNS`, SI."""
        return {
            "load": self.contact.load,
            "contact_angle": self.contact.contact_angle,
            **vars(self.reference),
            **{f"uncertainty_{name}": part.total for name, part in self.estimates.items()},
            **{f"hertz_{name}": value for name, value in vars(self.hertz).items()},
            **{f"discrepancy_{name}": value for name, value in self.discrepancy.items()},
            "unknowns": float(self.meshes[-1].unknowns),
        }

    def to_dataset(self) -> Any:
        """An xarray.Dataset of what is compared, with units."""
        attributes = {
            "pair": self.contact.pair,
            "geometry": self.geometry,
            "rung": self.method,
            "tolerance": self.tolerance,
            VERDICT: self.shown_verdict,
            "warnings": "\n".join(self.warnings),
        }
        return contact_dataset(self.columns(), attributes)

    def _repr_html_(self) -> str:
        """A table in a notebook."""
        caption = f"{self.contact.pair}, {self.geometry}, {self.contact.load:.4g} N: {self.shown_verdict}"
        return contact_html(self.columns(), caption)


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
    with traced_to_load(scene, pair=pair, load=load):
        solution = compare_contact(contact, recipe=recipe, tolerance=tolerance, accuracy=accuracy, progress=progress)
        if geometry == "ring":
            progress(1.0, f"{pair}: ring")
            solution = replace(with_ring(solution), geometry=geometry)
    return replace(solution, warnings=(*scene.warnings, *solution.warnings))


def with_ring(solution: ContactSolution) -> ContactSolution:
    """A solved race contact with what its ring adds. Raises InputError if the ring is not known or cannot be meshed."""
    recipe = recipe_of("ring", pair=solution.contact.pair)
    return replace(solution, ring=structure_of_ring(solution.meshes, solution.estimates["approach"], recipe=recipe))


def compare_contact(
    contact: Contact, *, recipe: Recipe, tolerance: float, accuracy: float | None = None, progress: Progress = silent
) -> ContactSolution:
    """Solve `contact` on two levels of `recipe` or more, until the accuracy is reached.

    accuracy : required of the finite elements, relative; the tolerance unless given
    Finer levels follow where one misses the accuracy, or leaves a verdict undecided that a finer mesh could decide. A
    sheet has no verdict; only its approach and stiffness must reach the accuracy.
    """
    start = time.perf_counter()
    contact = as_meshed(contact, recipe=recipe)
    accuracy = tolerance if accuracy is None else accuracy
    hertz = hertz_quantities(contact)
    thin = recipe.geometry == "wall"
    quantities = SHOWN_OF_A_SHEET if thin else COMPARED

    def undecided(estimates: Estimates) -> bool:
        return not thin and any(
            could_be_decided(getattr(hertz, name), part, tolerance=tolerance) for name, part in estimates.items()
        )

    reference = solve_reference(
        contact,
        recipe=recipe,
        accuracy=accuracy,
        quantities=quantities,
        undecided=undecided,
        progress=progress,
    )
    meshes, estimates = reference.meshes, reference.estimates
    overrun = near_shoulder(meshes[-1], contact)
    annular = annular_warning(meshes[-1], hertz=hertz.peak_pressure) if thin else ""
    warnings = (
        *((sheet_warning(contact),) if thin else ()),
        *((annular,) if annular else ()),
        *((shoulder_warning(contact, reference),) if overrun else ()),
        *solve_warnings([(meshes[-1], estimates)], accuracy=accuracy, quantities=quantities, thin=thin),
    )
    corrected, beyond = None, ()
    correctable = is_correctable(contact, recipe.geometry)
    if correctable:
        corrected, beyond = corrected_hertz(contact, hertz=hertz)
    return ContactSolution(
        contact=contact,
        geometry=recipe.geometry,
        tolerance=tolerance,
        hertz=hertz,
        estimates=estimates,
        shoulder=reference.shoulder,
        meshes=meshes,
        seconds=time.perf_counter() - start,
        warnings=(*warnings, *beyond),
        corrected=corrected,
        approach_curve=approach_over_load(contact, hertz=hertz, correctable=correctable),
        pressure_profile=profiles_of(meshes[-1], hertz),
        refinement=reference.refinement,
        peak_memory=peak_memory(),
        valid=not thin and not overrun,
    )


def is_correctable(contact: Contact, geometry: Shape) -> bool:
    """Whether the correction for finite geometry applies: to ball and race in their true shapes."""
    return geometry in ("real", "ring") and contact.pair != "pocket"
