"""Words of help pages, reasons, warnings and pages: nouns of the field, in place of phrases that need a second reading.

Strings of the code count, and templates of pages; comments and docstrings count where a command shows them.
"""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from fembearing.cli import COMMANDS, command_of

ROOT = Path(__file__).parents[1]
BANNED = {  # with what to write in its place
    r"unasked|of its own accord": "skipped: ..., limit ...",
    r"(does|do) not know\b|nobody knows": "ignores, without",
    r"\b(may|can) be left out\b|\bleaves out\b": "neglected, budget",
    r"until .* came out|comes? out as": "calibrated; is",
    r"\b(as|so) far as (is|are|the|inputs)\b": "from the stated uncertainties",
    r"\bhow far to trust\b": "uncertainty, verdict",
    r"\bthe scene (says|asks|names)\b": "in the scene",
    r"\bgoes on\b|\bwhat is done\b": "continues; finished points",
    r"\bsettles?\b": "converge, determine",
    r"\bstands? twice\b": "given twice",
    r"\bsays? (how|what|which|why)\b": "gives, determines",
}
HELP_BANNED = r"without it\.?$|, as [0-9a-z]|^(Of|In|For|From) "  # defaults are written (default: ...)


def shown_strings(source: str) -> Iterator[tuple[int, str]]:
    """Strings of a file in which a sentence may stand: no docstrings, joined where they are formatted."""
    tree = ast.parse(source)
    docstrings = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    inside = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            parts = (str(part.value) if isinstance(part, ast.Constant) else "x" for part in node.values)
            yield node.lineno, "".join(parts)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docstrings | inside:
            yield node.lineno, node.value


def shown_files() -> Iterator[tuple[str, int, str]]:
    """Every place of a string, with the string."""
    for package in ("analytic", "fembearing"):
        for path in sorted((ROOT / package).rglob("*.py")):
            for line, text in shown_strings(path.read_text("utf-8")):
                yield str(path.relative_to(ROOT)), line, text
        for path in sorted((ROOT / package).rglob("*.html")):
            text = path.read_text("utf-8").partition("<script")[0]
            yield from ((str(path.relative_to(ROOT)), n, line) for n, line in enumerate(text.splitlines(), start=1))


def test_no_string_has_a_phrase_in_place_of_a_term() -> None:
    found = [
        f"{file}:{line}: {text.strip()[:70]!r}: write {better}"
        for file, line, text in shown_files()
        for phrase, better in BANNED.items()
        if re.search(phrase, text) and " " in text.strip()
    ]
    assert not found, "\n".join(found)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_option_says_what_it_is_and_its_default(name: str) -> None:
    """Each begins with a noun or a verb and ends with a full stop."""
    command = command_of(name)
    for parameter in command.params:
        words = getattr(parameter, "help", None)
        assert words, f"{name} {parameter.name} has no help"
        assert not re.search(HELP_BANNED, words), f"{name} {parameter.name}: {words}"
        if parameter.name != "help":
            assert words.endswith("."), f"{name} {parameter.name}: {words}"
