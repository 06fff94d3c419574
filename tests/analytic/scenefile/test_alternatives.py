"""The scene that `fembearing init` writes runs, and so it does with each alternative in its comments."""

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from analytic import friction_torque
from analytic.scenefile.read import parse_scene
from analytic.scenefile.template import scene_text

DESIGNATIONS = ("6206", "7208B", "6305-2RS/C3")
KEY = re.compile(r"#(\w[\w.]*) = ")
# Keys in comments that go together; of the others each stands alone.
TOGETHER = (
    ("pocket_clearance", "wall_thickness", "mass", "material"),
    ("inner_temperature", "outer_temperature"),
)
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
    for designation in DESIGNATIONS
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
    for designation in DESIGNATIONS:
        text = scene_text(designation)
        tried = "\n".join(name for name, _ in alternatives(text))
        comments = [line.partition("# ")[2] for line in text.splitlines() if not line.startswith("#:")]
        words = {word for comment in comments for word in re.findall(r'"([\w.]+)"', comment)} - NOT_VALUES
        assert len(words) >= 7
        assert {word for word in words if f'"{word}"' not in tried} == set(), designation
        assert len(tried.splitlines()) > 30
