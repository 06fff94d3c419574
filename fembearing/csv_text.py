"""Columns of numbers as CSV: names as in datasets and JSON, each with the unit in which it is shown."""

import csv
from collections.abc import Mapping, Sequence
from io import StringIO
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike

from analytic.words import Unit
from fembearing.plain_types import RESIDUE

Words = Mapping[str, Sequence[str | int]]
FORMULAS = ("=", "+", "-", "@")  # how they begin in a spreadsheet
NONE: Words = MappingProxyType({})


def csv_of_columns(columns: Mapping[str, tuple[Unit, ArrayLike]], *, first: Words = NONE, last: Words = NONE) -> str:
    """A line for each row, to 15 digits; heads have the unit in brackets. A cell is empty where nothing is known.

    columns : the unit that is shown, and the numbers in SI, each (n,);  first, last : other columns as they are
    """
    numbers = {
        f"{name} [{unit.name or '1'}]": [
            "" if np.isnan(value) else f"{value:.15g}" for value in unit.number(_settled(values)).tolist()
        ]
        for name, (unit, values) in columns.items()
    }
    every = {**_as_words(first), **numbers, **_as_words(last)}
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(every)
    writer.writerows(zip(*every.values(), strict=True))
    return text.getvalue()


def _as_words(columns: Words) -> Words:
    """With an apostrophe before what a spreadsheet would compute, which a name may look like."""
    return {
        name: [f"'{cell}" if isinstance(cell, str) and cell.startswith(FORMULAS) else cell for cell in cells]
        for name, cells in columns.items()
    }


def _settled(values: ArrayLike) -> np.ndarray:
    """Round-off is 0."""
    numbers = np.asarray(values, dtype=float)
    return np.where(np.abs(numbers) <= RESIDUE, 0.0, numbers)
