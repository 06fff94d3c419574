"""The scene of a bearing of the catalogue: it reads, it runs, and its comments are what the catalogue has."""

import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque
from analytic.catalog.bearing_rows import clearance_group, find_bearing
from analytic.errors import InputError
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


def test_the_suffix_of_clearance_is_in_the_scene_and_its_span_in_the_comment() -> None:
    low, high = clearance_group(25e-3, "C3")
    scene = load_scene("6305-2RS/C3")
    np.testing.assert_allclose(scene.bearing.diametral_clearance, (low + high) / 2, rtol=1e-9)  # a difference of radii
    (line,) = [line for line in scene_text("6305-2RS/C3").splitlines() if line.startswith("clearance")]
    assert line.startswith('clearance = "C3" ')
    assert f"C3: {low * 1e6:g} to {high * 1e6:g} um; CN: " in line


def test_the_load_is_light_and_of_the_kind_that_the_bearing_carries() -> None:
    groove, angular = load_scene("6206"), load_scene("7208B")
    np.testing.assert_allclose(groove.operation.radial_load / find_bearing("6206").static_load_rating, 0.05, rtol=0.05)
    np.testing.assert_allclose(angular.operation.axial_load / find_bearing("7208B").static_load_rating, 0.02, rtol=0.05)
    assert groove.operation.axial_load == angular.operation.radial_load == 0.0


def test_every_table_in_comments_is_read(tmp_path: Path) -> None:
    (tmp_path / "data.csv").write_text("inner_speed [rpm],torque [N mm]\n500,7\n")
    text, count = re.subn(r"(?m)^#(\[?\w)", r"\1", scene_text("6206"))
    assert count > 20
    scene = parse_scene(text, origin="here", folder=tmp_path)
    assert scene.measured is not None
    assert scene.cage is not None
    assert scene.losses.seals == pytest.approx(5e-3, rel=1e-12)  # one rounding
    assert set(scene.effects.values()) == {"auto"}


@pytest.mark.parametrize("designation", ["6206", "7208B"])
def test_the_scene_runs_within_its_tolerance(designation: str) -> None:
    scene = load_scene(designation)
    result = friction_torque(scene)
    assert np.all(result.torque.total > 0)
    assert np.all(result.numerical_uncertainty <= scene.tolerance)


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


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("6206.toml", ("No such file", "paper_6205", "6206")),
        ("6299", ("6299", "nearest: ", "no scene file")),
        ("no/scene", ("no/scene: No such file",)),
        ("x" * 300, ("give the path of a scene file",)),
    ],
)
def test_a_name_that_is_nothing_is_refused(
    name: str, words: tuple[str, ...], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)  # where README's commands may have left files
    with pytest.raises(InputError) as problem:
        load_scene(name)
    assert str(problem.value).isprintable()
    assert all(word in str(problem.value) for word in words), problem.value


def line_of(text: str, key: str) -> str:
    (line,) = (line for line in text.splitlines() if line.startswith(f"{key} = "))
    return line


def test_the_head_names_the_bearing_with_its_sizes_and_ratings() -> None:
    row, text = find_bearing("6206-2RS1"), scene_text("6206-2RS1")
    head = " ".join(line.removeprefix("# ") for line in text.splitlines()[1:4])
    assert head.startswith(f"{row.designation}, {row.kind} ball bearing, 30 x 62 x 16 mm, C 19.5 kN, C0 11.3 kN (NSK)")
    assert "Seals: 2RS1: " in head
    assert "Seals" not in scene_text("6206")


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


def test_what_a_dimension_rests_on_is_said_with_its_deviation() -> None:
    """In the unit of the dimension: the balls of a 7206 BEP to 0.62 mm, the conformity of ISO 76 to 0.0058."""
    text = scene_text("7206 BEP")
    origins = find_bearing("7206 BEP").origins
    ball, conformity = origins["ball_diameter"].uncertainty, origins["inner.conformity"].uncertainty
    assert ball is not None
    assert conformity is not None
    assert f"# - derived, +- {1e3 * ball:.2g} mm: from the same" in text
    assert f"# - assumed, +- {conformity:.2g}: evenly from the tightest" in text
    assert "# - assumed: turned off to the groove for the assembly" in text
    assert '#outer.far_shoulder_half_width = "0 mm"' in text
    assert "shoulder_half_width is not known" not in text


@pytest.mark.parametrize("designation", ["6206", "7208B", "7036C"])
def test_the_sheet_of_the_cage_leaves_a_part_of_the_web(designation: str) -> None:
    """As thick as that of the 6205 of [Paper] over its ball, 0.113, but at most 0.8 of the web between pockets."""
    text, row = scene_text(designation), find_bearing(designation)
    clearance, wall = (
        float(re.search(rf'#{key} = "([\d.]+) mm"', text)[1]) * 1e-3  # pyright: ignore[reportOptionalSubscript]
        for key in ("pocket_clearance", "wall_thickness")
    )
    web = row.pitch_diameter * math.sin(math.pi / row.ball_count) - 1.025 * row.ball_diameter
    assert clearance == pytest.approx(0.025 * row.ball_diameter, rel=0.05)  # two digits
    assert wall == pytest.approx(min(0.113 * row.ball_diameter, 0.8 * web), rel=0.05)
    assert (0.8 * web < 0.113 * row.ball_diameter) == (designation != "6206")


@pytest.mark.parametrize(
    ("designation", "rub", "closed"),
    [("6206-2RS1", True, True), ("6206-2Z", False, True), ("6310-DDW", True, True), ("6206", False, False)],
)
def test_seals_and_grease_of_a_closed_bearing_are_written(designation: str, rub: bool, closed: bool) -> None:
    text = scene_text(designation)
    assert ("in place of SKF's formula" in text) == rub
    assert ('\nsupply = "grease"' in text) == closed
