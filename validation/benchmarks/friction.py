"""The friction ladder: python validation/benchmarks/friction.py [--errors | --nodes] [--scenes 500] [--seed 40000]

Prints the race torque of a 6205 under 1000 N thrust at a given contact angle of 0.18 rad, without hysteresis, by the
three rungs of `analytic.sliding.ball`, with what the cheaper ones miss and the processor time of each, and the time that
the load shared by film and asperities takes. With --errors, what the two cheaper rungs miss in random scenes of oil and
finish, two contacts each, beside the bound of `analytic.sliding.methods` by which `auto` chooses: the constants there hold as
far as that bound does. With --nodes, what the nodes of the dearer rungs leave in such scenes, beside the bound on it.
Model against model: nothing here is measured. Times are the machine's.
"""

import time
from collections import defaultdict
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Annotated, Literal
from unittest.mock import patch

import numpy as np
import typer
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic import friction_torque, load_scene, thrust_equilibrium
from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import contact_modulus
from analytic.effects.ledger import COMPUTED
from analytic.loads.kinematics import ball_kinematics
from analytic.oil.mixed import mixed_contact
from analytic.oil.traction import MixedTraction
from analytic.scene import Autocorrelation, ContactAngle, Lubricant, Scene
from analytic.scenefile.read import builtin_scene
from analytic.sliding.ball import RaceContact, Rung, slip_friction
from analytic.sliding.long_ellipse import deformed_radius
from analytic.sliding.methods import WAYS, Way
from analytic.surface.asperity_table import tabulated_asperities
from analytic.surface.moments import mccool_summits
from analytic.surface.roughness import spectral_moments
from random_scenes import of_oil_and_finish, thrust_scene

RUNGS: tuple[Rung, ...] = ("single_coefficient", "along_axis", "over_ellipse")
LAWS: tuple[Literal["eyring_constant", "eyring_sinh"], ...] = ("eyring_constant", "eyring_sinh")
BOUNDS = (0.0, 0.01, 0.03, 0.1, 0.25, 0.5, 1.0, np.inf)  # by which scenes are told apart
MANY = (48, 48)  # nodes that stand for no error
STRICT = 1e-6  # tolerance that asks for the most nodes
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
    errors: Annotated[bool, typer.Option("--errors", help="What cheap rungs miss in random scenes.")] = False,
    nodes: Annotated[bool, typer.Option("--nodes", help="What nodes leave in random scenes.")] = False,
    scenes: Annotated[int, typer.Option(help="Random ones.")] = 500,
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
    table = Table("traction", "Sq, um", "rpm", "N mm", "of the last, missed by", "ms", title=", ".join(RUNGS))
    for traction in LAWS:
        for roughness in (0.1e-6, 1e-6):
            for rpm in (100.0, 500.0):
                torques, seconds = zip(*(race_torque(rung, traction, roughness, rpm) for rung in RUNGS), strict=True)
                missed = " ".join(f"{torque / torques[-1] - 1:+.1%}" for torque in torques[:-1])
                table.add_row(
                    *(traction, f"{roughness * 1e6:g}", f"{rpm:g}"),
                    *(" ".join(f"{torque:.2f}" for torque in torques), missed),
                    " ".join(f"{1e3 * second:.1f}" for second in seconds),
                )
    out.print(table)


def contacts(roughness: float, speed: np.ndarray) -> tuple[list[dict], dict]:
    """Of both races: geometry and load as RaceContact takes them; and the arguments of mixed_contact, (2, n)."""
    bearing = load_scene(builtin_scene("6205")).bearing
    balls = thrust_equilibrium(bearing, ContactAngle(rule="given", value=ANGLE), axial_load=LOAD)
    motion, rates = (
        ball_kinematics(
            inner_speed=w,
            inner_angle=ANGLE,
            outer_angle=ANGLE,
            pitch_diameter=bearing.pitch_diameter,
            ball_diameter=bearing.ball_diameter,
        )
        for w in (speed, 1.0)
    )
    rolling = {"inner": rates.inner_rolling_rate, "outer": rates.outer_rolling_rate}
    races, curvatures = [], []
    for name, contact, groove in (("inner", balls.inner, bearing.inner), ("outer", balls.outer, bearing.outer)):
        curvatures.append(race_curvatures(bearing, name, contact_angle=ANGLE))  # pyright: ignore[reportArgumentType]
        races.append(
            {
                "load": float(balls.ball_load),
                "semi_axis_rolling": float(contact.semi_axis_x),
                "semi_axis_transverse": float(contact.semi_axis_y),
                "deformed_radius": float(
                    deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter)
                ),
                "rolling_rate": float(rolling[name]),
            }
        )
    correlation = Autocorrelation(kind="gaussian", length=LENGTH, spacing=LENGTH / 20)
    moments = spectral_moments(rms_roughness=roughness, autocorrelation=correlation)
    modulus = contact_modulus(bearing.ball_material, bearing.inner.material)
    along, across = np.array(curvatures, dtype=np.float64).T[..., None]
    areas = [np.pi * race["semi_axis_rolling"] * race["semi_axis_transverse"] for race in races]
    return races, {
        "curvature_x": along,
        "curvature_y": across,
        "load": float(balls.ball_load),
        "modulus": modulus,
        "contact_area": np.array(areas)[:, None],
        "entrainment_speed": motion.entrainment_speed,
        "viscosity": OIL.viscosity,
        "pressure_viscosity": OIL.pressure_viscosity,
        "asperities": tabulated_asperities(
            summits=mccool_summits(moments + moments), modulus=modulus, hardness=HARDNESS
        ),
    }


def race_torque(
    rung: Rung, traction: Literal["eyring_constant", "eyring_sinh"], roughness: float, rpm: float
) -> tuple[float, float]:
    """N mm, and processor seconds without the sharing."""
    speed = np.array([rpm * np.pi / 30])
    races, film = contacts(roughness, speed)
    shared = mixed_contact(**film)
    inner, outer = (
        RaceContact(
            traction=MixedTraction(
                lubricant=replace(OIL, traction=traction),
                boundary_friction=0.12,
                asperity_share=shared.asperity_share[k],
                area_fraction=shared.area_fraction[k],
                film_thickness=shared.film_thickness[k],
            ),
            **race,
        )
        for k, race in enumerate(races)
    )
    arguments = {"ring_speed": speed, "spin_difference": np.sin(ANGLE), "spin_rule": "balanced", "rung": rung}
    slip_friction(inner, outer, **arguments)
    started = time.process_time()
    found = slip_friction(inner, outer, **arguments).torque
    seconds = time.process_time() - started
    balls = load_scene(builtin_scene("6205")).bearing.ball_count
    return 1e3 * balls * float((found.spin + found.conformity)[0]), seconds


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
    """One rung in one scene."""

    seed: int
    traction: str
    rung: Rung
    missed: float  # of what the rung found: the last rung's torque by sliding over its own, less 1
    bound: float  # on its magnitude


def bounds(scenes: int, first: int, out: Console) -> None:
    trials = [
        trial for seed in track(range(first, first + scenes), console=Console(stderr=True)) for trial in rungs_of(seed)
    ]
    table = Table(title=f"{scenes} scenes of two contacts, seeds {first} to {first + scenes - 1}")
    heads = (
        "traction",
        "rung",
        "bound",
        "scenes",
        "missed: from",
        "to",
        "median",
        "bound holds",
        "of it used at most",
        "at seed",
    )
    for head in heads:
        table.add_column(head)
    for traction in LAWS:
        for rung in RUNGS[:-1]:
            for low, high in pairwise(BOUNDS):
                some = [
                    trial for trial in trials
                    if (trial.traction, trial.rung) == (traction, rung) and low <= trial.bound < high
                ]  # fmt: skip
                if not some:
                    continue
                missed = np.array([trial.missed for trial in some])
                used = np.abs(missed) / [trial.bound for trial in some]
                table.add_row(
                    *(traction, rung.replace("_", " "), f"{100 * low:g} to {100 * high:g} %", str(len(some))),
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


def rungs_of(seed: int) -> list[Trial]:
    scene = sliding_scene(seed)
    found = {rung: friction_torque(replace(scene, sliding=rung)) for rung in RUNGS}
    true = found["over_ellipse"].torque.total[0]
    assert scene.lubricant is not None
    return [
        Trial(
            seed=seed,
            traction=scene.lubricant.traction,
            rung=rung,
            missed=float(true / found[rung].torque.total[0] - 1),
            bound=float(found[rung].numerical_uncertainty[0]),
        )
        for rung in RUNGS[:-1]
    ]


def quadratures(seeds: range, out: Console) -> None:
    """The dearer ways of `analytic.sliding.methods`, of the torque by sliding, against many nodes on the same rung."""
    missed: dict[tuple[str, Way], list[float]] = defaultdict(list)
    for seed in track(seeds, console=Console(stderr=True)):
        scene = sliding_scene(seed)
        assert scene.lubricant is not None
        for way in WAYS[1:]:
            found, true = (torque_by(replace(way, nodes=nodes), scene) for nodes in (way.nodes, MANY))
            missed[scene.lubricant.traction, way].append(abs(found / true - 1))
    table = Table("traction", "rung", "nodes", "scenes", "median", "98 of 100", "most", "bound")
    for (traction, way), some in missed.items():
        bound = way.smooth if traction == "eyring_constant" else way.kinked
        table.add_row(
            *(traction, way.rung, "{} by {}".format(*way.nodes), str(len(some))),
            *(f"{value:.1e}" for value in (*np.quantile(some, [0.5, 0.98, 1.0]), bound)),
        )
    out.print(table)


def torque_by(way: Way, scene: Scene) -> float:
    with patch("analytic.sliding.methods.WAYS", (WAYS[0], way)):
        return float(friction_torque(replace(scene, sliding=way.rung)).torque.total[0])


if __name__ == "__main__":
    typer.run(main)
