"""Pressure and film of a lubricated contact: maps over the contact, and both along the line of rolling."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Ellipse
from matplotlib.ticker import MaxNLocator

from analytic.figures.style import BLACK, BLUE, GREY, LETTERS, RED, WIDTH, lettered
from analytic.units import METRIC
from fembearing.ehl.film import NumericalFilm

SEEN = 1.45  # semi-axes that a map shows to each side
HEIGHT = 5.6  # inches
LEVELS = 24
THICKEST = 1.4  # central films: where the scale of the film ends
CAPTION = (
    "Above: pressure and film over the contact; oil flow from left to right; dashed: Hertz's ellipse. The film is flat "
    "in the middle and thin in a horseshoe at the outlet and the sides. Below: both along the line of rolling. The "
    "pressure differs from Hertz's semi-ellipse in the inlet (the source of the rolling force) and in a spike at the "
    "outlet, where the film is thinnest."
)


def film_figure(solution: NumericalFilm) -> Figure:
    """The figure of a solved contact, metric."""
    contact, units = solution.contact, METRIC
    a, b = contact.semi_axes
    x, y = solution.x, np.concatenate([-solution.y[::-1], solution.y])
    pressure, height = (np.concatenate([each[:, ::-1], each], axis=1) for each in (solution.pressure, solution.film))
    figure = Figure(figsize=(WIDTH, HEIGHT), layout="constrained")
    grid = figure.add_gridspec(2, 2, height_ratios=(1.25, 1.0))
    across, small = units.length, units.small_length
    thin = 0.9 * solution.minimum_film.value, THICKEST * solution.central_film.value
    for column, (values, ends, unit, name, colours) in enumerate(
        (
            (pressure, (0.0, pressure.max()), units.pressure, "pressure", "viridis"),
            (height, thin, small, "film", "magma_r"),
        )
    ):
        panel = figure.add_subplot(grid[0, column])
        levels = np.linspace(ends[0] * unit.factor, ends[1] * unit.factor, LEVELS + 1)
        shown = np.clip(values * unit.factor, levels[0], levels[-1])
        map_ = panel.contourf(x / a, y * across.factor, shown.T, levels=levels, cmap=colours)
        panel.add_patch(Ellipse((0, 0), 2, 2 * b * across.factor, fill=False, linestyle="--", color=GREY, linewidth=1))
        panel.set(xlim=(-SEEN, SEEN), ylim=(-SEEN * b * across.factor, SEEN * b * across.factor))
        panel.set(xlabel="along rolling, semi-axes a", ylabel=f"across, {across.name}")
        bar = figure.colorbar(map_, ax=panel, label=f"{name}, {unit.name}", ticks=MaxNLocator(6))
        bar.ax.yaxis.label.set_fontsize(LETTERS)
    panel = figure.add_subplot(grid[1, :])
    _along_rolling(panel, solution)
    return lettered(figure)


def _along_rolling(panel: Axes, solution: NumericalFilm) -> None:
    """Pressure, Hertz's semi-ellipse and film along the line of rolling through the centre."""
    contact, x, units = solution.contact, solution.x, METRIC
    pressure, height = solution.pressure[:, 0], solution.film[:, 0]
    a = contact.semi_axes[0]
    fine = np.linspace(-1, 1, 400)
    peak = contact.peak_pressure * units.pressure.factor
    panel.plot(fine, peak * np.sqrt(1 - fine**2), color=BLACK, linewidth=1, linestyle="--", label="Hertz's pressure")
    panel.plot(x / a, pressure * units.pressure.factor, color=BLUE, label="pressure")
    panel.set(xlim=(-2.5, SEEN), ylim=(0, 1.25 * peak), xlabel="along rolling, semi-axes a")
    panel.set_ylabel(f"pressure, {units.pressure.name}")
    panel.grid(alpha=0.3)
    other = panel.twinx()
    small = units.small_length
    other.plot(x / a, height * small.factor, color=RED, label="film")
    other.set(ylim=(0, 4 * solution.central_film.value * small.factor), ylabel=f"film, {small.name}")
    handles = [*panel.get_legend_handles_labels()[0], *other.get_legend_handles_labels()[0]]
    panel.legend(
        handles, [str(each.get_label()) for each in handles], loc="center left", frameon=False, fontsize=LETTERS
    )
