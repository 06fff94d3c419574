"""The bearing and how it runs, and which effects were computed."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.result import COORDINATES
from fembearing.quantities import PER_MINUTE
from fembearing.report.document.report import Report
from fembearing.report.document.scene import GivenAngle, SolvedAngle
from fembearing.report.phrases import SHARES, friction_of, share_of

LONGEST_LIST = 12  # values in a table's cell


def scene_section(document: Report) -> dict[str, Any]:
    """The scene itself, SI, and what its table says in other words."""
    scene = document.provenance.scene_content
    bearing, operation = scene.bearing, scene.operation
    bodies = [bearing.ball_material, bearing.inner.material, bearing.outer.material]
    materials = bodies + ([] if scene.cage is None else [scene.cage.material])
    sideways = {name: np.atleast_1d(getattr(operation, name)) for name in ("radial_load", "moment")}
    return {
        "scene": scene,
        "grooves": [("inner groove", bearing.inner), ("outer groove", bearing.outer)],
        "pitch_diameter": bearing.inner.bottom_radius + bearing.outer.bottom_radius,
        "clearance": 2 * (bearing.outer.bottom_radius - bearing.inner.bottom_radius - bearing.ball_diameter),
        "materials": [material for number, material in enumerate(materials) if material not in materials[:number]],
        "loads": listed(operation.axial_load),
        "sideways": [
            (COORDINATES[name].meaning, f"{listed(values)} {COORDINATES[name].unit}")
            for name, values in sideways.items()
            if np.any(values)
        ],
        "speeds": speeds(operation.inner_speed),
        "angle": _angle(scene.contact_angle, document.contacts[0].contact_angle),
        "friction": friction_of(
            coefficient=scene.friction_coefficient,
            is_lubricated=scene.lubricant is not None and scene.surface is not None,
        ),
        "effects": [
            (effect, share_of(effect.share_is, effect.share))
            for effect in (() if document.torque is None else document.torque.effects)
        ],
        "shares": SHARES,
    }


def _angle(rule: GivenAngle | SolvedAngle, loaded: float) -> str:
    if rule.rule == "given":
        return f"given, {rule.value:.4g} rad"
    free = "that of the clearance" if rule.free is None else f"{rule.free:.4g} rad"
    return f"solved from the load, free angle {free}; {loaded:.4f} rad at the largest ball load"


def speeds(values: Sequence[float]) -> str:
    """Speeds in rad/s, listed in rpm."""
    return listed([value * PER_MINUTE for value in values])


def listed(values: Sequence[float] | np.ndarray) -> str:
    """Distinct values in their order; a long series by its ends."""
    distinct = list(dict.fromkeys(f"{value:.4g}" for value in values))
    if len(distinct) > LONGEST_LIST:
        return f"{distinct[0]} to {distinct[-1]}, {len(distinct)} values"
    return ", ".join(distinct)
