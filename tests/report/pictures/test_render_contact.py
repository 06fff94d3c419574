"""Map, section and view of a contact, from bodies of one cell each: where their parts are, and how large."""

import base64
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import pyvista as pv
from vtkmodules.vtkCommonDataModel import vtkTriQuadraticHexahedron

from fembearing.report.pictures.framing import BAR, TITLE
from fembearing.report.pictures.render import BARE, VIEW, pressure_map, section
from fembearing.report.pictures.render_mesh import BODIES, HERTZ, INK, LINES, SHOULDER, STEEP
from fembearing.report.pictures.render_view import contact_view
from tests.report.pictures.sketch import Window, sketched

PLACES = np.reshape(vtkTriQuadraticHexahedron().GetParametricCoords(), (27, 3))
WIDE = {"lower": 2.0, "upper": 9.0}  # mm: reach of a body along rolling
ENDS = {False: (0.0, 1.6), True: (-1.2, 1.6)}  # mm: of both across, by whether half of the contact is meshed
LIFTED = 0.9  # mm
SINGLE = 1e-4  # mm: single precision of VTK's points, at 10 mm


def nodes_of(side: str, *, half: bool) -> np.ndarray:
    """(27, 3) mm: a groove 0.8 mm deep, or a ball on it 1.3 mm high, of one cell with a curved face."""
    first, last = ENDS[half]
    x, y = WIDE[side] * PLACES[:, 0], first + (last - first) * PLACES[:, 1]
    z = 0.03 * x**2 + 0.05 * y**2 + (0.8 * (PLACES[:, 2] - 1) if side == "lower" else 1.3 * PLACES[:, 2])
    return np.column_stack([x, y, z])


def job_of(folder: Path, *, half: bool = False, **other: object) -> dict[str, Any]:
    """The greatest pressure, 2 GPa, in the middle of a quarter; none at its edges."""
    job: dict[str, Any] = {}
    for side in BODIES:
        places = nodes_of(side, half=half)
        x, y, _ = places.T
        loaded = PLACES[:, 2] == (side == "lower")
        body = pv.UnstructuredGrid({pv.CellType.TRIQUADRATIC_HEXAHEDRON: np.arange(27)[None]}, places / 1e3)
        body.point_data["pressure"] = np.where(loaded, 2e9 * (1 - (x / WIDE[side]) ** 2) * (1 - (y / 1.6) ** 2), 0.0)
        body.point_data["surface"] = loaded.astype(np.int32)
        body.save(folder / f"{side}.vtu")
        job[side] = str(folder / f"{side}.vtu")
    rest = {
        "unit": "GPa",
        "factor": 1e-9,
        "peak": 2.0,
        "ticks": [0.0, 0.5, 1.5],
        "title": "a contact",
        "near": "The race near the contact",
        "hertz": [0.6e-3, 0.4e-3],
        "computed": [0.7e-3, 0.5e-3],
        "centroid": 0.12e-3,
        "shoulders": [],
        "half": half,
        "lifted": LIFTED / 1e3,
    }
    return job | rest | other


def frame_of(*, horizontal: bool) -> dict[str, Any]:
    """Wider than high, and the reverse; 100 pixels are 1 mm, and the contact is not in the middle."""
    width, height = (1000, 490) if horizontal else (900, 950)
    frame = {"width": width, "height": height, "scale": 1e5, "centre": (width / 2, 190), "bar": 2e-3}
    return frame | {"rolling_is_horizontal": horizontal}


def on_map(frame: dict[str, Any], x: Any, y: Any) -> np.ndarray:
    """(n, 2) pixels of places in mm: y upwards, or to the right."""
    (left, top), horizontal = frame["centre"], frame["rolling_is_horizontal"]
    right, up = (x, y) if horizontal else (y, -np.asarray(x))
    return np.column_stack([left + 100 * np.asarray(right), frame["height"] - top + 100 * np.asarray(up)])


def require_around(window: Window, mesh: Any, corners: np.ndarray) -> None:
    """A part reaches as far as these two corners on each side."""
    expected = np.sort(corners, axis=0)
    np.testing.assert_allclose(window.box(mesh)[:, :2], expected, atol=100 * SINGLE)  # 100 pixels to 1 mm


@pytest.mark.parametrize("horizontal", [True, False])
def test_a_map_has_everything_to_scale_about_the_contact(tmp_path: Path, horizontal: bool) -> None:
    """The surface whole from its half, the ellipses, and pressure up to both shoulders."""
    frame = frame_of(horizontal=horizontal)
    job = job_of(tmp_path, half=True, frame=frame, shoulders=[-0.9e-3, 0.7e-3])
    window = sketched(pressure_map, job).window
    assert (window.width, window.height) == (frame["width"], frame["height"])
    require_around(window, window.of(BARE)[0], on_map(frame, [-2, 2], [-1.2, 1.6]))
    require_around(window, window.of(LINES)[0], on_map(frame, [-2, 2], [-1.2, 1.6]))
    require_around(window, window.of(HERTZ)[0], on_map(frame, [-0.6, 0.6], [-0.4, 0.4]))
    require_around(window, window.of(INK)[0], on_map(frame, [-0.7, 0.7], [0.12 - 0.5, 0.12 + 0.5]))
    (pressed,) = (part.mesh for part in window.parts if part.look.get("scalars") == "pressure")
    np.testing.assert_allclose(pressed.bounds[2:4], (-0.9, 0.7), atol=SINGLE)
    assert pressed["pressure"].min() >= 0.005 * 2.0 - 1e-6  # GPa: single precision
    for line, y in zip(window.of(SHOULDER), (-0.9, 0.7), strict=True):
        low, high = window.box(line)[:, :2]
        at, along = (1, 0) if horizontal else (0, 1)
        np.testing.assert_allclose((low[at], high[at]), on_map(frame, 0.0, y)[0, at], atol=100 * SINGLE)
        assert low[along] < 0 < frame["width" if horizontal else "height"] < high[along]  # from edge to edge
        assert high[along] - low[along] < 4 * max(window.width, window.height)  # VTK has single precision
    order = [window.of(BARE)[0], pressed, window.of(LINES)[0], window.of(INK)[0], window.of(HERTZ)[0]]
    layers = [window.box(mesh)[:, 2] for mesh in order]
    for behind, before in pairwise(layers):
        assert behind[0] < before[0] > behind[1] - 0.2  # pixels: the lowest place is between two nodes of the cell
    assert min(window.box(line)[0, 2] for line in window.of(SHOULDER)) > layers[-1][1]
    assert window.box(window.of(INK)[1])[0, 2] > layers[2][0]


@pytest.mark.parametrize("horizontal", [True, False])
def test_bars_and_words_of_a_map_stand_in_the_strips_that_are_kept_for_them(tmp_path: Path, horizontal: bool) -> None:
    frame = frame_of(horizontal=horizontal)
    sketch = sketched(pressure_map, job_of(tmp_path, frame=frame, shoulders=[0.7e-3]))
    window, width, height = sketch.window, frame["width"], frame["height"]
    low, high = window.box(window.of(INK)[1])[:, :2]
    np.testing.assert_allclose(high - low, (200, 0), atol=100 * SINGLE)  # 2 mm
    scale, title = window.word("2 mm, "), window.word("a contact")
    assert scale.text == ("2 mm, rolling" if horizontal else "2 mm, transverse")
    assert 0 < scale.left == pytest.approx(low[0], abs=100 * SINGLE)
    assert 0 < low[1] < scale.bottom < scale.top < BAR
    (bar,) = (part.look["scalar_bar_args"] for part in window.parts if part.look.get("show_scalar_bar"))
    left, wide, most = width * bar["position_x"], width * bar["width"], height * (bar["position_y"] + bar["height"])
    np.testing.assert_allclose((wide, height * bar["height"]), (420, 80))  # pixels, in every picture
    assert high[0] < left < left + wide < width
    assert most < BAR
    np.testing.assert_array_equal(sketch.scalar_bars[bar["title"]].values, [0.0, 0.5, 1.5])
    others = [window.word(begin) for begin in ("red", "black", "orange")]
    assert [word.colour for word in others] == [HERTZ, INK, SHOULDER]
    assert {word.bottom for word in others} == {others[0].bottom}
    assert title.bottom > others[0].top > others[0].bottom > height - TITLE
    assert 0 < others[0].left < others[1].left - 100 < others[2].left - 200  # pixels: letters


def test_a_section_fits_both_bodies_to_its_left_half(tmp_path: Path) -> None:
    """From VIEW, cut along x = 0 and up to four half widths of the lower body around; a sixth stays free."""
    job = job_of(tmp_path)
    window = sketched(section, job).windows[0, 0]
    for side, mesh in ((side, window.of(colour)[0]) for side, colour in BODIES.items()):
        lift = LIFTED if side == "upper" else 0.0
        quarter = nodes_of(side, half=False)
        np.testing.assert_allclose(mesh.bounds[::2], (0, -1.6, lift + quarter[:, 2].min()), atol=SINGLE)
        np.testing.assert_allclose(mesh.bounds[1::2], (WIDE[side], 1.6, lift + quarter[:, 2].max()), atol=SINGLE)
    nodes = np.vstack([nodes_of(side, half=False) + lift for side, lift in (("lower", 0.0), ("upper", [0, 0, LIFTED]))])
    nodes = np.vstack([nodes, nodes * [1, -1, 1]]).clip(-4 * 1.6, 4 * 1.6)
    low, high = window.box(nodes)[:, :2]
    # pixels: VIEW is shorter than 1 by 0.3 %, which counts double where the middle is taken along it
    np.testing.assert_allclose((low + high) / 2, (375, 400), atol=2)
    assert np.max(high - low) == pytest.approx(800 / 1.2, rel=4e-3)
    assert np.min(high - low) < 600
    assert window.word("a contact").bottom > high[1]


@pytest.mark.parametrize(
    ("computed", "eye", "half_height"), [((0.1e-3, 0.5e-3), STEEP, 1.15 * 0.5), ((0.5e-3, 0.3e-3), VIEW, 1.25 * 0.5)]
)
def test_the_close_up_holds_the_longer_semi_axis(
    tmp_path: Path, computed: tuple[float, float], eye: np.ndarray, half_height: float
) -> None:
    """A slender contact is seen more from above. Pressure and lines lie on the body, not in it and not over it."""
    sketch = sketched(section, job_of(tmp_path, computed=computed))
    window = sketch.windows[0, 1]
    assert window.camera.parallel_scale == pytest.approx(half_height)
    np.testing.assert_array_equal(window.camera.focal_point, 0)
    towards = np.subtract(window.camera.position, window.camera.focal_point)
    np.testing.assert_allclose(towards / np.linalg.norm(towards), eye / np.linalg.norm(eye), rtol=1e-12)
    solid, pressed, lines = (part.mesh for part in window.parts)
    assert pressed["pressure"].max() == pytest.approx(2.0, rel=1e-6)  # single precision
    assert pressed["pressure"].min() == pytest.approx(0.005 * 2.0, rel=1e-4)
    moved = pressed.points[np.argmax(pressed["pressure"])], lines.points.min(axis=0) - solid.points.min(axis=0)
    shares = [float(each @ eye / (eye @ eye)) for each in moved]
    for each, share in zip(moved, shares, strict=True):
        np.testing.assert_allclose(each, share * eye, atol=1e-6)  # mm: single precision at 2 mm
    assert 0 < shares[0] < shares[1] < 0.01 * half_height
    assert [part.look.get("show_scalar_bar") for part in window.parts] == [None, True, None]
    assert [part.look.get("show_scalar_bar") for part in sketch.windows[0, 0].parts] == 2 * [None, False, None]
    (labels,) = sketch.scalar_bars.values()
    np.testing.assert_array_equal(labels.values, [0.0, 0.5, 1.5])
    assert window.word("The race").bottom > 0.9 * window.height


@pytest.mark.parametrize(("computed", "half_size"), [((0.1e-3, 0.5e-3), 1.3 * 0.5), ((0.5e-3, 0.45e-3), 1.7 * 0.45)])
def test_a_view_has_the_lengths_of_the_contact_in_mm(
    tmp_path: Path, computed: tuple[float, float], half_size: float
) -> None:
    view = contact_view(job_of(tmp_path, computed=computed))
    assert view["least"] == pytest.approx(0.005 * 2.0)
    assert view["half_size"] == pytest.approx(half_size)
    farthest = np.linalg.norm(nodes_of("upper", half=False), axis=1).max()
    assert view["reach"] == pytest.approx(farthest, rel=1e-6)  # single precision
    assert [each["semi_axes"] for each in view["ellipses"]] == [
        pytest.approx([0.6, 0.4]),
        pytest.approx([1e3 * part for part in computed]),
    ]
    assert [each["middle"] for each in view["ellipses"]] == [0.0, pytest.approx(0.12)]
    assert view["faces"] == 2 * 4 * 8  # eight triangles to each of four cells


@pytest.mark.parametrize("shoulders", [(-0.9, 0.7), (-0.9, None), (None, 0.7), (None, None)])
def test_a_view_knows_on_which_side_a_shoulder_is(tmp_path: Path, shoulders: tuple[float | None, float | None]) -> None:
    """Else the page would leave everything beyond the only one bare."""
    given = [y / 1e3 for y in shoulders if y is not None]
    found = contact_view(job_of(tmp_path, half=True, shoulders=given))["shoulders"]
    assert found == [y if y is None else pytest.approx(y) for y in shoulders]


def test_the_faces_of_a_view_look_out_of_their_bodies(tmp_path: Path) -> None:
    """Up from the groove and down from the ball: their shadow is as large as the body, 2 or 9 mm by 1.6 mm each way."""
    for side, body in zip(BODIES, contact_view(job_of(tmp_path))["bodies"], strict=True):
        vertices = np.frombuffer(base64.b64decode(body["vertices"]), "<f4").reshape(-1, 7).astype(float)
        corners = np.frombuffer(base64.b64decode(body["triangles"]), "<u4").reshape(-1, 3)
        first, second, third = np.moveaxis(vertices[corners, :3], 1, 0)
        shadow = np.cross(second - first, third - first)[:, 2] / 2
        up = 1 if side == "lower" else -1
        assert (up * shadow > 0).all()
        assert (up * vertices[:, 5] > 0).all()
        np.testing.assert_allclose(np.abs(shadow).sum(), 4 * WIDE[side] * 1.6, rtol=1e-6)  # single precision
        np.testing.assert_allclose((vertices[:, 6].min(), vertices[:, 6].max()), (0, 2), rtol=1e-6)
