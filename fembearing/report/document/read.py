"""Reading a report.json: the document, or one line on what is wrong with the file."""

import json
from importlib.metadata import version
from pathlib import Path
from typing import Any, NoReturn

from pydantic import ValidationError

from analytic.errors import InputError
from analytic.reading import content_of
from fembearing.report.document.report import FORMAT, KIND, Report

LARGEST_FILE = 256_000_000  # bytes: ten times a series of thousand points
SHOWN = 60  # characters of a value in a message
FAULTS = {
    "missing": "is missing",
    "float_type": "is no number",
    "int_type": "is no whole number",
    "bool_type": "is neither true nor false",
    "string_type": "is no text",
    "list_type": "is no list",
    "dict_type": "is no table",
    "model_type": "is no table",
    "finite_number": "is not finite",
    "extra_forbidden": "is not known",
    "string_pattern_mismatch": "is not written as it must be",
}


def read_report(path: Path) -> Report:
    """The document in a report.json.

    Raises InputError, in one line, for what is no regular file, is too large, is no such document or is damaged.
    """
    text = _text_of(path)
    try:
        content = json.loads(text, parse_constant=_no_number)
        json.dumps(content, ensure_ascii=False).encode()  # half a character, as an escape lets it in, is refused here
    except (ValueError, RecursionError) as problem:
        raise InputError(
            f"{str(path)!r} is no JSON, or cut off: {problem}; run `fembearing validate` again"
        ) from problem
    if not isinstance(content, dict) or content.get("kind") != KIND:
        raise InputError(f"{str(path)!r} is JSON, but no report of `fembearing validate`; give the report.json of one")
    if content.get("format") != FORMAT:
        raise InputError(
            f"{str(path)!r} is of fembearing {_writer(content) or 'unknown'}, format {content.get('format')!r}; this "
            f"fembearing {_ours()} reads format {FORMAT}: take that version, or run `fembearing validate` again"
        )
    try:
        return Report.model_validate(content)
    except ValidationError as problem:
        raise InputError(f"{str(path)!r}: {_fault(problem)}; {_remedy(content)}") from problem


def _text_of(path: Path) -> bytes:
    try:
        return content_of(path, most=LARGEST_FILE, remedy="give the report.json of a report")
    except InputError as problem:
        raise InputError(f"{str(path)!r}: {problem}") from problem


def _no_number(name: str) -> NoReturn:
    raise ValueError(f"{name} is no number of JSON")


def _fault(problem: ValidationError) -> str:
    """The first fault, in words."""
    first, *others = problem.errors(include_url=False)
    where = ".".join(map(str, first["loc"])) or "it"
    words = FAULTS.get(first["type"], first["msg"].removeprefix("Value error, "))
    shown = "" if first["type"] in ("missing", "value_error") else f" = {_shortened(first['input'])}"
    more = f" (and {len(others)} more)" if others else ""
    return f"{where}{shown} {words}{more}"


def _shortened(value: object) -> str:
    text = repr(value)
    return text if len(text) <= SHOWN else f"{text[: SHOWN // 2]}...{text[-SHOWN // 2 :]}"


def _remedy(content: dict[str, Any]) -> str:
    """What to do about a damaged report, with the versions that wrote and read it."""
    wrote = _writer(content)
    other = "" if wrote in (None, _ours()) else f" or was written by fembearing {wrote}, this is {_ours()}"
    return f"it was changed{other}: run `fembearing validate` again"


def _writer(content: dict[str, Any]) -> str | None:
    """The version that wrote a report; None where it does not say."""
    origin = content.get("provenance")
    versions = origin.get("versions") if isinstance(origin, dict) else None
    wrote = versions.get("fembearing") if isinstance(versions, dict) else None
    return wrote if isinstance(wrote, str) else None


def _ours() -> str:
    return version("fembearing")
