"""The friction ladder: python validation/benchmarks/friction.py [--errors | --nodes] [--scenes 500] [--seed 40000]

Prints the race torque of a 6205 under 1000 N thrust at a given contact angle of 0.18 rad, without hysteresis, by the
three methods of `analytic.sliding.ball`, with the errors of the cheaper ones and the processor time of the torque. With
--errors: the errors of the two cheaper methods in random scenes of oil and finish, two contacts each, with the
numerical uncertainty that the result states, by which `auto` chooses. With --nodes [--balls 10000]: error and estimate
(`analytic.sliding.judge`) of every method on random balls (`random_scenes`), with the worst ratio and its ball;
status 1 where an error is above its estimate. The reference is the last method with 96 by 96 nodes. Model is compared
with model; nothing is measured. Times are those of the machine.
"""

import sys
import time
from collections import defaultdict
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, Literal

import numpy as np
import typer
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic import friction_torque, load_scene
from analytic.oil.variation import Variation
from analytic.scene import Array, Autocorrelation, ContactAngle, Lubricant, Operation, Scene, SlidingMethod, Surface
from analytic.sliding import judge
from analytic.sliding.ellipse import quadrature_of
from analytic.solve.model import model_of
from analytic.solve.records import SETTLED
from analytic.solve.solution import points_of, solved
from validation.benchmarks.random_scenes import of_oil_and_finish, sliding_alone, sliding_balls, thrust_scene

METHODS: tuple[SlidingMethod, ...] = ("single_coefficient", "along_axis", "over_ellipse")
LAWS: tuple[Literal["eyring_constant", "eyring_sinh"], ...] = ("eyring_constant", "eyring_sinh")
BOUNDS = (0.0, 0.01, 0.03, 0.1, 0.25, 0.5, 1.0, np.inf)  # by which scenes are grouped
MANY = (96, 96)  # nodes whose error counts as none
ROUND_OFF = 1e-9  # relative
AT_ONCE = 20  # random balls of one bearing
STRICT = 1e-6  # tolerance that needs the most nodes
LENGTH = 150e-6  # m, of the gaussian autocorrelation
LADDER = Scene(
    name="friction ladder",
    tolerance=STRICT,
    bearing=load_scene("6205-dry").bearing,
    contact_angle=ContactAngle(rule="given", value=0.18),
    operation=Operation(axial_load=np.array([1000.0]), inner_speed=np.array([10.0])),
    lubricant=Lubricant(
        viscosity=0.06,
        pressure_viscosity=2e-8,
        viscosity_temperature=0.03,
        reference_temperature=313.15,
        temperature=313.15,
        thermal_conductivity=0.14,
        density=870.0,
        eyring_stress=5e6,
        limiting_shear=0.06,
        traction="eyring_constant",
    ),
    surface=Surface(
        rms_roughness=1e-6,
        autocorrelation=Autocorrelation(kind="gaussian", length=LENGTH, spacing=LENGTH / 20),
        hardness=7.8e9,
    ),
    spin_rule="balanced",
    effects=sliding_alone(),
)


def main(
    errors: Annotated[bool, typer.Option("--errors", help="Errors of cheap methods in random scenes.")] = False,
    nodes: Annotated[
        bool, typer.Option("--nodes", help="Do the estimates of the errors hold on random balls?")
    ] = False,
    scenes: Annotated[int, typer.Option(help="Number of random scenes of --errors.")] = 500,
    balls: Annotated[int, typer.Option(help="Number of random balls of --nodes.")] = 10_000,
    seed: Annotated[int, typer.Option(help="The first; each scene has one of its own.")] = 40000,
) -> None:
    out = Console(width=140)
    if errors:
        bounds(scenes, seed, out)
    elif nodes:
        sys.exit(not estimates(balls, seed, out))
    else:
        ladder(out)


def ladder(out: Console) -> None:
    table = Table("traction", "Sq, um", "rpm", "N mm", "of the last, missed by", "ms", title=", ".join(METHODS))
    for traction in LAWS:
        for roughness in (0.1e-6, 1e-6):
            for rpm in (100.0, 500.0):
                scene = replace(
                    LADDER,
                    lubricant=replace(LADDER.lubricant, traction=traction),
                    surface=replace(LADDER.surface, rms_roughness=roughness),
                    operation=replace(LADDER.operation, inner_speed=np.array([rpm * np.pi / 30])),
                )
                each = [timed_torque(replace(scene, sliding=method)) for method in METHODS]
                table.add_row(
                    *(traction, f"{roughness * 1e6:g}", f"{rpm:g}", " ".join(f"{torque:.2f}" for torque, _ in each)),
                    " ".join(f"{torque / each[-1][0] - 1:+.1%}" for torque, _ in each[:-1]),
                    " ".join(f"{seconds * 1e3:.1f}" for _, seconds in each),
                )
    out.print(table)


def timed_torque(scene: Scene) -> tuple[float, float]:
    """N mm, and processor seconds of a second call."""
    friction_torque(scene)
    started = time.process_time()
    torque = friction_torque(scene).torque.total
    return 1e3 * float(torque[0]), time.process_time() - started


@dataclass(frozen=True)
class Trial:
    """One method in one scene."""

    seed: int
    traction: str
    method: SlidingMethod
    error: float  # torque by sliding of the most accurate method over that of this method, less 1
    bound: float  # on its magnitude


def bounds(scenes: int, first: int, out: Console) -> None:
    trials = [
        trial for seed in track(range(first, first + scenes), console=Console(stderr=True)) for trial in trials_of(seed)
    ]
    heads = ("traction", "method", "bound", "scenes", "error: from", "to", "median", "bound holds")
    title = f"{scenes} scenes of two contacts, seeds {first} to {first + scenes - 1}"
    table = Table(*heads, "of it used at most", "at seed", title=title)
    for traction in LAWS:
        for method in METHODS[:-1]:
            for low, high in pairwise(BOUNDS):
                some = [
                    trial for trial in trials
                    if (trial.traction, trial.method) == (traction, method) and low <= trial.bound < high
                ]  # fmt: skip
                if not some:
                    continue
                missed = np.array([trial.error for trial in some])
                used = np.abs(missed) / [trial.bound for trial in some]
                table.add_row(
                    *(traction, method.replace("_", " "), f"{100 * low:g} to {100 * high:g} %", str(len(some))),
                    *(f"{missed.min():+.1%}", f"{missed.max():+.1%}", f"{np.median(np.abs(missed)):.2%}"),
                    *(f"{np.sum(used <= 1)} of {len(some)}", f"{used.max():.2f}", str(some[int(used.argmax())].seed)),
                )
    out.print(table)


def sliding_scene(seed: int) -> Scene:
    """A random scene under thrust, in which nothing but sliding costs torque or leaves an uncertainty."""
    rng = np.random.default_rng(seed)
    return replace(thrust_scene(rng, **of_oil_and_finish(rng)), effects=sliding_alone(), tolerance=STRICT)


def trials_of(seed: int) -> list[Trial]:
    scene = sliding_scene(seed)
    found = {method: friction_torque(replace(scene, sliding=method)) for method in METHODS}
    true = found["over_ellipse"].torque.total[0]
    return [
        Trial(
            seed=seed,
            traction=scene.lubricant.traction,
            method=method,
            error=float(true / found[method].torque.total[0] - 1),
            bound=float(found[method].numerical_uncertainty[0]),
        )
        for method in METHODS[:-1]
    ]


@dataclass(frozen=True, kw_only=True)
class Judged:
    """One method on the balls of one bearing; arrays (n,)."""

    seed: int
    error: Array  # relative to the power of the method
    stated: Array  # its estimate, relative to the same

    @property
    def used(self) -> Array:
        """Error over estimate; errors that are round-off count as none."""
        return np.where(self.error > ROUND_OFF, self.error / self.stated, 0.0)


def estimates(balls: int, first: int, out: Console) -> bool:
    """Do the estimates of `analytic.sliding.judge` hold on so many random balls between two contacts each?"""
    judged: dict[tuple[str, int], list[Judged]] = defaultdict(list)
    seeds = range(first, first + -(-balls // AT_ONCE))
    for seed in track(seeds, console=Console(stderr=True)):
        for law, method, each in judged_methods(seed):
            judged[law, method].append(each)
    heads = ("traction", "method", "nodes", "balls", "error: median", "most", "estimate/error, median")
    title = f"{len(seeds) * AT_ONCE} balls, seeds {seeds[0]} to {seeds[-1]}"
    table = Table(*heads, "error/estimate", "of seed, ball", title=title)
    for (law, method), some in sorted(judged.items()):
        error, stated = (np.concatenate([getattr(each, name) for each in some]) for name in ("error", "stated"))
        worst = max(some, key=lambda each: each.used.max(initial=0.0))
        matters = error > ROUND_OFF
        wide = np.median(stated[matters] / error[matters]) if matters.any() else np.nan
        nodes = judge.NODES[judge.OWN_NODES[method]]
        used = "" if method == judge.SINGLE_COEFFICIENT else f"{nodes['across']} by {nodes['along']}"
        table.add_row(
            *(law, judge.METHODS[method], used, str(error.size), f"{np.median(error):.1e}", f"{error.max():.1e}"),
            *(f"{wide:.2f}", f"{worst.used.max():.2f}", f"{worst.seed}, {worst.used.argmax()}"),
        )
    out.print(table)
    return all(each.used.max(initial=0.0) <= 1 for some in judged.values() for each in some)


def judged_methods(seed: int) -> list[tuple[str, int, Judged]]:
    """Name of the law, method, and what it misses on the balls that have an equilibrium; of odd seeds by spin alone."""
    rng = np.random.default_rng(seed)
    scene, variation = sliding_balls(rng, AT_ONCE), Variation(film=10 ** rng.uniform(-1, 0))
    counted = {name: decision == "on" for name, decision in scene.effects.items()} | {"conformity": seed % 2 == 0}
    model = model_of(scene, counted, variation=variation)
    points, nodes = points_of(scene.operation, model.temperature), judge.NODES.copy()
    nodes[judge.OWN_NODES[judge.FINE]] = quadrature_of(MANY)
    exactly = model.with_numbers(method=judge.FINE, judges=False)
    exact = solved(replace(exactly, tables=model.tables._replace(nodes=nodes)), points).points
    is_settled = exact["status"] == SETTLED
    law = "coulomb" if scene.lubricant is None else scene.lubricant.traction
    law += "" if counted["conformity"] else ", spin alone"
    found = []
    for method in range(len(judge.METHODS)):
        own = solved(model.with_numbers(method=method), points).points[is_settled]
        error = np.abs(exact["total"][is_settled] / own["total"] - 1)
        found.append((law, method, Judged(seed=seed, error=error, stated=own["sliding_error"] / own["total"])))
    return found


if __name__ == "__main__":
    typer.run(main)
