"""What the scene of a bearing of the catalogue assumes, beside its options and settings."""

import os
from collections.abc import Collection, Iterator, Mapping
from typing import Any

from analytic.catalog.bearing_rows import find_bearing
from analytic.scene import Scene
from analytic.scenefile.choice import KEYS
from analytic.scenefile.find import find_scene
from analytic.scenefile.setting import read_choice
from analytic.scenefile.text import parse_text


def assumptions(
    name: str | os.PathLike[str], scene: Scene, *, settings: Collection[str], options: Mapping[str, Any]
) -> Iterator[str]:
    """Gives "key = value" of each key that the usual scene of a bearing has and nobody gave; of other scenes nothing.

    name, settings, options : as for `load_scene`, which gave the scene
    """
    found = find_scene(name, choice=read_choice(options)[0])
    if found.designation is None:
        return
    document = parse_text(found.text, origin=found.origin)
    assert scene.lubricant is not None, "the usual scene has oil"
    document["lubricant"].setdefault("supply", scene.lubricant.supply)
    given = {KEYS[option] for option, value in options.items() if value is not None} | {*settings}
    if "temperature" in scene.lubricant.origins:  # friction settles it
        given.add("lubricant.temperature")
    if find_bearing(found.designation).clearance_group is not None:
        given.add("bearing.clearance")
    document["bearing"] = {key: value for key, value in document["bearing"].items() if key == "clearance"}
    for table in ("bearing", "operation", "lubricant", "surface", "friction"):
        values = {f"{table}.{key}": value for key, value in document[table].items()}
        yield from (f"{path} = {value}" for path, value in values.items() if path not in given)
