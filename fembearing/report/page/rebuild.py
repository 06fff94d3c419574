"""The page made again from report.json and the pictures beside it."""

import os
import sys
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from analytic.errors import InputError
from analytic.reading import opened
from analytic.writing import remove_leftovers, replaced_file
from fembearing.report.page.write import MARK, page_of
from fembearing.report.report import read_report

PAGE = "report.html"
NO_DETAILS: Mapping[str, str] = MappingProxyType({})
ENOUGH = 1000  # bytes at the beginning of a page, with its mark


@dataclass(frozen=True, kw_only=True)
class RebuiltPage:
    """The page that was written."""

    page: Path
    missing: tuple[str, ...]  # pictures that do not lie beside report.json
    warnings: tuple[str, ...] = ()


def rebuild_page(numbers: Path, *, out: Path | None = None, details: Mapping[str, str] = NO_DETAILS) -> RebuiltPage:
    """Write the page of a report.json, whole or not at all.

    out : the page; report.html beside the numbers without it. What exists there is replaced if it is such a page
    details : of [report] in place of those in report.json, which stays as it is
    Raises InputError for numbers that are no report, and for a page that would replace something else or cannot be
    written.
    """
    document = read_report(numbers)
    document = replace(document, report=replace(document.report, **details))
    target = numbers.with_name(PAGE) if out is None else out
    place = f"--out {str(target)!r}"
    if os.path.lexists(target) and not _is_page(target):
        raise InputError(f"{place} exists and is no page of fembearing: give another name, or remove it first")
    page = page_of(document, numbers.parent)
    remove_leftovers(target.parent)
    with replaced_file(target) as file:
        file.write_bytes(page.encode())
    named = (numbers.parent / picture.file for picture in document.pictures)
    missing = tuple(file.name for file in named if not file.is_file() or file.is_symlink())
    return RebuiltPage(page=target, missing=missing)


def _is_page(file: Path) -> bool:
    """Whether a file begins as a page of ours."""
    try:
        with opened(file, most=sys.maxsize, remedy="") as content:
            return MARK.encode() in content.read(ENOUGH)
    except InputError:
        return False
