"""A sweep as pictures: a map in colour over two axes, lines over one; further axes side by side."""

import json
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import colormaps
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.cm import ScalarMappable
from matplotlib.colors import LogNorm, Normalize
from matplotlib.figure import Figure
from matplotlib.patheffects import withStroke
from matplotlib.ticker import LogLocator, MaxNLocator

from analytic.columns import COLUMNS
from analytic.figures.style import DECADE, plain_numbers
from analytic.scene import Array
from analytic.units import METRIC, unit_for
from analytic.words import Unit
from analytic.writing import write
from fembearing.report.figures.style import png

PLOTTED = ("torque_total", "peak_pressure_inner", "peak_pressure", "discrepancy_peak_pressure")
MOST_PANELS, MOST_LINES = 6, 8
FEWEST = 3  # values of an axis of a map
WIDE = 20.0  # ratio of the largest to the smallest from which on a scale of colours or heights is logarithmic
WIDE_AXIS = 4.0  # the same of an axis whose steps are nearer to even in the logarithm


def write_maps(dataset: Any, folder: Path) -> list[Path]:
    """Write NAME.png of each variable that is plotted, if there is any number in it."""
    written = []
    for name in PLOTTED:
        if name in dataset and np.any(np.isfinite(dataset[name])) and any(size > 1 for size in dataset.sizes.values()):
            written.append(folder / f"{name}.png")
            write(written[-1], png(map_figure(dataset, name)))
    return written


def map_figure(dataset: Any, name: str) -> Figure:
    """One variable of the dataset of a sweep over its axes."""
    variable = dataset[name]
    fixed = [dimension for dimension in variable.dims if variable.sizes[dimension] == 1]
    variable = variable.squeeze(fixed, drop=False)
    numeric = [d for d in variable.dims if np.issubdtype(variable[d].dtype, np.number)]
    variable = variable.sortby(numeric)
    longest = sorted((d for d in numeric if variable.sizes[d] >= FEWEST), key=lambda d: -variable.sizes[d])[:2]
    across = [d for d in variable.dims if d in longest] or [max(variable.dims, key=lambda d: variable.sizes[d])]
    others = [d for d in variable.dims if d not in across]
    unit = _unit_of(variable, relative=name.startswith(("uncertainty", "discrepancy")))
    title = ", ".join([f"{variable.attrs['long_name']}", *(_place(variable[d], variable[d].values) for d in fixed)])
    draw = _draw_map if len(across) == 2 else _draw_lines
    figure = draw(variable, across, others, unit)
    if not np.all(np.isfinite(variable)):
        title += " (grey: failed)" if len(across) == 2 else " (gaps: failed)"
    figure.suptitle("\n".join([title, *_fixed_words(dataset)]), fontsize=10, wrap=True)
    return figure


def _fixed_words(dataset: Any) -> list[str]:
    """Bearing, oil, temperature, loads and speed of all points, as far as no axis changes them: one line, or none."""
    scene = json.loads(dataset.attrs.get("first_scene", "{}"))
    varied = {str(dataset[axis].attrs.get("key", axis)) for axis in dataset.sizes}
    bearing, oil, operation = (scene.get(table) or {} for table in ("bearing", "lubricant", "operation"))
    words = [] if "bearing.catalog" in varied else [bearing.get("name")]
    if oil and "lubricant.name" not in varied:
        words.append(oil.get("name") or "oil")
    for value, key, unit in (
        (oil.get("temperature"), "lubricant.temperature", METRIC.temperature),
        *((operation.get(name), f"operation.{name}", COLUMNS[name].shown()) for name in ("axial_load", "radial_load")),
        (operation.get("inner_speed"), "operation.inner_speed", METRIC.speed),
    ):
        values = value if isinstance(value, list) else [value]
        if key in varied or len(values) != 1 or not values[0]:
            continue
        name = "" if key == "lubricant.temperature" else f"{key.partition('.')[2].partition('_')[0]} "
        words.append(f"{name}{unit.written(values[0], '.4g')}")
    known = [word for word in words if word]
    return [", ".join(known)] if known else []


def _draw_map(variable: Any, across: list[str], others: list[str], unit: Unit) -> Figure:
    """A coloured map over two axes; a panel for each value of the others."""
    (vertical, horizontal), shown = across, list(_choices(variable, others, MOST_PANELS))
    columns = 2 if len(shown) == 4 else min(3, len(shown))
    rows = -(-len(shown) // columns)
    figure = Figure(figsize=(2.2 + 4.6 * columns, 0.8 + 3.6 * rows), layout="constrained")
    panels = figure.subplots(rows, columns, squeeze=False, sharex=True, sharey=True)
    norm = _norm(unit.number(variable.values))
    levels = _levels(norm)
    colours = colormaps["viridis"].with_extremes(bad="lightgrey")
    for panel, chosen in zip(panels.ravel(), shown, strict=False):
        part = variable.sel(chosen).transpose(vertical, horizontal)
        x, y = (_shown_axis(part[dimension]) for dimension in (horizontal, vertical))
        values = unit.number(part.values)
        whole = bool(np.all(np.isfinite(values)))
        if whole:  # colours between the computed points, which are dots
            ends = [x, y]
            panel.pcolormesh(x, y, values, norm=norm, cmap=colours, shading="gouraud", rasterized=True)
            panel.plot(*(each.ravel() for each in np.meshgrid(x, y)), ".", color="white", markersize=2, clip_on=False)
        else:
            ends = [_edges(part[dimension]) for dimension in (horizontal, vertical)]
            panel.pcolormesh(*ends, np.ma.masked_invalid(values), norm=norm, cmap=colours)
        if whole and levels and np.ptp(values) > 0:
            lines = panel.contour(x, y, values, levels=levels, colors="white", linewidths=0.7)
            for text in panel.clabel(lines, fontsize=8, fmt="%g"):
                text.set_path_effects([withStroke(linewidth=1.5, foreground="black")])  # on the lightest colours too
        for axis, dimension in ((panel.xaxis, horizontal), (panel.yaxis, vertical)):
            _set_axis(panel, axis, variable[dimension])
        panel.set(**{f"{axis}lim": (each[0], each[-1]) for axis, each in zip("xy", ends, strict=True)})
        panel.set_title(", ".join(_place(variable[d], value) for d, value in chosen.items()), fontsize=9)
    for panel in panels.ravel()[len(shown) :]:
        panel.set_axis_off()
    for panel in panels[-1]:
        panel.set_xlabel(_label(variable[horizontal]))
    for panel in panels[:, 0]:
        panel.set_ylabel(_label(variable[vertical]))
    bar = figure.colorbar(ScalarMappable(norm, colours), ax=panels, label=f"{_name(variable)}, {unit.name}")
    if isinstance(norm, LogNorm):
        plain_numbers(bar.ax.yaxis)
    return figure


def _draw_lines(variable: Any, across: list[str], others: list[str], unit: Unit) -> Figure:
    """A line for each value of the other axes."""
    (horizontal,) = across
    figure = Figure(figsize=(7.4, 4.8), layout="constrained")
    panel = figure.subplots()
    for chosen in _choices(variable, others, MOST_LINES):
        part = variable.sel(chosen)
        label = ", ".join(_place(variable[d], value) for d, value in chosen.items())
        panel.plot(_shown_axis(part[horizontal]), unit.number(part.values), "o-", markersize=3, label=label)
    _set_axis(panel, panel.xaxis, variable[horizontal])
    known = variable.values[np.isfinite(variable.values)]
    is_wide = panel.get_xscale() == "log" and panel.get_xlim()[1] > DECADE * panel.get_xlim()[0]
    if isinstance(_norm(unit.number(variable.values)), LogNorm) or (is_wide and known.min() > 0):
        panel.set_yscale("log")
        plain_numbers(panel.yaxis)
    panel.set(xlabel=_label(variable[horizontal]), ylabel=f"{_name(variable)}, {unit.name}")
    panel.grid(alpha=0.3, which="both")
    if others:
        panel.legend(fontsize=8)
    return figure


def _choices(variable: Any, others: list[str], most: int) -> Iterator[dict[str, Any]]:
    """Values of the other axes, evenly chosen where there are too many."""
    every = list(product(*(variable[d].values for d in others)))
    for number in np.unique(np.linspace(0, len(every) - 1, min(most, len(every))).round().astype(int)):
        yield dict(zip(others, every[number], strict=True))


def _unit_of(values: Any, *, relative: bool = False) -> Unit:
    """The unit in which a variable is shown."""
    if relative:
        return Unit("%", 100.0)
    if not np.issubdtype(values.dtype, np.number):
        return Unit("", 1.0)
    return unit_for(values.attrs.get("units", "1"), float(np.nanmax(np.abs(values))))


def _shown_axis(values: Any) -> Array:
    if not np.issubdtype(values.dtype, np.number):
        return np.array([str(value) for value in values.values])
    return _unit_of(values).number(values.values)


def _place(values: Any, value: Any) -> str:
    """One value of an axis in words."""
    if not np.issubdtype(values.dtype, np.number):
        return f"{_name(values)} {value}"
    return f"{_name(values)} {_unit_of(values).written(float(value), '.4g')}"


def _name(values: Any) -> str:
    return str(values.attrs.get("long_name", values.name)).partition(",")[0]


def _label(values: Any) -> str:
    unit = _unit_of(values)
    return f"{values.attrs.get('long_name', values.name)}" + (f", {unit.name}" if unit.name else "")


def _set_axis(panel: Axes, axis: Axis, values: Any) -> None:
    """Make the axis logarithmic where its steps are nearer to even in the logarithm."""
    if not np.issubdtype(values.dtype, np.number) or not _even_in_logarithm(values.values):
        return
    (panel.set_xscale if axis is panel.xaxis else panel.set_yscale)("log")
    plain_numbers(axis)


def _even_in_logarithm(values: Array) -> bool:
    """Whether the steps of an axis are nearer to even in the logarithm."""
    if values.size < 3 or np.min(values) <= 0 or np.max(values) < WIDE_AXIS * np.min(values):
        return False
    plain, logarithmic = (np.abs(np.diff(part)) for part in (np.sort(values), np.log(np.sort(values))))
    return bool(np.std(logarithmic) / np.mean(logarithmic) < np.std(plain) / np.mean(plain))


def _edges(values: Any) -> Array:
    """Edges of the cells around the values, one more than those: in the middle, in the logarithm where that is even."""
    place = _shown_axis(values)
    logarithmic = _even_in_logarithm(values.values)
    place = np.log(place) if logarithmic else place
    half = np.diff(place) / 2
    ends = np.concatenate([[place[0] - half[0]], place[:-1] + half, [place[-1] + half[-1]]])
    return np.exp(ends) if logarithmic else ends


def _norm(values: Array) -> Normalize:
    known = values[np.isfinite(values)]
    low, high = float(known.min()), float(known.max())
    return LogNorm(low, high) if low > 0 and high > WIDE * low else Normalize(low, high)


def _levels(norm: Normalize) -> list[float]:
    """Round values between both ends, the same in every panel."""
    locator = LogLocator(subs=(1.0, 2.0, 5.0)) if isinstance(norm, LogNorm) else MaxNLocator(8)
    low, high = float(norm.vmin or 0.0), float(norm.vmax or 0.0)
    return [float(tick) for tick in locator.tick_values(low, high) if low < tick < high]
