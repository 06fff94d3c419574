"""The torque of a cold bearing between starved and flooded: python validation/cold/run.py [--out FOLDER]

A 6206 in a bath of ISO VG 68 under a radial load, over the temperature of the oil: the torque with its quick 95 %
interval, the torque with SKF's replenishment factor and without starvation, and makers' formulas. It prints a table,
writes cold.md and draws cold.png into this folder.
"""

from collections.abc import Iterator
from pathlib import Path

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


def at(temperature: float) -> dict[str, float]:
    """The bearing at one temperature, degC: torques in N mm, NaN where a formula does not hold."""
    scene = load_scene(BEARING, radial_load=LOAD, speed=SPEED, oil=OIL, temperature=f"{temperature} degC")
    found = friction_torque(scene)
    ends, exponent = first_order_ends(scene, found), found.limits.replenishment
    low, high = (np.nan, np.nan) if ends is None else 1e3 * ends[:, 0]
    row = {
        "temperature": temperature,
        "left": 1.0 if exponent is None else float(np.exp(-exponent[0])),  # of rolling, by the replenishment factor
        "torque": 1e3 * float(found.torque.total[0]),
        "low": low,  # ends of the 95 % interval
        "high": high,
        "flooded": 1e3 * float(friction_torque(scene, variation=FLOODED).torque.total[0]),
    }
    makers: dict[str, float] = {}
    for name, values in scene_band(scene).values.items():
        makers.setdefault(name.partition(",")[0], 1e3 * float(values[0]))
    return row | makers


def table(found: list[dict[str, float]]) -> Iterator[str]:
    """Torques over the temperature, Markdown."""

    def cells(row: dict[str, float]) -> Iterator[str]:
        for name, value in row.items():
            if name == "low":
                yield f"{value:.3g} to {row['high']:.4g}"
            elif name != "high":
                form = "" if name == "temperature" else ".2g" if name == "left" else ".3g" if value < 1e3 else ".0f"
                yield f"{value:{form}}"

    yield from markdown(("oil, degC", "left of rolling", "torque", "95 %", *list(found[0])[5:]), map(cells, found))


def draw(found: list[dict[str, float]], path: Path) -> None:
    """Torques over the temperature, with the interval as a band."""
    drawn = figure(8, 4.6)
    axis, columns = drawn.subplots(), {name: [row[name] for row in found] for name in found[0]}
    places, _, torque, low, high, flooded, *makers = columns.values()
    axis.fill_between(places, low, high, color="0.88", label="95 % interval")
    axis.plot(places, torque, "k-", label="torque: starved as a running bearing")
    axis.plot(places, flooded, "k--", label="flooded, as at a start")
    for name, values, colour in zip(list(columns)[6:], makers, ("tab:blue", "tab:orange", "tab:green"), strict=False):
        axis.plot(places, values, ".-", color=colour, lw=1, label=name)
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
