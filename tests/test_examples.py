"""The example notebooks run from top to bottom, and the last value of each cell can be displayed."""

import ast
import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
NOTEBOOKS = sorted(EXAMPLES.glob("*.ipynb"))
PROGRAMS = sorted(EXAMPLES.glob("*.py"))


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(notebook: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    cells = [cell for cell in json.loads(notebook.read_text("utf-8"))["cells"] if cell["cell_type"] == "code"]
    assert all(cell["outputs"] == [] for cell in cells)  # a stored output could be out of date
    names: dict[str, Any] = {}
    shown = []
    for number, cell in enumerate(cells):
        tree = ast.parse("".join(cell["source"]), f"{notebook.name}, cell {number}")
        last = tree.body.pop()
        assert isinstance(last, ast.Expr)
        exec(compile(tree, f"{notebook.name}, cell {number}", "exec"), names)
        shown.append(eval(compile(ast.Expression(last.value), f"{notebook.name}, cell {number}", "eval"), names))
    tables = [table for value in shown if (table := getattr(value, "_repr_html_", str)())]
    assert len(tables) >= 4
    assert all("<" in table for table in tables)
    power = shown[-1].to_numpy()
    # Coulomb friction in a contact that grows with the load Q: between Q and Q^(4/3), and the contact angle rises.
    assert ((power > 0.9) & (power < 1.8)).all()


@pytest.mark.slow
@pytest.mark.parametrize("program", PROGRAMS, ids=lambda path: path.stem)
def test_a_program_runs_and_draws_a_picture(program: Path, tmp_path: Path) -> None:
    done = subprocess.run([sys.executable, program], cwd=tmp_path, capture_output=True, text=True, check=True)
    assert done.stdout
    assert (tmp_path / f"{program.stem}.png").stat().st_size > 10_000  # bytes: more than an empty frame


def test_there_is_an_example() -> None:
    assert NOTEBOOKS
    assert PROGRAMS
