"""Do the tests of a folder see a change of one operator in it?

Each mutant runs in a copy of the tree with the tests that mirror its module's folder, the module's own tests first,
until one fails. Machine code of formulas is kept in a copy of the cache, where it is known by its source, so that only
what a mutant changes is compiled again. In the end the tests that failed run on the source as it is: they must pass.
"""

import compileall
import csv
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from queue import SimpleQueue

from mutants import PACKAGES, Mutant, drawn

from analytic.numerics.machine_code import FOLDER, cache_folder

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = (".git", ".venv*", ".*_cache", "__pycache__", "build", "dist", "*.egg-info")  # of the copies
MEMORY = 8_000_000_000  # bytes of data of a process
LONGEST, DEAF = 400, 3000  # s of the processor and of the clock; tests that do not end have seen the mutant
LIMITED = f'ulimit -t {LONGEST}; ulimit -d {MEMORY // 1024}; exec "$@"'
TIMED_OUT = (124, 137, 152, -9, -24)  # statuses of `timeout`, and of a process that the limit ends
COLUMNS = ("module", "line", "kind", "before", "after", "outcome", "seconds", "test", "judgement")


@dataclass(frozen=True)
class Outcome:
    mutant: Mutant
    outcome: str  # killed, timeout, survived
    seconds: float
    test: str  # that failed first

    @property
    def row(self) -> dict[str, object]:
        mutant = self.mutant
        return {
            "module": mutant.module,
            "line": mutant.line,
            "kind": mutant.kind,
            "before": mutant.before,
            "after": mutant.after,
            "outcome": self.outcome,
            "seconds": f"{self.seconds:.0f}",
            "test": self.test,
            "judgement": "",  # of a survivor, by hand: the test that sees it now, or why it changes nothing
        }


class Tree:
    """A copy of the tree, in which one mutant at a time is tested."""

    def __init__(self, folder: Path, cache: Path, before: Sequence[str]) -> None:
        self.root, self.cache, self.before = folder, cache, before
        shutil.copytree(ROOT, self.root, ignore=shutil.ignore_patterns(*LEFT_OUT), symlinks=True)
        for package in (*PACKAGES, "tests"):
            compileall.compile_dir(self.root / package, quiet=1)
        self.writes = 0

    def test(self, mutant: Mutant) -> Outcome:
        with self.changed(mutant):
            return Outcome(mutant, *self.run(tests_of(self.root, mutant.module), "-x"))

    @contextmanager
    def changed(self, mutant: Mutant) -> Iterator[None]:
        file = self.root / mutant.module
        original, times = file.read_bytes(), file.stat()
        self.writes += 1
        file.write_bytes(mutant.source(original))
        os.utime(file, (self.writes, self.writes))  # Python knows stale byte code by time and size
        try:
            yield
        finally:
            file.write_bytes(original)
            os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))

    def run(self, tests: Sequence[str], *options: str) -> tuple[str, float, str]:
        """Outcome, seconds, and the first test that failed."""
        limits = ("timeout", "--kill-after=10", str(DEAF), "bash", "-c", LIMITED, "limited")
        pytest = (sys.executable, "-m", "pytest", "-q", "-rfE", "-p", "no:cacheprovider")
        own = {"PYTHONPATH": str(self.root), "PYTHONDONTWRITEBYTECODE": "1", "CI": "true", "OMP_NUM_THREADS": "1"}
        with tempfile.TemporaryFile() as output:
            start = time.monotonic()
            done = subprocess.run(
                [*self.before, *limits, *pytest, *options, *tests],
                cwd=self.root,
                env=os.environ | own | {FOLDER: str(self.cache)},
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                check=False,
            )
            seconds = time.monotonic() - start
            output.seek(0)
            words = output.read().decode(errors="replace")
        if done.returncode == 0:
            return "survived", seconds, ""
        if done.returncode in TIMED_OUT:
            return "timeout", seconds, ""
        failed = [line.partition(" - ")[0] for line in words.splitlines() if line.startswith(("FAILED", "ERROR"))]
        return "killed", seconds, failed[0] if failed else words.strip().splitlines()[-1][:200] if words.strip() else ""


def tests_of(root: Path, module: str) -> list[str]:
    """The files with tests of a module's folder, those first that have its name or name it most often.

    `tests` mirrors the folders of both packages; a folder without tests of its own has them one folder up.
    """
    path = Path(module)
    folder = path.parent if path.parts[0] == "analytic" else path.parent.relative_to("fembearing")
    while not (files := sorted((root / "tests" / folder).glob("test_*.py"))):
        folder = folder.parent
    dotted = ".".join(path.with_suffix("").parts)

    def distance(file: Path) -> tuple[bool, int]:
        return not file.stem.startswith(f"test_{path.stem}"), -file.read_text("utf-8").count(dotted)

    return [file.relative_to(root).as_posix() for file in sorted(files, key=distance)]


def tested(count: int, seed: int, *, jobs: int, before: Sequence[str], record: Path) -> Iterator[Outcome]:
    """The outcomes of mutants; each is added to the CSV file at once, and those that it has are not tested again."""
    mutants = drawn(ROOT, count, seed)
    done = {tuple(row[name] for name in COLUMNS[:5]) for row in rows_of(record)}
    ahead = [
        mutant
        for mutant in mutants
        if (mutant.module, str(mutant.line), mutant.kind, mutant.before, mutant.after) not in done
    ]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        trees: SimpleQueue[Tree] = SimpleQueue()
        cache, shared = Path(folder) / "cache", cache_folder()
        cache.mkdir()
        if shared is not None and shared.is_dir():
            shutil.copytree(shared, cache, dirs_exist_ok=True)
        for number in range(jobs):
            trees.put(Tree(Path(folder) / str(number), cache, before))

        def outcome_of(mutant: Mutant) -> Outcome:
            tree = trees.get()
            try:
                outcome = tree.test(mutant)
            finally:
                trees.put(tree)
            add(record, outcome.row)
            return outcome

        yield from pool.map(outcome_of, ahead)


def failing_without(record: Path, before: Sequence[str]) -> str:
    """The first of the tests that failed with a mutant that fails without one too; "" where there is none."""
    tests = {row["test"].removeprefix("FAILED ").removeprefix("ERROR ").partition("[")[0] for row in rows_of(record)}
    with tempfile.TemporaryDirectory() as folder:
        cache = Path(folder) / "cache"
        cache.mkdir()
        return Tree(Path(folder) / "tree", cache, before).run(sorted(tests - {""}), "-x")[2]


def rows_of(record: Path) -> list[dict[str, str]]:
    if not record.exists():
        return []
    with record.open(newline="") as file:
        return list(csv.DictReader(file))


def add(record: Path, row: dict[str, object]) -> None:
    new = not record.exists()
    with record.open("a", newline="") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, COLUMNS)
        if new:
            writer.writeheader()
        writer.writerow(row)
