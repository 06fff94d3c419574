"""Figures 5 to 9 of [Paper] beside ours. Lines are three readings, marks the numbers that the paper prints."""

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine

from analytic.scene import Autocorrelation
from analytic.surface.roughness import generated_surface
from validation.paper.cage import ROUGH, RPM, SMOOTH
from validation.paper.comparison import Series, Stored, load, published
from validation.study import figure as empty
from validation.study import save

FINISHES = (ROUGH, SMOOTH)
COLOURS = {"as printed": "tab:orange", "calibrated": "tab:blue", "physical": "tab:green"}
MAP_POINTS, MAP_SEED = 256, 5
MOMENTS = "calibrated, friction moments in place of power"
LEAST = {"cage_torque": 0.03, "cage_max_force": 0.5, "pocket_coefficient": 0.02, "pocket": 3e-6}  # of logarithmic axes
Readings = dict[str, dict[float, Series]]  # by name and Sq, m


def draw_all(stored: Stored, folder: Path) -> None:
    """All pictures, from what `run.py` stores."""
    readings = {
        one["name"]: {float(sq): _arrays(part) for sq, part in one["series"].items()} for one in stored["readings"]
    }
    points, autocorrelation = published(), load("calibrated").surface.autocorrelation
    assert autocorrelation is not None
    draw_surfaces(autocorrelation, folder / "paper_5_surfaces.png")
    draw_total(readings, points, folder / "paper_6_total.png")
    draw_coefficients(readings, folder / "paper_7_coefficients.png")
    draw_parts(readings, points, folder / "paper_8_torques.png")
    draw_forces(readings, points, folder / "paper_9_forces.png")
    draw_pocket(readings["calibrated"], stored["mixed_pocket_coefficients"], folder / "paper_pocket.png")


def _arrays(part: Stored) -> Series:
    return {name: np.array(values) for name, values in part.items()}


def draw_surfaces(autocorrelation: Autocorrelation, path: Path) -> None:
    """Figure 5."""
    figure = Figure(figsize=(10.5, 3.1), layout=ConstrainedLayoutEngine(w_pad=0.12))
    axes = figure.subplots(1, 3, width_ratios=(1, 1, 1.2))
    width = autocorrelation.spacing * MAP_POINTS * 1e3
    for number, (axis, roughness) in enumerate(zip(axes, FINISHES, strict=False)):
        surface = generated_surface(
            rms_roughness=roughness, autocorrelation=autocorrelation, points=MAP_POINTS, seed=MAP_SEED + number
        )
        heights, most = surface.heights * 1e6, 3 * roughness * 1e6
        image = axis.imshow(heights, extent=(0, width, 0, width), vmin=-most, vmax=most, cmap="viridis")
        figure.colorbar(image, ax=axis, label="height, µm", shrink=0.85)
        axis.set(title=f"({'ab'[number]}) Sq {roughness * 1e6:g} µm", xlabel="x, mm", ylabel="y, mm")
        place = np.arange(MAP_POINTS) * autocorrelation.spacing * 1e3
        axes[2].plot(place, heights[MAP_POINTS // 2], color="k" if number == 0 else "tab:red", lw=1.2,
                     label=f"Sq {roughness * 1e6:g} µm")  # fmt: skip
    axes[2].set(title="middle rows of both, one scale", xlabel="x, mm", ylabel="height, µm", ylim=(-2.2, 3))
    axes[2].legend(frameon=False, loc="upper right", ncols=2)
    axes[2].grid(alpha=0.3)
    save(figure, path, dpi=100)


def draw_total(readings: Readings, points: list[Stored], path: Path) -> None:
    """Figure 6."""
    figure, axes = _of_finishes("total friction torque, N mm")
    for axis, roughness in zip(axes, FINISHES, strict=True):
        _panel(axis, readings, points, roughness, "total_torque")
        _moments(axis, readings, roughness, "total_with_moments")
        axis.set(ylim=(0, 70))
    _finish(figure, path, axes[0])


def draw_coefficients(readings: Readings, path: Path) -> None:
    """Figure 7; the paper has no numbers for it."""
    figure = empty(10.0, 4.2)
    axes = figure.subplots(1, 3)
    titles = {"outer": "(a) ball on outer race", "inner": "(b) ball on inner race", "pocket": "(c) ball on cage"}
    for axis, (part, title) in zip(axes, titles.items(), strict=True):
        for name, one in readings.items():
            if part != "pocket" and name == "as printed":
                continue  # the races of this reading have the coefficients of the calibrated one
            for sq, style in ((ROUGH, "-"), (SMOOTH, "--")):
                label = f"{name}, Sq {sq * 1e6:g} µm"
                values = one[sq][f"{part}_coefficient"]
                axis.plot(one[sq]["inner_speed"] / RPM, values, style, color=COLOURS[name], marker=".", label=label)
        _speeds(axis)
        axis.set(title=title, ylim=(0, 0.12))
    axes[2].set(yscale="log", ylim=(LEAST["pocket_coefficient"], 0.2), yticks=(0.02, 0.05, 0.1, 0.2))
    axes[2].yaxis.set_major_formatter("{x:g}")
    axes[2].yaxis.set_minor_formatter("")
    _off_scale(axes[2], readings, "pocket_coefficient", ROUGH, "", 1.0)
    axes[0].set_ylabel("friction coefficient")
    _finish(figure, path, axes[2])


def draw_parts(readings: Readings, points: list[Stored], path: Path) -> None:
    """Figure 8."""
    figure = empty(10.0, 6.6)
    axes = figure.subplots(2, 3, sharex=True)
    titles = {"race": "(a) balls on races", "cage": "(b) balls on cage", "total": "(c) bearing"}
    for row, roughness in zip(axes, FINISHES, strict=True):
        for axis, (part, title) in zip(row, titles.items(), strict=True):
            _panel(axis, readings, points, roughness, f"{part}_torque")
            if part != "race":
                _moments(axis, readings, roughness, "cage_moments" if part == "cage" else "total_with_moments")
            if part == "cage":
                axis.set(yscale="log", ylim=(LEAST["cage_torque"], 20))
                axis.yaxis.set_major_formatter("{x:g}")
                _off_scale(axis, readings, "cage_torque", roughness, "N mm", 1e3)
            else:
                axis.set(ylim=(0, 70))
            axis.set_title(f"{title}, Sq {roughness * 1e6:g} µm")
            axis.set_xlabel(axis.get_xlabel() if roughness == SMOOTH else "")
        row[0].set_ylabel("friction torque, N mm")
    _finish(figure, path, axes[0, 1], axes[0, 2])


def draw_forces(readings: Readings, points: list[Stored], path: Path) -> None:
    """Figure 9."""
    figure, axes = _of_finishes("largest force of a ball on the cage, N")
    for axis, roughness in zip(axes, FINISHES, strict=True):
        for name, one in readings.items():
            values = one[roughness]
            middle, low, high = (values[f"cage_max_force{end}"] for end in ("", "_low", "_high"))
            style = {"marker": ".", "color": COLOURS[name], "capsize": 3, "lw": 1.5, "label": name}
            axis.errorbar(values["inner_speed"] / RPM, middle, yerr=(middle - low, high - middle), **style)
        _marks(axis, points, "cage_max_force", roughness, 1.0)
        axis.set(yscale="log", ylim=(LEAST["cage_max_force"], 400))
        axis.yaxis.set_major_formatter("{x:g}")
        _off_scale(axis, readings, "cage_max_force", roughness, "N", 1.0)
    _finish(figure, path, axes[0])


def draw_pocket(calibrated: dict[float, Series], mixed: list[Stored], path: Path) -> None:
    """The coefficient of ball on pocket that the paper's cage torque needs, and mixed lubrication's; by roughness."""
    figure, axes = _of_finishes("friction coefficient, ball on pocket")
    for axis, roughness in zip(axes, FINISHES, strict=True):
        values = calibrated[roughness]
        speeds = values["inner_speed"] / RPM
        axis.plot(speeds, values["pocket_coefficient"], "k-", lw=2.5, label="needed for the paper's cage torque")
        for one in mixed:
            if one["rms_roughness"] == roughness:
                name = one["pocket"]
                colour = COLOURS["calibrated" if name.startswith("calibrated") else "physical"]
                style = "--" if "table 1" in name else "-"
                axis.plot(speeds, one["coefficient"], style, color=colour, marker=".", label=name)
        axis.set(yscale="log", ylim=(LEAST["pocket"], 1))
    _finish(figure, path, axes[0], columns=2)


def _of_finishes(label: str) -> tuple[Figure, Sequence[Axes]]:
    """Two panels over speed, one for each finish."""
    figure = empty(9.0, 4.4)
    axes = figure.subplots(1, 2, sharey=True)
    for axis, roughness in zip(axes, FINISHES, strict=True):
        _speeds(axis)
        axis.set_title(f"Sq {roughness * 1e6:g} µm")
    axes[0].set_ylabel(label)
    return figure, axes


def _panel(axis: Axes, readings: Readings, points: list[Stored], roughness: float, quantity: str) -> None:
    """A torque by all readings, and the paper's."""
    for name, one in readings.items():
        values = one[roughness]
        axis.plot(values["inner_speed"] / RPM, values[quantity] * 1e3, color=COLOURS[name], marker=".", label=name)
    _marks(axis, points, quantity, roughness, 1e3)
    _speeds(axis)


def _marks(axis: Axes, points: list[Stored], quantity: str, roughness: float, factor: float) -> None:
    """The paper's numbers: filled as printed, hollow where its text says about."""
    for note, fill, label in (("printed", "k", "paper, number printed"), ("about", "w", "paper, printed as about")):
        wanted = {"quantity": quantity, "rms_roughness": roughness, "note": note}
        if mine := [one for one in points if wanted.items() <= one.items()]:
            speeds, values = [one["inner_speed"] / RPM for one in mine], [one["value"] * factor for one in mine]
            axis.plot(speeds, values, "ko", mfc=fill, mew=1.5, ms=7, label=label, zorder=4)


def _moments(axis: Axes, readings: Readings, roughness: float, quantity: str) -> None:
    values = readings["calibrated"][roughness]
    speeds, colour = values["inner_speed"] / RPM, COLOURS["calibrated"]
    axis.plot(speeds, values[quantity] * 1e3, ":", color=colour, lw=2, label=MOMENTS)


def _off_scale(axis: Axes, readings: Readings, quantity: str, roughness: float, unit: str, factor: float) -> None:
    """Names readings that lie below a logarithmic axis."""
    for name, one in readings.items():
        highest = float(one[roughness][quantity].max()) * factor
        if highest < axis.get_ylim()[0]:
            power = f"$10^{{{int(np.ceil(np.log10(highest)))}}}$"
            words = f"{name}: below {power} {unit}"
            axis.text(0.03, 0.03, words, color=COLOURS[name], transform=axis.transAxes, fontsize=8)


def _speeds(axis: Axes) -> None:
    axis.set(xlabel="speed of the inner ring, rpm", xlim=(60, 540), xticks=(100, 200, 300, 400, 500))
    axis.grid(alpha=0.3)


def _finish(figure: Figure, path: Path, *axes: Axes, columns: int = 3) -> None:
    """One legend for all panels, the paper's marks first; then write the picture."""
    kept: dict[str, Artist] = {}
    for axis in axes:
        for handle, label in zip(*axis.get_legend_handles_labels(), strict=True):
            kept.setdefault(label, handle)
    labels = sorted(kept, key=lambda label: not label.startswith("paper"))  # stable: the rest keeps its order
    handles, style = [kept[label] for label in labels], {"frameon": False, "fontsize": 9}
    figure.legend(handles, labels, loc="outside lower center", ncols=columns, **style)
    save(figure, path, dpi=100)
