"""The contacts by finite elements beside Hertz: pressure, stiffness, and how their meshes converge."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import LogLocator, NullFormatter

from analytic.columns import CONTACT
from analytic.figures.style import BLACK, BLUE, GREEN, GREY, LETTERS, PURPLE, RED, WIDTH, lettered
from analytic.units import Units
from fembearing.check.contact.figure import CAPTION, CUT, DrawnPressure, contact_columns, pressure_figure
from fembearing.check.contact.scene_contact import place_of
from fembearing.check.contact.solution import ContactNumbers
from fembearing.report.report import Report
from fembearing.report.sections.contacts import contact_place

LOOKS = {  # pair and geometry -> colour and mark
    ("inner", "real"): (BLUE, "o"),
    ("outer", "real"): (RED, "s"),
    ("pocket", "real"): (GREEN, "^"),
    ("pocket", "wall"): (PURPLE, "D"),
}
APPROACHES = (
    "Above: load of the ball over its approach by Hertz, by Hertz corrected for finite geometry in the range of the "
    "fit, and by finite elements at the solved load. Below: approach over Hertz's, less one, with the 95 % intervals "
    "of the fit and of the finite elements; negative: stiffer than Hertz."
)
SAME = 1e-6  # relative: what is nearer to its limit is drawn here
BELOW = 0.4  # of the least point of a panel: where the slope to compare with ends
HIGH = 3.5  # inches
SHORT = 100.0  # from the least unknowns to the most: beyond, ticks at 3, 30, 300 run into their neighbours
DIMENSIONS = 3  # cells of size h are as h^-3 unknowns
CONVERGENCE = (
    "Distance of each quantity from its extrapolated value over the number of unknowns; dash-dotted: slope of the "
    "formal order in the cell size. The extrapolation assumes this order for the last two meshes, so the test is the "
    "distance of the coarser meshes from the slope, and the observed order of the last three. Dashed: not "
    "extrapolated; distance from the finest mesh, which is not drawn."
)


def pressure_plot(document: Report) -> tuple[Figure | None, str]:
    """A column for each contact."""
    units = document.units
    drawn = [
        DrawnPressure(
            title=f"{_title(contact)}\n{units.force.written(contact.load, '.4g')}",
            profiles=contact.pressure_profile,
            hertz=contact.hertz,
            fe=contact.reference,
            shoulders=[] if contact.shoulder is None else contact.shoulder.cuts,
            is_half=contact.shoulder is not None and contact.shoulder.half,
        )
        for contact in document.contacts
    ]
    cut = any(contact.shoulder for contact in document.contacts)
    return pressure_figure(drawn, units), CAPTION + (CUT if cut else "")


def _title(contact: ContactNumbers) -> str:
    """The place of a contact in short lines."""
    return contact_place(contact).replace(", ", ",\n").replace(" of the", "\nof the")


def approach_plot(document: Report) -> tuple[Figure | None, str]:
    """A column for each contact."""
    units = document.units
    labels = (f"load, {units.force.name}", "approach over\nHertz's, less 1, %")
    return contact_columns(document.contacts, _curve, _apart, units=units, labels=labels), APPROACHES


def _curve(panel: Axes, contact: ContactNumbers, units: Units) -> None:
    """Load over approach, with the solved point."""
    curve, solved = contact.approach_curve, contact.quantities["approach"]
    load, small = units.force.factor * np.array(curve.load), units.small_length.factor
    panel.plot(small * np.array(curve.hertz), load, color=BLACK, label="Hertz")
    panel.plot(small * _known(curve.corrected), load, "--", color=BLUE, label="Hertz, corrected for finite geometry")
    panel.errorbar(
        small * solved.reference,
        units.force.number(contact.load),
        xerr=small * solved.uncertainty,
        fmt="o",
        color=RED,
        markersize=5,
        label="finite elements",
    )
    panel.set_title(_title(contact))
    panel.margins(0.1)
    panel.set(xlabel=f"approach, {units.small_length.name}", xlim=(0, None), ylim=(0, None))


def _apart(panel: Axes, contact: ContactNumbers, units: Units) -> None:
    """Departure from Hertz's approach, per cent."""
    curve, solved = contact.approach_curve, contact.quantities["approach"]
    load, hertz = units.force.factor * np.array(curve.load), np.array(curve.hertz)
    corrected, half = _known(curve.corrected), _known(curve.uncertainty)
    panel.axhline(0, color=BLACK)
    if np.isfinite(corrected).any():
        low, high = (100 * (corrected * (1 + side * half) / hertz - 1) for side in (-1, 1))
        panel.fill_between(load, low, high, color=BLUE, alpha=0.2, linewidth=0)
        panel.plot(load, 100 * (corrected / hertz - 1), "--", color=BLUE)
    ratio, uncertain = (part / solved.production for part in (solved.reference, solved.uncertainty))
    panel.errorbar(
        units.force.number(contact.load),
        100 * (ratio - 1),
        yerr=100 * uncertain,
        fmt="o",
        color=RED,
        markersize=5,
        capsize=4,
    )
    panel.margins(x=0.1, y=0.25)
    panel.set(xlabel=f"load, {units.force.name}", xlim=(0, None))


def _known(values: Sequence[float | None]) -> np.ndarray:
    return np.array([np.nan if value is None else value for value in values])


def convergence_plot(document: Report) -> tuple[Figure | None, str]:
    """A panel for each quantity, and the key in the place of a sixth."""
    contacts = document.contacts
    figure = Figure(figsize=(WIDTH, HIGH), layout="constrained")
    panels = figure.subplots(2, 3).ravel()
    for panel, (name, quantity) in zip(panels, CONTACT.items(), strict=False):
        for contact in contacts:
            _convergence(panel, contact, name)
        _formal_slope(panel, contacts, name)
        cut = name == "peak_pressure" and any(contact.shoulder for contact in contacts)
        panel.set_title(f"{quantity.name}{', cut off: at y = 0' if cut else ''}")
        panel.set(xscale="log", yscale="log")
        panel.set_xlabel("unknowns")
        panel.grid(alpha=0.3, which="both")
        low, high = panel.get_xlim()
        for axis, numbers, short in ((panel.xaxis, "{x:,.0f}", high < SHORT * low), (panel.yaxis, "{x:g}", True)):
            axis.set_major_locator(LogLocator(subs=(1, 3) if short else (1,)))
            axis.set_major_formatter(numbers)
            axis.set_minor_formatter(NullFormatter())  # over one decade they would run into each other
    for panel in panels[::3]:
        panel.set_ylabel("distance from the limit, %")
    panels[-1].set_axis_off()
    key = dict(zip(*reversed(panels[0].get_legend_handles_labels()), strict=True))
    panels[-1].legend(key.values(), key.keys(), loc="center left", frameon=False, fontsize=LETTERS)
    return lettered(figure), CONVERGENCE


def _convergence(panel: Axes, contact: ContactNumbers, name: str) -> None:
    """Distance of one quantity from its extrapolated value over the unknowns."""
    colour, mark = LOOKS.get((contact.pair, contact.geometry), (BLACK, "x"))
    unknowns, distance = _distances(contact, name)
    study = contact.estimates[name]
    panel.plot(
        *(unknowns, distance, mark),
        linestyle="--" if study.richardson is None else "-",
        color=colour,
        markerfacecolor="white" if contact.bearing == "second" else colour,
        markersize=5,
        label=_short(contact),
    )


def _short(contact: ContactNumbers) -> str:
    """The place of a contact for a narrow key."""
    return (
        place_of(contact.pair, contact.geometry, contact.bearing)
        .removeprefix("ball on ")
        .removeprefix("ball in cage pocket, ")
    )


def _distances(contact: ContactNumbers, name: str) -> tuple[np.ndarray, np.ndarray]:
    """Unknowns and distance from the limit, %, mesh by mesh."""
    study = contact.estimates[name]
    values, limit = np.array(study.values), study.richardson
    unknowns = np.array([mesh.unknowns for mesh in contact.meshes])
    if limit is None:  # its own finest mesh is the limit
        values, limit, unknowns = values[:-1], values[-1], unknowns[:-1]
    return unknowns, 100 * np.maximum(np.abs(values / limit - 1), SAME)


def _formal_slope(panel: Axes, contacts: Sequence[ContactNumbers], name: str) -> None:
    """Below all points of the contacts that have a formal order in this quantity."""
    ordered = [contact for contact in contacts if contact.formal_order[name] is not None]
    order = ordered[0].formal_order[name] if ordered else None  # one for all contacts
    if order is None:
        return
    unknowns, distance = (np.concatenate(parts) for parts in zip(*(_distances(c, name) for c in ordered), strict=True))
    ends = np.array([unknowns.min(), unknowns.max()])
    slope = (ends / ends[0]) ** (-order / DIMENSIONS)
    lowest = np.min(distance / (unknowns / ends[0]) ** (-order / DIMENSIONS))
    panel.plot(ends, BELOW * lowest * slope, "-.", color=GREY, linewidth=1, label="formal order")
    middle = (np.sqrt(ends[0] * ends[1]), BELOW * lowest * np.sqrt(slope[1]))
    panel.annotate(
        f"order {order:g}",
        *(middle, (-4, -1)),
        textcoords="offset points",
        ha="right",
        va="top",
        fontsize=LETTERS,
    )
