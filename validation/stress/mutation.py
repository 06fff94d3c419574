"""Do the tests of a folder see a change of one operator in it?

A mutant is the source with one node of its syntax tree replaced: + and - swapped, * and / swapped, a power raised by
one, a comparison turned round, `<` and `<=` swapped beside a whole number, `and` and `or` swapped, `not` or a minus
taken away, min and max swapped, or a coefficient increased by a tenth. Messages and assertions are left alone, and so
are coefficients in modules that draw. Each mutant runs in a copy of the tree with the tests that mirror its module's
folder, until one fails; tests that hang have seen it too. Compiled formulas are kept by the content of their sources:
mutants that change none of these share them.
"""

import ast
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Generator, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from pathlib import Path
from queue import SimpleQueue
from typing import NamedTuple

import numpy as np

from analytic.numerics.machine_code import CACHE
from validation.study import ROOT

PACKAGES = ("analytic", "fembearing")
LEFT_OUT = shutil.ignore_patterns(".git", ".venv*", ".*_cache", "__pycache__", "build", "dist", "*.egg-info")
DRAWING = ("fembearing/report/figures", "fembearing/report/pictures")
LIMITED = 'ulimit -t 700; ulimit -d 8000000; exec "$@"'  # s of the processor, 300 to compile; kB of data
DEAF = "3000"  # s of the clock
TIMED_OUT = (124, 137, 152, -9, -24)  # statuses of `timeout`, and of a process that a limit ends
SWAPPED = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult}
OPPOSITE = {ast.Lt: ast.GtE, ast.Gt: ast.LtE, ast.Eq: ast.NotEq, ast.Is: ast.IsNot, ast.In: ast.NotIn}
OPPOSITE |= {after: before for before, after in OPPOSITE.items()}
LIMIT = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}  # itself out of the range, or into it
EXTREMES = {"min": "max", "minimum": "maximum", "argmin": "argmax"}
EXTREMES |= {after: before for before, after in EXTREMES.items()}


class Mutant(NamedTuple):
    """One change of one expression."""

    module: str  # path from the root
    line: int
    kind: str
    before: str
    after: str
    span: tuple[int, int]  # of the expression in the file, bytes

    def source(self, original: bytes) -> bytes:
        return original[: self.span[0]] + b"(" + self.after.encode() + b")" + original[self.span[1] :]


class Outcome(NamedTuple):
    mutant: Mutant
    outcome: str  # killed, timeout, survived, error
    seconds: float
    test: str  # that failed first, or what an error says

    @property
    def row(self) -> dict[str, object]:
        mutant = dict(zip(Mutant._fields[:-1], self.mutant, strict=False))
        return mutant | {"outcome": self.outcome, "seconds": round(self.seconds), "test": self.test}


def drawn(count: int, seed: int, root: Path = ROOT) -> list[Mutant]:
    """Half of them from each package, at even distances in the row of all its mutants, in random order."""
    rng = np.random.default_rng(seed)
    chosen = []
    for package in PACKAGES:
        every = [mutant for path in sorted((root / package).rglob("*.py")) for mutant in mutants(path, root)]
        places = ((np.arange(count // 2) + rng.random()) * len(every) / (count // 2)).astype(int)
        chosen += [every[place] for place in np.unique(places)]
    return [chosen[place] for place in rng.permutation(len(chosen))]


def mutants(path: Path, root: Path = ROOT) -> Iterator[Mutant]:
    source, module = path.read_bytes(), path.relative_to(root).as_posix()
    starts = np.cumsum([0, *map(len, source.splitlines(keepends=True))])
    for node in expressions(ast.parse(source)):
        ends = (node.lineno, node.col_offset), (node.end_lineno, node.end_col_offset)
        first, last = (int(starts[line - 1]) + column for line, column in ends)
        for kind, after in changes(node):
            if kind != "coefficient" or not module.startswith(DRAWING):
                yield Mutant(module, node.lineno, kind, ast.unparse(node), ast.unparse(after), (first, last))


def expressions(node: ast.AST) -> Iterator[ast.expr]:
    """All expressions of a tree that decide or compute."""
    for name, child in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "format_spec", "type_params"):
            continue
        for each in child if isinstance(child, list) else [child]:
            is_code = isinstance(each, ast.AST) and not isinstance(each, ast.Raise | ast.Assert | ast.JoinedStr)
            if is_code and not (isinstance(each, ast.If) and "TYPE_CHECKING" in ast.unparse(each.test)):
                if isinstance(each, ast.expr):
                    yield each
                yield from expressions(each)


def changes(node: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    """What kind of change, and the node that replaces this one."""

    def with_(**fields: object) -> ast.expr:
        other = deepcopy(node)
        vars(other).update(fields)
        return other

    match node:
        case ast.BinOp(op=ast.Pow(), right=power):
            yield "power", with_(right=ast.BinOp(power, ast.Add(), ast.Constant(1)))
        case ast.BinOp(op=op) if type(op) in SWAPPED and not of_text(node):
            yield "arithmetic", with_(op=SWAPPED[type(op)]())
        case ast.BinOp(op=ast.BitAnd()):
            yield "logic", with_(op=ast.BitOr())
        case ast.BoolOp(op=op):
            yield "logic", with_(op=ast.Or() if isinstance(op, ast.And) else ast.And())
        case ast.Compare(ops=[op, *others], left=left, comparators=[right, *_]):
            yield "comparison", with_(ops=[OPPOSITE[type(op)](), *others])
            if not others and type(op) in LIMIT and (is_whole(left) or is_whole(right)):
                yield "limit", with_(ops=[LIMIT[type(op)]()])
        case ast.UnaryOp(op=ast.Not() | ast.USub(), operand=operand) if not isinstance(operand, ast.Constant):
            yield "sign", operand
        case ast.Call(func=ast.Name(id=name)) if name in EXTREMES:
            yield "extreme", with_(func=ast.Name(EXTREMES[name]))
        case ast.Call(func=ast.Attribute(value=owner, attr=name)) if name in EXTREMES:
            yield "extreme", with_(func=ast.Attribute(owner, EXTREMES[name]))
    if isinstance(node, ast.BinOp) and type(node.op) in SWAPPED:
        for name in ("left", "right"):
            match getattr(node, name):
                case ast.Constant(value=float(value)) if value not in (0.0, 1.0):
                    yield "coefficient", with_(**{name: ast.Constant(1.1 * value)})


def is_whole(node: ast.expr) -> bool:
    """Whether it is a whole number or a length, where the limit itself occurs."""
    match node:
        case ast.Constant(value=int(value) | float(value)):
            return not isinstance(value, bool) and (isinstance(value, int) or value == 0)
        case ast.Call(func=ast.Name(id="len")) | ast.Attribute(attr="size" | "ndim"):
            return True
    return False


def of_text(node: ast.BinOp) -> bool:
    """Whether it puts texts or lists together, which no other operator does."""
    kinds = (ast.JoinedStr, ast.List, ast.Tuple, ast.ListComp)
    sides = (node.left, node.right)
    return any(isinstance(side, kinds) or isinstance(getattr(side, "value", None), str) for side in sides)


def tested(mutant: Mutant, root: Path) -> Outcome:
    """The outcome of a mutant in a copy of the tree."""
    file = root / mutant.module
    original = file.read_bytes()
    file.write_bytes(mutant.source(original))
    try:
        return Outcome(mutant, *run(tests_of(root, mutant.module), root))
    finally:
        file.write_bytes(original)


def run(tests: Sequence[str], root: Path) -> tuple[str, float, str]:
    """Run tests of a copy of the tree until one fails: outcome, seconds, and the test."""
    limits = ("timeout", "--kill-after=10", DEAF, "bash", "-c", LIMITED, "limited")
    pytest = (sys.executable, "-B", "-m", "pytest", "-q", "-x", "-rfE", "-p", "no:cacheprovider", *tests)
    # Byte code is neither written nor read: that of a mutant could be as old and as long as another's.
    own = {"PYTHONPATH": str(root), "CI": "true", "OMP_NUM_THREADS": "1", CACHE: str(root.parent / "formulas")}
    start = time.monotonic()
    done = subprocess.run(
        [*limits, *pytest], cwd=root, env=os.environ | own, stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", check=False,
    )  # fmt: skip
    seconds = time.monotonic() - start
    if done.returncode == 0 or done.returncode in TIMED_OUT:
        return "timeout" if done.returncode else "survived", seconds, ""
    lines = done.stdout.strip().splitlines() or [""]
    failed = [line.partition(" - ")[0] for line in lines if line.startswith(("FAILED tests/", "ERROR tests/"))]
    if done.returncode == 1 and failed:
        return "killed", seconds, failed[0].partition(" ")[2]
    return "error", seconds, f"status {done.returncode}: {(failed or lines)[-1]:.200}"


def tests_of(root: Path, module: str) -> list[str]:
    """The files with tests of a module's folder, those first that have its name or name it most often.

    `tests` mirrors the folders of both packages; a folder without tests of its own has them one folder up.
    """
    path = Path(module)
    folder = path.parent if path.parts[0] == "analytic" else path.parent.relative_to("fembearing")
    while not (files := sorted((root / "tests" / folder).glob("test_*.py"))):
        folder = folder.parent
    dotted = ".".join(path.with_suffix("").parts)
    files.sort(key=lambda file: (not file.stem.startswith(f"test_{path.stem}"), -file.read_text().count(dotted)))
    return [file.relative_to(root).as_posix() for file in files]


def outcomes(chosen: Sequence[Mutant], *, jobs: int) -> Generator[Outcome]:
    """The outcome of each mutant; at last, as an error, the tests that also fail without one."""
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        trees: SimpleQueue[Path] = SimpleQueue()
        for number in range(jobs):
            trees.put(shutil.copytree(ROOT, Path(folder) / str(number), ignore=LEFT_OUT, symlinks=True))

        def test(mutant: Mutant) -> Outcome:
            tree = trees.get()
            try:
                return tested(mutant, tree)
            finally:
                trees.put(tree)

        failed = set()
        for outcome in pool.map(test, chosen):
            failed |= {outcome.test} if outcome.outcome == "killed" else set()
            yield outcome
        if failed:
            found, seconds, test_ = run(sorted(failed), trees.get())
            if found != "survived":
                yield Outcome(Mutant("none", 0, "", "", "", (0, 0)), "error", seconds, test_)
