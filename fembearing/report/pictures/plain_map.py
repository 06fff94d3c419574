"""A contact's pressure as a plain map by matplotlib, where VTK cannot draw; to the same frame."""

from itertools import product

import numpy as np
from matplotlib.cm import ScalarMappable
from matplotlib.colors import Normalize
from matplotlib.figure import Figure
from matplotlib.tri import Triangulation

from fembearing.check.contact.solution import ContactSolution
from fembearing.quantities import MILLI
from fembearing.report.pictures.framing import Frame, PressureScale

DOTS = 100  # per inch
LEVELS = 60
LEAST_SHOWN = 0.005  # of the peak pressure: below, nothing is painted


def pressure_map(contact: ContactSolution, *, title: str, frame: Frame, shown: PressureScale) -> Figure:
    """The pressure on the finest mesh with Hertz's ellipse."""
    peak = shown.peak
    figure = Figure(figsize=(frame.width / DOTS, frame.height / DOTS), dpi=DOTS)
    axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
    left, top = frame.centre
    axes.set_xlim(-left / frame.scale, (frame.width - left) / frame.scale)
    axes.set_ylim((top - frame.height) / frame.scale, top / frame.scale)
    axes.set_axis_off()
    finest = contact.meshes[-1]
    pressure = np.where(finest.force > 0, finest.pressure, 0.0) * shown.factor
    levels = np.linspace(0, peak, LEVELS + 1)
    levels[0] = LEAST_SHOWN * peak
    scale = ScalarMappable(Normalize(0, peak), "viridis")
    # Triangles of a circle: those of a slender ellipse would reach from its edge across to nodes outside.
    triangles = Triangulation(finest.x / finest.x.max(), finest.y / finest.y.max()).triangles
    triangles = triangles[finest.pair.footprint.holds(finest.y[triangles].mean(axis=1))]
    half = finest.pair.footprint.half
    for rolling, across in product((1, -1), (1,) if half else (1, -1)):  # half or a quarter is meshed
        place = rolling * finest.x, across * finest.y
        horizontal, vertical = place if frame.rolling_is_horizontal else place[::-1]
        part = Triangulation(horizontal, vertical, triangles)
        axes.tricontourf(part, np.clip(pressure, 0, peak), levels=levels, cmap=scale.cmap, norm=scale.norm)
    angle = np.linspace(0, 2 * np.pi, 721)
    found, shoulder = contact.numbers, contact.numbers.shoulder
    for quantities, centre, colour, width in (
        (found.reference, 0.0 if shoulder is None else shoulder.centroid.reference, "black", 1.0),
        (found.hertz, 0.0, "red", 1.5),
    ):
        along = quantities.semi_axis_rolling * np.cos(angle), centre + quantities.semi_axis_transverse * np.sin(angle)
        axes.plot(*(along if frame.rolling_is_horizontal else along[::-1]), color=colour, linewidth=width)
    for cut in () if shoulder is None else shoulder.cuts:
        mark = axes.axhline if frame.rolling_is_horizontal else axes.axvline
        mark(cut, color="darkorange", linewidth=1.5)
        figure.text(380 / frame.width, 1 - 52 / frame.height, "orange: shoulder", fontsize=10, color="darkorange")
    figure.text(12 / frame.width, 1 - 28 / frame.height, title, fontsize=12)
    figure.text(12 / frame.width, 1 - 52 / frame.height, "red: Hertz's ellipse", fontsize=10, color="red")
    figure.text(170 / frame.width, 1 - 52 / frame.height, "black: finite elements", fontsize=10)
    bar = figure.add_axes((1 - 440 / frame.width, 56 / frame.height, 420 / frame.width, 20 / frame.height))
    colours = figure.colorbar(scale, cax=bar, orientation="horizontal", ticks=shown.ticks, format="%g")
    colours.set_label(f"contact pressure, {shown.unit}")
    start = (30 - left) / frame.scale, (top - frame.height + 30) / frame.scale
    axes.plot([start[0], start[0] + frame.bar], [start[1], start[1]], color="black", linewidth=3)
    direction = "rolling" if frame.rolling_is_horizontal else "transverse"
    figure.text(30 / frame.width, 40 / frame.height, f"{MILLI.written(frame.bar, 'g')}, {direction}", fontsize=10)
    return figure
