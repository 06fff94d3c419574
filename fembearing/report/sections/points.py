"""Operating points as tables name them: by number, speed and loads."""

from collections.abc import Sequence

from analytic.columns import COLUMNS, COORDINATES, Point
from analytic.scene_torque import SceneTorque
from analytic.units import METRIC, Units, load_words, speed_words
from analytic.words import rounded
from fembearing.report.document import Head

LOADS = ("axial_load", "radial_load", "moment")

MOST = 12  # points of a long series that are shown


def point_heads(points: Sequence[Point], units: Units) -> list[Head]:
    """Number, speed and loads: the first columns of a table over operating points.

    A terminal has no column for a load that is the same at all of them: `fixed_loads` has it in words.
    """
    varying, loads = varying_loads(points), []
    for name in present_loads(points):
        column = COLUMNS[name]
        short = f"{column.symbol}, {column.shown(units).name}"
        loads.append(Head(column.heading(units), short=short, wide=name not in varying))
    return [Head("#"), Head(f"speed, {units.speed.name}", short=units.speed.name), *loads]


def point_cells(points: Sequence[Point], index: int, units: Units) -> list[str]:
    """The cells below `point_heads`."""
    point = points[index]
    shown = {name: COLUMNS[name].shown(units) for name in present_loads(points)}
    loads = [f"{unit.number(point[name]):.5g}" for name, unit in shown.items()]
    return [str(index + 1), rounded(units.speed.number(point["inner_speed"]), 5), *loads]


def fixed_loads(points: Sequence[Point], units: Units) -> list[str]:
    """The loads that are the same at every point, in words."""
    varying = varying_loads(points)
    return [
        f"{COORDINATES[name].meaning} {COLUMNS[name].shown(units).written(points[0][name], '.5g')}"
        for name in present_loads(points)
        if name not in varying
    ]


def point_name(points: Sequence[Point], index: int, units: Units) -> str:
    """An operating point in words, with its number where there are several."""
    point = points[index]
    number = f"point {index + 1}: " if len(points) > 1 else ""
    named = [name for name in present_loads(points) if point[name]] or LOADS[:1]
    return f"{number}{loads_of(point, named, units)}, {speed_words(point['inner_speed'], units)}"


def heaviest_point(points: Sequence[Point]) -> int:
    """The point with the heaviest ball, whose contacts are solved; the first of equal ones."""
    loads = [max(point["load_inner"], point["load_outer"]) for point in points]
    return loads.index(max(loads))


def shown_places(torque: SceneTorque) -> list[int]:
    """At most 12 points with a torque and 12 without one, in their order.

    Of many with a torque: both ends, smallest and largest total, and an even choice of the others.
    """
    known, lost = torque.places.computed, [*torque.places.failures][:MOST]
    if len(known) <= MOST:
        return sorted([*known, *lost])
    totals = {torque.points[place]["torque_total"]: place for place in reversed(known)}  # the first of equal ones
    chosen = {known[0], known[-1], totals[min(totals)], totals[max(totals)]}
    others, free = [place for place in known if place not in chosen], MOST - len(chosen)
    chosen |= {others[round(number * (len(others) - 1) / (free - 1))] for number in range(free)}
    return sorted([*chosen, *lost])


def loads_of(point: Point, names: Sequence[str], units: Units = METRIC) -> str:
    """The loads of these names at an operating point, for example "1000 N axial, 50 N radial"."""
    return ", ".join(load_words(name, point[name], units) for name in names)


def varying_loads(points: Sequence[Point]) -> list[str]:
    """The names of the loads that differ between operating points."""
    return [name for name in LOADS if len({point[name] for point in points}) > 1]


def present_loads(points: Sequence[Point]) -> list[str]:
    """The axial load, and the names of the other loads that are not 0 at every operating point."""
    return [name for name in LOADS if name == "axial_load" or any(point[name] for point in points)]
