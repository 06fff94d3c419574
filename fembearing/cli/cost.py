"""`fembearing cost`."""

from fembearing.cli.options import (
    AsJson,
    Given,
    Output,
    SceneName,
    Talk,
    Tolerance,
    read_tolerance,
)


def cost(
    given: Given,
    output: Output,
    talk: Talk,
    scene: SceneName = None,
    tolerance: Tolerance = None,
    as_json: AsJson = False,
) -> None:
    """Measure error and time of all methods for the same quantity on this machine, from cheap to exact."""
    read = given.scene(scene)
    limit = read_tolerance(tolerance, read)
    from fembearing.check.cost.scene_cost import measure_cost
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import plain
    from fembearing.report.folder import write_cost
    from fembearing.report.terminal.cost import print_cost

    with talk.progress() as progress, output.opened() as place:
        result = measure_cost(read, tolerance=limit, progress=progress)
        if place is not None:
            write_cost(result, place)
    if as_json:
        print_json(plain(result))
    else:
        print_cost(out, result)
        talk.warn(read.warnings, read=read.warnings)
