"""The page of a result as the main job writes it."""

from collections.abc import Sequence
from pathlib import Path

from fembearing.check.validation import Validation
from fembearing.report.figures.page_plots import Plot, pictures_of, plots_of
from fembearing.report.folder import report_page
from fembearing.report.pictures.draw import Picture
from fembearing.report.report import report_of


def written_page(
    result: Validation, *, pictures: Sequence[Picture] = (), folder: Path | None = None, plots: Sequence[Plot] = ()
) -> str:
    """Its text.

    folder : where the pictures lie; without it that of the first of them
    plots : in place of all of them, which take seconds
    """
    document = report_of(result, pictures=[picture.listed for picture in pictures])
    place = folder or (pictures[0].file.parent if pictures else Path())
    drawn = pictures_of(document, place)
    for name, blocks in plots_of(document, plots).items():
        drawn.setdefault(name, []).extend(blocks)
    return report_page(document, drawn)
