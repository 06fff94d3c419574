"""One contact both ways: Hertz's closed forms and finite elements on the meshed bodies."""

import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, fields, replace
from pathlib import Path
from typing import Any

import numpy as np

from analytic.contact import pocket_contact, race_contact
from analytic.equilibrium import thrust_equilibrium
from analytic.errors import InputError
from analytic.hertz import contact_modulus, hertz_contact, relative_curvatures
from analytic.scene import Contact, Pair, Scene
from fembearing.compare.provenance import peak_memory
from fembearing.compare.uncertainty import FORMAL_ORDER, Estimate, estimate
from fembearing.compare.verdict import Verdict, judge, worst
from fembearing.fem.measure import Quantities
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.mesh.meshfile import write_body
from fembearing.mesh.recipe import Geometry, Recipe, load_recipe

RECIPES: dict[Geometry, str] = {"real": "race", "hertzian": "hertzian", "wall": "wall"}
POCKET_LOAD = 28.0  # N: the largest ball-cage force that the paper reports
EDGE_OF_GROOVE = 1.05  # an ellipse this near its shoulder, in semi-axes, is no longer Hertz's
ENOUGH = 0.2  # mesh uncertainty, as a share of the tolerance, at which no finer mesh is called for
FEWEST = 3  # meshes
SHOWN_OF_A_SHEET = ("approach", "stiffness")  # what its bending changes

Progress = Callable[[float, str], None]


def silent(_share: float, _step: str) -> None:
    """Progress that nobody watches."""


def part_of(progress: Progress, begin: float, end: float) -> Progress:
    """Progress of a part of the work, which takes the whole from one share to another."""
    return lambda share, step: progress(begin + share * (end - begin), step)


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactSolution:
    """A contact by production formula and by finite elements.

    Quantities are those of `Quantities`; estimates, discrepancies and verdicts are keyed by their names.
    """

    contact: Contact
    geometry: Geometry
    tolerance: float
    hertz: Quantities
    estimates: dict[str, Estimate]
    meshes: tuple[MeshSolution, ...]  # coarse to fine
    seconds: float
    warnings: tuple[str, ...]
    valid: bool

    @property
    def reference(self) -> Quantities:
        return self.meshes[-1].quantities

    @property
    def discrepancy(self) -> dict[str, float]:
        """Production over reference minus one."""
        return {name: getattr(self.hertz, name) / part.value - 1 for name, part in self.estimates.items()}

    @property
    def verdicts(self) -> dict[str, Verdict]:
        return {
            name: _verdict(part, formula=getattr(self.hertz, name), tolerance=self.tolerance, valid=self.valid)
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
    def rung(self) -> str:
        return f"finite elements, {self.geometry}, {self.meshes[-1].unknowns} unknowns"

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
            "verdict": self.verdict,
            "rung": self.rung,
            "convergence": {
                name: {
                    "values": list(part.values),
                    "order": part.order,
                    "richardson": part.richardson,
                    "mesh": part.mesh,
                    "domain": part.domain,
                }
                for name, part in self.estimates.items()
            },
            "cost": {"seconds": self.seconds, "unknowns": self.meshes[-1].unknowns, "peak_memory": peak_memory()},
            "warnings": list(self.warnings),
        }


def solve_contact(
    scene: Scene,
    *,
    pair: Pair,
    load: float | None = None,
    tolerance: float | None = None,
    geometry: Geometry = "real",
    progress: Progress = silent,
) -> ContactSolution:
    """Solve one contact of a scene by finite elements and set Hertz beside it.

    load : of the ball, N; unless given the scene's largest, in the pocket 28 N
    tolerance : relative, for the verdict; the scene's unless given
    geometry : "real"; "hertzian" for the idealisation whose exact answer is Hertz; "wall", of a pocket alone, for
        the cage's sheet on its own support where "real" has a thick seat
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for a contact that cannot be meshed, ConvergenceError for one that does not settle.
    """
    contact = contact_of(scene, pair=pair, load=load)
    if geometry == "wall" and pair != "pocket":
        raise InputError(f"geometry 'wall' is that of a pocket; the {pair} race has 'real' and 'hertzian'")
    recipe = load_recipe(RECIPES[geometry])
    asked = scene.tolerance if tolerance is None else tolerance
    with traced_to_load(scene, pair=pair, load=load):
        found = compare_contact(contact, recipe=recipe, tolerance=asked, progress=progress)
    return replace(found, warnings=(*scene.warnings, *found.warnings))


def contact_of(scene: Scene, *, pair: Pair, load: float | None = None) -> Contact:
    """The contact of a scene that carries most: at its operating point of largest ball load, or at `load`, N.

    Raises InputError for the pocket of a scene without a cage.
    """
    if pair == "pocket":
        if scene.cage is None:
            raise InputError("the scene has no [cage], so there is no pocket: add an empty [cage] for the catalog's")
        return pocket_contact(scene.bearing, scene.cage, load=POCKET_LOAD if load is None else load)
    balls = thrust_equilibrium(scene.bearing, scene.contact_angle, axial_load=scene.operation.axial_load)
    point = int(np.argmax(balls.ball_load))
    with traced_to_load(scene, pair=pair, load=load):
        return race_contact(
            scene.bearing,
            pair,
            contact_angle=float(balls.contact_angle[point]),
            ball_load=float(balls.ball_load[point]) if load is None else load,
        )


@contextmanager
def traced_to_load(scene: Scene, *, pair: Pair, load: float | None) -> Iterator[None]:
    """Name the load that a person gave in front of what it leads to."""
    try:
        yield
    except InputError as problem:
        if load is None and pair != "pocket":
            cause = f"operation.axial_load = {scene.operation.axial_load.max():g} N"
        else:
            cause = f"load = {POCKET_LOAD if load is None else load:g} N"
        raise InputError(f"{cause}: {problem}") from problem


def compare_contact(
    contact: Contact, *, recipe: Recipe, tolerance: float, progress: Progress = silent
) -> ContactSolution:
    """Solve `contact` on ever finer levels of `recipe`, three at least, until the tolerance asks for no more.

    That is when the mesh uncertainty is a small share of it and no verdict is left that a finer mesh could decide.
    A sheet has no verdict; its approach and stiffness settle it.
    """
    start = time.perf_counter()
    work = np.cumsum([level**3 for level in recipe.levels[: FEWEST + 1]])
    progress(0.0, f"{contact.pair}: size of the contact")
    second = fitted_solution(contact, recipe=recipe)
    semi_axes = second.pair.semi_axes
    hertz = hertz_quantities(contact)
    thin = recipe.geometry == "wall"
    meshes: list[MeshSolution] = []
    estimates: dict[str, Estimate] = {}
    domain: dict[str, float] = {}
    for number, level in enumerate(recipe.levels):
        progress(min(work[max(number - 1, 0)] / work[-1], 0.95), f"{contact.pair}: mesh {number + 1}")
        known = second if level == second.level else None
        meshes.append(known or solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=semi_axes))
        if len(meshes) < FEWEST:
            continue
        estimates = estimates_of(meshes)
        watched = [estimates[name] for name in (SHOWN_OF_A_SHEET if thin else estimates)]
        if max(part.mesh for part in watched) > ENOUGH * tolerance and level != recipe.levels[-1]:
            continue
        if not domain:
            domain = _far_boundary(meshes[-2], recipe=recipe, semi_axes=semi_axes, progress=progress)
        estimates = {name: replace(part, domain=domain[name]) for name, part in estimates.items()}
        if thin or not any(
            _is_open(part, formula=getattr(hertz, name), tolerance=tolerance) for name, part in estimates.items()
        ):
            break
    overrun = EDGE_OF_GROOVE * meshes[-1].quantities.semi_axis_transverse > contact.shoulder
    warnings = _warnings(contact, meshes[-1], estimates, overrun=overrun, thin=thin)
    return ContactSolution(
        contact=contact,
        geometry=recipe.geometry,
        tolerance=tolerance,
        hertz=hertz,
        estimates=estimates,
        meshes=tuple(meshes),
        seconds=time.perf_counter() - start,
        warnings=warnings,
        valid=not thin and not (overrun and recipe.geometry == "real"),
    )


def _far_boundary(
    mesh: MeshSolution, *, recipe: Recipe, semi_axes: tuple[float, float], progress: Progress
) -> dict[str, float]:
    """What the far boundary of a block still does to each quantity, relative; nothing for a body that has none.

    The outermost cells are taken off: what that changes, over the ratio of the two sizes less one, is what is left if
    it fades as one over the size.
    """
    if not mesh.pair.lower.far.size:
        return {part.name: 0.0 for part in fields(Quantities)}
    contact = mesh.contact
    progress(0.95, f"{contact.pair}: far boundary")
    trimmed = solve_on_mesh(
        contact, recipe=recipe, level=mesh.level, semi_axes=semi_axes, trimmed=True, upper=mesh.upper
    )
    ratio = _depth(mesh) / _depth(trimmed)
    return {
        part.name: abs(getattr(mesh.quantities, part.name) / getattr(trimmed.quantities, part.name) - 1) / (ratio - 1)
        for part in fields(Quantities)
    }


def _depth(mesh: MeshSolution) -> float:
    """How far the race or lower half space reaches down, m."""
    return -float(mesh.pair.lower.mesh.doflocs[2].min())


def _is_open(part: Estimate, *, formula: float, tolerance: float) -> bool:
    """Whether a quantity is undecided and a finer mesh could decide it: the far boundary's share it would not lower."""
    perfect = replace(part, mesh=0.0, values=part.values[-1:] * FEWEST, order=FORMAL_ORDER)
    now, then = (_verdict(each, formula=formula, tolerance=tolerance, valid=True) for each in (part, perfect))
    return now == "undecided" != then


def _verdict(part: Estimate, *, formula: float, tolerance: float, valid: bool) -> Verdict:
    return judge(
        discrepancy=formula / part.value - 1,
        uncertainty=part.total,
        tolerance=tolerance,
        ordered=part.order is not None,
        spread=part.spread,
        valid=valid,
    )


def estimates_of(meshes: Sequence[MeshSolution]) -> dict[str, Estimate]:
    """Each quantity on its finest mesh with its mesh uncertainty."""
    sizes = [1 / mesh.level for mesh in meshes]
    return {
        part.name: estimate([getattr(mesh.quantities, part.name) for mesh in meshes], sizes)
        for part in fields(Quantities)
    }


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


def _warnings(
    contact: Contact, finest: MeshSolution, estimates: dict[str, Estimate], *, overrun: bool, thin: bool
) -> tuple[str, ...]:
    found = []
    if thin and contact.wall is not None:
        found.append(
            f"{contact.pair}: the sheet of {contact.wall.thickness * 1e3:.3g} mm bends on its rim, which Hertz's half "
            "space does not know: compare with the stiffness, do not judge by it"
        )
    if overrun:
        found.append(
            f"{contact.pair}: the contact reaches {finest.quantities.semi_axis_transverse * 1e3:.3f} mm across, the "
            f"shoulder stands at {contact.shoulder * 1e3:.3f} mm: outside Hertz, and the pressure at that edge may "
            "exceed the one at the centre; lower the load or the contact angle"
        )
    unordered = [name for name, part in estimates.items() if part.order is None]
    if unordered:
        found.append(f"{contact.pair}: the meshes disagree without order in {', '.join(unordered)}")
    return tuple(found)
