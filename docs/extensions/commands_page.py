"""The page of commands and their options, from the command line itself."""

from inspect import signature
from pathlib import Path
from typing import Any

from docs.extensions.annotations import with_parts, words_in
from docs.extensions.tables import code, table
from fembearing.cli import COMMANDS, command_of

HEAD = """\
# Command options

Made from the command line itself: `fembearing COMMAND --help` prints the same. [Commands](../commands.md) says how they
go together, what they write, and what their exit status means.
"""


def commands_page() -> str:
    """The page in Markdown."""
    return "\n".join([HEAD, *map(section, COMMANDS)])


def section(name: str) -> str:
    """One command: what it does, how it is called, its options, an example."""
    (function, example), command = COMMANDS[name], command_of(name)
    annotations = {each.name: each.annotation for each in signature(function).parameters.values()}
    arguments = [each for each in command.params if each.param_type_name == "argument"]
    options = [each for each in command.params if each.param_type_name == "option"]
    call = " ".join(["fembearing", name, *map(placeholder, arguments), "[OPTIONS]"])
    rows = [
        *([code(placeholder(each)), "", each.help or ""] for each in arguments),
        *([spelling(each, annotations[each.name]), default(each), each.help or ""] for each in options),
    ]
    parts = [
        f"## `{name}`\n",
        f"{prose(command.help)}\n",
        f"```text\n{call}\n```\n",
        table(["argument or option", "default", "meaning"], rows),
        f"For example:\n\n```text\n{f'fembearing {name} {example}'.rstrip()}\n```\n",
    ]
    return "\n".join(parts)


def placeholder(argument: Any) -> str:
    word = (argument.metavar or argument.name).strip("[]").upper()
    return word if argument.required else f"[{word}]"


def spelling(option: Any, kind: Any) -> str:
    """The names of an option, and what it takes."""
    takes = "" if option.is_flag else f" {taken(kind)}{', more than once' if option.multiple else ''}"
    return ", ".join(map(code, option.opts)) + takes


def taken(kind: Any) -> str:
    """What an annotation takes, in words."""
    parts = list(with_parts(kind))
    if words := words_in(kind):
        return " or ".join(map(code, words))
    names = {int: "number", Path: "path"}
    return next((names[part] for part in parts if part in names), "text")


def default(option: Any) -> str:
    given = option.default
    return code(str(given)) if isinstance(given, str | int) and not isinstance(given, bool) else ""


def prose(text: str) -> str:
    """The help of a command without the line breaks of its source."""
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in text.split("\n\n"))
