"""A bearing drawn to scale: a section through a ball, the view along the axis, and its dimensions with their origin."""

import os
import re
import textwrap
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple, Unpack

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Circle, Polygon

from analytic.any_scene import scene_by
from analytic.errors import InputError
from analytic.figures.style import BLUE, GREY, LETTERS, RED, TITLE, WIDTH
from analytic.given import SceneOptions
from analytic.scene import ArrangementKind, Array, Scene
from analytic.units import METRIC, SYSTEMS, Units
from analytic.writing import new_file
from fembearing.report.figures.bearing_section import (
    DrawnBearing,
    RingSection,
    Section,
    is_drawable,
    section_of,
    unloaded_angle,
)
from fembearing.report.figures.style import pdf, png, svg
from fembearing.report.report import Report

STEEL, BALL, LINE, CENTRE = "#e3e8ed", "#cfe0ef", "#1b1f23", (0, (9, 2, 1.5, 2))
HIGH, ROW, FOOT, HEAD = 3.2, 0.152, 0.38, 0.36  # inches: of the views, of a row of the table, of the ends
SOURCE = 65  # letters of a source: `fembearing torque SCENE --details` has them whole
NOT_DRAWABLE = "No drawing: the dimensions of the bearing contradict each other."
SMALL = 7  # points, letters of the table
ARROW = {"linewidth": 0.6, "color": LINE, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 7}
CONTENTS: Mapping[str, Callable[[Figure], bytes]] = {".svg": svg, ".png": png, ".pdf": pdf}  # by the ending of a file
ANGLES = {"solved": "unloaded contact angle", "given": "contact angle, loaded, given", "thrust": "contact angle"}


class Shown(NamedTuple):
    """How a scene's bearing is drawn."""

    bearing: DrawnBearing
    name: str
    angle: float  # of the line of contact, rad
    angle_name: str
    angle_origin: str
    pocket: float | None = None  # diameter of the cage's pocket, m
    arrangement: ArrangementKind | None = None
    distance: float | None = None  # between the middles of a pair, m


class Label(NamedTuple):
    """Words with a line to what they name."""

    words: str
    place: tuple[float, float]  # m, of what they name
    colour: str = LINE


def shown_bearing(bearing: DrawnBearing, rule: str, angle: float | None, *, pocket: float | None = None) -> Shown:
    """How a bearing is drawn.

    rule : of its contact angle;  angle : the one that the scene gives, rad: loaded for "given", else unloaded
    """
    own = unloaded_angle(bearing) if angle is None else angle
    origin = "given; the scene" if angle is not None else "derived; from clearance and grooves"
    if bearing.kind == "thrust":
        own, rule, origin = np.pi / 2, "thrust", "derived; of every thrust bearing"
    elif angle is None and "clearance" in bearing.origins and "contact angle" in bearing.origins["clearance"].source:
        origin = "given; nominal, sets the clearance"
    return Shown(
        bearing=bearing, name=bearing.name, angle=own, angle_name=ANGLES[rule], angle_origin=origin, pocket=pocket
    )


def draw_bearing(
    scene: Scene | str | os.PathLike[str],
    *,
    out: Path | str | None = None,
    force: bool = False,
    **options: Unpack[SceneOptions],
) -> Figure:
    """Draw the bearing of a scene to scale, with its dimensions and where they come from.

    Parameters
    ----------
    scene : Scene, str or path
        Of one bearing, or of a pair, which is drawn in its arrangement.
    out : str or path, optional
        File that ends with .svg, .png or .pdf. None writes nothing.
    force : bool
        The file takes the place of one that exists.
    **options : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    matplotlib.figure.Figure
        A section through a ball, the view along the axis, and a table of dimensions, in the scene's system of units.
        Each view has its own scale. A dimension that the scene lacks is drawn at a guess, dashed.

    Raises
    ------
    InputError
        The file exists, cannot be written or has another ending; or the bearing has more than 500 balls.

    Notes
    -----
    The rings are drawn in operation, after mounting, without load: the ball touches both races at the unloaded contact
    angle al0, cos al0 = 1 - P_d/(2 A0), with the diametral clearance P_d and the distance A0 of the groove centres
    [Harris2007].
    """
    scene = scene_by(scene, options)
    content = None if out is None else _content_of(Path(out))
    given = scene.contact_angle
    shown = shown_bearing(
        scene.bearing,
        given.rule,
        given.value if given.rule == "given" else given.free,
        pocket=None if scene.cage is None else scene.cage.pocket_diameter,
    )
    if scene.bearing.name == "unnamed":
        shown = shown._replace(name=scene.name)
    if scene.arrangement is not None:
        shown = shown._replace(arrangement=scene.arrangement.kind, distance=scene.arrangement.distance)
    figure = drawing_of(shown, SYSTEMS[scene.report.units])
    if figure is None:
        raise InputError(f"{scene.bearing.name}: {NOT_DRAWABLE} It takes at most 500 balls, and lengths in proportion")
    if out is not None and content is not None:
        with new_file(Path(out), force=force) as file:
            file.write_bytes(content(figure))
    return figure


def _content_of(target: Path) -> Callable[[Figure], bytes]:
    """What a file of this name holds. Raises InputError for an ending that is not known."""
    content = CONTENTS.get(target.suffix.casefold())
    if content is None:
        raise InputError(
            f"--out {str(target)!r} ends with {target.suffix!r}: give a file that ends with {', '.join(CONTENTS)}"
        )
    return content


def bearing_plot(document: Report) -> tuple[Figure | None, str]:
    """The drawing of a report's bearing, without its table."""
    scene = document.scene
    angle, pocket = scene.contact_angle, None if scene.cage is None else scene.cage.pocket_diameter
    given = angle.value if angle.rule == "given" else angle.free
    figure = drawing_of(shown_bearing(scene.bearing, angle.rule, given, pocket=pocket), document.units, table=False)
    if figure is None:
        return None, NOT_DRAWABLE
    return figure, "Without load, in operation. The origin of each dimension is in the appendix of inputs."


def drawing_of(shown: Shown, units: Units = METRIC, *, table: bool = True) -> Figure | None:
    """The drawing; None for dimensions that are not those of one thing.

    table : of the dimensions, with where each comes from
    """
    if not is_drawable(shown.bearing):
        return None
    rows = list(dimensions_of(shown, units)) if table else []
    below = FOOT + (ROW * (len(rows) + 1) if table else 0.0)
    high = HIGH + HEAD + below
    figure = Figure(figsize=(WIDTH, high))
    bottom = below / high
    left, right = (
        figure.add_axes((start, bottom, width, HIGH / high)) for start, width in ((0.005, 0.62), (0.64, 0.355))
    )
    section = section_of(shown.bearing, angle=None if shown.angle_name == ANGLES["given"] else shown.angle)
    _draw_section(left, shown, section, units)
    _draw_side(right, shown, section, units)
    bearing = shown.bearing
    pair = "" if shown.arrangement is None else f"two, arranged {shown.arrangement}; "
    title = f"{shown.name}: {pair}{bearing.ball_count} balls of {_length(bearing.ball_diameter, units)}"
    _write(figure, 0.5, 1 - 0.17 / high, title, fontsize=TITLE + 1, ha="center", va="center", weight="bold")
    if table:
        _table(figure, rows, high)
    dashed = any(not line.known for ring in (section.inner, section.outer) for line in ring.lines)
    words = "Each view to its own scale. Seals, chamfers and the cage's body are not drawn."
    words += "\nDashed: guess, as the scene has no such dimension." if dashed else ""
    _write(figure, 0.01, 0.07 / high, words, fontsize=SMALL, color="0.3", va="bottom")
    return figure


def dimensions_of(shown: Shown, units: Units) -> Iterator[tuple[str, str, str]]:
    """Name, value and origin of each dimension."""
    bearing = shown.bearing
    for name, key in (("bore", "bore_diameter"), ("outside diameter", "outside_diameter"), ("width", "width")):
        value = getattr(bearing, key)
        words, origin = ("not given", "-") if value is None else (_length(value, units), _origin(bearing, key))
        yield name, words, origin
    yield "balls", f"{bearing.ball_count}, {bearing.ball_material.name}", _origin(bearing, "ball_count")
    yield "ball diameter", _length(bearing.ball_diameter, units), _origin(bearing, "ball_diameter")
    pitch = bearing.inner.bottom_radius + bearing.outer.bottom_radius
    yield "pitch diameter", _length(pitch, units), _origin(bearing, "pitch_diameter")
    gap = pitch * np.sin(np.pi / bearing.ball_count) - bearing.ball_diameter
    yield "gap between balls", _length(gap, units), "derived; below 0 the balls would overlap"
    for name in ("inner", "outer"):
        groove = getattr(bearing, name)
        ratio = groove.groove_radius / bearing.ball_diameter
        value = f"{_length(groove.groove_radius, units)} = {ratio:.4g} ball diameters"
        yield f"{name} groove radius", value, _origin(bearing, f"{name}.conformity")
        heights = [
            "not given" if each is None else _length(_rise(groove.groove_radius, each), units)
            for each in groove.half_widths
        ]
        words = heights[0] if heights[0] == heights[1] else f"{heights[0]}, far side {heights[1]}"
        yield f"{name} shoulder height", words, _origin(bearing, f"{name}.shoulder_half_width")
    if bearing.kind == "radial":
        yield "radial clearance", _length(_clearance(bearing), units), _origin(bearing, "clearance")
    yield shown.angle_name, f"{np.degrees(shown.angle):.4g} deg", shown.angle_origin


def _rise(radius: float, half_width: float) -> float:
    """Height of a shoulder above the bottom of its groove, m."""
    return radius - float(np.sqrt(max(radius**2 - half_width**2, 0.0)))


def _clearance(bearing: DrawnBearing) -> float:
    """On the diameter, m."""
    return 2 * (bearing.outer.bottom_radius - bearing.inner.bottom_radius - bearing.ball_diameter)


def _length(value: float, units: Units) -> str:
    """A length, in the small unit where it is short."""
    short = abs(value) < 2e-4
    return (units.small_length if short else units.length).written(value, ".4g" if short else ".5g")


def _origin(bearing: DrawnBearing, key: str) -> str:
    """How a dimension came about, and its source."""
    origin = bearing.origins.get(key)
    if origin is None:
        return "origin not known"
    return textwrap.shorten(f"{origin.status}; {origin.source}", SOURCE, placeholder=" ...")


def _draw_section(panel: Axes, shown: Shown, section: Section, units: Units) -> None:
    """Rings and ball, with dimensions at the left and above, and labels at the right."""
    bearing, size = shown.bearing, shown.bearing.ball_diameter
    copies = _copies(shown)
    for offset, flip in copies:
        _draw_rings(panel, section, size, offset, flip)
        if shown.pocket is not None and bearing.kind == "radial":
            _pocket(panel, section, shown.pocket, offset)
    points = np.concatenate([section.inner.outline, section.outer.outline])
    low, high = points.min(axis=0), points.max(axis=0)
    low[0], high[0] = low[0] + copies[0][0], high[0] + copies[-1][0]
    span = max(float(high[1] - low[1]), 0.72 * float(high[0] - low[0]))
    reach = 0.58 * float(high[1] - low[1] if bearing.kind == "radial" else high[0] - low[0])
    for offset, flip in copies:
        _contact_line(panel, section, shown, (offset, flip), reach)
    diameters = [(bearing.inner.bottom_radius + bearing.outer.bottom_radius, section.ball[1], "pitch circle")]
    if bearing.bore_diameter is not None:
        diameters.append((bearing.bore_diameter, bearing.bore_diameter / 2, "bore"))
    if bearing.outside_diameter is not None:
        diameters.insert(0, (bearing.outside_diameter, bearing.outside_diameter / 2, "outside"))
    floor = low[1] - (0.62 if len(copies) == 1 else 0.85) * span
    for number, (value, y, name) in enumerate(diameters):
        x = low[0] - (0.62 - 0.20 * number) * span
        _diameter(panel, (x, y), floor, float(low[0]), f"{name} \u2300 {_length(value, units)}")
    if bearing.width is not None:
        ends = (low[0], high[0]) if bearing.kind == "thrust" else (low[0], low[0] + bearing.width)
        name = "height" if bearing.kind == "thrust" else "width"
        _across(panel, ends, float(high[1]), span, f"{name} {_length(bearing.width, units)}")
    last = copies[-1]
    labels = _labels(shown, section, units, last)
    middle, step = (high[1] + low[1]) / 2, 0.205 * span
    _leaders(panel, labels, x=float(high[0]) + 0.24 * span, middle=float(middle) - 0.16 * span, step=step)
    panel.set_xlim(low[0] - 0.78 * span, high[0] + (1.68 if len(copies) == 1 else 1.8) * span)
    panel.set_ylim(floor, high[1] + 0.42 * span)
    panel.set_aspect("equal", adjustable="box", anchor="C")
    panel.set_axis_off()


def _copies(shown: Shown) -> list[tuple[float, int]]:
    """Place along the axis, m, and 1 or -1 for a bearing that is turned round; one bearing, or both of a pair."""
    if shown.arrangement is None:
        return [(0.0, 1)]
    width = shown.bearing.width
    apart = shown.distance or width or 2 * shown.bearing.ball_diameter
    turned = {"O": (1, -1), "X": (-1, 1), "tandem": (1, 1)}[shown.arrangement]
    return [(-apart / 2, turned[0]), (apart / 2, turned[1])]


def _draw_rings(panel: Axes, section: Section, ball: float, offset: float, flip: int) -> None:
    """Both rings hatched, and the ball between."""
    for ring, hatch in ((section.inner, "\\\\\\"), (section.outer, "///")):
        outline = _moved(ring.outline, offset, flip)
        panel.add_patch(Polygon(outline, closed=True, facecolor=STEEL, edgecolor="0.72", hatch=hatch, linewidth=0))
        _outline(panel, ring, offset, flip)
    panel.add_patch(Circle((offset, section.ball[1]), ball / 2, facecolor=BALL, edgecolor=LINE, linewidth=1))
    for across in (True, False):  # centre lines of the ball
        ends = np.array([-0.58, 0.58]) * ball
        x, y = (offset + ends, [section.ball[1]] * 2) if across else ([offset] * 2, section.ball[1] + ends)
        panel.plot(x, y, color=GREY, linewidth=0.6, linestyle=CENTRE)


def _outline(panel: Axes, ring: RingSection, offset: float, flip: int) -> None:
    for line in ring.lines:
        look = {"color": LINE, "linewidth": 1.1} if line.known else {"color": RED, "linewidth": 0.9, "linestyle": "--"}
        panel.plot(*_moved(line.points, offset, flip).T, **look)


def _moved(points: Array, offset: float, flip: int) -> Array:
    return points * [flip, 1.0] + [offset, 0.0]


def _pocket(panel: Axes, section: Section, diameter: float, offset: float) -> None:
    """The cage's pocket on both sides of the ball."""
    angle = np.radians(np.linspace(-38, 38, 31))
    for side in (-1, 1):
        x = offset + side * diameter / 2 * np.cos(angle)
        panel.plot(x, section.ball[1] + diameter / 2 * np.sin(angle), color="#009E73", linewidth=1, linestyle=":")


def _contact_line(panel: Axes, section: Section, shown: Shown, copy: tuple[float, int], reach: float) -> None:
    """The line of contact through the ball, in the slope of its angle."""
    offset, flip = copy
    across = np.array([np.sin(shown.angle), np.cos(shown.angle)]) * [flip, 1]
    middle = np.array([offset, section.ball[1]])
    ends = np.array([middle - reach * across, middle + reach * across])
    panel.plot(*ends.T, color=BLUE, linewidth=1, linestyle=(0, (6, 2)))


def _diameter(panel: Axes, head: tuple[float, float], floor: float, edge: float, words: str) -> None:
    """A diameter as half a dimension line, which goes on beyond the axis."""
    panel.plot([head[0], edge], [head[1], head[1]], color=LINE, linewidth=0.5)
    panel.annotate(
        "",
        xy=head,
        xytext=(head[0], floor),
        arrowprops=ARROW | {"arrowstyle": "-|>"},
    )
    _write(panel, head[0], floor, f" {words}", rotation=90, ha="right", va="bottom", fontsize=LETTERS)


def _across(panel: Axes, ends: Sequence[float], edge: float, span: float, words: str) -> None:
    """A dimension along the axis, above the rings."""
    height = edge + 0.22 * span
    for x in ends:
        panel.plot([x, x], [edge + 0.02 * span, height + 0.03 * span], color=LINE, linewidth=0.5)
    panel.annotate(
        "",
        xy=(ends[0], height),
        xytext=(ends[1], height),
        arrowprops=ARROW | {"arrowstyle": "<|-|>"},
    )
    _write(panel, sum(ends) / 2, height + 0.03 * span, words, ha="center", va="bottom", fontsize=LETTERS)


def _labels(shown: Shown, section: Section, units: Units, copy: tuple[float, int]) -> list[Label]:
    """What is named at the right of the section, from the top."""
    bearing, (offset, flip) = shown.bearing, copy
    radius, middle = bearing.ball_diameter / 2, np.array([0.0, section.ball[1]])
    slope = np.array([np.sin(shown.angle), np.cos(shown.angle)])
    tip = _moved(middle + 1.42 * radius * slope, offset, flip)

    def right_of(ring: RingSection) -> tuple[float, float]:
        """Near the right end of a groove."""
        points = _moved(ring.groove.points, offset, flip)
        ordered = points[np.argsort(points @ ([1.0, 0.0] if bearing.kind == "radial" else [0.0, 1.0]))]
        low = bearing.kind == "thrust" and ring is section.inner
        return tuple(ordered[round((0.06 if low else 0.95) * (len(ordered) - 1))])

    around = np.radians(-8)
    beside = (offset + radius * np.cos(around), section.ball[1] + radius * np.sin(around))
    labels = [
        Label(f"{shown.angle_name}\n{np.degrees(shown.angle):.4g} deg", tuple(tip), BLUE),
        *(
            Label(
                f"{name} groove, radius {_length(groove.groove_radius, units)}\n= "
                f"{groove.groove_radius / bearing.ball_diameter:.4g} of the ball diameter",
                right_of(ring),
            )
            for name, groove, ring in (("outer", bearing.outer, section.outer), ("inner", bearing.inner, section.inner))
        ),
        Label(f"ball \u2300 {_length(bearing.ball_diameter, units)}\n{bearing.ball_material.name}", beside),
    ]
    if bearing.kind == "radial":
        down = (offset + 0.28 * radius, section.ball[1] - 0.96 * radius)
        words = f"radial clearance {_length(_clearance(bearing), units)}\non the diameter, too small to see"
        if _clearance(bearing) > 0.02 * bearing.ball_diameter:
            words = words.partition(",")[0]
        labels.append(Label(words, down))
    if shown.pocket is not None and bearing.kind == "radial":
        place = (offset + shown.pocket / 2 * np.cos(0.5), section.ball[1] + shown.pocket / 2 * np.sin(0.5))
        labels.append(Label(f"cage pocket \u2300 {_length(shown.pocket, units)}", place, "#00704f"))
    return labels


def _leaders(panel: Axes, labels: Sequence[Label], *, x: float, middle: float, step: float) -> None:
    """Labels one below the other in the order of what they name, so that no line crosses another."""
    ordered = sorted(labels, key=lambda label: -label.place[1])
    for number, label in enumerate(ordered):
        y = middle + ((len(ordered) - 1) / 2 - number) * 1.25 * step
        panel.plot([label.place[0], x - 0.25 * step, x], [label.place[1], y, y], color=label.colour, linewidth=0.5)
        panel.plot(*label.place, "o", color=label.colour, markersize=2)
        _write(
            panel, x + 0.1 * step, y, label.words, va="center", fontsize=LETTERS, color=label.colour, linespacing=1.05
        )


def _draw_side(panel: Axes, shown: Shown, section: Section, units: Units) -> None:
    """The view along the axis: rings, and balls on their circle."""
    bearing = shown.bearing
    pitch, radius = (bearing.inner.bottom_radius + bearing.outer.bottom_radius) / 2, bearing.ball_diameter / 2
    circles = _circles(bearing, section)
    for place, known in circles:
        look = {"edgecolor": LINE} if known else {"edgecolor": RED, "linestyle": "--"}
        panel.add_patch(Circle((0, 0), place, fill=False, linewidth=0.9, **look))
    panel.add_patch(Circle((0, 0), pitch, fill=False, edgecolor=GREY, linewidth=0.7, linestyle=CENTRE))
    for number in range(bearing.ball_count):
        angle = 2 * np.pi * number / bearing.ball_count
        centre = (pitch * np.sin(angle), pitch * np.cos(angle))
        panel.add_patch(Circle(centre, radius, facecolor=BALL, edgecolor=LINE, linewidth=0.8))
    most = max([pitch + radius, *(place for place, _ in circles)])
    panel.plot([-0.1 * most, 0.1 * most], [0, 0], color=GREY, linewidth=0.6)
    panel.plot([0, 0], [-0.1 * most, 0.1 * most], color=GREY, linewidth=0.6)
    panel.set_xlim(-1.04 * most, 1.04 * most)
    panel.set_ylim(-1.36 * most, 1.04 * most)
    panel.set_aspect("equal", adjustable="box", anchor="N")
    words = f"{bearing.ball_count} balls of \u2300 {_length(2 * radius, units)}\n"
    words += f"on a circle of \u2300 {_length(2 * pitch, units)}"
    _write(panel, 0, -1.08 * most, words, ha="center", va="top", fontsize=LETTERS)
    panel.set_axis_off()


def _circles(bearing: DrawnBearing, section: Section) -> list[tuple[float, bool]]:
    """Radii of the rings' edges in the view along the axis, m, and whether they are known."""
    if bearing.kind == "thrust":
        faces = [(face.points[0, 1], face.known) for face in section.inner.faces]
        return [(float(radius), known) for radius, known in faces]
    lands = [(ring.lands[0].points[0, 1], ring.lands[0].known) for ring in (section.inner, section.outer)]
    seats = [(ring.seat.points[0, 1], ring.seat.known) for ring in (section.inner, section.outer)]
    return [(float(radius), known) for radius, known in [*seats, *lands]]


def _table(figure: Figure, rows: Sequence[tuple[str, str, str]], high: float) -> None:
    """Dimensions with their origin, below the views."""
    places = (0.012, 0.205, 0.48)
    top = (ROW * (len(rows) + 1) + FOOT - 0.04) / high
    for x, words in zip(places, ("dimension", "value", "origin"), strict=True):
        _write(figure, x, top, words, fontsize=SMALL, weight="bold", va="top")
    for number, row in enumerate(rows, start=1):
        for x, words in zip(places, row, strict=True):
            colour = RED if words.startswith("not given") or re.match(r"-\d", words) else LINE
            _write(figure, x, top - number * ROW / high, words, fontsize=SMALL, va="top", color=colour)


def _write(where: Axes | Figure, x: float, y: float, words: str, **look: Any) -> None:
    """Words as they stand: names come from a person, and a dollar sign begins no formula."""
    where.text(x, y, words, parse_math=False, **look)
