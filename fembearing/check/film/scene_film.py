"""Film and rolling force of a ball on a race: the formulas of production against the numerical solution.

The formulas are central film [Nijenbanning1994], minimum film [Hamrock1977] and rolling force [Biboulet2010]. Both
sides have the same oil, the same load and the same speed, without heat of the inlet, starvation and roughness.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from analytic.brief import Brief
from analytic.contact.geometry import Race
from analytic.errors import ConvergenceError, InputError, require_packages
from analytic.oil.film import FILM_FACTORS
from analytic.oil.variation import COVERAGE, FIT_SHARE, NOMINAL, ROLLING_SPREAD, Variation
from analytic.oil.viscosity import oil_numbers
from analytic.prediction.evaluation import parts_of, without_moving_cage
from analytic.prediction.settled import level_of
from analytic.progress import Progress, silent
from analytic.result import FrictionTorque
from analytic.scene import Array, Contact, Scene
from fembearing.check.comparison import Comparison, ShownVerdict, compared_with, worst
from fembearing.check.contact.compliance import Compliance, meshed_pair
from fembearing.check.contact.scene_contact import OfPair, balls_of, contact_at, heaviest_place
from fembearing.check.film.closed_forms import ClosedForms
from fembearing.ehl.ball_on_race import lubricated_contact
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.film import RATIO, NumericalFilm, numerical_film
from fembearing.ehl.oil import Oil
from fembearing.ehl.solver import require_few_cells

if TYPE_CHECKING:
    from matplotlib.figure import Figure

REFINEMENTS = (0.75, 0.95, 1.2)  # of the middle grid, until the tolerance is reached
OUTSIDE = "the formula of the rolling force is outside its range: rigid bodies would resist less than elastic ones"
JUDGED = ("central_film", "rolling_force")  # must reach the tolerance; the minimum lies beside the contact's edge


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
    verdict: ShownVerdict  # whether film and force are within the stated errors of the formulas
    tolerance: float  # asked of central film and rolling force, relative
    seconds: float  # of the solution on its three grids
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
        """Maps of pressure and film, and both along the line of rolling, as the report has them.

        Returns
        -------
        matplotlib.figure.Figure
            GPa, um and mm.

        Raises
        ------
        MissingPackageError
            Matplotlib is not installed.
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
    compliance : {"half-space", "meshed"}
        Elastic bodies of the numerical solution: half spaces, or ball and race of true shape by finite elements.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and the name of the current step.

    Returns
    -------
    RaceFilm
        Formula and numerical value with its uncertainty, SI.

    Raises
    ------
    InputError
        For a dry scene, standstill, what the numerical solution does not cover, and meshed bodies whose contact a
        shoulder cuts off.
    ConvergenceError
        Where the numerical solution does not converge.

    Notes
    -----
    The ball turns by closed kinematics. The oil has the temperature of the scene.
    """
    closed, speed = problem_of(scene, pair, load=load, inner_speed=inner_speed)
    problem = closed.problem
    if compliance == "meshed":
        progress(0.0, f"{pair}: compliance of ball and race")
        problem = replace(problem, added=meshed_pair(closed.contact))
    limit = scene.tolerance if tolerance is None else tolerance
    solution = _accurate(
        problem, tolerance=limit, progress=lambda share: progress(share, f"{pair}: film on three grids")
    )
    found = _compared(closed, solution, inner_speed=speed, tolerance=limit)
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


def _accurate(problem: LubricatedContact, *, tolerance: float, progress: Callable[[float], None]) -> NumericalFilm:
    """The solution on the coarsest grids that reach the tolerance, or on the finest that converge in this memory."""
    best: NumericalFilm | None = None
    for number, refinement in enumerate(REFINEMENTS):
        progress(number / len(REFINEMENTS))
        try:
            require_few_cells(problem, refinement * RATIO)
            best = numerical_film(problem, refinement=refinement)
        except InputError:  # too many cells, on each finer grid too
            if best is None:
                raise
            return best
        except ConvergenceError:  # another grid may converge; the finest one says why none does
            if best is None and refinement == REFINEMENTS[-1]:
                raise
            continue
        if all(getattr(best, name).total <= tolerance for name in JUDGED):
            break
    assert best is not None
    return best


def _heaviest(scene: Scene, race: Race) -> tuple[Contact, float, float]:
    """The contact of the heaviest ball, the ring's speed there, rad/s, and the entrainment speed over it, m."""
    balls = balls_of(scene)
    place = heaviest_place(balls)
    contact = contact_at(scene, balls, race, place)
    rate = balls["motion"][f"{race}_entrainment"][place]
    return contact, float(scene.operation.as_series().inner_speed[place[0]]), float(rate)


def problem_of(
    scene: Scene, pair: Race, *, load: float | None = None, inner_speed: float | None = None
) -> tuple[ClosedForms, float]:
    """The lubricated contact of the heaviest ball with its formulas, and the speed of the inner ring, rad/s.

    load, inner_speed : N and rad/s; None: of the scene. Raises InputError for a dry scene, at standstill, and for what
    the numerical solution does not cover.
    """
    lubricant = scene.lubricant
    if lubricant is None:
        raise InputError("the scene is dry, without a film: add a table [lubricant]")
    contact, speed, rate = _heaviest(scene, pair)
    if load is not None:
        contact = replace(contact, load=load)
    speed = speed if inner_speed is None else inner_speed
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
        entrainment_speed=speed * rate,
        ahead=lubricant.reach.ahead * contact.ball_radius,
        behind=lubricant.reach.behind * contact.ball_radius,
    )
    return ClosedForms(scene=scene, pair=pair, contact=contact, problem=problem), speed


def _compared(closed: ClosedForms, solution: NumericalFilm, *, inner_speed: float, tolerance: float) -> RaceFilm:
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
    for name, factors in (("central_film", FILM_FACTORS), ("rolling_force", (np.exp(-spread), np.exp(spread)))):
        quantities[name] = _judged(quantities[name], factors)
    numbers = FilmNumbers(
        pair=closed.pair,
        load=contact.load,
        inner_speed=inner_speed,
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
