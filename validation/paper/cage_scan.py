"""Friction whirl beside the cage of [Paper]: python validation/paper/cage_scan.py [--jobs 2] [--out FOLDER]

A cage that whirls rolls in its pockets and presses on all balls at once. This is the motion that gives forces as large
as the paper's. Three tables show what the calibrated reading of validation/paper/run.py rests on:

- the motion at two fixed coefficients of ball on pocket, with the three numbers that have the unit of a torque;
- the largest force over clearance and angle of the balls' axes, with the coefficients at which the friction moments
  about the balls' centres are the paper's cage torque;
- the motion that each start leads to.

Writes cage_scan.csv into this folder.
"""

import argparse
import csv
import os
from concurrent.futures import ProcessPoolExecutor
from dataclasses import asdict, dataclass, replace
from pathlib import Path

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads

import numpy as np
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic.cage.steady import whirl_force, whirl_speed
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import CageStart, Scene
from validation.paper.cage import (
    CLEARANCE,
    COEFFICIENTS,
    LOADED,
    LOADED_ANGLE,
    ROUGH,
    RPM,
    SMOOTH,
    CagePoint,
    cage_at,
    loose_cage,
    with_moving_cage,
)
from validation.paper.comparison import load, published

HERE = Path(__file__).parent
SPEEDS = (100.0, 200.0, 300.0, 400.0, 500.0)  # rpm, [Paper]
PRINTED = (100.0, 500.0)  # rpm, where the paper prints cage torque and largest force
FRICTIONS = (0.12, 0.06)
CLEARANCES = (0.06e-3, 0.08e-3, 0.09e-3, 0.1e-3, 0.11e-3, 0.12e-3, 0.2e-3)  # m
STARTS: tuple[CageStart, ...] = ("rest", "ramp", "sudden", "whirl")
OUTER_CONTROL = 0.252  # rad, at the loaded angle: tan = sin(al)/(cos(al) + D/d_m)
ANGLES = {"loaded": LOADED, "0.18 rad": 0.18, "outer control": LOADED}  # axes -> contact angle, rad
out = Console(width=118)


@dataclass(frozen=True, kw_only=True)
class Case:
    """A motion of the cage; SI but for the speed."""

    table: str
    rms_roughness: float  # of the races; the pocket has the coefficient
    clearance: float
    angle: str  # a key of ANGLES: where the balls' axes lie
    start: CageStart
    friction: float
    rpm: float


def cases() -> list[Case]:
    found = [
        Case(
            table="motion",
            rms_roughness=ROUGH,
            clearance=CLEARANCE,
            angle="loaded",
            start="whirl",
            friction=mu,
            rpm=rpm,
        )
        for mu in FRICTIONS
        for rpm in SPEEDS
    ]
    scene = load("calibrated")
    for angle in ANGLES:
        for clearance in CLEARANCES:
            for roughness in (ROUGH, SMOOTH):
                for rpm in PRINTED:
                    mu = fitting_coefficient(
                        scene, clearance=clearance, angle=ANGLES[angle], rms_roughness=roughness, rpm=rpm
                    )
                    found.append(
                        Case(
                            table="clearance", rms_roughness=roughness, clearance=clearance, angle=angle, start="whirl",
                            friction=mu, rpm=rpm,
                        )
                    )  # fmt: skip
    for start in STARTS:
        for rpm, mu in zip(PRINTED, COEFFICIENTS[ROUGH], strict=True):
            found.append(
                Case(
                    table="start", rms_roughness=ROUGH, clearance=CLEARANCE, angle="loaded", start=start, friction=mu,
                    rpm=rpm,
                )
            )  # fmt: skip
    return found


def fitting_coefficient(scene: Scene, *, clearance: float, angle: float, rms_roughness: float, rpm: float) -> float:
    """T/(r sum N): at it the friction moments about the balls' centres are the paper's cage torque T.

    clearance : of the pocket's diameter, m;  angle : contact angle, rad
    The force is the closed form of whirl, a few per cent from the motion's.
    """
    bearing, cage = scene.bearing, loose_cage(clearance=clearance, start="whirl", friction_coefficient=None)
    motion = ball_kinematics(rpm * RPM, angle, angle, bearing.pitch_diameter, bearing.ball_diameter)
    whirl = whirl_speed(
        ball_speed=motion.ball_speed, ball_radius=bearing.ball_radius, contact_angle=0.0, half_clearance=clearance / 2
    )
    force = whirl_force(cage_mass=cage.mass, whirl=whirl, orbit_speed=motion.cage_speed, half_clearance=clearance / 2)
    return printed("cage_torque", rms_roughness, rpm) / (bearing.ball_radius * float(force))


def printed(quantity: str, rms_roughness: float, rpm: float) -> float:
    """The paper's number, SI."""
    (value,) = [
        point.value
        for point in published()
        if (point.quantity, point.rms_roughness, round(point.inner_speed / RPM)) == (quantity, rms_roughness, rpm)
    ]
    return value


def computed(case: Case) -> CagePoint:
    scene = load("calibrated")
    cage = loose_cage(clearance=case.clearance, start=case.start, friction_coefficient=case.friction)
    if ANGLES[case.angle] == LOADED:
        scene = replace(scene, contact_angle=LOADED_ANGLE)
    axis = OUTER_CONTROL if case.angle == "outer control" else None
    return cage_at(with_moving_cage(scene, cage, inner_speed=case.rpm * RPM), axis_angle=axis)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=1, help="processes")
    parser.add_argument("--out", type=Path, default=HERE, help="folder for cage_scan.csv")
    options = parser.parse_args()
    todo = cases()
    with ProcessPoolExecutor(options.jobs) as pool:
        done = list(
            track(pool.map(computed, todo), total=len(todo), description="motions", disable=not out.is_terminal)
        )
    rows = list(zip(todo, done, strict=True))
    options.out.mkdir(parents=True, exist_ok=True)
    write(rows, options.out / "cage_scan.csv")
    report(rows)


def report(rows: list[tuple[Case, CagePoint]]) -> None:
    table = Table(
        *(
            "mu",
            "rpm",
            "sum of forces, N",
            "largest, N",
            "power/ring speed",
            "moments about balls",
            "mean |moment|, axis",
        ),
        title=f"Whirl in a clearance of {CLEARANCE * 1e3:g} mm; the last three in N mm, of which the first is a loss",
    )
    for case, point in rows:
        if case.table == "motion":
            torques = (point.torque, point.ball_moments, point.axial_moment)
            table.add_row(f"{case.friction:g}", f"{case.rpm:g}", f"{point.force:.3g}", f"{point.max_force:.3g}",
                          *(f"{1e3 * torque:.2g}" for torque in torques))  # fmt: skip
    out.print(table)
    report_clearances(rows)
    table = Table("start", *(f"{rpm:g} rpm" for rpm in PRINTED), title=f"Starts in {CLEARANCE * 1e3:g} mm, Sq 1 um")
    for start in STARTS:
        points = [point for case, point in rows if case.table == "start" and case.start == start]
        table.add_row(start, *(f"{point.state}, largest force {point.max_force:.2g} N" for point in points))
    out.print(table)


def report_clearances(rows: list[tuple[Case, CagePoint]]) -> None:
    """Largest forces over the paper's, and the worst factor of the four."""
    places = [(roughness, rpm) for roughness in (ROUGH, SMOOTH) for rpm in PRINTED]
    table = Table(
        "balls' axes", "clearance, mm", *(f"Sq {sq * 1e6:g} um, {rpm:g} rpm" for sq, rpm in places), "worst factor",
        title="Largest force over the paper's, and (coefficient at which the moments are the paper's cage torque)",
    )  # fmt: skip
    for angle in ANGLES:
        for clearance in CLEARANCES:
            ratios, cells = [], []
            for case, point in rows:
                if (case.table, case.angle, case.clearance) == ("clearance", angle, clearance):
                    ratios.append(point.max_force / printed("cage_max_force", case.rms_roughness, case.rpm))
                    cells.append(f"{ratios[-1]:.2f} ({case.friction:.3f})")
            worst = float(np.exp(np.max(np.abs(np.log(ratios)))))
            table.add_row(angle, f"{clearance * 1e3:g}", *cells, f"{worst:.2f}")
    out.print(table)


def write(rows: list[tuple[Case, CagePoint]], path: Path) -> None:
    flat = [
        asdict(case)
        | {key: value for key, value in asdict(point).items() if key not in ("max_force_range", "friction_coefficient")}
        | dict(zip(("max_force_low", "max_force_high"), point.max_force_range, strict=True))
        for case, point in rows
    ]
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write("# python validation/paper/cage_scan.py; SI, speed in rpm\n")
        writer = csv.DictWriter(file, flat[0], lineterminator="\n")
        writer.writeheader()
        for row in flat:
            writer.writerow({key: f"{value:.4g}" if isinstance(value, float) else value for key, value in row.items()})


if __name__ == "__main__":
    main()
