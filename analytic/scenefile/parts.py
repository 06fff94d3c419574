"""The parts of a scene for Python, by the keys and names of a scene file: numbers are SI, texts have units.

A quantity of pint, in its own registry, stands for the text that it prints.
"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any, TypedDict, Unpack, cast
from warnings import warn

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import InputError, require_finite
from analytic.given import Given, Quantity
from analytic.scene import Array, Bearing, Lubricant, Material, Operation, Scene, Surface, Tilt
from analytic.scenefile.keys import scene_key
from analytic.scenefile.kinds import material_entry
from analytic.scenefile.read import scene_of
from analytic.scenefile.setting import as_plain, in_si
from analytic.words import shown

Series = ArrayLike | str | Sequence[str] | Quantity | Sequence[Quantity]
# What a scene needs beside the table that is read.
ANYTHING = {"name": "from Python", "tolerance": 0.05, "operation": {"axial_load": "1 N", "inner_speed": "0 rpm"}}
BEARING = {"catalog": "paper_6205"}


class BearingKeys(TypedDict, total=False):
    """Of [bearing]."""

    name: str
    ball_count: int
    ball_diameter: Given
    ball_mass: Given
    ball_material: str | Mapping[str, Any]
    inner: Mapping[str, Any]
    outer: Mapping[str, Any]
    bore_diameter: Given
    outside_diameter: Given
    width: Given
    kind: str
    static_load_rating: Given
    dynamic_load_rating: Given
    contact_angle: Mapping[str, Any]
    pitch_diameter: Given
    conformity: Given
    clearance: Given


class SurfaceKeys(TypedDict, total=False):
    """Of [surface]."""

    rms_roughness: Given
    autocorrelation: Mapping[str, Any]
    height_map: Mapping[str, Any]
    ball_rms_roughness: Given
    hardness: Given
    boundary_friction: Given
    gap: str
    asperities: str
    Ra: Given
    finish: str


class LubricantKeys(TypedDict, total=False):
    """Of [lubricant]."""

    pressure_viscosity: Given
    viscosity_temperature: Given
    reference_temperature: Given
    thermal_conductivity: Given
    density: Given
    limiting_shear: Given
    traction: str | Mapping[str, Any]
    eyring_stress: Given
    thickening: str
    supply: str
    surface_tension: Given
    starvation_degree: Given
    reach: Mapping[str, Any]
    cavitation_pressure: Given
    compressible: bool
    film_formula: str
    rolling_formula: str
    base_oil: str


class MaterialKeys(TypedDict, total=False):
    """Of a material."""

    youngs_modulus: Given
    poisson_ratio: Given
    density: Given
    source: str
    hardness: Given
    thermal_expansion: Given


def _scene_with(name: str, keys: Mapping[str, Any]) -> Scene:
    """A scene with this table; the errors of a scene file, which begin with its name."""
    return scene_of({**ANYTHING, "bearing": BEARING, name: in_si(keys, name)}, origin=name)


def bearing(designation: str | None = None, **dimensions: Unpack[BearingKeys]) -> Bearing:
    """The bearing that the table `[bearing]` of a scene describes.

    Parameters
    ----------
    designation : str, optional
        Of the catalogue, as "NSK 6206/C3"; None: the dimensions say all.
    **dimensions : float, str or dict
        Keys of [bearing], which take precedence: numbers in SI, or texts with units; a dict for a table, as
        inner={"conformity": 0.515} or contact_angle={"nominal": 0.262}. The clearance may be a group, as "C3".

    Returns
    -------
    Bearing
        In SI.

    Raises
    ------
    InputError
        A designation or key is unknown; something is missing, out of range or does not fit together.

    Warns
    -----
    UserWarning
        Makers differ, or a suffix is not understood.
    """
    scene = _scene_with("bearing", dimensions if designation is None else {**dimensions, "catalog": designation})
    for warning in scene.warnings:
        warn(warning, stacklevel=2)
    return scene.bearing


def operation(
    *,
    inner_speed: Series,
    axial_load: Series = 0.0,
    radial_load: Series = 0.0,
    moment: Series | None = None,
    tilt: Given | None = None,
) -> Operation:
    """The operating points of a series: single values or (n,); a single value counts for the whole series.

    Parameters
    ----------
    inner_speed : array_like or str, shape (n,)
        Of the inner ring, rad/s, or texts with units, as "1000 rpm" or ["500 rpm", "1000 rpm"].
    axial_load, radial_load : array_like or str, shape (n,)
        N, or texts with units.
    moment : array_like or str, shape (n,), optional
        N m, as in `analytic.scene.Operation`, or texts with units; the ring then tilts freely.
    tilt : float or str, optional
        At which the ring is held, rad, or a text as "0.3 mrad" or "free"; None: 0, or free under a given moment.

    Returns
    -------
    Operation
        Arrays (n,), SI.

    Raises
    ------
    InputError
        Lengths differ, something is neither a number nor a quantity of that key, or a moment is given beside a tilt.
    """
    given = {"axial_load": axial_load, "inner_speed": inner_speed, "radial_load": radial_load, "moment": moment}
    arrays = {key: _in_si(f"operation.{key}", value) for key, value in given.items() if value is not None}
    if tilt is None:
        held = None if moment is None else "free"
    else:
        held = scene_key("operation.tilt").read_as("operation.tilt", in_si(tilt, "operation.tilt"))
    if moment is not None and not isinstance(held, str):
        raise InputError("operation.tilt holds the ring, and operation.moment tilts it: leave one of them out")
    return Operation(tilt=cast(Tilt | None, held), **arrays).as_series()


def _in_si(path: str, given: Series) -> Array:
    """Numbers, which are in SI already, or quantities in texts: one or a list."""
    given = as_plain(given)
    if isinstance(given, str):
        key = scene_key(path)
        return np.asarray(key.kind.read(given) if " to " in given else key.read_as(path, given))
    if isinstance(given, list | tuple) and any(isinstance(each, str) for each in given):
        return np.array([scene_key(path).read_as(path, each) for each in given])
    try:
        numbers = np.asarray(given, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"{path} = {shown(given)} is neither numbers in SI nor texts with units") from None
    require_finite(**{path: numbers})
    return numbers


def surfaces(**keys: Unpack[SurfaceKeys]) -> Surface:
    """The surfaces that the table `[surface]` of a scene describes.

    Parameters
    ----------
    **keys : float, str or dict
        Keys of [surface]: numbers in SI or texts with units, as finish="ground and honed" or Ra=0.05e-6.

    Returns
    -------
    Surface
        In SI, with the origin of each property.

    Raises
    ------
    InputError
        A key is unknown, missing or in conflict, or a value is out of range.
    """
    found = _scene_with("surface", keys).surface
    assert found is not None, "the document has the table"
    return found


def lubricant(
    name: str | None = None,
    *,
    temperature: Given | None = None,
    viscosity: Given | Sequence[str] | None = None,
    **overrides: Unpack[LubricantKeys],
) -> Lubricant:
    """The lubricant that the table `[lubricant]` of a scene describes.

    Parameters
    ----------
    name : str, optional
        Of an oil or grease of the catalog, as "ISO VG 46"; analytic.catalog.oil_names lists them; None: the other keys
        say all, as viscosity=0.03, density=870.0, base_oil="mineral".
    temperature : float or str, optional
        In K, or a text as "70 degC"; None: 40 degC, or where the viscosity is known.
    viscosity : float, str or sequence of str, optional
        Pa s, or as in a scene, for example ["46 cSt at 40 degC", "6.8 cSt at 100 degC"].
    **overrides : float, str or bool
        Keys of [lubricant], which take precedence: numbers in SI, or texts with units; reach={"ahead": 0.9}.

    Returns
    -------
    Lubricant
        In SI, with the origin of each property.

    Raises
    ------
    InputError
        A name or key is unknown, a value is out of range, the temperature is beyond the oil's data, or neither the
        catalog nor an override gives a value.

    Notes
    -----
    Sources: [ASTMD341] for the viscosity over the temperature, [Arana2019] for the stresses; see docs/oils.md.
    """
    reach = as_plain(overrides.get("reach"))
    lengths = [each for each in (reach.values() if isinstance(reach, dict) else ()) if isinstance(each, str)]
    if lengths := [each for each in lengths if not each.rstrip().endswith("%")]:
        raise InputError(f"lubricant.reach = {lengths[0]!r}: no ball is given; give a share of its radius, as 0.9")
    keys = {"name": name, "temperature": temperature, "viscosity": viscosity, **overrides}
    found = _scene_with("lubricant", {key: value for key, value in keys.items() if value is not None}).lubricant
    assert found is not None, "the document has the table"
    return found


def material(name: str, **overrides: Unpack[MaterialKeys]) -> Material:
    """The material that a scene means by this name.

    Parameters
    ----------
    name : str
        Of the catalog, as "100Cr6"; analytic.catalog.names("materials") lists them.
    **overrides : float or str
        Keys of a material in SI, which take precedence; `source` may say where they come from.

    Returns
    -------
    Material
        In SI.

    Raises
    ------
    InputError
        A name or key is unknown, a value is out of range, or neither gives a value.
    """
    try:
        entry = material_entry(name, overrides)
    except ValueError as problem:
        raise InputError(f"material {shown(name)} {problem}") from None
    return _scene_with("bearing", {**BEARING, "ball_material": entry}).bearing.ball_material


def with_tolerance(scene: Scene, tolerance: Given) -> Scene:
    """The scene with another tolerance: a number, a text as "1 %", or a quantity. Raises InputError as a scene file."""
    return replace(scene, tolerance=scene_key("tolerance").read_as("tolerance", as_plain(tolerance)))
