"""`fembearing cost`."""

from typing import TYPE_CHECKING

from fembearing.cli.options import AsJson, Given, Output, SceneName, Talk, Tolerance, read_tolerance

if TYPE_CHECKING:  # the solver takes a second to import
    from fembearing.check.cost.scene_cost import Cost


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
    from fembearing.cli.console import print_json
    from fembearing.plain_types import plain
    from fembearing.report.files import cost_files, write_all

    with talk.progress() as progress, output.opened() as place:
        result = measure_cost(read, tolerance=limit, progress=progress)
        if place is not None:
            write_all(cost_files(result), place)
    if as_json:
        print_json(plain(result))
    else:
        _print(result)
        talk.warn(read.warnings, read=read.warnings)


def _print(found: "Cost") -> None:
    """Each ladder with error, bound, time and memory, and the machine."""
    from analytic.words import percent_of
    from fembearing.cli.console import out
    from fembearing.report.document import Section
    from fembearing.report.sections.cost import cost_table
    from fembearing.report.terminal import print_sections

    print_sections(out, [Section("", [cost_table(found.ladders)])])
    machine = found.provenance
    versions = ", ".join(f"{name} {version}" for name, version in machine.versions.items() if version)
    out.print(
        f"Tolerance {percent_of(found.tolerance)}, {found.cost.seconds:.0f} s in all.\n{machine.processor}, "
        f"{machine.cores} cores, {machine.platform}, Python {machine.python}; {versions}.",
        markup=False,
    )
