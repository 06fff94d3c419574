"""TOML files, read within limits of size and depth."""

import os
import re
import tomllib
from typing import Any

from analytic.errors import InputError
from analytic.reading import content_of
from analytic.words import plain, shown

# A value without quotes that has a letter or a sign of a unit in it: a quantity or a word.
BARE_VALUE = re.compile(r"""[=\[,]\s*([^\s"'=,\[\]{}#][^"'=,\[\]{}#]*)""")
IN_WORDS = re.compile(r"[^\W\d_]|[°%]")
COMMENT = re.compile(r"""^((?:[^#"']|"[^"]*"|'[^']*')*)#.*""")  # the line before it, and the comment
NO_KEY = re.compile(r"([A-Za-z_][\w-]*(?:[ \t]+[\w-]+)*)[ \t]*([:=]?)")  # words that may be meant as a key
CURLED = re.compile("[\N{LEFT DOUBLE QUOTATION MARK}\N{RIGHT DOUBLE QUOTATION MARK}\N{DOUBLE LOW-9 QUOTATION MARK}]")
LONGEST_LINE = 200  # that is searched for a slip
LARGEST_FILE = 256_000  # bytes: a series of 20 000 points
# Keys of a scene have at most four parts. The memory of the TOML parser grows with the square of the number of parts.
LONG_KEY = re.compile(r"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){16}""", re.ASCII)


def read_text(path: str | os.PathLike[str], *, kind: str, remedy: str) -> str:
    """The text of a file; kind : of file, for messages;  remedy : for a file that cannot be opened.

    Raises InputError for a file that cannot be read, is too large or is not UTF-8.
    """
    origin = plain(os.fspath(path))
    try:
        return content_of(path, most=LARGEST_FILE, remedy=remedy).decode("utf-8-sig")
    except InputError as problem:
        raise InputError(f"{origin}: {problem}") from problem
    except UnicodeDecodeError as problem:
        raise InputError(f"{origin}: byte {problem.start} is not UTF-8; save the {kind} file as UTF-8") from problem


def parse_text(text: str, *, origin: str) -> dict[str, Any]:
    """The TOML document; origin : names the file in messages. Raises InputError for text that is not TOML."""
    long_key = LONG_KEY.search(text)
    if long_key:
        raise InputError(f"{origin}: {shown(long_key[0])} has too many parts; keys of a scene have at most four")
    try:
        return tomllib.loads(text)
    except (ValueError, RecursionError) as problem:  # ValueError: TOMLDecodeError, dates and integers out of range
        reason = " ".join(str(problem).split())
        if isinstance(problem, RecursionError):
            reason = "nested too deep"
        elif "set_int_max_str_digits" in reason:
            reason = "a number of thousands of digits"
        raise InputError(f"{origin}: not TOML: {reason}{_remedy(text, reason)}") from problem


def _remedy(text: str, reason: str) -> str:
    """What to write instead, where the parser stopped at a line with a usual slip."""
    place = re.search(r"\(at line (\d+), column \d+\)", reason)
    if place is None:
        return ""
    line = text.split("\n")[int(place[1]) - 1].strip()[:LONGEST_LINE]
    if reason.startswith("Cannot declare"):
        return f"; {plain(line)} is given twice: put its keys into one table"
    if reason.startswith("Cannot overwrite"):
        return f"; {plain(line.partition('=')[0].strip())} is given twice: leave one of them out"
    if reason.startswith("Illegal character '\\n'"):
        return "; close the quotes"
    if CURLED.search(line):
        return '; write straight quotes, "'
    line = COMMENT.sub(r"\1", line)
    if reason.startswith("Expected ']'") and line.startswith("["):
        return f"; close the bracket: {plain(line.strip())}]"
    if reason.startswith("Expected '=' after a key") and (key := NO_KEY.match(line)):
        return f"; write {plain('_'.join(key[1].split()))} = and the value: letters, digits and _ make a key, = follows"
    value = next((found.strip() for found in BARE_VALUE.findall(line) if IN_WORDS.search(found)), None)
    if value is None:
        return ""
    if value.lower() in ("true", "false"):
        return f"; write {value.lower()} in small letters"
    return f'; write the value in quotes: "{plain(value)}"'
