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
NO_KEY = re.compile(r"([A-Za-z_][\w-]*(?:[ \t]+[\w-]+)*)[ \t]*(?:[:=]|$)", re.ASCII)  # words meant as a key
VALUE = r"""(?:"[^"]*"|'[^']*'|[^\s"'=,\[\]{}#]+)"""
# What the parser says, what the line has, and what to write, with the groups of the line: the first that fits.
SLIPS = tuple(
    (re.compile(reason), re.compile(line), remedy)
    for reason, line, remedy in (
        (r"Cannot declare", r"(.*)", r"\1 is given twice: put its keys into one table"),
        (r"Cannot overwrite", r"\s*([^=]*?)\s*=.*", r"\1 is given twice: leave one of them out"),
        (r"Illegal character '\\n'|Unterminated|Expected \"['\"]", r".*", r"close the quotes"),
        (r"", ".*[\N{LEFT DOUBLE QUOTATION MARK}\N{RIGHT DOUBLE QUOTATION MARK}\N{DOUBLE LOW-9 QUOTATION MARK}].*",
         'write straight quotes, "'),
        (r"Unescaped|Invalid hex", r""".*"([^"']*\\[^"']*)".*""", r"write text with \\ in single quotes: '\1'"),
        (r"", r"\s*(?:(?://|;|%|!|--).*|[^\"'#]*?\s(?://|;|--)\s.*)", r"a comment begins with #"),
        (r"", r".*;\s*", r"leave out the semicolon at the end"),
        (r"", r".*[^=<>!]==[^=].*", r"write one ="),
        (r"Invalid initial", r"[^\[{]*\{[^}]*,\s*", r"write a table in { } in one line"),
        (r"Unclosed inline", rf".*=\s*{VALUE}\s+[\w-]+\s*=.*", r"write a comma between the keys"),
        (r"Expected newline", rf"[^\[{{]*=\s*{VALUE}\s+[A-Za-z_][\w.-]*\s*=.*", r"write each key in a line of its own"),
        (r"", r"[^\"'#]*[=\[,]\s*([+-]?\d+),(\d+)\s*", r"write a decimal point: \1.\2"),
        (r"", r"[^\"'#]*[=\[,]\s*([+-]?)\.(\d+)\b.*", r"write \g<1>0.\2"),
        (r"", r"[^\"'#]*[=\[,]\s*([+-]?\d+)\.(?!\d)([eE][+-]?\d+)?.*", r"write \1.0\2"),
        (r"Unclosed array \(at end", r"[^\[]*\[[^\]]*", r"close the list: ]"),
        (r"Expected '\]'", r"\s*(\[[^\]]*?)\s*", r"close the bracket: \1]"),
    )
)  # fmt: skip
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
        raise InputError(f"{origin}: not TOML: {reason}{_place(text, reason)}") from problem


def _place(text: str, reason: str) -> str:
    """The line at which the parser stopped, and what to write instead of a usual slip, where that is sure."""
    place = re.search(r"\(at (?:line (\d+), column \d+|end of document)\)", reason)
    if place is None:
        return ""
    lines = text.rstrip().split("\n")
    line = (lines[int(place[1]) - 1] if place[1] else lines[-1]).strip()[:LONGEST_LINE]
    remedy = _remedy(COMMENT.sub(r"\1", line).rstrip(), reason)
    return f", in {plain(line)}{remedy and f'; {remedy}'}"


def _remedy(line: str, reason: str) -> str:
    for said, slip, remedy in SLIPS:
        if said.match(reason) and (found := slip.fullmatch(line)):
            return plain(found.expand(remedy))
    if reason.startswith("Expected '=' after a key") and (key := NO_KEY.match(line)):
        return f"write {plain('_'.join(key[1].split()))} = and the value: letters, digits and _ make a key, = follows"
    if line.startswith("["):
        return ""
    value = next((found.strip() for found in BARE_VALUE.findall(line) if IN_WORDS.search(found)), None)
    if value is None:
        return "write a comma between the values" if reason.startswith("Unclosed array (at line") else ""
    if value.lower() in ("true", "false"):
        return f"write {value.lower()} in small letters"
    return f'write the value in quotes: "{plain(value)}"'
