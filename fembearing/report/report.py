"""The report of a check: one type is written, drawn and shown."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Annotated, Any, Literal

import numpy as np
from annotated_types import Len, MinLen

from analytic.columns import Point
from analytic.rows import Count, NotNegative, Positive
from analytic.scene import Array, Pair, ReportDetails, Scene
from analytic.scene_torque import SceneTorque
from analytic.units import SYSTEMS, Units
from analytic.verdicts import Compared, PhysicalCheck, Summary, Verdict
from fembearing.check.cage_record import DrawnMotion
from fembearing.check.comparison import ShownVerdict
from fembearing.check.contact.scene_contact import OfPair, Shape
from fembearing.check.contact.solution import ContactNumbers
from fembearing.check.cost.ladder import Ladder
from fembearing.check.creep.scene_creep import CreepNumbers
from fembearing.check.film.scene_film import FilmNumbers
from fembearing.check.hard_record import HardRecord
from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.check.sensitivity import Sensitivity
from fembearing.check.torque_change import OF_RACES, TorqueChange
from fembearing.check.validation import Validation
from fembearing.plain_types import UNWRITTEN
from fembearing.provenance import Provenance
from fembearing.report.findings import Finding, findings_of
from fembearing.report.torque import TorqueContent, cage_motion
from fembearing.report.torque import content_of as torque_content

INSTANTS = 400  # of a cage's motion that are kept
Floats = tuple[float, ...]
Optionals = tuple[float | None, ...]


@dataclass(frozen=True, kw_only=True)
class BeforeAndAfter:
    """A number of the production at each point, and with contacts of finite elements; None where none was solved."""

    production: Floats
    corrected: Optionals


@dataclass(frozen=True, kw_only=True)
class PartChanges:
    """Relative changes of each part at each point.

    None in place of a list: the part was left out. None in a list: no contact was solved at that ball load.
    """

    total: Optionals
    race: Optionals | None
    spin: Optionals | None
    conformity: Optionals | None
    hysteresis: Optionals | None
    rolling: Optionals | None


@dataclass(frozen=True, kw_only=True)
class ChangeByFit:
    """What the fit for finite geometry changes at each point, relative; None where it ends."""

    change: Optionals
    uncertainty: tuple[NotNegative | None, ...]


@dataclass(frozen=True, kw_only=True)
class ChangeRecord:
    """What finite-element contacts change in the torque."""

    contact_angle: BeforeAndAfter  # rad
    torque: BeforeAndAfter  # N m
    change: PartChanges
    uncertainty: NotNegative  # of the total's change
    uncertainties: dict[str, NotNegative]  # of each part's relative change
    finite_geometry: ChangeByFit | None  # None: it is in the production's contacts
    verdict: ShownVerdict
    note: str


@dataclass(frozen=True, kw_only=True)
class Cost:
    """What accuracy costs."""

    measured: bool  # every ladder, with repeats; else the methods that the check ran
    seconds: float
    peak_memory: Count | None  # bytes
    ladders: tuple[Ladder, ...]


@dataclass(frozen=True, kw_only=True)
class PictureFile:
    """A picture of a contact, in a file beside report.json."""

    file: str  # name
    kind: Literal["pressure", "section", "view", "film", "creep"]
    pair: Pair
    geometry: Shape
    caption: str
    bearing: OfPair | None = None  # of a pair


@dataclass(frozen=True, kw_only=True)
class Report:
    """The check of a scene. Numbers are SI, uncertainties and discrepancies relative."""

    scene: Scene = field(metadata=UNWRITTEN)  # in SI it is part of the provenance
    verdict: Summary
    findings: Annotated[tuple[Finding, ...], MinLen(1)]
    physical: Annotated[tuple[PhysicalCheck, ...], MinLen(1)]
    report: ReportDetails
    tolerance: Positive
    contacts: Annotated[tuple[ContactNumbers, ...], Len(2, 6)]
    compared: Mapping[Compared, Verdict]  # the worst verdict on contacts, film and friction
    solved: SceneTorque | None = field(metadata=UNWRITTEN)  # the torque, which JSON holds as follows
    torque: TorqueContent | None
    torque_change: ChangeRecord | None
    cage_motion: tuple[Point, ...] | None
    cage_records: tuple[DrawnMotion, ...]
    films: tuple[FilmNumbers, ...]
    film_change: Floats | None  # of the torque at each point, relative; None without films or torque
    creep: tuple[CreepNumbers, ...] = ()  # friction of the heaviest ball of each bearing; none where nothing slides
    creep_change: float | None = None  # of the torque at its operating point by the reference, relative
    measured: MeasuredComparison | None = None  # measured torques beside the computed ones; None: the scene has none
    sensitivity: Sensitivity | None
    cost: Cost
    hard: HardRecord
    warnings: tuple[str, ...]
    provenance: Provenance
    pictures: tuple[PictureFile, ...] = ()

    @property
    def units(self) -> Units:
        """In which page and figures show these numbers, which are SI."""
        return SYSTEMS[self.report.units]

    def contact_of(self, picture: PictureFile) -> ContactNumbers:
        """The contact that a picture shows."""
        return next(each for each in self.contacts if _place_of(each) == _place_of(picture))


def _place_of(part: ContactNumbers | PictureFile) -> tuple[OfPair | None, Pair, Shape]:
    return part.bearing, part.pair, part.geometry


def report_of(result: Validation, *, pictures: Sequence[PictureFile] = ()) -> Report:
    """The report of a check."""
    verdicts, contacts = result.verdicts, tuple(contact.numbers for contact in result.contacts)
    films, creep = tuple(film.numbers for film in result.films), tuple(creep.numbers for creep in result.creep)
    torque, change = result.torque, result.torque_change
    return Report(
        scene=result.scene,
        verdict=verdicts.summary,
        findings=tuple(findings_of(contacts, films, creep, change, result.compared.get("friction", "shown"))),
        physical=verdicts.physical,
        report=result.scene.report,
        tolerance=result.tolerance,
        contacts=contacts,
        compared=result.compared,
        solved=torque,
        torque=None if torque is None else torque_content(torque),
        torque_change=None if change is None else change_record(change),
        cage_motion=None if torque is None else cage_motion(torque),
        cage_records=tuple(record.drawn(most=INSTANTS) for record in result.cage_records),
        films=films,
        film_change=None if result.film_change is None else tuple(result.film_change.tolist()),
        creep=creep,
        creep_change=result.creep_change,
        measured=result.measured_torques,
        sensitivity=result.sensitivity,
        cost=Cost(
            measured=result.measured, seconds=result.seconds, peak_memory=result.peak_memory, ladders=result.ladders
        ),
        hard=result.hard,
        warnings=result.warnings,
        provenance=result.provenance,
        pictures=tuple(pictures),
    )


def change_record(change: TorqueChange) -> ChangeRecord:
    """Lists over the operating points."""
    production, fitted = change.production, change.fitted
    changes = {part: _listed(change.relative(part)) for part in ("total", *OF_RACES)}
    angles = {"production": _listed(production.contact_angle), "corrected": _listed(change.contact_angle)}
    totals = {"production": _listed(production.torque.total), "corrected": _listed(change.total)}
    return ChangeRecord(
        contact_angle=BeforeAndAfter(**angles),
        torque=BeforeAndAfter(**totals),
        change=PartChanges(**changes),
        uncertainty=change.uncertainty,
        uncertainties=change.uncertainties,
        finite_geometry=fitted
        and ChangeByFit(change=_listed(fitted.relative), uncertainty=_listed(fitted.uncertainty)),
        verdict=change.verdict,
        note=change.note,
    )


def _listed(values: Array | None) -> Any:
    """Numbers of a series, None for NaN."""
    return None if values is None else tuple(None if np.isnan(value) else value for value in values.tolist())
