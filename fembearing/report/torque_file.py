"""One file of a torque: the table, the numbers, the figure or a page, by the ending of its name."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from analytic.columns import COLUMNS
from analytic.errors import InputError, require_packages
from analytic.scene import Array
from analytic.scene_torque import SceneTorque
from fembearing.csv_text import csv_of_columns
from fembearing.plain_types import json_of
from fembearing.provenance import provenance_of
from fembearing.report.document import Bullets, Section
from fembearing.report.torque import content_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

CAPTION = "Friction torque by effect, with the 95 % interval of the total and the formulas of makers, as far as known."
Content = Callable[[SceneTorque], bytes]
IMAGES = (".png", ".svg", ".pdf")
MOST_DRAWN = 100  # scenes in a figure, which grows with them
ComparedContent = Callable[[Mapping[str, SceneTorque]], bytes]  # by the name of the scene


def writer_of(target: Path) -> Content:
    """What a file of this name holds. Raises InputError for an ending that is not known, with those that are."""
    content = CONTENTS.get(target.suffix.casefold())
    if content is None:
        raise InputError(
            f"--out {str(target)!r} ends with {target.suffix!r}: give a file that ends with {', '.join(CONTENTS)}, or "
            "a name without an ending for a folder with all"
        )
    return content


def torque_content(result: SceneTorque, *, ending: str) -> bytes:
    """A torque as the content of a file, as `fembearing torque --out` writes it.

    Parameters
    ----------
    result : SceneTorque
        Of `torque_of_scene`.
    ending : str
        ".csv", ".json", ".html", ".svg", ".png" or ".pdf".

    Returns
    -------
    bytes
        Table, numbers, page or figure.

    Raises
    ------
    InputError
        An unknown ending, with the known ones.
    """
    return writer_of(Path(f"torque{ending}"))(result)


def table_file(result: SceneTorque) -> bytes:
    """CSV."""
    return csv_of({result.scene.name: result}).encode()


def numbers_file(result: SceneTorque, **more: Any) -> bytes:
    """JSON, SI; more : what else it holds."""
    return json_of("torque", content_of(result), **more, run=provenance_of(result.scene)).encode()


def image_of(figure: "Figure", ending: str) -> bytes:
    """A figure as a file of one of IMAGES."""
    from fembearing.report.figures.style import pdf, png, svg  # with matplotlib: only a figure pays for it

    return {".png": png, ".svg": svg, ".pdf": pdf}[ending](figure)


def page_file(result: SceneTorque) -> bytes:
    """The page."""
    from fembearing.report.figures.page_plots import drawing_of
    from fembearing.report.page.document import page_of
    from fembearing.report.sections.headline import headline_section
    from fembearing.report.sections.torque import torque_sections

    sections = [headline_section(result), *torque_sections(result, [drawing_of(result.plot(), CAPTION)])]
    warnings = [Section("Warnings", [Bullets(result.friction.warnings)])] if result.friction.warnings else []
    title = f"{result.scene.name}: friction torque"
    return page_of(title, [*sections, *warnings], provenance_of(result.scene)).encode()


def compared_content(target: Path, count: int) -> ComparedContent:
    """What a file of this name holds of several scenes; count : of them.

    Raises InputError for any other than table and figure, and for more scenes than a figure has room for.
    """
    ending = target.suffix.casefold()
    if ending == ".csv":
        return lambda results: csv_of(results).encode()
    if ending not in IMAGES:
        raise InputError(
            f"--out {str(target)!r} takes one scene: give one, or for several a file that ends with .csv, .png, .svg "
            "or .pdf"
        )
    if count > MOST_DRAWN:
        raise InputError(f"--out {str(target)!r} is a figure of at most {MOST_DRAWN} scenes, not {count}; give a .csv")
    require_packages(f"--out {str(target)!r}", "matplotlib")

    def content(results: Mapping[str, SceneTorque]) -> bytes:
        from fembearing.report.figures.torque import compared_figure

        return image_of(compared_figure({name: result.drawn for name, result in results.items()}), ending)

    return content


def _drawn_as(ending: str) -> Content:
    return lambda result: image_of(result.plot(), ending)


CONTENTS: Mapping[str, Content] = {
    ".csv": table_file,
    ".json": numbers_file,
    **{ending: _drawn_as(ending) for ending in IMAGES},
    ".html": page_file,
}


def csv_of(results: Mapping[str, SceneTorque]) -> str:
    """A row for each operating point, and the name of the bearing last; columns that hold nothing are left out.

    results : by the name of the scene, which is the first column where there are several
    """
    known: dict[str, list[Array]] = {}
    sizes = {name: len(result.points) for name, result in results.items()}
    for scene, result in results.items():
        for name, (_, values, _) in result.columns().items():
            found = np.asarray(values, dtype=float)
            if np.isfinite(found).any():  # an uncertainty that is not known is infinite
                known.setdefault(name, [np.full(size, np.nan) for size in sizes.values()])
                known[name][list(results).index(scene)] = np.where(np.isfinite(found), found, np.nan)
    columns = {name: (column.shown(), np.concatenate(known[name])) for name, column in COLUMNS.items() if name in known}
    first = {"scene": [name for name, size in sizes.items() for _ in range(size)]} if len(results) > 1 else {}
    points = [number for size in sizes.values() for number in range(1, size + 1)]
    bearings = [result.scene.bearing.name for result in results.values() for _ in result.points]
    return csv_of_columns(columns, first=first | {"point": points}, last={"bearing": bearings})
