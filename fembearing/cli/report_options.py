"""The options that stand for keys of a scene's table [report]: --author, --checker, --revision, --date, --units."""

from typing import Annotated, Any

import typer

from analytic.units import UnitSystem
from fembearing.cli.added_options import given, with_options

OPTIONS: dict[str, Any] = {
    "author": Annotated[str | None, typer.Option(help="Author of the report (default: from the scene).")],
    "checker": Annotated[str | None, typer.Option(help="Checker of the report (default: from the scene).")],
    "revision": Annotated[str | None, typer.Option(help="Revision of the report (default: from the scene).")],
    "date": Annotated[str | None, typer.Option(help="Date of the revision (default: from the scene).")],
    "units": Annotated[
        UnitSystem | None, typer.Option(help="Units of page and tables (default: from the scene, or metric).")
    ],
}
UNITS = {"units": OPTIONS["units"]}  # of commands that print no report
with_report_options = with_options(OPTIONS)


def given_details() -> dict[str, str]:
    """The details of the report that options give. Raises InputError for a text that no key of [report] takes."""
    from analytic.errors import InputError
    from analytic.scenefile.keys import scene_key
    from analytic.words import shown

    details = given(OPTIONS)
    for name, text in details.items():
        try:
            scene_key(f"report.{name}").read(text)
        except ValueError as problem:
            raise InputError(f"--{name} {shown(text)} {problem}") from None
    return details


def shown_system() -> UnitSystem:
    """The units of a command that reads no scene: of the option, or of the user's settings."""
    from fembearing.cli.config import own_details

    return given(UNITS).get("units") or own_details().get("units", "metric")
