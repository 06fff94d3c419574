"""Values between the nodes of a table, by polynomials through the nearest nodes of each axis, and their error.

This is what readers of the tables do: two nodes of an axis make straight lines, as in Modelica and Simscape, four make
cubic polynomials, as in `fmu.c`.
"""

from collections.abc import Sequence

import numpy as np

from analytic.scene import Array
from fembearing.formats.torque_map import TorqueMap

LINEAR, CUBIC = 2, 4  # nodes of an axis in a polynomial
MOST = 1000  # points at which an error is measured
SEED = 1  # of the choice of so many


def interpolated(axes: Sequence[Array], table: Array, points: Sequence[Array], *, order: int) -> Array:
    """The table at points, (n,).

    axes : nodes of each, ascending;  table : of the shape of the axes;  points : (n,) of each axis, within its nodes
    order : most nodes of an axis in a polynomial
    """
    first, *others = (_weights(nodes, at, min(order, nodes.size)) for nodes, at in zip(axes, points, strict=True))
    found = np.tensordot(first, table, axes=1)
    for weights in others:
        found = np.einsum("ni,ni...->n...", weights, found)
    return found


def _weights(nodes: Array, at: Array, size: int) -> Array:
    """(n, nodes) weight of each node at points, (n,), by the polynomial through the nearest `size` nodes."""
    begin = np.clip(np.searchsorted(nodes, at, side="right") - size // 2, 0, nodes.size - size)
    chosen = begin[:, None] + np.arange(size)
    near, own = nodes[chosen], np.eye(size, dtype=bool)
    gaps = np.where(own, 1.0, near[:, :, None] - near[:, None, :])
    factors = np.where(own, 1.0, (at[:, None] - near)[:, None, :] / gaps)
    weights = np.zeros((at.size, nodes.size))
    np.put_along_axis(weights, chosen, factors.prod(axis=-1), axis=1)
    return weights


def table_error(found: TorqueMap, *, order: int) -> float:
    """The largest error of the interpolated torque over the torque itself, in the middle of the cells of the table.

    Of more than MOST cells so many are chosen at random. On each axis the error of a polynomial is largest near the
    middle between two nodes.
    """
    middles = [values if values.size == 1 else (values[1:] + values[:-1]) / 2 for values in found.axes.values()]
    points = np.stack([each.ravel() for each in np.meshgrid(*middles, indexing="ij")])
    if points.shape[1] > MOST:
        points = points[:, np.random.default_rng(SEED).choice(points.shape[1], MOST, replace=False)]
    right = found.law.at(dict(zip(found.axes, points, strict=True)))
    nodes = list(found.axes.values())
    by_table = interpolated(nodes, found.nominal, list(points), order=order)
    error = np.abs(by_table - right)
    return float(np.max(np.divide(error, right, out=np.zeros_like(error), where=right > 0)))
