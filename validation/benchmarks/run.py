"""How fast is this tree beside another? python validation/benchmarks/run.py [--against COMMIT_OR_WHEEL] [--short]

Each row of rows.toml is an expression. It is timed in this tree and in another one in turns, each time in a new
process: the expression is repeated for a twentieth of a second once it is warm, or is called once where the first call
of a process counts. The table has the medians of both trees, the median of the ratios of the pairs, and the difference
of the results. Seconds are those of the processor with its children; wall seconds where several processes work.

The exit status is 1 if a row fails in one of the trees, or if it takes more than 1.3 times as long as in the other tree
in each of three attempts. --json FILE also writes all figures. The machine should be idle for figures to quote.
"""

import argparse
import json
import os
import subprocess
import sys
import tarfile
import tempfile
import tomllib
import zipfile
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from typing import Any, Literal

from rich.progress import track

from validation.study import machine, progress
from validation.study import show as show_table

AGAINST = "dfce3aaa"  # renewed after a change that is slower on purpose
ATTEMPTS, PAIRS = 3, 3
SLOWER = 1.3  # times, in each of three attempts: pairs scatter on a machine that does something else too
LIMIT = 3600.0  # s, for one process
ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")


@dataclass(frozen=True, kw_only=True)
class Row:
    """A row of rows.toml, which says what its keys are."""

    title: str
    call: str = ""
    scene: str = ""
    setup: str = ""
    goal: float | None = None
    clock: Literal["cpu", "wall"] = "cpu"
    first: bool = False
    short: bool = False


HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
ROWS = {name: Row(**row) for name, row in tomllib.loads((HERE / "rows.toml").read_text("utf-8")).items()}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--against", default=AGAINST, metavar="COMMIT_OR_WHEEL")
    parser.add_argument("--rows", nargs="+", choices=ROWS, metavar="ROW", help=", ".join(ROWS))
    parser.add_argument("--short", action="store_true", help="some rows only")
    parser.add_argument("--pairs", type=int, default=PAIRS, help="turns of each row")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args()
    names = options.rows or [name for name, row in ROWS.items() if row.short or not options.short]
    with tempfile.TemporaryDirectory() as place:
        trees = [ROOT, *unpacked(options.against, Path(place).resolve())]
        found = {}
        for name in track(names, "rows", console=progress):
            found[name] = measured(ROWS[name], trees, pairs=options.pairs)
    show(found, against=options.against)
    if options.json:
        about = {"machine": machine(), "against": options.against, "rows": found}
        options.json.write_text(json.dumps(about, indent=1) + "\n", "utf-8")
    return int(any(each.get("failed") or each.get("ratio", 0.0) > SLOWER for each in found.values()))


def unpacked(against: str, place: Path) -> list[Path]:
    """A folder with the packages of a wheel or a commit; none where this clone lacks the commit."""
    if against.endswith(".whl"):
        zipfile.ZipFile(against).extractall(place)
        return [place]
    archive = place / "tree.tar"
    git = ("git", "-C", str(ROOT), "archive", "-o", str(archive), against, "analytic", "fembearing", "meshes")
    try:
        subprocess.run(git, check=True, capture_output=True, text=True)
    except (OSError, subprocess.CalledProcessError) as problem:
        reason = str(getattr(problem, "stderr", None) or problem).strip()
        progress.print(f"Nothing is compared, {against} is not in this clone: {reason}")
        return []
    with tarfile.open(archive) as tree:
        tree.extractall(place, filter="data")
    return [place]


def measured(row: Row, trees: list[Path], *, pairs: int) -> dict[str, Any]:
    """Figures of a row in both trees; a row that seems slower is measured again."""
    samples: list[list[dict[str, Any]]] = []
    found: dict[str, Any] = {"title": row.title, "clock": row.clock, "goal": row.goal}
    for attempt in range(ATTEMPTS):
        try:
            if row.first and attempt == 0:  # formulas that a tree has not compiled yet do not count
                for tree in trees:
                    timed(row, tree)
            for turn in range(pairs):
                order = trees if turn % 2 == 0 else trees[::-1]
                pair = {tree: timed(row, tree) for tree in order}
                samples.append([pair[tree] for tree in trees])
        except RuntimeError as problem:
            return found | {"failed": str(problem)}
        figures = [[sample[row.clock] for sample in pair] for pair in samples[attempt * pairs :]]
        found["seconds"] = [median(column) for column in zip(*figures, strict=True)]
        if len(trees) == 1:
            break
        found["ratio"] = median(now / then for now, then in figures)
        found["pairs"] = [now / then for now, then in figures]
        now, then = (sample["result"] for sample in samples[0])
        found["result_differs_by"] = now / then - 1 if now is not None and then else None
        if found["ratio"] <= SLOWER:
            break
    return found


def timed(row: Row, tree: Path) -> dict[str, Any]:
    """Seconds and result of one process. Raises RuntimeError."""
    environment = os.environ | {"PYTHONPATH": str(tree), "PYTHONDONTWRITEBYTECODE": ""}
    environment |= {} if '"validate"' in row.call else ONE_THREAD
    given = json.dumps([asdict(row), str(tree), str(ROOT / "validation" / "scenes")])
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-P", HERE / "timed.py"]
        done = subprocess.run(
            command, input=given, cwd=folder, env=environment, capture_output=True, text=True, timeout=LIMIT
        )
    if done.returncode:
        raise RuntimeError(f"{tree}: {(done.stderr.strip().splitlines() or ['no message'])[-1]}")
    return json.loads(done.stdout.splitlines()[-1])


def show(found: dict[str, dict[str, Any]], *, against: str) -> None:
    heads = ("row", "what", "this tree, s", f"{against[:12]}, s", "ratio", "goal, s", "result differs by")
    rows = []
    for name, each in found.items():
        seconds = [f"{value:.3g}" for value in each.get("seconds", ())] + ["", ""]
        ratio, differs = each.get("ratio"), each.get("result_differs_by")
        verdict = "" if ratio is None else f"{ratio:.2f}" + (" SLOWER" if ratio > SLOWER else "")
        title = each["title"] + (", wall" if each["clock"] == "wall" else "")
        goal = f"{each['goal']:g}" if each["goal"] else ""
        change = "" if differs is None else f"{differs:+.1e}"
        rows.append((name, title, *seconds[:2], each.get("failed", verdict), goal, change))
    show_table(heads, rows, machine())


if __name__ == "__main__":
    sys.exit(main())
