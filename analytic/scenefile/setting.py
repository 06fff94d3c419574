"""Values of keys that are given beside a scene: by options of a bearing of the catalogue, and by settings of any key.

People type them, so a speed without a unit is in rpm, which it is not in a scene file. Numbers from Python are SI.
"""

import re
import tomllib
from collections.abc import Mapping
from dataclasses import replace
from difflib import get_close_matches
from typing import Any

import numpy as np

from analytic.errors import InputError
from analytic.scenefile.choice import KEYS, LOADS, OTHER_LOADS, Choice
from analytic.scenefile.columns import OPERATING
from analytic.scenefile.keys import scene_key
from analytic.scenefile.quantity import NUMBER, Dimension, Range, range_of
from analytic.scenefile.table import Table
from analytic.scenefile.tables import SceneTable
from analytic.units import has_unit
from analytic.words import plain, shown, speed_of

LIKE_RPM = 100  # rad/s: an integer from here on is more often one of rpm
SETTING = "give KEY=VALUE, for example --set lubricant.supply=grease"


def read_choice(options: Mapping[str, Any]) -> tuple[Choice, tuple[str, ...]]:
    """What options give, and notes on how it was read; None: not given. Raises InputError for an unknown option."""
    values, notes = {}, []
    for name, given in options.items():
        if name not in KEYS:
            near = get_close_matches(name, KEYS, n=1)
            remedy = f"did you mean {near[0]}?" if near else f"give {', '.join(KEYS)}, or the key in settings"
            raise InputError(f"{plain(name)} is no option of a bearing; {remedy}")
        if given is not None:
            values[name], note = read_setting(KEYS[name], given)
            notes += note
    return Choice(**values), tuple(notes)


def with_settings(choice: Choice, settings: Mapping[str, Any]) -> Choice:
    """The choice with what settings give by the keys of its fields; no usual load stands beside another load.

    Its usual oil then suits a speed and a temperature that settings give. settings : by key, as for `load_scene`
    """
    choice = replace(
        choice, **{name: read_setting(key, settings[key])[0] for name, key in KEYS.items() if key in settings}
    )
    if has_load(choice) or not {*OTHER_LOADS} & settings.keys():
        return choice
    return replace(choice, radial_load="0 N")


def has_load(choice: Choice) -> bool:
    """Whether the choice itself gives a load, so that there is no usual one."""
    return any(getattr(choice, name) is not None for name in LOADS)


def with_columns(choice: Choice, columns: Mapping[str, Any]) -> Choice:
    """The choice with the loads of the heaviest row of a file, and speed and temperature of its fastest row.

    No usual load is added to those of the file, and the usual oil suits its speed.
    columns : by name, (n,), SI; None, or no entry: the file has no such column
    """
    given = {name: values for name in OPERATING if (values := columns.get(name)) is not None}
    loads = {name: values for name, values in given.items() if name in LOADS}
    if loads:
        row = int(np.argmax(np.sum(np.abs([*loads.values()]), axis=0)))
        choice = replace(choice, **{name: f"{float(values[row])!r} N" for name, values in loads.items()})
    row = int(np.argmax(np.abs(given["inner_speed"]))) if "inner_speed" in given else 0
    if "inner_speed" in given:
        choice = replace(choice, speed=f"{float(given['inner_speed'][row])!r} rad/s")
    if "temperature" in given:
        choice = replace(choice, temperature=f"{float(given['temperature'][row])!r} K")
    return choice


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


def read_setting(path: str, given: Any, *, root: type[Table] = SceneTable) -> tuple[Any, list[str]]:
    """The value of a key as a scene file has it, and notes on how it was read.

    root : whose key it is
    given : a text, as it is typed; or from Python a number in SI, a quantity, a switch, a list, or a table
    Raises InputError for an unknown key; the value itself is checked with the scene.
    """
    value = as_text(given)
    is_typed = isinstance(value, str)
    table = _toml_value(value) if is_typed and value.lstrip().startswith("{") else value
    if isinstance(table, dict):
        return table, []
    key = scene_key(path, root=root)
    if is_typed and not key.takes_text:
        value = _toml_value(value)
    if key.dimension is None:
        return value, []
    notes: list[str] = []
    if is_typed and key.in_series and (found := _range_at(path, value)) is not None:
        first, last = (
            _in_context(path, key.dimension, end, notes=notes, is_typed=True) for end in (found.first, found.last)
        )
        return f"{first} to {last} in {found.size}{' log' if found.log else ''}", notes
    parts = [*value] if isinstance(value, list | tuple) else [value]
    read = [_in_context(path, key.dimension, part, notes=notes, is_typed=is_typed) for part in parts]
    return (read if isinstance(value, list | tuple) else read[0]), notes


def _range_at(path: str, value: Any) -> Range | None:
    """The parts of a range. Raises InputError as `range_of` for one without its number of values."""
    try:
        return range_of(value) if isinstance(value, str) else None
    except ValueError as problem:
        raise InputError(f"{path} = {shown(value)} {problem}") from None


def _toml_value(text: str) -> Any:
    """The text as a value of TOML: a number, a switch, a text in quotes, a list of them, a table; else the text."""
    try:
        value = tomllib.loads(f"value = {text}")["value"]
    except (ValueError, RecursionError):
        return text
    parts = value if isinstance(value, list) else [value]
    if isinstance(value, dict):
        return value
    return value if all(isinstance(part, str | int | float) for part in parts) else text


def _in_context(path: str, dimension: Dimension, value: Any, *, notes: list[str], is_typed: bool) -> Any:
    """A quantity as a scene file has it; what is none is left for the scene to refuse."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        if not dimension.unit:
            return value
        if not is_typed:
            if dimension.unit == "rad/s" and isinstance(value, int) and abs(value) >= LIKE_RPM:
                notes.append(
                    f'{path} = {value!r} is in rad/s, {speed_of(value)}; write "{value!r} rpm" if it is in rpm'
                )
            return f"{value!r} {dimension.unit}"
        if dimension.unit != "rad/s":
            return value
        value = repr(value)
    if not isinstance(value, str):
        return value
    try:
        text = dimension.tidy(value)
    except ValueError:
        return value
    if dimension.unit not in ("", "rad/s") or not re.fullmatch(NUMBER, text, re.ASCII):
        return text
    if not dimension.unit:
        return float(text)
    notes.append(f"{path} = {text} has no unit and is read as {text} rpm")
    return f"{text} rpm"


def as_text(value: Any) -> Any:
    """A value of Python as a scene has it.

    A quantity of pint is a text, "20.0 degree_Celsius", numbers of NumPy are those of Python, and arrays are lists.
    """
    if isinstance(value, np.ndarray | np.generic):
        return value.tolist()
    if isinstance(value, list | tuple):
        return [as_text(each) for each in value]
    if not has_unit(value):
        return value
    numbers, unit = np.asarray(value.magnitude), f"{value.units:C}"
    if numbers.ndim > 1 or numbers.dtype.kind not in "fiu":
        return value
    return [f"{number!r} {unit}" for number in numbers.tolist()] if numbers.ndim else f"{numbers.item()!r} {unit}"
