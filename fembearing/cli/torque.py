"""`fembearing torque`."""

from collections import Counter
from collections.abc import Collection, Iterator, Mapping
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

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
from fembearing.cli.status import CHECK_FAILED, DONE, NOT_SOLVED, STANDING_STATUS, print_warnings, say

if TYPE_CHECKING:
    from analytic.errors import InputError
    from analytic.scene import Scene
    from analytic.scene_torque import SceneTorque
    from fembearing.report.torque_file import ComparedContent


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
        bool, typer.Option("--keep-going", help="Skip operating points and scenes without a torque, with the reason.")
    ] = False,
    details: Annotated[
        bool, typer.Option("--details", help="Print contacts, cage, effects, inputs, methods and limits.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Friction torque of a scene with its 95 % interval and a verdict. Several scenes are compared.

    A bearing of the catalog needs no file: loads, speed, oil, temperature and supply are options. Missing options are
    assumed and printed. --speed 0rpm gives the starting torque. A list of bearings (.csv, .xlsx) has a column
    designation, and columns as these options, which take their place.
    """
    requested = _requested(scenes or [BUILTIN], given)
    content = _content_of_all(target, len(requested))
    lost: list[InputError] = []
    read: dict[str, Scene] = {}
    for name, one in requested.items():
        with _named(one.place, lost, keep_going=keep_going):
            read[name] = one.scene()
    count = read_samples(samples, with_interval=with_interval)
    from analytic.progress import part_of
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import document
    from fembearing.report.torque import content_of
    from fembearing.report.torque_folder import torque_with_files

    results: dict[str, SceneTorque] = {}
    lacking = None
    with talk.progress() as progress, _file_of_all(target if content else None, force=force) as file:
        for number, (name, scene) in enumerate(read.items()):
            with _named(requested[name].place, lost, keep_going=keep_going):
                results[name], lacking = torque_with_files(
                    scene,
                    out=None if content else target,
                    force=force,
                    samples=count,
                    keep_going=keep_going,
                    progress=part_of(progress, number / len(read), (number + 1) / len(read)),
                )
        if not results:
            raise lost[0]
        if content is not None and file is not None:
            file.write_bytes(content(results))
    if as_json:
        files = {name: document("torque", content_of(result)) for name, result in results.items()}
        print_json(files if len(requested) > 1 else next(iter(files.values())))
    else:
        _print(results, talk, details=details)
        if target is not None:
            out.tell(f"{'file' if target.suffix else 'folder'}: {target}")
    for problem in lost:
        say(f"skipped: {problem}")
    if lacking is not None:
        say(lacking)
    raise typer.Exit(_status(results.values(), lost))


class Requested(NamedTuple):
    """A scene of the command line, or a row of a list."""

    place: str  # as messages begin; "": they need not say it
    name: str
    given: GivenAccurate
    is_listed: bool = False  # in a list, which has bearings of the catalog alone

    def scene(self) -> "Scene":
        """Raises InputError as `Given.scene`."""
        if self.is_listed:
            from analytic.catalog.bearing_rows import find_bearing

            find_bearing(self.name)
        return self.given.scene(self.name)


def _requested(names: list[str], given: GivenAccurate) -> dict[str, Requested]:
    """The scenes by their names in the tables. Raises InputError for one that is named twice."""
    from analytic.errors import InputError
    from analytic.scenefile.bearing_list import ENDINGS, read_list

    requested: dict[str, Requested] = {}
    times = Counter[str]()
    for name in names:
        if not name.casefold().endswith(ENDINGS):
            if name in requested:
                raise InputError(f"the scene {name!r} is given twice: leave one of them out")
            requested[name] = Requested(name if len(names) > 1 else "", name, given)
            continue
        rows, warnings = read_list(name)
        print_warnings(warnings)
        for designation, place, options in rows:
            times[designation] += 1
            again = f" ({times[designation]})" if times[designation] > 1 or designation in names else ""
            own = replace(given, **(options | given.options))
            requested[designation + again] = Requested(place, designation, own, is_listed=True)
    return requested


@contextmanager
def _named(place: str, lost: "list[InputError]", *, keep_going: bool) -> Iterator[None]:
    """An InputError that arises begins with the place of its scene; where the others go on, it is among the lost."""
    from analytic.errors import InputError

    try:
        yield
    except InputError as problem:
        named = InputError(f"{place}: {problem}") if place else problem
        if not keep_going:
            raise named from problem
        lost.append(named)


def _content_of_all(target: Path | None, count: int) -> "ComparedContent | None":
    """What a file for several scenes holds; None for one scene, or without a file. Raises InputError as that."""
    if target is None or count == 1:
        return None
    from fembearing.report.torque_file import compared_content

    return compared_content(target, count)


def _file_of_all(target: Path | None, *, force: bool) -> AbstractContextManager[Path | None]:
    """A file for several scenes, which must not exist yet; none for one scene."""
    from analytic.writing import new_file

    return nullcontext() if target is None else new_file(target, force=force)


def _print(results: "Mapping[str, SceneTorque]", talk: Talk, *, details: bool) -> None:
    from rich.markup import escape

    from analytic.units import SYSTEMS
    from fembearing.cli.console import out, tell_assumed
    from fembearing.report.document import Section
    from fembearing.report.sections.headline import headline_section, names_by, side_by_side
    from fembearing.report.sections.torque import torque_sections
    from fembearing.report.terminal import print_sections

    if len(results) > 1:
        units = SYSTEMS[next(iter(results.values())).scene.report.units]
        print_sections(out, [Section("", [side_by_side(results, units)])])
    usual = {name: tuple(result.scene.usual.items()) for name, result in results.items()}
    for assumed, names in names_by(usual.items()).items():
        tell_assumed(dict(assumed), before=names if len(results) > 1 else "")
    for name, result in results.items():
        if details and len(results) > 1:
            out.rule(escape(name))
        if details or len(results) == 1:
            print_sections(out, [headline_section(result)])
        if details:
            out.print()
            print_sections(out, torque_sections(result))
    said = names_by((name, each) for name, result in results.items() for each in result.friction.warnings)
    lines = {each: f"{names if len(results) > 1 else ''}{each}" for each, names in said.items()}
    of_input = {each for result in results.values() for each in result.scene.warnings}
    talk.warn(lines.values(), read=[line for each, line in lines.items() if each in of_input])


def _status(results: "Collection[SceneTorque]", lost: "Collection[InputError]") -> int:
    """That of the worst scene; a failed check before what is not solved, as scenes that are lost."""
    statuses = {STANDING_STATUS[result.standing.word] for result in results}
    statuses |= {NOT_SOLVED for result in results if result.places.failures} | {NOT_SOLVED for _ in lost}
    return next((status for status in (CHECK_FAILED, NOT_SOLVED) if status in statuses), DONE)
