"""A template filled: every text is escaped, and a name that is missing is an error."""

from functools import cache
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined


def filled(template: str, /, **content: Any) -> str:
    """The text of a template of this folder; content : what its names stand for."""
    return environment().get_template(template).render(content)


def source_of(template: str) -> str:
    """The text of a template before it is filled."""
    made = environment()
    assert made.loader is not None
    return made.loader.get_source(made, template)[0]


@cache
def environment() -> Environment:
    """Of the templates of this folder: every text is escaped."""
    made = Environment(
        loader=PackageLoader("fembearing.report.page"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    made.filters["kind"] = lambda block: type(block).__name__
    return made
