"""Oils and materials of the catalog by name, for Python: all values in SI; a scene reads the same with units."""

from typing import Any

from analytic.errors import InputError
from analytic.scene import Lubricant, Material
from analytic.scenefile.keys import scene_key
from analytic.scenefile.material import catalog_material
from analytic.scenefile.oil import completed_lubricant
from analytic.scenefile.text import shown
from analytic.scenefile.viscosity import GivenViscosity, ViscosityPoint

MATERIAL = "bearing.ball_material"  # the keys of any material are the same


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
