"""Which scene a name means: a file, a scene that ships with the package, or a bearing of the catalogue; and its TOML.

Files are read within limits of size and depth.
"""

import os
import re
import tomllib
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from analytic import catalog
from analytic.catalog.bearing_rows import CatalogBearing, find_bearing
from analytic.catalog.designation import begins_as_number
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
LONGEST_NAME = 60  # characters of a designation
# What a name ends with that is a file, among them slips of the keyboard: a point also stands in front of a suffix.
EXTENSIONS = (
    *(".toml", ".tml", ".tom", ".tmol", ".txt", ".json", ".yaml", ".yml"),
    *(".ini", ".cfg", ".csv", ".html", ".md"),
)


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


@dataclass(frozen=True, kw_only=True, eq=False)
class FoundScene:
    """The document of a scene, before it is read; that of a bearing of the catalogue is empty."""

    document: dict[str, Any]
    origin: str  # names it in messages
    folder: Path  # that the paths in the text start from
    bearing: CatalogBearing | None = None  # of the catalogue, whose usual scene it is
    designation: str = ""  # as it was given


def find_scene(name: str | os.PathLike[str], *, folder: Path = Path()) -> FoundScene:
    """The scene that a name means.

    folder : that a relative path starts from

    A file that exists comes first, then a built-in scene, then a bearing of the catalogue, whose scene is the one that
    `fembearing init` writes. A name that ends like one of a file, with .toml or .txt, is a file.
    Raises InputError for a name that is none of these, and for a file that is not TOML.
    """
    if isinstance(name, int | float):  # a designation from Python without its quotes
        raise InputError(f'{name} is a number, not the name of a bearing or a file; write it in quotes: "{name}"')
    if not isinstance(name, str | os.PathLike):
        raise InputError(
            f'{shown(name)} is not the name of a bearing or a file, nor a Scene; give one, for example "6206"'
        )
    given = os.fspath(name)
    path, builtin = folder / given, catalog.names("scenes")
    known = f"built in: {', '.join(builtin)}"
    if given in builtin and not os.path.isfile(path):
        path = catalog.path("scenes", given)
    elif not os.path.isfile(path) and _may_be_a_bearing(given):
        try:
            return FoundScene(
                document={}, origin=f"scene of {given}", folder=folder, bearing=find_bearing(given), designation=given
            )
        except InputError as problem:
            if os.path.basename(given) == given or (not path.parent.is_dir() and begins_as_number(given)):
                raise InputError(f"{problem} (no scene file has this name either, nor a scene {known})") from None
    text = read_text(path, kind="scene", remedy=f"give the path of a scene file ({known}), or a bearing as 6206")
    origin = plain(os.fspath(path))
    return FoundScene(document=parse_text(text, origin=origin), origin=origin, folder=path.parent)


def _may_be_a_bearing(name: str) -> bool:
    return 0 < len(name) <= LONGEST_NAME and name.isprintable() and not name.lower().endswith(EXTENSIONS)
