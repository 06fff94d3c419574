import mpmath
import numpy as np
import pytest

from analytic.scene import Array
from fembearing.ehl.grid import Grid, graded_faces
from fembearing.ehl.reynolds import Balance, Fluid, balance, logarithmic_mean

GRID = Grid(
    x_faces=graded_faces([-3.1, -0.9, 1.3], [0.7, 0.3, 0.35], refinement=0.8),
    y_faces=graded_faces([0.0, 1.1, 2.9], [0.31, 0.33, 0.7], refinement=0.9),
)


def oil(pressure: Array, film: Array) -> Fluid:
    """A piezoviscous and compressible one, with made-up constants."""
    return Fluid(
        pressure, film, 2.3 * pressure, np.full_like(pressure, 2.3), 1 + 0.21 * pressure, np.full_like(pressure, 0.21)
    )


def gap(x: Array, y: Array) -> Array:
    return 0.4 + 0.3 * x**2 + 0.17 * y**2


def at(pressure: Array, film: Array) -> Balance:
    x, y = GRID.x, GRID.y
    ends = (
        gap(GRID.x_faces[0], y) - gap(x[0], y),
        gap(GRID.x_faces[-1], y) - gap(x[-1], y),
        gap(x, GRID.y_faces[-1]) - gap(x, y[-1]),
    )
    return balance(oil(pressure, film), grid=GRID, gap=ends, epsilon=0.37)


@pytest.fixture
def state() -> tuple[Array, Array]:
    random = np.random.default_rng(5)
    film = gap(GRID.x[:, None], GRID.y[None, :])
    return random.uniform(0.0, 1.9, GRID.shape), film * random.uniform(0.9, 1.2, GRID.shape)


@pytest.mark.parametrize(("left", "right"), [(-0.3, 2.1), (-17.0, -2.5), (0.7, 0.7), (1.3, 1.3 + 3e-5), (2.0, 1.9998)])
def test_logarithmic_mean_and_slopes_against_many_digits(left: float, right: float) -> None:
    def mean(first: mpmath.mpf, second: mpmath.mpf) -> mpmath.mpf:
        return mpmath.quad(lambda share: mpmath.exp(first + share * (second - first)), [0, 1])

    with mpmath.workdps(40):
        exact = [mean(mpmath.mpf(left), mpmath.mpf(right))]
        exact += [mpmath.diff(lambda v: mean(v, mpmath.mpf(right)), left)]
        exact += [mpmath.diff(lambda v: mean(mpmath.mpf(left), v), right)]
    found = logarithmic_mean(np.array([left]), np.array([right]))
    # The series beside equal values leaves 1e-9; elsewhere the difference of exponentials loses four digits.
    np.testing.assert_allclose([float(each[0]) for each in found], [float(each) for each in exact], rtol=2e-8)


def test_slopes_are_those_of_differences(state: tuple[Array, Array]) -> None:
    pressure, film = state
    known, step = at(pressure, film), 1e-6
    for slopes, moved in ((known.by_pressure, 0), (known.by_film, 1)):
        for cell in (0, 7, GRID.areas.size // 2, GRID.areas.size - 1):
            change = np.zeros(GRID.areas.size)
            change[cell] = step
            there = [each + change.reshape(GRID.shape) * (number == moved) for number, each in enumerate(state)]
            back = [each - change.reshape(GRID.shape) * (number == moved) for number, each in enumerate(state)]
            difference = (at(*there).excess - at(*back).excess) / (2 * step)
            column = slopes.toarray()[:, cell]
            # Central differences of step 1e-6 leave some 1e-9 of the largest slope.
            np.testing.assert_allclose(column, difference, atol=1e-7 * np.abs(column).max())


def test_mass_that_enters_leaves_or_stays_in_the_excess(state: tuple[Array, Array]) -> None:
    found = at(*state)
    for column in range(GRID.shape[0]):
        gained = found.excess.reshape(GRID.shape)[column].sum()
        balance_ = found.through[column + 1] - found.through[column] + found.aside[column]
        assert gained == pytest.approx(balance_, abs=1e-12 * np.abs(found.through).max())  # round-off


def test_a_converging_gap_asks_for_pressure_and_a_diverging_one_does_not() -> None:
    """The sign of the wedge: without pressure a cell where the gap closes along +x has too much oil."""
    nothing = np.zeros(GRID.shape)
    excess = at(nothing, gap(GRID.x[:, None], GRID.y[None, :])).excess.reshape(GRID.shape)
    assert (excess[GRID.x < -0.5] < 0).all()
    assert (excess[GRID.x > 0.9] > 0).all()


def test_the_equation_has_second_order() -> None:
    """Of p = (1 - x^2)(1 - y^2) over a linear gap, by refinement: the excess over the area tends to the exact one."""
    errors = []
    for cells in (12, 24, 48):
        grid = Grid(x_faces=np.linspace(-1, 1, cells + 1), y_faces=np.linspace(0, 1, cells + 1))
        x, y = np.broadcast_arrays(grid.x[:, None], grid.y[None, :])
        slope, top = 0.2, 1.3
        film, pressure = top - slope * x, (1 - x**2) * (1 - y**2)
        one, none = np.ones_like(x), np.zeros_like(x)
        ends = np.full(cells, slope / cells), np.full(cells, -slope / cells), np.zeros(cells)
        found = balance(Fluid(pressure, film, none, none, one, none), grid=grid, gap=ends, epsilon=0.7)
        # R = -slope - epsilon d/dx(h^3 dp/dx) - epsilon h^3 d2p/dy2
        along = -2 * (1 - y**2) * film**3 + 3 * film**2 * -slope * (-2 * x * (1 - y**2))
        exact = -slope - 0.7 * (along - 2 * (1 - x**2) * film**3)
        inner = (slice(3, -3), slice(0, -3))  # beside the ends the distance halves, which costs an order locally
        errors.append(np.abs(found.excess.reshape(grid.shape) / grid.areas - exact)[inner].max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert (orders > 1.8).all(), orders
