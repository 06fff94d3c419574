"""Operating points as the page names them: by number, loads and speed."""

from collections.abc import Sequence

from analytic.result import TorquePoint
from analytic.rows import OperatingPoint
from fembearing.quantities import QUANTITIES, Units
from fembearing.report.phrases import LOADS, loads_of, present_loads
from fembearing.report.tables.table import Head

MOST_IN_SUMMARY = 12
NUMBER = Head("point", "name")


def point_heads(points: Sequence[OperatingPoint], units: Units) -> list[Head]:
    """Number, loads and speed: the first columns of a table over operating points."""
    loads = [Head(QUANTITIES[name].in_units(units).heading) for name in present_loads(points)]
    return [NUMBER, *loads, Head(f"speed, {units.speed.name}")]


def point_cells(points: Sequence[OperatingPoint], index: int, units: Units) -> list[str]:
    """The cells below `point_heads`."""
    point = points[index]
    factors = {name: QUANTITIES[name].in_units(units).shown.factor for name in present_loads(points)}
    loads = [f"{getattr(point, name) * factor:.6g}" for name, factor in factors.items()]
    return [str(index + 1), *loads, f"{point.inner_speed * units.speed.factor:.5g}"]


def point_name(points: Sequence[OperatingPoint], index: int, units: Units) -> str:
    """An operating point in words, with its number where there are several."""
    point = points[index]
    number = f"point {index + 1}: " if len(points) > 1 else ""
    named = [name for name in present_loads(points) if getattr(point, name)] or LOADS[:1]
    return f"{number}{loads_of(point, named, units)}, {units.speed.written(point.inner_speed, '.5g')}"


def parts_of(points: Sequence[TorquePoint]) -> list[str]:
    """The parts of the torque that were computed or declared."""
    return [
        name for name, value in vars(points[0].torque).items() if value is not None and name not in ("race", "total")
    ]


def heaviest_point(points: Sequence[TorquePoint]) -> int:
    """The point with the heaviest ball, whose contacts are solved; the first of equal ones."""
    return max(range(len(points)), key=lambda index: _heaviest(points[index]))


def points_of_summary(points: Sequence[TorquePoint]) -> list[int]:
    """At most 12 points in their order: both ends, smallest and largest total, and an even choice of the others."""
    count = len(points)
    if count <= MOST_IN_SUMMARY:
        return list(range(count))
    totals = [point.torque.total for point in points]
    chosen = {0, count - 1, totals.index(min(totals)), totals.index(max(totals))}
    free = MOST_IN_SUMMARY - len(chosen)
    others = [index for index in range(count) if index not in chosen]
    chosen |= {others[round(place * (len(others) - 1) / (free - 1))] for place in range(free)}
    return sorted(chosen)


def _heaviest(point: TorquePoint) -> float:
    return max(point.contact.inner.load, point.contact.outer.load)
