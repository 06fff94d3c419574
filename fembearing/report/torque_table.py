"""The numbers of a torque as a table: a row for each operating point, in the units that people use."""

import csv
from io import StringIO
from typing import NamedTuple

import numpy as np

from analytic.labelled import Column
from analytic.scene import Array
from analytic.scene_torque import SceneTorque
from analytic.words import Unit
from fembearing.quantities import shown_unit

BEARING = "bearing"  # the last column: its name
POINT = "point"  # the first column: the number of the operating point, from 1


class ShownColumn(NamedTuple):
    """A column in the unit in which it is shown."""

    column: Column
    unit: Unit
    values: Array  # (n,) in this unit; NaN where nothing is known


def shown_columns(result: SceneTorque) -> dict[str, ShownColumn]:
    """Every column of a torque that holds something, by its name in datasets."""
    shown = {}
    for name, (_, values, column) in result.columns().items():
        known = np.where(np.isfinite(values), values, np.nan)  # an uncertainty that is not known is infinite
        if not np.all(np.isnan(known)):
            unit = shown_unit(name, column.unit)
            shown[name] = ShownColumn(column, unit, known * unit.factor)
    return shown


def csv_of(result: SceneTorque) -> str:
    """The table as CSV, to 15 digits: names as in datasets and JSON, each with its unit in brackets, then the bearing.

    A cell is empty where nothing is known.
    """
    columns = shown_columns(result)
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([POINT, *(f"{name} [{each.unit.name or '1'}]" for name, each in columns.items()), BEARING])
    rows = zip(*(each.values.tolist() for each in columns.values()), strict=True)
    for number, row in enumerate(rows, start=1):
        cells = ("" if np.isnan(value) else f"{value:.15g}" for value in row)
        writer.writerow([number, *cells, result.scene.bearing.name])
    return text.getvalue()
