"""The fit of production against solutions on true circles: python validation/ehl/bearings.py

Ten contacts of the built-in 6205, both races; writes bearings.csv.
"""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from analytic.contact.geometry import RACES
from analytic.scenefile.read import load_scene
from analytic.words import RPM
from fembearing.check.film.scene_film import film_of
from validation.study import run, write

TABLE = Path(__file__).parent / "bearings.csv"
POINTS = ((30, 500, 0.0125), (372, 500, 0.0125), (372, 3000, 0.0125), (372, 500, 0.059), (1000, 500, 0.059))
TOLERANCE = 0.03  # of the solutions
HEAD = ("race", "load_N", "speed_rpm", "viscosity_Pa_s", "rolling_force_mN", "film_um")


def compared(load: float, speed: float, viscosity: float) -> Iterator[dict[str, object]]:
    """Both races under a load, N, at a speed, rpm, in an oil, Pa s; errors are relative."""
    scene = load_scene("paper_6205")
    oil = replace(scene.lubricant, viscosity=viscosity, reference_temperature=313.0, temperature=313.0)
    for race in RACES:
        found = film_of(
            replace(scene, lubricant=oil),
            pair=race,
            load=float(load),
            inner_speed=speed / RPM.factor,
            tolerance=TOLERANCE,
        ).numbers
        force, film = (found.quantities[name] for name in ("rolling_force", "central_film"))
        values = 1e3 * force.reference, 1e6 * film.reference
        row = dict(zip(HEAD, (race, load, speed, viscosity, *values), strict=True))
        for name, part in (("force", force), ("film", film)):
            errors = part.formula / part.reference - 1, part.discrepancy, part.relative_uncertainty
            row |= {
                f"{name}_{of}": f"{each:+.4f}"
                for of, each in zip(("formula", "model", "uncertainty"), errors, strict=True)
            }
        yield row


def main() -> None:
    rows = []
    for point in POINTS:
        rows += compared(*point)
        write(rows, TABLE, list(rows[0]), form=".4g")


if __name__ == "__main__":
    run(main)
