"""The main job: every contact of a scene, formula against finite elements, and what it does to the torque."""

import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from analytic.cage.torque import CagePart
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Pair, Scene
from analytic.torque import friction_torque
from fembearing.compare.contact.comparison_error import WHY, comparison_of
from fembearing.compare.contact.discrepancy import ContactSolution, solve_contact, with_ring
from fembearing.compare.contact.scene_contact import contact_of
from fembearing.compare.contact.verdict import Verdict, worst
from fembearing.compare.cost.contact_ladder import contact_ladder_of
from fembearing.compare.cost.formula_ladders import SEED
from fembearing.compare.cost.ladder import Ladder
from fembearing.compare.cost.scene_cost import Cost, measure_cost
from fembearing.compare.hard.table import HardOutcome, run_hard_cases
from fembearing.compare.torque.cage_record import CageRecord, record_cage
from fembearing.compare.torque.catalogue import beside_catalogue
from fembearing.compare.torque.change import TorqueChange, change_of_torque
from fembearing.compare.torque.published import beside_paper
from fembearing.compare.torque.sensitivity import Sensitivity, sensitivity_of
from fembearing.memory import peak_memory
from fembearing.mesh.recipe import Geometry
from fembearing.progress import Progress, part_of, silent
from fembearing.provenance import provenance_of

KIND, FORMAT = "fembearing validation", 1  # what the JSON is; the number rises when a key changes its meaning
# Contacts with the seconds that they took on one machine, for the progress alone.
RACES: tuple[tuple[Pair, Geometry, float], ...] = (("inner", "real", 5.0), ("outer", "real", 4.0))
POCKET: tuple[tuple[Pair, Geometry, float], ...] = (("pocket", "real", 11.0), ("pocket", "wall", 10.0))  # seat, sheet
HARD_SECONDS, COST_SECONDS = 30.0, 45.0
INSTANTS = 400  # of a cage's motion that are kept
ENOUGH = 0.2  # uncertainty that is asked of a reference, as a share of the tolerance that it is to judge


@dataclass(frozen=True, kw_only=True, eq=False)
class Validation:
    """What was found. The first two contacts are the inner and the outer race; a pocket comes as seat and as sheet."""

    scene: Scene
    tolerance: float
    contacts: tuple[ContactSolution, ...]
    torque: TorqueChange | None  # None where the scene gives neither friction nor lubrication
    hard: tuple[HardOutcome, ...]  # empty unless they were asked for
    cost: Cost | None  # every ladder, measured; None unless that was asked for
    seconds: float
    production: FrictionTorque | None = None  # as the scene asks for it, its cage in motion; the change leaves that out
    sensitivity: Sensitivity | None = None  # None: not computed
    cage_records: tuple[CageRecord, ...] = ()  # of the slowest and the fastest point whose cage moved
    trouble: tuple[str, ...] = ()  # met while the report was written

    @property
    def ladders(self) -> tuple[Ladder, ...]:
        """All of the scene's where they were asked for, otherwise the methods that the check itself ran."""
        if self.cost is not None:
            return self.cost.ladders
        return tuple(contact_ladder_of(contact) for contact in self.contacts if contact.judged)

    @property
    def verdict(self) -> Verdict:
        """The worst of all quantities that are judged; a hard case that went wrong fails the whole."""
        if any(case.outcome == "wrong" for case in self.hard):
            return "fail"
        return worst(found for contact in self.contacts if contact.judged for found in contact.verdicts.values())

    @property
    def warnings(self) -> tuple[str, ...]:
        """Of the scene, of all contacts, of the torque and of the report, each once."""
        found = [warning for contact in self.contacts for warning in contact.warnings]
        torque = () if self.torque is None else (*self.torque.hertz.warnings, *self.torque.fitted.warnings)
        moved = () if self.moving_cage is None else self.moving_cage.warnings
        return tuple(dict.fromkeys([*found, *torque, *moved, *self.trouble]))

    @property
    def moving_cage(self) -> CagePart | None:
        """None where no cage moved."""
        part = None if self.production is None else self.production.cage
        return part if part is not None and any(part.motion) else None

    def to_json(self) -> dict[str, Any]:
        """The result as plain types, SI; discrepancies and uncertainties relative."""
        return {
            "kind": KIND,
            "format": FORMAT,
            "verdict": self.verdict,
            "verdicts": [
                {
                    "pair": contact.contact.pair,
                    "geometry": contact.geometry,
                    "quantity": name,
                    "production": getattr(contact.hertz, name),
                    "reference": part.value,
                    "discrepancy": contact.discrepancy[name],
                    "uncertainty": part.total,
                    "exceeds_uncertainty": abs(contact.discrepancy[name]) > part.total,
                    "comparison": comparison_of(getattr(contact.hertz, name), part).to_json(),
                    "verdict": contact.verdicts[name],
                }
                for contact in self.contacts
                if contact.judged
                for name, part in contact.estimates.items()
            ],
            "uncertainties": WHY,
            "torque_change": None if self.torque is None else self.torque.to_json(),
            "torque": None
            if self.torque is None
            else self.torque.hertz.to_json() | {"catalogue_band": beside_catalogue(self.scene).to_json()},
            "cage_motion": self._cage_to_json(),
            "published": beside_paper(self.scene, self.production).to_json(),
            "cage_records": [record.to_json(most=INSTANTS) for record in self.cage_records],
            "sensitivity": None if self.sensitivity is None else self.sensitivity.to_json(),
            "tolerance": self.tolerance,
            "contacts": [contact.to_json() for contact in self.contacts],
            "cost": {
                "measured": self.cost is not None,  # every ladder, with repeats; else the methods that the check ran
                "seconds": self.seconds,
                "peak_memory": peak_memory(),
                "ladders": [ladder.to_json() for ladder in self.ladders],
            },
            "hard": [outcome.to_json() for outcome in self.hard],
            "warnings": list(self.warnings),
            "provenance": provenance_of(self.scene, seeds=self._seeds),
        }

    @property
    def _seeds(self) -> dict[str, Sequence[int]]:
        """Of what was random in this check."""
        cage, surface = self.scene.cage, self.scene.surface
        found: dict[str, Sequence[int]] = {}
        if self.moving_cage is not None and cage is not None:
            found["motion of the cage"] = range(cage.seeds)
        if self.cost is not None and surface is not None and surface.autocorrelation is not None:
            found["generated surface"] = (SEED,)
        return found

    def _cage_to_json(self) -> list[dict[str, Any]] | None:
        """Each operating point; torque, start and block are None where the cage rests in closed form."""
        part, found = self.moving_cage, self.production
        if part is None or found is None:
            return None
        return [
            part.at(point)
            | {"inner_speed": float(found.inner_speed[point])}
            | {name: None if motion is None else getattr(motion, name) for name in ("torque", "start", "block")}
            | {"other": None if motion is None or motion.other is None else asdict(motion.other)}
            for point, motion in enumerate(part.motion)
        ]


def check_scene(
    scene: Scene,
    *,
    tolerance: float | None = None,
    hard: bool = False,
    cost: bool = False,
    progress: Progress = silent,
) -> Validation:
    """Check each race contact of a scene, and where it has a cage the pocket, in a thick seat and in its sheet.

    tolerance : relative; the scene's unless given
    hard : run the table of hard cases too
    cost : measure every method of every ladder too
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for a scene that cannot be solved, ConvergenceError for a contact that does not settle.
    """
    start = time.perf_counter()
    asked = scene.tolerance if tolerance is None else tolerance
    jobs = RACES if scene.cage is None else RACES + POCKET
    production = None
    if scene.has_friction or "on" in scene.effects.values():
        production = friction_torque(scene)  # refuses what it cannot model before anything is solved
    for pair, *_ in jobs:
        contact_of(scene, pair=pair)  # and so do the contacts
    shares = np.cumsum([0.0, *(seconds for *_, seconds in jobs)])
    extra = np.cumsum([0.0, HARD_SECONDS * hard, COST_SECONDS * cost])
    whole = shares[-1] + extra[-1]
    shares, extra = shares / whole, (shares[-1] + extra) / whole
    contacts = []
    for (pair, geometry, _), (begin, end) in zip(jobs, pairwise(shares), strict=True):
        contacts.append(
            solve_contact(
                scene,
                pair=pair,
                geometry=geometry,
                tolerance=asked,
                accuracy=ENOUGH * asked,
                progress=part_of(progress, begin, end),
            )
        )
    inner, outer = (_ring_beside(contact) for contact in contacts[:2])
    return Validation(
        scene=scene,
        tolerance=asked,
        contacts=(inner, outer, *contacts[2:]),
        torque=change_of_torque(scene, inner=inner, outer=outer) if scene.has_friction else None,
        hard=run_hard_cases(progress=part_of(progress, extra[0], extra[1])) if hard else (),
        cost=measure_cost(scene, tolerance=asked, progress=part_of(progress, extra[1], 1.0)) if cost else None,
        production=production,
        sensitivity=sensitivity_of(scene),
        cage_records=() if production is None else _recorded(scene, production),
        seconds=time.perf_counter() - start,
    )


def _recorded(scene: Scene, found: FrictionTorque) -> tuple[CageRecord, ...]:
    """The slowest and the fastest point whose cage moved: one that stands in the torque by its statistics alone."""
    moved = [] if found.cage is None else [point for point, motion in enumerate(found.cage.motion) if motion]
    by_speed = sorted(moved, key=lambda point: abs(found.inner_speed[point]))
    records = (record_cage(scene, found, point) for point in dict.fromkeys(by_speed[:1] + by_speed[-1:]))
    return tuple(record for record in records if record is not None)


def _ring_beside(contact: ContactSolution) -> ContactSolution:
    """A race with its ring's structure, or with a word why it has none: no contact fails for it."""
    try:
        return with_ring(contact)
    except InputError as problem:
        return replace(contact, warnings=(*contact.warnings, str(problem)))
