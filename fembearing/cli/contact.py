"""`fembearing contact`."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from fembearing.cli.options import (
    AsJson,
    GeometryName,
    Given,
    Output,
    PairName,
    SceneName,
    Talk,
    Tolerance,
    read_load,
    read_tolerance,
    require_folder_name,
)
from fembearing.cli.status import reached

if TYPE_CHECKING:
    from analytic.progress import Progress
    from analytic.scene import Scene
    from fembearing.check.contact.solution import ContactSolution
    from fembearing.check.contact.subsurface import SubsurfaceComparison


Loads = Annotated[
    list[str] | None,
    typer.Option(
        "--load",
        help='Load of the ball, for example "620 N" (default: from the scene). Several give the stiffness law.',
    ),
]
Geometry = Annotated[
    GeometryName,
    typer.Option(
        help="Meshed shape. real: true shapes; hertzian: half spaces, with Hertz as exact solution; wall: sheet of a "
        "pocket on its rim; ring: true shapes, and the ring on a rigid seat as a separate part."
    ),
]
Meshes = Annotated[
    Path | None,
    typer.Option("--mesh", help="Folder for the meshes of ball and race (.vtu), which are written, and not solved."),
]


def contact(
    given: Given,
    output: Output,
    talk: Talk,
    scene: SceneName = None,
    pair: Annotated[PairName, typer.Option(help="Contact of the ball.")] = "inner",
    load: Loads = None,
    geometry: Geometry = "real",
    tolerance: Tolerance = None,
    mesh: Meshes = None,
    level: Annotated[int | None, typer.Option(help="Level of the mesh with --mesh (default: the finest).")] = None,
    as_json: AsJson = False,
) -> None:
    """Solve one contact by finite elements and compare Hertz with it. Several --load give the stiffness law.

    The accuracy is that of the finite elements; the limit for Hertz is always the tolerance of the scene. Exit status
    0: required accuracy reached, for any verdict on Hertz; 2: input error; 3: accuracy not reached.
    """
    read = given.scene(scene)
    limit = read_tolerance(tolerance, read)
    loads = [force for text in load or () if (force := read_load(text)) is not None]
    from analytic.errors import InputError

    if mesh is not None:
        _require_mesh_only({"--tolerance": tolerance, "--out": output.folder}, loads)
        meshes = _write_meshes(read, mesh, pair=pair, geometry=geometry, load=loads[0] if loads else None, level=level)
        _show_meshes(meshes, read, talk, as_json=as_json)
        return
    if level is not None:
        raise InputError(f"--level {level} goes with --mesh; --tolerance decides on the meshes of a solution")
    from analytic.units import SYSTEMS
    from fembearing.check.contact.load_series import solve_load_series
    from fembearing.check.contact.refinement import COMPARED
    from fembearing.check.contact.solution import SHOWN_OF_A_SHEET, solve_contact
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import document, json_of
    from fembearing.report.files import solution_files, write_all
    from fembearing.report.sections.contacts import contact_sections, series_sections
    from fembearing.report.terminal import print_sections

    units = SYSTEMS[read.report.units]
    with talk.progress() as progress, output.opened() as place:
        settings: dict[str, Any] = {"pair": pair, "accuracy": limit, "geometry": geometry, "progress": progress}
        if len(loads) > 1:
            found = solve_load_series(read, loads=loads, **settings)
            sections, content = series_sections(found, units), document("load series", found)
            studies = {f"approach at {part.load:g} N": part.approach.study for part in found.points}
            unsure = {name: study.total for name, study in studies.items() if study}
            if place is not None:
                write_all({"contact.json": json_of("load series", found)}, place)
        else:
            result, below = _with_stress(solve_contact(read, load=loads[0] if loads else None, **settings), progress)
            found = result.numbers
            sections = contact_sections(found, below, units)
            content = document("contact", found, accuracy=limit, subsurface=below)
            unsure = {name: found.estimates[name].total for name in (COMPARED if found.judged else SHOWN_OF_A_SHEET)}
            if place is not None:
                write_all(solution_files(result, accuracy=limit, subsurface=below), place)
    if as_json:
        print_json(content)
    else:
        print_sections(out, sections)
        talk.warn(found.warnings, read=read.warnings)
    worst = max(unsure, key=lambda name: unsure[name])
    raise typer.Exit(reached(limit, worst, unsure[worst]))


def _with_stress(
    result: "ContactSolution", progress: "Progress"
) -> "tuple[ContactSolution, SubsurfaceComparison | None]":
    """The stress under the contact; without it the solution has a warning."""
    from analytic.errors import InputError
    from fembearing.check.contact.subsurface import compare_subsurface

    progress(0.8, f"{result.contact.pair}: stress under the contact")
    try:
        return result, compare_subsurface(result)
    except InputError as problem:  # a contact cut off at a shoulder: everything else is known
        return result.with_numbers(warnings=(*result.numbers.warnings, str(problem))), None


def _require_mesh_only(of_solution: dict[str, Any], loads: list[float]) -> None:
    """Raise InputError for an option of a solution beside --mesh, and for several loads."""
    from analytic.errors import InputError

    for option, asked in of_solution.items():
        if asked is not None:
            raise InputError(f"{option} {str(asked)!r} does not go with --mesh, which solves nothing: leave it out")
    if len(loads) > 1:
        raise InputError(f"--mesh takes one --load, and there are {len(loads)}: give one")


def _write_meshes(
    scene: "Scene", folder: Path, *, pair: PairName, geometry: GeometryName, load: float | None, level: int | None
) -> dict[str, dict[str, Any]]:
    """Write both meshes of a contact; the quality of each by its file."""
    from analytic.errors import InputError
    from fembearing.check.contact.scene_contact import as_meshed, contact_of, recipe_of, traced_to_load
    from fembearing.fem.guess import expected_semi_axes
    from fembearing.mesh.meshfile import write_body
    from fembearing.mesh.pair import pair_mesh
    from fembearing.mesh.quality import mesh_quality
    from fembearing.mesh.ring import ring_piece

    require_folder_name(folder, option="--mesh")
    recipe = recipe_of(geometry, pair=pair)
    chosen = recipe.levels[-1] if level is None else level
    if chosen not in recipe.levels:
        raise InputError(f"--level {chosen}: recipe {recipe.name} has levels {', '.join(map(str, recipe.levels))}")
    meshed = as_meshed(contact_of(scene, pair=pair, load=load), recipe=recipe)
    with traced_to_load(scene, pair=pair, load=load):
        expected = expected_semi_axes(meshed, geometry=recipe.geometry)
        bodies = pair_mesh(meshed, recipe=recipe, level=chosen, semi_axes=expected)
        lower = ring_piece(meshed, recipe, chosen, expected).body if geometry == "ring" else bodies.lower
    written = {}
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as problem:
        raise InputError(f"--mesh {str(folder)!r}: {problem.strerror}; give a folder for the meshes") from problem
    for end, body in (("upper", bodies.upper), ("lower", lower)):
        file = folder / f"{pair}-{geometry}-{end}.vtu"
        write_body(file, body)
        written[str(file)] = asdict(mesh_quality(body.mesh)) | {"body": body.name, "level": chosen}
    return written


def _show_meshes(meshes: dict[str, dict[str, Any]], scene: "Scene", talk: Talk, *, as_json: bool) -> None:
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from fembearing.cli.console import out, print_json

    if as_json:
        print_json({"meshes": meshes, "warnings": scene.warnings})
        return
    talk.warn(scene.warnings, read=scene.warnings)
    table = Table("file", "body", "cells", "nodes", "least det J/mean", "there x, y, z, mm", box=SIMPLE_HEAD)
    for path, quality in meshes.items():
        place = ", ".join(f"{1e3 * part:.3g}" for part in quality["worst_place"])
        share = f"{quality['least_determinant']:.3f}"
        table.add_row(path, quality["body"], str(quality["cells"]), str(quality["nodes"]), share, place)
    out.print(table)
