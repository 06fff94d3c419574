"""Peer: the finite elements of fembearing on the Hertzian idealisation. The refinement is the level of the recipe.

The other finite-element peers use our mesh and our far field, so that only the solver differs. A block without a far
field, cut off at thirty contact radii, has an error of 1 % of the approach.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from skfem import Basis, ElementHex2

from analytic.scene import Contact, Material
from fembearing.fem.solution import solve_on_mesh
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe

CORNERS = ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0), (0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1))  # right-handed here
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))  # by corners


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


@dataclass(frozen=True, kw_only=True, eq=False)
class Quarter:
    """The quarter x > 0, y > 0 of a half space z < 0, in hexahedra of 20 nodes in the order of Abaqus."""

    position: NDArray[np.float64]  # (nodes, 3), m
    cells: NDArray[np.intp]  # (cells, 20): corners, then middles of the edges
    top: NDArray[np.bool_]  # (nodes,) on the surface z = 0
    touching: NDArray[np.bool_]  # (nodes,) may come into contact
    far: NDArray[np.bool_]  # (nodes,) on the outer faces


def quarter(case: dict[str, Any], level: int) -> Quarter:
    """The lower half space of our mesh at a level of its recipe."""
    recipe, axes = load_recipe("hertzian"), tuple(case["semi_axes"])
    body = pair_mesh(idealised_contact(case), recipe=recipe, level=level, semi_axes=axes).lower
    corners = np.array(CORNERS)
    places = np.vstack([corners, corners[list(EDGES)].mean(axis=1)]).tolist()
    order = [ElementHex2().doflocs.tolist().index(place) for place in places]
    used, cells = np.unique(Basis(body.mesh, ElementHex2(), intorder=1).element_dofs[order].T, return_inverse=True)
    return Quarter(
        position=body.mesh.doflocs[:, used].T,
        cells=cells.reshape(-1, len(order)),
        top=np.isin(used, body.surface),
        touching=np.isin(used, body.touching),
        far=np.isin(used, body.far),
    )
