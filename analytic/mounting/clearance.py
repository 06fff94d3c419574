"""Radial internal clearance from the bearing as delivered to the bearing in operation.

A tight seat widens the inner ring and narrows the outer one; temperatures change every part, and by that the seats
too. Each ring is a thick ring that is as thick as its wall below the groove. Its shoulders stiffen a true ring, and a
shaft or a housing that is wider than the ring presses harder; these two nearly cancel. Finite elements of true sections
say that the model moves the inner groove 0.4 to 3.5 % too far and the outer one 5 to 7 % too little
(validation/benchmarks/mounting.py).
A housing without outside diameter has no end. Each part has one temperature: the shaft that of the inner ring, the
housing that of the outer ring. The rings' widening by centrifugal force is left out, and so is the change of a groove's
profile by the seat. Balls do not bend the rings.
Source: the steps are those of [Harris2007] section 3; the formulas are Lame's.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Annotated, NamedTuple

import numpy as np

from analytic.contact.geometry import RACES, race_curvatures
from analytic.contact.hertz import contact_modulus, hertz_contact
from analytic.declared import FILLED, InFile, Noun
from analytic.errors import InputError, require_finite
from analytic.mounting.thick_ring import ThickRing, fit_pressure
from analytic.scene import Bearing, Clearances, Groove, Interference, Length, Material, Temperature, Width

REFERENCE_TEMPERATURE = 293.15  # K: 20 degC, at which lengths are measured
LARGEST_STRAIN = 0.005  # interference over diameter: rings of hardened steel burst or yield before


@dataclass(frozen=True, kw_only=True)
class Mounting(Noun):
    """Seats of a bearing and the temperatures of its parts.

    Interferences are effective: what is left of the measured ones after the asperities of the seats are pressed flat.
    They and the clearance of the bearing belong to `mounting_temperature`.
    """

    HINT = "give a table [mounting] of seats and temperatures"
    shaft_material: Annotated[Material, InFile("steel")]
    housing_material: Annotated[Material, InFile("steel")]
    shaft_interference: Annotated[Interference, "on the diameter; negative: loose"] = 0.0
    housing_interference: Annotated[Interference, "likewise"] = 0.0
    shaft_bore: Annotated[Width, "diameter; 0: a solid shaft"] = 0.0
    housing_outside_diameter: Annotated[Length | None, "without one the housing has no end"] = None
    inner_temperature: Annotated[Temperature, FILLED, "of inner ring and shaft"] = REFERENCE_TEMPERATURE
    outer_temperature: Annotated[Temperature, FILLED, "of outer ring and housing"] = REFERENCE_TEMPERATURE
    ball_temperature: Annotated[Temperature | None, "without it the mean of both rings"] = None
    mounting_temperature: Temperature = REFERENCE_TEMPERATURE

    @property
    def temperatures(self) -> "Temperatures":
        """In operation."""
        ball = self.ball_temperature
        if ball is None:
            ball = (self.inner_temperature + self.outer_temperature) / 2
        return Temperatures(inner=self.inner_temperature, outer=self.outer_temperature, ball=ball)


class Temperatures(NamedTuple):
    """K."""

    inner: float  # of inner ring and shaft
    outer: float  # of outer ring and housing
    ball: float


class Seat(NamedTuple):
    """A ring on its seat, at one temperature."""

    interference: float  # on the diameter, m
    pressure: float  # Pa
    moved: float  # the groove's bottom, outward, m
    growth: float  # of the ring's dimensions, relative


def mounted(bearing: Bearing, mounting: Mounting) -> tuple[Bearing, Clearances]:
    """The bearing in operation, on its seats and at its temperatures, and its clearances.

    bearing : as delivered, every dimension at the mounting temperature
    Every dimension of rings and balls is then that in operation; bore, outside diameter and width stay nominal. Rings
    are thick rings by Lamé, which end at the bottom of their groove.
    Raises InputError for what `mounting_faults` finds.
    Sources: [Timoshenko1970], [Harris2007] section 3.
    """
    for key, problem in mounting_faults(bearing, mounting):
        raise InputError(f"{key} {problem}")
    cold = mounting.mounting_temperature
    on_seats, *_ = _bearing_at(bearing, mounting, Temperatures(inner=cold, outer=cold, ball=cold))
    warm, shaft, housing = _bearing_at(bearing, mounting, mounting.temperatures)
    return warm, Clearances(
        unmounted=bearing.diametral_clearance,
        mounted=on_seats.diametral_clearance,
        operating=warm.diametral_clearance,
        shaft_interference=shaft.interference,
        housing_interference=housing.interference,
        shaft_pressure=shaft.pressure,
        housing_pressure=housing.pressure,
        ball_load=preload_of_balls(warm),
    )


def preload_of_balls(bearing: Bearing) -> float:
    """Load of every ball between rings that press on it, before any other load, N; 0 with clearance left.

    Both contacts lie at the bottom of their grooves; their approaches add up to half of the interference.
    """
    if bearing.diametral_clearance >= 0:
        return 0.0
    approach = 0.0  # of both contacts under 1 N
    for race, groove in zip(RACES, (bearing.inner, bearing.outer), strict=True):
        rolling, transverse = race_curvatures(bearing, race, contact_angle=0.0)
        modulus = contact_modulus(bearing.ball_material, groove.material)
        approach += float(
            hertz_contact(curvature_x=rolling, curvature_y=transverse, load=1.0, modulus=modulus).approach
        )
    return float((-bearing.diametral_clearance / 2 / approach) ** 1.5)


def mounting_faults(bearing: Bearing, mounting: Mounting) -> Iterator[tuple[str, str]]:
    """(key of the scene, problem) for what is missing or cannot be."""
    require_finite(**{key: value for key, value in vars(mounting).items() if isinstance(value, float)})
    bore, outside, end = bearing.bore_diameter, bearing.outside_diameter, mounting.housing_outside_diameter
    if bore is None:
        yield "bearing.bore_diameter", 'is missing: [mounting] needs the inner ring\'s wall; give for example "25 mm"'
    elif not 0 <= mounting.shaft_bore < bore:
        yield "mounting.shaft_bore", f"must be below bearing.bore_diameter {_mm(bore)}"
    if outside is None:
        yield (
            "bearing.outside_diameter",
            'is missing: [mounting] needs the outer ring\'s wall; give for example "52 mm"',
        )
    elif end is not None and not end > outside:
        yield "mounting.housing_outside_diameter", f"must exceed bearing.outside_diameter {_mm(outside)}"
    for key, diameter in (("shaft_interference", bore), ("housing_interference", outside)):
        if diameter is not None and getattr(mounting, key) > LARGEST_STRAIN * diameter:
            limit = f"{LARGEST_STRAIN * diameter * 1e6:.0f} um"
            yield f"mounting.{key}", f"must be at most {limit}, {LARGEST_STRAIN:.1%} of the seat: rings yield before"
    for key, part, material, temperature in _parts(bearing, mounting):
        if material.thermal_expansion is None and temperature != mounting.mounting_temperature:
            yield (
                key,
                f"{material.name!r} of the {part} has no thermal_expansion, which a change of temperature needs; give "
                'it in the table of the material, for example "12e-6 1/K"',
            )


def _parts(bearing: Bearing, mounting: Mounting) -> Iterator[tuple[str, str, Material, float]]:
    """(key, part in words, material, temperature in operation) of each."""
    warm = mounting.temperatures
    yield "bearing.inner.material", "inner ring", bearing.inner.material, warm.inner
    yield "bearing.outer.material", "outer ring", bearing.outer.material, warm.outer
    yield "bearing.ball_material", "balls", bearing.ball_material, warm.ball
    yield "mounting.shaft_material", "shaft", mounting.shaft_material, warm.inner
    yield "mounting.housing_material", "housing", mounting.housing_material, warm.outer


def _bearing_at(bearing: Bearing, mounting: Mounting, warm: Temperatures) -> tuple[Bearing, Seat, Seat]:
    """The bearing on its seats at these temperatures, and both seats."""
    cold = mounting.mounting_temperature
    assert bearing.bore_diameter is not None, "mounting_faults says so before"
    assert bearing.outside_diameter is not None, "mounting_faults says so before"
    shaft = _seat(
        ring=_wall(bearing.bore_diameter / 2, bearing.inner),
        other=ThickRing(
            inner_radius=mounting.shaft_bore / 2,
            outer_radius=bearing.bore_diameter / 2,
            material=mounting.shaft_material,
        ),
        interference=mounting.shaft_interference,
        warmer=warm.inner - cold,
    )
    end = mounting.housing_outside_diameter
    housing = _seat(
        ring=_wall(bearing.outside_diameter / 2, bearing.outer),
        other=ThickRing(
            inner_radius=bearing.outside_diameter / 2,
            outer_radius=np.inf if end is None else end / 2,
            material=mounting.housing_material,
        ),
        interference=mounting.housing_interference,
        warmer=warm.outer - cold,
    )
    placed = replace(
        bearing,
        ball_diameter=bearing.ball_diameter * (1 + _expansion(bearing.ball_material, warm.ball - cold)),
        inner=_placed(bearing.inner, shaft),
        outer=_placed(bearing.outer, housing),
    )
    return placed, shaft, housing


def _seat(*, ring: ThickRing, other: ThickRing, interference: float, warmer: float) -> Seat:
    """ring : of the bearing;  other : shaft or housing;  warmer : both than at mounting, K"""
    growth, beyond = _expansion(ring.material, warmer), _expansion(other.material, warmer)
    if other.outer_radius == ring.inner_radius:
        bottom, now = ring.outer_radius, interference + 2 * ring.inner_radius * (beyond - growth)
        pressure = fit_pressure(other, ring, interference=now)
        moved = ring.displacement(bottom, inside=pressure)
    else:
        bottom, now = ring.inner_radius, interference + 2 * ring.outer_radius * (growth - beyond)
        pressure = fit_pressure(ring, other, interference=now)
        moved = ring.displacement(bottom, outside=pressure)
    return Seat(interference=now, pressure=pressure, moved=growth * bottom + moved, growth=growth)


def _wall(seat: float, groove: Groove) -> ThickRing:
    """The ring between its seat and the bottom of its groove; seat : radius, m."""
    inner, outer = sorted((seat, groove.bottom_radius))
    return ThickRing(inner_radius=inner, outer_radius=outer, material=groove.material)


def _placed(groove: Groove, seat: Seat) -> Groove:
    far = groove.far_shoulder_half_width
    near = groove.shoulder_half_width
    return replace(
        groove,
        bottom_radius=groove.bottom_radius + seat.moved,
        groove_radius=groove.groove_radius * (1 + seat.growth),
        shoulder_half_width=None if near is None else near * (1 + seat.growth),
        far_shoulder_half_width=None if far is None else far * (1 + seat.growth),
    )


def _expansion(material: Material, warmer: float) -> float:
    """Thermal strain; `mounting_faults` refuses a material whose expansion is needed and unknown."""
    return 0.0 if warmer == 0 else (material.thermal_expansion or 0.0) * warmer


def _mm(length: float) -> str:
    return f"{length * 1e3:.6g} mm"
