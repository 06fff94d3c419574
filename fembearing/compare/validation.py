"""The main job: every contact of a scene, formula against finite elements, and what it does to the torque."""

import time
from dataclasses import dataclass
from typing import Any

from analytic.scene import Pair, Scene
from fembearing.compare.discrepancy import ContactSolution, Progress, silent, solve_contact
from fembearing.compare.provenance import peak_memory, provenance_of
from fembearing.compare.torque_change import TorqueChange, change_of_torque
from fembearing.compare.verdict import Verdict, worst
from fembearing.mesh.recipe import Geometry

RACES: tuple[tuple[Pair, Geometry], ...] = (("inner", "real"), ("outer", "real"))
POCKET: tuple[tuple[Pair, Geometry], ...] = (("pocket", "real"), ("pocket", "wall"))


@dataclass(frozen=True, kw_only=True, eq=False)
class Validation:
    """What `validate` found."""

    scene: Scene
    tolerance: float
    contacts: tuple[ContactSolution, ...]
    torque: TorqueChange | None  # None where the scene gives no friction coefficient
    seconds: float

    @property
    def judged(self) -> tuple[ContactSolution, ...]:
        """The contacts that Hertz's formulas are made for: a cage's sheet on its own support is shown, not judged."""
        return tuple(contact for contact in self.contacts if contact.geometry != "wall")

    @property
    def verdict(self) -> Verdict:
        """The worst of all contacts and quantities."""
        return worst(found for contact in self.judged for found in contact.verdicts.values())

    def to_json(self) -> dict[str, Any]:
        """The result as plain types, SI; discrepancies and uncertainties relative."""
        return {
            "verdicts": [
                {
                    "pair": contact.contact.pair,
                    "quantity": name,
                    "production": getattr(contact.hertz, name),
                    "reference": part.value,
                    "discrepancy": contact.discrepancy[name],
                    "uncertainty": part.total,
                    "exceeds_uncertainty": abs(contact.discrepancy[name]) > part.total,
                    "verdict": contact.verdicts[name],
                }
                for contact in self.judged
                for name, part in contact.estimates.items()
            ],
            "torque_change": None if self.torque is None else self.torque.to_json(),
            "torque": None if self.torque is None else self.torque.hertz.to_json(),
            "tolerance": self.tolerance,
            "contacts": [contact.to_json() for contact in self.contacts],
            "cost": {"seconds": self.seconds, "peak_memory": peak_memory()},
            "warnings": list(self.scene.warnings),
            "provenance": provenance_of(self.scene),
        }


def validate(scene: Scene, *, tolerance: float | None = None, progress: Progress = silent) -> Validation:
    """Check each contact of a scene: both races and, where the scene has a cage, its pocket.

    tolerance : relative; the scene's unless given
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for a scene that cannot be solved, ConvergenceError for a contact that does not settle.
    """
    start = time.perf_counter()
    asked = scene.tolerance if tolerance is None else tolerance
    jobs = RACES if scene.cage is None else RACES + POCKET
    contacts = []
    for number, (pair, geometry) in enumerate(jobs):

        def report(share: float, step: str, done: int = number) -> None:
            progress((done + share) / len(jobs), step)

        contacts.append(solve_contact(scene, pair=pair, geometry=geometry, tolerance=asked, progress=report))
    has_friction = scene.friction_coefficient is not None
    torque = change_of_torque(scene, inner=contacts[0], outer=contacts[1]) if has_friction else None
    return Validation(
        scene=scene,
        tolerance=asked,
        contacts=tuple(contacts),
        torque=torque,
        seconds=time.perf_counter() - start,
    )
