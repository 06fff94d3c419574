"""Search for scenes whose stated uncertainty is too small.

    python validation/adversary/run.py [--scenes 200] [--climbs 20]

Draws scenes over the valid range of scene files: bearings of several shapes, loads from 0.1 N up, creep to 20 000 rpm,
oils up to 1 Pa s, smooth and rough surfaces, given coefficients, balls that turn freely or by a rule, gravity with and
without a direction. Computes each at a tolerance of 5, 1 and 0.1 % with
every choice on `auto`, and once with every effect on and the most accurate methods. The error of `auto` against that is
compared with its stated numerical uncertainty. Then climbs from the worst scenes towards violations: one or more inputs
change at random, and a change stays if the ratio of error to stated uncertainty grows.
Prints how often the statement holds, how wide it is where the error matters, how often the uncertainty is unknown, and
the worst scenes as TOML. Exit status: 0 no violation, 1 a violation. Every draw has its seed, so a run can be repeated.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import sys
import time
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from itertools import repeat
from typing import Annotated

import numpy as np
import typer
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from analytic import friction_torque
from analytic.effects.table import COMPUTED, ENTRIES, ruled
from analytic.errors import FembearingError, InputError
from analytic.result import FrictionTorque
from analytic.scene import Scene
from analytic.scenefile.read import parse_scene

TOLERANCES = (0.05, 0.01, 0.001)
ROUND_OFF = 1e-9  # relative: smaller differences are those of converged iterations
MATTERS = 0.1  # of the tolerance: an error that is worth its statement
SHOWN = 3  # worst scenes in print
STEP = 0.15  # of the range of an input, in a climb; every second change is ten times smaller


@dataclass(frozen=True, kw_only=True)
class Trial:
    """One scene at one tolerance."""

    place: tuple[float, ...]  # of the scene: each input within its range, 0 to 1
    tolerance: float
    error: float  # of the total against everything on, relative, beyond what that itself states
    stated: float  # numerical uncertainty of the total, relative; infinite: unknown

    @property
    def ratio(self) -> float:
        """Error over stated uncertainty: above 1 the statement is wrong, and so is one about no number."""
        if np.isnan(self.error):
            return np.inf
        return 0.0 if self.error <= ROUND_OFF or np.isinf(self.stated) else self.error / max(self.stated, ROUND_OFF)


class Draw:
    """Reads the inputs of a scene off a place, one number after the other."""

    def __init__(self, place: Iterable[float]) -> None:
        self.numbers = iter(place)

    def between(self, low: float, high: float) -> float:
        return low + (high - low) * next(self.numbers)

    def power(self, low: float, high: float) -> float:
        """Even in the logarithm."""
        return float(np.exp(self.between(np.log(low), np.log(high))))

    def one_of(self, *choices: str) -> str:
        return choices[min(int(next(self.numbers) * len(choices)), len(choices) - 1)]

    def chance(self, share: float) -> bool:
        return next(self.numbers) < share


INPUTS = 45  # numbers that a place has; `scene_text` takes no more


def scene_text(place: Iterable[float], *, tolerance: float, directed: bool = False) -> str:
    """The scene at a place, as a scene file; directed : with the direction of gravity, whether it gives it or not."""
    draw = Draw(place)
    ball = draw.power(3e-3, 30e-3)
    inner, outer = (draw.between(0.505, 0.56) * ball for _ in range(2))
    pitch, clearance = ball * draw.between(3.2, 6.5), ball * draw.power(1e-4, 3e-2)
    bottom = pitch / 2 - ball / 2 - clearance / 4
    shoulder = draw.between(0.38, 0.46) * ball
    balls = int(draw.between(0.5, 0.9) * np.pi * pitch / ball)
    material = draw.one_of("steel", "steel", "silicon_nitride")
    lines = [
        'name = "drawn"',
        f"tolerance = {tolerance:g}",
        "[bearing]",
        'name = "drawn"',
        f"ball_count = {max(balls, 5)}",
        f'ball_diameter = "{ball:.9g} m"',
        f'ball_mass = "{np.pi / 6 * ball**3 * (7800 if material == "steel" else 3200):.9g} kg"',
        f'ball_material = "{material}"',
        f'bore_diameter = "{2 * bottom - ball:.9g} m"',
        f'outside_diameter = "{2 * (bottom + ball + clearance / 2) + ball:.9g} m"',
        f'contact_angle = {{ rule = "solved", free = "{draw.between(0.05, 0.7):.9g} rad" }}',
    ]
    for ring, radius, groove in (("inner", bottom, inner), ("outer", bottom + ball + clearance / 2, outer)):
        lines += [
            f"[bearing.{ring}]",
            f'bottom_radius = "{radius:.9g} m"',
            f'groove_radius = "{groove:.9g} m"',
            f'shoulder_half_width = "{shoulder:.9g} m"',
            'material = "steel"',
        ]
    heaviest = 1e8 * ball**2  # N of thrust: about 2.5 GPa in usual grooves, 4 GPa in open ones
    axial = draw.power(0.1, max(heaviest, 1.0))
    lines += ["[operation]", f'axial_load = "{axial:.9g} N"', f'inner_speed = "{draw.power(1e-3, 2e3):.9g} rad/s"']
    radial, moment = draw.power(1e-4, 2.0) * axial, draw.power(1e-4, 0.5) * axial * pitch
    lines += [f'radial_load = "{radial:.9g} N"'] if draw.chance(0.35) else []
    lines += [f'moment = "{moment:.9g} N m"'] if draw.chance(0.2) else []
    down = [f"{draw.between(-1, 1):.6g}" for _ in range(3)]
    lines += [f"down = [{', '.join(down)}]"] if draw.chance(0.5) or directed else []
    oiled = draw.chance(0.8)
    oil = [
        "[lubricant]",
        f'viscosity = "{draw.power(2e-3, 1.0):.9g} Pa s"',
        f'pressure_viscosity = "{draw.between(0.8e-8, 3e-8):.9g} 1/Pa"',
        f'eyring_stress = "{draw.power(1e6, 15e6):.9g} Pa"',
        f"limiting_shear = {draw.between(0.03, 0.1):.6g}",
        f'traction = "{draw.one_of("eyring_sinh", "eyring_sinh", "eyring_constant")}"',
        f'supply = "{draw.one_of("oil_bath", "oil_spot", "grease")}"',
        f"compressible = {'true' if draw.chance(0.2) else 'false'}",
    ]
    degree = 1 + draw.power(1e-3, 1e2)
    oil += [f"starvation_degree = {degree:.9g}"] if draw.chance(0.15) else []
    length = draw.power(10e-6, 200e-6)
    surface = [
        "[surface]",
        f'rms_roughness = "{draw.power(5e-9, 1e-6):.9g} m"',
        f'autocorrelation = {{ kind = "{draw.one_of(*4 * ("gaussian",), "exponential")}", length = "{length:.9g} m", '
        f'spacing = "{length / 20:.9g} m" }}',
        'hardness = "7.8 GPa"',
        f"boundary_friction = {draw.between(0.05, 0.2):.6g}",
        draw.one_of('gap = "elastic"', 'gap = "truncated"', 'gap = "truncated"\nasperities = "greenwood_williamson"'),
    ]
    friction = ["[friction]", f"hysteresis_loss = {draw.power(1e-3, 2e-2):.6g}"]
    friction += [f'spin_rule = "{draw.one_of(*4 * ("free",), "balanced", "inner_control", "outer_control")}"']
    coefficient = draw.power(0.003, 0.2)
    if oiled:
        return "\n".join(lines + oil + surface + friction) + "\n"
    return "\n".join([*lines, *(oil if draw.chance(0.5) else []), *friction, f"coefficient = {coefficient:.6g}"]) + "\n"


def trials_at(place: tuple[float, ...]) -> list[Trial] | None:
    """One scene at every tolerance; None where it is refused.

    Nothing where an iteration does not converge, or where the reference itself states more than a tenth.
    """
    try:
        scene = parse_scene(scene_text(place, tolerance=TOLERANCES[0]), origin="drawn")
        exact = everything_on(parse_scene(scene_text(place, tolerance=TOLERANCES[0], directed=True), origin="drawn"))
        whole, unsure = float(exact.torque.total[0]), float(exact.numerical_uncertainty[0])
        if unsure > MATTERS:  # no reference
            return []
        trials = []
        for tolerance in TOLERANCES:
            auto = friction_torque(replace(scene, tolerance=tolerance))
            trials.append(
                Trial(
                    place=place,
                    tolerance=tolerance,
                    error=max(abs(float(auto.torque.total[0]) / whole - 1) - unsure, 0.0),
                    stated=float(auto.numerical_uncertainty[0]),
                )
            )
    except InputError:
        return None
    except FembearingError:
        return []
    return trials


def everything_on(scene: Scene) -> FrictionTorque:
    """Every effect that the scene has inputs for, by the most accurate methods."""
    wanted = {name: "on" for name in COMPUTED if ENTRIES[name].lacks(scene) is None}
    dearest = replace(scene, tolerance=1e-6, sliding="over_ellipse" if ruled(scene) else "marched_creep")
    try:
        return friction_torque(replace(dearest, effects=wanted))
    except InputError:  # an effect that cannot act in this scene: auto then computes all that can
        return friction_torque(dearest)


def climbed(trial: Trial, seed: int, steps: int) -> list[Trial]:
    """The trials on the way from one scene to a worse one."""
    rng = np.random.default_rng(seed)
    best, seen = trial, []
    for step in range(steps):
        change = np.where(rng.random(INPUTS) < 3 / INPUTS, rng.normal(size=INPUTS), 0.0)
        moved = np.clip(np.array(best.place) + change * STEP * (0.1 if step % 2 else 1.0), 0.0, 1.0 - 1e-9)
        at_tolerances = trials_at(tuple(moved.tolist()))
        if not at_tolerances:
            continue
        seen += at_tolerances
        here = at_tolerances[TOLERANCES.index(best.tolerance)]
        if here.ratio > best.ratio:
            best = here
    return seen


def main(
    scenes: Annotated[int, typer.Option(min=1, help="Scenes to draw at random.")] = 200,
    climbs: Annotated[int, typer.Option(min=0, help="Climbs, from the worst of them.")] = 20,
    steps: Annotated[int, typer.Option(min=1, help="Scenes in each climb.")] = 50,
    seed: Annotated[int, typer.Option(help="Of the first scene.")] = 1,
    jobs: Annotated[int, typer.Option(min=1, help="Processes.")] = 2,
) -> None:
    """Look for scenes whose stated uncertainty does not hold."""
    out, started = Console(width=110, soft_wrap=False), time.perf_counter()
    places = [tuple(np.random.default_rng(seed + index).random(INPUTS).tolist()) for index in range(scenes)]
    with ProcessPoolExecutor(jobs) as pool, Progress(console=Console(stderr=True)) as bar:
        task = bar.add_task("random scenes", total=scenes)
        drawn: list[Trial] = []
        refused = stuck = 0
        for trials in pool.map(trials_at, places, chunksize=4):
            bar.advance(task)
            refused, stuck = refused + (trials is None), stuck + (trials == [])
            drawn += trials or []
        starts = worst_places(drawn)[:climbs]
        task = bar.add_task("climbs", total=len(starts))
        searched: list[Trial] = []
        for trials in pool.map(climbed, starts, range(seed, seed + len(starts)), repeat(steps)):
            bar.advance(task)
            searched += trials
    show(drawn, searched, out)
    out.print(f"Of the random scenes {refused} more were refused, and {stuck} ended without convergence.")
    out.print(f"{time.perf_counter() - started:.0f} s, {jobs} processes, seed {seed}.")
    sys.exit(int(any(trial.ratio > 1 for trial in drawn + searched)))


def worst_places(trials: list[Trial]) -> list[Trial]:
    """The worst trial of each place, worst first."""
    worst: dict[tuple[float, ...], Trial] = {}
    for trial in sorted(trials, key=lambda trial: trial.ratio, reverse=True):
        worst.setdefault(trial.place, trial)
    return list(worst.values())


def show(drawn: list[Trial], searched: list[Trial], out: Console) -> None:
    table = Table("tolerance", "search", "scenes", "held", "largest ratio", "unknown", "stated/error", "of scenes")
    for tolerance in TOLERANCES:
        for name, trials in (("random", drawn), ("directed", searched)):
            here = [trial for trial in trials if trial.tolerance == tolerance]
            if not here:
                continue
            wide = [each.stated / each.error for each in here
                    if each.error > MATTERS * tolerance and np.isfinite(each.stated)]  # fmt: skip
            table.add_row(
                f"{100 * tolerance:g} %",
                name,
                str(len(here)),
                str(sum(trial.ratio <= 1 for trial in here)),
                f"{max(trial.ratio for trial in here):.3g}",
                f"{100 * np.mean([np.isinf(trial.stated) for trial in here]):.2g} %",
                f"{np.median(wide):.2g}" if wide else "",
                str(len(wide)),
            )
    out.print(table)
    out.print(
        "ratio: error over stated uncertainty. stated/error: median over the scenes whose error exceeds a tenth of the "
        "tolerance."
    )
    for trial in worst_places(drawn + searched)[:SHOWN]:
        if trial.ratio > 1:
            out.print(f"\n# error {100 * trial.error:.4g} %, stated {100 * trial.stated:.4g} %", highlight=False)
            out.print(scene_text(trial.place, tolerance=trial.tolerance), highlight=False, markup=False)


if __name__ == "__main__":
    typer.run(main)
