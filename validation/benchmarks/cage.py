"""Accuracy of the cage's motion: python validation/benchmarks/cage.py [--duration 0.2]

A 6205 at 500 rpm with 0.2 mm of pocket clearance. Prints the drift of the energy of a cage without losses over fifty
bounces, against the step; the spread of torque and largest force between seeds; the convergence of torque and force
with the step; and the motion against both closed forms.
"""

import argparse
import os
from dataclasses import replace

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np
from rich.console import Console
from rich.table import Table

from analytic.cage.motion import CageMotion
from analytic.cage.statistics import measured_motion
from analytic.cage.steady import STANDARD_GRAVITY, DrivenCage, hanging_torque, whirl_force, whirl_speed
from analytic.cage.torque import driven_cage
from analytic.loads.kinematics import ball_kinematics
from analytic.scene import Cage, CageStart
from analytic.scenefile.read import load_scene
from validation.benchmarks.machine import machine, versions

SPEED = 500 * np.pi / 30  # rad/s
ANGLE = 0.18  # rad
STARTS: tuple[CageStart, ...] = ("rest", "whirl", "sudden")
out = Console(width=110)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--duration", type=float, default=0.2, help="measured time of each seed, s")
    parser.add_argument("--bounces", type=int, default=50, help="of the cage without losses")
    options = parser.parse_args()
    out.print(f"{machine()}; {versions('numpy')}")
    cage = example()
    energy(cage, bounces=options.bounces)
    spread(cage, duration=options.duration)
    steps(cage, duration=options.duration)
    closed_forms(cage, duration=options.duration)


def example() -> DrivenCage:
    """The cage of the built-in scene, with the scene's friction coefficient of the races."""
    scene = load_scene("6205-dry")
    bearing, cage = scene.bearing, scene.cage
    assert cage is not None
    moving = ball_kinematics(SPEED, ANGLE, ANGLE, bearing.pitch_diameter, bearing.ball_diameter)
    return driven_cage(
        bearing,
        cage,
        friction_coefficient=scene.friction_coefficient or 0.1,
        inner_speed=SPEED,
        orbit_speed=float(moving.cage_speed),
        ball_speed=float(moving.ball_speed),
        contact_angle=ANGLE,
    )


def energy(cage: DrivenCage, *, bounces: int) -> None:
    """Drift of the kinetic energy over its start, taken where the cage touches no ball."""
    free = replace(cage, friction_coefficient=0.0, restitution=1.0, gravity=(0.0, 0.0, 0.0), orbit_speed=0.0)
    table = Table("steps a contact", "largest drift of the energy", title=f"Without losses, {bounces} bounces")
    usual = Cage.steps_per_contact
    for steps_per_contact in (usual // 2, usual, 2 * usual):
        motion = CageMotion(free, begin="sudden", steps_per_contact=steps_per_contact)
        motion.launch(velocity=np.array([0.31, -0.22, 0.17]), angular_velocity=np.array([6.0, -9.0, 14.0]))
        first, count, touching, drift = motion.kinetic_energy, 0, False, 0.0
        while count < bounces:
            motion.advance(free.contact_time / 4)
            before, touching = touching, bool(motion.forces().any())
            count += touching and not before
            if not touching:
                drift = max(drift, abs(motion.kinetic_energy / first - 1))
        table.add_row(f"{steps_per_contact}", f"{drift:.1e}")
    out.print(table)


def spread(cage: DrivenCage, *, duration: float) -> None:
    columns = (
        "start",
        "state",
        "torque, N mm",
        "+- 95 %",
        "force of one contact, N",
        "largest seen, N",
        "damping, N mm",
    )
    table = Table(
        *columns, title=f"Four seeds of {duration:g} s; the force is the median of blocks of {duration / 10:g} s"
    )
    for name, case in (("", cage), (", balls leading 60 um", replace(cage, ball_lead=60e-6))):
        for start in STARTS:
            result = measured_motion(case, start=start, duration=duration)
            low, high = result.torque_interval
            force_low, force_high = result.max_force_interval
            table.add_row(
                f"{start}{name}",
                result.state,
                f"{result.torque * 1e3:.4g}",
                f"{(high - low) / 2 / result.torque:.2%}",
                f"{result.max_force:.3g} ({force_low:.3g} .. {force_high:.3g})",
                f"{max(result.block_maxima):.3g}",
                f"{result.damping_torque * 1e3:.3g}",
            )
    out.print(table)


def whirl_torque(cage: DrivenCage, *, force: float) -> float:
    """T = (2/pi) mu (sum N) r sin(al) (w_b/w), N m: a whirling cage that cannot tilt.

    The cage rolls in the plane and slides along z, as the axes of the balls lean out of that direction.
    """
    slip = cage.ball_speed / cage.ring_speed * cage.ball_radius * np.sin(ANGLE)
    return float(2 / np.pi * cage.friction_coefficient * force * slip)


def steps(cage: DrivenCage, *, duration: float) -> None:
    table = Table("steps a contact", "whirl, N mm", "largest force, N", "balls leading 60 um, N mm", "largest force, N")
    for steps_per_contact in (10, 20, 40, 80):
        row = [f"{steps_per_contact}"]
        for case in (cage, replace(cage, ball_lead=60e-6)):
            result = measured_motion(case, start="whirl", duration=duration / 2, steps_per_contact=steps_per_contact)
            row += [f"{result.torque * 1e3:.4f}", f"{result.max_force:.3f}"]
        table.add_row(*row)
    out.print(table)


def closed_forms(cage: DrivenCage, *, duration: float) -> None:
    weight, rate = cage.mass * STANDARD_GRAVITY, cage.ball_speed / cage.ring_speed
    hanging = hanging_torque(cage.friction_coefficient, weight, rate * cage.ball_radius, ANGLE)
    table = Table("motion", "quantity", "closed form", "simulated", "difference")

    def add(name: str, quantity: str, closed: float, simulated: float) -> None:
        table.add_row(name, quantity, f"{closed:.4g}", f"{simulated:.4g}", f"{simulated / closed - 1:+.2%}")

    resting = measured_motion(cage, start="rest", duration=duration)
    add("rest", "torque, N mm", hanging * 1e3, resting.torque * 1e3)
    for name, case, leaning in (
        ("whirl", cage, 0.0),
        ("whirl, tilt locked", replace(cage, transverse_inertia=1.0), ANGLE),
    ):
        motion = CageMotion(case, begin="whirl", seed=0)
        motion.advance(duration)
        record = motion.advance(duration)
        whirl = whirl_speed(
            ball_speed=cage.ball_speed,
            ball_radius=cage.ball_radius,
            contact_angle=leaning,
            half_clearance=cage.half_clearance,
        )
        force = whirl_force(
            cage_mass=cage.mass, whirl=whirl, orbit_speed=cage.orbit_speed, half_clearance=cage.half_clearance
        )
        add(name, "speed, rad/s", float(whirl) + cage.orbit_speed, record.circling)
        add(name, "sum of normal forces, N", float(force), record.force)
        if leaning:
            torque = whirl_torque(cage, force=float(force))
            add(name, "torque, N mm", torque * 1e3, record.slip_power / cage.ring_speed * 1e3)
    out.print(table)


if __name__ == "__main__":
    main()
