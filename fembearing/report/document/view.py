"""What a view of a contact is drawn from: numbers alone, so that a page can be made of those in a stranger's file."""

import base64
import binascii
from typing import Annotated, Self

import numpy as np
from numpy.typing import NDArray
from pydantic import Field, ValidationError, model_validator

from fembearing.report.document.table import Numbers, Positive, Table

Share = Annotated[float, Field(ge=0, le=1)]
Colour = Annotated[list[Share], Field(min_length=3, max_length=3)]
Packed = Annotated[str, Field(pattern=r"^[A-Za-z0-9+/]*={0,2}$")]  # numbers as bytes, base 64
PER_VERTEX = 7  # numbers: place, normal and pressure


class ViewBody(Table):
    """The loaded faces of a body: vertices, 7 numbers of 4 bytes each; triangles and lines, numbers of vertices."""

    colour: Colour
    faces: int
    vertices: Packed
    triangles: Packed
    lines: Packed

    @model_validator(mode="after")
    def all_corners_are_there(self) -> Self:
        """Refuse numbers that are not finite, and corners without a vertex."""
        vertices = _numbers(self.vertices, "<f4", PER_VERTEX)
        for corners, each in ((self.triangles, 3), (self.lines, 2)):
            used = _numbers(corners, "<u4", each)
            if used.size and used.max() >= len(vertices):
                raise ValueError(f"has a corner {used.max()} and {len(vertices)} vertices")
        if not np.isfinite(vertices).all():
            raise ValueError("has a vertex that is not finite")
        return self


class ViewEllipse(Table):
    """A line of the contact; mm."""

    colour: Colour
    semi_axes: Annotated[list[Positive], Field(min_length=2, max_length=2)]
    middle: float  # transverse


class View(Table):
    """A contact to turn; lengths in mm, pressures in `unit`."""

    title: str
    unit: str
    peak: Positive
    ticks: Numbers
    least: float  # pressure from which on colours begin
    faces: int
    bodies: Annotated[list[ViewBody], Field(min_length=2, max_length=2)]
    reach: Positive
    shoulders: Annotated[list[float | None], Field(min_length=2, max_length=2)]
    ellipses: Annotated[list[ViewEllipse], Field(min_length=2, max_length=2)]
    lines: Colour
    shoulder: Colour
    shades: Packed
    eye: Annotated[list[float], Field(min_length=3, max_length=3)]
    half_size: Positive

    @model_validator(mode="after")
    def colours_have_four_parts(self) -> Self:
        """Refuse a scale of colours that breaks off."""
        _numbers(self.shades, "u1", 4)
        return self


def read_view(text: str) -> View | None:
    """The view that a text of JSON holds; None where it holds none."""
    try:
        return View.model_validate_json(text)
    except ValidationError:
        return None


def _numbers(text: str, kind: str, each: int) -> NDArray[np.generic]:
    """Packed numbers, `each` in a row. Raises ValueError for other counts."""
    try:
        content = np.frombuffer(base64.b64decode(text, validate=True), kind)
    except binascii.Error as problem:
        raise ValueError(f"is not base 64: {problem}") from problem
    return content.reshape(-1, each)
