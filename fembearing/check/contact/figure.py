"""Contact pressure along both axes through the centre: finite elements as points, Hertz as a line."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TypeVar

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.columns import CONTACT
from analytic.figures.style import BLACK, BLUE, LETTERS, RED, SIDE_BY_SIDE, WIDTH, lettered
from analytic.scene import Array
from analytic.units import Units
from fembearing.check.contact.hertz import Profiles
from fembearing.fem.measure import Quantities

ROLLING, TRANSVERSE = CONTACT["semi_axis_rolling"], CONTACT["semi_axis_transverse"]
ALONG = {  # axis of the profile -> semi-axis, words, colour, mark, line
    "rolling": ("semi_axis_rolling", f"rolling, x/{ROLLING.symbol}", BLUE, "o", "-"),
    "transverse": ("semi_axis_transverse", f"transverse, y/{TRANSVERSE.symbol}", RED, "s", "--"),
}
EDGE = 0.9  # of the distance to the edge: differences up to there set the scale; beyond, two edges are compared
HIGHEST = 1.5  # of Hertz's peak: at a shoulder the pressure has no bound
UPPER, LOWER = 1.6, 1.2  # inches: heights of the two panels of a contact
HEADS = 0.7  # inches: titles of a row of contacts, and names of its axes
AnyContact = TypeVar("AnyContact")
CAPTION = (
    "Above: pressure at the nodes of the finest mesh on both axes through the contact's centre, and Hertz's "
    "semi-ellipse; positions in Hertz's semi-axes, a along rolling and b transverse. Below: nodes less Hertz; lines: "
    "semi-ellipse with a, b and peak pressure of the finite elements, less Hertz's. Single nodes scatter about it, "
    "most in the cell of the edge; the peak pressure is a fit to many nodes."
)
CUT = (
    " Dotted: shoulder that cuts off a contact; the pressure beside it is unbounded, and nodes there may be off "
    "the scale."
)


@dataclass(frozen=True, kw_only=True)
class DrawnPressure:
    """What the figure shows of a contact."""

    title: str
    profiles: Profiles
    hertz: Quantities
    fe: Quantities
    shoulders: Sequence[float]  # y of those that cut the contact off, m
    is_half: bool  # whether both transverse sides of the centre are meshed: where one shoulder cuts the contact off

    @property
    def sides(self) -> list[float]:
        """y of the shoulders on the sides that are drawn, m."""
        return [y for y in self.shoulders if y > 0 or self.is_half]


def pressure_figure(contacts: Sequence[DrawnPressure], units: Units) -> Figure:
    """A column for each contact."""
    labels = (f"pressure, {units.pressure.name}", "less Hertz,\n% of its peak")
    rows = _profile, lambda panel, contact, _: _difference(panel, contact)
    return contact_columns(contacts, *rows, units=units, labels=labels, shared=True)


def contact_columns(
    contacts: Sequence[AnyContact],
    *rows: Callable[[Axes, AnyContact, Units], None],
    units: Units,
    labels: tuple[str, str],
    shared: bool = False,
) -> Figure:
    """Two panels for each contact, one above the other, contacts side by side, with one legend for all.

    rows : what draws the upper and the lower panel;  labels : of the vertical axis of both
    shared : both panels of a contact have one horizontal axis
    """
    storeys = -(-len(contacts) // SIDE_BY_SIDE)
    columns = -(-len(contacts) // storeys)
    figure = Figure(figsize=(WIDTH, 0.3 + storeys * (HEADS + UPPER + LOWER)), layout="constrained")
    grid = figure.add_gridspec(2 * storeys, columns, height_ratios=(UPPER, LOWER) * storeys)
    for number, contact in enumerate(contacts):
        storey, column = divmod(number, columns)
        above = None
        for row, (draw, label) in enumerate(zip(rows, labels, strict=True)):
            panel = figure.add_subplot(grid[2 * storey + row, column], sharex=above if shared else None)
            above = above or panel
            draw(panel, contact, units)
            panel.set_ylabel("" if column else label)
            panel.grid(alpha=0.3)
    handles, words = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, words, loc="outside lower center", ncols=SIDE_BY_SIDE, frameon=False, fontsize=LETTERS)
    return lettered(figure)


def _profile(panel: Axes, contact: DrawnPressure, units: Units) -> None:
    """Pressure along both axes, with Hertz's semi-ellipse."""
    hertz, factor = contact.hertz, units.pressure.factor
    for axis, (name, words, colour, mark, _) in ALONG.items():
        nodes = getattr(contact.profiles, axis).fe
        position = np.array(nodes.position) / getattr(hertz, name)
        pressure = factor * np.array(nodes.pressure)
        panel.plot(position, pressure, mark, color=colour, markersize=4, markerfacecolor="white", label=words)
    line = contact.profiles.rolling.hertz  # both axes are one line in semi-axes
    position = np.array(line.position) / hertz.semi_axis_rolling
    pressure = factor * np.array(line.pressure)
    if contact.is_half:
        panel.plot(-position[::-1], pressure[::-1], color=BLACK, linewidth=1)
    panel.plot(position, pressure, color=BLACK, linewidth=1, label="Hertz")
    for y in contact.sides:
        panel.axvline(y / hertz.semi_axis_transverse, color=RED, linewidth=1, linestyle=":")
    panel.set_title(contact.title)
    panel.set_ylim(0, min(panel.get_ylim()[1], HIGHEST * factor * hertz.peak_pressure))


def _difference(panel: Axes, contact: DrawnPressure) -> None:
    """The nodes less Hertz, per cent of Hertz's peak."""
    hertz, computed, largest = contact.hertz, contact.fe, 0.0
    for axis, (name, _, colour, mark, line) in ALONG.items():
        nodes = getattr(contact.profiles, axis).fe
        position = np.array(nodes.position)
        apart = 100 * (np.array(nodes.pressure) - _semi_ellipse(position, hertz, name)) / hertz.peak_pressure
        edge = min(map(abs, contact.sides), default=np.inf) if axis == "transverse" else np.inf
        inside = np.abs(position) <= EDGE * min(getattr(hertz, name), edge)
        largest = max(largest, float(np.abs(apart[inside]).max(initial=0.0)))
        panel.plot(position / getattr(hertz, name), apart, mark, color=colour, markersize=4, markerfacecolor="white")
        if contact.shoulders:  # a cut contact is no semi-ellipse
            continue
        fine = np.linspace(position.min(), position.max(), 400)
        expected = _semi_ellipse(fine, computed, name) - _semi_ellipse(fine, hertz, name)
        panel.plot(fine / getattr(hertz, name), 100 * expected / hertz.peak_pressure, line, color=colour, linewidth=1)
    panel.axhline(0, color=BLACK, linewidth=1)
    panel.set_ylim(-2.5 * max(largest, 0.4), 2.5 * max(largest, 0.4))
    panel.set_xlabel("position, semi-axes")


def _semi_ellipse(position: Array, quantities: Quantities, semi_axis: str) -> Array:
    inside = 1 - (position / getattr(quantities, semi_axis)) ** 2
    return quantities.peak_pressure * np.sqrt(np.maximum(inside, 0.0))
