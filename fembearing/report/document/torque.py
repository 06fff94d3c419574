"""The friction torque of the document: its points, its change by finite-element contacts, its cage, its inputs."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from fembearing.report.document.prediction import Prediction
from fembearing.report.document.ring import RingState
from fembearing.report.document.table import (
    Label,
    NotNegative,
    Numbers,
    OnContacts,
    OnRaces,
    Positive,
    Series,
    Table,
    Two,
    Verdict,
    check_lengths,
)
from fembearing.report.document.verdicts import Verdicts


class OperatingPoint(Table):
    """Speed and loads."""

    inner_speed: float
    axial_load: float
    radial_load: float
    moment: float


class Parts(Table):
    """Parts of the torque; None where one was left out."""

    total: float
    race: float | None
    spin: float | None
    conformity: float | None
    hysteresis: float | None
    rolling: float | None
    cage: float | None
    declared: float | None


class Uncertainty(Table):
    """Uncertainty of the total; None where it is not known."""

    numerical: NotNegative | None
    model: NotNegative | None
    model_parts: dict[str, NotNegative] | None  # of the model's, by the formula that is varied


class LoadedContact(Table):
    """The heaviest ball on one race."""

    load: NotNegative
    semi_axis_rolling: NotNegative
    semi_axis_transverse: NotNegative
    peak_pressure: NotNegative
    approach: NotNegative


class BothRaces(Table):
    """The heaviest ball on both races."""

    inner: LoadedContact
    outer: LoadedContact


class Interval(Table):
    """Intervals at 95 %."""

    torque: Two
    max_force: Two


class CageState(Table):
    """What the cage does at an operating point; None where there is no cage, or none that moved."""

    mean_force: float | None
    max_force: float | None
    interval: Interval | None
    duration: float | None
    state: str | None
    signed_moment: float | None
    whirl_speed: float | None
    wobble: float | None
    ball_lead: float | None
    grip_share: float | None
    grip_number: float | None
    race_excess: float | None


class Point(OperatingPoint):
    """The torque at one operating point."""

    contact_angle: float
    torque: Parts
    friction_coefficient: OnContacts
    film: OnRaces
    asperity_share: OnRaces
    boundary_share: OnRaces
    contact: BothRaces
    uncertainty: Uncertainty
    cage: CageState
    ring: RingState | None  # None for a pair


class Effect(Table):
    """One effect, decided for the whole series."""

    name: str
    decision: str
    share: float | None
    share_is: Literal["part", "trial", "bound", "unbounded", "unknown"]
    reason: str

    @model_validator(mode="after")
    def a_part_or_a_bound_has_its_share(self) -> "Effect":
        """Refuse an effect without the share that it says it has."""
        if self.share is None and self.share_is in ("part", "trial", "bound"):
            raise ValueError("has no share")
        return self


class Band(Table):
    """The catalogue band at each point; None where there is none."""

    low: list[float] | None
    high: list[float] | None
    values: dict[str, list[float | None]]  # by name of the model; None where it does not hold
    note: str


class StatedInput(Table):
    """An input with where it comes from; its uncertainty is a standard deviation."""

    key: str
    value: float | Label | None
    unit: str
    status: Literal["given", "printed", "derived", "assumed", "not known"]
    uncertainty: NotNegative | None
    source: str


class OtherCandidate(Table):
    """The balls that the ratings fit nearly as well, and the total torque with them at each point."""

    ball_count: int
    ball_diameter: Positive
    total: list[float]


class Clearances(Table):
    """The diametral clearance on its way into operation, and the seats; negative is preload."""

    unmounted: float
    mounted: float
    operating: float
    shaft_interference: float
    housing_interference: float
    shaft_pressure: float
    housing_pressure: float
    ball_load: float


class Torque(Table):
    """The friction torque that `fembearing torque` computes."""

    points: Annotated[list[Point], Field(min_length=1)]
    gap_roughness: Positive | None
    clearances: Clearances | None
    pair: None  # a check is of one bearing
    effects: list[Effect]
    warnings: list[str]
    unknown: list[str]  # why the numerical uncertainty is not known
    provenance: dict[str, str]
    seconds: NotNegative
    tolerance: Positive
    catalogue_band: Band
    verdicts: Verdicts
    notes: list[str]  # none of them is judged
    inputs: list[StatedInput]
    other_candidate: OtherCandidate | None
    prediction: Prediction | None = None  # a report of before has none
    left_out: list[dict[str, float | str]] = Field(default_factory=list, max_length=0)  # none in a check

    @model_validator(mode="after")
    def the_band_is_whole(self) -> "Torque":
        """Refuse a catalogue band with one side, or at other points."""
        band = self.catalogue_band
        if (band.low is None) != (band.high is None):
            raise ValueError("has half a catalogue_band")
        for side in (band.low, band.high):
            if side is not None and len(side) != len(self.points):
                raise ValueError(f"has {len(side)} values of catalogue_band at {len(self.points)} points")
        for check in self.verdicts.physical:
            if check.point >= len(self.points):
                raise ValueError(f"has a verdict on point {check.point}, and {len(self.points)} points")
        if self.prediction is not None and len(self.prediction.points) != len(self.points):
            raise ValueError(f"has a prediction of {len(self.prediction.points)} points, and {len(self.points)} points")
        return self


class BeforeAndAfter(Table):
    """A number of the production at each point, and with contacts of finite elements; None where none was solved."""

    production: list[float]
    corrected: list[float | None]


class PartChanges(Table):
    """Relative changes of each part at each point.

    None in place of a list: the part was left out. None in a list: no contact was solved at that ball load.
    """

    total: list[float | None]
    race: list[float | None] | None
    spin: list[float | None] | None
    conformity: list[float | None] | None
    hysteresis: list[float | None] | None
    rolling: list[float | None] | None


class FittedChange(Table):
    """What the fit for finite geometry changes at each point; None where it ends."""

    change: list[float | None]
    uncertainty: list[NotNegative | None]


class TorqueChange(Table):
    """What finite-element contacts change in the torque."""

    contact_angle: BeforeAndAfter
    torque: BeforeAndAfter
    change: PartChanges
    uncertainty: NotNegative
    uncertainties: dict[str, NotNegative]
    finite_geometry: FittedChange | None  # None: it is in the production's contacts
    verdict: Verdict
    note: str

    @property
    def lengths(self) -> set[int]:
        """The numbers of points of its lists: one, where they belong together."""
        both = (self.contact_angle, self.torque)
        series = [*(side.production for side in both), *(side.corrected for side in both), self.change.total]
        fitted = () if self.finite_geometry is None else (values for _, values in self.finite_geometry)
        return {len(each) for each in (*series, *fitted)}


class OtherStart(Table):
    """Where the same cage comes to from another start."""

    state: str
    start: str
    torque: float


class CageAtRest(CageState):
    """An operating point whose cage rests, by its closed form."""

    inner_speed: float
    torque: None
    start: None
    block: None
    other: None


class MovedCage(Table):
    """An operating point whose cage moved."""

    inner_speed: float
    state: str
    start: str
    torque: float
    interval: Interval
    signed_moment: float
    mean_force: float
    max_force: float
    whirl_speed: float
    wobble: float
    ball_lead: float
    grip_share: float | None
    grip_number: float | None
    race_excess: float | None
    duration: float
    block: float
    other: OtherStart | None


class Room(Table):
    """Where the centre of the cage can be."""

    size: Positive
    middle: Two
    edge: Annotated[list[Two], Field(min_length=1)]


class Orbit(Table):
    """Places of the centre of the cage."""

    joined: bool
    start_up: Annotated[list[Two], Field(min_length=1)]
    measured: Annotated[list[Two], Field(min_length=1)]


class Forces(Series):
    """Forces of balls on the cage over time."""

    time: Numbers
    largest: Numbers
    sum: Numbers


class Exceedance(Series):
    """How often each force is exceeded."""

    force: list[Positive]
    share: list[Positive]


class CageRecord(Table):
    """One motion of a cage, as it is drawn."""

    point: int
    inner_speed: float
    bearing: str
    state: Literal["rest", "whirl", "irregular", "mixed"]
    start: str
    start_up: Positive
    torque: float
    torque_interval: Two
    max_force: NotNegative
    max_force_interval: Two
    block: float
    block_maxima: Numbers
    gravity: Annotated[list[float], Field(min_length=3, max_length=3)]
    room: Room
    orbit: Orbit
    forces: Forces
    exceedance: Exceedance


class TotalTorque(OperatingPoint):
    """A torque whose sensitivity to inputs was computed."""

    quantity: Literal["total_torque"]
    pair: None
    value: float


class PeakPressure(Table):
    """A peak pressure whose sensitivity to inputs was computed."""

    quantity: Literal["peak_pressure"]
    pair: Literal["inner", "outer"]
    inner_speed: None
    axial_load: None
    radial_load: None
    moment: None
    value: float


class Input(Table):
    """One input with its range, and what its ends change in each output; None at an end that was refused."""

    name: Label
    unit: Literal["Pa", "1/Pa", "Pa s", "m", "N", "N m", "rad", "K", "1"]
    value: float
    low: float
    high: float
    source: str
    change_low: list[float] | None
    change_high: list[float] | None
    refused: list[str]

    @property
    def swing(self) -> float:
        """The largest change of any output."""
        return max(map(abs, [*(self.change_low or ()), *(self.change_high or ())]), default=0.0)


class Sensitivity(Table):
    """What each input changes in the outputs."""

    outputs: Annotated[list[TotalTorque] | list[PeakPressure], Field(min_length=1)]
    inputs: list[Input]

    @model_validator(mode="after")
    def each_output_has_its_changes(self) -> "Sensitivity":
        """Refuse changes of other outputs than those listed."""
        for each in self.inputs:
            ends = (each.change_low, each.change_high)
            check_lengths(list(self.outputs), *(changes for changes in ends if changes is not None))
        return self
