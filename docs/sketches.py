"""The sketches of the theory pages, with their symbols: `python docs/sketches.py` writes them into docs/pictures.

Shapes are exaggerated where the true ones could not be seen; what is solved (the lines without slip, the clearance and
its angle) follows the formulas of the pages.
"""

from collections.abc import Callable
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Arc, Circle, Ellipse

from analytic.figures.style import BLUE, GREEN, GREY, ORANGE, RED
from analytic.writing import replaced_file
from fembearing.report.figures.style import svg

FOLDER = Path(__file__).resolve().parent / "pictures"
INK, STEEL, BALL, OIL = "#1b1f23", "#e3e8ed", "#cfe0ef", "#fbe6bd"
LETTERS = 11
ARROW = {"arrowstyle": "->", "color": INK, "linewidth": 1.0, "shrinkA": 0, "shrinkB": 0}
BOTH = ARROW | {"arrowstyle": "<->"}


def geometry() -> Figure:
    """The groove radii, the contact angle, the distance of the groove centres, and the clearance."""
    figure = Figure(figsize=(6.4, 4.6), layout="constrained")
    panel = figure.subplots()
    radius, grooves, angle = 1.0, (1.22, 1.28), np.radians(32)
    across = np.array([np.sin(angle), np.cos(angle)])
    inner, outer = (grooves[0] - radius) * across, -(grooves[1] - radius) * across
    for centre, groove, side, name in ((inner, grooves[0], 1, "i"), (outer, grooves[1], -1, "o")):
        half = np.linspace(-0.80, 0.80, 121)
        profile = np.column_stack([centre[0] + half, centre[1] - side * np.sqrt(groove**2 - half**2)])
        ends = np.array([-1.55, 1.55])
        edge = -side * 1.85
        outline = [[ends[0], edge], [ends[0], profile[0, 1]], *profile, [ends[1], profile[-1, 1]], [ends[1], edge]]
        panel.fill(*np.array(outline).T, facecolor=STEEL, edgecolor=INK, linewidth=1.2)
        tip = profile[24 if side > 0 else 98]
        panel.annotate("", xy=tuple(tip), xytext=tuple(centre), arrowprops=ARROW | {"color": RED})
        place = 0.55 * tip + 0.45 * centre
        panel.text(
            place[0] - 0.08, place[1] + 0.10 * side, rf"$r_{{g,{name}}}$", color=RED, fontsize=LETTERS, ha="right"
        )
        panel.plot(*centre, "o", color=RED, markersize=4)
    panel.add_patch(Circle((0, 0), radius, facecolor=BALL, edgecolor=INK, linewidth=1.2, alpha=0.75))
    panel.plot([0, 0], [-1.95, 1.95], color=GREY, linewidth=0.8, linestyle=(0, (9, 2, 1.5, 2)))
    line = np.array([-1.95 * across, 1.95 * across])
    panel.plot(*line.T, color=BLUE, linewidth=1.3, linestyle="--")
    panel.add_patch(Arc((0, 0), 2.9, 2.9, theta1=90 - np.degrees(angle), theta2=90, color=BLUE))
    panel.text(0.36, 1.52, r"$\alpha_0$", color=BLUE, fontsize=LETTERS)
    panel.annotate("", xy=(-radius, 0), xytext=(radius, 0), arrowprops=BOTH)
    panel.text(-0.72, -0.05, "$D$", fontsize=LETTERS, va="top")
    aside = 0.42 * np.array([np.cos(angle), -np.sin(angle)])
    for end in (inner, outer):
        panel.plot(*np.array([end, end + 1.1 * aside]).T, color=RED, linewidth=0.6)
    panel.annotate("", xy=tuple(inner + aside), xytext=tuple(outer + aside), arrowprops=BOTH | {"color": RED})
    panel.text(aside[0] + 0.07, aside[1] - 0.16, "$A_0$", color=RED, fontsize=LETTERS)
    words = [
        (1.7, 1.2, "outer ring, bottom radius $R_{b,o}$"),
        (1.7, -1.3, "inner ring, bottom radius $R_{b,i}$"),
        (1.7, 0.35, "centres of the grooves (red)\n$A_0 = r_{g,i} + r_{g,o} - D$"),
        (1.7, -0.45, "line of contact (blue)\n" + r"$\cos\alpha_0 = 1 - P_d/(2A_0)$"),
    ]
    for x, y, text in words:
        panel.text(x, y, text, fontsize=LETTERS - 1, va="center")
    panel.annotate("", xy=(-1.9, 0.9), xytext=(-1.9, -0.9), arrowprops=ARROW)
    panel.text(-1.98, 0, "from the bearing's axis", rotation=90, ha="right", va="center", fontsize=LETTERS - 1)
    _bare(panel, (-2.3, 4.1), (-2.0, 2.0))
    return figure


def inlet() -> Figure:
    """A rolling contact in oil: inlet, film, outlet, and the pressure over it."""
    figure = Figure(figsize=(6.4, 4.2), layout="constrained")
    above, below = figure.subplots(2, 1, sharex=True, height_ratios=(1.0, 1.25))
    x = np.linspace(-2.6, 2.2, 289)
    hertz = np.sqrt(np.maximum(1 - x**2, 0.0))
    early = 0.16 * np.exp(-((np.minimum(x + 0.85, 0.0) / 0.42) ** 2)) * (x < -0.85)
    pressure = np.where(x < -0.985, early, np.where(x > 0.97, 0.0, np.maximum(hertz, 0.16 * (x < 0))))
    pressure = pressure + 0.45 * np.exp(-(((x - 0.80) / 0.045) ** 2)) * (x < 0.9)
    above.plot(x, hertz, "--", color=GREY, linewidth=1, label="dry: Hertz")
    above.fill_between(x, 0, pressure, color=BLUE, alpha=0.15)
    above.plot(x, pressure, color=BLUE, linewidth=1.5)
    above.text(0.02, 1.05, "$p_0$", fontsize=LETTERS, ha="center")
    above.annotate(
        "pressure builds up ahead:\nresistance to rolling",
        xy=(-1.15, 0.10),
        xytext=(-2.55, 0.78),
        arrowprops=ARROW,
        fontsize=LETTERS - 1,
    )
    above.text(1.25, 0.45, "dashed: Hertz, dry\nblue: with oil", fontsize=LETTERS - 1)
    gap = (
        0.16
        + 0.9
        * np.where(
            np.abs(x) > 1,
            np.abs(x) * np.sqrt(np.maximum(x**2 - 1, 0)) - np.log(np.abs(x) + np.sqrt(np.maximum(x**2 - 1, 0))),
            0,
        )
        / 2
    )
    gap = gap - 0.055 * np.exp(-(((x - 0.86) / 0.10) ** 2))
    below.fill_between(x, gap, 2.0, color=BALL)
    below.fill_between(x, -0.6, 0, color=STEEL)
    wet = x[(x > -2.2) & (x < 1.35)]
    below.fill_between(wet, 0, np.interp(wet, x, gap), color=OIL)
    below.plot(x, gap, color=INK, linewidth=1.2)
    below.axhline(0, color=INK, linewidth=1.2)
    below.annotate("", xy=(-0.05, 0), xytext=(-0.05, 0.16), arrowprops=ARROW | {"arrowstyle": "-", "linewidth": 1.5})
    below.annotate("central film $h$", xy=(-0.05, 0.09), xytext=(-0.55, 0.72), arrowprops=ARROW, fontsize=LETTERS - 1)
    below.annotate("minimum film", xy=(0.86, 0.06), xytext=(0.42, 0.44), arrowprops=ARROW, fontsize=LETTERS - 1)
    below.text(-1.75, 0.14, "inlet", fontsize=LETTERS - 1, ha="center")
    below.text(1.16, 0.045, "outlet", fontsize=LETTERS - 2, ha="center")
    below.text(1.72, 1.45, "ball", fontsize=LETTERS)
    below.text(1.72, -0.35, "race", fontsize=LETTERS)
    for y in (1.25, -0.3):
        below.annotate("", xy=(-0.65, y), xytext=(-1.35, y), arrowprops=ARROW | {"linewidth": 1.6})
        below.text(-1.42, y, "$u$", fontsize=LETTERS, ha="right", va="center")
    below.annotate("", xy=(-2.2, -0.12), xytext=(-1.0, -0.12), arrowprops=BOTH | {"color": ORANGE})
    below.text(-2.25, -0.14, "$X$", color="#9a6700", fontsize=LETTERS, ha="right", va="center")
    for end in (-1, 1):
        for panel in (above, below):
            panel.axvline(end, color=GREY, linewidth=0.7, linestyle=":")
    below.annotate("", xy=(0, -0.48), xytext=(1, -0.48), arrowprops=BOTH)
    below.text(0.5, -0.47, "$a$", fontsize=LETTERS, ha="center", va="bottom")
    _bare(above, (-2.8, 2.3), (-0.05, 1.3), equal=False)
    _bare(below, (-2.8, 2.3), (-0.62, 1.9), equal=False)
    return figure


def slip() -> Figure:
    """Slip of a ball that rolls and spins in the ellipse of its contact, with the lines where it does not slide."""
    figure = Figure(figsize=(6.4, 3.9), layout="constrained")
    panel = figure.subplots()
    long, short, spin = 2.4, 1.0, 0.30  # b, a, and the spin-to-roll ratio
    across = 2 * np.sqrt(1 - spin**2) * np.sin(np.arcsin(1 / (2 * (1 - spin**2) ** 1.5)) / 3)
    lines = [-spin - across, -spin + across]  # of pure rolling, in b: docs/theory/traction-and-sliding.md
    panel.add_patch(Ellipse((0, 0), 2 * long, 2 * short, facecolor="#eef3f8", edgecolor=INK, linewidth=1.4))
    for y in np.linspace(-0.92, 0.92, 15):
        speed = (y - lines[0]) * (y - lines[1])  # of sliding along rolling, which vanishes on both lines
        for x in np.linspace(-0.62, 0.62, 4) * np.sqrt(1 - y**2):
            length = 0.42 * speed
            colour = RED if speed > 0 else BLUE
            if abs(length) > 0.02:
                panel.annotate(
                    "",
                    xy=(long * y, short * x + length),
                    xytext=(long * y, short * x),
                    arrowprops=ARROW | {"color": colour},
                )
    for line, name in zip(lines, ("1", "2"), strict=True):
        height = 1.18 * np.sqrt(1 - line**2)
        panel.plot([long * line] * 2, [-height, height], color=GREEN, linewidth=1.6)
        panel.text(long * line, height + 0.05, rf"$\gamma_{name} b$", color="#00704f", ha="center", fontsize=LETTERS)
    panel.annotate("", xy=(long, -1.22), xytext=(0, -1.22), arrowprops=BOTH)
    panel.text(long / 2, -1.27, "$b$", ha="center", va="top", fontsize=LETTERS)
    panel.annotate("", xy=(2.75, short), xytext=(2.75, 0), arrowprops=BOTH)
    panel.text(2.82, 0.5, "$a$", va="center", fontsize=LETTERS)
    panel.annotate("", xy=(-2.95, 1.05), xytext=(-2.95, -0.35), arrowprops=ARROW)
    panel.text(-3.05, 0.35, "rolling, $x$", rotation=90, ha="right", va="center", fontsize=LETTERS - 1)
    panel.annotate("", xy=(-2.05, -1.22), xytext=(-2.95, -1.22), arrowprops=ARROW)
    panel.text(-2.5, -1.27, "across, $y$", ha="center", va="top", fontsize=LETTERS - 1)
    panel.text(
        0,
        -1.78,
        "red and blue: the ball slides forward and back; green: it rolls without sliding.\n"
        "Spin moves both lines to one side.",
        ha="center",
        va="top",
        fontsize=LETTERS - 1,
    )
    _bare(panel, (-3.4, 3.2), (-2.25, 1.45))
    return figure


def creep() -> Figure:
    """Stick and slip along a strip of a contact: the traction builds up from the leading edge."""
    figure = Figure(figsize=(6.4, 3.3), layout="constrained")
    panel = figure.subplots()
    x = np.linspace(-1, 1, 401)
    limit = np.sqrt(1 - x**2)
    stuck = 0.45  # Carter: the ellipse of stick reaches from the leading edge, x = 1
    middle, half = stuck, 1 - stuck
    inside = np.sqrt(np.maximum(1 - ((x - middle) / half) ** 2, 0.0))
    traction = limit - half * inside
    panel.fill_between(x, 0, traction, where=x >= middle - half, color=BLUE, alpha=0.25, linewidth=0)
    panel.fill_between(x, 0, traction, where=x <= middle - half, color=RED, alpha=0.25, linewidth=0)
    panel.plot(x, limit, "--", color=INK, linewidth=1.1)
    panel.plot(x, traction, color=INK, linewidth=1.6)
    panel.axhline(0, color=INK, linewidth=1)
    panel.text(-0.62, 0.30, "slip\n$|t| = \\mu p$", ha="center", fontsize=LETTERS)
    panel.text(0.52, 0.10, "stick, $|t| < \\mu p$", ha="center", fontsize=LETTERS)
    panel.annotate("limit $\\mu p$", xy=(0.72, 0.70), xytext=(0.95, 0.92), arrowprops=ARROW, fontsize=LETTERS)
    panel.annotate("traction $t$", xy=(0.25, 0.47), xytext=(0.28, 0.72), arrowprops=ARROW, fontsize=LETTERS)
    panel.text(1.03, -0.06, "leading edge", va="top", ha="center", fontsize=LETTERS - 1)
    panel.text(-1.0, -0.06, "trailing edge", va="top", ha="center", fontsize=LETTERS - 1)
    panel.annotate("", xy=(0.45, -0.14), xytext=(-0.45, -0.14), arrowprops=ARROW | {"linewidth": 1.6})
    panel.text(0, -0.18, "rolling, $x$, $V$", ha="center", va="top", fontsize=LETTERS)
    _bare(panel, (-1.25, 1.45), (-0.32, 1.08), equal=False)
    return figure


def pocket() -> Figure:
    """A ball in the pocket of a cage, pressed against one of its two half-shells."""
    figure = Figure(figsize=(6.4, 4.0), layout="constrained")
    panel = figure.subplots()
    radius, wide, wall, deep = 1.0, 1.22, 0.16, 1.30  # D/2, D_p/2, of the sheet, k
    for side in (-1, 1):
        middle = -side * (wide - deep)  # centre of the shell, which is deeper than a half-sphere
        start = np.arcsin(min(1.0, (deep - wide) / wide))
        angle = np.linspace(-np.pi / 2 - start, np.pi / 2 + start, 121)
        shape = [
            np.column_stack([middle + side * each * np.cos(angle), each * np.sin(angle)])
            for each in (wide, wide + wall)
        ]
        outline = np.concatenate([shape[0], shape[1][::-1]])
        outline[:, 0] = side * np.maximum(side * outline[:, 0], 0.0)
        panel.fill(*outline.T, facecolor="#d7b899", edgecolor=INK, linewidth=1)
        panel.plot(middle, 0, "+", color="#7a4a1e", markersize=8)
    lean = np.radians(25)
    shell = np.array([deep - wide, 0.0])  # the centre of the half-shell that it touches
    place = shell + (wide - radius) * np.array([np.cos(lean), np.sin(lean)])
    panel.add_patch(Circle(tuple(place), radius, facecolor=BALL, edgecolor=INK, linewidth=1.2))
    panel.plot(*place, "o", color=INK, markersize=3)
    away = (place - shell) / np.linalg.norm(place - shell)
    touch = place + radius * away
    panel.annotate(
        "", xy=tuple(touch), xytext=tuple(touch + 0.75 * away), arrowprops=ARROW | {"color": RED, "linewidth": 1.8}
    )
    panel.text(*(touch + 0.85 * away), "$N$", color=RED, fontsize=LETTERS + 1, ha="left", va="center")
    along = np.array([-away[1], away[0]])
    panel.annotate(
        "", xy=tuple(touch + 0.5 * along), xytext=tuple(touch), arrowprops=ARROW | {"color": ORANGE, "linewidth": 1.8}
    )
    panel.text(
        *(touch + 0.55 * along + np.array([0.05, 0.04])), r"$\mu_c N$", color="#9a6700", fontsize=LETTERS, va="bottom"
    )
    panel.plot([0, 0], [-1.75, 1.75], color=GREY, linewidth=0.9, linestyle=(0, (9, 2, 1.5, 2)))
    panel.text(0.04, -1.72, "plane where the halves join", fontsize=LETTERS - 2, va="top", ha="center")
    panel.annotate("", xy=(-deep, -1.55), xytext=(0, -1.55), arrowprops=BOTH)
    panel.text(-deep / 2, -1.53, "$k$", ha="center", va="bottom", fontsize=LETTERS)
    panel.plot([-deep, -deep], [-1.6, 0], color=INK, linewidth=0.5)
    panel.annotate("", xy=(-1.95, -wide), xytext=(-1.95, wide), arrowprops=BOTH)
    for y in (-wide, wide):
        panel.plot([-2.0, 0], [y, y], color=INK, linewidth=0.5)
    panel.text(-2.0, 0, "$D_p$", ha="right", va="center", fontsize=LETTERS)
    ends = [(place[0], place[1] + side * radius) for side in (-1, 1)]
    panel.annotate("", xy=ends[0], xytext=ends[1], arrowprops=BOTH)
    panel.text(place[0] + 0.05, place[1] - 0.45, "$D$", fontsize=LETTERS)
    panel.text(
        2.5,
        -0.9,
        "$\\nabla = (D_p - D)/2$\ncrosses: centres of\nthe half-shells $s = \\pm 1$",
        fontsize=LETTERS - 1,
        va="center",
    )
    panel.annotate("", xy=(2.1, -1.75), xytext=(1.3, -1.75), arrowprops=ARROW)
    panel.text(2.15, -1.75, "$x$, the pocket's axis", fontsize=LETTERS - 1, va="center")
    _bare(panel, (-2.6, 4.6), (-1.95, 1.85))
    return figure


def _bare(panel: Axes, across: tuple[float, float], up: tuple[float, float], *, equal: bool = True) -> None:
    """No axes; equal : both directions to one scale."""
    panel.set_axis_off()
    panel.set_xlim(*across)
    panel.set_ylim(*up)
    if equal:
        panel.set_aspect("equal")


SKETCHES: dict[str, Callable[[], Figure]] = {
    "sketch-geometry": geometry,
    "sketch-inlet": inlet,
    "sketch-slip": slip,
    "sketch-creep": creep,
    "sketch-pocket": pocket,
}


def main() -> None:
    for name, draw in SKETCHES.items():
        with replaced_file(FOLDER / f"{name}.svg") as file:
            file.write_bytes(svg(draw()))


if __name__ == "__main__":
    main()
