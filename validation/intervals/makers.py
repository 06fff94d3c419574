"""How many makers' formulas, and measured torques, lie in the interval to first order:
python validation/intervals/makers.py [--bearings 200]

The 95 % interval of the total by `first_order_ends`, with the spreads that it states, beside the twelve mean torques of
the spin-downs [Balan2015], which were measured; and beside the formulas of SKF, Palmgren, ISO 15312 and FAG, which were
not: they are fits to unpublished tests, and differ among themselves by factors. Bearings are taken evenly from those of
the catalogue that have constants and the grades printed, A or B, which are 180. They run under 0.05 C radial and under
0.02 C0 axial; the moment that seats an angular contact bearing is in ours only. A
share near 95 % would not prove the interval; a small one says that model or formula is off by more than inputs explain.
It writes makers.csv and makers.png into this folder, in two minutes.
"""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from matplotlib.figure import Figure

from analytic.catalog.bearing_rows import CatalogBearing, bearing_names, find_bearing
from analytic.errors import InputError
from analytic.makers import case_of, scene_band
from analytic.prediction.first_order import first_order_ends
from analytic.scene import Array, Scene
from analytic.torque import friction_torque
from validation.intervals.run import counts
from validation.measured import run as measured
from validation.measured.makers import GRADES, LOADS, fag_torque, scene_at
from validation.study import Out, Row, figure, numbers, run, save, show, write

HERE = Path(__file__).parent
MAKERS = {  # column: name of the model in the band
    "skf": "SKF",
    "palmgren_4": "Palmgren, z = 0.0004",
    "palmgren_6": "Palmgren, z = 0.0006",
    "palmgren": "Palmgren",
    "iso": "ISO 15312",
    "fag_least": "FAG, least factors",
    "fag_largest": "FAG, largest factors",
}
COLUMNS = ("designation", "series", "case", "torque", "low", "high", *MAKERS)  # torques in N mm


def makers_torques(scene: Scene) -> dict[str, float]:
    """By name of the model, N m; without moment, which no model knows."""
    alone = replace(scene, operation=replace(scene.operation, moment=0.0))
    least, largest = fag_torque(case_of(alone))
    found = {**scene_band(alone).values, "FAG, least factors": least, "FAG, largest factors": largest}
    return {name: float(values[0]) for name, values in found.items()}


def compared(bearing: CatalogBearing, case: str) -> Row:
    """Torque, interval and makers' torques of one bearing under one load, N mm."""
    scene = scene_at(bearing, case)
    nominal = friction_torque(scene)
    ends = first_order_ends(scene, nominal)
    makers = makers_torques(scene)
    values = {"torque": nominal.torque.total[0]}
    if ends is not None:
        values |= {"low": ends[0, 0], "high": ends[1, 0]}
    values |= {key: makers[name] for key, name in MAKERS.items() if np.isfinite(makers.get(name, np.nan))}
    known = {"designation": bearing.designation, "series": bearing.series, "case": case}
    return known | {name: f"{1e3 * value:.5g}" for name, value in values.items()}


def chosen(count: int) -> list[CatalogBearing]:
    """So many bearings, evenly from all that have constants, in the order of the catalogue."""
    graded = (bearing for bearing in map(find_bearing, bearing_names()) if bearing.grade in GRADES)
    known = [bearing for bearing in graded if has_band(bearing)]
    return [known[int(place)] for place in np.linspace(0, len(known) - 1, min(count, len(known)))]


def has_band(bearing: CatalogBearing) -> bool:
    try:
        case_of(scene_at(bearing, "axial"))
    except InputError:
        return False
    return True


def coverage(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    """Shares inside, and the width of the intervals, by load and source: of the rigs, and of the formulas."""

    def line(load: str, words: str, torque: Array, ours: Array, low: Array, high: Array) -> tuple[object, ...]:
        inside, below, above = counts(torque, low, high)
        share = f"{inside} ({100 * (torque.size - below - above) / torque.size:.0f} %)"
        return load, words, share, below, above, f"{np.median(torque / ours):.2f}", f"{np.median(high / low):.2f}"

    for diameter in measured.RIGS:
        rig = measured.compare(diameter)
        ends = first_order_ends(rig.scene, friction_torque(rig.scene))
        assert ends is not None
        yield line("thrust rig", f"measured, balls of {diameter:g} mm [Balan2015]", rig.measured, rig.computed, *ends)
    for case, (key, name) in product(LOADS, MAKERS.items()):
        if own := [row for row in rows if row["case"] == case and row.get(key) and row.get("low")]:
            yield line(case, f"formula: {name}", *(numbers(own, column) for column in (key, "torque", "low", "high")))


def draw(rows: Sequence[Row]) -> Figure:
    """All over the computed torque: the interval, and the formulas."""
    drawn = figure(10, 7)
    panels = drawn.subplots(2, 1, sharex=True, sharey=True)
    for axes, case in zip(panels, LOADS, strict=True):
        own = [row for row in rows if row["case"] == case and row.get("low")]
        own.sort(key=lambda row: float(row["torque"]))
        ours = numbers(own, "torque")
        low, high = (numbers(own, end) / ours for end in ("low", "high"))
        axes.fill_between(ours, low, high, color="0.85", lw=0, label="95 % interval to first order")
        for number, (key, name) in enumerate(MAKERS.items()):
            axes.plot(ours, numbers(own, key) / ours, ".", ms=4, color=f"C{number}", label=name)
        axes.axhline(1, color="k", lw=0.8)
        axes.set(xscale="log", yscale="log", ylabel="over the computed torque")
        ticks = [0.5, 1, 2, 4]
        axes.set_yticks(ticks, [f"{tick:g}" for tick in ticks])
        axes.minorticks_off()
        axes.set_title(LOADS[case], fontsize=10)
    panels[-1].set_xlabel("computed torque, N mm")
    panels[-1].legend(fontsize=8, ncols=3, loc="upper left")
    return drawn


def main(bearings: Annotated[int, typer.Option(help="Number of bearings.")] = 200, out: Out = HERE) -> None:
    rows = [compared(bearing, case) for case in LOADS for bearing in chosen(bearings)]
    write(rows, out / "makers.csv", COLUMNS, about=("Torques in N mm at 1000 rpm; see makers.py.",))
    save(draw(rows), out / "makers.png", dpi=110)
    heads = ("load", "source", "inside", "below", "above", "source over ours, median", "high over low, median")
    show(heads, coverage(rows))


if __name__ == "__main__":
    run(main)
