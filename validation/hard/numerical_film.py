"""Hard cases of the numerical film: its limits of load and speed, extreme materials and grooves, and oil that ends."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from itertools import islice
from typing import Any

import numpy as np

from analytic.scene import Material, Operation, Reach, Scene
from analytic.scenefile.read import load_scene
from fembearing.check.film.scene_film import film_of
from fembearing.ehl.contact import LubricatedContact
from fembearing.ehl.contact import Reach as OilReach
from fembearing.ehl.film import numerical_film
from fembearing.ehl.oil import Oil
from fembearing.ehl.shape import BallOnRace, Paraboloid
from fembearing.ehl.solver import Solution, solve_on_grids
from fembearing.fem.half_space import contact_modulus, hertz_ellipse
from validation.hard.specimens import (
    BEARING,
    CERAMIC,
    NEARLY_INCOMPRESSIBLE,
    PEEK,
    inner,
    with_clearance,
    with_conformity,
)

LIGHT = 60.0  # N of thrust: a small contact, quick to solve
RIGID = 35.35  # H M^2 of a rigid point contact with an endless inlet, by two other codes: 35.2 to 35.5


def rolling(
    loading: float,
    thickening: float,
    *,
    modulus: float,
    ellipticity: float = 1.0,
    ahead: float = 8.49,
    load: float | None = None,
    **oil: Any,
) -> LubricatedContact:
    """Paraboloids of given M, L and lambda; without thickening the load is given, N. ahead : of the oil, in a."""
    pressure_viscosity, viscosity, radius = 2e-8 if thickening else 0.0, 0.059, 9.5e-3
    scale = 2 * modulus * radius**2
    if load is None:
        relative = (thickening / (pressure_viscosity * 2 * modulus)) ** 4
        pressed = loading * relative**0.75 * scale
    else:
        relative, pressed = (load / scale / loading) ** (4 / 3), load
    a, b = hertz_ellipse((1 / radius, ellipticity / radius), load=pressed, modulus=modulus)
    return LubricatedContact(
        load=pressed,
        modulus=modulus,
        shape=Paraboloid(rolling_radius=radius, transverse_radius=radius / ellipticity),
        speed=relative * modulus * radius / viscosity,
        oil=Oil(viscosity=viscosity, pressure_viscosity=pressure_viscosity, **oil),
        reach=OilReach(ahead=ahead * a, behind=ahead * a, side=max(ahead * a / ellipticity**0.5, 1.5 * b)),
    )


def solved(contact: LubricatedContact, refinement: float) -> Solution:
    """On the second grid, from the first of this refinement."""
    *_, found = islice(solve_on_grids(contact, refinement), 2)
    return found


def modulus_of(ball: Material, race: Material) -> float:
    return contact_modulus(replace(inner(), ball_material=ball, race_material=race))


@cache
def film_number(modulus: float) -> float:
    """Moes's H at M 23, L 5 and lambda 0.47, of an incompressible oil by Barus's law, whose only numbers these are."""
    contact = rolling(23.0, 5.0, ellipticity=0.47, modulus=modulus, law="barus", compressible=False)
    return solved(contact, 0.34).central_film / contact.film_scale


def alike(ball: Material, race: Material) -> float:
    """Moes's H over that of steel."""
    steel = BEARING.ball_material
    return film_number(modulus_of(ball, race)) / film_number(modulus_of(steel, steel))


def rigid() -> float:
    """H M^2 of a ball on a plane under 1e-6 N, at M of 0.5, over that of two other codes."""
    contact = rolling(0.5, 0.0, modulus=1.14e11, load=1e-6, ahead=8000.0, compressible=False)
    return numerical_film(contact, refinement=0.4).central_film.value / contact.film_scale * 0.5**2 / RIGID


def nearly_dry() -> float:
    """Largest pressure over Hertz's."""
    contact = rolling(1000.0, 5.0, modulus=1.14e11, ahead=6.0)
    return float(solved(contact, 0.54).pressure.max()) / contact.peak_pressure


def close(conformity: float) -> float:
    """Rolling force by dissipation over that by pressure: 20 N at this conformity, in oil of constant viscosity."""
    ball = BEARING.ball_radius
    contact = LubricatedContact(
        load=20.0,
        modulus=1.13e11,
        shape=BallOnRace(ball_radius=ball, race_radius=15.9e-3, groove_radius=2 * conformity * ball),
        speed=0.37,
        oil=Oil(viscosity=0.061, pressure_viscosity=0.0),
        reach=OilReach(ahead=0.9 * ball, behind=0.9 * ball, side=0.75 * ball),
    )
    found = solved(contact, 0.6)
    return found.dissipated_force / found.rolling_force


def oiled(*, load: float = LIGHT, speed: float = 31.0, **changed: Any) -> Scene:
    """The 6205 in oil under thrust, N, at an inner speed, rad/s; `changed` replaces other fields."""
    operation = Operation(axial_load=np.array([load]), inner_speed=np.array([speed]))
    return replace(load_scene("paper_6205"), operation=operation, cage=None, **changed)


def filmed(**changed: Any) -> float:
    """Central film on the inner race, m; arguments of `oiled`."""
    return film_of(oiled(**changed), pair="inner", tolerance=0.2).numbers.quantities["central_film"].reference


def reaching(ahead: float) -> float:
    """Central film, m, where the oil reaches so many radii of the ball ahead."""
    lubricant = oiled().lubricant
    assert lubricant is not None
    return filmed(lubricant=replace(lubricant, reach=Reach(ahead=ahead)))


NUMERICAL_FILM_CASES: dict[str, Callable[[], float]] = {
    "numerical film: 1e-6 N": rigid,
    "numerical film: nearly dry": nearly_dry,
    "numerical film: Poisson ratio 0.49": lambda: alike(*[NEARLY_INCOMPRESSIBLE] * 2),
    "numerical film: ceramic on PEEK": lambda: alike(CERAMIC, PEEK),
    "numerical film: conformity 0.5005": lambda: close(0.5005),
    "numerical film: reversed": lambda: filmed(speed=-31.0) / filmed(),
    "numerical film: clearance 1e-12 m": lambda: (
        filmed(bearing=with_clearance(1e-12)) / filmed(bearing=with_clearance(0.0))
    ),
    "numerical film: groove as wide as the ball": lambda: filmed(bearing=with_conformity(0.5)),
    "numerical film: over the shoulder": lambda: filmed(load=1000.0, bearing=with_conformity(0.5005)),
    "numerical film: at standstill": lambda: filmed(speed=0.0),
    "numerical film: inlet shorter than the contact": lambda: reaching(0.01),
    "numerical film: dry": lambda: filmed(speed=1e-9),
    "numerical film: floating": lambda: filmed(load=2.0, speed=8000.0),
}
