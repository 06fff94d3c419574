"""Height maps in X3P files: a zip archive of main.xml and of matrices in binary, in m [ISO25178-72].

Nothing unpacks to more than its limit, whatever the archive says of its size, and main.xml may define no entities.
"""

import os
from math import nan
from pathlib import PurePosixPath
from xml.etree import ElementTree
from zipfile import ZipFile

import numpy as np

from analytic.errors import InputError
from analytic.reading import opened
from analytic.scene import Array
from analytic.surface.map_data import MapData, require_matrix

LARGEST, LARGEST_INDEX = 300_000_000, 10_000_000  # bytes of the archive, and of its main.xml
AGAIN = "export it again, or save heights in m as .npy"
NUMBERS = {"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}  # by the data type of an axis


class _Index(ElementTree.TreeBuilder):
    """Builds main.xml, which has no use for a document type: that could define entities that grow without limit."""

    def doctype(self, _name: str, _public: str | None, _system: str | None) -> None:
        raise InputError(f"has a main.xml with a document type, which X3P has not; {AGAIN}")


def x3p_map(path: str | os.PathLike[str]) -> MapData:
    """The map of an X3P file.

    Floating-point numbers are metres as they stand: the increment of z is that of integers.
    Raises InputError for a file that holds no map, and other errors for damaged archives.
    """
    with opened(path, most=LARGEST, remedy="give the path of a height map") as file, ZipFile(file) as archive:
        names = [name for name in archive.namelist() if PurePosixPath(name).name == "main.xml"]
        if not names:
            raise InputError(f"has no main.xml, so it is no X3P file; {AGAIN}")
        index = min(names, key=len)
        parser = ElementTree.XMLParser(target=_Index())
        root = ElementTree.fromstring(_unpacked(archive, index, LARGEST_INDEX), parser)
        if (kind := _text(root, "Record1/FeatureType", "SUR")) != "SUR":
            raise InputError(f"holds {kind}, and a height map is SUR, a surface; export the surface")
        for axis in ("CX", "CY"):
            if (kind := _text(root, f"Record1/Axes/{axis}/AxisType", "I")) != "I":
                raise InputError(f"has an axis {axis} of the type {kind}, no regular grid; export a surface")
        columns, rows, layers = (int(_text(root, f"Record3/MatrixDimension/Size{axis}", "1")) for axis in "XYZ")
        if layers != 1:
            raise InputError(f"has {layers} layers; export one surface")
        require_matrix((rows, columns))
        kind = _text(root, "Record1/Axes/CZ/DataType", "D")
        if kind not in NUMBERS:
            raise InputError(f"has heights of the type {kind}, not {', '.join(NUMBERS)}; {AGAIN}")
        heights = _heights(archive, root, PurePosixPath(index).parent, (rows, columns), np.dtype(NUMBERS[kind]))
    if kind in "IL":
        increment = float(_text(root, "Record1/Axes/CZ/Increment", "1"))
        if not increment > 0:
            raise InputError(f"has heights in steps of {increment:g} m; {AGAIN}")
        heights *= increment
    along_x, along_y = (float(_text(root, f"Record1/Axes/{axis}/Increment", "nan")) for axis in ("CX", "CY"))
    return MapData(heights, (along_x, along_y))


def _heights(
    archive: ZipFile, root: ElementTree.Element, folder: PurePosixPath, shape: tuple[int, int], kind: np.dtype
) -> Array:
    """The numbers of main.xml itself, or of the file that it names; NaN where a point is not valid."""
    count = shape[0] * shape[1]
    link = _text(root, "Record3/DataLink/PointDataLink", "")
    if link:
        content = _unpacked(archive, str(folder / link), count * kind.itemsize)
        heights = np.frombuffer(content, dtype=kind).astype(np.float64)
    else:  # a point has X;Y;Z, on a regular grid Z alone, and nothing where it is not valid
        points = root.iterfind("{*}Record3/{*}DataList/{*}Datum")
        heights = np.array([float((point.text or "").split(";")[-1].strip() or nan) for point in points])
    if heights.size != count:
        raise InputError(f"has {heights.size} heights for {shape[0]} by {shape[1]} points; {AGAIN}")
    if valid := _text(root, "Record3/DataLink/ValidPointsLink", ""):
        bits = np.frombuffer(_unpacked(archive, str(folder / valid), -(-count // 8)), dtype=np.uint8)
        heights[np.unpackbits(bits, bitorder="little")[:count] == 0] = np.nan
    return heights.reshape(shape)


def _text(root: ElementTree.Element, path: str, default: str) -> str:
    """The text of an element, in whatever namespace it is."""
    return (root.findtext("/".join(f"{{*}}{name}" for name in path.split("/"))) or default).strip()


def _unpacked(archive: ZipFile, name: str, most: int) -> bytes:
    """A part of the archive, which is read only so far as it may be long."""
    with archive.open(name) as part:
        content = part.read(most + 1)
    if len(content) > most:
        raise InputError(f"has a {PurePosixPath(name).name} of more than {most} bytes; {AGAIN}")
    return content
