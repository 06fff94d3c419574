"""Columns of numbers as CSV: names as in datasets and JSON, each with the unit in which it is shown."""

import csv
from collections.abc import Mapping, Sequence
from io import StringIO

import numpy as np
from numpy.typing import ArrayLike

from analytic.words import Unit


def csv_of_columns(
    columns: Mapping[str, tuple[Unit, ArrayLike]], *, number: str = "", words: Mapping[str, Sequence[str]] | None = None
) -> str:
    """A line for each row, to 15 digits; heads have the unit in brackets. A cell is empty where nothing is known.

    columns : the unit that is shown, and the numbers in SI, each (n,);  number : head of a first column with the number
    of the row, from 1; empty: none;  words : columns of text, the last ones
    """
    heads = [f"{name} [{unit.name or '1'}]" for name, (unit, _) in columns.items()]
    cells = [
        ["" if np.isnan(value) else f"{value:.15g}" for value in unit.number(np.asarray(values, dtype=float)).tolist()]
        for unit, values in columns.values()
    ]
    if number:
        heads, cells = [number, *heads], [[str(row) for row in range(1, len(cells[0]) + 1)], *cells]
    for name, texts in (words or {}).items():
        heads, cells = [*heads, name], [*cells, list(texts)]
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(heads)
    writer.writerows(zip(*cells, strict=True))
    return text.getvalue()
