"""What the accuracy of film and rolling force costs: formula, the fit of production, and grids from coarse to fine."""

import time
from collections.abc import Callable, Iterator, Sequence

import numpy as np

from analytic.errors import FembearingError, InputError
from analytic.oil.film import FILM_FACTORS
from analytic.oil.variation import COVERAGE, FIT_SHARE, ROLLING_SPREAD
from analytic.progress import Progress
from analytic.scene import Scene
from fembearing.check.cost.ladder import Ladder, TimedMethod, UntimedMethod, ladder_of, timed
from fembearing.check.film.scene_film import problem_of
from fembearing.ehl.film import RATIO, USUAL, estimates_of
from fembearing.ehl.solver import require_few_cells, solve_on_grids
from fembearing.grid_convergence import Estimate

FILM, FORCE = "central film, inner", "rolling force, inner"
MODEL = "as in the torque"
REFERENCE = "three grids, extrapolated; the seconds of a grid include those of the coarser grids"
REFINEMENTS = USUAL / RATIO, USUAL, USUAL * RATIO
Form = tuple[str, Callable[[], float], float]  # name, value, bound


def measured_films(scene: Scene, *, tolerance: float, progress: Progress) -> tuple[Ladder, Ladder]:
    """The ladders of central film and rolling force of the heaviest ball on the inner race.

    Raises InputError for a scene without such a film.
    """
    closed, _ = problem_of(scene, "inner")
    grids, failed = [], None
    begun = time.perf_counter()
    try:
        require_few_cells(closed.problem, REFINEMENTS[-1])
        for number, solution in enumerate(solve_on_grids(closed.problem, REFINEMENTS)):
            grids.append((solution, time.perf_counter() - begun))
            progress((number + 1) / len(REFINEMENTS), f"film, grid {number + 1}")
    except FembearingError as problem:
        failed = str(problem)
    spread, of_film = COVERAGE * ROLLING_SPREAD, FILM_FACTORS[1] - 1
    of_fit = spread * (1 - closed.model_force()[1] * (1 - FIT_SHARE))
    films = (("formula", closed.film, of_film), (MODEL, closed.model_film, of_film))
    forces = (
        ("formula", lambda: float(closed.resistance().force), float(np.expm1(spread))),
        (MODEL, lambda: closed.model_force()[0], float(np.expm1(of_fit))),
    )
    reference = "none: a grid did not converge" if failed else REFERENCE

    limits = {} if failed else estimates_of([each for each, _ in grids], REFINEMENTS)

    def ladder(name: str, forms: Sequence[Form], key: str) -> Ladder:
        values = [(getattr(each, key), seconds) for each, seconds in grids]
        methods = [*map(_form, forms), *_numerical(values, limits.get(key), failed)]
        return ladder_of(name, reference, methods, tolerance=tolerance)

    return ladder(FILM, films, "central_film"), ladder(FORCE, forces, "rolling_force")


def _form(form: Form) -> TimedMethod:
    name, run, bound = form
    return timed(UntimedMethod(name=name, run=lambda: np.array([run()]), bound=lambda: bound))


def _numerical(
    grids: Sequence[tuple[float, float]], limit: Estimate | None, failed: str | None
) -> Iterator[TimedMethod]:
    """Each grid, value and seconds, and the extrapolation; failed : why a grid has no solution."""
    for number, (value, seconds) in enumerate(grids):
        yield TimedMethod(name=f"numerical, grid {number + 1}", answer=np.array([value]), seconds=(seconds,))
    if limit is None:
        yield TimedMethod(name="numerical", answer=None, failed=failed)
        return
    yield TimedMethod(
        name="numerical, three grids",
        answer=np.array([limit.value]),
        bound=limit.total,
        seconds=(grids[-1][1],),
        may_refer=True,
    )


def absent_films(reason: InputError) -> tuple[Ladder, Ladder]:
    """Both ladders of a scene without a film."""
    film, force = (Ladder(quantity=each, reference="none", methods=(), absent=str(reason)) for each in (FILM, FORCE))
    return film, force
