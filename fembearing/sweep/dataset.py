"""The result of a sweep as one dataset, netCDF: axes are coordinates; units, meanings and provenance are attributes."""

import json
from collections import Counter
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.columns import COLUMNS
from fembearing.provenance import provenance_of, without_folders
from fembearing.sweep.grid import Axis, Grid
from fembearing.sweep.parts import column_notes

QUANTITY = {
    "bearing.catalog": "bearing",
    "lubricant.name": "oil",
    "ball_load": "load",
}  # of an axis, where its key does not end in its name
MOST_WARNINGS = 50


def write_dataset(file: Path, grid: Grid, values: Mapping[str, NDArray[Any]], warnings: Counter[str]) -> None:
    """Write the dataset as netCDF, without the columns that hold no number.

    values : (size,) in the order of the points, by the name of the column
    """
    import xarray  # on demand: it takes a second

    names = axis_names(grid.axes)
    shape = tuple(len(axis.values) for axis in grid.order)
    variables = {}
    for name, note in column_notes(grid).items():
        if note.unit and np.all(np.isnan(values[name])):
            continue
        notes = {"long_name": note.meaning} | ({"units": note.unit} if note.unit else {})
        variable = xarray.Variable([names[axis.key] for axis in grid.order], values[name].reshape(shape), notes)
        variables[name] = variable.transpose(*names.values())
    coordinates = {names[axis.key]: (names[axis.key], list(axis.values), _axis_notes(axis)) for axis in grid.axes}
    dataset = xarray.Dataset(variables, coords=coordinates, attrs=_provenance(grid, warnings))
    dataset.to_netcdf(file, engine="netcdf4")


def axis_names(axes: Iterable[Axis]) -> dict[str, str]:
    """Key to name of the dimension: without the table of the scene, where it is clear without."""
    short = {axis.key: "bearing" if axis.key == "bearing.catalog" else _short(axis.key) for axis in axes}
    counts = Counter(short.values())
    return {key: name if counts[name] == 1 else key.replace(".", "_") for key, name in short.items()}


def _short(key: str) -> str:
    table, _, rest = key.partition(".")
    return (rest or table).replace(".", "_")


def _axis_notes(axis: Axis) -> dict[str, str]:
    name = QUANTITY.get(axis.key, _short(axis.key))
    notes = {"long_name": COLUMNS[name].meaning if name in COLUMNS else name.replace("_", " "), "key": axis.key}
    return notes | ({} if axis.unit is None else {"units": axis.unit or "1"})


def _provenance(grid: Grid, warnings: Counter[str]) -> dict[str, Any]:
    scene = grid.first_scene()
    origin = provenance_of(scene)
    others = {name: value for name, value in vars(origin).items() if name != "scene_content"}
    most = [warning for warning, _ in warnings.most_common(MOST_WARNINGS)]
    return {
        "title": f"{grid.what} of {scene.name}",
        "fembearing": origin.versions["fembearing"],
        "grid": without_folders(grid.text),
        "first_scene": json.dumps(origin.scene_content),
        "warnings": "\n".join(most),
        **{name: value if isinstance(value, str | int) else json.dumps(value) for name, value in others.items()},
    }
