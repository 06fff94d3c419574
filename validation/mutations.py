"""Do the tests detect a wrong formula? python validation/mutations.py [--count 60] [--seed 0] [--jobs 1]

Works on a copy of the tree. Each mutation changes one place in one core formula: a sign (+ to -), a factor (* to /, or
a number by a tenth) or an exponent (by one). The tests of that module then run. If they pass, the mutation was missed
and its line is printed: either a test is missing, or the change does not matter there (a starting value, a tolerance,
a bound). The seed determines the places. Exit status: 0 all mutations detected, 1 some missed.
"""

import ast
import os
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from copy import deepcopy
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Annotated

import numpy as np
import typer

ROOT = Path(__file__).parents[1]
MODULES = (  # files with the core formulas
    *("analytic/contact/hertz.py", "analytic/contact/hertz_fitted.py", "analytic/contact/subsurface.py"),
    *(
        "analytic/loads/thrust.py",
        "analytic/loads/ring.py",
        "analytic/loads/inertia.py",
        "analytic/loads/kinematics.py",
    ),
    *("analytic/surface/moments.py", "analytic/surface/roughness.py", "analytic/surface/asperity.py"),
    *("analytic/oil/film.py", "analytic/oil/viscosity.py", "analytic/oil/rolling.py", "analytic/oil/traction.py"),
    *("analytic/sliding/long_ellipse.py", "fembearing/compare/torque/catalogue_models.py"),
)
TENTH = 1.1
LONGEST = 600.0  # s, time limit of the tests of one mutation; tests that do not end have detected it
SWAPPED = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult}
KINDS = {ast.Add: "sign", ast.Sub: "sign", ast.Mult: "factor", ast.Div: "factor"}


@dataclass(frozen=True)
class Mutation:
    """One change of one node of the syntax tree."""

    module: str  # one of MODULES
    place: int  # number of the node in the order of `ast.walk`
    kind: str
    line: int
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.module}:{self.line}: {self.kind}: {self.before} -> {self.after}"


def main(
    count: Annotated[int, typer.Option(help="Number of mutations.")] = 60,
    seed: Annotated[int, typer.Option(help="Seed of the random places.")] = 0,
    jobs: Annotated[int, typer.Option(help="Mutations tested at the same time.")] = 1,
) -> None:
    rng = np.random.default_rng(seed)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        base = Path(folder) / "base"  # the tree as it is now; it may be edited during the run
        for part in ("analytic", "fembearing", "tests", "validation", "meshes"):
            shutil.copytree(ROOT / part, base / part, ignore=shutil.ignore_patterns("__pycache__"), symlinks=True)
        shutil.copy(ROOT / "pyproject.toml", base)
        by_module = [mutations(base, module) for module in MODULES]
        drawn = []
        for number in range(count):  # the same number in each module
            of_module = by_module[number % len(by_module)]
            drawn.append(of_module.pop(int(rng.integers(len(of_module)))))
        outcomes = pool.map(partial(is_detected, base=base), range(count), drawn)
        detected: Counter[str] = Counter()
        for mutation, was_detected in zip(drawn, outcomes, strict=True):
            detected[mutation.kind] += was_detected
            if not was_detected:
                typer.echo(f"missed: {mutation}")
    total = Counter(mutation.kind for mutation in drawn)
    counts = ", ".join(f"{kind}: {detected[kind]} of {total[kind]} detected" for kind in sorted(total))
    typer.echo(f"{counts}; seed {seed}")
    raise typer.Exit(0 if detected == total else 1)


def tests_of(module: str) -> str:
    """The file with the tests of a module: `tests` mirrors the folders of both packages."""
    path = Path(module)
    folder = path.parent if path.parts[0] == "analytic" else path.parent.relative_to("fembearing")
    return (Path("tests") / folder / f"test_{path.name}").as_posix()


def mutations(root: Path, module: str) -> list[Mutation]:
    """All changes to formulas in the functions of a module. Error messages are left alone."""
    tree = ast.parse((root / module).read_text("utf-8"))
    in_message = {
        id(node) for part in ast.walk(tree) if isinstance(part, ast.Raise | ast.JoinedStr) for node in ast.walk(part)
    }
    inside = {id(node) for part in ast.walk(tree) if isinstance(part, ast.FunctionDef) for node in ast.walk(part)}
    result = []
    for place, node in enumerate(ast.walk(tree)):
        if id(node) in in_message or id(node) not in inside:
            continue
        after = changed(node)
        if after is not None:
            kind = "exponent" if is_power(node) else KINDS[type(node.op)] if isinstance(node, ast.BinOp) else "factor"
            words = [ast.unparse(part) for part in (node, after)]
            result.append(Mutation(module, place, kind, node.lineno, *words))  # pyright: ignore[reportAttributeAccessIssue]
    return result


def is_power(node: ast.AST) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow)


def changed(node: ast.AST) -> ast.expr | None:
    """The node that replaces this one; None if this one is left alone."""
    match node:
        case ast.BinOp(op=ast.Pow(), right=power):
            other = deepcopy(node)
            other.right = ast.BinOp(left=power, op=ast.Add(), right=ast.Constant(1))
            return other
        case ast.BinOp(op=op) if type(op) in SWAPPED:
            other = deepcopy(node)
            other.op = SWAPPED[type(op)]()
            return other
        case ast.Constant(value=float(value)) if value not in (0.0, 1.0):
            return ast.Constant(TENTH * value)
    return None


class Replacement(ast.NodeTransformer):
    """Replaces one node of a tree by another."""

    def __init__(self, target: ast.AST, other: ast.AST) -> None:
        self.target, self.other = target, other

    def visit(self, node: ast.AST) -> ast.AST:
        return self.other if node is self.target else self.generic_visit(node)


def is_detected(number: int, mutation: Mutation, *, base: Path) -> bool:
    """Whether the tests of the module fail."""
    copy = base.parent / str(number)
    shutil.copytree(base, copy, symlinks=True)
    file = copy / mutation.module
    tree = ast.parse(file.read_text("utf-8"))
    target = list(ast.walk(tree))[mutation.place]
    other = changed(target)
    assert other is not None
    file.write_text(ast.unparse(ast.fix_missing_locations(Replacement(target, other).visit(tree))), "utf-8")
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider"]
    try:
        done = subprocess.run(
            [*command, tests_of(mutation.module)],
            cwd=copy,
            env=os.environ | {"PYTHONPATH": str(copy), "CI": "true"},
            capture_output=True,
            timeout=LONGEST,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return True
    finally:
        shutil.rmtree(copy)
    if done.returncode not in (0, 1, 2):  # 2: pytest fails before the first test, because the module cannot be imported
        raise RuntimeError(f"{mutation}: {done.stdout.decode()[-500:]}")
    return done.returncode > 0


if __name__ == "__main__":
    typer.run(main)
