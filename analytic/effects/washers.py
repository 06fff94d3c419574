"""What the balls' own forces can do in a thrust bearing, which is computed with them in the middle of their grooves."""

from collections.abc import Mapping

import numpy as np

from analytic.effects.ledger import share_in
from analytic.scene import Array, Scene
from analytic.solve.solution import Solution

HELD = ("centrifugal", "weight")  # effects whose bound in a thrust bearing is part of the uncertainty
# Power of the load with which a part of the torque goes at most. Boundary friction: moments as load times width.
# Rolling: the width alone.
LOAD_POWER = {"spin": 4 / 3, "conformity": 5 / 3, "hysteresis": 4 / 3, "rolling": 1 / 3}


def held_in_the_middle(scene: Scene, found: Solution, *, parts: Mapping[str, Array], total: Array) -> Array:
    """(n,) uncertainty of the torque of a thrust bearing by centrifugal force and weight, relative; else 0.

    parts, total : of the torque, (n,), N m
    Centrifugal force F_c is carried by contacts that lean outwards by p = F_c/(2 Q) on both washers. The ball's own
    rotation, d_m/D times as fast as the spin w/2, then turns about the normals by its share p: the spin rises by
    p d_m/D, and its loss by twice that at most, where friction grows with slip. All else is of second order.
    The weight m g loads one of both washers more if the axis is upright. If it is level, the weight cancels around the
    bearing. Left out where the scene says off. Derived here.
    """
    bearing = scene.bearing
    if bearing.kind == "radial":
        return np.zeros_like(total)
    outward, weight = found.points["centrifugal_share"], found.points["weight_share"]
    leaning = outward * bearing.pitch_diameter / bearing.ball_diameter * parts.get("spin", np.zeros_like(total))
    heavier = sum(
        (power / 2 * weight * parts[name] for name, power in LOAD_POWER.items() if name in parts),
        start=np.zeros_like(total),
    )
    wanted = [part for name, part in zip(HELD, (leaning, heavier), strict=True) if scene.effects.get(name) != "off"]
    return share_in(sum(wanted, start=np.zeros_like(total)), total)
