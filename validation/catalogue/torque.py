"""The torque of every bearing of the catalogue: python validation/catalogue/torque.py [--out FOLDER]

Every bearing of the grades printed, A and B runs at 1000 rpm in ISO VG 68 of 60 degC, with ground and honed races and
balls that turn freely, by default methods at a tolerance of 5 %. It has two loads: 0.05 C radial, and 0.02 C0 axial.
An angular contact bearing under a radial load alone slides apart, so it also carries 1.7 Fr tan(nominal angle), the
thrust from which all its balls are loaded. Its radial load acts at its load centre, where the lines of contact meet the
axis; anywhere else a single bearing tilts, until balls run on a shoulder. The program writes
catalogue_torque.csv, one row for each bearing and load, and the figure catalogue_torque.png into this folder. It prints
failures, kinds of warnings, and torques outside the catalogue band. Torques that the CSV file already has are kept, so
that a stopped run can be resumed; delete the file to compute all of them anew. It takes 25 minutes on two busy cores.
"""

import math
import os
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import ScalarFormatter

from analytic.catalog.bearing_rows import CatalogBearing, bearing_names, find_bearing
from analytic.errors import FembearingError, InputError
from analytic.makers import scene_band
from analytic.scene import Scene
from analytic.scenefile.read import scene_of
from analytic.torque import friction_torque
from validation.study import Out, Row, continued, figure, out, read, run, save, show, write

HERE = Path(__file__).parent
GRADES = ("printed", "A", "B")
RADIAL_SHARE, AXIAL_SHARE = 0.05, 0.02  # of C, of C0
SEATED = 1.7  # of Fr tan(angle): thrust that loads all balls of a straight ring, about 1.67 for point contact
CASES = ("radial", "axial")
DOWN = {"radial": [1, 0, 0], "axial": [0, 0, 1]}  # the shaft lies, or it stands
LOADS = ("radial_N", "axial_N", "moment_N_m")
COMPUTED = ("designation", "case", *LOADS, "torque_N_mm", "numerical_uncertainty", "warnings", "failure")
KNOWN = ("maker", "kind", "series", "grade", "bore_mm", "outside_mm")
BAND = ("band_low_N_mm", "band_high_N_mm")
KINDS = {  # what a warning says: its kind; the first that fits
    "without a cage": "",  # no scene here has one
    "passes the": "an ellipse passes a shoulder",
    "the film on the": "the film is extrapolated, or limited to the gap",
    "shoulder not known": "a shoulder is not known",
    "the fit": "outside the fit for finite geometry",
    "ratings": "on the bearing's balls",
    "differs between makers": "on the bearing's balls",
    "also made with": "on the bearing's balls",
    "prints": "on the bearing's balls",
}
FAMILIES = {  # series: name and colour in the figure
    "618": ("618 (68)", "#CC79A7"),
    "619": ("619 (69)", "#56B4E9"),
    "160": ("160, 161", "#F0E442"),
    "60": ("60", "#009E73"),
    "62": ("62", "#0072B2"),
    "63": ("63", "#D55E00"),
    "64": ("64", "black"),
}
ANGULAR = {"SKF": ("72 B, 73 B", "#D55E00"), "NSK": ("NSK spindle", "#0072B2"), "GMN": ("GMN spindle", "#009E73"),
           "SNFA": ("SNFA spindle", "#CC79A7")}  # fmt: skip


def loads_of(bearing: CatalogBearing, case: str) -> tuple[float, float, float]:
    """(radial, axial) load, N, and moment about the bearing's middle, N m."""
    if case == "axial":
        return 0.0, AXIAL_SHARE * bearing.static_load_rating, 0.0
    radial = RADIAL_SHARE * bearing.dynamic_load_rating
    slope = 0.0 if bearing.nominal_angle is None else math.tan(bearing.nominal_angle)
    return radial, SEATED * radial * slope, -radial * slope * bearing.pitch_diameter / 2


def scene_at(bearing: CatalogBearing, case: str) -> Scene:
    """The scene of one bearing under one load."""
    radial, axial, moment = loads_of(bearing, case)
    document: dict[str, Any] = {
        "name": f"{bearing.designation}, {case}",
        "tolerance": "5 %",
        "bearing": {"catalog": bearing.designation},
        "operation": {
            "radial_load": f"{radial!r} N",
            "axial_load": f"{axial!r} N",
            "moment": f"{moment!r} N m",
            "inner_speed": "1000 rpm",
            "down": DOWN[case],
        },
        "lubricant": {"name": "ISO VG 68", "temperature": "60 degC"},
        "surface": {"finish": "ground and honed"},
        "friction": {"hysteresis_loss": 0.007, "spin_rule": "free"},
    }
    return scene_of(document, origin=bearing.designation)


def computed(task: tuple[str, str]) -> list[Row]:
    """The torque of one bearing under one load, or why there is none."""
    name, case = task
    bearing = find_bearing(name)
    loads = (f"{load:.5g}" for load in loads_of(bearing, case))
    row = {"designation": name, "case": case, **dict(zip(LOADS, loads, strict=True))}
    try:
        found = friction_torque(scene_at(bearing, case))
    except FembearingError as problem:
        return [row | {"failure": str(problem)}]
    torque = f"{1e3 * found.torque.total[0]:.5g}"
    uncertainty = f"{found.numerical_uncertainty[0]:.3g}"
    warnings = kinds_of(found.warnings)
    return [row | {"torque_N_mm": torque, "numerical_uncertainty": uncertainty, "warnings": warnings}]


def kinds_of(warnings: Sequence[str]) -> str:
    """The kinds of warnings, each once."""
    kinds = [next((kind for words, kind in KINDS.items() if words in text), text) for text in warnings]
    return "; ".join(sorted({kind for kind in kinds if kind}))


def with_band(row: Row) -> Row:
    """The row with what is known of the bearing, and with its catalogue band, which knows no moment."""
    bearing = find_bearing(row["designation"])
    known = (bearing.maker, bearing.kind, bearing.series, bearing.grade, 1e3 * bearing.bore, 1e3 * bearing.outside)
    texts = [value if isinstance(value, str) else f"{value:g}" for value in known]
    scene = scene_at(bearing, row["case"])
    try:
        band = scene_band(replace(scene, operation=replace(scene.operation, moment=0.0)))
        ends = [f"{1e3 * end[0]:.5g}" for end in (band.low, band.high)]
    except InputError:
        ends = ["", ""]
    return row | dict(zip(KNOWN, texts, strict=True)) | dict(zip(BAND, ends, strict=True))


def position(row: Row) -> float:
    """The torque over the middle (geometric mean) of its band; NaN without one."""
    if not row["torque_N_mm"] or not row["band_low_N_mm"]:
        return math.nan
    return float(row["torque_N_mm"]) / math.sqrt(float(row["band_low_N_mm"]) * float(row["band_high_N_mm"]))


def half_width(row: Row) -> float:
    """The upper end of the band over its middle."""
    return math.sqrt(float(row["band_high_N_mm"]) / float(row["band_low_N_mm"]))


def coefficient(row: Row) -> float:
    """The torque over F d_m/2, with the whole load F and d_m = (d + D)/2; NaN without a torque."""
    if not row["torque_N_mm"]:
        return math.nan
    load = math.hypot(float(row["radial_N"]), float(row["axial_N"]))
    return float(row["torque_N_mm"]) / (load * mean_diameter(row) / 2)


def mean_diameter(row: Row) -> float:
    """(d + D)/2, mm."""
    return (float(row["bore_mm"]) + float(row["outside_mm"])) / 2


def print_result(rows: Sequence[Row]) -> None:
    """Failures, kinds of warnings, and where the torques lie in the band, by series."""
    for row in rows:
        if row["failure"]:
            out.print(f"{row['designation']}, {row['case']}: {row['failure']}")
    for case in CASES:
        counts = Counter(kind for row in rows if row["case"] == case for kind in row["warnings"].split("; ") if kind)
        out.print(f"{case}, {sum(row['case'] == case for row in rows)} torques:", dict(counts.most_common()))
    heads = ("series", "load", "torques", "below", "above", "torque over middle", "ends over middle")
    show(heads, in_the_band(rows))
    for case in CASES:
        own = sorted((row for row in rows if row["case"] == case and row["torque_N_mm"]), key=coefficient)
        words = [f"{row['designation']} {coefficient(row):.2g}" for row in (*own[:6], *own[-6:])]
        out.print(f"{case}, least and largest coefficient of friction: {', '.join(words)}")


def in_the_band(rows: Sequence[Row]) -> Iterator[tuple[object, ...]]:
    """Where the torques lie, by series and load."""
    for series in sorted({row["series"] for row in rows if row["band_low_N_mm"]}):
        for case in CASES:
            own = [row for row in rows if (row["series"], row["case"]) == (series, case) and row["torque_N_mm"]]
            if not own:
                continue
            ratios, ends = np.array([position(row) for row in own]), np.array([half_width(row) for row in own])
            spread = f"{ratios.min():.2f} {np.median(ratios):.2f} {ratios.max():.2f}"
            outside = (np.sum(ratios < 1 / ends), np.sum(ratios > ends))
            yield series, case, len(own), *outside, spread, f"{np.median(ends):.2f}"


def draw(rows: Sequence[Row]) -> Figure:
    """Above the radial load, below the axial one: deep groove bearings against their band, and all coefficients."""
    drawn = figure(11, 8)
    panels = drawn.subplots(2, 2, sharex="col")
    for (against, alone), case in zip(panels, CASES, strict=True):
        own = [row for row in rows if row["case"] == case and row["torque_N_mm"]]
        load = f"{RADIAL_SHARE:g} C radial" if case == "radial" else f"{AXIAL_SHARE:g} C0 axial"
        left, right = ("a", "b") if case == "radial" else ("c", "d")
        _draw_band(against, own)
        against.set_title(f"({left}) {load}: torque over middle of catalogue band", fontsize=10)
        _draw_coefficients(alone, own)
        alone.set_title(f"({right}) {load}: coefficient of friction, torque over F d_m/2", fontsize=10)
    for axes in panels[1]:
        axes.set_xlabel("mean diameter d_m = (d + D)/2, mm")
    for axes in panels.flat:
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter(ScalarFormatter())
        axes.set_xticks([10, 20, 50, 100, 200, 300])
        axes.grid(visible=True, color="0.9")
        axes.set_axisbelow(True)
    panels[0, 0].legend(fontsize=8, ncols=2)
    panels[0, 1].legend(fontsize=8, ncols=2)
    return drawn


def _draw_band(axes: Axes, rows: Sequence[Row]) -> None:
    """A dot for each torque, and a grey line for each band."""
    banded = [row for row in rows if row["band_low_N_mm"]]
    sizes, ends = [mean_diameter(row) for row in banded], np.array([half_width(row) for row in banded])
    axes.vlines(sizes, 1 / ends, ends, color="0.8", linewidth=2, label="catalogue band")
    for series, (name, colour) in FAMILIES.items():
        own = [row for row in banded if row["series"].replace("161", "160") == series]
        axes.plot([mean_diameter(row) for row in own], [position(row) for row in own], ".", color=colour, label=name)
    own = [row for row in banded if row["kind"] == "angular contact"]
    axes.plot([mean_diameter(row) for row in own], [position(row) for row in own], "r^", mfc="none", label="72 B, 73 B")
    axes.set_yscale("log")
    axes.set_ylim(0.35, 3.5)
    axes.set_yticks([0.4, 0.5, 0.7, 1, 1.5, 2, 3], ["0.4", "0.5", "0.7", "1", "1.5", "2", "3"])
    axes.minorticks_off()


def _draw_coefficients(axes: Axes, rows: Sequence[Row]) -> None:
    """A dot for each torque; deep groove bearings are grey."""
    deep = [row for row in rows if row["kind"] == "deep groove"]
    axes.plot([mean_diameter(row) for row in deep], [coefficient(row) for row in deep], ".", color="0.7",
              label="deep groove")  # fmt: skip
    for maker, (name, colour) in ANGULAR.items():
        own = [row for row in rows if row["kind"] == "angular contact" and row["maker"] == maker]
        axes.plot([mean_diameter(row) for row in own], [coefficient(row) for row in own], ".", color=colour, label=name)
    axes.set_ylim(bottom=0)


def main(folder: Out = HERE) -> None:
    path, columns = folder / "catalogue_torque.csv", ("designation", "case", *COMPUTED[2:], *KNOWN, *BAND)
    names = [name for name in bearing_names() if find_bearing(name).grade in GRADES]
    tasks = {(name, case): (name, case) for case in reversed(CASES) for name in names}
    order = {name: place for place, name in enumerate(bearing_names())}
    rows = continued(path, columns, tasks, computed, jobs=os.cpu_count() or 1)
    rows.sort(key=lambda row: (order[row["designation"]], CASES.index(row["case"])))
    write(map(with_band, rows), path, ("designation", *KNOWN, *COMPUTED[1:7], *BAND, *COMPUTED[7:]))
    rows = read(path)
    print_result(rows)
    save(draw(rows), folder / "catalogue_torque.png", dpi=110)


if __name__ == "__main__":
    run(main)
