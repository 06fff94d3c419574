"""Closed kinematics beside free balls:  python validation/kinematics/run.py [--scenes 300] [--seed 50000]

Torque of ordinary scenes with `spin_rule = "balanced"`, whose balls turn by closed kinematics, over that of free balls,
the default. Draws bearings of the catalogue under thrust, radial or both loads, 0.6 to 25 % of the static load rating,
at 100 to 12 000 rpm, half of them with ISO VG 32 at 60 degC and half dry with a friction coefficient of 0.1. Prints a
table of the ratio by group of bearings and kind of load, and writes kinematics.csv beside this file. Model against
model: this says how far a choice matters, not which one is right.
"""

import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # before numpy loads its threads

import re
import time
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import numpy as np
import typer
from rich.progress import track

from analytic import friction_torque
from analytic.catalog.bearing_rows import find_bearing
from analytic.errors import FembearingError
from analytic.scenefile.read import parse_scene
from validation.study import Out, Row, markdown, numbers, out, progress, run, write

HERE = Path(__file__).parent
GROUPS = {
    "608": ("608",),
    "6205 to 6210": tuple(f"62{size:02d}" for size in range(5, 11)),
    "6308": ("6308",),
    "7208B": ("7208B",),
}
OIL = '[lubricant]\nname = "ISO VG 32"\ntemperature = "60 degC"\n[surface]\nfinish = "ground and honed"\n[friction]\n'
DRY = "[friction]\ncoefficient = 0.1\n"
LINE = 100  # characters of a reason
LOADS = ("thrust", "radial", "both")
COLUMNS = ("seed", "group", "bearing", "loads", "oil", "axial_N", "radial_N", "rpm", "ratio", "free_s", "closed_s",
           "failure")  # fmt: skip


def drawn_row(seed: int) -> Row:
    """One scene both ways."""
    rng = np.random.default_rng(seed)
    group = str(rng.choice(list(GROUPS)))
    name, oil = str(rng.choice(GROUPS[group])), bool(rng.random() < 0.5)
    kind = str(rng.choice(("thrust", "both") if name == "7208B" else LOADS))  # it slides apart under a radial load
    rating = find_bearing(name).static_load_rating
    load, rpm = rating * 10 ** rng.uniform(np.log10(0.006), np.log10(0.25)), 10 ** rng.uniform(2, np.log10(12_000))
    angle = {"thrust": np.pi / 2, "radial": 0.0, "both": rng.uniform(0.2, 1.2)}[kind]
    axial, radial = load * np.sin(angle), load * np.cos(angle) * (kind != "thrust")
    row = {"seed": str(seed), "group": group, "bearing": name, "loads": kind, "oil": "VG 32" if oil else "dry"}
    row |= {"axial_N": f"{axial:.5g}", "radial_N": f"{radial:.5g}", "rpm": f"{rpm:.5g}"}
    torque, seconds = {}, {}
    for rule in ("free", "balanced"):
        scene = parse_scene(
            f'name = "{name}"\ntolerance = "1 %"\n[bearing]\ncatalog = "{name}"\n[operation]\n'
            f'axial_load = "{axial} N"\nradial_load = "{radial} N"\ninner_speed = "{rpm} rpm"\n'
            f'{OIL if oil else DRY}spin_rule = "{rule}"\n',
            origin=f"seed {seed}",
        )
        begun = time.process_time()
        try:
            torque[rule] = float(friction_torque(scene).torque.total[0])
        except FembearingError as problem:
            return row | {"failure": f"{rule}: {problem}"}
        seconds[rule] = f"{time.process_time() - begun:.3g}"
    ratio = f"{torque['balanced'] / torque['free']:.5g}"
    return row | {"ratio": ratio, "free_s": seconds["free"], "closed_s": seconds["balanced"]}


def groups(rows: list[Row]) -> Iterator[tuple[object, ...]]:
    """Differences of closed kinematics from free balls, by group of bearings and kind of load."""
    solved = [row for row in rows if "ratio" in row]
    for group in (*GROUPS, "all"):
        for kind in ("all",) if group == "all" else LOADS:
            some = [row for row in solved if group in (row["group"], "all") and kind in (row["loads"], "all")]
            if not some:
                continue
            change = 100 * (numbers(some, "ratio") - 1)
            ends = (*np.quantile(change, (0.05, 0.5, 0.95)), change[np.abs(change).argmax()])
            times = (f"{np.median(numbers(some, key)):.2g}" for key in ("free_s", "closed_s"))
            yield group, kind, len(some), *(f"{value:+.1f} %" for value in ends), *times


def main(
    scenes: Annotated[int, typer.Option(min=1, help="Scenes to draw.")] = 300,
    seed: Annotated[int, typer.Option(help="Of the first scene.")] = 50000,
    folder: Out = HERE,
) -> None:
    """Compare both, and print the table."""
    drawn_row(seed)  # compiles
    rows = [drawn_row(each) for each in track(range(seed, seed + scenes), console=progress)]
    write(rows, folder / "kinematics.csv", COLUMNS)
    heads = ("bearing", "loads", "scenes", "5 %", "median", "95 %", "extreme", "free balls, s", "closed, s")
    for line in markdown(heads, groups(rows)):
        out.print(line)
    failures = Counter(re.sub(r"[0-9.]+", "#", row["failure"])[:LINE] for row in rows if row.get("failure"))
    for failure, count in failures.most_common():
        out.print(f"{count} without a torque: {failure}")


if __name__ == "__main__":
    run(main)
