"""Film and rolling force of a ball on a race: the formulas of production against the numerical solution.

The formulas are central film [Nijenbanning1994], minimum film [Hamrock1977] and rolling force [Biboulet2010]. Both
sides have the same oil, the same load and the same speed, without heat of the inlet, starvation and roughness.
The ball turns by closed kinematics, and the oil has the temperature of the scene.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
from threadpoolctl import threadpool_limits

from analytic.brief import Brief
from analytic.contact.geometry import Race
from analytic.contact.rolling_contact import ContactNumbers, deformed_radius
from analytic.errors import ConvergenceError, InputError, require_packages
from analytic.oil.ehl_fit import Regime, film_correction, regime_of
from analytic.oil.film import FILM_FACTORS, Inflow, central_film, minimum_ratio
from analytic.oil.inlets import oil_supply
from analytic.oil.lubrication import rolling_force_of
from analytic.oil.rolling import RollingResistance, hydrodynamic_rolling
from analytic.oil.variation import COVERAGE, FIT_SHARE, NOMINAL, ROLLING_SPREAD, Variation
from analytic.oil.viscosity import oil_numbers
from analytic.prediction.evaluation import parts_of, without_moving_cage
from analytic.prediction.settled import level_of
from analytic.progress import Progress, silent
from analytic.result import FrictionTorque
from analytic.scene import Array, Contact, Scene
from fembearing.check.comparison import Comparison, ShownVerdict, compared_with, worst
from fembearing.check.contact.scene_contact import OfPair, balls_of, contact_at, heaviest_place
from fembearing.ehl.ball_on_race import lubricated_contact
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.film import USUAL, NumericalFilm, numerical_films
from fembearing.ehl.oil import Oil
from fembearing.fem.compliance import Compliance, meshed_pair

if TYPE_CHECKING:
    from matplotlib.figure import Figure

OUTSIDE = "the formula of the rolling force is outside its range: rigid bodies would resist less than elastic ones"
FINER = 1.25  # grids where the usual ones do not lead to a film
JUDGED = ("central_film", "rolling_force")  # must reach the tolerance; the torque does not take the minimum film


@dataclass(frozen=True, kw_only=True, eq=False)
class ClosedForms:
    """Film and rolling force of one contact, smooth and isothermal, in closed form and as the torque takes them, SI."""

    scene: Scene  # with a lubricant
    pair: Race
    contact: Contact
    inner_speed: float  # of the inner ring, rad/s
    problem: LubricatedContact  # what the numerical solution solves

    @cached_property
    def smooth(self) -> ContactNumbers:
        """The contact as formulas take it."""
        (a, b), (rolling, transverse) = self.problem.semi_axes, self.problem.shape.radii
        contact = self.contact
        return ContactNumbers(
            load=contact.load,
            semi_axis_rolling=a,
            semi_axis_transverse=b,
            curvature_rolling=1 / rolling,
            curvature_transverse=1 / transverse,
            modulus=self.problem.modulus,
            deformed_radius=deformed_radius(groove_radius=contact.groove_radius, ball_diameter=2 * contact.ball_radius),
            rolling_rate=1.0,
            entrainment=1.0,
        )

    @cached_property
    def inflow(self) -> Inflow:
        """The oil as it enters."""
        oil = self.problem.oil
        return Inflow(self.problem.speed, oil.viscosity, oil.pressure_viscosity, oil.compressible, np.inf)

    @property
    def regime(self) -> Regime:
        """Moes's numbers."""
        return regime_of(self.smooth, self.inflow)

    @property
    def _oil(self) -> dict[str, float]:
        oil = self.inflow
        return {
            "entrainment_speed": oil.speed,
            "viscosity": oil.viscosity,
            "pressure_viscosity": oil.pressure_viscosity,
        }

    def film(self, *, compressible: bool = False) -> float:
        """Central film by [Nijenbanning1994], m."""
        return float(central_film(self.smooth, **self._oil, compressible=compressible).thickness)

    def model_film(self) -> float:
        """Central film as the torque takes it, m."""
        assert self.scene.lubricant is not None
        film = self.film(compressible=self.inflow.compressible)
        return film * np.exp(film_correction(self.regime)) if self.scene.lubricant.film_formula == "numerical" else film

    def minimum_ratio(self) -> float:
        """Minimum over central film by [Hamrock1977]."""
        return float(minimum_ratio(self.smooth, **self._oil))

    def resistance(self) -> RollingResistance:
        """By [Biboulet2010]."""
        return hydrodynamic_rolling(self.smooth, viscosity=self.inflow.viscosity, entrainment_speed=self.inflow.speed)

    def model_force(self) -> tuple[float, float]:
        """Rolling force as the torque takes it, N, and the share of the fit in it, 0 to 1."""
        lubricant = self.scene.lubricant
        assert lubricant is not None
        formula = lubricant.rolling_formula
        supply = oil_supply(self.scene.bearing, lubricant, self.pair, contact_angle=self.contact.contact_angle)
        force, share, _ = rolling_force_of(
            self.smooth, self.inflow, self.regime, supply, formula == "numerical", formula == "houpert"
        )
        return force, share


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
    # central_film, minimum_film and pressure_centre, its distance ahead of the contact's centre, m; rolling_force, on
    # each surface against its motion, N. The formulas take an oil without compression.
    quantities: dict[str, Comparison]
    dissipated_force: float  # the force from the viscous dissipation, N: a check
    verdict: ShownVerdict  # whether central film and force are within their stated errors; the minimum film has its own
    tolerance: float  # asked of central film and rolling force, relative
    seconds: float  # of the solution on its grids
    warnings: tuple[str, ...]
    compliance: Compliance = "half-space"  # of the numerical solution
    bearing: OfPair | None = None  # of a pair

    @property
    def worst(self) -> tuple[str, float]:
        """The quantity with the largest relative uncertainty, of those that must reach the tolerance."""
        each = {name: self.quantities[name] for name in JUDGED}
        found = {name: part.uncertainty / abs(part.reference) for name, part in each.items()}
        name = max(found, key=lambda name: found[name])
        return name, found[name]


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceFilm(Brief):
    """The numbers of a lubricated contact and its solution, with the maps of pressure and film."""

    numbers: FilmNumbers
    solution: NumericalFilm

    def _facts(self) -> Iterator[str]:
        found = self.numbers
        film = found.quantities["central_film"]
        yield from (found.pair, f"{found.load:.4g} N", f"film {1e6 * film.reference:.4g} um")

    def plot(self) -> "Figure":
        """Maps of pressure, GPa, and film, um, and both along the line of rolling, mm, as the report has them.

        Raises MissingPackageError where Matplotlib is not installed.
        """
        require_packages("a figure", "matplotlib")
        from fembearing.check.film.figure import film_figure

        return film_figure(self.solution)


def film_of(
    scene: Scene,
    *,
    pair: Race,
    load: float | None = None,
    inner_speed: float | None = None,
    tolerance: float | None = None,
    compliance: Compliance = "half-space",
    progress: Progress = silent,
) -> RaceFilm:
    """Solve the lubricated contact of the heaviest ball on one race of a lubricated scene, and compare the formulas.

    load : of the ball, N, > 0; None: the scene's largest
    inner_speed : of the inner ring, rad/s, of either sign; None: that of the operating point of the heaviest ball
    tolerance : required of central film and rolling force, relative; None: the scene's
    compliance : of the numerical solution: half spaces, or ball and race of true shape by finite elements
    progress : called with the share done, 0 to 1, and the name of the current step
    Raises InputError for a dry scene, standstill, what the numerical solution does not cover, and meshed bodies whose
    contact a shoulder cuts off; ConvergenceError where the numerical solution does not converge.
    """
    closed = problem_of(scene, pair, load=load, inner_speed=inner_speed)
    problem = closed.problem
    if compliance == "meshed":
        progress(0.0, f"{pair}: compliance of ball and race")
        problem = replace(problem, added=meshed_pair(closed.contact))
    limit = scene.tolerance if tolerance is None else tolerance
    progress(0.0, f"{pair}: film on three grids")
    found: RaceFilm | None = None
    with threadpool_limits(1, "blas"):
        for solution in _films_of(problem):
            found = compare_film(closed, solution, tolerance=limit)
            if found.numbers.worst[1] <= limit:
                break
            progress(0.2, f"{pair}: film on a finer grid")
    assert found is not None
    return replace(found, numbers=replace(found.numbers, compliance=compliance))


def film_change(scene: Scene, friction: FrictionTorque, films: tuple[RaceFilm, ...]) -> Array:
    """(n,) relative change of the torque with the numerical film and rolling force.

    friction : friction_torque(scene)
    All contacts get the mean ratios, numerical value over the model, of `films`; a cage that moves keeps its torque.
    """

    def ratio(name: str) -> float:
        return float(np.mean([1 / (1 + film.numbers.quantities[name].difference) for film in films]))

    numerical = Variation(film=ratio("central_film"), rolling=ratio("rolling_force"))
    same = without_moving_cage(scene, friction)
    level = level_of(same)
    base = parts_of(same, NOMINAL, level).total
    return (parts_of(same, numerical, level).total - base) / friction.torque.total


def _judged(found: Comparison, factors: tuple[float, float]) -> Comparison:
    """With the verdict whether the numerical value lies within factors of what production takes, for certain."""
    low, high = ((found.reference + sign * found.uncertainty) / found.production for sign in (-1, 1))
    least, most = factors
    inside, outside = least <= low and high <= most, high < least or most < low
    return replace(found, verdict="pass" if inside else "fail" if outside else "undecided")


def _films_of(problem: LubricatedContact) -> Iterator[NumericalFilm]:
    """On the usual grids, or on finer ones where Newton's method does not settle on those."""
    try:
        yield from numerical_films(problem)
    except ConvergenceError:
        yield from numerical_films(problem, refinement=FINER * USUAL)


def problem_of(scene: Scene, pair: Race, *, load: float | None = None, inner_speed: float | None = None) -> ClosedForms:
    """The lubricated contact of the heaviest ball with its formulas.

    load, inner_speed : N and rad/s; None: of the scene. Raises InputError for a dry scene, at standstill, and for what
    the numerical solution does not cover.
    """
    lubricant = scene.lubricant
    if lubricant is None:
        raise InputError("the scene is dry, without a film: add a table [lubricant]")
    balls = balls_of(scene)
    place = heaviest_place(balls)
    contact = contact_at(scene, balls, pair, place)
    if load is not None:
        contact = replace(contact, load=load)
    speed = float(scene.operation.as_series().inner_speed[place[0]]) if inner_speed is None else inner_speed
    if speed == 0:
        raise InputError("operation.inner_speed = 0: at standstill there is no film; give --speed or another scene")
    oil = Oil(
        viscosity=oil_numbers(lubricant).viscosity,
        pressure_viscosity=float(lubricant.pressure_viscosity),
        compressible=lubricant.compressible,
        cavitation_pressure=float(lubricant.cavitation_pressure),
    )
    problem = lubricated_contact(
        contact,
        oil=oil,
        entrainment_speed=speed * float(balls["motion"][f"{pair}_entrainment"][place]),
        ahead=lubricant.reach.ahead * contact.ball_radius,
        behind=lubricant.reach.behind * contact.ball_radius,
    )
    return ClosedForms(scene=scene, pair=pair, contact=contact, inner_speed=speed, problem=problem)


def compare_film(closed: ClosedForms, solution: NumericalFilm, *, tolerance: float) -> RaceFilm:
    """The formulas beside a solution of the same contact."""
    problem, contact = closed.problem, closed.contact
    film, produced_film = closed.film(), closed.model_film()
    minimum, resistance = closed.minimum_ratio(), closed.resistance()
    force, (produced_force, share) = float(resistance.force), closed.model_force()
    arm = 2 * problem.shape.radii[0] / contact.load
    spread = COVERAGE * ROLLING_SPREAD * (1 - share * (1 - FIT_SHARE))
    quantities = {
        name: compared_with(getattr(solution, name), production, formula=formula)
        for name, formula, production in (
            ("central_film", film, produced_film),
            ("minimum_film", minimum * film, minimum * produced_film),
            ("rolling_force", force, produced_force),
            ("pressure_centre", force * arm, produced_force * arm),
        )
    }
    of_force = np.exp(-spread), np.exp(spread)
    # The minimum is a share of the central film: it is asked to be as near.
    for name, factors in zip((*JUDGED, "minimum_film"), (FILM_FACTORS, of_force, FILM_FACTORS), strict=True):
        quantities[name] = _judged(quantities[name], factors)
    numbers = FilmNumbers(
        pair=closed.pair,
        load=contact.load,
        inner_speed=closed.inner_speed,
        entrainment_speed=problem.speed,
        viscosity=problem.oil.viscosity,
        pressure_viscosity=problem.oil.pressure_viscosity,
        reach=problem.reach,
        loading=problem.loading,
        thickening=problem.thickening,
        ellipticity=problem.ellipticity,
        quantities=quantities,
        dissipated_force=solution.dissipated_force.value,
        verdict=worst(quantities[name].verdict for name in JUDGED),
        tolerance=tolerance,
        seconds=solution.seconds,
        warnings=(OUTSIDE,) if share < 1 and resistance.outside_range else (),
    )
    return RaceFilm(numbers=numbers, solution=solution)
