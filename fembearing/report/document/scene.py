"""What report.json must hold of the scene for the page to be made from it, SI; see `fembearing.report.document.document`."""

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

Positive = Annotated[float, Field(gt=0)]
Two = Annotated[list[float], Field(min_length=2, max_length=2)]  # JSON has no tuples


class Shape(BaseModel):
    model_config = ConfigDict(strict=True, allow_inf_nan=False)


class Material(Shape):
    name: str
    youngs_modulus: float
    poisson_ratio: float
    source: str


class Groove(Shape):
    bottom_radius: float
    groove_radius: float
    shoulder_half_width: float
    material: Material


class Bearing(Shape):
    name: str
    ball_count: int
    ball_diameter: Positive
    ball_material: Material
    inner: Groove
    outer: Groove


class Cage(Shape):
    pocket_diameter: float
    pocket_depth: float
    wall_thickness: float
    material: Material


class GivenAngle(Shape):
    rule: Literal["given"]
    value: float


class SolvedAngle(Shape):
    rule: Literal["solved"]
    free: float | None


class Operation(Shape):
    axial_load: list[float]
    inner_speed: list[float]
    radial_load: list[float] | float
    moment: list[float] | float


class Lubricant(Shape):
    viscosity: float
    reference_temperature: float
    temperature: float
    pressure_viscosity: float
    eyring_stress: float
    traction: str


class Autocorrelation(Shape):
    kind: str
    length: float


class HeightMap(Shape):
    path: str


class Declared(Shape):
    height_map: None
    rms_roughness: float
    autocorrelation: Autocorrelation
    boundary_friction: float


class Mapped(Shape):
    height_map: HeightMap
    boundary_friction: float


class Scene(Shape):
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
