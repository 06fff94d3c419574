"""A measured torque beside the computed one, made by hand: each number is known and unlike all others."""

from typing import Any

import numpy as np

from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.check.measured.rows import MeasuredRow


def row(**changed: Any) -> MeasuredRow:
    given: dict[str, Any] = {
        "inner_speed": 20 * np.pi,  # 600 rpm
        "axial_load": 700.0,
        "radial_load": 0.0,
        "moment": 0.0,
        "temperature": 333.15,
        "measured": 0.04,
        "computed": 0.05,
        "error": 0.01,
        "numerical": 0.0004,
        "input": 0.003,
        "measurement": 0.002,
        "validation": 0.0036,
        "formulas": 0.005,
        "computed_low": 0.041,
        "computed_high": 0.062,
        "low": 0.0405,
        "high": 0.063,
        "beyond": 0.0005,
        "verdict": "model too high",
    }
    return MeasuredRow(**given | changed)


def comparison(*rows: MeasuredRow) -> MeasuredComparison:
    return MeasuredComparison(
        scene="a scene",
        file="data.csv",
        rows=rows,
        inside=sum(each.verdict == "inside" for each in rows),
        mean_error=0.21,
        scatter=0.03,
        shares={"lubricant.viscosity": 0.61},
        samples=640,
        seed=7,
        seconds=2.5,
        conclusions=("Missed: one of them.",),
        notes=("From the scene: all else.",),
        warnings=(),
    )


FASTER = row(inner_speed=30 * np.pi, verdict="inside", beyond=0.0)
TWO = comparison(row(), FASTER)
