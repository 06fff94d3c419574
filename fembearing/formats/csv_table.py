"""The torque map as CSV: a row for each point, units in the heads of the columns, in units that people use."""

from pathlib import Path

import numpy as np

from analytic.progress import Progress
from analytic.scenefile.read import SceneByTemperature
from analytic.words import NEWTON_MILLIMETRE
from fembearing.csv_text import csv_of_columns
from fembearing.formats.axes import SHOWN, Axes
from fembearing.formats.torque_map import OF_OPERATION, mapped_torque

TORQUES = ("torque_low", "torque", "torque_high")  # in the order of a map


def write_csv(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write the map, 15 digits a number; speed varies slowest."""
    found = mapped_torque(given, axes, progress=progress)
    points = np.meshgrid(*axes.values(), indexing="ij")
    columns = {
        OF_OPERATION.get(name, name): (SHOWN[name], each.ravel()) for name, each in zip(axes, points, strict=True)
    }
    columns |= {name: (NEWTON_MILLIMETRE, each.ravel()) for name, each in zip(TORQUES, found.torque, strict=True)}
    file.write_text(csv_of_columns(columns), "utf-8", newline="")
    return ()
