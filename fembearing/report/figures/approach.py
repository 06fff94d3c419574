"""The stiffness of each contact: load over approach, and how far each model is from Hertz."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from fembearing.check.contact.solution import ContactNumbers
from fembearing.quantities import Units
from fembearing.report.figures.style import BLACK, BLUE, RED, contact_columns
from fembearing.report.phrases import contact_place
from fembearing.report.report import Report

CAPTION = (
    "Above: load of the ball over its approach by Hertz, by Hertz corrected for finite geometry in the range of the "
    "fit, and by finite elements at the solved load. Below: approach over Hertz's, less one, with the 95 % intervals "
    "of the fit and of the finite elements; negative: stiffer than Hertz."
)


def approach_plot(document: Report) -> tuple[Figure | None, str]:
    """A column for each contact."""
    units = document.units
    labels = (f"load, {units.force.name}", "approach over\nHertz's, less 1, %")
    return contact_columns(document.contacts, _curve, _apart, units=units, labels=labels), CAPTION


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
    panel.set_title(contact_place(contact).replace(", ", ",\n").replace(" of the", "\nof the"))
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
