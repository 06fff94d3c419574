"""Height maps in X3P files as instruments write them, and as nobody should."""

from pathlib import Path
from zipfile import ZIP_BZIP2, ZIP_DEFLATED, ZIP_LZMA, ZipFile

import numpy as np
import pytest

from analytic.scenefile.read import load_scene
from analytic.surface.heightmap import read_height_map
from analytic.surface.roughness import gap_roughness
from tests.analytic.scenefile.scene_texts import LUBRICANT, PLAIN
from tests.analytic.surface.map_files import ROUGH, SPACING, formless, x3p
from tests.refusals import refused

STEP = 2e-10  # m
STEPS = np.round(ROUGH / STEP)
GAPS = np.zeros(ROUGH.shape, dtype=bool)
GAPS[3, 5:9] = GAPS[17, 30] = True


def test_heights_and_spacing_are_those_that_were_written(tmp_path: Path) -> None:
    """Rows stay rows: the map is not square. The scene gives the file alone."""
    x3p(tmp_path / "race.X3P", ROUGH)
    (tmp_path / "scene.toml").write_text(PLAIN + LUBRICANT + '[surface]\nheight_map = { path = "race.X3P" }\n')
    surface = load_scene(tmp_path / "scene.toml").surface
    assert surface is not None
    found = gap_roughness(surface).height_map
    assert found is not None
    np.testing.assert_allclose(found.heights, formless(ROUGH), atol=1e-20)  # round-off of 1e-7
    assert (found.spacing, found.warnings) == (SPACING, ())


@pytest.mark.parametrize(
    ("heights", "said", "rounding"),
    [
        (ROUGH, {"z": 1e-6}, 1e-20),  # floating-point heights are metres whatever the increment
        (ROUGH, {"z": 1e-6, "kind": "F"}, 1e-13),  # digits of single precision
        (STEPS, {"z": STEP, "kind": "L"}, STEP),
        (STEPS, {"z": STEP, "kind": "I"}, STEP),
        (ROUGH, {"folder": "race 7/"}, 1e-20),
        (ROUGH, {"listed": True}, 1e-20),
    ],
)
def test_every_way_to_write_the_same_heights(tmp_path: Path, heights: np.ndarray, said: dict, rounding: float) -> None:
    found = read_height_map(x3p(tmp_path / "race.x3p", heights, **said), spacing=SPACING)
    np.testing.assert_allclose(found.heights, formless(ROUGH), atol=rounding)


def test_spacings_that_differ_by_rounding_count_by_their_mean(tmp_path: Path) -> None:
    x3p(tmp_path / "race.x3p", ROUGH, x=2.27998e-6, y=2.27979e-6)
    found = read_height_map(tmp_path / "race.x3p")
    assert found.spacing == pytest.approx(2.279885e-6, rel=1e-12)  # round-off
    assert "2.27998 um apart along x and 2.27979 um along y" in found.warnings[0]
    assert read_height_map(tmp_path / "race.x3p", spacing=2.28e-6).spacing == found.spacing


@pytest.mark.parametrize("way", ["valid", "listed", "nan"])
def test_gaps_are_named_with_their_share(tmp_path: Path, way: str) -> None:
    """5 of 2120 points; of integers the file of valid points says them."""
    with_gaps = np.where(GAPS, np.nan, ROUGH)
    said = {
        "valid": {"heights": STEPS, "valid": ~GAPS, "kind": "L", "z": STEP},
        "listed": {"heights": with_gaps, "listed": True},
        "nan": {"heights": with_gaps},
    }[way]
    found = read_height_map(x3p(tmp_path / "race.x3p", **said))
    assert "0.236 %" in found.warnings[0]
    np.testing.assert_allclose(found.heights[~GAPS], formless(ROUGH)[~GAPS], atol=3e-9)  # 5 of 2120 points in the form


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"y": 2.3e-6}, ("1.7 um along x and 2.3 um along y", "square grid")),
        ({"x": 3e-6, "y": 3e-6}, ("every 3 um, got spacing 1.7 um",)),
        ({"x": "nan"}, ("spacing",)),
        ({"x": 1.0, "y": 1.0}, ("every 1 m", "spacings in m")),
        ({"x": 1e-300, "y": 1e-300}, ("every 1e-300 m",)),
        ({"z": 0.0, "kind": "L"}, ("steps of 0 m",)),
        ({"kind": "Q"}, ("type Q",)),
        ({"axis": "A"}, ("axis CX",)),
        ({"feature": "PRF"}, ("holds PRF",)),
        ({"layers": 2}, ("2 layers",)),
        ({"layers": "2 or 3"}, ("2 or 3",)),
        ({"rows": 7}, ("7 by 53 points",)),
        ({"rows": 41}, ("2120 heights for 41 by 53 points",)),
    ],
)
def test_what_is_no_map_on_a_square_grid_is_refused_in_one_line(tmp_path: Path, said: dict, words: tuple) -> None:
    x3p(tmp_path / "race.x3p", ROUGH, **said)
    refused(lambda: read_height_map(tmp_path / "race.x3p", spacing=SPACING), "race.x3p", *words)


def test_a_damaged_archive_is_refused_in_one_line(tmp_path: Path) -> None:
    whole = x3p(tmp_path / "race.x3p", ROUGH).read_bytes()
    for content in (b"", b"no zip", whole[: len(whole) // 2], whole.replace(b"main.xml", b"main.txt")):
        (tmp_path / "race.x3p").write_bytes(content)
        refused(lambda: read_height_map(tmp_path / "race.x3p"), "race.x3p", ".npy")
    with ZipFile(tmp_path / "none.x3p", "w") as archive:
        archive.writestr("main.xml", "<no><xml></no>")
    refused(lambda: read_height_map(tmp_path / "none.x3p"), "none.x3p")


@pytest.mark.parametrize("part", ["main.xml", "bindata/data.bin"])
def test_a_part_that_unpacks_to_much_is_read_no_further_than_it_may_be_long(tmp_path: Path, part: str) -> None:
    """60 MB in a file of 60 kB; nothing of this size is unpacked."""
    file = x3p(tmp_path / "race.x3p", ROUGH)
    with ZipFile(file) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    with ZipFile(file, "w", ZIP_DEFLATED) as archive:
        for name, content in (parts | {part: bytes(60_000_000)}).items():
            archive.writestr(name, content)
    refused(lambda: read_height_map(file), "race.x3p", f"{Path(part).name} of more than")


@pytest.mark.parametrize("method", [ZIP_BZIP2, ZIP_LZMA])
def test_a_compression_without_limit_is_refused(tmp_path: Path, method: int) -> None:
    """zipfile unpacks a block of bzip2 or LZMA as a whole, even if the caller reads a few bytes."""
    file = x3p(tmp_path / "race.x3p", ROUGH)
    with ZipFile(file) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    with ZipFile(file, "w", method) as archive:
        for name, content in parts.items():
            archive.writestr(name, content)
    refused(lambda: read_height_map(file), "race.x3p", "compression", "save it again")


def test_entities_that_would_grow_without_limit_are_refused(tmp_path: Path) -> None:
    grown = "".join(f'<!ENTITY e{n + 1} "{f"&e{n};" * 10}">' for n in range(9))
    file = x3p(tmp_path / "race.x3p", ROUGH, doctype=f'<!DOCTYPE p [<!ENTITY e0 "e">{grown}]>', feature="&e9;")
    refused(lambda: read_height_map(file), "race.x3p", "document type")
