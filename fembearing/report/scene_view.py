"""The scene of a report, as far as the page tells of it: report.json holds it whole, whatever version wrote it."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar, Literal

from analytic.declared import nothing
from analytic.rows import Positive
from analytic.scene import Autocorrelation, Groove, HeightMapFile, Material, Origin


@dataclass(frozen=True, kw_only=True)
class Bearing:
    """The bearing."""

    name: str
    kind: Literal["radial", "thrust"]
    ball_count: int
    ball_diameter: Positive
    ball_material: Material
    inner: Groove
    outer: Groove
    bore_diameter: Positive | None = None
    outside_diameter: Positive | None = None
    width: Positive | None = None
    origins: Mapping[str, Origin] = field(default_factory=nothing)


@dataclass(frozen=True, kw_only=True)
class Cage:
    """The cage."""

    pocket_diameter: float
    pocket_depth: float
    wall_thickness: float
    material: Material


@dataclass(frozen=True, kw_only=True)
class GivenAngle:
    """A contact angle that the scene gives."""

    rule: Literal["given"]
    value: float


@dataclass(frozen=True, kw_only=True)
class SolvedAngle:
    """A contact angle that follows from the load."""

    rule: Literal["solved"]
    free: float | None


@dataclass(frozen=True, kw_only=True)
class Operation:
    """The operating points."""

    axial_load: tuple[float, ...]
    inner_speed: tuple[float, ...]
    radial_load: tuple[float, ...] | float
    moment: tuple[float, ...] | float


@dataclass(frozen=True, kw_only=True)
class OwnLaw:
    """A user's law of traction."""

    name: str
    sha256: str
    distribution: str
    version: str


@dataclass(frozen=True, kw_only=True)
class Lubricant:
    """The oil."""

    viscosity: float
    reference_temperature: float
    temperature: float
    pressure_viscosity: float
    eyring_stress: float | None  # None: it follows the pressure
    traction: str | OwnLaw
    supply: str
    name: str
    origins: Mapping[str, Origin] = field(default_factory=nothing)


@dataclass(frozen=True, kw_only=True)
class Declared:
    """A surface by its numbers."""

    height_map: None
    rms_roughness: float
    autocorrelation: Autocorrelation
    boundary_friction: float


@dataclass(frozen=True, kw_only=True)
class Mapped:
    """A surface by a height map."""

    height_map: HeightMapFile
    boundary_friction: float


@dataclass(frozen=True, kw_only=True)
class SceneView:
    """The scene as far as the page tells of it."""

    __pydantic_config__: ClassVar[dict[str, Any]] = {"strict": True, "extra": "ignore", "allow_inf_nan": False}

    name: str
    bearing: Bearing
    contact_angle: GivenAngle | SolvedAngle
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
