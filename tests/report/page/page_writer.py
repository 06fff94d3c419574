"""The page of a result as the main job writes it: from the JSON alone."""

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any
from unittest.mock import patch

from fembearing.compare.validation import Validation
from fembearing.report.figures.plot import Plot
from fembearing.report.page import html as page
from fembearing.report.pictures.draw import Picture


def document_of(result: Validation, pictures: Sequence[Picture] = (), trouble: str | None = None) -> dict[str, Any]:
    """What report.json holds, read back."""
    told = {"pictures": [picture.to_json() for picture in pictures], "renderer": trouble or "VTK"}
    return json.loads(json.dumps(result.to_json() | told, allow_nan=False))


def written_page(
    result: Validation,
    folder: Path,
    *,
    pictures: Sequence[Picture] = (),
    trouble: str | None = None,
    plots: Sequence[Plot] = (),
) -> str:
    """Its text; pictures lie where they were drawn, all in one folder.

    plots : in place of all of them, which take seconds
    """
    file = folder / "page.html"
    place = pictures[0].file.parent if pictures else folder
    with patch.object(page, "PLOTS", plots):
        page.write_page(document_of(result, pictures, trouble), folder=place, file=file)
    return file.read_text("utf-8")
