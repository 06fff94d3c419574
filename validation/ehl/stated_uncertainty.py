"""Whether the stated numerical uncertainty of a film holds: python validation/ehl/stated_uncertainty.py [--count N]

Contacts that no table has are solved on five grids. The 95 % interval that the first three state should hold the value
of the last three, two levels finer. Continues stated_uncertainty.csv, and prints the share.
"""

from collections.abc import Iterator
from itertools import islice
from pathlib import Path

import numpy as np

from analytic.errors import FembearingError
from fembearing.ehl.film import numerical_films
from validation.ehl.run import contact_of, fitted_draws
from validation.study import continued, numbers, out, run

TABLE = Path(__file__).parent / "stated_uncertainty.csv"
SEED = 78
COARSE = 0.38  # refinement of the first grid: four levels finer is near to the finest that the memory holds
QUANTITIES = "central_film", "minimum_film", "rolling_force"
NAMES = (
    *("number", "loading", "thickening", "ellipticity", "seconds", "finer_seconds"),
    *(f"{name}_{kind}" for name in QUANTITIES for kind in ("error", "stated")),
)


def compared(task: tuple[int, tuple[float, float, float]]) -> Iterator[dict[str, float]]:
    """Relative errors and stated uncertainties of a draw; empty where it has no five grids."""
    contact = contact_of(*task[1])
    assert contact is not None
    row = dict(zip(NAMES, (task[0], *task[1]), strict=False))
    try:
        coarse, _, fine = islice(numerical_films(contact, refinement=COARSE), 3)
    except (FembearingError, ValueError):  # ValueError: fewer than three
        yield row
        return
    row |= {"seconds": coarse.seconds, "finer_seconds": fine.seconds}
    for name in QUANTITIES:
        stated, true = getattr(coarse, name), getattr(fine, name)
        row |= {f"{name}_error": stated.value / true.value - 1, f"{name}_stated": stated.total}
    yield row


def main(count: int = 80) -> None:
    draws = {(str(number),): (number, draw) for number, draw in enumerate(fitted_draws(count, seed=SEED))}
    rows = [row for row in continued(TABLE, NAMES, draws, compared, form=".5g") if row["seconds"]]
    for name in QUANTITIES:
        inside = np.sum(np.abs(numbers(rows, f"{name}_error")) <= numbers(rows, f"{name}_stated"))
        out.print(f"{name.replace('_', ' ')}: {inside} of {len(rows)} inside; {count - len(rows)} have no five grids")


if __name__ == "__main__":
    run(main)
