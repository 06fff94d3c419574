"""Pressure and film of a lubricated contact on one grid, by a semismooth Newton method that is fully coupled.

Unknown are the pressure of each cell and the approach of the bodies. A cell whose pressure would fall below that of
cavitation keeps it, and there the oil only has to leave. The load is one more equation. Lengths are in Hertz's
semi-axis a, pressures in his p0 and films in a^2/R_x.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import count
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.interpolate import PchipInterpolator, RectBivariateSpline
from scipy.linalg import lu_factor, lu_solve
from scipy.sparse.linalg import LinearOperator, gmres

from analytic.errors import ConvergenceError, FembearingError, InputError
from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact
from fembearing.ehl.elastic import half_space_integrals
from fembearing.ehl.grid import Grid, graded_faces, usual_cells
from fembearing.ehl.reynolds import Balance, Fluid, balance

# Cells at refinement 1, in units of the contact's half lengths; smaller at the inlet and outlet where the film is thin
INLET, MIDDLE, EDGE, ACROSS = 0.5, 1.5, 0.06, 0.1  # the first is a share of the inlet's length, the second of the first
GROWTH = 0.18  # of the size of cells over the distance outside
WIDEST_INLET = 0.35  # of the half length
CUT = 2.5  # half lengths behind the centre where cavitated oil is left out
LAST, ROUGH = 1e-4, 1e-2  # largest step of pressure over the largest pressure: of a solution, and on the way to it
STEPS = 30  # of Newton's method; 4 to 8 are usual
LEAST_GAP = 0.2  # share of the film that a step leaves
EASY = 20.0  # M of the contact at which a solution starts
RATIO = 1.5  # of the cells of two grids
WHOLE = 4  # divides the number of cells along each direction of the first grid: the next two have exactly the ratio
EASIER, LEAST_EASIER = 4.0, 1.1  # factor on the speed between two steps towards the contact, and the least one tried
INNER = 1e-3  # residual of the linear system where an older factorisation solves it
MOST_INNER = 25  # steps for that, after which a new factorisation is cheaper
AROUND = 81  # points of a spline of the film across three cells
LEAST_BETWEEN = 0.5  # of the least film of a cell: on coarse cells the spline falls below 0
MOST_CELLS = 10_000  # of a grid: matrices are full, with up to 24 bytes for each pair of cells, 2.4 GB


class NoFilmError(ConvergenceError):
    """A regime in which Newton's method does not converge on a grid."""

    def __init__(self, contact: LubricatedContact, *, reached: float) -> None:
        """reached : the least factor on the speed of the contact at which it converges; inf: none"""
        self.iterations, self.residual, self.tolerance = STEPS, reached, 1.0
        where = f"below {reached:.3g} times its speed" if np.isfinite(reached) else "at its speed or above"
        remedy = "less speed or more load" if contact.loading < EASY else "more speed or less load"
        FembearingError.__init__(
            self, f"the numerical film of {regime_words(contact)} does not converge {where}: give {remedy}"
        )


class Start(NamedTuple):
    """What a solution starts from."""

    grid: Grid
    pressure: Array  # (columns, rows), in p0
    approach: float  # of the bodies, negative where they overlap, in a^2/R_x


@dataclass(frozen=True, kw_only=True, eq=False)
class Solution:
    """A contact on one grid, SI."""

    contact: LubricatedContact
    grid: Grid  # in m
    pressure: Array  # (columns, rows), Pa
    film: Array  # (columns, rows), m
    balance: Balance  # mass in units of u a a^2/R_x

    @property
    def central_film(self) -> float:
        """In the centre, m."""
        return self._film_at(0.0, 0.0).item()

    @property
    def minimum_film(self) -> float:
        """The least near the cell of least film where the oil is not cavitated, m."""
        oil = self.pressure > self.contact.oil.cavitation_pressure
        column, row = np.unravel_index(np.where(oil, self.film, np.inf).argmin(), oil.shape)
        least = LEAST_BETWEEN * float(self.film[column, row])
        around = np.linspace(-1, 1, AROUND)
        x = np.interp(column + around, np.arange(self.grid.x.size), self.grid.x)
        y = np.interp(row + around, np.arange(-1, self.grid.y.size), np.append(-self.grid.y[0], self.grid.y))
        return max(float(self._film_at(x, y).min()), least)

    @cached_property
    def _film_at(self) -> RectBivariateSpline:
        """The film, m, between cells, at x and at y, both ascending."""
        film = np.concatenate([self.film[:, ::-1], self.film], axis=1)
        return RectBivariateSpline(self.grid.x, np.concatenate([-self.grid.y[::-1], self.grid.y]), film)

    @property
    def rolling_force(self) -> float:
        """F1 = -1/2 of the integral of p d(gap)/dx, on each surface against its motion, N; half is solved."""
        slope = self.contact.shape.slope(self.grid.x[:, None], self.grid.y[None, :])
        # The other half of the domain doubles the sum.
        return -float((self.pressure * slope * self.grid.areas).sum())

    @property
    def dissipated_force(self) -> float:
        """F3: the power that pressure flow turns into heat, over 2 u, N. Without error it is the rolling force."""
        a, _ = self.contact.semi_axes
        return self.balance.dissipation * a**3 / self.contact.shape.radii[0] * self.contact.peak_pressure

    @property
    def pressure_centre(self) -> float:
        """How far the centre of pressure lies ahead of the contact's centre, m."""
        force = self.pressure * self.grid.areas
        return -float((force * self.grid.x[:, None]).sum() / force.sum())


def solve_on_grids(contact: LubricatedContact, refinement: float) -> Iterator[Solution]:
    """The solution on each grid, coarse to fine, as far as the memory goes.

    refinement : of the first grid
    The first start is an easy contact, at a higher speed and of thinner oil under pressure, on a coarser grid still.
    Raises ConvergenceError, which names the regime, where Newton's method does not settle.
    """
    first = Discretised(contact=contact, refinement=refinement, level=-1)
    factor = max((contact.loading / EASY) ** (4 / 3), 1.0)
    path = first.path([(factor, first.first_guess(factor))], last=ROUGH)
    for level in count():
        place = Discretised(contact=contact, refinement=refinement, level=level)
        if place.cell_count > MOST_CELLS:
            return
        path = place.path([(speed, place.carried(start)) for speed, start in path], last=LAST)
        speed, start = path[-1]
        if speed > 1.0:
            raise NoFilmError(contact, reached=speed)
        yield place.solution(start)


def regime_words(contact: LubricatedContact) -> str:
    """Moes's numbers in words."""
    return f"M {contact.loading:.3g}, L {contact.thickening:.3g}, lambda {contact.ellipticity:.3g}"


def require_few_cells(contact: LubricatedContact, refinement: float) -> None:
    """Raise InputError where a film is so thin that a grid of this refinement has more than `MOST_CELLS`."""
    cells = Discretised(contact=contact, refinement=refinement).cell_count
    if cells > MOST_CELLS:
        raise InputError(
            f"the film of {regime_words(contact)} is too thin against its contact for the numerical solution, which "
            f"would take {cells:.3g} cells, above {MOST_CELLS:g}: give more speed or less load"
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class Discretised:
    """A contact on one grid, in scaled units."""

    contact: LubricatedContact
    refinement: float  # of the first grid
    level: int = 0  # finer by so many ratios

    @cached_property
    def likely_film(self) -> float:
        """Moes's H within a factor of about two, which sets the size of cells and the first guess.

        The first part is that of a rigid point contact, whose load is known in closed form but for a number.
        """
        contact = self.contact
        slim = (3 + 2 * contact.ellipticity) ** 2 * contact.ellipticity
        return 880 / (slim * contact.loading**2) + 1 + 0.3 * contact.thickening**0.75

    @cached_property
    def inflow(self) -> float:
        """Distance from the centre where the gap has grown by the likely film."""
        return float(2 * self.likely_film * self.film_scale) ** 0.5

    @cached_property
    def half_lengths(self) -> tuple[float, float]:
        """Of the region that carries the load, along x and y: Hertz's ellipse, or more under a thick film."""
        a, b = self.contact.semi_axes
        return float(np.hypot(1, self.inflow)), float(np.hypot(b / a, self.inflow / self.contact.ellipticity**0.5))

    @cached_property
    def grid(self) -> Grid:
        """In semi-axes a."""
        (x, y), (long, wide) = self._places, self.half_lengths
        nx, ny = (number / usual_cells(*each) for number, each in zip(self._counts, self._places, strict=True))
        return Grid(x_faces=graded_faces(*x, refinement=nx) * long, y_faces=graded_faces(*y, refinement=ny) * wide)

    @property
    def cell_count(self) -> int:
        """Of the grid, without making it."""
        return math.prod(self._counts)

    @property
    def _counts(self) -> tuple[int, int]:
        """Columns and rows."""
        first = (max(round(self.refinement * usual_cells(*each) / WHOLE), 1) * WHOLE for each in self._places)
        columns, rows = (round(each * RATIO**self.level) for each in first)
        return columns, rows

    @property
    def _places(self) -> tuple[tuple[list[float], list[float]], tuple[list[float], list[float]]]:
        """Places along x and y, each with the sizes of cells there, in half lengths."""
        contact = self.contact
        a, _ = contact.semi_axes
        long, wide = self.half_lengths
        thin = self.likely_film * self.film_scale
        inlet = min(WIDEST_INLET, thin ** (2 / 3)) if self.inflow < 1 else WIDEST_INLET
        fine, middle = INLET * inlet, min(MIDDLE * INLET * inlet, ACROSS)
        reach = contact.reach
        ahead, side = reach.ahead / a / long, reach.side / a / wide
        behind = reach.behind / a / long
        if contact.oil.cavitation_pressure == 0.0:
            behind = min(behind, CUT)
        places = [-1.25, -0.75, -0.4, 0.5, 0.75, 1.08]
        sizes = [fine, fine, middle, middle, fine, fine]
        y = _within([0.0, 0.6, 0.9, 1.1], [ACROSS, ACROSS, EDGE, EDGE], 0.0, side)
        return _within(places, sizes, -ahead, behind), y

    @cached_property
    def elastic(self) -> Array:
        """(n, n) film per pressure of each cell."""
        contact, grid = self.contact, self.grid
        a, _ = contact.semi_axes
        found = half_space_integrals(grid.x, grid.y, grid.x_faces, grid.y_faces)
        found *= contact.peak_pressure * contact.shape.radii[0] / (np.pi * contact.modulus * a)
        if contact.added is not None:
            x, y = (a * part.ravel() for part in np.meshgrid(grid.x, grid.y, indexing="ij"))
            scale = contact.peak_pressure * contact.shape.radii[0] * grid.areas.ravel()
            for side in (1, -1):  # a cell and its mirror image
                found += contact.added.normal_influence((x, y), (x, side * y)) * scale
        return found

    @cached_property
    def gap(self) -> Array:
        """(n,) of the undeformed bodies."""
        return self._gap(self.grid.x[:, None], self.grid.y[None, :]).ravel()

    def _gap(self, x: Array, y: Array) -> Array:
        a, _ = self.contact.semi_axes
        return self.contact.shape.gap(x * a, y * a) * self.contact.shape.radii[0] / a**2

    @cached_property
    def gap_beyond(self) -> tuple[Array, Array, Array]:
        """By how much the gap on the ends and on the far side exceeds that of the next cells."""
        grid = self.grid
        gap = self.gap.reshape(grid.shape)
        return (
            self._gap(grid.x_faces[0], grid.y) - gap[0],
            self._gap(grid.x_faces[-1], grid.y) - gap[-1],
            self._gap(grid.x, grid.y_faces[-1]) - gap[:, -1],
        )

    @cached_property
    def epsilon(self) -> float:
        """Of Reynolds's equation, at the speed of the contact."""
        contact = self.contact
        a, _ = contact.semi_axes
        unit = a**2 / contact.shape.radii[0]
        return float(unit**2 * contact.peak_pressure / (12 * contact.oil.viscosity * contact.speed * a))

    @property
    def film_scale(self) -> float:
        """Moes's unit of films."""
        a, _ = self.contact.semi_axes
        return float(self.contact.film_scale * self.contact.shape.radii[0] / a**2)

    def first_guess(self, speed: float) -> Start:
        """The pressure of a semi-ellipsoid under the load, and a likely film, at `speed` times the contact's."""
        a, b = self.contact.semi_axes
        long, wide = self.half_lengths
        x, y = self.grid.x[:, None] / long, self.grid.y[None, :] / wide
        pressure = b / a / (long * wide) * np.sqrt(np.maximum(1 - x**2 - y**2, 0.0))
        easy = replace(self.contact, speed=self.contact.speed * speed)
        film = Discretised(contact=easy, refinement=self.refinement).likely_film * self.film_scale * speed**0.5
        return Start(self.grid, pressure, film - float((self.elastic @ pressure.ravel() + self.gap).min()))

    def carried(self, start: Start) -> Start:
        """The pressure on this grid from that on another one of the same region."""
        old = start.grid
        x = np.concatenate([old.x_faces[:1], old.x, old.x_faces[-1:]])
        y = np.concatenate([-old.y[1::-1], old.y, old.y_faces[-1:]])
        square = start.pressure * np.abs(start.pressure)  # Hertz's is a parabola, without the steep edge
        padded = np.pad(np.column_stack([square[:, 1::-1], square]), ((1, 1), (0, 1)))
        across = PchipInterpolator(y, padded, axis=1)(self.grid.y)
        found = PchipInterpolator(x, across, axis=0)(self.grid.x)
        return Start(self.grid, np.sign(found) * np.sqrt(np.abs(found)), start.approach)

    def _fluid(self, pressure: Array, film: Array, speed: float) -> Fluid:
        """speed : times the contact's; oil thickens by the power -1/4 of it, so that Moes's L stays."""
        oil, unit = self.contact.oil, self.contact.peak_pressure
        log_viscosity, thickening = oil.log_viscosity(pressure * unit, share=speed**-0.25)
        density, stiffening = oil.density(pressure * unit)
        parts = pressure, film, log_viscosity, thickening * unit, density, stiffening * unit
        return Fluid(*(part.reshape(self.grid.shape) for part in parts))

    def balanced(self, pressure: Array, film: Array, speed: float) -> Balance:
        """Reynolds's equation at pressure and film, (n,)."""
        return balance(
            self._fluid(pressure, film, speed), grid=self.grid, gap=self.gap_beyond, epsilon=self.epsilon / speed
        )

    def path(self, starts: list[tuple[float, Start]], *, last: float) -> list[tuple[float, Start]]:
        """Solutions with the factors on the speed to which they belong, towards 1, as far as this grid holds a film.

        starts : factors and what may lie near their solutions. The last that leads to a solution is taken.
        last : of `settled`, at the speed of the contact
        """
        found: list[tuple[float, Start]] = []
        starts, ratio = [*starts], EASIER
        while ratio > LEAST_EASIER and (found or starts):
            speed, start = (max(found[-1][0] / ratio, 1.0), found[-1][1]) if found else starts.pop()
            solution = self.settled(start, speed=speed, last=last if speed == 1.0 else ROUGH)
            if solution is not None:
                found.append((speed, solution))
                if speed == 1.0:
                    break
            elif found:
                ratio **= 0.5
        return found or [(np.inf, self.first_guess(1.0))]

    def settled(self, start: Start, *, speed: float, last: float) -> Start | None:
        """The solution at `speed` times the contact's, or None where there is none in reach.

        last : largest step of pressure that ends the search, over the largest pressure
        """
        least = self.contact.oil.cavitation_pressure / self.contact.peak_pressure
        areas, half_load = self.grid.areas.ravel(), np.pi / 3 * self.contact.semi_axes[1] / self.contact.semi_axes[0]
        pressure, approach = np.maximum(start.pressure.ravel(), least), start.approach
        solver = _Linear(self.elastic, areas)
        film = approach + self.gap + self.elastic @ pressure
        for _ in range(STEPS):
            now = self.balanced(pressure, np.maximum(film, 1e-2 * self.film_scale), speed)
            diagonal = now.by_pressure.diagonal() + now.by_film.diagonal() * self.elastic.diagonal()
            held = pressure - least < now.excess / np.abs(diagonal)
            fixed = np.where(held, least - pressure, 0.0)
            step, lift = solver.step(now, held, fixed, half_load - float(areas @ pressure))
            change = self.elastic @ step + lift
            if not np.isfinite(change).all():
                return None
            closing = float((-change / np.maximum(film, 1e-2 * self.film_scale)).max())
            share = min(1.0, max((1 - LEAST_GAP) / max(closing, 1e-9), 0.1))
            pressure, approach = np.maximum(pressure + share * step, least), approach + share * lift
            film = approach + self.gap + self.elastic @ pressure
            if share == 1.0 and np.abs(step).max() < last * pressure.max():
                return Start(self.grid, pressure.reshape(self.grid.shape), approach)
        return None

    def solution(self, found: Start) -> Solution:
        """In SI units."""
        contact = self.contact
        a, _ = contact.semi_axes
        pressure = found.pressure.ravel()
        film = found.approach + self.gap + self.elastic @ pressure
        return Solution(
            contact=contact,
            grid=Grid(x_faces=self.grid.x_faces * a, y_faces=self.grid.y_faces * a),
            pressure=found.pressure * contact.peak_pressure,
            film=film.reshape(self.grid.shape) * a**2 / contact.shape.radii[0],
            balance=self.balanced(pressure, film, 1.0),
        )


class _Linear:
    """Newton's linear systems on one grid, by GMRES with the factors of an earlier one; matrices in single precision.

    The unknowns are the step of pressure in each cell and that of the approach.
    """

    def __init__(self, elastic: Array, areas: Array) -> None:
        self.elastic, self.areas = elastic.astype(np.float32), areas
        self.factors: tuple[NDArray[np.float32], NDArray[np.int32]] | None = None
        self.known = np.zeros(0, dtype=np.intp)  # unknowns of the factorised system

    def step(self, now: Balance, held: NDArray[np.bool_], fixed: Array, missing: float) -> tuple[Array, float]:
        """The step of pressure, (n,), and that of the approach.

        held : cells that take the step `fixed`;  missing : load on the half domain
        """
        scale = np.append(np.where(held, 1.0, now.by_pressure.diagonal()), 1.0)

        def product(vector: Array) -> Array:
            step = vector[:-1]
            leaving = now.by_pressure @ step + now.by_film @ (self.elastic @ step.astype(np.float32) + vector[-1])
            return np.append(np.where(held, step, leaving), self.areas @ step)

        def likely(vector: Array) -> Array:
            found = vector / scale
            found[self.known] = lu_solve(self.factors, vector[self.known].astype(np.float32), check_finite=False)
            found[:-1][held] = vector[:-1][held]
            return found

        start = np.append(fixed, 0.0)
        rest = np.append(np.where(held, fixed, -now.excess), missing) - product(start)
        # The factors stand on the right, so that the residual of the system itself is small.
        operator = LinearOperator((rest.size, rest.size), lambda vector: product(likely(vector)), dtype=float)
        solved = partial(gmres, operator, rest, rtol=INNER, restart=MOST_INNER, maxiter=1)
        found, failed = solved() if self.factors else (rest, 1)
        if failed:
            self._factorise(now, np.flatnonzero(~held))
            found, _ = solved()
        step = start + likely(found)
        return step[:-1], float(step[-1])

    def _factorise(self, now: Balance, free: NDArray[np.intp]) -> None:
        matrix = np.empty((free.size + 1, free.size + 1), dtype=np.float32, order="F")
        by_film = now.by_film[free]
        matrix[:-1, :-1] = by_film.astype(np.float32) @ self.elastic[:, free]
        coordinates = now.by_pressure[free][:, free].tocoo()
        matrix[coordinates.coords] += coordinates.data
        matrix[:-1, -1], matrix[-1, :-1], matrix[-1, -1] = by_film.sum(axis=1), self.areas[free], 0.0
        self.factors = lu_factor(matrix, overwrite_a=True, check_finite=False)
        self.known = np.append(free, now.excess.size)


def _within(places: list[float], sizes: list[float], start: float, end: float) -> tuple[list[float], list[float]]:
    """The places between start and end, with both ends, and the sizes of cells there, which grow beyond the places."""
    size = [
        sizes[0] + GROWTH * (places[0] - start) if start < places[0] else float(np.interp(start, places, sizes)),
        *(each for place, each in zip(places, sizes, strict=True) if start < place < end),
        sizes[-1] + GROWTH * (end - places[-1]) if end > places[-1] else float(np.interp(end, places, sizes)),
    ]
    return [start, *(place for place in places if start < place < end), end], size
