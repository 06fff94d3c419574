"""Values between the nodes of a table, by straight lines along each axis, and their error.

This is what readers of the tables do: BearingFriction of Modelica, the lookup tables of Simscape, and `fmu.c`. The
torque of a bearing has kinks, as where a ball is relieved; polynomials of a higher degree err more there, and may make
a torque negative.
"""

import numpy as np
from scipy.interpolate import RegularGridInterpolator

from analytic.progress import Progress, part_of
from analytic.scenefile.read import SceneByTemperature
from fembearing.formats.axes import Axes
from fembearing.formats.torque_map import TorqueMap, from_standstill, mapped_torque

MOST = 1000  # points at which an error is measured
SEED = 1  # of the choice of so many


def table_of_motion(given: SceneByTemperature, axes: Axes, progress: Progress) -> tuple[TorqueMap, str]:
    """The torque from standstill on, and how far straight lines in its table are off, in words."""
    found = mapped_torque(given, from_standstill(axes), progress=part_of(progress, 0.0, 0.8))
    progress(0.8, "error of the table")
    error = 100 * _largest_error(found)
    return found, f"straight lines between the nodes differ from the computed torque by up to {error:.2g} %"


def _largest_error(found: TorqueMap) -> float:
    """The largest error of the interpolated torque over the torque itself, in the middle of the cells of the table.

    Of more than MOST cells so many are chosen at random. On each axis the error of a straight line is largest near the
    middle between two nodes.
    """
    middles = [values if values.size == 1 else (values[1:] + values[:-1]) / 2 for values in found.axes.values()]
    points = np.stack([each.ravel() for each in np.meshgrid(*middles, indexing="ij")])
    if points.shape[1] > MOST:
        points = points[:, np.random.default_rng(SEED).choice(points.shape[1], MOST, replace=False)]
    right = found.law.at(dict(zip(found.axes, points, strict=True)))
    error = np.abs(RegularGridInterpolator([*found.axes.values()], found.nominal)(points.T) - right)
    return float(np.max(np.divide(error, right, out=np.zeros_like(error), where=right > 0)))
