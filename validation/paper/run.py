"""The paper, figure by figure: python validation/paper/run.py [--out FOLDER]

Makes figures 5 to 9 of [Paper] and its table 1 beside ours, at 100 to 500 rpm and both finishes, for three readings:
as printed, calibrated, physical. The paper's numbers are computed as well, so nothing here is a validation. A reading
whose inputs were chosen to match is a calibration, which predicts nothing. Takes about a minute and a half. Prints
the page of docs.py, and writes into this folder its pictures paper_*.png and paper.json (everything, SI).
"""

import json
import sys
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np

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
from validation.paper.comparison import SCENES, compare, load, printed_jumps, table_1
from validation.paper.docs import page
from validation.paper.figures import draw_all
from validation.study import Out, run

HERE = Path(__file__).parent


def main(out: Out = HERE) -> None:
    stored = rounded(computed())
    out.mkdir(parents=True, exist_ok=True)
    (out / "paper.json").write_text(json.dumps(stored, indent=1) + "\n", encoding="utf-8")
    draw_all(stored, out)
    sys.stdout.write(page(stored))


def computed() -> dict[str, Any]:
    """Everything, SI."""
    readings = [compare(name) for name in SCENES]
    free = on_free_balls(cage_scene("calibrated", at_finish(load("calibrated"), SMOOTH), inner_speed=FASTEST))
    return {
        "readings": readings,
        "mixed_pocket_coefficients": list(mixed_coefficients(readings[1]["series"])),
        "jumps": printed_jumps(load("as printed")),
        "table_1": table_1(load_scene("6205-dry")),
        "free_balls": {  # the calibrated cage at Sq 0.1 um and 500 rpm on balls that it may brake
            name: getattr(free, name) for name in ("max_force", "mean_force", "torque", "race_excess_torque")
        },
    }


def mixed_coefficients(series: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Coefficient of ball on pocket by mixed lubrication under the forces of the calibrated whirl, by its series."""
    pockets = {
        f"clearance {CLEARANCE * 1e3:g} mm": loose_cage(clearance=CLEARANCE, start="whirl", friction_coefficient=None),
        "pocket of table 1": printed_pocket(),
    }
    for oil, (words, pocket), sq in product(("calibrated", "physical"), pockets.items(), (ROUGH, SMOOTH)):
        force = series[f"{sq:g}"]["cage_force"]
        coefficient = mixed_coefficient(at_finish(load(oil), sq), pocket, force=force)
        yield {"pocket": f"{oil} oil, {words}", "rms_roughness": sq, "coefficient": coefficient}


def rounded(value: Any) -> Any:
    """With six digits, so that different machines write the same file."""
    match value:
        case np.ndarray():
            return [rounded(float(one)) for one in value]
        case float():
            return float(f"{value:.6g}")
        case dict():
            return {key: rounded(one) for key, one in value.items()}
        case list() | tuple():
            return [rounded(one) for one in value]
    return value


if __name__ == "__main__":
    run(main)
