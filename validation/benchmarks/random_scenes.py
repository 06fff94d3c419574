"""Random scenes within the model's limits: bearings like a 6205 under usual loads, speeds, oils and finishes.

Ranges are wide on purpose: tight to open grooves, dry to full films, creep to 16 000 rpm.
"""

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from analytic.scene import Autocorrelation, ContactAngle, Operation, Scene, Surface
from analytic.scenefile.read import load_scene

CAGE = load_scene("6205-dry").cage
BASE = load_scene(Path(__file__).parents[1] / "scenes" / "6205_physical.toml")
SHOULDER = 3.6e-3  # m, high, so that the contact of an open groove stays on its race
LUBRICATED, THRUST_ONLY = 0.7, 0.6  # shares of the scenes


def random_scene(rng: np.random.Generator) -> Scene:
    """Any scene: friction from oil and finish or given, with or without radial load."""
    friction = of_oil_and_finish(rng) if rng.random() < LUBRICATED else given(rng)
    scene = thrust_scene(rng, **friction)
    if rng.random() < THRUST_ONLY:
        return scene
    radial = scene.operation.axial_load * 10 ** rng.uniform(-3, 0.3)
    return replace(scene, operation=replace(scene.operation, radial_load=radial))


def thrust_scene(rng: np.random.Generator, **friction: Any) -> Scene:
    """One operating point without radial load.

    friction : fields of the scene that set its friction
    """
    bearing = BASE.bearing
    inner, outer = (
        replace(groove, groove_radius=rng.uniform(0.505, 0.56) * bearing.ball_diameter, shoulder_half_width=SHOULDER)
        for groove in (bearing.inner, bearing.outer)
    )
    return replace(
        BASE,
        bearing=replace(bearing, inner=inner, outer=outer),
        contact_angle=ContactAngle(rule="solved", free=rng.uniform(0.05, 0.45)),
        operation=Operation(
            axial_load=np.array([10 ** rng.uniform(1.5, 3.3)]), inner_speed=np.array([10 ** rng.uniform(-0.5, 3.2)])
        ),
        spin_rule=str(rng.choice(["balanced", "inner_control", "outer_control"])),  # pyright: ignore[reportArgumentType]
        **friction,
    )


def of_oil_and_finish(rng: np.random.Generator) -> dict[str, Any]:
    oil, length = BASE.lubricant, 10 ** rng.uniform(-4.7, -3.7)
    return {
        "lubricant": replace(
            oil,
            viscosity=10 ** rng.uniform(-2.3, -0.6),
            eyring_stress=10 ** rng.uniform(6, 7.2),
            limiting_shear=rng.uniform(0.04, 0.1),
            traction=str(rng.choice(["eyring_sinh", "eyring_constant"])),  # pyright: ignore[reportArgumentType]
        ),
        "surface": Surface(
            rms_roughness=10 ** rng.uniform(-8, -6),
            autocorrelation=Autocorrelation(kind="gaussian", length=length, spacing=length / 20),
            hardness=7.8e9,
        ),
    }


def given(rng: np.random.Generator) -> dict[str, Any]:
    """Friction by a coefficient, with or without an oil for hydrodynamic rolling."""
    return {
        "lubricant": BASE.lubricant if rng.random() < 0.5 else None,
        "surface": None,
        "friction_coefficient": 10 ** rng.uniform(-2.3, -0.9),
    }


def with_cage(rng: np.random.Generator, scene: Scene) -> Scene:
    """The same scene with a cage: tight to loose, light to heavy, with any start."""
    pocket = scene.bearing.ball_diameter + rng.uniform(0.08e-3, 0.4e-3)
    cage = replace(
        CAGE,
        pocket_diameter=pocket,
        pocket_depth=pocket / 2,
        mass=CAGE.mass * 10 ** rng.uniform(-0.7, 0.3),
        restitution=rng.uniform(0.4, 0.95),
        start=str(rng.choice(["rest", "ramp", "sudden", "whirl"])),  # pyright: ignore[reportArgumentType]
        gravity=str(rng.choice(["across", "along", "off"])),  # pyright: ignore[reportArgumentType]
        friction_coefficient=10 ** rng.uniform(-2, -0.6),
    )
    return replace(scene, cage=cage)
