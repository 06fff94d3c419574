"""A contact's meshes as they are drawn: whole from their quarter or half, in mm, with their loaded faces and edges.

It runs in the process of `fembearing.report.pictures.render`. Frame of the meshes: z along the load into the ball, x
along rolling, y transverse.
"""

from typing import Any

import numpy as np
import pyvista as pv

MM = 1e3
COLOURS, INK, HERTZ, LINES, SHOULDER = "viridis", "black", "red", "dimgrey", "darkorange"
BODIES = {"upper": "lightsteelblue", "lower": "wheat"}
LEAST_SHOWN = 0.005  # of the peak pressure: below, a surface is bare
STEEP = np.array([-0.40, 0.10, 0.91])  # towards the eye: from there no contact is a sliver
ON_PLANE = 1e-9  # mm: round-off; the next nodes are a thousandth of a contact away
ROUND = 3  # subdivisions that draw a quadratic cell's face as the curve it is
# Of VTK's triquadratic hexahedron: the ends of each edge with its middle, and the edges around each face.
EDGES = np.array(
    [
        *((0, 1, 8), (1, 2, 9), (2, 3, 10), (3, 0, 11)),
        *((4, 5, 12), (5, 6, 13), (6, 7, 14), (7, 4, 15)),
        *((0, 4, 16), (1, 5, 17), (2, 6, 18), (3, 7, 19)),
    ]
)
FACES = np.array([(8, 7, 11, 3), (9, 5, 10, 1), (8, 4, 9, 0), (10, 2, 11, 6), (0, 1, 2, 3), (4, 5, 6, 7)])
CENTRES = slice(20, 26)  # its nodes in the middle of each face
MIDDLE = 26  # and of itself
NODES = 27


def scaled(path: str, job: dict[str, Any]) -> pv.UnstructuredGrid:
    """A quarter or a half of a body in mm, its pressure in the unit of the picture."""
    body = pv.read(path)
    body.points *= MM
    body.points[np.abs(body.points) < ON_PLANE] = 0.0  # where a node meets its mirror image, and is one with it
    body.point_data["pressure"] *= job["factor"]
    body.point_data["surface"] = body.point_data["surface"].astype(float)  # VTK rounds what it interpolates in integers
    return body


def across(job: dict[str, Any]) -> tuple[int, ...]:
    """The axis across the contact, where the meshes end in a plane of symmetry."""
    return () if job["half"] else (1,)


def mirrored(mesh: pv.DataSet, axes: tuple[int, ...]) -> pv.DataSet:
    """A mesh with its mirror images across the planes normal to these axes."""
    for axis in axes:
        mesh = mesh.merge(mesh.reflect(np.eye(3)[axis], point=(0, 0, 0)))
    return mesh


def loaded_face(body: pv.DataSet) -> pv.PolyData:
    """The faces whose nodes all lie on the loaded surface."""
    face = body.extract_surface(nonlinear_subdivision=ROUND, algorithm="dataset_surface")
    loaded = face.threshold(0.999, scalars="surface", all_scalars=True)
    return loaded.extract_surface(algorithm="dataset_surface")


def outer_faces(body: pv.DataSet, *, loaded: bool = False) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The nodes of the outer faces; only of those loaded.

    Gives the edges around each face, (faces, 4, 3), two ends and the middle of each; its centre, (faces,); and the
    middle of its cell, (faces,).
    """
    cells = pv.UnstructuredGrid(body).cell_connectivity.reshape(-1, NODES)
    centres, count = np.unique(cells[:, CENTRES], return_counts=True)
    outer = np.isin(cells[:, CENTRES], centres[count == 1])
    if loaded:
        outer &= (body.point_data["surface"][cells[:, EDGES[FACES]]] == 1).all(axis=(2, 3))
    return cells[:, EDGES[FACES]][outer], cells[:, CENTRES][outer], cells[np.nonzero(outer)[0], MIDDLE]


def distinct_edges(edges: np.ndarray) -> np.ndarray:
    """(edges, 3), each once, known by its middle."""
    edges = edges.reshape(-1, 3)
    return edges[np.unique(edges[:, 2], return_index=True)[1]]


def cell_edges(body: pv.DataSet, *, loaded: bool = False) -> pv.PolyData:
    """The edges of the outer faces as the curves they are, as finely divided as the faces; only of those loaded."""
    edges = distinct_edges(outer_faces(body, loaded=loaded)[0])
    curves = pv.UnstructuredGrid({pv.CellType.QUADRATIC_EDGE: edges}, body.points)
    return curves.extract_surface(nonlinear_subdivision=ROUND, algorithm="dataset_surface")
