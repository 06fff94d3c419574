"""The numbers of a torque as a table: a row for each operating point, in the units that people use."""

import csv
from collections.abc import Mapping
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
SCENE = "scene"  # before it, of several scenes: as the user named it


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
    return compared_csv({result.scene.name: result})


def compared_csv(results: Mapping[str, SceneTorque]) -> str:
    """The same of several scenes, by their names, which are the first column where there are several."""
    shown = {scene: shown_columns(result) for scene, result in results.items()}
    heads = {name: each.unit.name or "1" for columns in shown.values() for name, each in columns.items()}
    several = len(results) > 1
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    first = [SCENE, POINT] if several else [POINT]
    writer.writerow([*first, *(f"{name} [{unit}]" for name, unit in heads.items()), BEARING])
    for scene, result in results.items():
        unknown = np.full(result.places.size, np.nan)
        values = [shown[scene][name].values if name in shown[scene] else unknown for name in heads]
        for number, row in enumerate(zip(*(each.tolist() for each in values), strict=True), start=1):
            cells = ("" if np.isnan(value) else f"{value:.15g}" for value in row)
            writer.writerow([*([scene] if several else []), number, *cells, result.scene.bearing.name])
    return text.getvalue()
