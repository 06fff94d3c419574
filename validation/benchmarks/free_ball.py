"""Time of free balls: python validation/benchmarks/free_ball.py

One point under thrust, one of 13 unequal balls, each beside closed kinematics in the same run, and a long series under
thrust in one process. Medians; the first call, which compiles or loads compiled code, is not counted but printed.
"""

from collections.abc import Callable
from dataclasses import replace
from statistics import median
from time import perf_counter

import numpy as np
from rich.console import Console
from rich.table import Table

from analytic import friction_torque, load_scene
from analytic.free_ball.rotation import Creep, FreeTurning, Nodes, Surfaces
from analytic.loads.balls import LoadEffects, loaded_balls
from analytic.oil.traction import CoulombTraction
from analytic.scene import Operation, Scene

REPEATS = 30
SERIES = 100_000
CREEPS: tuple[Creep, ...] = ("none", "closed", "marched")


def main() -> None:
    scene = load_scene("6205-dry")
    table = Table("what", "creep", "ms", title="Free balls")
    thrust = Operation(axial_load=np.array([1000.0]), inner_speed=np.array([523.6])).as_series()
    aside = Operation(
        axial_load=np.array([1000.0]), inner_speed=np.array([523.6]), radial_load=300.0, moment=1.0
    ).as_series()
    many = replace(scene, bearing=replace(scene.bearing, ball_count=13))
    started = perf_counter()
    balanced(scene, thrust, "marched")
    table.add_row("first call", "marched", f"{1e3 * (perf_counter() - started):.0f}")
    for name, given, operation in (("one thrust point", scene, thrust), ("13 unequal balls", many, aside)):
        table.add_row(name, "closed kinematics", f"{time_of(lambda g=given, o=operation: ruled(g, o)):.2f}")
        for creep in CREEPS:
            seconds = time_of(lambda g=given, o=operation, c=creep: balanced(g, o, c))
            table.add_row(name, creep, f"{seconds:.2f}")
    dry = replace(scene, effects={"finite_geometry": "off"}, cage=None)
    table.add_row("friction_torque, one thrust point", "auto", f"{time_of(lambda: friction_torque(dry)):.2f}")
    random = np.random.default_rng(7)
    series = Operation(
        axial_load=10 ** random.uniform(1.5, 3.5, SERIES), inner_speed=10 ** random.uniform(0.5, 3, SERIES)
    )
    started = perf_counter()
    found = friction_torque(replace(dry, operation=series))
    table.add_row(f"friction_torque, {SERIES} thrust points", found.sliding, f"{1e3 * (perf_counter() - started):.0f}")
    console = Console()
    console.print(table)
    worst = found.numerical_uncertainty.max()
    console.print(f"{found.provenance['sliding']}, numerical uncertainty {worst:.2g} at most")


def ruled(scene: Scene, operation: Operation) -> None:
    loaded_balls(scene.bearing, scene.contact_angle, operation, LoadEffects())


def balanced(scene: Scene, operation: Operation, creep: Creep) -> None:
    law = CoulombTraction(friction_coefficient=0.05)
    turning = FreeTurning(
        scene.bearing,
        (law, law),
        inner_speed=operation.inner_speed,
        balls=None if operation.is_thrust else scene.bearing.ball_count,
        surfaces=Surfaces(creep, Nodes(16, 12)),
    )
    loaded_balls(scene.bearing, scene.contact_angle, operation, LoadEffects(), turning=turning)


def time_of(call: Callable[[], object]) -> float:
    """Median time of a call, ms."""
    call()
    times = []
    for _ in range(REPEATS):
        started = perf_counter()
        call()
        times.append(perf_counter() - started)
    return 1e3 * median(times)


if __name__ == "__main__":
    main()
