"""The main job: both race contacts of a scene, formula against finite elements, and what it does to the torque."""

import time
from dataclasses import dataclass
from typing import Any

from analytic.scene import Pair, Scene
from analytic.torque import friction_torque
from fembearing.compare.discrepancy import ContactSolution, Progress, silent, solve_contact
from fembearing.compare.provenance import peak_memory, provenance_of
from fembearing.compare.torque_change import TorqueChange, change_of_torque
from fembearing.compare.verdict import Verdict, worst

RACES: tuple[Pair, ...] = ("inner", "outer")


@dataclass(frozen=True, kw_only=True, eq=False)
class Validation:
    """What `validate` found."""

    scene: Scene
    tolerance: float
    contacts: tuple[ContactSolution, ...]
    torque: TorqueChange | None  # None where the scene gives no friction coefficient
    seconds: float

    @property
    def verdict(self) -> Verdict:
        """The worst of all contacts and quantities."""
        return worst(found for contact in self.contacts for found in contact.verdicts.values())

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
                for contact in self.contacts
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
    """Check each race contact of a scene.

    tolerance : relative; the scene's unless given
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for a scene that cannot be solved, ConvergenceError for a contact that does not settle.
    """
    start = time.perf_counter()
    asked = scene.tolerance if tolerance is None else tolerance
    has_friction = scene.friction_coefficient is not None
    if has_friction:
        friction_torque(scene)  # refuses what it cannot model before anything is solved
    contacts = []
    for number, pair in enumerate(RACES):

        def report(share: float, step: str, done: int = number) -> None:
            progress((done + share) / len(RACES), step)

        contacts.append(solve_contact(scene, pair=pair, tolerance=asked, progress=report))
    inner, outer = contacts
    return Validation(
        scene=scene,
        tolerance=asked,
        contacts=(inner, outer),
        torque=change_of_torque(scene, inner=inner, outer=outer) if has_friction else None,
        seconds=time.perf_counter() - start,
    )
