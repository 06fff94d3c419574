"""An interval of a torque, made by hand: each number is known and unlike all others."""

from types import SimpleNamespace
from typing import Any, cast

import numpy as np

from analytic.prediction.prediction import Prediction
from analytic.prediction.rows import Interval, SobolIndices

NOMINAL = np.array([0.021, 0.034])  # N m
SPEED = np.array([10.0, 50.0])  # rad/s
ENDS = {"numerical": (0.98, 1.03), "input": (0.7, 1.5), "model": (0.8, 1.4), "model.film": (0.9, 1.1)}
ROWS = [{"inner_speed": speed, "axial_load": 640.0, "radial_load": 0.0, "moment": 0.0} for speed in SPEED.tolist()]
TOTALS = np.array([[0.14, 0.44], [0.61, 0.31], [0.0, 0.001]])


def interval_of(keys: list[str], totals: np.ndarray, **changed: Any) -> Prediction:
    """Of these inputs, with their total indices (d, 2)."""
    given: dict[str, Any] = {
        "nominal": SimpleNamespace(torque=SimpleNamespace(total=NOMINAL), inner_speed=SPEED, rows=ROWS),
        "inputs": tuple(SimpleNamespace(key=key) for key in keys),
        "total": Interval(
            low=0.6 * NOMINAL,
            median=NOMINAL,
            high=1.9 * NOMINAL,
            low_error=0 * NOMINAL + 2e-4,
            high_error=7e-4 + NOMINAL,
        ),
        "parts": {},
        "made_of": {name: np.outer(ends, NOMINAL) for name, ends in ENDS.items()},
        "indices": SobolIndices(
            first=0.9 * totals, total=totals, first_error=0.01 + 0 * totals, total_error=0.03 + 0 * totals
        ),
        "explained": np.array([0.97, 0.98]),
        **dict.fromkeys(("samples", "seed", "failed"), 0),
        "reasons": (),
        "seconds": 1.5,
        "evaluation_seconds": 2.5,
    }
    return cast(Prediction, Prediction(**given | changed))


INTERVAL = interval_of(["lubricant.viscosity", "model.film", "numerical"], TOTALS)
