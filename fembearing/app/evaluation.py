"""What the page shows of a scene: the torque as `fembearing torque` gives it, over the speed too, and its files."""

import base64
import zipfile
from dataclasses import dataclass, replace
from functools import reduce
from html import escape
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from analytic import steady_scene
from analytic.columns import Point
from analytic.declared import Key
from analytic.errors import FembearingError
from analytic.scene import Array, Contact, Material, Scene
from analytic.scene_torque import with_interval
from analytic.scenefile.keys import Values, scene_key
from analytic.scenefile.read import parse_by_temperature
from analytic.units import SYSTEMS, Units
from analytic.words import pressure_of
from fembearing import SceneTorque, draw_bearing, torque_content, torque_headline, torque_of_scene
from fembearing.app.scene_edit import FIELDS, ORIGIN
from fembearing.check.contact.scene_contact import contact_of
from fembearing.report.sections.points import point_name

SPEEDS = np.array([0.1, 0.2, 0.35, 0.5, 0.7, 0.85, 1.0, 1.2, 1.4, 1.6, 1.8, 2.0])  # of the curve, over the scene's own
SLICES = 6  # of the curve: between two of them it ends where the scene has changed
RACES = "inner", "outer"


@dataclass(frozen=True, kw_only=True)
class Evaluation:
    """A scene with its torque. Of a series, parts, balls and contacts are those at its highest torque."""

    text: str  # of the scene
    derived: dict[str, str]  # what the torque was computed with, by the keys of the fields
    result: SceneTorque
    point: int  # with the highest torque, from 0
    contacts: dict[str, Contact]  # of the heaviest ball there, by race; empty where they are not known
    no_contact: str  # why they are not known; empty: they are

    @property
    def row(self) -> Point:
        """The point with the highest torque."""
        return self.result.points[self.point]

    @property
    def is_series(self) -> bool:
        """Whether the scene has several operating points."""
        return len(self.result.points) > 1

    @property
    def units(self) -> Units:
        """The system of units of the scene."""
        return SYSTEMS[self.result.scene.report.units]

    @property
    def lines(self) -> dict[str, str]:
        """The lines that `fembearing torque` prints first, and captions, by their places on the page."""
        head, row = torque_headline(self.result), self.row
        where = f"At {point_name(self.result.points, self.point, self.units)}, the highest torque: "
        lines = {
            "title": head.title,
            "torque": head.torque,
            "unit": head.unit,
            "interval": f"95 %: {head.interval}",
            "power": f"power {head.power} W",
            "verdict": head.verdict,
            "reason": head.reason,
            "split": f"{where}{head.split}" if self.is_series else "",
            "film": head.film or "film: not computed without oil and surface",
            "makers": head.makers,
            "warnings": "\n".join(self.result.friction.warnings),
            "ring": "Azimuth from the radial load, which points down."
            if self.result.friction.ring
            else "Balls of a pair: `fembearing torque --details`.",
            "contact": self.no_contact,
        }
        for race in RACES:
            load = self.units.force.written(row[f"load_{race}"], ".4g")
            lines[race] = f"{race} race: {load}, {pressure_of(row[f'peak_pressure_{race}'])}"
        return lines

    def number(self, key: str) -> float | None:
        """The value of a key of the operation or the oil at this point, SI; None: none, or friction settles it."""
        table, _, name = key.partition(".")
        oil = self.result.scene.lubricant
        if table == "operation":
            return self.row[name]
        return None if oil is None or name in oil.origins else getattr(oil, name)


def at_once(text: str) -> Evaluation:
    """The torque of the scene that a text describes, without its interval. Raises InputError as the command does."""
    read = parse_by_temperature(text, origin=ORIGIN)
    scene = steady_scene(read)
    result = torque_of_scene(scene, estimate=False)
    point, contacts, reason = int(np.argmax(result.friction.torque.total)), {}, ""
    here = scene.operation.as_series().at(np.array([point])).points
    try:
        contacts = {race: contact_of(_at(scene, here), pair=race) for race in RACES}
    except FembearingError as problem:  # the torque is known all the same
        reason = str(problem)
    derived = derived_values(read.values or Values({}), scene)
    return Evaluation(text=text, derived=derived, result=result, point=point, contacts=contacts, no_contact=reason)


def derived_values(values: Values, scene: Scene) -> dict[str, str]:
    """What a scene has for every field, given or not, by their keys;  values : of the keys in its text, and by rules"""
    bearing, cage, pair, tilt, found = scene.bearing, scene.cage, scene.arrangement, scene.operation.held_tilt, {}
    seen = {  # that have no attribute of their name, or none before others say it
        "arrangement.distance": pair and (pair.distance or bearing.width),
        "bearing.clearance": None
        if bearing.kind == "thrust"
        else scene.clearances.unmounted
        if scene.clearances
        else bearing.diametral_clearance,
        "cage.pocket_clearance": cage and cage.pocket_diameter - values["bearing.ball_diameter"],
        "operation.tilt": "free" if pair or np.isnan(tilt) else tilt,
    }
    for path in FIELDS:
        value = values[path]
        if value is None:
            value = seen.get(path, reduce(lambda it, name: getattr(it, name, None), path.split("."), scene))
        is_dry = path.startswith("lubricant.") and scene.lubricant is None  # though the keys have defaults
        found[path] = _written(scene_key(path), None if is_dry else value)
    return found


def _written(key: Key, value: Any) -> str:
    """A value as a field takes it;  value : SI, None: there is none"""
    if isinstance(value, list):
        return ", ".join(_written(key, each) for each in value)
    if isinstance(value, float) and key.dimension is not None:
        return f"{key.dimension.written(value)} {key.dimension.shown_unit}".rstrip()
    return "none" if value is None else value.name if isinstance(value, Material) else str(value)


def completed(found: Evaluation) -> Evaluation:
    """The same with its interval, which takes three times as long as all else."""
    return replace(found, result=with_interval(found.result))


def curve_scenes(found: Evaluation) -> list[Scene]:
    """The scene in slices of its curve over the speed, each from its slow to its fast end; none for a bearing at rest.

    Of a series the series itself.
    """
    scene = found.result.scene
    points = scene.operation.as_series().points
    if found.is_series:
        return [scene]
    if not np.any(points["inner_speed"]):
        return []
    slices = (points | {"inner_speed": points["inner_speed"] * SPEEDS[first::SLICES]} for first in range(SLICES))
    return [_at(scene, each) for each in slices]


def series_of(scene: Scene) -> SceneTorque:
    """The torque at the points of a scene that have one, with intervals. Raises InputError where none has."""
    return torque_of_scene(scene, keep_going=True)


def drawing_of(found: Evaluation) -> str:
    """The bearing to scale, as HTML. Raises InputError for dimensions that contradict each other."""
    from fembearing.report.figures.style import svg  # with matplotlib

    scene = found.result.scene
    content = base64.b64encode(svg(draw_bearing(scene))).decode()
    words = escape(f"{scene.bearing.name}: section through a ball and view along the axis, to scale, with dimensions")
    return f'<img src="data:image/svg+xml;base64,{content}" alt="{words}">'


def _at(scene: Scene, points: dict[str, Array]) -> Scene:
    """The scene at other operating points."""
    return replace(scene, operation=replace(scene.operation, **points))


def zip_of(found: Evaluation, report: Path | None) -> bytes:
    """Scene, tables, numbers and page of a torque as a ZIP file;  report : folder of the check; None: without"""
    content = BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("scene.toml", found.text)
        for ending in (".csv", ".json", ".html"):
            archive.writestr(f"torque{ending}", torque_content(found.result, ending=ending))
        for file in sorted(report.iterdir()) if report is not None else ():
            archive.write(file, f"report/{file.name}")
    return content.getvalue()
