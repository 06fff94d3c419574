"""What film and rolling force cost: formula, fit, grids."""

import time
from collections.abc import Iterator
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from analytic.errors import ConvergenceError
from analytic.progress import silent
from analytic.scenefile.read import load_scene
from fembearing.check.cost import film_ladder
from fembearing.check.cost.film_ladder import measured_films
from tests.analytic.specimens import present


@pytest.mark.nightly
def test_errors_fall_from_the_formula_to_the_last_grid() -> None:
    scene = load_scene("paper_6205")
    assert scene.lubricant is not None
    thin = replace(scene, lubricant=replace(scene.lubricant, reach=replace(scene.lubricant.reach, ahead=0.55)))
    film, force = measured_films(thin, tolerance=0.02, progress=silent)
    closed, model = (present(each.error) for each in film.methods[:2])
    assert model < closed / 3  # the formula's oil is not compressed
    for ladder, limit in ((film, 0.05), (force, 0.06)):  # the stated error of the fit, and the solution's own
        formula, fit, *grids, reference = ladder.methods
        assert [each.name for each in grids] == [f"numerical, grid {number}" for number in (1, 2, 3)]
        assert reference.error is None
        assert formula.bound is not None
        assert present(fit.error) < limit
        coarse, middle, fine = (present(each.error) for each in grids)
        assert coarse > middle > fine
        assert present(fit.seconds) < 1e-2 * present(reference.seconds)


@pytest.mark.parametrize("count", [3, 1])
def test_a_grid_costs_the_time_from_the_start(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    """A solution on a grid begins from those on coarser ones; where a grid has none, the reference says why."""
    paused = 0.02  # s

    def solutions(*_: Any) -> Iterator[Any]:
        for number in range(count):
            time.sleep(paused)
            yield SimpleNamespace(central_film=1e-7 * (3 - 0.1 * number), rolling_force=0.2 - 0.01 * number)
        if count < 3:
            raise ConvergenceError(iterations=7, residual=0.3, tolerance=0.1, problem="the film on a fine grid")

    monkeypatch.setattr(film_ladder, "solve_on_grids", solutions)
    monkeypatch.setattr(film_ladder, "estimates_of", lambda *_: {})
    shown: list[float] = []
    begun = time.perf_counter()
    film, force = measured_films(
        load_scene("paper_6205"), tolerance=0.02, progress=lambda share, _: shown.append(share)
    )
    whole = time.perf_counter() - begun
    assert shown == pytest.approx([(number + 1) / 3 for number in range(count)], rel=1e-12)
    for ladder in (film, force):
        *_, reference = ladder.methods
        seconds = [present(each.seconds) for each in ladder.methods if each.name.startswith("numerical, grid")]
        assert len(seconds) == count
        for number, each in enumerate(seconds):
            assert (number + 1) * paused <= each <= whole
        assert reference.error is None
        assert ("fine grid" in (reference.failed or "")) == (count < 3)
