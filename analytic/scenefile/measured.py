"""Measured torques in a CSV file: one row for each operating point, a column for each quantity with its unit.

    # rig 2, second run
    inner_speed [rpm],axial_load [N],temperature [degC],torque [N mm],uncertainty [N mm]
    500,1000,62.5,35.1,0.8

Lines that begin with # are comments. Every message is one line with the place, the value and what is accepted.
"""

import csv
import os
import re
from collections.abc import Iterator, Sequence
from dataclasses import replace
from difflib import get_close_matches
from typing import NamedTuple

import numpy as np

from analytic.errors import InputError
from analytic.noun import read_only
from analytic.scene import Lubricant, MeasuredTorque
from analytic.scenefile.keys import scene_key
from analytic.scenefile.oil import lubricant_of
from analytic.scenefile.quantity import NUMBER, Dimension
from analytic.scenefile.tables import LubricantTable
from analytic.scenefile.text import plain, read_text, shown
from analytic.words import torque_of

OPERATING = ("inner_speed", "axial_load", "radial_load", "temperature")  # columns that say where a torque was measured
TORQUE = Dimension(unit="N m", low=1e-12, high=1e6, example='"35.1 N mm"')
COLUMNS: dict[str, Dimension] = {
    **{
        name: dimension
        for name in OPERATING
        if (dimension := scene_key(f"{'lubricant' if name == 'temperature' else 'operation'}.{name}").dimension)
    },
    "torque": TORQUE,
    "uncertainty": replace(TORQUE, low=0.0, example='"0.8 N mm"'),
}
SHARE = Dimension(unit="", low=0, high=1, example='"2 %"')  # an uncertainty over its torque
LIKENESS = 0.5  # of a name to the one that is probably meant
HEAD = re.compile(r"([^\[\]]*?)\s*(?:\[([^\[\]]*)\])?")
REMEDY = "give the path of a CSV file of measured torques"


class Column(NamedTuple):
    """A column of the file."""

    name: str
    unit: str  # as it is written
    dimension: Dimension


class Row(NamedTuple):
    """A row of the file."""

    place: str  # in words
    cells: list[str]


def read_measured(path: str | os.PathLike[str]) -> MeasuredTorque:
    """The measured torques in a CSV file, without the oils at their temperatures.

    Raises InputError, in one line that begins with the path, for a file that cannot be read, for a column that is
    unknown, missing, there twice or without its unit, and for a row with a value too few, too many or out of range.
    """
    try:
        columns, rows = _table(read_text(path, kind="CSV", remedy=REMEDY))
        values = np.array([[*_values(columns, row)] for row in rows]).T
    except ValueError as problem:
        if isinstance(problem, InputError):  # of the file itself, which it names
            raise
        raise InputError(f"{plain(os.fspath(path))}: {problem}") from None
    return MeasuredTorque(
        file=plain(os.fspath(path)), **{column.name: each for column, each in zip(columns, values, strict=True)}
    )


def with_oils(
    measured: MeasuredTorque, table: LubricantTable | None, own: Lubricant | None, *, ball_radius: float
) -> MeasuredTorque:
    """The same, with the oil that the scene describes at the temperature of each row.

    table, own : of the scene;  ball_radius : m. Raises InputError for temperatures without an oil, or beyond its data.
    """
    if measured.temperature is None:
        return measured
    if table is None or own is None:
        raise InputError(
            f"{measured.file}: the column temperature is that of the oil, and the scene has no [lubricant]; "
            "leave the column out"
        )
    oils = {own.temperature: own}
    for temperature in np.unique(measured.temperature).tolist():
        if temperature not in oils:
            at_it = table.model_copy(update={"temperature": temperature})
            try:
                oils[temperature] = lubricant_of(at_it, ball_radius=ball_radius)
            except InputError as problem:
                row = int(np.flatnonzero(measured.temperature == temperature)[0]) + 1
                raise InputError(
                    f"{measured.file}: row {row}: temperature = {temperature - 273.15:.4g} degC: {problem}"
                ) from problem
    return replace(measured, oils=read_only(oils))


def _table(text: str) -> tuple[list[Column], list[Row]]:
    """Columns and rows. Raises ValueError."""
    lines = [
        (number, line)
        for number, line in enumerate(text.splitlines(), start=1)
        if line.strip() and not line.lstrip().startswith("#")
    ]
    try:
        head, *others = [(number, [cell.strip() for cell in next(csv.reader([line]))]) for number, line in lines]
    except csv.Error as problem:
        raise ValueError(f"is no CSV: {problem}; {REMEDY}") from None
    except ValueError:  # nothing to unpack
        example = ",".join(map(_head, ("inner_speed", "torque", "uncertainty")))
        raise ValueError(f"is empty; give a line of column heads, as {example}, and a line for each torque") from None
    if len(head[1]) == 1 and re.search("[;\t]", head[1][0]):
        raise ValueError("is separated by semicolons or tabs; separate by commas, and write decimal points")
    columns = _columns(head[1])
    if not others:
        raise ValueError("has a line of column heads and no row below it; give a line for each measured torque")
    return columns, [Row(f"row {row} (line {line})", cells) for row, (line, cells) in enumerate(others, start=1)]


def _columns(cells: Sequence[str]) -> list[Column]:
    columns = [_column(cell) for cell in cells]
    names = [column.name for column in columns]
    for name in COLUMNS:
        if names.count(name) > 1:
            raise ValueError(f"has {names.count(name)} columns {name}; keep one of them")
    if "torque" not in names:
        raise ValueError(f"has no column torque, only {', '.join(names)}; add one, for example {_head('torque')}")
    if not {*OPERATING} & {*names}:
        heads = ", ".join(map(_head, OPERATING))
        raise ValueError(f"does not say where the torques were measured; add a column, one or more of {heads}")
    return columns


def _column(cell: str) -> Column:
    """The column under a head. Raises ValueError."""
    match = HEAD.fullmatch(cell)
    name, unit = match.groups() if match else (cell, None)
    dimension = COLUMNS.get(name)
    if dimension is None:
        near = get_close_matches(name.casefold(), COLUMNS, n=1, cutoff=LIKENESS)
        remedy = f"did you mean {_head(near[0])}?" if near else f"known: {', '.join(COLUMNS)}"
        raise ValueError(f"column {shown(cell)} is not known; {remedy}")
    if not unit:
        raise ValueError(f"column {name} has no unit; write it in brackets, for example {_head(name)}")
    if name == "uncertainty" and unit in ("%", "percent"):
        dimension = SHARE
    try:
        dimension.known_unit(unit)
    except ValueError as problem:
        percent = " or [%]" if name == "uncertainty" else ""
        raise ValueError(f"column {name} [{unit}] {problem}; write for example {_head(name)}{percent}") from None
    return Column(name, unit, dimension)


def _values(columns: Sequence[Column], row: Row) -> Iterator[float]:
    """The numbers of a row, SI. Raises ValueError."""
    if len(row.cells) != len(columns):
        remedy = "write decimal points, not commas" if len(row.cells) > len(columns) else "give one for each"
        count = f"{len(row.cells)} value{'' if len(row.cells) == 1 else 's'}"
        raise ValueError(f"{row.place} has {count}, and there are {len(columns)} columns; {remedy}")
    read = {each.name: _value(each, cell, row.place) for each, cell in zip(columns, row.cells, strict=True)}
    if read.get("inner_speed") == 0:
        raise ValueError(f"{row.place}: inner_speed = 0: nothing turns; give the speed, or leave the row out")
    for column in columns:
        if column.dimension is SHARE:
            read["uncertainty"] *= read["torque"]
    if read.get("uncertainty", 0.0) > read["torque"]:
        raise ValueError(
            f"{row.place}: uncertainty = {torque_of(read['uncertainty'])} is larger than the torque, "
            f"{torque_of(read['torque'])}; give the standard uncertainty of the measured torque (k = 1)"
        )
    yield from read.values()


def _value(column: Column, cell: str, place: str) -> float:
    """A cell in SI. Raises ValueError."""
    if not re.fullmatch(NUMBER, cell, re.ASCII):
        what = "is empty" if not cell else f"= {shown(cell)} is no number"
        raise ValueError(f"{place}: {column.name} {what}; give a number in {column.unit}, or leave the row out")
    if column.name == "torque" and cell.startswith("-"):
        raise ValueError(f"{place}: torque = {cell} {column.unit} is below 0; give its magnitude, whatever its sign")
    try:
        return column.dimension.read(f"{cell} {column.unit}")
    except ValueError as problem:
        raise ValueError(f"{place}: {column.name} = {cell} {column.unit} {problem}") from None


def _head(name: str) -> str:
    """The head of a column, as people write it."""
    return f"{name} [{COLUMNS[name].shown_unit}]"
