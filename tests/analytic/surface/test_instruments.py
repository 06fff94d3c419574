"""Height maps in files of instruments, which SurfaceTopography reads in a process of its own."""

import sys
from collections.abc import Callable
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile

import numpy as np
import pytest

from analytic.surface.heightmap import read_height_map
from tests.analytic.surface.map_files import ROUGH, SPACING, formless, opd, plu, sur
from tests.refusals import refused

STEPS = np.round(ROUGH / 1e-10)


@pytest.fixture
def reader() -> None:
    pytest.importorskip("SurfaceTopography", reason="it is an extra")


@pytest.mark.usefixtures("reader")
@pytest.mark.parametrize(
    ("write", "rounding"),
    [
        (lambda file: sur(file.with_suffix(".SUR"), STEPS), 1e-10),  # a step
        (lambda file: opd(file.with_suffix(".opd"), ROUGH), 1e-13),  # single precision
    ],
    ids=["sur", "opd"],
)
def test_heights_and_spacing_are_those_that_were_written(
    tmp_path: Path, write: Callable[[Path], Path], rounding: float
) -> None:
    """In the units of the file, and rows stay rows."""
    found = read_height_map(write(tmp_path / "race"))
    np.testing.assert_allclose(found.heights, formless(ROUGH), atol=rounding)
    assert found.spacing == pytest.approx(SPACING, rel=1e-7)  # single precision
    assert found.warnings == ()


@pytest.mark.usefixtures("reader")
def test_of_several_maps_the_first_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Modules in the folder of the scene, which may be a stranger's, are not run."""
    (tmp_path / "SurfaceTopography.py").write_text("raise SystemExit")
    monkeypatch.chdir(tmp_path)
    found = read_height_map(plu(tmp_path / "race.plu", ROUGH, 3 * ROUGH[::-1]))
    np.testing.assert_allclose(found.heights, formless(ROUGH), atol=1e-13)  # single precision
    assert "2 maps of heights" in found.warnings[0]


@pytest.mark.usefixtures("reader")
def test_what_is_no_map_is_refused_in_one_line(tmp_path: Path) -> None:
    def read(file: Path, *words: str) -> None:
        refused(lambda: read_height_map(file), file.name, *words)

    read(sur(tmp_path / "time.sur", STEPS, unit=b"s"), ".x3p")
    read(sur(tmp_path / "large.sur", np.zeros((33, 5000))), "33 by 5000 points")
    (tmp_path / "words.opd").write_text("no map")
    read(tmp_path / "words.opd", "cannot be read")
    with (
        ZipFile(tmp_path / "large.plux", "w", ZIP_DEFLATED, compresslevel=1) as archive,
        archive.open("index.xml", "w") as part,
    ):
        for _ in range(31):
            part.write(bytes(10_000_000))
    read(tmp_path / "large.plux", "unpacks to more than 300 MB")


def test_without_the_reader_one_line_names_the_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "SurfaceTopography", None)
    file = sur(tmp_path / "race.sur", STEPS)
    refused(lambda: read_height_map(file), "needs SurfaceTopography", ".[profilometer]")
