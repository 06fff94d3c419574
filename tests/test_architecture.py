"""The design on one screen: who may import what, and the few rules that keep files readable.

The rules are functions of a source tree, so that the second half of this file can feed them small trees that break
each rule and see them complain.
"""

import ast
import re
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
OURS = ("analytic", "fembearing")
NOUNS = ("analytic.scene", "analytic.errors")  # all of `analytic` that the check may know

# row -> what of ours it may import besides itself. A module belongs to the row with the longest name that fits it.
# Every package, and every module directly in fembearing, needs a row of its own.
MAY_IMPORT = {
    "analytic": (*NOUNS, "analytic.catalog"),  # the formulas, and `__init__`
    "analytic.catalog": (),
    "analytic.errors": (),
    "analytic.scene": (),
    "analytic.scenefile.fit": NOUNS,  # does a bearing fit together
    "analytic.scenefile.quantity": (),  # units: with `tables` and `scenefile` the one place that knows them
    "analytic.scenefile.tables": (*NOUNS, "analytic.catalog", "analytic.scenefile.quantity"),
    "analytic.scenefile.text": NOUNS,
    "analytic.scenefile.keys": (
        *NOUNS,
        "analytic.catalog",
        "analytic.scenefile.text",
        "analytic.scenefile.quantity",
        "analytic.scenefile.tables",
    ),
    "analytic.scenefile.read": (
        *NOUNS,
        "analytic.catalog",
        "analytic.scenefile.fit",
        "analytic.scenefile.quantity",
        "analytic.scenefile.text",
        "analytic.scenefile.tables",
    ),
    "fembearing": (
        "analytic",
        "fembearing.mesh",
        "fembearing.fem",
        "fembearing.compare",
        "fembearing.report",
        "fembearing.sweep",
    ),
    "fembearing.mesh": NOUNS,
    "fembearing.fem": (*NOUNS, "fembearing.mesh"),
    "fembearing.compare": ("analytic", "fembearing.mesh", "fembearing.fem"),
    "fembearing.report": ("analytic", "fembearing.compare", "fembearing.report.page.sections"),
    "fembearing.report.page.sections": ("analytic", "fembearing.compare", "fembearing.report"),
    "fembearing.report.pictures.render": (  # a process of its own, fed by JSON and .vtu files
        "fembearing.report.pictures.render_cage",
        "fembearing.report.pictures.render_mesh",
        "fembearing.report.pictures.render_view",
    ),
    "fembearing.report.pictures.render_cage": (),
    "fembearing.report.pictures.render_mesh": (),
    "fembearing.report.pictures.render_view": ("fembearing.report.pictures.render_mesh",),
    "fembearing.sweep": ("analytic", "fembearing.compare"),
    "fembearing.cli.console": ("analytic",),  # what the commands write
    "fembearing.cli.options": ("analytic",),  # of the commands
    "fembearing.cli.sweep": (
        "fembearing.cli.console",
        "fembearing.cli.options",
        "fembearing.sweep",
        "fembearing.report",
    ),
    "fembearing.cli.report": ("fembearing.cli.console", "fembearing.cli.options", "fembearing.report"),
    "fembearing.cli": OURS,
}
# What a package's `__init__` may import besides, but only on demand, so that importing the package stays light.
ON_DEMAND = {"analytic": ("analytic.scenefile.read",)}
# Each heavy dependency has a home.
ONLY_IN = {
    "pint": ("analytic.scenefile.quantity",),
    "pydantic_core": ("analytic.scenefile.quantity",),
    "pydantic": (
        "analytic.scenefile.tables",
        "analytic.scenefile.read",
        "analytic.scenefile.keys",
        "fembearing.report",
    ),
    "meshio": ("fembearing.mesh",),
    "skfem": ("fembearing.mesh", "fembearing.fem"),
    "pypardiso": ("fembearing.fem",),
    "pyvista": tuple(f"fembearing.report.pictures.render{part}" for part in ("", "_cage", "_mesh", "_view")),
    "matplotlib": ("fembearing.report",),
    "jinja2": ("fembearing.report",),
    "xarray": ("analytic", "fembearing.compare", "fembearing.sweep"),  # on demand, see HEAVY
    "distributed": ("fembearing.sweep",),
    "vtk": ("fembearing.report.pictures.render",),
}
LONGEST_FILE = 400  # lines; what outgrows it is two things
HEAVY = {
    "vtk",
    "vtkmodules",
    "pyvista",
    "skfem",
    "pint",
    "pydantic",
    "pypardiso",
    "numba",
    "xarray",
    "netCDF4",
}  # `import analytic` loads none
REGISTRY = re.compile(
    r"\b(?:(?:pypi|pythonhosted|npmjs|yarnpkg|anaconda|crates|rubygems)\.(?:org|com|io)|proxy\.golang)"
)
LOCK_FILE = re.compile(r"(?:^|[-.])lock(?:b|\.json|\.ya?ml)?$|^pylock\.")


def within(module: str, package: str) -> bool:
    return module == package or module.startswith(package + ".")


def row_of(module: str) -> str:
    return max((row for row in MAY_IMPORT if within(module, row)), key=len, default="")


def is_private(name: str) -> bool:
    return name.startswith("_") and not name.startswith("__")


@dataclass(frozen=True)
class Import:
    line: int
    module: str  # empty if the name is computed
    name: str  # what is taken out of the module, if that is no module itself
    spelling: str  # how the importing file calls it
    eager: bool  # runs when the importing file is loaded


class Module:
    """One file of a tree: its name, its syntax, what it imports."""

    def __init__(self, path: Path, root: Path) -> None:
        self.root, self.file = root, path.relative_to(root).as_posix()
        parts = path.relative_to(root).with_suffix("").parts
        self.is_package = parts[-1] == "__init__"
        self.name = ".".join(parts[:-1] if self.is_package else parts)
        self.package = self.name if self.is_package else self.name.rpartition(".")[0]
        self.text = path.read_text("utf-8")
        self.tree = ast.parse(self.text)
        self.imports = list(self._imports(self.tree, eager=True))

    def _imports(self, node: ast.AST, *, eager: bool) -> Iterator[Import]:
        match node:
            case ast.Import():
                for alias in node.names:
                    yield Import(node.lineno, alias.name, "", alias.asname or alias.name, eager)
                    top = alias.name.partition(".")[0]
                    if top in OURS and alias.name != top and not alias.asname:  # binds the top package, all its names
                        yield Import(node.lineno, top, "", top, eager)
            case ast.ImportFrom():
                source = self._source(node)
                for alias in node.names:
                    whole = f"{source}.{alias.name}"
                    target = (whole, "") if self._is_module(whole) else (source, alias.name)
                    if whole == "importlib.import_module" and alias.asname:  # by another name it would go unseen below
                        target = ("", "")
                    yield Import(node.lineno, *target, alias.asname or alias.name, eager)
            case ast.Call() if ast.unparse(node.func).rpartition(".")[2] in ("import_module", "__import__"):
                literal = node.args[0].value if node.args and isinstance(node.args[0], ast.Constant) else ""
                yield Import(node.lineno, str(literal), "", "", eager)
            case ast.FunctionDef() | ast.AsyncFunctionDef() | ast.Lambda():
                eager = False
            case ast.If() if "TYPE_CHECKING" in ast.unparse(node.test):
                eager = False
        for child in ast.iter_child_nodes(node):
            yield from self._imports(child, eager=eager)

    def _source(self, node: ast.ImportFrom) -> str:
        if not node.level:
            return node.module or ""
        base = self.package.split(".")
        return ".".join([*base[: len(base) - node.level + 1], *([node.module] if node.module else [])])

    def _is_module(self, name: str) -> bool:
        place = self.root.joinpath(*name.split("."))
        return place.is_dir() or place.with_suffix(".py").is_file()


def modules(root: Path) -> list[Module]:
    return [Module(path, root) for top in OURS for path in sorted((root / top).rglob("*.py"))]


def import_complaints(module: Module) -> Iterator[str]:
    if module.package not in MAY_IMPORT or (module.package == "fembearing" and module.name not in MAY_IMPORT):
        yield f"{module.file}: {module.name} has no row in MAY_IMPORT; say there what it may import"
        return
    row = row_of(module.name)
    for found in module.imports:
        where, target = f"{module.file}:{found.line}:", found.module
        if not target:
            if not module.is_package:  # an `__init__` may load its own parts by name
                yield f"{where} an import by a computed name cannot be checked"
        elif not within(target, "analytic") and not within(target, "fembearing"):
            homes = ONLY_IN.get(target.partition(".")[0], (module.name,))
            if not any(within(module.name, home) for home in homes):
                yield f"{where} {target} belongs to {' and '.join(homes)}"
        elif target in ON_DEMAND.get(module.name, ()):
            if found.eager:
                yield f"{where} {target} must be imported on demand, inside a function"
        elif row_of(target) != row and not any(within(target, allowed) for allowed in MAY_IMPORT[row]):
            yield f"{where} {row} may not import {target}"
        elif is_private(found.name) or any(map(is_private, target.split("."))):
            yield f"{where} {target}.{found.name} is private"
    spellings = {found.spelling for found in module.imports if within(found.module, row) or row_of(found.module)}
    for node in ast.walk(module.tree):
        if isinstance(node, ast.Attribute) and is_private(node.attr) and ast.unparse(node.value) in spellings:
            yield f"{module.file}:{node.lineno}: {ast.unparse(node)} is private"


def shape_complaints(module: Module) -> Iterator[str]:
    lines = len(module.text.splitlines())
    if lines > LONGEST_FILE:
        yield f"{module.file}: {lines} lines, more than {LONGEST_FILE}; it is two things"
    for node in module.tree.body:
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and node.name == module.name.rpartition(".")[2]:
            yield f"{module.file}:{node.lineno}: function {node.name} bears its module's name"


def cycle_complaints(found: list[Module]) -> Iterator[str]:
    graph = {module.name: {i.module for i in module.imports if i.eager} - {module.name} for module in found}
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as problem:
        yield f"imports run in a circle: {' <- '.join(problem.args[1])}"


def complaints(root: Path) -> list[str]:
    found = modules(root)
    each = [text for module in found for rule in (import_complaints, shape_complaints) for text in rule(module)]
    return list(dict.fromkeys([*each, *cycle_complaints(found)]))  # once a line, however many names it imports


def files_of_the_project(root: Path) -> list[Path]:
    """What git tracks or would add; without git, the whole tree but for hidden and made folders."""
    listing = ["git", "-C", str(root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"]
    try:
        listed = subprocess.run(listing, capture_output=True, check=True, text=True).stdout.split("\0")
        paths = [root / name for name in listed if name]
    except (OSError, subprocess.CalledProcessError):
        made = re.compile(r"\.(?!ci\b|github\b).*|__pycache__|build|dist")
        paths = [p for p in root.rglob("*") if not any(made.fullmatch(part) for part in p.relative_to(root).parts[:-1])]
    return sorted(path for path in paths if path.is_file())


def address_complaints(root: Path) -> Iterator[str]:
    for path in files_of_the_project(root):
        if LOCK_FILE.search(path.name):
            yield f"{path.relative_to(root)}: a lock file; exact versions live in constraints.txt"
        for number, line in enumerate(path.read_text("utf-8", errors="ignore").splitlines(), start=1):
            if REGISTRY.search(line):
                yield f"{path.relative_to(root)}:{number}: names a package registry"


def test_the_packages_keep_to_the_design() -> None:
    assert len(modules(ROOT)) > 1  # else the walk looks in the wrong place and every rule holds
    assert complaints(ROOT) == []


def test_every_row_of_the_table_fits_the_design() -> None:
    named = {name for row in MAY_IMPORT.values() for name in row} | {n for row in ONLY_IN.values() for n in row}
    assert named <= set(MAY_IMPORT)  # a misspelt name would permit or forbid nothing


def test_no_file_names_a_registry_or_locks_versions() -> None:
    assert list(address_complaints(ROOT)) == []


def test_importing_the_production_model_is_light() -> None:
    show = "import sys, analytic; print(*{name.partition('.')[0] for name in sys.modules})"
    loaded = subprocess.run([sys.executable, "-c", show], cwd=ROOT, capture_output=True, check=True, text=True).stdout
    assert "analytic" in loaded.split()
    assert not HEAVY & set(loaded.split())


# Negative controls: each rule is shown a sound tree with one file that breaks it.

SOUND = {
    "analytic/__init__.py": "from .hertz import contact\ndef load():\n    from analytic.scenefile.read import read\n",
    "analytic/errors.py": "",
    "analytic/scene.py": "import numpy as np\n",
    "analytic/scenefile/quantity.py": "import pint\n",
    "analytic/scenefile/read.py": "import pydantic\nfrom analytic.scene import Scene\ndef read(): ...\n",
    "analytic/contact/hertz.py": "from . import errors\nfrom .scene import Scene\ndef contact(): ...\ndef _half(): ...\n",
    "fembearing/__init__.py": "from fembearing.compare import verdict\n",
    "fembearing/mesh/__init__.py": "import meshio\nfrom analytic.scene import Groove\n",
    "fembearing/fem/__init__.py": "",
    "fembearing/fem/contact.py": "from ..mesh import Patch\nfrom analytic import errors, scene\n",
    "fembearing/compare/__init__.py": "from analytic import hertz\nfrom ..fem import contact\n",
    "fembearing/report/__init__.py": "from fembearing.compare import verdict\n",
    "fembearing/report/pictures/render.py": "import pyvista\n",
    "fembearing/cli/__init__.py": "import fembearing\nfrom analytic.scenefile.read import read\nfrom fembearing.report import page\n",
}
NEXT_DOOR = ("pypi", "org")  # joined below: this file, too, names no registry


def grow(root: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text, "utf-8")
    return root


def test_a_sound_tree_passes(tmp_path: Path) -> None:
    assert complaints(grow(tmp_path, SOUND)) == []


@pytest.mark.parametrize(
    ("file", "text", "complaint"),
    [
        ("analytic/oil/film.py", "import fembearing", "analytic may not import fembearing"),
        (
            "analytic/oil/film.py",
            "def f():\n    from fembearing.fem import x",
            "analytic may not import fembearing.fem",
        ),
        ("analytic/oil/film.py", "from .scenefile import read", "analytic may not import analytic.scenefile.read"),
        ("analytic/oil/film.py", "from . import scenefile", "analytic may not import analytic.scenefile.read"),
        ("analytic/__init__.py", "from .scenefile import read", "must be imported on demand"),
        ("analytic/scene.py", "from . import errors", "analytic.scene may not import analytic.errors"),
        ("analytic/errors.py", "from .scene import Scene", "analytic.errors may not import analytic.scene"),
        (
            "analytic/scenefile/read.py",
            "from analytic.contact.hertz import x",
            "analytic.scenefile.read may not import analytic.contact.hertz",
        ),
        ("analytic/oil/film.py", "import pint.errors", "pint.errors belongs to analytic.scenefile.quantity"),
        ("analytic/oil/film.py", "def f():\n    import pydantic", "pydantic belongs to analytic.scenefile.tables"),
        (
            "analytic/oil/film.py",
            "from .quantity import Dimension",
            "analytic may not import analytic.scenefile.quantity",
        ),
        ("fembearing/mesh/patch.py", "from ..fem import contact", "mesh may not import fembearing.fem.contact"),
        ("fembearing/mesh/patch.py", "from analytic import hertz", "mesh may not import analytic.contact.hertz"),
        ("fembearing/fem/contact.py", "from analytic import hertz", "fem may not import analytic.contact.hertz"),
        ("fembearing/fem/contact.py", "from analytic import contact", "fembearing.fem may not import analytic"),
        ("fembearing/fem/contact.py", "import analytic.scene", "fembearing.fem may not import analytic"),
        ("fembearing/fem/contact.py", "import meshio as m", "meshio belongs to fembearing.mesh"),
        (
            "fembearing/fem/contact.py",
            "import importlib\nimportlib.import_module('analytic.contact.hertz')",
            "analytic.contact.hertz",
        ),
        ("fembearing/fem/contact.py", "from importlib import import_module as m", "computed name"),
        ("fembearing/fem/contact.py", "import importlib\nimportlib.import_module('a' + 'b')", "computed name"),
        ("fembearing/compare/case.py", "import pyvista", "pyvista belongs to fembearing.report.pictures.render"),
        ("fembearing/compare/case.py", "from ..report import page", "compare may not import fembearing.report"),
        (
            "fembearing/report/page/html.py",
            "from fembearing.fem import contact",
            "report may not import fembearing.fem",
        ),
        ("fembearing/report/page/html.py", "from .. import cli", "fembearing.report may not import fembearing.cli"),
        ("fembearing/__init__.py", "from .cli import main", "fembearing may not import fembearing.cli"),
        ("fembearing/sweep.py", "from fembearing.cli import main", "fembearing.sweep may not import fembearing.cli"),
        ("fembearing/helpers.py", "", "fembearing.helpers has no row"),
        ("fembearing/fem/inner/__init__.py", "", "fembearing.fem.inner has no row"),
        ("analytic/extra/part.py", "", "analytic.extra.part has no row"),
        ("analytic/oil/film.py", "from .hertz import _half", "analytic.contact.hertz._half is private"),
        ("analytic/oil/film.py", "from . import hertz as h\nh._half()", "h._half is private"),
        ("analytic/oil/film.py", "def film(): ...", "function film bears its module's name"),
        ("fembearing/mesh/__init__.py", "def mesh(): ...", "function mesh bears its module's name"),
        ("analytic/oil/film.py", "\n" * 401, "401 lines"),
        ("analytic/contact/hertz.py", "from . import hertz\nfrom analytic import contact", "in a circle"),
    ],
)
def test_a_tree_that_breaks_a_rule_is_refused(tmp_path: Path, file: str, text: str, complaint: str) -> None:
    found = complaints(grow(tmp_path, SOUND | {file: text}))
    assert any(complaint in line for line in found), found


@pytest.mark.parametrize("with_git", [True, False])
def test_a_registry_address_or_a_lock_file_is_refused(tmp_path: Path, with_git: bool) -> None:
    grow(tmp_path, {"notes/a.md": f"see https://{'.'.join(NEXT_DOOR)}/simple", "b.md": "nothing here", "uv.lock": ""})
    if with_git:
        subprocess.run(["git", "init", "-q", str(tmp_path)], check=True)
    found = list(address_complaints(tmp_path))
    assert len(found) == 2
    assert any("a.md:1: names a package registry" in line for line in found)
    assert any("uv.lock: a lock file" in line for line in found)
