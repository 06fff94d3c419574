"""The torque over speed as a MATLAB script with tables for a block PS Lookup Table (1D) of Simscape.

The block takes strictly ascending grid vectors. The torque has the sign of the speed, and jumps where that changes: the
jump becomes a steep line between two speeds that are STICKING times the first one of the table. A shaft at standstill
therefore creeps, by at most that speed, until the torque on it reaches `breakaway`.
"""

from pathlib import Path

import numpy as np

from analytic.progress import Progress
from analytic.scene import Array
from analytic.scenefile.read import SceneByTemperature
from fembearing.formats.axes import Axes, axes_in_words
from fembearing.formats.interpolation import table_of_motion
from fembearing.formats.torque_map import HIGH, LOW, NOMINAL

STICKING = 1e-3
WIDTH = 6  # numbers in a line
TEXT = """\
%% Friction torque of {bearing}, computed by fembearing
% {axes}
% {error}.
%
% Ideal Rotational Motion Sensor -> PS Lookup Table (1D) -> Ideal Torque Source that brakes the shaft
%   Table grid vector:    friction.speed
%   Table values:         friction.torque, or friction.low and friction.high, the ends of the 95 % interval
%   Interpolation method: Linear
%   Extrapolation method: Error, as nothing is known beyond the table
% The torque has the sign of the speed: it acts against it. Between -{slow:.4g} and {slow:.4g} rad/s it rises in a
% straight line through 0, in place of sticking.
friction = struct();
friction.breakaway = {breakaway!r}; % N*m, at which the bearing begins to turn
friction.speed = {speed}; % rad/s
friction.torque = {torque}; % N*m
friction.low = {low}; % N*m
friction.high = {high}; % N*m
"""


def write_simscape(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write the script, for both directions of rotation."""
    found, error = table_of_motion(given, axes, progress)
    speeds, torques = found.curve
    slow = STICKING * float(speeds[1])
    positive = np.concatenate([[slow], speeds[1:]])
    text = TEXT.format(
        bearing=found.scene.bearing.name,
        axes=axes_in_words(axes),
        error=error,
        slow=slow,
        breakaway=float(torques[NOMINAL, 0]),
        speed=_vector(_odd(positive)),
        torque=_vector(_odd(torques[NOMINAL])),
        low=_vector(_odd(torques[LOW])),
        high=_vector(_odd(torques[HIGH])),
    )
    file.write_text(text, "utf-8")
    return (error,)


def _odd(positive: Array) -> Array:
    """With the negative half and 0 before it."""
    return np.concatenate([-positive[::-1], [0.0], positive])


def _vector(values: Array) -> str:
    """A row vector of MATLAB."""
    words = [repr(value) for value in values.tolist()]
    lines = [" ".join(words[place : place + WIDTH]) for place in range(0, len(words), WIDTH)]
    return "[" + " ...\n    ".join(lines) + "]"
