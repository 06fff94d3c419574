"""Which scene a name means: a file, a scene that ships with the package, or a bearing of the catalogue; and its TOML.

Files are read within limits of size and depth.
"""

import os
import re
import tomllib
from dataclasses import dataclass
from math import inf
from pathlib import Path
from typing import Any

from analytic import catalog
from analytic.catalog.bearing_rows import CatalogBearing, find_bearing
from analytic.catalog.designation import begins_as_number
from analytic.errors import InputError
from analytic.reading import content_of
from analytic.words import plain, shown

STRING = r"""(?:"[^"]*"|'[^']*')"""
COMMENT = re.compile(rf"""^((?:[^#"']|{STRING})*)#.*""")  # the line before it, and the comment
CLOSED = re.compile(rf"""(?:[^"']|{STRING})*""")
BEGINNING = re.compile(r"""\[|[\w."'-]+\s*=""")  # of a statement
BEFORE, AFTER = r"(?<=[=\[,(; ])(?<!^\[)", r"(?=\s*(?:[,;\]})]|$))"  # a value
BARE = r"""[^\s"'=,;\[\]{}][^"'=,;\[\]{}]*?"""
SCALAR = r"true|false|[+-]?(?:inf|nan|[\d._]+(?:[eE][+-]?\d+)?)"
# What people write outside of strings, and what it is in TOML, in the order of trial.
REPAIRS = tuple(
    (re.compile(rf"(?:{written})|(?P<string>{STRING})"), meant)
    for written, meant in (
        (r"^(?://|;|%|!|--|/\*|REM\b)\s*", "# "),
        (r"\s(?://|--)\s", " # "),
        ("[\N{LEFT DOUBLE QUOTATION MARK}\N{RIGHT DOUBLE QUOTATION MARK}\N{DOUBLE LOW-9 QUOTATION MARK}]", '"'),
        ("[\N{LEFT SINGLE QUOTATION MARK}\N{RIGHT SINGLE QUOTATION MARK}\N{SINGLE LOW-9 QUOTATION MARK}]", "'"),
        (r"""^([^"']*=\s*)(["'])([^"']*)["']?$""", r"\1\2\3\2"),
        (r""""([^"']*\\[^"']*)\"""", r"'\1'"),
        (r"^([\w.]+):$", r"[\1]"),
        (r"(?<=\w)(?<![=:\[{] )[ \t]+(?=\w[\w \t-]*(?:=|:\s))", "_"),
        (r"\s*(?:==|:=|=>|:(?![\\/]))\s*", " = "),
        (r"^([\w.-]+)[ \t]+(?=[^=]*$)", r"\1 = "),
        (rf"{BEFORE}([+-]?(?:0|\d+(?!,\d{{3}}\b))),(\d+)(?![.,]?\d)", r"\1.\2"),
        (rf"{BEFORE}([+-]?)[.,](?=\d)", r"\g<1>0."),
        (rf"{BEFORE}([+-]?\d+)\.(?!\d)", r"\1.0"),
        (rf"{BEFORE}0+(?=\d)", ""),
        (rf"{BEFORE}(?i:true){AFTER}", "true"),
        (rf"{BEFORE}(?i:false){AFTER}", "false"),
        (rf"{BEFORE}(?!(?:{SCALAR}){AFTER})(?=[^,;\]}}]*(?:[^\W\d_]|[°%]))({BARE}){AFTER}", r'"\1"'),
        (r"[({]([^(){}=]*)[)}]", r"[\1]"),
        (r"^([\w.-]+\s*=\s*)([^\[{]*,\s[^\[{]*)$", r"\1[\2]"),
        (r"\s*;\s*$|,\s*(?=\}$)", ""),
        (r"\s*;", ","),
        (r"""(?<=[\w"'\]}])\s+(?=[\w"'\[{+-])""", ", "),
        (r"[\s;,]+(?=[A-Za-z_][\w.-]*\s*=)", "\n"),
        (r"\s;\s", " # "),
        (r"^([^{]*\{[^}]*)$", r"\1 }"),
        (r"^([^\[]*\[[^\]]*)$", r"\1]"),
        (r"^(\w[\w.]*\])$", r"[\1"),
    )
)  # fmt: skip
LONGEST_LINE = 200  # characters of a statement that is repaired
WHOLE = (inf, 1.0)  # nothing stops the parser
WRITES = "fembearing init 6206 writes a scene file"
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
    """The line at which the parser stopped, and its statement in TOML, where a usual slip is all that is wrong."""
    place = re.search(r"\(at (?:line (\d+), column \d+|end of document)\)", reason)
    if place is None:
        return ""
    lines = [COMMENT.sub(r"\1", line).strip() for line in text.rstrip().split("\n")]
    is_open = (number for number, line in enumerate(lines) if not CLOSED.fullmatch(line))  # quotes that nothing closes
    at = int(place[1]) - 1 if place[1] else next(is_open, len(lines) - 1)
    remedy, repaired = "", _repaired(_statement(lines, at))
    if reason.startswith("Cannot"):  # overwrite a value, or declare a table twice
        remedy = "; it is given twice: leave one of them out, or put the keys of both tables into one"
    elif repaired not in ("", lines[at]):
        remedy = "; write " + " and, in a line of its own, ".join(map(plain, repaired.split("\n")))
    return f", in {plain(lines[at][:LONGEST_LINE])}{remedy}"


def _statement(lines: list[str], at: int) -> str:
    """The line with that number, and those before and after it that belong to the same statement."""
    first = next((number for number in range(at, -1, -1) if BEGINNING.match(lines[number])), at)
    if _reach("\n".join(lines[first:at])) == WHOLE:
        first = at
    for after in range(at + 1, len(lines) + 1):
        statement = " ".join(lines[first:after])
        if len(statement) > LONGEST_LINE or all(statement.count(a) <= statement.count(b) for a, b in ("[]", "{}")):
            return statement
    return " ".join(lines[first : at + 1])


def _repaired(statement: str) -> str:
    """The statement in TOML; empty where no repair is known. A repair counts if the parser comes further with it."""
    reached = _reach(statement)
    for written, meant in 2 * REPAIRS if len(statement) <= LONGEST_LINE else ():
        if reached == WHOLE:
            break
        tried = written.sub(lambda found: found["string"] or found.expand(meant), statement)  # noqa: B023 - at once
        if (further := _reach(tried)) > reached:
            statement, reached = tried, further
    return statement if reached == WHOLE else ""


def _reach(text: str) -> tuple[float, float]:
    """Line and column at which the parser stops."""
    try:
        tomllib.loads(text)
    except (ValueError, RecursionError) as problem:
        place = re.search(r"line (\d+), column (\d+)", str(problem))
        return (float(place[1]), float(place[2])) if place else (inf, 0.0)
    return WHOLE


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
    require_no_data(name)
    given = os.path.expanduser(os.fspath(name))
    path, builtin = folder / given, catalog.names("scenes")
    if given in builtin and not os.path.isfile(path):
        path = catalog.path("scenes", given)
    elif not os.path.isfile(path) and may_be_a_bearing(given):
        try:
            return FoundScene(
                document={}, origin=f"scene of {given}", folder=folder, bearing=find_bearing(given), designation=given
            )
        except InputError as problem:
            if os.path.basename(given) == given or (not path.parent.is_dir() and begins_as_number(given)):
                raise InputError(f"{problem}. No scene file has this name either; {WRITES}") from None
    text = read_text(path, kind="scene", remedy=f"give the path of a scene file, or a bearing as 6206; {WRITES}")
    origin = plain(os.fspath(path))
    return FoundScene(document=parse_text(text, origin=origin), origin=origin, folder=path.parent)


def require_no_data(name: object) -> None:
    """Raise InputError for a table in the place of a scene."""
    if isinstance(name, str | os.PathLike) and os.fspath(name).lower().endswith((".csv", ".xlsx")):
        raise InputError(f"{plain(os.fspath(name))} is no scene; give the scene first, as 6206, then the table")


def may_be_a_bearing(name: str) -> bool:
    """Whether a name is none of a file."""
    return 0 < len(name) <= LONGEST_NAME and name.isprintable() and not name.lower().endswith(EXTENSIONS)
