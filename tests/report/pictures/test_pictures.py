"""Each picture is read back: is the contact in it, where it should be and as large as it should be?"""

import subprocess
import sys
import time
from dataclasses import asdict
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv
from scipy.spatial import cKDTree

from fembearing.check.validation import Validation
from fembearing.report.pictures import draw as module
from fembearing.report.pictures.draw import Picture, contact_jobs, draw_pictures
from fembearing.report.pictures.framing import BAR, frame_of
from fembearing.report.pictures.render_mesh import ROUND, cell_edges, loaded_face, scaled
from tests.analytic.specimens import present
from tests.report.pictures.odd_contacts import with_ellipses
from tests.report.pictures.picture_reader import (
    CORNER,
    check_colour_bar,
    check_ellipse,
    check_pressure,
    check_scale_bar,
    lines_of_map,
    pixels_of,
    share_of_lines,
)

PAIRS = ("inner-real", "outer-real", "pocket-real", "pocket-wall")
WARNS = r"import os, sys; os.write(2, b'\x1b[33mno GL\x1b[0m\n'); os.abort()"  # as VTK without GL does


@pytest.fixture(scope="module")
def drawn(pictures: list[Picture]) -> dict[str, Picture]:
    return {picture.file.stem: picture for picture in pictures}


@pytest.mark.parametrize("pair", PAIRS)
def test_a_pressure_picture_is_to_scale(drawn: dict[str, Picture], pair: str) -> None:
    """Hertz's ellipse, the painted pressure, both bars and the lines of the mesh."""
    picture = drawn[f"{pair}-pressure"]
    check_ellipse(picture)
    check_pressure(picture)
    check_scale_bar(picture)
    check_colour_bar(pixels_of(picture.file)[-BAR:, -CORNER:])
    assert min(lines_of_map(picture)) > 0.005  # found: 0.014 and more; without lines 0


@pytest.mark.parametrize("name", ["race", "pocket"])
def test_the_computed_ellipse_is_drawn_beside_hertz(odd_by_vtk: dict[str, Picture], name: str) -> None:
    """Both outside the painted pressure and apart: one is longer, the other wider."""
    check_ellipse(odd_by_vtk[name])
    check_ellipse(odd_by_vtk[name], computed=True)


def test_pressure_ends_at_the_shoulder_and_only_there(odd_by_vtk: dict[str, Picture]) -> None:
    """On its own side of the line, not mirrored over it."""
    picture = odd_by_vtk["cut"]
    frame, pixels = present(picture.frame), pixels_of(picture.file)
    left, top = frame.centre
    row = pixels[round(top) - 12 : round(top) + 12]  # along the middle of the contact
    painted = (np.ptp(row, axis=2) > 0.2).mean(axis=0) > 0.5  # in colours; lines are thinner than half of the row
    across = (np.flatnonzero(painted) + 0.5 - left) / frame.scale
    assert across.max() == pytest.approx(0.8e-3, abs=6e-6)  # m: the line's width, three pixels
    assert across.min() < -0.9e-3
    assert np.diff(across).max() < 0.05e-3  # nothing bare between
    red, green, blue = np.moveaxis(pixels, -1, 0)
    orange = np.flatnonzero(((red > 0.7) & (green > 0.3) & (green < 0.8) & (blue < 0.4)).mean(axis=0) > 0.5)
    assert (orange.mean() + 0.5 - left) / frame.scale == pytest.approx(0.8e-3, abs=3e-6)
    assert "y = 0.8 mm, on one side" in picture.caption


@pytest.mark.parametrize(
    ("renderer", "words"),
    [
        ((sys.executable, "-c", WARNS), "VTK ended with signal 6: no GL"),
        ((sys.executable, "-c", "raise SystemExit('no GL here')"), "status 1: no GL here"),
        ((sys.executable, "-c", ""), "status 0"),  # ends well and draws nothing
        (("/nowhere/python",), "could not be started"),
        ((sys.executable, "-c", "import time; time.sleep(60)"), "did not finish within"),
    ],
)
def test_every_way_to_fail_is_named_and_leaves_no_picture(
    checked: Validation, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, renderer: tuple[str, ...], words: str
) -> None:
    monkeypatch.setattr(module, "PATIENCE", 5 if "sleep" not in renderer[-1] else 0.5)
    found, trouble = draw_pictures(checked.contacts[:1], tmp_path, renderer=renderer)
    assert words in present(trouble)
    assert found == []
    assert {path.suffix for path in tmp_path.iterdir()} == {".vtu"}


@pytest.mark.parametrize("pair", PAIRS)
def test_a_section_shows_two_bodies_and_the_pressure_between(drawn: dict[str, Picture], pair: str) -> None:
    pixels = pixels_of(drawn[f"{pair}-section"].file)
    height, width, _ = pixels.shape
    red, _, blue = np.moveaxis(pixels, -1, 0)
    ball, lower = blue > red + 0.04, red > blue + 0.08
    left, right = np.s_[:, : width // 2], np.s_[: int(0.8 * height), width // 2 :]  # without the colour bar
    assert 0.15 < ball[left].mean() < 0.6
    assert lower[left].mean() > 0.05  # found: 0.06, the small block of a pocket beside the ball, and more
    assert np.argwhere(ball[left])[:, 0].mean() < np.argwhere(lower[left])[:, 0].mean()  # the ball lies above
    assert lower[right].mean() > 0.5  # the close-up is filled by the lower body
    vivid = np.ptp(pixels, axis=-1) > 0.45
    rows, columns = np.nonzero(vivid[right])
    assert columns.max() - columns.min() > 0.25 * width  # half the close-up is the contact
    assert abs(columns.mean() / (width / 2) - 0.5) < 0.1  # in its middle
    assert rows.size > 1000


@pytest.mark.parametrize("pair", PAIRS)
def test_a_section_has_a_colour_bar(drawn: dict[str, Picture], pair: str) -> None:
    pixels = pixels_of(drawn[f"{pair}-section"].file)
    height, width, _ = pixels.shape
    check_colour_bar(pixels[int(0.9 * height) :, width // 2 :])


@pytest.mark.parametrize("pair", PAIRS)
def test_a_section_shows_the_cells_of_both_bodies(drawn: dict[str, Picture], pair: str) -> None:
    pixels = pixels_of(drawn[f"{pair}-section"].file)
    height, width, _ = pixels.shape
    down, right = np.indices(pixels.shape[:2])
    red, _, blue = np.moveaxis(pixels, -1, 0)
    ball, lower, left = blue > red + 0.04, red > blue + 0.08, right < width // 2
    free = (down > 0.05 * height) & (down < 0.85 * height)  # of title and colour bar
    for body in (ball & left, lower & left, lower & ~left):
        assert share_of_lines(pixels, body & free, 0.02) > 0.02  # found: 0.05 and more; without lines 0.003


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("side", ["upper", "lower"])
def test_the_lines_of_the_mesh_lie_on_the_surface_they_divide(drawn: dict[str, Picture], pair: str, side: str) -> None:
    """Straight ones between the corners of coarse cells would sink into it or hang over it."""
    mesh = pv.read(drawn[f"{pair}-section"].file.with_name(f"{pair}-{side}.vtu"))
    assert isinstance(mesh, pv.UnstructuredGrid)
    mesh.points /= np.ptp(mesh.points)
    surface = mesh.extract_surface(nonlinear_subdivision=ROUND, algorithm="dataset_surface")
    lines = cell_edges(mesh)
    distance, _ = cKDTree(surface.points).query(lines.points)
    assert distance.max() < 1e-6  # of the body's size; VTK computes in single precision
    faces = mesh.extract_surface(nonlinear_subdivision=0, algorithm="dataset_surface")
    assert lines.n_cells == faces.extract_all_edges().n_cells  # all of them, each once
    middles = lines.points[lines.lines.reshape(lines.n_cells, -1)[:, 1 + 2**ROUND // 2]]
    ends = lines.points[lines.lines.reshape(lines.n_cells, -1)[:, [1, -1]]].mean(axis=1)
    assert np.linalg.norm(middles - ends, axis=1).max() > 0.002  # of the body's size: a chord would be seen


@pytest.mark.parametrize("pair", PAIRS)
def test_pressure_is_painted_on_the_loaded_surface_alone(drawn: dict[str, Picture], pair: str) -> None:
    """None on the cut below its edge."""
    mesh = scaled(str(drawn[f"{pair}-section"].file.with_name(f"{pair}-lower.vtu")), {"factor": 1.0})
    face = loaded_face(mesh)
    assert face.n_cells > 0
    for axis in (0, 1):
        cut = np.abs(face.points[:, axis]) < 1e-9  # mm
        assert not cut[face.regular_faces].all(axis=1).any()


def test_a_job_has_room_for_both_ellipses_and_names_the_body_near_the_contact(
    checked: Validation, tmp_path: Path
) -> None:
    """Each ellipse is the longer one in one direction; the ball is lifted by 0.35 of its radius at most."""
    for contact, body in ((checked.contacts[0], "race"), (checked.contacts[2], "pocket")):
        for computed, hertz in (((1.2, 1.1), (0.9, 1.3)), ((0.8, 1.4), (1.6, 0.7))):
            odd = with_ellipses(contact, computed=computed, hertz=hertz)
            by_fe, by_hertz = odd.numbers.reference, odd.numbers.hertz
            longer, wider = (by_fe, by_hertz) if computed[0] > hertz[0] else (by_hertz, by_fe)
            frame = frame_of(
                semi_axis_rolling=longer.semi_axis_rolling, semi_axis_transverse=wider.semi_axis_transverse
            )
            pressure, section, _ = contact_jobs(odd, tmp_path)
            assert pressure["frame"] == asdict(frame)
            assert section["near"] == f"The {body} near the contact"
            width = float(contact.meshes[-1].pair.lower.mesh.doflocs[1].max())
            assert section["lifted"] == min(0.35 * contact.contact.ball_radius, width)


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="only Linux says whether a process is there")
def test_a_renderer_ends_with_the_process_that_was_killed(tmp_path: Path) -> None:
    slow = (
        "import os, time\nfrom pathlib import Path\nfrom fembearing.report.pictures import render\n"
        f"def draw(job): Path({str(tmp_path / 'number')!r}).write_text(str(os.getpid())); time.sleep(100)\n"
        "render.KINDS['slow'] = draw\nrender.main()"
    )
    asks = (
        "import sys\nfrom fembearing.report.pictures.draw import rendered\n"
        f"rendered([{{'kind': 'slow', 'file': 'none.png'}}], (sys.executable, '-c', {slow!r}))"
    )
    asking = subprocess.Popen([sys.executable, "-c", asks])
    try:
        while not (tmp_path / "number").exists() or not (tmp_path / "number").read_text():
            assert asking.poll() is None
            time.sleep(0.05)
    finally:
        asking.kill()
        asking.wait()
    renderer = Path("/proc", (tmp_path / "number").read_text(), "stat")
    for _ in range(600):  # it dies at once; the machine may be busy
        if not renderer.exists() or renderer.read_text().rpartition(")")[2].split()[0] == "Z":
            break
        time.sleep(0.1)
    else:
        pytest.fail("the renderer goes on")
