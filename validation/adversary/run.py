"""Search for scenes whose stated uncertainty is too small.

    python validation/adversary/run.py [--scenes 200] [--climbs 20]

Draws scenes over the valid range of scene files: bearings of several shapes, loads from 0.1 N up, creep to 20 000 rpm,
oils up to 1 Pa s, smooth and rough surfaces, given coefficients, balls that turn freely or by a rule, gravity with and
without a direction (radial.py); thrust bearings, pairs, seats, given contact angles, height maps, series of unlike
points, cages that rest on their balls, losses of the oil (drawn.py).
Computes each at a tolerance of 5, 1 and 0.1 % with every choice on `auto`, and once with every effect on and the most
accurate methods. The error of `auto` against that is compared with its stated numerical uncertainty, at every operating
point. Then climbs from the worst scenes towards violations: one or more inputs change at random, and a change stays if
the ratio of error to stated uncertainty grows.
Prints each violation as TOML when it is found, then how often the statement holds, how wide it is where the error
matters, how often and why the uncertainty is unknown. Exit status: 0 no violation, 1 a violation. Every draw has its
seed, so a run can be repeated.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import re
import signal
import sys
import time
from collections import Counter
from collections.abc import Iterable
from concurrent.futures import ProcessPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field, replace
from itertools import repeat
from typing import Annotated

import numpy as np
import typer
from rich.console import Console
from rich.table import Table

from analytic import friction_torque
from analytic.cage.drive import SQUEEZE_SPREAD
from analytic.effects.table import COMPUTED, ENTRIES, ruled
from analytic.errors import FembearingError, InputError
from analytic.result import FrictionTorque
from analytic.scene import Array, Scene
from analytic.scenefile.read import parse_scene
from analytic.verdicts import physical_checks
from validation.adversary.drawn import INPUTS, LONG_SERIES, scene_text
from validation.adversary.radial import RADIAL_INPUTS, radial_scene

TOLERANCES = (0.05, 0.01, 0.001)
ROUND_OFF = 1e-9  # relative: smaller differences are those of converged iterations
LAST = np.array([-1])  # number of a point
CHOSEN_LAWS = "free_ball", "closed_creep"  # of the slip of free balls: a choice of the scene, as that of a film formula
MATTERS = 0.1  # of the tolerance: an error that is worth its statement
NOT_GIVEN = "is not given"  # in a cause of an unknown uncertainty: an input is missing that the scene could have
DECISIVE = "peak_pressure", "shoulder", "cage_force"  # limits beyond which the uncertainty is unknown
LONGEST = 15.0  # s of processor time for a scene: those with two steady states take minutes
MORE = 4  # of that for a long series
PIECE = 25  # scenes, or climbs, between two lines in print
STEP = 0.15  # of the range of an input, in a climb; every second change is ten times smaller


@dataclass(frozen=True, kw_only=True)
class Trial:
    """One operating point of a scene at one tolerance."""

    place: tuple[float, ...]  # of the scene: each input within its range, 0 to 1
    tolerance: float
    error: float  # difference of everything on, or of the point alone, beyond its own uncertainty, over the total
    stated: float  # numerical uncertainty of the total, relative; infinite: unknown
    reference: float  # uncertainty of everything on, or of the point alone, relative
    unknown: tuple[str, ...]  # why the uncertainty of a point of the scene is unknown
    is_past_limit: bool = False  # whether a limit of the physics fails beyond which the uncertainty is unknown

    @property
    def lacks_input(self) -> bool:
        """Whether the uncertainty is unknown for an input that the scene lacks: with it, everything on is known."""
        missing = bool(self.unknown) and all(NOT_GIVEN in cause for cause in self.unknown)
        return np.isinf(self.stated) and np.isfinite(self.reference) and missing

    @property
    def ratio(self) -> float:
        """Error over stated uncertainty: above 1 the statement is wrong, and so is one about no number."""
        if np.isnan(self.error):
            return np.inf
        return 0.0 if self.error <= ROUND_OFF or np.isinf(self.stated) else self.error / max(self.stated, ROUND_OFF)


@dataclass(frozen=True, kw_only=True)
class Drawn:
    """What became of one scene: its trials, or why it has no torque."""

    trials: list[Trial] = field(default_factory=list)
    refused: str = ""
    unsolved: str = ""  # an iteration does not converge, or takes long


def drawn_at(place: tuple[float, ...]) -> Drawn:
    """One scene at every tolerance and point."""
    signal.signal(signal.SIGVTALRM, _give_up)
    try:
        scene = parse_scene(scene_text(place, tolerance=TOLERANCES[0]), origin="drawn")
        is_long = scene.operation.as_series().inner_speed.size == LONG_SERIES
        signal.setitimer(signal.ITIMER_VIRTUAL, LONGEST * (MORE if is_long else 1))
        exact = everything_on(parse_scene(scene_text(place, tolerance=TOLERANCES[0], directed=True), origin="drawn"))
        scenes = [replace(scene, tolerance=each) for each in TOLERANCES]
        return Drawn(trials=[trial for each in scenes for trial in compared(place, each, exact)])
    except InputError as reason:
        return Drawn(refused=str(reason))
    except (FembearingError, TimeoutError) as reason:
        return Drawn(unsolved=str(reason))
    except Exception as fault:  # the run goes on, and the fault counts as a wrong statement
        return Drawn(
            trials=[
                Trial(place=place, tolerance=each, error=np.nan, stated=0.0, reference=0.0, unknown=(repr(fault),))
                for each in TOLERANCES
            ]
        )
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0.0)


def _give_up(*_: object) -> None:
    raise TimeoutError("takes too long")


def compared(place: tuple[float, ...], scene: Scene, exact: FrictionTorque) -> Iterable[Trial]:
    """The torque of a scene beside that with everything on, at each point; its last point is also solved alone.

    That one is compared with both.
    """
    auto = friction_torque(scene)
    pairs = [(auto, exact)]
    if len(auto.torque.total) > 1:  # the last point has the longest way behind it
        with suppress(FembearingError):  # alone it may be refused, as a pair that is pressed elsewhere only
            alone = friction_torque(last_of(scene))
            pairs += [(auto.at(LAST), alone), (alone, exact.at(LAST))]
    for found, other in pairs:
        is_past_limit = any(check.name in DECISIVE and check.verdict != "pass" for check in physical_checks(found))
        for each, without, share in zip(*difference(found, other), found.numerical_uncertainty, strict=True):
            if found is not auto and np.isinf(without):
                continue  # says nothing: the comparison with everything on asks whether an input is missing
            yield Trial(
                place=place,
                tolerance=scene.tolerance,
                error=max(float(each - without), 0.0) if np.isfinite(without) else 0.0,
                stated=float(share),
                reference=float(without),
                unknown=found.unknown,
                is_past_limit=is_past_limit,
            )


def last_of(scene: Scene) -> Scene:
    """The scene at its last operating point alone."""
    return replace(scene, operation=scene.operation.as_series().at(LAST))


def difference(auto: FrictionTorque, other: FrictionTorque) -> tuple[Array, Array]:
    """(n,) of the total of the other one, and the uncertainty of the other, both over the total.

    The spread of a squeezed cage is left out of the latter: both have the same formula.
    """
    whole, total = other.torque.total, auto.torque.total  # the stated uncertainty is a share of it
    unsure = other.numerical_uncertainty * np.divide(whole, total, out=np.ones_like(whole), where=total > 0)
    if other.cage is not None:
        spread = SQUEEZE_SPREAD * other.cage.torque * other.cage.is_squeezed
        unsure = unsure - np.divide(spread, total, out=np.zeros_like(total), where=total > 0)
    change = np.abs(total - whole)
    return np.divide(change, total, out=np.where(change > 0, np.inf, 0.0), where=total > 0), unsure


def everything_on(scene: Scene) -> FrictionTorque:
    """Every effect that the scene has inputs for and does not switch off, by the most accurate methods of its law."""
    off = {name: "off" for name, decision in scene.effects.items() if decision == "off"}
    wanted = {name: "on" for name in (*COMPUTED, "cage") if ENTRIES[name].lacks(scene) is None} | off
    free = scene.sliding if scene.sliding in CHOSEN_LAWS else "free_ball" if "creep" in off else "marched_creep"
    dearest = replace(scene, tolerance=1e-6, sliding="over_ellipse" if ruled(scene) else free)
    try:
        return friction_torque(replace(dearest, effects=wanted))
    except InputError:  # an effect that cannot act in this scene: auto then computes all that can
        return friction_torque(replace(dearest, effects=off))


def climbed(trial: Trial, seed: int, steps: int) -> Drawn:
    """The trials on the way from one scene to a worse one."""
    rng = np.random.default_rng(seed)
    best, seen = trial, []
    for step in range(steps):
        change = np.where(rng.random(INPUTS) < 3 / INPUTS, rng.normal(size=INPUTS), 0.0)
        moved = np.clip(np.array(best.place) + change * STEP * (0.1 if step % 2 else 1.0), 0.0, 1.0 - 1e-9)
        found = drawn_at(tuple(moved.tolist())).trials
        seen += found
        best = max([best, *(each for each in found if each.tolerance == best.tolerance)], key=lambda each: each.ratio)
    return Drawn(trials=seen)


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
    everything_on(parse_scene(radial_scene(np.full(RADIAL_INPUTS, 0.5), tolerance=0.01), origin="drawn"))  # compiles
    with ProcessPoolExecutor(jobs) as pool:
        drawn = list(reported("random scene", pool.map(drawn_at, places, chunksize=1), seed, out))
        random = [trial for each in drawn for trial in each.trials]
        starts = worst_places(random)[:climbs]
        climbing = pool.map(climbed, starts, range(seed, seed + len(starts)), repeat(steps))
        searched = [trial for each in reported("climb", climbing, seed, out) for trial in each.trials]
    show(random, searched, out)
    out.print(
        f"Of the random scenes {sum(bool(each.refused) for each in drawn)} more were refused, and "
        f"{sum(bool(each.unsolved) for each in drawn)} ended without convergence or after {LONGEST:g} s, "
        f"{MORE * LONGEST:g} s of a long series."
    )
    for line in without_torque(drawn, seed):
        out.print(line, highlight=False, markup=False)
    out.print(f"{time.perf_counter() - started:.0f} s, {jobs} processes, seed {seed}.")
    sys.exit(int(any(trial.ratio > 1 for trial in random + searched)))


def reported(name: str, found: Iterable[Drawn], seed: int, out: Console) -> Iterable[Drawn]:
    """The same; each violation in print as it comes, and a line for each piece."""
    begun, broken, unknown = time.perf_counter(), 0, 0
    for number, each in enumerate(found, 1):
        yield each
        unknown += any(np.isinf(trial.stated) for trial in each.trials)
        for trial in worst_places(each.trials):
            if trial.ratio > 1:
                broken += 1
                out.print(f"\n# {name} with seed {seed + number - 1}: error {100 * trial.error:.4g} %, "
                          f"stated {100 * trial.stated:.4g} % {' '.join(trial.unknown)}", highlight=False)  # fmt: skip
                out.print(scene_text(trial.place, tolerance=trial.tolerance), highlight=False, markup=False)
        if number % PIECE == 0:
            out.print(f"{name} {number}: {broken} violations, {unknown} unknown, {time.perf_counter() - begun:.0f} s")


def worst_places(trials: list[Trial]) -> list[Trial]:
    """The worst trial of each place, worst first."""
    worst: dict[tuple[float, ...], Trial] = {}
    for trial in sorted(trials, key=lambda trial: trial.ratio, reverse=True):
        worst.setdefault(trial.place, trial)
    return list(worst.values())


def show(drawn: list[Trial], searched: list[Trial], out: Console) -> None:
    table = Table("tolerance", "search", "scenes", "points", "held", "largest ratio", "unknown", "stated/error", "of")
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
                str(len({trial.place for trial in here})),
                str(len(here)),
                str(sum(trial.ratio <= 1 for trial in here)),
                f"{max(trial.ratio for trial in here):.3g}",
                f"{100 * np.mean([np.isinf(trial.stated) for trial in here]):.2g} %",
                f"{np.median(wide):.2g}" if wide else "",
                str(len(wide)),
            )
    out.print(table)
    out.print(
        "ratio: error over stated uncertainty. stated/error: median over the points whose error exceeds a tenth of the "
        "tolerance."
    )
    vague = np.mean([trial.reference > MATTERS for trial in drawn + searched])
    out.print(f"The reference itself is more uncertain than {100 * MATTERS:g} % at {100 * vague:.2g} % of the points.")
    for line in unknown_shares(drawn):
        out.print(line)


def unknown_shares(trials: list[Trial]) -> Iterable[str]:
    """How many of the scenes have an unknown uncertainty at some tolerance and point: all, and by cause."""
    scenes = len({trial.place for trial in trials})
    sound = len({trial.place for trial in trials if not trial.is_past_limit})
    found: dict[tuple[float, ...], list[Trial]] = {}
    for trial in trials:
        if np.isinf(trial.stated):
            found.setdefault(trial.place, []).append(trial)
    known_with_input = sum(all(trial.lacks_input for trial in each) for each in found.values())
    for name, count in (("", len(found)), (", those that lack an input left out,", len(found) - known_with_input)):
        yield f"unknown{name} in {count} of {scenes} random scenes, {100 * count / max(scenes, 1):.2g} %"
    inside = sum(not all(trial.lacks_input or trial.is_past_limit for trial in each) for each in found.values())
    yield f"these within the limits of the physics, in {inside} of {sound}, {100 * inside / max(sound, 1):.2g} %"
    causes = Counter(
        cause for each in found.values() for cause in {words(why) for trial in each for why in trial.unknown}
    )
    for cause, count in causes.most_common():
        yield f"unknown in {count}: {cause}"


def without_torque(drawn: list[Drawn], seed: int) -> Iterable[str]:
    """Why scenes were refused or not solved, how many, and the seed of the first of them."""
    for name in "unsolved", "refused":
        reasons = [words(getattr(each, name)) for each in drawn]
        for reason, count in Counter(filter(None, reasons)).most_common():
            yield f"{name} in {count}, first {seed + reasons.index(reason)}: {reason}"


def words(reason: str) -> str:
    """A reason without its numbers."""
    return re.sub(r"[0-9.]+( %| [GM]Pa)?", "#", reason)[:90]


if __name__ == "__main__":
    typer.run(main)
