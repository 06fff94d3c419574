"""The interval to first order against samples: python validation/intervals/first_order.py [--scenes 25]
[--samples 1024] [--seed 900]

Random scenes, each drawn from its own seed: bearings like a 6205, dry or in oil, under thrust alone or with a radial
load, at one operating point. Both ends of the 95 % interval of the total by `first_order_ends`, which moves one input
at a time, are divided by those of Latin hypercube samples (`predict`), which know products of inputs. Samples know
their ends to a few per cent only; the program prints how well. Both rest on the same spreads: this tests a method of
propagation, not the spreads. It writes first_order.csv into this folder, a row for each scene.
"""

import argparse
from collections.abc import Sequence
from pathlib import Path
from time import perf_counter

import numpy as np
from rich.console import Console
from rich.table import Table

from analytic.errors import FembearingError
from analytic.prediction.first_order import first_order_ends
from analytic.prediction.prediction import predict
from analytic.scene import Array
from analytic.torque import friction_torque
from validation.benchmarks.random_scenes import random_scene
from validation.rows import Row, write

HERE = Path(__file__).parent
CLOSE = 0.1  # of an end
QUANTILES = (0.0, 0.1, 0.5, 0.9, 1.0)
COLUMNS = (
    "seed",
    "torque_N_mm",
    "low_ratio",
    "high_ratio",
    "low_error",
    "high_error",
    "first_s",
    "samples_s",
    "trouble",
)


def compared(seed: int, samples: int) -> Row:
    """Ends to first order over those of samples, the relative standard errors of these, and seconds of both."""
    try:
        scene = random_scene(np.random.default_rng(seed))
        nominal = friction_torque(scene)
        begun = perf_counter()
        ends = first_order_ends(scene, nominal)
        seconds = perf_counter() - begun
        if ends is None:
            return {"seed": str(seed), "trouble": "an input at its end leaves no torque"}
        total = predict(scene, samples=samples, workers=1)
    except FembearingError as problem:
        return {"seed": str(seed), "trouble": str(problem)}
    interval = total.total
    low, high = ends[:, 0] / (interval.low[0], interval.high[0])
    values = (1e3 * nominal.torque.total[0], low, high, interval.low_error[0] / interval.low[0],
              interval.high_error[0] / interval.high[0], seconds, total.seconds)  # fmt: skip
    return {"seed": str(seed), **{name: f"{each:.4g}" for name, each in zip(COLUMNS[1:-1], values, strict=True)}}


def report(rows: Sequence[Row], samples: int, out: Console) -> None:
    """Quantiles of the ratios, the share that is close, and the seconds."""
    solved = [row for row in rows if not row.get("trouble")]
    out.print(f"{len(solved)} of {len(rows)} random scenes have both intervals; {samples} samples each")
    for row in rows:
        if row.get("trouble"):
            out.print(f"seed {row['seed']}: {row['trouble']}", markup=False)
    table = Table("end", *(f"{100 * each:g} %" for each in QUANTILES), f"within {100 * CLOSE:g} %", "error of samples")
    for end in ("low", "high"):
        ratios, errors = column(solved, f"{end}_ratio"), column(solved, f"{end}_error")
        close = f"{np.sum(np.abs(ratios - 1) <= CLOSE)} of {ratios.size}"
        spread = (f"{each:.3f}" for each in np.quantile(ratios, QUANTILES))
        table.add_row(end, *spread, close, f"{100 * np.median(errors):.1f} % (median)")
    out.print(table)
    first, sampled = (np.median(column(solved, name)) for name in ("first_s", "samples_s"))
    out.print(f"seconds of a scene, median: {first:.2f} to first order, {sampled:.1f} by samples in one process")


def column(rows: Sequence[Row], name: str) -> Array:
    return np.array([float(row[name]) for row in rows])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--scenes", type=int, default=25, help="number of random scenes")
    parser.add_argument("--samples", type=int, default=1024, help="samples of each")
    parser.add_argument("--seed", type=int, default=900, help="of the first scene")
    parser.add_argument("--out", type=Path, default=HERE, help="folder of first_order.csv")
    given = parser.parse_args()
    out, rows = Console(width=120, highlight=False), []
    given.out.mkdir(parents=True, exist_ok=True)
    for seed in range(given.seed, given.seed + given.scenes):
        rows.append(compared(seed, given.samples))
        write(rows, given.out / "first_order.csv", COLUMNS)  # an interrupted run leaves those that are done
    report(rows, given.samples, out)


if __name__ == "__main__":
    main()
