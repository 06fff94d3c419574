"""The report of a check: one type is written, read, drawn and shown."""

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, ClassVar, Literal, NoReturn

import numpy as np
from annotated_types import Len, MinLen

from analytic.errors import InputError
from analytic.reading import content_of
from analytic.rows import Count, NotNegative, Positive
from analytic.scene import Array, Pair, ReportDetails
from analytic.verdicts import PhysicalCheck, Summary
from fembearing.check.cage_record import DrawnMotion
from fembearing.check.comparison import ShownVerdict, worst
from fembearing.check.contact.bearings import OfPair
from fembearing.check.contact.scene_contact import Shape
from fembearing.check.contact.solution import ContactNumbers
from fembearing.check.cost.ladder import Ladder
from fembearing.check.creep.scene_creep import CreepNumbers
from fembearing.check.film.scene_film import FilmNumbers
from fembearing.check.hard_record import HardRecord
from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.check.sensitivity import Sensitivity
from fembearing.check.torque_change import OF_RACES, TorqueChange
from fembearing.check.validation import Validation
from fembearing.provenance import Provenance
from fembearing.quantities import CONTACT, SYSTEMS, Units
from fembearing.report.findings import Finding, findings_of
from fembearing.report.scene_view import SceneView
from fembearing.report.torque import CageMotionPoint, TorqueRecord, cage_motion, torque_record

if TYPE_CHECKING:
    from pydantic import TypeAdapter

KIND, FORMAT = "fembearing validation", 8  # what the JSON is; the number rises when a key changes its name or meaning
INSTANTS = 400  # of a cage's motion that are kept
LARGEST = 1e200  # SI; a larger number is damage, and may be too large in the unit in which it is shown
LARGEST_FILE = 256_000_000  # bytes: ten times a series of thousand points
POCKETS = ([], ["real", "wall"])  # models of a cage pocket: no cage, or the thick seat and the sheet
SHOWN = 60  # characters of a value in a message
FAULTS = {  # pydantic's names
    "missing": "is missing",
    "float_type": "is no number",
    "int_type": "is no whole number",
    "bool_type": "is neither true nor false",
    "string_type": "is no text",
    "tuple_type": "is no list",
    "list_type": "is no list",
    "dict_type": "is no table",
    "dataclass_type": "is no table",
    "finite_number": "is not finite",
    "unexpected_keyword_argument": "is not known",
}
FILE_NAME = r"^\w[\w.-]*$"
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

    @property
    def lengths(self) -> set[int]:
        """The numbers of points of its lists: one, where they belong together."""
        both, fitted = (self.contact_angle, self.torque), self.finite_geometry
        series = [*(side.production for side in both), *(side.corrected for side in both), self.change.total]
        series += [] if fitted is None else [fitted.change, fitted.uncertainty]
        return {len(each) for each in series}


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

    file: str  # beside report.json, never elsewhere
    kind: Literal["pressure", "section", "view", "film", "creep"]
    pair: Pair
    geometry: Shape
    caption: str
    bearing: OfPair | None = None  # of a pair

    def __post_init__(self) -> None:
        """Raises ValueError for a name that may lead elsewhere."""
        if not re.fullmatch(FILE_NAME, self.file):
            raise ValueError(f"has a picture {self.file!r}, which is no plain name")


@dataclass(frozen=True, kw_only=True)
class Report:
    """The check of a scene. Numbers are SI, uncertainties and discrepancies relative."""

    __pydantic_config__: ClassVar[dict[str, Any]] = {"strict": True, "extra": "forbid", "allow_inf_nan": False}

    kind: Literal["fembearing validation"] = KIND
    format: Literal[8] = FORMAT
    verdict: Summary
    findings: Annotated[tuple[Finding, ...], MinLen(1)]
    physical: Annotated[tuple[PhysicalCheck, ...], MinLen(1)]
    report: ReportDetails
    tolerance: Positive
    contacts: Annotated[tuple[ContactNumbers, ...], Len(2, 6)]
    torque: TorqueRecord | None
    torque_change: ChangeRecord | None
    cage_motion: tuple[CageMotionPoint, ...] | None
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
    renderer: str = "VTK"

    def __post_init__(self) -> None:
        """Raises ValueError for parts that do not belong together."""
        if len({_place_of(contact) for contact in self.contacts}) < len(self.contacts):
            raise ValueError("has a contact twice")
        if sorted(contact.geometry for contact in self.contacts if contact.pair == "pocket") not in POCKETS:
            raise ValueError(f"has a pocket of other models than {' and '.join(POCKETS[1])}")
        for picture in self.pictures:
            if self.contact_of(picture) is None:
                raise ValueError(f"has no contact for the picture {picture.file}")
        for contact in self.contacts:
            if sorted(contact.quantities) != sorted(CONTACT):
                raise ValueError(f"has no verdict on every quantity of {contact.pair}, once")
        if self.verdict.comparison != worst(contact.verdict for contact in self.contacts):
            raise ValueError("has another verdict on the comparison than the worst on a contact")
        for name in self._names:
            if "$" in name:
                raise ValueError(f"has a name {name!r}, in which a formula begins where a figure shows it")
        if (self.torque is None) != (self.torque_change is None):
            raise ValueError("has torque without torque_change, or the other way round")
        if self.torque is not None and self.torque_change is not None:
            count = len(self.torque.points)
            if any(check.point >= count for check in self.physical):
                raise ValueError(f"has a physical verdict on a point beyond the {count} points of torque")
            if self.film_change is not None and len(self.film_change) != count:
                raise ValueError(f"has a film_change of other than the {count} points of torque")
            if self.torque_change.lengths != {count}:
                raise ValueError(f"has a torque_change of other than the {count} points of torque")
            if self.cage_motion is not None and len(self.cage_motion) != count:
                raise ValueError(f"has a cage_motion of other than the {count} points of torque")
            if self.torque.left_out or self.torque.verdicts.numerical is None:
                raise ValueError("has a torque with points left out")

    @property
    def _names(self) -> Iterator[str]:
        """Names that stand in figures."""
        for ladder in self.cost.ladders:
            yield from (ladder.quantity, *(method.name for method in ladder.methods))
        if self.sensitivity is not None:
            yield from (name for each in self.sensitivity.inputs for name in (each.name, each.unit))
        if self.torque is not None and self.torque.prediction is not None:
            yield from (each.key for each in self.torque.prediction.inputs)
            yield from self.torque.prediction.points[0].made_of

    def contact_of(self, picture: PictureFile) -> ContactNumbers | None:
        """The contact that a picture shows; None where there is none."""
        return next((each for each in self.contacts if _place_of(each) == _place_of(picture)), None)

    @cached_property
    def scene(self) -> SceneView:
        """The scene, as far as the page tells of it. Raises ValueError for a scene of another kind."""
        return _adapter(SceneView).validate_json(json.dumps(self.provenance.scene_content))

    @property
    def units(self) -> Units:
        """In which page and figures show these numbers, which are SI."""
        return SYSTEMS[self.report.units]

    @property
    def pocket_load(self) -> str:
        """The load of the pocket, N, as the page says it."""
        return f"{self.contacts[-1].load:g}"


def _place_of(part: ContactNumbers | PictureFile) -> tuple[OfPair | None, Pair, Shape]:
    return part.bearing, part.pair, part.geometry


def report_of(result: Validation, *, pictures: Sequence[PictureFile] = (), renderer: str | None = None) -> Report:
    """The report of a check;  renderer : what drew the pictures; VTK without it."""
    verdicts, contacts = result.verdicts, tuple(contact.numbers for contact in result.contacts)
    films, creep = tuple(film.numbers for film in result.films), tuple(creep.numbers for creep in result.creep)
    torque, change = result.torque, result.torque_change
    return Report(
        verdict=verdicts.summary,
        findings=tuple(findings_of(contacts, films, creep, change)),
        physical=verdicts.physical,
        report=result.scene.report,
        tolerance=result.tolerance,
        contacts=contacts,
        torque=None if torque is None else torque_record(torque, measured=True),
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
        renderer=renderer or "VTK",
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


def read_report(path: Path) -> Report:
    """The report in a report.json.

    Raises InputError, in one line, for what is no regular file, is too large, is no such report or is damaged.
    """
    text = _text_of(path)
    try:
        content = json.loads(text, parse_constant=_no_number)
        json.dumps(content, ensure_ascii=False).encode()  # half a character, as an escape lets it in, is refused here
    except (ValueError, RecursionError) as problem:
        raise InputError(
            f"{str(path)!r} is no JSON, or cut off: {problem}; run `fembearing validate` again"
        ) from problem
    if not isinstance(content, dict) or content.get("kind") != KIND:
        raise InputError(f"{str(path)!r} is JSON, but no report of `fembearing validate`; give the report.json of one")
    if content.get("format") != FORMAT:
        raise InputError(
            f"{str(path)!r} is of fembearing {_writer(content) or 'unknown'}, format {content.get('format')!r}; this "
            f"fembearing {_ours()} reads format {FORMAT}: take that version, or run `fembearing validate` again"
        )
    try:
        return report_in(content)
    except ValueError as problem:
        raise InputError(f"{str(path)!r}: {_fault(problem)}; {_remedy(content)}") from problem


def report_in(content: dict[str, Any]) -> Report:
    """The report in the content of a report.json. Raises ValueError, mostly pydantic's, for any other."""
    _require_usual_numbers(content)
    report = _adapter(Report).validate_json(json.dumps(content))
    _ = report.scene  # damage to it is found here, and not where it is shown
    return report


@cache
def _adapter(of: type) -> "TypeAdapter[Any]":
    from pydantic import TypeAdapter  # only what reads a report pays for it

    return TypeAdapter(of)


def _require_usual_numbers(node: Any, where: str = "it") -> None:
    if isinstance(node, dict | list):
        parts = node.items() if isinstance(node, dict) else enumerate(node)
        for name, part in parts:
            _require_usual_numbers(part, f"{where}.{name}".removeprefix("it."))
    elif isinstance(node, float) and abs(node) > LARGEST:
        raise ValueError(f"{where} {node:g} is larger than {LARGEST:g}")


def _text_of(path: Path) -> bytes:
    try:
        return content_of(path, most=LARGEST_FILE, remedy="give the report.json of a report")
    except InputError as problem:
        raise InputError(f"{str(path)!r}: {problem}") from problem


def _no_number(name: str) -> NoReturn:
    raise ValueError(f"{name} is no number of JSON")


def _fault(problem: ValueError) -> str:
    """The first fault, in words."""
    from pydantic import ValidationError

    if not isinstance(problem, ValidationError):
        return str(problem)
    first, *others = problem.errors(include_url=False)
    above = ("provenance", "scene_content") if problem.title == SceneView.__name__ else ()
    where = ".".join(map(str, (*above, *first["loc"]))) or "it"
    words = FAULTS.get(first["type"], first["msg"].removeprefix("Value error, "))
    shown = "" if first["type"] in ("missing", "value_error") else f" = {_shortened(first['input'])}"
    more = f" (and {len(others)} more)" if others else ""
    return f"{where}{shown} {words}{more}"


def _shortened(value: object) -> str:
    text = repr(value)
    return text if len(text) <= SHOWN else f"{text[: SHOWN // 2]}...{text[-SHOWN // 2 :]}"


def _remedy(content: dict[str, Any]) -> str:
    """What to do about a damaged report, with the versions that wrote and read it."""
    wrote = _writer(content)
    other = "" if wrote in (None, _ours()) else f" or was written by fembearing {wrote}, this is {_ours()}"
    return f"it was changed{other}: run `fembearing validate` again"


def _writer(content: dict[str, Any]) -> str | None:
    """The version that wrote a report; None where it does not say."""
    origin = content.get("provenance")
    versions = origin.get("versions") if isinstance(origin, dict) else None
    wrote = versions.get("fembearing") if isinstance(versions, dict) else None
    return wrote if isinstance(wrote, str) else None


def _ours() -> str:
    return version("fembearing")
