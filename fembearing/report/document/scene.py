"""The scene in the document, SI: the keys that the page reads, and all others of `analytic.scene.Scene` as they are."""

from typing import Annotated, Literal

from pydantic import ConfigDict, Field

from fembearing.report.document.table import Positive, Table


class Noun(Table):
    """A noun of the scene."""

    model_config = ConfigDict(extra="allow")  # the scene is kept whole


class Material(Noun):
    """A material."""

    name: str
    youngs_modulus: float
    poisson_ratio: float
    source: str


class Groove(Noun):
    """The groove of a ring."""

    bottom_radius: float
    groove_radius: float
    shoulder_half_width: float | None
    far_shoulder_half_width: float | None = None
    material: Material


class Bearing(Noun):
    """The bearing."""

    name: str
    kind: Literal["radial", "thrust"]
    ball_count: int
    ball_diameter: Positive
    ball_material: Material
    inner: Groove
    outer: Groove


class Cage(Noun):
    """The cage."""

    pocket_diameter: float
    pocket_depth: float
    wall_thickness: float
    material: Material


class GivenAngle(Noun):
    """A contact angle that the scene gives."""

    rule: Literal["given"]
    value: float


class SolvedAngle(Noun):
    """A contact angle that follows from the load."""

    rule: Literal["solved"]
    free: float | None


class Operation(Noun):
    """The operating points."""

    axial_load: list[float]
    inner_speed: list[float]
    radial_load: list[float] | float
    moment: list[float] | float


class Lubricant(Noun):
    """The oil."""

    viscosity: float
    reference_temperature: float
    temperature: float
    pressure_viscosity: float
    eyring_stress: float
    traction: str
    name: str


class Autocorrelation(Noun):
    """How heights of a surface hang together."""

    kind: str
    length: float


class HeightMap(Noun):
    """A measured surface."""

    path: str


class Declared(Noun):
    """A surface by its numbers."""

    height_map: None
    rms_roughness: float
    autocorrelation: Autocorrelation
    boundary_friction: float


class Mapped(Noun):
    """A surface by a height map."""

    height_map: HeightMap
    boundary_friction: float


class Scene(Noun):
    """The scene."""

    name: str
    bearing: Bearing
    contact_angle: Annotated[GivenAngle | SolvedAngle, Field(discriminator="rule")]
    operation: Operation
    cage: Cage | None
    lubricant: Lubricant | None
    surface: Declared | Mapped | None
    friction_coefficient: float | None
    spin_rule: str
    calibration: str | None

    @property
    def is_lubricated(self) -> bool:
        """Whether the scene gives all that a film takes."""
        return self.lubricant is not None and self.surface is not None

    @property
    def materials(self) -> list[Material]:
        """Each material once: of the balls, the rings and the cage."""
        bearing = self.bearing
        bodies = [bearing.ball_material, bearing.inner.material, bearing.outer.material]
        bodies += [] if self.cage is None else [self.cage.material]
        return [material for number, material in enumerate(bodies) if material not in bodies[:number]]
