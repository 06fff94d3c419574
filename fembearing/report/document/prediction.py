"""The 95 % interval of a torque in the document: its ends, what it is made of, and which inputs make it."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from fembearing.report.document.table import Count, Label, NotNegative, Numbers, Positive, Table, Two


class Interval(Table):
    """The ends of an interval, with their standard errors."""

    low: float
    median: float
    high: float
    low_error: NotNegative
    high_error: NotNegative


class Indices(Table):
    """Sobol indices of each input with their standard errors."""

    first: Numbers
    total: Numbers
    first_error: Numbers
    total_error: Numbers


class PredictedPoint(Table):
    """The interval at one operating point."""

    inner_speed: float
    axial_load: float
    radial_load: float
    moment: float
    nominal: float
    total: Interval
    parts: dict[str, Interval]
    made_of: dict[Label, Two]  # of the total, if nothing else were uncertain
    indices: Indices
    explained: float


class UncertainInput(Table):
    """An input with its standard deviation."""

    key: Label
    value: float
    unit: str
    deviation: Positive
    source: str
    floor: float | None  # what lies above it is lognormal; None: normal
    kind: Literal["numerical", "input", "model"]


class Prediction(Table):
    """A torque with its interval."""

    covered: float
    points: Annotated[list[PredictedPoint], Field(min_length=1)]
    inputs: Annotated[list[UncertainInput], Field(min_length=1)]
    not_varied: list[str]
    samples: Count
    failed: int
    reasons: list[str]
    seed: int
    seconds: NotNegative
    evaluation_seconds: NotNegative

    @property
    def failures(self) -> str:
        """How many samples failed and why, in words; empty where none did."""
        words = f"{self.failed} of {self.samples} samples have no torque and are left out: {'; '.join(self.reasons)}."
        return words if self.failed else ""

    @property
    def ends(self) -> list[PredictedPoint]:
        """The slowest and the fastest operating point, of equal ones the first; one where they are the same."""
        by_speed = sorted(self.points, key=lambda point: abs(point.inner_speed))
        return by_speed[:1] if by_speed[0].nominal == by_speed[-1].nominal else [by_speed[0], by_speed[-1]]

    @property
    def ranked(self) -> list[int]:
        """The inputs from the one with the largest total index at any of `ends`."""
        largest = [max(point.indices.total[place] for point in self.ends) for place in range(len(self.inputs))]
        return sorted(range(len(largest)), key=lambda place: -largest[place])

    @property
    def largest_error(self) -> float:
        """The largest standard error of an end of the total, over that end."""
        each = [(p.total.low, p.total.low_error) for p in self.points]
        each += [(p.total.high, p.total.high_error) for p in self.points]
        return max((error / abs(end) for end, error in each if end), default=0.0)

    @property
    def explained(self) -> float:
        """The least share of the variance, at any point, that the indices are of; 0 where the regression fails."""
        return max(0.0, min(point.explained for point in self.points))

    @model_validator(mode="after")
    def every_input_has_its_indices(self) -> "Prediction":
        """Refuse indices of other inputs than those listed."""
        for point in self.points:
            if {len(values) for _, values in point.indices} != {len(self.inputs)}:
                raise ValueError(f"has indices of other than its {len(self.inputs)} inputs")
            if not {"input", "model", "numerical"} >= {n for n in point.made_of if "." not in n}:
                raise ValueError(f"is made of unknown parts: {', '.join(point.made_of)}")
            if point.made_of.keys() != self.points[0].made_of.keys():
                raise ValueError("is made of other parts at other points")
        return self
