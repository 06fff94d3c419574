"""The friction ladder: python validation/benchmarks/friction.py [--errors | --nodes] [--scenes 500] [--seed 40000]

Prints the race torque of a 6205 under 1000 N thrust at a given contact angle of 0.18 rad, without hysteresis, by the
three methods of `analytic.sliding.ball`, with the errors of the cheaper ones and the processor time of each, and the
time that the load sharing between film and asperities takes. With --errors: the errors of the two cheaper methods in
random scenes of oil and finish, two contacts each, with the estimate of `analytic.sliding.methods` that `auto` uses.
With --nodes [--balls 10000]: error and estimate of every method and its nodes on random balls (`random_contacts`), with
the worst ratio and its ball; status 1 where an error is above its estimate. The reference is the power by 96 by 96
nodes at the sliding found by the last method. Model is compared with model; nothing is measured. Times are those of the
machine.
"""

import sys
import time
from collections import defaultdict
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, Literal

import numpy as np
import typer
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic import friction_torque, load_scene
from analytic.effects.table import COMPUTED
from analytic.loads.balls import LoadEffects, thrust_balls
from analytic.oil.lubricated_races import LubricatedRaces, lubricate_races
from analytic.oil.variation import Variation
from analytic.scene import (
    Array,
    Autocorrelation,
    ContactAngle,
    Lubricant,
    Operation,
    Scene,
    SlidingMethod,
    SpinRule,
    Surface,
)
from analytic.sliding.ball import SlipFriction, SlipRule, slip_friction
from analytic.sliding.ellipse import slip_over_ellipse
from analytic.sliding.long_ellipse import MicroslipTorque
from analytic.sliding.methods import QUADRATURES, Sliders, SlidingModel
from random_contacts import sliding_balls
from random_scenes import of_oil_and_finish, thrust_scene

METHODS: tuple[SlidingMethod, ...] = ("single_coefficient", "along_axis", "over_ellipse")
Law = Literal["eyring_constant", "eyring_sinh"]
LAWS: tuple[Law, ...] = ("eyring_constant", "eyring_sinh")
BOUNDS = (0.0, 0.01, 0.03, 0.1, 0.25, 0.5, 1.0, np.inf)  # by which scenes are grouped
MANY = (96, 96)  # nodes whose error counts as none
ROUND_OFF = 1e-9  # relative
AT_ONCE = 20  # random balls of one bearing
STRICT = 1e-6  # tolerance that needs the most nodes
ANGLE, LOAD, HARDNESS = 0.18, 1000.0, 7.8e9  # rad, N, Pa
LENGTH = 150e-6  # m, of the gaussian autocorrelation
OIL = Lubricant(
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
        time_sharing(out)


def ladder(out: Console) -> None:
    table = Table("traction", "Sq, um", "rpm", "N mm", "of the last, missed by", "ms", title=", ".join(METHODS))
    for traction in LAWS:
        for roughness in (0.1e-6, 1e-6):
            for rpm in (100.0, 500.0):
                torques, seconds = zip(
                    *(race_torque(method, traction, roughness, rpm) for method in METHODS), strict=True
                )
                missed = " ".join(f"{torque / torques[-1] - 1:+.1%}" for torque in torques[:-1])
                table.add_row(
                    *(traction, f"{roughness * 1e6:g}", f"{rpm:g}"),
                    *(" ".join(f"{torque:.2f}" for torque in torques), missed),
                    " ".join(f"{1e3 * second:.1f}" for second in seconds),
                )
    out.print(table)


def oiled_races(roughness: float, speed: Array, traction: Law = "eyring_constant") -> LubricatedRaces:
    bearing = load_scene("6205-dry").bearing
    balls = thrust_balls(
        bearing,
        ContactAngle(rule="given", value=ANGLE),
        Operation(axial_load=np.full_like(speed, LOAD), inner_speed=speed),
        LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False),
    )
    correlation = Autocorrelation(kind="gaussian", length=LENGTH, spacing=LENGTH / 20)
    return lubricate_races(
        bearing,
        balls,
        lubricant=replace(OIL, traction=traction),
        surface=Surface(rms_roughness=roughness, autocorrelation=correlation, hardness=HARDNESS),
        ring_speed=speed,
        variation=Variation(),
    )


def race_torque(method: SlidingMethod, traction: Law, roughness: float, rpm: float) -> tuple[float, float]:
    """N mm, and processor seconds without the sharing."""
    speed = np.array([rpm * np.pi / 30])
    races = oiled_races(roughness, speed, traction)
    balls, shared = races.balls, races.mixed(asperities=True, film_factor=1.0)

    def slip() -> MicroslipTorque:
        return slip_friction(
            balls.races,
            (races.traction(shared.race(0)), races.traction(shared.race(1))),
            ring_speed=speed[:, None],
            spin_difference=np.sin(ANGLE),
            spin_rule="balanced",
            rule=SlipRule(method),
        ).torque

    slip()
    started = time.process_time()
    torque = slip()
    seconds = time.process_time() - started
    return 1e3 * balls.alike * float((torque.spin + torque.conformity)[0, 0]), seconds


def time_sharing(out: Console) -> None:
    for points, repeats in ((1, 200), (100_000, 1)):
        races = oiled_races(1e-6, np.geomspace(1.0, 1000.0, points))
        races.mixed(asperities=True, film_factor=1.0)
        started = time.process_time()
        for _ in range(repeats):
            races.mixed(asperities=True, film_factor=1.0)
        out.print(f"load shared in {2 * points} contacts: {1e3 * (time.process_time() - started) / repeats:.3g} ms")


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
    table = Table(title=f"{scenes} scenes of two contacts, seeds {first} to {first + scenes - 1}")
    heads = (
        "traction",
        "method",
        "bound",
        "scenes",
        "error: from",
        "to",
        "median",
        "bound holds",
        "of it used at most",
        "at seed",
    )
    for head in heads:
        table.add_column(head)
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
    effects: dict[str, Literal["auto", "on", "off"]] = dict.fromkeys(COMPUTED, "off")
    effects |= dict.fromkeys(("spin", "conformity", "asperities"), "on")
    return replace(thrust_scene(rng, **of_oil_and_finish(rng)), effects=effects, tolerance=STRICT)


def trials_of(seed: int) -> list[Trial]:
    scene = sliding_scene(seed)
    found = {method: friction_torque(replace(scene, sliding=method)) for method in METHODS}
    true = found["over_ellipse"].torque.total[0]
    assert scene.lubricant is not None
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
    traction: str
    error: Array  # relative to the power of the method
    stated: Array  # its estimate, relative to the same

    @property
    def used(self) -> Array:
        """Error over estimate; errors that are round-off count as none."""
        return np.where(self.error > ROUND_OFF, self.error / self.stated, 0.0)


def estimates(balls: int, first: int, out: Console) -> bool:
    """Do the estimates of `analytic.sliding.methods` hold on so many random balls between two contacts each?"""
    judged: dict[tuple[str, SlipRule], list[Judged]] = defaultdict(list)
    seeds = range(first, first + -(-balls // AT_ONCE))
    for seed in track(seeds, console=Console(stderr=True)):
        for quadrature, each in judged_methods(seed):
            judged[each.traction, quadrature].append(each)
    heads = (
        "traction",
        "method",
        "nodes",
        "balls",
        "error: median",
        "most",
        "estimate/error, median",
        "error/estimate",
    )
    table = Table(*heads, "of seed, ball", title=f"{len(seeds) * AT_ONCE} balls, seeds {seeds[0]} to {seeds[-1]}")
    for (traction, quadrature), some in judged.items():
        error, stated = (np.concatenate([getattr(each, name) for each in some]) for name in ("error", "stated"))
        worst = max(some, key=lambda each: each.used.max())
        matters = error > ROUND_OFF
        wide = np.median(stated[matters] / error[matters]) if matters.any() else np.nan
        table.add_row(
            *(traction, quadrature.method, "{} by {}".format(*quadrature.nodes), str(error.size)),
            *(f"{np.median(error):.1e}", f"{error.max():.1e}", f"{wide:.2f}", f"{worst.used.max():.2f}"),
            f"{worst.seed}, {worst.used.argmax()}",
        )
    out.print(table)
    return all(each.used.max() <= 1 for some in judged.values() for each in some)


def power_of(sliders: Sliders, result: SlipFriction) -> np.ndarray:
    """(n,) slip power over the ring speed by MANY nodes, N m, at the spin of a result."""
    rates = result.torque.inner_spin_rate, result.torque.outer_spin_rate
    power = np.zeros(sliders.ring_speed.size)
    for contact, traction, rate in zip(sliders.balls.races, sliders.traction, rates, strict=True):
        law = traction.point_law
        law = law._replace(fluidity=np.asarray(law.fluidity) * np.abs(sliders.ring_speed[:, None]))
        power += slip_over_ellipse(contact, law=law, spin_rate=rate, nodes=MANY).slip_power.sum(axis=1)
    return power


def judged_methods(seed: int) -> Iterator[tuple[SlipRule, Judged]]:
    rng = np.random.default_rng(seed)
    balls, traction, speed, name = sliding_balls(rng, AT_ONCE)
    rules: tuple[SpinRule, ...] = ("balanced", "balanced", "inner_control", "outer_control")
    rule = rules[rng.integers(len(rules))]
    model = SlidingModel(spins=True, conforms=True, spin_rule=rule, microslip="derived", method="auto")
    sliders = Sliders(balls=balls, traction=traction, model=model, ring_speed=speed)
    results = {quadrature: sliders.slide(quadrature) for quadrature in QUADRATURES}
    true = power_of(sliders, results[QUADRATURES[-1]])
    for quadrature, result in results.items():
        own = np.sum(result.torque.spin + result.torque.conformity, axis=1)
        stated = sliders.errors_at(result)(quadrature)
        yield quadrature, Judged(seed=seed, traction=name, error=np.abs(true / own - 1), stated=stated)


if __name__ == "__main__":
    typer.run(main)
