"""What the scene of a bearing of the catalogue assumes, beside its options and settings."""

import os
from collections.abc import Collection, Iterator, Mapping
from types import MappingProxyType
from typing import Any

from analytic.catalog.bearing_rows import find_bearing
from analytic.scene import Scene
from analytic.scenefile.choice import KEYS
from analytic.scenefile.columns import OPERATING, key_of_column
from analytic.scenefile.find import SceneText, find_scene
from analytic.scenefile.setting import read_choice, with_loads
from analytic.scenefile.text import parse_text

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
    settings: Collection[str] = (),
    options: Mapping[str, Any] = NOTHING,
    columns: Mapping[str, Any] = NOTHING,
) -> Iterator[str]:
    """Gives "key = value" of each key that the usual scene of a bearing has and nobody gave; of other scenes nothing.

    name, settings, options, columns : as for `load_by_temperature`, which gave the scene
    """
    found = find_scene(name, choice=with_loads(read_choice(options)[0], columns))
    given = {KEYS[option] for option, value in options.items() if value is not None} | {*settings}
    given |= {key_of_column(column) for column in OPERATING if columns.get(column) is not None}
    yield from usual_values(found, scene, given=given)


def usual_document(found: SceneText, given: Collection[str]) -> dict[str, Any]:
    """The document of a scene; that of a bearing of the catalogue without assumptions that given keys replace.

    given : keys that someone gives. What is below a given key, or a suffix of the designation, is no assumption.
    """
    document = parse_text(found.text, origin=found.origin)
    if found.designation is None:
        return document
    given = _with_suffix(found.designation, given)
    for path in {INSTEAD[key] for key in given if key in INSTEAD}:
        if not any(f"{key}.".startswith(f"{path}.") for key in given):
            *tables, last = path.split(".")
            inside = document
            for name in tables:
                inside = inside.get(name, {})
            inside.pop(last, None)
    return document


def _with_suffix(designation: str, given: Collection[str]) -> set[str]:
    """The given keys, with that of a clearance group in the designation."""
    return {*given} | ({"bearing.clearance"} if find_bearing(designation).clearance_group is not None else set())


def usual_values(found: SceneText, scene: Scene, *, given: Collection[str]) -> Iterator[str]:
    """The same of a scene that is found.

    found : the text of the scene;  given : keys whose values are no assumptions
    """
    if found.designation is None:
        return
    document = usual_document(found, given)
    assert scene.lubricant is not None, "the usual scene has oil"
    document["lubricant"].setdefault("supply", scene.lubricant.supply)
    given = _with_suffix(found.designation, given)
    if "temperature" in scene.lubricant.origins:  # friction settles it
        given.add("lubricant.temperature")
    document["bearing"] = {key: value for key, value in document["bearing"].items() if key == "clearance"}
    if "seals" in scene.losses.origins:
        document.setdefault("losses", {}).setdefault("seals", "estimate")
    for table in ("bearing", "operation", "lubricant", "surface", "friction", "losses"):
        values = {f"{table}.{key}": value for key, value in document.get(table, {}).items()}
        yield from (f"{path} = {value}" for path, value in values.items() if path not in given)
