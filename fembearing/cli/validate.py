"""`fembearing validate`."""

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated

import typer

from fembearing.cli.options import (
    AsJson,
    GivenAccurate,
    Output,
    SceneName,
    Talk,
    WithInterval,
    text_options,
)
from fembearing.cli.status import STATUS

if TYPE_CHECKING:
    from analytic.scene import Scene


SIGNED = {  # details of [report], by their keys
    "author": "Author of the report (default: from the scene).",
    "checker": "Checker of the report (default: from the scene).",
    "revision": "Revision of the report (default: from the scene).",
    "date": "Date of the revision (default: from the scene).",
}


class Signed(text_options(SIGNED)):
    """Who made the report, and when, in place of what [report] of the scene says."""

    def of(self, scene: "Scene") -> "Scene":
        """The scene with these details. Raises InputError for a text that no key of [report] takes."""
        from analytic.errors import InputError
        from analytic.scenefile.keys import scene_key
        from analytic.words import shown

        details = {name: text for name, text in vars(self).items() if text is not None}
        for name, text in details.items():
            try:
                scene_key(f"report.{name}").read(text)
            except ValueError as problem:
                raise InputError(f"--{name} {shown(text)} {problem}") from None
        return replace(scene, report=replace(scene.report, **details))


def validate(
    given: GivenAccurate,
    output: Output,
    signed: Signed,
    talk: Talk,
    scene: SceneName = None,
    with_cost: Annotated[
        bool, typer.Option("--cost", help="Measure error and time of all methods, as `fembearing cost`.")
    ] = False,
    with_interval: WithInterval = False,
    no_film: Annotated[bool, typer.Option("--no-film", help="Skip the numerical film.")] = False,
    no_creep: Annotated[bool, typer.Option("--no-creep", help="Skip the numerical friction.")] = False,
    details: Annotated[
        bool, typer.Option("--details", help="Print tables of contacts, film, friction, torque and limits.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Check contacts, film, friction and torque of a scene against numerical references.

    One line per reference gives the largest difference; --details, --json and the report give all differences. That of
    the contacts stands beside the progress as soon as they are solved.
    """
    read = signed.of(given.scene(scene))
    from fembearing.cli.console import out, print_json, tell_assumed
    from fembearing.plain_types import document
    from fembearing.report.findings import contact_finding
    from fembearing.report.folder import validate as run
    from fembearing.report.report import report_of
    from fembearing.report.sections.headline import check_headline
    from fembearing.report.sections.validation import detail_sections
    from fembearing.report.terminal import print_sections

    with talk.progress() as progress:
        result = run(
            read,
            out=output.folder,
            force=output.force,
            cost=with_cost,
            samples="enough" if with_interval else None,
            film=not no_film,
            creep=not no_creep,
            progress=progress,
            at_contacts=lambda contacts: talk.early(contact_finding([each.numbers for each in contacts]).words),
        )
    report = report_of(result)
    if as_json:
        print_json(document("validation", report))
    else:
        tell_assumed(read.usual)
        print_sections(out, [check_headline(report)])
        if details:
            out.print()
            print_sections(out, detail_sections(report))
        talk.warn(result.warnings, read=read.warnings)
        if output.folder is not None:
            out.tell(f"report: {output.folder / 'report.html'}")
    raise typer.Exit(STATUS[result.verdict])
