"""What accuracy costs in a scene: every method of every ladder, with its error, bound, seconds and memory."""

import time
from collections.abc import Callable
from dataclasses import dataclass

from analytic.errors import InputError, require_positive
from analytic.progress import Progress, part_of, silent
from analytic.rows import Count
from analytic.scene import Scene
from fembearing.check.contact.scene_contact import RECIPES, contact_of
from fembearing.check.cost.cage_ladder import cage_methods
from fembearing.check.cost.contact_ladder import measured_contact
from fembearing.check.cost.creep_ladder import creep_methods
from fembearing.check.cost.film_ladder import absent_films, measured_films
from fembearing.check.cost.formula_ladders import (
    friction_methods,
    hertz_methods,
    load_methods,
    roughness_methods,
    turning_methods,
)
from fembearing.check.cost.ladder import Ladder, UntimedLadder, measured, with_choices
from fembearing.check.memory import peak_memory
from fembearing.mesh.recipe import load_recipe
from fembearing.provenance import Provenance, provenance_of

FORMULA_LADDERS: tuple[tuple[str, Callable[[Scene], UntimedLadder]], ...] = (
    ("Hertz contact", hertz_methods),
    ("load of the heaviest ball", load_methods),
    ("friction torque", friction_methods),
    ("how balls turn", turning_methods),
    ("sliding in the contacts", creep_methods),
    ("roughness", roughness_methods),
    ("cage torque", cage_methods),
)
FORMULAS, FILMS = 0.3, 0.6  # shares of the time, only for the progress


@dataclass(frozen=True, kw_only=True)
class Spent:
    """What a computation took."""

    seconds: float
    peak_memory: Count | None  # of the process, bytes


@dataclass(frozen=True, kw_only=True, eq=False)
class Cost:
    """The measured ladders of a scene."""

    ladders: tuple[Ladder, ...]
    tolerance: float
    cost: Spent
    warnings: tuple[str, ...]  # of the scene, one line each
    provenance: Provenance


def measure_cost(scene: Scene, *, tolerance: float | None = None, progress: Progress = silent) -> Cost:
    """Error and time of every method of a scene's ladders, in one run.

    tolerance : relative, for the choice; the scene's unless given
    progress : called with the share done, 0 to 1, and the name of the current step
    A method that cannot solve the scene is shown with the reason, and so is a ladder that the scene does not have.
    Raises InputError for a scene without a contact.
    """
    start = time.perf_counter()
    tolerance = scene.tolerance if tolerance is None else tolerance
    require_positive(tolerance=tolerance)
    contact = contact_of(scene, pair="inner")  # raises for a scene without one
    ladders = []
    for number, (quantity, methods) in enumerate(FORMULA_LADDERS):
        progress(FORMULAS * number / len(FORMULA_LADDERS), quantity)
        try:
            ladders.append(measured(methods(scene), tolerance=tolerance))
        except InputError as reason:
            ladders.append(with_choices(Ladder(quantity=quantity, reference="none", methods=(), absent=str(reason))))
    try:
        ladders += measured_films(scene, tolerance=tolerance, progress=part_of(progress, FORMULAS, FILMS))
    except InputError as reason:
        ladders += map(with_choices, absent_films(reason))
    recipe = load_recipe(RECIPES["real"])
    rest = part_of(progress, FILMS, 1.0)
    ladders.append(measured_contact(contact, recipe=recipe, tolerance=tolerance, progress=rest))
    return Cost(
        tolerance=tolerance,
        ladders=tuple(ladders),
        cost=Spent(seconds=time.perf_counter() - start, peak_memory=peak_memory()),
        warnings=tuple(scene.warnings),
        provenance=provenance_of(scene),
    )
