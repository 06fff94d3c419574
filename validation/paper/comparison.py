"""Three readings of [Paper] and how far each is from its numbers and conclusions.

Every reading has a friction torque, in which the cage counts with the power of its sliding. The friction moments about
the balls' centres, which are no loss, are compared with the paper's cage torque beside it.
"""

import tomllib
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import deformed_radius
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import Array, Groove, Scene
from analytic.scenefile.read import load_scene
from analytic.sliding.as_printed import as_printed_moments
from analytic.sliding.long_ellipse import FULL_SPIN, microslip_moments
from analytic.torque import friction_torque
from validation.paper.cage import COEFFICIENTS, FASTEST, ROUGH, RPM, SLOWEST, SMOOTH, at_finish, cage_at, cage_scene
from validation.study import SCENES as FILES
from validation.study import published as published_rows

WORDS_OF_PAGE = tomllib.loads(Path(__file__).with_name("words.toml").read_text("utf-8"))
SCENES = {  # reading -> file; words.toml describes it
    "as printed": "6205_paper_as_printed.toml",
    "calibrated": "6205_paper_calibrated.toml",
    "physical": "6205_physical.toml",
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
ASIDE = 1e-6  # relative distance of both sides from a jump, in load or ratio
DIRECTIONS = {"rises": 1, "flat": 0, "falls": -1}
FLAT = 0.1  # relative, lowest to highest value: "minimal impact" or "almost constant" in the paper

Series = Mapping[str, Array]  # over speed, SI, each (n,)
Stored = dict[str, Any]  # of paper.json


def published() -> list[Stored]:
    """The numbers from the paper, SI."""
    return [
        {
            "quantity": row["quantity"],
            "rms_roughness": float(row["rms_roughness_um"]) * 1e-6,
            "inner_speed": float(row["inner_speed_rpm"]) * RPM,
            "value": float(row["value"]) * UNITS[row["unit"]],
            "note": row["note"],  # "printed" or "about"
        }
        for row in published_rows("paper_torque.csv")
    ]


def load(name: str) -> Scene:
    return load_scene(FILES / SCENES[name])


def compare(name: str) -> Stored:
    """One scene beside the paper; its series by Sq, m."""
    scene = load(name)
    found = {roughness: series(name, at_finish(scene, roughness)) for roughness in (ROUGH, SMOOTH)}
    return {
        "name": name,
        "kind": WORDS_OF_PAGE["readings"][name],
        "assumed": assumed_inputs(name, scene),
        "series": {f"{roughness:g}": values for roughness, values in found.items()},
        "beside": [row for point in published() for row in beside(point, found[point["rms_roughness"]])],
        "trends": list(trends(found[ROUGH], found[SMOOTH])),
    }


def series(name: str, scene: Scene) -> Series:
    """All quantities of a reading at one finish over the speeds of its scene."""
    races = friction_torque(scene)
    inner, outer = races.friction_coefficient.inner, races.friction_coefficient.outer
    assert inner is not None
    assert outer is not None
    speeds, race = scene.operation.inner_speed, races.torque.race
    points = [cage_at(cage_scene(name, scene, inner_speed=float(speed))) for speed in speeds]
    cage = {quantity: np.array([point[quantity] for point in points]) for quantity in points[0]}
    return {
        "inner_speed": speeds,
        "race_torque": race,
        "inner_coefficient": inner,
        "outer_coefficient": outer,
        **cage,
        "total_torque": race + cage["cage_torque"],
        "total_with_moments": race + cage["cage_moments"],
    }


def beside(point: Stored, values: Series) -> Iterator[Stored]:
    """The reading at a point of the paper; a torque of the cage counts as a power, and then as friction moments."""
    for name in filter(None, (point["quantity"], MOMENTS.get(point["quantity"]))):
        computed = float(np.interp(point["inner_speed"], values["inner_speed"], values[name]))
        yield {"point": point, "ours": name, "computed": computed, "deviation": computed / point["value"] - 1}


def trends(rough: Series, smooth: Series) -> Iterator[Stored]:
    """The conclusions of the paper, in its order."""
    for claim, rule, names, finishes in WORDS_OF_PAGE["trends"]:
        if rule == "rougher":
            parts = [_rougher_is_more(rough, smooth, name) for name in names]
        else:
            some = {"both": (rough, smooth), "rough": (rough,), "smooth": (smooth,)}[finishes]
            parts = [_change(one[name], DIRECTIONS[rule]) for one in some for name in names]
        yield {"claim": claim, "held": all(held for held, _ in parts), "detail": "; ".join(words for _, words in parts)}


def _change(values: Array, direction: int) -> tuple[bool, str]:
    """Whether the values rise (1) or fall (-1) from each speed to the next, or are flat (0), and by how much."""
    held = np.ptp(values) <= FLAT * values.min() if direction == 0 else np.all(direction * np.diff(values) > 0)
    ratio = values[-1] / values[0]
    return bool(held), f"{100 * (ratio - 1):+.1f} %" if ratio < 2 else f"{ratio:.3g} times"


def _rougher_is_more(rough: Series, smooth: Series, quantity: str) -> tuple[bool, str]:
    ratio = rough[quantity] / smooth[quantity]
    return bool(np.all(ratio > 1)), f"{ratio.min():.2f} to {ratio.max():.2f} times"


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
    ours = {
        "balls": bearing.ball_count,
        "ball": bearing.ball_mass * 1e3,  # g
        "steel": bearing.ball_material.density * 4 / 3 * np.pi * bearing.ball_radius**3 * 1e3,  # g, by its volume
        "cage": scene.cage.mass * 1e3,
        "diameter": bearing.ball_diameter * 1e3,  # mm
        "inner": bearing.inner.bottom_radius * 1e3,
        "outer": bearing.outer.bottom_radius * 1e3,
        "inner_groove": bearing.inner.groove_radius * 1e3,
        "outer_groove": bearing.outer.groove_radius * 1e3,
        "chord": bearing.pitch_diameter * np.sin(np.pi / bearing.ball_count) * 1e3,
    }
    return [(name, paper, words.format(**ours)) for name, paper, words in WORDS_OF_PAGE["table_1"]]


def printed_jumps(scene: Scene) -> list[Stored]:
    """Both sides of a spin-to-roll ratio where equations 2 to 7 as printed jump, and the derived ones do not; SI.

    At the scene's first speed: moments of one contact, N m, and the torque of the bearing. Below and above; at a ratio
    of 0, at it and above.
    """
    first = scene.operation.as_series().at(np.array([0]))
    scene = replace(scene, operation=replace(first, radial_load=0.0, moment=0.0))
    found, bearing, jumps = friction_torque(scene), scene.bearing, []

    def add(where: str, quantity: str, printed: ArrayLike, derived: ArrayLike) -> None:
        sides = {name: np.asarray(values).tolist() for name, values in (("printed", printed), ("derived", derived))}
        jumps.append({"where": where, "quantity": quantity, **sides})

    def surface(groove: Groove) -> Array:
        return deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter)

    outer = {
        "friction_force": found.friction_coefficient.outer[0] * found.ball_load[0],
        "semi_axis_transverse": found.outer.semi_axis_transverse[0],
    }
    for where, ratios in (("ratio 0", (0.0, ASIDE)), ("ratio 1/2", (FULL_SPIN - ASIDE, FULL_SPIN))):
        printed = as_printed_moments(**outer, ball_radius=bearing.ball_radius, spin_to_roll=ratios)
        derived = microslip_moments(**outer, deformed_radius=surface(bearing.outer), spin_to_roll=ratios)
        for name, ours, theirs in zip(("M_z", "M_r"), derived, printed, strict=True):
            add(f"outer contact, {where}", name, theirs, ours)
    angle = float(found.contact_angle[0])
    motion = ball_kinematics(1.0, angle, angle, bearing.pitch_diameter, bearing.ball_diameter)
    # With a very small spin the outer contact resists rolling; at a given angle nothing else in the scene changes.
    added = float(bearing.ball_count * jumps[1]["printed"][1] * motion.outer_rolling_rate)
    printed, derived = (
        float(friction_torque(each).torque.total[0]) for each in (scene, replace(scene, microslip="derived"))
    )
    add("bearing, outer ratio 0", "torque", (printed, printed + added), (derived, derived))
    rate = float(motion.spin_difference / motion.inner_rolling_rate)
    ratio = rate * float(surface(bearing.inner)) / found.inner.semi_axis_transverse[0]
    load = float(first.axial_load[0]) * (ratio / FULL_SPIN) ** 3  # b grows as its third root
    both = replace(  # falling load: the ratio rises
        scene.operation,
        axial_load=load * np.array([1 + ASIDE, 1 - ASIDE]),
        inner_speed=np.repeat(first.inner_speed, 2),
    )
    sides = replace(scene, operation=both)
    printed, derived = (friction_torque(each).torque.total for each in (sides, replace(sides, microslip="derived")))
    add(f"bearing, inner ratio 1/2 (at {load:.3g} N)", "torque", printed, derived)
    return jumps
