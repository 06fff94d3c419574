"""One file of a torque: the table, the numbers, the figure or a page, by the ending of its name."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from analytic.errors import InputError, require_packages
from analytic.scene_torque import SceneTorque
from fembearing.plain_types import plain
from fembearing.provenance import provenance_of
from fembearing.report.torque import torque_file
from fembearing.report.torque_table import compared_csv, csv_of

Content = Callable[[SceneTorque], bytes]
ComparedContent = Callable[[Mapping[str, SceneTorque]], bytes]  # by the name of the scene


def content_of(target: Path) -> Content:
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
    return content_of(Path(f"torque{ending}"))(result)


def table_file(result: SceneTorque) -> bytes:
    """CSV."""
    return csv_of(result).encode()


def numbers_file(result: SceneTorque, **more: Any) -> bytes:
    """JSON, SI; more : what else it holds."""
    content = plain(torque_file(result)) | more | {"run": plain(provenance_of(result.scene))}
    return json.dumps(content, indent=1, allow_nan=False).encode()


def figure_file(result: SceneTorque) -> bytes:
    """The figure as PNG."""
    from fembearing.report.figures.style import png  # with matplotlib: only a figure pays for it

    return png(result.plot())


def vector_file(result: SceneTorque) -> bytes:
    """The figure as SVG."""
    from fembearing.report.figures.style import svg

    return svg(result.plot())


def printed_file(result: SceneTorque) -> bytes:
    """The figure as PDF."""
    from fembearing.report.figures.style import pdf

    return pdf(result.plot())


def page_file(result: SceneTorque) -> bytes:
    """The page."""
    from fembearing.report.page.torque_alone import torque_page

    return torque_page(result, vector_file(result)).encode()


def compared_content(target: Path) -> ComparedContent:
    """What a file of this name holds of several scenes. Raises InputError for any other than table and figure."""
    from fembearing.report.figures.style import pdf, png, svg

    if target.suffix.casefold() == ".csv":
        return lambda results: compared_csv(results).encode()
    image = {".png": png, ".svg": svg, ".pdf": pdf}.get(target.suffix.casefold())
    if image is None:
        raise InputError(
            f"--out {str(target)!r} takes one scene: give one, or for several a file that ends with .csv, .png, .svg "
            "or .pdf"
        )
    require_packages(f"--out {str(target)!r}", "matplotlib")

    def content(results: Mapping[str, SceneTorque]) -> bytes:
        from fembearing.report.figures.torque import compared_figure

        return image(compared_figure({name: result.drawn for name, result in results.items()}))

    return content


CONTENTS: Mapping[str, Content] = {
    ".csv": table_file,
    ".json": numbers_file,
    ".png": figure_file,
    ".svg": vector_file,
    ".pdf": printed_file,
    ".html": page_file,
}
