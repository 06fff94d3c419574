"""One file of a torque: the table, the numbers, the figure or a page, by the ending of its name."""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from analytic.errors import InputError
from analytic.scene_torque import SceneTorque
from fembearing.csv_text import csv_of_columns
from fembearing.plain_types import json_of
from fembearing.provenance import provenance_of
from fembearing.quantities import shown_unit
from fembearing.report.document import Bullets, Section
from fembearing.report.torque import content_of

Content = Callable[[SceneTorque], bytes]


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
    """CSV: a row for each operating point, and the name of the bearing last; columns that hold nothing are left out."""
    columns = {}
    for name, (_, values, column) in result.columns().items():
        known = np.where(np.isfinite(values), values, np.nan)  # an uncertainty that is not known is infinite
        if not np.isnan(known).all():
            columns[name] = (shown_unit(name, column.unit), known)
    bearing = [result.scene.bearing.name] * len(result.points)
    return csv_of_columns(columns, number="point", words={"bearing": bearing}).encode()


def numbers_file(result: SceneTorque, **more: Any) -> bytes:
    """JSON, SI; more : what else it holds."""
    return json_of("torque", content_of(result), **more, run=provenance_of(result.scene)).encode()


def figure_file(result: SceneTorque) -> bytes:
    """The figure as PNG."""
    from fembearing.report.figures.style import png  # with matplotlib: only a figure pays for it
    from fembearing.report.figures.torque_alone import figure_of_torque

    return png(figure_of_torque(result))


def vector_file(result: SceneTorque) -> bytes:
    """The figure as SVG."""
    from fembearing.report.figures.style import svg
    from fembearing.report.figures.torque_alone import figure_of_torque

    return svg(figure_of_torque(result))


def printed_file(result: SceneTorque) -> bytes:
    """The figure as PDF."""
    from fembearing.report.figures.style import pdf
    from fembearing.report.figures.torque_alone import figure_of_torque

    return pdf(figure_of_torque(result))


def page_file(result: SceneTorque) -> bytes:
    """The page."""
    from fembearing.report.figures.page_plots import embedded
    from fembearing.report.page.document import page_of_sections
    from fembearing.report.sections.torque import headline_section, torque_sections

    sections = [headline_section(result), *torque_sections(result, figure=embedded(vector_file(result), "svg+xml"))]
    warnings = [Section("Warnings", [Bullets(result.friction.warnings)])] if result.friction.warnings else []
    title = f"{result.scene.name}: friction torque"
    return page_of_sections(title, [*sections, *warnings], provenance_of(result.scene)).encode()


CONTENTS: Mapping[str, Content] = {
    ".csv": table_file,
    ".json": numbers_file,
    ".png": figure_file,
    ".svg": vector_file,
    ".pdf": printed_file,
    ".html": page_file,
}
