"""The document of a report: what is built of a check is what is written, read back, drawn and shown."""

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from analytic.report_details import UnitSystem
from fembearing.quantities import SYSTEMS, Units
from fembearing.report.document.contact import Contact
from fembearing.report.document.scene import Scene
from fembearing.report.document.table import (
    Count,
    Geometry,
    Label,
    NotNegative,
    OfQuantities,
    Pair,
    Positive,
    Table,
    Verdict,
)
from fembearing.report.document.torque import CageAtRest, CageRecord, MovedCage, Sensitivity, Torque, TorqueChange
from fembearing.report.document.verdicts import PhysicalVerdict, Summary

KIND, FORMAT = "fembearing validation", 4  # what the JSON is; the number rises when a key changes its meaning
Quantity = Literal["approach", "semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "stiffness"]
FileName = Annotated[str, Field(pattern=r"^\w[\w.-]*$")]  # beside report.json, never elsewhere


class ReportDetails(Table):
    """What the scene or an option says of the report itself; None: a blank to fill in by hand."""

    author: str | None
    checker: str | None
    revision: str | None
    date: str | None
    units: UnitSystem


class Comparison(Table):
    """Hertz less finite elements, and the uncertainty of that difference, in the unit of the quantity."""

    error: float
    numerical: NotNegative
    input: NotNegative
    reference: NotNegative
    total: NotNegative
    resolved: bool


class VerdictRow(Table):
    """One quantity of one contact, judged."""

    pair: Pair
    geometry: Geometry
    quantity: Quantity
    production: float
    reference: Positive
    discrepancy: float
    uncertainty: NotNegative
    exceeds_uncertainty: bool
    comparison: Comparison
    verdict: Verdict

    @property
    def relative_uncertainty(self) -> float:
        """u_val over the reference."""
        return self.comparison.total / abs(self.reference)


class Uncertainties(Table):
    """Where each uncertainty of a comparison comes from, in words."""

    numerical: str
    input: str
    reference: str


class Method(Table):
    """One method to compute a quantity, with its error and its price."""

    name: Label
    error: float | None
    bound: float | None
    seconds: Annotated[float, Field(gt=0, lt=1e12)] | None
    spread: NotNegative | None
    repeats: int
    warm_up: NotNegative | None
    predicted: NotNegative | None
    memory: Count | None
    unknowns: Count | None
    known_error: float | None
    chosen: bool
    failed: str | None


class Choice(Table):
    """The method that a tolerance takes; None where no method is that good."""

    tolerance: float
    method: str | None = Field(alias="rung")
    seconds: NotNegative | None
    price: NotNegative | None


class Ladder(Table):
    """The methods to compute one quantity, from cheap to exact."""

    quantity: Label
    reference: str
    absent: str | None
    methods: list[Method] = Field(alias="rungs")
    choices: list[Choice]


class Cost(Table):
    """What accuracy costs."""

    measured: bool  # every ladder, with repeats; else the methods that the check ran
    seconds: float
    peak_memory: Count | None
    ladders: list[Ladder]


class HardRecord(Table):
    """How the hard cases of this version ended, and when."""

    date: str
    fembearing: str
    model_version: int
    right: int
    refused: int
    wrong: int


class PictureFile(Table):
    """A picture of a contact, in a file beside report.json."""

    file: FileName
    kind: Literal["pressure", "section", "view"]
    pair: Pair
    geometry: Geometry
    caption: str


class Provenance(Table):
    """Where the numbers come from."""

    scene: str
    scene_content: Scene
    scene_sha256: str
    seeds: dict[str, list[int]]
    date: str
    command: list[str]
    python: str
    platform: str
    processor: str
    cores: int | None
    versions: dict[str, str | None]


class Report(Table):
    """The check of a scene as a document. Numbers are SI, uncertainties and discrepancies relative."""

    kind: Literal["fembearing validation"]
    format: Literal[4]
    verdict: Summary
    physical: Annotated[list[PhysicalVerdict], Field(min_length=1)]
    report: ReportDetails
    tolerance: Positive
    verdicts: list[VerdictRow]
    uncertainties: Uncertainties
    contacts: Annotated[list[Contact], Field(min_length=2, max_length=4)]
    torque: Torque | None
    torque_change: TorqueChange | None
    cage_motion: list[MovedCage | CageAtRest] | None
    cage_records: list[CageRecord]
    sensitivity: Sensitivity | None
    cost: Cost
    hard: HardRecord
    warnings: list[str]
    provenance: Provenance
    pictures: Annotated[list[PictureFile], Field(default_factory=list)]
    renderer: str = "VTK"

    def to_json(self) -> dict[str, Any]:
        """The document as plain types, with the keys that it was made of."""
        return self.model_dump(mode="json", by_alias=True, exclude_unset=True)

    def contact_at(self, pair: Pair, geometry: Geometry) -> Contact | None:
        """The contact of a picture or of a verdict; None where there is none."""
        return next((each for each in self.contacts if (each.pair, each.geometry) == (pair, geometry)), None)

    @property
    def units(self) -> Units:
        """In which page and figures show these numbers, which are SI."""
        return SYSTEMS[self.report.units]

    @property
    def pocket_load(self) -> str:
        """The load of the pocket, N, as the page says it."""
        return f"{self.contacts[-1].load:g}"

    def verdicts_on(self, contact: Contact) -> dict[str, VerdictRow]:
        """The verdicts on one contact, by quantity."""
        place = contact.pair, contact.geometry
        return {row.quantity: row for row in self.verdicts if (row.pair, row.geometry) == place}

    @model_validator(mode="after")
    def parts_fit_together(self) -> "Report":
        """Refuse pictures without a contact, contacts without verdicts, and a torque without its change."""
        for picture in self.pictures:
            if self.contact_at(picture.pair, picture.geometry) is None:
                raise ValueError(f"has no contact for the picture {picture.file}")
        for contact in self.contacts:
            rows = [row for row in self.verdicts if (row.pair, row.geometry) == (contact.pair, contact.geometry)]
            if contact.judged and sorted(row.quantity for row in rows) != sorted(OfQuantities.model_fields):
                raise ValueError(f"has no verdict on every quantity of {contact.pair}, once")
        if (self.torque is None) != (self.torque_change is None):
            raise ValueError("has torque without torque_change, or the other way round")
        if self.torque is not None and self.torque_change is not None:
            count = len(self.torque.points)
            if any(check.point >= count for check in self.physical):
                raise ValueError(f"has a physical verdict on a point beyond the {count} points of torque")
            if self.torque_change.lengths != {count}:
                raise ValueError(f"has a torque_change of other than the {count} points of torque")
        return self
