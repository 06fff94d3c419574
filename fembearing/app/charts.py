"""The charts of the page, as options of Apache ECharts, which draws them in the browser."""

from collections.abc import Sequence
from html import escape
from typing import Any

import numpy as np

from analytic.columns import COLUMNS, COORDINATES, Point
from analytic.figures.series_axis import axis_of
from analytic.figures.style import BLUE, GREY, RED
from analytic.figures.torque import PARTS
from analytic.result import FrictionTorque
from analytic.rows import Two
from analytic.scene import Contact
from analytic.scene_torque import SceneTorque
from analytic.units import Units
from fembearing.report.sections.torque import RESIDUE

Options = dict[str, Any]
NEUTRAL = "#8a8f98"  # seen on a light and on a dark page
TEXT = {"textBorderWidth": 0}  # ECharts draws a light border around letters
OUTLINE = 81  # points of half an ellipse
BESIDE = 1.15  # of the distance to a shoulder that is shown
AROUND = 1.1  # of half an ellipse that is shown at least
ACROSS, ALONG = 250, 84  # pixels of the room around an ellipse, so that the ratio of its scales is known
STEPS, FINE = (1.0, 2.0, 5.0), 1.5  # of a scale, times powers of ten; least number of steps beside the middle
LINE = {"type": "line", "symbol": "none"}
INSIDE = {"top": 12, "left": 12, "right": 20, "bottom": 40, "containLabel": True}
LEGEND = {"bottom": 0, "left": "center", "itemWidth": 16, "itemHeight": 10, "itemGap": 12}
FAINT = {"splitLine": {"lineStyle": {"color": NEUTRAL, "opacity": 0.25}}}
AXIS = {"type": "value", "nameLocation": "middle", "axisLine": {"lineStyle": {"color": NEUTRAL}}, **FAINT}
BANDS = {"makers' formulas": NEUTRAL, "95 %": BLUE}


def part_options(point: Point, units: Units) -> Options:
    """A bar of the parts of the torque at one operating point."""
    unit, total = units.torque, point["torque_total"]
    series = [
        {"name": words, "data": [_short(unit.number(value))], "itemStyle": {"color": _css(colour)}}
        | {"type": "bar", "stack": "torque", "barWidth": 28}
        for words, colour, value in _parts(point)
    ]
    return {
        "animation": False,
        "grid": {"top": 2, "left": 2, "right": 2, "height": 32},
        "tooltip": {"trigger": "item", "confine": True},
        "xAxis": {"type": "value", "min": 0, "max": _short(unit.number(total)) or 1.0, "show": False},
        "yAxis": {"type": "category", "data": [unit.name], "show": False},
        "series": series,
    }


def part_legend(point: Point, units: Units) -> str:
    """The parts with their colours, shares and values, as HTML."""
    unit, total = units.torque, point["torque_total"]
    entries = [
        f'<li><i style="background: {_css(colour)}"></i>{escape(words)} <b>{100 * value / total:.0f} %</b>, '
        f"{unit.written(value, '.3g')}</li>"
        for words, colour, value in _parts(point)
    ]
    return f'<ul class="legend">{"".join(entries)}</ul>'


def _parts(point: Point) -> list[tuple[str, str, float]]:
    """Words, colour and value (N m) of each part that is seen."""
    values = [(words, colour, point[f"torque_{part}"]) for part, (words, colour) in PARTS.items()]
    least = RESIDUE * point["torque_total"]
    return [(words, colour, value) for words, colour, value in values if value is not None and value > least]


def curve_options(results: Sequence[SceneTorque], units: Units, *, marked: float | None) -> Options:
    """The torque with its interval and the makers' formulas over the axis of all points of the results.

    marked : speed of the scene, rad/s; None: not drawn
    """
    known = [point for each in results for point in each.points if point["torque_total"] is not None]
    columns = {name: np.array([point[name] for point in known], dtype=float) for name in (*COORDINATES, "torque_total")}
    axis, unit = axis_of(columns, units), units.torque
    bands = [[_ends(known[place], "catalogue"), _ends(known[place], "interval")] for place in axis.order]
    x = axis.values.tolist() if axis.joined else list(range(1, len(bands) + 1))
    series: list[Options] = []
    for name, ends in zip(BANDS, zip(*bands, strict=True), strict=True):
        if all(each is not None for each in ends):
            series += _band(name, x, ends, units)
    total = unit.number(axis.columns["torque_total"]).tolist()
    look = {"lineStyle": {"width": 2.5, "color": BLUE}, "itemStyle": {"color": BLUE}, "symbol": "circle"}
    line = {**LINE, **look, "symbolSize": 5, "name": "torque", "data": _pairs(x, total)}
    at = [] if marked is None else [{"xAxis": units.speed.number(abs(marked)), "label": {"show": False}}]
    line["markLine"] = {"symbol": "none", "silent": True, "lineStyle": {"color": NEUTRAL}, "data": at}
    shades = [{"name": each["name"], "icon": "rect"} for each in series if "areaStyle" in each]
    heading = COLUMNS["torque"].heading(units)
    return {
        "animation": False,
        "grid": {**INSIDE, "top": 36, "bottom": 58},
        "legend": {**LEGEND, "data": [*shades, "torque"]},
        "tooltip": {"trigger": "item", "confine": True, ":formatter": f"p => `${{p.value[1]}} {unit.name}`"},
        "xAxis": {**AXIS, "name": axis.label, "nameGap": 28, "scale": True},
        "yAxis": {**AXIS, "name": heading, "nameLocation": "end", "min": 0} | {"nameTextStyle": {"align": "left"}},
        "series": [*series, line],
    }


def ring_options(friction: FrictionTorque, place: int, units: Units) -> Options | None:
    """The loads of the balls around the ring; the radial load points down. None for a pair of bearings.

    Angles of the chart begin at its top, where its scale does not cross the loaded balls.
    """
    ring, unit = friction.ring, units.force
    if ring is None:
        return None
    turned = (np.degrees(ring.azimuth) + 180.0).tolist()
    series = []
    for side, (race, colour, kind) in enumerate((("inner", BLUE, "solid"), ("outer", RED, "dashed"))):
        load = [_short(unit.number(each)) for each in ring.load[place, side].tolist()]
        look = {"lineStyle": {"color": colour, "type": kind, "width": 2}, "itemStyle": {"color": colour}}
        points = [*_pairs(load, turned), [load[0], turned[0] + 360]]
        polar = {"coordinateSystem": "polar", "symbol": "circle", "symbolSize": 7}
        series.append({**LINE, **polar, **look, "name": f"{race} race", "data": points})
    azimuth = "(a + 180) % 360"
    around = {"type": "value", "min": 0, "max": 360, "interval": 90, "startAngle": 90, "clockwise": False}
    axis = {"axisLine": {"lineStyle": {"color": NEUTRAL}}, **FAINT}
    words = f"p => {{ const [q, a] = p.value; return `${{p.seriesName}}, ${{{azimuth}}}°: ${{q}} {unit.name}`; }}"
    return {
        "animation": False,
        "legend": LEGEND,
        "tooltip": {"trigger": "item", "confine": True, ":formatter": words},
        "polar": {"radius": "66%", "center": ["50%", "46%"]},
        "angleAxis": {**axis, **around, "axisLabel": {":formatter": f"a => `${{{azimuth}}}°`"}},
        "radiusAxis": {**axis, "min": 0, "splitNumber": 3}
        | {"axisLabel": {"formatter": f"{{value}} {unit.name}", "showMinLabel": False, "showMaxLabel": False}},
        "series": series,
    }


def ellipse_options(contact: Contact, point: Point, units: Units) -> Options:
    """The contact ellipse across its groove, with the shoulders."""
    unit = units.length
    axes = (point[f"semi_axis_{name}_{contact.pair}"] for name in ("rolling", "transverse"))
    half, across = map(unit.number, axes)
    sides = [-unit.number(contact.far_shoulder), unit.number(contact.shoulder)]
    edges = [side if np.isfinite(side) else np.sign(side) * 2 * across for side in sides]
    turn = np.sin(np.linspace(-np.pi / 2, np.pi / 2, OUTLINE))  # dense where the outline is steep
    rise = half * np.sqrt(1 - turn**2)
    colour = BLUE if contact.pair == "inner" else RED
    outline = {**LINE, "silent": True, "lineStyle": {"color": colour}, "areaStyle": {"color": colour, "opacity": 0.25}}
    series = [{**outline, "data": _pairs((across * turn).tolist(), (sign * rise).tolist())} for sign in (1, -1)]
    shoulders = [{"xAxis": round(side, 4)} for side in sides if np.isfinite(side)]
    label = {"formatter": "shoulder", "color": NEUTRAL, **TEXT}
    look = {"lineStyle": {"color": NEUTRAL, "type": "solid", "width": 2}, "label": label}
    series[0]["markLine"] = {"symbol": "none", "silent": True, "data": shoulders, **look}
    low, high = (BESIDE * edge for edge in edges)
    scale = (high - low) / ACROSS  # of a pixel, across
    least = AROUND * half
    power = 10 ** np.floor(np.log10(least / FINE))
    step = power * max(each for each in STEPS if each * power <= least / FINE)
    most = step * np.ceil(least / step)
    ratio = max(1, int(ALONG * scale / (2 * most)))
    ends = {"axisLabel": {"showMinLabel": False, "showMaxLabel": False, "hideOverlap": True}}
    across_words = f"across the groove, {unit.name}; rolling {ratio} times larger"
    return {
        "animation": False,
        "grid": {"width": ACROSS, "height": round(2 * most * ratio / scale), "left": "center", "top": 24},
        "xAxis": {**AXIS, **ends, "name": across_words, "nameGap": 24} | {"min": _short(low), "max": _short(high)},
        "yAxis": {**AXIS, "axisLabel": {"hideOverlap": True}, "name": f"rolling, {unit.name}", "nameGap": 38}
        | {"min": -_short(most), "max": _short(most), "interval": _short(step)},
        "series": series,
    }


def _ends(point: Point, name: str) -> Two | None:
    """Both ends of the interval, or of the makers' band, N m; None: not known."""
    low, high = point.get(f"{name}_low"), point.get(f"{name}_high")
    return None if low is None or high is None else (low, high)


def _band(name: str, x: Sequence[float], ends: Sequence[Two], units: Units) -> list[Options]:
    """The area between two lines: the upper one is stacked on the lower one, which is not seen."""
    unit, colour = units.torque, BANDS[name]
    stacked = {**LINE, "stack": name, "stackStrategy": "all", "lineStyle": {"opacity": 0}, "silent": True}
    area = {"areaStyle": {"color": colour, "opacity": 0.22}, "itemStyle": {"color": colour}}
    ground = _pairs(x, [unit.number(low) for low, _ in ends])
    height = _pairs(x, [unit.number(high - low) for low, high in ends])
    return [{**stacked, "name": f"{name}, from", "data": ground}, {**stacked, **area, "name": name, "data": height}]


def _pairs(x: Sequence[float], y: Sequence[float]) -> list[list[float]]:
    return [[_short(first), _short(second)] for first, second in zip(x, y, strict=True)]


def _short(number: float) -> float:
    return float(f"{number:.6g}")


def _css(colour: str) -> str:
    """A colour of the figures as browsers know it: the shades of grey have names of their own there."""
    return NEUTRAL if colour == GREY else colour
