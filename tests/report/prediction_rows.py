"""An interval of a torque, made by hand: each number is known and unlike all others."""

import json
from dataclasses import dataclass
from typing import Any, ClassVar

from pydantic import TypeAdapter

from analytic.prediction.rows import PredictionRows


def predicted_point(speed: float, nominal: float, totals: list[float]) -> dict[str, Any]:
    ends = {"low": 0.6 * nominal, "median": nominal, "high": 1.9 * nominal, "low_error": 2e-4, "high_error": 7e-4}
    return {
        "inner_speed": speed,
        "axial_load": 640.0,
        "radial_load": 0.0,
        "moment": 0.0,
        "nominal": nominal,
        "total": ends,
        "parts": {"race": ends},
        "made_of": {
            "numerical": [0.98 * nominal, 1.03 * nominal],
            "input": [0.7 * nominal, 1.5 * nominal],
            "model": [0.8 * nominal, 1.4 * nominal],
            "model.film": [0.9 * nominal, 1.1 * nominal],
        },
        "indices": {
            "first": [0.11, 0.55, 0.0],
            "total": totals,
            "first_error": [0.01, 0.02, 0.001],
            "total_error": [0.03, 0.034, 0.002],
        },
        "explained": 0.97,
    }


@dataclass(frozen=True)
class Whole:
    """As a report reads them: strictly."""

    __pydantic_config__: ClassVar = {"strict": True, "extra": "forbid", "allow_inf_nan": False}
    rows: PredictionRows


def prediction_of(content: dict[str, Any]) -> PredictionRows:
    return TypeAdapter(Whole).validate_json(json.dumps({"rows": content})).rows


def content() -> dict[str, Any]:
    made = {"value": 1.5, "deviation": 0.2, "source": "judgement", "floor": 0.0}
    return {
        "covered": 0.95,
        "points": [predicted_point(10.0, 0.021, [0.14, 0.61, 0.0]), predicted_point(50.0, 0.034, [0.44, 0.31, 0.001])],
        "inputs": [
            made | {"key": "lubricant.viscosity", "unit": "Pa*s", "kind": "input"},
            made | {"key": "model.film", "unit": "", "kind": "model"},
            made | {"key": "numerical", "unit": "", "kind": "numerical"},
        ],
        "not_varied": ["the moon"],
        "samples": 300,
        "failed": 2,
        "reasons": ["a ball fell out (2 times)"],
        "seed": 77,
        "seconds": 12.0,
        "evaluation_seconds": 22.0,
    }
