"""The page of a result as the main job writes it: from the document alone."""

from collections.abc import Sequence
from pathlib import Path
from unittest.mock import patch

from fembearing.check.validation import Validation
from fembearing.plain_types import plain
from fembearing.report.figures.page_plots import Plot
from fembearing.report.page import write as page
from fembearing.report.pictures.draw import Picture
from fembearing.report.report import Report, report_in, report_of


def document_of(result: Validation, pictures: Sequence[Picture] = (), trouble: str | None = None) -> Report:
    """What report.json holds, read back."""
    written = report_of(result, pictures=[picture.listed for picture in pictures], renderer=trouble)
    return report_in(plain(written))


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
    place = pictures[0].file.parent if pictures else folder
    with patch.object(page, "PLOTS", plots):
        return page.page_of(document_of(result, pictures, trouble), place)
