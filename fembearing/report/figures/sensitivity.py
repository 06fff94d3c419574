"""Which inputs move the torque, or without friction the peak pressures, most: a tornado."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.columns import CONTACT
from analytic.figures.style import BLACK, BLUE, LETTERS, ORANGE, WIDTH, lettered
from analytic.units import Units
from fembearing.check.sensitivity import Input, Output, Sensitivity
from fembearing.report.phrases import input_name
from fembearing.report.report import Report
from fembearing.report.sections.points import loads_of, present_loads

NAMES = {"total_torque": "total torque", "peak_pressure": CONTACT["peak_pressure"].name}
LEAST = 1e-6  # relative: inputs that move nothing by as much are named in the caption alone
MOST = 12  # inputs that are drawn
ROW, HEADS = 0.30, 0.85  # inches: of an input, and of all that stands above and below
HEIGHT = 0.36  # of a bar; two on one side stand one above the other
APART = 2  # points: by which the values of such two stand farther apart than the bars
NOT_COMPUTED = "No sensitivity was computed."


def sensitivity_plot(document: Report) -> tuple[Figure | None, str]:
    """A panel for each output, inputs from the one that moves them most."""
    sensitivity = document.sensitivity
    if sensitivity is None:
        return None, NOT_COMPUTED
    units = document.units
    every = [each for each in sensitivity.inputs if each.swing >= LEAST]
    moving, less = every[:MOST], [input_name(each.name) for each in every[MOST:]]
    still = [input_name(each.name) for each in sensitivity.inputs if each.swing < LEAST and not each.refused]
    outputs = sensitivity.outputs
    quantity = NAMES[outputs[0].quantity]
    figure = Figure(figsize=(WIDTH, HEADS + ROW * len(moving)), layout="constrained")
    panels = figure.subplots(1, len(outputs), squeeze=False, sharex=True, sharey=True)[0]
    for number, (panel, output) in enumerate(zip(panels, outputs, strict=True)):
        for row, each in enumerate(moving):
            _bars(panel, row, each, number, units)
        panel.axvline(0, color=BLACK, linewidth=0.8)
        panel.set_title(_title(output, outputs, units))
        panel.set_yticks(
            range(len(moving)), [f"{input_name(each.name)}, {_shown(each, each.value, units)}" for each in moving]
        )
        panel.set_ylim(len(moving) - 0.4, -0.6)
        panel.margins(x=0.85)  # for the labels
        panel.grid(alpha=0.3, axis="x")
        panel.set_xlabel(f"change of the {quantity}, %")
    return lettered(figure), _caption(sensitivity, quantity, still=still, less=less)


def _bars(panel: Axes, row: int, each: Input, output: int, units: Units) -> None:
    """Both bars of one input, labelled with the values at its ends."""
    ends = {"low": each.change_low, "high": each.change_high}
    known = {name: 100 * changes[output] for name, changes in ends.items() if changes is not None}
    same_side = len(known) == 2 and known["low"] * known["high"] > 0
    for name, change in known.items():
        aside = (HEIGHT / 2) * (-1 if name == "low" else 1) if same_side else 0.0
        colour = BLUE if name == "low" else ORANGE
        panel.barh(row + aside, change, HEIGHT if same_side else 2 * HEIGHT, color=colour, label=name)
        panel.annotate(
            _shown(each, getattr(each, name), units),
            (change, row + aside),
            xytext=(3 if change >= 0 else -3, -np.sign(aside) * APART),
            textcoords="offset points",
            ha="left" if change >= 0 else "right",
            va="center",
            fontsize=LETTERS,
        )


def _shown(each: Input, value: float, units: Units) -> str:
    """A value of an input, in the unit of the scene's value."""
    return units.unit_for(each.unit, each.value).written(value, ".4g")


def _title(output: Output, outputs: Sequence[Output], units: Units) -> str:
    """The output and its value."""
    if output.point is None:
        return f"ball on {output.pair} race: {units.pressure.written(output.value, '.4g')}"
    points = [vars(each.point) for each in outputs if each.point is not None]
    loads = loads_of(vars(output.point), present_loads(points), units)
    speed, torque = units.speed.written(output.point.inner_speed, ".5g"), units.torque.written(output.value, ".4g")
    return f"{speed}, {loads}:\n{torque}"


def _caption(sensitivity: Sensitivity, quantity: str, *, still: list[str], less: list[str]) -> str:
    """What is varied, what moves nothing, and what was refused."""
    refused = [f"{input_name(each.name)}, {reason}" for each in sensitivity.inputs for reason in each.refused]
    caption = (
        f"Change of the {quantity} if one input goes from the scene's value (beside its name) to the low (blue) or "
        "high (orange) end of its 95 % range, by the production model, "
        + (
            "with the cage at rest: not the total with a moving cage. "
            if quantity == NAMES["total_torque"]
            else "by Hertz. "
        )
        + "Spreads as in the 95 % interval; report.json has their sources. One input at a time, no interactions."
    )
    if less:
        caption += f" Smaller changes: {', '.join(less)}."
    if still:
        caption += f" Changes below 1e-4 %: {', '.join(still)}."
    return caption + (f" No result at an end: {'; '.join(refused)}." if refused else "")
