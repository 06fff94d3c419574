"""The main job with its report in a folder."""

import os
from collections.abc import Callable
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Unpack

from analytic.any_scene import scene_by
from analytic.given import SceneOptions
from analytic.progress import Progress, part_of, silent
from analytic.scene import Scene
from analytic.scene_torque import Samples
from analytic.scenefile.parts import Given
from analytic.writing import new_folder, write
from fembearing.check.contact.solution import ContactSolution
from fembearing.check.film.scene_film import RaceFilm
from fembearing.check.validation import Validation, check_scene
from fembearing.plain_types import json_of

if TYPE_CHECKING:
    from fembearing.report.document import Block
    from fembearing.report.report import PictureFile, Report
    from fembearing.report.sections.validation import Drawn

NOTHING: "Drawn" = MappingProxyType({})
CHECKED = 0.75  # of the whole job, when the contacts are solved and the report is still to be written


def validate(
    scene: Scene | str | os.PathLike[str],
    *,
    out: Path | str | None = None,
    force: bool = False,
    tolerance: Given | None = None,
    cost: bool = False,
    samples: Samples = None,
    film: bool = True,
    creep: bool = True,
    progress: Progress = silent,
    at_contacts: Callable[[tuple[ContactSolution, ...]], None] = lambda _contacts: None,
    **given: Unpack[SceneOptions],
) -> Validation:
    """Check every contact of a scene, and write the report.

    Parameters
    ----------
    scene : Scene, str or path
        Of one bearing or of a pair, of which both are checked.
    out : str or path, optional
        Folder for report.html, report.json, pictures and meshes (.vtu). None writes nothing.
    force : bool
        The folder takes the place of one with files of fembearing only; else it must not exist yet.
    tolerance : float or str, optional
        Relative (dimensionless); None: the scene's.
    cost : bool
        Measure every method of every ladder too.
    samples : int or "enough", optional
        Number of samples of the torque's 95 % interval; None: no interval.
    film : bool
        Solve the lubricated contacts of both races too, where there is oil and motion.
    creep : bool
        Solve stick and slip of the heaviest ball on both races too, where something slides.
    progress : callable
        Called with the share done, 0 to 1 (dimensionless), and a word on the step at hand; from several threads, one
        call at a time.
    at_contacts : callable, optional
        Called with all contacts as soon as they are solved, while film and friction are.
    **given : float, str, list or mapping
        With a name, the other arguments of `load_scene`: radial_load="3 kN", speed="3000 rpm", settings.

    Returns
    -------
    Validation
        Contacts both ways, the torque, and the verdicts, SI.

    Raises
    ------
    InputError
        The scene cannot be solved, or the folder cannot be made.
    ConvergenceError
        A contact does not settle.

    Notes
    -----
    Sources: those of `solve_contact` and of `analytic.friction_torque`; the comparison is in the terms of [ASME2009].
    """
    scene = scene_by(scene, given)
    with nullcontext() if out is None else new_folder(Path(out), force=force) as folder:
        checked = 1.0 if folder is None else CHECKED
        solving = part_of(progress, 0.0, checked)
        result = check_scene(
            scene,
            tolerance=tolerance,
            cost=cost,
            samples=samples,
            film=film,
            creep=creep,
            progress=solving,
            at_contacts=at_contacts,
        )
        if folder is not None:
            progress(CHECKED, "report")
            result, _ = write_report(result, folder)
    return result


def write_report(result: Validation, folder: Path) -> "tuple[Validation, Report]":
    """Write report.html, report.json, pictures and meshes into a folder.

    Gives the result, with what troubled the writing, and the report that is written.
    """
    from fembearing.report.figures.page_plots import PLOTS, pictures_of, plots_of  # with matplotlib
    from fembearing.report.pictures.creep import creep_pictures
    from fembearing.report.pictures.draw import draw_pictures
    from fembearing.report.report import report_of
    from fembearing.report.sections.cost import cost_csv

    plots: dict[str, list[Block]] = {}

    def draw_plots() -> None:
        plots.update(plots_of(report_of(result), PLOTS))

    slipping = [picture for creep in result.creep for picture in creep_pictures(creep, folder)]
    pictures, trouble = draw_pictures(
        result.contacts, folder, besides=[each.job for each in slipping], meanwhile=draw_plots
    )
    if trouble:
        result = replace(result, trouble=(f"there are no pictures of contacts and friction: {trouble}",))
    listed = [*(picture.listed for picture in pictures), *(_film_picture(film, folder) for film in result.films)]
    listed += [each.listed for each in slipping if not trouble]
    document = report_of(result, pictures=listed)
    write(folder / "report.json", json_of("validation", document))
    drawn = pictures_of(document, folder)
    for name, blocks in plots.items():
        drawn.setdefault(name, []).extend(blocks)
    write(folder / "report.html", report_page(document, drawn))
    write(folder / "cost.csv", cost_csv(document.cost.ladders))
    return result, document


def report_page(document: "Report", drawn: "Drawn" = NOTHING) -> str:
    """The page of a check;  drawn : plots and pictures, by the name of their section"""
    from fembearing.report.page.document import page_of
    from fembearing.report.sections.validation import report_sections

    title = f"{document.scene.name}: friction torque and contact check"
    return page_of(title, report_sections(document, drawn), document.provenance, details=document.report)


def _film_picture(film: RaceFilm, folder: Path) -> "PictureFile":
    """Write the picture of a film beside report.json."""
    from fembearing.check.film.figure import CAPTION
    from fembearing.report.figures.style import png
    from fembearing.report.report import PictureFile

    pair, bearing = film.numbers.pair, film.numbers.bearing
    file = f"{f'{bearing}-' if bearing else ''}{pair}-film.png"
    write(folder / file, png(film.plot()))
    return PictureFile(file=file, kind="film", pair=pair, geometry="real", caption=CAPTION, bearing=bearing)
