"""Hard cases of lubrication: the film, what asperities leave of the load, oil that slides, and the torque of it all."""

import math
from dataclasses import replace

import numpy as np

from analytic.contact.rolling_contact import EllipticContact, elliptic_contact
from analytic.oil.film import central_film
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.oil.traction import MixedTraction, oil_shear_stress
from analytic.oil.viscosity import roelands_viscosity
from analytic.result import FrictionTorque
from analytic.scene import Lubricant, Surface
from analytic.scenefile.read import builtin_scene, load_scene
from analytic.torque import friction_torque
from fembearing.compare.hard.case import HardCase
from fembearing.compare.hard.contacts import LARGE, LOAD, MODULUS, ROUND_OFF, SMALL, exponent
from fembearing.compare.hard.friction import AS_HERTZ
from fembearing.compare.hard.roughness import CORRELATION, HARDNESS, rough

RACES = ("inner", "outer")
SPEED = 0.37  # m/s, of entrainment
BOUNDARY_FRICTION = 0.12  # where asperities touch
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
)

# Tolerances, relative, with their reasons
LOGARITHMS = (1e-12, "formulas in logarithms of size 30 to 200, whose rounding is that of the result")
ASYMPTOTE = (1e-12, "logarithms of size 100; the other asymptotes add less than 1e-16")
SPLINE = (1e-7, "the asperities' splines are good to 1e-8, and the film grows with its power 0.6 or more")


def film(**changed: float) -> float:
    """Central film, m; NaN for an ellipse of no fitted shape that is not marked as one, or one marked in vain."""
    of_contact = {name: changed.pop(name) for name in ("load", "curvature_transverse") if name in changed}
    here = contact(**of_contact)
    oil = {"viscosity": OIL.viscosity, "pressure_viscosity": OIL.pressure_viscosity}
    found = central_film(here, **({"entrainment_speed": SPEED} | oil | changed))
    fitted = 0.03 <= here.curvature_transverse / here.curvature_rolling <= 1
    return float(found.thickness) if bool(found.outside_range) != fitted else math.nan


def contact(load: float = LOAD, curvature_transverse: float = SMALL) -> EllipticContact:
    """A ball on a race."""
    return elliptic_contact(
        curvature_rolling=LARGE, curvature_transverse=curvature_transverse, load=load, modulus=MODULUS
    )


def shared(
    rms_roughness: float, *, load: float = LOAD, speed: float = SPEED, heating_factor: float = 1.0
) -> MixedContact:
    """Oil and asperities of two surfaces of so much roughness each, m; 0: smooth."""
    return mixed_contact(
        contact(load),
        entrainment_speed=speed,
        viscosity=OIL.viscosity,
        pressure_viscosity=OIL.pressure_viscosity,
        asperities=rough(rms_roughness) if rms_roughness else None,
        heating_factor=heating_factor,
    )


def share(rms_roughness: float, **changed: float) -> float:
    """s, of the load that asperities carry."""
    return float(shared(rms_roughness, **changed).asperity_share)


def friction(oil: Lubricant, found: MixedContact, *, load: float, slip: float) -> float:
    """N, of a contact that slides with slip, m/s."""
    traction = MixedTraction(
        lubricant=oil,
        boundary_friction=BOUNDARY_FRICTION,
        asperity_share=found.asperity_share,
        area_fraction=found.area_fraction,
        film_thickness=found.film_thickness,
    )
    return float(traction.force(contact(load))(np.asarray(slip)))


def light_friction(load: float) -> float:
    """N, of oil that shears at one stress; NaN unless the film is said to fill what room there is."""
    found = shared(0.3e-6, load=load)
    told = bool(found.capped)
    return friction(replace(OIL, traction="eyring_constant"), found, load=load, slip=0.02) if told else math.nan


def thickened(
    pressure: float, *, pressure_viscosity: float = OIL.pressure_viscosity, temperature: float = 313.0
) -> float:
    """Viscosity, Pa s, at a pressure, Pa, and a temperature, K."""
    found = roelands_viscosity(
        pressure=pressure,
        temperature=temperature,
        viscosity=OIL.viscosity,
        pressure_viscosity=pressure_viscosity,
        reference_temperature=OIL.reference_temperature,
        viscosity_temperature=OIL.viscosity_temperature,
    )
    return float(found)


def shear(speed: float, *, oil: Lubricant = OIL, pressure: float = 0.9e9, film_thickness: float = 0.23e-6) -> float:
    """Stress in the oil, Pa, that slides with speed, m/s."""
    return float(oil_shear_stress(oil, pressure=pressure, speed=speed, film_thickness=film_thickness))


def oiled(*, speed: float = 31.0, rms_roughness: float = 0.3e-6, conformity: float | None = None) -> FrictionTorque:
    """The 6205 under 700 N of thrust in oil, its inner ring at speed, rad/s."""
    scene = load_scene(builtin_scene("6205"))
    bearing = scene.bearing
    if conformity is not None:
        close = {
            name: replace(getattr(bearing, name), groove_radius=conformity * bearing.ball_diameter) for name in RACES
        }
        bearing = replace(bearing, **close)
    asked = replace(
        scene,
        bearing=bearing,
        operation=replace(scene.operation, axial_load=np.array([700.0]), inner_speed=np.array([speed])),
        friction_coefficient=None,
        lubricant=OIL,
        surface=Surface(
            rms_roughness=rms_roughness,
            autocorrelation=CORRELATION,
            hardness=HARDNESS,
            boundary_friction=BOUNDARY_FRICTION,
        ),
        effects=AS_HERTZ,
    )
    return friction_torque(asked)


def warned(found: FrictionTorque, words: str) -> int:
    """How many warnings hold these words."""
    return sum(words in warning for warning in found.warnings)


def coefficient_at_standstill() -> float:
    """Of the inner race; NaN unless both races are said to have no film."""
    found = oiled(speed=0.0)
    assert found.friction_coefficient.inner is not None
    return float(found.friction_coefficient.inner[0]) if warned(found, "at standstill") == 2 else math.nan


def share_of_smooth_races() -> float:
    """The larger one."""
    found = oiled(rms_roughness=0.0).asperity_share
    return max(float(values[0]) for values in vars(found).values())


LUBRICATION_CASES: tuple[HardCase, ...] = (
    HardCase(
        name="film: standstill",
        asked="one and the film without speed over that at 0.37 m/s",
        right="1: what does not move draws in no oil, and ln 0 is no film",
        evaluate=lambda: 1 + film(entrainment_speed=0.0) / film(),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="film: the other sense",
        asked="the film at -0.37 m/s over that at 0.37 m/s",
        right="1: a mirror image, though powers of a negative speed are none",
        evaluate=lambda: film(entrainment_speed=-SPEED) / film(),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="film: wider along rolling",
        asked="R_x/R_y of 1.9, where the formula was made for 0.03 to 1",
        right="the formula by 40 digits, marked as outside its range: unmarked counts as wrong",
        evaluate=lambda: film(curvature_transverse=1.9 * LARGE),
        expected=8.961701851164410376e-8,
        tolerance=LOGARITHMS,
    ),
    HardCase(
        name="film: no load",
        asked="a contact without load, whose asymptotes are infinite",
        right="the room between the bodies, 1/(1/R_x + 1/R_y)",
        evaluate=lambda: film(load=0.0),
        expected=0.0031279324366593681576,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="film: 1e-12 N",
        asked="a load at which the rigid asymptote, F^-2, gives 1e23 m",
        right="the room between the bodies, 1/(1/R_x + 1/R_y)",
        evaluate=lambda: film(load=1e-12),
        expected=0.0031279324366593681576,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="film: 1e-12 N in a narrow place",
        asked="the same where the surroundings leave 0.11 mm",
        right="0.11 mm",
        evaluate=lambda: film(load=1e-12, largest_gap=0.11e-3),
        expected=0.11e-3,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="film: 1e-12 N at a crawl",
        asked="1e-12 m/s besides: powers of the load of 1e-19 and of the speed of 1e-22",
        right="the formula by 40 digits: nothing under- or overflows",
        evaluate=lambda: film(load=1e-12, entrainment_speed=1e-12),
        expected=2.1669042756524236938e-6,
        tolerance=LOGARITHMS,
    ),
    HardCase(
        name="film: no piezoviscosity",
        asked="an oil that pressure does not thicken: two asymptotes are 0, and H_EI/H_EP is x/0",
        right="the isoviscous half of the formula, by 40 digits",
        evaluate=lambda: film(pressure_viscosity=0.0),
        expected=2.8100995675040086227e-8,
        tolerance=LOGARITHMS,
    ),
    HardCase(
        name="film: rigid bodies",
        asked="such an oil at 1e-28 N and 1e-30 m/s, where nothing deforms",
        right="the rigid-isoviscous formula alone, by 40 digits",
        evaluate=lambda: film(pressure_viscosity=0.0, load=1e-28, entrainment_speed=1e-30),
        expected=2.1669042755773166055e-10,
        tolerance=ASYMPTOTE,
    ),
    HardCase(
        name="mixed: standstill",
        asked="the friction of rough bodies without speed, over that of asperities under all of the load",
        right="1: there is no film, and the oil beside the asperities bears no pressure",
        evaluate=lambda: friction(OIL, shared(0.3e-6, speed=0.0), load=LOAD, slip=0.02) / (BOUNDARY_FRICTION * LOAD),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="mixed: the other sense",
        asked="the asperities' share at -0.37 m/s over that at 0.37 m/s",
        right="1: a mirror image",
        evaluate=lambda: share(0.3e-6, speed=-SPEED) / share(0.3e-6),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="mixed: smooth",
        asked="one and the share of asperities that do not exist, Sq = 0",
        right="1: exactly none, though ln 0 stands in the balance",
        evaluate=lambda: 1 + share(0.0),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="mixed: all but smooth",
        asked="Sq of 1e-12 m, whose share no double holds: the film over that of smooth bodies",
        right="1: the limit is the smooth contact",
        evaluate=lambda: float(shared(1e-12).film_thickness) / film(),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="mixed: very rough",
        asked="Sq of 40 um, 400 times the film: what asperities leave to the oil",
        right="the root of film(s) = separation(s), by 40 digits: a share near 1 that is not 1",
        evaluate=lambda: 1 - share(40e-6),
        expected=0.00016194905824766592232,
        tolerance=SPLINE,
    ),
    HardCase(
        name="mixed: rougher than its room",
        asked="Sq of 10 mm: asperities hold the bodies farther apart than oil can reach",
        right="1: the share is all",
        evaluate=lambda: share(1e-2),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="mixed: boiled off",
        asked="the share where heating of the inlet leaves nothing of the film",
        right="1: as at standstill",
        evaluate=lambda: share(0.3e-6, heating_factor=0.0),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="mixed: friction at vanishing load",
        asked="the exponent of the friction of oil at one stress, from 1e-12 to 1e-9 N",
        right="2/3, as the area: the coefficient has no limit, the force has. A film not said to be capped is wrong",
        evaluate=lambda: exponent(light_friction, 1e-12, 1e-9),
        expected=2 / 3,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oil: 3.1 GPa",
        asked="the viscosity far above what races see; Barus's law gives e^65 times that of the inlet",
        right="Roelands', by 40 digits",
        evaluate=lambda: thickened(3.1e9),
        expected=971556858133.9482587,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oil: no piezoviscosity",
        asked="the viscosity at 3.1 GPa over that of the inlet, of an oil that pressure does not thicken",
        right="1",
        evaluate=lambda: thickened(3.1e9, pressure_viscosity=0.0) / OIL.viscosity,
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oil: a temperature in degrees Celsius",
        asked="40 K, below Roelands' pole at 138 K",
        right="a refusal that names the unit: a negative number to a broken power is none",
        evaluate=lambda: thickened(0.9e9, temperature=40.0),
        refusal="temperature must be above 138 K",
    ),
    HardCase(
        name="oil: no sliding",
        asked="one and the stress where nothing slides, over Eyring's",
        right="1: none, though the direction of sliding is 0/0",
        evaluate=lambda: 1 + shear(0.0) / OIL.eyring_stress,
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oil: all but no sliding",
        asked="stress over speed at 1e-15 m/s, 0.9 GPa and a film of 0.23 um",
        right="Newton's eta(p)/h, by 40 digits: asinh keeps the digits of a small argument",
        evaluate=lambda: shear(1e-15) / 1e-15,
        expected=64315516436.507601783,
        tolerance=(1e-10, "asinh falls short by a sixth of its argument squared, 1.5e-4 squared at 1e-8"),
    ),
    HardCase(
        name="oil: 30 GPa",
        asked="the stress at 0.02 m/s where Roelands' viscosity is 1e58 times that of the inlet",
        right="tau_E asinh(eta v/(h tau_E)), by 40 digits, below its limit",
        evaluate=lambda: shear(0.02, pressure=30e9),
        expected=675304811.70847845256,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oil: pressed solid",
        asked="the stress at 7 GPa in an oil so thick that no double holds its viscosity",
        right="zeta p: what does not flow shears at its limit",
        evaluate=lambda: shear(0.02, oil=replace(OIL, viscosity=1e4, pressure_viscosity=1e-7), pressure=7e9),
        expected=0.49e9,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oil: neither film nor sliding",
        asked="the stress where speed over film is 0/0",
        right="zeta p: without a film the limit holds at any speed, and so at none",
        evaluate=lambda: shear(0.0, film_thickness=0.0),
        expected=0.063e9,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oiled torque: standstill",
        asked="the friction coefficient of the inner race at 0 rpm over that of the boundary",
        right="1, with a warning for each race that slow running need not come to the same: without it, wrong",
        evaluate=lambda: coefficient_at_standstill() / BOUNDARY_FRICTION,
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oiled torque: the other way round",
        asked="the torque in oil at -296 rpm over that at 296 rpm",
        right="1: a mirror image",
        evaluate=lambda: float(oiled(speed=-31.0).torque.total[0] / oiled(speed=31.0).torque.total[0]),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oiled torque: smooth races",
        asked="one and the larger share of asperities, Sq = 0",
        right="1: exactly none",
        evaluate=lambda: 1 + share_of_smooth_races(),
        expected=1.0,
        tolerance=ROUND_OFF,
    ),
    HardCase(
        name="oiled torque: an ellipse of no fitted shape",
        asked="how many warnings name the film's formula at conformity 0.505, R_x/R_y of 0.01",
        right="2: one for each race",
        evaluate=lambda: float(warned(oiled(conformity=0.505), "its ellipse is not of a shape that was fitted")),
        expected=2.0,
        tolerance=ROUND_OFF,
    ),
)
