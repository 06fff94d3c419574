"""Height maps of rough surfaces: read from a file, levelled, and measured by differences of neighbouring points.

A map is a matrix of heights, m, on a square grid; x is along its rows, y along its columns. Heights are relative to the
mean plane, which is subtracted before anything is measured.
"""

import os
from collections.abc import Iterator
from dataclasses import dataclass
from functools import partial
from itertools import chain
from pathlib import Path
from typing import BinaryIO

import numpy as np

from analytic.errors import InputError, require_positive
from analytic.reading import opened, require_regular
from analytic.scene import Array
from analytic.surface.moments import SpectralMoments, Summits
from analytic.surface.profilometer import ENDING, SAME_SPACING, x3p_heights, x3p_shape_and_spacing
from analytic.words import length_of, plain

FEWEST_POINTS, MOST_POINTS = 32, 4096  # in each direction: fewer are no statistics, more need too much memory
FEWER = f"give {FEWEST_POINTS} to {MOST_POINTS} in each direction, or cut out a part"
LARGEST_TEXT, LARGEST_BINARY = 100_000_000, 300_000_000  # bytes of .csv and .npy
LONGEST_LINE = 100 * MOST_POINTS  # bytes; a number has 25 at most
BAND = 64  # rows of a map that are measured together
HIGHEST = 1e-3  # m, from the lowest to the highest point: larger heights are not in metres, or the part is broken
SMOOTHEST = 1e-9  # m, Sq: polished silicon has some 0.1 nm, finished races have 10 nm and more
ROUND_OFF = 64 * np.finfo(np.float64).eps  # of the heights; means of 4096 and a slope over them leave a few eps
WIDEST = 0.1  # correlation length over domain, and spacing over correlation length: more spoils statistics or summits
MOST_UNEQUAL = 1.5  # ratio of the mean squared slopes along x and y: more is a lay, and the summits are no spheres


@dataclass(frozen=True, kw_only=True, eq=False)
class HeightMap:
    """Heights above the mean plane."""

    heights: Array  # (rows, columns), m
    spacing: float  # of neighbouring points, m


@dataclass(frozen=True, kw_only=True, eq=False)
class Measurement:
    """Statistics of the surface of a height map."""

    moments: SpectralMoments  # mean of both directions; their height is Sq squared of this map
    correlation_length: float  # at which the autocorrelation is 1/e, m; infinite if it is above 1/e in half the map
    summits: Summits  # by counting
    warnings: tuple[str, ...]


def read_height_map(path: str | os.PathLike[str], *, spacing: float) -> HeightMap:
    """The map in a .npy file, in lines of comma-separated numbers (.csv), m, or in a .x3p file, without its mean plane.

    spacing : of neighbouring points in both directions, m, > 0; of a .x3p file the one that it has
    A .npy file is never unpickled, and nothing is read that does not fit into memory.
    Raises InputError for a file that cannot be read, has another format, or holds no matrix of finite real numbers, for
    fewer than 32 or more than 4096 points in a direction, and for heights that cannot be metres: Sq below 1 nm, or a
    span above 1 mm.
    """
    require_positive(spacing=spacing)
    origin = plain(os.fspath(path))
    readers = {".npy": _read_binary, ".csv": _read_text, ENDING: partial(_read_x3p, spacing=spacing)}
    kind = Path(path).suffix.lower()
    if kind not in readers:
        raise InputError(f"{origin}: not a height map; give a .npy or .csv file of heights in m, or a .x3p file")
    try:
        heights = readers[kind](path)
    except InputError as problem:
        raise InputError(f"{origin}: {problem}") from problem
    except Exception as problem:  # NumPy raises different exceptions for a damaged header, depending on the damage
        reason = plain(" ".join(str(problem).split())[:120])
        raise InputError(f"{origin}: not a matrix of numbers: {reason}; save heights in m as .npy or .csv") from problem
    if not np.isfinite(heights).all():
        row, column = (int(i) for i in np.argwhere(~np.isfinite(heights))[0])
        raise InputError(f"{origin}: the height at row {row}, column {column} is not finite; fill or cut out gaps")
    half = heights.max() / 2 - heights.min() / 2  # the whole span may overflow
    if not half <= HIGHEST / 2:
        raise InputError(
            f"{origin}: heights span {length_of(2 * float(half))}, more than {length_of(HIGHEST)}; give them in m, "
            "not in um"
        )
    _level(heights)
    roughness = float(np.sqrt(_mean_square(heights, order=0)))
    if roughness < SMOOTHEST:
        raise InputError(
            f"{origin}: heights have Sq {roughness * 1e9:.3g} nm, less than {SMOOTHEST * 1e9:g} nm, and no race is so "
            "smooth; give them in m"
        )
    return HeightMap(heights=heights, spacing=spacing)


def levelled(raw: HeightMap) -> HeightMap:
    """The map without its mean plane (least squares); waves and the curvature of a ball remain."""
    heights = raw.heights.copy()
    _level(heights)
    return HeightMap(heights=heights, spacing=raw.spacing)


def _level(heights: Array) -> None:
    """Subtract the mean plane in place: a large map is in memory once. What round-off leaves of a plane is flat."""
    round_off = ROUND_OFF * max(abs(heights.max()), abs(heights.min()))
    heights -= heights.mean()
    for axis, size in enumerate(heights.shape):
        across = np.arange(size) - (size - 1) / 2
        profile = heights.mean(axis=1 - axis)
        slope = across @ profile / (across @ across)
        heights -= slope * (across[:, None] if axis == 0 else across)
    if max(heights.max(), -heights.min()) <= round_off:
        heights[:] = 0.0


def measure(height_map: HeightMap) -> Measurement:
    """Spectral moments, correlation length and summits of a levelled map.

    Slope and curvature are differences of neighbours at the spacing d: (z_1 - z_0)/d, (z_2 - 2 z_1 + z_0)/d^2. They are
    lower than the derivatives of a smooth surface. For a gaussian autocorrelation sampled at a tenth of its length m_2
    is low by 0.5 %, m_4 by 1.6 %, the curvature of the summits by 1.3 %, and their number by less than 1 %.
    """
    z, d = height_map.heights, height_map.spacing
    slopes = [_mean_square(lines, order=1) / d**2 for lines in (z.T, z)]
    curvatures = [_mean_square(lines, order=2) / d**4 for lines in (z.T, z)]
    moments = SpectralMoments(
        height=_mean_square(z, order=0), slope=float(np.mean(slopes)), curvature=float(np.mean(curvatures))
    )
    length = _correlation_length(height_map)
    return Measurement(
        moments=moments,
        correlation_length=length,
        summits=_counted_summits(height_map),
        warnings=tuple(_doubts(height_map, slopes, length)),
    )


def _bands(lines: Array) -> Iterator[Array]:
    """Some rows at a time, so that what is computed of them takes little memory beside a large map."""
    for start in range(0, lines.shape[0], BAND):
        yield lines[start : start + BAND]


def _mean_square(lines: Array, *, order: int) -> float:
    """Of the differences of this order along the rows."""
    total = sum(float(np.sum(np.diff(band, n=order, axis=1) ** 2)) for band in _bands(lines))
    return total / (lines.shape[0] * (lines.shape[1] - order))


def _read_binary(path: str | os.PathLike[str]) -> Array:
    require_regular(path, most=LARGEST_BINARY, remedy="give the path of a height map")
    mapped = np.lib.format.open_memmap(path, mode="r")  # the header only; refuses pickled objects
    if mapped.dtype.kind not in "fiu":
        raise InputError(f"holds {mapped.dtype}, not real numbers; save heights in m")
    _require_matrix(mapped.shape)
    return np.array(mapped, dtype=np.float64)


def _read_text(path: str | os.PathLike[str]) -> Array:
    with opened(path, most=LARGEST_TEXT, remedy="give the path of a height map; of a large one, a .npy file") as file:
        rows = _rows(file)
        first = next(rows, None)
        if first is None:
            raise InputError("holds no numbers; give a line of comma-separated heights in m for each row")
        heights = np.loadtxt(chain((first,), rows), delimiter=",", ndmin=2, dtype=np.float64)
    _require_matrix(heights.shape)
    return heights


def _read_x3p(path: str | os.PathLike[str], *, spacing: float) -> Array:
    shape, own = x3p_shape_and_spacing(path)
    _require_matrix(shape)
    if not abs(spacing - own) <= SAME_SPACING * own:
        raise InputError(
            f"has points every {length_of(own, '.6g')}, got spacing {length_of(spacing, '.6g')}; give its own"
        )
    return x3p_heights(path)


def _rows(file: BinaryIO) -> Iterator[str]:
    """The lines with numbers, one at a time in memory. Raises InputError for more of them than a map may have."""
    count = 0
    while line := file.readline(LONGEST_LINE + 1):
        if len(line) > LONGEST_LINE:
            raise InputError(f"has a line of more than {LONGEST_LINE} bytes; {FEWER}")
        text = line.decode("utf-8-sig" if file.tell() == len(line) else "utf-8")
        if not text.strip() or text.startswith("#"):
            continue
        count += 1
        if count > MOST_POINTS:
            raise InputError(f"has more than {MOST_POINTS} rows; {FEWER}")
        yield text


def _require_matrix(shape: tuple[int, ...]) -> None:
    if len(shape) != 2:
        raise InputError(f"has the shape {shape}; a height map is a matrix, rows by columns")
    if not all(FEWEST_POINTS <= size <= MOST_POINTS for size in shape):
        raise InputError(f"has {shape[0]} by {shape[1]} points; {FEWER}")


def _correlation_length(height_map: HeightMap) -> float:
    """Where the autocorrelation, mean of both directions, first falls below 1/e; linear between the points."""
    lags = min(height_map.heights.shape) // 2
    both = []
    for z in (height_map.heights, height_map.heights.T):
        size = z.shape[1]
        # padded with zeros: the map is not periodic
        spectrum = sum((np.abs(np.fft.rfft(band, n=2 * size, axis=1)) ** 2).sum(axis=0) for band in _bands(z))
        products = np.fft.irfft(spectrum / z.shape[0], n=2 * size)[:lags]
        both.append(products / (size - np.arange(lags)))
    correlation = np.mean(both, axis=0)
    below = np.flatnonzero(correlation < correlation[0] / np.e)
    if below.size == 0:
        return float("inf")
    first = int(below[0])
    drop = correlation[first - 1] - correlation[first]
    return height_map.spacing * (first - 1 + float((correlation[first - 1] - correlation[0] / np.e) / drop))


def _counted_summits(height_map: HeightMap) -> Summits:
    """Inner points above their eight neighbours, with the mean of their curvatures along x and y.

    Equal neighbours do not count, so coarsely rounded heights have too few summits.
    """
    z, d = height_map.heights, height_map.spacing
    ring = np.ones((3, 3), dtype=bool)
    ring[1, 1] = False
    from scipy.ndimage import maximum_filter  # a twentieth of a second to import, only for height maps

    row, column = (1 + place for place in np.nonzero((z > maximum_filter(z, footprint=ring))[1:-1, 1:-1]))
    tops = z[row, column]
    if tops.size == 0:
        return Summits(density=0.0, radius=float("inf"), height_deviation=0.0, mean_height=0.0)
    around = z[row - 1, column] + z[row + 1, column] + z[row, column - 1] + z[row, column + 1]
    curvature = float(np.mean(4 * tops - around)) / (2 * d**2)
    return Summits(
        density=tops.size / ((z.shape[0] - 2) * (z.shape[1] - 2) * d**2),
        radius=1 / curvature,
        height_deviation=float(tops.std()),
        mean_height=float(tops.mean()),
    )


def _doubts(height_map: HeightMap, slopes: list[float], length: float) -> Iterator[str]:
    spacing = height_map.spacing
    domain = spacing * min(height_map.heights.shape)
    if length > WIDEST * domain:
        yield (
            f"the map is {length_of(domain)} wide and its correlation length {length_of(length)}: below ten lengths "
            "Sq is uncertain"
        )
    if spacing > WIDEST * length:
        yield (
            f"the spacing {length_of(spacing)} is more than a tenth of the correlation length {length_of(length)}: "
            "slope, curvature and summits depend on it"
        )
    if max(slopes) > MOST_UNEQUAL * min(slopes):
        yield (
            f"mean squared slopes of the map are {slopes[1]:.3g} along its rows and {slopes[0]:.3g} along its columns: "
            "the surface has a lay, but the model takes round summits"
        )
