"""`fembearing duty`: energy and torque of a cycle, and a steady temperature of the oil."""

import csv
import json
from collections.abc import Callable
from pathlib import Path

import jsonschema
import pytest

from fembearing.report.schema import duty_schema
from tests.conftest import Result

Run = Callable[..., Result]
EXAMPLE = str(Path(__file__).resolve().parents[2] / "examples/duty_cycle.csv")
QUICK = ("6206", EXAMPLE, "--set", "friction.spin_rule=balanced")


def test_the_example_has_its_steps_and_its_energy(command: Run) -> None:
    ended = command("duty", *QUICK)
    assert ended.status == 0
    lines = [line for line in ended.out.splitlines() if not line.startswith("assumed: ")]
    *tables, verdict = lines
    assert max(map(len, tables)) <= 80
    assert verdict.startswith("check: ")
    assert "oil at 60 degC" in " ".join(ended.out.split())  # the width depends on the path of the file
    assert "worst torque, step" in ended.out
    energy = next(
        line.split() for line in ended.out.splitlines() if line.split()[:1] + line.split()[-1:] == ["energy", "J"]
    )
    low, high = map(float, energy[2].split("-"))
    assert low < float(energy[1]) < high


def test_json_fits_its_schema_and_a_folder_has_everything(
    command: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    ended = command("duty", *QUICK, "--json", "--out", "found")
    found = json.loads(ended.out)
    jsonschema.validate(found, duty_schema())
    assert json.loads(command("list", "--schema", "duty").out) == json.loads(json.dumps(duty_schema()))
    assert (found["kind"], found["format"]) == ("fembearing duty", 1)
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


def test_what_is_assumed_is_told_but_for_the_columns_of_the_cycle(command: Run, tmp_path: Path) -> None:
    file = tmp_path / "thrust.csv"
    file.write_text("duration [s],axial_load [N],inner_speed [rpm]\n7,300,900\n")
    quick = ("--set", "friction.spin_rule=balanced")
    ended = command("duty", "6206", str(file), "--oil", "ISO VG 46", *quick)
    (told,) = (line for line in ended.out.splitlines() if line.startswith("assumed: "))
    assert "operation.radial_load = 0 N, " in told
    assert "lubricant.temperature = 60 degC" in told
    assert told.endswith("; change with --set KEY=VALUE")
    for given in ("axial_load", "inner_speed", "lubricant.name"):
        assert given not in told
    assert "radial load" not in command("duty", "6206", str(file), "--radial-load", "0N", *quick).err
    heated = ("--set", "thermal.resistance=0.8 K/W", "--set", "thermal.ambient=22C")
    assert "lubricant.temperature" not in command("duty", "6206", str(file), *heated, *quick).out


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


def test_a_steady_temperature_is_in_title_json_and_not_among_the_assumptions(command: Run) -> None:
    heated = ("--set", "thermal.resistance=0.8 K/W", "--set", "thermal.ambient=22C", *QUICK[2:])
    ended = command("torque", "6206", "--speed", "3000rpm", *heated)
    title = ended.out.splitlines()[0] + ended.out.splitlines()[1]
    assert "degC (steady)" in title
    assert "lubricant.temperature" not in ended.out
    record = json.loads(command("torque", "6206", "--speed", "3000rpm", "--json", *heated).out)
    warm = next(each for each in record["inputs"] if each["key"] == "lubricant.temperature")
    power = record["points"][0]["torque"]["total"] * record["points"][0]["inner_speed"]
    assert warm["value"] == pytest.approx(295.15 + 0.8 * power, abs=1e-3)  # the search ends at 1e-4 K
    assert "0.8 K/W" in warm["source"]
    assert "(steady)" in command("duty", *QUICK, *heated[:4]).out
