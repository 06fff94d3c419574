"""The reach of oil on a race in terms of a paraboloid's: python validation/ehl/effective_reach.py

Far ahead of a contact the bodies are rigid, and Reynolds's equation is linear. A ball in a groove then has the rolling
force of a paraboloid of the same curvatures whose oil reaches as far as X_eff ahead and X_eff/sqrt(lambda) to the
sides. ln(X_eff/X) depends on four ratios of lengths; it is computed for drawn grooves and fitted by a polynomial.
"""

import json
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.linalg import spsolve
from scipy.stats.qmc import Halton

from analytic.scene import Array
from fembearing.ehl.contact import Shape
from fembearing.ehl.grid import Grid, graded_faces
from fembearing.ehl.shape import BallOnRace, Paraboloid
from validation.study import out, run

FIT = Path(__file__).parent / "effective_reach.json"
SEED, COUNT, FRESH = 21, 1200, 200
# r/race radius, 1 - r/groove radius, half width and reach over the ball's radius r
LOWER, UPPER = np.array([-0.45, 0.01, 0.2, 0.3]), np.array([0.6, 1.0, 0.97, 0.97])
CORE = 2e-5  # film in the middle, over R_x: its error is that of both shapes
FINEST, GROWTH = 2e-3, 0.1  # smallest cell over R_x, and growth of cells over the distance
DEGREE = 4  # total, of the polynomial


def faces(ends: list[float], coarser: float) -> Array:
    """Limits of cells from 0 to the last end, one of them at each end."""
    pieces = [
        graded_faces(both, [coarser * (FINEST + GROWTH * each) for each in both], refinement=1.0)
        for both in pairwise([0.0, *ends])
    ]
    return np.unique(np.concatenate(pieces))


def pressure_operator(film: Callable[[Array, Array], Array], grid: Grid) -> csr_array:
    """(n, n) flow by pressure out of each cell, rigid bodies; the pressure is 0 at the ends and at the far side.

    film : at x (columns,) and y (rows,), (columns, rows)
    """
    conductance_x = film(grid.x_faces, grid.y) ** 3 * grid.widths_y[None, :]
    conductance_y = film(grid.x, grid.y_faces) ** 3 * grid.widths_x[:, None]
    conductance_x /= np.diff(np.concatenate([grid.x_faces[:1], grid.x, grid.x_faces[-1:]]))[:, None]
    conductance_y /= np.diff(np.concatenate([grid.y_faces[:1], grid.y, grid.y_faces[-1:]]))[None, :]
    conductance_y[:, 0] = 0.0  # symmetry
    diagonal = conductance_x[1:] + conductance_x[:-1] + conductance_y[:, 1:] + conductance_y[:, :-1]
    number = np.arange(diagonal.size).reshape(diagonal.shape)
    rows, columns, values = [number.ravel()], [number.ravel()], [diagonal.ravel()]
    for first, second, between in (
        (number[:-1], number[1:], conductance_x[1:-1]),
        (number[:, :-1], number[:, 1:], conductance_y[:, 1:-1]),
    ):
        rows += [first.ravel(), second.ravel()]
        columns += [second.ravel(), first.ravel()]
        values += [-between.ravel(), -between.ravel()]
    return csr_array((np.concatenate(values), (np.concatenate(rows), np.concatenate(columns))))


def rigid_force(shape: Shape, grid: Grid, *, ahead: float, side: float) -> float:
    """F^ of rigid bodies in the inlet; lengths over R_x, and the pressure is 0 in the middle and where the oil ends."""
    inside = (grid.x[:, None] < ahead) & (grid.y[None, :] < side)

    def film(x: Array, y: Array) -> Array:
        return CORE + shape.gap(np.minimum(x, ahead)[:, None], np.minimum(y, side)[None, :])

    at = np.flatnonzero(inside)
    rise = np.diff(film(grid.x_faces, grid.y), axis=0) * grid.widths_y[None, :]  # x points ahead
    pressure = spsolve(pressure_operator(film, grid)[at][:, at].tocsc(), rise[inside])
    slope = shape.slope(np.minimum(grid.x, ahead)[:, None], np.minimum(grid.y, side)[None, :])
    return float(6 * (pressure * (slope * grid.areas)[inside]).sum())


def log_ratio(race: float, groove: float, width: float, reach: float) -> float:
    """ln(X_eff/X) of a ball; arguments as in LOWER and UPPER."""
    ball = 1 + race  # its radius over R_x
    true = BallOnRace(
        ball_radius=ball,
        race_radius=ball / race if race else np.inf,
        groove_radius=ball / (1 - groove) if groove < 1 else np.inf,
    )
    ellipticity = true.radii[0] / true.radii[1]
    ahead, side, far = reach * ball, width * ball, reach * ball / ellipticity**0.5
    smooth = Paraboloid(rolling_radius=1.0, transverse_radius=1 / ellipticity)
    slope = 6 * np.pi / ((3 + 2 * ellipticity) * ellipticity**0.5)

    def change(coarser: float) -> float:
        grid = Grid(x_faces=faces([ahead], coarser), y_faces=faces(sorted({side, far}), coarser))
        return rigid_force(true, grid, ahead=ahead, side=side) - rigid_force(smooth, grid, ahead=ahead, side=far)

    return (2 * change(1.0) - change(2.0)) / slope  # the error falls with the size of cells: see the test of its order


def scaled(points: Array) -> Array:
    """(n, 4) -1 to 1: the groove and the width by their logarithms."""
    lower, upper, points = LOWER.copy(), UPPER.copy(), points.copy()
    for each in (lower, upper, points):
        each[..., 1:3] = np.log(each[..., 1:3])
    return (2 * points - lower - upper) / (upper - lower)


def drawn(count: int, seed: int) -> Array:
    """(count, 4) grooves; the second ratio is drawn in its logarithm."""
    unit = Halton(4, seed=seed).random(count)
    points = LOWER + (UPPER - LOWER) * unit
    points[:, 1] = LOWER[1] * (UPPER[1] / LOWER[1]) ** unit[:, 1]
    return points


def main() -> None:
    """Solve, fit, and print the error at fresh grooves."""
    points, fresh = drawn(COUNT, SEED), drawn(FRESH, SEED + 1)
    values = np.array([log_ratio(*each) for each in points])
    each = np.array(list(np.ndindex(*4 * (DEGREE + 1,))))
    terms = each[each.sum(axis=1) <= DEGREE]  # (terms, 4) of the polynomial

    def design(at: Array) -> Array:
        return np.prod(scaled(at)[:, None, :] ** terms[None, :, :], axis=2)

    coefficients, *_ = np.linalg.lstsq(design(points), values, rcond=None)
    error = design(fresh) @ coefficients - np.array([log_ratio(*each) for each in fresh])
    result = {
        "lower": LOWER.tolist(),
        "upper": UPPER.tolist(),
        "powers": terms.tolist(),
        "range_of_values": [float(values.min()), float(values.max())],
        "fresh_rms": float(np.sqrt((error**2).mean())),
        "fresh_largest": float(np.abs(error).max()),
    }
    FIT.write_text(json.dumps(result | {"coefficients": coefficients.tolist()}) + "\n")
    out.print({name: each for name, each in result.items() if name != "powers"})


if __name__ == "__main__":
    run(main)
