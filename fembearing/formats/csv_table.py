"""The torque map as CSV: a row for each point, units in the heads of the columns, in units that people use."""

import csv
from pathlib import Path

import numpy as np

from analytic.progress import Progress
from analytic.scenefile.by_temperature import SceneByTemperature
from analytic.words import NEWTON_MILLIMETRE
from fembearing.formats.axes import SHOWN, Axes
from fembearing.formats.torque_map import OF_OPERATION, mapped_torque

TORQUES = ("torque_low", "torque", "torque_high")  # in the order of a map


def write_csv(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write the map, 15 digits a number; speed varies slowest."""
    found = mapped_torque(given, axes, progress=progress)
    points = np.meshgrid(*(SHOWN[name].number(values) for name, values in axes.items()), indexing="ij")
    columns = [*points, *NEWTON_MILLIMETRE.number(found.torque)]
    heads = [f"{OF_OPERATION.get(name, name)} [{SHOWN[name].name}]" for name in axes]
    heads += [f"{name} [{NEWTON_MILLIMETRE.name}]" for name in TORQUES]
    with file.open("w", encoding="utf-8", newline="") as text:
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(heads)
        writer.writerows([f"{value:.15g}" for value in row] for row in np.stack([e.ravel() for e in columns], axis=1))
    return ()
