"""Pictures of a contact that one shoulder cuts off: pressure on its own side of the line, not mirrored over it."""

import sys
from pathlib import Path

import matplotlib.image
import numpy as np
import pytest

from fembearing.report.pictures.draw import Picture, draw_pictures

BROKEN = (sys.executable, "-c", "raise SystemExit(3)")


@pytest.mark.parametrize("renderer", ["VTK", "map"])
def test_pressure_ends_at_the_shoulder_and_only_there(
    odd_by_vtk: dict[str, Picture], tmp_path: Path, renderer: str
) -> None:
    picture = odd_by_vtk["cut"]
    if renderer == "map":
        picture = draw_pictures([picture.contact], tmp_path, renderer=BROKEN)[0][0]
    assert picture.frame is not None
    pixels = matplotlib.image.imread(picture.file)[..., :3]
    left, top = picture.frame.centre
    row = pixels[round(top) - 12 : round(top) + 12]  # along the middle of the contact
    painted = (np.ptp(row, axis=2) > 0.2).mean(axis=0) > 0.5  # in colours; lines are thinner than half of the row
    across = (np.flatnonzero(painted) + 0.5 - left) / picture.frame.scale
    assert across.max() == pytest.approx(0.8e-3, abs=6e-6)  # m: the line's width, three pixels
    assert across.min() < -0.9e-3
    assert np.diff(across).max() < 0.05e-3  # nothing bare between
    red, green, blue = pixels.transpose(2, 0, 1)
    orange = np.flatnonzero(((red > 0.7) & (green > 0.3) & (green < 0.8) & (blue < 0.4)).mean(axis=0) > 0.5)
    assert (orange.mean() + 0.5 - left) / picture.frame.scale == pytest.approx(0.8e-3, abs=3e-6)
    assert "y = 0.8 mm, on one side" in picture.caption
