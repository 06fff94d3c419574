"""How fast is the friction torque? python validation/benchmarks/torque.py [--points 100000] [--contacts 1000000]

Wall times, as median, least and greatest, of
- the import in fresh interpreters;
- one thrust point, warm, and long series of random thrust points on one and on two processes, each with three laws of
  friction. Loads are 100 to 2000 N, speeds 10 to 150 and 10 to 300 rad/s. The inertia of the balls is left out in the
  first range and not in the second, because the worst point decides for the series;
- exact Hertz contacts;
- the equilibrium of the ring, and the torque with it.
The table also shows the methods chosen at a tolerance of 5 %. A series that would take too long is shortened and listed
with its reduced number of points. Prints a table and writes torque_benchmark.csv into the folder (validation/reports).
Times depend on the machine: let nothing else run.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads; one process uses one core
os.environ.setdefault("MKL_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import csv
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from multiprocessing import get_context
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich.console import Console
from rich.table import Table

from analytic import friction_torque, hertz_contact, load_scene, ring_equilibrium
from analytic.effects.table import COMPUTED
from analytic.result import FrictionTorque
from analytic.scene import Array, Operation, Scene
from machine import machine, versions

VALIDATION = Path(__file__).parents[1]
TOLERANCE = 0.05
SEED = 5
FASTEST = (150.0, 300.0)  # rad/s; the inertia of the balls is left out up to the first, not up to the second
PROCESSES = 2
FEW, GROWTH = 10, 10  # points
SHORT = 0.2  # s; shorter calls are repeated within one timing
IMPORTS = {
    "import analytic": "import analytic",
    "and the two functions": "from analytic import friction_torque, load_scene",
}


@dataclass(frozen=True, kw_only=True)
class Row:
    """One line of the table."""

    what: str
    scene: str = ""
    processes: int = 1
    seconds: list[float]
    limit: float | None = None  # s, to be reached
    methods: str = ""
    effects: str = ""  # that were computed

    @property
    def median(self) -> float:
        return statistics.median(self.seconds)


def main(
    points: Annotated[int, typer.Option(help="Points of a series of thrust points.")] = 100_000,
    contacts: Annotated[int, typer.Option(help="Number of Hertz contacts.")] = 1_000_000,
    ring_points: Annotated[int, typer.Option(help="Points of the series under radial load.")] = 1000,
    longest: Annotated[float, typer.Option(help="Seconds that a series may take; a longer one is shortened.")] = 30.0,
    repeats: Annotated[int, typer.Option(help="Repeats of each timing.")] = 5,
    out: Annotated[Path, typer.Option(help="Folder for torque_benchmark.csv.")] = VALIDATION / "reports",
) -> None:
    shown = Console(width=150)
    rows = [*imports(repeats)]
    with ProcessPoolExecutor(PROCESSES, mp_context=get_context("spawn")) as pool:
        for name, scene in scenes().items():
            rows.append(one_point(name, scene, repeats))
            for fastest in FASTEST:
                rows += series(name, scene, fastest, points, longest, repeats, pool)
    rows.append(hertz(contacts, repeats))
    for count in (1, ring_points):
        rows += ring(count, longest, repeats)
    shown.print(f"{machine()}; {versions('fembearing', 'numpy', 'scipy')}; tolerance {TOLERANCE:.0%}")
    show(rows, shown)
    out.mkdir(parents=True, exist_ok=True)
    write(rows, out / "torque_benchmark.csv")


def scenes() -> dict[str, Scene]:
    """The same bearing with three laws of friction; loads and speeds come from each series."""
    physical = load_scene(VALIDATION / "scenes" / "6205_physical.toml")
    assert physical.lubricant is not None
    constant = replace(physical, lubricant=replace(physical.lubricant, traction="eyring_constant"))
    given = replace(load_scene("6205-dry"), cage=None)
    laws = {"given coefficient": given, "constant Eyring stress": constant, "sinh traction": physical}
    return {name: replace(scene, tolerance=TOLERANCE) for name, scene in laws.items()}


def imports(repeats: int) -> list[Row]:
    """Times of imports in fresh interpreters; the first, which compiles the files, does not count."""
    rows = []
    for name, statement in IMPORTS.items():
        program = f"import time; started = time.perf_counter(); {statement}; print(time.perf_counter() - started)"
        run = [
            float(subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True).stdout)
            for _ in range(repeats + 1)
        ]
        rows.append(Row(what=name, seconds=run[1:], limit=0.4 if name == "import analytic" else None))
    return rows


def one_point(name: str, scene: Scene, repeats: int) -> Row:
    point = replace(scene, operation=Operation(axial_load=np.array([1000.0]), inner_speed=np.array([52.0])))
    result = friction_torque(point)
    return Row(
        what="1 thrust point",
        scene=name,
        seconds=timed(lambda: friction_torque(point), repeats),
        limit=1e-3,
        methods=methods(result),
        effects=computed(result),
    )


def series(
    name: str, scene: Scene, fastest: float, points: int, longest: float, repeats: int, pool: ProcessPoolExecutor
) -> list[Row]:
    random = np.random.default_rng(SEED)
    load, speed = random.uniform(100, 2000, points), random.uniform(10, fastest, points)

    def some(part: slice) -> Scene:
        return replace(scene, operation=Operation(axial_load=load[part], inner_speed=speed[part]))

    points = affordable(lambda few: friction_torque(some(slice(few))), points, longest)
    long, half = some(slice(points)), points // PROCESSES
    parts = [some(slice(half)), some(slice(half, points))]
    what, limit = f"{points} thrust points to {fastest:g} rad/s", 2 * points / 100_000
    _, chosen, effects = totals(long)
    rows = [Row(what=what, scene=name, seconds=timed(lambda: totals(long), repeats), methods=chosen, effects=effects)]
    (_, *first), (_, *second) = pool.map(totals, parts)  # not timed: the processes start and import here
    seconds = timed(lambda: list(pool.map(totals, parts)), repeats)
    chosen, effects = (" and ".join(dict.fromkeys(pair)) for pair in zip(first, second, strict=True))
    return [
        *rows,
        Row(
            what=what, scene=name, processes=PROCESSES, seconds=seconds, limit=limit, methods=chosen, effects=effects
        ),
    ]  # fmt: skip


def affordable(call: Callable[[int], object], points: int, longest: float) -> int:
    """The number of points whose call takes about `longest` seconds, at most `points`.

    Starts with few points and takes ten times as many until one call takes a tenth of that time.
    """
    few = FEW
    while few < points:
        [seconds] = timed(lambda few=few: call(few), 1)
        if seconds > longest / GROWTH:
            return max(PROCESSES, int(few * longest / seconds))
        few *= GROWTH
    return points


def totals(scene: Scene) -> tuple[Array, str, str]:
    """The result of a process: torques, N m, methods and effects."""
    result = friction_torque(scene)
    return result.torque.total, methods(result), computed(result)


def hertz(contacts: int, repeats: int) -> Row:
    curvatures = np.geomspace(37.0, 3.7e7, contacts)
    return Row(
        what=f"{contacts} Hertz contacts",
        scene="curvature ratios 1 to 1e6",
        seconds=timed(
            lambda: hertz_contact(curvature_x=curvatures, curvature_y=37.0, load=620.0, modulus=1.13e11), repeats
        ),
        limit=0.5 * contacts / 1e6,
        methods="exact",
    )


def ring(points: int, longest: float, repeats: int) -> list[Row]:
    """Thrust and radial load of similar size, at speed: the equilibrium, and the torque of its unequal balls."""
    axial, radial = np.random.default_rng(SEED).uniform(100, 2000, (2, points))
    speed = np.random.default_rng(SEED + 1).uniform(10, 300, points)
    sinh = scenes()["sinh traction"]

    def some(few: int) -> Scene:
        operation = Operation(axial_load=axial[:few], inner_speed=speed[:few], radial_load=radial[:few])
        return replace(sinh, operation=operation)

    few = affordable(lambda few: friction_torque(some(few)), points, longest)
    scene, plural = some(few), "" if few == 1 else "s"
    result = friction_torque(scene)
    return [
        Row(
            what=f"ring, {points} point{'' if points == 1 else 's'}",
            scene="thrust, radial load, speed",
            seconds=timed(
                lambda: ring_equilibrium(
                    scene.bearing, scene.contact_angle, axial_load=axial, radial_load_x=radial, inner_speed=speed
                ),
                repeats,
            ),
            methods="equilibrium of the ring",
        ),
        Row(
            what=f"torque with it, {few} point{plural}",
            scene="sinh traction",
            seconds=timed(lambda: friction_torque(scene), repeats),
            methods=methods(result),
            effects=computed(result),
        ),
    ]


def timed(call: Callable[[], object], repeats: int) -> list[float]:
    """Seconds of one call, warm; short calls are repeated within one timing."""
    started = time.perf_counter()
    call()
    once = time.perf_counter() - started
    number = max(1, round(SHORT / max(once, 1e-6))) if repeats > 1 else 1
    seconds = []
    for _ in range(repeats):
        started = time.perf_counter()
        for _ in range(number):
            call()
        seconds.append((time.perf_counter() - started) / number)
    return seconds


def methods(result: FrictionTorque) -> str:
    return "; ".join(result.provenance[name] for name in ("loads", "contacts", "sliding"))


def computed(result: FrictionTorque) -> str:
    return ", ".join(
        effect.name.replace("_", " ")
        for effect in result.effects
        if effect.name in COMPUTED and effect.decision == "on"
    )


def show(rows: list[Row], out: Console) -> None:
    table = Table(
        "what", "scene", "processes", "median", "least to greatest", "to reach", "methods", "effects computed"
    )
    for row in rows:
        unit, name = (1.0, "s") if row.median >= 0.1 else (1e3, "ms")
        table.add_row(
            *(row.what, row.scene, str(row.processes), f"{unit * row.median:.3g} {name}"),
            f"{unit * min(row.seconds):.3g} to {unit * max(row.seconds):.3g} {name}",
            "" if row.limit is None else f"{unit * row.limit:.3g} {name}",
            *(row.methods, row.effects),
        )
    out.print(table)


def write(rows: list[Row], path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write(f"# {machine()}\n# {versions('fembearing', 'numpy', 'scipy')}; tolerance {TOLERANCE:g}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(
            (*("what", "scene", "processes", "median_s", "least_s", "greatest_s", "repeats", "to_reach_s"),
             *("methods", "effects_computed"))
        )  # fmt: skip
        for row in rows:
            times = (f"{value:.4g}" for value in (row.median, min(row.seconds), max(row.seconds)))
            limit = "" if row.limit is None else f"{row.limit:.4g}"
            writer.writerow(
                (row.what, row.scene, row.processes, *times, len(row.seconds), limit, row.methods, row.effects)
            )


if __name__ == "__main__":
    typer.run(main)
