"""Do the tests of a folder see a change of one operator in it?

Each mutant runs in a copy of the tree with the tests that mirror its module's folder, the module's own tests first,
until one fails. A test that fails, or tests that hang, have seen the mutant; any other end of pytest is an error.
Each mutant has all formulas that its tests take compiled, in a folder that is deleted after it. In the end the tests
that failed run on the source as it is: they must pass.
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
from functools import cache
from pathlib import Path
from queue import SimpleQueue

from analytic.numerics.compilation import FOLDER
from validation.stress.mutants import PACKAGES, Mutant, drawn

ROOT = Path(__file__).resolve().parents[2]
LEFT_OUT = (".git", ".venv*", ".*_cache", "__pycache__", "build", "dist", "*.egg-info")  # of the copies
MEMORY = 8_000_000_000  # bytes of data of a process
LONGEST, DEAF = (
    700,
    3000,
)  # s of the processor, of which up to 300 compile, and of the clock; tests that do not end have seen the mutant
LIMITED = f'ulimit -t {LONGEST}; ulimit -d {MEMORY // 1024}; exec "$@"'
TIMED_OUT = (124, 137, 152, -9, -24)  # statuses of `timeout`, and of a process that the limit ends
FAILED = 1  # status of pytest where a test fails
KILLED = ("killed", "timeout")
COLUMNS = ("module", "line", "kind", "before", "after", "outcome", "seconds", "test", "judgement", "commit")


@dataclass(frozen=True)
class Outcome:
    mutant: Mutant
    outcome: str  # killed, timeout, survived, error
    seconds: float
    test: str  # that failed first, or what an error says

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
            "commit": commit(),
        }


class Tree:
    """A copy of the tree, in which one mutant at a time is tested."""

    def __init__(self, folder: Path, before: Sequence[str]) -> None:
        self.root, self.before = folder, before
        shutil.copytree(ROOT, self.root, ignore=shutil.ignore_patterns(*LEFT_OUT), symlinks=True)
        for package in (*PACKAGES, "tests"):
            compileall.compile_dir(self.root / package, quiet=1)
        self.writes = 0

    def test(self, mutant: Mutant) -> Outcome:
        with self.changed(mutant):
            return Outcome(mutant, *self.run(tests_of(self.root, mutant.module)))

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

    def run(self, tests: Sequence[str]) -> tuple[str, float, str]:
        """Run tests until one fails: outcome, seconds, and the test."""
        limits = ("timeout", "--kill-after=10", str(DEAF), "bash", "-c", LIMITED, "limited")
        pytest = (sys.executable, "-m", "pytest", "-q", "-x", "-rfE", "-p", "no:cacheprovider")
        own = {"PYTHONPATH": str(self.root), "PYTHONDONTWRITEBYTECODE": "1", "CI": "true", "OMP_NUM_THREADS": "1"}
        with tempfile.TemporaryFile() as output, tempfile.TemporaryDirectory() as cache:
            start = time.monotonic()
            done = subprocess.run(
                [*self.before, *limits, *pytest, *tests],
                cwd=self.root,
                env=os.environ | own | {FOLDER: cache},
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
        if done.returncode == FAILED and failed:
            return "killed", seconds, failed[0]
        said = failed or words.strip().splitlines()[-1:]
        return "error", seconds, f"status {done.returncode}: {''.join(said[:1]):.200}"


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


@cache
def commit() -> str:
    """The commit of the tree."""
    command = ["git", "-C", str(ROOT), "describe", "--always", "--dirty"]
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout.strip()


def test_mutants(count: int, seed: int, *, jobs: int, before: Sequence[str], record: Path) -> None:
    """Test mutants; each is added to the CSV file at once. Those that it has of this commit are not tested again."""
    mutants = drawn(ROOT, count, seed)
    done = {tuple(row[name] for name in COLUMNS[:5]) for row in rows_of(record) if row["commit"] == commit()}
    ahead = [
        mutant
        for mutant in mutants
        if (mutant.module, str(mutant.line), mutant.kind, mutant.before, mutant.after) not in done
    ]
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        trees: SimpleQueue[Tree] = SimpleQueue()
        for number in range(jobs):
            trees.put(Tree(Path(folder) / str(number), before))

        def test(mutant: Mutant) -> None:
            tree = trees.get()
            try:
                outcome = tree.test(mutant)
            finally:
                trees.put(tree)
            add(record, outcome.row)

        for _ in pool.map(test, ahead):
            pass


def failing_without(record: Path, before: Sequence[str]) -> Iterator[str]:
    """The tests that failed with a mutant of this commit and do not pass without one, at most one of each file.

    Each file has the limits of time of a mutant; tests that do not end within them have not passed.
    """
    files: dict[str, set[str]] = {}
    for row in rows_of(record):
        if row["commit"] == commit() and row["outcome"] == "killed":
            test = row["test"].partition(" ")[2].partition("[")[0]
            files.setdefault(test.partition("::")[0], set()).add(test)
    with tempfile.TemporaryDirectory() as folder:
        tree = Tree(Path(folder) / "tree", before)
        for file, tests in files.items():
            outcome, seconds, words = tree.run(sorted(tests))
            if outcome != "survived":
                yield words or f"{file}: {outcome} after {seconds:.0f} s"


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
