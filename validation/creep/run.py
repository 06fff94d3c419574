"""Friction of balls by half spaces: python validation/creep/run.py [--seeds 60] [--production]

Without an option, random balls are turned on five grids. The interval that three grids state is compared with the value
two levels finer. With --production, the torque by sliding of six bearings is compared with that of free balls with
marched creep. Both continue where they have stopped: rows are kept in coverage.csv and production.csv beside this file.
"""

import time
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

from analytic.oil.traction import PointLaw
from analytic.scene import Bearing, Groove, Material, Scene
from analytic.scenefile.read import parse_scene
from fembearing.check.creep.production import produced
from fembearing.check.creep.scene_creep import reference_torque
from fembearing.creep.ball import TurningBall, turn_ball
from fembearing.creep.place import HeldBall, unit_under
from fembearing.creep.reference import GRIDS, estimate
from validation.benchmarks.random_scenes import BASE
from validation.study import Row, continued, markdown, numbers, out, run

HERE = Path(__file__).parent
CERAMIC, GIVEN, OILED, FAST = 0.25, 0.2, 0.2, 0.3  # shares of the balls
NITRIDE = Material(name="silicon nitride", youngs_modulus=310e9, poisson_ratio=0.26, density=3200.0, source="typical")
RACE_QUANTITIES = "spin_moment", "rolling_moment", "transverse_force", "slip_share"
QUANTITIES = ("torque", *(f"{race}_{name}" for name in RACE_QUANTITIES for race in ("inner", "outer")))
COMPARED = ("bearing", "friction", "load", "production", "reference", "uncertainty")
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


def main(
    seeds: Annotated[int, typer.Option(help="Random balls of the coverage.")] = 60,
    production: Annotated[bool, typer.Option(help="Compare with production instead.")] = False,
) -> None:
    """Continue one of both comparisons, and print it."""
    if production:
        cases = {tuple(map(str, case)): case for case in product(BEARINGS, FRICTIONS, LOADS)}
        print_production(continued(HERE / "production.csv", COMPARED, cases, compared, form=""))
        return
    columns = ("seed", "strips", "cells", *QUANTITIES, "seconds")
    tasks = {(str(seed),): seed for seed in range(seeds)}
    rows = continued(HERE / "coverage.csv", columns, tasks, on_all_grids, form="")
    print_coverage([[row for row in rows if row["seed"] == str(seed)] for seed in range(seeds)])


def on_all_grids(seed: int) -> Iterator[Mapping[str, object]]:
    """A random ball on all grids."""
    ball, turned = random_ball(seed), None
    for grid in GRIDS:
        begun = time.process_time()
        turned = turn_ball(ball, grid, turned)
        seconds = time.process_time() - begun
        of_races = [getattr(race, name) for name in RACE_QUANTITIES[:3] for race in turned.races]
        shares = [race.friction.slip_share for race in turned.races]
        values = dict(zip(QUANTITIES, (turned.torque, *of_races, *shares), strict=True))
        yield {"seed": seed, "strips": grid[0], "cells": grid[1], **values, "seconds": round(seconds, 3)}


def print_coverage(balls: list[list[Row]]) -> None:
    rows = []
    for first, name in product((0, 1), QUANTITIES):
        grids = GRIDS[first : first + 3]
        values = np.array([numbers(ball, name) for ball in balls])
        sizes = tuple(1 / grid.strips for grid in grids)
        found = [estimate(tuple(each), sizes) for each in values[:, first : first + 3].tolist()]
        error = np.abs([each.value for each in found] - values[:, -1])
        stated, true = np.array([each.uncertainty for each in found]), np.abs(values[:, -1])
        shares = f"{np.median(stated / true):.2%}", f"{np.median(error / true):.3%}"
        span = f"{grids[0].strips} to {grids[-1].strips} strips"
        rows.append((span, name, f"{np.sum(error <= stated)} of {len(balls)}", *shares))
    for line in markdown(("grids", "quantity", "inside", "median uncertainty", "median error"), rows):
        out.print(line, soft_wrap=True)


def scene_of(bearing: str, friction: float, load: float) -> Scene:
    """A bearing under thrust, N, in which nothing but sliding costs torque."""
    return parse_scene(
        f'name = "{bearing}"\ntolerance = "1 %"\n[bearing]\n{BEARINGS[bearing]}\n[operation]\naxial_load = "{load} N"\n'
        f'inner_speed = "{SPEED} rad/s"\n[friction]\ncoefficient = {friction}\n',
        origin=bearing,
    )


def compared(case: tuple[str, float, float]) -> Iterator[Mapping[str, object]]:
    """Torque by sliding of all balls, by production and by the reference, N m."""
    production = produced(scene_of(*case))
    reference, uncertainty, _ = reference_torque(production, tolerance=0.01)
    yield dict(zip(COMPARED, (*case, production.torque, reference, uncertainty), strict=True))


def print_production(rows: list[Row]) -> None:
    torque, reference, uncertainty = (numbers(rows, name) for name in ("production", "reference", "uncertainty"))
    shown = [
        (*(row[name] for name in COMPARED[:3]), f"{1e3 * ours:.5g}", f"{1e3 * true:.5g} +- {off / true:.2%}",
         f"{ours / true - 1:+.2%}")
        for row, ours, true, off in zip(rows, torque, reference, uncertainty, strict=True)
    ]  # fmt: skip
    for line in markdown(("bearing", "friction", "thrust, N", "production, N mm", "reference, N mm", "change"), shown):
        out.print(line, soft_wrap=True)
    out.print(f"largest difference {np.abs(torque / reference - 1).max():.2%}")


def random_ball(seed: int) -> TurningBall:
    """One ball; seed : of its numbers."""
    rng = np.random.default_rng(seed)
    bearing = _bearing(rng)
    angle, peak = rng.uniform(0.1, 0.8), 10 ** rng.uniform(8.7, 9.45)  # rad, Pa
    unit = unit_under(bearing, "inner", angle)
    load = (peak * np.pi * unit.semi_axis_rolling * unit.semi_axis_transverse / 1.5) ** 3
    radial = bearing.groove_centre_distance * np.cos(angle)
    thrust, centre = float(load * np.sin(angle)), bearing.outer.bottom_radius - bearing.outer.groove_radius
    if rng.random() < GIVEN:
        held = HeldBall(bearing=bearing, centre=centre, thrust=thrust, angle=angle)
    else:
        held = HeldBall(bearing=bearing, centre=centre, thrust=thrust, radial=float(radial))
    law = _law(rng)
    speed = 10 ** rng.uniform(0, 2) if rng.random() > FAST else 10 ** rng.uniform(2, 3)
    return TurningBall(held=held, laws=(law, law), speed=float(speed))


def _bearing(rng: np.random.Generator) -> Bearing:
    scale, like = 10 ** rng.uniform(-0.3, 0.6), BASE.bearing
    diameter = scale * like.ball_diameter
    ceramic = rng.random() < CERAMIC

    def groove(one: Groove) -> Groove:
        radius = float(rng.uniform(0.507, 0.55) * diameter)
        return replace(
            one,
            bottom_radius=scale * one.bottom_radius,
            groove_radius=radius,
            shoulder_half_width=None,
            far_shoulder_half_width=None,
        )

    material = NITRIDE if ceramic else like.ball_material
    mass = material.density * np.pi / 6 * diameter**3
    return replace(
        like,
        ball_diameter=diameter,
        ball_mass=float(mass),
        ball_material=material,
        inner=groove(like.inner),
        outer=groove(like.outer),
    )


def _law(rng: np.random.Generator) -> PointLaw:
    friction = float(10 ** rng.uniform(-2, -0.82))  # 0.01 to 0.15
    if rng.random() >= OILED:
        return PointLaw(boundary=friction)
    return PointLaw(
        boundary=0.3 * friction,
        limit=0.7 * friction,
        eyring=5e6,
        fluidity=float(10 ** rng.uniform(-3.5, -1.5)),  # s/m: 0.06 Pa s over 5 MPa and 40 nm is 0.3 s/m
        share=0.9,
        alpha=9.2 * 0.61 * 5.1e-9,
        exponent=0.61,
    )


if __name__ == "__main__":
    run(main)
