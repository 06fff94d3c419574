"""The picture of a measured surface: what counts, to scale, and what was removed."""

import re
from pathlib import Path

import numpy as np
import pytest

from analytic.scene import HeightMapFile
from analytic.scenefile.read import load_scene
from analytic.units import METRIC, SYSTEMS, Units
from analytic.words import Unit
from fembearing.report.figures.height_map import height_map_figure
from fembearing.report.torque_folder import torque_with_files
from tests.analytic.scenefile.scene_texts import LUBRICANT, PLAIN
from tests.analytic.surface.map_files import ROUGH, SPACING, formless
from tests.report.figures.figure_reader import require_legible

FORM = np.linspace(-1e-6, 1e-6, ROUGH.shape[1]) ** 2 * 2e6  # m, from 0 to 2 um


def of_words(caption: str, before: str, unit: Unit) -> float:
    """The length behind these words, m."""
    found = re.search(rf"{before} ([\d.]+) {unit.name}", caption)
    assert found is not None, caption
    return float(found[1]) / unit.factor


@pytest.mark.parametrize("units", SYSTEMS.values(), ids=SYSTEMS)
def test_the_map_is_drawn_without_its_form_and_the_caption_has_both(tmp_path: Path, units: Units) -> None:
    np.save(tmp_path / "race.npy", ROUGH + FORM)
    file = HeightMapFile(path=str(tmp_path / "race.npy"), spacing=SPACING)
    figure, caption = height_map_figure(file, units, captioned=True)
    require_legible(figure)
    small = units.small_length
    panel, bar = figure.axes
    (image,) = panel.get_images()
    np.testing.assert_allclose(np.asarray(image.get_array()), small.factor * formless(ROUGH), atol=1e-12)  # round-off
    wide, high = small.factor * SPACING * ROUGH.shape[1], small.factor * SPACING * ROUGH.shape[0]
    np.testing.assert_allclose(image.get_extent(), (0, wide, high, 0), rtol=1e-12)
    assert small.name in panel.get_xlabel()
    assert small.name in bar.get_ylabel()
    assert of_words(caption, "Sq", small) == pytest.approx(formless(ROUGH).std(), rel=5e-3)  # three digits
    assert of_words(caption, "with the form", small) == pytest.approx((ROUGH + FORM).std(), rel=5e-3)


def test_a_large_map_is_drawn_with_fewer_points(tmp_path: Path) -> None:
    np.save(tmp_path / "race.npy", np.tile(ROUGH, (1, 60)))
    figure, caption = height_map_figure(HeightMapFile(path=str(tmp_path / "race.npy"), spacing=SPACING), METRIC)
    (image,) = figure.axes[0].get_images()
    assert max(np.asarray(image.get_array()).shape) <= 400
    assert "40 by 3180 points" in caption


def test_the_folder_of_a_torque_has_the_map(tmp_path: Path) -> None:
    np.save(tmp_path / "race.npy", ROUGH + FORM)
    table = '[surface]\nheight_map = { path = "race.npy", spacing = "7 um" }\n'
    (tmp_path / "scene.toml").write_text(PLAIN + LUBRICANT + table)
    torque_with_files(load_scene(tmp_path / "scene.toml"), out=tmp_path / "made")
    assert (tmp_path / "made" / "height-map.png").read_bytes().startswith(b"\x89PNG")
