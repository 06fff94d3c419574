"""The verdicts of the document: comparison, numerical accuracy, physical limits."""

from typing import Annotated, Literal

from pydantic import Field

from fembearing.report.document.table import Label, NotNegative, Positive, Table, Verdict


class NumericalVerdict(Table):
    """Whether the torque is solved within the tolerance; uncertainty None: not known, for the reason given."""

    verdict: Literal["pass", "not reached"]
    uncertainty: NotNegative | None
    tolerance: Positive
    reason: str


class PhysicalVerdict(Table):
    """One number against its physical limit, at the operating point where it is worst; None: infinite or not known."""

    name: Label
    where: Label
    point: Annotated[int, Field(ge=0)]
    value: float | None
    limit: float
    unit: Literal["Pa", "1"]
    verdict: Literal["pass", "fail", "unknown"]
    note: str


class Verdicts(Table):
    """The verdicts on a torque."""

    numerical: NumericalVerdict
    physical: Annotated[list[PhysicalVerdict], Field(min_length=1)]


class Summary(Table):
    """One word for each kind of verdict, and one for all; numerical None: there is no torque."""

    comparison: Verdict
    numerical: Literal["pass", "not reached"] | None
    physical: Literal["pass", "fail", "unknown"]
    overall: Literal["pass", "fail", "undecided"]
