"""The command line as a user meets it: exit status, what stands on which stream, one line for each mistake."""

import json
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from fembearing import cli
from fembearing.fem import solution

QUANTITIES = {"semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach", "stiffness"}


class Result(NamedTuple):
    status: int
    out: str
    err: str


def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, *arguments: str) -> Result:
    monkeypatch.setattr("sys.argv", ["fembearing", *arguments])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    captured = capsys.readouterr()
    return Result(int(stop.value.code or 0), captured.out, captured.err)


@pytest.fixture
def command(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch):
    return lambda *arguments: run(capsys, monkeypatch, *arguments)


@pytest.fixture(scope="module")
def validated() -> dict[str, Any]:
    """The main job once, through the command line."""
    with pytest.MonkeyPatch.context() as patch:
        printed: list[str] = []
        patch.setattr("sys.argv", ["fembearing", "validate", "--json"])
        patch.setattr(cli.typer, "echo", lambda text, err=False: printed.append(text) if not err else None)
        with pytest.raises(SystemExit) as stop:
            cli.main()
    assert (stop.value.code or 0) == 0
    return json.loads("".join(printed))


def test_the_main_job_judges_every_quantity_of_both_races(validated: dict[str, Any]) -> None:
    judged = {(row["pair"], row["quantity"]) for row in validated["verdicts"]}
    assert judged == {(pair, quantity) for pair in ("inner", "outer") for quantity in QUANTITIES}
    assert {row["verdict"] for row in validated["verdicts"]} == {"pass"}


def test_each_discrepancy_is_production_over_reference_minus_one(validated: dict[str, Any]) -> None:
    for row in validated["verdicts"]:
        assert row["discrepancy"] == pytest.approx(row["production"] / row["reference"] - 1, abs=1e-12)  # round-off
        assert row["exceeds_uncertainty"] == (abs(row["discrepancy"]) > row["uncertainty"])
        assert row["uncertainty"] > 0


def test_the_true_groove_is_stiffer_than_hertz_says_and_the_inner_race_bears_more(validated: dict[str, Any]) -> None:
    inner, outer = validated["contacts"]
    assert inner["fe"]["peak_pressure"] > outer["fe"]["peak_pressure"]
    for contact in (inner, outer):
        assert contact["fe"]["stiffness"] > contact["hertz"]["stiffness"]
        assert contact["fe"]["semi_axis_transverse"] < contact["hertz"]["semi_axis_transverse"]  # the groove closes in


def test_uncertainty_covers_a_finer_solution(command, validated: dict[str, Any]) -> None:
    """The finer one is another run, to a tolerance that asks for one more mesh."""
    result = command("contact", "--pair", "outer", "--tolerance", "0.3 %", "--json")
    finer = json.loads(result.out)
    coarse = validated["contacts"][1]
    assert finer["cost"]["unknowns"] > 2 * coarse["cost"]["unknowns"]
    for name in QUANTITIES:
        assert abs(coarse["fe"][name] / finer["fe"][name] - 1) <= coarse["uncertainty"][name]
    assert result.status == 1  # Hertz is 1.7 % off in approach: beyond 0.3 %, and said so
    assert finer["verdict"] == "fail"


def test_json_is_alone_on_standard_output(command) -> None:
    result = command("contact", "--geometry", "hertzian", "--load", "51 N", "--json")
    found = json.loads(result.out)
    assert found["load"] == 51.0
    assert set(found["fe"]) == set(found["hertz"]) == set(found["uncertainty"]) == QUANTITIES
    assert result.status == 0
    assert result.err == ""  # no progress where nobody watches


def test_the_idealisation_meets_hertz_within_its_own_uncertainty(command) -> None:
    found = json.loads(command("contact", "--geometry", "hertzian", "--pair", "outer", "--json").out)
    for name in QUANTITIES:
        assert abs(found["discrepancy"][name]) <= found["uncertainty"][name]


def test_meshes_that_disagree_without_order_are_undecided(command, monkeypatch: pytest.MonkeyPatch) -> None:
    """Peak pressure is made to swing by 3 % from mesh to mesh, as it does for solvers that read it off one node."""
    true = solution.peak_pressure
    swing = iter([0.0, 0.03, -0.03, 0.03, -0.03, 0.03, -0.03])
    monkeypatch.setattr(solution, "peak_pressure", lambda *a, **k: true(*a, **k) * (1 + next(swing)))
    result = command("contact", "--geometry", "hertzian", "--load", "77 N", "--json")
    found = json.loads(result.out)
    assert found["verdict"] == "undecided"
    assert found["convergence"]["peak_pressure"]["order"] is None
    assert "without order in peak_pressure" in found["warnings"][0]
    assert result.status == 3


def test_table_names_axes_and_units(command) -> None:
    result = command("contact", "--geometry", "hertzian", "--load", "51 N")
    for words in ("Hertz", "FE", "GPa", "x along rolling", "um", "order"):
        assert words in result.out


SCENE = """
name = "mine"
tolerance = "4 %"
[bearing]
catalog = "6205"
contact_angle = { rule = "given", value = "0.2 rad" }
[operation]
axial_load = "700 N"
inner_speed = "90 rpm"
[friction]
coefficient = 0.1
"""


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["validate", "nowhere.toml"], ["nowhere.toml"]),
        (["validate", "scene.toml", "--tolerance", "-1 %"], ["--tolerance", "-1 %", "1e-06"]),
        (["contact", "--load", "620"], ["--load", "620", "N"]),
        (["contact", "--load", "nan N"], ["--load", "nan N"]),
        (["contact", "--load", "3 mm"], ["--load", "3 mm", "N"]),
        (["contact", "--load", "90 kN"], ["too wide", "m"]),  # plastic long before: no mesh for it
        (["mesh", "--out", "scene.toml"], ["--out", "scene.toml", "folder"]),
        (["mesh", "--out", "new", "--level", "77"], ["--level", "77", "1, 2, 3, 4"]),
    ],
)
def test_a_mistake_gets_one_line_and_status_2(
    command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], words: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.toml").write_text(SCENE)
    result = command(*arguments)
    assert result.status == 2
    assert result.out == ""
    assert result.err.count("\n") == 1
    assert all(word in result.err for word in words), result.err
    assert sorted(path.name for path in tmp_path.iterdir()) == ["scene.toml"]  # nothing half-written


def test_mesh_files_are_written_and_their_worst_cells_reported(command, tmp_path: Path) -> None:
    result = command("mesh", "--out", str(tmp_path / "made"), "--level", "1", "--json")
    found = json.loads(result.out)
    assert result.status == 0
    assert {Path(path).name for path in found["meshes"]} == {"inner-real-upper.vtu", "inner-real-lower.vtu"}
    assert all(Path(path).is_file() and quality["negative_points"] == 0 for path, quality in found["meshes"].items())


def test_help_shows_an_example(command) -> None:
    for name in ("validate", "contact", "mesh"):
        assert "Example: fembearing" in command(name, "--help").out
