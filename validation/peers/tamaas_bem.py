"""Peer: Tamaas, boundary elements on half spaces by FFT. It shares neither mesh nor method with fembearing.

The refinement is the number of grid points along each side. One elastic half space of modulus E* is pressed against a
rigid paraboloid.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
import tamaas as tm
from numpy.typing import NDArray

from validation.peers.peer import peak_pressure, semi_axis

REACH = 1.1  # half a side of the grid, in semi-axes; just contains the contact
# Residual of the conjugate gradients. With it each worst error is that of a residual of 1e-9 to a quarter, in a third
# to two thirds of its time; with a tenfold residual it is up to ten times as large on the finest grids.
RESIDUALS = {16: 1e-4, 32: 1e-4, 64: 1e-4, 128: 1e-4, 256: 1e-5, 512: 1e-5}  # by the points along a side
tm.set_log_level(tm.LogLevel.error)


def pressed(surface: NDArray, *, sides: Sequence[float], modulus: float, load: float, residual: float) -> list[NDArray]:
    """Pressure, Pa, and displacement, m, of a half space of modulus E*, Pa, under a rigid surface at the grid's points.

    surface : heights, m;  sides : of the grid, m;  residual : of the conjugate gradients
    """
    model = tm.ModelFactory.createModel(tm.model_type.basic_2d, list(sides), list(surface.shape))
    model.E, model.nu = modulus, 0.0  # so that E is E*
    tm.ModelFactory.registerNonPeriodic(model, "half space")
    solver = tm.PolonskyKeerRey(model, surface, residual)
    solver.setIntegralOperator("half space")
    solver.solve(load / (sides[0] * sides[1]))
    # The displacement from the solver is known only up to a constant, so it is computed from the pressure.
    model.operators["half space"](model.traction, model.displacement)
    return [np.array(model.traction), np.array(model.displacement)]


def solve(case: dict[str, Any], points: int) -> dict[str, Any]:
    sides = [2 * REACH * axis for axis in case["semi_axes"]]
    area = sides[0] * sides[1] / points**2  # m^2, of a grid cell
    x, y = np.meshgrid(*(((np.arange(points) + 0.5) / points - 0.5) * side for side in sides), indexing="ij")
    surface = -(case["curvature_x"] * x**2 + case["curvature_y"] * y**2) / 2
    modulus = case["youngs_modulus"] / (2 * (1 - case["poisson_ratio"] ** 2))
    pressure, moved = pressed(surface, sides=sides, modulus=modulus, load=case["load"], residual=RESIDUALS[points])
    axes = semi_axis(x, pressure), semi_axis(y, pressure)
    return {
        "semi_axis_x": axes[0],
        "semi_axis_y": axes[1],
        "peak_pressure": peak_pressure(x, y, pressure, np.full_like(x, area), semi_axes=axes),
        "approach": float(np.average(moved - surface, weights=pressure)),
        "unknowns": points**2,
    }
