"""The examples run from top to bottom: notebooks, whose last value of each cell can be displayed, and programs."""

import ast
import json
import runpy
from pathlib import Path
from typing import Any

import matplotlib.pyplot as plt
import pytest

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
NOTEBOOKS = sorted(EXAMPLES.glob("*.ipynb"))
PROGRAMS = sorted(EXAMPLES.glob("*.py"))
LONG = {"plot_interval", "plot_measured_roughness", "plot_stiffness_law", "plot_thin_sheet"}  # 5 s and more
plt.switch_backend("agg")  # no window


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


@pytest.mark.parametrize(
    "program",
    [
        pytest.param(path, marks=pytest.mark.nightly if path.stem in LONG else pytest.mark.slow, id=path.stem)
        for path in PROGRAMS
    ],
)
def test_a_program_runs_and_draws_a_picture(program: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(plt, "show", lambda: None)
    runpy.run_path(str(program), run_name="__main__")
    figures = [plt.figure(number) for number in plt.get_fignums()]
    plt.close("all")
    assert figures
    assert all(figure.get_axes() for figure in figures)
