"""The friction ladder: python validation/benchmarks/friction.py [--errors | --nodes] [--scenes 500] [--seed 40000]

Prints the race torque of a 6205 under 1000 N thrust at a given contact angle of 0.18 rad, without hysteresis, by the
three methods of `analytic.sliding.ball`, with the errors of the cheaper ones and the processor time of each, and the
time that the load sharing between film and asperities takes. With --errors: the errors of the two cheaper methods in
random scenes of oil and finish, two contacts each, with the bound of `analytic.sliding.methods` that `auto` uses.
The constants there are right as far as that bound holds. With --nodes: the errors by the nodes of the dearer methods in
such scenes, with their bound. Model is compared with model; nothing is measured. Times are those of the machine.
"""

import time
from collections import defaultdict
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, Any, Literal
from unittest.mock import patch

import numpy as np
import typer
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic import friction_torque, load_scene
from analytic.contact.hertz import contact_modulus
from analytic.contact.rolling_contact import RollingContact
from analytic.effects.table import COMPUTED
from analytic.loads.balls import LoadedBalls, LoadEffects, thrust_balls
from analytic.oil.film import film_asymptotes
from analytic.oil.mixed import mixed_contact
from analytic.oil.traction import mixed_traction
from analytic.scene import Autocorrelation, ContactAngle, Lubricant, Operation, Scene, Surface
from analytic.scenefile.read import builtin_scene
from analytic.sliding.ball import SlidingMethod, slip_friction
from analytic.sliding.long_ellipse import MicroslipTorque
from analytic.sliding.methods import QUADRATURES, Quadrature
from analytic.surface.gap import gap_law
from analytic.surface.roughness import gap_roughness
from random_scenes import of_oil_and_finish, thrust_scene

METHODS: tuple[SlidingMethod, ...] = ("single_coefficient", "along_axis", "over_ellipse")
Law = Literal["eyring_constant", "eyring_sinh"]
LAWS: tuple[Law, ...] = ("eyring_constant", "eyring_sinh")
BOUNDS = (0.0, 0.01, 0.03, 0.1, 0.25, 0.5, 1.0, np.inf)  # by which scenes are grouped
MANY = (48, 48)  # nodes whose error counts as none
STRICT = 1e-6  # tolerance that needs the most nodes
ANGLE, LOAD, HARDNESS = 0.18, 1000.0, 7.8e9  # rad, N, Pa
BOUNDARY_FRICTION = 0.12
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
    nodes: Annotated[bool, typer.Option("--nodes", help="Errors by the nodes in random scenes.")] = False,
    scenes: Annotated[int, typer.Option(help="Number of random scenes.")] = 500,
    seed: Annotated[int, typer.Option(help="The first; each scene has one of its own.")] = 40000,
) -> None:
    out = Console(width=140)
    if errors:
        bounds(scenes, seed, out)
    elif nodes:
        quadratures(range(seed, seed + scenes), out)
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


def contacts(roughness: float, speed: np.ndarray) -> tuple[LoadedBalls, dict[str, Any]]:
    """The loaded balls, and the arguments of mixed_contact with them, (2, n)."""
    bearing = load_scene(builtin_scene("6205")).bearing
    still = LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False)
    operation = Operation(axial_load=np.array([LOAD]), inner_speed=np.zeros(1))
    balls = thrust_balls(bearing, ContactAngle(rule="given", value=ANGLE), operation, still)
    correlation = Autocorrelation(kind="gaussian", length=LENGTH, spacing=LENGTH / 20)
    surface = Surface(rms_roughness=roughness, autocorrelation=correlation, hardness=HARDNESS)
    modulus = float(contact_modulus(bearing.ball_material, bearing.inner.material))
    both = RollingContact(**{name: value[..., 0] for name, value in vars(balls.contacts).items()})  # (2, 1)
    return balls, {
        "contact": both,
        "film": film_asymptotes(
            both,
            entrainment_speed=speed * balls.motion.entrainment_speed[0, 0],
            viscosity=OIL.viscosity,
            pressure_viscosity=OIL.pressure_viscosity,
        ),
        "gap": gap_law(
            surface,
            gap_roughness(surface),
            modulus=modulus,
            bodies=(bearing.ball_material, bearing.inner.material),
        ),
    }


def race_torque(method: SlidingMethod, traction: Law, roughness: float, rpm: float) -> tuple[float, float]:
    """N mm, and processor seconds without the sharing."""
    speed = np.array([rpm * np.pi / 30])
    balls, film = contacts(roughness, speed)
    shared = mixed_contact(**film)
    inner_law, outer_law = (
        mixed_traction(replace(OIL, traction=traction), BOUNDARY_FRICTION, shared.race(race)) for race in (0, 1)
    )
    contact = film["contact"]
    inner, outer = (RollingContact(**{name: value[race] for name, value in vars(contact).items()}) for race in (0, 1))

    def slip() -> MicroslipTorque:
        return slip_friction(
            (inner, outer),
            (inner_law, outer_law),
            ring_speed=speed,
            spin_difference=np.sin(ANGLE),
            spin_rule="balanced",
            method=method,
        ).torque

    slip()
    started = time.process_time()
    torque = slip()
    seconds = time.process_time() - started
    return 1e3 * balls.alike * float((torque.spin + torque.conformity)[0]), seconds


def time_sharing(out: Console) -> None:
    for points, repeats in ((1, 200), (100_000, 1)):
        _, film = contacts(1e-6, np.geomspace(1.0, 1000.0, points))
        mixed_contact(**film)
        started = time.process_time()
        for _ in range(repeats):
            mixed_contact(**film)
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


def quadratures(seeds: range, out: Console) -> None:
    """Errors of the dearer quadratures of `analytic.sliding.methods` against many nodes with the same method."""
    errors: dict[tuple[str, Quadrature], list[float]] = defaultdict(list)
    for seed in track(seeds, console=Console(stderr=True)):
        scene = sliding_scene(seed)
        assert scene.lubricant is not None
        for quadrature in QUADRATURES[1:]:
            found, true = (torque_by(replace(quadrature, nodes=nodes), scene) for nodes in (quadrature.nodes, MANY))
            errors[scene.lubricant.traction, quadrature].append(abs(found / true - 1))
    table = Table("traction", "method", "nodes", "scenes", "median", "98 of 100", "most", "bound")
    for (traction, quadrature), some in errors.items():
        bound = quadrature.smooth if traction == "eyring_constant" else quadrature.kinked
        table.add_row(
            *(traction, quadrature.method, "{} by {}".format(*quadrature.nodes), str(len(some))),
            *(f"{value:.1e}" for value in (*np.quantile(some, [0.5, 0.98, 1.0]), bound)),
        )
    out.print(table)


def torque_by(quadrature: Quadrature, scene: Scene) -> float:
    with patch("analytic.sliding.methods.QUADRATURES", (QUADRATURES[0], quadrature)):
        return float(friction_torque(replace(scene, sliding=quadrature.method)).torque.total[0])


if __name__ == "__main__":
    typer.run(main)
