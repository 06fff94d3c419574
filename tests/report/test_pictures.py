"""Each picture is read back: is the contact in it, where it should be and as large as it should be?"""

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import pyvista as pv
from matplotlib import colormaps
from matplotlib.image import imread
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from fembearing.compare.discrepancy import ContactSolution
from fembearing.compare.validation import Validation
from fembearing.report import pictures as module
from fembearing.report.framing import BAR, TITLE, Frame, frame_of
from fembearing.report.pictures import RENDERER, Picture, draw_pictures
from fembearing.report.render import ROUND, cell_edges, loaded_face, scaled

Pixels = NDArray[np.float64]
PAIRS = ("inner-real", "outer-real", "pocket-real", "pocket-wall")
CORNER = 460  # pixels from the right: the colour bar's
PEN = 3.0  # pixels: the width of the ellipse's line
DIES = (sys.executable, "-c", "import os, signal; os.kill(os.getpid(), signal.SIGABRT)")  # as VTK without GL does


@pytest.fixture(scope="module")
def drawn(checked: Validation, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Picture]:
    found, trouble = draw_pictures(checked.contacts, tmp_path_factory.mktemp("vtk"))
    assert trouble is None
    return {picture.file.stem: picture for picture in found}


@pytest.fixture(scope="module")
def mapped(checked: Validation, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Picture]:
    found, trouble = draw_pictures(checked.contacts, tmp_path_factory.mktemp("maps"), renderer=DIES)
    assert trouble is not None
    assert "signal 6" in trouble
    return {picture.file.stem: picture for picture in found}


def pixels_of(file: Path) -> Pixels:
    """(height, width, 3), 0 to 1."""
    return imread(file)[..., :3].astype(float)


def middle_of(frame: Frame, pixels: Pixels) -> Pixels:
    """The picture without title and colour bar."""
    _, top = frame.centre
    room = int(min(top - TITLE, frame.height - top - BAR))
    return pixels[int(top) - room : int(top) + room, :]


def half_sizes(marked: NDArray[np.bool_]) -> tuple[float, float, float, float]:
    """Half width, half height, and the middle from left and top, of what is marked, in pixels."""
    rows, columns = np.nonzero(marked)
    assert rows.size, "nothing of that colour in the picture"
    return (
        (columns.max() - columns.min() + 1) / 2,
        (rows.max() - rows.min() + 1) / 2,
        (columns.max() + columns.min() + 1) / 2,
        (rows.max() + rows.min() + 1) / 2,
    )


def is_red(pixels: Pixels) -> NDArray[np.bool_]:
    return (pixels[..., 0] > 0.75) & (pixels[..., 1] < 0.35) & (pixels[..., 2] < 0.35)


def is_black(pixels: Pixels) -> NDArray[np.bool_]:
    """Black or its blurred edge; the colour scale starts in violet."""
    return (pixels.max(axis=-1) < 0.45) & (np.ptp(pixels, axis=-1) < 0.12)


def is_pressed(pixels: Pixels) -> NDArray[np.bool_]:
    """Of the colour scale: far from grey, and not the red line."""
    return (np.ptp(pixels, axis=-1) > 0.2) & (pixels[..., 0] < pixels[..., 1:].max(axis=-1) + 0.2)


def on_screen(frame: Frame, rolling: float, transverse: float) -> tuple[float, float]:
    """Half width and half height in pixels."""
    return frame.scale * (rolling if frame.rolling_is_horizontal else transverse), frame.scale * (
        transverse if frame.rolling_is_horizontal else rolling
    )


def check_ellipse(picture: Picture, *, computed: bool = False) -> None:
    """Hertz's ellipse in red, or the computed one in black."""
    frame = picture.frame
    assert frame is not None
    pixels = pixels_of(picture.file)
    assert pixels.shape == (frame.height, frame.width, 3)
    line, ellipse = (is_black, picture.contact.reference) if computed else (is_red, picture.contact.hertz)
    width, height, left, top = half_sizes(line(middle_of(frame, pixels)))
    expected = on_screen(frame, ellipse.semi_axis_rolling, ellipse.semi_axis_transverse)
    np.testing.assert_allclose((width, height), expected, atol=PEN)  # half the line lies outside, blurred by a pixel
    shown = middle_of(frame, pixels).shape
    np.testing.assert_allclose((left, top), (frame.centre[0], shown[0] / 2), atol=2)  # pixels


def check_pressure(picture: Picture) -> None:
    frame, computed = picture.frame, picture.contact.reference
    assert frame is not None
    pixels = middle_of(frame, pixels_of(picture.file))
    width, height, *_ = half_sizes(is_pressed(pixels))
    expected = on_screen(frame, computed.semi_axis_rolling, computed.semi_axis_transverse)
    # Pressure ends between two nodes, and the nodes near the edge lie up to 6 % of a semi-axis apart on these meshes.
    np.testing.assert_allclose((width, height), expected, rtol=0.06, atol=PEN)
    brightness = pixels.sum(axis=-1)
    row, column = pixels.shape[0] // 2, pixels.shape[1] // 2
    inside = brightness[row, column]
    edge = brightness[row, int(column + 0.93 * expected[0])]
    assert inside > 1.4 * edge  # viridis: yellow where pressure is high, violet where it is low


def longest_run(marked: NDArray[np.bool_]) -> int:
    """Of marked pixels beside each other in one row."""
    steps = np.diff(np.pad(marked.astype(int), ((0, 0), (1, 1))), axis=1)
    starts, ends = np.nonzero(steps == 1)[1], np.nonzero(steps == -1)[1]  # both in the order of the rows
    return int((ends - starts).max(initial=0))


def check_scale_bar(picture: Picture) -> None:
    """As long as it says, measured by Hertz's ellipse, which is drawn to scale."""
    frame, hertz = picture.frame, picture.contact.hertz
    assert frame is not None
    pixels = pixels_of(picture.file)
    corner = pixels[-BAR // 2 :, : frame.width - CORNER]  # left of the colour bar
    length = longest_run(corner.max(axis=-1) < 0.35)  # its ink
    width, *_ = half_sizes(is_red(middle_of(frame, pixels)))
    widest = hertz.semi_axis_rolling if frame.rolling_is_horizontal else hertz.semi_axis_transverse
    # Round caps of a thick line reach out by its width, and the ellipse's line lies half outside.
    np.testing.assert_allclose(length, frame.bar * width / widest, rtol=0.01, atol=2 * PEN)


def check_colour_bar(corner: Pixels) -> None:
    """One row through the bar holds viridis from end to end."""
    vivid = np.ptp(corner, axis=-1) > 0.2
    count = vivid.sum(axis=1)
    assert count.max() > 300, "no colour bar"  # pixels
    through = int(np.median(np.flatnonzero(count > 0.9 * count.max())))
    columns = np.flatnonzero(vivid[through])
    share = np.array([0.02, 0.25, 0.5, 0.75, 0.98])  # at the very ends the pixels are blurred
    found = corner[through, np.round(columns[0] + share * np.ptp(columns)).astype(int)]
    np.testing.assert_allclose(found, colormaps["viridis"](share)[:, :3], atol=0.06)  # a map has 60 steps of colour


def share_of_lines(pixels: Pixels, where: NDArray[np.bool_], step: float) -> float:
    """Of the pixels `where`: those darker by `step` than the pixels of the same surface on both sides of them."""
    brightness, beside = pixels.mean(axis=-1), 3  # pixels: more than a line's half width
    found = np.zeros_like(where)
    for axis in (0, 1):
        darkest = np.minimum(np.roll(brightness, beside, axis), np.roll(brightness, -beside, axis))
        inside = np.roll(where, beside, axis) & np.roll(where, -beside, axis)
        found |= inside & (brightness < darkest - step)
    return float(found.sum() / where.sum())


def lines_of_map(picture: Picture) -> list[float]:
    """The share of mesh lines in each quarter of the picture, on the pressed surface and on the bare one around it."""
    frame, hertz = picture.frame, picture.contact.hertz
    assert frame is not None
    pixels = middle_of(frame, pixels_of(picture.file))
    down, right = np.indices(pixels.shape[:2])
    right, down = right + 0.5 - frame.centre[0], down + 0.5 - pixels.shape[0] / 2
    width, height = on_screen(frame, hertz.semi_axis_rolling, hertz.semi_axis_transverse)
    reach = np.hypot(right / width, down / height)
    surfaces = reach < 0.85, reach > 1.15  # between them run the ellipses
    quarters = [(right * x > 0) & (down * y > 0) for x in (-1, 1) for y in (-1, 1)]
    return [share_of_lines(pixels, surface & quarter, 0.01) for surface in surfaces for quarter in quarters]


@pytest.mark.parametrize("pair", PAIRS)
def test_vtk_draws_hertz_ellipse_to_scale(drawn: dict[str, Picture], pair: str) -> None:
    check_ellipse(drawn[f"{pair}-pressure"])


@pytest.mark.parametrize("pair", PAIRS)
def test_vtk_paints_the_pressure_where_the_contact_is(drawn: dict[str, Picture], pair: str) -> None:
    check_pressure(drawn[f"{pair}-pressure"])


@pytest.mark.parametrize("pair", PAIRS)
def test_a_renderer_that_dies_leaves_a_map_that_says_the_same(mapped: dict[str, Picture], pair: str) -> None:
    check_ellipse(mapped[f"{pair}-pressure"])
    check_pressure(mapped[f"{pair}-pressure"])


def test_there_is_no_section_without_vtk(mapped: dict[str, Picture]) -> None:
    assert {name.rpartition("-")[2] for name in mapped} == {"pressure"}
    assert not list(next(iter(mapped.values())).file.parent.glob("*section*"))


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
@pytest.mark.parametrize("renderer", ["drawn", "mapped"])
def test_both_bars_of_a_pressure_picture_are_right(request: pytest.FixtureRequest, renderer: str, pair: str) -> None:
    pictures: dict[str, Picture] = request.getfixturevalue(renderer)
    picture = pictures[f"{pair}-pressure"]
    check_scale_bar(picture)
    check_colour_bar(pixels_of(picture.file)[-BAR:, -CORNER:])


@pytest.mark.parametrize("pair", PAIRS)
def test_a_section_has_a_colour_bar(drawn: dict[str, Picture], pair: str) -> None:
    pixels = pixels_of(drawn[f"{pair}-section"].file)
    height, width, _ = pixels.shape
    check_colour_bar(pixels[int(0.9 * height) :, width // 2 :])


@pytest.mark.parametrize("pair", PAIRS)
def test_a_pressure_picture_shows_the_mesh(drawn: dict[str, Picture], pair: str) -> None:
    assert min(lines_of_map(drawn[f"{pair}-pressure"])) > 0.005  # found: 0.014 and more; without lines 0


@pytest.mark.parametrize("pair", PAIRS)
def test_a_map_has_no_mesh_that_could_be_taken_for_lines(mapped: dict[str, Picture], pair: str) -> None:
    assert max(lines_of_map(mapped[f"{pair}-pressure"])) < 0.001


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


@pytest.mark.parametrize("renderer", [RENDERER, DIES], ids=["vtk", "map"])
def test_the_computed_ellipse_is_drawn_beside_hertz(
    checked: Validation, tmp_path: Path, renderer: tuple[str, ...]
) -> None:
    """Both outside the painted pressure and apart: one is longer, the other wider."""
    race, _, pocket, _ = checked.contacts
    contacts = [
        with_ellipses(race, computed=(1.15, 1.2), hertz=(1.3, 1.05)),
        with_ellipses(pocket, computed=(1.3, 1.1), hertz=(1.15, 1.25)),
    ]
    found, trouble = draw_pictures(contacts, tmp_path, renderer=renderer)
    assert (trouble is None) == (renderer is RENDERER)
    for picture in found:
        if picture.kind == "pressure":
            check_ellipse(picture)
            check_ellipse(picture, computed=True)


def with_ellipses(
    contact: ContactSolution, *, computed: tuple[float, float], hertz: tuple[float, float]
) -> ContactSolution:
    """The ellipses as multiples of the computed one; (rolling, transverse)."""
    names = "semi_axis_rolling", "semi_axis_transverse"
    sizes = {name: getattr(contact.reference, name) for name in names}
    made = {
        name: replace(contact.estimates[name], richardson=sizes[name] * factor, beyond=0.0)
        for name, factor in zip(names, computed, strict=True)
    }
    return replace(
        contact,
        estimates=contact.estimates | made,
        hertz=replace(contact.hertz, **{name: sizes[name] * factor for name, factor in zip(names, hertz, strict=True)}),
    )


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


@pytest.mark.parametrize(("pair", "least"), [("inner-real", 22), ("outer-real", 36)])
def test_the_close_up_of_a_slender_contact_is_no_sliver(drawn: dict[str, Picture], pair: str, least: int) -> None:
    """found: 28 and 45 pixels; seen as flat as a round contact 16 and 27."""
    pixels = pixels_of(drawn[f"{pair}-section"].file)
    height, width, _ = pixels.shape
    vivid = np.ptp(pixels[: int(0.8 * height), width // 2 :], axis=-1) > 0.45
    assert vivid.sum(axis=0).max() > least


def test_a_small_body_under_a_large_ball_is_still_seen(checked: Validation, tmp_path: Path) -> None:
    """As the block of a pocket's tiny contact is: an eighth of the ball."""
    seat = checked.contacts[2]
    finest = seat.meshes[-1]
    lower = finest.pair.lower
    small = replace(lower, mesh=replace(lower.mesh, doflocs=0.4 * lower.mesh.doflocs))
    finest = replace(finest, pair=replace(finest.pair, lower=small))
    found, trouble = draw_pictures([replace(seat, meshes=(finest,))], tmp_path)
    assert trouble is None
    pixels = pixels_of(found[1].file)  # the section
    left = pixels[:, : pixels.shape[1] // 2]
    red, _, blue = np.moveaxis(left, -1, 0)
    width, height, *_ = half_sizes(red > blue + 0.08)
    assert min(width, height) > 0.08 * left.shape[0]
    assert not (red > blue + 0.08)[[0, -1]].any()  # the body is whole


def test_the_colour_bar_is_labelled_in_round_numbers_up_to_its_end(checked: Validation) -> None:
    for contact in checked.contacts:
        scale = module._scale(contact)
        ticks = np.array(scale["ticks"])
        assert ticks[0] == 0
        assert 0.7 * scale["peak"] < ticks[-1] <= scale["peak"]
        assert len({f"{step:.6g}" for step in np.diff(ticks)}) == 1
        assert max(len(f"{tick:g}".replace(".", "").lstrip("0")) for tick in ticks) <= 3


def test_the_reader_sees_an_ellipse_of_the_wrong_size(checked: Validation, tmp_path: Path) -> None:
    """The pictures' test, tested: Hertz a tenth too large is drawn where it does not belong."""
    contact = checked.contacts[0]
    stretched = replace(
        contact, hertz=replace(contact.hertz, semi_axis_transverse=contact.hertz.semi_axis_transverse * 0.9)
    )
    (picture,), _ = draw_pictures([stretched], tmp_path, renderer=DIES)
    with pytest.raises(AssertionError):
        check_ellipse(replace(picture, contact=contact))


@pytest.mark.parametrize(
    ("renderer", "words"),
    [
        ((sys.executable, "-c", "raise SystemExit('no GL here')"), "status 1: no GL here"),
        ((sys.executable, "-c", ""), "status 0"),  # ends well and draws nothing
        (("/nowhere/python",), "could not be started"),
        ((sys.executable, "-c", "import time; time.sleep(60)"), "did not finish within"),
    ],
)
def test_every_way_to_fail_is_named(
    checked: Validation, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, renderer: tuple[str, ...], words: str
) -> None:
    monkeypatch.setattr(module, "PATIENCE", 5 if "sleep" not in renderer[-1] else 0.5)
    found, trouble = draw_pictures(checked.contacts[:1], tmp_path, renderer=renderer)
    assert trouble is not None
    assert words in trouble
    assert [picture.file.name for picture in found] == ["inner-real-pressure.png"]
    assert found[0].file.is_file()
    assert "Grey lines" not in found[0].caption  # a map has no mesh


def test_captions_say_what_to_see(checked: Validation, drawn: dict[str, Picture]) -> None:
    """The groove closes in on the ball: Hertz reaches further across."""
    contact: ContactSolution = checked.contacts[0]
    share = contact.hertz.semi_axis_transverse / contact.reference.semi_axis_transverse - 1
    assert share > 0
    assert f"{share:.1%} beyond" in drawn["inner-real-pressure"].caption
    assert "Grey lines are the mesh" in drawn["inner-real-pressure"].caption
    assert "1.4 mm off its race" in drawn["inner-real-section"].caption


@pytest.mark.parametrize(
    ("rolling", "transverse"), [(1.1e-4, 9.3e-4), (9.3e-4, 1.1e-4), (3.1e-4, 3.0e-4), (2e-7, 9e-7)]
)
def test_a_frame_holds_its_contact(rolling: float, transverse: float) -> None:
    frame = frame_of(semi_axis_rolling=rolling, semi_axis_transverse=transverse)
    width, height = on_screen(frame, rolling, transverse)
    assert width >= 0.999 * height  # a circle to within a thousandth lies as it likes
    assert width < min(frame.centre[0], frame.width - frame.centre[0])
    assert height < min(frame.centre[1], frame.height - frame.centre[1]) - 40  # title and colour bar
    assert max(width / frame.width, height / frame.height) > 0.2  # and fills it
    assert f"{frame.bar:.0e}"[0] in "125"
    assert 100 < frame.bar * frame.scale <= 260
