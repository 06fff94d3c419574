"""The interval to first order against samples: python validation/intervals/first_order.py [--scenes 25]
[--samples 1024] [--seed 900]

Random scenes, each drawn from its own seed: bearings like a 6205, dry or in oil, under thrust alone or with a radial
load, at one operating point. Both ends of the 95 % interval of the total by `first_order_ends`, which moves one input
at a time, are divided by those of Latin hypercube samples (`predict`), which know products of inputs. Samples know
their ends to a few per cent only; the program prints how well. Both rest on the same spreads: this tests a method of
propagation, not the spreads. It writes first_order.csv into this folder, a row for each scene.
"""

from pathlib import Path
from time import perf_counter
from typing import Annotated

import numpy as np
import typer

from analytic.errors import FembearingError
from analytic.prediction.first_order import first_order_ends
from analytic.prediction.prediction import predict
from analytic.torque import friction_torque
from validation.benchmarks.random_scenes import random_scene
from validation.study import Out, Row, numbers, out, run, show, write

HERE = Path(__file__).parent
CLOSE = 0.1  # of an end
QUANTILES = (0.0, 0.1, 0.5, 0.9, 1.0)
COLUMNS = (
    *("seed", "torque_N_mm", "low_ratio", "high_ratio", "low_error", "high_error"),
    *("first_s", "samples_s", "trouble"),
)


def compared(seed: int, samples: int) -> Row:
    """Ends to first order over those of samples, the relative standard errors of these, and seconds of both."""
    row = {"seed": str(seed)}
    try:
        scene = random_scene(np.random.default_rng(seed))
        nominal = friction_torque(scene)
        begun = perf_counter()
        ends = first_order_ends(scene, nominal)
        seconds = perf_counter() - begun
        if ends is None:
            return row | {"trouble": "an input at its end leaves no torque"}
        found = predict(scene, samples=samples, workers=1)
    except FembearingError as problem:
        return row | {"trouble": str(problem)}
    low, high, total = found.total.low[0], found.total.high[0], 1e3 * nominal.torque.total[0]
    errors = found.total.low_error[0] / low, found.total.high_error[0] / high
    values = (total, ends[0, 0] / low, ends[1, 0] / high, *errors, seconds, found.seconds)
    return row | {name: f"{each:.4g}" for name, each in zip(COLUMNS[1:-1], values, strict=True)}


def report(rows: list[Row], samples: int) -> None:
    """Quantiles of the ratios, the share that is close, and the seconds."""
    solved = [row for row in rows if not row.get("trouble")]
    out.print(f"{len(solved)} of {len(rows)} random scenes have both intervals; {samples} samples each")
    for row in rows:
        if row.get("trouble"):
            out.print(f"seed {row['seed']}: {row['trouble']}")
    found = []
    for end in ("low", "high"):
        ratios, errors = numbers(solved, f"{end}_ratio"), numbers(solved, f"{end}_error")
        close = f"{np.sum(np.abs(ratios - 1) <= CLOSE)} of {ratios.size}"
        spread = (f"{each:.3f}" for each in np.quantile(ratios, QUANTILES))
        found.append((end, *spread, close, f"{100 * np.median(errors):.1f} % (median)"))
    show(("end", *(f"{each:.0%}" for each in QUANTILES), f"within {CLOSE:.0%}", "error of samples"), found)
    first, sampled = (np.median(numbers(solved, name)) for name in ("first_s", "samples_s"))
    out.print(f"seconds of a scene, median: {first:.2f} to first order, {sampled:.1f} by samples in one process")


def main(
    scenes: Annotated[int, typer.Option(help="Number of random scenes.")] = 25,
    samples: Annotated[int, typer.Option(help="Samples of each.")] = 1024,
    seed: Annotated[int, typer.Option(help="Of the first scene.")] = 900,
    folder: Out = HERE,
) -> None:
    rows = []
    for number in range(seed, seed + scenes):
        rows.append(compared(number, samples))
        write(rows, folder / "first_order.csv", COLUMNS)  # an interrupted run leaves those that are done
    report(rows, samples)


if __name__ == "__main__":
    run(main)
