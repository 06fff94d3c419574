"""The inner ring and every ball at the first and the last operating point, as the polar plot beside them."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from fembearing.quantities import Units
from fembearing.report.document.report import Report
from fembearing.report.document.ring import Balls, Displacement, RingState
from fembearing.report.document.torque import Point
from fembearing.report.page.sections.grid import Grid, Group, Head, Row, grid_of
from fembearing.report.page.sections.points import point_cells, point_heads, point_name
from fembearing.report.phrases import angle_cell, digits

ACTIONS = ("axial force, N", "force along x, N", "force along y, N", "moment about x, N mm", "moment about y, N mm")
FREEDOMS = (
    *(f"{name}, per um" for name in ("axially", "along x", "along y")),
    *(f"tilt about {name}, per mrad" for name in "xy"),
)
PER_SI = np.outer([1.0, 1.0, 1.0, 1e3, 1e3], [1e-6, 1e-6, 1e-6, 1e-3, 1e-3])  # N and N mm per um and mrad
ROUND_OFF = 1e-9  # of the diagonal, below which an entry is none
BALLS = ("load, inner, N", "load, outer, N", "angle, inner, deg (rad)", "angle, outer, deg (rad)")


class RingSection(NamedTuple):
    """Tables of the section; displacement None: the scene gives the contact angle, which no displacement belongs to."""

    displacement: Grid | None
    stiffness: Grid
    balls: Grid


def ring_section(document: Report) -> RingSection | None:
    """What the section shows; None without a torque."""
    points = [] if document.torque is None else document.torque.points
    units = document.units
    shown = [(index, ring) for index in _ends(points) if (ring := points[index].ring) is not None]
    if not shown:
        return None
    placed = [(index, ring.displacement) for index, ring in shown if ring.displacement is not None]
    stiffness = [Group(list(_stiffness(ring, units)), point_name(points, index, units)) for index, ring in shown]
    balls = [Group(list(_balls(ring.balls, units)), point_name(points, index, units)) for index, ring in shown]
    return RingSection(
        displacement=_displacement(points, placed, units) if placed else None,
        stiffness=Grid("stiffness of the bearing", [Head("", "name"), *_freedoms(units)], stiffness),
        balls=Grid("balls", [Head("azimuth, deg (rad)", "name"), *_heads_of_balls(units)], balls),
    )


def _ends(points: Sequence[Point]) -> list[int]:
    """The first and the last point."""
    return sorted({0, len(points) - 1}) if points else []


def _displacement(points: Sequence[Point], placed: Sequence[tuple[int, Displacement]], units: Units) -> Grid:
    lengths = [Head(f"{name}, {units.small_length.name}") for name in AXES]
    tilts = [Head(f"tilt about {name}, deg (rad)") for name in "xy"]
    rows = [
        [
            *point_cells(points, index, units),
            *(f"{each * MICRO.factor:z.3f}" for each in (ring.axial, ring.x, ring.y)),
            *(f"{np.degrees(each):z.4f} ({each:z.6f})" for each in (ring.tilt_x, ring.tilt_y)),
        ]
        for index, ring in placed
    ]
    return grid_of("displacement of the inner ring", [*point_heads(points, units), *lengths, *tilts], rows)


def _stiffness(ring: RingState) -> Iterator[Row]:
    matrix = np.array(ring.stiffness)
    scale = np.sqrt(np.abs(np.outer(matrix.diagonal(), matrix.diagonal())))
    matrix = np.where(np.abs(matrix) > ROUND_OFF * scale, matrix, 0.0)  # a symmetric bearing has zeros
    for action, row in zip(ACTIONS, matrix * PER_SI, strict=True):
        yield [action, *(f"{value:.4g}" for value in row)]


def _balls(balls: Balls, units: Units) -> Iterator[Row]:
    """A row for each ball; one for all of them where they are alike."""
    columns = (balls.inner_load, balls.outer_load, balls.inner_angle, balls.outer_angle)
    rows = [
        (
            digits(inner, units.force.factor, 4),
            digits(outer, units.force.factor, 4),
            angle_cell(first),
            angle_cell(second),
        )
        for inner, outer, first, second in zip(*columns, strict=True)
    ]
    if len(set(rows)) == 1:
        yield [f"all {len(rows)} balls", *rows[0]]
        return
    for azimuth, row in zip(balls.azimuth, rows, strict=True):
        yield [f"{np.degrees(azimuth):.1f} ({azimuth:.3f})", *row]
