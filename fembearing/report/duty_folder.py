"""What a duty cycle is written to: numbers, a table of the steps and the figure."""

from pathlib import Path

import numpy as np

from analytic.columns import COLUMNS, COORDINATES
from analytic.prediction.duty import DutyCycle
from analytic.scene import Scene
from analytic.standing import WorstStanding
from analytic.writing import write
from fembearing.csv_text import csv_of_columns
from fembearing.plain_types import json_of
from fembearing.provenance import provenance_of
from fembearing.quantities import SYSTEMS, unit_for

OF_STEP = ("duration", *COORDINATES, "temperature", "torque", "torque_low", "torque_high", "power", "energy")


def write_duty(cycle: DutyCycle, standing: WorstStanding, scene: Scene, folder: Path) -> None:
    """Write duty.json, duty.csv, duty.png and duty.svg into a folder."""
    from fembearing.report.figures.duty import duty_figure  # with matplotlib: only a figure pays for it
    from fembearing.report.figures.style import png, svg

    figure = duty_figure(cycle, SYSTEMS[scene.report.units])
    write(folder / "duty.json", json_of("duty", cycle, standing=standing, run=provenance_of(scene)))
    write(folder / "duty.csv", csv_of(cycle))
    write(folder / "duty.png", png(figure))
    write(folder / "duty.svg", svg(figure))


def csv_of(cycle: DutyCycle) -> str:
    """A line for each step."""
    rows = [
        vars(step) | {"torque": step.torque.value, "torque_low": step.torque.low, "torque_high": step.torque.high}
        for step in cycle.steps
    ]
    known = COORDINATES | COLUMNS
    columns = {name: np.array([row[name] for row in rows], dtype=float) for name in OF_STEP}
    shown = {name: (unit_for(known[name].unit, 0.0), values) for name, values in columns.items()}
    return csv_of_columns(shown, first={"step": range(1, len(rows) + 1)})
