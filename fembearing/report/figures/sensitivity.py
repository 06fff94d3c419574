"""Which inputs move the torque, or without friction the peak pressures, most: a tornado."""

from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from fembearing.report.figures.plot import Document
from fembearing.report.figures.style import BLACK, BLUE, ORANGE
from fembearing.report.words import PER_MINUTE

NAMES = {"total_torque": "total torque", "peak_pressure": "peak pressure"}
UNITS = {  # as an input is shown: SI unit -> unit, and what an SI value is multiplied by, from this value on
    "Pa": (("GPa", 1e-9, 1e9), ("MPa", 1e-6, 0.0)),
    "m": (("mm", 1e3, 1e-3), ("µm", 1e6, 0.0)),
    "1/Pa": (("1/GPa", 1e9, 0.0),),
    "N m": (("N mm", 1e3, 0.0),),
    "1": (("", 1.0, 0.0),),
}
LEAST = 1e-6  # relative: inputs that move nothing by as much are named in the caption alone
HEIGHT = 0.36  # of a bar; two on one side stand one above the other
NOT_COMPUTED = "No sensitivity was computed."


def sensitivity_plot(document: Document) -> tuple[Figure | None, str]:
    """A panel for each output, inputs from the one that moves them most."""
    found = document["sensitivity"]
    if found is None:
        return None, NOT_COMPUTED
    moving = [each for each in found["inputs"] if _swing(each) >= LEAST]
    still = [each["name"] for each in found["inputs"] if _swing(each) < LEAST and not each["refused"]]
    outputs = found["outputs"]
    quantity = NAMES[outputs[0]["quantity"]]
    figure = Figure(figsize=(3.2 + 4.2 * len(outputs), 1.6 + 0.42 * len(moving)), layout="constrained")
    panels = figure.subplots(1, len(outputs), squeeze=False, sharex=True, sharey=True)[0]
    for number, (panel, output) in enumerate(zip(panels, outputs, strict=True)):
        for row, each in enumerate(moving):
            _bars(panel, row, each, number)
        panel.axvline(0, color=BLACK, linewidth=0.8)
        panel.set_title(_title(output), fontsize=10)
        panel.set_xlabel(f"change of the {quantity}, %")
        panel.margins(x=0.3)  # for the labels
        panel.grid(alpha=0.3, axis="x")
    panels[0].set_yticks(
        range(len(moving)), [f"{each['name']}\n{_shown(each, 'value')}" for each in moving], fontsize=8
    )
    panels[0].set_ylim(len(moving) - 0.4, -0.6)
    return figure, _caption(found, quantity, still)


def _swing(each: dict[str, Any]) -> float:
    return max(map(abs, [*(each["change_low"] or ()), *(each["change_high"] or ())]), default=0.0)


def _bars(panel: Axes, row: int, each: dict[str, Any], output: int) -> None:
    ends = {name: each[f"change_{name}"] for name in ("low", "high")}
    known = {name: 100 * changes[output] for name, changes in ends.items() if changes is not None}
    same_side = len(known) == 2 and known["low"] * known["high"] > 0
    for name, change in known.items():
        aside = (HEIGHT / 2) * (-1 if name == "low" else 1) if same_side else 0.0
        colour = BLUE if name == "low" else ORANGE
        panel.barh(row + aside, change, HEIGHT if same_side else 2 * HEIGHT, color=colour, label=name)
        panel.annotate(
            _shown(each, name),
            (change, row + aside),
            xytext=(3 if change >= 0 else -3, 0),
            textcoords="offset points",
            ha="left" if change >= 0 else "right",
            va="center",
            fontsize=7,
        )


def _shown(each: dict[str, Any], which: str) -> str:
    value = each[which]
    for unit, factor, least in UNITS.get(each["unit"], ((each["unit"], 1.0, 0.0),)):
        if abs(each["value"]) >= least:
            return f"{value * factor:.4g} {unit}".strip()
    return f"{value:.4g} {each['unit']}"


def _title(output: dict[str, Any]) -> str:
    if output["quantity"] == "peak_pressure":
        return f"ball on {output['pair']} race: {output['value'] * 1e-9:.4g} GPa"
    speed, load = output["inner_speed"] * PER_MINUTE, output["axial_load"]
    return f"{speed:.5g} rpm, {load:.4g} N axial: {output['value'] * 1e3:.4g} N mm"


def _caption(found: dict[str, Any], quantity: str, still: list[str]) -> str:
    refused = [f"{each['name']}, {reason}" for each in found["inputs"] for reason in each["refused"]]
    caption = (
        f"One input at a time goes from the scene's value, below its name, to the low end of its range (blue) and the "
        f"high end (orange), and the {quantity} is computed again by the production model, "
        + (
            "without a cage in motion and as `fembearing torque` has it: Hertz corrected for finite geometry where the "
            "tolerance asks for that. "
            if quantity == NAMES["total_torque"]
            else "by Hertz. "
        )
        + "Ranges are mostly judgements; report.json has their sources. What inputs do together is not in it."
    )
    if still:
        caption += f" By less than 1e-4 %: {', '.join(still)}."
    return caption + (f" Refused at an end: {'; '.join(refused)}." if refused else "")
