"""`fembearing cost`."""

from contextlib import nullcontext

from fembearing.cli.options import (
    AsJson,
    Folder,
    Force,
    Given,
    SceneName,
    Talk,
    Tolerance,
    read_tolerance,
    require_folder_name,
)


def cost(
    given: Given,
    talk: Talk,
    scene: SceneName = None,
    tolerance: Tolerance = None,
    folder: Folder = None,
    force: Force = False,
    as_json: AsJson = False,
) -> None:
    """Measure error and time of all methods for the same quantity on this machine, from cheap to exact."""
    require_folder_name(folder)
    read = given.scene(scene)
    limit = read_tolerance(tolerance, read)
    from analytic.writing import new_folder
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import plain
    from fembearing.report.folder import write_cost
    from fembearing.report.terminal.cost import print_cost
    from fembearing.verify.cost.scene_cost import measure_cost

    with talk.progress() as progress, nullcontext() if folder is None else new_folder(folder, force=force) as place:
        result = measure_cost(read, tolerance=limit, progress=progress)
        if place is not None:
            write_cost(result, place)
    if as_json:
        print_json(plain(result))
    else:
        print_cost(out, result)
        talk.warn(read.warnings, read=read.warnings)
