"""The paper, figure by figure: python validation/paper/run.py [--out FOLDER]

Makes figures 5 to 9 of [Paper] and its table 1 beside ours, at 100 to 500 rpm and both finishes, for three readings:
as printed, calibrated, physical. The paper's numbers are computed as well, so nothing here is a validation. A reading
whose inputs were chosen to match is a calibration, which predicts nothing. Takes about a minute and a half. Prints
tables, and writes into this folder: paper.md (the page), its pictures paper_*.png, paper.csv (the
numbers) and paper.json (everything, SI).
"""

import argparse
import csv
import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from analytic.scene import Array
from analytic.scenefile.read import load_scene
from validation.paper.cage import (
    CLEARANCE,
    FASTEST,
    ROUGH,
    RPM,
    SMOOTH,
    at_finish,
    cage_scene,
    loose_cage,
    mixed_coefficient,
    on_free_balls,
    printed_pocket,
)
from validation.paper.comparison import (
    FLAT,
    MATCH,
    SCENES,
    UNITS,
    WORDS,
    Comparison,
    PointComparison,
    compare,
    load,
    published,
)
from validation.paper.figures import draw_coefficients, draw_forces, draw_parts, draw_pocket, draw_surfaces, draw_total
from validation.paper.inputs import table_1
from validation.paper.page import PICTURES, write_page
from validation.paper.printed_jumps import ASIDE, Jump, printed_jumps

HERE = Path(__file__).parent


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=HERE, help="folder for what is written")
    folder = parser.parse_args().out
    points = published()
    readings = [compare(name, points) for name in SCENES]
    jumps = printed_jumps(load("as printed"))
    report(readings, jumps, Console(width=118, soft_wrap=False))
    folder.mkdir(parents=True, exist_ok=True)
    write_csv(readings, folder / "paper.csv")
    surface = load("calibrated").surface
    assert surface is not None
    assert surface.autocorrelation is not None
    five, six, seven, eight, nine, pocket = (folder / name for name in PICTURES)
    surfaces = draw_surfaces(surface.autocorrelation, five)
    draw_total(readings, points, six)
    draw_coefficients(readings, seven)
    draw_parts(readings, points, eight)
    draw_forces(readings, points, nine)
    fit = next(one for one in readings if one.name == "calibrated")
    needed = {ROUGH: fit.rough["pocket_coefficient"], SMOOTH: fit.smooth["pocket_coefficient"]}
    mixed = mixed_coefficients(fit)
    free = on_free_balls(cage_scene("calibrated", at_finish(load("calibrated"), SMOOTH), inner_speed=FASTEST))
    write_json(readings, jumps, mixed, folder / "paper.json")
    draw_pocket(needed, mixed, fit.rough["inner_speed"], pocket)
    write_page(readings, table_1(load_scene("6205-dry")), surfaces, mixed, free, folder / "paper.md")


def mixed_coefficients(fit: Comparison) -> dict[tuple[str, float], Array]:
    """(oil and pocket, Sq) -> coefficient of ball on pocket by mixed lubrication under the forces of the whirl."""
    pockets = {
        f"clearance {CLEARANCE * 1e3:g} mm": loose_cage(clearance=CLEARANCE, start="whirl", friction_coefficient=None),
        "pocket of table 1": printed_pocket(),
    }
    return {
        (f"{oil} oil, {words}", roughness): mixed_coefficient(
            at_finish(load(oil), roughness), pocket, force=values["cage_force"]
        )
        for oil in ("calibrated", "physical")
        for words, pocket in pockets.items()
        for roughness, values in ((ROUGH, fit.rough), (SMOOTH, fit.smooth))
    }


def report(comparisons: list[Comparison], jumps: list[Jump], out: Console) -> None:
    for one in comparisons:
        out.print(f"{one.name}: {one.kind}.")
    out.print()
    numbers = Table("quantity", "Sq, um", "rpm", "paper", *(one.name for one in comparisons), title="Numbers")
    for row, first in enumerate(comparisons[0].points):
        point = first.point
        scale = UNITS[point.unit]
        numbers.add_row(
            WORDS[first.ours], f"{point.rms_roughness * 1e6:g}", f"{point.inner_speed / RPM:.0f}",
            f"{'about ' if point.note == 'about' else ''}{point.value / scale:.4g} {point.unit}",
            *(_cell(one.points[row], scale) for one in comparisons),
        )  # fmt: skip
    out.print(numbers)
    out.print(
        "Power: of sliding in the pockets over the speed of the ring, a loss. Moments: of friction about the balls' "
        "centres, no loss.\n"
    )
    verdicts = Table(
        "curve", "Sq, um", *(one.name for one in comparisons), title=f"Matched: within {100 * (MATCH - 1):.0f} %"
    )
    for row, curve in enumerate(comparisons[0].curves):
        verdicts.add_row(
            WORDS[curve.ours], f"{curve.rms_roughness * 1e6:g}", *(one.curves[row].verdict for one in comparisons)
        )
    out.print(verdicts)
    out.print("What is matched was calibrated for, by more inputs than there are numbers: no evidence for the model.\n")
    conclusions = Table("conclusion of the paper", *(one.name for one in comparisons), title="Trends")
    for row, trend in enumerate(comparisons[0].trends):
        cells = [one.trends[row] for one in comparisons]
        conclusions.add_row(trend.claim, *(f"{'held' if cell.held else 'not held'} {cell.detail}" for cell in cells))
    out.print(conclusions)
    out.print(
        f"Changes are from the slowest to the fastest point, at Sq 1 um and on the inner race first. Flat and almost "
        f"constant mean within {100 * FLAT:.0f} %.\n"
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
    change = f"{100 * one.deviation:+.0f} %" if one.deviation < 1 else f"{one.deviation + 1:.3g} times"
    return f"{one.computed / scale:.3g} ({change})"


def write_csv(comparisons: list[Comparison], path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(("reading", "quantity", "rms_roughness_um", "inner_speed_rpm", "paper", "note", "ours",
                         "computed", "deviation", "unit"))  # fmt: skip
        for one in comparisons:
            for row in one.points:
                point, scale = row.point, UNITS[row.point.unit]
                writer.writerow(
                    (one.name, point.quantity, f"{point.rms_roughness * 1e6:g}", f"{point.inner_speed / RPM:.0f}",
                     f"{point.value / scale:.4g}", point.note, WORDS[row.ours], f"{row.computed / scale:.4g}",
                     f"{row.deviation:.4f}", point.unit)
                )  # fmt: skip


def write_json(
    comparisons: list[Comparison], jumps: list[Jump], mixed: dict[tuple[str, float], Array], path: Path
) -> None:
    """All values SI, with six digits, so that different machines write the same file."""
    content = {
        "paper": "Effect of Surface Roughness on the Friction Moment in a Ball Bearing",
        "readings": [
            {
                "name": one.name,
                "kind": one.kind,
                "file": SCENES[one.name][0],
                "assumed": dict(one.assumed),
                "series": {"1e-06": dict(one.rough), "1e-07": dict(one.smooth)},
                "beside": [asdict(row) | {"deviation": row.deviation} for row in one.points],
                "curves": [asdict(curve) | {"verdict": curve.verdict} for curve in one.curves],
                "trends": [asdict(trend) for trend in one.trends],
                "warnings": list(one.warnings),
            }
            for one in comparisons
        ],
        "mixed_pocket_coefficients": [
            {"pocket": name, "rms_roughness": roughness, "coefficient": values}
            for (name, roughness), values in mixed.items()
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


if __name__ == "__main__":
    main()
