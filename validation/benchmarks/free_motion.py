"""Cost and limits of balls and cage in motion together: python validation/benchmarks/free_motion.py [--duration 0.05]

A 6205 with 0.2 mm of pocket clearance and a free contact angle of 0.18 rad, under thrust. Prints the processor time of
one step, warm, on one core, beside that of the motion on given balls; the energy that the steps lose; the torque
against the step; and the motion against closed limits and against given balls.
"""

import argparse
import os
import statistics
import time
from dataclasses import replace
from typing import Any

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from rich.console import Console
from rich.table import Table

from analytic.cage.motion import CageMotion, MeanMotion
from analytic.cage.raceways import Raceways, thrust_raceways
from analytic.cage.steady import DrivenCage
from analytic.cage.torque import driven_cage
from analytic.scene import CageStart, ContactAngle, Operation
from analytic.scenefile.read import load_scene
from analytic.torque import loaded_balls_of
from validation.benchmarks.machine import machine, versions

RPM = np.pi / 30  # rad/s
ANGLE = ContactAngle(rule="solved", free=0.18)
# name, axial load in N, speed in rpm, start
CASES: tuple[tuple[str, float, float, CageStart], ...] = (
    ("rest", 1000.0, 500.0, "rest"),
    ("whirl", 1000.0, 500.0, "whirl"),
    ("sudden start", 1000.0, 500.0, "sudden"),
    ("sliding balls", 1000.0, 5000.0, "whirl"),
    ("rattling", 100.0, 6000.0, "whirl"),
)
out = Console(width=120)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repeats", type=int, default=5, help="repeats of each timing; the median counts")
    parser.add_argument("--duration", type=float, default=0.05, help="measured time of a motion, s")
    options = parser.parse_args()
    out.print(f"{machine()}; {versions('numpy')}")
    times(repeats=options.repeats)
    energy()
    steps(duration=options.duration)
    limits(duration=options.duration)


def example(*, axial_load: float = 1000.0, rpm: float = 500.0, friction: float = 0.1) -> tuple[DrivenCage, Raceways]:
    """The built-in bearing and cage, one coefficient at both races, 0.1 in the pockets."""
    scene = load_scene("6205-dry")
    assert scene.cage is not None
    speed = rpm * RPM
    operation = Operation(axial_load=np.array([axial_load]), inner_speed=np.array([speed]))
    balls = loaded_balls_of(replace(scene, contact_angle=ANGLE, operation=operation))[0]
    cage = driven_cage(
        scene.bearing,
        scene.cage,
        friction_coefficient=0.1,
        inner_speed=speed,
        orbit_speed=float(balls["motion"]["cage_speed"][0] * speed),
        ball_speed=float(balls["motion"]["ball_speed"][0] * speed),
        contact_angle=float(balls["angle"].mean()),
    )
    return cage, thrust_raceways(scene.bearing, balls, inner_speed=speed, friction=(friction, friction))


def times(*, repeats: int) -> None:
    columns = ("motion", "given balls, us a step", "free balls, us a step", "ratio", "step, us", "N, all pockets")
    table = Table(*columns, title="Nine balls, one core, warm; medians of one run")
    for name, load, rpm, start in CASES:
        cage, races = example(axial_load=load, rpm=rpm)
        given, free = CageMotion(cage, begin=start, seed=0), CageMotion(cage, races, begin=start, seed=0)
        free.advance(0.01)
        taken = [(step_time(given), step_time(free)) for _ in range(repeats)]  # in turn: other work slows both
        each = [statistics.median(of_motion) * 1e6 for of_motion in zip(*taken, strict=True)]
        force = free.advance(1e-3).force
        row = (*(f"{value:.2f}" for value in each), f"{each[1] / each[0]:.1f}", f"{free.step * 1e6:.3f}")
        table.add_row(name, *row, f"{force:.3g}")
    out.print(table)


def step_time(motion: CageMotion) -> float:
    """Processor time of a step, s."""
    started = time.process_time()
    passed = motion.advance(5e-3)
    return (time.process_time() - started) / (passed.duration / motion.step)


def energy() -> None:
    """From a sudden start without gravity: what neither losses nor kinetic energy account for."""
    table = Table("steps a contact", "energy unaccounted for, of the ring's work", title="4 ms, restitution 0.6")
    for steps_per_contact in (20, 40, 80, 160):
        cage, races = example()
        cage = replace(cage, gravity=(0.0, 0.0, 0.0), restitution=0.6)
        motion = CageMotion(cage, races, begin="sudden", seed=0, steps_per_contact=steps_per_contact)
        before, passed = motion.kinetic_energy, motion.advance(4e-3)
        work, change = passed.ring_power * passed.duration, motion.kinetic_energy - before
        table.add_row(f"{steps_per_contact}", f"{(work - lost(passed) * passed.duration - change) / work:.1e}")
    out.print(table)


def lost(passed: MeanMotion) -> float:
    """W."""
    in_pockets = passed.slip_power + passed.damping_power + passed.land_power + passed.drag_power
    return in_pockets + passed.race_power + passed.numerical_power


def steps(*, duration: float) -> None:
    table = Table("steps a contact", "rest, N mm", "whirl, N mm", "whirl, sum of forces, N")
    cage, races = example()
    for steps_per_contact in (20, 40, 80):
        options: dict[str, Any] = {"duration": duration, "steps_per_contact": steps_per_contact}
        rest, whirl = (run(cage, races, begin=start, **options) for start in ("rest", "whirl"))
        torques = (passed.slip_power / cage.ring_speed * 1e3 for passed in (rest, whirl))
        table.add_row(f"{steps_per_contact}", *(f"{torque:.4f}" for torque in torques), f"{whirl.force:.3f}")
    out.print(table)


def run(cage: DrivenCage, races: Raceways, *, duration: float, **options: Any) -> MeanMotion:
    motion = CageMotion(cage, races, seed=0, **options)
    motion.advance(duration)
    return motion.advance(duration)


def limits(*, duration: float) -> None:
    columns = (
        "motion",
        "forces, N",
        "given balls",
        "largest, N",
        "2 mu Q/(1+mu_c)",
        "pockets, N mm",
        "races, N mm",
        "alone",
    )
    table = Table(*columns, title="Free balls, after a start-up as long as the measured time")
    for name, load, rpm, start in CASES:
        cage, races = example(axial_load=load, rpm=rpm)
        passed = run(cage, races, begin=start, duration=duration)
        given = CageMotion(cage, begin=start, seed=0)
        given.advance(duration)
        torques = (passed.slip_power, passed.race_power, passed.alone_power)
        table.add_row(
            f"{name}, {load:g} N, {rpm:g} rpm",
            f"{passed.force:.4g}",
            f"{given.advance(duration).force:.4g}",
            f"{passed.max_force:.4g}",
            f"{2 * races.limits.min() / 1.1:.3g}",
            *(f"{power / cage.ring_speed * 1e3:.4g}" for power in torques),
        )
    out.print(table)


if __name__ == "__main__":
    main()
