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


def usual_values(found: SceneText, scene: Scene, *, given: Collection[str]) -> Iterator[str]:
    """The same of a scene that is found.

    found : the text of the scene;  given : keys whose values are no assumptions
    """
    if found.designation is None:
        return
    document = parse_text(found.text, origin=found.origin)
    assert scene.lubricant is not None, "the usual scene has oil"
    document["lubricant"].setdefault("supply", scene.lubricant.supply)
    given = {*given}
    if "temperature" in scene.lubricant.origins:  # friction settles it
        given.add("lubricant.temperature")
    if find_bearing(found.designation).clearance_group is not None:
        given.add("bearing.clearance")
    document["bearing"] = {key: value for key, value in document["bearing"].items() if key == "clearance"}
    for table in ("bearing", "operation", "lubricant", "surface", "friction"):
        values = {f"{table}.{key}": value for key, value in document[table].items()}
        yield from (f"{path} = {value}" for path, value in values.items() if path not in given)
