"""The fields of a public class on its page: each with the comment that stands beside it in the source."""

import re
from typing import Any

from sphinx.application import Sphinx

from docs.extensions.public import public_classes
from docs.extensions.source import field_comments

MARKUP = re.compile(r"(?<![`\\])([*|`]|_(?=\W|$))")  # characters of a comment that RST would read


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("autodoc-process-docstring", add_fields, priority=100)  # before numpydoc
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def add_fields(_app: Sphinx, _what: str, _name: str, thing: Any, _options: Any, lines: list[str]) -> None:
    """Add the section Attributes to the lines of a docstring, where the class has fields and no such section."""
    if thing in public_classes() and "Attributes" not in lines:
        said = ((name, comment) for name, comment in field_comments(thing).items() if comment)
        fields = [line for name, comment in said for line in (name, "    " + MARKUP.sub(r"\\\1", comment))]
        lines += ["", "Attributes", "----------", *fields, ""] if fields else []
