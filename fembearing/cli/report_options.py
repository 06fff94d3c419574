"""The options that stand for keys of a scene's table [report]: --author, --checker, --revision, --date, --units."""

import inspect
from collections.abc import Callable
from contextvars import ContextVar
from functools import wraps
from typing import Annotated, Any

import typer

from analytic.report_details import UnitSystem

OPTIONS: dict[str, Any] = {
    "author": Annotated[str | None, typer.Option(help="Who made the report; the scene says so without it.")],
    "checker": Annotated[str | None, typer.Option(help="Who checked it.")],
    "revision": Annotated[str | None, typer.Option(help="Of the document.")],
    "date": Annotated[str | None, typer.Option(help="Of the revision.")],
    "units": Annotated[UnitSystem | None, typer.Option(help="In which the report is written.")],
}
GIVEN: ContextVar[dict[str, str | None]] = ContextVar("given")  # what the options of the running command say


def with_report_options(command: Callable[..., None]) -> Callable[..., None]:
    """The command with these options, which its function need not take: `given_details` has what they say."""

    @wraps(command)
    def run(**given: Any) -> None:
        GIVEN.set({name: given.pop(name) for name in OPTIONS})
        command(**given)

    own = inspect.signature(command)
    kind = inspect.Parameter.KEYWORD_ONLY
    added = [inspect.Parameter(name, kind, default=None, annotation=option) for name, option in OPTIONS.items()]
    vars(run)["__signature__"] = own.replace(parameters=[*own.parameters.values(), *added])
    return run


def given_details() -> dict[str, str]:
    """The details of the report that options give. Raises InputError for a text that no key of [report] takes."""
    from analytic.errors import InputError
    from analytic.scenefile.keys import scene_key
    from analytic.scenefile.text import shown

    details = {name: text for name, text in GIVEN.get().items() if text is not None}
    for name, text in details.items():
        try:
            scene_key(f"report.{name}").read(text)
        except ValueError as problem:
            raise InputError(f"--{name} {shown(text)} {problem}") from None
    return details
