"""The text of a scene, as the page edits it: its fields show keys of the text and change their lines."""

import json
import re
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from typing import Any, get_args

from analytic import catalog
from analytic.errors import InputError
from analytic.scene import Supply
from analytic.scenefile.keys import with_key
from analytic.scenefile.setting import read_setting
from analytic.scenefile.template import COLUMN, scene_text
from analytic.scenefile.text import parse_text
from analytic.words import NEWTON, RPM, Unit
from fembearing.quantities import METRIC

ORIGIN = "scene"  # names the text in messages
CATALOG = "bearing.catalog"
VALUE = r"""("(?:[^"\\]|\\.)*"|\[[^\]]*\]|[^#]*?)\s*(#.*)?"""  # of a line, and its comment


@dataclass(frozen=True, kw_only=True)
class Field:
    """An input of the page."""

    label: str
    example: str  # of what it takes; of words to choose from: what no choice means
    unit: Unit | None = None  # of its slider; None: it has none
    words: tuple[str, ...] = ()  # to choose from; empty: any text


FIELDS: Mapping[str, Field] = {
    "operation.radial_load": Field(label="Radial load", example="2 kN", unit=NEWTON),
    "operation.axial_load": Field(label="Axial load", example="500 N", unit=NEWTON),
    "operation.inner_speed": Field(label="Speed of the inner ring", example="1500 rpm", unit=RPM),
    "lubricant.name": Field(label="Oil or grease", example="ISO VG 68", words=catalog.oil_names()),
    "lubricant.temperature": Field(label="Oil temperature", example="60 degC", unit=METRIC.temperature),
    "lubricant.supply": Field(label="Supply", example="oil bath, or grease of a grease", words=get_args(Supply)),
    "surface.finish": Field(label="Finish", example="as the scene has it", words=tuple(catalog.rows("finishes"))),
}


def values_in(text: str) -> dict[str, Any]:
    """The values of bearing and fields by their keys, as the text has them. Raises InputError for what is no TOML."""
    document = parse_text(text, origin=ORIGIN)
    found = {}
    for key in (CATALOG, *FIELDS):
        table, _, name = key.partition(".")
        inside = document.get(table)
        if isinstance(inside, dict) and name in inside:
            found[key] = inside[name]
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


def _without(document: dict[str, Any], key: str) -> dict[str, Any]:
    table, _, name = key.partition(".")
    inside = document.get(table, {})
    if not isinstance(inside, dict) or name not in inside:
        return document
    return document | {table: {each: value for each, value in inside.items() if each != name}}


def _with_line(text: str, key: str, value: str | None) -> str:
    """The text with the line of a key changed, put in, or made a comment; a comment with this key gives its place."""
    table, _, name = key.partition(".")
    lines = text.split("\n")
    heads = [number for number, line in enumerate(lines) if re.match(r"\s*\[", line)]
    begin = next((each for each in heads if re.match(rf"\s*\[\s*{table}\s*\]", lines[each])), None)
    if begin is None:
        return text if value is None else f"{text.rstrip()}\n\n[{table}]\n{name} = {value}\n"
    end = next((each for each in heads if each > begin), len(lines))
    places = {
        mark: number
        for number in reversed(range(begin + 1, end))
        for mark in ("", "#")
        if re.match(rf"\s*{mark}\s*{name}\s*=", lines[number])
    }
    place = places.get("", places.get("#"))
    if value is None:
        if "" in places:
            lines[places[""]] = f"#{lines[places['']].lstrip()}"
    elif place is None:
        lines.insert(begin + 1, f"{name} = {value}")
    else:
        found = re.fullmatch(rf"\s*#?\s*{name}\s*=\s*{VALUE}", lines[place])
        comment = found[2] if found and found[2] else ""
        lines[place] = f"{f'{name} = {value}':<{COLUMN}} {comment}".rstrip()
    return "\n".join(lines)


def of_bearing(designation: str, before: str) -> str:
    """The usual scene of a bearing, with what the scene before has otherwise than the usual one of its own bearing.

    Raises InputError for a designation that the catalogue does not have.
    """
    text, given, usual = scene_text(designation), {}, {}
    with suppress(InputError):
        given = values_in(before)
        usual = values_in(scene_text(str(given.get(CATALOG))))
    for key in FIELDS:
        if key in given and given[key] != usual.get(key):
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
