"""The command that makes the page of a report again."""

from pathlib import Path
from typing import Annotated

import typer

from fembearing.cli.console import out, print_json
from fembearing.cli.options import AsJson

EXAMPLE = "Example: fembearing report report-of-my-bearing/report.json --out for-my-customer.html"


def report(
    numbers: Annotated[Path, typer.Argument(metavar="REPORT.JSON", help="The numbers of a report.")],
    page: Annotated[
        Path | None,
        typer.Option(
            "--out", help="The page; report.html beside the numbers without it. Only such a page is replaced."
        ),
    ] = None,
    as_json: AsJson = False,
) -> None:
    """Make the page of a report again from its numbers, with the pictures that lie beside them."""
    from fembearing.report.page.rebuild import rebuild_page

    found = rebuild_page(numbers, out=page)
    if as_json:
        print_json(found.to_json())
    else:
        out.print(f"page: {found.file}", highlight=False, soft_wrap=True, markup=False)
    for name in found.missing:
        typer.echo(f"fembearing: the picture {name} does not lie beside {numbers}; the page says so", err=True)
