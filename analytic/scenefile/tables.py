"""The tables of a scene file: one class for each table, one field for each key.

Unknown keys are refused. A key without a default must be given. Values are read into SI.
"""

import math
from dataclasses import dataclass
from typing import Annotated, Any, Literal, get_args

from pydantic import BeforeValidator, Field

from analytic import catalog
from analytic.mounting.clearance import Mounting
from analytic.report_details import ReportDetails
from analytic.scene import (
    OIL_TEMPERATURES,
    ArrangementKind,
    AsperityLaw,
    Bearing,
    BearingKind,
    Cage,
    CageGravity,
    CageStart,
    ClearanceGroup,
    Decision,
    ElasticRolling,
    FilmFormula,
    GapModel,
    Lubricant,
    Microslip,
    PocketAxis,
    Reach,
    RollingFormula,
    Scene,
    SpinRule,
    Supply,
    Surface,
    Thickening,
    Traction,
)
from analytic.scenefile.law_packages import BUILT_IN, GROUP, installed_laws
from analytic.scenefile.material import material_entry
from analytic.scenefile.quantity import Dimension, QuantityOrWord, range_of
from analytic.scenefile.spread_tables import AssumedTable, UncertaintyTable
from analytic.scenefile.table import Table, Text, Whole
from analytic.scenefile.viscosity import OIL_VISCOSITY, GivenViscosity
from analytic.units import UnitSystem


def _switch(given: object) -> bool:
    if not isinstance(given, bool):
        raise ValueError("is neither true nor false; give one of them, without quotes")
    return given


def _series_of(kind: Any) -> BeforeValidator:
    """Accepts a quantity of this kind, a list of them, or a range "FIRST to LAST in COUNT"."""
    dimension = get_args(kind)[1]

    def read(given: object) -> list[Any]:
        if given == []:
            raise ValueError("is empty; give a quantity or a list of them")
        if isinstance(given, str) and (parts := range_of(given)) is not None:
            values = parts.values(dimension.read(parts.first), dimension.read(parts.last))
            return [f"{value!r} {dimension.unit}" for value in values.tolist()]
        return given if isinstance(given, list) else [given]

    return BeforeValidator(read)


def _direction(given: object) -> tuple[float, float, float]:
    numbers = isinstance(given, list) and all(isinstance(each, int | float) for each in given)
    length = math.hypot(*given) if isinstance(given, list) and numbers and len(given) == 3 else 0.0
    if not isinstance(given, list) or not 0 < length < math.inf:
        raise ValueError(
            "is no direction; give where gravity points as [x, y, z] of any length, with x towards the radial load and "
            "z along the thrust, for example [1, 0, 0]"
        )
    x, y, z = (float(each) / length for each in given)
    return x, y, z


def _row_of(table: Literal["base_oils", "finishes"], *, thing: str) -> BeforeValidator:
    """Accepts the name of a row of this table of the catalog."""

    def read(given: object) -> object:
        known = catalog.rows(table)
        if given not in tuple(known):
            raise ValueError(f"is not a {thing}; give one of {', '.join(known)}")
        return given

    return BeforeValidator(read)


def _law(given: object) -> object:
    """Accepts the name of a law of traction, built in or installed; the package is not imported yet."""
    if not isinstance(given, str) or (given not in BUILT_IN and given not in installed_laws()):
        known = ", ".join((*BUILT_IN, *installed_laws()))
        raise ValueError(f"is not a law of traction; give one of {known}, or install a package that has it as {GROUP}")
    return given


Count = Annotated[
    int, Whole(things="balls", low=1, high=1000, example=9), Field(description="give a whole number, for example 9")
]
Length = Annotated[float, Dimension(unit="m", low=1e-5, high=10, example='"7.94 mm"')]
Gap = Annotated[float, Dimension(unit="m", low=1e-9, high=10, example='"0.2 mm"')]
Mass = Annotated[float, Dimension(unit="kg", low=1e-12, high=1e4, example='"2.04 g"')]
Angle = Annotated[float, Dimension(unit="rad", low=0, high=1.5, example='"0.18 rad"')]
HEAVIEST = 1e8  # N, and N m: beyond the static load rating of the largest ball bearings that are made
Force = Annotated[float, Dimension(unit="N", low=1e-15, high=HEAVIEST, example='"1 kN"')]
Thrust = Annotated[float, Dimension(unit="N", low=0, high=HEAVIEST, example='"1 kN"')]
Side = Annotated[float, Dimension(unit="N", low=-HEAVIEST, high=HEAVIEST, example='"0.5 kN"')]
FARTHEST = 0.1  # rad: beyond it a tilt is not small
Tilt = Annotated[
    float | Literal["free"],
    QuantityOrWord(
        unit="rad", low=-FARTHEST, high=FARTHEST, example='"0.3 mrad"', words=("free",), meaning="by the loads"
    ),
]
Moment = Annotated[float, Dimension(unit="N m", low=-HEAVIEST, high=HEAVIEST, example='"2 N m"')]
ClearanceEntry = Annotated[
    float | ClearanceGroup,
    QuantityOrWord(unit="m", low=-1, high=1, example='"10 um"', words=get_args(ClearanceGroup), meaning="a group"),
]
Conformity = Annotated[float, Dimension(unit="", low=0.5, high=5, example="0.52")]
Width = Annotated[float, Dimension(unit="m", low=0, high=10, example='"2 mm"')]
Interference = Annotated[float, Dimension(unit="m", low=-1e-2, high=1e-2, example='"12 um"')]  # on the diameter
FASTEST = 1e7 * math.pi / 30  # rad/s: 1e7 rpm
Speed = Annotated[float, Dimension(unit="rad/s", low=-FASTEST, high=FASTEST, example='"300 rpm"')]
Roughness = Annotated[float, Dimension(unit="m", low=0, high=1e-4, example='"0.1 um"')]
Spacing = Annotated[float, Dimension(unit="m", low=1e-10, high=1e-2, example='"2 um"')]
Pressure = Annotated[float, Dimension(unit="Pa", low=1e3, high=1e12, example='"7.8 GPa"')]
COLDEST, HOTTEST = OIL_TEMPERATURES
Temperature = Annotated[float, Dimension(unit="K", low=COLDEST, high=HOTTEST, example='"40 degC"')]
Friction = Annotated[float, Dimension(unit="", low=0, high=5, example="0.1")]
Loss = Annotated[float, Dimension(unit="N m", low=0, high=1e6, example='"5 N mm"')]
Flow = Annotated[float, Dimension(unit="m^3/s", low=0, high=1, example='"0.8 l/min"')]
SealLoss = Annotated[
    float | Literal["estimate", "off"],
    QuantityOrWord(
        unit="N m",
        low=0,
        high=1e6,
        example='"5 N mm"',
        words=("estimate", "off"),
        meaning="SKF's formula or no drag",
    ),
]


class MaterialTable(Table):
    name: Text = "unnamed"
    youngs_modulus: Annotated[float, Dimension(unit="Pa", low=1e3, high=1e13, example='"206 GPa"')]
    poisson_ratio: Annotated[float, Dimension(unit="", low=0, high=0.49999, example="0.3")]
    density: Annotated[float, Dimension(unit="kg/m^3", low=1, high=3e4, example='"7850 kg/m^3"')]
    source: Text = "the scene file"
    hardness: Pressure | None = None  # of indentation; without it, give [surface] hardness
    thermal_expansion: Annotated[float, Dimension(unit="1/K", low=0, high=1e-3, example='"12.5e-6 1/K"')] | None = None


MaterialEntry = Annotated[
    MaterialTable, BeforeValidator(material_entry), Field(description='give a material, for example "steel"')
]
STEEL = Field(default="steel", validate_default=True)


CATALOGUE = 'catalogue: catalog = "6206"'


class GrooveTable(Table):
    HINT = "give a table of conformity, bottom_radius ..."
    bottom_radius: Length | None = None
    groove_radius: Length | None = None
    conformity: Conformity | None = None  # groove_radius over ball_diameter
    # The shoulder that thrust loads: one of these; without it, it is not known.
    shoulder_half_width: Length | None = None
    shoulder_height: Length | None = None
    shoulder_diameter: Length | None = None
    # The other shoulder, if it differs: one of these.
    far_shoulder_half_width: Width | None = None
    far_shoulder_height: Width | None = None
    far_shoulder_diameter: Length | None = None
    material: MaterialEntry = STEEL


class ContactAngleTable(Table):
    HINT = 'give { rule = "solved" }, { nominal = "15 deg" } or { rule = "given", value = "0.18 rad" }'
    rule: Literal["solved", "given"] = "solved"
    value: Angle | None = None  # under load
    free: Angle | None = None  # unloaded, whatever the clearance is
    nominal: Angle | None = None  # unloaded; the clearance follows from it


class BearingTable(Table):
    HINT = 'give a table [bearing] with catalog = "paper_6205" or every dimension'
    catalog: Text | None = None  # a bearing whose dimensions apply where no other is given
    name: Text | None = None
    kind: BearingKind = Bearing.kind  # "thrust": two equal washers at 90 degrees, and nothing but thrust
    ball_count: Count = Field(description="give a whole number, for example 9, or a bearing of the " + CATALOGUE)
    ball_diameter: Length = Field(description='give for example "7.94 mm", or a bearing of the ' + CATALOGUE)
    ball_mass: Mass | None = None  # that of a solid ball by default
    ball_material: MaterialEntry = STEEL
    pitch_diameter: Length | None = None
    conformity: Conformity | None = None  # of both rings
    inner: GrooveTable = GrooveTable()
    outer: GrooveTable = GrooveTable()
    bore_diameter: Length | None = None
    outside_diameter: Length | None = None
    width: Length | None = None
    static_load_rating: Force | None = None  # C0 of a maker's catalogue, only for the catalogue band
    dynamic_load_rating: Force | None = None  # C of a maker's catalogue
    clearance: ClearanceEntry | None = None  # unmounted, on the diameter: a length, negative is preload; or a group
    contact_angle: ContactAngleTable = ContactAngleTable()


class MountingTable(Table):
    HINT = "give a table [mounting] of seats and temperatures"
    shaft_interference: Interference = 0.0
    housing_interference: Interference = 0.0
    shaft_bore: Annotated[float, Dimension(unit="m", low=0, high=10, example='"10 mm"')] = Mounting.shaft_bore
    shaft_material: MaterialEntry = STEEL
    housing_outside_diameter: Length | None = None  # without one the housing has no end
    housing_material: MaterialEntry = STEEL
    inner_temperature: Temperature | None = None  # of inner ring and shaft
    outer_temperature: Temperature | None = None  # of outer ring and housing
    ball_temperature: Temperature | None = None  # the mean of both by default
    mounting_temperature: Temperature = Mounting.mounting_temperature


class ArrangementTable(Table):
    HINT = 'give a table [arrangement] of kind = "O" and preload = "100 N", or leave it out'
    kind: ArrangementKind = Field(description='give "O" (back to back, DB), "X" (face to face, DF) or "tandem" (DT)')
    preload: Force | None = None  # axial, of the mounted pair at standstill
    offset: Gap | None = None  # axial distance that clamping closes, of the pair
    distance: Length | None = None  # between the middles of both bearings


class LandTable(Table):
    HINT = 'give { ring = "outer", clearance = "0.3 mm", width = "10 mm" }'
    ring: Literal["inner", "outer"] = Field(description='give "inner" or "outer"')
    clearance: Gap  # on the diameter
    width: Length  # of the cage


class PocketApproachTable(Table):
    """Approach by a test or finite elements, in place of Hertz's. With sheet_stiffness, of the contact alone."""

    HINT = 'give the approach by a test or finite elements, { load = "28 N", approach = "0.883 um" }'
    load: Force
    approach: Gap


def _no_cage(given: object) -> object:
    """Accepts the word of a scene whose cage is left out."""
    if isinstance(given, str) and given != "none":
        raise ValueError(f"is no cage; {CageTable.HINT}")
    return None if given == "none" else given


class CageTable(Table):
    HINT = 'give a table [cage] of pocket_clearance, wall_thickness, mass and material, or cage = "none"'
    variant: Text | None = None  # of the cage in the catalog
    pocket_clearance: Gap | None = None  # pocket diameter minus ball diameter
    pocket_diameter: Length | None = None
    pocket_depth: Length | None = None  # half of the pocket diameter by default
    wall_thickness: Length
    mass: Mass
    material: MaterialEntry
    pocket_axis: PocketAxis = Cage.pocket_axis
    pocket_approach: PocketApproachTable | None = None
    sheet_stiffness: Annotated[float, Dimension(unit="N/m", low=1e3, high=1e12, example='"130 N/um"')] | None = None
    friction_coefficient: Friction | None = None
    restitution: Annotated[float, Dimension(unit="", low=0.05, high=1, example="0.8")] = Cage.restitution
    start: CageStart | None = Field(default=None, description='give "rest", "ramp", "sudden" or "whirl"')
    seeds: Annotated[int, Whole(things="seeds", low=2, high=1000, example=4)] = Cage.seeds
    duration: Annotated[float, Dimension(unit="s", low=1e-4, high=1e3, example='"0.2 s"')] = Cage.duration
    # With fewer steps the error for fast cages is a half and more (`fembearing cost` shows it); more only take longer.
    steps_per_contact: Annotated[int, Whole(things="steps", low=10, high=1000, example=40)] = Cage.steps_per_contact
    gravity: CageGravity = Cage.gravity
    drag: Annotated[float, Dimension(unit="N*m*s", low=0, high=1, example='"1e-6 N m s"')] = Cage.drag
    land: LandTable | None = None


class OperationTable(Table):
    HINT = "give a table [operation] with inner_speed and a load, axial_load for example"
    axial_load: Annotated[list[Thrust], _series_of(Thrust)] = Field(default=[0.0])
    inner_speed: Annotated[list[Speed], _series_of(Speed)] = Field(description='give for example "300 rpm"')
    radial_load: Annotated[list[Side], _series_of(Side)] = Field(default=[0.0])
    moment: Annotated[list[Moment], _series_of(Moment)] = Field(default=[0.0])
    # Of the inner ring about y, against which the moment acts; 0 by default, free where a moment is given
    tilt: Tilt | None = None
    down: Annotated[tuple[float, float, float], BeforeValidator(_direction)] | None = None

    @property
    def is_free(self) -> bool:
        """Whether the ring tilts as its loads and moment have it."""
        return self.tilt == "free" or (self.tilt is None and "moment" in self.model_fields_set)


@dataclass(frozen=True)
class GivenLength:
    """A length that is given where a share may stand too."""

    metres: float


@dataclass(frozen=True, kw_only=True)
class Extent(Dimension):
    """A share of the ball's radius, or a length."""

    @property
    def accepted(self) -> str:
        """The end of every message."""
        return f"{super().accepted} of the ball's radius, or a length, {EXTENT.example}"

    def read(self, given: object) -> Any:
        """The share, or the length. Raises ValueError as `Dimension.read`."""
        if isinstance(given, str) and not given.rstrip().endswith("%"):
            return GivenLength(EXTENT.read(given))
        return super().read(given)


EXTENT = Dimension(unit="m", low=1e-7, high=1.0, example='"3 mm"')
ReachValue = Annotated[float | GivenLength, Extent(unit="", low=0.05, high=1, example="0.9")]


class ReachTable(Table):
    """Reach of the oil from the centre of a contact along rolling."""

    HINT = "give { ahead = 0.9 }, of the ball's radius, or a length"
    ahead: ReachValue = Reach.ahead
    behind: ReachValue = Reach.behind


class LubricantTable(Table):
    """Missing values follow from the name, the viscosities or the base oil: see `analytic.scenefile.oil`."""

    HINT = 'give a table [lubricant] with name = "ISO VG 46", or with viscosity and pressure_viscosity'

    name: Text | None = None  # of an oil or grease of the catalog
    base_oil: Annotated[str, _row_of("base_oils", thing="base oil")] | None = (
        None  # where the oil has no name of the catalog
    )
    viscosity: Annotated[GivenViscosity, OIL_VISCOSITY] | None = None
    pressure_viscosity: Annotated[float, Dimension(unit="1/Pa", low=0, high=1e-7, example='"2e-8 1/Pa"')] | None = None
    eyring_stress: Annotated[float, Dimension(unit="Pa", low=1e3, high=1e9, example='"5 MPa"')] | None = None
    traction: Annotated[Traction | str, BeforeValidator(_law)] = Field(
        "eyring_sinh", description='give "eyring_sinh", "eyring_constant" or the name of an installed law'
    )
    # Of the viscosity under pressure in the shear stress
    thickening: Thickening = Lubricant.thickening
    # Over the pressure; 0.05 to 0.08 for lubricants (no source seen).
    limiting_shear: Annotated[float, Dimension(unit="", low=0, high=1, example="0.065")] | None = None
    reference_temperature: Temperature | None = None  # of a viscosity without a temperature
    temperature: Temperature | None = None  # of the oil at the inlet; the reference temperature by default
    viscosity_temperature: Annotated[float, Dimension(unit="1/K", low=0, high=0.2, example='"0.045 1/K"')] | None = None
    thermal_conductivity: (
        Annotated[float, Dimension(unit="W/m/K", low=1e-3, high=100, example='"0.14 W/m/K"')] | None
    ) = None
    density: Annotated[float, Dimension(unit="kg/m^3", low=100, high=5000, example='"870 kg/m^3"')] | None = None
    supply: Supply = Lubricant.supply
    # Of the oil that bleeds from a grease
    surface_tension: Annotated[float, Dimension(unit="N/m", low=1e-3, high=1.0, example='"0.022 N/m"')] | None = None
    # Distance of the oil's meniscus from the centre of a contact, over its semi-axis along rolling; by the supply if
    # it is not given.
    starvation_degree: Annotated[float, Dimension(unit="", low=1, high=1e9, example="2")] | None = None
    reach: ReachTable = ReachTable()
    cavitation_pressure: Annotated[float, Dimension(unit="Pa", low=-1e8, high=0, example='"-0.1 MPa"')] = (
        Lubricant.cavitation_pressure
    )
    compressible: Annotated[bool, BeforeValidator(_switch)] = Lubricant.compressible
    film_formula: FilmFormula = Lubricant.film_formula
    rolling_formula: RollingFormula = Lubricant.rolling_formula


class AutocorrelationTable(Table):
    HINT = 'give { kind = "gaussian", length = "60 um", spacing = "2 um" }'
    kind: Literal["gaussian", "exponential"] = Field(description='give "gaussian" or "exponential"')
    length: Spacing
    spacing: Spacing


class HeightMapTable(Table):
    HINT = 'give { path = "race.npy", spacing = "2 um" }'
    path: Text = Field(
        description="give the path of a .npy, .csv (heights in m) or .x3p file, from the scene file's folder"
    )
    spacing: Spacing | None = None  # required but for a .x3p file, which has its own


class ThermalTable(Table):
    """Heat flow from the bearing to its surroundings; in the steady state it equals the power of friction."""

    HINT = 'give { resistance = "0.5 K/W", ambient = "20 degC" }'
    resistance: Annotated[float, Dimension(unit="K/W", low=0, high=1e6, example='"0.5 K/W"')]  # oil to surroundings
    ambient: Temperature  # of the surroundings


class SurfaceTable(Table):
    HINT = "give a table [surface] with rms_roughness and autocorrelation, finish, Ra or height_map"
    rms_roughness: Roughness | None = None  # of each surface
    Ra: Roughness | None = None  # of each surface, instead
    finish: Annotated[str, _row_of("finishes", thing="finish")] | None = None  # of the race, instead
    ball_rms_roughness: Roughness | None = None  # if it differs from that of the race
    autocorrelation: AutocorrelationTable | None = None
    height_map: HeightMapTable | None = None
    hardness: Pressure | None = None  # that of the softer material of ball and race by default
    # 0.1 to 0.15 for steel on steel with mineral oil (no source seen).
    boundary_friction: Annotated[float, Dimension(unit="", low=0, high=5, example="0.12")] = Surface.boundary_friction
    gap: GapModel = Surface.gap
    asperities: AsperityLaw | None = None  # of gap = "truncated", zhao_maietta_chang by default


class FrictionTable(Table):
    HINT = "give a table [friction], with coefficient where no lubricant is given"
    coefficient: Friction | None = None  # of every race contact; replaces that of lubricant and surface
    hysteresis_loss: Annotated[float, Dimension(unit="", low=0, high=1, example="0.007")] | None = None
    elastic_rolling: ElasticRolling = Scene.elastic_rolling
    spin_rule: SpinRule = Scene.spin_rule
    microslip: Microslip = Scene.microslip  # "as_printed": equations 2 to 7 with the misprints of the paper


class ShearedLandTable(Table):
    HINT = 'give { ring = "inner", diameter = "31 mm", clearance = "0.3 mm", width = "4 mm" }'
    ring: Literal["inner", "outer"] = Field(description='give "inner" or "outer"')
    diameter: Length  # of the shoulder
    clearance: Gap  # on the diameter
    width: Length  # of all lands together


class ShearedPocketsTable(Table):
    HINT = 'give { clearance = "0.2 mm", thickness = "2 mm" }'
    clearance: Gap  # on the diameter
    thickness: Length  # of the cage at its pockets


class LossesTable(Table):
    HINT = 'give a table [losses] of seals = "5 N mm", drag, oil_flow, oil_share, land, pockets'
    seals: SealLoss | None = None  # of both seals together
    drag: Loss | None = None  # of the oil that balls and cage move
    oil_flow: Flow | None = None  # through each bearing
    oil_share: Annotated[float, Dimension(unit="", low=0, high=1, example='"2 %"')] | None = None  # the rest is air
    land: ShearedLandTable | None = None
    pockets: ShearedPocketsTable | None = None


class EffectsTable(Table):
    HINT = 'give a table [effects] of "auto", "on", "off"'
    load_distribution: Decision = "auto"
    centrifugal: Decision = "auto"
    gyroscopic: Decision = "auto"
    weight: Decision = "auto"
    finite_geometry: Decision = "auto"
    asperities: Decision = "auto"
    inlet_heating: Decision = "auto"
    starvation: Decision = "auto"
    spin: Decision = "auto"
    conformity: Decision = "auto"
    creep: Decision = "auto"
    hysteresis: Decision = "auto"
    rolling: Decision = "auto"
    unloaded_balls: Decision = "auto"
    cage: Decision = "auto"
    cage_dynamics: Decision = "auto"
    ball_dynamics: Decision = "auto"
    through_flow: Decision = "auto"
    cage_shear: Decision = "auto"
    ball_drag: Decision = "auto"


class MeasuredTable(Table):
    """Measured torques, to compare with the computed ones."""

    HINT = 'give a table [measured] of file = "data.csv"'

    file: Text = Field(description="give the path of a CSV file of measured torques, from the scene file's folder")


class ReportTable(Table):
    """Names, dates and units in the report."""

    HINT = 'give a table [report] of author = "N. N.", date ...'

    author: Text | None = None
    checker: Text | None = None
    revision: Text | None = None
    date: Text | None = None  # in quotes, in any form
    units: UnitSystem = ReportDetails.units


class SceneTable(Table):
    name: Text
    calibration: Text | None = Field(default=None, description="give the inputs that were fitted, and to which numbers")
    tolerance: Annotated[float, Dimension(unit="", low=1e-6, high=1, example='"5 %"')]
    bearing: BearingTable
    operation: OperationTable
    mounting: MountingTable | None = None
    arrangement: ArrangementTable | None = None
    cage: Annotated[CageTable | None, BeforeValidator(_no_cage)] = None  # "none": left out
    lubricant: LubricantTable | None = None
    thermal: ThermalTable | None = None
    surface: SurfaceTable | None = None
    friction: FrictionTable | None = None
    losses: LossesTable = LossesTable()
    effects: EffectsTable = EffectsTable()
    uncertainty: UncertaintyTable = UncertaintyTable()  # pyright: ignore[reportInvalidTypeForm]
    assumed: AssumedTable = AssumedTable()  # pyright: ignore[reportInvalidTypeForm]
    measured: MeasuredTable | None = None
    report: ReportTable = ReportTable()
