"""Does `auto` keep to the tolerance? python validation/benchmarks/effects.py [--scenes 300] [--seed 30000]

Random scenes vary load, speed, angle, grooves, roughness, viscosity, traction, radial load and spin rule. Each is
computed with every effect on and sliding integrated over the ellipse, and then as `auto` decides at tolerances of 10, 1
and 0.1 %. For each tolerance the tables show the deviation of auto, how often its stated numerical uncertainty covers
this deviation, how much faster it is (processor time, warm), the methods that it chose, and the effects that it left
out. A scene that the model refuses is named and counted. Model against model: this verifies decisions, not physics.
Prints tables and writes effects.csv and effects.png into this folder.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads
os.environ.setdefault("MKL_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import csv
import time
from collections import Counter
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Literal

import matplotlib as mpl
import numpy as np
import typer
from matplotlib.figure import Figure
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic import friction_torque
from analytic.effects.table import COMPUTED, ENTRIES
from analytic.errors import FembearingError
from analytic.result import FrictionTorque
from analytic.scene import Scene
from validation.benchmarks.machine import machine, versions
from validation.benchmarks.random_scenes import random_scene

mpl.use("agg")

STRICT = 1e-6  # tolerance that selects the most nodes
TOLERANCES = (0.1, 0.01, 0.001)
SPREAD = 1.8  # largest factor of the random horizontal shift of points in the figure
HERE = Path(__file__).parent


@dataclass(frozen=True, kw_only=True)
class Trial:
    """One scene at one tolerance."""

    seed: int
    tolerance: float
    difference: float  # total torque of auto over that with everything on, minus 1
    uncertainty: float  # stated by auto, over its own total
    seconds: float
    full_seconds: float
    loads: str
    sliding: str
    left_out: tuple[str, ...]

    @property
    def holds(self) -> bool:
        return abs(self.difference) <= self.uncertainty * (1 + self.difference)

    @property
    def speed_up(self) -> float:
        return self.full_seconds / self.seconds


def main(
    scenes: Annotated[int, typer.Option(help="Random scenes.")] = 300,
    seed: Annotated[int, typer.Option(help="First seed; each scene has one of its own.")] = 30000,
    out: Annotated[Path, typer.Option(help="Folder for effects.csv and effects.png.")] = HERE,
) -> None:
    shown, trials = Console(width=130), []
    refused: dict[int, str] = {}
    for number in track(range(seed, seed + scenes), console=Console(stderr=True)):
        try:
            trials += compare(random_scene(np.random.default_rng(number)), number)
        except FembearingError as problem:
            refused[number] = str(problem)
    last = seed + scenes - 1
    shown.print(f"{machine()}; {versions('fembearing', 'numpy', 'scipy')}")
    shown.print(f"{scenes} scenes, seeds {seed} to {last}; {len(refused)} refused")
    for number, problem in refused.items():
        shown.print(f"  seed {number}: {problem}")
    if not trials:
        return
    show(trials, shown)
    out.mkdir(parents=True, exist_ok=True)
    write(trials, out / "effects.csv", title=f"seeds {seed} to {last}, {len(refused)} refused")
    draw(trials, out / "effects.png")


def compare(scene: Scene, seed: int) -> list[Trial]:
    full, full_seconds = timed(everything_on(scene))
    trials = []
    for tolerance in TOLERANCES:
        result, seconds = timed(replace(scene, tolerance=tolerance))
        trials.append(
            Trial(
                seed=seed,
                tolerance=tolerance,
                difference=float(result.torque.total[0] / full.torque.total[0] - 1),
                uncertainty=float(result.numerical_uncertainty[0]),
                seconds=seconds,
                full_seconds=full_seconds,
                loads=result.provenance["loads"],
                sliding=result.provenance["sliding"].replace("_", " "),
                left_out=tuple(
                    effect.name for effect in result.effects if effect.name in COMPUTED and effect.decision == "off"
                ),
            )
        )
    return trials


def everything_on(scene: Scene) -> Scene:
    """The scene with every effect that it has inputs for."""
    effects: dict[str, Literal["auto", "on", "off"]] = {
        name: "on" for name in COMPUTED if ENTRIES[name].lacks(scene) is None
    }
    return replace(scene, tolerance=STRICT, effects=effects, sliding="over_ellipse")


def timed(scene: Scene) -> tuple[FrictionTorque, float]:
    """The result and the least processor time of two warm calls."""
    result, seconds = friction_torque(scene), []
    for _ in range(2):
        started = time.process_time()
        friction_torque(scene)
        seconds.append(time.process_time() - started)
    return result, min(seconds)


def show(trials: list[Trial], out: Console) -> None:
    heads = ("tolerance", "deviation, largest", "median", "over tolerance", "within uncertainty", "stated, median")
    table = Table(*heads, "faster, median", "least to greatest", "seeds over tolerance")
    for tolerance in TOLERANCES:
        some = [trial for trial in trials if trial.tolerance == tolerance]
        deviation = np.abs([trial.difference for trial in some])
        faster = np.array([trial.speed_up for trial in some])
        beyond = [str(trial.seed) for trial in some if abs(trial.difference) > tolerance]
        table.add_row(
            *(f"{tolerance:.1%}", f"{deviation.max():.3%}", f"{np.median(deviation):.3%}"),
            f"{len(beyond)} of {len(some)}",
            f"{sum(trial.holds for trial in some)} of {len(some)}",
            f"{np.median([trial.uncertainty for trial in some]):.3%}",
            *(f"{np.median(faster):.1f}", f"{faster.min():.2f} to {faster.max():.1f}", ", ".join(beyond)),
        )
    out.print(table)
    for tolerance in TOLERANCES:
        some = [trial for trial in trials if trial.tolerance == tolerance]
        out.print(f"at {tolerance:.1%}", style="bold")
        for name in ("loads", "sliding"):
            out.print(f"  {name}: {counted(Counter(getattr(trial, name) for trial in some))}")
        out.print(f"  left out: {counted(Counter(name for trial in some for name in trial.left_out))}")


def counted(names: Counter[str]) -> str:
    return ", ".join(f"{name.replace('_', ' ')} {count}" for name, count in names.most_common())


def write(trials: list[Trial], path: Path, *, title: str) -> None:
    with path.open("w", encoding="utf-8", newline="") as file:
        file.write(f"# {machine()}; {versions('fembearing', 'numpy', 'scipy')}; {title}\n")
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(
            (*("seed", "tolerance", "difference", "numerical_uncertainty", "holds", "speed_up"),
             *("loads", "sliding", "left_out"))
        )  # fmt: skip
        for trial in trials:
            numbers = (f"{value:.4g}" for value in (trial.difference, trial.uncertainty))
            writer.writerow(
                (*(trial.seed, trial.tolerance, *numbers, trial.holds, f"{trial.speed_up:.2f}"),
                 *(trial.loads, trial.sliding, " ".join(trial.left_out)))
            )  # fmt: skip


def draw(trials: list[Trial], path: Path) -> None:
    figure = Figure(figsize=(9.0, 4.2), layout="constrained")
    errors, speeds = figure.subplots(1, 2)
    marks = {"single coefficient": "o", "along axis": "s", "over ellipse": "^", "none": "x"}
    jitter = np.random.default_rng(0)
    for sliding, mark in marks.items():
        some = [trial for trial in trials if trial.sliding == sliding]
        if not some:
            continue
        shifted = np.array([trial.tolerance for trial in some]) * SPREAD ** jitter.uniform(-1, 1, len(some))
        deviation = np.maximum(np.abs([trial.difference for trial in some]), 1e-9)
        errors.loglog(shifted, deviation, mark, ms=3, alpha=0.5, mew=0, label=sliding)
        speeds.loglog(shifted, [trial.speed_up for trial in some], mark, ms=3, alpha=0.5, mew=0, label=sliding)
    limit = np.array(TOLERANCES)
    errors.hlines(limit, limit / SPREAD, limit * SPREAD, "k", lw=0.8, label="tolerance")
    errors.set(xlabel="tolerance, points shifted", ylabel="deviation from everything on", ylim=(1e-9, 1))
    errors.legend(frameon=False, fontsize=8)
    speeds.axhline(1, color="k", lw=0.8)
    speeds.set(xlabel="tolerance, points shifted", ylabel="times faster than everything on")
    figure.savefig(path, dpi=130, metadata={"Software": None})


if __name__ == "__main__":
    typer.run(main)
