"""Rolling force of a ball that rolls in oil a gap off its race: python validation/ehl/wide_gap.py

Reynolds's equation for rigid bodies and oil of constant viscosity, pure rolling, pressure of at least 0, oil up to 0.9
of the ball's radius and between the shoulders, true circles of ball and race. Both races of bearings of the catalogue;
writes wide_gap.csv with the formula of production, and prints its error.
"""

from itertools import pairwise
from pathlib import Path

import numpy as np
from scipy.sparse.linalg import spsolve

from analytic.contact.geometry import RACES, Race
from analytic.errors import ConvergenceError
from analytic.oil.ehl_fit import UNKNOWN_WIDTH, effective_reach, gap_force
from analytic.scene import Array, Bearing
from analytic.scenefile.read import load_scene
from fembearing.ehl.contact import Shape
from fembearing.ehl.grid import Grid, graded_faces
from fembearing.ehl.shape import BallOnRace
from validation.ehl.effective_reach import pressure_operator
from validation.study import out, run, write

TABLE = Path(__file__).parent / "wide_gap.csv"
COLUMNS = ("bearing", "race", "ratio_of_radii", "gap_over_Rx", "force", "change_by_cells", "formula")
DESIGNATIONS = ("625", "6004", "6204", "6205", "6209", "6310", "7206 B")
GAPS = (1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2)  # over R_x
REACH, WIDEST = 0.9, 0.98  # of the oil, over the ball's radius: ahead, and to the sides at most
SMALLEST, GROWTH = 0.12, 0.07  # cells over the length at which the gap has doubled, and growth over the distance
OUTLET = 5.0  # lengths at which the gap has doubled: the oil breaks within one
MOST_ROUNDS = 60


def force_at(shape: Shape, gap: float, *, reach: float, side: float, coarser: float = 1.0) -> float:
    """f/(eta u R_x) on each surface; lengths over R_x. Raises ConvergenceError for an active set that does not settle.

    reach, side : of the oil, ahead and behind, and to each side;  coarser : factor on the cells
    """
    doubled = (2 * gap) ** 0.5
    across = doubled * (shape.radii[1] / shape.radii[0]) ** 0.5

    def faces(ends: tuple[float, ...], length: float) -> Array:
        pieces = [
            graded_faces(both, [coarser * (SMALLEST * length + GROWTH * abs(each)) for each in both], refinement=1.0)
            for both in pairwise(ends)
        ]
        return np.unique(np.concatenate(pieces))

    grid = Grid(
        x_faces=faces((-min(reach, OUTLET * doubled), 0.0, reach), doubled),
        y_faces=faces((0.0, side), min(across, side)),
    )

    def film(x: Array, y: Array) -> Array:
        return gap + shape.gap(x[:, None], y[None, :])

    operator = pressure_operator(film, grid)
    rise = 12 * (np.diff(film(grid.x_faces, grid.y), axis=0) * grid.widths_y[None, :]).ravel()  # x points ahead
    filled, pressure = np.repeat(grid.x > 0, grid.y.size), np.zeros(rise.size)
    changes = 0
    for _ in range(MOST_ROUNDS):
        at = np.flatnonzero(filled)
        pressure[:] = 0.0
        pressure[at] = spsolve(operator[at][:, at].tocsc(), rise[at])
        after = np.where(filled, pressure > 0, operator @ pressure < rise)
        changes = np.count_nonzero(after != filled)
        if not changes:
            slope = shape.slope(grid.x[:, None], grid.y[None, :])
            return float((pressure.reshape(grid.shape) * slope * grid.areas).sum())  # both halves of half of it
        filled = after
    raise ConvergenceError(
        iterations=MOST_ROUNDS,
        residual=float(changes),
        tolerance=0.0,
        unit="cells",
        problem="the oil behind a ball off its race",
        remedy="Give coarser cells, or a wider gap.",
    )


def extrapolated(shape: Shape, gap: float, *, reach: float, side: float) -> tuple[float, float]:
    """The force on cells of size 0, whose error goes with their size, and the change by it."""
    coarse, fine = (force_at(shape, gap, reach=reach, side=side, coarser=each) for each in (2.0, 1.0))
    return 2 * fine - coarse, abs(fine - coarse)


def ball_on(bearing: Bearing, race: Race) -> tuple[BallOnRace, float, float]:
    """Shape, reach and side of the oil, over R_x."""
    ball, groove, sign = bearing.ball_radius, getattr(bearing, race), 1 if race == "inner" else -1
    rolling = 1 / (1 / ball + sign / groove.bottom_radius)
    near, far = groove.half_widths
    width = UNKNOWN_WIDTH * ball if near is None or far is None else (near + far) / 2
    shape = BallOnRace(
        ball_radius=ball / rolling,
        race_radius=sign * groove.bottom_radius / rolling,
        groove_radius=groove.groove_radius / rolling,
    )
    return shape, REACH * ball / rolling, min(width, WIDEST * ball) / rolling


def formula(bearing: Bearing, race: Race, shape: BallOnRace, gap: float) -> float:
    """f/(eta u R_x) of production."""
    rolling, transverse = shape.radii
    size = bearing.ball_radius / shape.ball_radius  # R_x, m
    ahead = effective_reach(bearing, race, reach=REACH, contact_angle=0.0)
    return float(gap_force(1.0, size, rolling / transverse, gap * size, ahead)) / size


def main() -> None:
    rows = []
    for designation in DESIGNATIONS:
        bearing = load_scene(designation).bearing
        for race in RACES:
            shape, reach, side = ball_on(bearing, race)
            for gap in GAPS:
                force, change = extrapolated(shape, gap, reach=reach, side=side)
                ours = formula(bearing, race, shape, gap)
                numbers = (shape.radii[1] / shape.radii[0], gap, force, change, ours)
                rows.append(dict(zip(COLUMNS, (designation, race, *numbers), strict=True)))
    write(rows, TABLE, COLUMNS, form=".5g")
    errors = np.array([row["formula"] / row["force"] - 1 for row in rows])
    out.print(f"formula over numerical solution - 1: {errors.min():+.1%} to {errors.max():+.1%}, {errors.size} gaps")
    out.print(f"rms {np.sqrt(np.mean(errors**2)):.1%}")


if __name__ == "__main__":
    run(main)
