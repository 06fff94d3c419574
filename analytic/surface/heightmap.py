"""Height maps of rough surfaces: read from a file, levelled, and measured by differences of neighbouring points.

A map is a matrix of heights, m, on a square grid; x is along its rows, y along its columns. Heights are relative to the
mean plane, which is subtracted before anything is measured; those of a file lose their form and their gaps too.
"""

import os
import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np

from analytic.errors import InputError, MissingPackageError, require_positive
from analytic.reading import content_of, require_regular, text_of
from analytic.scene import Array
from analytic.surface.instruments import FORMATS, METROPRO, instrument_map
from analytic.surface.map_data import FEWEST_POINTS, MOST_POINTS, MapData, require_matrix
from analytic.surface.moments import SpectralMoments, Summits
from analytic.surface.x3p import x3p_map
from analytic.words import length_of, percent_of, plain

LARGEST_TEXT, LARGEST_BINARY = 100_000_000, 300_000_000  # bytes of a text and of .npy
MOST_LINES, LONGEST_LINE = 10_000, 100 * MOST_POINTS  # of a text, with its head; a number has 25 characters at most
MATRIX = f"give a matrix of heights in m, a row a line, of {FEWEST_POINTS} to {MOST_POINTS} in each direction"
BAND = 64  # rows of a map that are measured together
SPACING_ROUNDING = 1e-6  # relative difference of two equal spacings in a text
SAME_SPACING = 1e-3  # relative difference of two spacings: moments of slopes change by as much
# Share of points that were not measured. Filled points are smoother than the surface, so that they lower the mean
# squares of height, slope and curvature by up to this share: as much as these scatter from place to place.
MOST_GAPS = 0.05
HIGHEST = 1e-3  # m, from the lowest to the highest point: larger heights are not in metres, or the part is broken
# m, Sq: polished silicon has some 0.1 nm, finished races have 10 nm and more; turned steel has some um
SMOOTHEST, ROUGHEST = 1e-9, 1e-5
DENSEST, WIDEST_SPACING = 1e-10, 1e-3  # m: atoms are as far apart, and waves of roughness are shorter
ROUND_OFF = 64 * np.finfo(np.float64).eps  # of the heights; sums over 4096 points and a form leave a few eps
WIDEST = 0.1  # correlation length over domain, and spacing over correlation length: more spoils statistics or summits
MOST_UNEQUAL = 1.5  # ratio of the mean squared slopes along x and y: more is a lay, and the summits are no spheres
PLANE, FORM = 1, 2  # order of a polynomial
NUMBER = re.compile(r"[-+]?(\d+[.,]?\d*|[.,]\d+)([eE][-+]?\d+)?")
GAP = re.compile(r"(?i)(?<![^\s;,])(bad|n/?a|nan|\*+|-+)(?![^\s;,])")  # as instruments write what was not measured
BETWEEN = re.compile(r"[;,\s]+")
WITH_COMMA = r"[-+]?\d+,\d+([eE][-+]?\d+)?"
TWO_WAYS = re.compile(rf"{WITH_COMMA}(,{WITH_COMMA})*")  # numbers with decimal commas, or twice as many without
ENOUGH_CELLS = 2 * FEWEST_POINTS  # of a line, to see whether it has numbers; a decimal comma makes two of one
SIZE = re.compile(r"\d[\d.,]*([eE][-+]?\d+)?\s*[^\W\d]*")
OTHER_UNIT = re.compile(r"(?i)(?<!\w)([npcumµμ]m|Å|inch|mil|(micro|nano|milli|centi)met\w+|microns?)(?!\w)")


@dataclass(frozen=True, kw_only=True, eq=False)
class HeightMap:
    """Heights above the mean plane."""

    heights: Array  # (rows, columns), m
    spacing: float  # of neighbouring points, m
    with_form: float = np.nan  # Sq before the form was removed, without the plane, m; NaN: nobody looked for a form
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True, kw_only=True, eq=False)
class Measurement:
    """Statistics of the surface of a height map."""

    moments: SpectralMoments  # mean of both directions; their height is Sq squared of this map
    correlation_length: float  # at which the autocorrelation is 1/e, m; infinite if it is above 1/e in half the map
    summits: Summits  # by counting
    warnings: tuple[str, ...]


def read_height_map(path: str | os.PathLike[str], *, spacing: float | None = None) -> HeightMap:
    """The map in a file, without its form: the polynomial of second order, by least squares [ISO25178-2].

    The ending says what the file is (`READERS`). Text and .npy have heights in m.
    spacing : of neighbouring points in both directions, m, > 0; None: the one that the file has
    A .npy file is never unpickled, and nothing is read that does not fit into memory. Up to 5 % of points that were not
    measured are filled along rows and columns, with a warning.
    Raises InputError for a file that cannot be read, has another format, or holds no matrix of real numbers, for
    spacings that differ, fewer than 32 or more than 4096 points in a direction, more gaps, and for heights that cannot
    be metres: Sq below 1 nm or above 10 um, a span above 1 mm, or a head of a text that names another unit.
    """
    if spacing is not None:
        require_positive(spacing=spacing)
    origin = plain(os.fspath(path))
    read = READERS.get(Path(path).suffix.lower())
    if read is None:
        raise InputError(f"{origin}: not a height map; give one of {', '.join(READERS)}")
    try:
        found = read(path)
        return _checked(found, _one_spacing(found, spacing))
    except (InputError, MissingPackageError) as problem:
        raise InputError(f"{origin}: {problem}") from problem
    except Exception as problem:  # NumPy and zipfile raise different ones for damaged files, depending on the damage
        reason = plain(" ".join(str(problem).split())[:120])
        raise InputError(f"{origin}: not a matrix of numbers: {reason}; save heights in m as .npy or .csv") from problem


def _one_spacing(found: MapData, given: float | None) -> float:
    if found.spacings is None:
        if given is None:
            raise InputError('has no spacing of its own; give that of its points, for example spacing = "2 um"')
        return given
    along_x, along_y = found.spacings
    require_positive(spacing=found.spacings)
    if not DENSEST <= min(found.spacings) <= max(found.spacings) <= WIDEST_SPACING:
        raise InputError(
            f"has points every {along_x:.6g} m along x and {along_y:.6g} m along y, and roughness is measured at "
            f"{DENSEST:g} to {WIDEST_SPACING:g} m; export it again, with spacings in m"
        )
    if not abs(along_x - along_y) <= SAME_SPACING * along_x:
        raise InputError(
            f"has points every {length_of(along_x, '.6g')} along x and {length_of(along_y, '.6g')} along y; resample "
            "it to a square grid"
        )
    own = (along_x + along_y) / 2
    if given is not None and not abs(given - own) <= SAME_SPACING * own:
        raise InputError(
            f"has points every {length_of(own, '.6g')}, got spacing {length_of(given, '.6g')}; leave the spacing out"
        )
    return own


def _checked(found: MapData, spacing: float) -> HeightMap:
    """The map without form and gaps."""
    heights, doubts = found.heights, [*found.doubts]
    if found.spacings is not None and abs(found.spacings[0] - found.spacings[1]) > SPACING_ROUNDING * spacing:
        along_x, along_y = (length_of(each, ".6g") for each in found.spacings)
        doubts.append(f"points of the map are {along_x} apart along x and {along_y} along y, and their mean counts")
    gaps = ~np.isfinite(heights)
    heights[gaps] = np.nan  # infinite ones too
    share = float(gaps.mean())
    if share > MOST_GAPS:
        raise InputError(
            f"{percent_of(share)} of the points were not measured, at most {percent_of(MOST_GAPS)} are filled; measure "
            "again, or cut out a part"
        )
    half = np.nanmax(heights) / 2 - np.nanmin(heights) / 2  # the whole span may overflow
    if not half <= HIGHEST / 2:
        raise InputError(
            f"heights span {length_of(2 * float(half))}, more than {length_of(HIGHEST)}; give them in m, not in um"
        )
    _remove(heights, PLANE)
    with_form = float(np.sqrt(np.nanmean(heights**2)))
    _remove(heights, FORM)
    if share:
        doubts.append(
            f"{percent_of(share)} of the points of the map were not measured and are filled by linear interpolation"
        )
        _fill(heights)
        _remove(heights, FORM)
    roughness = float(np.sqrt(_mean_square(heights, order=0)))
    if roughness < SMOOTHEST:
        raise InputError(
            f"heights have Sq {roughness * 1e9:.3g} nm without plane and form, less than {SMOOTHEST * 1e9:g} nm, and "
            "no race is so smooth; give them in m"
        )
    if roughness > ROUGHEST:
        raise InputError(
            f"heights have Sq {length_of(roughness)} without plane and form, more than {length_of(ROUGHEST)}, and no "
            "race is so rough; give them in m"
        )
    return HeightMap(heights=heights, spacing=spacing, with_form=with_form, warnings=tuple(doubts))


def levelled(raw: HeightMap) -> HeightMap:
    """The map without its mean plane (least squares); waves and the curvature of a ball remain."""
    heights = raw.heights.copy()
    _remove(heights, PLANE)
    return HeightMap(heights=heights, spacing=raw.spacing)


def _remove(heights: Array, order: int) -> None:
    """Subtract the polynomial of this order in place, by least squares over the points that were measured.

    What round-off leaves of a polynomial is flat.
    """
    round_off = ROUND_OFF * np.nanmax(np.abs(heights))
    heights -= np.nanmean(heights)
    down, along = (np.vander(np.linspace(-1, 1, size), 2 * order + 1, increasing=True) for size in heights.shape)
    few = order + 1
    terms = [(i, j) for i in range(few) for j in range(few - i)]
    products, sums = np.zeros((2 * order + 1, 2 * order + 1)), np.zeros((few, few))
    for rows, band in zip(_bands(down), _bands(heights), strict=True):
        products += rows.T @ np.isfinite(band) @ along
        sums += rows[:, :few].T @ np.nan_to_num(band) @ along[:, :few]
    normal = [[products[i + k, j + m] for k, m in terms] for i, j in terms]
    form = np.zeros((few, few))
    form[tuple(zip(*terms, strict=True))] = np.linalg.solve(normal, [sums[term] for term in terms])
    for rows, band in zip(_bands(down), _bands(heights), strict=True):
        band -= rows[:, :few] @ form @ along[:, :few].T
    if np.nanmax(np.abs(heights)) <= round_off:
        heights[:] = 0.0


def _fill(heights: Array) -> None:
    """Put into each gap the mean of linear interpolations along its row and its column, in place.

    Where neither has a point, it takes those that were filled before.
    """
    while (gaps := np.isnan(heights)).any():
        total, count = np.zeros(gaps.sum()), np.zeros(gaps.sum())
        for lines, missing in ((heights, gaps), (heights.T, gaps.T)):
            filled = lines.copy()
            for line, hole in zip(filled, missing, strict=True):
                if hole.any() and not hole.all():
                    line[hole] = np.interp(np.flatnonzero(hole), np.flatnonzero(~hole), line[~hole])
            found = (filled if lines is heights else filled.T)[gaps]
            total += np.nan_to_num(found)
            count += np.isfinite(found)
        heights[gaps] = np.where(count > 0, total / np.maximum(count, 1), np.nan)


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
        warnings=(*height_map.warnings, *_doubts(height_map, slopes, length)),
    )


def _bands(lines: Array) -> Iterator[Array]:
    """Some rows at a time, so that what is computed of them takes little memory beside a large map."""
    for start in range(0, lines.shape[0], BAND):
        yield lines[start : start + BAND]


def _mean_square(lines: Array, *, order: int) -> float:
    """Of the differences of this order along the rows."""
    total = sum(float(np.sum(np.diff(band, n=order, axis=1) ** 2)) for band in _bands(lines))
    return total / (lines.shape[0] * (lines.shape[1] - order))


def _read_binary(path: str | os.PathLike[str]) -> MapData:
    require_regular(path, most=LARGEST_BINARY, remedy="give the path of a height map")
    mapped = np.lib.format.open_memmap(path, mode="r")  # the header only; refuses pickled objects
    if mapped.dtype.kind not in "fiu":
        raise InputError(f"holds {mapped.dtype}, not real numbers; save heights in m")
    require_matrix(mapped.shape)
    return MapData(np.array(mapped, dtype=np.float64))


def _read_text(path: str | os.PathLike[str]) -> MapData:
    """The matrix behind the lines of words, if any, with the separator and the decimal sign of its first row.

    A comma is a decimal sign beside semicolons, tabs or blanks, else it separates numbers.
    """
    content = content_of(path, most=LARGEST_TEXT, remedy="give the path of a height map; of a large one, a .npy file")
    if content.startswith(METROPRO[1]):
        return instrument_map(path, METROPRO[0])
    parts = text_of(content).replace("\r\n", "\n").replace("\r", "\n").split("\n", MOST_LINES)
    if len(parts) > MOST_LINES or max(map(len, parts)) > LONGEST_LINE:
        raise InputError(f"has more than {MOST_LINES} lines, or longer ones than {LONGEST_LINE} characters; {MATRIX}")
    lines = {number: line for number, part in enumerate(parts) if (line := part.strip(" ")) and line[0] != "#"}
    start = next((number for number, line in lines.items() if _has_numbers(line)), None)
    if start is None:
        raise InputError(f"has no row of {FEWEST_POINTS} or more numbers; {MATRIX}")
    _require_metres(parts[:start])
    places = [number for number in lines if number >= start]
    if len({later - earlier for earlier, later in pairwise(places)}) > 1:
        raise InputError(f"has lines between its rows, as between two maps; {MATRIX}")
    rows, first = [lines[number] for number in places], lines[start]
    separator = next((sign for sign in "\t;" if sign in first), None)
    is_decimal = separator is not None or re.search(r"\d\s+[-+.\d]", first) is not None
    if not is_decimal and "," in first:
        separator = ","
        if TWO_WAYS.fullmatch(re.sub(r"\s", "", first)):
            raise InputError(
                "has commas as decimal signs or between numbers, both are possible; separate by semicolons"
            )
    for is_at, without in ((str.endswith, str.removesuffix), (str.startswith, str.removeprefix)):
        while separator is not None and 2 * sum(is_at(row, separator) for row in rows) > len(rows):  # beside each row
            rows = [without(row, separator) for row in rows]
    require_matrix((len(rows), len(rows[0].split(separator))))
    if is_decimal:
        rows = (row.replace(",", ".") for row in rows)
    if separator is not None:
        empty = re.compile(rf"(?:^|(?<={separator})) *(?={separator}|$)")
        rows = (empty.sub("nan", row) for row in rows)
    heights = np.loadtxt((GAP.sub("nan", row) for row in rows), delimiter=separator, ndmin=2, dtype=np.float64)
    for line, following, name in (
        (heights[0, 1:], heights[1, 1:], "row"),
        (heights[1:, 0], heights[1:, 1], "column"),
    ):
        if _are_positions(line, following):
            raise InputError(f"has a first {name} that only rises or falls, as positions do; leave this {name} out")
    return MapData(heights)


def _has_numbers(line: str) -> bool:
    """Whether a line is a row, perhaps with something that is no number: it is no head then, but refused."""
    cells = BETWEEN.split(line.strip(";, \t"), ENOUGH_CELLS)[:ENOUGH_CELLS]
    return sum(bool(NUMBER.fullmatch(cell) or GAP.fullmatch(cell)) for cell in cells) >= FEWEST_POINTS


def _require_metres(head: list[str]) -> None:
    """Raise InputError where a head names another unit; sizes with their units, as 12 um, may stand there."""
    for line in head:
        if unit := OTHER_UNIT.search(SIZE.sub("", line)):
            raise InputError(f"has {unit[0]} in its head; give heights in m, without this word")


def _are_positions(line: Array, following: Array) -> bool:
    """Positions only rise or only fall, unlike the heights beside them, which a tilted surface has in common."""
    with np.errstate(over="ignore", invalid="ignore"):  # of numbers near the largest double
        steps = np.diff(line)
        is_monotone = np.all(steps >= 0) or np.all(steps <= 0)
        return bool(is_monotone and np.ptp(line - following) > np.ptp(line) / 2)


READERS = {
    ".npy": _read_binary,
    **dict.fromkeys((".csv", ".txt", ".asc", ".dat"), _read_text),
    ".x3p": x3p_map,
    **dict.fromkeys(FORMATS, instrument_map),
}
HAVE_NO_SPACING = (".npy", ".csv", ".txt", ".asc")


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
