"""What report.json must hold for the page to be made from it. Numbers are SI, uncertainties and discrepancies relative.

A key that no section and no plot reads may be anything or missing; one that they read has a line here.
"""

from typing import Annotated, Generic, Literal, TypeVar

from pydantic import ConfigDict, Field, model_validator

from fembearing.report.document.plots import (
    ApproachCurve,
    CageRecord,
    OnContacts,
    OnRaces,
    PressureProfile,
    Sensitivity,
)
from fembearing.report.document.scene import Positive, Scene, Shape, Two

T = TypeVar("T")
Pair = Literal["inner", "outer", "pocket"]
Geometry = Literal["real", "hertzian", "wall", "ring"]
Quantity = Literal["approach", "semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "stiffness"]
Verdict = Literal["pass", "fail", "undecided", "outside validity"]
Count = Annotated[int, Field(gt=0, lt=2**63)]
Label = Annotated[str, Field(pattern=r"^[^$]*$")]  # in a plot, where dollars would begin a formula
FileName = Annotated[str, Field(pattern=r"^\w[\w.-]*$")]  # beside report.json, never elsewhere


class OfQuantities(Shape, Generic[T]):
    approach: T
    semi_axis_rolling: T
    semi_axis_transverse: T
    peak_pressure: T
    stiffness: T


class Comparison(Shape):
    total: float
    resolved: bool


class VerdictRow(Shape):
    pair: Pair
    geometry: Geometry
    quantity: Quantity
    production: float
    reference: Positive
    discrepancy: float
    verdict: Verdict
    comparison: Comparison


class Uncertainties(Shape):
    numerical: str
    input: str
    reference: str


class Corrected(Shape):
    values: OfQuantities[float]
    interpolation_error: OfQuantities[float]


class Ring(Shape):
    approach: float
    share: float
    uncertainty: float


class Estimated(Shape):
    fe: float
    uncertainty: float


class Sides(Shape):
    model_config = ConfigDict(extra="forbid")  # the page reads whatever is there

    above: float
    below: float = 0.0


class Shoulder(Shape):
    sides: Sides
    half: bool
    strip_width: float
    hertz_line_load: Positive
    centroid: Estimated
    strip_share: Estimated
    strip_line_load: Estimated


class Study(Shape):
    values: list[Positive]
    order: float | None
    grid_convergence_index: float | None
    formal_order: float | None
    richardson: Positive | None
    mesh: float
    domain: float


class Mesh(Shape):
    unknowns: Count


class Contact(Shape):
    pair: Pair
    geometry: Geometry
    load: float
    contact_angle: float
    judged: bool
    fe: OfQuantities[float]
    hertz: OfQuantities[Positive]
    uncertainty: OfQuantities[float]
    corrected: Corrected | None
    ring: Ring | None
    convergence: OfQuantities[Study]
    meshes: Annotated[list[Mesh], Field(min_length=2)]
    shoulder: Shoulder | None
    pressure_profile: PressureProfile
    approach_curve: ApproachCurve

    @model_validator(mode="after")
    def each_mesh_has_its_value(self) -> "Contact":
        for name, study in self.convergence:
            if len(study.values) != len(self.meshes):
                raise ValueError(f"has {len(study.values)} values of {name} on {len(self.meshes)} meshes")
        return self


class Parts(Shape):
    """None where a part was left out."""

    model_config = ConfigDict(extra="forbid")  # the page reads whatever is there

    total: float
    race: float | None
    spin: float | None
    conformity: float | None
    hysteresis: float | None
    rolling: float | None
    cage: float | None
    declared: float | None


class Uncertainty(Shape):
    numerical: float | None
    model: float | None


class Point(Shape):
    axial_load: float
    inner_speed: float
    contact_angle: float
    torque: Parts
    uncertainty: Uncertainty
    friction_coefficient: OnContacts
    film: OnRaces
    asperity_share: OnRaces


class Effect(Shape):
    name: str
    decision: str
    share: float | None
    share_is: Literal["part", "bound", "unbounded", "unknown"]
    reason: str

    @model_validator(mode="after")
    def what_has_a_share_tells_it(self) -> "Effect":
        if self.share is None and self.share_is in ("part", "bound"):
            raise ValueError("has no share")
        return self


class Band(Shape):
    low: list[float] | None
    high: list[float] | None
    note: str


class Torque(Shape):
    points: Annotated[list[Point], Field(min_length=1)]
    gap_roughness: Positive | None
    effects: list[Effect]
    catalogue_band: Band

    @model_validator(mode="after")
    def the_band_is_whole(self) -> "Torque":
        band = self.catalogue_band
        if (band.low is None) != (band.high is None):
            raise ValueError("has half a catalogue_band")
        for side in (band.low, band.high):
            if side is not None and len(side) != len(self.points):
                raise ValueError(f"has {len(side)} values of catalogue_band at {len(self.points)} points")
        return self


class Corrections(Shape):
    corrected: list[float | None]


class Total(Shape):
    total: list[float | None]


class FiniteGeometry(Shape):
    change: list[float | None]


class TorqueChange(Shape):
    contact_angle: Corrections
    torque: Corrections
    change: Total
    uncertainty: float
    finite_geometry: FiniteGeometry
    verdict: Verdict

    @property
    def lengths(self) -> set[int]:
        series = (self.contact_angle.corrected, self.torque.corrected, self.change.total, self.finite_geometry.change)
        return set(map(len, series))


class Interval(Shape):
    torque: Two
    max_force: Two


class OtherStart(Shape):
    state: str
    start: str
    torque: float


class CageAtRest(Shape):
    start: None


class MovedCage(Shape):
    start: str
    state: str
    inner_speed: float
    torque: float
    interval: Interval
    signed_moment: float
    mean_force: float
    max_force: float
    duration: float
    block: float
    other: OtherStart | None


class Chosen(Shape):
    value: float
    unit: str


class Printed(Shape):
    quantity: Annotated[str, Field(pattern="_(torque|force)$")]
    rms_roughness: float
    inner_speed: float
    value: float
    note: str
    ours: float | None
    deviation: float | None


class Published(Shape):
    paper: str
    same_bearing: bool
    same_load: bool
    absent: str | None
    calibration: str | None
    chosen: dict[str, Chosen]
    rows: list[Printed]


class Rung(Shape):
    name: Label
    error: float | None
    bound: float | None
    seconds: Annotated[float, Field(gt=0, lt=1e12)] | None
    memory: Count | None
    unknowns: Count | None
    chosen: bool
    failed: str | None


class Ladder(Shape):
    quantity: Label
    absent: str | None
    rungs: list[Rung]


class Cost(Shape):
    measured: bool
    seconds: float
    ladders: list[Ladder]


class HardCase(Shape):
    case: str
    outcome: Literal["right", "refused", "wrong"]
    detail: str


class PictureFile(Shape):
    file: FileName
    kind: Literal["pressure", "section", "view"]
    pair: Pair
    geometry: Geometry
    caption: str


class Provenance(Shape):
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


class Report(Shape):
    verdict: Verdict
    tolerance: Positive
    verdicts: list[VerdictRow]
    uncertainties: Uncertainties
    contacts: Annotated[list[Contact], Field(min_length=2, max_length=4)]
    torque: Torque | None
    torque_change: TorqueChange | None
    cage_motion: list[MovedCage | CageAtRest] | None
    published: Published
    sensitivity: Sensitivity | None
    cage_records: list[CageRecord]
    cost: Cost
    hard: list[HardCase]
    warnings: list[str]
    provenance: Provenance
    pictures: Annotated[list[PictureFile], Field(default_factory=list)]
    renderer: str = "VTK"

    @model_validator(mode="after")
    def parts_fit_together(self) -> "Report":
        places = [(contact.pair, contact.geometry) for contact in self.contacts]
        for picture in self.pictures:
            if (picture.pair, picture.geometry) not in places:
                raise ValueError(f"has no contact for the picture {picture.file}")
        for contact in self.contacts:
            rows = [row for row in self.verdicts if (row.pair, row.geometry) == (contact.pair, contact.geometry)]
            named = sorted(row.quantity for row in rows)
            if contact.judged and named != sorted(OfQuantities.model_fields):
                raise ValueError(f"has no verdict on every quantity of {contact.pair}, once")
        if (self.torque is None) != (self.torque_change is None):
            raise ValueError("has torque without torque_change, or the other way round")
        if self.torque is not None and self.torque_change is not None:
            count = len(self.torque.points)
            if self.torque_change.lengths != {count}:
                raise ValueError(f"has a torque_change of other than the {count} points of torque")
        return self
