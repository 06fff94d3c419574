"""Contacts in a sweep, and results as datasets and as tables of a notebook."""

from collections.abc import Callable
from pathlib import Path

import pytest

from fembearing.check.contact import scene_contact, solution
from fembearing.check.contact.solution import ContactSolution
from fembearing.mesh.recipe import Recipe
from fembearing.sweep.run import run_sweep

QUANTITIES = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")


@pytest.mark.usefixtures("in_process")
def test_contacts_of_half_spaces_agree_with_hertz(
    grid_file: Callable[..., Path], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shallow: Callable[[str], Recipe]
) -> None:
    """At every point of the sweep, Hertz's exact answer lies within the intervals of the finite elements."""
    monkeypatch.setattr(scene_contact, "load_recipe", shallow)
    solved: list[ContactSolution] = []
    solve = solution.solve_contact
    monkeypatch.setattr(solution, "solve_contact", lambda *a, **k: solved.append(solve(*a, **k)) or solved[-1])
    path = grid_file(
        'pair = ["inner", "outer"]\nball_load = ["90 N"]',
        head='what = "contact"\ngeometry = "hertzian"\naccuracy = 0.03',
    )
    found = run_sweep(path, out=tmp_path / "out").to_dataset().squeeze("ball_load")
    assert len(solved) == 2
    assert found["pair"].values.tolist() == ["inner", "outer"]
    for name in QUANTITIES:
        off, allowed = found[f"discrepancy_{name}"], found[f"uncertainty_{name}"]
        assert bool((abs(off) <= allowed).all()), name
        assert bool((allowed <= 0.03).all()), name
    assert found["peak_pressure"].attrs["units"] == "Pa"
    assert float(found["load"][0]) == 90
    assert set(found["verdict"].values) == {"pass"}

    alone = solved[0].to_dataset()
    assert alone.attrs["pair"] == "inner"
    for name in QUANTITIES:
        assert float(alone[name]) == float(found[name][0]) == solved[0].numbers.quantities[name].reference
        assert float(alone[f"hertz_{name}"]) == solved[0].numbers.quantities[name].production
        assert alone[name].attrs["units"]
    table = solved[0]._repr_html_()
    assert f"<td>{solved[0].numbers.reference.approach:.5g}</td>" in table
    assert table.count("<tr>") == 6
