"""Load and contact angle of every ball around the ring."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.projections.polar import PolarAxes

from fembearing.quantities import Units
from fembearing.report.document.report import Report
from fembearing.report.document.ring import Balls
from fembearing.report.figures.style import BLUE, RED, WIDTH
from fembearing.report.figures.torque import NO_TORQUE
from fembearing.report.phrases import loads_of, present_loads

LOOKS = {"inner": (BLUE, "o", "-"), "outer": (RED, "s", "--")}  # the lines may lie on each other
QUARTER = 90  # degrees between ticks of the azimuth


def ring_plot(document: Report) -> tuple[Figure | None, str]:
    """Polar plots of the loads, and beside them the angles, at the first and the last operating point."""
    if document.torque is None:
        return None, NO_TORQUE
    points, units = document.torque.points, document.units
    ends = [points[0], *points[1:][-1:]]
    shown = [(point, point.ring.balls) for point in ends if point.ring is not None]
    if not shown:
        return None, "The scene has a pair of bearings: ring and balls are those of each bearing, from Python."
    figure = Figure(figsize=(WIDTH, 2.8), layout="constrained")
    for part, (point, balls) in zip(figure.subfigures(1, len(shown), squeeze=False)[0], shown, strict=True):
        words = loads_of(point, present_loads(points), units)
        part.suptitle(f"{units.speed.written(point.inner_speed, '.4g')}, {words}", fontsize=10)
        polar = part.add_subplot(1, 2, 1, projection="polar")
        assert isinstance(polar, PolarAxes)
        _loads(polar, balls, units)
        _angles(part.add_subplot(1, 2, 2), balls)
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=2, frameon=False, fontsize=9)
    caption = (
        f"Load of every ball, {units.force.name}, and beside it the contact angle, around the bearing. 0 degrees is "
        "the direction of the radial load, x. A ball at the centre carries no load."
    )
    return figure, caption


def _loads(panel: PolarAxes, balls: Balls, units: Units) -> None:
    azimuth = np.append(balls.azimuth, balls.azimuth[0] + 2 * np.pi)  # closed
    for race, (colour, mark, line) in LOOKS.items():
        load = [units.force.number(each) for each in getattr(balls, f"{race}_load")]
        panel.plot(azimuth, [*load, load[0]], f"{line}{mark}", color=colour, markersize=4, label=f"{race} race")
    panel.set_ylim(0, 1.1 * units.force.number(max(*balls.inner_load, *balls.outer_load, 1e-12)))
    panel.tick_params(labelsize=8)
    panel.set_rlabel_position(QUARTER / 4)


def _angles(panel: Axes, balls: Balls) -> None:
    for race, (colour, mark, _) in LOOKS.items():
        angle = [np.nan if each is None else np.degrees(each) for each in getattr(balls, f"{race}_angle")]
        panel.plot(np.degrees(balls.azimuth), angle, mark, color=colour, markersize=4)
    panel.set(xlabel="azimuth, deg", ylabel="contact angle, deg", xlim=(-10, 360))
    panel.set_xticks(range(0, 361, QUARTER))
    panel.ticklabel_format(axis="y", useOffset=False)
    panel.tick_params(labelsize=8)
    panel.grid(alpha=0.3)
