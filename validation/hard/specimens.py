"""What several hard cases share: the 6205 with its contact, its torque and a scene text, and materials."""

import math
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from analytic.contact.geometry import race_contact
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Bearing, Contact, Decision, Material, Operation
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque

LARGE, SMALL, MODULUS = 310.0, 9.7, 1.13e11  # 1/m, 1/m, Pa: a steel ball on the inner race of a small bearing
LOAD = 613.0  # N
ANGLE, BALL_LOAD = 0.18, 620.0  # rad, N: the inner race contact of the 6205
# The limits are those of the textbook formulas, under loads that inertia would exceed at any speed.
AS_HERTZ: dict[str, Decision] = {
    "weight": "off",
    "spin": "on",
    "finite_geometry": "off",
    "centrifugal": "off",
    "gyroscopic": "off",
    "cage": "off",
}
SCENE = """
name = "a scene"
tolerance = "5 %"
[bearing]
catalog = "paper_6205"
contact_angle = {{ rule = "solved" }}
[operation]
axial_load = "{load}"
{speed_key} = "{speed}"
"""
SCENE_6205 = load_scene("6205-dry")  # the built-in one, with a friction coefficient
BEARING = SCENE_6205.bearing
STEEL = BEARING.ball_material
INCOMPRESSIBLE, NEARLY_INCOMPRESSIBLE = (replace(STEEL, poisson_ratio=ratio) for ratio in (0.4999, 0.49))
PEEK = Material(name="peek", youngs_modulus=3.6e9, poisson_ratio=0.38, density=1300.0, source="the catalog's")
CERAMIC = Material(name="Si3N4", youngs_modulus=310e9, poisson_ratio=0.27, density=3200.0, source="the case's")
BRONZE = Material(name="bronze", youngs_modulus=110e9, poisson_ratio=0.34, density=8800.0, source="the case's")


def with_clearance(clearance: float, *, of: Bearing = BEARING) -> Bearing:
    """A bearing, the 6205, with its outer ring opened to a diametral clearance, m; negative is preload."""
    touching = of.inner.bottom_radius + of.ball_diameter
    return replace(of, outer=replace(of.outer, bottom_radius=touching + clearance / 2))


def with_conformity(conformity: float) -> Bearing:
    """The 6205 with both grooves of this conformity, r_g/D."""
    radius = conformity * BEARING.ball_diameter
    inside, outside = (replace(race, groove_radius=radius) for race in (BEARING.inner, BEARING.outer))
    return replace(BEARING, inner=inside, outer=outside)


def of_materials(ball: Material, race: Material) -> Bearing:
    """The 6205 of other materials, its balls as heavy as before."""
    inside, outside = (replace(each, material=race) for each in (BEARING.inner, BEARING.outer))
    return replace(BEARING, ball_material=ball, inner=inside, outer=outside)


def inner(*, load: float = BALL_LOAD, material: Material = STEEL, conformity: float | None = None) -> Contact:
    """The ball on the inner race of the 6205; `material` is that of both bodies, `conformity` is r_g/D."""
    contact = race_contact(BEARING, "inner", contact_angle=ANGLE, ball_load=load)
    contact = replace(contact, ball_material=material, race_material=material)
    return contact if conformity is None else replace(contact, groove_radius=2 * conformity * contact.ball_radius)


def torque_6205(
    *, axial_load: float = 0.0, radial_load: float = 0.0, speed: float = 31.0, **changed: Any
) -> FrictionTorque:
    """Torque of the 6205 under loads, N, at an inner speed, rad/s; `changed` replaces other fields of its scene."""
    operation = Operation(
        axial_load=np.array([axial_load]), inner_speed=np.array([speed]), radial_load=np.array([radial_load])
    )
    return friction_torque(replace(SCENE_6205, operation=operation, effects=AS_HERTZ, **changed))


def parsed(tables: str = "", **entries: str) -> float:
    """The tolerance of a scene file of the 6205 with these entries and further tables."""
    text = SCENE.format(**{"load": "700 N", "speed": "90 rpm", "speed_key": "inner_speed"} | entries)
    return parse_scene(text + tables, origin="scene").tolerance


def exponent(quantity: Callable[[float], float], low: float, high: float) -> float:
    """Exponent of a quantity over the load, N, between two loads."""
    return math.log(quantity(high) / quantity(low)) / math.log(high / low)


@contextmanager
def temporary_file(name: str) -> Iterator[Path]:
    """A path for one case's file. Error messages omit its folder, whose name differs every time."""
    with TemporaryDirectory() as folder:
        try:
            yield Path(folder) / name
        except InputError as refusal:
            raise InputError(str(refusal).replace(f"{folder}{os.sep}", "")) from refusal
