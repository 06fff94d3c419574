"""What accuracy costs in a scene: every rung of every ladder, with its error, its bound, its seconds and its memory."""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from analytic.errors import InputError, require_positive
from analytic.scene import Scene
from fembearing.compare.contact.scene_contact import RECIPES, contact_of
from fembearing.compare.cost.cage_ladder import cage_question
from fembearing.compare.cost.contact_ladder import measured_contact
from fembearing.compare.cost.formula_ladders import (
    friction_question,
    hertz_question,
    load_question,
    roughness_question,
)
from fembearing.compare.cost.ladder import Ladder, Question, measured
from fembearing.memory import peak_memory
from fembearing.mesh.recipe import load_recipe
from fembearing.progress import Progress, part_of, silent
from fembearing.provenance import provenance_of

QUESTIONS: tuple[tuple[str, Callable[[Scene], Question]], ...] = (
    ("Hertz contact", hertz_question),
    ("load of the heaviest ball", load_question),
    ("friction torque", friction_question),
    ("roughness", roughness_question),
    ("cage torque", cage_question),
)
FORMULAS = 0.4  # of the whole, for the progress alone


@dataclass(frozen=True, kw_only=True, eq=False)
class Cost:
    """What `measure_cost` found."""

    scene: Scene
    tolerance: float
    ladders: tuple[Ladder, ...]
    seconds: float

    def to_json(self) -> dict[str, Any]:
        """The result as plain types; SI, errors relative."""
        return {
            "ladders": [ladder.to_json() for ladder in self.ladders],
            "tolerance": self.tolerance,
            "cost": {"seconds": self.seconds, "peak_memory": peak_memory()},
            "warnings": list(self.scene.warnings),
            "provenance": provenance_of(self.scene),
        }


def measure_cost(scene: Scene, *, tolerance: float | None = None, progress: Progress = silent) -> Cost:
    """Error and time of every rung of a scene's ladders, in one run.

    tolerance : relative, for the choice; the scene's unless given
    progress : called with the share done, 0 to 1, and a word on the step at hand
    A rung that cannot solve the scene is shown with the reason, and so is a ladder that the scene does not have. Raises
    InputError for a scene without a contact.
    """
    start = time.perf_counter()
    asked = scene.tolerance if tolerance is None else tolerance
    require_positive(tolerance=asked)
    contact = contact_of(scene, pair="inner")  # refuses a scene that has none
    ladders = []
    for number, (quantity, question) in enumerate(QUESTIONS):
        progress(FORMULAS * number / len(QUESTIONS), quantity)
        try:
            ladders.append(measured(question(scene), tolerance=asked))
        except InputError as reason:
            ladders.append(Ladder(quantity=quantity, reference="none", rungs=(), absent=str(reason)))
    recipe = load_recipe(RECIPES["real"])
    ladders.append(measured_contact(contact, recipe=recipe, tolerance=asked, progress=part_of(progress, FORMULAS, 1.0)))
    return Cost(scene=scene, tolerance=asked, ladders=tuple(ladders), seconds=time.perf_counter() - start)
