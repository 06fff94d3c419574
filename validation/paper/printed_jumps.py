"""The jumps of equations 2 to 7 of [Paper], as printed, where one case follows another."""

from dataclasses import dataclass, replace

import numpy as np

from analytic.contact.rolling_contact import deformed_radius
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import Array, Scene
from analytic.sliding.as_printed import as_printed_moments
from analytic.sliding.long_ellipse import FULL_SPIN, microslip_moments
from analytic.torque import friction_torque

ASIDE = 1e-6  # relative distance of both sides from a jump, in load or ratio


@dataclass(frozen=True, kw_only=True)
class Jump:
    """Values on both sides of a spin-to-roll ratio where the derived equations are continuous; SI."""

    where: str
    quantity: str
    unit: str
    printed: tuple[float, float]  # below and above; at a ratio of 0, at it and above
    derived: tuple[float, float]


def printed_jumps(scene: Scene) -> list[Jump]:
    """At the scene's first speed: moments of one contact, N m, and the torque of the bearing."""
    scene = replace(scene, operation=replace(scene.operation, axial_load=scene.operation.axial_load[:1],
                                             inner_speed=scene.operation.inner_speed[:1],
                                             radial_load=0.0, moment=0.0))  # fmt: skip
    found, bearing = friction_torque(scene), scene.bearing
    outer_coefficient = found.friction_coefficient.outer
    outer = {
        "friction_force": outer_coefficient[0] * found.ball_load[0],
        "semi_axis_transverse": found.outer.semi_axis_transverse[0],
    }
    surface = deformed_radius(groove_radius=bearing.outer.groove_radius, ball_diameter=bearing.ball_diameter)
    jumps = []
    for where, ratios in (
        ("outer contact, ratio 0", (0.0, ASIDE)),
        ("outer contact, ratio 1/2", (FULL_SPIN - ASIDE, FULL_SPIN)),
    ):
        printed = as_printed_moments(**outer, ball_radius=bearing.ball_radius, spin_to_roll=ratios)
        derived = microslip_moments(**outer, deformed_radius=surface, spin_to_roll=ratios)
        for name, ours, theirs in zip(("M_z", "M_r"), derived, printed, strict=True):
            jumps.append(Jump(where=where, quantity=name, unit="N mm", printed=_pair(theirs), derived=_pair(ours)))
    angle = float(found.contact_angle[0])
    motion = ball_kinematics(1.0, angle, angle, bearing.pitch_diameter, bearing.ball_diameter)
    # With a very small spin the outer contact resists rolling; at a given angle nothing else in the scene changes.
    added = float(bearing.ball_count * jumps[1].printed[1] * motion.outer_rolling_rate)
    derived = float(friction_torque(replace(scene, microslip="derived")).torque.total[0])
    printed = float(found.torque.total[0])
    whole = {"quantity": "torque", "unit": "N mm"}
    beside = {"printed": (printed, printed + added), "derived": (derived, derived)}
    jumps.append(Jump(where="bearing, outer ratio 0", **whole, **beside))
    rate = float((motion.spin_difference / motion.inner_rolling_rate)[0])
    surface = deformed_radius(groove_radius=bearing.inner.groove_radius, ball_diameter=bearing.ball_diameter)
    ratio = rate * float(surface) / found.inner.semi_axis_transverse[0]
    load = float(scene.operation.axial_load[0]) * (ratio / FULL_SPIN) ** 3  # b grows as its third root
    sides = replace(  # falling load: the ratio rises
        scene,
        operation=replace(
            scene.operation,
            axial_load=load * np.array([1 + ASIDE, 1 - ASIDE]),
            inner_speed=np.repeat(scene.operation.inner_speed, 2),
        ),
    )
    beside = {"printed": sides, "derived": replace(sides, microslip="derived")}
    beside = {name: _pair(friction_torque(each).torque.total) for name, each in beside.items()}
    return [*jumps, Jump(where=f"bearing, inner ratio 1/2 (at {load:.3g} N)", **whole, **beside)]


def _pair(values: Array) -> tuple[float, float]:
    return float(values[0]), float(values[1])
