"""Friction of balls by half spaces: python validation/creep/run.py [--seeds 60] [--production]

Without an option, random balls are turned on five grids. The interval that three grids state is compared with the value
two levels finer. With --production, the torque by sliding of six bearings is compared with that of free balls with
marched creep. Both continue where they have stopped: rows are kept in coverage.csv and production.csv beside this file.
"""

import csv
import time
from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich.console import Console

from analytic.scene import Scene
from analytic.scenefile.read import parse_scene
from fembearing.check.creep.production import produced
from fembearing.check.creep.scene_creep import reference_torque
from fembearing.creep.ball import turn_ball
from fembearing.creep.reference import GRIDS, estimate
from validation.creep.random_balls import random_ball

HERE = Path(__file__).parent
RACE_QUANTITIES = "spin_moment", "rolling_moment", "transverse_force", "slip_share"
QUANTITIES = ("torque", *(f"{race}_{name}" for name in RACE_QUANTITIES for race in ("inner", "outer")))
SPEED = 52.36  # rad/s
FRICTIONS, LOADS = (0.12, 0.06, 0.03, 0.01), (30.0, 400.0, 5000.0)  # N
BEARINGS = {
    "7205C": 'catalog = "7205C"',
    "7208B": 'catalog = "7208B"',
    "6205": 'catalog = "6205"',
    "6310": 'catalog = "6310"',
    "hybrid 6205": 'catalog = "6205"\nball_material = "silicon_nitride"',
    "thrust": """kind = "thrust"
ball_count = 12
ball_diameter = "7.938 mm"
pitch_diameter = "36 mm"
inner = { groove_radius = "4.25 mm", shoulder_height = "1.5 mm" }
outer = { groove_radius = "4.25 mm", shoulder_height = "1.5 mm" }""",
}
out = Console(highlight=False, soft_wrap=True, markup=False)


def main(
    seeds: Annotated[int, typer.Option(help="Random balls of the coverage.")] = 60,
    production: Annotated[bool, typer.Option(help="Compare with production instead.")] = False,
) -> None:
    """Continue one of both comparisons, and print it."""
    if production:
        _continue(
            HERE / "production.csv",
            ("bearing", "friction", "load", "production", "reference", "uncertainty"),
            {
                (name, str(mu), str(load)): _compared(name, mu, load)
                for name, mu, load in product(BEARINGS, FRICTIONS, LOADS)
            },
        )
        _print_production()
        return
    _continue(
        HERE / "coverage.csv",
        ("seed", "strips", "cells", *QUANTITIES, "seconds"),
        {(str(seed),): _levels(seed) for seed in range(seeds)},
    )
    _print_coverage(seeds)


def _continue(path: Path, head: tuple[str, ...], jobs: dict[tuple[str, ...], Iterator[tuple[object, ...]]]) -> None:
    """Add the rows of those jobs that the table does not have; its first columns are their names."""
    rows = _rows(path)
    if not rows and not path.exists():
        path.write_text(",".join(head) + "\n", encoding="utf-8")
    for name, job in jobs.items():
        if any(tuple(row[key] for key in head[: len(name)]) == name for row in rows):
            continue
        found = list(job)
        with path.open("a", encoding="utf-8", newline="") as file:
            csv.writer(file, lineterminator="\n").writerows(found)


def _rows(path: Path) -> list[dict[str, str]]:
    if not path.exists():
        return []
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def _levels(seed: int) -> Iterator[tuple[object, ...]]:
    """A random ball on all grids."""
    ball, turned = random_ball(seed), None
    for grid in GRIDS:
        begun = time.process_time()
        turned = turn_ball(ball, grid, turned)
        seconds = time.process_time() - begun
        of_races = [getattr(race, name) for name in RACE_QUANTITIES[:3] for race in turned.races]
        shares = [race.friction.slip_share for race in turned.races]
        yield (seed, *grid, turned.torque, *of_races, *shares, round(seconds, 3))


def _print_coverage(seeds: int) -> None:
    balls: dict[str, list[dict[str, str]]] = {}
    for row in _rows(HERE / "coverage.csv"):
        if int(row["seed"]) < seeds:
            balls.setdefault(row["seed"], []).append(row)
    out.print("| grids | quantity | inside | median uncertainty | median error |\n| --- | --- | --- | --- | --- |")
    for first, name in product((0, 1), QUANTITIES):
        grids = GRIDS[first : first + 3]
        inside, stated, errors = 0, [], []
        for rows in balls.values():
            values = [float(row[name]) for row in rows]
            found = estimate(tuple(values[first : first + 3]), tuple(1 / grid.strips for grid in grids))
            error = abs(found.value - values[-1])
            inside += error <= found.uncertainty
            stated.append(found.uncertainty / abs(values[-1]))
            errors.append(error / abs(values[-1]))
        span = f"{grids[0].strips} to {grids[-1].strips} strips"
        out.print(f"| {span} | {name} | {inside} of {len(balls)} | {np.median(stated):.2%} | {np.median(errors):.3%} |")


def scene_of(bearing: str, friction: float, load: float) -> Scene:
    """A bearing under thrust, N, in which nothing but sliding costs torque."""
    return parse_scene(
        f'name = "{bearing}"\ntolerance = "1 %"\n[bearing]\n{BEARINGS[bearing]}\n[operation]\naxial_load = "{load} N"\n'
        f'inner_speed = "{SPEED} rad/s"\n[friction]\ncoefficient = {friction}\n',
        origin=bearing,
    )


def _compared(name: str, friction: float, load: float) -> Iterator[tuple[object, ...]]:
    """Torque by sliding of all balls, by production and by the reference, N m."""
    production = produced(scene_of(name, friction, load))
    reference, uncertainty, _ = reference_torque(production, tolerance=0.01)
    yield (name, friction, load, production.torque, reference, uncertainty)


def _print_production() -> None:
    out.print("| bearing | friction | thrust, N | production, N mm | reference, N mm | difference |")
    out.print("| --- | --- | --- | --- | --- | --- |")
    worst = 0.0
    for row in _rows(HERE / "production.csv"):
        torque, reference, uncertainty = (float(row[key]) for key in ("production", "reference", "uncertainty"))
        change = torque / reference - 1
        worst = max(worst, abs(change))
        numbers = f"{torque * 1e3:.5g} | {reference * 1e3:.5g} +- {uncertainty / reference:.2%} | {change:+.2%}"
        out.print(f"| {row['bearing']} | {row['friction']} | {row['load']} | {numbers} |")
    out.print(f"largest difference {worst:.2%}")


if __name__ == "__main__":
    typer.run(main)
