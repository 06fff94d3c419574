"""What the two sides of a groove do to a contact: python validation/correction/sides.py [--fine]

A quarter of a contact is meshed with the nearer shoulder on both sides, and lands parallel to the tangent plane. Here
steel contacts are solved so, and on half of the contact with both sides as they are: unequal shoulders, and lands
parallel to the axis of the bearing, which the contact angle tilts. For each the table has the change of the quantities
from quarter to half, at the angle and without it; then the mean of two quarters, one with each side, over the half.
`--fine` adds the change of the first on the third level. Takes two minutes, with `--fine` ten.
"""

from dataclasses import replace
from typing import Annotated

import numpy as np
import typer

from analytic.scene import Array, Contact
from fembearing.fem.solution import fitted_solution, solve_on_mesh
from fembearing.mesh.footprint import Sides
from fembearing.mesh.recipe import load_recipe
from validation.correction.solve import QUANTITIES, STEEL, contact_of_shape
from validation.study import run, show

# Rolling curvature r/R, contact angle in degrees, size b/r, and both shoulders over r
CASES = (
    (0.25, 0, 0.05, 0.1, 0.85),
    (0.25, 15, 0.1, 0.2, 0.9),
    (-0.17, 15, 0.1, 0.9, 0.28),
    (0.25, 15, 0.2, 0.35, 0.36),
    (0.25, 25, 0.2, 0.5, 0.95),
    (-0.17, 25, 0.3, 0.7, 0.95),
    (0.25, 40, 0.1, 0.15, 0.85),
    (-0.17, 40, 0.1, 0.2, 0.9),
    (0.25, 40, 0.2, 0.35, 0.9),
    (-0.17, 40, 0.13, 0.34, 0.69),
    (-0.17, 40, 0.3, 0.4, 0.9),
)
RECIPE = load_recipe("race")


def main(fine: Annotated[bool, typer.Option(help="The third level too.")] = False) -> None:
    columns = ("half over quarter", "the same at 0 degrees", "mean of two quarters over half")
    heads = ("r/R", "angle", "b/r", "shoulders", *columns, *(("the first, level 3",) if fine else ()))
    rows = []
    for curvature, degrees, size, shoulder, far_shoulder in CASES:
        shape = STEEL | {"conformity": 0.52, "rolling_curvature": curvature, "size": size, "shoulder": shoulder}
        shape |= {"far_shoulder": far_shoulder, "contact_angle": np.radians(degrees)}
        tilted = contact_of_shape(shape)
        flat = replace(tilted, contact_angle=0.0)
        semi_axes = fitted_solution(tilted, recipe=RECIPE).pair.semi_axes
        quarter, half, above, below = (
            solved(tilted, semi_axes, sides=sides) for sides in ("even", "both", "above", "below")
        )
        found = [half / quarter, solved(flat, semi_axes, sides="both") / quarter, (above + below) / 2 / half]
        if fine:
            found.append(solved(tilted, semi_axes, sides="both", level=3) / solved(tilted, semi_axes, level=3))
        words = (", ".join(f"{1e5 * (ratio - 1):.1f}" for ratio in ratios) for ratios in found)
        rows.append((curvature, degrees, size, f"{shoulder:g}, {far_shoulder:g}", *words))
    show(heads, rows, "a, b, peak pressure and approach, changes in 1e-5")


def solved(contact: Contact, semi_axes: tuple[float, float], *, sides: Sides = "even", level: int = 2) -> Array:
    """(4,) semi-axes, peak pressure and approach on one mesh."""
    found = solve_on_mesh(contact, recipe=RECIPE, level=level, semi_axes=semi_axes, sides=sides).quantities
    return np.array([getattr(found, name) for name in QUANTITIES])


if __name__ == "__main__":
    run(main)
