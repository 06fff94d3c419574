"""A case as a contact of fembearing, and the quarter of a half space for all finite-element peers.

The peers use our mesh and our far field, so that only the solver differs. A block without a far field, cut off at
thirty contact radii, has an error of 1 % of the approach.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from skfem import Basis, ElementHex2

from analytic.scene import Contact, Material
from fembearing.fem.farfield import pressed_ellipse
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe

Array = NDArray[np.float64]
Nodes = NDArray[np.intp]


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


@dataclass(frozen=True, kw_only=True, eq=False)
class Quarter:
    """The quarter x > 0, y > 0 of a half space z < 0, in hexahedra of 20 nodes in the order of Abaqus."""

    position: Array  # (nodes, 3), m
    cells: Nodes  # (cells, 20): corners, then middles of the edges
    top: NDArray[np.bool_]  # (nodes,) on the surface z = 0
    touching: NDArray[np.bool_]  # (nodes,) may come into contact
    far: NDArray[np.bool_]  # (nodes,) on the outer faces
    displacement: Array  # (nodes, 3), m, of a half space under the case's load; zero off the outer faces

    def contact_faces(self) -> list[tuple[int, int, Nodes]]:
        """Cell, face and its 8 nodes, corners first, of each face that may come into contact."""
        return [
            (cell, face, nodes[[*corners, *middles]])
            for cell, nodes in enumerate(self.cells)
            for face, (corners, middles) in enumerate(zip(FACES, MIDDLES, strict=True))
            if np.all(self.top[nodes[[*corners]]]) and np.any(self.touching[nodes[[*corners]]])
        ]


CORNERS = ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0), (0, 0, 1), (0, 1, 1), (1, 1, 1), (1, 0, 1))  # right-handed here
EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))

FACES = ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
MIDDLES = ((8, 9, 10, 11), (12, 13, 14, 15), (8, 17, 12, 16), (9, 18, 13, 17), (10, 19, 14, 18), (11, 16, 15, 19))


def quarter(case: dict[str, Any], level: int) -> Quarter:
    """The lower half space of our mesh at a level of its recipe."""
    contact, axes = idealised_contact(case), tuple(case["semi_axes"])
    body = pair_mesh(contact, recipe=load_recipe("hertzian"), level=level, semi_axes=axes).lower
    places = [tuple(place) for place in np.rint(2 * ElementHex2().doflocs).astype(int)]
    corners = [tuple(2 * part for part in corner) for corner in CORNERS]
    middles = [tuple((p + q) // 2 for p, q in zip(corners[i], corners[j], strict=True)) for i, j in EDGES]
    chosen = Basis(body.mesh, ElementHex2(), intorder=1).element_dofs[
        [places.index(each) for each in corners + middles]
    ]
    used, numbers = np.unique(chosen, return_inverse=True)
    x, y, z = body.mesh.doflocs[:, used]
    far = np.isin(used, body.far)
    moved = np.zeros((used.size, 3))
    unit = pressed_ellipse(x[far], y[far], -z[far], semi_axes=axes, material=contact.race_material)
    moved[far] = case["load"] * (unit * [[1], [1], [-1]]).T  # its third component points into the body
    return Quarter(
        position=np.column_stack([x, y, z]),
        cells=numbers.reshape(chosen.shape).T,
        top=np.isin(used, body.surface),
        touching=np.isin(used, body.touching),
        far=far,
        displacement=moved,
    )
