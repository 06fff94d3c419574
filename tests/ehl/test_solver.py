"""The grid of a film, its first guess, the way to a solution, and what a solution says of itself."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.grid import Grid
from fembearing.ehl.solver import EASY, Discretised, NoFilmError, Solution, Start, require_few_cells, solve_on_grids
from tests.ehl.contacts import moes


def on_grid(contact: LubricatedContact, refinement: float = 0.3) -> Discretised:
    return Discretised(contact=contact, refinement=refinement)


# -- the grid --------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("ellipticity", [1.0, 0.4])
def test_the_likely_film_of_a_rigid_contact_is_that_of_its_load(ellipticity: float) -> None:
    """H M^2 is 35.35 for a ball on a plane, and for others [3 + 2 lambda]^-2 lambda^-1 times 25 of it."""
    found = on_grid(moes(0.02, 0.0, ellipticity)).likely_film
    assert found * 0.02**2 == pytest.approx(35.35 * 25 / (3 + 2 * ellipticity) ** 2 / ellipticity, rel=0.01)


def test_the_grid_ends_with_the_oil_and_soon_behind_cavitated_oil() -> None:
    contact = moes(31.0, 6.0, 0.4)
    a, b = contact.semi_axes
    contact = replace(contact, reach=Reach(ahead=5.1 * a, behind=6.2 * a, side=1.9 * b))
    for pressure, end in ((0.0, 2.5 * on_grid(contact).half_lengths[0]), (-1e5, 6.2)):
        tense = replace(contact, oil=replace(contact.oil, cavitation_pressure=pressure))
        grid = on_grid(tense).grid
        np.testing.assert_allclose(grid.x_faces[[0, -1]], (-5.1, end), rtol=1e-12)
        np.testing.assert_allclose(grid.y_faces[[0, -1]] * a, (0.0, 1.9 * b), rtol=1e-12, atol=1e-18)
    short = replace(contact, reach=replace(contact.reach, behind=1.7 * a))
    assert on_grid(short).grid.x_faces[-1] == pytest.approx(1.7)


def test_cells_are_counted_without_the_grid() -> None:
    found = on_grid(moes(31.0, 6.0, 0.4), refinement=0.7)
    assert found.cell_count == found.grid.areas.size
    require_few_cells(found.contact, 0.7)


# -- starts ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("speed", [1.0, 7.0])
def test_the_first_guess_carries_the_load_over_a_film(speed: float) -> None:
    place = on_grid(moes(12.0, 5.0, 0.4), refinement=0.8)
    contact, found = place.contact, place.first_guess(speed)
    a, _ = contact.semi_axes
    load = 2 * contact.peak_pressure * a**2 * float((found.pressure * place.grid.areas).sum())
    assert load == pytest.approx(contact.load, rel=0.01)  # cells of a tenth
    film = found.approach + place.gap + place.elastic @ found.pressure.ravel()
    faster = replace(contact, speed=speed * contact.speed)  # the film in a^2/R_x
    likely = on_grid(faster).likely_film * faster.film_scale * contact.shape.radii[0] / a**2
    assert film.min() == pytest.approx(likely, rel=1e-9)


def test_pressure_is_carried_to_another_grid() -> None:
    """Hertz's, whose square is a parabola, and a tension beside it."""
    place, finer = (on_grid(moes(60.0, 5.0, 0.4), refinement) for refinement in (3.1, 4.3))
    b = place.contact.semi_axes[1] / place.contact.semi_axes[0]

    def pressure(grid: Grid) -> Array:
        square = 1 - grid.x[:, None] ** 2 - (grid.y[None, :] / b) ** 2
        return np.asarray(np.sqrt(np.maximum(square, 0.0)) - 0.04 * ((square < 0) & (square > -1)), dtype=float)

    found = finer.carried(Start(place.grid, pressure(place.grid), -0.37))
    assert found.approach == -0.37
    inside = finer.grid.x[:, None] ** 2 + (finer.grid.y[None, :] / b) ** 2
    np.testing.assert_allclose(found.pressure[inside < 0.8], pressure(finer.grid)[inside < 0.8], atol=4e-3)
    beside = (inside > 1.5) & (inside < 1.7)
    np.testing.assert_allclose(found.pressure[beside], -0.04, atol=1e-3)


# -- the way to a solution --------------------------------------------------------------------------------------------


@pytest.fixture
def tried(monkeypatch: pytest.MonkeyPatch) -> Any:
    """No factor on the speed below `least` has a solution."""
    told = SimpleNamespace(least=1.0)

    def settled(_: Discretised, start: Start, *, speed: float, **_rest: Any) -> Start | None:
        return start if speed >= told.least else None

    monkeypatch.setattr(Discretised, "settled", settled)
    return told


def test_no_film_is_an_error_with_the_speed_that_was_reached(tried: Any) -> None:
    tried.least = 2.0
    with pytest.raises(
        NoFilmError, match=r"M 200, L 5, lambda 1 does not converge below 2\.\d+ times its speed"
    ) as stop:
        list(solve_on_grids(moes(200.0, 5.0), 0.2))
    assert 2 <= stop.value.residual < 2.4
    assert str(stop.value).endswith("give more speed or less load")


@pytest.mark.parametrize(
    ("loading", "remedy"), [(0.9 * EASY, "less speed or more"), (1.1 * EASY, "more speed or less")]
)
def test_a_contact_without_film_gets_the_remedy_of_its_side(loading: float, remedy: str) -> None:
    words = str(NoFilmError(moes(loading, 5.0), reached=np.inf))
    assert "does not converge at its speed or above: give " + remedy in words


# -- what a solution says --------------------------------------------------------------------------------------------


@pytest.fixture(scope="module")
def told() -> Solution:
    """A film (3 - x + x^2/5 + 5 y^2 + x y^2) a and a pressure with cavitated oil behind, on cells of unequal size."""
    contact = moes(31.0, 6.0, 0.4)
    a, _ = contact.semi_axes
    grid = Grid(x_faces=a * np.linspace(-1.9, 1.3, 41), y_faces=a * np.array([0.0, 0.2, 0.5, 0.9, 1.4]))
    x, y = grid.x[:, None] / a, grid.y[None, :] / a
    film = (3 - x + 0.2 * x**2 + 5 * y**2 + x * y**2) * a
    pressure = np.where(x < 0.75, 2e8 * (0.75 - x) * (2 + y), 0.0)
    balance: Any = SimpleNamespace(dissipation=0.37)
    return Solution(contact=contact, grid=grid, pressure=pressure, film=film, balance=balance)


def test_the_central_film_is_read_between_cells(told: Solution) -> None:
    """At x = y = 0, where no cell has its centre; even in y."""
    assert told.central_film == pytest.approx(3 * told.contact.semi_axes[0], rel=1e-6)  # a spline on a parabola


def test_the_least_film_is_one_under_pressure(told: Solution) -> None:
    """Between cells: at x = 0.43 and y = 0, and not in the cavitated oil behind, where another dip is deeper."""
    a = told.contact.semi_axes[0]
    x, y = told.grid.x[:, None] / a, told.grid.y[None, :] / a
    film = 2 - 0.3 * np.cos(2 * np.pi * (x - 0.43) / 0.77) - 0.2 * np.exp(-(((x - 1.2) / 0.2) ** 2)) + 0.3 * y**2
    dipped = replace(told, film=a * film)
    # A wave has ten cells, on which a spline leaves 1e-3.
    assert dipped.minimum_film == pytest.approx(1.7 * a, rel=2e-3)
    filled = replace(dipped, pressure=np.where(x > 1.0, 1e6, 0.0) + 0 * y)
    assert filled.minimum_film == pytest.approx(1.5 * a, rel=2e-3)


def test_forces_and_the_centre_are_integrals_over_both_halves(told: Solution) -> None:
    a, radius = told.contact.semi_axes[0], told.contact.shape.radii[0]
    x, y = told.grid.x[:, None], told.grid.y[None, :]
    areas = np.diff(told.grid.x_faces)[:, None] * np.diff(told.grid.y_faces)
    whole = 2 * np.sum(told.pressure * (x / radius) * areas)
    assert told.rolling_force == pytest.approx(-whole / 2, rel=1e-12)
    assert told.pressure_centre == pytest.approx(-np.average(x + 0 * y, weights=told.pressure * areas), rel=1e-12)
    # mass flows times pressure are in u a (a^2/R_x) p0 on the half domain; the power over 2 u, twice
    unit = a * a**2 / radius * told.contact.peak_pressure
    assert told.dissipated_force == pytest.approx(0.37 * unit, rel=1e-12)
