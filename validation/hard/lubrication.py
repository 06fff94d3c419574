"""Hard cases of lubrication: film, load share of asperities, sliding oil, and the torque in oil."""

import math
from dataclasses import replace
from typing import Any

from analytic.contact.rolling_contact import ContactNumbers, elliptic_contact
from analytic.oil.film import Inflow, asymptotes_of, central_film
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.oil.traction import mean_force, mixed_traction, oil_shear_stress
from analytic.oil.viscosity import oil_numbers, roelands_viscosity
from analytic.result import FrictionTorque
from analytic.scene import Lubricant, Reach, Surface
from analytic.surface.gap import NOT_ELASTIC, SMOOTH_GAP, TRUNCATED, GapNumbers
from analytic.surface.truncated_gap import truncated_law
from validation.hard.case import HardCase
from validation.hard.roughness import CORRELATION, HARDNESS, summits
from validation.hard.specimens import LARGE, LOAD, MODULUS, SMALL, bearing, exponent, torque_6205

RACES = ("inner", "outer")
SPEED = 0.37  # m/s, of entrainment
BOUNDARY_FRICTION = 0.12  # coefficient where asperities touch
OIL = Lubricant(
    viscosity=0.061,
    pressure_viscosity=2.1e-8,
    viscosity_temperature=0.041,
    reference_temperature=313.0,
    temperature=313.0,
    thermal_conductivity=0.14,
    density=870.0,
    eyring_stress=5.3e6,
    limiting_shear=0.07,
    traction="eyring_sinh",
    thickening="roelands",
)

# Tolerances, relative, with their reasons
LOGARITHMS = (1e-12, "logarithms of size 30 to 200, whose rounding is that of the result")
ASYMPTOTE = (1e-12, "logarithms of size 100; the other asymptotes add less than 1e-16")
SLOW = (1e-11, "the film over that of a molecule")
SPLINE = (1e-7, "the asperities' splines are good to 1e-8, and the film grows with its power 0.6 or more")


def film(**changed: Any) -> float:
    """Central film, m; NaN unless exactly the ellipses outside the fitted shapes are marked."""
    of_contact = {name: changed.pop(name) for name in ("load", "curvature_transverse") if name in changed}
    here = contact(**of_contact)
    oil: dict[str, Any] = {"viscosity": OIL.viscosity, "pressure_viscosity": OIL.pressure_viscosity}
    oil |= {"entrainment_speed": SPEED} | changed
    central = central_film(here, **oil)
    fitted = 0.03 <= here.curvature_transverse / here.curvature_rolling <= 1
    return float(central.thickness) if bool(central.outside_range) != fitted else math.nan


def contact(load: float = LOAD, curvature_transverse: float = SMALL) -> ContactNumbers:
    """A ball on a race."""
    return elliptic_contact(
        curvature_rolling=LARGE, curvature_transverse=curvature_transverse, load=load, modulus=MODULUS
    )


def shared(rms_roughness: float, *, load: float = LOAD, speed: float = SPEED, film_factor: float = 1.0) -> MixedContact:
    """Oil and asperities of two surfaces, each of this roughness, m; 0: smooth."""
    here = contact(load)
    film = asymptotes_of(here, Inflow(abs(speed), OIL.viscosity, OIL.pressure_viscosity))
    return mixed_contact(here, film, truncated(rms_roughness) if rms_roughness else SMOOTH_GAP, film_factor)


def truncated(rms_roughness: float) -> GapNumbers:
    """The gap between these surfaces; what overlaps is cut off."""
    deviation = math.sqrt(2) * rms_roughness
    cubics, law = truncated_law(summits=summits(rms_roughness), modulus=MODULUS, hardness=HARDNESS, deviation=deviation)
    return GapNumbers(TRUNCATED, cubics, law, NOT_ELASTIC)


def share(rms_roughness: float, **changed: float) -> float:
    """s, the asperities' share of the load."""
    return float(shared(rms_roughness, **changed).asperity_share)


def friction(oil: Lubricant, mixed: MixedContact, *, load: float, slip: float) -> float:
    """Friction, N, of a contact that slides with slip, m/s."""
    law = mixed_traction(oil_numbers(oil), BOUNDARY_FRICTION, mixed, 1.0)
    return float(mean_force(law, contact(load), slip))


def light_friction(load: float) -> float:
    """Friction, N, of oil at constant shear stress; NaN unless the film is marked as capped by the gap."""
    mixed = shared(0.3e-6, load=load)
    force = friction(replace(OIL, traction="eyring_constant"), mixed, load=load, slip=0.02)
    return force if bool(mixed.capped) else math.nan


def thickened(
    pressure: float, *, pressure_viscosity: float = OIL.pressure_viscosity, temperature: float = 313.0
) -> float:
    """Viscosity, Pa s, at a pressure, Pa, and a temperature, K."""
    viscosity = roelands_viscosity(
        pressure=pressure,
        temperature=temperature,
        viscosity=OIL.viscosity,
        pressure_viscosity=pressure_viscosity,
        reference_temperature=OIL.reference_temperature,
        viscosity_temperature=OIL.viscosity_temperature,
    )
    return float(viscosity)


def shear(speed: float, *, oil: Lubricant = OIL, pressure: float = 0.9e9, film_thickness: float = 0.23e-6) -> float:
    """Shear stress, Pa, of oil that slides with speed, m/s."""
    return float(oil_shear_stress(oil_numbers(oil), pressure=pressure, speed=speed, film_thickness=film_thickness))


def oiled(
    *,
    speed: float = 31.0,
    rms_roughness: float = 0.3e-6,
    conformity: float | None = None,
    ahead: float = 0.9,
    degree: float | None = None,
) -> FrictionTorque:
    """The 6205 under 700 N of thrust in oil, its inner ring at speed, rad/s.

    ahead : reach of the oil, in radii of the ball;  degree : of starvation
    """
    if conformity is None:
        close = bearing()
    else:
        radius = conformity * bearing().ball_diameter
        close = replace(bearing(), **{race: replace(getattr(bearing(), race), groove_radius=radius) for race in RACES})
    oil = replace(OIL, reach=Reach(ahead=ahead), starvation_degree=degree)
    surface = Surface(
        rms_roughness=rms_roughness,
        autocorrelation=CORRELATION,
        hardness=HARDNESS,
        boundary_friction=BOUNDARY_FRICTION,
        gap="truncated",
    )
    return torque_6205(
        axial_load=700.0, speed=speed, bearing=close, friction_coefficient=None, lubricant=oil, surface=surface
    )


def warned(torque: FrictionTorque, words: str) -> int:
    """Number of warnings that contain these words."""
    return sum(words in warning for warning in torque.warnings)


def coefficient(**changed: float) -> float:
    """Friction coefficient of the inner race; arguments of `oiled`."""
    coefficient = oiled(**changed).friction_coefficient.inner
    assert coefficient is not None
    return float(coefficient[0])


def share_of_smooth_races() -> float:
    """The larger asperity share of both races."""
    shares = oiled(rms_roughness=0.0).asperity_share
    return max(float(values[0]) for values in vars(shares).values())


LUBRICATION_CASES: tuple[HardCase, ...] = (  # name, problem, answer, evaluation, expected number
    HardCase("film: standstill", "the film without speed over that at 0.37 m/s",
        "0: no motion draws in oil, although the formula would take ln 0", lambda: film(entrainment_speed=0.0) / film(),
        0.0),
    HardCase("film: reversed", "the film at -0.37 m/s over that at 0.37 m/s",
        "1, by symmetry, although a negative speed has no real powers", lambda: film(entrainment_speed=-SPEED) / film(),
        1.0),
    HardCase("film: wider along rolling", "R_x/R_y of 1.9, where the formula was fitted for 0.03 to 1",
        "the formula by 40 digits, marked as outside its range; wrong without the mark",
        lambda: film(curvature_transverse=1.9 * LARGE), 8.961701851164410376e-8, tolerance=LOGARITHMS),
    HardCase("film: no load", "a contact without load, whose asymptotes are infinite",
        "the gap between the bodies, 1/(1/R_x + 1/R_y)", lambda: film(load=0.0), 0.0031279324366593681576),
    HardCase("film: 1e-12 N", "a load at which the rigid asymptote, F^-2, gives 1e23 m",
        "the gap between the bodies, 1/(1/R_x + 1/R_y)", lambda: film(load=1e-12), 0.0031279324366593681576),
    HardCase("film: 1e-12 N, limited gap", "the same with a largest gap of 0.11 mm", "0.11 mm",
        lambda: film(load=1e-12, largest_gap=0.11e-3), 0.11e-3),
    HardCase("film: 1e-12 N, 1e-12 m/s", "1e-12 N at 1e-12 m/s: powers of the load of 1e-19 and of the speed of 1e-22",
        "the formula by 40 digits: nothing underflows or overflows", lambda: film(load=1e-12, entrainment_speed=1e-12),
        2.1669042756524236938e-6, tolerance=LOGARITHMS),
    HardCase("film: no piezoviscosity",
        "an oil whose viscosity does not depend on pressure: two asymptotes are 0, and H_EI/H_EP is x/0",
        "the isoviscous half of the formula, by 40 digits", lambda: film(pressure_viscosity=0.0),
        2.8100995675040086227e-8, tolerance=LOGARITHMS),
    HardCase("film: rigid bodies", "such an oil at 1e-28 N and 1e-30 m/s, without deformation",
        "the rigid-isoviscous formula alone, by 40 digits",
        lambda: film(pressure_viscosity=0.0, load=1e-28, entrainment_speed=1e-30), 2.1669042755773166055e-10,
        tolerance=ASYMPTOTE),
    HardCase("mixed: standstill",
        "the friction of rough bodies without speed, over that of asperities under the whole load",
        "1: there is no film, and the oil between the asperities carries no pressure",
        lambda: friction(OIL, shared(0.3e-6, speed=0.0), load=LOAD, slip=0.02) / (BOUNDARY_FRICTION * LOAD), 1.0),
    HardCase("mixed: reversed", "the asperities' share at -0.37 m/s over that at 0.37 m/s", "1, by symmetry",
        lambda: share(0.3e-6, speed=-SPEED) / share(0.3e-6), 1.0),
    HardCase("mixed: smooth", "the asperities' share of the load for Sq = 0",
        "0 exactly, although the balance contains ln 0", lambda: share(0.0), 0.0),
    HardCase("mixed: nearly smooth",
        "the film at Sq = 1e-12 m, where the share is too small for a double, over that of smooth bodies",
        "1: the limit is the smooth contact", lambda: float(shared(1e-12).film_thickness) / film(), 1.0),
    HardCase("mixed: very rough", "the oil's share at Sq = 40 um, 400 times the film",
        "the root of film(s) = gap(s), by 40 digits: the asperities' share s is near 1 but not 1",
        lambda: 1 - share(40e-6), 0.0001399154246617205731102, tolerance=SPLINE),
    HardCase("mixed: 1e-9 m/s", "what boundary friction leaves of the load at 1e-9 m/s, where the film is 0.0006 nm",
        "(1 - s)(1 - exp(-h/1 nm)) at the root of film(s) = gap(s), by 40 digits: 1e-4, and 0 at standstill",
        lambda: 1 - float(shared(0.3e-6, speed=1e-9).boundary_share), 0.0001058039710646594447058, tolerance=SPLINE),
    HardCase("mixed: rougher than the gap", "Sq of 10 mm: asperities hold the bodies farther apart than oil can reach",
        "1: the asperities carry the whole load", lambda: share(1e-2), 1.0),
    HardCase("mixed: no film after inlet heating", "the share where heating of the inlet leaves no film",
        "1: as at standstill", lambda: share(0.3e-6, film_factor=0.0), 1.0),
    HardCase("mixed: friction at vanishing load",
        "the exponent of the friction over the load for oil at constant shear stress, from 1e-12 to 1e-9 N",
        "2/3, as the area: the coefficient has no limit, the force has. Wrong unless marked as capped",
        lambda: exponent(light_friction, 1e-12, 1e-9), 2 / 3),
    HardCase("oil: 3.1 GPa",
        "the viscosity far above the pressures in races; Barus's law gives e^65 times that of the inlet",
        "Roelands' viscosity, by 40 digits", lambda: thickened(3.1e9), 971556858133.9482587),
    HardCase("oil: no piezoviscosity",
        "the viscosity at 3.1 GPa over that of the inlet, for an oil that does not depend on pressure", "1",
        lambda: thickened(3.1e9, pressure_viscosity=0.0) / OIL.viscosity, 1.0),
    HardCase("oil: a temperature in degrees Celsius", "40 K, below the pole of Roelands' formula at 138 K",
        "a refusal that names the unit: a negative number has no real fractional power",
        lambda: thickened(0.9e9, temperature=40.0), refusal="temperature must be above 138 K"),
    HardCase("oil: no sliding", "the stress without sliding, over Eyring's",
        "0, although the direction of sliding is 0/0", lambda: shear(0.0) / 5.3e6, 0.0),
    HardCase("oil: sliding at 1e-15 m/s", "stress over speed at 1e-15 m/s, 0.9 GPa and a film of 0.23 um",
        "Newton's eta(p)/h, by 40 digits: asinh keeps the digits of a small argument", lambda: shear(1e-15) / 1e-15,
        64315516436.507601783,
        tolerance=(1e-10, "asinh falls short by a sixth of its argument squared, 1.5e-4 squared at 1e-8")),
    HardCase("oil: 30 GPa", "the stress at 0.02 m/s where Roelands' viscosity is 1e58 times that of the inlet",
        "tau_E asinh(eta v/(h tau_E)), by 40 digits, below its limit", lambda: shear(0.02, pressure=30e9),
        675304811.70847845256),
    HardCase("oil: pressed solid", "the stress at 7 GPa in an oil whose viscosity is too large for a double",
        "zeta p: oil that does not flow shears at its limit",
        lambda: shear(0.02, oil=replace(OIL, viscosity=1e4, pressure_viscosity=1e-7), pressure=7e9), 0.49e9),
    HardCase("oil: neither film nor sliding", "the stress where speed over film thickness is 0/0",
        "zeta p: without a film the limit holds at any speed, also at 0", lambda: shear(0.0, film_thickness=0.0),
        0.063e9),
    HardCase("oiled torque: standstill",
        "the friction coefficient of the inner race at 0 rpm over that of the boundary", "1: there is no film",
        lambda: coefficient(speed=0.0) / BOUNDARY_FRICTION, 1.0),
    HardCase("oiled torque: slow running", "the torque at 1e-20 rad/s over that at standstill",
        "1: the film of 4e-12 nm carries load, but shears like a boundary film",
        lambda: float(oiled(speed=1e-20).torque.total[0] / oiled(speed=0.0).torque.total[0]), 1.0, tolerance=SLOW),
    HardCase("oiled torque: reversed rotation", "the torque in oil at -296 rpm over that at 296 rpm", "1, by symmetry",
        lambda: float(oiled(speed=-31.0).torque.total[0] / oiled(speed=31.0).torque.total[0]), 1.0),
    HardCase("oiled torque: smooth races", "the larger asperity share of both races for Sq = 0", "0 exactly",
        lambda: share_of_smooth_races(), 0.0),
    HardCase("oiled torque: inlet shorter than the contact",
        "the friction coefficient of the inner race over that of the boundary, with oil that ends within the ellipse",
        "1: nothing is left of the film, as at a starvation degree of 1",
        lambda: coefficient(ahead=0.01, degree=5.0) / BOUNDARY_FRICTION, 1.0),
    HardCase("oiled torque: inlet that ends at the contact",
        "the same with oil up to the edge of the ellipse, at a starvation degree of 1", "1",
        lambda: coefficient(degree=1.0) / BOUNDARY_FRICTION, 1.0),
    HardCase("oiled torque: ellipse outside the film's fit",
        "the number of warnings on the film's formula at conformity 0.505, R_x/R_y of 0.01", "2: one for each race",
        lambda: float(warned(oiled(conformity=0.505), "contact ellipse outside the fitted shapes")), 2.0),
)  # fmt: skip
