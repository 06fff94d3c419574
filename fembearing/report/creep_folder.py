"""What the friction of a ball is written to: creep.json, and a picture of each race."""

import json
from pathlib import Path
from typing import Any

from analytic.writing import write
from fembearing.check.creep.scene_creep import CreepNumbers, SceneCreep
from fembearing.plain_types import document


def write_creep(creep: SceneCreep, folder: Path) -> str | None:
    """Write the numbers and the pictures with their captions into a folder; why there are no pictures, or None."""
    from fembearing.report.pictures.creep import creep_pictures
    from fembearing.report.pictures.draw import RENDERER, rendered

    pictures = creep_pictures(creep, folder)
    trouble = rendered([each.job for each in pictures], RENDERER)
    listed = [] if trouble else [{"file": each.file, "caption": each.caption} for each in pictures]
    content = creep_content(creep.numbers) | {"pictures": listed}
    write(folder / "creep.json", json.dumps(content, indent=1, allow_nan=False).encode())
    return trouble


def creep_content(numbers: CreepNumbers) -> dict[str, Any]:
    """What creep.json and `creep --json` hold, SI."""
    return document("creep", numbers)
