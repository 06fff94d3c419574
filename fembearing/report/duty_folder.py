"""What a duty cycle is written to: numbers, a table of the steps and the figure."""

import csv
import json
from dataclasses import dataclass
from io import StringIO
from pathlib import Path
from typing import Literal

from analytic.prediction.duty import DutyCycle
from analytic.scene import Scene
from analytic.standing import WorstStanding
from analytic.writing import write
from fembearing.plain_types import plain
from fembearing.provenance import provenance_of
from fembearing.quantities import SYSTEMS, unit_for

KIND, FORMAT = "fembearing duty", 1  # what the JSON is; the number rises when a key changes its name or meaning
COLUMNS = {  # of a step, with the SI unit
    "duration": "s",
    "inner_speed": "rad/s",
    "axial_load": "N",
    "radial_load": "N",
    "moment": "N m",
    "temperature": "K",
    "torque": "N m",
    "torque_low": "N m",
    "torque_high": "N m",
    "power": "W",
    "energy": "J",
}


@dataclass(frozen=True, kw_only=True)
class DutyFile(DutyCycle):
    """What `duty --json` prints."""

    standing: WorstStanding  # how far the torques can be trusted
    kind: Literal["fembearing duty"] = KIND
    format: Literal[1] = FORMAT


def duty_file(cycle: DutyCycle, standing: WorstStanding) -> DutyFile:
    """The cycle with its standing, kind and format."""
    return DutyFile(**vars(cycle), standing=standing)


def write_duty(cycle: DutyCycle, standing: WorstStanding, scene: Scene, folder: Path) -> None:
    """Write duty.json, duty.csv, duty.png and duty.svg into a folder."""
    from fembearing.report.figures.duty import duty_figure  # with matplotlib: only a figure pays for it
    from fembearing.report.figures.style import png, svg

    figure = duty_figure(cycle, SYSTEMS[scene.report.units])
    content = plain(duty_file(cycle, standing)) | {"run": plain(provenance_of(scene))}
    write(folder / "duty.json", json.dumps(content, indent=1, allow_nan=False))
    write(folder / "duty.csv", csv_of(cycle))
    write(folder / "duty.png", png(figure))
    write(folder / "duty.svg", svg(figure))


def csv_of(cycle: DutyCycle) -> str:
    """A line for each step, to 15 digits; heads have the unit in brackets. A cell is empty where nothing is known."""
    units = {name: unit_for(unit, 0.0) for name, unit in COLUMNS.items()}
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(["step", *(f"{name} [{unit.name}]" for name, unit in units.items())])
    for number, step in enumerate(cycle.steps, start=1):
        torque = step.torque
        values = vars(step) | {"torque": torque.value, "torque_low": torque.low, "torque_high": torque.high}
        cells = ("" if values[name] is None else f"{unit.number(values[name]):.15g}" for name, unit in units.items())
        writer.writerow([number, *cells])
    return text.getvalue()
