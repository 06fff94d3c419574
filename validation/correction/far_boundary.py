"""What lies beyond the block of a race: python validation/correction/far_boundary.py [--contacts 45] [--seed 300]

Random contacts of true shape are solved on the second level, each with its twin, on the block of the recipe and on
blocks 2, 4 and 8 times as large, as far as the ring is large enough to be meshed. The table has the change of each
quantity from the first block. Semi-axes and pressure approach a limit; the approach changes with the logarithm of the
size until the block is as large as the ball, and is therefore defined as that of the block twice as large. The powers
in `fembearing.check.contact.meshed_region` were chosen on seeds 300 to 344. Takes four minutes.
"""

import argparse

from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic.errors import FembearingError
from analytic.scene import Contact
from fembearing.check.contact.refinement import COMPARED
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.solution import solve_on_mesh
from fembearing.fem.twin import TwinSolution, twin_factors, twin_on_level
from fembearing.mesh import race
from fembearing.mesh.recipe import load_recipe
from validation.intervals.twin import random_contact

RECIPE, TIMES = load_recipe("race"), (2.0, 4.0, 8.0)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--contacts", type=int, default=45, help="number of contacts")
    parser.add_argument("--seed", type=int, default=300, help="first seed")
    given = parser.parse_args()
    table = Table("seed", "pair", "b/r", "groove/block", *(f"{times:g} times" for times in TIMES))
    table.title = "change of a, b, peak pressure and approach, 1e-5"
    for seed in track(range(given.seed, given.seed + given.contacts), console=Console(stderr=True)):
        contact = random_contact(seed)
        try:
            shape, changes = changes_with_size(contact)
        except FembearingError as problem:
            shape, changes = ("", ""), [str(problem)[:40]]
        table.add_row(str(seed), contact.pair, *shape, *changes)
    Console(width=170).print(table)


def changes_with_size(contact: Contact) -> tuple[tuple[str, str], list[str]]:
    """b/r and the groove's radius over the size of the block; the changes with each larger block, as words."""
    solution = None
    start = expected_semi_axes(contact, geometry="real")
    for level in RECIPE.levels[:2]:
        solution = twin_on_level(contact, recipe=RECIPE, level=level, start=start)
        if solution is None:
            return ("", ""), ["no twin"]
        start = solution.ellipse
    mesh = solution.mesh
    size = float(mesh.pair.lower.mesh.doflocs[0].max())
    shape = f"{max(mesh.pair.semi_axes) / contact.ball_radius:.3f}", f"{contact.groove_radius / size:.2f}"
    widest = race.WIDEST_BLOCK * abs(contact.rolling_radius) / size
    kept, words = race.FURTHER, []
    try:
        for times in TIMES:
            if times > max(widest, race.LEAST_FURTHER):
                break
            race.FURTHER = times
            larger = solve_on_mesh(
                mesh.contact,
                recipe=RECIPE,
                level=mesh.level,
                semi_axes=mesh.pair.semi_axes,
                extended=True,
                upper=mesh.upper,
            )
            after = TwinSolution(mesh=larger, factors=twin_factors(larger, recipe=RECIPE, extended=True)).corrected
            changes = (1e5 * (after[name] / solution.corrected[name] - 1) for name in COMPARED)
            words.append(", ".join(f"{change:.1f}" for change in changes))
    except FembearingError as problem:
        words.append(str(problem)[:40])
    finally:
        race.FURTHER = kept
    return shape, words


if __name__ == "__main__":
    main()
