"""What import-linter's contracts (pyproject.toml) cannot say: sizes, names, light imports, and the map of the tree."""

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import grimp

from analytic.numerics.machine_code import ABOVE, ENTRIES

ROOT = Path(__file__).resolve().parents[1]
OURS = ("analytic", "fembearing")
MOST_PARAMETERS = 7  # of a function; more of them belong together in a noun
LONGER = {  # functions that may have more
    "ring_equilibrium": "a public face: bearing, loads and speeds as a user has them, each with its own shape",
    "advance": "a compiled kernel: numba takes arrays and numbers, no nouns",
    **dict.fromkeys(
        ("settle_freely", "_one_pass", "_loads", "_step_free_ball", "slips_of"),
        "part of a compiled kernel: records and arrays that one point works with",
    ),
    **dict.fromkeys(("solve_contact", "solve_load_series"), "a public face: a contact and how it is solved"),
    **dict.fromkeys(("validate", "check_scene"), "the main job and its command: what it computes, by name"),
    **dict.fromkeys(("compare", "contact", "film", "creep", "torque"), "a command: its options, each by its name"),
}
HEAVY = {"vtk", "vtkmodules", "pyvista", "skfem", "pint", "pydantic", "pymklpardiso", "numba", "xarray", "netCDF4"}
ROOM = re.compile(r"`((?:analytic|fembearing)/[\w./]*)`")  # in the list of docs/architecture.md
MOST_LINES = 60  # of a function, without its docstring, comments and blank lines


def parameters_of(function: ast.FunctionDef | ast.AsyncFunctionDef) -> int:
    given = function.args
    return len([*given.posonlyargs, *given.args, *given.kwonlyargs, *filter(None, (given.vararg, given.kwarg))])


def lines_of_code(function: ast.FunctionDef | ast.AsyncFunctionDef, lines: list[str]) -> int:
    """The lines from the definition on that hold code; a docstring holds none."""
    documented = ast.get_docstring(function) is not None
    docstring = function.body[0] if documented else None
    prose = set(range(docstring.lineno, (docstring.end_lineno or 0) + 1)) if docstring else set()
    own = range(function.lineno, (function.end_lineno or function.lineno) + 1)
    return sum(bool(text := lines[n - 1].strip()) and text[0] != "#" for n in own if n not in prose)


def code_complaints(root: Path) -> Iterator[str]:
    longer = set()
    for path in (path for top in OURS for path in sorted((root / top).rglob("*.py"))):
        text, file = path.read_text("utf-8"), path.relative_to(root).as_posix()
        module = path.parent.name if path.name == "__init__.py" else path.stem
        tree, lines = ast.parse(text), text.splitlines()
        for node in tree.body:
            named = isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef) and node.name == module
            if named and path.parent.name != "cli":  # there a file is named after its command
                yield f"{file}:{node.lineno}: function {module} has its module's name"
        for node in ast.walk(tree):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                count, length = parameters_of(node), lines_of_code(node, lines)
                if count > MOST_PARAMETERS:
                    longer.add(node.name)
                    if node.name not in LONGER:
                        yield f"{file}:{node.lineno}: {node.name} has {count} parameters, more than {MOST_PARAMETERS}"
                if length > MOST_LINES:
                    yield f"{file}:{node.lineno}: {node.name} has {length} lines of code, more than {MOST_LINES}"
            if isinstance(node, ast.ImportFrom):
                private = [alias.name for alias in node.names if re.match(r"_(?!_)", alias.name)]
                yield from (f"{file}:{node.lineno}: {name} is private to its module" for name in private)
            called = getattr(node, "func", None)
            name = getattr(called, "attr", getattr(called, "id", ""))
            if isinstance(node, ast.Call) and name in ("import_module", "__import__") and path.name != "__init__.py":
                yield f"{file}:{node.lineno}: the contracts do not see an import by a computed name"
    yield from (f"{name} need not be in LONGER" for name in LONGER.keys() - longer)


def map_complaints(root: Path) -> Iterator[str]:
    """The list of docs/architecture.md against the tree; a folder is one with Python files in it."""
    page = (root / "docs/architecture.md").read_text("utf-8")
    rows = set(ROOM.findall(page.partition("\n## The rooms\n")[2].partition("\n## ")[0]))
    code = [path for top in OURS for path in (root / top).rglob("*.py")]
    tree = {f"{path.parent.relative_to(root).as_posix()}/" for path in code}
    tree |= {f"{path.parent.name}/{path.name}" for path in code if path.parent.parent == root and path.stem[0] != "_"}
    yield from (f"docs/architecture.md has no row for {name}" for name in sorted(tree - rows))
    yield from (
        f"docs/architecture.md names {name}, which does not exist" for name in rows if not (root / name).exists()
    )


def test_the_project_keeps_its_rules() -> None:
    assert [*code_complaints(ROOT), *map_complaints(ROOT)] == []


def test_no_compiled_function_imports_a_folder_that_its_digest_leaves_out() -> None:
    graph = grimp.build_graph("analytic", cache_dir=None)
    files = {path: path.read_text("utf-8") for path in sorted(ROOT.glob("analytic/**/*.py"))}
    compiled = [path for path, text in files.items() if "\n@compiled" in text or "\n@entry" in text]
    assert sum(text.count("\n@entry(") for text in files.values()) == len(ENTRIES)  # a wheel has them all
    names = [".".join(path.relative_to(ROOT).with_suffix("").parts) for path in compiled]
    imported = {name for module in names for name in (module, *graph.find_upstream_modules(module))}
    assert len(compiled) > 30  # else the search looks for the wrong word
    assert {name for name in imported if name.partition(".")[2].partition(".")[0] in ABOVE} == set()


def test_importing_the_production_model_is_light() -> None:
    show = "import sys, analytic; print(*{name.partition('.')[0] for name in sys.modules})"
    loaded = subprocess.run([sys.executable, "-c", show], cwd=ROOT, capture_output=True, check=True, text=True).stdout
    assert "analytic" in loaded.split()
    assert not HEAVY & set(loaded.split())
