"""A contact to turn in the browser: one page with our script and the numbers of a mesh, which fetches nothing.

The page, templates/view.html, draws the loaded faces of both bodies by WebGL. Its vertices are the nodes of the finest
mesh, not deformed, so that no value in it is interpolated.
It has its own script because the exports that exist are five times as heavy or more, and the one of VTK asks a host for
icons when it is opened. The browser runs no other script: the policies of this page, and of the report that holds it,
name the script by its hash. What is drawn is numbers alone, so that a page can be made of those in a stranger's file.
"""

import base64
import binascii
import hashlib
import re
from dataclasses import dataclass
from functools import cache
from typing import Annotated, Any, ClassVar

import numpy as np
from annotated_types import Ge, Le, MinLen
from numpy.typing import NDArray
from pydantic import TypeAdapter, ValidationError

from analytic.rows import Positive
from fembearing.plain_types import plain
from fembearing.report.page.template import filled, source_of

BEGIN, END = '<script id="scene" type="application/json">', "</script>"
Share = Annotated[float, Ge(0), Le(1)]
Colour = tuple[Share, Share, Share]
PACKED = re.compile(r"[A-Za-z0-9+/]*={0,2}")  # numbers as bytes, base 64
PER_VERTEX = 7  # numbers: place, normal and pressure


@dataclass(frozen=True, kw_only=True)
class ViewBody:
    """The loaded faces of a body: vertices, 7 numbers of 4 bytes each; triangles and lines, numbers of vertices."""

    colour: Colour
    faces: int
    vertices: str
    triangles: str
    lines: str

    def __post_init__(self) -> None:
        """Raises ValueError for numbers that are not finite, and for corners without a vertex."""
        vertices = _numbers(self.vertices, "<f4", PER_VERTEX)
        for corners, each in ((self.triangles, 3), (self.lines, 2)):
            used = _numbers(corners, "<u4", each)
            if used.size and used.max() >= len(vertices):
                raise ValueError(f"has a corner {used.max()} and {len(vertices)} vertices")
        if not np.isfinite(vertices).all():
            raise ValueError("has a vertex that is not finite")


@dataclass(frozen=True, kw_only=True)
class ViewEllipse:
    """A line of the contact; mm."""

    colour: Colour
    semi_axes: tuple[Positive, Positive]
    middle: float  # transverse


@dataclass(frozen=True, kw_only=True)
class View:
    """A contact to turn; lengths in mm, pressures in `unit`."""

    __pydantic_config__: ClassVar[dict[str, Any]] = {"strict": True, "extra": "forbid", "allow_inf_nan": False}

    title: str
    unit: str
    peak: Positive
    ticks: Annotated[tuple[float, ...], MinLen(1)]
    least: float  # pressure from which on colours begin
    faces: int
    bodies: tuple[ViewBody, ViewBody]
    reach: Positive
    shoulders: tuple[float | None, float | None]
    ellipses: tuple[ViewEllipse, ViewEllipse]
    lines: Colour
    shoulder: Colour
    shades: str
    eye: tuple[float, float, float]
    half_size: Positive

    def __post_init__(self) -> None:
        """Raises ValueError for a scale of colours that breaks off."""
        _numbers(self.shades, "u1", 4)


@cache
def _adapter() -> TypeAdapter[View]:
    return TypeAdapter(View)


def read_view(text: str | bytes) -> View:
    """The view that a text of JSON holds. Raises ValidationError where it holds none."""
    return _adapter().validate_json(text)


def view_page(view: View) -> str:
    """The page."""
    return filled("view.html", scene=plain(view), script=script_hash())


@cache
def script_hash() -> str:
    """The source of the only script that a page may run, as policies name it."""
    script = source_of("view.html").rpartition("<script>")[2].partition(END)[0]
    return f"'sha256-{base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()}'"


def remade(page: bytes) -> str | None:
    """The page again from the numbers in it, whoever wrote it; None where it holds no view."""
    numbers = page.decode("utf-8", "replace").partition(BEGIN)[2].partition(END)[0]
    try:
        return view_page(read_view(numbers))
    except ValidationError:
        return None


def _numbers(text: str, kind: str, each: int) -> NDArray[np.generic]:
    """Packed numbers, `each` in a row. Raises ValueError for other counts and for what is not base 64."""
    if not PACKED.fullmatch(text):
        raise ValueError("is not base 64")
    try:
        content = np.frombuffer(base64.b64decode(text, validate=True), kind)
    except binascii.Error as problem:
        raise ValueError(f"is not base 64: {problem}") from problem
    return content.reshape(-1, each)
