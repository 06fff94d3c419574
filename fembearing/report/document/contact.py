"""The contacts of the document: each by Hertz and by finite elements, with its meshes, curves and profiles."""

from typing import Annotated, Literal

from pydantic import Field, model_validator

from fembearing.report.document.table import (
    Count,
    Geometry,
    NotNegative,
    Numbers,
    OfQuantities,
    Pair,
    Positive,
    Series,
    Table,
    Verdict,
)


class Profile(Series):
    """Pressure along one axis."""

    position: Numbers
    pressure: Numbers


class BothProfiles(Table):
    """The pressure along one axis at the nodes of the finest mesh, and by Hertz."""

    fe: Profile
    hertz: Profile


class PressureProfile(Table):
    """The pressure along both axes through the centre."""

    rolling: BothProfiles
    transverse: BothProfiles


class ApproachCurve(Series):
    """Approach over load; None where the fit for finite geometry ends."""

    load: list[Positive]
    hertz: Annotated[list[Positive], Field(min_length=1)]
    corrected: list[Positive | None]
    uncertainty: list[NotNegative | None]


class Corrected(Table):
    """Hertz corrected for finite geometry."""

    values: OfQuantities[Positive]
    uncertainty: OfQuantities[NotNegative]
    interpolation_error: OfQuantities[float]


class Ring(Table):
    """What a ring on a rigid seat adds to the approach."""

    approach: float
    share: float
    uncertainty: NotNegative


class Estimated(Table):
    """A quantity at a shoulder, by finite elements."""

    fe: float
    uncertainty: NotNegative
    values: list[float]
    order: float | None


class Sides(Table):
    """Distances of the shoulders that cut a contact off."""

    above: float = 0.0  # one of both is not given where one side alone is cut off
    below: float = 0.0


class Shoulder(Table):
    """What a contact does at the shoulder that cuts it off."""

    sides: Sides
    half: bool
    peak_pressure_at: float
    strip_width: float
    hertz_line_load: Positive
    centroid: Estimated
    strip_share: Estimated
    strip_line_load: Estimated

    @property
    def cuts(self) -> list[float]:
        """y of each shoulder that cuts the contact off, the nearer one first."""
        given = self.sides.model_fields_set
        cuts = [y for side, y in (("above", self.sides.above), ("below", -self.sides.below)) if side in given]
        return sorted(cuts, key=abs)


class Study(Table):
    """One quantity on all meshes, coarse to fine, and what they say together."""

    values: list[Positive]
    order: float | None
    grid_convergence_index: float | None
    formal_order: float | None
    richardson: Positive | None
    mesh: NotNegative
    beyond: float
    sides: float = 0.0
    domain: NotNegative
    corrected: Annotated[list[Positive], Field(default_factory=list)]


class Mesh(Table):
    """One mesh of a contact."""

    level: int
    unknowns: Count
    seconds: NotNegative


class SolveCost(Table):
    """What a contact cost to solve."""

    seconds: NotNegative
    unknowns: Count
    peak_memory: Count | None


class Contact(Table):
    """One contact, by Hertz and by finite elements."""

    pair: Pair
    geometry: Geometry
    load: Positive
    contact_angle: float
    fe: OfQuantities[Positive]
    uncertainty: OfQuantities[NotNegative]
    hertz: OfQuantities[Positive]
    discrepancy: OfQuantities[float]
    corrected: Corrected | None
    verdict: Verdict | Literal["shown"]
    judged: bool
    method: str = Field(alias="rung")
    refinement: Literal["twin", "levels"] = "levels"
    meshes: Annotated[list[Mesh], Field(min_length=2)]
    ring: Ring | None
    convergence: OfQuantities[Study]
    pressure_profile: PressureProfile
    approach_curve: ApproachCurve
    shoulder: Shoulder | None
    cost: SolveCost
    warnings: list[str]

    @model_validator(mode="after")
    def each_mesh_has_its_value(self) -> "Contact":
        """Refuse a convergence study on other meshes than those listed."""
        for name, study in self.convergence:
            if len(study.values) != len(self.meshes):
                raise ValueError(f"has {len(study.values)} values of {name} on {len(self.meshes)} meshes")
        return self
