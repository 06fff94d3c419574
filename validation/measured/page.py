"""The page and the figure of the comparison with measured torques."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes

from validation.study import figure, markdown, save

if TYPE_CHECKING:
    from validation.measured.run import Rig

DRY_SHARE = (0.02, 0.12)  # of the lubricated torque, as stated


def rig_page(rigs: Sequence[Rig]) -> Iterator[str]:
    """measured.md, in Markdown; every number in it is computed."""
    yield from (*_verdict(rigs), *_points(rigs), *_mechanisms(rigs))


def _verdict(rigs: Sequence[Rig]) -> Iterator[str]:
    relative = np.concatenate([rig.error / rig.measured for rig in rigs])
    ratio = np.concatenate([np.abs(rig.error) / rig.validation for rig in rigs])
    side = "too low" if np.all(relative < 0) else "too high" if np.all(relative > 0) else "off to both sides"
    yield "# The torque against measured torques"
    yield ""
    yield (
        f"|E| > u_val at {np.sum(ratio > 1)} of {ratio.size} points and > 2 u_val at {np.sum(ratio > 2)}: the computed "
        f"torque is {side}, by {100 * np.abs(relative).min():.0f} to {100 * np.abs(relative).max():.0f} % of the "
        "measured one, and the uncertainties of inputs and measurement do not explain that."
    )
    yield ""
    yield (
        "`python validation/measured/run.py` compares `thrust_rig_3mm.toml` and `thrust_rig_6mm.toml` of "
        "validation/scenes with the spin-downs of [Balan2015], as [ASME2009] does: E = S - D, "
        "u_val^2 = u_num^2 + u_input^2 + u_D^2, all standard uncertainties. docs/measured.md says what that means."
    )
    yield ""


def _points(rigs: Sequence[Rig]) -> Iterator[str]:
    for rig in rigs:
        load = float(rig.scene.operation.axial_load.flat[0]) / rig.scene.bearing.ball_count
        yield f"## Balls of {1e3 * rig.ball_diameter:g} mm, {load:g} N each"
        yield ""
        yield (
            f"Torques in uN m. One spin-down scatters by {100 * rig.scatter:.1f} % about the mean at its speed. S is "
            "by closed kinematics; the last column is S by the default, free balls, +- its stated numerical "
            "uncertainty (95 %)."
        )
        yield ""
        heads = ("rpm", "runs", "D", "S", "E", "E/D", "u_D", "u_num", "u_input", "u_val")
        yield from markdown((*heads, "\\|E\\|/u_val", "free balls"), _point_rows(rig))
        yield ""
        largest = {name: 100 * float(np.max(part / rig.computed)) for name, part in rig.inputs.items()}
        yield "Parts of u_input, largest over the speeds, of S: " + ", ".join(
            f"{name} {share:.1f} %" if share >= 0.05 else f"{name} below 0.05 %" for name, share in largest.items()
        ) + "."  # fmt: skip
        yield ""


def _point_rows(rig: Rig) -> Iterator[tuple[str, ...]]:
    parts = rig.measured, rig.computed, rig.error, rig.measurement, rig.numerical, rig.input, rig.validation
    for point, rpm in enumerate(_rpm(rig)):
        d, s, e, u_d, u_num, u_input, u_val = (1e6 * part[point] for part in parts)
        yield (
            f"{rpm:.0f}", str(rig.count[point]), f"{d:.1f}", f"{s:.1f}", f"{e:+.1f}", f"{100 * e / d:+.0f} %",
            f"{u_d:.1f}", f"{u_num:.2f}", f"{u_input:.1f}", f"{u_val:.1f}", f"{abs(e) / u_val:.1f}",
            f"{1e6 * rig.free[point]:.1f} +- {1e6 * rig.free_numerical[point]:.1f}",
        )  # fmt: skip


def _mechanisms(rigs: Sequence[Rig]) -> Iterator[str]:
    yield "## What is missing, and what known mechanisms supply"
    yield ""
    yield "Ranges over the speeds, uN m; negative: the mechanism lowers the torque."
    yield ""
    force = "missing, as a force on both surfaces of each contact, mN"
    rows = {
        "missing, D - S": [_range(-1e6 * rig.error) for rig in rigs],
        **{name: [_range(1e6 * rig.supplied[name]) for rig in rigs] for name in rigs[0].supplied},
        "the whole dry torque as stated, 2 to 12 % of D": [_range(1e6 * np.outer(DRY_SHARE, r.measured)) for r in rigs],
        "factor on the viscosity that would supply it": [_range(rig.viscosity_needed, digits=2) for rig in rigs],
        force: [_range(1e3 * rig.lack_per_contact, digits=2) for rig in rigs],
        "2 gamma d of an oil meniscus, gamma 0.03 N/m, mN": [f"{1e3 * rig.meniscus:.2f}" for rig in rigs],
    }
    balls = (f"balls of {1e3 * rig.ball_diameter:g} mm" for rig in rigs)
    yield from markdown(("", *balls), ((name, *cells) for name, cells in rows.items()))
    yield ""
    yield (
        "No mechanism of the model supplies what is missing. The last line is a weak hypothesis: a force of an oil "
        "meniscus would have this size, but it rests on two numbers, no such force was measured, and what is missing "
        "falls with speed (3 mm) or within the runs (6.35 mm), which a constant force does not."
    )
    yield ""
    yield "![Measured and computed torques of three balls between thrust races](measured.png)"


def _range(values: np.ndarray, digits: int = 1) -> str:
    low, high = float(np.min(values)), float(np.max(values))
    return f"{low:.{digits}f} to {high:.{digits}f}" if high - low > 0.5 * 10**-digits else f"{high:.{digits}f}"


def _rpm(rig: Rig) -> np.ndarray:
    return np.asarray(rig.scene.operation.inner_speed) * 30 / np.pi


def draw(rigs: Sequence[Rig], path: Path) -> None:
    drawn = figure(10, 4.4)
    for axes, rig in zip(drawn.subplots(1, len(rigs)), rigs, strict=True):
        _draw_rig(axes, rig)
    save(drawn, path)


def _draw_rig(axes: Axes, rig: Rig) -> None:
    rpm = _rpm(rig)
    for number, run in enumerate(1e6 * rig.runs):
        axes.plot(rpm, run, "-", color="0.75", lw=0.8, label=None if number else "single spin-downs")
    axes.errorbar(rpm, 1e6 * rig.measured, 2e6 * rig.measurement, fmt="k.", capsize=2, lw=1, label="measured D, 2 u_D")
    unsure = 2 * np.hypot(rig.numerical, rig.input)
    low, high = 1e6 * (rig.computed - unsure), 1e6 * (rig.computed + unsure)
    axes.fill_between(rpm, low, high, color="C0", alpha=0.25, lw=0, label="its inputs and numerics, 2 u")
    axes.plot(rpm, 1e6 * rig.computed, color="C0", label="computed S")
    axes.plot(rpm, 1e6 * rig.free, "--", color="C3", lw=1, label="computed, free balls (default)")
    axes.set(xlabel="speed, rpm", ylabel="torque, uN m", ylim=(0, None))
    axes.set_title(f"three balls of {1e3 * rig.ball_diameter:g} mm", fontsize=10)
    axes.legend(frameon=False, fontsize=8)
