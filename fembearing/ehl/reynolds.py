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


def upstream(grid: Grid) -> tuple[NDArray[np.intp], Array]:
    """(2, columns + 1) columns of cells, and their shares in the value on each face across x.

    A face takes the straight line through the two cells upstream of it; the first two take that through the first two.
    """
    near = np.clip(np.arange(-1, grid.x.size), 1, None)
    share = (grid.x_faces - grid.x[near - 1]) / (grid.x[near] - grid.x[near - 1])
    return np.stack([near, near - 1]), np.stack([share, 1 - share])


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
    cells, shares = upstream(grid)
    root = np.sqrt(fluid.density * fluid.film)
    on_faces = (root[cells] * shares[:, :, None]).sum(axis=0)
    carried = on_faces**2 * grid.widths_y
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
    nothing, beside_y = np.full((1, rows), -1), np.concatenate([number.T, np.full((1, columns), -1)])
    beside_x = np.concatenate([nothing, number, nothing])
    held_x, held_y = np.concatenate([number[:1], number, number[-1:]]), np.concatenate([number.T, number.T[-1:]])
    by_root = on_faces * grid.widths_y * shares[:, :, None]  # half of the slope of what the surfaces carry
    slopes = []
    for twice, (by_x, by_y), (of_x, of_y) in (
        (fluid.stiffening * fluid.film / root, (along.by_pressure, across.by_pressure), (beside_x, beside_y)),
        (fluid.density / root, (along.by_film, across.by_film), (held_x, held_y)),
    ):
        parts = [
            (by_root * twice[cells], beside_x, number[cells]),
            (np.stack(by_x), beside_x, np.stack([of_x[:-1], of_x[1:]])),
            (np.stack(by_y), beside_y, np.stack([of_y[:-1], of_y[1:]])),
        ]
        slopes.append(_leaving(parts, count))
    return Balance(
        excess=excess.ravel(),
        by_pressure=slopes[0],
        by_film=slopes[1],
        dissipation=float(along.dissipation.sum() + across.dissipation.sum()),
        through=through.sum(axis=1),
        aside=aside[-1],
    )


def _leaving(parts: list[tuple[Array, NDArray[np.intp], NDArray[np.intp]]], count: int) -> csr_array:
    """(n, n) slopes of what leaves each cell.

    parts : two slopes of the flow through each face; the cells beside it, one row more; and those on whose values the
        slopes are. -1: no cell
    """
    found = []
    for slopes, beside, of in parts:
        for cells, sign in ((beside[:-1], 1.0), (beside[1:], -1.0)):
            there = (cells >= 0) & (of >= 0)
            found.append((sign * slopes[there], np.broadcast_to(cells, of.shape)[there], of[there]))
    entries, places, columns = (np.concatenate(each) for each in zip(*found, strict=True))
    return csr_array((entries, (places, columns)), shape=(count, count))
