"""Meshes as .vtu files of VTK, written by meshio, with cells and node sets and without loss."""

from pathlib import Path
from typing import Any

import meshio
import numpy as np
from skfem import MeshHex2
from skfem.io.meshio import from_meshio, to_meshio

from analytic.errors import InputError
from analytic.reading import require_regular
from analytic.words import plain
from analytic.writing import replaced_file
from fembearing.mesh.bodies import BodyMesh, BodyName

LARGEST = 1_000_000_000  # bytes: ten times the finest mesh
ABSENT = -1  # number of a node that cannot touch
SETS = ("surface", "far", "clamped", "plane_x", "plane_y", "plane_z")


def write_body(path: Path, body: BodyMesh, **fields: Any) -> None:
    """Write a body as .vtu, whole or not at all.

    fields : further arrays over the nodes, (nodes,), (nodes, 3) or (nodes, 6), SI
    """
    count = body.mesh.doflocs.shape[1]
    order = np.full(count, ABSENT, dtype=np.int32)
    order[body.touching] = np.arange(body.touching.size)
    marks: dict[str, Any] = {"touching": order}
    for name, nodes in zip(SETS, (body.surface, body.far, body.clamped, *body.planes), strict=True):
        marks[name] = np.isin(np.arange(count), nodes).astype(np.int8)
    content = to_meshio(body.mesh)
    content.point_data.update(marks | fields)
    with replaced_file(path) as file:
        meshio.vtu.write(str(file), content)


def read_body(path: Path, *, name: BodyName) -> BodyMesh:
    """Read what `write_body` wrote. Raises InputError for a file that is not such a mesh."""
    try:
        require_regular(path, most=LARGEST, remedy="give a .vtu file of `fembearing contact --mesh`")
    except InputError as problem:
        raise InputError(f"{path}: {problem}") from problem
    try:
        content = meshio.vtu.read(str(path))
        _require_sound(content)
        mesh = from_meshio(content)
        if not isinstance(mesh, MeshHex2):
            raise TypeError(f"cells are {', '.join(sorted(content.cells_dict))}, wanted hexahedron27")
        order = content.point_data["touching"]
        sets = {part: np.flatnonzero(content.point_data[part]) for part in SETS}
    except Exception as problem:  # the error of meshio depends on the damage, and some are not public
        reason = plain(str(problem).splitlines()[0]) if str(problem) else type(problem).__name__
        raise InputError(f"{path}: not a mesh written by fembearing ({reason})") from problem
    touching = np.flatnonzero(order != ABSENT)
    if not np.array_equal(np.sort(order[touching]), np.arange(touching.size)):
        raise InputError(f"{path}: not a mesh written by fembearing (nodes that may touch are not numbered in a row)")
    return BodyMesh(
        name=name,
        mesh=mesh,
        touching=touching[np.argsort(order[touching])],
        surface=sets["surface"],
        far=sets["far"],
        clamped=sets["clamped"],
        planes=(sets["plane_x"], sets["plane_y"], sets["plane_z"]),
    )


def _require_sound(content: meshio.Mesh) -> None:
    """Raise ValueError for impossible numbers; a cell with a node that does not exist would exhaust memory."""
    if not np.isfinite(content.points).all():
        raise ValueError("a position is not finite")
    for block in content.cells:
        if block.data.size and not (block.data.min() >= 0 and block.data.max() < len(content.points)):
            raise ValueError("a cell names a node that does not exist")
