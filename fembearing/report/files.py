"""What the results of a command are written to: the files of its folder, by their names."""

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from analytic.columns import COLUMNS, COORDINATES
from analytic.prediction.duty import DutyCycle
from analytic.scene import Scene
from analytic.standing import WorstStanding
from analytic.units import SYSTEMS
from analytic.writing import write
from fembearing.check.contact.solution import ContactSolution
from fembearing.check.cost.scene_cost import Cost
from fembearing.check.creep.scene_creep import SceneCreep
from fembearing.check.film.scene_film import RaceFilm
from fembearing.check.measured.comparison import ROW, MeasuredComparison
from fembearing.csv_text import csv_of_columns
from fembearing.plain_types import json_of
from fembearing.provenance import provenance_of

OF_STEP = ("duration", *COORDINATES, "temperature", "torque", "torque_low", "torque_high", "power", "energy")


def solution_files(solution: ContactSolution | RaceFilm, **others: Any) -> dict[str, str | bytes]:
    """contact.png or film.png, and contact.json or film.json with its caption; others : beside the numbers there"""
    from fembearing.check.contact import figure as contact  # with matplotlib: only a figure pays for it
    from fembearing.check.film import figure as film
    from fembearing.report.figures.style import png

    kind, drawn = ("contact", contact) if isinstance(solution, ContactSolution) else ("film", film)
    picture = {"file": f"{kind}.png", "caption": drawn.CAPTION}
    numbers = json_of(kind, solution.numbers, picture=picture, **others)
    return {f"{kind}.png": png(solution.plot()), f"{kind}.json": numbers}


def write_creep(creep: SceneCreep, folder: Path) -> str | None:
    """Write creep.json and a picture of each race into a folder; why there are no pictures, or None."""
    from fembearing.report.pictures.creep import creep_pictures
    from fembearing.report.pictures.draw import RENDERER, rendered

    pictures = creep_pictures(creep, folder)
    trouble = rendered([each.job for each in pictures], RENDERER)
    listed = [] if trouble else [{"file": each.file, "caption": each.caption} for each in pictures]
    write(folder / "creep.json", json_of("creep", creep.numbers, pictures=listed))
    return trouble


def cost_files(cost: Cost) -> dict[str, str | bytes]:
    """cost.png, cost.csv and cost.json."""
    from fembearing.report.figures.cost import cost_figures
    from fembearing.report.figures.style import png
    from fembearing.report.sections.cost import cost_csv

    ladders = cost.ladders
    figures = cost_figures(ladders, tolerance=cost.tolerance, most=len(ladders) + 1)
    return {"cost.png": png(*figures), "cost.csv": cost_csv(ladders), "cost.json": json_of("cost", cost)}


def duty_files(cycle: DutyCycle, standing: WorstStanding, scene: Scene) -> dict[str, str | bytes]:
    """duty.json, a line of duty.csv for each step, duty.png and duty.svg."""
    from fembearing.report.figures.duty import duty_figure
    from fembearing.report.figures.style import png, svg

    figure = duty_figure(cycle, SYSTEMS[scene.report.units])
    rows = [
        vars(step) | {"torque": step.torque.value, "torque_low": step.torque.low, "torque_high": step.torque.high}
        for step in cycle.steps
    ]
    columns = {name: np.array([row[name] for row in rows], dtype=float) for name in OF_STEP}
    shown = {name: (COLUMNS[name].shown(), values) for name, values in columns.items()}
    return {
        "duty.json": json_of("duty", cycle, standing=standing, run=provenance_of(scene)),
        "duty.csv": csv_of_columns(shown, first={"step": range(1, len(rows) + 1)}),
        "duty.png": png(figure),
        "duty.svg": svg(figure),
    }


def compared_files(comparison: MeasuredComparison, scene: Scene) -> dict[str, str | bytes]:
    """compare.html, compare.json, a line of compare.csv for each row, compare.png and compare.svg."""
    from fembearing.report.document import Bullets, Section
    from fembearing.report.figures.measured import caption_of, measured_figure
    from fembearing.report.figures.page_plots import drawing_of
    from fembearing.report.figures.style import png, svg
    from fembearing.report.page.document import page_of
    from fembearing.report.sections.measured import measured_sections

    units = SYSTEMS[scene.report.units]
    figure = measured_figure(comparison, units)
    origin = provenance_of(scene, seeds={"samples beside the measured torques": [comparison.seed]})
    sections = measured_sections(comparison, units, [drawing_of(figure, caption_of(comparison))])
    warnings = [Section("Warnings", [Bullets(comparison.warnings)])] if comparison.warnings else []
    columns = {name: (column.shown(), values) for name, (_, values, column) in comparison.columns().items()}
    table = csv_of_columns(
        columns,
        first={ROW: range(1, len(comparison.rows) + 1)},
        last={"verdict": [row.verdict for row in comparison.rows]},
    )
    return {
        "compare.json": json_of("compare", comparison, run=origin),
        "compare.csv": table,
        "compare.png": png(figure),
        "compare.svg": svg(figure),
        "compare.html": page_of("Measured and computed torque", [*sections, *warnings], origin),
    }


def write_all(files: Mapping[str, str | bytes], folder: Path) -> None:
    """Write files into a folder."""
    for name, content in files.items():
        write(folder / name, content)
