"""CSV files with one row for each operating point: measured torques, and the steps of a duty cycle.

    # rig 2, second run
    inner_speed [rpm],axial_load [N],temperature [degC],torque [N mm],uncertainty [N mm]
    500,1000,62.5,35.1,0.8

A column for each quantity, with its unit in brackets; lines that begin with # are comments. Every message is one line
with the place, the value and what is accepted.
"""

import csv
import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from typing import Any, NamedTuple

import numpy as np

from analytic.declared import nothing, read_only
from analytic.errors import InputError
from analytic.quantity import NUMBER, Dimension
from analytic.scene import Array, Lubricant, MeasuredTorque, Scene
from analytic.scenefile.find import read_text
from analytic.scenefile.keys import Values, scene_key
from analytic.scenefile.oil import lubricant_of
from analytic.words import plain, shown, torque_of

OPERATING = ("inner_speed", "axial_load", "radial_load", "temperature")  # columns that say where a row is
LIKENESS = 0.5  # of a name to the one that is probably meant
HEAD = re.compile(r"([^\[\]]*?)\s*(?:\[([^\[\]]*)\])?")
PERCENT = ("%", "percent")


def key_of_column(name: str) -> str:
    """The key of a scene whose value a column of OPERATING has."""
    return f"{'lubricant' if name == 'temperature' else 'operation'}.{name}"


def operating_column(name: str) -> Dimension:
    """What a column of OPERATING takes, as the scene does."""
    key = scene_key(key_of_column(name))
    assert key.dimension is not None, name
    return key.dimension


class Column(NamedTuple):
    """A column of the file."""

    name: str
    unit: str  # as it is written
    dimension: Dimension
    is_share: bool  # of the required column


@dataclass(frozen=True, kw_only=True)
class Columns:
    """What the columns of one kind of file may be."""

    known: Mapping[str, Dimension]  # by name
    required: str  # a name
    row: str  # what a row stands for, "measured torque"
    where: str  # what the operating columns say, "where the torques were measured"
    example: tuple[str, ...]  # names for the head of a file
    shares: Mapping[str, Dimension] = field(default_factory=nothing)  # by name: columns that may be in per cent
    fault: Callable[[Mapping[str, float]], str | None] = lambda _: None  # what is wrong with a row, SI

    @property
    def remedy(self) -> str:
        """The end of a message on a file that is none."""
        return f"give the path of a CSV file of {self.row}s"

    def head(self, name: str) -> str:
        """The head of a column, as people write it."""
        return f"{name} [{self.known[name].shown_unit}]"

    def read(self, path: str | os.PathLike[str]) -> dict[str, Any]:
        """The name of a file, `file`, and its columns, each (n,) in SI.

        Raises InputError, in one line that begins with the path, for a file that cannot be read, for a column that is
        unknown, missing, there twice or without its unit, and for a row with a value too few, too many, out of range or
        that does not fit the others.
        """
        file = plain(os.fspath(path))
        text = read_text(path, kind="CSV", remedy=self.remedy)
        try:
            heads, lines = self._lines(text)
            columns = self._columns(heads)
            if not lines:
                raise ValueError(f"has a line of column heads and no row below it; give a line for each {self.row}")
            rows = [
                self._row(f"row {row} (line {number})", columns, cells)
                for row, (number, cells) in enumerate(lines, start=1)
            ]
        except ValueError as problem:
            raise InputError(f"{file}: {problem}") from None
        return {"file": file, **{each.name: np.array([row[each.name] for row in rows]) for each in columns}}

    def _lines(self, text: str) -> tuple[list[str], list[tuple[int, list[str]]]]:
        """The heads, and the cells of each line with its number. Raises ValueError."""
        lines = [
            (number, line)
            for number, line in enumerate(text.splitlines(), start=1)
            if line.strip() and not line.lstrip().startswith("#")
        ]
        if not lines:
            example = ",".join(map(self.head, self.example))
            raise ValueError(
                f"is empty; give a line of column heads, as {example}, and a line for each {self.row.split()[-1]}"
            )
        try:
            (_, heads), *others = [
                (number, [cell.strip() for cell in next(csv.reader([line]))]) for number, line in lines
            ]
        except csv.Error as problem:
            raise ValueError(f"is no CSV: {problem}; {self.remedy}") from None
        if len(heads) == 1 and re.search("[;\t]", heads[0]):
            raise ValueError("is separated by semicolons or tabs; separate by commas, and write decimal points")
        return heads, others

    def _columns(self, heads: Sequence[str]) -> list[Column]:
        columns = [self._column(head) for head in heads]
        names = [column.name for column in columns]
        for name in self.known:
            if names.count(name) > 1:
                raise ValueError(f"has {names.count(name)} columns {name}; keep one of them")
        if self.required not in names:
            raise ValueError(
                f"has no column {self.required}, only {', '.join(names)}; add one, for example "
                f"{self.head(self.required)}"
            )
        if not {*OPERATING} & {*names}:
            given = ", ".join(map(self.head, OPERATING))
            raise ValueError(f"does not say {self.where}; add a column, one or more of {given}")
        return columns

    def _column(self, head: str) -> Column:
        """The column under a head. Raises ValueError."""
        match = HEAD.fullmatch(head)
        name, unit = match.groups() if match else (head, None)
        dimension = self.known.get(name)
        if dimension is None:
            near = get_close_matches(name.casefold(), self.known, n=1, cutoff=LIKENESS)
            remedy = f"did you mean {self.head(near[0])}?" if near else f"known: {', '.join(self.known)}"
            raise ValueError(f"column {shown(head)} is not known; {remedy}")
        if not unit:
            raise ValueError(f"column {name} has no unit; write it in brackets, for example {self.head(name)}")
        is_share = name in self.shares and unit in PERCENT
        if is_share:
            dimension = self.shares[name]
        try:
            dimension.known_unit(unit)
        except ValueError as problem:
            percent = " or [%]" if name in self.shares else ""
            raise ValueError(
                f"column {name} [{plain(unit)}] {problem}; write for example {self.head(name)}{percent}"
            ) from None
        return Column(name, unit, dimension, is_share)

    def _row(self, place: str, columns: Sequence[Column], cells: Sequence[str]) -> dict[str, float]:
        """The numbers of a row by column, SI. Raises ValueError."""
        if len(cells) != len(columns):
            remedy = "write decimal points, not commas" if len(cells) > len(columns) else "give one for each"
            count = f"{len(cells)} value{'' if len(cells) == 1 else 's'}"
            raise ValueError(f"{place} has {count}, and there are {len(columns)} columns; {remedy}")
        row = {each.name: _value(each, cell, place) for each, cell in zip(columns, cells, strict=True)}
        row |= {each.name: row[each.name] * row[self.required] for each in columns if each.is_share}
        if fault := self.fault(row):
            raise ValueError(f"{place}: {fault}")
        return row


def _value(column: Column, cell: str, place: str) -> float:
    """A cell in SI. Raises ValueError."""
    if not re.fullmatch(NUMBER, cell, re.ASCII):
        what = "is empty" if not cell else f"= {shown(cell)} is no number"
        raise ValueError(f"{place}: {column.name} {what}; give a number in {column.unit}, or leave the row out")
    try:
        return column.dimension.read(f"{cell} {column.unit}")
    except ValueError as problem:
        raise ValueError(f"{place}: {column.name} = {plain(cell)} {column.unit} {problem}") from None


def operating_points(scene: Scene, file: str, columns: Mapping[str, Array | None], rows: int) -> dict[str, Array]:
    """Loads and speed of each row, SI; what the file lacks is that of the scene.

    file : as messages name it;  columns : by name, (rows,);  rows : number of them
    Raises InputError for a quantity that the file lacks and of which the scene has several values.
    """
    points: dict[str, Array] = {}
    for name, own in scene.operation.as_series().points.items():
        column = columns.get(name)
        if column is None and np.ptp(own):
            raise InputError(
                f"{file} has no column {name}, and the scene has {np.unique(own).size} values of it; "
                f"{'give one' if name == 'moment' else 'add the column, or give one'} in operation.{name}"
            )
        points[name] = np.full(rows, own[0]) if column is None else column
    return points


def require_loads(scene: Scene, file: str, points: Mapping[str, Array]) -> None:
    """Raise InputError for a row without any load, where nothing preloads the bearing; points : by name, (rows,)."""
    idle = (points["axial_load"] == 0) & (points["radial_load"] == 0) & (points["moment"] == 0)
    if np.any(idle) and (scene.arrangement is None or scene.arrangement.kind == "tandem"):
        raise InputError(f"{file}: row {int(np.argmax(idle)) + 1} has no load; give one, or leave the row out")


@dataclass(frozen=True, kw_only=True)
class Magnitude(Dimension):
    """A quantity that is given without its sign."""

    def read(self, given: object) -> float:
        """The value in SI. Raises ValueError as `Dimension.read`, and for a value below 0."""
        if isinstance(given, str) and given.startswith("-"):
            raise ValueError("is below 0; give its magnitude, whatever its sign")
        return super().read(given)


def _unfit(row: Mapping[str, float]) -> str | None:
    torque, uncertainty = row["torque"], row.get("uncertainty", 0.0)
    if row.get("inner_speed") == 0:
        return "inner_speed = 0: nothing turns; give the speed, or leave the row out"
    if uncertainty <= torque:
        return None
    return (
        f"uncertainty = {torque_of(uncertainty)} is larger than the torque, {torque_of(torque)}; give the standard "
        "uncertainty of the measured torque (k = 1)"
    )


OF_OPERATION = {name: operating_column(name) for name in OPERATING}
MEASURED = Columns(
    known={
        **OF_OPERATION,
        "torque": Magnitude(unit="N m", low=1e-12, high=1e6, example='"35.1 N mm"'),
        "uncertainty": Dimension(unit="N m", low=0.0, high=1e6, example='"0.8 N mm"'),
    },
    required="torque",
    row="measured torque",
    where="where the torques were measured",
    example=("inner_speed", "torque", "uncertainty"),
    shares=read_only({"uncertainty": Dimension(unit="", low=0, high=1, example='"2 %"')}),
    fault=_unfit,
)
CYCLE = Columns(
    known={"duration": Dimension(unit="s", low=1e-9, high=1e10, example='"20 s"'), **OF_OPERATION},
    required="duration",
    row="duty step",
    where="what runs in its steps",
    example=("duration", "inner_speed"),
)


@dataclass(frozen=True, kw_only=True)
class Cycle:
    """The steps of a duty cycle, each array (n,); None: as in the scene."""

    file: str  # that has them, as messages name it
    duration: Array  # s, > 0
    inner_speed: Array | None = None  # rad/s; 0: a pause
    axial_load: Array | None = None  # N
    radial_load: Array | None = None  # N
    temperature: Array | None = None  # of the oil at the inlets, K


def read_cycle(path: str | os.PathLike[str]) -> Cycle:
    """The duty cycle in a CSV file. Raises InputError as `Columns.read`."""
    return Cycle(**CYCLE.read(path))


def read_measured(path: str | os.PathLike[str]) -> MeasuredTorque:
    """The measured torques in a CSV file, without the oils at their temperatures. Raises InputError as `Columns.read`.

    A row is refused where nothing turns, and where the uncertainty exceeds the torque.
    """
    return MeasuredTorque(**MEASURED.read(path))


def with_oils(measured: MeasuredTorque, values: Values, own: Lubricant | None, *, ball_radius: float) -> MeasuredTorque:
    """The same, with the oil that the scene describes at the temperature of each row.

    values, own : of the scene;  ball_radius : m. Raises InputError for temperatures without an oil, or beyond its data.
    """
    if measured.temperature is None:
        return measured
    if own is None:
        raise InputError(
            f"{measured.file}: the column temperature is that of the oil, and the scene has no [lubricant]; "
            "leave the column out"
        )
    oils = {own.temperature: own}
    for temperature in np.unique(measured.temperature).tolist():
        if temperature not in oils:
            try:
                oils[temperature] = lubricant_of(values.at(temperature), ball_radius=ball_radius)
            except InputError as problem:
                row = int(np.flatnonzero(measured.temperature == temperature)[0]) + 1
                raise InputError(
                    f"{measured.file}: row {row}: temperature = {temperature - 273.15:.4g} degC: {problem}"
                ) from problem
    return replace(measured, oils=read_only(oils))
