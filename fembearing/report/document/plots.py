"""What report.json must hold for its plots alone, SI, changes relative; see `fembearing.report.document.document`."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from fembearing.report.document.scene import Positive, Shape, Two

Numbers = Annotated[list[float], Field(min_length=1)]


def alike(*lists: list[object] | list[float] | list[float | None]) -> None:
    """Refuses lists that belong together and are not of one length."""
    lengths = sorted({len(each) for each in lists})
    if len(lengths) > 1:
        raise ValueError(f"has lists of {' and '.join(map(str, lengths))} values that belong together")


class OnRaces(Shape):
    inner: float | None
    outer: float | None


class OnContacts(OnRaces):
    pocket: float | None


class Profile(Shape):
    position: Numbers
    pressure: Numbers

    @model_validator(mode="after")
    def each_place_has_its_pressure(self) -> "Profile":
        alike(self.position, self.pressure)
        return self


class BothProfiles(Shape):
    fe: Profile
    hertz: Profile


class PressureProfile(Shape):
    rolling: BothProfiles
    transverse: BothProfiles


class ApproachCurve(Shape):
    load: Numbers
    hertz: Annotated[list[Positive], Field(min_length=1)]
    corrected: list[float | None]
    uncertainty: list[float | None]

    @model_validator(mode="after")
    def each_load_has_its_approaches(self) -> "ApproachCurve":
        alike(self.load, self.hertz, self.corrected, self.uncertainty)
        return self


class TotalTorque(Shape):
    quantity: Literal["total_torque"]
    inner_speed: float
    axial_load: float
    value: float


class PeakPressure(Shape):
    quantity: Literal["peak_pressure"]
    pair: Literal["inner", "outer"]
    value: float


class Input(Shape):
    name: Annotated[str, Field(pattern=r"^[^$]*$")]  # dollars would begin a formula
    unit: Literal["Pa", "1/Pa", "Pa s", "m", "N", "N m", "rad", "K", "1"]
    value: float
    low: float
    high: float
    change_low: list[float] | None
    change_high: list[float] | None
    refused: list[str]


class Sensitivity(Shape):
    outputs: Annotated[list[TotalTorque] | list[PeakPressure], Field(min_length=1)]
    inputs: list[Input]

    @model_validator(mode="after")
    def each_output_has_its_changes(self) -> "Sensitivity":
        for each in self.inputs:
            alike(list(self.outputs), *(ends for ends in (each.change_low, each.change_high) if ends is not None))
        return self


class Room(Shape):
    size: Positive
    middle: Two
    edge: Annotated[list[Two], Field(min_length=1)]


class Orbit(Shape):
    joined: bool
    start_up: Annotated[list[Two], Field(min_length=1)]
    measured: Annotated[list[Two], Field(min_length=1)]


class Forces(Shape):
    time: Numbers
    largest: Numbers
    sum: Numbers

    @model_validator(mode="after")
    def each_instant_has_its_forces(self) -> "Forces":
        alike(self.time, self.largest, self.sum)
        return self


class Exceedance(Shape):
    force: list[Positive]
    share: list[Positive]

    @model_validator(mode="after")
    def each_force_has_its_share(self) -> "Exceedance":
        alike(self.force, self.share)
        return self


class CageRecord(Shape):
    inner_speed: float
    bearing: str
    state: Literal["rest", "whirl", "irregular", "mixed"]
    start: str
    start_up: Positive
    torque: float
    torque_interval: Two
    max_force: Annotated[float, Field(ge=0)]
    max_force_interval: Two
    block: float
    block_maxima: Numbers
    gravity: Annotated[list[float], Field(min_length=3, max_length=3)]
    room: Room
    orbit: Orbit
    forces: Forces
    exceedance: Exceedance
