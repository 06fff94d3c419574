"""The outlines of a bearing cut through a ball, to scale: x along the axis, y from the axis.

The ball touches both races without load, at the unloaded contact angle; the faces of the rings are drawn flush.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np

from analytic.scene import Array, Groove, Material, Origin

UNKNOWN_SHOULDER, UNKNOWN_SEAT, UNKNOWN_WIDTH = 0.36, 0.35, 1.9  # ball diameters, where the scene has no dimension
POINTS = 61  # of an arc
MOST_BALLS, MOST_RATIO = 500, 1e4  # beyond, no drawing would show anything


class DrawnBearing(Protocol):
    """What a drawing needs of a bearing."""

    @property
    def name(self) -> str: ...
    @property
    def kind(self) -> Literal["radial", "thrust"]: ...
    @property
    def ball_count(self) -> int: ...
    @property
    def ball_diameter(self) -> float: ...
    @property
    def ball_material(self) -> Material: ...
    @property
    def inner(self) -> Groove: ...
    @property
    def outer(self) -> Groove: ...
    @property
    def bore_diameter(self) -> float | None: ...
    @property
    def outside_diameter(self) -> float | None: ...
    @property
    def width(self) -> float | None: ...
    @property
    def origins(self) -> Mapping[str, Origin]: ...


@dataclass(frozen=True, kw_only=True, eq=False)
class Line:
    """A part of an outline, (n, 2), m."""

    points: Array
    known: bool = True  # else drawn at a guess, as the scene does not have the dimension


@dataclass(frozen=True, kw_only=True, eq=False)
class RingSection:
    """A ring, or a washer."""

    groove: Line
    lands: tuple[Line, Line]  # at the lower and the higher coordinate along the groove's width
    faces: tuple[Line, Line]
    seat: Line

    @property
    def lines(self) -> tuple[Line, ...]:
        """All of its outline."""
        return (self.groove, *self.lands, *self.faces, self.seat)

    @property
    def outline(self) -> Array:
        """(n, 2) closed, m."""
        low, high = self.lands
        return np.concatenate([low.points, self.groove.points, high.points, self.seat.points[::-1]])


@dataclass(frozen=True, kw_only=True, eq=False)
class Section:
    """A bearing cut through a ball, m."""

    ball: tuple[float, float]  # its centre
    angle: float  # of the line of contact to the radial plane, rad
    inner: RingSection
    outer: RingSection

    @property
    def across(self) -> Array:
        """(2,) unit vector along the line of contact, to the outer race."""
        return np.array([np.sin(self.angle), np.cos(self.angle)])


def is_drawable(bearing: DrawnBearing) -> bool:
    """Whether the dimensions are those of one thing: a damaged file may hold any numbers."""
    rings = (bearing.inner, bearing.outer)
    lengths = [bearing.bore_diameter, bearing.outside_diameter, bearing.width]
    lengths += [length for ring in rings for length in (ring.bottom_radius, ring.groove_radius, *ring.half_widths)]
    known = np.array([length for length in lengths if length is not None]) / bearing.ball_diameter
    return bool(
        np.all(known >= 0)
        and np.all(known < MOST_RATIO)
        and 0 < bearing.ball_count <= MOST_BALLS
        and all(ring.bottom_radius > 0 and ring.groove_radius > 0 for ring in rings)
    )


def unloaded_angle(bearing: DrawnBearing) -> float:
    """The contact angle that the clearance allows, rad; 0 for a preload, a quarter turn for a thrust bearing."""
    if bearing.kind == "thrust":
        return np.pi / 2
    distance = bearing.inner.groove_radius + bearing.outer.groove_radius - bearing.ball_diameter
    play = bearing.outer.bottom_radius - bearing.inner.bottom_radius - bearing.ball_diameter
    return 0.0 if play <= 0 or distance <= 0 else float(np.arccos(max(1 - play / distance, 0.0)))


def section_of(bearing: DrawnBearing, *, angle: float | None = None) -> Section:
    """The section; angle : of the line of contact without load, rad, in place of the one that the clearance allows."""
    slope = unloaded_angle(bearing) if angle is None else angle
    if bearing.kind == "thrust":
        return _thrust_section(bearing)
    inner, outer, radius = bearing.inner, bearing.outer, bearing.ball_diameter / 2
    middle = outer.bottom_radius - outer.groove_radius + (outer.groove_radius - radius) * np.cos(slope)
    ball = np.array([0.0, middle])
    across = np.array([np.sin(slope), np.cos(slope)])
    centres = ball + (inner.groove_radius - radius) * across, ball - (outer.groove_radius - radius) * across
    half = _unknown_half_width(bearing) if bearing.width is None else bearing.width / 2
    near, far = outer.half_widths  # thrust loads the outer ring's at larger x, the inner ring's at smaller x
    seats = [None if each is None else each / 2 for each in (bearing.bore_diameter, bearing.outside_diameter)]
    rings = [
        _ring(groove, centre=centre, side=side, widths=widths, ends=(-half, half), seat=seat, ball=2 * radius)
        for groove, centre, side, widths, seat in (
            (inner, centres[0], 1, inner.half_widths, seats[0]),
            (outer, centres[1], -1, (far, near), seats[1]),
        )
    ]
    known = [_with_faces(ring, known=bearing.width is not None) for ring in rings]
    return Section(ball=(0.0, float(middle)), angle=slope, inner=known[0], outer=known[1])


def _unknown_half_width(bearing: DrawnBearing) -> float:
    """Of a ring whose width is not known, wider than its groove, m."""
    known = [each for ring in (bearing.inner, bearing.outer) for each in ring.half_widths if each is not None]
    return max([UNKNOWN_WIDTH / 2 * bearing.ball_diameter, *(1.2 * each for each in known)])


def _thrust_section(bearing: DrawnBearing) -> Section:
    """Both washers, the turning one at the left; their near shoulder is the outer one."""
    middle, radius = bearing.inner.bottom_radius, bearing.ball_diameter / 2
    guess = _unknown_half_width(bearing)
    bore, outside = bearing.bore_diameter, bearing.outside_diameter
    ends = (-guess if bore is None else bore / 2 - middle, guess if outside is None else outside / 2 - middle)
    rings = []
    for groove, side in ((bearing.inner, 1), (bearing.outer, -1)):
        centre = np.array([0.0, side * (groove.groove_radius - radius)])
        height = None if bearing.width is None else -side * bearing.width / 2
        near, far = groove.half_widths
        drawn = _ring(groove, centre=centre, side=side, widths=(far, near), ends=ends, seat=height, ball=2 * radius)
        lands = _turned(drawn.lands[0], middle), _turned(drawn.lands[1], middle)
        low, high = (_turned(face, middle).points for face in drawn.faces)
        faces = Line(points=low, known=bore is not None), Line(points=high, known=outside is not None)
        groove_line, seat = _turned(drawn.groove, middle), _turned(drawn.seat, middle)
        rings.append(RingSection(groove=groove_line, lands=lands, faces=faces, seat=seat))
    return Section(ball=(0.0, middle), angle=np.pi / 2, inner=rings[0], outer=rings[1])


def _turned(line: Line, middle: float) -> Line:
    """A line of a ring as one of a washer: across becomes along the axis."""
    return Line(points=np.column_stack([line.points[:, 1], middle + line.points[:, 0]]), known=line.known)


def _with_faces(ring: RingSection, *, known: bool) -> RingSection:
    """The ring with both faces known, or not."""
    low, high = (Line(points=face.points, known=known) for face in ring.faces)
    return RingSection(groove=ring.groove, lands=ring.lands, faces=(low, high), seat=ring.seat)


def _ring(
    groove: Groove,
    *,
    centre: Array,
    side: int,
    widths: tuple[float | None, float | None],
    ends: tuple[float, float],
    seat: float | None,
    ball: float,
) -> RingSection:
    """A ring whose groove lies at the larger height (side 1) or at the smaller one (side -1).

    centre : (2,) of the groove's profile: along its width, and height;  widths : to the lower and the higher shoulder
    ends : of the ring along its width, from the ball;  seat : height of the seat
    """
    radius = groove.groove_radius
    halves = [min(UNKNOWN_SHOULDER * ball if each is None else each, radius) for each in widths]
    along = np.linspace(-halves[0], halves[1], POINTS)
    profile = np.column_stack([centre[0] + along, centre[1] - side * np.sqrt(np.maximum(radius**2 - along**2, 0.0))])
    bottom = centre[1] - side * radius
    height = bottom - side * UNKNOWN_SEAT * ball if seat is None else seat
    low, high = ends[0], ends[1]
    return RingSection(
        groove=Line(points=profile),
        lands=(
            Line(points=np.array([[low, profile[0, 1]], profile[0]]), known=widths[0] is not None),
            Line(points=np.array([profile[-1], [high, profile[-1, 1]]]), known=widths[1] is not None),
        ),
        faces=(
            Line(points=np.array([[low, height], [low, profile[0, 1]]])),
            Line(points=np.array([[high, height], [high, profile[-1, 1]]])),
        ),
        seat=Line(points=np.array([[low, height], [high, height]]), known=seat is not None),
    )
