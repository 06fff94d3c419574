"""Three readings of [Paper] and how far each is from its numbers and conclusions.

Every reading has a friction torque, in which the cage counts with the power of its sliding. The friction moments about
the balls' centres, which are no loss, are compared with the paper's cage torque beside it.
"""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import asdict, dataclass
from typing import Any

import numpy as np

from analytic.scene import Array, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from validation.paper.cage import ROUGH, RPM, SMOOTH, at_finish, cage_at, cage_scene, cage_series
from validation.paper.inputs import assumed_inputs
from validation.study import SCENES as FILES
from validation.study import published as published_rows

SCENES = {  # reading -> file and description
    "as printed": (
        "6205_paper_as_printed.toml",
        "equations 2 to 7 and the pocket of table 1 as in the paper, misprints included; other inputs of the races as "
        "in the calibrated reading",
    ),
    "calibrated": (
        "6205_paper_calibrated.toml",
        "inputs missing in the paper, chosen to match its race torque and the numbers of its cage",
    ),
    "physical": ("6205_physical.toml", "usual inputs, loaded angle, sinh traction, hydrodynamic rolling, a slow start"),
}
UNITS = {"N mm": 1e-3, "N": 1.0}
MOMENTS = {"cage_torque": "cage_moments", "total_torque": "total_with_moments"}  # the same with moments, no losses
WORDS = {
    "total_torque": "total torque",
    "race_torque": "race torque",
    "cage_torque": "cage torque, power",
    "cage_moments": "cage torque, moments",
    "total_with_moments": "total torque, moments",
    "cage_max_force": "largest cage force",
}
MATCH = 1.1  # factor; rounding makes some published values uncertain by 7 %, for example 7 N mm
FLAT = 0.1  # relative, lowest to highest value: "minimal impact" or "almost constant" in the paper

Series = Mapping[str, Array]  # over speed, SI, each (n,)
Stored = dict[str, Any]  # of paper.json


@dataclass(frozen=True, kw_only=True)
class Point:
    """A number from the paper, SI."""

    quantity: str
    rms_roughness: float
    inner_speed: float
    value: float
    unit: str  # in which it is shown
    note: str  # "printed" or "about"


def published() -> list[Point]:
    """The numbers from the paper."""
    return [
        Point(
            quantity=row["quantity"],
            rms_roughness=float(row["rms_roughness_um"]) * 1e-6,
            inner_speed=float(row["inner_speed_rpm"]) * RPM,
            value=float(row["value"]) * UNITS[row["unit"]],
            unit=row["unit"],
            note=row["note"],
        )
        for row in published_rows("paper_torque.csv")
    ]


def load(name: str) -> Scene:
    return load_scene(FILES / SCENES[name][0])


def compare(name: str, points: list[Point]) -> Stored:
    """One scene beside the paper; its series by Sq, m."""
    scene = load(name)
    finishes = {roughness: at_finish(scene, roughness) for roughness in (ROUGH, SMOOTH)}
    found = {roughness: series(name, finish) for roughness, finish in finishes.items()}
    compared = [row for point in points for row in beside(point, found[point.rms_roughness])]
    warnings = (text for finish in finishes.values() for text in friction_torque(finish).warnings)
    file, kind = SCENES[name]
    return {
        "name": name,
        "kind": kind,
        "file": file,
        "assumed": assumed_inputs(name, scene),
        "series": {f"{roughness:g}": values for roughness, values in found.items()},
        "beside": compared,
        "curves": curves(compared),
        "trends": trends(found[ROUGH], found[SMOOTH]),
        "warnings": list(dict.fromkeys(warnings)),
    }


def series(name: str, scene: Scene) -> Series:
    """All quantities of a reading at one finish over the speeds of its scene."""
    races = friction_torque(scene)
    inner, outer = races.friction_coefficient.inner, races.friction_coefficient.outer
    assert inner is not None
    assert outer is not None
    speeds, race = scene.operation.inner_speed, races.torque.race
    cage = cage_series([cage_at(cage_scene(name, scene, inner_speed=float(speed))) for speed in speeds])
    return {
        "inner_speed": speeds,
        "race_torque": race,
        "inner_coefficient": inner,
        "outer_coefficient": outer,
        **cage,
        "total_torque": race + cage["cage_torque"],
        "total_with_moments": race + cage["cage_moments"],
    }


def beside(point: Point, values: Series) -> Iterator[Stored]:
    """The reading at a point of the paper; a torque of the cage counts as a power, and then as friction moments."""
    for name in (point.quantity, *([MOMENTS[point.quantity]] if point.quantity in MOMENTS else [])):
        computed = float(np.interp(point.inner_speed, values["inner_speed"], values[name]))
        yield {"point": asdict(point), "ours": name, "computed": computed, "deviation": computed / point.value - 1}


def curves(points: list[Stored]) -> list[Stored]:
    """One curve for each quantity and roughness, in the order of the points; factors : the larger over the smaller."""
    groups: dict[tuple[str, float], list[float]] = {}
    for one in points:
        factor = float(np.exp(abs(np.log1p(one["deviation"]))))
        groups.setdefault((one["ours"], one["point"]["rms_roughness"]), []).append(factor)
    return [
        {"ours": ours, "rms_roughness": sq, "factors": found, "verdict": verdict(max(found))}
        for (ours, sq), found in groups.items()
    ]


def verdict(worst: float) -> str:
    return "matched" if worst <= MATCH else f"within a factor of {worst:.3g}"


def trends(rough: Series, smooth: Series) -> list[Stored]:
    """The conclusions of the paper, in its order."""
    both = (rough, smooth)
    races = ("inner_coefficient", "outer_coefficient")
    return [
        _trend("rougher raises the total torque at every speed", _rougher_is_more(rough, smooth, "total_torque")),
        _trend("the total torque rises with speed", _together(_change(one["total_torque"], 1) for one in both)),
        _trend("rougher raises the friction coefficients of both races at every speed",
               _together(_rougher_is_more(rough, smooth, race) for race in races)),
        _trend("the friction coefficients of both races are flat in speed",
               _together(_change(one[race], 0) for one in both for race in races)),
        _trend("the race torque is almost constant at Sq 1 um", _change(rough["race_torque"], 0)),
        _trend("the race torque falls with speed at Sq 0.1 um", _change(smooth["race_torque"], -1)),
        _trend("the cage torque rises with speed", _together(_change(one["cage_torque"], 1) for one in both)),
        _trend("rougher raises the cage torque at every speed", _rougher_is_more(rough, smooth, "cage_torque")),
        _trend("the largest cage force rises with speed", _together(_change(one["cage_max_force"], 1) for one in both)),
        _trend("rougher raises the largest cage force at every speed",
               _rougher_is_more(rough, smooth, "cage_max_force")),
        _trend("rougher raises the pocket's friction coefficient at every speed",
               _rougher_is_more(rough, smooth, "pocket_coefficient")),
        _trend("the pocket's friction coefficient falls with speed at Sq 0.1 um",
               _change(smooth["pocket_coefficient"], -1)),
    ]  # fmt: skip


Outcome = tuple[bool, list[str]]  # whether a conclusion holds, with its numbers


def _trend(claim: str, outcome: Outcome) -> Stored:
    held, numbers = outcome
    return {"claim": claim, "held": held, "detail": "; ".join(numbers)}


def _together(parts: Iterable[Outcome]) -> Outcome:
    """Holds if all parts hold."""
    outcomes = list(parts)
    return all(held for held, _ in outcomes), [number for _, numbers in outcomes for number in numbers]


def _change(values: Array, direction: int) -> Outcome:
    """Whether the values rise (1) or fall (-1) from each speed to the next, or are flat (0)."""
    held = np.ptp(values) <= FLAT * values.min() if direction == 0 else np.all(direction * np.diff(values) > 0)
    ratio = values[-1] / values[0]
    return bool(held), [f"{100 * (ratio - 1):+.1f} %" if ratio < 2 else f"{ratio:.3g} times"]


def _rougher_is_more(rough: Series, smooth: Series, quantity: str) -> Outcome:
    ratio = rough[quantity] / smooth[quantity]
    return bool(np.all(ratio > 1)), [f"{ratio.min():.2f} to {ratio.max():.2f} times"]
