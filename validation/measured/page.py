"""The page and the figure of the comparison with measured torques."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

if TYPE_CHECKING:
    from validation.measured.run import Rig

mpl.use("agg")

DRY_SHARE = (0.02, 0.12)  # of the lubricated torque, as stated


def page(rigs: Sequence[Rig]) -> str:
    """measured.md, in markdown; every number in it is computed."""
    return "\n".join((*_verdict(rigs), *_points(rigs), *_mechanisms(rigs))) + "\n"


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
        yield "| rpm | runs | D | S | E | E/D | u_D | u_num | u_input | u_val | \\|E\\|/u_val | free balls |"
        yield "| --- " * 12 + "|"
        parts = rig.measured, rig.computed, rig.error, rig.measurement, rig.numerical, rig.input, rig.validation
        for point, rpm in enumerate(_rpm(rig)):
            d, s, e, u_d, u_num, u_input, u_val = (1e6 * part[point] for part in parts)
            free, unsure = 1e6 * rig.free[point], 1e6 * rig.free_numerical[point]
            yield (
                f"| {rpm:.0f} | {rig.count[point]} | {d:.1f} | {s:.1f} | {e:+.1f} | {100 * e / d:+.0f} % | {u_d:.1f} | "
                f"{u_num:.2f} | {u_input:.1f} | {u_val:.1f} | {abs(e) / u_val:.1f} | {free:.1f} +- {unsure:.1f} |"
            )
        yield ""
        largest = {name: 100 * float(np.max(part / rig.computed)) for name, part in rig.inputs.items()}
        yield "Parts of u_input, largest over the speeds, of S: " + ", ".join(
            f"{name} {share:.1f} %" if share >= 0.05 else f"{name} below 0.05 %" for name, share in largest.items()
        ) + "."  # fmt: skip
        yield ""


def _mechanisms(rigs: Sequence[Rig]) -> Iterator[str]:
    yield "## What is missing, and what known mechanisms supply"
    yield ""
    yield "Ranges over the speeds, uN m; negative: the mechanism lowers the torque."
    yield ""
    yield "| | " + " | ".join(f"balls of {1e3 * rig.ball_diameter:g} mm" for rig in rigs) + " |"
    yield "| --- " * (1 + len(rigs)) + "|"
    yield "| missing, D - S | " + " | ".join(_range(-1e6 * rig.error) for rig in rigs) + " |"
    for name in rigs[0].supplied:
        yield f"| {name} | " + " | ".join(_range(1e6 * rig.supplied[name]) for rig in rigs) + " |"
    dry = [_range(1e6 * np.outer(DRY_SHARE, rig.measured)) for rig in rigs]
    yield f"| the whole dry torque as stated, 2 to 12 % of D | {' | '.join(dry)} |"
    needed = " | ".join(_range(rig.viscosity_needed, digits=2) for rig in rigs)
    yield f"| factor on the viscosity that would supply it | {needed} |"
    yield "| missing, as a force on both surfaces of each contact, mN | " + " | ".join(
        _range(1e3 * rig.lack_per_contact, digits=2) for rig in rigs
    ) + " |"  # fmt: skip
    yield "| 2 gamma d of an oil meniscus, gamma 0.03 N/m, mN | " + " | ".join(
        f"{1e3 * rig.meniscus:.2f}" for rig in rigs
    ) + " |"  # fmt: skip
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
    figure = Figure(figsize=(10, 4.4), layout="constrained")
    for axes, rig in zip(figure.subplots(1, len(rigs)), rigs, strict=True):
        _draw_rig(axes, rig)
    figure.savefig(path, dpi=130, metadata={"Software": None})


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
