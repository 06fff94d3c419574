"""The inner ring and every ball at the first and the last operating point, as the polar plot beside them."""

from collections.abc import Iterator, Sequence

import numpy as np

from analytic.columns import Point
from analytic.units import Units
from fembearing.report.document import Group, Head, Row, Section, Table, Text, table_of, without_zero_angles
from fembearing.report.phrases import angle_cell, digits
from fembearing.report.report import Report
from fembearing.report.sections.points import point_cells, point_heads, point_name

FRAME = (
    "z is the axis of the bearing, the radial load acts along x and the moment about y. All operating points are in "
    "report.json."
)
AXES = ("axially", "along x", "along y")


def ring_section(document: Report) -> Section:
    """The displacement where the contact angle follows from it, stiffness and balls; no blocks without a torque."""
    torque, units = document.solved, document.units
    points = () if torque is None else torque.points
    state = None if torque is None else torque.friction.ring
    shown = [] if state is None else [(index, state.rows[index]) for index in _ends(points)]
    if not shown:
        return Section("Ring and balls", [])
    placed = [(index, ring["displacement"]) for index, ring in shown if ring["displacement"] is not None]
    stiffness = [Group(list(_stiffness(ring, units)), point_name(points, index, units)) for index, ring in shown]
    balls = [Group(list(_balls(ring["balls"], units)), point_name(points, index, units)) for index, ring in shown]
    return Section(
        "Ring and balls",
        [
            Text(FRAME),
            *([_displacement(points, placed, units)] if placed else []),
            Table("Stiffness: what moves the ring by one unit", [Head("", "name"), *_freedoms(units)], stiffness),
            without_zero_angles(Table("Load and contact angle of every ball", _heads_of_balls(units), balls)),
        ],
    )


def _ends(points: Sequence[Point]) -> list[int]:
    """The first and the last point."""
    return sorted({0, len(points) - 1}) if points else []


def _displacement(points: Sequence[Point], placed: Sequence[tuple[int, Point]], units: Units) -> Table:
    lengths = [Head(f"{name}, {units.small_length.name}") for name in AXES]
    tilts = [Head(f"tilt about {name}, deg (rad)") for name in "xy"]
    rows = [
        [
            *point_cells(points, index, units),
            *(f"{units.small_length.number(ring[name]):z.3f}" for name in ("axial", "x", "y")),
            *(f"{np.degrees(ring[name]):z.4f} ({ring[name]:z.6f})" for name in ("tilt_x", "tilt_y")),
        ]
        for index, ring in placed
    ]
    return table_of("Displacement of the inner ring", [*point_heads(points, units), *lengths, *tilts], rows)


def _freedoms(units: Units) -> list[Head]:
    """The displacements and tilts of the ring: the columns of its stiffness."""
    along = [f"{name}, per {units.small_length.name}" for name in AXES]
    return [Head(name) for name in (*along, *(f"tilt about {name}, per mrad" for name in "xy"))]


def _heads_of_balls(units: Units) -> list[Head]:
    races = ("inner", "outer")
    loads = [f"load, {race}, {units.force.name}" for race in races]
    numbers = [Head(name) for name in (*loads, *(f"angle, {race}, deg (rad)" for race in races))]
    return [Head("azimuth, deg (rad)", "name"), *numbers]


def _stiffness(ring: Point, units: Units) -> Iterator[Row]:
    force, torque = units.force, units.torque
    actions = [f"{name}, {force.name}" for name in ("axial force", "force along x", "force along y")]
    actions += [f"moment about {name}, {torque.name}" for name in "xy"]
    along, tilt = 1 / units.small_length.factor, 1e-3  # m and rad, by one of which a column moves
    per_si = np.outer([*3 * [force.factor], *2 * [torque.factor]], [*3 * [along], *2 * [tilt]])
    matrix = np.array(ring["stiffness"])
    for action, row in zip(actions, matrix * per_si, strict=True):
        yield [action, *(f"{value:.4g}" for value in row)]


def _balls(balls: Point, units: Units) -> Iterator[Row]:
    """A row for each ball; one for all of them where they are alike."""
    columns = (balls[name] for name in ("inner_load", "outer_load", "inner_angle", "outer_angle"))
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
    for azimuth, row in zip(balls["azimuth"], rows, strict=True):
        yield [f"{np.degrees(azimuth):.1f} ({azimuth:.3f})", *row]
