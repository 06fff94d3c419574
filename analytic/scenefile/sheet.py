"""Rows of cells that people keep in a spreadsheet: CSV of any country, and the first sheet of an .xlsx.

Tabs, semicolons or commas separate a CSV, whichever of these its first row has. Between commas, numbers without quotes
have decimal points. Elsewhere the file itself must show its decimal sign, as "35,1" does: "1.500" is 1.5 in one country
and 1500 in another. Numbers of an .xlsx are numbers, whatever their format.
"""

import csv
import io
import os
import re
import warnings
import zipfile
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import NamedTuple

from analytic.errors import require_packages
from analytic.reading import MILLION, content_of, text_of
from analytic.words import plain

Cell = str | int | float  # without blanks around it and with single ones inside; "" : empty

WORKBOOK, OLD_WORKBOOK = b"PK\x03\x04", b"\xd0\xcf\x11\xe0"  # how these files begin
LARGEST_FILE, LARGEST_UNPACKED = 2_000_000, 20_000_000  # bytes
MOST_ROWS, MOST_COLUMNS = 20_000, 200
SEPARATORS = "\t;,"  # the first that is there: a comma may be decimal, and a semicolon may stand in a text
# A comment, or the separator as Excel declares it; but "#DIV/0!", "#N/A" and "#NV" are failed cells.
ASIDE = re.compile(r"\s*(?:#(?!N/?[AV]\b|[A-Z0-9/]+[!?])|sep=.\s*$)")
NUMERAL = re.compile(r"[.,]?\d[\d.,]*")
GROUPED = re.compile(r"[1-9]\d{0,2}[.,]\d{3}")  # or three decimals
SIGNS = {".": "point", ",": "comma"}


class Line(NamedTuple):
    """A row with something in it."""

    number: int  # in the file, from 1
    cells: list[Cell]


class Sheet(NamedTuple):
    """The rows of a file."""

    lines: list[Line]
    separator: str  # of a CSV; "" of an .xlsx


def read_sheet(path: str | os.PathLike[str], *, remedy: str) -> Sheet:
    """The rows of a file; remedy : what to do about one that cannot be read.

    Raises ValueError, which does not name the file, for what is no such file and for one that is too large;
    MissingPackageError for an .xlsx without openpyxl.
    """
    content = content_of(path, most=LARGEST_FILE, remedy=remedy)
    if content.startswith(OLD_WORKBOOK):
        raise ValueError("is an .xls, or has a password; save it as .xlsx or CSV")
    if content.startswith(WORKBOOK):
        require_packages(plain(os.fspath(path)), "openpyxl")
        lines, separator = _of_workbook(content), ""
    else:
        lines, separator = _of_text(text_of(content))
    filled = (line for line in lines if any(cell != "" for cell in line.cells))
    found = list(islice(filled, MOST_ROWS + 2))  # with the heads
    if len(found) > MOST_ROWS + 1:
        raise ValueError(f"has more than {MOST_ROWS} rows; {remedy}")
    for number, cells in found:
        if len(cells) > MOST_COLUMNS:
            raise ValueError(f"line {number} has more than {MOST_COLUMNS} columns; leave those out that are not needed")
    return Sheet(found, separator)


def _of_text(text: str) -> tuple[Iterator[Line], str]:
    rows = ["\n" if ASIDE.match(row) else row for row in io.StringIO(text, newline=None)]
    first = re.sub(r'"[^"]*"', "", next((row for row in rows if row.strip()), "")).strip()
    separator = next((each for each in SEPARATORS if each in first), ",")

    def lines() -> Iterator[Line]:
        reader = csv.reader(rows, delimiter=separator, strict=True)
        try:
            for cells in reader:
                yield Line(reader.line_num, [" ".join(cell.split()) for cell in cells])
        except csv.Error as problem:
            raise ValueError(f"is no CSV at line {reader.line_num}: {problem}; correct the quotes") from None

    return lines(), separator


def _of_workbook(content: bytes) -> Iterator[Line]:
    import openpyxl  # few files need it

    try:
        with zipfile.ZipFile(io.BytesIO(content)) as parts:
            unpacked = sum(part.file_size for part in parts.infolist())
        if unpacked > LARGEST_UNPACKED:
            raise ValueError(f"it unpacks to more than {LARGEST_UNPACKED // MILLION} MB")
        with warnings.catch_warnings(action="ignore"):  # of what a sheet has beside its cells
            book = openpyxl.load_workbook(io.BytesIO(content), read_only=True, data_only=True, keep_links=False)
            sheet = book.worksheets[0]
            sheet.reset_dimensions()  # some programs write wrong ones
            for number, row in enumerate(sheet.iter_rows(max_col=MOST_COLUMNS + 1), start=1):
                cells = [_cell(each.value, each.number_format) for each in row]
                while cells and cells[-1] == "":
                    cells.pop()
                if not ASIDE.match(str(next((cell for cell in cells if cell != ""), ""))):
                    yield Line(number, cells)
    except Exception as problem:  # openpyxl raises different ones, depending on the damage
        reason = plain(" ".join(str(problem).split())[:120])
        raise ValueError(f"is no .xlsx that can be read: {reason}; save its table alone, as .xlsx or CSV") from problem


def _cell(value: object, form: str | None) -> Cell:
    if isinstance(value, int | float) and not isinstance(value, bool):
        return f"{100 * value:.14e}%" if form and "%" in form else value  # as it is shown
    return "" if value is None else " ".join(str(value).split())


def decimal_sign(cells: Iterable[Cell], separator: str) -> str:
    """The decimal sign of these cells: "." or ","; "" where each number can be read in two ways."""
    numbers = [number for cell in cells if isinstance(cell, str) for number in NUMERAL.findall(cell)]
    if separator == "," and not any("," in number for number in numbers):
        return "."
    signs = {sign for number in numbers for sign in SIGNS if number.count(sign) == 1 and not GROUPED.fullmatch(number)}
    return min(signs, default="")  # with both, the comma: then the points are refused


def with_points(cell: Cell, sign: str) -> Cell:
    """The cell with decimal points in its numbers; sign : as `decimal_sign` finds it.

    Raises ValueError for a number that has another sign, groups of digits, or can be read in two ways.
    """

    def pointed(match: re.Match[str]) -> str:
        number = match[0]
        found = [each for each in number if each in SIGNS]
        if len(found) > 1:
            raise ValueError("groups its digits; write them without separators, and one before the decimals")
        if not found or found == [sign]:
            return number.replace(",", ".")
        whole = number.replace(found[0], "")
        if not sign:
            raise ValueError(
                f"is ambiguous, a {SIGNS[found[0]]} before three digits: write {whole}, or {number.replace(',', '.')}0"
            )
        readings = [whole] if GROUPED.fullmatch(number) else []
        readings.append(number.replace(found[0], sign))
        words = f"has a {SIGNS[found[0]]}, and the decimals of this file have a {SIGNS[sign]}"
        raise ValueError(f"{words}; write {' or '.join(readings)}")

    return NUMERAL.sub(pointed, cell) if isinstance(cell, str) else cell
