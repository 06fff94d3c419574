"""What the scene of a bearing of the catalogue assumes, beside its options and settings."""

import os
from collections.abc import Collection, Iterator, Mapping
from copy import deepcopy
from types import MappingProxyType
from typing import Any

from analytic.catalog.bearing_rows import find_bearing
from analytic.scene import Scene
from analytic.scenefile.choice import KEYS
from analytic.scenefile.columns import OPERATING, key_of_column
from analytic.scenefile.find import FoundScene, find_scene
from analytic.scenefile.known_oil import viscosities_of
from analytic.scenefile.setting import as_text, read_choice, with_columns, with_settings

NOTHING: Mapping[str, Any] = MappingProxyType({})
INSTEAD = {  # by key: the key or table of the usual scene in whose place it stands
    **dict.fromkeys(("surface.Ra", "surface.rms_roughness", "surface.height_map.path"), "surface.finish"),
    **dict.fromkeys(("bearing.contact_angle.nominal", "bearing.contact_angle.free"), "bearing.clearance"),
    **dict.fromkeys(("bearing.inner.bottom_radius", "bearing.outer.bottom_radius"), "bearing.clearance"),
    "bearing.clearance": "bearing.contact_angle.nominal",
    "friction.coefficient": "surface",
}


def assumptions(
    name: str | os.PathLike[str],
    scene: Scene,
    *,
    settings: Mapping[str, Any] = NOTHING,
    options: Mapping[str, Any] = NOTHING,
    columns: Mapping[str, Any] = NOTHING,
) -> Iterator[str]:
    """Gives "key = value" of each key that the usual scene of a bearing has and nobody gave; of other scenes nothing.

    name, settings, options, columns : as for `load_by_temperature`, which gave the scene
    """
    found = find_scene(name, choice=with_settings(with_columns(read_choice(options)[0], columns), settings))
    given = {**{KEYS[option]: value for option, value in options.items() if value is not None}, **settings}
    given |= {key_of_column(name): values for name in OPERATING if (values := columns.get(name)) is not None}
    yield from usual_values(found, scene, given=given)


def usual_document(found: FoundScene, given: Mapping[str, Any]) -> dict[str, Any]:
    """The document of a scene; that of a bearing of the catalogue without assumptions that given keys replace.

    given : values by key that someone gives. What is below a given key, or a suffix of the designation, is no
        assumption.
    """
    document = deepcopy(found.document)
    if found.designation is None:
        return document
    keys = _with_suffix(found.designation, given)
    for path in {INSTEAD[key] for key in keys if key in INSTEAD}:
        if not any(f"{key}.".startswith(f"{path}.") for key in keys):
            *tables, last = path.split(".")
            inside = document
            for name in tables:
                inside = inside.get(name, {})
            inside.pop(last, None)
    if found.choice.oil is None:
        document["lubricant"] = _oil_beside(document["lubricant"], given)
    return document


def _oil_beside(usual: dict[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """The table of the usual oil, without its name where given keys say another oil.

    Beside a base oil alone stay the viscosities of its class. A viscosity that is given is one of mineral oil, and
    without a temperature of its own that at the oil's.
    """
    keys = {key.partition(".")[2] for key in given if key.startswith("lubricant.")}
    if "name" in keys or not keys & {"viscosity", "base_oil", "reference_temperature"}:
        return usual
    oil = {key: value for key, value in usual.items() if key != "name"}
    if "viscosity" in keys:
        parts = as_text(given["lubricant.viscosity"])
        has_own = isinstance(parts, list) or " at " in str(parts)
        return {
            **({} if "base_oil" in keys else {"base_oil": "mineral"}),
            **({} if has_own or "reference_temperature" in keys else {"reference_temperature": oil["temperature"]}),
            **oil,
        }
    if "base_oil" in keys and "reference_temperature" not in keys:
        return {"viscosity": viscosities_of(str(usual["name"])), **oil}
    return oil


def _with_suffix(designation: str, given: Collection[str]) -> set[str]:
    """The given keys, with that of a clearance group in the designation."""
    return {*given} | ({"bearing.clearance"} if find_bearing(designation).clearance_group is not None else set())


def usual_values(found: FoundScene, scene: Scene, *, given: Mapping[str, Any]) -> Iterator[str]:
    """The same of a scene that is found.

    found : the document of the scene;  given : values by key that are no assumptions
    """
    if found.designation is None:
        return
    document = usual_document(found, given)
    assert scene.lubricant is not None, "the usual scene has oil"
    document["lubricant"].setdefault("supply", scene.lubricant.supply)
    keys = _with_suffix(found.designation, given)
    if "temperature" in scene.lubricant.origins:  # friction settles it
        keys.add("lubricant.temperature")
    document["bearing"] = {key: value for key, value in document["bearing"].items() if key == "clearance"}
    if "seals" in scene.losses.origins:
        document.setdefault("losses", {}).setdefault("seals", "estimate")
    for table in ("bearing", "operation", "lubricant", "surface", "friction", "losses"):
        values = {f"{table}.{key}": value for key, value in document.get(table, {}).items()}
        yield from (f"{path} = {value}" for path, value in values.items() if path not in keys)
