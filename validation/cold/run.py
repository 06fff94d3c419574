"""The torque of a cold bearing between starved and flooded: python validation/cold/run.py [--out FOLDER]

A 6206 in a bath of ISO VG 68 under a radial load, over the temperature of the oil: the torque with its quick 95 %
interval, the torque with SKF's replenishment factor and without starvation, and makers' formulas. It prints a table,
writes cold.md and draws cold.png into this folder.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import numpy as np

from analytic.makers import scene_band
from analytic.oil.variation import Variation
from analytic.prediction.first_order import first_order_ends
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from validation.study import Out, figure, markdown, run, save, write_text

HERE = Path(__file__).parent
BEARING, OIL, LOAD, SPEED = "6206", "ISO VG 68", "2 kN", "1500 rpm"
TEMPERATURES = (*range(-30, 40, 10), 40, 60, 80, 100)  # degC
FLOODED = Variation(starvation=1.0)


class Cold(NamedTuple):
    """One temperature of the oil; torques in N mm."""

    temperature: float  # degC
    left: float  # of rolling, by the replenishment factor
    torque: float
    low: float  # ends of the 95 % interval
    high: float
    flooded: float
    makers: dict[str, float]  # by formula; NaN where it does not hold


def at(temperature: float) -> Cold:
    """The bearing at one temperature, degC."""
    scene = load_scene(BEARING, radial_load=LOAD, speed=SPEED, oil=OIL, temperature=f"{temperature} degC")
    found = friction_torque(scene)
    ends, exponent = first_order_ends(scene, found), found.limits.replenishment
    low, high = (np.nan, np.nan) if ends is None else 1e3 * ends[:, 0]
    makers: dict[str, float] = {}
    for name, values in scene_band(scene).values.items():
        makers.setdefault(name.partition(",")[0], 1e3 * float(values[0]))
    return Cold(
        temperature=temperature,
        left=1.0 if exponent is None else float(np.exp(-exponent[0])),
        torque=1e3 * float(found.torque.total[0]),
        low=low,
        high=high,
        flooded=1e3 * float(friction_torque(scene, variation=FLOODED).torque.total[0]),
        makers=makers,
    )


def table(found: list[Cold]) -> Iterator[str]:
    """Torques over the temperature, Markdown."""

    def shown(torque: float) -> str:
        return f"{torque:.3g}" if torque < 1e3 else f"{torque:.0f}"

    heads = ("oil, degC", "left of rolling", "torque", "95 %", "flooded", *found[0].makers)
    yield from markdown(
        heads,
        (
            (each.temperature, f"{each.left:.2g}", shown(each.torque), f"{each.low:.3g} to {each.high:.4g}",
             shown(each.flooded), *map(shown, each.makers.values()))
            for each in found
        ),
    )  # fmt: skip


def draw(found: list[Cold], path: Path) -> None:
    """Torques over the temperature, with the interval as a band."""
    drawn = figure(8, 4.6)
    axis, places = drawn.subplots(), [each.temperature for each in found]
    band = ([each.low for each in found], [each.high for each in found])
    axis.fill_between(places, *band, color="0.88", label="95 % interval")
    axis.plot(places, [each.torque for each in found], "k-", label="torque: starved as a running bearing")
    axis.plot(places, [each.flooded for each in found], "k--", label="flooded, as at a start")
    for name, colour in zip(found[0].makers, ("tab:blue", "tab:orange", "tab:green"), strict=False):
        axis.plot(places, [each.makers[name] for each in found], ".-", color=colour, lw=1, label=name)
    axis.set(xlabel="temperature of the oil, degC", ylabel="friction torque, N mm", yscale="log")
    axis.grid(which="both", color="0.93")
    axis.legend(fontsize=9)
    axis.set_title(f"{BEARING}, {LOAD} radial, {SPEED}, {OIL}, oil bath", fontsize=10)
    save(drawn, path, dpi=120)


def main(out: Out = HERE) -> None:
    found = [at(temperature) for temperature in TEMPERATURES]
    write_text(out / "cold.md", table(found))
    draw(found, out / "cold.png")


if __name__ == "__main__":
    run(main)
