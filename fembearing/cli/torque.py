"""`fembearing torque`."""

from collections.abc import Collection, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from fembearing.cli.options import (
    BUILTIN,
    AsJson,
    Force,
    GivenAccurate,
    Samples,
    SceneNames,
    Talk,
    WithInterval,
    read_samples,
)
from fembearing.cli.status import CHECK_FAILED, DONE, NOT_SOLVED, STANDING_STATUS, say

if TYPE_CHECKING:
    from analytic.scene_torque import SceneTorque


Target = Annotated[
    Path | None,
    typer.Option(
        "--out",
        "-o",
        help="New folder for torque.json, torque.csv, torque.png and time series; or one file: .csv, .json, .png, "
        ".svg, .pdf, .html. Several scenes: .csv, .png, .svg, .pdf.",
    ),
]


def torque(
    given: GivenAccurate,
    talk: Talk,
    scenes: SceneNames = None,
    target: Target = None,
    force: Force = False,
    with_interval: WithInterval = False,
    samples: Samples = None,
    keep_going: Annotated[
        bool, typer.Option("--keep-going", help="Skip operating points without a torque, with the reason.")
    ] = False,
    details: Annotated[
        bool, typer.Option("--details", help="Print contacts, cage, effects, inputs, methods and limits.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Friction torque of a scene with its 95 % interval and a verdict. Several scenes are compared.

    A bearing of the catalog needs no file: loads, speed, oil, temperature and supply are options. Missing options are
    assumed and printed. --speed 0rpm gives the starting torque.
    """
    names = scenes or [BUILTIN]
    _require_different(names)
    content = None
    if target is not None and len(names) > 1:
        from fembearing.report.torque_file import compared_content

        content = compared_content(target)
    read = {name: given.scene(name) for name in names}
    count = read_samples(samples, with_interval=with_interval)
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import document
    from fembearing.report.torque import content_of
    from fembearing.report.torque_folder import torque_with_files

    results: dict[str, SceneTorque] = {}
    lacking = None
    with talk.progress() as progress, _file_of_all(target if content else None, force=force) as file:
        for name, scene in read.items():
            with _named(name if len(read) > 1 else None):
                results[name], lacking = torque_with_files(
                    scene,
                    out=None if content else target,
                    force=force,
                    samples=count,
                    keep_going=keep_going,
                    progress=progress,
                )
        if content is not None and file is not None:
            file.write_bytes(content(results))
    if as_json:
        files = {name: document("torque", content_of(result)) for name, result in results.items()}
        print_json(files if len(files) > 1 else files[names[0]])
    else:
        _print(results, talk, details=details)
        if target is not None:
            out.tell(f"{'file' if target.suffix else 'folder'}: {target}")
    if lacking is not None:
        say(lacking)
    raise typer.Exit(_status(results.values()))


def _file_of_all(target: Path | None, *, force: bool) -> AbstractContextManager[Path | None]:
    """A file for several scenes, which must not exist yet; none for one scene."""
    from analytic.writing import new_file

    return nullcontext() if target is None else new_file(target, force=force)


def _require_different(names: list[str]) -> None:
    """Raises InputError for a scene that stands twice."""
    from analytic.errors import InputError

    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise InputError(f"the scene {twice!r} is given twice: leave one of them out")


@contextmanager
def _named(name: str | None) -> Iterator[None]:
    """An InputError that arises begins with the name of its scene; None: there is one scene alone."""
    from analytic.errors import InputError

    try:
        yield
    except InputError as problem:
        raise problem if name is None else InputError(f"{name}: {problem}") from problem


def _print(results: "Mapping[str, SceneTorque]", talk: Talk, *, details: bool) -> None:
    from rich.markup import escape

    from analytic.units import SYSTEMS
    from fembearing.cli.console import out, tell_assumed
    from fembearing.report.document import Section
    from fembearing.report.sections.headline import headline_section, side_by_side
    from fembearing.report.sections.torque import torque_sections
    from fembearing.report.terminal import print_sections

    if len(results) > 1:
        units = SYSTEMS[next(iter(results.values())).scene.report.units]
        print_sections(out, [Section("", [side_by_side(results, units)])])
    for name, result in results.items():
        before = f"{name}: " if len(results) > 1 else ""
        if before and details:
            out.rule(escape(name))
        if details or not before:
            print_sections(out, [headline_section(result)])
        tell_assumed(result.scene.usual, before=before)
        if details:
            out.print()
            print_sections(out, torque_sections(result))
        said = {warning: f"{before}{warning}" for warning in result.friction.warnings}
        talk.warn(said.values(), read=[said[each] for each in result.scene.warnings if each in said])


def _status(results: "Collection[SceneTorque]") -> int:
    """That of the worst scene; a failed check before what is not solved."""
    statuses = {STANDING_STATUS[result.standing.word] for result in results}
    statuses |= {NOT_SOLVED for result in results if result.places.failures}
    return next((status for status in (CHECK_FAILED, NOT_SOLVED) if status in statuses), DONE)
