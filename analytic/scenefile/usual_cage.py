"""The cage that a bearing of the catalogue is taken to have: that of the 6205 of [Paper], scaled to its balls."""

import math
from collections.abc import Collection
from typing import Any, Protocol

from analytic.scene import Material, Origin

# Over the ball diameter, of the 6205 of [Paper]: clearance in the pockets; thickness of two steel sheets and of a
# moulded cage; and the width of the sheets that gives their mass of 6.58 g. Each sheet follows the pitch circle and
# half of every ball.
POCKET, SHEET, MOULDED, SHEET_WIDTH = 0.025, 0.113, 0.189, 0.36
WEB = 0.8  # of the web between pockets: the thickest sheet
DENSITY = {"steel": 7850.0, "peek": 1300.0}  # kg/m^3
LIGHT = 2000.0  # kg/m^3: plastics are lighter
PLASTIC = ("plastic", "polyamide", "phenolic")  # in the meaning of a suffix
FRICTION = (
    0.1  # of ball on pocket: below the boundary friction of steel, 0.09 to 0.15, as films carry a part; judgement
)
# Standard deviation of friction times mass over the value, judgement: the torque is in proportion to both.
SPREAD = 0.5
_SIZE = Origin(status="assumed", uncertainty=None, source="cage of the 6205 of [Paper], scaled by the ball diameter")
ORIGINS = {
    **dict.fromkeys(("pocket_clearance", "wall_thickness", "mass"), _SIZE),
    "material": Origin(status="assumed", uncertainty=None, source="by the suffix of the cage; pressed steel without"),
    "friction_coefficient": Origin(
        status="assumed",
        uncertainty=SPREAD * FRICTION,
        source="judgement: boundary friction of steel less what films carry; the spread includes that of the mass",
    ),
}


class Balls(Protocol):
    """What the size of a cage follows from."""

    @property
    def ball_count(self) -> int: ...
    @property
    def ball_diameter(self) -> float: ...  # m
    @property
    def pitch_diameter(self) -> float: ...  # m


def cage_sizes(bearing: Balls, *, material: str) -> dict[str, float]:
    """Pocket clearance and wall thickness, m, and mass, kg, by the keys of [cage]; empty: the balls leave no web.

    material : "steel" of two pressed sheets, "peek" of a moulded cage
    """
    ball, count, pitch = bearing.ball_diameter, bearing.ball_count, bearing.pitch_diameter
    web = pitch * math.sin(math.pi / count) - (1 + POCKET) * ball
    sheet = min((SHEET if material == "steel" else MOULDED) * ball, WEB * web)
    if sheet <= 0:
        return {}
    around = math.pi * pitch + count * (math.pi / 2 - 1) * ball
    mass = DENSITY[material] * 2 * sheet * SHEET_WIDTH * ball * around
    return {"pocket_clearance": POCKET * ball, "wall_thickness": sheet, "mass": mass}


def assumed_cage(bearing: Balls, suffixes: Collection[str], *, material: Material | None = None) -> dict[str, Any]:
    """The same with the name of the material.

    suffixes : meanings of those of the designation: a plastic is moulded; all others count as pressed steel
    material : that is given, in place of the usual one; one as light as a plastic is moulded
    """
    by_suffix = any(word in meaning for meaning in suffixes for word in PLASTIC)
    is_moulded = by_suffix if material is None else material.density < LIGHT
    kind = "peek" if is_moulded else "steel"
    sizes = cage_sizes(bearing, material=kind)
    if sizes and material is not None:
        sizes["mass"] *= material.density / DENSITY[kind]
    return sizes | {"material": kind} if sizes else {}
