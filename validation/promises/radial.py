"""A radial bearing at one operating point, as a scene: one number between 0 and 1 for each input."""

from collections.abc import Iterable
from typing import Any

import numpy as np


class Draw:
    """Reads the inputs of a scene off a place, one number after the other."""

    def __init__(self, place: Iterable[float]) -> None:
        self.numbers = iter(place)

    def between(self, low: float, high: float) -> float:
        return low + (high - low) * next(self.numbers)

    def power(self, low: float, high: float) -> float:
        """Even in the logarithm."""
        return float(np.exp(self.between(np.log(low), np.log(high))))

    def one_of(self, *choices: str) -> str:
        return choices[min(int(next(self.numbers) * len(choices)), len(choices) - 1)]

    def chance(self, share: float) -> bool:
        return next(self.numbers) < share


RADIAL_INPUTS = 46  # numbers that `radial_scene` takes at most


def radial_scene(place: Iterable[float], *, tolerance: float) -> dict[str, Any]:
    """The scene at a place, as the document of a scene file."""
    draw = Draw(place)
    ball = draw.power(3e-3, 30e-3)
    radii = {ring: draw.between(0.505, 0.56) * ball for ring in ("inner", "outer")}
    pitch, clearance = ball * draw.between(3.2, 6.5), ball * draw.power(1e-4, 3e-2)
    inner = pitch / 2 - ball / 2 - clearance / 4
    bottoms = {"inner": inner, "outer": inner + ball + clearance / 2}
    shoulder = draw.between(0.38, 0.46) * ball
    balls = int(draw.between(0.5, 0.9) * np.pi * pitch / ball)
    material = draw.one_of("steel", "steel", "silicon_nitride")
    bearing: dict[str, Any] = {
        "name": "drawn",
        "ball_count": max(balls, 5),
        "ball_diameter": f"{ball:.9g} m",
        "ball_mass": f"{np.pi / 6 * ball**3 * (7800 if material == 'steel' else 3200):.9g} kg",
        "ball_material": material,
        "bore_diameter": f"{2 * inner - ball:.9g} m",
        "outside_diameter": f"{2 * bottoms['outer'] + ball:.9g} m",
        "contact_angle": {"rule": "solved", "free": f"{draw.between(0.05, 0.7):.9g} rad"},
    }
    for ring, groove in radii.items():
        bearing[ring] = {
            "bottom_radius": f"{bottoms[ring]:.9g} m",
            "groove_radius": f"{groove:.9g} m",
            "shoulder_half_width": f"{shoulder:.9g} m",
            "material": "steel",
        }
    heaviest = 1e8 * ball**2  # N of thrust: about 2.5 GPa in usual grooves, 4 GPa in open ones
    axial = draw.power(0.1, max(heaviest, 1.0))
    operation: dict[str, Any] = {"axial_load": f"{axial:.9g} N", "inner_speed": f"{draw.power(1e-3, 2e3):.9g} rad/s"}
    radial, moment = draw.power(1e-4, 2.0) * axial, draw.power(1e-4, 0.5) * axial * pitch
    operation |= {"tilt": "free"} if draw.chance(0.7) else {}  # loads the balls less alike than a ring held straight
    operation |= {"radial_load": f"{radial:.9g} N"} if draw.chance(0.35) else {}
    operation |= {"moment": f"{moment:.9g} N m"} if draw.chance(0.2) else {}
    down = [float(f"{draw.between(-1, 1):.6g}") for _ in range(3)]
    operation |= {"down": down} if draw.chance(0.5) else {}
    oiled = draw.chance(0.8)
    oil: dict[str, Any] = {
        "viscosity": f"{draw.power(2e-3, 1.0):.9g} Pa s",
        "pressure_viscosity": f"{draw.between(0.8e-8, 3e-8):.9g} 1/Pa",
        "eyring_stress": f"{draw.power(1e6, 15e6):.9g} Pa",
        "limiting_shear": float(f"{draw.between(0.03, 0.1):.6g}"),
        "traction": draw.one_of("eyring_sinh", "eyring_sinh", "eyring_constant"),
        "supply": draw.one_of("oil_bath", "oil_spot", "grease"),
        "compressible": draw.chance(0.2),
    }
    degree = 1 + draw.power(1e-3, 1e2)
    oil |= {"starvation_degree": float(f"{degree:.9g}")} if draw.chance(0.15) else {}
    length, rms = draw.power(10e-6, 200e-6), draw.power(5e-9, 1e-6)
    kind = draw.one_of(*4 * ("gaussian",), "exponential")
    surface: dict[str, Any] = {
        "rms_roughness": f"{rms:.9g} m",
        "autocorrelation": {"kind": kind, "length": f"{length:.9g} m", "spacing": f"{length / 20:.9g} m"},
        "hardness": "7.8 GPa",
        "boundary_friction": float(f"{draw.between(0.05, 0.2):.6g}"),
    }
    law = draw.one_of("elastic", "truncated", "greenwood_williamson")
    surface |= {"gap": law} if law != "greenwood_williamson" else {"gap": "truncated", "asperities": law}
    friction: dict[str, Any] = {"hysteresis_loss": float(f"{draw.power(1e-3, 2e-2):.6g}")}
    friction["spin_rule"] = draw.one_of(*4 * ("free",), "balanced", "inner_control", "outer_control")
    coefficient = float(f"{draw.power(0.003, 0.2):.6g}")
    document = {"name": "drawn", "tolerance": tolerance, "bearing": bearing, "operation": operation}
    if oiled:
        return document | {"lubricant": oil, "surface": surface, "friction": friction}
    document |= {"lubricant": oil} if draw.chance(0.5) else {}
    return document | {"friction": friction | {"coefficient": coefficient}}
