"""Orbit and forces of a cage in motion, side by side."""

import textwrap

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from fembearing.compare.cage_record import CageRecord
from fembearing.report.wording import PER_MINUTE

MICRO, MILLI = 1e6, 1e3
STARTING, MEASURED, BLOCKS, LIMIT = "silver", "tab:blue", "tab:red", "black"
LEAST_SHOWN = 1e-3  # of the median of blocks: a force below is nothing
WIDE = 20.0  # from the least force to the greatest: beyond, a logarithmic scale
WHAT_TO_SEE = {
    "rest": "The cage rests: after the start-up its centre keeps its place, moved sideways by the friction of the "
    "turning balls, and forces come to its weight.",
    "whirl": "The cage whirls: its centre runs round at the edge of its room, rolling on its balls; forces are nearly "
    "steady, and hold it on its circle.",
    "irregular": "The cage moves irregularly, from impact to impact. The largest force grows with the time watched: "
    "trust the median of blocks with its interval, not the largest seen.",
    "mixed": "Seeds came to different regimes: this is one of them, and others look different.",
}


def cage_caption(record: CageRecord) -> str:
    """What is drawn, and what to see in it."""
    found = record.statistics
    return (
        f"{WHAT_TO_SEE[found.state]} Left: grey the start-up of {record.start_up:g} s, which no statistics count, "
        "blue after it; dashed the edge of the room, where the balls stop a level cage. Middle: the largest force of "
        "one ball on its pocket since the instant before, and the sum over all balls at the instant. Right: how often "
        f"a force is exceeded, of instants of this motion and of {len(found.block_maxima)} blocks of {found.block:.3g} "
        "s of all seeds; band: 95 % interval of their median."
    )


def orbit_figure(record: CageRecord) -> Figure:
    """Orbit of the cage's centre, forces over time, and how often each force is exceeded."""
    figure = Figure(figsize=(14, 5.6), layout="constrained")
    orbit, forces, excess = figure.subplots(1, 3, width_ratios=(1.0, 1.25, 1.0))
    _orbit(orbit, record)
    _forces(forces, record)
    _excess(excess, record)
    found, speed = record.statistics, record.cage.ring_speed * PER_MINUTE
    figure.suptitle(
        f'{record.scene.bearing.name} at {speed:.5g} rpm: regime "{found.state}", started "{found.start}"; cage torque '
        f"{found.torque * MILLI:.3g} N mm, {found.torque_interval[0] * MILLI:.3g} to "
        f"{found.torque_interval[1] * MILLI:.3g} at 95 %"
    )
    figure.supxlabel(textwrap.fill(cage_caption(record), 190), x=0.01, ha="left", fontsize=9)
    return figure


def _orbit(panel: Axes, record: CageRecord) -> None:
    centre, after = MICRO * record.series.centre, record.measured
    panel.plot(*centre[~after, :2].T, color=STARTING, lw=0.6, label="start-up")
    panel.plot(*centre[after, :2].T, color=MEASURED, lw=0.6, label="measured")
    angle = np.linspace(0, 2 * np.pi, 361)
    directions = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    way = np.array([record.cage.free_way(direction) for direction in directions])
    edge = MICRO * (record.cage.middle + way[:, None] * directions)
    panel.plot(*edge[:, :2].T, "--", color=LIMIT, lw=1, label="edge of its room")
    panel.plot(*centre[-1, :2], "o", color=MEASURED, mec="black", ms=6, label="end")
    pull = np.array(record.cage.gravity[:2])
    if pull.any():
        middle = MICRO * record.cage.middle[:2]
        head = middle + 0.35 * MICRO * record.cage.room * pull / np.linalg.norm(pull)
        panel.annotate("", xy=tuple(head), xytext=tuple(middle), arrowprops={"arrowstyle": "->"})
        panel.annotate("gravity", xy=tuple(head), xytext=(0, -12), textcoords="offset points", ha="center", fontsize=9)
    panel.set(xlabel="x, µm", ylabel="y, µm", title="Orbit of the cage's centre")
    panel.set_aspect("equal", adjustable="datalim")
    panel.margins(0.12)
    panel.grid(alpha=0.3)
    panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=2, fontsize=8, frameon=False)


def _forces(panel: Axes, record: CageRecord) -> None:
    series, found = record.series, record.statistics
    time = MILLI * series.time
    total = np.linalg.norm(series.force, axis=2).sum(axis=1)
    for values, colour, label in (
        (total, "tab:orange", "sum over all balls"),
        (series.max_force, MEASURED, "largest of one ball"),
    ):
        panel.plot(time, np.where(values > 0, values, np.nan), color=colour, lw=0.6, label=label)
    panel.axvspan(0, MILLI * record.start_up, color=STARTING, alpha=0.35, lw=0, label="start-up")
    panel.axhline(found.max_force, color=BLOCKS, ls="--", lw=1, label=f"median of blocks, {found.max_force:.3g} N")
    panel.set(xlabel="time, ms", ylabel="force of balls on the cage, N", title="Forces")
    panel.set(yscale="log", xlim=(0, 2 * MILLI * record.start_up), ylim=(LEAST_SHOWN * found.max_force, None))
    panel.yaxis.set_major_formatter("{x:g}")
    panel.grid(alpha=0.3)
    panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=2, fontsize=8, frameon=False)


def _excess(panel: Axes, record: CageRecord) -> None:
    found = record.statistics
    for values, colour, label in (
        (record.series.max_force[record.measured], MEASURED, "instants of this motion"),
        (np.array(found.block_maxima), BLOCKS, "blocks of all seeds"),
    ):
        force = np.sort(values[values > 0])
        share = np.arange(force.size, 0, -1) / values.size  # no smaller one lies above it
        panel.step(force, 100 * share, where="pre", color=colour, label=label)
    panel.axvspan(*found.max_force_interval, color=BLOCKS, alpha=0.2, lw=0)
    panel.axvline(found.max_force, color=BLOCKS, ls="--", lw=1, label="median of blocks, 95 %")
    panel.set(xlabel="largest force of one ball, N", ylabel="exceeded in, %", title="How often a force is exceeded")
    panel.set(yscale="log", ylim=(None, 150))
    panel.yaxis.set_major_formatter("{x:g}")
    least, most = panel.get_xlim()
    if most > WIDE * max(least, LEAST_SHOWN * found.max_force):
        panel.set(xscale="log", xlim=(max(least, LEAST_SHOWN * found.max_force), 1.3 * most))
        panel.xaxis.set_major_formatter("{x:g}")
    panel.grid(alpha=0.3, which="both")
    panel.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=2, fontsize=8, frameon=False)
