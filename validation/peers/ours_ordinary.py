"""Peer in its ordinary workflow: fembearing as `fembearing contact --accuracy` solves a contact.

The refinement is the number of digits of the accuracy: 2 for 1 %, 3 for 0.1 %. The ellipse is not given.
"""

from typing import Any

from validation.peers.peer import Solve, serve


def load() -> Solve:
    from analytic.progress import silent
    from fembearing.check.contact.refinement import solve_reference
    from fembearing.mesh.recipe import load_recipe
    from validation.peers.idealised import idealised_contact

    def solve(case: dict[str, Any], digits: int) -> dict[str, Any]:
        reference = solve_reference(
            idealised_contact(case), recipe=load_recipe("hertzian"), accuracy=10.0**-digits, progress=silent
        )
        values = {name: part.value for name, part in reference.estimates.items()}
        return {
            "semi_axis_x": values["semi_axis_rolling"],
            "semi_axis_y": values["semi_axis_transverse"],
            "peak_pressure": values["peak_pressure"],
            "approach": values["approach"],
            "unknowns": reference.meshes[-1].upper.unknowns,  # of one body; the other is its mirror image
        }

    return solve


if __name__ == "__main__":
    serve(load)
