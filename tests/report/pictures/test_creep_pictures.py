"""The pictures of friction, read back: what is blue sticks, and lengths are those of the scale."""

from pathlib import Path

import numpy as np
from matplotlib.image import imread

from fembearing.report.pictures.creep import WIDTH, CreepPicture
from fembearing.report.pictures.draw import Picture
from fembearing.verify.validation import Validation

BLUE, CLOSE = np.array([65, 105, 225]) / 255, 0.12  # royal blue, but for lines between rectangles and smoothed edges
LEGEND = 60  # pixels from the left, with a blue square of its own


def test_blue_is_as_large_as_what_sticks_and_the_ellipse_as_long_as_its_scale(
    checked: Validation, slipping: dict[Path, CreepPicture], pictures: list[Picture]
) -> None:
    assert pictures  # VTK has drawn all of them
    for (file, picture), race in zip(slipping.items(), checked.creep[0].numbers.races.values(), strict=True):
        job, seen = picture.job, imread(file)[..., :3]
        blue = np.sqrt(np.sum((seen - BLUE) ** 2, axis=2)) < CLOSE
        edges, (left, right) = np.array(job["edges"]), np.array(job["sides"])
        areas = np.diff(edges, axis=1) * (right - left)[:, None]
        expected = np.sum(areas[np.array(job["sticks"])]) * job["scale"] ** 2 * job["stretch"]
        assert expected > 0
        # Edges of rectangles, a pixel wide, are smoothed.
        np.testing.assert_allclose(np.count_nonzero(blue[:, LEGEND:]), expected, rtol=0.1, atol=40)
        painted = np.flatnonzero((seen[job["height"] - 248] < 0.99).any(axis=1))  # across the middle of the lower one
        length = 2 * race.semi_axis_transverse * job["scale"]
        np.testing.assert_allclose(np.ptp(painted), length, atol=4)  # the ellipse of another grid, and its line
        np.testing.assert_allclose((painted[0] + painted[-1]) / 2, WIDTH / 2, atol=4)
        assert picture.listed.kind == "creep"
