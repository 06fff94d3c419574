"""Whether the stated numerical uncertainty of a film holds: python validation/ehl/stated_uncertainty.py [--count N]

Contacts that no table has are solved on three grids, and again on three grids two levels finer. The stated 95 %
interval of the first should hold the value of the second. Continues stated_uncertainty.csv, and prints the share.
"""

import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from analytic.errors import ConvergenceError
from fembearing.ehl.film import RATIO, numerical_film
from validation.ehl.run import contact_of, fitted_draws
from validation.study import continued, numbers, out, run

TABLE = Path(__file__).parent / "stated_uncertainty.csv"
SEED = 77
COARSE = 0.6  # refinement of the middle grid: two levels finer is near to the finest that the memory holds
QUANTITIES = "central_film", "minimum_film", "rolling_force"
NAMES = (
    *("number", "loading", "thickening", "ellipticity", "seconds", "finer_seconds"),
    *(f"{name}_{kind}" for name in QUANTITIES for kind in ("error", "stated")),
)


def compared(task: tuple[int, tuple[float, float, float]]) -> Iterator[dict[str, float]]:
    """Relative errors and stated uncertainties of a draw; empty where a grid does not settle."""
    contact = contact_of(*task[1])
    assert contact is not None
    row = dict(zip(NAMES, (task[0], *task[1]), strict=False))
    try:
        begun = time.perf_counter()
        coarse = numerical_film(contact, refinement=COARSE)
        middle = time.perf_counter()
        fine = numerical_film(contact, refinement=COARSE * RATIO**2)
    except ConvergenceError:
        yield row
        return
    row |= {"seconds": middle - begun, "finer_seconds": time.perf_counter() - middle}
    for name in QUANTITIES:
        stated, true = getattr(coarse, name), getattr(fine, name)
        row |= {f"{name}_error": stated.value / true.value - 1, f"{name}_stated": stated.total}
    yield row


def main(count: int = 60) -> None:
    draws = {(str(number),): (number, draw) for number, draw in enumerate(fitted_draws(count, seed=SEED))}
    rows = [row for row in continued(TABLE, NAMES, draws, compared, form=".5g") if row["seconds"]]
    for name in QUANTITIES:
        inside = np.sum(np.abs(numbers(rows, f"{name}_error")) <= numbers(rows, f"{name}_stated"))
        out.print(f"{name.replace('_', ' ')}: {inside} of {len(rows)} inside; {count - len(rows)} did not settle")


if __name__ == "__main__":
    run(main)
