"""Do the intervals hold? python validation/benchmarks/coverage.py [--ideal 100] [--real 30] [--seed 8000]

Solves random contacts to an asked accuracy and compares each quantity with its true value: on the Hertzian idealisation
Hertz's, exactly; on true shapes that of a finer solution on a block twice as wide. Prints, for each quantity, how often
the 95 % interval holds the true value, and the median of half-width over true error. Seeds 0 to 59,
1000 to 1099, 5000 to 5019 and 7000 to 7099 were used to choose the factors of `fembearing.compare.uncertainty`; any
others are a test of them.
"""

import time
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
import typer
from rich.console import Console
from rich.progress import track
from rich.table import Table

from analytic.scene import Contact, Material, Pair
from fembearing.compare.discrepancy import hertz_quantities
from fembearing.compare.progress import silent
from fembearing.compare.reference import FORMAL_ORDERS, estimates_of, solve_reference
from fembearing.fem.solution import fitted_solution, solve_on_mesh
from fembearing.mesh.recipe import Recipe, load_recipe

ACCURACY = 2e-3
MATERIALS = [
    Material(name=name, youngs_modulus=modulus, poisson_ratio=ratio, density=1.0, source="typical")
    for name, modulus, ratio in (
        ("steel", 206e9, 0.3),
        ("silicon nitride", 310e9, 0.26),
        ("bronze", 110e9, 0.34),
        ("peek", 3.6e9, 0.38),
    )
]
out = Console(width=100)


@dataclass(frozen=True)
class Trial:
    """One quantity of one contact; relative."""

    error: float
    uncertainty: float


def main(
    ideal: Annotated[int, typer.Option(help="Random contacts of half spaces.")] = 100,
    real: Annotated[int, typer.Option(help="Random contacts of true shapes.")] = 30,
    seed: Annotated[int, typer.Option(help="First seed.")] = 8000,
) -> None:
    for count, name in ((ideal, "hertzian"), (real, "race")):
        if count == 0:
            continue
        recipe = load_recipe(name)
        trials: dict[str, list[Trial]] = {quantity: [] for quantity in FORMAL_ORDERS}
        seconds = []
        for number in track(range(seed, seed + count), description=name, console=Console(stderr=True)):
            contact = random_contact(np.random.default_rng(number))
            start = time.perf_counter()
            found = solve_reference(contact, recipe=recipe, accuracy=ACCURACY, progress=silent).estimates
            seconds.append(time.perf_counter() - start)
            truth = vars(hertz_quantities(contact)) if name == "hertzian" else finer(contact, recipe)
            for quantity, part in found.items():
                trials[quantity].append(Trial(error=abs(part.value / truth[quantity] - 1), uncertainty=part.total))
        show(name, trials, first=seed, seconds=seconds)


def random_contact(rng: np.random.Generator) -> Contact:
    """A quarter of pockets, the rest races; conformity 0.5025 to 0.6, semi-axes up to a fifth of the ball's radius."""
    radius = 10 ** rng.uniform(-3, np.log10(0.02))
    groove = 2 * radius * (0.5025 + 0.0975 * rng.random() ** 2)
    angle = rng.uniform(0, 0.7)
    ring = radius / rng.uniform(0.06, 0.35) / np.cos(angle)  # half the pitch diameter over the cosine
    pair: Pair = "inner" if rng.random() < 0.5 else "outer"
    rolling = ring - radius if pair == "inner" else -ring - radius
    if rng.random() < 0.25:
        pair, rolling, angle = "pocket", -groove * rng.uniform(1.0, 1.5), 0.0
    ball, race = (MATERIALS[number] for number in rng.choice(4, 2, p=[0.5, 0.2, 0.15, 0.15]))
    contact = Contact(
        pair=pair,
        ball_radius=radius,
        groove_radius=groove,
        rolling_radius=rolling,
        shoulder=0.95 * groove,
        contact_angle=angle,
        load=1.0,
        ball_material=ball,
        race_material=race,
    )
    unit = hertz_quantities(contact)
    size = 10 ** rng.uniform(-4, np.log10(0.2)) * radius
    return replace(contact, load=float((size / max(unit.semi_axis_rolling, unit.semi_axis_transverse)) ** 3))


def finer(contact: Contact, recipe: Recipe) -> dict[str, float]:
    """Levels 2, 3 and 4 extrapolated, on a block twice as wide with cells in proportion."""
    wide = replace(
        recipe,
        domain=replace(recipe.domain, extent=2 * recipe.domain.extent),
        cells=replace(recipe.cells, outside=recipe.cells.outside + 1, depth=recipe.cells.depth + 1),
    )
    semi_axes = fitted_solution(contact, recipe=recipe).pair.semi_axes
    meshes = [solve_on_mesh(contact, recipe=wide, level=level, semi_axes=semi_axes) for level in (2, 3, 4)]
    return {name: part.value for name, part in estimates_of(meshes).items()}


def show(name: str, trials: dict[str, list[Trial]], *, first: int, seconds: list[float]) -> None:
    count = len(seconds)
    table = Table(title=f"{name}: {count} contacts, seeds {first} to {first + count - 1}, accuracy {ACCURACY:g}")
    for head in ("quantity", "interval holds", "half-width/error, median", "error, median", "error, worst"):
        table.add_column(head, justify="right" if head != "quantity" else "left")
    for quantity, found in trials.items():
        error, width = np.array([(each.error, each.uncertainty) for each in found]).T
        table.add_row(
            quantity,
            f"{np.count_nonzero(error <= width)} of {count}",
            f"{np.median(width / error):.1f}",
            f"{np.median(error):.3%}",
            f"{error.max():.3%}",
        )
    out.print(table)
    out.print(f"{np.median(seconds):.1f} s a contact, median\n")


if __name__ == "__main__":
    typer.run(main)
