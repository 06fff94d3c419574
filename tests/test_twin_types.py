"""Types that declare the same thing twice: pairs of classes of four fields or more that share 70 % of their names.

python -m tests.twin_types
"""

import ast
from collections.abc import Iterator
from itertools import combinations
from pathlib import Path

FEWEST, SHARED, LEFT = 4, 0.7, 3  # fields; share of the names of both together; pairs that are to go
ROOT = Path(__file__).parents[1]


def fields_of(package: str) -> Iterator[tuple[str, frozenset[str]]]:
    """Each class of a package with the names of its own annotated fields; keywords of a function declare no type."""
    for file in sorted((ROOT / package).rglob("*.py")):
        for node in ast.walk(ast.parse(file.read_text("utf-8"))):
            if isinstance(node, ast.ClassDef) and "TypedDict" not in map(ast.unparse, node.bases):
                names = {
                    part.target.id
                    for part in node.body
                    if isinstance(part, ast.AnnAssign) and isinstance(part.target, ast.Name)
                }
                yield f"{file.relative_to(ROOT)}:{node.name}", frozenset(names)


def twins() -> list[tuple[str, str]]:
    """The pairs, in the order of their files."""
    classes = [each for package in ("analytic", "fembearing") for each in fields_of(package) if len(each[1]) >= FEWEST]
    return [(a, b) for (a, one), (b, two) in combinations(classes, 2) if len(one & two) >= SHARED * len(one | two)]


def test_no_new_types_declare_the_same() -> None:
    """Those that are left: factors beside the quantities that they are of, and one operating point beside a series."""
    assert len(twins()) <= LEFT
