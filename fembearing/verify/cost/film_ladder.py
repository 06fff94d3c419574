"""What the accuracy of film and rolling force costs: formula, the fit of production, and grids from coarse to fine."""

import time
from collections.abc import Callable

import numpy as np

from analytic.errors import FembearingError, InputError
from analytic.oil.film import FILM_FACTORS
from analytic.oil.variation import COVERAGE, FIT_SHARE, ROLLING_SPREAD
from analytic.scene import Scene
from fembearing.ehl.film import RATIO, USUAL, extrapolation
from fembearing.ehl.solver import Solution, solve_on_grids
from fembearing.progress import Progress
from fembearing.verify.cost.ladder import Ladder, TimedMethod, UntimedMethod, ladder_of, timed
from fembearing.verify.film.scene_film import problem_of

FILM, FORCE = "central film, inner", "rolling force, inner"
REFINEMENTS = USUAL / RATIO, USUAL, USUAL * RATIO


def measured_films(scene: Scene, *, tolerance: float, progress: Progress) -> tuple[Ladder, Ladder]:
    """The ladders of central film and rolling force of the heaviest ball on the inner race.

    Raises InputError for a scene without such a film.
    """
    closed, _ = problem_of(scene, "inner")
    spread = COVERAGE * ROLLING_SPREAD
    of_film, of_force = FILM_FACTORS[1] - 1, float(np.expm1(spread))
    of_fit = float(np.expm1(spread * (1 - closed.share * (1 - FIT_SHARE))))
    solutions, seconds, failed = [], [], None
    begun = time.perf_counter()
    try:
        for number, solution in enumerate(solve_on_grids(closed.problem, REFINEMENTS)):
            solutions.append(solution)
            seconds.append(time.perf_counter() - begun)
            progress((number + 1) / len(REFINEMENTS), f"film, grid {number + 1}")
    except FembearingError as problem:
        failed = str(problem)

    def ladder(
        name: str,
        formula: Callable[[], float],
        model: Callable[[], float],
        value: Callable[[Solution], float],
        bounds: tuple[float, float],
    ) -> Ladder:
        forms = zip(("formula", "fit to numerical solutions"), (formula, model), bounds, strict=True)
        methods = [
            timed(UntimedMethod(name=each, run=lambda run=run: np.array([run()]), bound=lambda bound=bound: bound))
            for each, run, bound in forms
        ]
        values = [value(each) for each in solutions]
        methods += [
            TimedMethod(
                name=f"numerical, grid {number + 1}",
                answer=np.array([each]),
                seconds=(seconds[number],),
                unknowns=solutions[number].pressure.size,
            )
            for number, each in enumerate(values)
        ]
        if failed is not None:
            methods.append(TimedMethod(name="numerical", answer=None, failed=failed))
        else:
            limit = extrapolation(tuple(values), tuple(1 / each for each in REFINEMENTS))
            answer = np.array([limit.value])
            methods.append(
                TimedMethod(
                    name="numerical, three grids",
                    answer=answer,
                    bound=limit.total,
                    seconds=(seconds[-1],),
                    may_refer=True,
                )
            )
        words = "three grids, extrapolated; a grid's seconds are with those of the grids before it"
        return ladder_of(name, "none: no grid settled" if failed else words, methods, tolerance=tolerance)

    return (
        ladder(
            FILM,
            closed.film,
            closed.model_film,
            lambda each: each.central_film,
            (of_film, of_film),
        ),
        ladder(
            FORCE,
            lambda: float(closed.resistance().force),
            closed.model_force,
            lambda each: each.rolling_force,
            (of_force, of_fit),
        ),
    )


def absent_films(reason: InputError) -> tuple[Ladder, Ladder]:
    """Both ladders of a scene without a film."""
    film, force = (Ladder(quantity=each, reference="none", methods=(), absent=str(reason)) for each in (FILM, FORCE))
    return film, force
