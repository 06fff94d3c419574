"""Free balls that turn steadily in more than one way, by how the bearing came to its speed."""

import numpy as np

from analytic.loads.inertia import outward_force
from analytic.scene import Array
from analytic.solve.model import Model, workspace
from analytic.solve.solution import Solution, solved

# Speeds over that of a point at which a bearing comes there: from below and from above
RUNS = tuple(np.geomspace(first, 1.0, 4) for first in (0.5, 2.0))


def other_states(model: Model, points: Array, found: Solution) -> Array:
    """(n,) race torque of the points as a warm start finds it, the farthest from the cold one, N m; NaN: not sought.

    points : (n, 5);  found : at these
    Several speeds of a ball's orbit are steady where centrifugal force presses it harder than the rings do, or the oil
    resists it more than friction drives it. Such a point is solved from half its speed and from twice its speed, in
    steps that begin where the balls were.
    """
    bearing, balls, other = model.numbers.ring.bearing, found.balls, np.full(len(points), np.nan)
    orbit = balls["motion"]["cage_speed"] * points[:, 3:4]
    outward = np.mean(outward_force(bearing.ball_mass, bearing.pitch_diameter, orbit), axis=1)
    pressed_out = model.numbers.counted.centrifugal & (outward >= balls["load"][..., 0].mean(axis=1))
    race = found.race_torque
    for i in map(int, np.flatnonzero((pressed_out | (found.sliding_number.max(axis=0) > 1)) & (race > 0))):
        warm = model.at(np.array([i])).with_numbers(cold=False, level=int(found.points["level"][i]), allowed=np.inf)
        for run in RUNS:
            work, end = workspace(warm), found
            for share in run:
                point = points[[i]].copy()
                point[0, 3] *= share
                end = solved(warm, point, work=work)
            torque = end.race_torque[0]
            if np.isnan(other[i]) or abs(torque - race[i]) > abs(other[i] - race[i]):
                other[i] = torque
    return other
