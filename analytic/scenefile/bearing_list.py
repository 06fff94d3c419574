"""Lists of bearings in a table: a row for each, with loads, speed and oil of its own.

    designation;radial_load [kN];speed [rpm];oil
    6206;1,2;3000;ISO VG 68
    7208B;2,5;1500;

An empty cell leaves the usual value. A cell may have its own unit.
"""

import os
import re
from typing import NamedTuple

from analytic.declared import read_only
from analytic.errors import InputError
from analytic.given import KEYS
from analytic.quantity import NUMBER
from analytic.scenefile.columns import Columns, written
from analytic.scenefile.keys import scene_key
from analytic.words import plain

ENDINGS = (".csv", ".tsv", ".xlsx")  # of the name of a file
LIST = Columns(
    known={"designation": None, **{name: scene_key(key).dimension for name, key in KEYS.items()}},
    required="designation",
    row="bearing",
    example=("designation", "radial_load", "speed"),
    synonyms=read_only({"bearing": "designation", "inner_speed": "speed"}),
)


class ListedBearing(NamedTuple):
    """A row of a list."""

    designation: str
    place: str  # of the row, with the file, as messages name it
    options: dict[str, str]  # that the row gives, by the names of `analytic.given.KEYS`


def read_list(path: str | os.PathLike[str]) -> tuple[list[ListedBearing], tuple[str, ...]]:
    """The bearings of a CSV or .xlsx file, and warnings on how it was read. Raises InputError as `Columns.rows`.

    Which bearings these are, and whether their options fit, turns out when their scenes are read.
    """
    columns, rows, warnings = LIST.rows(path)
    found = []
    for row, cells in rows:
        place = f"{plain(os.fspath(path))}: {row}"
        texts = {column.name: written(cell) for column, cell in zip(columns, cells, strict=True) if cell != ""}
        units = {column.name: column.unit for column in columns if LIST.known[column.name] is not None}
        texts |= {
            name: f"{texts[name]} {unit}".rstrip()
            for name, unit in units.items()
            if re.fullmatch(NUMBER, texts.get(name, ""), re.ASCII)
        }
        if "designation" not in texts:
            raise InputError(f"{place}: designation is empty; give one, or leave the row out")
        found.append(ListedBearing(texts.pop("designation"), place, texts))
    return found, warnings
