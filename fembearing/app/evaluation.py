"""What the page shows of a scene: the torque as `fembearing torque` gives it, over the speed too, and its files."""

import zipfile
from dataclasses import dataclass, replace
from io import BytesIO
from pathlib import Path

import numpy as np

from analytic.errors import FembearingError
from analytic.result import TorquePoint
from analytic.scene import Array, Contact, Scene
from analytic.scenefile.read import parse_scene
from analytic.words import pressure_of
from fembearing.app.scene_edit import ORIGIN
from fembearing.quantities import METRIC
from fembearing.report.headline import ABSENT, film_words, headline_title, makers_words, split_of
from fembearing.report.phrases import between
from fembearing.report.tables.points import point_name
from fembearing.report.torque import TorqueRecord, torque_record
from fembearing.report.torque_file import numbers_file, page_file, table_file
from fembearing.verify.contact.scene_contact import contact_of
from fembearing.verify.torque.scene_torque import SceneTorque, torque_of_scene

SPEEDS = np.array([0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0])  # of the curve, over the scene's own
SLICES = 4  # of the curve: between two of them the headline of a change comes first
RACES = "inner", "outer"


@dataclass(frozen=True, kw_only=True)
class Evaluation:
    """A scene with its torque. Of a series, parts, balls and contacts are those at its highest torque."""

    text: str  # of the scene
    result: SceneTorque
    record: TorqueRecord
    point: int  # with the highest torque, from 0
    contacts: dict[str, Contact]  # of the heaviest ball there, by race; empty where they are not known
    no_contact: str  # why they are not known; empty: they are

    @property
    def row(self) -> TorquePoint:
        """The point with the highest torque."""
        return self.record.points[self.point]

    @property
    def is_series(self) -> bool:
        """Whether the scene has several operating points."""
        return len(self.record.points) > 1

    @property
    def lines(self) -> dict[str, str]:
        """The lines that `fembearing torque` prints first, and captions, by their places on the page."""
        record, row, unit = self.record, self.row, METRIC.torque
        totals = [point.torque.total for point in record.points]
        ends = [each for each in record.interval if each is not None]
        known = len(ends) == len(totals)
        where = f"At {point_name(record.points, self.point, METRIC)}, the highest torque: " if self.is_series else ""
        lines = {
            "title": headline_title(self.result.scene, record),
            "torque": " to ".join(dict.fromkeys(f"{unit.number(end):.4g}" for end in (min(totals), max(totals)))),
            "unit": unit.name,
            "interval": f"95 %: {between((min(ends)[0], max(high for _, high in ends)), unit) if known else ABSENT}",
            "power": f"power {row.torque.total * abs(row.inner_speed):.3g} W",
            "verdict": record.standing.word,
            "reason": record.standing.reason,
            "split": f"{where}{split_of(row)}",
            "film": film_words(self.result) or "film: not computed without oil and surface",
            "makers": makers_words(record),
            "warnings": "\n".join(record.warnings),
            "ring": "Azimuth from the radial load, which points down."
            if row.ring
            else "Balls of a pair: `fembearing torque --details`.",
            "contact": self.no_contact or "Different scales of both axes.",
        }
        for race in RACES:
            contact = getattr(row.contact, race)
            lines[race] = f"{race} race: {contact.load:.4g} N, {pressure_of(contact.peak_pressure)}"
        return lines

    def number(self, key: str) -> float | None:
        """The value of a key of the operation or the oil at this point, SI; None: there is none."""
        table, _, name = key.partition(".")
        oil = self.result.scene.lubricant
        if table == "operation":
            return getattr(self.row, name)
        return None if oil is None else getattr(oil, name)


def evaluated(text: str) -> Evaluation:
    """The torque of the scene that a text describes. Raises InputError as the command does."""
    scene = parse_scene(text, origin=ORIGIN)
    result = torque_of_scene(scene)
    point, contacts, reason = int(np.argmax(result.friction.torque.total)), {}, ""
    here = {name: values[[point]] for name, values in vars(scene.operation.as_series()).items()}
    try:
        contacts = {race: contact_of(_at(scene, here), pair=race) for race in RACES}
    except FembearingError as problem:  # the torque is known all the same
        reason = str(problem)
    record = torque_record(result)
    return Evaluation(text=text, result=result, record=record, point=point, contacts=contacts, no_contact=reason)


def curve_scenes(found: Evaluation) -> list[Scene]:
    """The scene in slices of its curve over the speed, each from its slow to its fast end; none for a bearing at rest.

    Of a series the series itself.
    """
    scene = found.result.scene
    points = vars(scene.operation.as_series())
    if found.is_series:
        return [scene]
    if not np.any(points["inner_speed"]):
        return []
    slices = (points | {"inner_speed": points["inner_speed"] * SPEEDS[first::SLICES]} for first in range(SLICES))
    return [_at(scene, each) for each in slices]


def series_record(scene: Scene) -> TorqueRecord:
    """The torque at the points of a scene that have one, with intervals. Raises InputError where none has."""
    return torque_record(torque_of_scene(scene, keep_going=True))


def _at(scene: Scene, points: dict[str, Array]) -> Scene:
    """The scene at other operating points."""
    return replace(scene, operation=replace(scene.operation, **points))


def zip_of(found: Evaluation, report: Path | None) -> bytes:
    """Scene, tables, numbers and page of a torque as a ZIP file;  report : folder of the check; None: without"""
    content = BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("scene.toml", found.text)
        archive.writestr("torque.csv", table_file(found.result))
        archive.writestr("torque.json", numbers_file(found.result))
        archive.writestr("torque.html", page_file(found.result))
        for file in sorted(report.iterdir()) if report is not None else ():
            archive.write(file, f"report/{file.name}")
    return content.getvalue()
