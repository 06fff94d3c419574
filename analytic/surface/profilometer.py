"""Height maps in the file of a profilometer, X3P of ISO 25178-72, which has its own spacing and units.

SurfaceTopography reads it; it is an extra, as few scenes need it and it brings a dozen packages.
"""

import os

import numpy as np

from analytic.errors import InputError
from analytic.reading import require_regular
from analytic.scene import Array
from analytic.words import plain

ENDING = ".x3p"
EXTRA = "pip install 'fembearing[profilometer]'"
LARGEST = 300_000_000  # bytes
FLOATS = "F", "D"  # types of floating-point heights
SAME_SPACING = 1e-6  # relative difference of two spacings: rounding of a text in the file


def x3p_shape_and_spacing(path: str | os.PathLike[str]) -> tuple[tuple[int, int], float]:
    """Rows and columns of an X3P file, and the spacing of its points in both directions, m; heights are not read.

    Raises InputError for a file that cannot be read or is no X3P file, for spacings that differ, and where
    SurfaceTopography is not installed.
    """
    channel = _channel(path)
    columns, rows = channel.nb_grid_pts
    along_x, along_y = (size / count for size, count in zip(channel.physical_sizes, (columns, rows), strict=True))
    if not abs(along_x - along_y) <= SAME_SPACING * along_x:
        raise InputError(
            f"has points every {along_x * 1e6:.6g} um along x and {along_y * 1e6:.6g} um along y; resample it to a "
            "square grid"
        )
    return (int(rows), int(columns)), float(along_x)


def x3p_heights(path: str | os.PathLike[str]) -> Array:
    """The heights of an X3P file, (rows, columns), m; NaN where nothing was measured. Raises InputError likewise.

    Floating-point numbers are metres as they stand: the increment of z is that of integers [ISO25178-72]. The reader
    multiplies both by it.
    """
    channel = _channel(path)
    heights = np.ma.filled(np.ma.asarray(channel.topography().heights(), dtype=np.float64), np.nan)  # x first
    axis = channel.info["raw_metadata"]["Record1"]["Axes"]["CZ"]
    increment = float(axis.get("Increment", 1.0))
    if not increment > 0:
        raise InputError(f"has heights in steps of {increment:g} m; export it again, or save heights in m as .npy")
    return np.ascontiguousarray(heights.T) / (increment if axis["DataType"] in FLOATS else 1.0)


def _channel(path: str | os.PathLike[str]):
    """The one map of the file, in m."""
    require_regular(path, most=LARGEST, remedy="give the path of a height map")
    try:
        from SurfaceTopography import open_topography  # pyright: ignore[reportMissingImports]
    except ImportError as problem:
        raise InputError(
            f"{ENDING} files need SurfaceTopography, which is not installed: {EXTRA}, or save heights in m as .npy"
        ) from problem
    try:
        channel = open_topography(os.fspath(path), format="x3p").channels[0]
        unit = channel.unit
    except Exception as problem:  # it raises different ones, depending on the damage
        reason = plain(" ".join(str(problem).split())[:120])
        raise InputError(f"is no X3P file: {reason}; export it again, or save heights in m as .npy") from problem
    if unit != "m":
        raise InputError(f"has heights in {unit}, and X3P has them in m; export it again")
    return channel
