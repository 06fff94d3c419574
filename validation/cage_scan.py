"""Scan of the cage's unknown inputs: python validation/cage_scan.py [--jobs 2] [--duration 0.1] [--out FOLDER]

For its cage [Paper] gives no clearance (its pocket cannot be made), restitution, contact stiffness, friction of ball on
pocket, start or simulated time. This script varies them at the five speeds of the paper, 100 to 500 rpm, and computes
the deviation of every case from the four numbers that the paper prints for each roughness: cage torque and largest
force at 100 and 500 rpm. Between these speeds the paper only says that the torque rises. The roughness changes only the
friction, so a setting is all inputs but the friction, which may differ between the two roughnesses. Nothing is fitted
between the points of the scan, and a setting that came close would be a calibration, not a prediction.

A cage that starts at rest stays there, and neither stiffness nor restitution matters. For that start they are varied at
one clearance only, and the change is printed.
"""

import argparse
import csv
import itertools
import os
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads

import matplotlib
import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic.cage.statistics import measured_motion
from analytic.cage.torque import driven_cage
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import Cage, CageStart
from analytic.scenefile.read import builtin_scene, load_scene
from paper_comparison import ROUGH, RPM, SMOOTH, published

HERE = Path(__file__).parent
SPEEDS = (100.0, 200.0, 300.0, 400.0, 500.0)  # rpm, [Paper]
PRINTED = (100.0, 500.0)  # rpm, speeds at which the paper prints cage torque and largest force
ANGLE = 0.18  # rad, [Paper]
CLEARANCES: tuple[float | None, ...] = (0.1e-3, 0.2e-3, 0.4e-3, None)  # m; None: the pocket of Table 1 of [Paper]
VARIED_AT_REST = 0.2e-3  # m, the clearance at which a start at rest takes every stiffness and restitution
STIFFNESSES = {"Hertz": None, "sheet": 28.0 / 0.883e-6**1.5}  # N/m^1.5: finite elements of the sheet on its rim
RESTITUTIONS = (0.5, 0.9)
STARTS: tuple[CageStart, ...] = ("rest", "sudden")
FRICTIONS = (0.03, 0.1, 0.2)
LEADS = (0.0, 0.6)  # lead of the balls over half the clearance
SEEDS = 2
NEAR = 1.25  # factor on each number; a smaller one makes no sense for numbers printed with "about"
out = Console(width=118)


@dataclass(frozen=True, kw_only=True)
class Setting:
    """All inputs of a motion but speed and friction; lengths in m."""

    clearance: float | None
    stiffness: str
    restitution: float
    start: CageStart
    lead: float  # over half the clearance


@dataclass(frozen=True, kw_only=True)
class Row:
    """The result of one motion; SI."""

    setting: Setting
    friction: float
    speed_rpm: float
    torque: float
    torque_low: float
    torque_high: float
    max_force: float  # median over blocks of a tenth of the duration
    largest_force: float
    damping_torque: float
    state: str


def settings() -> Iterator[Setting]:
    for clearance, stiffness, restitution, start, lead in itertools.product(
        CLEARANCES, STIFFNESSES, RESTITUTIONS, STARTS, LEADS
    ):
        first = stiffness == next(iter(STIFFNESSES)) and restitution == RESTITUTIONS[0]
        if first or start != "rest" or clearance == VARIED_AT_REST:
            yield Setting(clearance=clearance, stiffness=stiffness, restitution=restitution, start=start, lead=lead)


def computed(setting: Setting, friction: float, rpm: float, duration: float) -> Row:
    scene = load_scene(builtin_scene("6205"))
    bearing, given = scene.bearing, scene.cage
    assert given is not None
    if setting.clearance is None:
        diameter, depth = 13.9e-3, 6.81e-3
    else:
        diameter = bearing.ball_diameter + setting.clearance
        depth = diameter / 2
    cage = Cage(
        pocket_diameter=diameter,
        pocket_depth=depth,
        wall_thickness=given.wall_thickness,
        mass=given.mass,
        material=given.material,
        pocket_stiffness=STIFFNESSES[setting.stiffness],
        restitution=setting.restitution,
    )
    moving = ball_kinematics(
        inner_speed=rpm * RPM,
        inner_angle=ANGLE,
        outer_angle=ANGLE,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    driven = driven_cage(
        bearing,
        cage,
        friction_coefficient=friction,
        inner_speed=rpm * RPM,
        orbit_speed=float(moving.cage_speed),
        ball_speed=float(moving.ball_speed),
        contact_angle=ANGLE,
    )
    driven = replace(driven, ball_lead=setting.lead * (depth - bearing.ball_radius))
    result = measured_motion(driven, start=setting.start, seeds=SEEDS, duration=duration)
    return Row(
        setting=setting,
        friction=friction,
        speed_rpm=rpm,
        torque=result.torque,
        torque_low=result.torque_interval[0],
        torque_high=result.torque_interval[1],
        max_force=result.max_force,
        largest_force=max(result.block_maxima),
        damping_torque=result.damping_torque,
        state=result.state,
    )


def targets() -> dict[tuple[float, str, float], float]:
    """(roughness, quantity, rpm) -> the paper's number, SI."""
    return {
        (point.rms_roughness, point.quantity, round(point.inner_speed / RPM)): point.value
        for point in published()
        if point.quantity in ("cage_torque", "cage_max_force")
    }


def deviations(case: dict[float, Row], paper: dict[tuple[float, str, float], float], roughness: float) -> list[float]:
    """ln(computed/paper) of torque and largest force at `PRINTED`; the force is the largest of all, as in the paper."""
    result = []
    for rpm in PRINTED:
        for quantity, ours in (("cage_torque", case[rpm].torque), ("cage_max_force", case[rpm].largest_force)):
            result.append(float(np.log(max(ours, 1e-12) / paper[roughness, quantity, rpm])))
    return result


def by_case(rows: list[Row]) -> dict[tuple[Setting, float], dict[float, Row]]:
    """(setting, friction) -> its motions by rpm."""
    cases: dict[tuple[Setting, float], dict[float, Row]] = {}
    for row in rows:
        cases.setdefault((row.setting, row.friction), {})[row.speed_rpm] = row
    return cases


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--duration", type=float, default=0.1, help="measured time of each of two seeds, s")
    parser.add_argument("--every", type=int, default=1, help="take only every n-th setting, for a trial")
    parser.add_argument("--out", type=Path, default=HERE / "reports", help="folder for cage_scan.csv and .png")
    options = parser.parse_args()
    chosen = list(settings())[:: options.every]
    jobs = [(s, mu, rpm, options.duration) for s in chosen for mu in FRICTIONS for rpm in SPEEDS]
    with ProcessPoolExecutor(options.jobs) as pool:
        motions = pool.map(computed, *zip(*jobs, strict=True), chunksize=4)
        rows = list(track(motions, total=len(jobs), description="motions", disable=not out.is_terminal))
    paper = targets()
    options.out.mkdir(parents=True, exist_ok=True)
    write(rows, options.out / "cage_scan.csv", options.duration)
    draw(rows, paper, options.out / "cage_scan.png")
    report(rows, paper)


def report(rows: list[Row], paper: dict[tuple[float, str, float], float]) -> None:
    cases = by_case(rows)
    for roughness in (ROUGH, SMOOTH):
        ranked = sorted(cases.items(), key=lambda item: max(map(abs, deviations(item[1], paper, roughness))))
        printed = " and ".join(
            f"{paper[roughness, 'cage_torque', rpm] * 1e3:g}, {paper[roughness, 'cage_max_force', rpm]:.4g} at {rpm:g}"
            for rpm in PRINTED
        )
        table = Table(
            *("setting", "mu", *(f"{rpm:g} rpm" for rpm in SPEEDS), "worst"),
            title=f"Sq {roughness * 1e6:g} um, nearest cases: torque, N mm, and largest force, N; paper: {printed} rpm",
            caption="r rest, w whirl, i irregular, m mixed; worst: largest factor to the four numbers of the paper",
        )
        for (setting, friction), case in ranked[:5]:
            numbers = [f"{row.torque * 1e3:.2g}, {row.largest_force:.2g} {row.state[0]}" for row in case.values()]
            worst = np.exp(max(map(abs, deviations(case, paper, roughness))))
            table.add_row(_words(setting), f"{friction:g}", *numbers, f"{worst:.2g}")
        out.print(table)
        for quantity, index in (("torque", 0), ("largest force", 1)):
            near = sum(max(map(abs, deviations(case, paper, roughness)[index::2])) < np.log(NEAR) for _, case in ranked)
            out.print(
                f"{near} of {len(ranked)} cases have the {quantity} at 100 and 500 rpm within a factor of {NEAR:g}."
            )
        near = sum(max(map(abs, deviations(case, paper, roughness))) < np.log(NEAR) for _, case in ranked)
        out.print(f"{near} of {len(ranked)} cases have all four numbers within this factor.\n")
    report_speed(cases, paper)
    report_rest(cases)
    report_one_cage(cases, paper)


def report_speed(
    cases: dict[tuple[Setting, float], dict[float, Row]], paper: dict[tuple[float, str, float], float]
) -> None:
    """In how many cases the torque rises with speed, and in how many as much as in the paper."""
    torques = [[case[rpm].torque for rpm in SPEEDS] for case in cases.values()]
    rising = [torque for torque in torques if np.all(np.diff(torque) > 0)]
    least = min(
        paper[roughness, "cage_torque", PRINTED[1]] / paper[roughness, "cage_torque", PRINTED[0]]
        for roughness in (ROUGH, SMOOTH)
    )
    far = sum(torque[-1] > least / NEAR * torque[0] for torque in rising)
    out.print(
        f"The cage torque rises from each speed to the next in {len(rising)} of {len(cases)} cases, in {far} of them "
        f"by a factor of {least / NEAR:.2g} or more from 100 to 500 rpm; in the paper by {least:.2g} or more."
    )


def report_rest(cases: dict[tuple[Setting, float], dict[float, Row]]) -> None:
    """The effect of stiffness and restitution on a start at rest, at the clearance with all of them."""
    alike: dict[tuple[float, float, float], list[Row]] = {}
    for (setting, friction), case in cases.items():
        if setting.start == "rest" and setting.clearance == VARIED_AT_REST:
            for rpm, row in case.items():
                alike.setdefault((setting.lead, friction, rpm), []).append(row)
    if not alike:
        return
    spread = max(max(row.torque for row in group) / min(row.torque for row in group) for group in alike.values()) - 1
    force = max(row.largest_force for group in alike.values() for row in group)
    out.print(
        f"From rest in {VARIED_AT_REST * 1e3:g} mm, stiffness and restitution change the torque by {spread:.1%} at "
        f"most, and no force exceeds {force:.2g} N; for this start, other clearances have one value of each."
    )


def report_one_cage(
    cases: dict[tuple[Setting, float], dict[float, Row]], paper: dict[tuple[float, str, float], float]
) -> None:
    """The nearest setting, if each roughness has its own friction."""
    best: dict[Setting, float] = {}
    for setting in dict.fromkeys(setting for setting, _ in cases):
        worst = [
            min(
                max(map(abs, deviations(case, paper, roughness)))
                for (other, _), case in cases.items()
                if other == setting
            )
            for roughness in (ROUGH, SMOOTH)
        ]
        best[setting] = max(worst)
    setting = min(best, key=lambda one: best[one])
    out.print(
        f"One cage for both roughnesses, each with its own friction: nearest is {_words(setting)}, with all eight "
        f"numbers within a factor of {np.exp(best[setting]):.3g}."
    )


def write(rows: list[Row], path: Path, duration: float) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write(
            f"# python validation/cage_scan.py --duration {duration:g}: {SEEDS} seeds, {duration:g} s each after "
            "as long a start-up; SI\n"
        )
        flat = [asdict(row.setting) | {k: v for k, v in vars(row).items() if k != "setting"} for row in rows]
        writer = csv.DictWriter(file, flat[0])
        writer.writeheader()
        for row in flat:
            writer.writerow({k: f"{v:.5g}" if isinstance(v, float) else v for k, v in row.items()})


def draw(rows: list[Row], paper: dict[tuple[float, str, float], float], path: Path) -> None:
    """Torque and largest force over speed: one point for each motion, a line for the nearest case of each roughness."""
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, panels = pyplot.subplots(1, 2, figsize=(11, 5.2), layout="constrained")
    colours = {"rest": "tab:blue", "whirl": "tab:orange", "irregular": "tab:green", "mixed": "tab:gray"}
    quantities = {
        "cage_torque": ("cage torque, N mm", 1e3, lambda row: row.torque),
        "cage_max_force": ("largest force of a ball on the cage, N", 1.0, lambda row: row.largest_force),
    }
    nearest: dict[tuple[Setting, float], list[str]] = {}  # case -> roughnesses for which it is the nearest
    cases = by_case(rows)
    for roughness in (ROUGH, SMOOTH):
        case = min(cases, key=lambda one: max(map(abs, deviations(cases[one], paper, roughness))))
        nearest.setdefault(case, []).append(f"Sq {roughness * 1e6:g} µm")
    for panel, (quantity, (label, factor, value)) in zip(panels, quantities.items(), strict=True):
        for position, (state, colour) in enumerate(colours.items()):
            at = [row for row in rows if row.state == state and value(row) > 0]
            place = [row.speed_rpm + 12 * (position - 1.5) for row in at]  # side by side, so that all stay visible
            heights = [factor * value(row) for row in at]
            panel.plot(place, heights, ".", color=colour, label=f"scan: {state}", alpha=0.5, markeredgewidth=0)
        for (case, roughnesses), style in zip(nearest.items(), ("-", "--"), strict=False):
            near = [factor * value(cases[case][rpm]) for rpm in SPEEDS]
            panel.plot(SPEEDS, near, style, color="black", lw=1, label=f"nearest case to {' and '.join(roughnesses)}")
        for roughness, mark in ((ROUGH, "*"), (SMOOTH, "P")):
            values = [factor * paper[roughness, quantity, rpm] for rpm in PRINTED]
            name = f"paper, Sq {roughness * 1e6:g} µm"
            panel.plot(PRINTED, values, mark, color="red", mec="black", ms=11, label=name, zorder=3)
        panel.set(xlabel="speed of the inner ring, rpm", ylabel=label, yscale="log", xticks=SPEEDS)
        panel.grid(alpha=0.3)
    figure.legend(
        *panels[0].get_legend_handles_labels(), loc="outside lower center", ncols=4, fontsize=9, frameon=False
    )
    figure.suptitle("The cage in motion: a scan of clearance, stiffness, restitution, start, friction and ball lead")
    figure.savefig(path, dpi=110)


def _words(setting: Setting) -> str:
    pocket = "Table 1's pocket" if setting.clearance is None else f"{setting.clearance * 1e3:g} mm"
    lead = ", balls leading" if setting.lead else ""
    return f"{pocket}, {setting.stiffness}, e {setting.restitution:g}, {setting.start}{lead}"


if __name__ == "__main__":
    main()
