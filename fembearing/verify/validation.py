"""The main job: every contact of a scene, formula against finite elements, and its friction torque."""

import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np

from analytic.brief import Brief
from analytic.contact.geometry import RACES as RACE_NAMES
from analytic.errors import FembearingError, InputError
from analytic.labelled import Column, Labelled, dataset_of, frame_of
from analytic.result import FrictionTorque
from analytic.scene import Array, Pair, Scene
from analytic.scenefile.by_name import Given, with_tolerance
from analytic.verdicts import pressure_check
from fembearing.mesh.recipe import Geometry
from fembearing.progress import Progress, part_of, silent
from fembearing.provenance import Provenance, provenance_of
from fembearing.verify.contact.columns import COLUMNS, VERDICT
from fembearing.verify.contact.discrepancy import ContactSolution, solve_contact, with_ring
from fembearing.verify.contact.scene_contact import contact_of
from fembearing.verify.contact.verdict import Verdict, worst
from fembearing.verify.cost.contact_ladder import contact_ladder_of
from fembearing.verify.cost.formula_ladders import SEED
from fembearing.verify.cost.ladder import Ladder
from fembearing.verify.cost.scene_cost import measure_cost
from fembearing.verify.creep.scene_creep import SceneCreep, creep_of
from fembearing.verify.film.scene_film import RaceFilm, film_change, film_of
from fembearing.verify.hard_record import HardRecord, last_run
from fembearing.verify.measured.comparison import MeasuredComparison, compare_measured
from fembearing.verify.memory import peak_memory
from fembearing.verify.torque.cage_record import CageRecord, record_cage
from fembearing.verify.torque.change import TorqueChange, change_of_torque
from fembearing.verify.torque.scene_torque import Samples, SceneTorque, torque_of_scene
from fembearing.verify.torque.sensitivity import Sensitivity, sensitivity_of
from fembearing.verify.torque.verdicts import Overall, Verdicts

# Contacts with the seconds that they took on one machine, for the progress alone.
RACES: tuple[tuple[Pair, Geometry, float], ...] = (("inner", "real", 5.0), ("outer", "real", 4.0))
POCKET: tuple[tuple[Pair, Geometry, float], ...] = (("pocket", "real", 11.0), ("pocket", "wall", 10.0))  # seat, sheet
FILM_SECONDS, CREEP_SECONDS, COST_SECONDS = 8.0, 3.0, 45.0
CREEP_TOLERANCE = 0.02  # the least that the check asks of numerical friction: half of it takes four times as long
ENOUGH = 0.2  # uncertainty that a reference must reach, as a share of the tolerance that it is to judge


@dataclass(frozen=True, kw_only=True, eq=False)
class Validation(Brief):
    """A scene that was checked. The first two contacts are the inner and the outer race; a pocket is seat and sheet."""

    scene: Scene  # with the tolerance of the check
    contacts: tuple[ContactSolution, ...]
    torque: SceneTorque | None  # that of the command `torque`; None where the scene gives no friction
    torque_change: TorqueChange | None  # what finite-element contacts change; likewise
    hard: HardRecord  # of the hard cases of this version
    ladders: tuple[Ladder, ...]  # all of the scene's where they were measured, else the methods that the check ran
    measured: bool  # whether every ladder was measured, with repeats
    seconds: float  # wall time of all
    peak_memory: int | None  # of the process, bytes
    provenance: Provenance
    films: tuple[RaceFilm, ...] = ()  # lubricated contacts of the heaviest balls, inner and outer; none without oil
    film_change: Array | None = None  # (n,) of the torque by numerical films, relative; None without films or torque
    no_film: tuple[str, ...] = ()  # why there is no numerical film
    creep: SceneCreep | None = None  # numerical friction of the heaviest ball; None where nothing slides
    creep_change: float | None = None  # of the torque at its point by numerical friction, relative; None without it
    no_creep: tuple[str, ...] = ()  # why there is no numerical friction
    measured_torques: MeasuredComparison | None = None  # beside the computed ones; None: the scene has none
    sensitivity: Sensitivity | None = None  # None: not computed
    cage_records: tuple[CageRecord, ...] = ()  # of the slowest and the fastest point whose cage moved
    trouble: tuple[str, ...] = ()  # met while the report was written

    def _facts(self) -> Iterator[str]:
        yield from (self.scene.name, f"{len(self.contacts)} contacts", self.verdict)
        yield f"tolerance {self.tolerance:g}, {self.seconds:.3g} s"

    @property
    def tolerance(self) -> float:
        """Relative."""
        return self.scene.tolerance

    @property
    def comparison(self) -> Verdict:
        """The worst of all quantities that are judged."""
        return worst(verdict for contact in self.contacts if contact.judged for verdict in contact.verdicts.values())

    @property
    def verdicts(self) -> Verdicts:
        """Comparison, numerical and physical; without a torque the physical ones are peak pressures of contacts."""
        if self.torque is not None:
            return replace(self.torque.verdicts, comparison=self.comparison)
        races = (contact for contact in self.contacts if contact.contact.pair != "pocket")
        physical = tuple(pressure_check(race.contact.pair, race.hertz.peak_pressure) for race in races)
        return Verdicts(numerical=None, physical=physical, comparison=self.comparison)

    @property
    def verdict(self) -> Overall:
        """ "pass" where comparison, numerical accuracy and physical limits all hold; "fail" where the first or the last
        fails; else "undecided"."""
        return self.verdicts.overall

    @property
    def warnings(self) -> tuple[str, ...]:
        """Those of the scene, of all contacts, of the torque and of the report, each once."""
        contacts = (warning for contact in self.contacts for warning in contact.warnings)
        torque = () if self.torque is None else self.torque.friction.warnings
        fitted = () if self.torque_change is None else self.torque_change.fitting_warnings
        films = (warning for film in self.films for warning in film.numbers.warnings)
        creep = () if self.creep is None else self.creep.numbers.warnings
        missing = (*self.no_film, *self.no_creep, *self.trouble)
        return tuple(dict.fromkeys([*contacts, *torque, *fitted, *films, *creep, *missing]))

    def to_dataset(self) -> Any:
        """The contacts as an xarray.Dataset over `contact`, SI, with units and meanings; `torque` has its own."""
        rows = [contact.columns() for contact in self.contacts]
        words = {
            "pair": ("body that the ball presses", [contact.contact.pair for contact in self.contacts]),
            "geometry": ("shape of the meshes", [contact.geometry for contact in self.contacts]),
            VERDICT: ("on uncorrected Hertz", [contact.shown_verdict for contact in self.contacts]),
        }
        return dataset_of(
            {name: Labelled(("contact",), [row[name] for row in rows], each) for name, each in COLUMNS.items()},
            coordinates={
                name: Labelled(("contact",), values, Column("", meaning)) for name, (meaning, values) in words.items()
            },
            attributes={"scene": self.scene.name, "tolerance": self.tolerance, VERDICT: self.verdict},
        )

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame of `to_dataset`: a row for each contact, SI."""
        return frame_of(self.to_dataset(), "contact")


def check_scene(
    scene: Scene,
    *,
    tolerance: Given | None = None,
    cost: bool = False,
    samples: Samples = None,
    film: bool = True,
    creep: bool = True,
    progress: Progress = silent,
) -> Validation:
    """Check each race contact of a scene, and where it has a cage the pocket, in a thick seat and in its sheet.

    tolerance : relative; the scene's unless given
    cost : measure every method of every ladder too
    samples : of the 95 % interval of the torque, or "enough"; None: no interval
    film : solve the lubricated contacts too, where there is oil and motion
    creep : solve the friction of the heaviest ball too, where something slides
    progress : called with the share done, 0 to 1, and a word on the step at hand
    Raises InputError for a scene that cannot be solved, ConvergenceError for a contact that does not settle.
    """
    start = time.perf_counter()
    if tolerance is not None:
        scene = with_tolerance(scene, tolerance)
    jobs = RACES if scene.cage is None else RACES + POCKET
    torque = None
    if scene.has_friction or "on" in scene.effects.values():
        # Refuses what it cannot model before anything is solved.
        torque = torque_of_scene(scene, samples=samples, progress=lambda _share, step: progress(0.0, step))
    measured_torques = None
    if scene.measured is not None:
        measured_torques = compare_measured(scene, progress=lambda _share, step: progress(0.0, step))
    for pair, *_ in jobs:
        contact_of(scene, pair=pair)  # and so do the contacts
    moves = bool(np.any(scene.operation.inner_speed))
    films_too = film and scene.lubricant is not None and moves
    creep_too = creep and moves and torque is not None and torque.friction.sliding != "auto"
    spent = FILM_SECONDS * films_too, CREEP_SECONDS * creep_too
    shares = np.cumsum([0.0, *(seconds for *_, seconds in jobs), *spent])
    shares = shares / (shares[-1] + COST_SECONDS * cost)
    contacts = _contacts(scene, jobs, shares[: -len(spent)], progress)
    inner, outer = contacts[:2]
    friction = None if torque is None else torque.friction
    films, change, no_film = (), None, ()
    if films_too:
        films, change, no_film = _films(scene, friction, part_of(progress, shares[-3], shares[-2]))
    slipping, creep_change, no_creep = None, None, ()
    if creep_too and friction is not None:
        slipping, creep_change, no_creep = _creep(scene, friction, part_of(progress, shares[-2], shares[-1]))
    return Validation(
        scene=scene,
        contacts=contacts,
        torque=torque,
        torque_change=None if friction is None else change_of_torque(scene, friction, inner=inner, outer=outer),
        films=films,
        film_change=change,
        no_film=no_film,
        creep=slipping,
        creep_change=creep_change,
        no_creep=no_creep,
        hard=last_run(),
        ladders=measure_cost(scene, tolerance=scene.tolerance, progress=part_of(progress, shares[-1], 1.0)).ladders
        if cost
        else tuple(contact_ladder_of(contact) for contact in contacts if contact.judged),
        measured=cost,
        measured_torques=measured_torques,
        sensitivity=sensitivity_of(scene),
        cage_records=() if friction is None else _recorded(scene, friction),
        seconds=time.perf_counter() - start,
        peak_memory=peak_memory(),
        provenance=provenance_of(scene, seeds=_seeds(scene, torque, measured_torques, cost=cost)),
    )


def _contacts(
    scene: Scene, jobs: Sequence[tuple[Pair, Geometry, float]], shares: Array, progress: Progress
) -> tuple[ContactSolution, ...]:
    """The contacts in the order of the jobs, races with their rings; shares : of the progress, one more than jobs"""
    contacts, rings = [], []
    with ThreadPoolExecutor(1) as beside:  # each ring is computed while the next contact is solved
        for (pair, geometry, _), (begin, end) in zip(jobs, pairwise(shares), strict=True):
            contacts.append(
                solve_contact(
                    scene,
                    pair=pair,
                    geometry=geometry,
                    tolerance=scene.tolerance,
                    accuracy=ENOUGH * scene.tolerance,
                    progress=part_of(progress, begin, end),
                )
            )
            if len(contacts) <= len(RACES):
                rings.append(beside.submit(_with_ring_if_known, contacts[-1]))
    return *(ring.result() for ring in rings), *contacts[len(RACES) :]


def _films(
    scene: Scene, friction: FrictionTorque | None, progress: Progress
) -> tuple[tuple[RaceFilm, ...], Array | None, tuple[str, ...]]:
    """The lubricated contacts of both races, what they change in the torque, and why something is missing."""
    films, change, reasons = [], None, []
    for number, race in enumerate(RACE_NAMES):
        begin, end = number / len(RACE_NAMES), (number + 1) / len(RACE_NAMES)
        try:
            films.append(film_of(scene, pair=race, progress=part_of(progress, begin, end)))
        except FembearingError as problem:  # the contacts and the torque are known all the same
            reasons.append(f"no numerical film on the {race} race: {problem}")
    if films and friction is not None:
        try:
            change = film_change(scene, friction, tuple(films))
        except FembearingError as problem:
            reasons.append(f"no torque with the numerical films: {problem}")
    return tuple(films), change, tuple(reasons)


def _creep(
    scene: Scene, friction: FrictionTorque, progress: Progress
) -> tuple[SceneCreep | None, float | None, tuple[str, ...]]:
    """The numerical friction of the heaviest ball, what it changes in the torque, and why it is missing."""
    try:
        found = creep_of(scene, tolerance=max(scene.tolerance, CREEP_TOLERANCE), progress=progress)
    except FembearingError as problem:  # the contacts and the torque are known all the same
        return None, None, (f"no numerical friction: {problem}",)
    torque = friction.torque
    slides = sum(float(part[found.place]) for part in (torque.spin, torque.conformity) if part is not None)
    return found, found.numbers.change * slides / float(torque.total[found.place]), ()


def _seeds(
    scene: Scene, torque: SceneTorque | None, measured: MeasuredComparison | None, *, cost: bool
) -> dict[str, Sequence[int]]:
    """The seeds of all that is random in a check."""
    cage, surface, friction = scene.cage, scene.surface, None if torque is None else torque.friction
    seeds: dict[str, Sequence[int]] = {}
    if cage is not None and friction is not None and friction.cage is not None and any(friction.cage.motion):
        seeds["motion of the cage"] = range(cage.seeds)
    if torque is not None and torque.prediction is not None:
        seeds["samples of the interval"] = (torque.prediction.seed,)
    if measured is not None:
        seeds["samples beside the measured torques"] = (measured.seed,)
    if cost and surface is not None and surface.autocorrelation is not None:
        seeds["generated surface"] = (SEED,)
    return seeds


def _recorded(scene: Scene, friction: FrictionTorque) -> tuple[CageRecord, ...]:
    """The motion at the slowest and the fastest point whose cage moved; the torque holds its statistics alone."""
    moved = [] if friction.cage is None else [point for point, motion in enumerate(friction.cage.motion) if motion]
    by_speed = sorted(moved, key=lambda point: abs(friction.inner_speed[point]))
    records = (record_cage(scene, friction, point) for point in dict.fromkeys(by_speed[:1] + by_speed[-1:]))
    return tuple(record for record in records if record is not None)


def _with_ring_if_known(contact: ContactSolution) -> ContactSolution:
    """A race with its ring's structure, or with a warning why it has none: no contact fails for it."""
    try:
        return with_ring(contact)
    except InputError as problem:
        return replace(contact, warnings=(*contact.warnings, str(problem)))
