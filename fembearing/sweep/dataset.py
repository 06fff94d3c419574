"""The result of a sweep as one dataset, netCDF: axes are coordinates; units, meanings and provenance are attributes."""

import json
from collections import Counter
from collections.abc import Callable, Container, Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.numerics.interpolated import SEED
from fembearing.provenance import provenance_of
from fembearing.quantities import QUANTITIES
from fembearing.sweep.grid import Axis, Grid
from fembearing.sweep.parts import Part, Piece, column_notes
from fembearing.verify.contact.columns import VERDICT

REASON = "failure"
WORDS = {REASON: "why a point failed; empty where not", VERDICT: "verdict on Hertz by the scene's tolerance"}
QUANTITY = {"bearing.catalog": "bearing", "ball_load": "load"}  # of an axis, where its key does not end in its name
MOST_WARNINGS = 50
BYTES_TOGETHER = 8_000_000


def write_dataset(
    file: Path, grid: Grid, parts: Callable[[Container[str]], Iterable[tuple[Piece, Part]]]
) -> tuple[str, ...]:
    """Write the dataset as netCDF, what is missing as NaN; why points failed, in the order of the grid.

    parts : every piece with its part, of which these columns alone
    A few columns are in memory at a time.
    """
    import xarray  # on demand: it takes a second

    names = axis_names(grid.axes)
    dimensions = [names[axis.key] for axis in grid.order]
    shape = tuple(len(axis.values) for axis in grid.order)

    def variable(values: NDArray[Any], **notes: str) -> Any:
        whole = xarray.Variable(dimensions, values.reshape(shape), notes)
        return whole.transpose(*(names[axis.key] for axis in grid.axes))

    words: dict[str, Any] = {REASON: np.full(grid.size, "", dtype=object)}
    warnings: Counter[str] = Counter()
    for piece, part in parts(()):
        for name, values in part.words.items():
            words.setdefault(name, np.full(grid.size, "", dtype=object))[piece.start : piece.stop] = values
        for place, reason in part.reasons.items():
            words[REASON][piece.start + place] = reason
        warnings.update(part.warnings)
    xarray.Dataset(
        {name: variable(values, long_name=WORDS[name]) for name, values in words.items()},
        coords={names[axis.key]: (names[axis.key], list(axis.values), _axis_notes(axis)) for axis in grid.axes},
        attrs=_provenance(grid, warnings),
    ).to_netcdf(file, engine="netcdf4")

    notes = column_notes(grid)
    for together in _groups(list(notes), grid.size):
        columns = {name: np.full(grid.size, np.nan) for name in together}
        for piece, part in parts(together):
            for name, values in part.columns.items():
                columns[name][piece.start : piece.stop] = values
        xarray.Dataset(
            {
                name: variable(values, units=notes[name].unit, long_name=notes[name].meaning)
                for name, values in columns.items()
                if not np.all(np.isnan(values))
            }
        ).to_netcdf(file, mode="a", engine="netcdf4")
    return tuple(reason for reason in words[REASON] if reason)


def _groups(names: list[str], size: int) -> Iterator[list[str]]:
    """Columns that are in memory together."""
    most = max(1, BYTES_TOGETHER // (8 * size))
    for start in range(0, len(names), most):
        yield names[start : start + most]


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
    notes = {"long_name": QUANTITIES[name].meaning if name in QUANTITIES else name.replace("_", " "), "key": axis.key}
    return notes | ({} if axis.unit is None else {"units": axis.unit or "1"})


def _provenance(grid: Grid, warnings: Counter[str]) -> dict[str, Any]:
    scene = grid.first_scene()
    origin = provenance_of(scene)
    others = {name: value for name, value in vars(origin).items() if name != "scene_content"}
    most = [warning for warning, _ in warnings.most_common(MOST_WARNINGS)]
    return {
        "title": f"{grid.what} of {scene.name}",
        "fembearing": origin.versions["fembearing"],
        "grid": grid.text,
        "first_scene": json.dumps(origin.scene_content),
        "seed": SEED,  # of the points at which a long series is sampled; a cage's seeds are numbered in the scene
        "warnings": "\n".join(most),
        **{name: value if isinstance(value, str | int) else json.dumps(value) for name, value in others.items()},
    }
