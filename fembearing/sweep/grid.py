"""The grid of a sweep: a TOML file with a scene and the axes whose product is computed.

    what = "torque"           # or "contact", by finite elements
    scene = "bearing.toml"    # path from the folder of the grid file, a built-in scene, a bearing, or a table
    [axes]                    # keys of the scene, and keys of sweeps: pair, ball_load, geometry
    operation.axial_load = { from = "100 N", to = "2 kN", count = 20, spacing = "log" }
    operation.inner_speed = ["100 rpm", "300 rpm"]

For a torque, `samples = 512` above [axes] computes its 95 % interval, from so many torques at each point. For a
contact, `pair`, `ball_load`, `geometry` and `accuracy` may stand above [axes] too, for the whole sweep.
"""

import os
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from math import prod
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from analytic.errors import InputError
from analytic.scene import Pair, Scene
from analytic.scenefile.find import find_scene
from analytic.scenefile.keys import Value, scene_key, with_key
from analytic.scenefile.quantity import Dimension
from analytic.scenefile.read import scene_of
from analytic.scenefile.text import parse_text, plain, read_text, shown

What = Literal["torque", "contact"]
OWN_QUANTITIES = {
    "ball_load": Dimension(unit="N", low=1e-12, high=1e7, example='"620 N"'),
    "accuracy": Dimension(unit="", low=1e-6, high=1, example='"1 %"'),
}
OWN_WORDS = {"pair": get_args(Pair), "geometry": ("real", "hertzian", "wall")}
OF_CONTACT = ("pair", "ball_load", "geometry", "accuracy")
DIRECTION = "down"  # the key of [operation] whose list is one value
SAMPLES = "samples"
RANGE = ("from", "to", "count", "spacing")
MOST_COUNT = 1_000_000  # values of one axis
BYTES_A_POINT = 400  # of the whole dataset in memory, or of a map while it is drawn
SHARE_OF_MEMORY = 0.5
MEMORY_UNKNOWN = 8e9  # bytes, taken where the system does not say


@dataclass(frozen=True, kw_only=True)
class Axis:
    """One quantity or word that varies."""

    key: str  # of a scene, with dots
    unit: str | None  # SI; "" for a pure number, None for words and counts
    values: tuple[Value, ...]  # SI
    in_series: bool = False  # a key of [operation]: the torque model takes all its values at once

    def in_scene(self, index: int) -> Value:
        """The value as it is written in a scene file.

        Parameters
        ----------
        index : int
            Number of the value, from 0.

        Returns
        -------
        float, int, str or bool
            A number in the unit of the axis becomes a text with that unit.
        """
        value = self.values[index]
        return f"{value!r} {self.unit}" if self.unit else value


@dataclass(frozen=True, kw_only=True)
class Grid:
    """A scene, what to compute for it, and the axes.

    Points are numbered with the axes in the order of `order`, in which those of a series come last; the last axis
    varies fastest.
    """

    what: What  # is computed at each point
    document: dict[str, Any]  # of the scene
    folder: str  # base of the relative paths in the scene
    fixed: dict[str, Value]  # keys of OF_CONTACT for the whole sweep
    samples: int | None  # number for the torque's 95 % interval at each point; None: no interval
    axes: tuple[Axis, ...]
    text: str  # of the grid file
    origin: str  # the file that it was read from

    @property
    def order(self) -> tuple[Axis, ...]:
        """The axes in the order in which points are numbered."""
        return (*self.outside, *self.series)

    @property
    def outside(self) -> tuple[Axis, ...]:
        """The axes with another scene at each value."""
        return tuple(axis for axis in self.axes if axis not in self.series)

    @property
    def series(self) -> tuple[Axis, ...]:
        """The axes whose product is one series of the torque model."""
        return tuple(axis for axis in self.axes if self.what == "torque" and axis.in_series)

    @property
    def size(self) -> int:
        """Number of points."""
        return prod(len(axis.values) for axis in self.axes)

    @property
    def length(self) -> int:
        """Number of points in one series."""
        return prod(len(axis.values) for axis in self.series)

    def chosen(self, variant: int) -> dict[str, int]:
        """Key and index of each axis of `outside`.

        Parameters
        ----------
        variant : int
            Number of a choice of these axes, from 0.

        Returns
        -------
        dict
            Index by key.
        """
        shape = tuple(len(axis.values) for axis in self.outside)
        places = np.unravel_index(variant, shape) if shape else ()
        return {axis.key: int(place) for axis, place in zip(self.outside, places, strict=True)}

    def settings(self, variant: int) -> dict[str, Value]:
        """Values of the keys of OF_CONTACT at one choice of the axes of `outside`.

        Parameters
        ----------
        variant : int
            Number of the choice, from 0.

        Returns
        -------
        dict
            SI.
        """
        chosen = self.chosen(variant)
        return self.fixed | {a.key: a.values[chosen[a.key]] for a in self.outside if a.key in OF_CONTACT}

    def scene(self, variant: int) -> Scene:
        """The scene at one choice of the axes of `outside`, and at the first point of its series.

        Parameters
        ----------
        variant : int
            Number of the choice, from 0.

        Returns
        -------
        Scene
            In SI.

        Raises
        ------
        InputError
            As `load_scene`.
        """
        chosen = self.chosen(variant)
        document = self.document
        for axis in self.order:
            if axis.key not in OF_CONTACT:
                document = with_key(document, axis.key, axis.in_scene(chosen.get(axis.key, 0)))
        return self._read(document)

    def first_scene(self) -> Scene:
        """The first scene that is valid. Raises InputError if none is."""
        failure = InputError(f"{self.origin}: no point is a scene")
        for variant in range(self.size // self.length):
            try:
                return self.scene(variant)
            except InputError as problem:
                failure = problem
        raise failure

    def _read(self, document: dict[str, Any]) -> Scene:
        # A copy, since the reader adds entries of the catalog to it.
        return scene_of(dict(document), origin=self.origin, folder=Path(self.folder))


def load_grid(path: str | os.PathLike[str]) -> Grid:
    """The grid that a TOML file describes.

    Raises InputError, in one line, for a file that cannot be read or is not TOML, an axis that is unknown, empty or in
    a wrong unit, an invalid scene, and a product too large for the memory.
    """
    origin = plain(os.fspath(path))
    text = read_text(path, kind="grid", remedy="give the path of a grid file: a scene and a table [axes]")
    try:
        return _grid(text, origin=origin, folder=Path(path).absolute().parent)
    except InputError as problem:
        words = str(problem)
        raise problem if words.startswith(origin) else InputError(f"{origin}: {words}") from problem


def _grid(text: str, *, origin: str, folder: Path) -> Grid:
    given = parse_text(text, origin=origin)
    known = ("what", "scene", "axes", SAMPLES, *OF_CONTACT)
    for key in given:
        if key not in known:
            raise InputError(f"{plain(key)} is an unknown key; known: {', '.join(known)}")
    what = given.get("what", "torque")
    if what not in ("torque", "contact"):
        raise InputError(f'what = {shown(what)} is not a word known here; give "torque" or "contact"')
    axes = tuple(_axis(key, values) for key, values in _listed(given.get("axes")))
    fixed = {key: _own(key)(key, given[key]) for key in OF_CONTACT if key in given}
    for key in (*fixed, *(axis.key for axis in axes)):
        if key in OF_CONTACT and what != "contact":
            raise InputError(f'{key} is of a contact; write what = "contact", or leave it out')
    samples = given.get(SAMPLES)
    if samples is not None and (isinstance(samples, bool) or not isinstance(samples, int) or samples < 1):
        raise InputError(f"samples = {shown(samples)} is no number of samples; give a whole number, for example 512")
    if samples is not None and what != "torque":
        raise InputError('samples are of the interval of a torque; write what = "torque", or leave them out')
    _require_distinct([axis.key for axis in axes], fixed)
    document, scene_folder = _document(given.get("scene"), folder)
    _require_one_point(document, axes)
    _require_memory(axes)
    return Grid(
        what=what,
        document=document,
        folder=str(scene_folder),
        fixed=fixed,
        samples=samples,
        axes=axes,
        text=text,
        origin=origin,
    )


def _listed(given: object, before: str = "") -> Iterator[tuple[str, object]]:
    """Whole key and values of each axis; keys may be quoted or not."""
    if not isinstance(given, dict) or not given:
        raise InputError('[axes] is missing; give for example operation.axial_load = ["100 N", "200 N"]')
    for key, inside in given.items():
        if isinstance(inside, dict) and inside and not set(inside) & set(RANGE[:3]):
            yield from _listed(inside, f"{before}{key}.")
        else:
            yield before + key, inside


def _own(key: str) -> Any:
    """A function that reads a value of a key of sweeps."""

    def read(name: str, given: object) -> Value:
        if key in OWN_WORDS:
            if given not in OWN_WORDS[key]:
                raise InputError(f"{name} = {shown(given)} is not a word known here; give {_either(OWN_WORDS[key])}")
            return str(given)
        try:
            return OWN_QUANTITIES[key].read(given)
        except ValueError as problem:
            raise InputError(f"{name} = {shown(given)} {problem}") from None

    return read


def _axis(key: str, given: object) -> Axis:
    name = f"axes.{plain(key)}"
    if key in OWN_WORDS or (key in OWN_QUANTITIES and key != "accuracy"):
        read, in_series = _own(key), False
        dimension = OWN_QUANTITIES.get(key)
    else:
        try:
            entry = scene_key(key)
        except InputError as problem:
            raise InputError(f"axes: {problem} (or one of the sweep's own: pair, ball_load, geometry)") from None
        dimension, in_series = entry.dimension, entry.in_series

        def read(name: str, given: object) -> Value:
            try:
                return entry.read(given)
            except ValueError as problem:
                raise InputError(f"{name} = {shown(given)} {problem}") from None

    if isinstance(given, dict):
        if dimension is None:
            raise InputError(f"{name} has no order to step through; give a list of its values")
        values = _steps(name, given, read)
    elif isinstance(given, list) and given:
        values = tuple(read(f"{name}[{number}]", value) for number, value in enumerate(given))
    elif given == []:
        raise InputError(f"{name} is empty; give at least one value, or leave the axis out")
    else:
        raise InputError(f"{name} = {shown(given)} is no list; give [..., ...] or {{ from, to, count, spacing }}")
    if len(set(values)) < len(values):
        twice = next(value for value, count in Counter(values).items() if count > 1)
        raise InputError(f"{name} has {shown(twice)} twice; leave one of them out")
    words = [isinstance(value, str) for value in values]  # of a key that takes a quantity or a word: a clearance
    if dimension is None or all(words):
        return Axis(key=key, unit=None, values=values, in_series=in_series)
    if any(words):
        raise InputError(f"{name} mixes words and quantities; give one kind")
    return Axis(key=key, unit=dimension.unit, values=values, in_series=in_series)


def _steps(name: str, given: dict[str, Any], read: Any) -> tuple[float, ...]:
    """Values of an axis given by from, to, count and spacing, which is "linear" by default."""
    for key in given:
        if key not in RANGE:
            raise InputError(f"{name}.{plain(key)} is an unknown key; known: {', '.join(RANGE)}")
    for key in RANGE[:3]:
        if key not in given:
            raise InputError(f'{name}.{key} is missing; give {{ from = ..., to = ..., count = 20, spacing = "log" }}')
    begin, end = (read(f"{name}.{key}", given[key]) for key in ("from", "to"))
    if isinstance(begin, str) or isinstance(end, str):
        raise InputError(f"{name} steps through quantities, not words; give a list of its values")
    count, spacing = given["count"], given.get("spacing", "linear")
    if isinstance(count, bool) or not isinstance(count, int) or not 2 <= count <= MOST_COUNT:
        raise InputError(f"{name}.count = {shown(count)} is no count; give a whole number from 2 to {MOST_COUNT}")
    if spacing not in ("linear", "log"):
        raise InputError(f'{name}.spacing = {shown(spacing)} is not a word known here; give "linear" or "log"')
    if begin == end:
        raise InputError(f"{name}: from and to are the same, {begin:g}; give a list of that one value")
    if spacing == "log" and begin * end <= 0:
        raise InputError(f'{name}: from {begin:g} to {end:g} has no logarithm; give spacing = "linear"')
    steps = np.geomspace(begin, end, count) if spacing == "log" else np.linspace(begin, end, count)
    steps[[0, -1]] = begin, end  # exactly as written
    return tuple(steps.tolist())


def _document(given: object, folder: Path) -> tuple[dict[str, Any], Path]:
    """The scene as a table, and the base folder of its relative paths."""
    if isinstance(given, dict):
        return given, folder
    if not isinstance(given, str) or not given:
        raise InputError("scene is missing; give its path, a bearing of the catalog, or a table [scene]")
    found = find_scene(given, folder=folder)
    return parse_text(found.text, origin=found.origin), found.folder


def _require_one_point(document: dict[str, Any], axes: tuple[Axis, ...]) -> None:
    """Refuse a list in the scene: there, values of several lists form points together; in a sweep, axes multiply."""
    operation = document.get("operation")
    keys = {axis.key for axis in axes}
    for key, value in operation.items() if isinstance(operation, dict) else ():
        is_series = isinstance(value, list) and len(value) != 1 and key != DIRECTION
        if is_series and f"operation.{key}" not in keys:
            raise InputError(
                f"operation.{plain(key)} has {len(value)} values in the scene; make it an axis, or give it one value"
            )


def _require_distinct(keys: list[str], fixed: dict[str, Value]) -> None:
    """Refuse two settings of one key: a coordinate of the dataset would not be the value in the scene."""
    for key, count in Counter(keys).items():
        if count > 1:
            raise InputError(f"axes.{key} is there twice, with quotes and without; leave one of them out")
        if key in fixed:
            raise InputError(f"{key} is an axis and has one value for the whole sweep; leave one of them out")


def _require_memory(axes: tuple[Axis, ...]) -> None:
    size = prod(len(axis.values) for axis in axes)
    try:
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        memory = MEMORY_UNKNOWN
    most = int(SHARE_OF_MEMORY * memory / BYTES_A_POINT)
    if size > most:
        counts = " x ".join(str(len(axis.values)) for axis in axes)
        raise InputError(
            f"axes: {counts} = {size:,} points are too many for this machine's memory, which holds the results of "
            f"{most:,}; shorten an axis, or sweep in parts"
        )


def _either(words: tuple[str, ...]) -> str:
    return ", ".join(f'"{word}"' for word in words[:-1]) + f' or "{words[-1]}"'
