"""Do the intervals hold? python validation/benchmarks/intervals.py [--ideal 100] [--real 40] [--seed 8000] [--jobs 1]

Solves random contacts to two accuracies and compares the four quantities with their true values. On the Hertzian
idealisation these are Hertz's, which are exact; on true shapes they come from `converged`, on a mesh of other
proportions, corrected by what that mesh errs on the idealisation of the contact. Prints how often the 95 % interval
contains the true value, the median of half-width over true error, and the largest of those corrections. Seeds 0 to 59,
1000 to 1099, 5000 to 5019 and 7000 to 7099 were used to choose the factors of
`fembearing.grid_convergence`; all others are a test of them.
"""

import time
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from typing import Annotated, Literal

import numpy as np
import typer
from rich.progress import track

from analytic.errors import FembearingError
from analytic.scene import Contact
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.refinement import COMPARED, Wanted, solve_reference
from fembearing.fem.solution import fitted_solution, solve_on_mesh
from fembearing.mesh.recipe import Cells, Depth, Domain, Patch, Recipe, load_recipe
from validation.intervals.twin import ball_and_race, drawn_materials, pressed_to
from validation.study import Jobs, out, progress, run, show

ACCURACIES = (2e-3, 1e-3)
SHARE_OF_POCKETS = 0.25  # of the idealised contacts; true shapes have none, as a seat's approach does not converge
# The mesh of the converged solution shares only the grading towards the edge with the recipes. Halving its cells leaves
# a sixteenth of the error or less (observed on the idealisation); this factor extrapolates it. Semi-axes and pressure
# come from a block twice as wide, and the change by doubling it once more is added; the approach from the block that
# defines it, with cells added around that of the recipe.
OTHER_CELLS = Cells(core=2, inside=3, margin=2, outside=5, depth=6)
OTHER_PATCH = Patch(core_size=0.5, core_bulge=0.7, edge_grading=1.5, margin_size=1.35)
OTHER_DEPTH = Depth(layer=1.0, share=0.45)
OTHER_GROWTH, WIDER = 2.5, 2.0
LEFT = 1 / 16
Kind = Literal["hertzian", "race"]


@dataclass(frozen=True)
class Trial:
    """One contact: relative values by accuracy and quantity."""

    error: dict[float, dict[str, float]]
    uncertainty: dict[float, dict[str, float]]
    seconds: dict[float, float]  # processor time
    correction: dict[str, float]  # of the true values, by the idealisation; 0 where they are exact


def main(
    ideal: Annotated[int, typer.Option(help="Random contacts of half spaces.")] = 100,
    real: Annotated[int, typer.Option(help="Random contacts of ball and race, true shapes.")] = 40,
    seed: Annotated[int, typer.Option(help="First seed.")] = 8000,
    jobs: Jobs = 1,
) -> None:
    kinds: tuple[tuple[Kind, int], ...] = (("hertzian", ideal), ("race", real))
    with ProcessPoolExecutor(jobs) as pool:
        for kind, count in kinds:
            if count == 0:
                continue
            seeds = range(seed, seed + count)
            answers = pool.map(partial(trial, kind=kind), seeds)
            results = list(track(answers, total=count, description=kind, console=progress))
            for number, each in zip(seeds, results, strict=True):
                if isinstance(each, str):
                    out.print(f"seed {number}: {each}")
            solved = [each for each in results if isinstance(each, Trial)]
            for accuracy in ACCURACIES:
                judge(kind, solved, accuracy=accuracy, first=seed, count=count)
            if kind == "race":
                worst = {name: max(abs(each.correction[name]) for each in solved) for name in COMPARED}
                words = ", ".join(f"{name} {error:.4%}" for name, error in worst.items())
                out.print(f"The idealisation corrects the converged solutions by up to: {words}\n")


def trial(seed: int, *, kind: Kind) -> Trial | str:
    """One random contact, or the reason why it cannot be solved."""
    recipe = load_recipe(kind)
    contact = random_contact(np.random.default_rng(seed), pockets=SHARE_OF_POCKETS if kind == "hertzian" else 0.0)
    references, seconds = {}, {}
    correction: dict[str, float] = dict.fromkeys(COMPARED, 0.0)
    try:
        for accuracy in ACCURACIES:
            start = time.process_time()
            references[accuracy] = solve_reference(contact, Wanted(recipe, accuracy=accuracy))
            seconds[accuracy] = time.process_time() - start
        if kind == "hertzian":
            truth = vars(hertz_quantities(contact))
        else:
            semi_axes = references[ACCURACIES[0]].meshes[1].pair.semi_axes
            correction = error_of_converged(contact)
            plain = converged(contact, recipe=recipe, semi_axes=semi_axes)
            truth = {name: value / (1 + correction[name]) for name, value in plain.items()}
    except FembearingError as problem:
        return str(problem)
    parts = {accuracy: {name: each.estimates[name] for name in COMPARED} for accuracy, each in references.items()}
    return Trial(
        error={
            accuracy: {name: abs(part.value / truth[name] - 1) for name, part in each.items()}
            for accuracy, each in parts.items()
        },
        uncertainty={accuracy: {name: part.total for name, part in each.items()} for accuracy, each in parts.items()},
        seconds=seconds,
        correction=correction,
    )


def random_contact(rng: np.random.Generator, *, pockets: float = SHARE_OF_POCKETS) -> Contact:
    """Conformity 0.5025 to 0.6, semi-axes up to a fifth of the ball's radius.

    pockets : probability that the contact is one of ball and pocket instead of ball and race
    """
    shape = ball_and_race(rng) | {"contact_angle": 0.0}
    groove = shape["groove_radius"]
    if rng.random() < pockets:
        shape |= {"pair": "pocket", "rolling_radius": -groove * rng.uniform(1.0, 1.5)}
    shape |= {"shoulder": 0.95 * groove, "far_shoulder": 0.95 * groove, **drawn_materials(rng)}
    return pressed_to(Contact(**shape, load=1.0), 10 ** rng.uniform(-4, np.log10(0.2)) * shape["ball_radius"])


def converged(contact: Contact, *, recipe: Recipe, semi_axes: tuple[float, float]) -> dict[str, float]:
    """The four quantities, extrapolated, on meshes that do not refine those of the recipe."""
    has_boundary = recipe.geometry == "real"  # half spaces have none

    def solved(width: float, level: int, *, extended: bool) -> dict[str, float]:
        domain = Domain(extent=width * recipe.domain.extent, growth=OTHER_GROWTH)
        other = replace(recipe, cells=OTHER_CELLS, patch=OTHER_PATCH, depth=OTHER_DEPTH, domain=domain)
        mesh = solve_on_mesh(contact, recipe=other, level=level, semi_axes=semi_axes, extended=extended)
        return vars(mesh.quantities)

    def extrapolated(name: str, first: dict[str, float], second: dict[str, float]) -> float:
        return second[name] + (second[name] - first[name]) * LEFT / (1 - LEFT)

    coarse, fine = (solved(WIDER, level, extended=False) for level in (1, 2))
    wider = solved(WIDER, 2, extended=True) if has_boundary else fine
    values = {name: extrapolated(name, coarse, fine) * wider[name] / fine[name] for name in COMPARED}
    return values | {
        "approach": extrapolated("approach", *(solved(1.0, level, extended=has_boundary) for level in (1, 2)))
    }


def error_of_converged(contact: Contact) -> dict[str, float]:
    """Relative error of `converged` against exact Hertz on the idealisation of a contact of true shape."""
    recipe = load_recipe("hertzian")
    recipe = replace(recipe, domain=load_recipe("race").domain)
    contact = replace(contact, shoulder=np.inf, far_shoulder=np.inf)
    values = converged(contact, recipe=recipe, semi_axes=fitted_solution(contact, recipe=recipe).pair.semi_axes)
    exact = vars(hertz_quantities(contact))
    return {name: values[name] / exact[name] - 1 for name in COMPARED}


def judge(kind: Kind, trials: list[Trial], *, accuracy: float, first: int, count: int) -> None:
    """Print how often the intervals of an accuracy hold."""
    all_hold, rows = np.ones(len(trials), dtype=bool), []
    for name in COMPARED:
        error = np.array([each.error[accuracy][name] for each in trials])
        width = np.array([each.uncertainty[accuracy][name] for each in trials])
        all_hold &= error <= width
        holds = f"{np.count_nonzero(error <= width)} of {error.size}"
        rows.append((name, holds, f"{np.median(width / error):.1f}", f"{np.median(error):.3%}", f"{error.max():.3%}"))
    heads = ("quantity", "interval holds", "half-width/error, median", "error, median", "error, worst")
    show(
        heads,
        rows,
        f"{kind}: seeds {first} to {first + count - 1}, {len(trials)} contacts solved, accuracy {accuracy:g}",
    )
    seconds = np.median([each.seconds[accuracy] for each in trials])
    held = f"All four hold in {np.count_nonzero(all_hold)} of {len(trials)}"
    out.print(f"{held}; median processor time {seconds:.1f} s a contact\n")


if __name__ == "__main__":
    run(main)
