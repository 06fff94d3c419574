"""The stiffness of the bearing over speed as a bearing element of ROSS [Timbo2020], rotor dynamics in Python.

In ROSS x and y lie across the shaft and the weight acts along -y. So y of ROSS is x of the ring here, along the radial
load, and x of ROSS is -y of the ring. The element takes the stiffness of two displacements, kxx, kxy, kyx and kyy, and
along the shaft, kzz. It has no tilts: the moments of the ring are left out. The stiffness is the tangent at the load of
the axis, with each contact's K and the balls' own forces held (`analytic.loads.ring_state`). Damping is 0: no formula
here gives any.
"""

from dataclasses import replace
from pathlib import Path

import numpy as np

from analytic.errors import InputError
from analytic.progress import Progress
from analytic.scene import Array
from analytic.scenefile.read import SceneByTemperature
from analytic.torque import friction_torque
from fembearing.formats.axes import Axes, axes_in_words

COEFFICIENTS = {  # sign and place in the stiffness of the ring: z, x, y and tilts
    "kxx": (1, 2, 2),
    "kxy": (-1, 2, 1),
    "kyx": (-1, 1, 2),
    "kyy": (1, 1, 1),
    "kzz": (1, 0, 0),
}
TEXT = """\
# Stiffness of {bearing} for ROSS, computed by fembearing: {axes}
#
#     from {module} import bearing
#     rotor = ross.Rotor(shaft_elements, disk_elements, [bearing(n=0), bearing(n=6)])
#
# The radial load acts along y, as the weight in ROSS. The model has no damping: give cxx from a test of your machine.
from inspect import signature

import ross

SPEED = {speed}  # rad/s, of the shaft
STIFFNESS = {{  # N/m
{stiffness}}}
# Of the arguments of the element, the one that is the shaft's speed: from ROSS 3 on `frequency` is that of the whirl
AXIS = "speed" if "speed" in signature(ross.BearingElement).parameters else "frequency"


def bearing(n, cxx=0.0, **others):
    '''The bearing at a node of the shaft; cxx : damping in x and y, N s/m;  others : of ross.BearingElement.'''
    return ross.BearingElement(n=n, cxx=cxx, **{{AXIS: SPEED}}, **STIFFNESS, **others)
"""


def write_ross(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write a Python module with a function that makes the element.

    Raises InputError for a pair of bearings, fewer than two speeds, and loads that leave a displacement free.
    """
    progress(0.0, "stiffness")
    speeds = axes["speed"]
    if speeds.size < 2:
        raise InputError("an element of ROSS needs speeds to interpolate between; give speed as a range")
    stiffness = stiffness_at(given, axes)
    rows = "".join(
        f'    "{name}": {(sign * stiffness[:, i, j] + 0.0).tolist()},\n' for name, (sign, i, j) in COEFFICIENTS.items()
    )
    text = TEXT.format(
        bearing=given.scene.bearing.name,
        axes=axes_in_words(axes),
        module=file.stem,
        speed=speeds.tolist(),
        stiffness=rows,
    )
    file.write_text(text, "utf-8")
    return ("damping is 0: the model has none; give cxx of bearing() from a test of your machine",)


def stiffness_at(given: SceneByTemperature, axes: Axes) -> Array:
    """(s, 5, 5) of the ring at each speed, as `RingState.stiffness`, at the one load and temperature of the axes."""
    scene = given.at(float(axes["temperature"][0])) if "temperature" in axes else given.scene
    if scene.arrangement is not None:
        raise InputError("a pair of bearings has no stiffness at one node; give the scene of each bearing by itself")
    speeds = axes["speed"]
    loads = {name: np.full(speeds.size, axes[name][0]) for name in ("axial_load", "radial_load")}
    own = scene.operation.as_series()
    moment = np.full(speeds.size, np.atleast_1d(own.moment)[0])
    ring = friction_torque(replace(scene, operation=replace(own, inner_speed=speeds, moment=moment, **loads))).ring
    assert ring is not None
    least = np.linalg.eigvalsh(ring.stiffness[:, 1:3, 1:3]).min()
    if not least > 0:
        raise InputError("the loaded balls leave a radial displacement free, of stiffness 0; give a larger axial_load")
    return ring.stiffness
