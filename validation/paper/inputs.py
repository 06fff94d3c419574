"""What the readings of [Paper] take in: its table 1, and inputs that it does not give."""

import numpy as np

from analytic.scene import Scene
from validation.paper.cage import COEFFICIENTS, FASTEST, ROUGH, RPM, SLOWEST, SMOOTH, cage_scene


def assumed_inputs(reading: str, scene: Scene) -> dict[str, str]:
    """Inputs that the paper does not give and the reading assumes, in words; for both finishes."""
    ball, angle, oil, surface = scene.bearing.ball_material, scene.contact_angle, scene.lubricant, scene.surface
    assert surface.autocorrelation is not None
    correlation, hardness = surface.autocorrelation, surface.hardness or ball.hardness or np.nan
    moving = cage_scene(reading, scene, inner_speed=SLOWEST)
    assert moving.cage is not None
    cage, given = moving.cage, moving.contact_angle.rule == "given"
    sphere = cage.pocket_depth == cage.pocket_diameter / 2
    return {
        "0.18 rad, races": f"{'loaded' if angle.rule == 'given' else 'free'} angle",
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
        "cage, pocket": "one sphere" if sphere else f"two shells, {cage.pocket_depth * 1e3:g} mm deep",
        "cage, clearance": f"{(cage.pocket_diameter - scene.bearing.ball_diameter) * 1e3:.3g} mm of the diameter",
        "cage, start": str(cage.start),
        "cage, angle of the balls' axes": "0.18 rad" if given else "loaded angle for 0.18 rad free",
        "cage, ball on pocket": "mixed lubrication" if cage.friction_coefficient is None else _coefficients(),
        "cage, restitution": f"{cage.restitution:g}",
        "cage, stiffness of a pocket": "Hertz" if cage.pocket_stiffness is None else "given",
    }


def _coefficients() -> str:
    speeds = f"from {SLOWEST / RPM:.0f} to {FASTEST / RPM:.0f} rpm"
    pairs = [f"{COEFFICIENTS[sq][0]:g} to {COEFFICIENTS[sq][1]:g} at Sq {sq * 1e6:g} um" for sq in (ROUGH, SMOOTH)]
    return f"{' and '.join(pairs)}, {speeds}"


def table_1(scene: Scene) -> list[tuple[str, str, str]]:
    """Table 1 of [Paper]: parameter, its value there, and what the readings make of it."""
    bearing = scene.bearing
    volume = 4 / 3 * np.pi * bearing.ball_radius**3
    steel = f"{bearing.ball_material.density * volume * 1e3:.2f} g by volume and density"
    chord = bearing.pitch_diameter * np.sin(np.pi / bearing.ball_count)
    return [
        ("number of balls", "9", f"{bearing.ball_count}"),
        ("mass of ball", "2.04 g", f"{bearing.ball_mass * 1e3:g} g; {steel}"),
        ("mass of cage", "6.58 g", f"{scene.cage.mass * 1e3:g} g"),
        ("contact angle", "0.18 rad", "as printed, calibrated: loaded, at the races; physical: free, 0.302 under load"),
        ("ball diameter", "7.94 mm", f"{bearing.ball_diameter * 1e3:g} mm"),
        ("mass of inner race", "38.63 g", "not used: the rings do not move"),
        ("mass of outer race", "54.21 g", "not used: the rings do not move"),
        ("radius of inner race", "15.53 mm", f"{bearing.inner.bottom_radius * 1e3:g} mm, at the groove's bottom"),
        ("radius of outer race", "23.48 mm", f"{bearing.outer.bottom_radius * 1e3:g} mm, at the groove's bottom"),
        ("groove radius of inner race", "4.13 mm", f"{bearing.inner.groove_radius * 1e3:g} mm"),
        ("groove radius of outer race", "4.21 mm", f"{bearing.outer.groove_radius * 1e3:g} mm"),
        ("pocket diameter", "13.9 mm", "as printed: the same, although neighbouring pockets would overlap: their "
         f"centres are {chord * 1e3:.2f} mm apart; calibrated: 8.04 mm; physical: 8.14 mm"),
        ("pocket depth", "6.81 mm", "as printed: the same; else half the diameter"),
    ]  # fmt: skip
