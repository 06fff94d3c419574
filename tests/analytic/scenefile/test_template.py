"""The scene of a bearing of the catalogue: it reads, and so it does with each alternative in its comments."""

import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque
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


WRITTEN = ("6206", "7208B", "6305-2RS/C3")
KEY = re.compile(r"#(\w[\w.]*) = ")
# Keys in comments that go together; of the others each stands alone.
TOGETHER = (("pocket_clearance", "wall_thickness", "mass", "material"), ("inner_temperature", "outer_temperature"))
# In place of a line that begins so; what comments name in words.
INSTEAD = {
    "down": ("down = [0, 0, 1]",),
    "clearance": ('clearance = "CN"', 'clearance = "C3"', 'clearance = "12 um"'),
    "supply": tuple(f'supply = "{word}"' for word in ("oil_bath", "oil_jet", "oil_spot", "grease")),
    "finish": ('Ra = "0.05 um"',),
    "inner_speed": ('inner_speed = ["500 rpm", "1000 rpm"]',),
    "hysteresis_loss": ("hysteresis_loss = 0.003", "hysteresis_loss = 0.025"),
    "material": ('material = "steel"', 'material = "peek"'),
    "creep": tuple(f'creep = "{word}"' for word in ("auto", "on", "off")),
    "rolling": tuple(f'rolling = "{word}"' for word in ("auto", "on", "off")),
    "elastic_rolling": ('elastic_rolling = "houpert"',),
}
NOT_VALUES = {"data.csv"}  # in quotes, and no alternative


def alternatives(text: str) -> Iterator[tuple[str, str]]:
    """(its line, the scene with it) of each alternative."""
    lines, table, begin = text.splitlines(), "", 0
    for number, line in enumerate(lines):
        if header := re.match(r"#?\[(\w+)\]", line):
            table, begin = header[1], number
        key = KEY.match(line) or re.match(r"(\w+) = ", line)
        if key is None:
            continue
        changed = list(lines)
        if line.startswith("#") and lines[begin].startswith("#"):
            changed[begin] = lines[begin][1:]
            names = next((each for each in TOGETHER if key[1] in each), (key[1],))
            for place in range(begin + 1, len(lines)):
                if (other := KEY.match(lines[place])) and other[1] in names:
                    changed[place] = lines[place][1:]
        own = () if line[0] != "#" else (line[1:].partition("  ")[0].strip(),)
        more = ('seals = "estimate"',) if "estimate" in line else ()
        for instead in (*INSTEAD.get(key[1], own), *more):
            changed[number] = instead
            if key[1] == "down":  # a shaft that stands has thrust, as the comment says
                changed = [re.sub('^axial_load = "0 N"', 'axial_load = "60 N"', each) for each in changed]
            yield f"{table}: {instead}", "\n".join(changed)


CASES = [
    pytest.param(designation, text, id=f"{designation} {name}")
    for designation in WRITTEN
    for name, text in alternatives(scene_text(designation))
]


@pytest.mark.parametrize(("designation", "text"), CASES)
def test_each_alternative_has_a_torque(designation: str, text: str, tmp_path: Path) -> None:
    (tmp_path / "data.csv").write_text("inner_speed [rpm],torque [N mm]\n500,7\n", "utf-8")
    scene = parse_scene(text, origin="here", folder=tmp_path)
    assert scene.bearing.name == designation
    assert np.all(friction_torque(scene).torque.total > 0)


def test_no_alternative_in_a_comment_is_left_out() -> None:
    """Each word in quotes of a comment is a value of some case."""
    for designation in WRITTEN:
        text = scene_text(designation)
        tried = "\n".join(name for name, _ in alternatives(text))
        comments = [line.partition("# ")[2] for line in text.splitlines() if not line.startswith("#:")]
        words = {word for comment in comments for word in re.findall(r'"([\w.]+)"', comment)} - NOT_VALUES
        assert len(words) >= 7
        assert {word for word in words if f'"{word}"' not in tried} == set(), designation
        assert len(tried.splitlines()) > 30
