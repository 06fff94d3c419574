"""A picture read back: the ellipses, the pressure, the bars and the lines of the mesh that are in its pixels."""

from pathlib import Path

import numpy as np
from matplotlib import colormaps
from matplotlib.image import imread
from numpy.typing import NDArray

from fembearing.report.pictures.draw import Picture
from fembearing.report.pictures.framing import BAR, TITLE, Frame

Pixels = NDArray[np.float64]
CORNER = 460  # pixels from the right: the colour bar's
PEN = 3.0  # pixels: the width of the ellipse's line


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
    line, ellipse = (
        (is_black, picture.contact.numbers.reference) if computed else (is_red, picture.contact.numbers.hertz)
    )
    width, height, left, top = half_sizes(line(middle_of(frame, pixels)))
    expected = on_screen(frame, ellipse.semi_axis_rolling, ellipse.semi_axis_transverse)
    np.testing.assert_allclose((width, height), expected, atol=PEN)  # half the line lies outside, blurred by a pixel
    shown = middle_of(frame, pixels).shape
    np.testing.assert_allclose((left, top), (frame.centre[0], shown[0] / 2), atol=2)  # pixels


def check_pressure(picture: Picture) -> None:
    frame, computed = picture.frame, picture.contact.numbers.reference
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
    frame, hertz = picture.frame, picture.contact.numbers.hertz
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
    frame, hertz = picture.frame, picture.contact.numbers.hertz
    assert frame is not None
    pixels = middle_of(frame, pixels_of(picture.file))
    down, right = np.indices(pixels.shape[:2])
    right, down = right + 0.5 - frame.centre[0], down + 0.5 - pixels.shape[0] / 2
    width, height = on_screen(frame, hertz.semi_axis_rolling, hertz.semi_axis_transverse)
    reach = np.hypot(right / width, down / height)
    surfaces = reach < 0.85, reach > 1.15  # between them run the ellipses
    quarters = [(right * x > 0) & (down * y > 0) for x in (-1, 1) for y in (-1, 1)]
    return [share_of_lines(pixels, surface & quarter, 0.01) for surface in surfaces for quarter in quarters]
