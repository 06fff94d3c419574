"""Docstrings of this project as numpydoc reads them.

A docstring here has its parameters as lines "name : meaning", formulas indented, and sentences "Raises InputError for
...". They become the sections Parameters and Raises, and literal blocks. The comment beside a field of a class becomes
the field's entry under Attributes. A docstring that has the sections already stays as it is.
"""

import inspect
import re
from collections.abc import Iterator
from typing import Any

from sphinx.application import Sphinx

from docs.extensions.source import field_comments

PARAMETER = re.compile(r"(?P<names>\*{0,2}\w+(?:, \*{0,2}\w+)*) : (?P<meaning>.+)")
RAISES = re.compile(r"Raises (?P<what>[A-Z]\w+Error\b.*)")
SECTION = re.compile(r"-{3,}$")
NOT_MARKUP = re.compile(r"(?<![`\\])([*|]|_(?=\W|$))")  # characters of formulas that RST would read


def setup(app: Sphinx) -> dict[str, Any]:
    app.connect("autodoc-process-docstring", rewrite, priority=100)  # before numpydoc
    return {"parallel_read_safe": True, "parallel_write_safe": True}


def rewrite(_app: Sphinx, what: str, _name: str, thing: Any, _options: Any, lines: list[str]) -> None:
    """Rewrite the lines of a docstring in place."""
    if any(SECTION.match(line.strip()) for line in lines):
        return
    lines[:] = list(sections(lines))
    if what == "class" and inspect.isclass(thing):
        lines += attributes(thing)


def sections(lines: list[str]) -> Iterator[str]:
    """The summary, then the parameters, the text, and what is raised."""
    parameters: list[str] = []
    raised: list[str] = []
    text: list[str] = []
    place = text
    for line in lines:
        stripped = line.strip()
        indented = line.startswith(" ") and stripped
        if not indented and (found := PARAMETER.match(line)):
            place = parameters
            for name, meaning in each_parameter(found):
                parameters += [name, f"    {plain(meaning)}"]
        elif not indented and (found := RAISES.match(line)):
            place = raised
            raised.append(found["what"])
        elif indented and place is parameters:
            parameters.append(f"    {plain(stripped)}")
        elif place is raised and stripped:
            raised.append(stripped)
        else:
            place = text
            text.append(line)
    yield from with_literals(text)
    if parameters:
        yield from ("", "Parameters", "----------", *parameters)
    if raised:
        yield from ("", "Raises", "------")
        for error, cause in each_error(" ".join(raised)):
            yield from (error, f"    {plain(cause)}")
    yield ""


def each_parameter(found: re.Match[str]) -> Iterator[tuple[str, str]]:
    """The parameters of one line, as in "load : N;  moment : N m"."""
    yield found["names"], re.split(r";  (?=\w+(?:, \w+)* : )", found["meaning"])[0]
    for more in re.split(r";  (?=\w+(?:, \w+)* : )", found["meaning"])[1:]:
        names, _, meaning = more.partition(" : ")
        yield names, meaning


def each_error(text: str) -> Iterator[tuple[str, str]]:
    """Each error with its cause: "InputError for ...; ConvergenceError where ..."."""
    for part in re.split(r"[;,] (?:and )?(?=[A-Z]\w+Error\b)", text.rstrip(".")):
        error, _, cause = part.partition(" ")
        yield error, cause


def with_literals(text: list[str]) -> Iterator[str]:
    """The text, with what is indented as literal blocks."""
    inside = False
    for line in text:
        indented = bool(line.strip()) and line.startswith(" ")
        if indented and not inside:
            yield from ("", "::", "")
        elif inside and not indented and line.strip():
            yield ""
        inside = indented
        yield line if indented else plain(line)


def plain(text: str) -> str:
    """The text with the characters that RST would read as markup escaped, outside code."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else NOT_MARKUP.sub(r"\\\1", part) for part in parts)


def attributes(of: type) -> list[str]:
    """The fields of a class with the comments beside them; nothing for a class without such comments."""
    try:
        comments = field_comments(of)
    except (OSError, TypeError):
        return []
    said = [line for name, comment in comments.items() if comment for line in (name, f"    {plain(comment)}")]
    return ["", "Attributes", "----------", *said, ""] if said else []
