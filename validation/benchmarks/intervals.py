"""Do the intervals hold? python validation/benchmarks/intervals.py [--ideal 100] [--real 40] [--seed 8000] [--jobs 1]

Solves random contacts to two accuracies and compares the four quantities with their true values. On the Hertzian
idealisation these are Hertz's, which are exact; on true shapes they come from `converged`, on a mesh of other
proportions, corrected by what that mesh errs on the idealisation of the contact. Prints how often the 95 % interval
contains the true value, the median of half-width over true error, and the largest of those corrections. Seeds 0 to 59,
1000 to 1099, 5000 to 5019 and 7000 to 7099 were used to choose the factors of
`fembearing.grid_convergence`; all others are a test of them.
"""

import time
from collections.abc import Mapping
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import partial
from typing import Annotated, Literal, NamedTuple

import numpy as np
import typer
from rich.progress import track

from analytic.errors import FembearingError
from analytic.scene import Array, Contact
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.reference import solve_reference
from fembearing.check.contact.refinement import COMPARED, Wanted
from fembearing.fem.solution import fitted_solution, solve_on_mesh
from fembearing.mesh.recipe import Cells, Depth, Domain, Patch, Recipe, load_recipe
from validation.intervals.levels import ball_and_race, drawn_materials, pressed_to
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


class Trial(NamedTuple):
    """One contact; relative errors and stated uncertainties by accuracy and quantity, (2, 4)."""

    error: Array
    uncertainty: Array
    seconds: list[float]  # processor time by accuracy
    correction: Array  # of the true values, by the idealisation; 0 where they are exact


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
            title = f"{kind}: seeds {seed} to {seed + count - 1}, {len(solved)} contacts solved"
            for number, accuracy in enumerate(ACCURACIES):
                judge(solved, number, f"{title}, accuracy {accuracy:g}")
            if kind == "race":
                worst = np.max(np.abs([each.correction for each in solved]), axis=0)
                words = ", ".join(f"{name} {error:.4%}" for name, error in zip(COMPARED, worst, strict=True))
                out.print(f"The idealisation corrects the converged solutions by up to: {words}\n")


def trial(seed: int, *, kind: Kind) -> Trial | str:
    """One random contact, or the reason why it cannot be solved."""
    recipe = load_recipe(kind)
    contact = random_contact(np.random.default_rng(seed), pockets=SHARE_OF_POCKETS if kind == "hertzian" else 0.0)
    references, seconds, correction = [], [], np.zeros(len(COMPARED))
    try:
        for accuracy in ACCURACIES:
            start = time.process_time()
            references.append(solve_reference(contact, Wanted(recipe, accuracy=accuracy)))
            seconds.append(time.process_time() - start)
        if kind == "hertzian":
            truth = _values(vars(hertz_quantities(contact)))
        else:
            correction = error_of_converged(contact)
            semi_axes = references[0].meshes[1].pair.semi_axes
            truth = converged(contact, recipe=recipe, semi_axes=semi_axes) / (1 + correction)
    except FembearingError as problem:
        return str(problem)
    parts = [[each.estimates[name] for name in COMPARED] for each in references]
    error = np.abs(np.array([[part.value for part in each] for each in parts]) / truth - 1)
    return Trial(error, np.array([[part.total for part in each] for each in parts]), seconds, correction)


def _values(quantities: Mapping[str, float]) -> Array:
    return np.array([quantities[name] for name in COMPARED])


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


def converged(contact: Contact, *, recipe: Recipe, semi_axes: tuple[float, float]) -> Array:
    """(4,) the quantities, extrapolated, on meshes that do not refine those of the recipe."""
    has_boundary = recipe.geometry == "real"  # half spaces have none

    def solved(width: float, level: int, *, extended: bool) -> Array:
        domain = Domain(extent=width * recipe.domain.extent, growth=OTHER_GROWTH)
        other = replace(recipe, cells=OTHER_CELLS, patch=OTHER_PATCH, depth=OTHER_DEPTH, domain=domain)
        mesh = solve_on_mesh(contact, recipe=other, level=level, semi_axes=semi_axes, extended=extended)
        return _values(vars(mesh.quantities))

    def extrapolated(first: Array, second: Array) -> Array:
        return second + (second - first) * LEFT / (1 - LEFT)

    coarse, fine = (solved(WIDER, level, extended=False) for level in (1, 2))
    wider = solved(WIDER, 2, extended=True) if has_boundary else fine
    of_block = extrapolated(*(solved(1.0, level, extended=has_boundary) for level in (1, 2)))
    return np.where(np.array(COMPARED) == "approach", of_block, extrapolated(coarse, fine) * wider / fine)


def error_of_converged(contact: Contact) -> Array:
    """(4,) relative error of `converged` against exact Hertz on the idealisation of a contact of true shape."""
    recipe = replace(load_recipe("hertzian"), domain=load_recipe("race").domain)
    contact = replace(contact, shoulder=np.inf, far_shoulder=np.inf)
    values = converged(contact, recipe=recipe, semi_axes=fitted_solution(contact, recipe=recipe).pair.semi_axes)
    return values / _values(vars(hertz_quantities(contact))) - 1


def judge(trials: list[Trial], number: int, title: str) -> None:
    """Print how often the intervals of an accuracy, by its number, hold."""
    errors, widths = (np.array([each[part][number] for each in trials]) for part in (0, 1))
    held, rows = errors <= widths, []
    for name, error, width, holds in zip(COMPARED, errors.T, widths.T, held.T, strict=True):
        told = f"{np.median(width / error):.1f}", f"{np.median(error):.3%}", f"{error.max():.3%}"
        rows.append((name, f"{np.count_nonzero(holds)} of {error.size}", *told))
    show(("quantity", "interval holds", "half-width/error, median", "error, median", "error, worst"), rows, title)
    seconds = np.median([each.seconds[number] for each in trials])
    all_four = np.count_nonzero(held.all(axis=1))
    out.print(f"All four hold in {all_four} of {len(trials)}; median processor time {seconds:.1f} s a contact\n")


if __name__ == "__main__":
    run(main)
