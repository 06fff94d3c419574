"""The main job: every contact of a scene, formula against finite elements, and its friction torque."""

import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import CancelledError, Future, ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass, replace
from itertools import product
from threading import Event, Lock
from typing import Any, NamedTuple, TypeVar

import numpy as np
from threadpoolctl import threadpool_limits

from analytic.brief import Brief
from analytic.columns import CONTACT_COLUMNS, VERDICT
from analytic.contact.geometry import RACES as RACE_NAMES
from analytic.contact.geometry import Race
from analytic.errors import FembearingError, InputError
from analytic.labelled import Column, Labelled, dataset_of, frame_of
from analytic.progress import Progress, part_of, silent
from analytic.result import FrictionTorque
from analytic.scene import Array, Pair, Scene
from analytic.scene_torque import Samples, SceneTorque, torque_of_scene
from analytic.scenefile.parts import Given, with_tolerance
from analytic.verdicts import Compared, Overall, Verdict, Verdicts, pressure_check
from fembearing.check.cage_record import CageRecord, record_cage
from fembearing.check.comparison import ShownVerdict, verdict_within, worst
from fembearing.check.contact.scene_contact import OneBearing, balls_of, bearings_of, contact_of, which_bearing
from fembearing.check.contact.solution import ContactSolution, solve_contact, with_ring
from fembearing.check.cost.ladder import Ladder
from fembearing.check.cost.scene_cost import SEED, contact_ladder_of, measure_cost
from fembearing.check.creep.scene_creep import SceneCreep, creep_of
from fembearing.check.film.scene_film import RaceFilm, film_change, film_of
from fembearing.check.hard_record import HardRecord, last_run
from fembearing.check.measured.comparison import MeasuredComparison, compare_measured
from fembearing.check.memory import peak_memory
from fembearing.check.sensitivity import Sensitivity, sensitivity_of
from fembearing.check.torque_change import TorqueChange, change_of_torque
from fembearing.fem.factor import solver_threads
from fembearing.mesh.recipe import Geometry
from fembearing.provenance import Provenance, provenance_of

# Contacts with the seconds that they took on one machine, for the progress alone.
RACES: tuple[tuple[Pair, Geometry, float], ...] = (("inner", "real", 5.0), ("outer", "real", 4.0))
POCKET: tuple[tuple[Pair, Geometry, float], ...] = (("pocket", "real", 11.0), ("pocket", "wall", 10.0))  # seat, sheet
FILM_SECONDS, CREEP_SECONDS, COST_SECONDS = 4.0, 3.0, 45.0  # of a race, of a bearing, of all
CREEP_TOLERANCE = 0.02  # the least that the check asks of numerical friction: half of it takes four times as long
ENOUGH = 0.2  # uncertainty that a reference must reach, as a share of the tolerance that it is to judge


Part = TypeVar("Part")


class _Job(NamedTuple):
    """A contact that is solved."""

    of: OneBearing
    pair: Pair
    geometry: Geometry
    seconds: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Validation(Brief):
    """A scene that was checked.

    Contacts are the inner and the outer race, of a pair those of each bearing, and then the pocket, seat and sheet.
    """

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
    creep: tuple[SceneCreep, ...] = ()  # numerical friction of the heaviest ball of each bearing; none: nothing slides
    missing: tuple[str, ...] = ()  # why there is no numerical film or friction
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
    def compared(self) -> dict[Compared, Verdict]:
        """The worst verdict on contacts, on films, and on the friction of balls, as far as they were solved."""
        found: dict[Compared, ShownVerdict] = {"contacts": worst(contact.numbers.verdict for contact in self.contacts)}
        if self.films:
            found["film"] = worst(film.numbers.verdict for film in self.films)
        if self.creep_change is not None:
            found["friction"] = self._friction(self.creep_change)
        return {name: verdict for name, verdict in found.items() if verdict != "shown"}

    @property
    def _heaviest(self) -> SceneCreep:
        return max(self.creep, key=lambda creep: creep.numbers.load)

    @property
    def creep_change(self) -> float | None:
        """Of the torque at the point of the heaviest ball by its numerical friction, relative; None without it."""
        if not self.creep or self.torque is None:
            return None
        place, torque = self._heaviest.place, self.torque.friction.torque
        slides = sum(float(part[place]) for part in (torque.spin, torque.conformity) if part is not None)
        return self._heaviest.numbers.change * slides / float(torque.total[place])

    def _friction(self, change: float) -> Verdict:
        """Whether the numerical friction of the heaviest ball changes the torque by less than the tolerance."""
        heaviest = self._heaviest.numbers
        share = change / heaviest.change if heaviest.change else 0.0  # of sliding in the torque
        return verdict_within(change, share * heaviest.relative_uncertainty, tolerance=self.tolerance)

    @property
    def verdicts(self) -> Verdicts:
        """Comparison, numerical and physical; without a torque the physical ones are peak pressures of contacts."""
        if self.torque is not None:
            return replace(self.torque.verdicts, compared=self.compared)
        races = (contact.numbers for contact in self.contacts if contact.numbers.pair != "pocket")
        checks = [(race.bearing, pressure_check(race.pair, race.hertz.peak_pressure)) for race in races]
        physical = tuple(replace(check, where=f"{check.where}{which_bearing(of)}") for of, check in checks)
        return Verdicts(numerical=None, physical=physical, compared=self.compared)

    @property
    def verdict(self) -> Overall:
        """ "pass" where comparison, numerical accuracy and physical limits all hold; "fail" where the first or the last
        fails; else "undecided"."""
        return self.verdicts.overall

    @property
    def warnings(self) -> tuple[str, ...]:
        """Those of the scene and its measured torques, of all contacts, of the torque and of the report, each once."""
        own = self.scene.warnings
        contacts = (
            f"{contact.numbers.bearing} bearing, {warning}"
            if contact.numbers.bearing and warning not in own
            else warning
            for contact in self.contacts
            for warning in contact.numbers.warnings
        )
        torque = () if self.torque is None else self.torque.friction.warnings
        table = () if self.scene.measured is None else self.scene.measured.warnings
        fit = None if self.torque_change is None else self.torque_change.fitted
        fitted = () if fit is None else fit.warnings
        films = (warning for film in self.films for warning in film.numbers.warnings)
        creep = (warning for creep in self.creep for warning in creep.numbers.warnings)
        return tuple(dict.fromkeys([*table, *contacts, *torque, *fitted, *films, *creep, *self.missing, *self.trouble]))

    def to_dataset(self) -> Any:
        """The contacts as an xarray.Dataset over `contact`, SI, with units and meanings; `torque` has its own."""
        words, numbers = self._labelled()
        attributes = {"scene": self.scene.name, "tolerance": self.tolerance, VERDICT: self.verdict}
        return dataset_of(numbers, coordinates=words, attributes=attributes)

    def to_dataframe(self) -> Any:
        """A pandas.DataFrame with the columns of `to_dataset`: a row for each contact, SI."""
        words, numbers = self._labelled()
        return frame_of(words | numbers, "contact")

    def _labelled(self) -> tuple[dict[str, Labelled], dict[str, Labelled]]:
        """What each contact is, and its numbers."""
        rows, found = [contact.columns() for contact in self.contacts], [contact.numbers for contact in self.contacts]
        words = {
            "pair": ("body that the ball presses", [each.pair for each in found]),
            "geometry": ("shape of the meshes", [each.geometry for each in found]),
            "bearing": ("of the pair", [each.bearing or "both" for each in found]),
            VERDICT: ("on uncorrected Hertz", [each.verdict for each in found]),
        }
        if self.scene.arrangement is None:
            del words["bearing"]
        return (
            {name: Labelled(("contact",), values, Column("", meaning)) for name, (meaning, values) in words.items()},
            {name: Labelled(("contact",), [row[name] for row in rows], each) for name, each in CONTACT_COLUMNS.items()},
        )


def check_scene(
    scene: Scene,
    *,
    tolerance: Given | None = None,
    cost: bool = False,
    samples: Samples = None,
    film: bool = True,
    creep: bool = True,
    progress: Progress = silent,
    at_contacts: Callable[[tuple[ContactSolution, ...]], None] = lambda _contacts: None,
) -> Validation:
    """Check each race contact of a scene, and where it has a cage the pocket, in a thick seat and in its sheet.

    Of a pair the races of both bearings are checked, and the pocket once, as both have the same. Contacts, films,
    friction and sensitivity are computed side by side on the cores that `solver_threads` allows.

    tolerance : relative; the scene's unless given
    cost : measure every method of every ladder too
    samples : of the 95 % interval of the torque, or "enough"; None: no interval
    film : solve the lubricated contacts too, where there is oil and motion
    creep : solve the friction of the heaviest ball too, where something slides
    progress : called with the share done, 0 to 1, and a word on the step at hand; from several threads, in turn
    at_contacts : called with the contacts as soon as all are solved
    Raises InputError for a scene that cannot be solved, ConvergenceError for a contact that does not settle.
    """
    start = time.perf_counter()
    scene = scene if tolerance is None else with_tolerance(scene, tolerance)
    if cost:
        balls_of(scene)  # refuses a pair: each method is measured on one bearing
    torque, measured_torques = _torques(scene, samples, lambda _share, step: progress(0.0, step))
    bearings, friction = list(bearings_of(scene)), None if torque is None else torque.friction
    jobs = _jobs(scene, bearings)  # refuses too
    moves = bool(np.any(scene.operation.inner_speed))
    races = list(product(bearings, RACE_NAMES)) if film and moves and scene.lubricant is not None else []
    slipping = bearings if creep and moves and friction is not None and friction.sliding != "none" else []
    seconds = [job.seconds for job in jobs] + [FILM_SECONDS] * len(races) + [CREEP_SECONDS] * len(slipping)
    solved, missing, by_films = sum(seconds) / (sum(seconds) + COST_SECONDS * cost), [], None
    with _side_by_side(part_of(progress, 0.0, solved), seconds) as (threads, steps):
        solving = threads.submit(_contacts, jobs, [next(steps) for _ in jobs])
        filming = [
            (f"film on the {race} race{which_bearing(of.name)}", threads.submit(_film, of, race, next(steps)))
            for of, race in races
        ]
        creeping = [(f"friction{which_bearing(of.name)}", threads.submit(_creep, of, next(steps))) for of in slipping]
        varying = threads.submit(sensitivity_of, scene)
        recording = threads.submit(_recorded, scene, friction)
        contacts = solving.result()
        at_contacts(contacts)
        changing = threads.submit(_changed, scene, friction, contacts)
        films = tuple(_known(filming, missing))
        if films and friction is not None:
            with _noted(missing, "no torque with the numerical films"):
                by_films = film_change(scene, friction, films)
        slips = tuple(_known(creeping, missing))
    return Validation(
        scene=scene,
        contacts=contacts,
        torque=torque,
        torque_change=changing.result(),
        films=films,
        film_change=by_films,
        creep=slips,
        missing=tuple(missing),
        hard=last_run(),
        ladders=_ladders(scene, contacts, part_of(progress, solved, 1.0) if cost else None),
        measured=cost,
        measured_torques=measured_torques,
        sensitivity=varying.result(),
        cage_records=recording.result(),
        seconds=time.perf_counter() - start,
        peak_memory=peak_memory(),
        provenance=provenance_of(scene, seeds=_seeds(scene, torque, measured_torques, cost=cost)),
    )


def _ladders(scene: Scene, contacts: Sequence[ContactSolution], progress: Progress | None) -> tuple[Ladder, ...]:
    """All of the scene's, measured with a progress; without one, those of the contacts that are judged."""
    if progress is not None:
        return measure_cost(scene, tolerance=scene.tolerance, progress=progress).ladders
    return tuple(contact_ladder_of(contact) for contact in contacts if contact.numbers.judged)


def _torques(
    scene: Scene, samples: Samples, progress: Progress
) -> tuple[SceneTorque | None, MeasuredComparison | None]:
    """The torque, and beside it the measured ones, as far as the scene gives them; refuses what cannot be modelled."""
    has_torque = scene.has_friction or "on" in scene.effects.values()
    return (
        torque_of_scene(scene, samples=samples, progress=progress) if has_torque else None,
        None if scene.measured is None else compare_measured(scene, progress=progress),
    )


@contextmanager
def _side_by_side(
    progress: Progress, seconds: Sequence[float]
) -> Iterator[tuple[ThreadPoolExecutor, Iterator[Progress]]]:
    """Threads, and a progress for each of the parts that they work on; seconds : that each part takes

    Where one part fails, or the user ends the check, the others end at their next step.
    """
    done, turn, ended = [0.0] * len(seconds), Lock(), Event()

    def part(number: int) -> Progress:
        def tell(share: float, step: str) -> None:
            if ended.is_set():
                raise CancelledError
            with turn:
                done[number] = max(done[number], share * seconds[number])
                progress(min(sum(done) / sum(seconds), 1.0), step)

        return tell

    with threadpool_limits(1, "blas"), ThreadPoolExecutor(solver_threads()) as threads:
        try:
            yield threads, map(part, range(len(seconds)))
        except BaseException:
            ended.set()
            threads.shutdown(wait=False, cancel_futures=True)
            raise


def _film(of: OneBearing, race: Race, progress: Progress) -> RaceFilm:
    """The film of the heaviest ball of a bearing on a race."""
    found = film_of(of.scene, pair=race, progress=progress)
    progress(1.0, f"{race}: film solved")
    return replace(found, numbers=replace(found.numbers, bearing=of.name))


def _creep(of: OneBearing, progress: Progress) -> SceneCreep:
    """The numerical friction of the heaviest ball of a bearing."""
    found = creep_of(of.scene, tolerance=max(of.scene.tolerance, CREEP_TOLERANCE), progress=progress)
    progress(1.0, "friction solved")
    return replace(found, numbers=replace(found.numbers, bearing=of.name), place=int(of.points[found.place]))


def _known(parts: Sequence[tuple[str, Future[Part]]], missing: list[str]) -> Iterator[Part]:
    """The parts that could be solved, and why the others could not; each with its name."""
    for name, part in parts:
        with _noted(missing, f"no numerical {name}"):
            yield part.result()


@contextmanager
def _noted(missing: list[str], words: str) -> Iterator[None]:
    """Note why a part of the check fails: the rest is known all the same."""
    try:
        yield
    except FembearingError as problem:
        missing.append(f"{words}: {problem}")


def _jobs(scene: Scene, bearings: Sequence[OneBearing]) -> list[_Job]:
    """Both races of each bearing, and the pocket, which is the same in both. Raises InputError as contact_of does."""
    jobs = [_Job(each, *race) for each in bearings for race in RACES]
    jobs += [] if scene.cage is None else [_Job(replace(bearings[0], name=None), *seat) for seat in POCKET]
    for job in jobs:
        contact_of(job.of.scene, pair=job.pair)
    return jobs


def _contacts(jobs: Sequence[_Job], steps: Sequence[Progress]) -> tuple[ContactSolution, ...]:
    """The contacts in the order of the jobs, races with their rings; steps : the progress of each"""
    with ThreadPoolExecutor(1) as beside:  # each ring is computed while the next contact is solved
        contacts = []
        for job, step in zip(jobs, steps, strict=False):  # other steps follow
            tolerance = job.of.scene.tolerance
            solved = solve_contact(
                job.of.scene,
                pair=job.pair,
                geometry=job.geometry,
                tolerance=tolerance,
                accuracy=ENOUGH * tolerance,
                progress=step,
            )
            step(1.0, f"{job.pair}: solved")
            contacts.append(beside.submit(_with_ring_if_known, solved.with_numbers(bearing=job.of.name)))
    return tuple(each.result() for each in contacts)


def _changed(scene: Scene, friction: FrictionTorque | None, contacts: Sequence[ContactSolution]) -> TorqueChange | None:
    """By both races of the bearing with the heaviest ball; None without a torque."""
    if friction is None:
        return None
    inner, outer = ([each for each in contacts if each.contact.pair == race] for race in RACE_NAMES)
    heaviest = max(zip(inner, outer, strict=True), key=lambda both: max(each.contact.load for each in both))
    return change_of_torque(scene, friction, inner=heaviest[0], outer=heaviest[1])


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


def _recorded(scene: Scene, friction: FrictionTorque | None) -> tuple[CageRecord, ...]:
    """The motion at the slowest and the fastest point whose cage moved; the torque holds its statistics alone."""
    if friction is None or friction.cage is None:
        return ()
    moved = [point for point, motion in enumerate(friction.cage.motion) if motion]
    by_speed = sorted(moved, key=lambda point: abs(friction.inner_speed[point]))
    records = (record_cage(scene, friction, point) for point in dict.fromkeys(by_speed[:1] + by_speed[-1:]))
    return tuple(record for record in records if record is not None)


def _with_ring_if_known(contact: ContactSolution) -> ContactSolution:
    """A race with its ring's structure, or with a warning why it has none: no contact fails for it."""
    try:
        return contact if contact.contact.pair == "pocket" else with_ring(contact)
    except InputError as problem:
        return contact.with_numbers(warnings=(*contact.numbers.warnings, str(problem)))
