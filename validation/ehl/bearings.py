"""The fit of production against solutions on true circles: python validation/ehl/bearings.py

Ten contacts of the built-in 6205, both races; writes bearings.csv.
"""

import csv
from dataclasses import replace
from pathlib import Path

from analytic.scenefile.read import load_scene
from analytic.words import RPM
from fembearing.check.film.scene_film import film_of

TABLE = Path(__file__).parent / "bearings.csv"
POINTS = ((30, 500, 0.0125), (372, 500, 0.0125), (372, 3000, 0.0125), (372, 500, 0.059), (1000, 500, 0.059))
TOLERANCE = 0.03  # of the solutions
HEAD = ("race", "load_N", "speed_rpm", "viscosity_Pa_s", "rolling_force_mN", "film_um")
ERRORS = ("force_formula", "force_model", "force_uncertainty", "film_formula", "film_model", "film_uncertainty")


def main() -> None:
    scene = load_scene("paper_6205")
    assert scene.lubricant is not None
    with TABLE.open("w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow((*HEAD, *ERRORS))
        for load, speed, viscosity in POINTS:
            oil = replace(scene.lubricant, viscosity=viscosity, reference_temperature=313.0, temperature=313.0)
            for race in ("inner", "outer"):
                found = film_of(
                    replace(scene, lubricant=oil),
                    pair=race,
                    load=float(load),
                    inner_speed=speed / RPM.factor,
                    tolerance=TOLERANCE,
                ).numbers
                force, film = (found.quantities[name] for name in ("rolling_force", "central_film"))
                errors = (
                    each
                    for part in (force, film)
                    for each in (part.formula / part.reference - 1, part.discrepancy, part.relative_uncertainty)
                )
                values = 1e3 * force.reference, 1e6 * film.reference
                row = (race, load, speed, viscosity, *(f"{each:.4g}" for each in values))
                writer.writerow((*row, *(f"{each:+.4f}" for each in errors)))
                file.flush()


if __name__ == "__main__":
    main()
