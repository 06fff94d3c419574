"""The result of the main job, `fembearing validate` without a scene. It takes half a minute of a processor.

The gate runs it from a wheel and names its folder in MADE, so that these tests only read what it has written. Without
that folder they run it, in the nightly.
"""

import io
import json
import os
from pathlib import Path
from typing import Any

import pytest

from fembearing import cli

QUANTITIES = {"semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach", "stiffness"}
MADE = "FEMBEARING_MAIN_JOB"  # of the environment: a folder with validate.json, from standard output, and report/
in_the_gate = pytest.mark.slow if os.environ.get(MADE) else pytest.mark.nightly


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    made = os.environ.get(MADE)
    return Path(made) if made else tmp_path_factory.mktemp("main")


@pytest.fixture(scope="module")
def report(folder: Path) -> Path:
    return folder / "report"


@pytest.fixture(scope="module")
def validated(folder: Path, report: Path) -> dict[str, Any]:
    """The result of `fembearing validate --json --out report`, run once."""
    if os.environ.get(MADE):
        return json.loads((folder / "validate.json").read_text("utf-8"))
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.argv", ["fembearing", "validate", "--json", "--out", str(report)])
        patch.setattr("sys.stdout", printed := io.StringIO())
        with pytest.raises(SystemExit) as stop:
            cli.main()
    assert (stop.value.code or 0) == 0
    return json.loads(printed.getvalue())


@in_the_gate
def test_validate_judges_every_quantity_of_all_three_pairs(validated: dict[str, Any]) -> None:
    judged = validated["contacts"][:3]
    assert [contact["pair"] for contact in judged] == ["inner", "outer", "pocket"]
    for contact in judged:
        assert {name: each["verdict"] for name, each in contact["quantities"].items()} == dict.fromkeys(
            QUANTITIES, "pass"
        )
    assert [ladder["quantity"] for ladder in validated["cost"]["ladders"]] == [
        "contact, inner",
        "contact, outer",
        "contact, pocket",
    ]


@in_the_gate
def test_the_answer_without_a_name_is_whole(validated: dict[str, Any]) -> None:
    """Only losses outside the contacts are missing, of which the oil's are estimated; assumptions have a source."""
    torque = validated["torque"]
    missing = {each["name"] for each in torque["effects"] if "not given" in each["reason"] or "add a" in each["reason"]}
    assert missing == {"seals", "drag", "through_flow", "cage_shear", "ball_drag"}
    assert not any("add a" in warning or "is neglected" in warning for warning in torque["warnings"])
    assumed = {each["key"]: each["source"] for each in torque["inputs"] if each["status"] == "assumed"}
    assert assumed["cage.start"]
    assert "ISO VG 68" in assumed["lubricant.viscosity"]
    assert all(assumed.values())


@in_the_gate
def test_the_sheet_of_the_pocket_is_shown_with_its_thick_seat(validated: dict[str, Any]) -> None:
    """A half space under sheet metal makes K_pb too large; the sheet is not judged."""
    seat, sheet = validated["contacts"][2:]
    assert (seat["geometry"], sheet["geometry"]) == ("real", "wall")
    assert seat["load"] == sheet["load"] == 28.0
    assert sheet["verdict"] == "shown"
    thick, thin = (each["quantities"]["stiffness"] for each in (seat, sheet))
    assert thin["reference"] < 0.7 * thick["production"] < thick["reference"]


@in_the_gate
def test_the_report_is_in_its_folder(validated: dict[str, Any], report: Path) -> None:
    written = json.loads((report / "report.json").read_text("utf-8"))
    assert written["contacts"] == validated["contacts"]
    assert (report / "report.html").is_file()
    kinds = {(picture["pair"], picture["geometry"], picture["kind"]) for picture in written["pictures"]}
    pairs = [("inner", "real"), ("outer", "real"), ("pocket", "real"), ("pocket", "wall")]
    contacts = {(*pair, kind) for pair in pairs for kind in ("pressure", "section", "view")}
    assert kinds == contacts | {(*pair, kind) for pair in pairs[:2] for kind in ("film", "creep")}


@in_the_gate
def test_the_torque_is_that_of_the_command_torque(command, validated: dict[str, Any]) -> None:
    torque = json.loads(command("torque", "--json").out)
    for key in ("points", "effects", "warnings", "makers", "verdicts", "notes", "tolerance"):
        assert validated["torque"][key] == torque[key]
