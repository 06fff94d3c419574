"""The axes of a table: speeds, loads and oil temperatures, as ranges "0 rpm to 6000 rpm in 15" or as lists."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from analytic.columns import COORDINATES
from analytic.errors import InputError, real_numbers
from analytic.given import KEYS
from analytic.limits import usual_speed
from analytic.quantity import MOST, Range, range_of
from analytic.scene import Array, Scene
from analytic.scenefile.keys import scene_key
from analytic.scenefile.read import SceneByTemperature
from analytic.scenefile.setting import as_plain, read_setting
from analytic.units import METRIC
from analytic.words import NEWTON, RPM, Unit, plain, shown

Axes = Mapping[str, Array]  # by the names of OPTIONS, in their order; each ascending, SI
OPTIONS = ("speed", "axial_load", "radial_load", "temperature")
SHOWN: dict[str, Unit] = {"speed": RPM, "axial_load": NEWTON, "radial_load": NEWTON, "temperature": METRIC.temperature}
EXAMPLES = {
    "speed": "0 rpm to 6000 rpm in 15",
    "axial_load": "100 N to 1 kN in 5 log",
    "radial_load": "500 N to 5 kN in 5 log",
    "temperature": "40 degC to 100 degC in 4",
}
SPEEDS, LOADS, TEMPERATURES = 31, 5, 3  # values of an axis that is not given
SLOWEST = 1e-5  # first speed above standstill of such an axis, over the last one: slower, hardly any film forms
AROUND = 2.0  # such an axis of load ends at the scene's load over and times this
NEAR = 20.0  # K: and one of temperature so far from the scene's


def end_of(name: str, text: str) -> str:
    """The last value of a range or a list, or the one value. Raises InputError as `axis_values`."""
    if (parts := _range_of(name, text)) is not None:
        return parts.last
    value, _ = read_setting(KEYS[name], text)
    return str(value[-1]) if isinstance(value, list) and value else text


def axis_values(name: str, given: Any) -> Array:
    """The values of an axis, ascending, SI: of a range as text, of a list, or one alone.

    Raises InputError for a name that is no axis, units that do not fit, a range of one value, and an order that does
    not ascend.
    """
    if name not in OPTIONS:
        raise InputError(f"{plain(name)} is no axis of a table; give {', '.join(OPTIONS)}")
    parts = _range_of(name, given) if isinstance(given, str) else None
    values = _listed(name, given) if parts is None else _stepped(name, given, parts)
    if values.ndim != 1 or not values.size or values.size > MOST:
        raise InputError(f"{name} = {shown(str(given))} is no list of 1 to {MOST} values; give {EXAMPLES[name]!r}")
    if np.any(np.diff(values) <= 0):
        raise InputError(f"{name} = {shown(str(given))} does not ascend: give each value once, from the least up")
    if name == "speed" and values[0] < 0:
        first = RPM.written(float(values[0]), ".6g")
        raise InputError(f"speed begins at {first}: give 0 rpm or more, as the other direction has the same torque")
    return values


def _range_of(name: str, text: str) -> Range | None:
    try:
        return range_of(text)
    except ValueError as problem:
        raise InputError(f"{name} = {shown(text)} {problem}") from None


def _stepped(name: str, given: str, parts: Range) -> Array:
    ends = _one(name, parts.first), _one(name, parts.last)
    try:
        return parts.values(*ends)
    except ValueError as problem:
        raise InputError(f"{name} = {shown(given)} {problem}") from None


def _listed(name: str, given: Any) -> Array:
    given = as_plain(given)
    if not isinstance(given, str):
        numbers = given if isinstance(given, list) and any(isinstance(each, str) for each in given) else None
        return (
            np.atleast_1d(real_numbers(name, given)) if numbers is None else np.array([_one(name, e) for e in numbers])
        )
    value, _ = read_setting(KEYS[name], given)
    return np.array([_one(name, each) for each in (value if isinstance(value, list) else [value])])


def _one(name: str, text: Any) -> float:
    """One value in SI. Raises InputError for a text that the key of the scene does not take."""
    key = scene_key(KEYS[name])
    value, _ = read_setting(key.path, text)
    number = key.read_as(name, value)
    assert isinstance(number, float)
    return number


def axes_of(found: SceneByTemperature, over: Mapping[str, Any], *, whole: bool) -> dict[str, Array]:
    """The axes of a table of this scene.

    over : what is given, as for `axis_values`;  whole : loads and temperature are axes too where nothing is given,
        else they have the scene's one value, as the temperature always has where the oil is known at it alone
    Raises InputError as `axis_values`, for a temperature without an oil, and where the scene lacks a value or has
    several.
    """
    scene = found.scene
    given = {name: axis_values(name, values) for name, values in over.items() if values is not None}
    if scene.lubricant is None and "temperature" in given:
        raise InputError("temperature is of an oil, and the scene has none; leave it out, or give the scene an oil")
    operation = scene.operation.as_series()
    if np.ptp(operation.moment) > 0:
        raise InputError("operation.moment has several values in the scene; a table has one: give it one value")
    names = OPTIONS if scene.lubricant is not None else OPTIONS[:3]
    wide = {name: whole and (name != "temperature" or found.is_known_elsewhere) for name in names}
    return {name: given[name] if name in given else _usual(name, scene, whole=wide[name]) for name in names}


def _usual(name: str, scene: Scene, *, whole: bool) -> Array:
    """What an axis has where nothing is given."""
    operation = scene.operation.as_series()
    if name == "speed":
        fastest = max(float(np.abs(operation.inner_speed).max()), usual_speed(scene))
        return np.concatenate([[0.0], fastest * np.geomspace(SLOWEST, 1.0, SPEEDS - 1)])
    if name == "temperature":
        assert scene.lubricant is not None
        own = scene.lubricant.temperature
        return np.linspace(own - NEAR, own + NEAR, TEMPERATURES) if whole else np.array([own])
    values = np.unique(getattr(operation, name))
    if values.size == 1:
        one = values[0]
        return np.sort(np.geomspace(one / AROUND, one * AROUND, LOADS)) if whole and one else values
    if not whole:
        raise InputError(
            f"{COORDINATES[name].meaning} has {values.size} values in the scene, and this format takes one; give "
            f"{name}, for example '500 N'"
        )
    return np.linspace(values[0], values[-1], LOADS)


def axes_in_words(axes: Axes) -> str:
    """The size of the table and its ranges."""
    words = []
    for name, values in axes.items():
        unit = SHOWN[name]
        ends = [unit.written(float(value), ".5g") for value in values[[0, -1]]]
        words.append(f"{name.replace('_', ' ')} {' to '.join(dict.fromkeys(ends))} in {values.size}")
    return ", ".join(words)
