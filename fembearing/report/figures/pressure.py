"""Contact pressure along both axes through the centre: finite elements as points, Hertz as a line."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.scene import Array
from fembearing.check.contact.solution import ContactNumbers
from fembearing.fem.measure import Quantities
from fembearing.quantities import CONTACT, Units
from fembearing.report.figures.style import BLACK, BLUE, RED, contact_columns
from fembearing.report.phrases import contact_place
from fembearing.report.report import Report

ROLLING, TRANSVERSE = CONTACT["semi_axis_rolling"], CONTACT["semi_axis_transverse"]
ALONG = {  # axis of the profile -> semi-axis, words, colour, mark, line
    "rolling": ("semi_axis_rolling", f"rolling, x/{ROLLING.symbol}", BLUE, "o", "-"),
    "transverse": ("semi_axis_transverse", f"transverse, y/{TRANSVERSE.symbol}", RED, "s", "--"),
}
EDGE = 0.9  # of the distance to the edge: differences up to there set the scale; beyond, two edges are compared
HIGHEST = 1.5  # of Hertz's peak: at a shoulder the pressure has no bound
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


def pressure_plot(document: Report) -> tuple[Figure | None, str]:
    """A column for each contact."""
    units = document.units
    labels = (f"pressure, {units.pressure.name}", "less Hertz,\n% of its peak")
    figure = contact_columns(document.contacts, _profile, _difference, units=units, labels=labels, shared=True)
    cut = any(contact.shoulder for contact in document.contacts)
    return figure, CAPTION + (CUT if cut else "")


def _profile(panel: Axes, contact: ContactNumbers, units: Units) -> None:
    """Pressure along both axes, with Hertz's semi-ellipse."""
    hertz, factor = contact.hertz, units.pressure.factor
    for axis, (name, words, colour, mark, _) in ALONG.items():
        nodes = getattr(contact.pressure_profile, axis).fe
        position = np.array(nodes.position) / getattr(hertz, name)
        pressure = factor * np.array(nodes.pressure)
        panel.plot(position, pressure, mark, color=colour, markersize=4, markerfacecolor="white", label=words)
    line = contact.pressure_profile.rolling.hertz  # both axes are one line in semi-axes
    position = np.array(line.position) / hertz.semi_axis_rolling
    pressure = factor * np.array(line.pressure)
    if _is_whole(contact):
        panel.plot(-position[::-1], pressure[::-1], color=BLACK, linewidth=1)
    panel.plot(position, pressure, color=BLACK, linewidth=1, label="Hertz")
    for y in _shoulders(contact):
        panel.axvline(y / hertz.semi_axis_transverse, color=RED, linewidth=1, linestyle=":")
    place = contact_place(contact).replace(", ", ",\n").replace(" of the", "\nof the")
    panel.set_title(f"{place}\n{units.force.written(contact.load, '.4g')}")
    panel.set_ylim(0, min(panel.get_ylim()[1], HIGHEST * factor * hertz.peak_pressure))


def _difference(panel: Axes, contact: ContactNumbers, units: Units) -> None:  # noqa: ARG001
    """The nodes less Hertz, per cent of Hertz's peak."""
    hertz, computed, largest = contact.hertz, contact.reference, 0.0
    for axis, (name, _, colour, mark, line) in ALONG.items():
        nodes = getattr(contact.pressure_profile, axis).fe
        position = np.array(nodes.position)
        apart = 100 * (np.array(nodes.pressure) - _semi_ellipse(position, hertz, name)) / hertz.peak_pressure
        edge = min(map(abs, _shoulders(contact)), default=np.inf) if axis == "transverse" else np.inf
        semi_axis = getattr(hertz, name)
        inside = np.abs(position) <= EDGE * min(semi_axis, edge)
        largest = max(largest, float(np.abs(apart[inside]).max(initial=0.0)))
        panel.plot(position / semi_axis, apart, mark, color=colour, markersize=4, markerfacecolor="white")
        if contact.shoulder:  # a cut contact is no semi-ellipse
            continue
        fine = np.linspace(position.min(), position.max(), 400)
        expected = _semi_ellipse(fine, computed, name) - _semi_ellipse(fine, hertz, name)
        panel.plot(fine / semi_axis, 100 * expected / hertz.peak_pressure, line, color=colour, linewidth=1)
    panel.axhline(0, color=BLACK, linewidth=1)
    panel.set_ylim(-2.5 * max(largest, 0.4), 2.5 * max(largest, 0.4))
    panel.set_xlabel("position, semi-axes")


def _semi_ellipse(position: Array, quantities: Quantities, semi_axis: str) -> Array:
    inside = 1 - (position / getattr(quantities, semi_axis)) ** 2
    return quantities.peak_pressure * np.sqrt(np.maximum(inside, 0.0))


def _is_whole(contact: ContactNumbers) -> bool:
    """Whether both transverse sides of the centre are meshed: where a shoulder cuts the contact off."""
    return contact.shoulder is not None and contact.shoulder.half


def _shoulders(contact: ContactNumbers) -> list[float]:
    """y of the shoulders that cut it off, m, on the sides that are drawn."""
    cuts = [] if contact.shoulder is None else contact.shoulder.cuts
    return [y for y in cuts if y > 0 or _is_whole(contact)]
