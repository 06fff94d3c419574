"""`fembearing cost`."""

from contextlib import nullcontext

from fembearing.cli.options import AsJson, Folder, SceneName, Tolerance, read_scene, read_tolerance, require_folder_name
from fembearing.cli.status import print_warnings


def cost(
    scene: SceneName = None,
    tolerance: Tolerance = None,
    folder: Folder = None,
    as_json: AsJson = False,
) -> None:
    """Measure error and time of all methods for the same quantity on this machine, from cheap to exact."""
    require_folder_name(folder)
    given = read_scene(scene)
    limit = read_tolerance(tolerance, given)
    from analytic.writing import new_folder
    from fembearing.cli.console import out, print_json, shown_progress
    from fembearing.plain_types import plain
    from fembearing.report.folder import write_cost
    from fembearing.report.terminal.cost import print_cost
    from fembearing.verify.cost.scene_cost import measure_cost

    with shown_progress() as progress, nullcontext() if folder is None else new_folder(folder) as place:
        result = measure_cost(given, tolerance=limit, progress=progress)
        if place is not None:
            write_cost(result, place)
    if as_json:
        print_json(plain(result))
    else:
        print_cost(out, result)
        print_warnings(given.warnings)
