"""`fembearing mesh`."""

from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from fembearing.cli.options import (
    AsJson,
    Geometry,
    Load,
    PairName,
    SceneName,
    read_load,
    read_scene,
    require_folder_name,
)
from fembearing.cli.status import print_warnings

if TYPE_CHECKING:
    from fembearing.mesh.bodies import BodyMesh


def mesh(
    folder: Annotated[Path, typer.Option("--out", "-o", help="Folder for the .vtu files, created if missing.")],
    scene: SceneName = None,
    pair: Annotated[PairName, typer.Option(help="Contact of the ball.")] = "inner",
    geometry: Geometry = "real",
    level: Annotated[int | None, typer.Option(help="Level of the mesh recipe (default: the finest).")] = None,
    load: Load = None,
    as_json: AsJson = False,
) -> None:
    """Write both meshes of a contact and print their worst cells."""
    from analytic.errors import InputError
    from fembearing.cli.console import print_json

    require_folder_name(folder)
    given = read_scene(scene)
    force = None if load is None else read_load(load)
    if str(folder) in ("", ".") or (folder.exists() and not folder.is_dir()):
        raise InputError(f"--out {str(folder)!r}: give a folder for the meshes")
    from fembearing.fem.guess import expected_semi_axes
    from fembearing.mesh.pair import pair_mesh
    from fembearing.mesh.ring import ring_piece
    from fembearing.verify.contact.scene_contact import as_meshed, contact_of, recipe_of, traced_to_load

    recipe = recipe_of(geometry, pair=pair)
    chosen = recipe.levels[-1] if level is None else level
    if chosen not in recipe.levels:
        raise InputError(f"--level {chosen}: recipe {recipe.name} has levels {', '.join(map(str, recipe.levels))}")
    meshed = as_meshed(contact_of(given, pair=pair, load=force), recipe=recipe)
    with traced_to_load(given, pair=pair, load=force):
        expected = expected_semi_axes(meshed, geometry=recipe.geometry)
        bodies = pair_mesh(meshed, recipe=recipe, level=chosen, semi_axes=expected)
        lower = ring_piece(meshed, recipe, chosen, expected).body if geometry == "ring" else bodies.lower
    files = {f"{pair}-{geometry}-upper.vtu": bodies.upper, f"{pair}-{geometry}-lower.vtu": lower}
    meshes = {str(folder / name): quality for name, quality in _write(files, folder).items()}
    if as_json:
        result = {"pair": pair, "geometry": geometry, "level": chosen, "meshes": meshes, "warnings": given.warnings}
        print_json(result)
    else:
        print_warnings(given.warnings)
        _print_table(meshes)


def _write(files: dict[str, "BodyMesh"], folder: Path) -> dict[str, dict[str, Any]]:
    """Write both files or neither; the quality of each."""
    from analytic.errors import InputError
    from analytic.writing import scratch_folder
    from fembearing.mesh.meshfile import write_body
    from fembearing.mesh.quality import mesh_quality

    try:
        folder.mkdir(parents=True, exist_ok=True)
        with scratch_folder(folder) as apart:
            for name, body in files.items():
                write_body(apart / name, body)
            for name in files:
                (apart / name).replace(folder / name)
    except OSError as problem:
        raise InputError(f"--out {str(folder)!r}: {problem.strerror}") from problem
    return {name: asdict(mesh_quality(body.mesh)) | {"body": body.name} for name, body in files.items()}


def _print_table(meshes: dict[str, dict[str, Any]]) -> None:
    from rich.box import SIMPLE_HEAD
    from rich.table import Table

    from fembearing.cli.console import out

    table = Table("file", "body", "cells", "nodes", "least det J/mean", "there x, y, z, mm", box=SIMPLE_HEAD)
    for path, quality in meshes.items():
        place = ", ".join(f"{1e3 * part:.3g}" for part in quality["worst_place"])
        share = f"{quality['least_determinant']:.3f}"
        table.add_row(path, quality["body"], str(quality["cells"]), str(quality["nodes"]), share, place)
    out.print(table)
