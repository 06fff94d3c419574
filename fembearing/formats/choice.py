"""The formats, and the function that writes a scene in one of them."""

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, NamedTuple, Unpack, get_args

import numpy as np

from analytic.errors import InputError
from analytic.given import SceneOptions
from analytic.prediction.steady import at_steady_temperature
from analytic.progress import Progress, silent
from analytic.scene import Scene
from analytic.scenefile.read import SceneByTemperature, load_by_temperature
from analytic.standing import WorstStanding, worst_standing
from analytic.words import plain
from analytic.writing import new_file, require_utf8
from fembearing.formats.axes import Axes, axes_in_words, axes_of
from fembearing.formats.csv_table import write_csv
from fembearing.formats.fmu import write_fmu
from fembearing.formats.modelica import write_modelica
from fembearing.formats.names import require_name
from fembearing.formats.netcdf import write_netcdf
from fembearing.formats.ross import write_ross
from fembearing.formats.simscape import write_simscape
from fembearing.formats.torque_map import torques_at_nodes

ANY_ERROR = float(np.finfo(np.float64).max)  # a tolerance that no error exceeds
FormatName = Literal["csv", "netcdf", "modelica", "simscape", "ross", "fmu"]


class Format(NamedTuple):
    """How a format is written."""

    ending: str  # of the file
    is_map: bool  # over loads and temperature too; else over speed alone
    has_torque: bool  # else it is a stiffness, of which only the physical limits are judged
    # Gives notes on the file, a sentence each
    write: Callable[[SceneByTemperature, Axes, Path, Progress], tuple[str, ...]]


FORMATS: Mapping[str, Format] = {
    "csv": Format(".csv", True, True, write_csv),
    "netcdf": Format(".nc", True, True, write_netcdf),
    "modelica": Format(".mo", False, True, write_modelica),
    "simscape": Format(".m", False, True, write_simscape),
    "ross": Format(".py", False, False, write_ross),
    "fmu": Format(".fmu", True, True, write_fmu),
}
MOVING_CAGE = "cage.start does not count: the cage of a table rests on its balls"


@dataclass(frozen=True, kw_only=True)
class Exported:
    """A file that another program reads."""

    file: Path
    axes: str  # size and ranges of its table, in words
    notes: tuple[str, ...]  # what to know of it, a sentence each
    standing: WorstStanding  # how far its torques can be trusted, by up to 20 speeds, 3 loads and 3 temperatures
    warnings: tuple[str, ...]  # of the torques there


def export(
    scene: str | os.PathLike[str] | Scene,
    *,
    to: FormatName,
    out: Path | str,
    over: Mapping[str, Any] | None = None,
    progress: Progress = silent,
    **given: Unpack[SceneOptions],
) -> Exported:
    """Write the friction torque of a scene, or its stiffness, in a form that another program reads.

    Parameters
    ----------
    scene : str, path or Scene
        What `load_scene` reads, with one moment. What `over` leaves out follows from its operating points and its oil.
        A Scene has its oil at one temperature alone.
    to : {"csv", "netcdf", "modelica", "simscape", "ross", "fmu"}
        The format. Modelica, Simscape and ROSS take one load and one temperature.
    out : str or path
        The file, with the ending of the format; it must not exist yet.
    over : mapping of str to str or array_like, optional
        Axes of the table: speed, rad/s, axial_load and radial_load, N, temperature of the oil, K. Texts as
        "0 rpm to 6000 rpm in 15", or " log" behind it for equal ratios; lists that ascend; or one value.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and a word on the step at hand.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`, as settings={"lubricant.supply": "grease"}.

    Returns
    -------
    Exported
        The file, its axes, notes as the error of interpolation, and the worst standing and the warnings of its torques.

    Raises
    ------
    InputError
        An unknown format or axis, a range without a torque, a temperature at which the oil is not known, a file that
        exists or cannot be made, a missing compiler; and as `load_scene`.
    ConvergenceError
        As `analytic.friction_torque`.

    Notes
    -----
    The torque is that of `analytic.torque_function` over these axes, with its 95 % interval to first order. At speed 0
    it is the limit for small speeds, at which the bearing begins to turn.
    Sources: those of `analytic.friction_torque`; [FMI2022], [Modelica2020] and [Timbo2020] for the forms.
    """
    return export_of(load_by_temperature(scene, **given), to=to, out=out, over=over, progress=progress)


def export_of(
    found: SceneByTemperature,
    *,
    to: FormatName,
    out: Path | str,
    force: bool = False,
    over: Mapping[str, Any] | None = None,
    progress: Progress = silent,
) -> Exported:
    """What `export` does, of a scene that is read; force : as in `analytic.writing.new_file`"""
    if to not in FORMATS:
        raise InputError(f"to = {plain(str(to))!r} is no format; give {', '.join(get_args(FormatName))}")
    form, file = FORMATS[to], Path(out)
    if file.suffix.casefold() != form.ending:
        raise InputError(f"--out {str(file)!r}: a file of {to} ends with {form.ending!r}; rename it")
    require_name(to, file)
    require_utf8(file)
    found = replace(found, scene=at_steady_temperature(found), thermal=None)
    axes = axes_of(found, over or {}, whole=form.is_map)
    if not form.is_map:
        for name, values in axes.items():
            if name != "speed" and values.size > 1:
                raise InputError(f"{name} has {values.size} values, and {to} takes one; write a file for each")
    with new_file(file, force=force) as apart:
        notes = form.write(found, axes, apart, progress)
        progress(1.0, "limits")
        torques = torques_at_nodes(found, axes)
    if not form.has_torque:  # nothing of it can exceed a tolerance
        torques = [(replace(scene, tolerance=ANY_ERROR), friction) for scene, friction in torques]
    warnings = dict.fromkeys(warning for _, friction in torques for warning in friction.warnings)
    cage = found.scene.cage
    if form.has_torque and cage is not None and cage.start and found.scene.effects.get("cage_dynamics") != "off":
        warnings[MOVING_CAGE] = None
    return Exported(
        file=file, axes=axes_in_words(axes), notes=notes, standing=worst_standing(torques), warnings=tuple(warnings)
    )
