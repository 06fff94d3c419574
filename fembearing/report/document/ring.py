"""Ring and balls in the document: displacement, stiffness, load and angle of every ball."""

from typing import Annotated

from pydantic import Field, model_validator

from fembearing.report.document.table import Table, check_lengths


class Displacement(Table):
    """Of the inner ring, m and rad."""

    axial: float
    x: float
    y: float
    tilt_x: float
    tilt_y: float


class Balls(Table):
    """Every ball around the ring; the angle of an unloaded contact is None."""

    azimuth: Annotated[list[float], Field(min_length=1)]
    inner_load: list[float]
    outer_load: list[float]
    inner_angle: list[float | None]
    outer_angle: list[float | None]

    @model_validator(mode="after")
    def each_ball_has_all(self) -> "Balls":
        """Refuse lists of different lengths."""
        check_lengths(*(values for _, values in self))
        return self


Five = Annotated[list[float], Field(min_length=5, max_length=5)]


class RingState(Table):
    """Ring and balls; the displacement is None where the scene gives the contact angle."""

    displacement: Displacement | None
    stiffness: Annotated[list[Five], Field(min_length=5, max_length=5)]
    balls: Balls
