"""Would a wrong formula be seen? python validation/mutations.py [--count 60] [--seed 0] [--jobs 1]

Changes one place of one core formula at a time, in a copy: a sign (+ and -), a factor (* and /, or a number by a
tenth) or an exponent (by one), and runs the tests of that module on it. One that stays green is printed with its line:
either a test is missing, or the change does not matter there (a starting value, a tolerance, a bound). The places are
drawn with the seed. Exit status: 0 all seen, 1 some were not.
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
MODULES = (  # the core formulas; each has its tests in tests/analytic/test_<module>.py
    *("hertz", "hertz_fitted", "kinematics", "race", "film", "viscosity", "rolling", "bounds", "traction"),
    *("equilibrium", "summits", "roughness", "asperity", "subsurface", "catalogue_torque"),
)
TENTH = 1.1
LONGEST = 600.0  # s that tests may take: a change that keeps them from ending is seen too
SWAPPED = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult}
KINDS = {ast.Add: "sign", ast.Sub: "sign", ast.Mult: "factor", ast.Div: "factor"}


@dataclass(frozen=True)
class Mutation:
    """One change: the number of the node, in the order of `ast.walk`, and what becomes of it."""

    module: str
    place: int
    kind: str
    line: int
    before: str
    after: str

    def __str__(self) -> str:
        return f"analytic/{self.module}.py:{self.line}: {self.kind}: {self.before} -> {self.after}"


def main(
    count: Annotated[int, typer.Option(help="Changes to try.")] = 60,
    seed: Annotated[int, typer.Option(help="Of the draw.")] = 0,
    jobs: Annotated[int, typer.Option(help="At a time.")] = 1,
) -> None:
    rng = np.random.default_rng(seed)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(jobs) as pool:
        base = Path(folder) / "base"  # as it is now, whatever is edited meanwhile
        for part in ("analytic", "fembearing", "tests", "validation", "meshes"):
            shutil.copytree(ROOT / part, base / part, ignore=shutil.ignore_patterns("__pycache__"), symlinks=True)
        shutil.copy(ROOT / "pyproject.toml", base)
        by_module = [mutations(base, module) for module in MODULES]
        drawn = []
        for number in range(count):  # each module alike
            of_module = by_module[number % len(by_module)]
            drawn.append(of_module.pop(int(rng.integers(len(of_module)))))
        outcomes = pool.map(partial(is_seen, base=base), range(count), drawn)
        seen: Counter[str] = Counter()
        for mutation, was_seen in zip(drawn, outcomes, strict=True):
            seen[mutation.kind] += was_seen
            if not was_seen:
                typer.echo(f"not seen: {mutation}")
    total = Counter(mutation.kind for mutation in drawn)
    typer.echo(", ".join(f"{kind}: {seen[kind]} of {total[kind]} seen" for kind in sorted(total)) + f"; seed {seed}")
    raise typer.Exit(0 if seen == total else 1)


def mutations(root: Path, module: str) -> list[Mutation]:
    """All places of a module's functions where a formula can be changed; not those of messages."""
    tree = ast.parse((root / "analytic" / f"{module}.py").read_text("utf-8"))
    told = {
        id(node) for told in ast.walk(tree) if isinstance(told, ast.Raise | ast.JoinedStr) for node in ast.walk(told)
    }
    inside = {id(node) for part in ast.walk(tree) if isinstance(part, ast.FunctionDef) for node in ast.walk(part)}
    found = []
    for place, node in enumerate(ast.walk(tree)):
        if id(node) in told or id(node) not in inside:
            continue
        after = changed(node)
        if after is not None:
            kind = "exponent" if is_power(node) else KINDS[type(node.op)] if isinstance(node, ast.BinOp) else "factor"
            words = [ast.unparse(part) for part in (node, after)]
            found.append(Mutation(module, place, kind, node.lineno, *words))  # pyright: ignore[reportAttributeAccessIssue]
    return found


def is_power(node: ast.AST) -> bool:
    return isinstance(node, ast.BinOp) and isinstance(node.op, ast.Pow)


def changed(node: ast.AST) -> ast.expr | None:
    """What becomes of a node; None for one that is left alone."""
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


class At(ast.NodeTransformer):
    """Puts a changed node in place of one."""

    def __init__(self, target: ast.AST, other: ast.AST) -> None:
        self.target, self.other = target, other

    def visit(self, node: ast.AST) -> ast.AST:
        return self.other if node is self.target else self.generic_visit(node)


def is_seen(number: int, mutation: Mutation, *, base: Path) -> bool:
    """Whether the module's tests turn red."""
    copy = base.parent / str(number)
    shutil.copytree(base, copy, symlinks=True)
    file = copy / "analytic" / f"{mutation.module}.py"
    tree = ast.parse(file.read_text("utf-8"))
    target = list(ast.walk(tree))[mutation.place]
    other = changed(target)
    assert other is not None
    file.write_text(ast.unparse(ast.fix_missing_locations(At(target, other).visit(tree))), "utf-8")
    command = [sys.executable, "-m", "pytest", "-x", "-q", "-p", "no:cacheprovider"]
    try:
        done = subprocess.run(
            [*command, f"tests/analytic/test_{mutation.module}.py"],
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
    if done.returncode not in (0, 1, 2):  # 2: red before the first test, as the module does not even load
        raise RuntimeError(f"{mutation}: {done.stdout.decode()[-500:]}")
    return done.returncode > 0


if __name__ == "__main__":
    typer.run(main)
