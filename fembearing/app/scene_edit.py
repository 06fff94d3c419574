"""The text of a scene, as the page edits it: its fields show keys of the text and change their lines."""

import json
import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from analytic import catalog, scene_text
from analytic.errors import InputError
from analytic.scenefile.keys import scene_key, with_key
from analytic.scenefile.setting import read_setting
from analytic.scenefile.template import COLUMN
from analytic.scenefile.text import parse_text
from analytic.units import METRIC
from analytic.words import NEWTON, RPM, Unit

ORIGIN = "scene"  # names the text in messages
CATALOG = "bearing.catalog"
KEPT = ("operation.", "lubricant.", "surface.", "mounting.")  # beginnings of keys that another bearing takes over
CAGE, MOUNTING = "cage", "mounting"  # tables that a scene of the catalogue has as comments
HEAD = re.compile(r"\s*(#?)\[\[?\s*([\w.]+)\s*\]")  # of a table, or of one that is a comment
KEY = re.compile(r"#[a-z_.]+\s*=")  # that is a comment
VALUE = r"""("(?:[^"\\]|\\.)*"|\[[^\]]*\]|[^#]*?)\s*(#.*)?"""  # of a line, and its comment


@dataclass(frozen=True, kw_only=True)
class Field:
    """An input of the page."""

    label: str
    example: str  # of what it takes; of words to choose from: what no choice means
    unit: Unit | None = None  # of its slider; None: it has none
    words: tuple[str, ...] = ()  # to choose from; empty: any text


SLIDERS = {"N": NEWTON, "rad/s": RPM, "K": METRIC.temperature}  # by the SI unit of what a slider sets


def _fields(*rows: tuple[str, str, str], sliders: Mapping[str, Unit] | None = None) -> Mapping[str, Field]:
    """Fields by key, of rows of key, label and example; empty: that of the key's declaration."""
    made = {}
    for path, label, example in rows:
        key = scene_key(path)
        dimension, words = key.dimension, () if key.dimension else getattr(key.kind, "words", ())
        shown = example or (dimension.example.strip('"') if dimension else "")
        unit = sliders.get(dimension.unit) if dimension and sliders else None
        made[path] = Field(label=label, example=shown, unit=unit, words=LISTED.get(path, words))
    return made


LISTED = {
    "lubricant.name": catalog.oil_names(),
    "cage.material": ("steel", "peek", "brass"),
}  # other names are taken too
OPERATION = _fields(
    ("operation.radial_load", "Radial load", ""),
    ("operation.axial_load", "Axial load", ""),
    ("operation.inner_speed", "Speed of the inner ring", ""),
    ("lubricant.name", "Oil or grease", "ISO VG 68"),
    ("lubricant.temperature", "Oil temperature", ""),
    ("lubricant.supply", "Supply", "oil bath, or grease of a grease"),
    ("surface.finish", "Finish", "as the scene has it"),
    sliders=SLIDERS,
)
DIMENSIONS = _fields(
    ("bearing.ball_count", "Number of balls", "9"),
    ("bearing.ball_diameter", "Ball diameter", ""),
    ("bearing.pitch_diameter", "Pitch diameter", "46 mm"),
    ("bearing.inner.conformity", "Conformity of the inner groove", ""),
    ("bearing.outer.conformity", "Conformity of the outer groove", ""),
    ("bearing.inner.shoulder_half_width", "Half width of the inner groove", "3.9 mm"),
    ("bearing.outer.shoulder_half_width", "Half width of the outer groove", "4.0 mm"),
)
SEATS = _fields(
    ("bearing.clearance", "Clearance, unmounted", "CN, C3 or 12 um"),
    ("mounting.shaft_interference", "Interference of the shaft seat", "none, as 5 um; negative: loose"),
    ("mounting.housing_interference", "Interference of the housing seat", "none, as -5 um"),
    ("mounting.inner_temperature", "Temperature of inner ring and shaft", "as mounted, or 65 degC"),
    ("mounting.outer_temperature", "Temperature of outer ring and housing", "as mounted, or 60 degC"),
)
POCKETS = _fields(
    ("cage.pocket_clearance", "Pocket clearance", ""),
    ("cage.wall_thickness", "Wall thickness", "1.1 mm"),
    ("cage.mass", "Mass", "11 g"),
    ("cage.material", "Material", "steel, peek, brass"),
)
FIELDS: Mapping[str, Field] = {**OPERATION, **DIMENSIONS, **SEATS, **POCKETS}


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


def has_table(text: str, table: str) -> bool:
    """Whether the scene has this table. Raises InputError for what is no TOML."""
    return table in parse_text(text, origin=ORIGIN)


def commented_value(text: str, key: str) -> str:
    """The value that a comment of the text has for a key, as `#ball_diameter = "9.525 mm"`; empty: none."""
    table, _, name = key.partition(".")
    lines = text.split("\n")
    for number in _lines_of(lines, table):
        found = re.fullmatch(rf"\s*#{re.escape(name)}\s*=\s*{VALUE}", lines[number])
        if found:
            return found[1].strip('"')
    return ""


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
    """The document without a key, and without what has no other: a dotted key, or the table of the seats."""
    name, _, rest = path.partition(".")
    others = {each: value for each, value in document.items() if each != name}
    if not rest:
        return others
    inside = document.get(name)
    if not isinstance(inside, dict):
        return document
    left = _without(inside, rest)
    return document | {name: left} if left or (path in FIELDS and name != MOUNTING) else others


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
            if table == MOUNTING and not any(_is_set(lines[each]) for each in _lines_of(lines, table)):
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


def with_cage(text: str, *, has_cage: bool) -> str:
    """The text with the table of a cage, or with this table as comments.

    A text without both gets the usual cage of its bearing, or the head alone where the bearing has no designation.
    """
    if has_table(text, CAGE) == has_cage:
        return text
    lines = text.split("\n")
    head = _head_of(lines, CAGE)
    if head is None:
        usual = scene_text(str(values_in(text)[CATALOG])).split("\n") if CATALOG in values_in(text) else [f"#[{CAGE}]"]
        begin = _head_of(usual, CAGE)
        assert begin is not None, "a scene of the catalogue has it"
        return with_cage("\n".join([text.rstrip(), "", *usual[begin : _lines_of(usual, CAGE).stop]]), has_cage=True)
    for number in (head, *_lines_of(lines, CAGE)):
        line = lines[number]
        if has_cage and (number == head or KEY.match(line)):
            lines[number] = line.removeprefix("#")
        elif not has_cage and _is_set(line):
            lines[number] = f"#{line}"
    return "\n".join(lines)


def of_bearing(designation: str, before: str) -> str:
    """The usual scene of a bearing, with what the scene before has otherwise than the usual one of its own bearing.

    Its dimensions and its clearance are its own; where the scene before has a cage, it has the usual one.
    Raises InputError for a designation that the catalogue does not have.
    """
    text, given, usual = scene_text(designation), {}, {}
    with suppress(InputError):
        given = values_in(before)
        text = with_cage(text, has_cage=has_table(before, CAGE))
        usual = values_in(scene_text(str(given.get(CATALOG))))
    for key in FIELDS:
        if key.startswith(KEPT) and key in given and given[key] != usual.get(key):
            text = with_value(text, key, given[key])
    return text


def with_dimensions(text: str) -> str:
    """The text with the dimensions inside the bearing as keys to edit, where it has them as comments."""
    head, mark, rest = text.partition("[bearing]\n")
    inside, end, after = rest.partition("\n[")
    inside = re.sub(r"^#([a-z_.]+ = )", r"\1", inside, flags=re.MULTILINE)
    return f"{head}{mark}{inside}{end}{after}"


def field_in(problem: str) -> str | None:
    """The key of the field that a message is about; None: of no field."""
    return next((key for key in (CATALOG, *FIELDS) if key in problem), None)
