"""The numbers of a contact to turn in the browser, `View` of `fembearing.report.page.view`.

It runs in the process of `fembearing.report.pictures.render`; the job is that of `fembearing.report.pictures.draw`.
"""

import base64
from typing import Any

import numpy as np
import pyvista as pv
from matplotlib import colormaps
from matplotlib.colors import to_rgb

from fembearing.report.pictures import render_mesh as mesh

SHADES = 256  # of the colour scale
SHOWN = 1.3, 1.7  # from the middle to the nearer edges at first, in longer and in shorter semi-axes


def contact_view(job: dict[str, Any]) -> dict[str, Any]:
    """The numbers; lengths in mm, pressure in the job's unit."""
    bodies = {side: mesh.mirrored(mesh.scaled(job[side], job), (0, *mesh.across(job))) for side in mesh.BODIES}
    parts = [drawn_body(body, mesh.BODIES[side]) for side, body in bodies.items()]
    shoulders = {np.sign(y): mesh.MM * y for y in job["shoulders"]}
    inks = (mesh.HERTZ, "hertz", 0.0), (mesh.INK, "computed", mesh.MM * job["centroid"])
    return {
        "title": job["title"],
        "unit": job["unit"],
        "peak": job["peak"],
        "ticks": job["ticks"],
        "least": mesh.LEAST_SHOWN * job["peak"],
        "faces": sum(part["faces"] for part in parts),
        "bodies": parts,
        "reach": float(max(np.linalg.norm(body.points, axis=-1).max() for body in bodies.values())),
        "shoulders": [shoulders.get(side) for side in (-1, 1)],
        "ellipses": [
            {"colour": to_rgb(ink), "semi_axes": [mesh.MM * part for part in job[name]], "middle": middle}
            for ink, name, middle in inks
        ],
        "lines": to_rgb(mesh.LINES),
        "shoulder": to_rgb(mesh.SHOULDER),
        "shades": packed(colormaps[mesh.COLOURS](np.linspace(0, 1, SHADES), bytes=True), "u1"),
        "eye": mesh.STEEP.tolist(),
        "half_size": mesh.MM * max(SHOWN[0] * max(job["computed"]), SHOWN[1] * min(job["computed"])),
    }


def drawn_body(body: pv.DataSet, colour: str) -> dict[str, Any]:
    """The loaded faces of a body as triangles of their nodes, the edges of its cells as lines.

    Each vertex has its place, the outward normal there, and the pressure: seven numbers.
    """
    edges, centres, within = mesh.outer_faces(body, loaded=True)
    halves = edges[..., [0, 2, 2, 1]].reshape(-1, 2)  # eight to a face
    triangles = np.column_stack([halves, np.repeat(centres, 8)])
    away = body.points[triangles[:, 2]] - body.points[np.repeat(within, 8)]
    inwards = np.sum(normals(body.points[triangles]) * away, axis=-1) < 0
    triangles[inwards] = triangles[inwards][:, ::-1]
    used, numbers = np.unique(triangles, return_inverse=True)
    numbers, points = numbers.reshape(-1, 3), body.points[used]
    smooth = np.zeros(points.shape)  # the mean of the normals of all triangles at a vertex, by their areas
    for corner in numbers.T:
        np.add.at(smooth, corner, normals(points[numbers]))
    smooth /= np.linalg.norm(smooth, axis=-1, keepdims=True)
    lines = mesh.distinct_edges(edges)[:, [0, 2, 2, 1]].reshape(-1, 2)
    pressure = np.maximum(body.point_data["pressure"][used], 0.0)
    return {
        "colour": to_rgb(colour),
        "faces": len(triangles),
        "vertices": packed(np.column_stack([points, smooth, pressure]), "<f4"),
        "triangles": packed(numbers, "<u4"),
        "lines": packed(np.searchsorted(used, lines), "<u4"),
    }


def normals(corners: np.ndarray) -> np.ndarray:
    """Of triangles (n, 3, 3) by the right hand, as long as twice their areas, (n, 3)."""
    first, second, third = np.moveaxis(corners, 1, 0)
    return np.cross(second - first, third - first)


def packed(values: Any, kind: str) -> str:
    """Numbers as the page's script unpacks them.

    kind : of each number, as numpy writes it
    """
    return base64.b64encode(np.ascontiguousarray(values, dtype=kind).tobytes()).decode()
