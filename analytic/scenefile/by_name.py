"""The parts of a scene for Python, by the keys and names of a scene file: numbers are SI, texts have units."""

from collections.abc import Mapping
from typing import Any
from warnings import warn

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError
from analytic.scene import Bearing, Lubricant, Material, Operation, Surface
from analytic.scenefile.keys import scene_key
from analytic.scenefile.material import catalog_material
from analytic.scenefile.oil import completed_lubricant
from analytic.scenefile.read import scene_of
from analytic.scenefile.text import shown
from analytic.scenefile.viscosity import GivenViscosity, ViscosityPoint

# What a scene needs beside the table that is read.
ANYTHING = {"name": "from Python", "tolerance": 0.05, "operation": {"axial_load": "1 N", "inner_speed": "0 rpm"}}
MATERIAL = "bearing.ball_material"  # the keys of any material are the same


def bearing(designation: str | None = None, **dimensions: Any) -> Bearing:
    """The bearing that the table `[bearing]` of a scene describes.

    designation : of the catalogue, as "NSK 6206/C3"; None: the dimensions say all
    dimensions : keys of [bearing], which take precedence: numbers in SI, or texts with units; a dict for a table, as
        inner={"conformity": 0.515} or contact_angle={"nominal": 0.262}. The clearance may be a group, as "C3"
    Raises InputError for an unknown designation or key, for what is missing, out of range or does not fit together.
    Warns where makers differ, and of suffixes that are not understood.
    """
    table = _with_units(dimensions, "bearing")
    if designation is not None:
        table["catalog"] = designation
    scene = scene_of({**ANYTHING, "bearing": table}, origin="bearing")
    for warning in scene.warnings:
        warn(warning, stacklevel=2)
    return scene.bearing


def _with_units(table: Mapping[str, Any], path: str) -> dict[str, Any]:
    """The table with numbers in SI as the texts that a scene has in their place."""
    written = {}
    for key, value in table.items():
        place = f"{path}.{key}"
        if isinstance(value, Mapping):
            written[key] = _with_units(value, place)
        elif isinstance(value, float | int) and not isinstance(value, bool):
            dimension = scene_key(place).dimension
            has_unit = dimension is not None and dimension.unit
            written[key] = f"{float(value)!r} {dimension.unit}" if dimension is not None and has_unit else value
        else:
            written[key] = value
    return written


def operation(
    *,
    inner_speed: ArrayLike,
    axial_load: ArrayLike = 0.0,
    radial_load: ArrayLike = 0.0,
    moment: ArrayLike = 0.0,
) -> Operation:
    """The operating points of a series: numbers or (n,); a number counts for the whole series.

    inner_speed : rad/s;  axial_load, radial_load : N;  moment : N m, as in `analytic.Operation`
    Raises InputError where lengths differ.
    """
    given = {"axial_load": axial_load, "inner_speed": inner_speed, "radial_load": radial_load, "moment": moment}
    return Operation(**{key: np.asarray(value, dtype=np.float64) for key, value in given.items()}).as_series()


def surfaces(**keys: Any) -> Surface:
    """The surfaces that the table `[surface]` of a scene describes.

    keys : of [surface]: numbers in SI or texts with units, as finish="ground and honed" or Ra=0.05e-6
    Raises InputError for an unknown key, for what is missing, out of range or in conflict.
    """
    table = _with_units(keys, "surface")
    scene = scene_of({**ANYTHING, "bearing": {"catalog": "paper_6205"}, "surface": table}, origin="surface")
    assert scene.surface is not None, "the document has the table"
    return scene.surface


def lubricant(name: str, *, temperature: float | None = None, **overrides: float | str | bool) -> Lubricant:
    """The lubricant that `[lubricant] name = ...` describes in a scene.

    name : of an oil or grease of the catalog, as "ISO VG 46"; analytic.catalog.oil_names lists them
    temperature : K; 40 degC if it is left out;  overrides : keys of [lubricant] in SI, which take precedence
    Raises InputError for an unknown name or key, for a value out of range, for a temperature beyond the oil's data, and
    for what neither the catalog nor an override gives.
    """
    own = overrides if temperature is None else {"temperature": temperature, **overrides}
    given: dict[str, Any] = {key: _checked(f"lubricant.{key}", value) for key, value in own.items()}
    if "viscosity" in given:
        point = ViscosityPoint(value=given["viscosity"], is_kinematic=False, temperature=None)
        given["viscosity"] = GivenViscosity(points=(point,), text=shown(given["viscosity"]))
    return completed_lubricant({"name": name, **given})


def material(name: str, **overrides: float | str) -> Material:
    """The material that a scene means by this name.

    name : of the catalog, as "100Cr6"; analytic.catalog.names("materials") lists them
    overrides : keys of a material in SI, which take precedence; `source` may say where they come from
    Raises InputError for an unknown name or key, for a value out of range, and for what neither gives.
    """
    given = {key: _checked(f"{MATERIAL}.{key}", value) for key, value in overrides.items()}
    try:
        entry = catalog_material(name, given)
    except ValueError as problem:
        raise InputError(f"material {shown(name)} {problem}") from None
    written: dict[str, Any] = {
        key: scene_key(f"{MATERIAL}.{key}").read(value) for key, value in entry.items() if key not in given
    }
    return Material(**(written | given))


def _checked(path: str, value: object) -> Any:
    """The value of a key, which is in SI already."""
    key = scene_key(path)
    try:
        if key.dimension is None:
            return key.read(value)
        if isinstance(value, bool) or not isinstance(value, int | float):
            raise ValueError("is not a number")
        return key.dimension.checked(float(value))
    except ValueError as problem:
        raise InputError(f"{path} = {shown(value)} {problem}") from None
