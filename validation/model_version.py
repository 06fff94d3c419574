"""The torque of every shipped scene, old and new: python validation/model_version.py [--write]

The table validation/model_version.csv holds the torques of one model version. It detects that a formula changed
a torque; it is our own output and validates nothing. Whoever changes a torque raises MODEL_VERSION in
analytic/torque.py, copies the table that this program prints into CHANGELOG.md, and runs it with --write.
"""

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, NamedTuple

import typer

from analytic import catalog
from analytic.scenefile.read import load_scene
from analytic.torque import MODEL_VERSION, friction_torque
from analytic.words import RPM
from validation.study import SCENES, markdown, out, read, run, write

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
    rows = ([row[name] for name in HEAD] for row in read(STORED))
    return [Row(int(version), scene, float(speed), float(total)) for version, scene, speed, total in rows]


def main(store: Annotated[bool, typer.Option("--write", help="Store the torques of this version.")] = False) -> None:
    before = {(row.scene, row.inner_speed): row for row in stored()}
    rows, shown = list(computed()), []
    for row in rows:
        old = before.get((row.scene, row.inner_speed))
        was = "-" if old is None else f"{old.total * 1e3:.5g} (version {old.version})"
        change = "-" if old is None else f"{row.total / old.total - 1:+.2%}"
        shown.append((row.scene, f"{row.inner_speed * RPM.factor:.5g}", was, f"{row.total * 1e3:.5g}", change))
    new = f"new, N mm (model version {MODEL_VERSION})"
    for line in markdown(("scene", "speed, rpm", "old, N mm", new, "change"), shown):
        out.print(line, soft_wrap=True)
    if store:
        about = ("A detector of changes, our own output: see validation/model_version.py, which writes it.",)
        write((dict(zip(HEAD, row, strict=True)) for row in rows), STORED, HEAD, about=about, form="")


if __name__ == "__main__":
    run(main)
