"""Peer in its ordinary workflow: Tamaas as its page "Solving contact" teaches, a periodic grid and a residual of 1e-12.

The refinement is the number of grid points along each side. A period is ten times as long as the contact. In a periodic
system the approach is known only against the mean of the surface; it is read so.
"""

from typing import Any

from validation.peers.peer import Solve, peak_pressure, semi_axis, serve

PERIOD = 20  # semi-axes
TOLERANCE = 1e-12


def load() -> Solve:
    import numpy as np
    import tamaas as tm

    tm.set_log_level(tm.LogLevel.error)

    def solve(case: dict[str, Any], points: int) -> dict[str, Any]:
        sides = [PERIOD * axis for axis in case["semi_axes"]]
        model = tm.ModelFactory.createModel(tm.model_type.basic_2d, sides, [points, points])
        model.E, model.nu = case["youngs_modulus"] / (2 * (1 - case["poisson_ratio"] ** 2)), 0.0  # so that E is E*
        x, y = np.meshgrid(*(((np.arange(points) + 0.5) / points - 0.5) * side for side in sides), indexing="ij")
        surface = -(case["curvature_x"] * x**2 + case["curvature_y"] * y**2) / 2
        solver = tm.PolonskyKeerRey(model, surface, TOLERANCE)
        solver.solve(case["load"] / (sides[0] * sides[1]))
        pressure, area = np.array(model.traction), sides[0] * sides[1] / points**2
        axes = semi_axis(x, pressure), semi_axis(y, pressure)
        displacement = np.array(model.displacement)
        return {
            "semi_axis_x": axes[0],
            "semi_axis_y": axes[1],
            "peak_pressure": peak_pressure(x, y, pressure, np.full_like(x, area), semi_axes=axes),
            "approach": float(np.average(displacement - surface, weights=pressure) - displacement.mean()),
            "unknowns": points**2,
        }

    return solve


if __name__ == "__main__":
    serve(load)
