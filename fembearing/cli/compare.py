"""`fembearing compare`."""

from typing import Annotated

import typer

from fembearing.cli.assumed import in_a_file, tell_assumed
from fembearing.cli.options import AsJson, Folder, Samples, require_folder_name, scene_names_like, with_details
from fembearing.cli.status import STATUS, print_warnings

Data = Annotated[
    str | None,
    typer.Argument(
        metavar="DATA",
        help="CSV file of measured torques, each column with its unit (default: from [measured] of the scene).",
    ),
]
SceneName = Annotated[
    str | None,
    typer.Argument(
        metavar="SCENE",
        help="Scene file (TOML) or bearing of the catalog, for example 6206; sufficient alone with [measured].",
        autocompletion=scene_names_like,
    ),
]
Seed = Annotated[int, typer.Option(help="Seed of the samples of the intervals.")]


def compare(
    data: Data = None,
    scene: SceneName = None,
    samples: Samples = None,
    seed: Seed = 1,
    folder: Folder = None,
    as_json: AsJson = False,
) -> None:
    """Compare the computed torque with measured torques: error, uncertainty and verdict of each.

    Give the CSV file and the scene, or the scene alone if its table [measured] names the file. Exit status 0: every
    measured torque lies in its 95 % interval; 1: at least one lies outside; 2: input error.
    """
    require_folder_name(folder)
    data, scene = _data_and_scene(data, scene)
    from contextlib import nullcontext

    from analytic.scenefile.assumption import assumptions
    from analytic.scenefile.read import load_scene
    from analytic.writing import new_folder
    from fembearing.cli.console import out, print_json, shown_progress
    from fembearing.plain_types import plain
    from fembearing.quantities import SYSTEMS
    from fembearing.report.measured_folder import ComparisonFile, write_comparison
    from fembearing.report.tables.measured import measured_table
    from fembearing.report.terminal.table import show
    from fembearing.verify.measured.comparison import compare_measured

    given = with_details(load_scene(scene, measured=data))
    with shown_progress() as progress, nullcontext() if folder is None else new_folder(folder) as place:
        result = compare_measured(given, samples=samples, seed=seed, progress=progress)
        if place is not None:
            write_comparison(result, given, place)
    if as_json:
        print_json(plain(ComparisonFile(**vars(result))))
    else:
        show(out, measured_table(result, SYSTEMS[given.report.units]))
        if given.measured is not None:
            tell_assumed(assumptions(scene, given, columns=vars(given.measured)), change=in_a_file(scene))
        print_warnings(result.warnings)
        if folder is not None:
            out.tell(f"report: {folder / 'compare.html'}")
        count = f"{result.inside} of {len(result.rows)} inside"
        out.tell(f"{result.verdict}: {count}, {result.samples} samples, {result.seconds:.1f} s")
    raise typer.Exit(STATUS[result.verdict])


def _data_and_scene(data: str | None, scene: str | None) -> tuple[str | None, str]:
    """The two arguments; one alone is the scene. Raises InputError for none, and for one in the place of the other."""
    from analytic.errors import InputError

    if data is None:
        raise InputError("give the measured torques and the scene: fembearing compare data.csv bearing.toml")
    if scene is None and data.casefold().endswith(".csv"):
        raise InputError(f"{data!r} has the measured torques; give the scene after it: fembearing compare {data} SCENE")
    if scene is not None and scene.casefold().endswith(".csv"):
        raise InputError(f"give the measured torques first: fembearing compare {scene} {data}")
    return (None, data) if scene is None else (data, scene)
