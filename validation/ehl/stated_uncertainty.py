"""Whether the stated numerical uncertainty of a film holds: python validation/ehl/stated_uncertainty.py [--count N]

Contacts that no table has are solved on three grids, and again on three grids two levels finer. The stated 95 %
interval of the first should hold the value of the second. Continues stated_uncertainty.csv, and prints the share.
"""

import argparse
import csv
import time
from pathlib import Path

from rich.console import Console

from analytic.errors import ConvergenceError
from fembearing.ehl.film import RATIO, numerical_film
from validation.ehl.run import FITTED, contact_of, drawn

TABLE = Path(__file__).parent / "stated_uncertainty.csv"
SEED, COUNT = 77, 60
COARSE = 0.6  # refinement of the middle grid: two levels finer is near to the finest that the memory holds
QUANTITIES = "central_film", "minimum_film", "rolling_force"
NAMES = (
    "number", "loading", "thickening", "ellipticity", "seconds", "finer_seconds",
    *(f"{name}_{kind}" for name in QUANTITIES for kind in ("error", "stated")),
)  # fmt: skip


def compared(point: tuple[float, float, float]) -> dict[str, float] | None:
    """Relative errors and stated uncertainties; None where a grid does not settle."""
    contact = contact_of(*point)
    assert contact is not None
    try:
        begun = time.perf_counter()
        coarse = numerical_film(contact, refinement=COARSE)
        middle = time.perf_counter()
        fine = numerical_film(contact, refinement=COARSE * RATIO**2)
    except ConvergenceError:
        return None
    row = {"seconds": middle - begun, "finer_seconds": time.perf_counter() - middle}
    for name in QUANTITIES:
        stated, true = getattr(coarse, name), getattr(fine, name)
        row |= {f"{name}_error": stated.value / true.value - 1, f"{name}_stated": stated.total}
    return row


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--count", type=int, default=COUNT, help="contacts of the whole study")
    count = parser.parse_args().count
    lowest, highest = FITTED["loading"]
    points = [each for each in drawn(3 * count, seed=SEED) if lowest <= each[0] * each[2] ** 0.5 <= highest][:count]
    known = list(csv.DictReader(TABLE.open(newline=""))) if TABLE.exists() else []
    with TABLE.open("a", newline="") as file:
        writer = csv.DictWriter(file, NAMES)
        if not known:
            writer.writeheader()
        for number in range(len(known), count):
            point = tuple(points[number])
            row = dict(zip(NAMES, (number, *point), strict=False)) | (compared(point) or {})
            writer.writerow({name: f"{each:.5g}" for name, each in row.items()})
            file.flush()
    out = Console(highlight=False)
    rows = [row for row in csv.DictReader(TABLE.open(newline="")) if row["seconds"]]
    for name in QUANTITIES:
        inside = sum(abs(float(row[f"{name}_error"])) <= float(row[f"{name}_stated"]) for row in rows)
        out.print(f"{name.replace('_', ' ')}: {inside} of {len(rows)} inside; {count - len(rows)} did not settle")


if __name__ == "__main__":
    main()
