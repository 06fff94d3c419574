"""Which grids a film of a scene is solved on."""

from types import SimpleNamespace
from typing import Any

import pytest

from analytic.errors import ConvergenceError, InputError
from fembearing.ehl.film import RATIO
from fembearing.verify.film import scene_film
from fembearing.verify.film.scene_film import JUDGED, REFINEMENTS
from tests.ehl.contacts import moes

PROBLEM = moes(23.0, 5.0, 0.47)


def solved_on(
    monkeypatch: pytest.MonkeyPatch, *, most: float = 9.0, fails: tuple[float, ...] = (), tolerance: float = 0.01
) -> float:
    """The refinement whose film is taken, where grids hold `most` and do not converge at `fails`; all are uncertain."""

    def numerical(_problem: object, *, refinement: float) -> Any:
        if refinement in fails:
            raise ConvergenceError(iterations=3, residual=1.0, tolerance=0.1)
        uncertain = SimpleNamespace(total=0.03 / refinement)
        return SimpleNamespace(refinement=refinement, **dict.fromkeys(JUDGED, uncertain))

    def few(_problem: object, refinement: float) -> None:
        if refinement > most * RATIO:
            raise InputError("too thin")

    monkeypatch.setattr(scene_film, "numerical_film", numerical)
    monkeypatch.setattr(scene_film, "require_few_cells", few)
    found: Any = scene_film._accurate(PROBLEM, tolerance=tolerance, progress=lambda _share: None)
    return found.refinement


def test_the_coarsest_grid_that_is_accurate_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    assert solved_on(monkeypatch, tolerance=0.05) == REFINEMENTS[0]
    assert solved_on(monkeypatch, tolerance=0.035) == REFINEMENTS[1]
    assert solved_on(monkeypatch, tolerance=0.001) == REFINEMENTS[2]


def test_a_grid_that_does_not_converge_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    assert solved_on(monkeypatch, fails=REFINEMENTS[:2]) == REFINEMENTS[2]
    assert solved_on(monkeypatch, fails=REFINEMENTS[2:]) == REFINEMENTS[1]
    with pytest.raises(ConvergenceError):
        solved_on(monkeypatch, fails=REFINEMENTS)


def test_the_finest_grid_that_the_memory_holds_is_taken(monkeypatch: pytest.MonkeyPatch) -> None:
    assert solved_on(monkeypatch, most=REFINEMENTS[1]) == REFINEMENTS[1]
    with pytest.raises(InputError, match="too thin"):
        solved_on(monkeypatch, most=0.5 * REFINEMENTS[0])


def judged(ratio: float, uncertainty: float, factors: tuple[float, float] = (0.9, 1.2)) -> tuple[Any, Any]:
    """A numerical value over that of production, and between which factors of it the model claims to lie."""
    return SimpleNamespace(numerical=ratio * 0.3, production=0.3, uncertainty=uncertainty * 0.3), factors


@pytest.mark.parametrize(
    ("film", "force", "verdict"),
    [
        (judged(0.93, 0.02), judged(1.15, 0.04), "pass"),
        (judged(0.93, 0.04), judged(1.15, 0.04), "undecided"),  # 0.89 to 0.97
        (judged(0.93, 0.02), judged(1.15, 0.06), "undecided"),  # 1.09 to 1.21
        (judged(0.87, 0.02), judged(1.15, 0.04), "fail"),  # 0.89 at most
        (judged(0.93, 0.02), judged(1.25, 0.04), "fail"),  # 1.21 at least
        (judged(0.87, 0.02), judged(1.15, 0.06), "fail"),  # one is enough
    ],
)
def test_a_film_passes_where_all_of_its_interval_is_within_the_stated_errors(
    film: Any, force: Any, verdict: str
) -> None:
    assert scene_film._verdict(film, force) == verdict
