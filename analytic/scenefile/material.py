"""Materials by name: the catalog's constants, and keys that replace or complete them."""

from typing import Any

from analytic import catalog

NEEDED = {"youngs_modulus": '"206 GPa"', "poisson_ratio": "0.29", "density": '"7850 kg/m^3"'}  # and examples


def material_entry(given: object) -> dict[str, Any]:
    """The table of a material that a scene names or gives; what a table with a catalog's name leaves out is filled in.

    Raises ValueError for an unknown name, and for a name whose entry lacks what a material needs.
    """
    if not isinstance(given, dict):
        return catalog_material(given, {})
    name = given.get("name")
    if not isinstance(name, str) or catalog.find("materials", name) is None:
        return given
    return _overlaid(name, given)


def catalog_material(name: object, given: dict[str, Any]) -> dict[str, Any]:
    """The catalog's table of that name with the given keys, which take precedence; the errors of material_entry."""
    if not isinstance(name, str) or catalog.find("materials", name) is None:
        known = ", ".join(catalog.names("materials"))
        raise ValueError(f"is not a material; give one of {known}, or a table with youngs_modulus and so on")
    entry = _overlaid(name, given)
    missing = [key for key in NEEDED if key not in entry]
    if missing:
        rest = ", ".join(f"{key} = {NEEDED[key]}" for key in missing)
        raise ValueError(
            f"has no sourced {' and no '.join(missing)}; give it with the name, for example "
            f"{{ name = {name!r}, {rest} }}"
        )
    return entry


def _overlaid(name: str, given: dict[str, Any]) -> dict[str, Any]:
    entry = catalog.entry("materials", catalog.find("materials", name) or name)
    entry.pop("also", None)
    own = [key for key in given if key not in ("name", "source")]
    if own:
        entry["source"] = f"{entry['source']}; given: {', '.join(own)}"
    return entry | given
