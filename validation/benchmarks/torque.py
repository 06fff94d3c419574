"""How fast is the friction torque? python validation/benchmarks/torque.py [--points 100000] [--contacts 1000000]

Wall times, medians with the least and the greatest: the import in fresh interpreters; one thrust point, warm, and long
series of random thrust points (100 to 2000 N, from 10 rad/s to where inertia of the balls is left out and to where it
is not, as the worst point decides) on one and on two processes, for three ways in which balls rub; exact Hertz
contacts; the equilibrium of the ring and the torque on it; with each the rungs chosen at a tolerance of 5 %. A series
that would take too long is cut, and told with the points that are left. Prints a table and writes torque_benchmark.csv
into the folder (validation/reports). Times are the machine's: let nothing else run.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads: a process stands for a core
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
from analytic.effects.ledger import COMPUTED
from analytic.result import FrictionTorque
from analytic.scene import Array, Operation, Scene
from analytic.scenefile.read import builtin_scene
from machine import machine, versions

VALIDATION = Path(__file__).parents[1]
TOLERANCE = 0.05
SEED = 5
FASTEST = (150.0, 300.0)  # rad/s
PROCESSES = 2
FEW, GROWTH = 10, 10  # points
SHORT = 0.2  # s: shorter calls are timed many at a time
IMPORTS = {
    "import analytic": "import analytic",
    "with what it names": "from analytic import friction_torque, load_scene",
}


@dataclass(frozen=True, kw_only=True)
class Row:
    """One line of the table."""

    what: str
    scene: str = ""
    processes: int = 1
    seconds: list[float]
    limit: float | None = None  # s, to be reached
    rungs: str = ""
    effects: str = ""  # that were computed

    @property
    def median(self) -> float:
        return statistics.median(self.seconds)


def main(
    points: Annotated[int, typer.Option(help="Of the series of thrust points.")] = 100_000,
    contacts: Annotated[int, typer.Option(help="Hertz contacts.")] = 1_000_000,
    ring_points: Annotated[int, typer.Option(help="Of the series under radial load.")] = 1000,
    longest: Annotated[float, typer.Option(help="Seconds that a series may take; else it is made shorter.")] = 30.0,
    repeats: Annotated[int, typer.Option(help="Of each time.")] = 5,
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
    """The same bearing, rubbing in three ways; each runs at what its series says."""
    physical = load_scene(VALIDATION / "scenes" / "6205_physical.toml")
    assert physical.lubricant is not None
    constant = replace(physical, lubricant=replace(physical.lubricant, traction="eyring_constant"))
    given = replace(load_scene(builtin_scene("6205")), cage=None)
    found = {"given coefficient": given, "constant Eyring stress": constant, "sinh traction": physical}
    return {name: replace(scene, tolerance=TOLERANCE) for name, scene in found.items()}


def imports(repeats: int) -> list[Row]:
    """In fresh interpreters, after one that leaves compiled files behind."""
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
    found = friction_torque(point)
    return Row(
        what="1 thrust point",
        scene=name,
        seconds=timed(lambda: friction_torque(point), repeats),
        limit=1e-3,
        rungs=rungs(found),
        effects=computed(found),
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
    found = totals(long)
    rows = [Row(what=what, scene=name, seconds=timed(lambda: totals(long), repeats), rungs=found[1], effects=found[2])]
    halves = list(pool.map(totals, parts))  # not timed: processes start and import
    seconds = timed(lambda: list(pool.map(totals, parts)), repeats)
    both = [" and ".join(dict.fromkeys(half[part] for half in halves)) for part in (1, 2)]
    return [
        *rows,
        Row(
            what=what, scene=name, processes=PROCESSES, seconds=seconds, limit=limit, rungs=both[0], effects=both[1]
        ),
    ]  # fmt: skip


def affordable(call: Callable[[int], object], points: int, longest: float) -> int:
    """At most so many points that one call takes so long: tried by ten times as many each time, as few tell little."""
    few = FEW
    while few < points:
        [seconds] = timed(lambda few=few: call(few), 1)
        if seconds > longest / GROWTH:
            return max(PROCESSES, int(few * longest / seconds))
        few *= GROWTH
    return points


def totals(scene: Scene) -> tuple[Array, str, str]:
    """What a process hands back: torques, N m, rungs and effects."""
    found = friction_torque(scene)
    return found.torque.total, rungs(found), computed(found)


def hertz(contacts: int, repeats: int) -> Row:
    curvatures = np.geomspace(37.0, 3.7e7, contacts)
    return Row(
        what=f"{contacts} Hertz contacts",
        scene="curvature ratios 1 to 1e6",
        seconds=timed(
            lambda: hertz_contact(curvature_x=curvatures, curvature_y=37.0, load=620.0, modulus=1.13e11), repeats
        ),
        limit=0.5 * contacts / 1e6,
        rungs="exact",
    )


def ring(points: int, longest: float, repeats: int) -> list[Row]:
    """Thrust and radial load of like size, at speed: the equilibrium, and the torque of its unequal balls."""
    axial, radial = np.random.default_rng(SEED).uniform(100, 2000, (2, points))
    speed = np.random.default_rng(SEED + 1).uniform(10, 300, points)
    sinh = scenes()["sinh traction"]

    def some(few: int) -> Scene:
        operation = Operation(axial_load=axial[:few], inner_speed=speed[:few], radial_load=radial[:few])
        return replace(sinh, operation=operation)

    few = affordable(lambda few: friction_torque(some(few)), points, longest)
    scene, plural = some(few), "" if few == 1 else "s"
    found = friction_torque(scene)
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
            rungs="equilibrium of the ring",
        ),
        Row(
            what=f"torque on it, {few} point{plural}",
            scene="sinh traction",
            seconds=timed(lambda: friction_torque(scene), repeats),
            rungs=rungs(found),
            effects=computed(found),
        ),
    ]


def timed(call: Callable[[], object], repeats: int) -> list[float]:
    """Seconds a call, warm; short ones many at a time."""
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


def rungs(found: FrictionTorque) -> str:
    return "; ".join(found.provenance[name] for name in ("loads", "contacts", "sliding"))


def computed(found: FrictionTorque) -> str:
    return ", ".join(
        effect.name.replace("_", " ") for effect in found.effects if effect.name in COMPUTED and effect.decision == "on"
    )


def show(rows: list[Row], out: Console) -> None:
    table = Table("what", "scene", "processes", "median", "least to greatest", "to reach", "rungs", "effects computed")
    for row in rows:
        unit, name = (1.0, "s") if row.median >= 0.1 else (1e3, "ms")
        table.add_row(
            *(row.what, row.scene, str(row.processes), f"{unit * row.median:.3g} {name}"),
            f"{unit * min(row.seconds):.3g} to {unit * max(row.seconds):.3g} {name}",
            "" if row.limit is None else f"{unit * row.limit:.3g} {name}",
            *(row.rungs, row.effects),
        )
    out.print(table)


def write(rows: list[Row], path: Path) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write(f"# {machine()}\n# {versions('fembearing', 'numpy', 'scipy')}; tolerance {TOLERANCE:g}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(
            (*("what", "scene", "processes", "median_s", "least_s", "greatest_s", "repeats", "to_reach_s"),
             *("rungs", "effects_computed"))
        )  # fmt: skip
        for row in rows:
            times = (f"{value:.4g}" for value in (row.median, min(row.seconds), max(row.seconds)))
            limit = "" if row.limit is None else f"{row.limit:.4g}"
            writer.writerow(
                (row.what, row.scene, row.processes, *times, len(row.seconds), limit, row.rungs, row.effects)
            )


if __name__ == "__main__":
    typer.run(main)
