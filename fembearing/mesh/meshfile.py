"""Meshes as files: VTK's .vtu through meshio, cells and node sets without loss."""

import binascii
import os
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path
from typing import Any

import meshio
import numpy as np
from skfem import MeshHex2
from skfem.io.meshio import from_meshio, to_meshio

from analytic.errors import InputError
from fembearing.mesh.bodies import BodyMesh, BodyName

ABSENT = -1  # number of a node that may not touch
SETS = ("surface", "far", "clamped", "plane_x", "plane_y", "plane_z")
UNREADABLE = (
    meshio.ReadError,
    OSError,
    ValueError,
    KeyError,
    IndexError,
    TypeError,
    AttributeError,
    AssertionError,
    zlib.error,
    binascii.Error,
    ElementTree.ParseError,
)  # what meshio raises on a broken .vtu


def write_body(path: Path, body: BodyMesh, **fields: Any) -> None:
    """Write a body as .vtu, whole or not at all.

    fields : further arrays over the nodes, (nodes,) or (nodes, 3), SI
    """
    count = body.mesh.doflocs.shape[1]
    order = np.full(count, ABSENT, dtype=np.int32)
    order[body.touching] = np.arange(body.touching.size)
    marks: dict[str, Any] = {"touching": order}
    for name, nodes in zip(SETS, (body.surface, body.far, body.clamped, *body.planes), strict=True):
        marks[name] = np.isin(np.arange(count), nodes).astype(np.int8)
    content = to_meshio(body.mesh)
    content.point_data.update(marks | fields)
    temporary = path.with_name(f".{path.stem}-{os.getpid()}.vtu")  # not tempfile's: that one only its owner may read
    try:
        meshio.vtu.write(str(temporary), content)
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def read_body(path: Path, *, name: BodyName) -> BodyMesh:
    """Read what `write_body` wrote. Raises InputError for a file that is not such a mesh."""
    try:
        content = meshio.vtu.read(str(path))
        mesh = from_meshio(content)
        if not isinstance(mesh, MeshHex2):
            raise TypeError(f"cells are {', '.join(sorted(content.cells_dict))}, wanted hexahedron27")
        order = content.point_data["touching"]
        sets = {part: np.flatnonzero(content.point_data[part]) for part in SETS}
    except UNREADABLE as problem:
        reason = str(problem).splitlines()[0] if str(problem) else type(problem).__name__
        raise InputError(f"{path}: not a mesh written by fembearing ({reason})") from problem
    touching = np.flatnonzero(order != ABSENT)
    return BodyMesh(
        name=name,
        mesh=mesh,
        touching=touching[np.argsort(order[touching])],
        surface=sets["surface"],
        far=sets["far"],
        clamped=sets["clamped"],
        planes=(sets["plane_x"], sets["plane_y"], sets["plane_z"]),
    )
