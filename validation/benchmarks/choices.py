"""Do the bounds hold that choose a method? python validation/benchmarks/choices.py [--scenes 100] [--meshes 20]

Takes random scenes (validation/benchmarks/random_scenes.py), one seed each, runs every method of every ladder once, and
compares its bound, which is known before the reference, with its error against the reference. Prints for each method in
how many scenes the bound covers the error, the median of bound over error, and the worst scene. For each ladder it then
prints how often the cheapest method whose bound is within 10, 1 and 0.1 % has an error within it. With --meshes, the
contacts of that many scenes are solved on every level of the recipe. With --cages, that many scenes get a cage, whose
motion is run with four step lengths.
Seeds 61000 to 61029 and 62000 to 62099 were used to choose the constants; all others are a test of them.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads
os.environ.setdefault("MKL_NUM_THREADS", "1")
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

from collections import defaultdict
from typing import Annotated

import numpy as np
import typer
from rich.progress import track

from analytic.errors import FembearingError, InputError
from analytic.scene import Scene
from fembearing.check.contact.scene_contact import RECIPES, contact_of
from fembearing.check.cost import scene_cost
from fembearing.check.cost.ladder import Ladder, measured
from fembearing.mesh.recipe import load_recipe
from validation.benchmarks.random_scenes import random_scene, with_cage
from validation.study import machine, out, progress, run, show

TOLERANCES = (0.1, 0.01, 0.001)
FLOOR = 1e-10  # smaller errors are round-off of iterations, and their ratios mean nothing


def main(
    scenes: Annotated[int, typer.Option(help="Random scenes for the ladders of formulas.")] = 100,
    meshes: Annotated[int, typer.Option(help="Of these, the number whose contact is solved by finite elements.")] = 20,
    cages: Annotated[int, typer.Option(help="Of these, the number that get a cage.")] = 20,
    seed: Annotated[int, typer.Option(help="First seed; each scene has its own.")] = 63000,
) -> None:
    checks: dict[tuple[str, str], list[tuple[int, float, float]]] = defaultdict(list)  # seed, error, bound
    choices: dict[tuple[str, float], list[bool]] = defaultdict(list)
    absent: dict[str, int] = defaultdict(int)
    for number in track(range(seed, seed + scenes), console=progress):
        scene_cost.SEED = number  # seed of the generated surfaces
        rng = np.random.default_rng(number)
        scene = random_scene(rng)
        if number - seed < cages:
            scene = with_cage(rng, scene)
        for one in ladders_of(scene, absent, with_meshes=number - seed < meshes, race=number % 2):
            for method in one.methods:
                if method.error is not None and method.bound is not None:
                    checks[one.quantity, method.name].append((number, method.error, method.bound))
            for tolerance in TOLERANCES:
                chosen = one.cheapest(tolerance)
                if chosen is not None:
                    choices[one.quantity, tolerance].append((chosen.error or 0.0) <= tolerance)
    out.print(f"{machine()}; seeds {seed} to {seed + scenes - 1}")
    judge(checks)
    for quantity, count in absent.items():
        out.print(f"{quantity}: {count} scenes lack this ladder")
    for (quantity, tolerance), held in choices.items():
        out.print(f"{quantity} at {100 * tolerance:g} %: {sum(held)} of {len(held)} choices are within the tolerance")


def ladders_of(scene: Scene, absent: dict[str, int], *, with_meshes: bool, race: int) -> list[Ladder]:
    ladders, once = [], {"tolerance": scene.tolerance, "repeats": 1}  # errors matter here, seconds do not
    for quantity, declare in scene_cost.FORMULA_LADDERS.items():
        try:
            ladders.append(measured(quantity, *declare(scene), **once))
        except InputError:
            absent[quantity] += 1
    if with_meshes:
        try:
            contact = contact_of(scene, pair="outer" if race else "inner")
            recipe = load_recipe(RECIPES["real"])
            ladders.append(measured(f"contact, {contact.pair}", *scene_cost.contact_methods(contact, recipe), **once))
        except FembearingError:
            absent["contact"] += 1
    return ladders


def judge(checks: dict[tuple[str, str], list[tuple[int, float, float]]]) -> None:
    """Print how often the bound of each method covers its error; a ratio of round-off to round-off is 1."""
    rows, ratios_of_all, covered_of_all = [], [], 0
    for names, checked in checks.items():
        seeds, errors, bounds = np.transpose(checked)
        ratios, covered = np.maximum(bounds, FLOOR) / np.maximum(errors, FLOOR), int(np.sum(errors <= bounds))
        worst = int(ratios.argmin())
        shown = f"{np.median(ratios):.3g}", f"{np.median(errors):.2g}", f"{1 / ratios[worst]:.2g}"
        rows.append((*names, f"{covered} of {len(checked)}", *shown, int(seeds[worst])))
        ratios_of_all += ratios.tolist()
        covered_of_all += covered
    heads = ("quantity", "method", "covers", "bound/error, median", "error, median", "error/bound, worst", "at seed")
    show(heads, rows)
    middle = f"bound over error {np.median(ratios_of_all):.3g}, median"
    out.print(f"all: {covered_of_all} of {len(ratios_of_all)} covered; {middle}")


if __name__ == "__main__":
    run(main)
