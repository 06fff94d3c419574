"""Changes of one operator in the source of both packages.

A mutant is the source with one node of its syntax tree replaced: + and - swapped, * and / swapped, a power raised by
one, a comparison turned round, `<` and `<=` swapped beside a whole number, `and` and `or` swapped, `not` or a minus
taken away, min and max swapped, or a coefficient increased by a tenth. Messages, assertions and what runs only for type
checkers are left alone, and so are coefficients in modules that draw: where a label stands is a matter of taste.
"""

import ast
from collections.abc import Iterator
from copy import deepcopy
from dataclasses import dataclass
from pathlib import Path

import numpy as np

PACKAGES = ("analytic", "fembearing")
DRAWING = ("fembearing/report/figures", "fembearing/report/pictures")
TENTH = 1.1
ARITHMETIC = {ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.FloorDiv: ast.Mult}
OPPOSITE = {
    ast.Lt: ast.GtE,
    ast.GtE: ast.Lt,
    ast.Gt: ast.LtE,
    ast.LtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
}
LIMIT = {ast.Lt: ast.LtE, ast.LtE: ast.Lt, ast.Gt: ast.GtE, ast.GtE: ast.Gt}  # itself out of the range, or into it
LOGIC = {ast.And: ast.Or, ast.Or: ast.And}
EXTREMES = {"min": "max", "max": "min", "minimum": "maximum", "maximum": "minimum", "argmin": "argmax"}
EXTREMES |= {"argmax": "argmin"}


@dataclass(frozen=True)
class Mutant:
    """One change of one expression."""

    module: str  # path from the root
    kind: str
    line: int
    start: int  # first byte of the expression in the file
    end: int
    before: str
    after: str

    def __str__(self) -> str:
        return f"{self.module}:{self.line}: {self.kind}: {self.before} -> {self.after}"

    def source(self, original: bytes) -> bytes:
        return original[: self.start] + b"(" + self.after.encode() + b")" + original[self.end :]


def drawn(root: Path, count: int, seed: int) -> list[Mutant]:
    """Half of them from each package, at even distances in the row of all its mutants, in random order.

    A part of them is a fair sample too.
    """
    rng = np.random.default_rng(seed)
    chosen = []
    for package in PACKAGES:
        paths = sorted((root / package).rglob("*.py"))
        every = [mutant for path in paths for mutant in mutants(root, path.relative_to(root).as_posix())]
        places = ((np.arange(count // 2) + rng.random()) * len(every) / (count // 2)).astype(int)
        chosen += [every[place] for place in np.unique(places)]
    return [chosen[place] for place in rng.permutation(len(chosen))]


def mutants(root: Path, module: str) -> list[Mutant]:
    """All mutants of one module, in the order of their lines."""
    source = (root / module).read_bytes()
    lines = [0]
    for line in source.splitlines(keepends=True):
        lines.append(lines[-1] + len(line))
    coefficients = not module.startswith(DRAWING)
    found = [
        Mutant(
            module=module,
            kind=kind,
            line=node.lineno,
            start=lines[node.lineno - 1] + node.col_offset,
            end=lines[(node.end_lineno or 0) - 1] + (node.end_col_offset or 0),
            before=ast.unparse(node),
            after=ast.unparse(after),
        )
        for node in expressions(ast.parse(source))
        for kind, after in changes(node)
        if coefficients or kind != "coefficient"
    ]
    return sorted(found, key=lambda mutant: (mutant.line, mutant.start, mutant.after))


def expressions(node: ast.AST) -> Iterator[ast.expr]:
    """All expressions of a tree that decide or compute."""
    for name, child in ast.iter_fields(node):
        if name in ("annotation", "returns", "decorator_list", "format_spec", "type_params"):
            continue
        for each in child if isinstance(child, list) else [child]:
            if not isinstance(each, ast.AST) or isinstance(each, ast.Raise | ast.Assert | ast.JoinedStr):
                continue
            if isinstance(each, ast.If) and "TYPE_CHECKING" in ast.unparse(each.test):
                continue
            if isinstance(each, ast.expr):
                yield each
            yield from expressions(each)


def changes(node: ast.expr) -> Iterator[tuple[str, ast.expr]]:
    """What kind of change, and the node that replaces this one."""
    match node:
        case ast.BinOp(op=ast.Pow(), left=left, right=power):
            yield "power", ast.BinOp(left, ast.Pow(), ast.BinOp(power, ast.Add(), ast.Constant(1)))
        case ast.BinOp(op=op) if type(op) in ARITHMETIC and not of_text(node):
            yield "arithmetic", replaced(node, op=ARITHMETIC[type(op)]())
        case ast.Compare(ops=[op], left=left, comparators=[right]):
            yield "comparison", replaced(node, ops=[OPPOSITE[type(op)]()])
            if type(op) in LIMIT and (is_whole(left) or is_whole(right)):
                yield "limit", replaced(node, ops=[LIMIT[type(op)]()])
        case ast.Compare(ops=ops):  # a < b < c
            first = OPPOSITE[type(ops[0])]()
            yield "comparison", replaced(node, ops=[first, *ops[1:]])
        case ast.BinOp(op=ast.BitAnd()):
            yield "logic", replaced(node, op=ast.BitOr())
        case ast.BoolOp(op=op):
            yield "logic", replaced(node, op=LOGIC[type(op)]())
        case ast.UnaryOp(op=ast.Not() | ast.USub(), operand=operand) if not isinstance(operand, ast.Constant):
            yield "sign", operand
        case ast.Call(func=ast.Name(id=name)) if name in EXTREMES:
            yield "extreme", replaced(node, func=ast.Name(EXTREMES[name]))
        case ast.Call(func=ast.Attribute(value=owner, attr=name)) if name in EXTREMES:
            yield "extreme", replaced(node, func=ast.Attribute(owner, EXTREMES[name]))
    match node:
        case ast.BinOp(left=left, right=right, op=op) if type(op) in ARITHMETIC:
            for name, side in (("left", left), ("right", right)):
                if isinstance(side, ast.Constant) and isinstance(side.value, float) and side.value not in (0.0, 1.0):
                    yield "coefficient", replaced(node, **{name: ast.Constant(TENTH * side.value)})


def replaced(node: ast.expr, **fields: object) -> ast.expr:
    other = deepcopy(node)
    for name, value in fields.items():
        setattr(other, name, value)
    return other


def is_whole(node: ast.expr) -> bool:
    """Whether it is a whole number or a length, where the limit itself occurs."""
    match node:
        case ast.Constant(value=int(value)):
            return not isinstance(value, bool)
        case ast.Constant(value=float(value)):
            return value == 0.0
        case ast.Call(func=ast.Name(id="len")) | ast.Attribute(attr="size" | "ndim"):
            return True
    return False


def of_text(node: ast.BinOp) -> bool:
    """Whether it puts texts or lists together, which no other operator does."""
    kinds = (ast.JoinedStr, ast.List, ast.Tuple, ast.ListComp)
    return any(isinstance(side, kinds) or is_text(side) for side in (node.left, node.right))


def is_text(node: ast.expr) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)
