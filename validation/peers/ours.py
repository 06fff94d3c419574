"""Peer: the finite elements of fembearing on the Hertzian idealisation. The refinement is the level of the recipe."""

from typing import Any

from analytic.scene import Contact, Material
from fembearing.fem.solution import solve_on_mesh
from fembearing.mesh.recipe import load_recipe


def idealised_contact(case: dict[str, Any]) -> Contact:
    """A contact with the curvatures of the case; curvature_x must not be below curvature_y."""
    groove = case["curvature_x"] - case["curvature_y"]  # 1/m, of the groove
    steel = Material(
        name="steel",
        youngs_modulus=case["youngs_modulus"],
        poisson_ratio=case["poisson_ratio"],
        density=7850.0,  # kg/m^3, has no effect
        source="case",
    )
    return Contact(
        pair="inner",
        ball_radius=1 / case["curvature_x"],
        groove_radius=1 / groove if groove else float("inf"),
        rolling_radius=float("inf"),
        shoulder=float("inf"),
        far_shoulder=float("inf"),
        contact_angle=0.0,
        load=case["load"],
        ball_material=steel,
        race_material=steel,
    )


def solve(case: dict[str, Any], level: int) -> dict[str, Any]:
    solution = solve_on_mesh(
        idealised_contact(case), recipe=load_recipe("hertzian"), level=level, semi_axes=tuple(case["semi_axes"])
    )
    return {
        "semi_axis_x": solution.quantities.semi_axis_rolling,
        "semi_axis_y": solution.quantities.semi_axis_transverse,
        "peak_pressure": solution.quantities.peak_pressure,
        "approach": solution.quantities.approach,
        "unknowns": solution.upper.unknowns,  # of one body; the other is its mirror image
    }
