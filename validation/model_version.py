"""The torque of every shipped scene, old and new: python validation/model_version.py [--write]

The table validation/model_version.csv holds the torques of one model version. It detects that a formula changed
a torque; it is our own output and validates nothing. Whoever changes a torque raises MODEL_VERSION in
analytic/torque.py, copies the table that this program prints into CHANGELOG.md, and runs it with --write.
"""

import argparse
import csv
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from rich.console import Console

from analytic import catalog
from analytic.scenefile.read import load_scene
from analytic.torque import MODEL_VERSION, friction_torque
from analytic.words import RPM

SCENES = Path(__file__).parent / "scenes"
STORED = Path(__file__).with_name("model_version.csv")
HEAD = ("model_version", "scene", "inner_speed_rad_s", "total_N_m")


class Row(NamedTuple):
    """One operating point of one scene."""

    version: int
    scene: str
    inner_speed: float  # rad/s
    total: float  # N m


def computed() -> Iterator[Row]:
    """The torques of this version."""
    for name in (*catalog.names("scenes"), *sorted(str(p) for p in SCENES.glob("*.toml"))):
        friction = friction_torque(load_scene(name))
        for speed, total in zip(friction.inner_speed.tolist(), friction.torque.total.tolist(), strict=True):
            yield Row(MODEL_VERSION, Path(name).stem, speed, total)


def stored() -> list[Row]:
    """The torques of the table."""
    with STORED.open(encoding="utf-8", newline="") as file:
        rows = csv.reader(line for line in file if not line.startswith("#"))
        next(rows)
        return [Row(int(version), scene, float(speed), float(total)) for version, scene, speed, total in rows]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true", help="store the torques of this version")
    write = parser.parse_args().write
    before = {(row.scene, row.inner_speed): row for row in (stored() if STORED.exists() else [])}
    rows = list(computed())
    out = Console(highlight=False, soft_wrap=True, markup=False)
    out.print(f"| scene | speed, rpm | old, N mm | new, N mm (model version {MODEL_VERSION}) | change |")
    out.print("| --- | --- | --- | --- | --- |")
    for row in rows:
        old = before.get((row.scene, row.inner_speed))
        was = "-" if old is None else f"{old.total * 1e3:.5g} (version {old.version})"
        change = "-" if old is None else f"{row.total / old.total - 1:+.2%}"
        out.print(f"| {row.scene} | {row.inner_speed * RPM.factor:.5g} | {was} | {row.total * 1e3:.5g} | {change} |")
    if write:
        with STORED.open("w", encoding="utf-8", newline="") as file:
            file.write("# A detector of changes, our own output: see validation/model_version.py, which writes it.\n")
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(HEAD)
            writer.writerows((row.version, row.scene, repr(row.inner_speed), repr(row.total)) for row in rows)


if __name__ == "__main__":
    main()
