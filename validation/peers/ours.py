"""Peer: fembearing's own finite elements on the Hertzian idealisation. Refinement: level of the mesh recipe."""

from typing import Any

from peer import Solve, serve


def load() -> Solve:
    from fembearing.fem.solution import solve_on_mesh
    from fembearing.mesh.recipe import load_recipe
    from idealised import idealised_contact

    def solve(case: dict[str, Any], level: int) -> dict[str, Any]:
        found = solve_on_mesh(
            idealised_contact(case), recipe=load_recipe("hertzian"), level=level, semi_axes=tuple(case["semi_axes"])
        )
        return {
            "semi_axis_x": found.quantities.semi_axis_rolling,
            "semi_axis_y": found.quantities.semi_axis_transverse,
            "peak_pressure": found.quantities.peak_pressure,
            "approach": found.quantities.approach,
            "unknowns": found.unknowns,
        }

    return solve


if __name__ == "__main__":
    serve(load)
