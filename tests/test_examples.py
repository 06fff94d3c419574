"""The example notebooks run from top to bottom, and the last value of each cell can be displayed."""

import ast
import json
from pathlib import Path
from typing import Any

import pytest

NOTEBOOKS = sorted((Path(__file__).resolve().parents[1] / "examples").glob("*.ipynb"))


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


def test_there_is_an_example() -> None:
    assert NOTEBOOKS
