"""Reynolds's equation on a tensor grid: what each cell loses, and how that depends on pressure and film.

    R = d(rho h)/dx - d/dx(e dp/dx) - d/dy(e dp/dy) = 0  where  p > p_cav,  R >= 0 elsewhere,   e = epsilon rho h^3/eta

Finite volumes. The surfaces carry rho h from upstream with second order, and 1/eta on a face is the logarithmic mean of
both cells: by Barus's law that is its mean over the pressures between them, and the flux is monotone in both. With the
viscosity of the mean pressure, errors of the force do not fall steadily with the cells. Roots of the film are
interpolated, not the film: that is exact on a parabola, where cells are large.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array

from analytic.scene import Array
from fembearing.ehl.grid import Grid

NEAR = 1e-4  # difference of logarithms below which their mean is a series, whose error is 1e-9 then
Sides = tuple[Array, Array]  # of each face: the lower and the upper one


class Fluid(NamedTuple):
    """Oil and film in each cell, (columns, rows), with slopes by pressure, in one set of units."""

    pressure: Array
    film: Array
    log_viscosity: Array  # ln(eta/eta_0)
    thickening: Array  # its slope
    density: Array  # over that at ambient pressure
    stiffening: Array  # its slope


class Flow(NamedTuple):
    """The flow of mass by pressure through faces, towards the upper side, with its slopes."""

    mass: Array
    by_pressure: Sides
    by_film: Sides
    dissipation: Array  # mass times the drop of pressure, over the density


class Balance(NamedTuple):
    """The equation at one pressure and film; cells are counted along y first."""

    excess: Array  # (n,) R times the area of the cell: what leaves it less what enters
    by_pressure: csr_array  # (n, n) slope at a given film
    by_film: csr_array  # (n, n) slope at a given pressure
    dissipation: float  # of the flow by pressure, on the half domain
    through: Array  # (columns + 1,) mass through each column of faces, towards +x
    aside: Array  # (columns,) mass that leaves each column at the far side


def logarithmic_mean(left: Array, right: Array) -> tuple[Array, Array, Array]:
    """(exp(right) - exp(left))/(right - left), and its slopes by left and by right."""
    step = right - left
    small = np.abs(step) < NEAR
    safe = np.where(small, 1.0, step)
    low, high = np.exp(left), np.exp(right)
    mean = np.where(small, np.exp((left + right) / 2), (high - low) / safe)
    by_left = np.where(small, low * (1 / 2 + step / 6), (mean - low) / safe)
    by_right = np.where(small, low * (1 / 2 + step / 3), (high - mean) / safe)
    return mean, by_left, by_right


def wedge_operator(grid: Grid) -> csr_array:
    """((columns + 1) rows, n): values on the faces across x from those in the cells upstream.

    A face takes the straight line through the two cells upstream of it; the first two take that through the first two.
    """
    columns, rows = grid.shape
    face = np.arange(columns + 1)
    near = np.clip(face - 1, 1, columns - 1)
    share = (grid.x_faces - grid.x[near - 1]) / (grid.x[near] - grid.x[near - 1])
    cells = np.stack([near, near - 1])[:, :, None] * rows + np.arange(rows)
    entries = np.broadcast_to(np.stack([share, 1 - share])[:, :, None], cells.shape)
    faces = np.broadcast_to(face[:, None] * rows + np.arange(rows), cells.shape)
    return csr_array((entries.ravel(), (faces.ravel(), cells.ravel())), shape=((columns + 1) * rows, columns * rows))


def _flow(lower: Fluid, upper: Fluid, *, width: Array, distance: Array, epsilon: float) -> Flow:
    """Of faces of some width between cells at some distance."""
    mean, by_lower, by_upper = logarithmic_mean(-lower.log_viscosity, -upper.log_viscosity)
    roots = np.sqrt(lower.film), np.sqrt(upper.film)
    film, density = ((roots[0] + roots[1]) / 2) ** 2, (lower.density + upper.density) / 2
    scale = epsilon * width / distance
    drop = lower.pressure - upper.pressure
    volume = scale * film**3 * mean
    by_lower = scale * film**3 * (lower.stiffening / 2 * mean - density * by_lower * lower.thickening)
    by_upper = scale * film**3 * (upper.stiffening / 2 * mean - density * by_upper * upper.thickening)
    by_root = 1.5 * scale * film**2 * np.sqrt(film) * density * mean * drop
    return Flow(
        mass=density * volume * drop,
        by_pressure=(density * volume + by_lower * drop, -density * volume + by_upper * drop),
        by_film=(by_root / roots[0], by_root / roots[1]),
        dissipation=volume * drop**2,
    )


def _along(fluid: Fluid, before: Array, after: Array) -> tuple[Fluid, Fluid]:
    """Lower and upper sides of the faces across the first axis; at an end lies ambient oil.

    before, after : by how much the film on the face at either end exceeds that of the cell, one row; none: no face
    """
    lower, upper = [], []
    for name, field in zip(Fluid._fields, fluid, strict=True):
        ends = [np.full_like(field[:1], name == "density")] * 2
        if name == "film":
            ends = [field[:1] + 2 * before, field[-1:] + 2 * after]
        padded = np.concatenate([ends[0], field, ends[1]])
        lower.append(padded[:-1])
        upper.append(padded[1:])
    return Fluid(*lower), Fluid(*upper)


def balance(fluid: Fluid, *, grid: Grid, gap: tuple[Array, Array, Array], epsilon: float) -> Balance:
    """The equation, where the pressure is 0 at both ends and at the far side.

    gap : of the bodies there, over that of the next cells: (rows,), (rows,) and (columns,)
    """
    columns, rows = grid.shape
    count = columns * rows
    number = np.arange(count).reshape(columns, rows)
    wedge = wedge_operator(grid)
    root = np.sqrt(fluid.density * fluid.film).ravel()
    on_faces = wedge @ root
    width = np.tile(grid.widths_y, columns + 1)
    carried = (on_faces**2 * width).reshape(columns + 1, rows)
    ends = [grid.x_faces[[0]], grid.x, grid.x_faces[[-1]]], [grid.y, grid.y_faces[[-1]]]
    steps = [np.diff(np.concatenate(each)) for each in ends]
    along = _flow(
        *_along(fluid, gap[0][None], gap[1][None]), width=grid.widths_y, distance=steps[0][:, None], epsilon=epsilon
    )
    turned = Fluid(*(field.T for field in fluid))
    sides = _along(turned, np.zeros((1, columns)), gap[2][None])
    across = _flow(
        *(Fluid(*(field[1:] for field in side)) for side in sides),  # nothing flows through the line of symmetry
        width=grid.widths_x,
        distance=steps[1][:, None],
        epsilon=epsilon,
    )
    through, aside = carried + along.mass, across.mass
    excess = np.diff(through, axis=0)
    excess += np.diff(np.concatenate([np.zeros((1, columns)), aside]), axis=0).T
    leaving = _difference(columns, rows) @ (wedge * (on_faces * width)[:, None])
    slopes_p = leaving * ((fluid.stiffening * fluid.film).ravel() / root)
    slopes_h = leaving * (fluid.density.ravel() / root)
    nothing = np.full((1, columns), -1)
    first, last = np.full((1, rows), -1), np.full((1, rows), -1)
    of_x = np.concatenate([first, number, last])
    of_y = np.concatenate([number.T, nothing])
    films_x = np.concatenate([number[:1], number, number[-1:]])
    films_y = np.concatenate([number.T, number.T[-1:]])
    for flow, cells, films in ((along, of_x, films_x), (across, of_y, films_y)):
        slopes_p = slopes_p + _slope(flow.by_pressure, cells, cells, count)
        slopes_h = slopes_h + _slope(flow.by_film, cells, films, count)
    return Balance(
        excess=excess.ravel(),
        by_pressure=csr_array(slopes_p),
        by_film=csr_array(slopes_h),
        dissipation=float(along.dissipation.sum() + across.dissipation.sum()),
        through=through.sum(axis=1),
        aside=aside[-1],
    )


def _difference(columns: int, rows: int) -> csr_array:
    """What leaves each cell less what enters, from the mass on all faces across x."""
    count = columns * rows
    cell = np.arange(count)
    signs = np.repeat([1.0, -1.0], count)
    return csr_array((signs, (np.tile(cell, 2), np.concatenate([cell + rows, cell]))), shape=(count, count + rows))


def _slope(slopes: Sides, cells: NDArray[np.intp], of: NDArray[np.intp], count: int) -> csr_array:
    """(n, n) slope of what leaves each cell; cells : beside each face, -1: none; of : on whose value the slope is."""
    found_rows, found_columns, entries = [], [], []
    for side, sign in ((slice(None, -1), 1.0), (slice(1, None), -1.0)):
        for slope, other in zip(slopes, (slice(None, -1), slice(1, None)), strict=True):
            there = (cells[side] >= 0) & (of[other] >= 0)
            found_rows.append(cells[side][there])
            found_columns.append(of[other][there])
            entries.append(sign * slope[there])
    flat = [np.concatenate(parts) for parts in (entries, found_rows, found_columns)]
    return csr_array((flat[0], (flat[1], flat[2])), shape=(count, count))
