"""How fast is this tree, and has it become slower? python validation/benchmarks/run.py [--short] [--record]

Measures contacts, validation, torques, intervals, the cage's motion, the start of the command line, and sweeps, in this
tree and in a temporary worktree of the recorded commit, in turns. Each figure is the best of all turns, in processor
seconds, or in wall seconds where a job uses several processes. The table has both figures, their ratio and the goal.
The exit status is 1 if a figure is more than 1.5 times as bad as at the recorded commit after three attempts, or if
this tree cannot measure it. A row of rows.py may state another limit, with its reason. The record is benchmarks.json in
this folder; --record renews it, with a table in benchmarks.md and the picture benchmarks.png. A clone without
the recorded commit compares nothing, and says so.

--short measures some rows only, in less than a minute. The machine should be idle for figures to quote.
"""

import argparse
import json
import signal
import sys
import time
from collections.abc import Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack, closing, suppress
from dataclasses import asdict, dataclass, field
from typing import Any

from validation.benchmarks.machine import machine, versions
from validation.benchmarks.rows import ROWS, Row
from validation.benchmarks.trees import ROOT, CommitMissingError, FailedError, Sample, Tree, checked_out, last_change

RECORD = ROOT / "validation" / "reports" / "benchmarks.json"
ATTEMPTS = 3  # until a row that became slower counts as such
REPEATS = 3  # turns
PATIENCE = {"short": 3.0, "full": 60.0}  # s, for the turns of a row; the first turn is finished in any case
UNITS = {"s": 1.0, "ms": 1e-3, "us": 1e-6}


@dataclass(kw_only=True)
class Measured:
    """A row in one tree."""

    samples: list[Sample] = field(default_factory=list)
    failed: str | None = None

    def add(self, row: Row, tree: Tree) -> None:
        if self.failed is None:
            try:
                self.samples.append(row.measure(tree))
            except FailedError as problem:
                self.failed = str(problem)

    def figure(self, row: Row) -> float | None:
        return None if self.failed or not self.samples else row.best(self.samples)


@dataclass(frozen=True, kw_only=True)
class Compared:
    """A row in this tree and in the recorded one."""

    row: Row
    now: Measured
    recorded: Measured

    @property
    def ratio(self) -> float | None:
        """How many times as bad this tree is; None where one of both figures is missing."""
        now, recorded = self.now.figure(self.row), self.recorded.figure(self.row)
        if now is None or recorded is None:
            return None
        return now / recorded if self.row.unit == "s" else recorded / now

    @property
    def slower(self) -> bool:
        return self.ratio is not None and self.ratio > self.row.worst

    @property
    def difference(self) -> float | None:
        """Of the results, relative: two trees that compute something else are not compared by their times."""
        both = [each.samples[0].result for each in (self.now, self.recorded) if each.samples]
        if len(both) < 2 or both[0] is None or not both[1]:
            return None
        return both[0] / both[1] - 1


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    names = [row.name for row in ROWS]
    parser.add_argument("--short", action="store_true", help="some rows only")
    parser.add_argument("--rows", nargs="+", choices=names, metavar="ROW", help=", ".join(names))
    parser.add_argument("--against", metavar="COMMIT", help="another commit than the recorded one")
    parser.add_argument("--repeats", type=int, default=REPEATS, help="turns of each row")
    parser.add_argument("--record", action="store_true", help="make this commit the recorded one")
    options = parser.parse_args(argv)
    if options.repeats < 1:
        parser.error("--repeats must be at least 1")
    commit = last_change()
    if options.record and (options.short or options.rows):
        parser.error("--record needs all rows")
    if options.record and commit is None:
        parser.error("--record needs analytic and fembearing as they are committed")
    rows = [row for row in ROWS if row.name in (options.rows or names) and (row.short or not options.short)]
    against = options.against or json.loads(RECORD.read_text("utf-8"))["commit"]
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))  # so that the worktree goes whatever ends the run
    with ExitStack() as stack:
        folders = [ROOT]
        try:
            folders.append(stack.enter_context(checked_out(against)))
        except CommitMissingError as problem:
            sys.stdout.write(f"Not compared: {problem}. This tree alone is measured, and no ratio can fail.\n")
        trees = [stack.enter_context(closing(Tree(folder))) for folder in folders]
        patience = PATIENCE["short" if options.short else "full"]
        compared = [measured(row, trees, repeats=options.repeats, patience=patience) for row in rows]
    print_table(compared, against=against)
    if options.record:
        record(compared, commit=str(commit), against=against)
    return verdict(compared)


def measured(row: Row, trees: Sequence[Tree], *, repeats: int, patience: float) -> Compared:
    """One row, the trees in turns; a row that seems slower is measured again.

    patience : seconds of an attempt after which no other turn begins
    """
    compared = Compared(row=row, now=Measured(), recorded=Measured())
    parts = list(zip((compared.now, compared.recorded), trees, strict=False))
    if not row.once:
        warm(row, trees)
    for _ in range(ATTEMPTS):
        started = time.perf_counter()
        for turn in range(1 if row.once else repeats):
            if turn and time.perf_counter() - started > patience:
                break
            for part, tree in parts:
                part.add(row, tree)
        if not compared.slower:
            break
    sys.stderr.write(f"{row.name}: {shown(compared.now.figure(row), row)}\n")
    return compared


def warm(row: Row, trees: Iterable[Tree]) -> None:
    """Fill the caches of both trees at once; this time does not count."""

    def once(tree: Tree) -> None:
        with suppress(FailedError):
            row.measure(tree)

    with ThreadPoolExecutor() as pool:
        list(pool.map(once, trees))


def verdict(compared: Iterable[Compared]) -> int:
    """The exit status, after a line for each row that fails."""
    lines = []
    for each in compared:
        if each.now.failed:
            lines.append(f"{each.row.name}: {each.now.failed}")
        elif each.slower:
            most = f"at most {each.row.worst:g}"
            lines.append(f"{each.row.name}: {each.ratio:.2f} times as bad as at the recorded commit, {most}")
    sys.stdout.writelines(f"FAILED {line}\n" for line in lines)
    return 1 if lines else 0


def shown(figure: float | None, row: Row) -> str:
    if figure is None:
        return "-"
    if row.unit == "times":
        return f"{figure:.2f} times"
    unit = next((unit for unit, size in UNITS.items() if figure >= 0.1 * size), "us")
    return f"{figure / UNITS[unit]:.3g} {unit}"


def cells(each: Compared) -> tuple[str, ...]:
    """What, before, now, ratio, goal, difference of the results, notes."""
    row, now = each.row, each.now.figure(each.row)
    met = now is not None and row.goal is not None and (now <= row.goal if row.unit == "s" else now >= row.goal)
    notes = {"now": each.now.failed or note_of(each.now)}
    notes["then"] = "that tree cannot" if each.recorded.failed else note_of(each.recorded)
    return (
        f"{row.title}{', wall' if row.clock == 'wall' and row.unit == 's' else ''}",
        shown(each.recorded.figure(row), row),
        shown(now, row),
        "-" if each.ratio is None else f"{each.ratio:.3g}",
        "" if row.goal is None else shown(row.goal, row) + (", met" if met else ""),
        "" if each.difference is None else f"{100 * each.difference:+.2g} %",
        "; ".join(f"{when}: {text}" for when, text in notes.items() if text),
    )


def note_of(part: Measured) -> str:
    return part.samples[-1].note if part.samples else ""


def heads(against: str) -> tuple[str, ...]:
    return ("what", f"at {against[:9]}", "this tree", "ratio", "goal", "result differs by", "notes")


def print_table(compared: Iterable[Compared], *, against: str) -> None:
    from rich.console import Console
    from rich.table import Table

    table = Table(*heads(against), title=f"{machine()}; {versions('numpy', 'scipy', 'numba')}")
    for each in compared:
        table.add_row(*cells(each))
    Console(width=150).print(table)


def record(compared: Sequence[Compared], *, commit: str, against: str) -> None:
    from validation.benchmarks.speed_figure import draw  # with matplotlib

    result = {
        "commit": commit,
        "against": against,
        "machine": machine(),
        "versions": versions("numpy", "scipy", "numba"),
        "rows": [as_json(each) for each in compared],
    }
    RECORD.write_text(json.dumps(result, indent=1) + "\n", "utf-8")
    table = [heads(against), ("---",) * len(heads(against)), *map(cells, compared)]
    title = (
        f"# Speed of {commit[:9]} against {against[:9]}\n\n`python validation/benchmarks/run.py --record` measured:\n"
    )
    lines = "\n".join(f"| {' | '.join(line)} |" for line in table)
    RECORD.with_suffix(".md").write_text(f"{title}\n{lines}\n\n{machine()}; {result['versions']}.\n", "utf-8")
    draw(result, RECORD.with_suffix(".png"))


def as_json(each: Compared) -> dict[str, Any]:
    row = each.row
    return {
        **{name: getattr(row, name) for name in ("name", "title", "unit", "clock", "goal")},
        "figure": each.now.figure(row),
        "recorded_figure": each.recorded.figure(row),
        "ratio": each.ratio,
        "result_differs_by": each.difference,
        "now": asdict(each.now),
        "recorded": asdict(each.recorded),
    }


if __name__ == "__main__":
    sys.exit(main())
