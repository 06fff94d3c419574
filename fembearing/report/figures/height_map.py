"""The height map of a race as it counts: without plane, form and gaps."""

import textwrap

import numpy as np
from matplotlib.figure import Figure

from analytic.errors import InputError
from analytic.figures.style import LETTERS, WIDTH, lettered
from analytic.scene import HeightMapFile
from analytic.surface.heightmap import measure, read_height_map
from analytic.units import Units
from fembearing.report.report import Report

HIGH = 3.4  # inches
MOST = 400  # points of the picture in each direction
ENDS = 3.0  # of the colours, in Sq: what lies beyond is rare, and would make the rest pale
LETTERS_WIDE = 110  # of a line below the figure


def height_map_plot(document: Report) -> tuple[Figure | None, str]:
    """The map of the surface that the torque has, if any."""
    surface = document.scene.surface
    if document.solved is None or surface is None or surface.height_map is None:
        return None, ""
    try:
        return height_map_figure(surface.height_map, document.units)
    except InputError as problem:  # the file was there before
        return None, f"There is no picture of the height map: {problem}."


def height_map_figure(file: HeightMapFile, units: Units, *, captioned: bool = False) -> tuple[Figure, str]:
    """The map in colours, and its caption; captioned : it stands below too."""
    found = read_height_map(file.path, spacing=file.spacing)
    small, (rows, columns) = units.small_length, found.heights.shape
    measured = measure(found)
    roughness, length = measured.moments.rms_roughness, measured.correlation_length
    figure = Figure(figsize=(WIDTH, HIGH), layout="compressed")
    panel = figure.add_subplot()
    step = -(-max(rows, columns) // MOST)
    image = panel.imshow(
        small.factor * found.heights[::step, ::step],
        extent=(0, small.factor * columns * found.spacing, small.factor * rows * found.spacing, 0),
        vmin=-ENDS * small.factor * roughness,
        vmax=ENDS * small.factor * roughness,
        cmap="cividis",
        interpolation="none",
    )
    panel.set(xlabel=f"x, {small.name}", ylabel=f"y, {small.name}")
    bar = figure.colorbar(image, extend="both")
    bar.set_label(f"height, {small.name}", fontsize=LETTERS)
    waves = small.written(length, ".3g") if np.isfinite(length) else "more than half of the map"
    caption = (
        f"Heights that count, {rows} by {columns} points every {small.written(found.spacing, '.4g')}, without plane "
        f"and form (a polynomial of second order). Sq {small.written(roughness, '.3g')}, with the form "
        f"{small.written(found.with_form, '.3g')}; correlation length {waves}. Look for stripes, scratches and single "
        "peaks: the model takes a surface that is alike in all directions."
    )
    caption += "".join(f" {doubt[0].upper()}{doubt[1:]}." for doubt in found.warnings)
    if captioned:
        figure.supxlabel(textwrap.fill(caption, LETTERS_WIDE), fontsize=LETTERS)
    return lettered(figure), caption
