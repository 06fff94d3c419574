"""`fembearing report`."""

from pathlib import Path
from typing import Annotated

import typer

from fembearing.cli.options import AsJson
from fembearing.cli.report_options import given_details, with_report_options
from fembearing.cli.status import say


@with_report_options
def report(
    numbers: Annotated[Path, typer.Argument(metavar="REPORT.JSON", help="Numbers of a report.")],
    page: Annotated[
        Path | None,
        typer.Option(
            "--out", "-o", help="Page (default: report.html beside REPORT.JSON). Only pages of fembearing are replaced."
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Rebuild the page of a report from its numbers and the pictures in the same folder."""
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import plain
    from fembearing.report.page.rebuild import rebuild_page

    result = rebuild_page(numbers, out=page, details=given_details())
    if as_json:
        print_json(plain(result))
    else:
        out.tell(f"page: {result.page}")
    for name in result.missing:
        say(f"picture {name} is missing beside {numbers}; the page notes it")
