"""Comparison of a scene with the numbers and conclusions of [Paper]."""

import csv
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from analytic.scene import Array, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque

HERE = Path(__file__).parent
PUBLISHED = HERE / "published" / "paper_torque.csv"
SCENES = {  # name -> file and description
    "calibrated": ("6205_paper_calibrated.toml", "calibration: inputs chosen so that the race torque comes out"),
    "as printed": (
        "6205_paper_as_printed.toml",
        "the same inputs with equations 2 to 7 as printed, outer race control",
    ),
    "physical": ("6205_physical.toml", "usual inputs, loaded angle, sinh traction, hydrodynamic rolling"),
}
ROUGH, SMOOTH = 1e-6, 0.1e-6  # Sq, m
RPM = np.pi / 30
UNITS = {"N mm": 1e-3, "N": 1.0}
# quantity -> its two keys in a point of the torque's JSON; None there means not computed.
QUANTITIES = {
    "total_torque": ("torque", "total"),
    "race_torque": ("torque", "race"),
    "cage_torque": ("torque", "cage"),
    "cage_max_force": ("cage", "max_force"),
    "inner_coefficient": ("friction_coefficient", "inner"),
    "outer_coefficient": ("friction_coefficient", "outer"),
    "pocket_coefficient": ("friction_coefficient", "pocket"),
}
MATCH = 0.1  # relative; rounding makes some published values uncertain by 7 %, for example 7 N mm
FLAT = 0.1  # relative, lowest to highest value: "minimal impact" or "almost constant" in the paper

Series = Mapping[str, Array | None]  # of the quantities above and inner_speed, SI, each (n,)


@dataclass(frozen=True, kw_only=True)
class Point:
    """A number from the paper, SI."""

    quantity: str
    rms_roughness: float
    inner_speed: float
    value: float
    unit: str  # in which it is shown
    note: str  # "printed" or "about"


@dataclass(frozen=True, kw_only=True)
class PointComparison:
    """The value of a scene at a point of the paper; None means not computed."""

    point: Point
    computed: float | None
    complete: bool  # False for a total without the cage

    @property
    def deviation(self) -> float | None:
        """Computed over published, minus 1."""
        return None if self.computed is None else self.computed / self.point.value - 1


@dataclass(frozen=True, kw_only=True)
class Curve:
    """A quantity from the paper over speed at one roughness."""

    quantity: str
    rms_roughness: float
    deviations: tuple[float, ...]  # at the speeds in the paper; empty if nothing is computed
    verdict: str


@dataclass(frozen=True, kw_only=True)
class Trend:
    """A conclusion of the paper and whether it holds."""

    claim: str
    held: bool | None  # None: not computed yet
    detail: str


@dataclass(frozen=True, kw_only=True)
class Comparison:
    """The comparison of one scene with the paper."""

    name: str
    kind: str
    assumed: Mapping[str, str]
    rough: Series
    smooth: Series
    points: tuple[PointComparison, ...]
    curves: tuple[Curve, ...]
    trends: tuple[Trend, ...]
    warnings: tuple[str, ...]


def published() -> list[Point]:
    """The numbers from the paper."""
    lines = [line for line in PUBLISHED.read_text("utf-8").splitlines() if not line.startswith("#")]
    return [
        Point(
            quantity=row["quantity"],
            rms_roughness=float(row["rms_roughness_um"]) * 1e-6,
            inner_speed=float(row["inner_speed_rpm"]) * RPM,
            value=float(row["value"]) * UNITS[row["unit"]],
            unit=row["unit"],
            note=row["note"],
        )
        for row in csv.DictReader(lines)
    ]


def load(name: str) -> Scene:
    return load_scene(HERE / "scenes" / SCENES[name][0])


def compare(name: str, points: list[Point]) -> Comparison:
    scene = load(name)
    assert scene.surface is not None
    torques = [
        friction_torque(replace(scene, surface=replace(scene.surface, rms_roughness=roughness)))
        for roughness in (ROUGH, SMOOTH)
    ]
    rough, smooth = (series(torque.to_json()["points"]) for torque in torques)
    compared = tuple(compare_point(point, rough if point.rms_roughness == ROUGH else smooth) for point in points)
    return Comparison(
        name=name,
        kind=SCENES[name][1],
        assumed=assumed_inputs(scene),
        rough=rough,
        smooth=smooth,
        points=compared,
        curves=tuple(curves(compared)),
        trends=tuple(trends(rough, smooth)),
        warnings=tuple(dict.fromkeys(text for torque in torques for text in torque.warnings)),
    )


def series(points: list[dict[str, Any]]) -> Series:
    """Quantities over the points of a torque's JSON; None for one that is not computed at every point."""
    quantities: dict[str, Array | None] = {"inner_speed": np.array([point["inner_speed"] for point in points])}
    for quantity, (group, name) in QUANTITIES.items():
        values = [point[group][name] for point in points]
        quantities[quantity] = None if None in values else np.array(values)
    return quantities


def compare_point(point: Point, series: Series) -> PointComparison:
    """The value of the series at the speed of a point, interpolated."""
    values, speeds = series[point.quantity], series["inner_speed"]
    assert speeds is not None
    computed = None if values is None else float(np.interp(point.inner_speed, speeds, values))
    complete = point.quantity != "total_torque" or series["cage_torque"] is not None
    return PointComparison(point=point, computed=computed, complete=complete)


def curves(points: tuple[PointComparison, ...]) -> list[Curve]:
    """One curve for each quantity and roughness, in the order of the points."""
    groups: dict[tuple[str, float], list[PointComparison]] = {}
    for one in points:
        groups.setdefault((one.point.quantity, one.point.rms_roughness), []).append(one)
    result = []
    for (quantity, roughness), members in groups.items():
        deviations = tuple(one.deviation for one in members if one.deviation is not None)
        if not deviations:
            verdict = "not computed yet"
        elif not all(one.complete for one in members):
            verdict = "not comparable yet: ours lacks the cage"
        else:
            verdict = "matched" if max(map(abs, deviations)) <= MATCH else "not matched"
        result.append(Curve(quantity=quantity, rms_roughness=roughness, deviations=deviations, verdict=verdict))
    return result


def trends(rough: Series, smooth: Series) -> list[Trend]:
    """The conclusions of the paper, in its order."""
    both = (rough, smooth)
    races = ("inner_coefficient", "outer_coefficient")
    lacks_cage = "" if rough["cage_torque"] is not None else ", without the cage"
    return [
        _trend("rougher raises the total torque at every speed", _rougher_is_more(rough, smooth, "total_torque"),
               lacks_cage),
        _trend("the total torque rises with speed", _together(_change(one["total_torque"], 1) for one in both),
               lacks_cage),
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


Outcome = tuple[bool, list[str]] | None  # whether a conclusion holds, with its numbers; None: not computed


def _trend(claim: str, outcome: Outcome, remark: str = "") -> Trend:
    if outcome is None:
        return Trend(claim=claim, held=None, detail="not computed yet")
    held, numbers = outcome
    return Trend(claim=claim, held=held, detail="; ".join(numbers) + remark)


def _together(parts: Iterable[Outcome]) -> Outcome:
    """Holds if all parts hold."""
    outcomes = list(parts)
    known = [one for one in outcomes if one is not None]
    if len(known) < len(outcomes):
        return None
    return all(held for held, _ in known), [number for _, numbers in known for number in numbers]


def _change(values: Array | None, direction: int) -> Outcome:
    """Whether the values rise (1) or fall (-1) from each speed to the next, or are flat (0)."""
    if values is None:
        return None
    held = np.ptp(values) <= FLAT * values.min() if direction == 0 else np.all(direction * np.diff(values) > 0)
    return bool(held), [f"{100 * (values[-1] / values[0] - 1):+.1f} %"]


def _rougher_is_more(rough: Series, smooth: Series, quantity: str) -> Outcome:
    more, less = rough[quantity], smooth[quantity]
    if more is None or less is None:
        return None
    ratio = more / less
    return bool(np.all(ratio > 1)), [f"{ratio.min():.2f} to {ratio.max():.2f} times"]


def assumed_inputs(scene: Scene) -> dict[str, str]:
    """Inputs that the paper does not give and the scene assumes; the same for both roughnesses."""
    ball, angle, oil, surface = scene.bearing.ball_material, scene.contact_angle, scene.lubricant, scene.surface
    assert oil is not None
    assert surface is not None
    assert surface.autocorrelation is not None
    correlation, hardness = surface.autocorrelation, surface.hardness or ball.hardness or np.nan
    meaning = "loaded" if angle.rule == "given" else "free"
    return {
        "0.18 rad read as": f"{meaning} angle",
        "elasticity": f"{ball.youngs_modulus / 1e9:g} GPa, Poisson {ball.poisson_ratio:g}",
        "hardness": f"{hardness / 1e9:g} GPa",
        "viscosity": f"{oil.viscosity:g} Pa s",
        "pressure-viscosity": f"{oil.pressure_viscosity:g} 1/Pa",
        "shear stress": f"{oil.traction}, {oil.eyring_stress / 1e6:g} MPa",
        "boundary friction": f"{surface.boundary_friction:g}",
        "autocorrelation": f"{correlation.kind}, {correlation.length * 1e6:g} um",
        "rough surfaces": "one" if surface.ball_rms_roughness == 0 else "two, alike",
        "hysteresis loss": "none" if scene.hysteresis_loss is None else f"{scene.hysteresis_loss:g}",
        "spin rule": scene.spin_rule,
        "equations 2 to 7": scene.microslip,
        "hydrodynamic rolling": "left out" if scene.effects.get("rolling") == "off" else "computed",
    }
