"""Tables with one row for each operating point: measured torques, and the steps of a duty cycle.

    # rig 2, second run
    inner_speed [rpm],axial_load [N],temperature [degC],torque [N mm],uncertainty [N mm]
    500,1000,62.5,35.1,0.8

A column for each quantity, with its unit in brackets or in a row of units; lines that begin with # are comments.
Columns of other things, as dates, are not read. Every message is one line with the place, the value and what is
accepted.
"""

import os
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from difflib import get_close_matches
from typing import Any, NamedTuple

import numpy as np

from analytic.declared import nothing, read_only
from analytic.errors import InputError
from analytic.quantity import LONGEST, NUMBER, Dimension
from analytic.scene import Array, Lubricant, MeasuredTorque, Operation, Scene
from analytic.scenefile.keys import Values, scene_key
from analytic.scenefile.oil import lubricant_of
from analytic.scenefile.sheet import Cell, Line, Sheet, decimal_sign, read_sheet, with_points
from analytic.words import plain, shown, torque_of

OPERATING = ("inner_speed", "axial_load", "radial_load", "temperature")  # columns that say where a row is
COMMANDS = {  # by the column that a kind of file must have
    "torque": "fembearing compare SCENE FILE takes measured torques",
    "duration": "fembearing duty SCENE FILE takes a duty cycle",
    "designation": "fembearing torque FILE takes a list of bearings",
}
OTHER_OPERATION = {part.name for part in fields(Operation)} - {*OPERATING}
LIKENESS = 0.75  # of a word to the one that is probably meant
MOST_NAMES = 8  # of columns in a message
SHORTEST = 4  # letters of a word that is cut short, as "temp"
HEAD = re.compile(r"(.*?)\s*(?:\[([^\[\]]*)\]|\(([^()]*)\))?")  # a name and its unit
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

    place: int  # of its cells in a row, from 0
    head: str  # as it is written
    name: str  # one of `Columns.known`; else a text like these
    unit: str  # as it is written; "": none


class Rows(NamedTuple):
    """The rows of a file under its known columns."""

    columns: list[Column]
    rows: list[tuple[str, list[Cell]]]  # the place of each in words, and its cells by column, with decimal points
    warnings: tuple[str, ...]


@dataclass(frozen=True, kw_only=True)
class Columns:
    """What the columns of one kind of file may be."""

    known: Mapping[str, Dimension | None]  # by name; None: texts
    required: str  # a name
    row: str  # what a row stands for, "measured torque"
    where: str = ""  # what the operating columns say, "where the torques were measured"; "": none is needed
    example: tuple[str, ...]  # names for the head of a file
    synonyms: Mapping[str, str] = field(default_factory=nothing)  # names by what else stands for them
    shares: Mapping[str, Dimension] = field(default_factory=nothing)  # by name: columns that may be in per cent
    fault: Callable[[Mapping[str, float]], str | None] = lambda _: None  # what is wrong with a row, SI

    @property
    def remedy(self) -> str:
        """The end of a message on a file that is none."""
        return f"give the path of a CSV or .xlsx file of {self.row}s"

    def head(self, name: str) -> str:
        """The head of a column, as people write it."""
        dimension = self.known[name]
        return name if dimension is None else f"{name} [{dimension.shown_unit}]"

    def _example(self, name: str) -> str:
        return self.head(name) + (" or [%]" if name in self.shares else "")

    def read(self, path: str | os.PathLike[str]) -> dict[str, Any]:
        """The name of a file, `file`, `warnings` on how it was read, and its columns, each (n,) in SI.

        Raises InputError, in one line that begins with the path, as `rows`, and for a row with a value that is no
        number, out of range or does not fit the others.
        """
        file = plain(os.fspath(path))
        columns, lines, warnings = self.rows(path)
        try:
            for name, unit in ((each.name, each.unit) for each in columns):
                if not unit:
                    raise ValueError(
                        f"column {name} has no unit; write it in brackets, for example {self._example(name)}"
                    )
            rows = [self._row(place, columns, cells) for place, cells in lines]
        except ValueError as problem:
            raise InputError(f"{file}: {problem}") from None
        values = {each.name: np.array([row[each.name] for row in rows]) for each in columns}
        return {"file": file, "warnings": warnings, **values}

    def rows(self, path: str | os.PathLike[str]) -> Rows:
        """The rows of a file.

        Raises InputError, in one line that begins with the path, for a file that cannot be read, for a column that is
        missing, there twice, in a wrong unit, or not known although it may be meant, and for a row with too many values
        or a number that can be read in two ways.
        """
        file = plain(os.fspath(path))
        try:
            return self._rows(read_sheet(path, remedy=self.remedy), file)
        except ValueError as problem:
            raise InputError(f"{file}: {problem}") from None

    def _rows(self, sheet: Sheet, file: str) -> Rows:
        if not sheet.lines:
            example = ",".join(map(self.head, self.example))
            raise ValueError(
                f"is empty; give a line of column heads, as {example}, and a line for each {self.row.split()[-1]}"
            )
        (_, heads), *lines = sheet.lines
        every = [self._column(place, str(head)) for place, head in enumerate(heads) if head != ""]
        if lines and (with_units := self._with_units(every, lines[0])):
            every, lines = with_units, lines[1:]
        columns, others = self._sorted(every)
        if not lines:
            raise ValueError(f"has a line of column heads and no row below it; give a line for each {self.row}")
        numbers = [each for each in columns if self.known[each.name] is not None]
        for each in numbers:
            if each.unit and (fault := self._unit_fault(each)):
                words = f"column {each.name} [{plain(each.unit)}] {fault}"
                raise ValueError(f"{words}; write for example {self._example(each.name)}")
        sign = decimal_sign((_at(line, each) for line in lines for each in numbers), sheet.separator)
        under, least = {each.place for each in every}, 1 + max(each.place for each in columns)
        may_split = sheet.separator == "," and sign == "."
        split = [(left, right) for left in numbers for right in others if may_split and right.place == left.place + 1]
        rows = []
        for row, line in enumerate(lines, start=1):
            place = f"row {row} (line {line.number})"
            count = len(line.cells)
            stray = any(cell != "" and number not in under for number, cell in enumerate(line.cells))
            # A decimal comma between commas makes a row longer, or the next cells those of other columns.
            if stray or (sheet.separator == "," and not least <= count <= len(heads)):
                words = f"{place} has {count} value{'' if count == 1 else 's'}, and there are {len(every)} columns"
                raise ValueError(f"{words}; give one for each, with decimal points in place of commas")
            for left, right in split:
                _require_no_comma(place, line, left, right)
            rows.append((place, [self._cell(place, each, _at(line, each), sign) for each in columns]))
        names = ", ".join(plain(each.head) for each in others[:MOST_NAMES])
        more = f" and {len(others) - MOST_NAMES} more" if len(others) > MOST_NAMES else ""
        return Rows(
            columns, rows, (f"{os.path.basename(file)}: columns that are not read: {names}{more}",) if others else ()
        )

    def _column(self, place: int, head: str) -> Column:
        """The column under a head."""
        match = HEAD.fullmatch(head)
        assert match is not None, head
        written, square, round_ = match.groups()
        name = re.sub(r"[\s_-]+", "_", written.casefold())
        return Column(place, head, self.synonyms.get(name, name), (square or round_ or "").strip())

    def _sorted(self, every: Sequence[Column]) -> tuple[list[Column], list[Column]]:
        """The known columns, and those that are not read. Raises ValueError."""
        columns = [each for each in every if each.name in self.known]
        others = [each for each in every if each.name not in self.known]
        names = [each.name for each in columns]
        absent = [name for name in self.known if name not in names]
        for name in self.known:
            if names.count(name) > 1:
                raise ValueError(f"has {names.count(name)} columns {name}; keep one of them")
        if self.required in absent:
            for each in others:
                if command := COMMANDS.get(each.name):
                    raise ValueError(f"has a column {each.name} and no column {self.required}; {command}")
        for each in others:
            self._require_further(each, absent)
        if self.required in absent:
            raise ValueError(
                f"has no column {self.required}, only {', '.join(plain(each.head) for each in every)}; add one, for "
                f"example {self.head(self.required)}"
            )
        if self.where and not {*OPERATING} & {*names}:
            given = ", ".join(map(self.head, OPERATING))
            raise ValueError(f"does not say {self.where}; add a column, one or more of {given}")
        return columns, others

    def _require_further(self, column: Column, absent: Sequence[str]) -> None:
        """Raise ValueError for an unknown column that may be meant for one that is absent, or for another load."""
        of = f"column {shown(column.head)} is not known"
        if column.name in OTHER_OPERATION and self.required not in absent:
            raise ValueError(f"{of}; give operation.{column.name} in the scene or by --set, and leave the column out")
        words = re.findall(r"[^\W_]+", column.name[:LONGEST])
        for name in absent:
            parts = [name, *name.split("_")]
            begun = [part for part in parts for word in words if len(word) >= SHORTEST and part.startswith(word)]
            if begun or any(get_close_matches(word, parts, cutoff=LIKENESS) for word in [column.name, *words]):
                own = column._replace(name=name)
                meant = f"{name} [{own.unit}]" if own.unit and self._unit_fault(own) is None else self.head(name)
                raise ValueError(f"{of}; did you mean {meant}? Else leave the column out")
        fitting = [name for name in absent if self._unit_fault(column._replace(name=name)) is None]
        if fitting:
            meant = " or ".join(map(self.head, fitting))
            raise ValueError(f"{of}, and its unit fits {meant}; name it so, or leave the column out")

    def _with_units(self, columns: Sequence[Column], line: Line) -> list[Column] | None:
        """The columns with their units from a row in which any cell fits as one; None for another row."""
        found = [each if each.unit else each._replace(unit=str(_at(line, each)).strip("[]() ")) for each in columns]
        lacking = [new for old, new in zip(columns, found, strict=True) if not old.unit and self.known.get(old.name)]
        return None if all(map(self._unit_fault, lacking)) else found

    def _dimension(self, column: Column) -> Dimension | None:
        is_share = column.name in self.shares and column.unit in PERCENT
        return self.shares[column.name] if is_share else self.known[column.name]

    def _unit_fault(self, column: Column) -> str | None:
        """What is wrong with the unit of a column; None: nothing."""
        dimension = self._dimension(column)
        try:
            return None if dimension is not None and dimension.known_unit(column.unit) else "has no unit"
        except ValueError as problem:
            return str(problem)

    def _cell(self, place: str, column: Column, cell: Cell, sign: str) -> Cell:
        """A cell with decimal points, unless it is a text. Raises ValueError."""
        try:
            return cell if self.known[column.name] is None else with_points(cell, sign)
        except ValueError as problem:
            raise ValueError(f"{place}: {column.name} = {shown(cell)} {problem}") from None

    def _row(self, place: str, columns: Sequence[Column], cells: Sequence[Cell]) -> dict[str, float]:
        """The numbers of a row by column, SI. Raises ValueError."""
        row = {each.name: self._value(each, cell, place) for each, cell in zip(columns, cells, strict=True)}
        shares = [each.name for each in columns if self._dimension(each) is not self.known[each.name]]
        row |= {name: row[name] * row[self.required] for name in shares}
        if fault := self.fault(row):
            raise ValueError(f"{place}: {fault}")
        return row

    def _value(self, column: Column, cell: Cell, place: str) -> float:
        """A cell in SI. Raises ValueError."""
        dimension, text = self._dimension(column), written(cell)
        assert dimension is not None, column
        if column.unit == "%":
            text = text.removesuffix("%").rstrip()
        if not re.fullmatch(NUMBER, text, re.ASCII):
            what = "is empty" if not text else f"= {shown(text)} is no number"
            raise ValueError(f"{place}: {column.name} {what}; give a number in {column.unit}, or leave the row out")
        try:
            return dimension.read(f"{text} {column.unit}")
        except ValueError as problem:
            raise ValueError(f"{place}: {column.name} = {plain(text)} {column.unit} {problem}") from None


def written(cell: Cell) -> str:
    """A cell as a text; a number to its last digit."""
    return cell if isinstance(cell, str) else repr(cell)


def _at(line: Line, column: Column) -> Cell:
    """The cell of a column; a row may end early."""
    return line.cells[column.place] if column.place < len(line.cells) else ""


def _require_no_comma(place: str, line: Line, left: Column, right: Column) -> None:
    """Raise ValueError for two whole numbers, the right one in a column that is not read: "35,1" may be one number."""
    whole, rest = _at(line, left), _at(line, right)
    if re.fullmatch(r"[+-]?\d+ \d+", f"{whole} {rest}", re.ASCII):
        words = f"{place}: {left.name} = {whole},{rest} may be one number; write {whole}.0 if it is not"
        raise ValueError(f"{words}, or leave the column {plain(right.head)} out")


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


SYNONYMS = read_only({"speed": "inner_speed"})  # as the option is called
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
    synonyms=SYNONYMS,
    shares=read_only({"uncertainty": Dimension(unit="", low=0, high=1, example='"2 %"')}),
    fault=_unfit,
)
CYCLE = Columns(
    known={"duration": Dimension(unit="s", low=1e-9, high=1e10, example='"20 s"'), **OF_OPERATION},
    required="duration",
    row="duty step",
    where="what runs in its steps",
    example=("duration", "inner_speed"),
    synonyms=SYNONYMS,
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
    warnings: tuple[str, ...] = ()  # on how the file was read


def read_cycle(path: str | os.PathLike[str]) -> Cycle:
    """The duty cycle in a CSV or .xlsx file. Raises InputError as `Columns.read`."""
    return Cycle(**CYCLE.read(path))


def read_measured(path: str | os.PathLike[str]) -> MeasuredTorque:
    """The measured torques in a CSV or .xlsx file, without the oils at their temperatures.

    Raises InputError as `Columns.read`, for a row where nothing turns, and where the uncertainty exceeds the torque.
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
