"""The scene of a bearing of the catalogue: it reads, it runs, and its comments are what the catalogue has."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic.catalog.bearing_rows import find_bearing
from analytic.scenefile.read import load_scene, parse_scene
from analytic.scenefile.template import scene_text

DESIGNATIONS = ("6206", "6305-2RS/C3", "SKF 6305", "7208B")


def with_every_dimension(text: str) -> str:
    """The text with the comments of [bearing] that are keys made keys."""
    bearing, mark, rest = text.partition("[operation]")
    found, count = re.subn(r"(?m)^#(\w[\w.]* = )", r"\1", bearing)
    assert count == (9 if "far_shoulder" in bearing else 7), bearing
    return found + mark + rest


@pytest.mark.parametrize("designation", DESIGNATIONS)
def test_the_dimensions_in_comments_are_those_of_the_catalogue(designation: str) -> None:
    text, row = scene_text(designation), find_bearing(designation)
    scene = parse_scene(text, origin="here")
    told = parse_scene(with_every_dimension(text), origin="here")
    assert told.bearing.ball_count == row.ball_count
    for read in (scene.bearing, told.bearing):  # comments round to seven digits
        np.testing.assert_allclose(read.ball_diameter, row.ball_diameter, rtol=1e-6)
        np.testing.assert_allclose(read.pitch_diameter, row.pitch_diameter, rtol=1e-6)
        for ring, conformity, half in zip(
            (read.inner, read.outer), row.conformity, row.shoulder_half_width, strict=True
        ):
            np.testing.assert_allclose(ring.groove_radius, conformity * row.ball_diameter, rtol=1e-6)
            np.testing.assert_allclose(np.array(ring.shoulder_half_width, float), np.array(half, float), rtol=1e-6)
        np.testing.assert_allclose(
            read.diametral_clearance, scene.bearing.diametral_clearance, rtol=1e-4
        )  # a difference
    assert told.bearing.origins["ball_diameter"].status == "given"
    assert scene.bearing.origins["ball_diameter"].status in ("derived", "printed")


def test_the_load_is_light_and_of_the_kind_that_the_bearing_carries() -> None:
    groove, angular = load_scene("6206"), load_scene("7208B")
    np.testing.assert_allclose(groove.operation.radial_load / find_bearing("6206").static_load_rating, 0.05, rtol=0.05)
    np.testing.assert_allclose(angular.operation.axial_load / find_bearing("7208B").static_load_rating, 0.02, rtol=0.05)
    assert groove.operation.axial_load == angular.operation.radial_load == 0.0


def test_a_file_comes_before_a_scene_of_that_name_and_before_a_bearing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert load_scene("6206").name == "6206"
    assert load_scene("paper_6205").name == "6205 of the paper under 1000 N thrust, oil"
    for name in ("6206", "paper_6205"):
        (tmp_path / name).write_text(scene_text("6208").replace('name = "6208"', f'name = "file {name}"'), "utf-8")
        assert load_scene(name).name == f"file {name}"
    (tmp_path / "6208").mkdir()  # a folder is no scene
    assert load_scene("6208").name == "6208"


def line_of(text: str, key: str) -> str:
    (line,) = (line for line in text.splitlines() if line.startswith(f"{key} = "))
    return line


@pytest.mark.parametrize(
    ("choice", "radial", "axial", "words"),
    [
        ({}, "560 N", "0 N", "0.05 C0, a light load; along x"),  # of 11.3 kN
        ({"radial_load": "3 kN"}, "3 kN", "0 N", "along x"),
        ({"axial_load": "3 kN"}, "0 N", "3 kN", "along x"),
    ],
)
def test_given_loads_leave_no_usual_ones(choice: dict[str, Any], radial: str, axial: str, words: str) -> None:
    text = scene_text("6206", **choice)
    assert line_of(text, "radial_load").startswith(f'radial_load = "{radial}" ')
    assert line_of(text, "radial_load").partition("# ")[2].startswith(words)
    assert line_of(text, "axial_load").startswith(f'axial_load = "{axial}" ')
    angular = scene_text("7206 BEP", **choice)
    assert line_of(angular, "axial_load").startswith(f'axial_load = "{"290 N" if not choice else axial}" ')
