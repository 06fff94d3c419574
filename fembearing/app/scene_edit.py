"""The text of a scene, as the page edits it: its fields show keys of the text and change their lines."""

import json
import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from math import isfinite
from typing import Any

from analytic import catalog, scene_text
from analytic.errors import InputError
from analytic.scenefile.find import parse_text
from analytic.scenefile.keys import scene_key, with_key
from analytic.scenefile.setting import read_setting
from analytic.scenefile.template import COLUMN
from analytic.units import METRIC
from analytic.words import NEWTON, RPM, Unit

ORIGIN = "scene"  # names the text in messages
CATALOG = "bearing.catalog"
# Beginnings of keys that another bearing takes over
KEPT = ("operation.", "lubricant.", "surface.", "mounting.", "arrangement.", "thermal.")
NEEDED = ("bearing", "operation", "lubricant", "surface")  # tables that stay when their last key leaves them
HEAD = re.compile(r"\s*(#?)\[\[?\s*([\w.]+)\s*\]")  # of a table, or of one that is a comment
VALUE = r"""("(?:[^"\\]|\\.)*"|\[[^\]]*\]|[^#]*?)\s*(#.*)?"""  # of a line, and its comment
OPERATION = (
    *("operation.radial_load", "operation.axial_load", "operation.inner_speed"),
    *("lubricant.name", "lubricant.temperature", "lubricant.supply", "surface.finish"),
)
DIMENSIONS = (
    *("bearing.ball_count", "bearing.ball_diameter", "bearing.pitch_diameter"),
    *("bearing.inner.conformity", "bearing.outer.conformity"),
    *("bearing.inner.shoulder_half_width", "bearing.outer.shoulder_half_width"),
    *("bearing.static_load_rating", "bearing.dynamic_load_rating"),
)
FOLDS: Mapping[str, tuple[str, ...]] = {  # keys of the fields of a panel, by its head
    "Seats and clearance": (
        *("bearing.clearance", "mounting.shaft_interference", "mounting.housing_interference"),
        *("mounting.inner_temperature", "mounting.outer_temperature"),
    ),
    "Moment and tilt": ("operation.moment", "operation.tilt"),
    "Pair of bearings": ("arrangement.kind", "arrangement.preload", "arrangement.offset", "arrangement.distance"),
    "Cage": ("cage.pocket_clearance", "cage.wall_thickness", "cage.mass", "cage.material"),
    "Seals and oil losses": ("losses.seals", "losses.drag", "losses.oil_share", "losses.oil_flow"),
    "Thermal resistance": ("thermal.resistance", "thermal.ambient"),
}
LABELS = {  # where the name of the key alone does not say it
    "operation.inner_speed": "Speed of the inner ring",
    "lubricant.name": "Oil or grease",
    "lubricant.temperature": "Oil temperature",
    "arrangement.kind": "Arrangement",
    "thermal.ambient": "Ambient temperature",
}
SLIDERS = {"N": NEWTON, "rad/s": RPM, "K": METRIC.temperature}  # by the SI unit of what a slider sets
LISTED = {
    "lubricant.name": catalog.oil_names(),
    "cage.material": ("steel", "peek", "brass"),
}  # other names are taken too


@dataclass(frozen=True, kw_only=True)
class Field:
    """An input of the page, as the declaration of its key has it."""

    label: str
    meaning: str  # with an example
    unit: Unit | None  # of its slider; None: it has none
    words: tuple[str, ...]  # that it offers
    is_choice: bool  # whether it takes nothing else


def _field(path: str) -> Field:
    key = scene_key(path)
    dimension = key.dimension
    words = getattr(dimension or key.kind, "words", ())
    return Field(
        label=LABELS.get(path, path.partition(".")[2].replace(".", " ").replace("_", " ").capitalize()),
        meaning="; ".join(filter(None, (key.meaning, key.accepted))),
        unit=SLIDERS.get(dimension.unit) if dimension and path in OPERATION else None,
        words=LISTED.get(path, words),
        is_choice=bool(words) and dimension is None,
    )


FIELDS: Mapping[str, Field] = {
    path: _field(path) for paths in (OPERATION, DIMENSIONS, *FOLDS.values()) for path in paths
}


def values_in(text: str) -> dict[str, Any]:
    """The values of bearing and fields by their keys, as the text has them. Raises InputError for what is no TOML."""
    document = parse_text(text, origin=ORIGIN)
    found = {}
    for key in (CATALOG, *FIELDS):
        value: Any = document
        for part in key.split("."):
            value = value.get(part) if isinstance(value, dict) else None
        if value is not None:
            found[key] = value
    return found


def shown_value(value: object) -> str:
    """A value as its field shows it; a series as a list."""
    return value if isinstance(value, str) else json.dumps(value, ensure_ascii=False)


def with_typed(text: str, key: str, typed: str) -> tuple[str, list[str]]:
    """The text with what a user types into a field, and notes on how that was read; an empty field leaves the key out.

    Raises InputError for an ambiguous number, and as `with_value`.
    """
    if not typed.strip():
        return with_value(text, key, None), []
    value, notes = read_setting(key, typed)
    if isinstance(value, float) and not isfinite(value):  # refused, and no number of JSON
        scene_key(key).read_as(f"{ORIGIN}: {key}", value)
    return with_value(text, key, value), notes


def with_value(text: str, key: str, value: Any) -> str:
    """The text with another value of a key, in its line; None leaves the key out. Comments stay.

    Raises InputError for a text that is no TOML, or that has the key elsewhere than in a line of its table.
    """
    before = parse_text(text, origin=ORIGIN)
    changed = _with_line(text, key, None if value is None else json.dumps(value, ensure_ascii=False))
    wanted = with_key(before, key, value) if value is not None else _without(before, key)
    with suppress(InputError):
        if parse_text(changed, origin=ORIGIN) == wanted:
            return changed
    raise InputError(
        f"{key} does not stand in a line of its own below [{key.partition('.')[0]}]: change it in the scene"
    )


def _without(document: dict[str, Any], path: str) -> dict[str, Any]:
    """The document without a key, and without a table that has no other, where a scene does not need it."""
    name, _, rest = path.partition(".")
    others = {each: value for each, value in document.items() if each != name}
    if not rest:
        return others
    inside = document.get(name)
    if not isinstance(inside, dict):
        return document
    left = _without(inside, rest)
    return document | {name: left} if left or (path in FIELDS and name in NEEDED) else others


def _with_line(text: str, key: str, value: str | None) -> str:
    """The text with the line of a key changed, put in, or made a comment; a comment with this key gives its place."""
    table, _, name = key.partition(".")
    lines = text.split("\n")
    begin = _head_of(lines, table)
    if begin is None:
        return text if value is None else f"{text.rstrip()}\n\n[{table}]\n{name} = {value}\n"
    places = {
        mark: number
        for number in reversed(_lines_of(lines, table))
        for mark in ("", "#")
        if re.match(rf"\s*{mark}\s*{re.escape(name)}\s*=", lines[number])
    }
    place = places.get("", places.get("#"))
    if value is None:
        if "" in places:
            lines[places[""]] = f"#{lines[places['']].lstrip()}"
            if table not in NEEDED and not any(_is_set(lines[each]) for each in _lines_of(lines, table)):
                lines[begin] = f"#{lines[begin]}"
        return "\n".join(lines)
    lines[begin] = lines[begin].lstrip("#")
    if place is None:
        lines.insert(begin + 1, f"{name} = {value}")
    else:
        found = re.fullmatch(rf"\s*#?\s*{re.escape(name)}\s*=\s*{VALUE}", lines[place])
        comment = found[2] if found and found[2] else ""
        lines[place] = f"{f'{name} = {value}':<{COLUMN}} {comment}".rstrip()
    return "\n".join(lines)


def _head_of(lines: list[str], table: str) -> int | None:
    """The line of the head of a table, else of the comment that has it; None: neither."""
    heads = [(number, found) for number, line in enumerate(lines) if (found := HEAD.match(line)) and found[2] == table]
    return next((number for number, found in heads if not found[1]), heads[0][0] if heads else None)


def _lines_of(lines: list[str], table: str) -> range:
    """The lines below the head of a table, to the next head."""
    begin = _head_of(lines, table)
    if begin is None:
        return range(0)
    after = range(begin + 1, len(lines))
    return range(begin + 1, next((each for each in after if HEAD.match(lines[each])), len(lines)))


def _is_set(line: str) -> bool:
    return bool(line.strip()) and not line.lstrip().startswith("#")


def of_bearing(designation: str, before: str) -> str:
    """The usual scene of a bearing, with what the scene before has otherwise than the usual one of its own bearing.

    Its dimensions, its clearance, its cage and its losses are its own.
    Raises InputError for a designation that the catalogue does not have.
    """
    text, given, usual = scene_text(designation), {}, {}
    with suppress(InputError):
        given = values_in(before)
        usual = values_in(scene_text(str(given.get(CATALOG))))
    for key in FIELDS:
        if key.startswith(KEPT) and given.get(key) != usual.get(key):
            text = with_value(text, key, given.get(key))
    return text


def field_in(problem: str) -> str | None:
    """The key of the field that a message is about; None: of no field."""
    return next((key for key in (CATALOG, *FIELDS) if key in problem), None)
