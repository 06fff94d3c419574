"""Comparison of the scenes with [Paper]: python validation/paper.py [--out FOLDER]

Shows which curves of the paper each scene matches, the inputs that the paper does not give and the scene assumes, and
which of the paper's conclusions hold. The paper's numbers are computed as well, so nothing here is a validation. A
scene whose inputs were chosen to match is a calibration, which predicts nothing. Prints tables, and writes paper.csv
(the numbers), paper.json (everything, SI) and paper.png into the folder (validation/reports).
"""

import argparse
import csv
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from rich.console import Console
from rich.table import Table

from paper_comparison import (
    FLAT,
    MATCH,
    ROUGH,
    RPM,
    SCENES,
    SMOOTH,
    UNITS,
    Comparison,
    Point,
    PointComparison,
    compare,
    load,
    published,
)
from printed_jumps import ASIDE, Jump, printed_jumps

mpl.use("agg")

HERE = Path(__file__).parent


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=HERE / "reports", help="folder for paper.csv, .json and .png")
    folder = parser.parse_args().out
    points = published()
    comparisons = [compare(name, points) for name in SCENES]
    jumps = printed_jumps(load("as printed"))
    report(comparisons, jumps, Console(width=118, soft_wrap=False))
    folder.mkdir(parents=True, exist_ok=True)
    write_csv(comparisons, folder / "paper.csv")
    write_json(comparisons, jumps, folder / "paper.json")
    draw(comparisons, points, folder / "paper.png")


def report(comparisons: list[Comparison], jumps: list[Jump], out: Console) -> None:
    inputs = Table("input that the paper does not give", *(one.name for one in comparisons), title="Assumed inputs")
    for name in comparisons[0].assumed:
        inputs.add_row(name, *(one.assumed[name] for one in comparisons))
    out.print(inputs)
    for one in comparisons:
        out.print(f"{one.name}: {one.kind}.")
    out.print()
    numbers = Table("quantity", "Sq, um", "rpm", "paper", *(one.name for one in comparisons), title="Numbers")
    for row, first in enumerate(comparisons[0].points):
        point = first.point
        scale = UNITS[point.unit]
        numbers.add_row(
            point.quantity.replace("_", " "), f"{point.rms_roughness * 1e6:g}", f"{point.inner_speed / RPM:.0f}",
            f"{'about ' if point.note == 'about' else ''}{point.value / scale:.4g} {point.unit}",
            *(_cell(one.points[row], scale) for one in comparisons),
        )  # fmt: skip
    out.print(numbers)
    out.print("*: without the cage, which the paper's number includes and these scenes do not.\n")
    verdicts = Table("curve", "Sq, um", *(one.name for one in comparisons), title=f"Curves, matched within {MATCH:.0%}")
    for row, curve in enumerate(comparisons[0].curves):
        verdicts.add_row(
            curve.quantity.replace("_", " "), f"{curve.rms_roughness * 1e6:g}",
            *(one.curves[row].verdict for one in comparisons),
        )  # fmt: skip
    out.print(verdicts)
    out.print(
        "The race torques are four rounded numbers, matched by more chosen inputs: no evidence for the model. A film "
        "that grows with speed takes load off the asperities, so the torque falls. No plausible inputs give the "
        "paper's nearly constant race torque at Sq 1 um: the calibration needs a boundary friction of 0.035.\n"
    )
    conclusions = Table("conclusion of the paper", *(one.name for one in comparisons), title="Trends")
    words = {True: "held", False: "not held", None: ""}
    for row, trend in enumerate(comparisons[0].trends):
        cells = [one.trends[row] for one in comparisons]
        conclusions.add_row(trend.claim, *(f"{words[cell.held]} {cell.detail}".strip() for cell in cells))
    out.print(conclusions)
    out.print(
        f"Changes are from the slowest to the fastest point, at Sq 1 um and on the inner race first. Flat and almost "
        f"constant mean within {FLAT:.0%}.\n"
    )
    sides = Table("where", "quantity", "as printed", "derived", title="Jumps of equations 2 to 7 as printed")
    for jump in jumps:
        scale = UNITS[jump.unit]
        printed, derived = (f"{pair[0] / scale:.4f} -> {pair[1] / scale:.4f}" for pair in (jump.printed, jump.derived))
        sides.add_row(jump.where, f"{jump.quantity}, {jump.unit}", printed, derived)
    out.print(sides)
    out.print(
        f"The two values are at ratios {ASIDE:g} below and above a jump; at ratio 0, without spin and at {ASIDE:g}."
    )


def _cell(one: PointComparison, scale: float) -> str:
    if one.computed is None or one.deviation is None:
        return "not computed yet"
    return f"{one.computed / scale:.4g}{'' if one.complete else '*'} ({100 * one.deviation:+.0f} %)"


def write_csv(comparisons: list[Comparison], path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("scene", "quantity", "rms_roughness_um", "inner_speed_rpm", "paper", "computed", "deviation",
                         "unit", "note"))  # fmt: skip
        for one in comparisons:
            for row in one.points:
                point, scale = row.point, UNITS[row.point.unit]
                writer.writerow(
                    (one.name, point.quantity, f"{point.rms_roughness * 1e6:g}", f"{point.inner_speed / RPM:.0f}",
                     f"{point.value / scale:.4g}", "" if row.computed is None else f"{row.computed / scale:.5g}",
                     "" if row.deviation is None else f"{row.deviation:.4f}", point.unit,
                     point.note if row.complete else f"{point.note}; ours lacks the cage")
                )  # fmt: skip


def write_json(comparisons: list[Comparison], jumps: list[Jump], path: Path) -> None:
    """All values SI, with six digits, so that different machines write the same file."""
    content = {
        "paper": "Effect of Surface Roughness on the Friction Moment in a Ball Bearing",
        "scenes": [
            {
                "name": one.name,
                "kind": one.kind,
                "file": SCENES[one.name][0],
                "assumed": dict(one.assumed),
                "series": {"1e-06": dict(one.rough), "1e-07": dict(one.smooth)},
                "beside": [asdict(row) | {"deviation": row.deviation} for row in one.points],
                "curves": [asdict(curve) for curve in one.curves],
                "trends": [asdict(trend) for trend in one.trends],
                "warnings": list(one.warnings),
            }
            for one in comparisons
        ],
        "jumps": [asdict(jump) for jump in jumps],
    }
    path.write_text(json.dumps(_rounded(content), indent=1) + "\n", encoding="utf-8")


def _rounded(value: Any) -> Any:
    match value:
        case np.ndarray():
            return [_rounded(float(one)) for one in value]
        case float():
            return float(f"{value:.6g}")
        case dict():
            return {key: _rounded(one) for key, one in value.items()}
        case list() | tuple():
            return [_rounded(one) for one in value]
    return value


def draw(comparisons: list[Comparison], points: list[Point], path: Path) -> None:
    figure = Figure(figsize=(9.0, 5.6), layout="constrained")
    axes = figure.subplots(1, 2, sharey=True)
    for axis, quantity, title in zip(
        axes, ("race_torque", "total_torque"), ("Ball on race", "Whole bearing"), strict=True
    ):
        for number, one in enumerate(comparisons):
            for roughness, values, style in ((ROUGH, one.rough, "-"), (SMOOTH, one.smooth, "--")):
                torque, speed = values[quantity], values["inner_speed"]
                assert torque is not None
                assert speed is not None
                label = f"{one.name}, Sq {roughness * 1e6:g} µm"
                axis.plot(speed / RPM, torque * 1e3, style, color=f"C{number}", label=label)
        for roughness, fill in ((ROUGH, "k"), (SMOOTH, "w")):
            mine = [point for point in points if (point.quantity, point.rms_roughness) == (quantity, roughness)]
            axis.plot(
                [point.inner_speed / RPM for point in mine], [point.value * 1e3 for point in mine], "ko",
                mfc=fill, ms=6, label=f"paper, Sq {roughness * 1e6:g} µm",
            )  # fmt: skip
        axis.set(title=title, xlabel="speed of the inner ring, rpm", ylim=(0, None))
    axes[0].set_ylabel("friction torque, N mm")
    figure.legend(*axes[0].get_legend_handles_labels(), loc="outside upper center", ncols=4, frameon=False, fontsize=8)
    lacking = (
        "; its whole bearing has the cage, which ours lacks" if comparisons[0].rough["cage_torque"] is None else ""
    )
    figure.supxlabel(
        "6205 under 1000 N thrust. Points: what the paper prints (race torque as about), computed and not measured"
        f"{lacking}.\nThe calibrated scene is a fit of its inputs to the paper's race torque, no prediction; as "
        "printed has them\nwith the misprints of equations 2 to 7; physical has the loaded angle, sinh traction and "
        "hydrodynamic rolling.",
        fontsize=8,
    )
    figure.savefig(path, dpi=130, metadata={"Software": None})


if __name__ == "__main__":
    main()
