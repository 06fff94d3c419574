"""Height maps in files of instruments, which SurfaceTopography reads in a process of its own."""

import sys
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np
import pytest

from analytic.surface.heightmap import read_height_map
from tests.analytic.surface.map_files import ROUGH, SPACING, formless, sur
from tests.refusals import refused

STEPS = np.round(ROUGH / 1e-10)


@pytest.fixture
def reader() -> None:
    pytest.importorskip("SurfaceTopography", reason="it is an extra")


@pytest.mark.usefixtures("reader")
def test_heights_and_spacing_are_those_that_were_written(tmp_path: Path) -> None:
    """In the unit of the file, which rounds to single precision."""
    found = read_height_map(sur(tmp_path / "race.SUR", STEPS))
    np.testing.assert_allclose(found.heights, formless(ROUGH), atol=1e-10)  # a step
    assert found.spacing == pytest.approx(SPACING, rel=1e-7)


@pytest.mark.usefixtures("reader")
def test_of_several_maps_of_heights_the_first_counts(tmp_path: Path) -> None:
    """A file of Gwyddion, whose names, sizes and units stand in front of the heights."""
    from SurfaceTopography import Topography

    rows, columns = ROUGH.shape
    sizes = (1e9 * SPACING * columns, 1e9 * SPACING * rows)
    Topography(1e9 * ROUGH.T, sizes, unit="nm").to_gwy(str(tmp_path / "race.gwy"))
    found = read_height_map(tmp_path / "race.gwy")
    np.testing.assert_allclose(found.heights, formless(ROUGH), atol=1e-20)  # round-off
    assert found.warnings == ()


@pytest.mark.usefixtures("reader")
def test_what_is_no_map_is_refused_in_one_line(tmp_path: Path) -> None:
    def read(file: Path, *words: str) -> None:
        refused(lambda: read_height_map(file), file.name, *words)

    read(sur(tmp_path / "time.sur", STEPS, unit=b"s"), ".x3p")
    read(sur(tmp_path / "large.sur", np.zeros((33, 5000))), "33 by 5000 points")
    (tmp_path / "words.opd").write_text("no map")
    read(tmp_path / "words.opd", "cannot be read")
    with ZipFile(tmp_path / "large.plux", "w", ZIP_DEFLATED) as archive, archive.open("index.xml", "w") as part:
        for _ in range(31):
            part.write(bytes(10_000_000))
    read(tmp_path / "large.plux", "unpacks to more than 300 MB")


def test_without_the_reader_one_line_names_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    file = sur(tmp_path / "race.sur", STEPS)
    refused(lambda: read_height_map(file), "race.sur", "not installed", "fembearing[profilometer]")
