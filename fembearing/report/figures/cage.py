"""Orbit and forces of a cage in motion."""

import textwrap
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from analytic.figures.style import BLACK, BLUE, LETTERS, ORANGE, RED, TITLE, WIDTH, give_title, lettered, plain_numbers
from analytic.units import MILLISECOND, Units
from fembearing.check.cage_record import DrawnMotion
from fembearing.report.report import Report

STARTING, MEASURED, BLOCKS, LIMIT = "silver", BLUE, RED, BLACK
HIGH, CAPTION_HIGH = 2.7, 1.0  # inches
LEAST_SHOWN = 1e-3  # of the median of blocks: a force below is nothing
BELOW = 4.0  # letters, from a panel to its key: the ticks and the name of the axis are between
WIDE = 20.0  # from the least force to the greatest: beyond, a logarithmic scale
WHAT_TO_SEE = {
    "rest": "The cage rests: after the start-up its centre stays at one place, displaced sideways by the friction of "
    "the turning balls; the forces carry its weight.",
    "whirl": "The cage whirls: its centre orbits at the edge of its clearance, and the cage rolls on its balls; nearly "
    "steady forces hold it on its circle.",
    "irregular": "The cage moves irregularly, from impact to impact. The largest force grows with the duration: use "
    "the median of blocks with its interval.",
    "mixed": "The seeds reach different regimes; this is one of them.",
}


def cage_plot(document: Report) -> tuple[list[Figure] | None, str]:
    """A figure for each motion that was kept: of the slowest and the fastest point whose cage moved."""
    motions = document.cage_records
    if not motions:
        return None, _why_at_rest(document)
    seen = [WHAT_TO_SEE[state] for state in dict.fromkeys(motion.state for motion in motions)]
    blocks = " and ".join(dict.fromkeys(_blocks(motion) for motion in motions))
    start_ups = " and ".join(dict.fromkeys(f"{motion.start_up:g} s" for motion in motions))
    figures = [orbit_figure(motion, document.units) for motion in motions]
    return figures, f"{' '.join(seen)} {_drawn(start_ups, blocks)}"


def _why_at_rest(document: Report) -> str:
    """Why there is no motion to draw."""
    if document.torque is None:
        return "No motion of the cage: the scene has no torque."
    return (
        "No motion of the cage: the torque has the closed form of a cage at rest on its balls, or no cage. The motion "
        "is computed for a scene with cage.start, where the cage can leave its rest."
    )


def cage_caption(motion: DrawnMotion) -> str:
    """What is drawn, and what to see in it."""
    return f"{WHAT_TO_SEE[motion.state]} {_drawn(f'{motion.start_up:g} s', _blocks(motion))}"


def _blocks(motion: DrawnMotion) -> str:
    return f"{len(motion.block_maxima)} blocks of {motion.block:.3g} s"


def _drawn(start_up: str, blocks: str) -> str:
    """What each panel shows."""
    return (
        f"Orbit: start-up of {start_up} (grey, not in the statistics), then blue; dashed: edge of the clearance, where "
        "the balls stop a level cage. Forces: the largest of one ball on its pocket since the instant before, and the "
        "sum over all balls; grey: start-up. Share of exceedance: instants of this motion, and "
        f"{blocks} of all seeds; band: 95 % interval of their median. This motion is a new run: after an irregular "
        "start-up it may differ from those in the statistics."
    )


def orbit_figure(motion: DrawnMotion, units: Units, *, captioned: bool = False) -> Figure:
    """Orbit of the cage's centre, forces over time, and how often each force is exceeded."""
    figure = Figure(figsize=(WIDTH, HIGH + (CAPTION_HIGH if captioned else 0.0)), layout="constrained")
    for panel, draw in zip(figure.subplots(1, 3), (_orbit, _forces, _excess), strict=True):
        draw(panel, motion, units)
    torque, high = (units.torque.written(value, ".3g") for value in (motion.torque, motion.torque_interval[1]))
    low = f"{units.torque.number(motion.torque_interval[0]):.3g}"
    give_title(
        figure,
        f'{motion.bearing} at {units.speed.written(motion.inner_speed, ".5g")}: regime "{motion.state}", started '
        f'"{motion.start}"; cage torque {torque}, {low} to {high} at 95 %',
        fontsize=TITLE,
    )
    if captioned:
        figure.supxlabel(textwrap.fill(cage_caption(motion), 114), x=0.01, ha="left", fontsize=LETTERS)
    return lettered(figure)


def _orbit(panel: Axes, motion: DrawnMotion, units: Units) -> None:
    """The orbit of the cage's centre, and the edge of its room."""
    orbit, room, small = motion.orbit, motion.room, units.small_length
    look: dict[str, Any] = {"lw": 0.6} if orbit.joined else {"linestyle": "none", "marker": ".", "ms": 2.5}
    for part, colour, label in (("start_up", STARTING, "start-up"), ("measured", MEASURED, "measured")):
        panel.plot(*(small.factor * np.array(getattr(orbit, part))).T, color=colour, label=label, **look)
    panel.plot(*(small.factor * np.array(room.edge)).T, "--", color=LIMIT, lw=1, label="edge of its clearance")
    panel.plot(*(small.factor * np.array(orbit.measured[-1])), "o", color=MEASURED, mec="black", ms=6, label="end")
    _gravity(panel, np.array(motion.gravity[:2]))
    panel.set(xlabel=f"x, {small.name}", ylabel=f"y, {small.name}")
    panel.set_title("Orbit of the cage's centre")
    panel.set_aspect("equal", adjustable="datalim")
    panel.set_box_aspect(1)
    panel.margins(0.12)
    panel.grid(alpha=0.3)
    _key(panel, columns=2)


def _gravity(panel: Axes, pull: np.ndarray) -> None:
    """An arrow for gravity in the corner, off the orbit."""
    if not pull.any():
        return
    along = 0.06 * pull / np.linalg.norm(pull)
    corner = np.array([0.09, 0.91])  # of the panel
    look = {"xycoords": "axes fraction", "textcoords": "axes fraction", "annotation_clip": False}
    panel.annotate("", xy=tuple(corner + along), xytext=tuple(corner - along), arrowprops={"arrowstyle": "->"}, **look)
    panel.text(0.15, 0.93, "gravity", transform=panel.transAxes, va="center", fontsize=LETTERS)


def _forces(panel: Axes, motion: DrawnMotion, units: Units) -> None:
    """Forces of the balls over time."""
    force, forces, start_up = units.force, motion.forces, MILLISECOND.factor * motion.start_up
    median = force.number(motion.max_force)
    least = np.inf
    for name, colour, label in (("sum", ORANGE, "sum over all balls"), ("largest", MEASURED, "largest of one ball")):
        values = force.factor * np.array(getattr(forces, name))
        shown = np.where(values > 0, values, np.nan)
        least = min(least, values[values > 0].min(initial=np.inf))
        panel.plot(MILLISECOND.factor * np.array(forces.time), shown, color=colour, lw=0.6, label=label)
    panel.axvspan(0, start_up, color=STARTING, alpha=0.35, lw=0)
    panel.axhline(median, color=BLOCKS, ls="--", lw=1, label=f"median of blocks, {median:.3g} {force.name}")
    panel.set(xlabel=f"time, {MILLISECOND.name}", ylabel=f"force on the cage, {force.name}")
    panel.set_title("Forces")
    low = max(LEAST_SHOWN * median, min(least, median) / 2)
    panel.set(yscale="log", xlim=(0, 2 * start_up), ylim=(low if low > 0 else None, None))
    plain_numbers(panel.yaxis)
    panel.grid(alpha=0.3)
    _key(panel)


def _excess(panel: Axes, motion: DrawnMotion, units: Units) -> None:
    """How often each force is exceeded."""
    factor = units.force.factor
    instants, blocks = motion.exceedance, factor * np.sort(motion.block_maxima)
    median = factor * motion.max_force
    of_blocks = np.arange(blocks.size, 0, -1) / blocks.size  # no smaller one lies above it
    for force, share, colour, label in (
        (factor * np.array(instants.force), np.array(instants.share), MEASURED, "instants of this motion"),
        (blocks, of_blocks, BLOCKS, "blocks of all seeds"),
    ):
        panel.step(force, 100 * share, where="pre", color=colour, label=label)
    panel.axvspan(*(factor * np.array(motion.max_force_interval)), color=BLOCKS, alpha=0.2, lw=0)
    panel.axvline(median, color=BLOCKS, ls="--", lw=1, label="median of blocks, 95 %")
    panel.set(xlabel=f"largest force of one ball, {units.force.name}", ylabel="exceeded in, %")
    panel.set_title("Share of exceedance")
    panel.set(yscale="log", ylim=(None, 150))
    plain_numbers(panel.yaxis)
    least, most = panel.get_xlim()
    if most > WIDE * max(least, LEAST_SHOWN * median):
        panel.set(xscale="log", xlim=(max(least, LEAST_SHOWN * median), 1.3 * most))
        plain_numbers(panel.xaxis)
    panel.grid(alpha=0.3, which="both")
    _key(panel)


def _key(panel: Axes, *, columns: int = 1) -> None:
    """Below the panel, where no data are."""
    panel.legend(
        loc="upper center",
        bbox_to_anchor=(0.5, 0),
        borderaxespad=BELOW,
        ncols=columns,
        columnspacing=1.0,
        fontsize=LETTERS,
        frameon=False,
    )
