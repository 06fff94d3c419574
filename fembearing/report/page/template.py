"""A template filled: every text is escaped, and a name that is missing is an error."""

from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from fembearing.report.phrases import listed, shown


def filled(template: str, /, **content: Any) -> str:
    """The text of a template of this folder; content : what its names stand for."""
    environment = Environment(
        loader=PackageLoader("fembearing.report.page"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"shown": shown, "listed": listed}
    return environment.get_template(template).render(content)
