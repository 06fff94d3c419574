"""A drawing as a file, and what is not drawn."""

from dataclasses import replace
from pathlib import Path

import pytest

from analytic.errors import InputError
from analytic.scenefile.read import load_scene
from fembearing.report.drawing import draw_bearing


def test_the_file_is_the_same_in_every_run_and_replaces_nothing(tmp_path: Path) -> None:
    scene = load_scene("6205")
    for name in ("one.svg", "two.svg", "three.png", "four.pdf"):
        draw_bearing(scene, out=tmp_path / name)
    first = (tmp_path / "one.svg").read_bytes()
    assert first == (tmp_path / "two.svg").read_bytes()
    assert b"<svg" in first
    assert (tmp_path / "three.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "four.pdf").read_bytes().startswith(b"%PDF-")
    with pytest.raises(InputError, match="exists"):
        draw_bearing(scene, out=tmp_path / "one.svg")
    with pytest.raises(InputError, match=r"ends with '\.docx': give a file that ends with \.svg, \.png, \.pdf"):
        draw_bearing(scene, out=tmp_path / "my.docx")


def test_more_balls_than_are_drawn_are_refused() -> None:
    scene = load_scene("6205")
    with pytest.raises(InputError, match=r"6205: .*at most 500 balls"):
        draw_bearing(replace(scene, bearing=replace(scene.bearing, ball_count=501)))
