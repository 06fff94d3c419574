"""`fembearing duty`: energy and torque of a cycle, and a steady temperature of the oil."""

import csv
import json
from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest

from fembearing.plain_types import FORMAT
from fembearing.report.schema import schema_of
from tests.conftest import Result

Run = Callable[..., Result]
EXAMPLE = str(Path(__file__).resolve().parents[2] / "examples/duty_cycle.csv")
QUICK = ("6206", EXAMPLE, "--set", "friction.spin_rule=balanced")


def test_json_fits_its_schema_and_a_folder_has_everything(
    command: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ended = command("duty", *QUICK, "--json", "--out", "found")
    found = json.loads(ended.out)
    jsonschema.validate(found, schema_of("duty"))
    assert json.loads(command("list", "--schema", "duty").out) == json.loads(json.dumps(schema_of("duty")))
    assert (found["kind"], found["format"]) == ("fembearing duty", FORMAT)
    folder = tmp_path / "found"
    assert {file.name for file in folder.iterdir() if file.name[0] != "."} == {
        "duty.json",
        "duty.csv",
        "duty.png",
        "duty.svg",
    }
    with (folder / "duty.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(found["steps"]) == 4
    for row, step in zip(rows, found["steps"], strict=True):
        assert float(row["torque [N mm]"]) == pytest.approx(1e3 * step["torque"]["value"], rel=1e-12)
        assert float(row["energy [J]"]) == pytest.approx(step["energy"], rel=1e-12)
    assert float(rows[1]["duration [s]"]) == 30
    assert (folder / "duty.png").read_bytes().startswith(b"\x89PNG")
    assert json.loads((folder / "duty.json").read_text("utf-8"))["run"]["scene"]


SLIPPING = "3,10000,5,0,60\n7,1000,600,0,60\n2,0,600,0,60\n4,10000,5,0,60\n"


def test_the_verdict_is_that_of_the_torque_at_the_worst_steps(command: Run, tmp_path: Path) -> None:
    line = "fail at 2 of 3 turning steps: the rolling force of the oil exceeds the driving friction (inner"
    head = "duration [s],inner_speed [rpm],axial_load [N],radial_load [N],temperature [degC]\n"
    (tmp_path / "cycle.csv").write_text(head + SLIPPING, "utf-8")
    words = ("duty", "6206", str(tmp_path / "cycle.csv"), "--oil", "ISO VG 68", *QUICK[2:])
    ended = command(*words)
    assert ended.status == 1
    assert [told for told in ended.out.splitlines() if told.startswith(line)]
    found = command(*words, "--json")
    assert found.status == 1
    standing = json.loads(found.out)["standing"]
    assert f"{standing['word']} at {standing['points']} of {standing['size']} turning steps" == line.split(":")[0]


def test_the_terminal_has_the_units_that_are_asked_for(command: Run) -> None:
    said = command("duty", *QUICK, "--units", "inch").out
    assert "lbf in" in said
    assert "N mm" not in said
