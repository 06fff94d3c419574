"""Load and contact angle of every ball around the ring."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.projections.polar import PolarAxes
from matplotlib.ticker import MaxNLocator

from analytic.columns import Point
from analytic.figures.style import BLUE, LETTERS, RED, WIDTH, lettered
from analytic.units import Units, speed_words
from fembearing.report.figures.torque import NO_TORQUE
from fembearing.report.report import Report
from fembearing.report.sections.points import loads_of, present_loads

LOOKS = {"inner": (BLUE, "o", "-"), "outer": (RED, "s", "--")}  # the lines may lie on each other
HIGH, LINE = 2.4, 0.17  # inches, without the loads in the titles, and for each of them
PAD = 0.1  # inches above and below: the layout counts a little too little for the title of a polar panel
LEAST_SPAN = 0.1  # degrees, of the angles: closer ones are alike, and their round-off is not to be seen
NO_ANGLE = 1e-9  # rad: round-off
QUARTER = 90  # degrees between ticks of the azimuth


def ring_plot(document: Report) -> tuple[Figure | None, str]:
    """Polar plots of the loads, and beside them the angles, at the first and the last operating point."""
    torque, units = document.solved, document.units
    if torque is None:
        return None, NO_TORQUE
    points, state = torque.points, torque.friction.ring
    if state is None:
        return None, "Pair of bearings: ring and balls of each bearing are available from Python."
    shown = [(points[place], state.rows[place]["balls"]) for place in sorted({0, len(points) - 1})]
    every = (angle for _, balls in shown for race in LOOKS for angle in balls[f"{race}_angle"])
    angles = [angle for angle in every if angle is not None]
    leans = max(map(abs, angles), default=0.0) > NO_ANGLE
    loads = present_loads(points)
    layout = ConstrainedLayoutEngine(h_pad=PAD)
    figure = Figure(figsize=(WIDTH, HIGH + LINE * len(loads)), layout=layout)
    grid = figure.add_gridspec(1, (1 + leans) * len(shown))
    for column, (point, balls) in enumerate(shown):
        polar = figure.add_subplot(grid[column], projection="polar")
        assert isinstance(polar, PolarAxes)
        words = [speed_words(point["inner_speed"], units), *(loads_of(point, [name], units) for name in loads)]
        _loads(polar, balls, units)
        panels: list[Axes] = [polar]
        if leans:
            panels.append(figure.add_subplot(grid[len(shown) + column]))
            _angles(panels[1], balls)
        for panel in panels:
            panel.set_title("\n".join(words))
    handles, labels = figure.axes[0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=2, frameon=False, fontsize=LETTERS)
    right = ", and right: its contact angle" if leans else ""
    caption = (
        f"Load of every ball, {units.force.name}{right}, around the bearing. 0 degrees: direction of the radial load, "
        f"x. A ball at the centre is unloaded.{'' if leans else ' All contact angles are 0.'}"
    )
    return lettered(figure), caption


def _loads(panel: PolarAxes, balls: Point, units: Units) -> None:
    azimuth = np.append(balls["azimuth"], balls["azimuth"][0] + 2 * np.pi)  # closed
    for race, (colour, mark, line) in LOOKS.items():
        load = [units.force.number(each) for each in balls[f"{race}_load"]]
        panel.plot(azimuth, [*load, load[0]], f"{line}{mark}", color=colour, markersize=4, label=f"{race} race")
    most = 1.1 * units.force.number(max(*balls["inner_load"], *balls["outer_load"], 1e-12))
    panel.set_rticks([tick for tick in MaxNLocator(3).tick_values(0, most) if 0 < tick < most])
    panel.set_ylim(0, most)
    panel.set_thetagrids(range(0, 360, QUARTER))
    panel.set_rlabel_position(1.5 * QUARTER)  # where a radial load presses no ball


def _angles(panel: Axes, balls: Point) -> None:
    for race, (colour, mark, _) in LOOKS.items():
        angle = [np.nan if each is None else np.degrees(each) for each in balls[f"{race}_angle"]]
        panel.plot(np.degrees(balls["azimuth"]), angle, mark, color=colour, markersize=4)
    panel.set(xlabel="azimuth, deg", ylabel="contact angle, deg", xlim=(-10, 360))
    panel.set_xticks(range(0, 361, QUARTER))
    low, high = panel.get_ylim()
    beyond = max(0.0, (LEAST_SPAN - (high - low)) / 2)
    panel.set_ylim(low - beyond, high + beyond)
    panel.ticklabel_format(axis="y", style="plain", useOffset=False)
    panel.grid(alpha=0.3)
