"""Peer: the finite elements of fembearing on the Hertzian idealisation. The refinement is the level of the recipe."""

from typing import Any

from fembearing.fem.solution import solve_on_mesh
from fembearing.mesh.recipe import load_recipe
from validation.peers.idealised import idealised_contact


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
