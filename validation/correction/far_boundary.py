"""What lies beyond the block of a race: python validation/correction/far_boundary.py [--contacts 45] [--seed 300]

Random contacts of true shape are solved by the compliance of the pair on the second level, on the block of the recipe
and on blocks 2, 4 and 8 times as large, as far as the ring is large enough to be meshed. The table has the change of
each quantity from the first block. Semi-axes and pressure approach a limit; the approach changes with the logarithm of
the size until the block is as large as the ball, and is therefore defined as that of the block twice as large. The
powers in `fembearing.check.contact.meshed_region` were chosen on seeds 300 to 344. Takes four minutes.
"""

from typing import Annotated

import typer
from rich.progress import track

from analytic.errors import FembearingError
from analytic.scene import Contact
from fembearing.check.contact.reference import OnLevel, on_level
from fembearing.check.contact.refinement import COMPARED
from fembearing.fem.guess import expected_semi_axes
from fembearing.fem.measure import Quantities
from fembearing.fem.pixel_contact import press_pair
from fembearing.mesh import race
from fembearing.mesh.recipe import load_recipe
from validation.intervals.levels import random_contact
from validation.study import progress, run, show

RECIPE, TIMES = load_recipe("race"), (2.0, 4.0, 8.0)


def main(
    contacts: Annotated[int, typer.Option(help="Number of contacts.")] = 45,
    first: Annotated[int, typer.Option("--seed", help="First seed.")] = 300,
) -> None:
    rows = []
    for seed in track(range(first, first + contacts), console=progress):
        contact = random_contact(seed)
        try:
            shape, changes = changes_with_size(contact)
        except FembearingError as problem:
            shape, changes = ("", ""), [str(problem)[:40]]
        rows.append((seed, contact.pair, *shape, *changes))
    heads = ("seed", "pair", "b/r", "groove/block", *(f"{times:g} times" for times in TIMES))
    show(heads, rows, "change of a, b, peak pressure and approach, 1e-5")


def changes_with_size(contact: Contact) -> tuple[tuple[str, str], list[str]]:
    """b/r and the groove's radius over the size of the block; the changes with each larger block, as words."""
    axes = expected_semi_axes(contact, geometry="real")
    for level in RECIPE.levels[:2]:
        own = on_level([contact], [axes], recipe=RECIPE, level=level)
        (axes,) = own.ellipses()
    (bodies,), before = own.bodies, quantities(own, contact)
    size = float(bodies.pair.lower.mesh.doflocs[0].max())
    shape = f"{max(axes) / contact.ball_radius:.3f}", f"{contact.groove_radius / size:.2f}"
    widest = race.WIDEST_BLOCK * abs(contact.rolling_radius) / size
    kept, words = race.FURTHER, []
    try:
        for times in TIMES:
            if times > max(widest, race.LEAST_FURTHER):
                break
            race.FURTHER = times
            larger = on_level(
                [contact], [bodies.pair.semi_axes], recipe=RECIPE, level=bodies.level, extended=True, known=own
            )
            after = quantities(larger, contact)
            changes = (1e5 * (getattr(after, name) / getattr(before, name) - 1) for name in COMPARED)
            words.append(", ".join(f"{change:.1f}" for change in changes))
    except FembearingError as problem:
        words.append(str(problem)[:40])
    finally:
        race.FURTHER = kept
    return shape, words


def quantities(on: OnLevel, contact: Contact) -> Quantities:
    return press_pair(on.compliance.at(contact.load), load=contact.load).quantities


if __name__ == "__main__":
    run(main)
