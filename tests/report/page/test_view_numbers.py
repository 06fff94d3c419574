"""What the numbers of a view to turn must be: packed, finite, and of corners that are there."""

import base64
from typing import Any

import numpy as np
import pytest

from fembearing.report.page.view import ViewBody


def packed(values: Any, kind: str) -> str:
    return base64.b64encode(np.asarray(values, dtype=kind).tobytes()).decode()


VERTICES = np.arange(21.0)  # of three vertices


def body(corners: list[int], *, vertices: Any = VERTICES, **changed: str) -> ViewBody:
    given = {
        "vertices": packed(vertices, "<f4"),
        "triangles": packed(corners, "<u4"),
        "lines": packed([0, 1], "<u4"),
    }
    return ViewBody(colour=(0.2, 0.3, 0.4), faces=2, **given | changed)


def test_corners_are_those_of_the_vertices() -> None:
    assert body([0, 1, 2]).triangles == packed([0, 1, 2], "<u4")
    assert body([]).triangles == ""
    with pytest.raises(ValueError, match="has a corner 3 and 3 vertices"):
        body([0, 1, 3])
    with pytest.raises(ValueError, match="has a corner 4 and 3 vertices"):
        body([0, 1, 2], lines=packed([4, 1], "<u4"))


def test_vertices_are_finite() -> None:
    with pytest.raises(ValueError, match="a vertex that is not finite"):
        body([0, 1, 2], vertices=np.where(VERTICES == 13, np.inf, VERTICES))


@pytest.mark.parametrize("text", ["A", "AAA*", "AAAA===", "A A="])
def test_numbers_are_base_64(text: str) -> None:
    with pytest.raises(ValueError, match="is not base 64"):
        body([0, 1, 2], lines=text)


def test_numbers_come_in_whole_rows() -> None:
    with pytest.raises(ValueError, match="cannot reshape"):
        body([0, 1])
