"""Height maps of rough surfaces: read from a file, levelled, and measured by differences of neighbouring points.

A map is a matrix of heights, m, on a square grid; x runs along its rows, y along its columns. Heights are counted from
the mean plane, which is taken off before anything is measured.
"""

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from analytic.errors import InputError, require_positive
from analytic.scene import Array
from analytic.surface.moments import SpectralMoments, Summits

FEWEST_POINTS, MOST_POINTS = 32, 4096  # each way: below, nothing can be said of a surface; above, memory
LARGEST_TEXT = 100_000_000  # bytes of .csv; numbers take four times that in memory at worst
HIGHEST = (
    1e-3  # m, from deepest to highest point: beyond, the heights are not in metres, or the part is not worn but broken
)
WIDEST = (
    0.1  # correlation length over domain, and spacing over correlation length: beyond, statistics or summits suffer
)
MOST_UNEQUAL = 1.5  # mean squared slopes along x and y: beyond, the surface has a lay and the summits are no spheres


@dataclass(frozen=True, kw_only=True, eq=False)
class HeightMap:
    """Heights above the mean plane."""

    heights: Array  # (rows, columns), m
    spacing: float  # of neighbouring points, m


@dataclass(frozen=True, kw_only=True, eq=False)
class Measurement:
    """What a height map says of its surface."""

    moments: SpectralMoments  # mean of both directions; their height is the realised Sq squared
    correlation_length: float  # where the autocorrelation has fallen to 1/e, m; infinite if it does not in half the map
    summits: Summits  # counted
    warnings: tuple[str, ...]


def read_height_map(path: str | os.PathLike[str], *, spacing: float) -> HeightMap:
    """The map in a .npy file or in lines of comma-separated numbers (.csv), in m, its mean plane taken off.

    spacing : of neighbouring points, the same both ways, m, > 0
    A .npy file is never unpickled, and nothing is read that does not fit into memory.
    Raises InputError, in one line, for a file that cannot be read, is neither, holds no matrix of finite real numbers,
    fewer than 32 or more than 4096 points each way, or heights that cannot be metres.
    """
    require_positive(spacing=spacing)
    origin = os.fspath(path)
    origin = origin if origin.isprintable() and len(origin) <= 200 else repr(origin)[:200]
    readers = {".npy": _read_binary, ".csv": _read_text}
    kind = Path(path).suffix.lower()
    if kind not in readers:
        raise InputError(f"{origin}: not a height map; give a .npy or .csv file of heights in m")
    try:
        heights = readers[kind](path)
    except OSError as problem:
        raise InputError(
            f"{origin}: {problem.strerror or 'cannot be read'}; give the path of a height map"
        ) from problem
    except InputError as problem:
        raise InputError(f"{origin}: {problem}") from problem
    except Exception as problem:  # what NumPy raises for a damaged header depends on where the damage is
        reason = " ".join(str(problem).split())[:120]
        raise InputError(f"{origin}: not a matrix of numbers: {reason}; save heights in m as .npy or .csv") from problem
    if not np.isfinite(heights).all():
        row, column = (int(i) for i in np.argwhere(~np.isfinite(heights))[0])
        raise InputError(f"{origin}: the height at row {row}, column {column} is not finite; fill or cut out gaps")
    half = heights.max() / 2 - heights.min() / 2  # the whole may be more than a double holds
    if not half <= HIGHEST / 2:
        raise InputError(
            f"{origin}: heights span {2 * float(half):.3g} m, more than {HIGHEST:g} m; give them in m, not in um"
        )
    return levelled(HeightMap(heights=heights, spacing=spacing))


def levelled(given: HeightMap) -> HeightMap:
    """The map with its mean plane (least squares) taken off; waves and the curvature of a ball stay."""
    heights = given.heights - given.heights.mean()
    for axis, size in enumerate(heights.shape):
        across = np.arange(size) - (size - 1) / 2
        profile = heights.mean(axis=1 - axis)
        slope = across @ profile / (across @ across)
        heights = heights - slope * (across[:, None] if axis == 0 else across)
    return HeightMap(heights=heights, spacing=given.spacing)


def measure(given: HeightMap) -> Measurement:
    """Spectral moments, correlation length and summits of a map whose mean plane has been taken off.

    Slope and curvature are differences of neighbours at the spacing d: (z_1 - z_0)/d, (z_2 - 2 z_1 + z_0)/d^2. Against
    the derivatives of a smooth surface they are low; for a gaussian autocorrelation sampled at a tenth of its length
    m_2 by 0.5 %, m_4 by 1.6 %, the curvature of the summits by 1.3 %, and their number by less than 1 %.
    """
    z, d = given.heights, given.spacing
    slopes = [float(np.mean(np.diff(z, axis=axis) ** 2)) / d**2 for axis in (0, 1)]
    curvatures = [float(np.mean(np.diff(z, n=2, axis=axis) ** 2)) / d**4 for axis in (0, 1)]
    moments = SpectralMoments(
        height=float(np.mean(z**2)), slope=float(np.mean(slopes)), curvature=float(np.mean(curvatures))
    )
    length = _correlation_length(given)
    return Measurement(
        moments=moments,
        correlation_length=length,
        summits=_counted_summits(given),
        warnings=tuple(_doubts(given, slopes, length)),
    )


def _read_binary(path: str | os.PathLike[str]) -> Array:
    mapped = np.lib.format.open_memmap(path, mode="r")  # header only; refuses what only unpickling could read
    if mapped.dtype.kind not in "fiu":
        raise InputError(f"holds {mapped.dtype}, not real numbers; save heights in m")
    _require_matrix(mapped.shape)
    return np.array(mapped, dtype=np.float64)


def _read_text(path: str | os.PathLike[str]) -> Array:
    if Path(path).stat().st_size > LARGEST_TEXT:
        raise InputError(f"more than {LARGEST_TEXT} bytes; save the heights as .npy, or a part of them")
    with Path(path).open(encoding="utf-8-sig") as lines:
        content = [line for line in lines if line.strip() and not line.startswith("#")]
    if not content:
        raise InputError("holds no numbers; give a line of comma-separated heights in m for each row")
    heights = np.loadtxt(content, delimiter=",", ndmin=2, dtype=np.float64)
    _require_matrix(heights.shape)
    return heights


def _require_matrix(shape: tuple[int, ...]) -> None:
    if len(shape) != 2:
        raise InputError(f"has the shape {shape}; a height map is a matrix, rows by columns")
    if not all(FEWEST_POINTS <= size <= MOST_POINTS for size in shape):
        raise InputError(
            f"has {shape[0]} by {shape[1]} points; give {FEWEST_POINTS} to {MOST_POINTS} each way, or cut out a part"
        )


def _correlation_length(given: HeightMap) -> float:
    """Where the autocorrelation, the mean of both directions, first falls below 1/e; linear between the points."""
    lags = min(given.heights.shape) // 2
    both = []
    for z in (given.heights, given.heights.T):
        size = z.shape[1]
        spectrum = np.abs(np.fft.rfft(z, n=2 * size, axis=1)) ** 2  # zeros behind: the map does not repeat
        products = np.fft.irfft(spectrum.mean(axis=0), n=2 * size)[:lags]
        both.append(products / (size - np.arange(lags)))
    correlation = np.mean(both, axis=0)
    below = np.flatnonzero(correlation < correlation[0] / np.e)
    if below.size == 0:
        return float("inf")
    first = int(below[0])
    drop = correlation[first - 1] - correlation[first]
    return given.spacing * (first - 1 + float((correlation[first - 1] - correlation[0] / np.e) / drop))


def _counted_summits(given: HeightMap) -> Summits:
    """Points above their eight neighbours, with the mean of their curvatures along x and y; without the rim.

    Of equal neighbours none counts: heights rounded coarsely have too few summits.
    """
    z, d = given.heights, given.spacing
    ring = np.ones((3, 3), dtype=bool)
    ring[1, 1] = False
    from scipy.ndimage import maximum_filter  # a twentieth of a second to import, for height maps alone

    top = (z > maximum_filter(z, footprint=ring))[1:-1, 1:-1]
    inside = z[1:-1, 1:-1]
    tops = inside[top]
    if tops.size == 0:
        return Summits(density=0.0, radius=float("inf"), height_deviation=0.0, mean_height=0.0)
    around = z[:-2, 1:-1] + z[2:, 1:-1] + z[1:-1, :-2] + z[1:-1, 2:]
    curvature = float(np.mean((4 * inside - around)[top])) / (2 * d**2)
    return Summits(
        density=tops.size / (inside.size * d**2),
        radius=1 / curvature,
        height_deviation=float(tops.std()),
        mean_height=float(tops.mean()),
    )


def _doubts(given: HeightMap, slopes: list[float], length: float) -> list[str]:
    found = []
    domain = given.spacing * min(given.heights.shape)
    if length > WIDEST * domain:
        found.append(
            f"the map is {domain:.3g} m wide and its correlation length {length:.3g} m: below ten lengths Sq is "
            "uncertain"
        )
    if given.spacing > WIDEST * length:
        found.append(
            f"the spacing {given.spacing:.3g} m is more than a tenth of the correlation length {length:.3g} m: "
            "slope, curvature and summits depend on it"
        )
    if max(slopes) > MOST_UNEQUAL * min(slopes):
        found.append(
            f"mean squared slopes of the map are {slopes[1]:.3g} along its rows and {slopes[0]:.3g} along its columns: "
            "the surface has a lay, and its summits are taken as round all the same"
        )
    return found
