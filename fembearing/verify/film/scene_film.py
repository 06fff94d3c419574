"""Film and rolling force of a ball on a race: the formulas of production against the numerical solution.

The formulas are central film [Nijenbanning1994], minimum film [Hamrock1977] and rolling force [Biboulet2010]. Both
sides have the same oil, the same load and the same speed, without heat of the inlet, starvation and roughness.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from analytic.brief import Brief
from analytic.contact.geometry import Race
from analytic.contact.rolling_contact import ContactNumbers, RollingContact, deformed_radius
from analytic.errors import ConvergenceError, InputError
from analytic.oil.asymptotes import Inflow
from analytic.oil.ehl_fit import OilSupply, covered, film_correction, fitted_force, regime_of
from analytic.oil.film import FILM_FACTORS, central_film, minimum_ratio
from analytic.oil.inlets import oil_supply
from analytic.oil.rolling import houpert_rolling, hydrodynamic_rolling
from analytic.oil.variation import COVERAGE, FIT_SHARE, NOMINAL, ROLLING_SPREAD, Variation
from analytic.oil.viscosity import inlet_viscosity
from analytic.prediction.evaluation import parts_of, without_moving_cage
from analytic.prediction.settled import free_start
from analytic.result import FrictionTorque
from analytic.scene import Array, Contact, Lubricant, Scene
from fembearing.ehl.ball_on_race import lubricated_contact
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.film import NumericalFilm, numerical_film
from fembearing.ehl.oil import Oil
from fembearing.grid_convergence import Estimate
from fembearing.progress import Progress, silent
from fembearing.verify.contact.scene_contact import balls_of, contact_at, heaviest_place

REFINEMENTS = (0.75, 0.95, 1.2)  # of the middle grid, until the tolerance is reached
OUTSIDE = "the formula of the rolling force is outside its range: rigid bodies would resist less than elastic ones"
JUDGED = ("central_film", "rolling_force")  # must reach the tolerance; the minimum lies beside the contact's edge


@dataclass(frozen=True, kw_only=True)
class FilmQuantity:
    """One quantity by formula and by numerical solution, SI."""

    formula: float  # in closed form, without compression of the oil
    production: float  # as the torque takes it: the fit to numerical solutions, or the formula outside its range
    numerical: float
    uncertainty: float  # of the numerical value, half-width at 95 %, in its unit
    discrepancy: float  # production over numerical value, less 1
    order: float | None  # observed on the three grids

    @property
    def relative_uncertainty(self) -> float:
        """Of the numerical value."""
        return self.uncertainty / abs(self.numerical)


@dataclass(frozen=True, kw_only=True)
class FilmNumbers:
    """The lubricated contact of a ball on a race: formulas and numerical solution, SI."""

    pair: Race
    load: float  # Q, N
    inner_speed: float  # of the inner ring, rad/s
    entrainment_speed: float  # u, mean of both surfaces relative to the contact, m/s
    viscosity: float  # eta_0 at the temperature of the scene, Pa s
    pressure_viscosity: float  # alpha, 1/Pa
    reach: Reach  # of the oil
    loading: float  # Moes's M
    thickening: float  # Moes's L
    ellipticity: float  # lambda = R_x/R_y
    central_film: FilmQuantity  # m
    minimum_film: FilmQuantity  # m
    rolling_force: FilmQuantity  # on each surface against its motion, N
    pressure_centre: FilmQuantity  # its distance ahead of the contact's centre, m
    dissipated_force: float  # the force from the viscous dissipation, N: a check
    verdict: Literal["pass", "fail", "undecided"]  # whether film and force are within the stated errors of the formulas
    tolerance: float  # asked of central film and rolling force, relative
    seconds: float  # of the solution on its three grids
    warnings: tuple[str, ...]

    @property
    def quantities(self) -> dict[str, FilmQuantity]:
        """Each by its name."""
        names = ("central_film", "minimum_film", "rolling_force", "pressure_centre")
        return {name: getattr(self, name) for name in names}

    @property
    def worst(self) -> tuple[str, float]:
        """The quantity with the largest relative uncertainty, of those that must reach the tolerance."""
        each = {name: getattr(self, name).relative_uncertainty for name in JUDGED}
        name = max(each, key=lambda name: each[name])
        return name, each[name]


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceFilm(Brief):
    """The numbers of a lubricated contact and its solution, with the maps of pressure and film."""

    numbers: FilmNumbers
    solution: NumericalFilm

    def _facts(self) -> Iterator[str]:
        found = self.numbers
        yield from (found.pair, f"{found.load:.4g} N", f"film {1e6 * found.central_film.numerical:.4g} um")


def film_of(
    scene: Scene,
    *,
    pair: Race,
    load: float | None = None,
    inner_speed: float | None = None,
    tolerance: float | None = None,
    progress: Progress = silent,
) -> RaceFilm:
    """Solve the lubricated contact of the heaviest ball on one race and compare the formulas with it.

    Parameters
    ----------
    scene : Scene
        With a lubricant.
    pair : {"inner", "outer"}
        The race.
    load : float, optional
        Of the ball, N, > 0; None: the scene's largest.
    inner_speed : float, optional
        Of the inner ring, rad/s, of either sign; None: that of the operating point of the heaviest ball.
    tolerance : float, optional
        Required of central film and rolling force, relative (dimensionless); None: the scene's.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and the name of the current step.

    Returns
    -------
    RaceFilm
        Formula and numerical value with its uncertainty, SI.

    Raises
    ------
    InputError
        For a dry scene, standstill, and what the numerical solution does not cover.
    ConvergenceError
        Where the numerical solution does not converge.

    Notes
    -----
    The ball turns by closed kinematics. The oil has the temperature of the scene.
    """
    if scene.lubricant is None:
        raise InputError("the scene is dry: add a table [lubricant], or there is no film to compute")
    contact, speed, rate = _heaviest(scene, pair)
    if load is not None:
        contact = replace(contact, load=load)
    speed = speed if inner_speed is None else inner_speed
    if speed == 0:
        raise InputError("operation.inner_speed = 0: at standstill there is no film; give --speed or another scene")
    lubricant, at_inlet = scene.lubricant, inlet_viscosity(scene.lubricant)
    oil = Oil(
        viscosity=float(at_inlet.viscosity),
        pressure_viscosity=float(lubricant.pressure_viscosity),
        compressible=lubricant.compressible,
        cavitation_pressure=float(lubricant.cavitation_pressure),
    )
    problem = lubricated_contact(
        contact,
        oil=oil,
        entrainment_speed=speed * rate,
        ahead=lubricant.reach.ahead * contact.ball_radius,
        behind=lubricant.reach.behind * contact.ball_radius,
    )
    limit = scene.tolerance if tolerance is None else tolerance
    solution = _accurate(
        problem, tolerance=limit, progress=lambda share: progress(share, f"{pair}: film on three grids")
    )
    supply = oil_supply(scene.bearing, lubricant, pair, contact_angle=contact.contact_angle)
    return _compared(pair, contact, solution, lubricant, supply, inner_speed=speed, tolerance=limit)


def film_change(scene: Scene, friction: FrictionTorque, films: tuple[RaceFilm, ...]) -> Array:
    """(n,) relative change of the torque with the numerical film and rolling force.

    friction : friction_torque(scene)
    All contacts get the mean ratios, numerical value over formula, of `films`; a cage that moves keeps its torque.
    """

    def ratio(name: str) -> float:
        return float(np.mean([1 / (1 + film.numbers.quantities[name].discrepancy) for film in films]))

    numerical = Variation(film=ratio("central_film"), rolling=ratio("rolling_force"))
    same = without_moving_cage(scene, friction)
    start = free_start(same)
    base = parts_of(same, NOMINAL, start).total
    return (parts_of(same, numerical, start).total - base) / friction.torque.total


def _verdict(
    *judged: tuple[FilmQuantity, tuple[float, float]],
) -> Literal["pass", "fail", "undecided"]:
    """Whether numerical values lie within factors of what production takes, for certain."""
    inside, outside = True, False
    for each, (least, most) in judged:
        low, high = ((each.numerical + sign * each.uncertainty) / each.production for sign in (-1, 1))
        inside = inside and least <= low and high <= most
        outside = outside or high < least or most < low
    return "pass" if inside else "fail" if outside else "undecided"


def _accurate(problem: LubricatedContact, *, tolerance: float, progress: Callable[[float], None]) -> NumericalFilm:
    """The solution on the coarsest grids that reach the tolerance, or on the finest."""
    *coarser, finest = REFINEMENTS
    for number, refinement in enumerate(coarser):
        progress(number / len(REFINEMENTS))
        try:
            solution = numerical_film(problem, refinement=refinement)
        except ConvergenceError:  # a finer grid may settle; the finest one says why it does not
            continue
        if all(getattr(solution, name).total <= tolerance for name in JUDGED):
            return solution
    progress(len(coarser) / len(REFINEMENTS))
    return numerical_film(problem, refinement=finest)


def _heaviest(scene: Scene, race: Race) -> tuple[Contact, float, float]:
    """The contact of the heaviest ball, the ring's speed there, rad/s, and the entrainment speed over it, m."""
    balls = balls_of(scene)
    place = heaviest_place(balls)
    contact = contact_at(scene, balls, race, place)
    rate = getattr(balls.motion, f"{race}_entrainment")[place]
    return contact, float(scene.operation.as_series().inner_speed[place[0]]), float(rate)


def _compared(
    pair: Race,
    contact: Contact,
    solution: NumericalFilm,
    lubricant: Lubricant,
    supply: OilSupply,
    *,
    inner_speed: float,
    tolerance: float,
) -> RaceFilm:
    """The formulas beside a solution of the same contact."""
    problem = solution.contact
    (a, b), (rolling, transverse) = problem.semi_axes, problem.shape.radii
    smooth = RollingContact(
        load=contact.load,
        semi_axis_rolling=a,
        semi_axis_transverse=b,
        curvature_rolling=1 / rolling,
        curvature_transverse=1 / transverse,
        modulus=problem.modulus,
        deformed_radius=deformed_radius(groove_radius=contact.groove_radius, ball_diameter=2 * contact.ball_radius),
        rolling_rate=1.0,
    )
    u, viscosity, pressure_viscosity = problem.speed, problem.oil.viscosity, problem.oil.pressure_viscosity
    inlet: dict[str, float] = {
        "entrainment_speed": u,
        "viscosity": viscosity,
        "pressure_viscosity": pressure_viscosity,
    }
    ratio = float(minimum_ratio(smooth, **inlet))
    resistance = hydrodynamic_rolling(smooth, viscosity=viscosity, entrainment_speed=u)
    alone, squeezed = (
        float(
            central_film(
                smooth,
                entrainment_speed=u,
                viscosity=viscosity,
                pressure_viscosity=pressure_viscosity,
                compressible=compressible,
            ).thickness
        )
        for compressible in (False, lubricant.compressible)
    )
    force = float(resistance.force)
    numbers = ContactNumbers._make((*(float(each) for each in smooth.fields[:8]), 1.0))
    inflow = Inflow(u, viscosity, pressure_viscosity, lubricant.compressible, np.inf)
    regime = regime_of(numbers, inflow)
    share = covered(regime) if lubricant.rolling_formula == "numerical" else 0.0
    if lubricant.film_formula == "numerical":
        squeezed *= float(np.exp(film_correction(regime)))
    resisting = force if lubricant.rolling_formula != "houpert" else float(houpert_rolling(smooth, **inlet).force)
    if share > 0:
        resisting += share * (fitted_force(numbers, inflow, regime, supply) - resisting)

    def beside(formula: float, production: float, part: Estimate) -> FilmQuantity:
        return FilmQuantity(
            formula=formula,
            production=production,
            numerical=part.value,
            uncertainty=part.total * abs(part.value),
            discrepancy=production / part.value - 1,
            order=part.order,
        )

    film = beside(alone, squeezed, solution.central_film)
    rolling_force = beside(force, resisting, solution.rolling_force)
    spread = COVERAGE * ROLLING_SPREAD * (1 - share * (1 - FIT_SHARE))
    numbers = FilmNumbers(
        pair=pair,
        load=contact.load,
        inner_speed=inner_speed,
        entrainment_speed=u,
        viscosity=viscosity,
        pressure_viscosity=pressure_viscosity,
        reach=problem.reach,
        loading=problem.loading,
        thickening=problem.thickening,
        ellipticity=problem.ellipticity,
        central_film=film,
        minimum_film=beside(alone * ratio, squeezed * ratio, solution.minimum_film),
        rolling_force=rolling_force,
        pressure_centre=beside(
            *(2 * rolling * each / contact.load for each in (force, resisting)), solution.pressure_centre
        ),
        dissipated_force=solution.dissipated_force.value,
        verdict=_verdict((film, FILM_FACTORS), (rolling_force, (np.exp(-spread), np.exp(spread)))),
        tolerance=tolerance,
        seconds=solution.seconds,
        warnings=(OUTSIDE,) if share < 1 and resistance.outside_range.any() else (),
    )
    return RaceFilm(numbers=numbers, solution=solution)
