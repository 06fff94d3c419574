"""Height maps: reading, refusals, and statistics of surfaces whose moments are known exactly."""

import contextlib
from pathlib import Path

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.surface.heightmap import HeightMap, levelled, measure, read_height_map
from tests.analytic.surface.map_files import ROUGH, SPACING, formless


def waves(rows: int, columns: int, *, amplitude: float, along_rows: float, along_columns: float) -> HeightMap:
    """amplitude cos(k x) cos(q y) with k and q in 1/m; x is along a row."""
    x, y = np.arange(columns) * SPACING, np.arange(rows)[:, None] * SPACING
    return HeightMap(heights=amplitude * np.cos(along_rows * x) * np.cos(along_columns * y), spacing=SPACING)


def test_moments_of_waves_are_exact() -> None:
    """Mean squares of a product of cosines: A^2/4, with (2/d) sin(k d/2) instead of k because of the differences."""
    size, amplitude = 1260, 0.29e-6
    k, q = 2 * np.pi * 15 / (size * SPACING), 2 * np.pi * 18 / (size * SPACING)  # whole periods
    computed = measure(waves(size, size, amplitude=amplitude, along_rows=k, along_columns=q))
    by_differences = [2 / SPACING * np.sin(wave * SPACING / 2) for wave in (k, q)]
    square = amplitude**2 / 4
    edge = 2 / size  # a row of n points has one or two differences less
    np.testing.assert_allclose(computed.moments.height, square, rtol=1e-12)  # round-off
    np.testing.assert_allclose(computed.moments.slope, square * np.mean(np.square(by_differences)), rtol=edge)
    np.testing.assert_allclose(computed.moments.curvature, square * np.mean(np.power(by_differences, 4)), rtol=edge)
    tops = 15 * 18 + 14 * 17  # where both cosines are 1 or both -1, without the rim
    np.testing.assert_allclose(computed.summits.density, tops / ((size - 2) * SPACING) ** 2, rtol=1e-12)
    np.testing.assert_allclose(computed.summits.mean_height, amplitude, rtol=1e-12)  # every summit is on a point
    np.testing.assert_allclose(computed.summits.radius, 2 / (amplitude * (k**2 + q**2)), rtol=0.02)
    assert computed.warnings == ()


def test_correlation_length_of_waves() -> None:
    """cos(k r) falls to 1/e at acos(1/e)/k."""
    size = 1200
    k = 2 * np.pi * 20 / (size * SPACING)
    computed = measure(waves(size, size, amplitude=2e-7, along_rows=k, along_columns=k))
    np.testing.assert_allclose(computed.correlation_length, np.arccos(np.exp(-1)) / k, rtol=0.01)  # open ends


def test_a_lay_and_a_coarse_or_narrow_map_give_warnings() -> None:
    size = 400
    lay = measure(waves(size, size, amplitude=1e-7, along_rows=2e5, along_columns=2e4))
    assert any("has a lay" in warning for warning in lay.warnings)
    assert any("along its rows" in warning for warning in lay.warnings)
    noise = measure(HeightMap(heights=ROUGH - ROUGH.mean(), spacing=SPACING))
    assert any("spacing 1.7 um is more than a tenth" in warning for warning in noise.warnings)
    long = measure(waves(64, 64, amplitude=1e-7, along_rows=4e4, along_columns=4e4))
    assert any("below ten lengths" in warning for warning in long.warnings)


def test_tilt_and_offset_are_removed() -> None:
    rows, columns = np.mgrid[:40, :53]
    tilted = ROUGH + 3e-6 + 2.3e-7 * rows - 1.1e-7 * columns
    straight = levelled(HeightMap(heights=ROUGH, spacing=SPACING)).heights
    np.testing.assert_allclose(levelled(HeightMap(heights=tilted, spacing=SPACING)).heights, straight, atol=1e-19)
    plane = np.linalg.lstsq(np.column_stack([np.ones(ROUGH.size), rows.ravel(), columns.ravel()]), ROUGH.ravel())[0]
    expected = ROUGH - plane[0] - plane[1] * rows - plane[2] * columns  # least squares by another method
    np.testing.assert_allclose(straight, expected, atol=1e-19)  # round-off of 1e-7


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
def test_a_binary_map_is_read(tmp_path: Path, dtype: type) -> None:
    heights = ROUGH.astype(dtype)
    np.save(tmp_path / "map.npy", np.asfortranarray(heights))
    computed = read_height_map(tmp_path / "map.npy", spacing=SPACING)
    np.testing.assert_allclose(computed.heights, formless(heights.astype(np.float64)), atol=1e-20)  # round-off
    assert (computed.spacing, computed.warnings) == (SPACING, ())


def test_the_form_of_a_race_is_removed_and_known(tmp_path: Path) -> None:
    """A flank with the curvatures of a groove of 4 mm and of a race of 15 mm, askew: its sag is a hundred times Sq."""
    y, x = np.mgrid[: ROUGH.shape[0], : ROUGH.shape[1]] * SPACING
    form = 0.1 * x + x**2 / 2 / 4e-3 - y**2 / 2 / 15e-3 + 7 * x * y
    for name, heights in (("form", form + ROUGH), ("hole", np.where((x > 7e-5) & (y < 1.2e-5), np.nan, form + ROUGH))):
        computed = read_height_map(saved(tmp_path / f"{name}.npy", heights), spacing=SPACING)
        known = np.isfinite(heights)
        # round-off of 1e-5; a corner of 4 % of the points shifts the form by some hundredths of Sq, most there
        rounding = 1e-19 if known.all() else 1e-7
        np.testing.assert_allclose(computed.heights[known], formless(ROUGH)[known], atol=rounding)
        assert abs(computed.heights[~known]).max(initial=0) < 4 * ROUGH.std(), "the hole is flat"
        plane = levelled(HeightMap(heights=form + ROUGH, spacing=SPACING)).heights
        np.testing.assert_allclose(computed.with_form, plane.std(), rtol=1e-9 if known.all() else 0.3)


def test_gaps_are_filled_up_to_a_share(tmp_path: Path) -> None:
    """A row and a column without a point cross; 92 of 2120 points. With 15 more they are above 5 %."""
    heights = ROUGH.copy()
    heights[7], heights[:, 11] = np.nan, np.inf
    computed = read_height_map(saved(tmp_path / "map.npy", heights), spacing=SPACING)
    assert np.isfinite(computed.heights).all()
    assert computed.warnings[0].startswith("4.34 %")
    neighbours = computed.heights[8, 20] + computed.heights[6, 20]
    np.testing.assert_allclose(computed.heights[7, 20], neighbours / 2, atol=0.05 * ROUGH.std())  # less the new form
    heights[20, 20:35] = np.nan
    assert "5.05 % of the points were not measured, at most 5 %" in refusal(saved(tmp_path / "map.npy", heights))


def written(separator: str, decimal: str = ".") -> str:
    """The rough surface as lines, to 17 digits."""
    return "\n".join(separator.join(f"{each:.17g}" for each in row) for row in ROUGH.tolist()).replace(".", decimal)


HEAD = "Race No. 7, 12 \xb5m from the edge\nXres = 53\n\tYres\t40\n"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "latin-1"])
@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("map.CSV", "# heights, m\n" + written(",")),
        ("map.csv", written(", ")),
        ("map.csv", HEAD + written(";", ",")),
        ("map.csv", HEAD + written(";").replace("\n", ";\n")),
        ("map.txt", HEAD + written("\t", ",").replace("\n", "\r\n")),
        ("map.asc", written("  ", ",")),
        ("map.dat", HEAD + written(" ") + "\n\n"),
    ],
)
def test_a_text_map_is_read(tmp_path: Path, name: str, text: str, encoding: str) -> None:
    (tmp_path / name).write_bytes(text.encode(encoding))
    computed = read_height_map(tmp_path / name, spacing=SPACING).heights
    np.testing.assert_allclose(computed, formless(ROUGH), atol=1e-20)  # round-off


@pytest.mark.parametrize("separator", [",", ";", "\t"])
@pytest.mark.parametrize("gap", ["", "NaN", "Bad", "***", "-"])
def test_words_and_empty_cells_are_gaps(tmp_path: Path, separator: str, gap: str) -> None:
    cells = [line.split(separator) for line in written(separator).split("\n")]
    for row, column in ((3, 5), (3, 6), (17, 20)):
        cells[row][column] = gap
    (tmp_path / "map.txt").write_text("\n".join(map(separator.join, cells)))
    computed = read_height_map(tmp_path / "map.txt", spacing=SPACING)
    assert computed.warnings[0].startswith("0.142 %"), "3 of 2120"


class Bomb:
    """Runs code when unpickled."""

    def __reduce__(self) -> tuple[object, tuple[str]]:
        return (pytest.fail, ("a height map was unpickled",))


def saved(path: Path, heights: object) -> Path:
    np.save(path, np.asarray(heights))
    return path


@pytest.mark.parametrize(
    ("heights", "words"),
    [
        (np.full((40, 40), np.nan), "100 % of the points were not measured"),
        (np.zeros((40, 40, 2)), "has the shape (40, 40, 2)"),
        (np.zeros((31, 400)), "has 31 by 400 points; give 32 to 4096"),
        (np.zeros((32, 4097), dtype=np.int8), "has 32 by 4097 points"),
        (np.zeros((40, 40), dtype=complex), "holds complex128, not real numbers"),
        (ROUGH * 1e6, "give them in m, not in um"),
        (np.array([[Bomb()] * 40] * 40), "not a matrix of numbers"),
    ],
)
def test_an_array_that_is_no_map_is_refused(tmp_path: Path, heights: object, words: str) -> None:
    path = saved(tmp_path / "map.npy", heights)
    assert words in refusal(path)


def refusal(path: Path) -> str:
    with pytest.raises(InputError) as problem:
        read_height_map(path, spacing=SPACING)
    message = str(problem.value)
    assert message.isprintable(), "one line"
    assert len(message) < 500
    assert message.startswith(str(path)[:150]) or str(path) != str(path).strip() or "'" in message
    return message


@pytest.mark.parametrize(
    ("name", "content", "words"),
    [
        ("a.csv", b"", "no row of 32 or more numbers"),
        ("a.txt", b"0 0 1e-7\n" * 5000, "no row of 32 or more numbers"),  # a list of points
        ("a.txt", b"0 0 1e-7\n" * 50_000, "more than 10000 lines"),
        ("a.txt", b"0 " * 300_000, "longer ones than 409600 characters"),
        ("a.txt", (b"1e308 -1e308 " * 20 + b"\n") * 40, "give them in m"),
        ("a.csv", b"1e-7," * 39 + b"2e-7\n3\n" * 40, "not a matrix of numbers"),
        ("a.csv", (b"1e-7," * 39 + b"2e-7\n") * 40 + b"the end", "not a matrix of numbers"),
        ("a.csv", (b"0,1e-7," * 39 + b"0,2e-7\n") * 40, "both are possible; separate by semicolons"),
        ("a.csv", (b"1,234.5;" * 39 + b"0\n") * 40, "not a matrix of numbers"),
        ("a.csv", (b"1e-7," * 34 + b"***," * 5 + b"2e-7\n") * 40, "12.5 % of the points were not measured"),
        ("a.csv", b",".join(b"%de-6" % n for n in range(40)) + b"\n" + (b"1e-7," * 39 + b"2e-7\n") * 40, "first row"),
        ("a.txt", b"".join(b"%de-6" % n + b" 1e-7 2e-7" * 20 + b"\n" for n in range(40)), "first column"),
        ("a.npy", b"PK\x03\x04 a zip file", "not a matrix of numbers"),
        ("a.npy", b"\x93NUMPY\x01\x00\x76\x00{'descr': '<f8', 'fortran_order': False, 'shape': (40,", "not a matrix"),
        ("a.csv", (b"1e-7," * 39 + b"2e-7\n") * 4097, "has 4097 by 40 points; give 32 to 4096 in each direction"),
        ("a.csv", b"0 " * 5000, "has 1 by 5000 points; give 32 to 4096"),
        ("a.mat", b"1,2", "give one of .npy, .csv"),
    ],
)
def test_a_file_that_is_no_map_is_refused(tmp_path: Path, name: str, content: bytes, words: str) -> None:
    (tmp_path / name).write_bytes(content)
    assert words in refusal(tmp_path / name)


def test_a_damaged_file_or_false_header_takes_no_memory(tmp_path: Path) -> None:
    whole = saved(tmp_path / "map.npy", ROUGH).read_bytes()
    short = tmp_path / "short.npy"
    short.write_bytes(whole[:-8])  # the last number is missing
    assert "not a matrix of numbers" in refusal(short)
    for shape in ("(99999999, 99999)", "(40, -53)", "(10**9, 40)", "40", "(40, 1" + "0" * 30 + ")"):
        false = tmp_path / "false.npy"
        header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
        false.write_bytes(b"\x93NUMPY\x01\x00\x76\x00" + header.encode())
        assert refusal(false)
    for cut in range(0, len(whole) - ROUGH.nbytes, 5):  # any damage to the header gives one line
        short.write_bytes(whole[:cut] + b"\x00" + whole[cut + 1 :])
        with contextlib.suppress(InputError):  # no other exception; a changed letter may also do no harm
            read_height_map(short, spacing=SPACING)


def test_a_missing_file_and_a_folder_are_refused(tmp_path: Path) -> None:
    assert "give the path of a height map" in refusal(tmp_path / "none.npy")
    (tmp_path / "folder.csv").mkdir()
    assert "give the path of a height map" in refusal(tmp_path / "folder.csv")
    with pytest.raises(InputError, match="spacing must be positive"):
        read_height_map(tmp_path / "none.npy", spacing=0.0)
    with pytest.raises(InputError, match="has no spacing of its own"):
        read_height_map(saved(tmp_path / "map.npy", ROUGH))
