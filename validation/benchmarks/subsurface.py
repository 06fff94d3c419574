"""Errors of the stresses below a contact: python validation/benchmarks/subsurface.py [--contacts 20] [--seed 3000]

Solves random contacts of half spaces, where the closed forms are exact: conformity 0.505 to 0.6 and circles, Poisson
ratios 0 to 0.4999, unequal materials. Prints for each level of the mesh recipe the relative errors of the largest shear
and von Mises stress, the errors of their depths in minor semi-axes, and how often the intervals hold.
"""

from dataclasses import replace
from itertools import product
from typing import Annotated

import numpy as np
import typer
from rich.progress import track

from analytic.scene import Contact
from analytic.scenefile.read import load_scene
from fembearing.check.contact.scene_contact import contact_of
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.check.contact.subsurface import NAMES, compare_subsurface
from fembearing.fem.solution import solve_on_mesh
from fembearing.mesh.recipe import load_recipe
from validation.study import progress, run, show

LEVELS = (2, 3, 4)
TOLERANCE = 0.05


def main(
    contacts: Annotated[int, typer.Option(help="Random contacts; both bodies of each are compared.")] = 20,
    seed: Annotated[int, typer.Option(help="First seed.")] = 3000,
) -> None:
    recipe = load_recipe("hertzian")
    errors = {level: {name: [] for name in NAMES} for level in LEVELS}
    held = {level: dict.fromkeys(NAMES, 0) for level in LEVELS}
    for number in track(range(seed, seed + contacts), console=progress):
        contact = random_contact(np.random.default_rng(number))
        solution = compare_contact(contact, recipe=recipe, tolerance=TOLERANCE)
        axes = solution.meshes[-1].pair.semi_axes
        meshes = [solve_on_mesh(contact, recipe=recipe, level=level, semi_axes=axes) for level in (1, *LEVELS)]
        for finest, level in enumerate(LEVELS, start=1):
            add_errors(replace(solution, meshes=tuple(meshes[: finest + 1])), errors[level], held[level])
    heads = ("finest level", "quantity", "error, median", "error, worst", "interval holds")
    rows = []
    for level, name in product(LEVELS, NAMES):
        error = np.array(errors[level][name])
        holds = f"{held[level][name]} of {error.size}"
        rows.append((level, name.replace("_", " "), f"{np.median(error):.2%}", f"{error.max():.2%}", holds))
    show(heads, rows, f"{contacts} contacts, seeds {seed} to {seed + contacts - 1}")


def random_contact(rng: np.random.Generator) -> Contact:
    """Balls of the 6205 on other grooves, one in four on a spherical seat."""
    pair = "inner" if rng.random() < 0.5 else "outer"
    contact = contact_of(load_scene("6205-dry"), pair=pair, load=float(rng.uniform(50.0, 1000.0)))
    ball, race = (replace(contact.ball_material, poisson_ratio=float(ratio)) for ratio in rng.uniform(0, 0.4999, 2))
    race = replace(race, youngs_modulus=float(rng.uniform(60e9, 300e9)))
    contact = replace(contact, ball_material=ball, race_material=race)
    if rng.random() < 0.25:
        return replace(contact, groove_radius=1e9, rolling_radius=1e9)
    return replace(contact, groove_radius=2 * contact.ball_radius * float(rng.uniform(0.505, 0.6)))


def add_errors(solution: ContactSolution, errors: dict[str, list[float]], held: dict[str, int]) -> None:
    """Append the errors of both bodies and count the intervals that hold; depths in minor semi-axes."""
    hertz = solution.numbers.hertz
    minor = min(hertz.semi_axis_rolling, hertz.semi_axis_transverse)
    for side in ("upper", "lower"):
        stresses = compare_subsurface(solution, side=side)
        for name in NAMES:
            each = stresses.quantities[name]
            scale = minor if "depth" in name else each.production
            errors[name].append(abs(each.reference - each.production) / scale)
            held[name] += not each.resolved


if __name__ == "__main__":
    run(main)
