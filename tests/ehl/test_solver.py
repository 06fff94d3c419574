"""The grid of a film, its first guess, the way to a solution, and what a solution says of itself."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy import sparse

from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.grid import Grid
from fembearing.ehl.reynolds import Balance
from fembearing.ehl.solver import (
    EASIER,
    EASY,
    INNER,
    LAST,
    ROUGH,
    Discretised,
    NoFilmError,
    Solution,
    Start,
    _Linear,
    require_few_cells,
    solve_on_grids,
)
from tests.ehl.contacts import moes


def on_grid(contact: LubricatedContact, refinement: float = 0.3) -> Discretised:
    return Discretised(contact=contact, refinement=refinement)


# -- the grid --------------------------------------------------------------------------------------------------------


def test_the_inlet_is_where_the_gap_has_grown_by_the_film() -> None:
    """x^2/(2 R_x) is the likely film there; under a thick one the region of the load reaches as far as the inlet."""
    for loading, ellipticity in ((0.7, 0.4), (230.0, 0.17)):
        found = on_grid(moes(loading, 6.0, ellipticity))
        contact = found.contact
        a, b = contact.semi_axes
        film = found.likely_film * contact.film_scale
        x, y = found.inflow * a, found.inflow * a / ellipticity**0.5
        gap = contact.shape.gap(np.array([x, 0.0]), np.array([0.0, y]))
        np.testing.assert_allclose(gap, film, rtol=1e-9)  # of a contact whose axis ratio is found to 1e-15
        np.testing.assert_allclose(np.array(found.half_lengths) * a, np.hypot((a, b), (x, y)), rtol=1e-12)


@pytest.mark.parametrize("ellipticity", [1.0, 0.4])
def test_the_likely_film_of_a_rigid_contact_is_that_of_its_load(ellipticity: float) -> None:
    """H M^2 is 35.35 for a ball on a plane, and for others [3 + 2 lambda]^-2 lambda^-1 times 25 of it."""
    found = on_grid(moes(0.02, 0.0, ellipticity)).likely_film
    assert found * 0.02**2 == pytest.approx(35.35 * 25 / (3 + 2 * ellipticity) ** 2 / ellipticity, rel=0.01)


def sizes(found: Discretised) -> tuple[Array, Array]:
    """Sizes of the cells over those of refinement 1, in half lengths, along x and y."""
    long, wide = found.half_lengths
    return found.grid.widths_x / long * found.refinement, found.grid.widths_y / wide * found.refinement


@pytest.mark.parametrize(("loading", "thickening"), [(900.0, 4.0), (25.0, 5.0), (0.5, 0.0)])
def test_cells_resolve_the_inlet_and_the_edge_and_grow_outside(loading: float, thickening: float) -> None:
    """The inlet of a thin film is as long as its power 2/3, of a thick one 0.35; its cells are half of that."""
    found = on_grid(moes(loading, thickening, 0.5), refinement=6.0)
    long, wide = found.half_lengths
    x, y = found.grid.x / long, found.grid.y / wide
    along, across = sizes(found)
    inlet = min(0.35, (found.likely_film * found.film_scale) ** (2 / 3)) if found.inflow < 1 else 0.35
    near = 0.05  # a cell spans a range of sizes, and their number is rounded
    fine = ((x > -1.2) & (x < -0.8)) | ((x > 0.8) & (x < 1.05))
    np.testing.assert_allclose(along[fine], inlet / 2, rtol=near)
    np.testing.assert_allclose(along[np.abs(x) < 0.35], min(0.75 * inlet, 0.1), rtol=near)
    np.testing.assert_allclose(across[y < 0.55], 0.1, rtol=near)
    np.testing.assert_allclose(across[(y > 0.93) & (y < 1.07)], 0.06, rtol=near)
    ahead = x < -1.3
    np.testing.assert_allclose(along[ahead], inlet / 2 + 0.18 * (-x[ahead] - 1.25), rtol=near)
    aside = y > 1.15
    np.testing.assert_allclose(across[aside], 0.06 + 0.18 * (y[aside] - 1.1), rtol=near)


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
    """Factors on the speed, and last steps, that are asked for; none below `least` has a solution."""
    told = SimpleNamespace(least=1.0, speeds=[], steps=[])

    def settled(_: Discretised, start: Start, *, speed: float, last: float) -> Start | None:
        told.speeds.append(speed)
        told.steps.append(last)
        return start if speed >= told.least else None

    monkeypatch.setattr(Discretised, "settled", settled)
    return told


START: Any = Start(None, np.zeros(1), 0.0)  # pyright: ignore[reportArgumentType]


def test_a_path_leads_to_the_speed_of_the_contact_by_factors(tried: Any) -> None:
    found = on_grid(moes(12.0, 5.0)).path([(40.0, START)], last=LAST)
    assert [speed for speed, _ in found] == [40.0, 40.0 / EASIER, 40.0 / EASIER**2, 1.0]
    assert tried.steps == [ROUGH, ROUGH, ROUGH, LAST]


def test_a_path_takes_the_last_start_that_is_solved(tried: Any) -> None:
    tried.least = 5.0
    found = on_grid(moes(12.0, 5.0)).path([(16.0, START), (8.0, START), (2.0, START), (1.0, START)], last=LAST)
    assert tried.speeds[:3] == [1.0, 2.0, 8.0]
    assert found[0][0] == 8.0
    # Each failure takes the root of the factor: 2 and 4 over 1.1 at least.
    assert 5.0 <= found[-1][0] < 5.0 * 1.2


def test_a_path_without_any_solution_has_none(tried: Any) -> None:
    tried.least = np.inf
    ((speed, _),) = on_grid(moes(12.0, 5.0)).path([(4.0, START), (2.0, START)], last=LAST)
    assert np.isinf(speed)
    assert len(tried.speeds) == 2


def test_no_film_is_an_error_with_the_speed_that_was_reached(tried: Any) -> None:
    tried.least = 2.0
    with pytest.raises(
        NoFilmError, match=r"M 200, L 5, lambda 1 does not converge below 2\.\d+ times its speed"
    ) as stop:
        list(solve_on_grids(moes(200.0, 5.0), (0.2,)))
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
    a = told.contact.semi_axes[0]
    x, y = told.grid.x / a, told.grid.y[0] / a
    expected = 3 - x + 0.2 * x**2 + 5 * y**2 + x * y**2
    assert told.minimum_film == pytest.approx(a * expected[x < 0.75].min(), rel=1e-12)
    ahead = replace(told, pressure=told.pressure[::-1])  # cavitated where the film is thick
    assert ahead.minimum_film == pytest.approx(a * expected.min(), rel=1e-12)


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


# -- linear systems ---------------------------------------------------------------------------------------------------


def system(seed: int, near: Balance | None = None) -> Balance:
    """Slopes of 40 cells in a row with a flow between neighbours; a tenth away from those of another one."""
    random, count = np.random.default_rng(seed), 40
    diagonal = random.uniform(2.0, 5.0, count)
    by_pressure = sparse.diags_array(
        [-random.uniform(0.4, 1.1, count - 1), diagonal, -diagonal[1:] / 5], offsets=[-1, 0, 1]
    )
    by_film = sparse.diags_array(
        [random.uniform(0.2, 0.9, count), random.uniform(-0.6, -0.1, count - 1)], offsets=[0, -1]
    )
    slopes = [sparse.csr_array(by_pressure), sparse.csr_array(by_film)]
    if near is not None:
        slopes = [0.9 * known + 0.1 * own for known, own in zip((near.by_pressure, near.by_film), slopes, strict=True)]
    nothing = np.zeros(0)
    return Balance(random.normal(size=count), *slopes, dissipation=0.0, through=nothing, aside=nothing)


def test_steps_fulfil_the_linear_equations_and_carry_the_load() -> None:
    """At first by a factorisation, then with its help to a thousandth, also where other cells are held."""
    place = np.arange(40)
    elastic = 0.7 / (1 + np.abs(place[:, None] - place))
    random = np.random.default_rng(3)
    areas, linear = random.uniform(0.5, 1.4, 40), _Linear(elastic)
    first = system(4)
    kept = None
    for number, now in enumerate((first, system(5, near=first), system(6, near=first))):
        held = np.isin(place, [3, 11, 30 + number])
        fixed = np.where(held, random.normal(size=40) * (number != 1), 0.0)
        step, lift = linear.step(now, held, fixed, areas, 1.7)
        np.testing.assert_array_equal(step[held], fixed[held])
        left = now.excess + now.by_pressure @ step + now.by_film @ (elastic @ step + lift)
        missing = areas[~held] @ step[~held] - 1.7
        residual, asked = np.append(left[~held], missing), np.append(now.excess, 1.7)
        accuracy = 1e-12 if number == 0 else 10 * INNER  # of a norm without the part of what is fixed
        assert np.linalg.norm(residual) < accuracy * np.linalg.norm(asked)
        assert kept is None or linear.factors is kept  # the first factorisation still helps
        kept = linear.factors


@pytest.mark.parametrize("speed", [1.0, 3.0])
def test_a_balance_has_the_slopes_of_its_excess(speed: float) -> None:
    """Along one direction of pressure and one of film, of compressible oil that thickens."""
    place = on_grid(moes(30.0, 6.0, 0.5), refinement=0.3)
    random = np.random.default_rng(9)
    count = place.grid.areas.size
    pressure, film = random.uniform(0.1, 0.3, count), random.uniform(0.3, 0.5, count)
    along, step = random.normal(size=count), 1e-6
    now = place.balanced(pressure, film, speed)
    for slope, by_pressure in ((now.by_pressure, 1), (now.by_film, 0)):
        there, back = (
            place.balanced(pressure + by_pressure * move, film + (1 - by_pressure) * move, speed).excess
            for move in (step * along, -step * along)
        )
        expected = (there - back) / (2 * step)
        # Round-off of the excess, 1e-16 over the step.
        np.testing.assert_allclose(slope @ along, expected, atol=1e-7 * np.abs(expected).max())
