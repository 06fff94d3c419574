"""A radial bearing at one operating point, as a scene file: one number between 0 and 1 for each input."""

from collections.abc import Iterable

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


def radial_scene(place: Iterable[float], *, tolerance: float) -> str:
    """The scene at a place, as a scene file."""
    draw = Draw(place)
    ball = draw.power(3e-3, 30e-3)
    inner, outer = (draw.between(0.505, 0.56) * ball for _ in range(2))
    pitch, clearance = ball * draw.between(3.2, 6.5), ball * draw.power(1e-4, 3e-2)
    bottom = pitch / 2 - ball / 2 - clearance / 4
    shoulder = draw.between(0.38, 0.46) * ball
    balls = int(draw.between(0.5, 0.9) * np.pi * pitch / ball)
    material = draw.one_of("steel", "steel", "silicon_nitride")
    lines = [
        'name = "drawn"',
        f"tolerance = {tolerance:g}",
        "[bearing]",
        'name = "drawn"',
        f"ball_count = {max(balls, 5)}",
        f'ball_diameter = "{ball:.9g} m"',
        f'ball_mass = "{np.pi / 6 * ball**3 * (7800 if material == "steel" else 3200):.9g} kg"',
        f'ball_material = "{material}"',
        f'bore_diameter = "{2 * bottom - ball:.9g} m"',
        f'outside_diameter = "{2 * (bottom + ball + clearance / 2) + ball:.9g} m"',
        f'contact_angle = {{ rule = "solved", free = "{draw.between(0.05, 0.7):.9g} rad" }}',
    ]
    for ring, radius, groove in (("inner", bottom, inner), ("outer", bottom + ball + clearance / 2, outer)):
        lines += [
            f"[bearing.{ring}]",
            f'bottom_radius = "{radius:.9g} m"',
            f'groove_radius = "{groove:.9g} m"',
            f'shoulder_half_width = "{shoulder:.9g} m"',
            'material = "steel"',
        ]
    heaviest = 1e8 * ball**2  # N of thrust: about 2.5 GPa in usual grooves, 4 GPa in open ones
    axial = draw.power(0.1, max(heaviest, 1.0))
    lines += ["[operation]", f'axial_load = "{axial:.9g} N"', f'inner_speed = "{draw.power(1e-3, 2e3):.9g} rad/s"']
    radial, moment = draw.power(1e-4, 2.0) * axial, draw.power(1e-4, 0.5) * axial * pitch
    lines += ['tilt = "free"'] if draw.chance(0.7) else []  # loads the balls less alike than a ring held straight
    lines += [f'radial_load = "{radial:.9g} N"'] if draw.chance(0.35) else []
    lines += [f'moment = "{moment:.9g} N m"'] if draw.chance(0.2) else []
    down = [f"{draw.between(-1, 1):.6g}" for _ in range(3)]
    lines += [f"down = [{', '.join(down)}]"] if draw.chance(0.5) else []
    oiled = draw.chance(0.8)
    oil = [
        "[lubricant]",
        f'viscosity = "{draw.power(2e-3, 1.0):.9g} Pa s"',
        f'pressure_viscosity = "{draw.between(0.8e-8, 3e-8):.9g} 1/Pa"',
        f'eyring_stress = "{draw.power(1e6, 15e6):.9g} Pa"',
        f"limiting_shear = {draw.between(0.03, 0.1):.6g}",
        f'traction = "{draw.one_of("eyring_sinh", "eyring_sinh", "eyring_constant")}"',
        f'supply = "{draw.one_of("oil_bath", "oil_spot", "grease")}"',
        f"compressible = {'true' if draw.chance(0.2) else 'false'}",
    ]
    degree = 1 + draw.power(1e-3, 1e2)
    oil += [f"starvation_degree = {degree:.9g}"] if draw.chance(0.15) else []
    length = draw.power(10e-6, 200e-6)
    surface = [
        "[surface]",
        f'rms_roughness = "{draw.power(5e-9, 1e-6):.9g} m"',
        f'autocorrelation = {{ kind = "{draw.one_of(*4 * ("gaussian",), "exponential")}", length = "{length:.9g} m", '
        f'spacing = "{length / 20:.9g} m" }}',
        'hardness = "7.8 GPa"',
        f"boundary_friction = {draw.between(0.05, 0.2):.6g}",
        draw.one_of('gap = "elastic"', 'gap = "truncated"', 'gap = "truncated"\nasperities = "greenwood_williamson"'),
    ]
    friction = ["[friction]", f"hysteresis_loss = {draw.power(1e-3, 2e-2):.6g}"]
    friction += [f'spin_rule = "{draw.one_of(*4 * ("free",), "balanced", "inner_control", "outer_control")}"']
    coefficient = draw.power(0.003, 0.2)
    if oiled:
        return "\n".join(lines + oil + surface + friction) + "\n"
    return "\n".join([*lines, *(oil if draw.chance(0.5) else []), *friction, f"coefficient = {coefficient:.6g}"]) + "\n"
