"""Height maps in X3P files, which the tests write by hand: main.xml and binary numbers in a zip file."""

import sys
from pathlib import Path
from zipfile import ZipFile

import numpy as np
import pytest

from analytic.scenefile.read import load_scene
from analytic.surface.heightmap import HeightMap, levelled, read_height_map
from tests.analytic.scenefile.scene_texts import LUBRICANT, PLAIN
from tests.refusals import refused

SPACING = 1.7e-6  # m
rng = np.random.default_rng(11)
ROUGH = 1e-7 * rng.standard_normal((40, 53))
INDEX = """<?xml version="1.0" encoding="UTF-8"?>
<p:ISO5436_2 xmlns:p="http://www.opengps.eu/2008/ISO5436_2">
<Record1><Revision>ISO5436 - 2000</Revision><FeatureType>SUR</FeatureType><Axes>
<CX><AxisType>I</AxisType><DataType>D</DataType><Increment>{x}</Increment><Offset>0</Offset></CX>
<CY><AxisType>I</AxisType><DataType>D</DataType><Increment>{y}</Increment><Offset>0</Offset></CY>
<CZ><AxisType>A</AxisType><DataType>{kind}</DataType><Increment>{z}</Increment><Offset>0</Offset></CZ>
</Axes></Record1>
<Record3><MatrixDimension><SizeX>{columns}</SizeX><SizeY>{rows}</SizeY><SizeZ>1</SizeZ></MatrixDimension>
<DataLink><PointDataLink>bindata/data.bin</PointDataLink></DataLink></Record3>
</p:ISO5436_2>
"""


def x3p(
    file: Path, heights: np.ndarray, *, x: float = SPACING, y: float = SPACING, z: float = 1.0, kind: str = "D"
) -> Path:
    rows, columns = heights.shape
    with ZipFile(file, "w") as folder:
        folder.writestr("main.xml", INDEX.format(x=x, y=y, z=z, kind=kind, rows=rows, columns=columns))
        folder.writestr("bindata/data.bin", heights.astype({"D": "<f8", "F": "<f4", "L": "<i4"}[kind]).tobytes())
    return file


@pytest.fixture
def reader() -> None:
    pytest.importorskip("SurfaceTopography", reason="it is an extra")


@pytest.mark.usefixtures("reader")
def test_heights_and_spacing_are_those_that_were_written(tmp_path: Path) -> None:
    """Rows stay rows: the map is not square."""
    found = read_height_map(x3p(tmp_path / "race.X3P", ROUGH), spacing=SPACING)
    np.testing.assert_allclose(found.heights, levelled(HeightMap(heights=ROUGH, spacing=SPACING)).heights, atol=1e-20)
    text = PLAIN + LUBRICANT + '[surface]\nheight_map = { path = "race.X3P" }\n'
    (tmp_path / "scene.toml").write_text(text)
    surface = load_scene(tmp_path / "scene.toml").surface
    assert surface is not None
    assert surface.height_map is not None
    assert surface.height_map.spacing == pytest.approx(SPACING, rel=1e-12)
    assert Path(surface.height_map.path) == tmp_path / "race.X3P"


@pytest.mark.usefixtures("reader")
def test_the_increment_of_z_is_that_of_integers(tmp_path: Path) -> None:
    """Floating-point heights are metres whatever the increment; integers are steps of it."""
    expected = levelled(HeightMap(heights=ROUGH, spacing=SPACING)).heights
    for kind, rounding in (("D", 1e-20), ("F", 1e-13)):
        found = read_height_map(x3p(tmp_path / f"{kind}.x3p", ROUGH, z=1e-6, kind=kind), spacing=SPACING)
        np.testing.assert_allclose(found.heights, expected, atol=rounding)
    steps = x3p(tmp_path / "steps.x3p", np.round(ROUGH / 2e-10), z=2e-10, kind="L")
    np.testing.assert_allclose(read_height_map(steps, spacing=SPACING).heights, expected, atol=2e-10)  # a step
    none = x3p(tmp_path / "none.x3p", np.round(ROUGH / 2e-10), z=0.0, kind="L")
    refused(lambda: read_height_map(none, spacing=SPACING), "none.x3p", "steps of 0 m")


@pytest.mark.usefixtures("reader")
def test_what_is_no_map_on_a_square_grid_is_refused_in_one_line(tmp_path: Path) -> None:
    def read(name: str) -> None:
        read_height_map(tmp_path / name, spacing=SPACING)

    x3p(tmp_path / "oblong.x3p", ROUGH, y=2.3e-6)
    refused(lambda: read("oblong.x3p"), "oblong.x3p", "1.7 um along x and 2.3 um along y", "square grid")
    x3p(tmp_path / "other.x3p", ROUGH, x=3e-6, y=3e-6)
    refused(lambda: read("other.x3p"), "other.x3p", "every 3 um, got spacing 1.7 um")
    x3p(tmp_path / "small.x3p", ROUGH[:7])
    refused(lambda: read("small.x3p"), "small.x3p", "7 by 53 points")
    gap = ROUGH.copy()
    gap[3, 5] = np.nan
    x3p(tmp_path / "gap.x3p", gap)
    refused(lambda: read("gap.x3p"), "gap.x3p", "row 3, column 5", "not finite")
    (tmp_path / "text.x3p").write_text("no zip")
    refused(lambda: read("text.x3p"), "text.x3p", "is no X3P file")
    refused(lambda: read("gone.x3p"), "gone.x3p", "No such file")


def test_without_the_reader_one_line_names_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    file = x3p(tmp_path / "race.x3p", ROUGH)
    refused(lambda: read_height_map(file, spacing=SPACING), "race.x3p", "not installed", "fembearing[profilometer]")
    (tmp_path / "scene.toml").write_text(PLAIN + LUBRICANT + '[surface]\nheight_map = { path = "race.x3p" }\n')
    refused(lambda: load_scene(tmp_path / "scene.toml"), "surface.height_map.path = 'race.x3p'", "[profilometer]")


@pytest.mark.parametrize(
    ("table", "words"),
    [
        ('{ path = "race.x3p", spacing = "2 um" }', ("surface.height_map.spacing = '2 um'", "has its own")),
        ('{ path = "race.npy" }', ("surface.height_map.spacing is missing", '"2 um"')),
    ],
)
def test_the_spacing_is_given_where_the_file_has_none(tmp_path: Path, table: str, words: tuple[str, ...]) -> None:
    (tmp_path / "scene.toml").write_text(PLAIN + LUBRICANT + f"[surface]\nheight_map = {table}\n")
    refused(lambda: load_scene(tmp_path / "scene.toml"), *words)
