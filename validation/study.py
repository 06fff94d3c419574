"""What studies share: command line, rows in CSV files, work that an interrupted run continues, tables, figures."""

import csv
import os
import platform
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from importlib.metadata import version
from pathlib import Path
from typing import Annotated, Any, TypeVar

import numpy as np
import typer
from matplotlib.figure import Figure
from rich.console import Console
from rich.progress import track
from rich.table import Table

Row = dict[str, str]
Task = TypeVar("Task")
HERE = Path(__file__).resolve().parent
ROOT, PUBLISHED, SCENES = HERE.parent, HERE / "published", HERE / "scenes"
Out = Annotated[Path, typer.Option("--out", help="Folder of the results.")]
Jobs = Annotated[int, typer.Option(min=1, help="Processes.")]
out = Console(width=130, highlight=False, markup=False)
progress = Console(stderr=True)


def machine() -> str:
    """The machine and versions of a run, for the head of its results."""
    versions = ", ".join(f"{package} {version(package)}" for package in ("fembearing", "numpy", "scipy"))
    cores = f"{platform.machine()}, {os.cpu_count()} cores, {platform.system()}"
    return f"{cores}, Python {platform.python_version()}; {versions}"


def run(main: Callable[..., object]) -> None:
    """The command line of a program; its help is the program's docstring."""
    command = typer.Typer(add_completion=False, rich_markup_mode=None, pretty_exceptions_enable=False)
    command.command(help=sys.modules[main.__module__].__doc__)(main)
    command()


def read(path: Path) -> list[Row]:
    """The rows of a file, without lines of comment; none where there is no file."""
    lines = path.read_text("utf-8").splitlines() if path.exists() else []
    return list(csv.DictReader(line for line in lines if not line.startswith("#")))


def numbers(rows: Iterable[Row], name: str) -> np.ndarray:
    """A column, (n,); NaN where a cell is empty."""
    return np.array([float(row.get(name) or "nan") for row in rows])


def published(name: str) -> list[Row]:
    """The rows of a file of validation/published."""
    return read(PUBLISHED / name)


def write(
    rows: Iterable[Mapping[str, object]],
    path: Path,
    columns: Sequence[str],
    *,
    about: Iterable[str] = (),
    form: str = ".6g",
) -> None:
    """Replace the file in one step, so that an interrupted run leaves a complete one.

    about : lines of comment;  form : of numbers with a point
    """
    path.parent.mkdir(parents=True, exist_ok=True)
    fresh = path.with_suffix(".new")
    with fresh.open("w", encoding="utf-8", newline="") as file:
        file.writelines(f"# {line}\n" for line in about)
        writer = csv.DictWriter(file, columns, restval="", lineterminator="\n")
        writer.writeheader()
        for row in rows:
            writer.writerow({name: f"{cell:{form}}" if isinstance(cell, float) else cell for name, cell in row.items()})
    os.replace(fresh, path)


def continued(
    path: Path,
    columns: Sequence[str],
    tasks: Mapping[tuple[str, ...], Task],
    work: Callable[[Task], Iterable[Mapping[str, object]]],
    *,
    jobs: int = 1,
    **options: Any,
) -> list[Row]:
    """The rows of a file, to which those of the tasks that it lacks are added, each when it is done.

    tasks : by what the first columns of their rows have;  work : the rows of a task;  options : of `write`
    """
    rows: list[Any] = read(path)
    done = {tuple(row[name] for name in columns[: len(next(iter(tasks), ()))]) for row in rows}
    ahead = [task for key, task in tasks.items() if key not in done]
    with ProcessPoolExecutor(jobs) as pool:
        found = pool.map(work, ahead) if jobs > 1 else map(work, ahead)
        for new in track(found, path.stem, total=len(ahead), console=progress):
            rows += new
            write(rows, path, columns, **options)
    return read(path)


def show(heads: Sequence[str], rows: Iterable[Sequence[object]], title: str | None = None) -> None:
    """Print a table."""
    table = Table(*heads, title=title)
    for row in rows:
        table.add_row(*map(str, row))
    out.print(table)


def markdown(heads: Sequence[str], rows: Iterable[Sequence[object]]) -> Iterator[str]:
    """The lines of a table in Markdown."""
    yield f"| {' | '.join(heads)} |"
    yield "| --- " * len(heads) + "|"
    for row in rows:
        yield f"| {' | '.join(map(str, row))} |"


def write_text(path: Path, lines: Iterable[str]) -> None:
    """Write lines to a file, and print them."""
    text = "\n".join(lines) + "\n"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, "utf-8")
    sys.stdout.write(text)


def figure(width: float, height: float) -> Figure:
    """An empty figure; inches."""
    return Figure(figsize=(width, height), layout="constrained")


def save(drawn: Figure, path: Path, *, dpi: int = 130) -> None:
    """Write a picture, the same on each machine."""
    path.parent.mkdir(parents=True, exist_ok=True)
    drawn.savefig(path, dpi=dpi, metadata={"Software": None})
