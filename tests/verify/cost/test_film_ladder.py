"""What film and rolling force cost: formula, fit, grids."""

from dataclasses import replace

import pytest

from analytic.scenefile.read import load_scene
from fembearing.progress import silent
from fembearing.verify.cost.film_ladder import measured_films
from tests.analytic.specimens import present


@pytest.mark.slow
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
