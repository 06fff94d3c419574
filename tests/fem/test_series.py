"""Loads that share a mesh against single solutions, and the number of meshes."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import InputError
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.fem import solution as module
from fembearing.fem.series import off_mesh, on_level, solve_series
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.mesh.recipe import Recipe, load_recipe
from tests.contacts import INNER, OUTER

IDEAL, REAL = load_recipe("hertzian"), load_recipe("race")


def meshes_of(series: tuple[MeshSolution, ...]) -> int:
    return len({id(part.bodies) for part in series})


@pytest.fixture
def condensed(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The bodies that are condensed from here on."""
    names: list[str] = []
    original = module.condense

    def counted(body, **arguments):
        names.append(body.name)
        return original(body, **arguments)

    monkeypatch.setattr(module, "condense", counted)
    return names


def test_a_load_of_a_series_is_that_load_on_the_same_mesh(shallow: Callable[[str], Recipe]) -> None:
    """Bit for bit: the same nodes touch, and the same equations are solved."""
    loads, recipe = (611.0, 130.0, 254.0), shallow("race")
    for part, load in zip(solve_series(OUTER, recipe=recipe, level=2, loads=loads), loads, strict=True):
        alone = solve_on_mesh(replace(OUTER, load=load), recipe=recipe, level=2, semi_axes=part.pair.semi_axes)
        assert part.quantities == alone.quantities
        np.testing.assert_array_equal(part.force, alone.force)
        assert part.contact == alone.contact


def test_forty_loads_within_a_factor_of_six_are_condensed_once(
    condensed: list[str], shallow: Callable[[str], Recipe]
) -> None:
    loads, recipe = np.geomspace(100.0, 600.0, 40), shallow("race")
    series = solve_series(INNER, recipe=recipe, level=2, loads=loads)
    all_loads = len(condensed)
    (made_for,) = {part.pair.semi_axes for part in series}
    own = next(part for part in series if max(abs(np.divide(part.semi_axes, made_for) - 1)) < 0.01)
    assert meshes_of(series) == 1
    condensed.clear()
    fitted_solution(own.contact, recipe=recipe)
    assert all_loads == len(condensed)  # as many as that one load takes
    condensed.clear()
    on_level(series, recipe=recipe, level=3)
    assert sorted(condensed) == ["ball", "race", "race"]  # the race with either true side
    condensed.clear()
    on_level(series, recipe=recipe, level=2, extended=True)
    assert condensed == ["race", "race"]  # no block changes the ball


def test_answers_come_in_the_order_given_and_repeated() -> None:
    loads = [410.0, 3.1, 410.0, 0.02, 3.1]
    series = solve_series(INNER, recipe=IDEAL, level=1, loads=loads)
    assert [part.contact.load for part in series] == loads
    assert series[0].quantities == series[2].quantities
    assert series[1].quantities == series[4].quantities
    assert meshes_of(series) == 3


def test_meshes_scale_from_a_millionth_of_a_newton_to_beyond_a_single_mesh() -> None:
    """The real groove, up to 5000 N, whose ellipse is too wide for a mesh of its own."""
    loads = [1e-6, 4.3e-4, 0.27, 61.0, 2900.0, 5000.0]
    series = solve_series(INNER, recipe=REAL, level=2, loads=loads)
    assert meshes_of(series) == 5
    assert max(map(off_mesh, series)) < 0.35
    for part in series:  # 4 %: the true shape at most 2.5 %, the second level 1.5 %
        np.testing.assert_allclose(part.quantities.approach, hertz_quantities(part.contact).approach, rtol=4e-2)
        along = part.force * -part.pair.normal[2]
        np.testing.assert_allclose(4 * along.sum(), part.contact.load, rtol=1e-10)  # round-off


@pytest.mark.parametrize("loads", [[], [3.0, -2.0], [0.0], [float("nan")], [[3.0, 4.0]], "x"])
def test_an_invalid_series_of_loads_is_refused(loads: object) -> None:
    with pytest.raises(InputError, match="loads must be"):
        solve_series(INNER, recipe=IDEAL, level=1, loads=loads)  # pyright: ignore[reportArgumentType]


def test_a_load_that_no_mesh_holds_is_named() -> None:
    with pytest.raises(InputError, match=r"inner: 90000 N spread the contact"):
        solve_series(INNER, recipe=REAL, level=1, loads=[9e4, 5.0])


def test_a_load_that_reaches_over_the_shoulder_needs_a_mesh_that_ends_there() -> None:
    """5000 N reach 2.05 mm across, too wide for a mesh of their own."""
    with pytest.raises(InputError, match=r"inner: 5000 N spread the contact"):
        solve_series(replace(INNER, shoulder=2.0e-3), recipe=REAL, level=1, loads=[3100.0, 5000.0])


@pytest.mark.parametrize("name", [pytest.param("race", marks=pytest.mark.nightly), "hertzian"])
def test_each_load_is_cut_off_where_its_own_ellipse_reaches_the_shoulder(
    shallow: Callable[[str], Recipe], name: str
) -> None:
    """Loads that would share one mesh without the shoulder, compared with single solutions on both sides of it."""
    contact, recipe = replace(INNER, shoulder=0.8e-3), shallow(name)  # an ellipse of 235 N
    loads = [372.0, 180.0, 260.0, 200.0, 300.0, 340.0]  # two below it and four above: it is not in their middle
    series = solve_series(contact, recipe=recipe, level=2, loads=loads)
    assert [part.shoulder is not None for part in series] == [True, False, True, False, True, True]
    assert meshes_of(series) == 2
    for part in series:
        assert part.pair.footprint.half == (part.semi_axes[1] > contact.shoulder)
    for part in (series[2], series[3]):  # next to the shoulder on either side
        own = fitted_solution(part.contact, recipe=recipe)
        # 0.5 %: 0.3 % off its mesh in 95 of 100, and a cut second level a little more
        np.testing.assert_allclose(part.quantities.approach, own.quantities.approach, rtol=5e-3)


@pytest.mark.slow
def test_the_farther_shoulder_splits_a_band_too(shallow: Callable[[str], Recipe]) -> None:
    contact = replace(INNER, shoulder=0.7e-3, far_shoulder=0.78e-3)
    loads = [120.0, 180.0, 420.0]  # ellipses of 0.64, 0.73 and 0.97 mm
    series = solve_series(contact, recipe=shallow("hertzian"), level=2, loads=loads)
    ends = [tuple(np.isfinite(part.pair.footprint.shoulders)) for part in series]
    assert ends == [(False, False), (False, True), (True, True)]
