"""A bearing problem: what the bearing is made of, how it is run, and how accurate the result has to be.

Every quantity is a float in SI (m, kg, N, Pa, rad, rad/s); `analytic.quantity` reads other units.
Axes of a contact from its centre: z along the load, x along rolling, y along the groove's profile. Convex radii: > 0.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import InitVar, dataclass, field, replace
from typing import Annotated, Any, Literal, get_args

import numpy as np
from numpy.typing import NDArray

from analytic.brief import points_of
from analytic.declared import DERIVED, FILLED, REQUIRED, InFile, Noun, Switch, Text, Whole, nothing
from analytic.errors import InputError, real_numbers, require_positive
from analytic.given import Supply, UnitSystem
from analytic.quantity import Dimension, QuantityOrWord, Series
from analytic.words import shown

Array = NDArray[np.float64]
Pair = Literal["inner", "outer", "pocket"]
SpinRule = Literal["free", "balanced", "inner_control", "outer_control"]
Microslip = Literal["derived", "as_printed"]
Traction = Literal["eyring_sinh", "eyring_constant"]
Thickening = Literal["modulus", "roelands"]
FilmFormula = Literal["numerical", "nijenbanning"]
RollingFormula = Literal["numerical", "biboulet", "houpert"]
ElasticRolling = Literal["hysteresis", "houpert"]
Decision = Literal["auto", "on", "off"]
EffectName = Literal[
    *("load_distribution", "centrifugal", "gyroscopic", "weight", "finite_geometry", "asperities", "inlet_heating"),
    *("starvation", "spin", "conformity", "creep", "hysteresis", "rolling", "unloaded_balls", "cage", "cage_dynamics"),
    *("ball_dynamics", "through_flow", "cage_shear", "ball_drag"),
]
PocketAxis = Literal["axial", "radial"]
CageStart = Literal["rest", "ramp", "sudden", "whirl"]
CageGravity = Literal["across", "along", "off"]
GapModel = Literal["elastic", "truncated"]
AsperityLaw = Literal["zhao_maietta_chang", "greenwood_williamson"]
Status = Literal["given", "printed", "derived", "assumed", "not known"]
ClearanceGroup = Literal["C2", "CN", "C3", "C4", "C5"]
ArrangementKind = Literal["O", "X", "tandem"]
Grade = Literal["printed", "A", "B", "C", "D"]
BearingKind = Literal["radial", "thrust"]
# How balls turn and slide: as friction has it, with and without elastic creep, or by closed kinematics
Sliding = Literal["marched_creep", "free_ball", "over_ellipse", "as_printed", "none"]

STANDARD_GRAVITY = 9.80665  # m/s^2
STEEPEST_DEEP_GROOVE = 20.0  # degrees: a larger unloaded contact angle is that of an angular contact bearing
UNIT_LENGTH = 0.01  # by which a unit vector may be off 1: its numbers may be rounded to two digits
OIL_TEMPERATURES = 200.0, 600.0  # K: between them is the oil of a scene
# Loss factor of bearing steel under rolling that calculations take most often: no measured one was found.
USUAL_LOSS = 0.007
MINERAL_RISE = -68.20e-3, 27.68e-5  # 1, 1/K: b1 and b2 of M100, a paraffinic oil, table 2 of [Arana2019]
LOSS_SPREAD = 0.5  # standard deviation of its logarithm, a judgement: 0.003 to 0.025 are in use


def _quantity(unit: str, low: float, high: float, example: str) -> Dimension:
    return Dimension(unit=unit, low=low, high=high, example=example)


HEAVIEST = 1e8  # N, and N m: beyond the static load rating of the largest ball bearings that are made
FASTEST = 1e7 * math.pi / 30  # rad/s: 1e7 rpm
FARTHEST = 0.1  # rad: beyond it a tilt is not small
COLDEST, HOTTEST = OIL_TEMPERATURES
CATALOGUE = 'catalogue: catalog = "6206"'
# What fields take: unit in SI, least and largest value in it, and an example.
Count = Annotated[int, Whole(things="balls", low=1, high=1000, example=9)]
Length = Annotated[float, _quantity("m", 1e-5, 10, '"7.94 mm"')]
Gap = Annotated[float, _quantity("m", 1e-9, 10, '"0.2 mm"')]
Width = Annotated[float, _quantity("m", 0, 10, '"2 mm"')]
Interference = Annotated[float, _quantity("m", -1e-2, 1e-2, '"12 um"')]  # on the diameter
Roughness = Annotated[float, _quantity("m", 0, 1e-4, '"0.1 um"')]
Spacing = Annotated[float, _quantity("m", 1e-10, 1e-2, '"2 um"')]
Mass = Annotated[float, _quantity("kg", 1e-12, 1e4, '"2.04 g"')]
Angle = Annotated[float, _quantity("rad", 0, 1.5, '"0.18 rad"')]
Force = Annotated[float, _quantity("N", 1e-15, HEAVIEST, '"1 kN"')]
Thrust = Annotated[float, _quantity("N", 0, HEAVIEST, '"1 kN"')]
Side = Annotated[float, _quantity("N", -HEAVIEST, HEAVIEST, '"0.5 kN"')]
Moment = Annotated[float, _quantity("N m", -HEAVIEST, HEAVIEST, '"2 N m"')]
Speed = Annotated[float, _quantity("rad/s", -FASTEST, FASTEST, '"300 rpm"')]
Tilt = Annotated[
    float | Literal["free"],
    QuantityOrWord(
        unit="rad", low=-FARTHEST, high=FARTHEST, example='"0.3 mrad"', words=("free",), meaning="by the loads"
    ),
]
Modulus = Annotated[float, _quantity("Pa", 1e3, 1e13, '"206 GPa"')]
PoissonRatio = Annotated[float, _quantity("", 0, 0.49999, "0.3")]
MaterialDensity = Annotated[float, _quantity("kg/m^3", 1, 3e4, '"7850 kg/m^3"')]
Hardness = Annotated[float, _quantity("Pa", 1e3, 1e12, '"7.8 GPa"')]
Expansion = Annotated[float, _quantity("1/K", 0, 1e-3, '"12.5e-6 1/K"')]
Stiffness = Annotated[float, _quantity("N/m", 1e3, 1e12, '"130 N/um"')]
Friction = Annotated[float, _quantity("", 0, 5, "0.1")]
Restitution = Annotated[float, _quantity("", 0.05, 1, "0.8")]
Seeds = Annotated[int, Whole(things="seeds", low=2, high=1000, example=4)]
Steps = Annotated[int, Whole(things="steps", low=10, high=1000, example=40)]
Duration = Annotated[float, _quantity("s", 1e-4, 1e3, '"0.2 s"')]
CageDrag = Annotated[float, _quantity("N m s", 0, 1, '"1e-6 N m s"')]
Temperature = Annotated[float, _quantity("K", COLDEST, HOTTEST, '"40 degC"')]
DynamicViscosity = Annotated[float, _quantity("Pa s", 1e-4, 1e4, '"0.06 Pa s"')]
PressureViscosity = Annotated[float, _quantity("1/Pa", 0, 1e-7, '"2e-8 1/Pa"')]
ThermalSlope = Annotated[float, _quantity("1/K", 0, 0.2, '"0.045 1/K"')]
Conductivity = Annotated[float, _quantity("W/m/K", 1e-3, 100, '"0.14 W/m/K"')]
OilDensity = Annotated[float, _quantity("kg/m^3", 100, 5000, '"870 kg/m^3"')]
LimitingShear = Annotated[float, _quantity("", 0, 1, "0.065")]
EyringStress = Annotated[float, _quantity("Pa", 1e3, 1e9, '"5 MPa"')]
SurfaceTension = Annotated[float, _quantity("N/m", 1e-3, 1.0, '"0.022 N/m"')]
StarvationDegree = Annotated[float, _quantity("", 1, 1e9, "2")]
Cavitation = Annotated[float, _quantity("Pa", -1e8, 0, '"-0.1 MPa"')]
Reaching = Annotated[float, _quantity("", 0.05, 1, "0.9")]
Asperity = Annotated[float, _quantity("", 0, 5, "0.12")]
LossFactor = Annotated[float, _quantity("", 0, 1, "0.007")]
Loss = Annotated[float, _quantity("N m", 0, 1e6, '"5 N mm"')]
Flow = Annotated[float, _quantity("m^3/s", 0, 1, '"0.8 l/min"')]
Share = Annotated[float, _quantity("", 0, 1, '"2 %"')]
Tolerance = Annotated[float, _quantity("", 1e-6, 1, '"5 %"')]
Resistance = Annotated[float, _quantity("K/W", 0, 1e6, '"0.5 K/W"')]
OnOff = Annotated[bool, Switch()]
OF_FRICTION = InFile(at="friction.")
THRUSTS, SIDES, MOMENTS, SPEEDS = (Series(of=get_args(kind)[1]) for kind in (Thrust, Side, Moment, Speed))


@dataclass(frozen=True, kw_only=True)
class Material(Noun):
    """An isotropic elastic solid."""

    name: Annotated[Text, InFile("unnamed"), "of the catalog, or any other"]
    youngs_modulus: Annotated[Modulus, "E, of elasticity"]
    poisson_ratio: Annotated[PoissonRatio, "nu, transverse strain over axial strain"]
    density: Annotated[MaterialDensity, "mass over volume"]
    source: Annotated[Text, InFile("the scene file"), "where the numbers come from"]
    hardness: Annotated[Hardness | None, "of indentation, H"] = None
    thermal_expansion: Annotated[Expansion | None, "of length"] = None


@dataclass(frozen=True, kw_only=True)
class Origin(Noun):
    """Where a dimension or a property comes from, and how far to trust it."""

    status: Status  # how it came about, in a word
    uncertainty: float | None  # standard deviation, in the unit of the value; None: unknown
    source: str  # in words


@dataclass(frozen=True, kw_only=True)
class Groove(Noun):
    """The raceway of one ring: a torus, with a flat land beyond each shoulder.

    Thrust loads the side of the near shoulder. A far half-width of 0 is a groove that is cylindrical from its bottom
    on, as in a counterbored outer ring. Half-widths of a thrust washer lie along the radius, the near one outside.
    """

    HINT = "give a table of conformity, bottom_radius ..."
    bottom_radius: Annotated[Length, FILLED, "bearing axis to the bottom of the groove"]
    groove_radius: Annotated[Length, FILLED, "r_g, of the profile of the groove"]
    shoulder_half_width: Annotated[Length | None, FILLED, "bottom of the groove to the near shoulder, along the axis"]
    material: Annotated[Material, InFile("steel")]
    far_shoulder_half_width: Annotated[Width | None, "likewise to the far shoulder; without it as the near one"] = None

    @property
    def half_widths(self) -> tuple[float | None, float | None]:
        """Bottom of the groove to the near and to the far shoulder, m; None: not known."""
        near, far = self.shoulder_half_width, self.far_shoulder_half_width
        return near, near if far is None else far


@dataclass(frozen=True, kw_only=True)
class Land(Noun):
    """The ring whose shoulders guide the cage: the rims of the cage touch them before its pockets touch the balls."""

    HINT = 'give { ring = "outer", clearance = "0.3 mm", width = "10 mm" }'
    ring: Annotated[Literal["inner", "outer"], "to which the shoulders belong"]
    clearance: Annotated[Gap, "on the diameter"]
    width: Annotated[Length, "of the cage, from rim to rim"]


@dataclass(frozen=True, kw_only=True)
class Cage(Noun):
    """The ball cage: a sheet with a spherical pocket around each ball, and how it moves."""

    HINT = 'give a table [cage] of pocket_clearance, wall_thickness, mass and material, or cage = "none"'
    pocket_diameter: Annotated[Length, FILLED, "of the sphere of a pocket, D_p"]
    pocket_depth: Annotated[Length, FILLED, "pole of a half pocket to the plane of both halves, k"]
    wall_thickness: Annotated[Length, "of the sheet"]
    mass: Annotated[Mass, "of the whole cage"]
    material: Annotated[Material, InFile(REQUIRED)]
    pocket_axis: Annotated[PocketAxis, "line through the centres of both half-shells; axial in a stamped cage"] = (
        "axial"
    )
    # K_pb, N/m^1.5, by finite elements or a test; None: by Hertz
    pocket_stiffness: Annotated[float | None, DERIVED] = None
    sheet_stiffness: Annotated[
        Stiffness | None, "of the sheet in series with the pocket's contact; without it rigid"
    ] = None
    friction_coefficient: Annotated[Friction | None, "of ball on pocket; without it that of the races"] = None
    restitution: Annotated[Restitution, "share of the speed that remains after an impact; assumed"] = 0.8
    start: Annotated[
        CageStart | None,
        InFile(hint='give "rest", "ramp", "sudden" or "whirl"'),
        "how the motion begins; without it the cage rests on its balls",
    ] = None
    seeds: Annotated[Seeds, "motions from slightly different beginnings"] = 4
    duration: Annotated[
        Duration, "measured time of each, s: ten swings of a cage at rest, a hundred turns of a whirl"
    ] = 0.2
    steps_per_contact: Annotated[Steps, "number of time steps in the shortest impact to expect"] = 40
    gravity: Annotated[CageGravity, "against the axis: across is -y, along is -z"] = "across"
    drag: Annotated[CageDrag, "braking torque of the surrounding oil over the speed of the cage"] = 0.0
    land: Land | None = None
    # At rest to balls that lead and lag: they do not squeeze it, as nobody knows its pockets
    gives_way: Annotated[bool, DERIVED] = False
    origins: Mapping[str, Origin] = field(default_factory=nothing, compare=False)  # by key; empty: not noted


@dataclass(frozen=True, kw_only=True)
class Bearing(Noun):
    """A ball bearing: radial, or a thrust bearing of two equal washers at 90 degrees, of which `inner` turns."""

    HINT = 'give a table [bearing] with catalog = "paper_6205" or every dimension'
    name: Annotated[Text, FILLED, "shown with results; that of the catalogue without"]
    ball_count: Annotated[
        Count, InFile(hint="give a whole number, for example 9, or a bearing of the " + CATALOGUE), "number of balls, Z"
    ]
    ball_diameter: Annotated[
        Length, InFile(hint='give for example "7.94 mm", or a bearing of the ' + CATALOGUE), "of every ball, D"
    ]
    ball_mass: Annotated[Mass, FILLED, "of one ball"]
    ball_material: Annotated[Material, InFile("steel")]
    inner: Groove
    outer: Groove
    bore_diameter: Annotated[Length | None, "where the inner ring sits on its shaft"] = None
    outside_diameter: Annotated[Length | None, "where the outer ring sits in its housing"] = None
    width: Annotated[Length | None, "of both rings; with bore and outside diameter for the structure of the rings"] = (
        None
    )
    kind: Annotated[BearingKind, "radial, or thrust of two washers"] = "radial"
    static_load_rating: Annotated[Force | None, "static load rating C0 of a catalogue"] = None
    dynamic_load_rating: Annotated[Force | None, "dynamic load rating C of a catalogue"] = None
    series: Annotated[str | None, DERIVED] = None  # by its designation, "62" or "72 B"; None: not of the catalogue
    seals: Annotated[str | None, DERIVED] = None  # in words; None: open, or not known
    seals_rub: Annotated[bool, DERIVED] = False  # whether they touch the inner ring and brake it
    grade: Annotated[Grade | None, DERIVED] = None  # of what the catalogue derives; None: not of the catalogue
    origins: Mapping[str, Origin] = field(default_factory=nothing, compare=False)  # of the dimensions, by their keys
    # That the ratings fit nearly as well; None: the catalogue is sure
    other_candidate: Annotated["Bearing | None", DERIVED] = None

    def __post_init__(self) -> None:
        super().__post_init__()
        count = self.ball_count
        if not (isinstance(count, int | float | np.integer) and count % 1 == 0):
            raise InputError(f"Bearing.ball_count must be a whole number, got {shown(count)}; give for example 9")
        vars(self)["ball_count"] = int(count)

    @property
    def ball_radius(self) -> float:
        """r = D/2, m."""
        return self.ball_diameter / 2

    @property
    def pitch_diameter(self) -> float:
        """d_m: the mean of the two groove-bottom diameters, m: in a thrust bearing the circle of the ball centres."""
        return self.inner.bottom_radius + self.outer.bottom_radius

    @property
    def is_deep_groove(self) -> bool:
        """By its series, as 62 or 618; without one by an unloaded contact angle of at most 20 degrees."""
        if self.kind == "thrust" or self.series is not None:
            return self.series is not None and self.series.isdigit()
        lift = 2 * self.groove_centre_distance * (1 - np.cos(np.deg2rad(STEEPEST_DEEP_GROOVE)))
        return bool(max(self.diametral_clearance, 0.0) <= lift)

    @property
    def diametral_clearance(self) -> float:
        """P_d: radial clearance of the unloaded bearing, on the diameter, m; negative is preload.

        Raises InputError for a thrust bearing.
        """
        if self.kind == "thrust":
            raise InputError("a thrust bearing has no radial clearance: its contact angle is given, 90 degrees")
        return 2 * (self.outer.bottom_radius - self.inner.bottom_radius - self.ball_diameter)

    @property
    def groove_centre_distance(self) -> float:
        """A_0 = r_gi + r_go - D: distance of the groove centres when both races touch the ball, m."""
        return self.inner.groove_radius + self.outer.groove_radius - self.ball_diameter


@dataclass(frozen=True, kw_only=True)
class Clearances(Noun):
    """The diametral clearance of a bearing on its way into operation, m, and what its seats do; negative is preload."""

    unmounted: float
    mounted: float  # on its seats, at the temperature of mounting
    operating: float  # on its seats, at the temperatures of operation
    shaft_interference: float  # in operation, on the diameter, m; negative: the seat is loose
    housing_interference: float
    shaft_pressure: float  # in operation, Pa
    housing_pressure: float
    ball_load: float  # of every ball in operation before any other load, N; 0 with clearance left


@dataclass(frozen=True, kw_only=True)
class Arrangement(Noun):
    """Two equal bearings on one rigid shaft, set against each other or side by side; give preload or offset, or none.

    O: back to back, the lines of contact of the two bearings meet the shaft outside; X: face to face, inside; tandem:
    both carry thrust in the same direction, without preload.
    """

    HINT = 'give a table [arrangement] of kind = "O" and preload = "100 N", or leave it out'
    kind: Annotated[
        ArrangementKind, InFile(hint='give "O" (back to back, DB), "X" (face to face, DF) or "tandem" (DT)')
    ]
    preload: Annotated[Force | None, "axial force in the mounted pair at standstill"] = None
    offset: Annotated[Gap | None, "axial distance that clamping closes, of the pair"] = None
    distance: Annotated[Length | None, "between the middles of both bearings; without it the width"] = None

    def __post_init__(self) -> None:
        super().__post_init__()
        said = [key for key in ("preload", "offset") if getattr(self, key) is not None]
        if self.kind == "tandem" and said:
            why = "both bearings carry the same direction, and nothing presses back"
            raise InputError(f'arrangement.{said[0]} does not go with kind = "tandem": {why}; leave it out')
        if len(said) > 1:
            raise InputError("arrangement.offset and preload both give the clamping of the pair; leave one of them out")
        if self.kind != "tandem" and not said:
            raise InputError('arrangement needs one of preload and offset, for example preload = "100 N"')


@dataclass(frozen=True, kw_only=True)
class ContactAngle(Noun):
    """How the contact angle is determined.

    `given`: `value` is the loaded angle. `solved`: the angle follows from the load. The unloaded angle is then `free`;
    None: the angle that the clearance allows.
    """

    HINT = 'give { rule = "solved" }, { nominal = "15 deg" } or { rule = "given", value = "0.18 rad" }'
    rule: Annotated[Literal["solved", "given"], InFile("solved"), "solved: it follows from the load"]
    value: Annotated[Angle | None, "under load"] = None
    free: Annotated[Angle | None, "unloaded, whatever the clearance is"] = None


@dataclass(frozen=True, kw_only=True)
class Reach(Noun):
    """How far the oil reaches from the centre of a contact, along rolling, in radii of the ball."""

    HINT = "give { ahead = 0.9 }, of the ball's radius, or a length"
    ahead: Annotated[Reaching, "in the inlet; a bath fills the gap about up to the ball's outline"] = 0.9
    behind: Annotated[Reaching, "in the outlet, which counts where cavitation_pressure is below 0"] = 0.9


@dataclass(frozen=True, kw_only=True)
class OwnTraction(Noun):
    """A user's law of traction; `analytic.oil.own_law.own_traction` makes one from a function.

    Two laws are equal where their numbers are, and their names.
    """

    name: str
    sha256: str  # of the table that is computed with
    distribution: str = ""  # the package that has it; empty: it was given in Python
    version: str = ""  # of the package
    rows: InitVar[Array]  # (n, 7) the table, for `table`

    def __post_init__(self, rows: Array) -> None:
        super().__post_init__()
        vars(self)["_table"] = rows  # no field: results have the digest in its place

    @property
    def table(self) -> Array:
        """Numbers of the law, as `analytic.oil.law_table` has them: logarithms of rate and stress, dimensionless."""
        return vars(self)["_table"]

    @property
    def origin(self) -> str:
        """Name, package and digest in words."""
        package = f" of {self.distribution} {self.version}" if self.distribution else ""
        return f"{self.name}{package}, SHA-256 {self.sha256[:12]}"


@dataclass(frozen=True, kw_only=True)
class Lubricant(Noun):
    """The oil at the inlets of the contacts."""

    HINT = 'give a table [lubricant] with name = "ISO VG 46", or with viscosity and pressure_viscosity'
    name: Annotated[Text, "under which its numbers were looked up; empty: they are given"] = field(
        default="", compare=False
    )
    viscosity: Annotated[DynamicViscosity, "eta_0, at the reference temperature and ambient pressure"]
    pressure_viscosity: Annotated[PressureViscosity, FILLED, "alpha_p = d ln(eta)/dp there"]
    viscosity_temperature: Annotated[ThermalSlope, FILLED, "beta = -d ln(eta)/dT there"]
    reference_temperature: Annotated[Temperature, FILLED, "of a viscosity without a temperature of its own"]
    temperature: Annotated[Temperature, FILLED, "of the oil at the inlet of a contact"]
    thermal_conductivity: Annotated[Conductivity, FILLED, "of the oil, k_f"]
    density: Annotated[OilDensity, FILLED, "mass over volume"]
    limiting_shear: Annotated[LimitingShear, FILLED, "Lambda, ratio of the largest shear stress to the pressure"]
    traction: Annotated[Traction | OwnTraction, "law of the shear stress"]
    eyring_stress: Annotated[
        EyringStress | None, "tau_E, at any pressure; without it 2 Lambda/alpha at the pressure of each point"
    ] = None
    thickening: Annotated[Thickening, "law of the viscosity under pressure in the shear stress"] = "modulus"
    modulus_rise: tuple[float, float] = MINERAL_RISE  # b1, 1, and b2, 1/K, of the modulus equation
    # Standard deviation of the logarithm of the shear stress; 0.5: the kind of oil is not known
    traction_spread: float = field(default=0.5, compare=False)
    supply: Annotated[Supply, "how oil returns to the track"] = "oil_bath"
    surface_tension: Annotated[SurfaceTension, FILLED, "of the oil that bleeds from a grease"] = 0.022
    starvation_degree: Annotated[
        StarvationDegree | None, "meniscus to centre over the semi-axis along rolling; without it by the supply"
    ] = None
    reach: Reach = Reach()  # of the oil, to where a flooded inlet begins
    cavitation_pressure: Annotated[
        Cavitation, "gauge, at which oil in the outlet breaks; 0: the outlet is ventilated"
    ] = 0.0
    compressible: Annotated[OnOff, "whether pressure squeezes the oil in the film"] = True
    film_formula: Annotated[FilmFormula, "formula of the film"] = "numerical"
    rolling_formula: Annotated[RollingFormula, "formula of hydrodynamic rolling"] = "numerical"
    origins: Mapping[str, Origin] = field(default_factory=nothing, compare=False)  # by field; empty: not noted

    def starves_as_measured(self, bearing: Bearing) -> bool:
        """Whether it is grease in a deep groove bearing, whose films were measured, and no degree is given.

        Parameters
        ----------
        bearing : Bearing
            That it lubricates.

        Returns
        -------
        bool
            Whether `analytic.oil.grease` gives its films.
        """
        return self.supply == "grease" and self.starvation_degree is None and bearing.is_deep_groove

    def starves_by_replenishment(self, bearing: Bearing) -> bool:
        """Whether the replenishment factor of the supply starves the inlets, as nothing else is known of them.

        Parameters
        ----------
        bearing : Bearing
            That it lubricates.

        Returns
        -------
        bool
            Whether bore and outside diameter are known, which the factor needs, and no degree or measured film is.
        """
        known = bearing.bore_diameter is not None and bearing.outside_diameter is not None
        return known and self.starvation_degree is None and not self.starves_as_measured(bearing)


@dataclass(frozen=True, kw_only=True)
class Autocorrelation(Noun):
    """Autocorrelation rho(r) of the heights of a random surface at the distance r; rho(0) = 1."""

    HINT = 'give { kind = "gaussian", length = "60 um", spacing = "2 um" }'
    kind: Annotated[Literal["gaussian", "exponential"], "exp(-(r/length)^2), exp(-r/length)"]
    length: Annotated[Spacing, "where rho is 1/e"]
    spacing: Annotated[Spacing, "of the points of the surface"]


@dataclass(frozen=True, kw_only=True)
class HeightMapFile(Noun):
    """A measured surface."""

    HINT = 'give { path = "race.npy", spacing = "2 um" }'
    path: Annotated[
        Text, InFile(hint="give the path of a .x3p, .npy or .csv file (heights in m), from the scene file's folder")
    ]
    spacing: Annotated[Spacing | None, "of neighbouring points in both directions; without it the file's own"] = None


@dataclass(frozen=True, kw_only=True)
class Surface(Noun):
    """Roughness of ball and races: declared statistics of random heights, or the height map of a race.

    Give `height_map`, or `rms_roughness` and `autocorrelation`. The ball has the same, scaled to `ball_rms_roughness`.
    """

    HINT = "give a table [surface] with rms_roughness and autocorrelation, finish, Ra or height_map"
    rms_roughness: Annotated[Roughness | None, "Sq, of each surface"] = None
    autocorrelation: Autocorrelation | None = None
    height_map: HeightMapFile | None = None
    ball_rms_roughness: Annotated[Roughness | None, "Sq of the ball; without it as the race"] = None
    hardness: Annotated[Hardness | None, "H; without it that of the softer material"] = None
    boundary_friction: Annotated[Asperity, "mu_b, coefficient of asperities in contact"] = 0.12
    gap: Annotated[
        GapModel, "room for the oil: between surfaces that deform, or that are cut off where they overlap"
    ] = "elastic"
    asperities: Annotated[AsperityLaw, FILLED, "of truncated surfaces; greenwood_williamson: they never yield"] = (
        "zhao_maietta_chang"
    )
    origins: Mapping[str, Origin] = field(default_factory=nothing, compare=False)  # by field; empty: not noted


@dataclass(frozen=True, kw_only=True)
class ShearedLand(Noun):
    """The gap between a shoulder and the cage that it guides, full of oil."""

    HINT = 'give { ring = "inner", diameter = "31 mm", clearance = "0.3 mm", width = "4 mm" }'
    ring: Annotated[Literal["inner", "outer"], "to which the shoulder belongs"]
    diameter: Annotated[Length, "of the shoulder"]
    clearance: Annotated[Gap, "on the diameter"]
    width: Annotated[Length, "of all lands of the cage together"]


@dataclass(frozen=True, kw_only=True)
class ShearedPockets(Noun):
    """The gaps between the balls and their pockets, which are bores along the radius, full of oil."""

    HINT = 'give { clearance = "0.2 mm", thickness = "2 mm" }'
    clearance: Annotated[Gap, "on the diameter"]
    thickness: Annotated[Length, "of the cage there"]


@dataclass(frozen=True, kw_only=True)
class Losses(Noun):
    """Torques about the bearing axis that the scene declares, and what losses of the oil follow from.

    None: not declared. `analytic.oil.losses` has the formulas.
    """

    HINT = 'give a table [losses] of seals = "5 N mm", drag, oil_flow, oil_share, land, pockets'
    seals: Annotated[Loss | None, ">= 0"] = None
    drag: Annotated[Loss | None, "of the oil that balls and cage move, >= 0"] = None
    oil_flow: Annotated[Flow | None, "through the bearing, >= 0"] = None
    oil_share: Annotated[Share | None, "of the space between the rings that is oil, not air, 0 to 1"] = None
    land: ShearedLand | None = None
    pockets: ShearedPockets | None = None
    origins: Mapping[str, Origin] = field(default_factory=nothing, compare=False)  # of what is assumed, by its key

    @property
    def total(self) -> float | None:
        """Of seals and drag together, N m; None: nothing is declared."""
        known = [value for value in (self.seals, self.drag) if value is not None]
        return sum(known) if known else None

    @property
    def has_oil(self) -> bool:
        """Whether losses of the oil follow from what is declared."""
        return any(getattr(self, name) is not None for name in ("oil_flow", "oil_share", "land", "pockets"))


@dataclass(frozen=True, kw_only=True, eq=False)
class Operation(Noun):
    """The operating points of a series; every array has the same shape (n,)."""

    HINT = "give a table [operation] with inner_speed and a load, axial_load for example"
    axial_load: Annotated[Array, THRUSTS, InFile([0.0]), "along the shaft"]
    inner_speed: Annotated[Array, SPEEDS, InFile(hint='give for example "300 rpm"'), "w; the outer ring stands still"]
    radial_load: Annotated[Array | float, SIDES, InFile([0.0]), "along x, which points to the first ball"] = 0.0
    moment: Annotated[
        Array | float, MOMENTS, InFile([0.0]), "about y; it tilts the +x side of the inner ring against the axial load"
    ] = 0.0
    # Of the inner ring about y at every point, rad. Free: it follows from the moment. None: free under a moment, else 0
    tilt: Annotated[Tilt | None, "about y, at which the inner ring is held"] = None

    def _facts(self) -> Iterator[str]:
        yield points_of(self.points)

    @property
    def points(self) -> dict[str, Any]:
        """Loads, moment and speed by name."""
        return {name: values for name, values in vars(self).items() if name != "tilt"}

    def at(self, points: NDArray[np.intp]) -> "Operation":
        """Some of the operating points of a series.

        Parameters
        ----------
        points : ndarray, shape (k,)
            Numbers of the points, from 0.

        Returns
        -------
        Operation
            Of k points.
        """
        tilt = "free" if np.isnan(self.held_tilt) else self.tilt  # also where no moment is among these points
        return replace(self, tilt=tilt, **{name: values[points] for name, values in self.points.items()})

    @property
    def held_tilt(self) -> float:
        """Tilt about y at which the inner ring is held, rad; NaN: it tilts freely."""
        if isinstance(self.tilt, str):
            return np.nan
        return (np.nan if np.any(self.moment) else 0.0) if self.tilt is None else float(self.tilt)

    @property
    def is_thrust(self) -> bool:
        """Whether no point has a radial load, a moment or a tilt that is held."""
        return not (np.any(self.radial_load) or np.any(self.moment) or abs(self.held_tilt) > 0)

    def as_series(self) -> "Operation":
        """The same with every array (n,); itself, if it is that.

        Raises InputError for texts, no point, shapes that do not fit, and a moment beside a tilt.
        """
        if not isinstance(self.tilt, str | None) and np.any(self.moment):
            raise InputError(
                f"operation.tilt = {self.tilt:g} rad holds the ring, and operation.moment tilts it: leave one of them "
                "out"
            )
        if _is_series(list(self.points.values())):
            return self
        given = [np.atleast_1d(real_numbers(f"operation.{name}", values)) for name, values in self.points.items()]
        try:
            arrays = np.broadcast_arrays(*given)
        except ValueError as problem:
            raise InputError("the arrays of operation have shapes that do not fit: give equal lengths") from problem
        if arrays[0].size == 0:
            raise InputError("operation.axial_load is empty: give at least one operating point")
        return replace(self, **dict(zip(self.points, arrays, strict=True)))


def _is_series(values: list[Any]) -> bool:
    """Whether all are arrays (n,) of floating-point numbers, n > 0."""
    if not all(isinstance(each, np.ndarray) and each.dtype == float for each in values):
        return False
    shape = values[0].shape
    return len(shape) == 1 and shape[0] > 0 and all(each.shape == shape for each in values)


@dataclass(frozen=True, kw_only=True, eq=False)
class MeasuredTorque(Noun):
    """Friction torques that were measured at n operating points, each (n,); None: as in the scene."""

    file: str  # that has them, as messages name it
    torque: Array  # N m, > 0
    uncertainty: Array | None = None  # standard, of the torque, N m, >= 0; None: not known
    inner_speed: Array | None = None  # rad/s
    axial_load: Array | None = None  # N
    radial_load: Array | None = None  # N
    temperature: Array | None = None  # of the oil at the inlets, K
    oils: Mapping[float, Lubricant] = field(default_factory=nothing)  # by temperature, K, as the scene's file has them
    warnings: tuple[str, ...] = ()  # on how the file was read


@dataclass(frozen=True, kw_only=True)
class Thermal(Noun):
    """Heat flow from the bearing to its surroundings; in the steady state it equals the power of friction."""

    HINT = 'give { resistance = "0.5 K/W", ambient = "20 degC" }'
    resistance: Annotated[Resistance, "from the oil to the surroundings"]
    ambient: Annotated[Temperature, "of the surroundings"]


@dataclass(frozen=True, kw_only=True)
class ReportDetails(Noun):
    """What a report says beside its numbers: names and dates are texts; None: a blank to fill in by hand."""

    HINT = 'give a table [report] of author = "N. N.", date ...'
    author: Annotated[Text | None, "who made it"] = None
    checker: Annotated[Text | None, "who checked it"] = None
    revision: Annotated[Text | None, "of the report"] = None
    date: Annotated[Text | None, "of the revision, in quotes, in any form"] = None
    units: Annotated[UnitSystem, "that pages and tables show"] = "metric"


@dataclass(frozen=True, kw_only=True, eq=False)
class Scene(Noun):
    """A bearing, its operating points, and the accuracy of the result."""

    bearing: Annotated[Bearing, InFile(REQUIRED)]
    operation: Annotated[Operation, InFile(REQUIRED)]
    name: Annotated[Text, InFile(REQUIRED), "shown with results"] = "scene"
    tolerance: Annotated[Tolerance, InFile(REQUIRED), "of the torque, relative"] = 0.05
    contact_angle: Annotated[ContactAngle, InFile(at="bearing.")] = ContactAngle(rule="solved")
    # On the way to `bearing`, which is in operation; None: no seats are given
    clearances: Annotated[Clearances | None, DERIVED] = None
    arrangement: Arrangement | None = None  # of two such bearings, which share the loads; None: one bearing
    cage: Annotated[Cage | None, InFile(word="none")] = None  # None: no cage term and no pocket contact
    lubricant: Lubricant | None = None  # None: unknown
    surface: Surface | None = None  # None: unknown
    friction_coefficient: Annotated[
        Friction | None, InFile(at="friction.coefficient"), "mu of every race contact, in place of oil and surface"
    ] = None
    hysteresis_loss: Annotated[
        LossFactor | None, OF_FRICTION, "alpha', share of the elastic energy lost in each cycle"
    ] = None  # None: USUAL_LOSS
    # See `analytic.oil.rolling`
    elastic_rolling: Annotated[ElasticRolling, OF_FRICTION, "law of the loss by elastic rolling"] = "hysteresis"
    losses: Losses = Losses()
    spin_rule: Annotated[SpinRule, OF_FRICTION, "how a ball turns; free: by mechanics"] = "free"
    microslip: Annotated[Microslip, OF_FRICTION, "as_printed: of the paper with its misprints"] = "derived"
    effects: Mapping[str, Decision] = field(default_factory=nothing)  # by their names; those left out are `auto`
    uncertainty: Mapping[str, float] = field(default_factory=nothing)  # SI, see `analytic.scenefile.inputs`
    assumed: Mapping[str, str] = field(default_factory=nothing)  # sources, by key
    calibration: Annotated[Text | None, InFile(hint="give the inputs that were fitted, and to which numbers")] = None
    # Unit vector of gravity along x, y, z; None: assumed along x
    down: Annotated[tuple[float, float, float] | None, DERIVED] = None
    warnings: tuple[str, ...] = ()  # from reading the scene
    # Values of a bearing of the catalogue that nobody gave, by key, as a file has them
    usual: Mapping[str, str] = field(default_factory=nothing, compare=False)
    measured: Annotated[MeasuredTorque | None, DERIVED] = None  # what to compare the torque with; None: nothing
    report: ReportDetails = field(default_factory=ReportDetails)

    def __post_init__(self) -> None:
        super().__post_init__()
        require_positive(**{"Scene.tolerance": self.tolerance})
        if self.down is not None and not _is_unit_vector(self.down):
            raise InputError(
                f"Scene.down must be a unit vector of three numbers along x, y, z, got {shown(self.down)}; give for "
                "example (1.0, 0.0, 0.0), towards the radial load, or None for that"
            )

    def _facts(self) -> Iterator[str]:
        yield from (self.name, self.bearing.name, points_of(self.operation.points), f"tolerance {self.tolerance:g}")

    @property
    def loss_factor(self) -> float:
        """alpha' that counts: the given one, else the usual one, dimensionless."""
        return USUAL_LOSS if self.hysteresis_loss is None else self.hysteresis_loss

    @property
    def has_friction(self) -> bool:
        """Whether the friction of ball on race is given or can be computed."""
        return self.friction_coefficient is not None or (self.lubricant is not None and self.surface is not None)


def _is_unit_vector(given: object) -> bool:
    numbers = given if isinstance(given, tuple | list) else ()
    if len(numbers) != 3 or not all(isinstance(each, int | float) for each in numbers):
        return False
    return abs(math.hypot(*numbers) - 1) < UNIT_LENGTH


@dataclass(frozen=True, kw_only=True)
class Wall:
    """The sheet behind a cage pocket."""

    thickness: float  # m
    depth: float  # k: from the pole of a half pocket to the plane where the halves join, m


@dataclass(frozen=True, kw_only=True)
class Ring:
    """The ring that carries a groove, whose middle is that of the ring."""

    bottom_radius: float  # bearing axis to the bottom of the groove, m
    seat_radius: float  # bearing axis to the seat on the shaft or in the housing, m
    width: float  # m
    shoulder_half_widths: tuple[float, float]  # middle of the groove to the shoulder at y > 0 and at y < 0, axially, m


@dataclass(frozen=True, kw_only=True)
class Contact:
    """A ball pressed into a groove: all that an elastic solution needs.

    `rolling_radius` is the radius of the groove along rolling at the centre of the contact: positive on the inner ring
    (convex), negative on the outer ring (concave). `shoulder` and `far_shoulder` are the distances from the centre of
    the contact to the shoulders at y > 0, which it has moved towards, and at y < 0, in the tangent plane there.
    """

    pair: Pair  # what the ball touches
    ball_radius: float  # m
    groove_radius: float  # r_g, m
    rolling_radius: float  # m, signed; infinite on a thrust washer
    shoulder: float  # at y > 0, m
    far_shoulder: float  # at y < 0, m
    contact_angle: float  # rad, >= 0
    load: float  # N
    ball_material: Material
    race_material: Material
    wall: Wall | None = None  # of a pocket
    ring: Ring | None = None  # of a race whose seat and width are known

    @property
    def tilt(self) -> float:
        """Of the race's lands against the tangent plane, rad: those of a thrust washer are parallel to it."""
        return 0.0 if np.isinf(self.rolling_radius) else self.contact_angle

    @property
    def nearer_shoulder(self) -> float:
        """Distance to the nearer one of both shoulders, m."""
        return min(self.shoulder, self.far_shoulder)
