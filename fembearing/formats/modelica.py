"""The torque over speed as a Modelica package: three models of bearing friction, of the torque and both its ends.

Each extends Modelica.Mechanics.Rotational.Components.BearingFriction [Modelica2020]. Its table tau_pos has ascending
speeds from 0 on and the torque at each. It mirrors the table for the other direction, sticks at
standstill until the torque reaches peak times that of speed 0, and draws straight lines, beyond the last speed too.
"""

from pathlib import Path

from analytic.progress import Progress
from analytic.scene import Array
from analytic.scenefile.read import SceneByTemperature
from fembearing.formats.axes import Axes, axes_in_words
from fembearing.formats.interpolation import table_of_motion

TEXT = """\
package {name} "Friction torque of {bearing}"
{models}  annotation (uses(Modelica(version="4.0.0")), Documentation(info="<html><p>Computed by fembearing for {axes};
{error}. At speed 0 the torque is that at which the bearing begins to turn, so that peak is 1. Beyond the last speed the
table is extrapolated: do not go there.</p></html>"));
end {name};
"""
MODEL = """\
  model {model} "{meaning}"
    extends Modelica.Mechanics.Rotational.Components.BearingFriction(
      final tau_pos=[{table}],
      final peak=1);
  end {model};

"""
MODELS = {  # in the order of a map
    "Low": "lower end of the 95 % interval of the friction torque",
    "Friction": "friction torque",
    "High": "upper end of the 95 % interval of the friction torque",
}


def write_modelica(given: SceneByTemperature, axes: Axes, file: Path, progress: Progress) -> tuple[str, ...]:
    """Write the package, which has the name of the file."""
    found, error = table_of_motion(given, axes, progress)
    speeds, torques = found.curve
    models = "".join(
        MODEL.format(model=model, meaning=meaning, table=_rows(speeds, torque))
        for (model, meaning), torque in zip(MODELS.items(), torques, strict=True)
    )
    bearing = found.scene.bearing.name.replace("\\", "\\\\").replace('"', '\\"')
    text = TEXT.format(name=file.stem, bearing=bearing, models=models, axes=axes_in_words(found.axes), error=error)
    file.write_text(text, "utf-8")
    return (error,)


def _rows(speeds: Array, torques: Array) -> str:
    """Speed, rad/s, and torque, N m."""
    rows = zip(speeds.tolist(), torques.tolist(), strict=True)
    return ";\n        ".join(f"{speed!r}, {torque!r}" for speed, torque in rows)
