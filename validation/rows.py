"""Rows of results in CSV files, which an interrupted program continues."""

import csv
import os
from collections.abc import Iterable, Sequence
from pathlib import Path

Row = dict[str, str]


def read(path: Path) -> list[Row]:
    """The rows of a file, without lines of comment; none where there is no file."""
    lines = path.read_text("utf-8").splitlines() if path.exists() else []
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def write(rows: Iterable[Row], path: Path, columns: Sequence[str], *, about: Iterable[str] = ()) -> None:
    """Replace the file in one step, so that an interrupted run leaves a complete one; about : lines of comment."""
    fresh = path.with_suffix(".new")
    with fresh.open("w", encoding="utf-8", newline="") as file:
        file.writelines(f"# {line}\n" for line in about)
        writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)
    os.replace(fresh, path)
