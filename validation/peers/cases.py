"""The contacts that all peers compute. Standard library only, see `run.py`."""

from dataclasses import dataclass
from math import cos

STEEL = (206e9, 0.3)  # E, Pa, and nu of both bodies


@dataclass(frozen=True, kw_only=True)
class Case:
    """Two half spaces of one material whose undeformed gap is curvature_x x^2/2 + curvature_y y^2/2."""

    name: str
    title: str
    curvature_x: float  # 1/m, rolling
    curvature_y: float  # 1/m, transverse
    load: float  # N
    semi_axes: tuple[float, float]  # m, in x and y, to 1 %; every peer sizes its mesh by them
    youngs_modulus: float = STEEL[0]  # Pa
    poisson_ratio: float = STEEL[1]


BALL, GROOVE, PITCH = 3.97e-3, 4.13e-3, 39.01e-3  # m: ball and inner groove radius, pitch diameter of the 6205
ANGLE = 0.18  # rad, contact angle
ROLLING = 1 / BALL + cos(ANGLE) / (PITCH / 2 - BALL * cos(ANGLE))  # 1/m

CASES = {
    case.name: case
    for case in (
        Case(
            name="sphere",
            title="sphere of 3.97 mm on a flat, 51 N",
            curvature_x=1 / BALL,
            curvature_y=1 / BALL,
            load=51.0,
            semi_axes=(0.110e-3, 0.110e-3),
        ),
        Case(
            name="ellipse",
            title="6205, ball on inner race, 620.63 N",
            curvature_x=ROLLING,
            curvature_y=1 / BALL - 1 / GROOVE,
            load=620.63,
            semi_axes=(0.121e-3, 1.12e-3),
        ),
    )
}
