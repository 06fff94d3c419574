"""The torque over speed as a Modelica package: three models of bearing friction, of the torque and both its ends.

Each extends Modelica.Mechanics.Rotational.Components.BearingFriction [Modelica2020]. Its table tau_pos has ascending
speeds from 0 on and the torque at each. It mirrors the table for the other direction, sticks at
standstill until the torque reaches peak times that of speed 0, and draws straight lines, beyond the last speed too.
"""

import re
from pathlib import Path

from analytic.errors import InputError
from analytic.progress import Progress
from analytic.scene import Array
from analytic.scenefile.read import SceneByTemperature
from fembearing.formats.axes import Axes, axes_in_words
from fembearing.formats.interpolation import table_error
from fembearing.formats.torque_map import TorqueMap, from_standstill, mapped_torque

IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
MODELS = {  # in the order of a map
    "Low": "lower end of the 95 % interval of the friction torque",
    "Friction": "friction torque",
    "High": "upper end of the 95 % interval of the friction torque",
}


def write_modelica(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write the package, which has the name of the file. Raises InputError for a name that Modelica does not take."""
    if not IDENTIFIER.fullmatch(file.stem):
        raise InputError(
            f"--out {file.name!r}: a Modelica package has the name of its file, letters, digits and _, a letter first; "
            f"give for example {'friction_' + re.sub(r'[^A-Za-z0-9_]+', '_', file.stem) + '.mo'!r}"
        )
    found = mapped_torque(given, from_standstill(axes), progress=progress)
    error = table_error(found)
    file.write_text(_package(file.stem, found, error), "utf-8")
    return (f"straight lines between the speeds differ from the torque by up to {100 * error:.2g} %",)


def _package(name: str, found: TorqueMap, error: float) -> str:
    speeds, torques = found.curve
    models = "".join(
        f'  model {model} "{meaning}"\n'
        "    extends Modelica.Mechanics.Rotational.Components.BearingFriction(\n"
        f"      final tau_pos={_table(speeds, torque)},\n"
        "      final peak=1);\n"
        f"  end {model};\n\n"
        for (model, meaning), torque in zip(MODELS.items(), torques, strict=True)
    )
    words = (
        f"<p>Computed by fembearing for {axes_in_words(found.axes)}. Straight lines between the speeds differ from the "
        f"computed torque by up to {100 * error:.2g} %. At speed 0 the torque is that at which the bearing begins to "
        "turn, so that peak is 1. Beyond the last speed the table is extrapolated: do not go there.</p>"
    )
    return (
        f'package {name} "Friction torque of {_quoted(found.scene.bearing.name)}"\n{models}'
        f'  annotation (uses(Modelica(version="4.0.0")), Documentation(info="<html>{_quoted(words)}</html>"));\n'
        f"end {name};\n"
    )


def _table(speeds: Array, torques: Array) -> str:
    """Rows of speed, rad/s, and torque, N m."""
    rows = zip(speeds.tolist(), torques.tolist(), strict=True)
    return "[" + ";\n        ".join(f"{speed!r}, {torque!r}" for speed, torque in rows) + "]"


def _quoted(text: str) -> str:
    """What stands in a text of Modelica."""
    return text.replace("\\", "\\\\").replace('"', '\\"')
