"""What half spaces leave out of film and friction: python validation/ehl/true_shapes.py

Film and rolling force of one contact, and the torque by sliding of a bearing, on half spaces and on ball and race of
true shape by finite elements; writes true_shapes.csv. Both are solved on the same grids, whose errors nearly cancel in
the difference; its own uncertainty is how much it changes between the two finest grids.
"""

import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from analytic.contact.geometry import RACES
from analytic.scene import Scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.words import RPM
from fembearing.check.creep.scene_creep import creep_of
from fembearing.check.film.scene_film import problem_of
from fembearing.ehl.contact import LubricatedContact
from fembearing.ehl.film import numerical_film
from fembearing.fem.compliance import meshed_pair
from fembearing.grid_convergence import Estimate
from validation.study import run, write

TABLE = Path(__file__).parent / "true_shapes.csv"
LOAD, SPEED, REFINEMENT = 372.0, 500 / RPM.factor, 0.63  # N, rad/s, of the first grid
HEAD = ("bearing", "race", "quantity", "half_spaces", "meshed", "change", "uncertainty", "s_half_spaces", "s_meshed")
FILM = ("central_film", "minimum_film", "rolling_force")
OF_A_RACE = ("spin_moment", "rolling_moment", "transverse_force", "slip_share")
ACCURACY = 2e-3  # of the torque by sliding
BEARINGS = ("6205", "7208B")
Row = dict[str, object]


def row_of(race: str, quantity: str, values: tuple[Estimate, Estimate], seconds: tuple[float, float]) -> Row:
    """One quantity in SI; values, seconds : on half spaces, and on meshed bodies."""
    *_, before, change = (new / old - 1 for old, new in zip(*(each.values for each in values), strict=True))
    cells = (*(each.value for each in values), f"{change:+.5f}", f"{abs(change - before):.5f}")
    return dict(zip(HEAD[1:], (race, quantity, *cells, *(f"{each:.1f}" for each in seconds)), strict=True))


def scene_of(bearing: str) -> Scene:
    """Thrust of 1000 N, a friction coefficient of 0.1, and the oil of the built-in scene."""
    dry = parse_scene(
        f'name = "{bearing}"\ntolerance = "0.5 %"\n[bearing]\ncatalog = "{bearing}"\n[operation]\n'
        'axial_load = "1000 N"\ninner_speed = "500 rpm"\n[friction]\ncoefficient = 0.1\n',
        origin=bearing,
    )
    return replace(dry, lubricant=load_scene("paper_6205").lubricant)


def films(scene: Scene) -> Iterator[Row]:
    for race in RACES:
        closed = problem_of(scene, race, load=LOAD, inner_speed=SPEED)
        begun = time.perf_counter()
        meshed: LubricatedContact = replace(closed.problem, added=meshed_pair(closed.contact))
        sampled = time.perf_counter() - begun
        plain, true = (numerical_film(each, refinement=REFINEMENT) for each in (closed.problem, meshed))
        for name in FILM:
            values = getattr(plain, name), getattr(true, name)
            yield row_of(race, name, values, (plain.seconds, true.seconds + sampled))


def frictions(scene: Scene) -> Iterator[Row]:
    dry = replace(scene, lubricant=None)
    creep_of(dry)  # formulas compile at their first call
    plain, true = (creep_of(dry, tolerance=ACCURACY, compliance=kind) for kind in ("half-space", "meshed"))
    seconds = plain.numbers.seconds, true.numbers.seconds
    for race in RACES:
        for name in OF_A_RACE:
            first, second = (getattr(getattr(each.reference, race), name) for each in (plain, true))
            yield row_of(race, name, (first, second), seconds)
    yield row_of("both", "torque of a ball by sliding", (plain.reference.torque, true.reference.torque), seconds)


def main() -> None:
    rows: list[Row] = []
    for bearing in BEARINGS:
        scene = scene_of(bearing)
        rows += [{"bearing": bearing, **row} for row in (*frictions(scene), *films(scene))]
        write(rows, TABLE, HEAD, form=".5g")


if __name__ == "__main__":
    run(main)
