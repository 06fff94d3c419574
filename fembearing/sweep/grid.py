"""The grid of a sweep: a TOML file with a scene and the axes whose product is computed.

    what = "torque"           # or "contact", by finite elements
    scene = "bearing.toml"    # path from the folder of the grid file, a built-in scene, a bearing, or a table
    [axes]                    # keys of the scene, and keys of sweeps: pair, ball_load, geometry
    operation.axial_load = { from = "100 N", to = "2 kN", count = 20, spacing = "log" }
    operation.inner_speed = ["100 rpm", "300 rpm"]

A bearing of the catalogue has no usual load beside an axis of loads.

For a torque, `samples = 512` above [axes] computes its 95 % interval, from so many torques at each point. For a
contact, `pair`, `ball_load`, `geometry` and `accuracy` may stand above [axes] too, for the whole sweep.
"""

import os
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from math import prod
from pathlib import Path
from typing import Any, Literal, get_args

import numpy as np

from analytic.declared import Key, Table, Whole, Word, nothing
from analytic.errors import InputError
from analytic.quantity import SI, Dimension
from analytic.scene import Pair, Scene
from analytic.scenefile.find import find_scene, parse_text, read_text
from analytic.scenefile.keys import Values, faults_of, read_document, scene_key, with_key
from analytic.scenefile.read import scene_of, whole_document
from analytic.words import plain, shown

What = Literal["torque", "contact"]
OF_AXES = ("pair", "ball_load", "geometry")  # keys of sweeps that may be axes
OF_CONTACT = (*OF_AXES, "accuracy")
LOADS = ("operation.axial_load", "operation.radial_load", "operation.moment")
DIRECTION = "down"  # the key of [operation] whose list is one value
BYTES_A_POINT = 400  # of the whole dataset in memory, or of a map while it is drawn
SHARE_OF_MEMORY = 0.5
MEMORY_UNKNOWN = 8e9  # bytes, taken where the system does not say
EXAMPLE = 'give for example operation.axial_load = ["100 N", "200 N"]'


Value = float | int | str | bool


@dataclass(frozen=True)
class AnyTable:
    """A table whose keys are read elsewhere, or a text in its place."""

    accepted: str
    takes_text: bool = False

    def read(self, given: object) -> Any:
        """The table, or the text. Raises ValueError for what is neither, and for an empty table."""
        if isinstance(given, dict) and not given:
            raise ValueError(f"is empty; {self.accepted}")
        if not isinstance(given, dict | str) or (isinstance(given, str) and not self.takes_text):
            raise ValueError(f"is not a table; {self.accepted}")
        return given


@dataclass(frozen=True)
class End:
    """The first or the last value of an axis of steps, which the axis itself reads."""

    accepted: str

    def read(self, given: object) -> Any:
        """The text or number. Raises ValueError for what is neither."""
        if not isinstance(given, str | int | float) or isinstance(given, bool):
            raise ValueError(f"is not a quantity; {self.accepted}")
        return given


GRID = Table(path="", hint="")
STEPS = Table(path="", hint="")
for _entry in (
    Key(path="what", kind=Word(get_args(What)), default="torque"),
    Key(path="scene", kind=AnyTable("give its path, a bearing of the catalog, or a table [scene]", takes_text=True)),
    Key(
        path="samples",
        kind=Whole(things="samples", low=1, high=10**9, example=512),
        default=None,
        meaning="of the 95 % interval of the torque",
    ),
    Key(path="pair", kind=Word(get_args(Pair)), default=None),
    Key(path="ball_load", kind=Dimension(unit="N", low=1e-12, high=1e7, example='"620 N"'), default=None),
    Key(path="geometry", kind=Word(("real", "hertzian", "wall")), default=None),
    Key(path="accuracy", kind=Dimension(unit="", low=1e-6, high=1, example='"1 %"'), default=None),
    Key(path="axes", kind=AnyTable(EXAMPLE)),
):
    GRID.add(_entry)
for _entry in (
    Key(path="from", kind=End('give the first value, for example "100 N"')),
    Key(path="to", kind=End('give the last value, for example "2 kN"')),
    Key(path="count", kind=Whole(things="values", low=2, high=1_000_000, example=20)),
    Key(path="spacing", kind=Word(("linear", "log")), default="linear"),
):
    STEPS.add(_entry)


@dataclass(frozen=True, kw_only=True)
class Axis:
    """One quantity or word that varies."""

    key: str  # of a scene, with dots
    unit: str | None  # SI; "" for a pure number, None for words and counts
    values: tuple[Value, ...]  # SI
    in_series: bool = False  # a key of [operation]: the torque model takes all its values at once


@dataclass(frozen=True, kw_only=True)
class Grid:
    """A scene, what to compute for it, and the axes.

    Points are numbered with the axes in the order of `order`, in which those of a series come last; the last axis
    varies fastest. A variant is a choice of the values of all axes of `outside`, numbered in the same way.
    """

    what: What  # is computed at each point
    document: dict[str, Any]  # of the scene
    folder: str  # base of the relative paths in the scene
    fixed: dict[str, Value]  # keys of OF_CONTACT for the whole sweep
    samples: int | None  # number for the torque's 95 % interval at each point; None: no interval
    axes: tuple[Axis, ...]
    text: str  # of the grid file
    origin: str  # the file that it was read from
    usual: Mapping[str, Any] = field(default_factory=nothing)  # by key: values of a bearing that nobody gave
    designation: str = ""  # of a bearing of the catalogue that the grid file names

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

    def settings(self, variant: int) -> dict[str, Value]:
        """Values of the keys of OF_CONTACT at one variant.

        Parameters
        ----------
        variant : int
            Number of the variant, from 0.

        Returns
        -------
        dict
            SI.
        """
        return self.fixed | {axis.key: value for axis, value in self._chosen(variant) if axis.key in OF_CONTACT}

    def scene(self, variant: int) -> Scene:
        """The scene of one variant, at the first point of its series.

        Parameters
        ----------
        variant : int
            Number of the variant, from 0.

        Returns
        -------
        Scene
            In SI.

        Raises
        ------
        InputError
            As `load_scene`.
        """
        document = self.document
        for axis, value in (*self._chosen(variant), *((axis, axis.values[0]) for axis in self.series)):
            if axis.key not in OF_CONTACT:
                document = with_key(document, axis.key, _in_document(axis, value))
        return scene_of(document, origin=self.origin, folder=Path(self.folder))

    def first_scene(self) -> Scene:
        """The first scene that is valid. Raises InputError if none is."""
        failure = InputError(f"{self.origin}: no point is a scene")
        for variant in range(self.size // self.length):
            try:
                return self.scene(variant)
            except InputError as problem:
                failure = problem
        raise failure

    def _chosen(self, variant: int) -> list[tuple[Axis, Value]]:
        """Each axis of `outside` with its value at a variant."""
        shape = tuple(len(axis.values) for axis in self.outside)
        places = np.unravel_index(variant, shape) if shape else ()
        return [(axis, axis.values[int(place)]) for axis, place in zip(self.outside, places, strict=True)]


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
    v = _validated(GRID, parse_text(text, origin=origin))
    axes = tuple(_axis(key, values) for key, values in _listed(v["axes"]))
    fixed = {key: v[key] for key in OF_CONTACT if key in v}
    for key, count in Counter(axis.key for axis in axes).items():  # a coordinate would not be the value in the scene
        if count > 1:
            raise InputError(f"axes.{key} is there twice, with quotes and without; leave one of them out")
        if key in fixed:
            raise InputError(f"{key} is an axis and has one value for the whole sweep; leave one of them out")
    what, samples = v.get("what", "torque"), v.get("samples")
    for key in (*fixed, *(axis.key for axis in axes)):
        if key in OF_CONTACT and what != "contact":
            raise InputError(f'{key} is of a contact; write what = "contact", or leave it out')
    if samples is not None and what != "torque":
        raise InputError('samples are of the interval of a torque; write what = "torque", or leave them out')
    document, usual, designation = v["scene"], {}, ""
    if isinstance(document, str):
        largest = {axis.key: _in_document(axis, _largest(axis)) for axis in axes if axis.key not in OF_CONTACT}
        named = find_scene(document, folder=folder)
        folder, designation = named.folder, named.designation
        document, usual = whole_document(named, largest if designation else {})
    _require_one_point(document, axes)
    _require_memory(axes)
    return Grid(
        what=what,
        document=document,
        folder=str(folder),
        fixed=fixed,
        samples=samples,
        axes=axes,
        text=text,
        origin=origin,
        usual=usual,
        designation=designation,
    )


def _validated(table: Table, given: dict[str, Any], before: str = "") -> Values:
    """The values; before : path of its keys. Raises InputError for the first of its faults."""
    values = read_document(given, table)
    for fault in faults_of(table, values):
        raise InputError(before + fault)
    return values


def _listed(given: dict[str, Any], before: str = "") -> Iterator[tuple[str, object]]:
    """Whole key and values of each axis; keys may be quoted or not."""
    for key, inside in given.items():
        if isinstance(inside, dict) and inside and not set(inside) & {"from", "to", "count"}:
            yield from _listed(inside, f"{before}{key}.")
        else:
            yield before + key, inside


def _axis(key: str, given: object) -> Axis:
    name = f"axes.{plain(key)}"
    try:
        entry = scene_key(key, root=GRID) if key in OF_AXES else scene_key(key)
    except InputError as problem:
        raise InputError(f"axes: {problem} (or one of the sweep's own: {', '.join(OF_AXES)})") from None
    if isinstance(given, dict):
        if entry.dimension is None:
            raise InputError(f"{name} has no order to step through; give a list of its values")
        values: tuple[Value, ...] = _steps(name, given, entry)
    elif isinstance(given, list) and given:
        values = tuple(_value(entry, f"{name}[{number}]", value) for number, value in enumerate(given))
    elif given == []:
        raise InputError(f"{name} is empty; give at least one value, or leave the axis out")
    else:
        raise InputError(f"{name} = {shown(given)} is no list; give [..., ...] or {{ from, to, count, spacing }}")
    if len(set(values)) < len(values):
        raise InputError(f"{name} has {shown(Counter(values).most_common(1)[0][0])} twice; leave one of them out")
    words = [isinstance(value, str) for value in values]  # of a key that takes a quantity or a word: a clearance
    if entry.dimension is None or all(words):
        return Axis(key=key, unit=None, values=values, in_series=entry.in_series)
    if any(words):
        raise InputError(f"{name} mixes words and quantities; give one kind")
    return Axis(key=key, unit=entry.dimension.unit, values=values, in_series=entry.in_series)


def _value(entry: Key, name: str, given: object) -> Value:
    """One value of an axis. Raises InputError for what the key does not take, and for a table, a list or a length."""
    if isinstance(given, dict | list):
        raise InputError(f"{name} = {shown(given)} is no number and no text; give one")
    value = entry.read_as(name, given)
    if not isinstance(value, Value):
        raise InputError(f"{name} = {shown(given)} makes no axis; give shares of the ball's radius, as 0.9")
    return value


def _steps(name: str, given: dict[str, Any], entry: Key) -> tuple[float, ...]:
    """Values of an axis given by from, to, count and spacing."""
    table: dict[str, Any] = {"spacing": "linear"} | _validated(STEPS, given, f"{name}.")
    begin, end = (_value(entry, f"{name}.{key}", table[key]) for key in ("from", "to"))
    if isinstance(begin, str) or isinstance(end, str):
        raise InputError(f"{name} steps through quantities, not words; give a list of its values")
    if begin == end:
        raise InputError(f"{name}: from and to are the same, {begin:g}; give a list of that one value")
    if table["spacing"] == "log" and begin * end <= 0:
        raise InputError(f'{name}: from {begin:g} to {end:g} has no logarithm; give spacing = "linear"')
    steps = (np.geomspace if table["spacing"] == "log" else np.linspace)(begin, end, table["count"])
    steps[[0, -1]] = begin, end  # exactly as written
    return tuple(steps.tolist())


def _largest(axis: Axis) -> Value:
    """The value of the largest magnitude; of words any."""
    return max(axis.values, key=lambda value: abs(value) if isinstance(value, float) else 0.0)


def _in_document(axis: Axis, value: Value) -> Value:
    """A value of an axis as a scene has it."""
    return SI(value, axis.unit) if axis.unit and isinstance(value, float) else value


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
