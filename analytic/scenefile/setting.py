"""Values of keys that are given beside a scene, by options or by settings of any key, in the form of a scene file.

People type them, so a speed without a unit is in rpm, which it is not in a scene file. Numbers from Python are SI.
"""

import re
import tomllib
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from typing import Any

import numpy as np

from analytic.declared import Table
from analytic.errors import InputError
from analytic.given import KEYS, SceneOptions, has_unit
from analytic.quantity import NUMBER, SI, Dimension, range_of
from analytic.scenefile.find import parse_text
from analytic.scenefile.keys import scene_key, scene_table
from analytic.words import plain, shown, speed_of

LIKE_RPM = 100  # rad/s: a whole number from here on is more often one of rpm
SEVERAL = re.compile(r"(?<=[^\W\d_%])\s*[,;]\s*")  # between quantities of a list
SETTING = "give KEY=VALUE, for example --set lubricant.supply=grease"


def given_values(settings: Mapping[str, Any], options: Mapping[str, Any]) -> tuple[dict[str, Any], tuple[str, ...]]:
    """What settings and options give, by key, in the form of a scene file, and notes on how it was read.

    Raises InputError for an unknown option, an unknown key, and a key that both give.
    """
    if not isinstance(settings, Mapping):
        raise InputError(
            f'settings = {shown(settings)} is no mapping; give for example {{"lubricant.supply": "grease"}}'
        )
    asked: dict[str, Any] = {}
    for path, value in settings.items():
        for key, inside in _flat(path, value):
            if key in asked:
                raise InputError(f"{plain(key)} is given twice: leave one of them out")
            asked[key] = inside
    for name, value in options.items():
        if name not in KEYS:
            near = get_close_matches(name, KEYS, n=1)
            remedy = f"did you mean {near[0]}?" if near else f"give {', '.join(KEYS)}, or the key in settings"
            raise InputError(f"{plain(name)} is no option of a bearing; {remedy}")
        if value is None:
            continue
        if KEYS[name] in asked:
            raise InputError(f"{name} = {shown(value)} and {KEYS[name]} are the same: leave one of them out")
        asked[KEYS[name]] = value
    values, notes = {}, []
    for path, value in asked.items():
        above = next((other for other in asked if path.startswith(f"{other}.")), None)
        if above is not None:
            raise InputError(f"{above} = {shown(asked[above])} and {path} exclude each other: leave one of them out")
        values[path], told = read_setting(path, value)
        notes += told
    return values, tuple(notes)


def _flat(path: object, given: Any) -> Iterator[tuple[str, Any]]:
    """The keys of a setting: itself, or those of the table that is given for it."""
    if not isinstance(path, str) or not all(path.split(".")):
        raise InputError(f"{shown(path)} is no key of a scene file; give its path, as 'operation.axial_load'")
    is_text = isinstance(given, str) and given.lstrip().startswith("{")
    table = _toml_value(path, given) if is_text else as_plain(given)
    if not isinstance(table, Mapping) or not isinstance(scene_table().find(path), Table):
        yield path, given
        return
    for name, inside in table.items():
        yield from _flat(f"{path}.{name}" if isinstance(name, str) else name, inside)


def require_nothing_beside(given: SceneOptions) -> None:
    """Raises InputError for anything that is given beside a Scene."""
    if not given:
        return
    unknown = sorted({*given} - SceneOptions.__optional_keys__)
    if unknown:
        raise InputError(f"{unknown[0]} is no argument of this function, nor one that goes with a designation")
    raise InputError(f"{min(given)} goes with a designation as 6308; change a Scene by dataclasses.replace")


def typed_settings(texts: list[str]) -> dict[str, str]:
    """Settings as "key=value" by key. Raises InputError for one that is none, and for a key that stands twice."""
    settings: dict[str, str] = {}
    for text in texts:
        key, mark, value = (part.strip() for part in text.partition("="))
        if not (mark and key and value):
            raise InputError(f"--set {shown(text)} is no setting; {SETTING}")
        if key in settings:
            raise InputError(f"--set {plain(key)} is given twice: leave one of them out")
        settings[key] = value
    return settings


def read_setting(path: str, given: Any, *, root: Table | None = None) -> tuple[Any, list[str]]:
    """The value of a key as a scene file has it, and notes on how it was read.

    root : whose key it is
    given : a text, as it is typed; or from Python a number in SI, a quantity, a switch, a list, or a table
    Raises InputError for an unknown key; the value itself is checked with the scene.
    """
    value = as_plain(given)
    is_typed = isinstance(value, str)
    table = _toml_value(path, value) if is_typed and value.lstrip().startswith("{") else value
    if isinstance(table, dict):
        return (table if is_typed else in_si(table, path)), []
    key = scene_key(path, root=root)
    if is_typed and not key.takes_text:
        value = _toml_value(path, value)
    if key.dimension is None:
        return value, []
    notes: list[str] = []
    if is_typed and key.in_series and isinstance(value, str) and len(parts := SEVERAL.split(value)) > 1:
        value = parts
    if is_typed and key.in_series and isinstance(value, str) and " to " in value:
        return _in_range(path, key.dimension, value, notes), notes
    parts = [*value] if isinstance(value, list | tuple) else [value]
    read = [_in_context(path, key.dimension, part, notes=notes, is_typed=is_typed) for part in parts]
    return (read if isinstance(value, list | tuple) else read[0]), notes


def _in_range(path: str, dimension: Dimension, text: str, notes: list[str]) -> str:
    """A range as a scene file has it. Raises InputError for one without its number of values."""
    try:
        found = range_of(text)
    except ValueError as problem:
        raise InputError(f"{path} = {shown(text)} {problem}") from None
    assert found is not None
    first, last = (_in_context(path, dimension, end, notes=notes, is_typed=True) for end in (found.first, found.last))
    return f"{first} to {last} in {found.size}{' log' if found.log else ''}"


def _toml_value(path: str, text: str) -> Any:
    """The text as a value of TOML: a number, a switch, a text in quotes, a list of them, a table; else the text.

    Raises InputError for a list or a table that is not TOML.
    """
    is_inside = text.lstrip()[:1] in ("[", "{")
    if "\n" in text or ("#" in text and not is_inside and text.lstrip()[:1] not in ("'", '"')):
        return text
    try:
        value = tomllib.loads(f"value = {text}")["value"]
    except (ValueError, RecursionError):
        return parse_text(f"{path} = {text}", origin="--set") if is_inside else text
    parts = value if isinstance(value, list) else [value]
    if isinstance(value, dict):
        return value
    return value if all(isinstance(part, str | int | float) for part in parts) else text


def _in_context(path: str, dimension: Dimension, value: Any, *, notes: list[str], is_typed: bool) -> Any:
    """A quantity as a scene file has it; what is none is left for the scene to refuse."""
    is_speed = dimension.unit == "rad/s"
    if isinstance(value, int | float) and not isinstance(value, bool):
        if not is_typed:
            if is_speed and float(value).is_integer() and abs(value) >= LIKE_RPM and not notes:
                notes.append(
                    f'{path} = {value!r} is in rad/s, {speed_of(value)}; write "{value:g} rpm" if it is in rpm'
                )
            return SI(value, dimension.unit) if dimension.unit else value
        if not is_speed:
            return value
        value = repr(value)
    if not isinstance(value, str):
        return value
    try:
        text = dimension.tidy(value)
    except ValueError:
        return value
    if (dimension.unit and not is_speed) or not re.fullmatch(NUMBER, text, re.ASCII):
        return text
    if not dimension.unit:
        return float(text)
    notes.append(f"{path} = {text} has no unit and is read as {text} rpm")
    return f"{text} rpm"


def as_plain(value: Any) -> Any:
    """A value of Python as a scene has it.

    A quantity of pint is a text, "20.0 degree_Celsius", numbers of NumPy are those of Python, and arrays are lists.
    """
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [as_plain(each) for each in value]
    if isinstance(value, Mapping):
        return {key: as_plain(each) for key, each in value.items()}
    if not has_unit(value):
        return value
    numbers, unit = np.asarray(value.magnitude), f"{value.units:C}"
    if numbers.ndim > 1 or numbers.dtype.kind not in "fiu":
        return value
    return [f"{number!r} {unit}" for number in numbers.tolist()] if numbers.ndim else f"{numbers.item()!r} {unit}"


def in_si(value: Any, path: str) -> Any:
    """A value of Python as a scene has it, or a table of them, with the numbers of quantities in SI; path : its key."""
    value = as_plain(value)
    if isinstance(value, Mapping):
        return {key: in_si(each, f"{path}.{key}") for key, each in value.items()}
    if isinstance(value, list):
        return [in_si(each, path) for each in value]
    if not isinstance(value, int | float) or isinstance(value, bool):
        return value
    dimension = scene_key(path).dimension
    return SI(value, dimension.unit) if dimension is not None and dimension.unit else value
