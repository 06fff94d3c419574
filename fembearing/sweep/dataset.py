"""What a sweep found as one xarray.Dataset: the axes are its coordinates, units, meanings and provenance attributes."""

import json
from collections import Counter
from collections.abc import Iterable
from typing import Any

import numpy as np

from analytic.sampled import SEED
from fembearing.compare.provenance import provenance_of
from fembearing.sweep.grid import Axis, Grid
from fembearing.sweep.parts import Part, Piece, column_notes

REASON = "failure"  # why a point failed; empty where it did not
MEANINGS = {
    "operation.axial_load": "axial load",
    "operation.inner_speed": "speed of the inner ring",
    "operation.radial_load": "radial load",
    "operation.moment": "moment",
    "lubricant.viscosity": "viscosity",
    "surface.rms_roughness": "rms roughness",
    "bearing.catalog": "bearing",
    "conformity": "conformity, groove radius over ball diameter",
    "ball_load": "load of the ball",
}
MOST_WARNINGS = 50


def gathered(grid: Grid, found: Iterable[tuple[Piece, Part]]) -> Any:
    """The dataset of all pieces; what is missing among them is NaN."""
    import xarray  # on demand: it takes a second

    notes = column_notes(grid)
    columns = {name: np.full(grid.size, np.nan) for name in notes}
    words: dict[str, Any] = {}
    reasons = np.full(grid.size, "", dtype=object)
    warnings: Counter[str] = Counter()
    for piece, part in found:
        here = slice(piece.start, piece.stop)
        for name, values in part.columns.items():
            columns[name][here] = values
        for name, values in part.words.items():
            words.setdefault(name, np.full(grid.size, "", dtype=object))[here] = values
        for place, reason in part.reasons.items():
            reasons[piece.start + place] = reason
        warnings.update(part.warnings)
    names = axis_names(grid.axes)
    dimensions = [names[axis.key] for axis in grid.order]
    shape = tuple(len(axis.values) for axis in grid.order)
    described = {
        name: (dimensions, values.reshape(shape), {"units": notes[name].unit, "long_name": notes[name].meaning})
        for name, values in columns.items()
        if not np.all(np.isnan(values))
    }
    described |= {name: (dimensions, values.reshape(shape)) for name, values in words.items()}
    described[REASON] = (dimensions, reasons.reshape(shape), {"long_name": "why a point failed; empty where not"})
    dataset = xarray.Dataset(
        described,
        coords={names[axis.key]: (names[axis.key], list(axis.values), _axis_notes(axis)) for axis in grid.axes},
        attrs=_provenance(grid, warnings),
    )
    return dataset.transpose(*(names[axis.key] for axis in grid.axes))


def axis_names(axes: Iterable[Axis]) -> dict[str, str]:
    """Key to name of the dimension: without the table of the scene, where it is clear without."""
    short = {axis.key: "bearing" if axis.key == "bearing.catalog" else _short(axis.key) for axis in axes}
    counts = Counter(short.values())
    return {key: name if counts[name] == 1 else key.replace(".", "_") for key, name in short.items()}


def _short(key: str) -> str:
    table, _, rest = key.partition(".")
    return (rest or table).replace(".", "_")


def _axis_notes(axis: Axis) -> dict[str, str]:
    notes = {"long_name": MEANINGS.get(axis.key, _short(axis.key).replace("_", " ")), "key": axis.key}
    return notes | ({} if axis.unit is None else {"units": axis.unit or "1"})


def _provenance(grid: Grid, warnings: Counter[str]) -> dict[str, Any]:
    scene = grid.first_scene()
    told = provenance_of(scene)
    content = told.pop("scene_content")
    most = [warning for warning, _ in warnings.most_common(MOST_WARNINGS)]
    return {
        "title": f"{grid.what} of {scene.name}",
        "fembearing": told["versions"]["fembearing"],
        "grid": grid.text,
        "first_scene": json.dumps(content),
        "seed": SEED,  # of the points at which a long series is sampled; a cage's seeds are numbered in the scene
        "warnings": "\n".join(most),
        **{name: value if isinstance(value, str | int) else json.dumps(value) for name, value in told.items()},
    }
