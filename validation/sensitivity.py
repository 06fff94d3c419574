"""Sensitivity of the torque to assumed inputs: python validation/sensitivity.py [--out FOLDER]

Takes the 6205 of [Paper] with the physics of 6205_physical.toml at Sq 1 um, but with balanced spin. One input at a time
takes each end of a plausible range, and the total torque at the slowest and the fastest point is computed again. The
ranges are judgements; each names its source or says that there is none. Joint changes of several inputs are not
covered. Prints a table, and writes sensitivity.csv and the tornado plot sensitivity.png into the folder
(validation/reports).
"""

import argparse
import csv
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from rich.console import Console
from rich.table import Table

from analytic.oil import variation as oil_variation
from analytic.oil.film import FILM_FACTORS
from analytic.oil.rolling import HYSTERESIS_LOSS
from analytic.scene import Array, Autocorrelation, ContactAngle, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque

mpl.use("agg")

HERE = Path(__file__).parent
SCENE = HERE / "scenes" / "6205_physical.toml"
ROUNDING = 5e-6  # m, half of the last digit of the radii and the ball diameter in [Paper]
DRAWS, SEED = 200_000, 6205  # of the rounding; quantiles are accurate to 0.1 degree
RPM = np.pi / 30


@dataclass(frozen=True, kw_only=True)
class End:
    """One end of a range, or another choice."""

    label: str  # with its unit
    scene: Scene
    film_factor: float = 1.0


@dataclass(frozen=True, kw_only=True)
class Variation:
    """An input that the scene assumes."""

    name: str
    base: str  # its value in the scene
    ends: tuple[End, ...]  # two, or one if the scene has the other
    source: str  # of the range


@dataclass(frozen=True, kw_only=True, eq=False)
class Swing:
    """The relative change of the total torque by a variation; for each end (n,) over the operating points."""

    variation: Variation
    changes: tuple[Array, ...]

    @property
    def largest(self) -> float:
        return max(float(np.abs(change).max()) for change in self.changes)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=Path, default=HERE / "reports", help="folder for sensitivity.csv and .png")
    folder = parser.parse_args().out
    scene = slowest_and_fastest(load_scene(SCENE))
    torque = friction_torque(scene).torque.total
    result = swings(scene)
    report(result, scene, torque, Console(width=140))
    folder.mkdir(parents=True, exist_ok=True)
    write(result, scene, folder / "sensitivity.csv")
    draw(result, scene, torque, folder / "sensitivity.png")


def slowest_and_fastest(scene: Scene) -> Scene:
    ends = [0, -1]
    operation = scene.operation
    return replace(
        scene,
        sliding="along_axis",  # one method throughout, so that the input alone changes the torque
        spin_rule="balanced",  # the rule of that method: it has closed kinematics, without creep
        operation=replace(
            operation,
            axial_load=operation.axial_load[ends],
            inner_speed=operation.inner_speed[ends],
            radial_load=0.0,
            moment=0.0,
        ),
    )


def swings(scene: Scene) -> list[Swing]:
    """The swings of all variations, the largest first."""
    base = friction_torque(scene).torque.total
    result = [
        Swing(
            variation=variation,
            changes=tuple(
                friction_torque(end.scene, variation=oil_variation.Variation(film=end.film_factor)).torque.total / base
                - 1
                for end in variation.ends
            ),
        )
        for variation in variations(scene)
    ]
    return sorted(result, key=lambda swing: swing.largest, reverse=True)


def variations(scene: Scene) -> Iterator[Variation]:
    oil, surface, angle = scene.lubricant, scene.surface, scene.contact_angle
    assert oil is not None
    assert surface is not None
    assert surface.autocorrelation is not None
    assert surface.rms_roughness is not None
    assert angle.free is not None
    correlation, steel = surface.autocorrelation, scene.bearing.ball_material

    def of_oil(**change: Any) -> Scene:
        return replace(scene, lubricant=replace(oil, **change))

    def of_surface(**change: Any) -> Scene:
        return replace(scene, surface=replace(surface, **change))

    def of_correlation(length: float) -> Scene:
        return of_surface(autocorrelation=replace(correlation, length=length, spacing=length / 20))

    def of_steel(**change: float) -> Scene:
        bearing, material = scene.bearing, replace(steel, **change)
        return replace(
            scene,
            bearing=replace(
                bearing,
                ball_material=material,
                inner=replace(bearing.inner, material=material),
                outer=replace(bearing.outer, material=material),
            ),
        )

    def sampled_at(spacing: float) -> End:
        sampled = Autocorrelation(kind="exponential", length=correlation.length, spacing=spacing)
        return End(label=f"exponential, sampled at {spacing * 1e6:g} µm", scene=of_surface(autocorrelation=sampled))

    def between(
        name: str, unit: str, scale: float, base: float, span: tuple[float, float], change: Callable[[float], Scene],
        source: str,
    ) -> Variation:  # fmt: skip
        """A number that takes both ends of a span, SI; scale : one unit in SI."""
        ends = tuple(End(label=f"{value / scale:.3g} {unit}".strip(), scene=change(value)) for value in span)
        return Variation(name=name, base=f"{base / scale:.3g} {unit}".strip(), ends=ends, source=source)

    no_source = "usual, no source seen"
    yield between(
        "Young's modulus", "GPa", 1e9, steel.youngs_modulus, (190e9, 210e9), lambda v: of_steel(youngs_modulus=v),
        "suppliers' sheets of 52100 (AISI)",
    )  # fmt: skip
    yield Variation(
        name="Poisson's ratio",
        base=f"{steel.poisson_ratio:g}",
        ends=(End(label="0.27", scene=of_steel(poisson_ratio=0.27)),),
        source="0.27 to 0.3, suppliers' sheets of 52100 (AISI)",
    )
    yield between(
        "hardness", "GPa", 1e9, surface.hardness or np.nan, (6.8e9, 8.8e9), lambda v: of_surface(hardness=v),
        "60 to 67 HRC, suppliers' sheets of 52100; 697 to 900 HV (table not seen)",
    )  # fmt: skip
    yield between(
        "viscosity", "Pa s", 1, oil.viscosity, (0.028, 0.087), lambda v: of_oil(viscosity=v),
        "VG 32 to VG 100 at 40 degC, 870 kg/m^3",
    )  # fmt: skip
    yield between(
        "pressure-viscosity", "1/GPa", 1e-9, oil.pressure_viscosity, (14e-9, 28e-9),
        lambda v: of_oil(pressure_viscosity=v),
        "oil of the measured films; machine oils of 0.03 to 0.05 Pa s in [Stachowiak] table 2.3",
    )  # fmt: skip
    yield between(
        "Eyring stress", "MPa", 1e6, oil.eyring_stress, (2e6, 10e6), lambda v: of_oil(eyring_stress=v), no_source
    )
    yield between(
        "limiting shear", "of pressure", 1, oil.limiting_shear, (0.05, 0.08), lambda v: of_oil(limiting_shear=v),
        no_source,
    )  # fmt: skip
    yield between(
        "boundary friction", "", 1, surface.boundary_friction, (0.08, 0.15), lambda v: of_surface(boundary_friction=v),
        no_source,
    )  # fmt: skip
    yield between(
        "hysteresis loss", "", 1, scene.hysteresis_loss or np.nan, HYSTERESIS_LOSS,
        lambda v: replace(scene, hysteresis_loss=v), "in use for bearing steel, none of them measured",
    )  # fmt: skip
    yield between(
        "correlation length",
        "µm",
        1e-6,
        correlation.length,
        (20e-6, 200e-6),
        of_correlation,
        "judgement, no source seen",
    )
    yield Variation(
        name="rms roughness",
        base=f"{surface.rms_roughness * 1e6:g} µm",
        ends=(End(label="0.1 µm", scene=of_surface(rms_roughness=0.1e-6)),),
        source="the other surface of the paper: given there, shown for scale",
    )
    yield Variation(
        name="autocorrelation",
        base=correlation.kind,
        ends=(sampled_at(8e-6), sampled_at(1e-6)),
        source="the other usual kind; its summits depend on the spacing",
    )
    yield Variation(
        name="rough surfaces",
        base="two",
        ends=(End(label="one", scene=of_surface(ball_rms_roughness=0.0)),),
        source="the paper does not say",
    )
    yield Variation(
        name="contact angle",
        base=f"free {angle.free:g} rad",
        ends=(
            End(
                label=f"loaded {angle.free:g} rad",
                scene=replace(scene, contact_angle=ContactAngle(rule="given", value=angle.free)),
            ),
        ),
        source="both readings of Table 1; 1000 N is impossible with it as the loaded angle",
    )
    free_angles = free_angles_within_rounding(scene)
    yield between(
        "clearance", "deg free angle", np.pi / 180, angle.free, free_angles,
        lambda v: replace(scene, contact_angle=ContactAngle(rule="solved", free=v)),
        "5 to 95 % quantile within the rounding of Table 1",
    )  # fmt: skip
    yield Variation(
        name="spin rule",
        base=scene.spin_rule,
        ends=(
            End(label="outer control", scene=replace(scene, spin_rule="outer_control")),
            End(label="inner control", scene=replace(scene, spin_rule="inner_control")),
        ),
        source="the paper does not say",
    )
    yield Variation(
        name="shear of the oil",
        base="sinh law",
        ends=(End(label="constant Eyring stress", scene=of_oil(traction="eyring_constant")),),
        source="both readings of a sentence in the paper",
    )
    yield Variation(
        name="film formula",
        base="as computed",
        ends=tuple(
            End(label=f"{100 * (factor - 1):+.0f} %", scene=scene, film_factor=factor) for factor in FILM_FACTORS
        ),
        source="its 95 % interval, analytic/oil/film.py",
    )


def free_angles_within_rounding(scene: Scene) -> tuple[float, float]:
    """5 % and 95 % quantile of the free contact angle, rad, over bearings whose rounded dimensions are the scene's.

    cos(al0) = 1 - P_d/(2 A_0). Both bottom radii, both groove radii and the ball diameter are distributed uniformly
    within half of their last digit. Without clearance the angle is 0.
    """
    bearing, draw = scene.bearing, np.random.default_rng(SEED)
    inner, outer, inner_groove, outer_groove, diameter = (
        value + draw.uniform(-ROUNDING, ROUNDING, DRAWS)
        for value in (
            bearing.inner.bottom_radius,
            bearing.outer.bottom_radius,
            bearing.inner.groove_radius,
            bearing.outer.groove_radius,
            bearing.ball_diameter,
        )
    )
    clearance, distance = 2 * (outer - inner - diameter), inner_groove + outer_groove - diameter
    angles = np.arccos(1 - np.maximum(clearance, 0.0) / (2 * distance))
    low, high = np.quantile(angles, (0.05, 0.95))
    return float(low), float(high)


def report(swings: list[Swing], scene: Scene, torque: Array, out: Console) -> None:
    speeds = [f"{speed / RPM:.0f} rpm" for speed in scene.operation.inner_speed]
    table = Table("input", "scene", "other", *(f"at {speed}, %" for speed in speeds), "range from")
    for swing in swings:
        for row, (end, change) in enumerate(zip(swing.variation.ends, swing.changes, strict=True)):
            first = row == 0
            table.add_row(
                swing.variation.name if first else "", swing.variation.base if first else "", end.label,
                *(f"{100 * value:+.1f}" for value in change), swing.variation.source if first else "",
            )  # fmt: skip
    out.print(table)
    totals = " and ".join(f"{value * 1e3:.1f} N mm at {speed}" for value, speed in zip(torque, speeds, strict=True))
    out.print(f"{scene.name}: total torque {totals}, without a cage.")


def write(swings: list[Swing], scene: Scene, path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        speeds = (f"change_at_{speed / RPM:.0f}_rpm" for speed in scene.operation.inner_speed)
        writer.writerow(("input", "scene", "other", *speeds, "source"))
        for swing in swings:
            for end, change in zip(swing.variation.ends, swing.changes, strict=True):
                name, base, source = swing.variation.name, swing.variation.base, swing.variation.source
                writer.writerow((name, base, end.label, *(f"{value:.4f}" for value in change), source))


def draw(swings: list[Swing], scene: Scene, torque: Array, path: Path) -> None:
    figure = Figure(figsize=(11.0, 7.2), layout="constrained")
    axes = figure.subplots(1, torque.size, sharey=True, sharex=True)
    rows = np.arange(len(swings))
    low, high = (100 * limit(limit(change.min(), change.max()) for swing in swings for change in swing.changes)
                 for limit in (min, max))  # fmt: skip
    margin = 0.55 * (high - low)  # for the labels
    for point, axis in enumerate(axes):
        for row, swing in zip(rows, swings, strict=True):
            changes = [100 * change[point] for change in swing.changes]
            same_side = len(changes) == 2 and changes[0] * changes[1] >= 0
            for number, (end, change) in enumerate(zip(swing.variation.ends, changes, strict=True)):
                height = 0.36 if same_side else 0.72
                place = row + (0.18 * (2 * number - 1) if same_side else 0.0)
                axis.barh(place, change, height=height, color=("C0", "C1")[number])
                axis.annotate(
                    end.label, (change, place), xytext=(3 if change >= 0 else -3, 0), textcoords="offset points",
                    ha="left" if change >= 0 else "right", va="center", fontsize=6,
                )  # fmt: skip
        axis.axvline(0, color="k", lw=0.8)
        speed = scene.operation.inner_speed[point] / RPM
        axis.set(title=f"{speed:.0f} rpm: {torque[point] * 1e3:.1f} N mm", xlabel="change of the total torque, %")
        axis.set_xlim(low - margin, high + margin)
    axes[0].set_yticks(rows, [f"{swing.variation.name}\n({swing.variation.base})" for swing in swings], fontsize=8)
    axes[0].invert_yaxis()
    figure.supxlabel(
        "6205 under 1000 N thrust, Sq 1 µm, loaded angle, sinh traction, hydrodynamic rolling; no cage. One input at a "
        "time goes from the scene's value\n(in brackets) to each end of its range (named on the bar, the first end in "
        "blue). The ranges are judgements; sensitivity.csv lists their sources.",
        fontsize=8,
    )
    figure.savefig(path, dpi=130, metadata={"Software": None})


if __name__ == "__main__":
    main()
