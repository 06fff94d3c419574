"""One contact both ways: Hertz's closed forms and finite elements on the meshed bodies."""

import math
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any, Literal

import numpy as np

from analytic.contact.geometry import pocket_contact
from analytic.contact.hertz import contact_modulus, hertz_contact, relative_curvatures
from analytic.errors import InputError, require_non_negative
from analytic.scene import Contact, Pair, Scene
from fembearing.compare.contact.approach_curve import ApproachCurve, approach_over_load
from fembearing.compare.contact.columns import VERDICT, contact_dataset, contact_html
from fembearing.compare.contact.corrected import CorrectedHertz, corrected_hertz
from fembearing.compare.contact.pressure_profile import Profiles, profiles_of
from fembearing.compare.contact.reference import COMPARED, FORMAL_ORDERS, Estimates, solve_reference
from fembearing.compare.contact.ring import RingStructure, structure_of_ring
from fembearing.compare.contact.uncertainty import Estimate
from fembearing.compare.contact.verdict import Verdict, could_be_decided, verdict_on, worst
from fembearing.compare.contact.warnings import near_shoulder, sheet_warning, shoulder_warning, solve_warnings
from fembearing.compare.torque.heaviest_ball import heaviest_contact
from fembearing.fem.measure import STRIP, Quantities
from fembearing.fem.solution import MeshSolution
from fembearing.memory import peak_memory
from fembearing.mesh.meshfile import write_body
from fembearing.mesh.recipe import Geometry, Recipe, load_recipe
from fembearing.mesh.ring import known_ring
from fembearing.plain import plain
from fembearing.progress import Progress, silent

Shape = Geometry | Literal["ring"]  # "ring": the contact as it is really, and apart from it what the ring adds
RECIPES: dict[Shape, str] = {"real": "race", "hertzian": "hertzian", "wall": "wall", "ring": "race"}
POCKET_LOAD = 28.0  # N: the largest ball-cage force that the paper reports
SHOWN_OF_A_SHEET = ("approach",)  # what its bending changes, and stiffness follows from it


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactSolution:
    """A contact by production formula and by finite elements.

    Quantities are those of `Quantities`; estimates, discrepancies and verdicts are keyed by their names. Verdicts are
    on Hertz as it is: the torque stands on it, and the correction comes from these same finite elements.
    """

    contact: Contact
    geometry: Shape
    tolerance: float
    hertz: Quantities
    estimates: dict[str, Estimate]
    shoulder: dict[str, Estimate]  # keyed by the names of `ShoulderLoad`; empty where the contact ends before it
    meshes: tuple[MeshSolution, ...]  # coarse to fine
    seconds: float
    warnings: tuple[str, ...]
    valid: bool
    ring: RingStructure | None = None  # apart from the contact: in no quantity, not judged; None where not computed
    corrected: CorrectedHertz | None = None  # None where the correction's fit does not reach
    approach_curve: ApproachCurve
    pressure_profile: Profiles
    peak_memory: int | None  # of the process when the contact was solved, bytes

    @property
    def reference(self) -> Quantities:
        """What all meshes say together."""
        return Quantities(**{name: part.value for name, part in self.estimates.items()})

    @property
    def discrepancy(self) -> dict[str, float]:
        """Production over reference minus one."""
        return {name: getattr(self.hertz, name) / part.value - 1 for name, part in self.estimates.items()}

    @property
    def interpolation_error(self) -> dict[str, float]:
        """Corrected Hertz over reference minus one, on a contact that the fit has not seen; empty where it ends."""
        if self.corrected is None:
            return {}
        values = vars(self.corrected.quantities)
        return {name: values[name] / part.value - 1 for name, part in self.estimates.items()}

    @property
    def verdicts(self) -> dict[str, Verdict]:
        return {
            name: verdict_on(getattr(self.hertz, name), part, tolerance=self.tolerance, valid=self.valid)
            for name, part in self.estimates.items()
        }

    @property
    def verdict(self) -> Verdict:
        """The worst of all quantities."""
        return worst(self.verdicts.values())

    @property
    def judged(self) -> bool:
        """A sheet is shown beside the thick seat, not judged: Hertz's half space is not made for it."""
        return self.geometry != "wall"

    @property
    def shown_verdict(self) -> str:
        """The verdict; "shown" of a contact that is not judged."""
        return self.verdict if self.judged else "shown"

    @property
    def rung(self) -> str:
        part = "half of the contact, " if self.meshes[-1].pair.footprint.half else ""
        return f"finite elements, {self.geometry}, {part}{self.meshes[-1].unknowns} unknowns"

    @property
    def centroid(self) -> float:
        """y of the load's centroid, m: off the contact's centre where one shoulder cuts it off."""
        return self.shoulder["centroid"].value if self.shoulder else 0.0

    @property
    def shoulders(self) -> tuple[float, ...]:
        """y of the shoulders that cut the contact off, m: the nearer one's is above 0, the farther one's below."""
        if not self.shoulder:
            return ()
        below, above = self.meshes[-1].pair.footprint.room
        return tuple(y for y in (-below, above) if math.isfinite(y))

    @property
    def strip_width(self) -> float:
        """Of the strip beside the nearer shoulder whose load is shown, m."""
        return STRIP * self.contact.shoulder

    @property
    def hertz_line_load(self) -> float:
        """Greatest line load of Hertz's ellipse, 3 Q/(4 b), N/m: the pressure summed along rolling, at its centre."""
        return 3 * self.contact.load / (4 * self.hertz.semi_axis_transverse)

    def write_meshes(self, folder: Path) -> dict[str, Path]:
        """Write both bodies of the finest mesh with the pressure, Pa, as .vtu; "upper" and "lower" to their paths."""
        finest, written = self.meshes[-1], {}
        for side, body in (("upper", finest.pair.upper), ("lower", finest.pair.lower)):
            pressure = np.zeros(body.mesh.doflocs.shape[1])
            # A node without force is open: what the fit of nodal values leaves there is noise.
            pressure[body.touching] = np.where(finest.force > 0, finest.pressure, 0.0)
            written[side] = folder / f"{self.contact.pair}-{self.geometry}-{side}.vtu"
            write_body(written[side], body, pressure=pressure)
        return written

    def to_json(self) -> dict[str, Any]:
        """The contact as plain types; SI, discrepancies and uncertainties relative."""
        return {
            "pair": self.contact.pair,
            "geometry": self.geometry,
            "load": self.contact.load,
            "contact_angle": self.contact.contact_angle,
            "fe": asdict(self.reference),
            "uncertainty": {name: part.total for name, part in self.estimates.items()},
            "hertz": asdict(self.hertz),
            "discrepancy": self.discrepancy,
            "corrected": self.corrected
            and {
                "values": asdict(self.corrected.quantities),
                "uncertainty": self.corrected.uncertainty,
                "interpolation_error": self.interpolation_error,
            },
            "verdict": self.shown_verdict,
            "judged": self.judged,
            "rung": self.rung,
            "meshes": [
                {"level": mesh.level, "unknowns": mesh.unknowns, "seconds": mesh.seconds} for mesh in self.meshes
            ],
            "ring": None if self.ring is None else self.ring.to_json(),
            "convergence": {
                name: {
                    "values": list(part.values),
                    "order": part.order,
                    "grid_convergence_index": part.index,
                    "formal_order": None if self.shoulder else FORMAL_ORDERS[name],  # a cut edge has none
                    "richardson": part.richardson,
                    "mesh": part.mesh,
                    "beyond": part.beyond,
                    "domain": part.domain,
                }
                for name, part in self.estimates.items()
            },
            "pressure_profile": plain(self.pressure_profile),
            "approach_curve": plain(self.approach_curve),
            "shoulder": self._shoulder_to_json(),
            "cost": {"seconds": self.seconds, "unknowns": self.meshes[-1].unknowns, "peak_memory": self.peak_memory},
            "warnings": list(self.warnings),
        }

    def columns(self) -> dict[str, float]:
        """The values of `fembearing.compare.contact.columns.COLUMNS`."""
        return {
            "load": self.contact.load,
            "contact_angle": self.contact.contact_angle,
            **vars(self.reference),
            **{f"uncertainty_{name}": part.total for name, part in self.estimates.items()},
            **{f"hertz_{name}": value for name, value in vars(self.hertz).items()},
            **{f"discrepancy_{name}": value for name, value in self.discrepancy.items()},
            "unknowns": float(self.meshes[-1].unknowns),
        }

    def to_xarray(self) -> Any:
        """An xarray.Dataset of what is compared, with units."""
        attributes = {
            "pair": self.contact.pair,
            "geometry": self.geometry,
            "rung": self.rung,
            "tolerance": self.tolerance,
            VERDICT: self.shown_verdict,
            "warnings": "\n".join(self.warnings),
        }
        return contact_dataset(self.columns(), attributes)

    def _repr_html_(self) -> str:
        """A table in a notebook."""
        caption = f"{self.contact.pair}, {self.geometry}, {self.contact.load:.4g} N: {self.shown_verdict}"
        return contact_html(self.columns(), caption)

    def _shoulder_to_json(self) -> dict[str, Any] | None:
        """What the contact does at the nearer shoulder that cuts it off, above y = 0; uncertainties relative."""
        if not self.shoulder:
            return None
        return {
            "sides": {"above" if y > 0 else "below": abs(y) for y in self.shoulders},  # of y = 0; distances, m
            "half": self.meshes[-1].pair.footprint.half,  # whether half of the contact is meshed, not a quarter
            "peak_pressure_at": 0.0,  # y, m: what "fe" and "hertz" compare, not the largest, which is at the edge
            "strip_width": self.strip_width,
            "hertz_line_load": self.hertz_line_load,
            **{
                name: {"fe": part.value, "uncertainty": part.total, "values": list(part.values), "order": part.order}
                for name, part in self.shoulder.items()
            },
        }


def solve_contact(
    scene: Scene,
    *,
    pair: Pair,
    load: float | None = None,
    tolerance: float | None = None,
    accuracy: float | None = None,
    geometry: Shape = "real",
    progress: Progress = silent,
) -> ContactSolution:
    """Solve one contact of a scene by finite elements and set Hertz beside it.

    load : of the ball, N; unless given the scene's largest, in the pocket 28 N
    tolerance : relative, for the verdict; the scene's unless given
    accuracy : asked of the finite elements, relative half-width of their 95 % intervals of semi-axes, peak pressure and
        approach; the tolerance unless given
    geometry : "real"; "hertzian" for the idealisation whose exact answer is Hertz; "wall", of a pocket alone, for
        the cage's sheet on its own support where "real" has a thick seat; "ring", of a race alone, for "real" and
        apart from it what the ring on a rigid seat adds to the approach
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for a contact that cannot be meshed, ConvergenceError for one that does not settle.
    """
    contact = contact_of(scene, pair=pair, load=load)
    recipe = recipe_of(geometry, pair=pair)
    if geometry == "ring":
        known_ring(contact)
    asked = scene.tolerance if tolerance is None else tolerance
    with traced_to_load(scene, pair=pair, load=load):
        found = compare_contact(contact, recipe=recipe, tolerance=asked, accuracy=accuracy, progress=progress)
        if geometry == "ring":
            progress(1.0, f"{pair}: ring")
            found = replace(with_ring(found), geometry=geometry)
    return replace(found, warnings=(*scene.warnings, *found.warnings))


def with_ring(found: ContactSolution) -> ContactSolution:
    """A solved race contact with what its ring adds. Raises InputError if the ring is not known or cannot be meshed."""
    recipe = recipe_of("ring", pair=found.contact.pair)
    return replace(found, ring=structure_of_ring(found.meshes, found.estimates["approach"], recipe=recipe))


def recipe_of(geometry: Shape, *, pair: Pair) -> Recipe:
    """How a geometry is meshed. Raises InputError for a sheet that would stand for a race."""
    if geometry == "wall" and pair != "pocket":
        raise InputError(f"geometry 'wall' is that of a pocket; the {pair} race has 'real' and 'hertzian'")
    return load_recipe(RECIPES[geometry])


def as_meshed(contact: Contact, *, recipe: Recipe) -> Contact:
    """The contact that a recipe meshes: the half spaces of Hertz have no shoulder."""
    return replace(contact, shoulder=math.inf) if recipe.geometry == "hertzian" else contact


def contact_of(scene: Scene, *, pair: Pair, load: float | None = None) -> Contact:
    """The contact of a scene that carries most: of its heaviest ball at any operating point, or at `load`, N.

    Raises InputError for the pocket of a scene without a cage.
    """
    if pair == "pocket":
        if scene.cage is None:
            raise InputError("the scene has no [cage], so there is no pocket: add an empty [cage] for the catalog's")
        return pocket_contact(scene.bearing, scene.cage, load=POCKET_LOAD if load is None else load)
    if load is not None:
        require_non_negative(ball_load=load)
    with traced_to_load(scene, pair=pair, load=load):
        contact = heaviest_contact(scene, pair)
    return contact if load is None else replace(contact, load=load)


@contextmanager
def traced_to_load(scene: Scene, *, pair: Pair, load: float | None) -> Iterator[None]:
    """Name the load that a person gave in front of what it leads to."""
    try:
        yield
    except InputError as problem:
        if load is None and pair != "pocket":
            cause = f"operation.axial_load = {scene.operation.axial_load.max():g} N"
            for name, unit in (("radial_load", "N"), ("moment", "N m")):
                largest = np.max(np.abs(getattr(scene.operation, name)))
                cause += f", operation.{name} = {largest:g} {unit}" if largest else ""
        else:
            cause = f"load = {POCKET_LOAD if load is None else load:g} N"
        raise InputError(f"{cause}: {problem}") from problem


def compare_contact(
    contact: Contact, *, recipe: Recipe, tolerance: float, accuracy: float | None = None, progress: Progress = silent
) -> ContactSolution:
    """Solve `contact` on three levels of `recipe` or more, until the accuracy is reached.

    accuracy : asked of the finite elements, relative; the tolerance unless given
    The first two levels predict which third one holds it; where that one does not, or leaves a verdict open that a
    finer mesh could decide, finer ones follow. A sheet has no verdict; its approach and stiffness settle it.
    """
    start = time.perf_counter()
    contact = as_meshed(contact, recipe=recipe)
    asked = tolerance if accuracy is None else accuracy
    hertz = hertz_quantities(contact)
    thin = recipe.geometry == "wall"
    watched = SHOWN_OF_A_SHEET if thin else COMPARED

    def is_open(estimates: Estimates) -> bool:
        return not thin and any(
            could_be_decided(getattr(hertz, name), part, tolerance=tolerance) for name, part in estimates.items()
        )

    found = solve_reference(
        contact,
        recipe=recipe,
        accuracy=asked,
        watched=watched,
        is_open=is_open,
        progress=progress,
    )
    meshes, estimates = found.meshes, found.estimates
    overrun = near_shoulder(meshes[-1], contact)
    warnings = (
        *((sheet_warning(contact),) if thin else ()),
        *((shoulder_warning(contact, found),) if overrun else ()),
        *solve_warnings([(meshes[-1], estimates)], accuracy=asked, watched=watched, thin=thin),
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
        shoulder=found.shoulder,
        meshes=meshes,
        seconds=time.perf_counter() - start,
        warnings=(*warnings, *beyond),
        corrected=corrected,
        approach_curve=approach_over_load(contact, hertz=hertz, correctable=correctable),
        pressure_profile=profiles_of(meshes[-1], hertz),
        peak_memory=peak_memory(),
        valid=not thin and not overrun,
    )


def is_correctable(contact: Contact, geometry: Shape) -> bool:
    """Whether the correction for finite geometry is of such a contact: ball and race, as they really are."""
    return geometry in ("real", "ring") and contact.pair != "pocket"


def hertz_quantities(contact: Contact) -> Quantities:
    """What the production model says of a contact."""
    curvature_x, curvature_y = relative_curvatures(contact)
    found = hertz_contact(
        curvature_x=curvature_x,
        curvature_y=curvature_y,
        load=contact.load,
        modulus=contact_modulus(contact.ball_material, contact.race_material),
    )
    return Quantities(
        semi_axis_rolling=float(found.semi_axis_x),
        semi_axis_transverse=float(found.semi_axis_y),
        peak_pressure=float(found.peak_pressure),
        approach=float(found.approach),
        stiffness=float(found.stiffness),
    )
