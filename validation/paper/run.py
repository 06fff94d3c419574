"""The paper, figure by figure: python validation/paper/run.py [--out FOLDER]

Makes figures 5 to 9 of [Paper] and its table 1 beside ours, at 100 to 500 rpm and both finishes, for three readings:
as printed, calibrated, physical. The paper's numbers are computed as well, so nothing here is a validation. A reading
whose inputs were chosen to match is a calibration, which predicts nothing. Takes about a minute and a half. Prints
the page of docs.py, and writes into this folder its pictures paper_*.png and paper.json (everything, SI).
"""

import json
import sys
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from analytic.cage.statistics import CageStatistics
from analytic.scene import Array
from analytic.scenefile.read import load_scene
from validation.paper.cage import (
    CLEARANCE,
    FASTEST,
    ROUGH,
    SMOOTH,
    at_finish,
    cage_scene,
    loose_cage,
    mixed_coefficient,
    on_free_balls,
    printed_pocket,
)
from validation.paper.comparison import SCENES, Comparison, compare, load, published
from validation.paper.docs import page
from validation.paper.figures import draw_coefficients, draw_forces, draw_parts, draw_pocket, draw_surfaces, draw_total
from validation.paper.inputs import table_1
from validation.paper.printed_jumps import printed_jumps
from validation.study import Out, run

HERE = Path(__file__).parent


def main(out: Out = HERE) -> None:
    points = published()
    readings = [compare(name, points) for name in SCENES]
    surface = load("calibrated").surface
    assert surface.autocorrelation is not None
    draw_surfaces(surface.autocorrelation, out / "paper_5_surfaces.png")
    draw_total(readings, points, out / "paper_6_total.png")
    draw_coefficients(readings, out / "paper_7_coefficients.png")
    draw_parts(readings, points, out / "paper_8_torques.png")
    draw_forces(readings, points, out / "paper_9_forces.png")
    fit = next(one for one in readings if one.name == "calibrated")
    needed = {ROUGH: fit.rough["pocket_coefficient"], SMOOTH: fit.smooth["pocket_coefficient"]}
    mixed = mixed_coefficients(fit)
    free = on_free_balls(cage_scene("calibrated", at_finish(load("calibrated"), SMOOTH), inner_speed=FASTEST))
    draw_pocket(needed, mixed, fit.rough["inner_speed"], out / "paper_pocket.png")
    stored = json_of(readings, mixed, free)
    (out / "paper.json").write_text(json.dumps(stored, indent=1) + "\n", encoding="utf-8")
    sys.stdout.write(page(stored))


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


def json_of(
    comparisons: list[Comparison], mixed: dict[tuple[str, float], Array], free: CageStatistics
) -> dict[str, Any]:
    """All values SI, with six digits, so that different machines write the same file.

    free : the calibrated cage at Sq 0.1 um and 500 rpm on balls that it may brake
    """
    content = {
        "paper": "Effect of Surface Roughness on the Friction Moment in a Ball Bearing",
        "readings": [
            {
                "name": one.name,
                "kind": one.kind,
                "file": SCENES[one.name][0],
                "assumed": dict(one.assumed),
                "series": {"1e-06": dict(one.rough), "1e-07": dict(one.smooth)},
                **{name: getattr(one, name) for name in ("beside", "curves", "trends", "warnings")},
            }
            for one in comparisons
        ],
        "mixed_pocket_coefficients": [
            {"pocket": name, "rms_roughness": roughness, "coefficient": values}
            for (name, roughness), values in mixed.items()
        ],
        "jumps": [asdict(jump) for jump in printed_jumps(load("as printed"))],
        "table_1": table_1(load_scene("6205-dry")),
        "free_balls": {
            name: getattr(free, name) for name in ("max_force", "mean_force", "torque", "race_excess_torque")
        },
    }
    return _rounded(content)


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
    run(main)
