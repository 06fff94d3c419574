"""`fembearing torque`."""

from dataclasses import replace
from typing import Annotated

import typer

from fembearing.cli.options import (
    AsJson,
    Samples,
    SceneName,
    Target,
    Tolerance,
    WithInterval,
    read_samples,
    read_scene,
    read_tolerance,
)
from fembearing.cli.status import DONE, NOT_SOLVED, STANDING_STATUS, print_warnings, say


def torque(
    scene: SceneName = None,
    tolerance: Tolerance = None,
    target: Target = None,
    with_interval: WithInterval = False,
    samples: Samples = None,
    keep_going: Annotated[
        bool, typer.Option("--keep-going", help="Leave out operating points that have no torque, and say why.")
    ] = False,
    details: Annotated[
        bool, typer.Option("--details", help="Contacts, cage, effects, inputs, methods and limits too.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Friction torque of a scene with its 95 % interval, and how far to trust it."""
    given, count = read_scene(scene), read_samples(samples, with_interval=with_interval)
    given = replace(given, tolerance=read_tolerance(tolerance, given))
    from fembearing.cli.console import out, print_json, shown_progress
    from fembearing.plain_types import plain
    from fembearing.report.terminal.torque import print_details, print_headline
    from fembearing.report.torque import torque_file
    from fembearing.report.torque_folder import torque_with_files

    with shown_progress() as progress:
        result, lacking = torque_with_files(given, out=target, samples=count, keep_going=keep_going, progress=progress)
    if as_json:
        print_json(plain(torque_file(result)))
    else:
        print_headline(out, result)
        if details:
            out.print()
            print_details(out, result)
        print_warnings(result.friction.warnings)
        if target is not None:
            out.tell(f"{'file' if target.suffix else 'folder'}: {target}")
    if lacking is not None:
        say(lacking)
    status = STANDING_STATUS[result.standing.word]
    raise typer.Exit(NOT_SOLVED if status == DONE and result.left_out else status)
