"""The charts of the page, as options of Apache ECharts, which draws them in the browser."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from analytic.result import LoadedContact, TorquePoint
from analytic.scene import Contact
from fembearing.quantities import METRIC, QUANTITIES
from fembearing.report.figures.series_axis import axis_of
from fembearing.report.figures.style import BLUE, GREY, RED
from fembearing.report.figures.torque import PARTS
from fembearing.report.torque import TorqueRecord

Options = dict[str, Any]
NEUTRAL = "#8a8f98"  # of makers' bands, on a light and on a dark page
INTERVAL = "#0072B2"
OUTLINE = 60  # points of half an ellipse
BESIDE = 1.15  # of the distance to a shoulder that is shown
LINE = {"type": "line", "symbol": "none", "animation": False}
INSIDE = {"top": 12, "left": 12, "right": 20, "bottom": 40, "containLabel": True}
LEGEND = {"bottom": 0, "left": "center", "itemWidth": 16, "itemHeight": 10, "itemGap": 12}


def part_options(point: TorquePoint) -> Options:
    """A bar of the parts of the torque at one operating point."""
    unit, total = METRIC.torque, point.torque.total
    series = []
    for part, (words, colour) in PARTS.items():
        value = getattr(point.torque, part)
        if value:
            name = f"{words} {100 * value / total:.0f} %" if total else words
            bar = {"name": name, "data": [float(f"{unit.number(value):.5g}")], "itemStyle": {"color": _hex(colour)}}
            series.append({"type": "bar", "stack": "torque", "barWidth": 26, "animation": False, **bar})
    return {
        "grid": {**INSIDE, "bottom": 64, "left": 4, "right": 4, "containLabel": False},
        "legend": {**LEGEND, "type": "plain"},
        "tooltip": {"trigger": "item", "confine": True},
        "xAxis": {"type": "value", "max": float(unit.number(total)) or 1.0, "show": False},
        "yAxis": {"type": "category", "data": [unit.name], "show": False},
        "series": series,
    }


def curve_options(record: TorqueRecord, *, marked: float | None) -> Options:
    """The torque with its interval and the makers' formulas over its points;  marked : speed of the scene, rad/s"""
    kept = [record.points[place] for place in record.computed]
    axis, unit = axis_of(kept, METRIC), METRIC.torque
    places = [record.computed[next(n for n, each in enumerate(kept) if each is point)] for point in axis.points]
    x = axis.values.tolist() if axis.joined else [place + 1 for place in places]
    total = [unit.number(point.torque.total) for point in axis.points]
    ends = [record.interval[place] for place in places]
    band = record.catalogue_band
    low, high = ([side[place] for place in places] if side else None for side in (band.low, band.high))
    series = []
    if low is not None and high is not None:
        series += _band("makers' formulas", x, low, high, NEUTRAL)
    if all(each is not None for each in ends):
        series += _band("95 %", x, [each[0] for each in ends if each], [each[1] for each in ends if each], INTERVAL)
    line = {**LINE, "name": "torque", "data": _pairs(x, total), "lineStyle": {"width": 2.5, "color": BLUE}}
    if marked is not None:
        at = {"xAxis": METRIC.speed.number(abs(marked)), "label": {"show": False}}
        line["markLine"] = {"symbol": "none", "silent": True, "lineStyle": {"color": NEUTRAL}, "data": [at]}
    if len(x) == 1 or not axis.joined:
        line |= {"symbol": "circle", "symbolSize": 7}
    label = axis.label if axis.joined else "operating point"
    return {
        "grid": {**INSIDE, "top": 34, "bottom": 58},
        "legend": {**LEGEND, "data": [each["name"] for each in series if "areaStyle" in each] + ["torque"]},
        "tooltip": {"trigger": "axis", "confine": True, "valueFormatter": None},
        "xAxis": {"type": "value", "name": label, "nameLocation": "middle", "nameGap": 26, "scale": True},
        "yAxis": {"type": "value", "name": QUANTITIES["torque"].heading, "min": 0, "nameTextStyle": {"align": "left"}},
        "series": [*series, {**line, "itemStyle": {"color": BLUE}}],
    }


def ring_options(point: TorquePoint) -> Options | None:
    """The loads of the balls around the ring; the radial load points down. None for a pair of bearings."""
    if point.ring is None:
        return None
    unit, balls = METRIC.force, point.ring.balls
    azimuth = np.degrees(balls.azimuth).tolist()
    series = []
    for race, colour, kind in (("inner", BLUE, "solid"), ("outer", RED, "dashed")):
        load = [float(f"{unit.number(each):.5g}") for each in getattr(balls, f"{race}_load")]
        points = [*zip(load, azimuth, strict=True), (load[0], azimuth[0] + 360)]
        look = {"lineStyle": {"color": colour, "type": kind, "width": 2}, "itemStyle": {"color": colour}}
        series.append(
            {**LINE, "name": f"{race} race", "coordinateSystem": "polar", "symbol": "circle", "symbolSize": 7}
            | {"data": [[each, angle] for each, angle in points], **look}
        )
    angles = {"type": "value", "min": 0, "max": 360, "interval": 90, "startAngle": 270, "clockwise": False}
    return {
        "legend": LEGEND,
        "tooltip": {"trigger": "item", "confine": True},
        "polar": {"radius": "64%", "center": ["50%", "46%"]},
        "angleAxis": {**angles, "axisLabel": {"formatter": "{value}°"}},
        "radiusAxis": {"min": 0, "splitNumber": 3, "axisLabel": {"formatter": f"{{value}} {unit.name}"}, "angle": 45},
        "series": series,
    }


def ellipse_options(contact: Contact, ellipse: LoadedContact[float]) -> Options:
    """The contact ellipse across the groove, to scale within each axis, with both shoulders."""
    unit = METRIC.length
    half = unit.number(ellipse.semi_axis_rolling)
    across = unit.number(ellipse.semi_axis_transverse)
    sides = [-unit.number(contact.far_shoulder), unit.number(contact.shoulder)]
    edges = [side if np.isfinite(side) else np.sign(side) * 2 * across for side in sides]
    turn = np.linspace(-1.0, 1.0, OUTLINE)
    rise = half * np.sqrt(1 - turn**2)
    colour = BLUE if contact.pair == "inner" else RED
    outline = {**LINE, "lineStyle": {"color": colour}, "areaStyle": {"color": colour, "opacity": 0.25}, "silent": True}
    series = [{**outline, "data": _pairs((across * turn).tolist(), (sign * rise).tolist())} for sign in (1, -1)]
    shoulders = [{"xAxis": round(side, 4)} for side in sides if np.isfinite(side)]
    name = {"formatter": "shoulder", "position": "insideEndTop", "distance": 3}
    lines = {"symbol": "none", "silent": True, "data": shoulders, "label": name}
    series[0]["markLine"] = {**lines, "lineStyle": {"color": NEUTRAL, "type": "solid", "width": 2}}
    axis = {"type": "value", "nameLocation": "middle"}
    return {
        "grid": {**INSIDE, "left": 28, "bottom": 30},
        "xAxis": {**axis, "name": f"across the groove, {unit.name}", "nameGap": 24}
        | {"min": round(BESIDE * edges[0], 3), "max": round(BESIDE * edges[1], 3)},
        "yAxis": {**axis, "name": f"rolling, {unit.name}", "nameGap": 34, "splitNumber": 2}
        | {"min": -float(f"{1.4 * half:.2g}"), "max": float(f"{1.4 * half:.2g}")},
        "series": series,
    }


def _band(name: str, x: Sequence[float], low: Sequence[float], high: Sequence[float], colour: str) -> list[Options]:
    """The area between two lines: the upper is stacked on the lower, which is not seen."""
    unit, stack = METRIC.torque, {"stack": name, "stackStrategy": "all", "lineStyle": {"opacity": 0}, "silent": True}
    ground = [unit.number(each) for each in low]
    height = [unit.number(top - bottom) for bottom, top in zip(low, high, strict=True)]
    hidden = {**LINE, **stack, "name": f"{name}, from", "data": _pairs(x, ground), "tooltip": {"show": False}}
    area = {"areaStyle": {"color": colour, "opacity": 0.22}, "itemStyle": {"color": colour}}
    return [hidden, {**LINE, **stack, **area, "name": name, "data": _pairs(x, height)}]


def _pairs(x: Sequence[float], y: Sequence[float]) -> list[list[float]]:
    return [[float(f"{first:.6g}"), float(f"{second:.6g}")] for first, second in zip(x, y, strict=True)]


def _hex(colour: str) -> str:
    """Colours of matplotlib's grey scale, as browsers know them."""
    return NEUTRAL if colour == GREY else colour
