"""`fembearing torque` as a user sees it: tables of 80 characters, JSON, exit status, one line for each mistake."""

import csv
import json
from pathlib import Path

import pytest

from analytic.scenefile.template import scene_text
from fembearing.cli.status import CHECK_FAILED, DONE, INPUT_AT_FAULT, NOT_SOLVED
from tests.analytic.scenefile.scene_texts import MINE, OILED, SPEEDS, changed

SERIES = changed('"700 N"', '["900 N", "400 N"]', changed(SPEEDS, '["500 rpm", "2000 rpm"]', OILED))
# Neither a bath nor a jet, whose oil outside the contacts has an estimate that a tight tolerance does not bear
SERIES = changed("[lubricant]\n", '[lubricant]\nsupply = "oil_spot"\n', SERIES)

BEARING = 'catalog = "paper_6205"\ncontact_angle = { rule = "solved" }\n'
NO_SHOULDER = """\
ball_count = 9
ball_diameter = "7.94 mm"
pitch_diameter = "39 mm"
conformity = 0.52
contact_angle = { nominal = "30 deg" }
"""


@pytest.mark.parametrize(
    ("text", "status", "words"),
    [
        (SERIES, DONE, "check: inside the makers' formulas"),
        # A low shoulder would cut off more than a tenth, and nobody knows how high it is
        (SERIES.replace(BEARING, NO_SHOULDER), NOT_SOLVED, "undecided: a physical limit is not known: shoulder"),
        # 0.2 rad: 9 balls carry 5033 N each, which 4.2 GPa allows up to some 4400 N
        (MINE.replace("700 N", "9000 N"), CHECK_FAILED, "fail: the peak pressure exceeds the static limit"),
    ],
)
def test_status_and_last_line_follow_from_both_verdicts(
    command, tmp_path: Path, text: str, status: int, words: str
) -> None:
    (tmp_path / "a.toml").write_text(text, "utf-8")
    shown = command("torque", str(tmp_path / "a.toml"))
    assert shown.status == status
    assert words in " ".join(shown.out.split())


COULOMB = SERIES.partition("[lubricant]")[0] + '[friction]\ncoefficient = 0.1\nspin_rule = "inner_control"\n'


def test_with_an_interval_the_json_the_tables_and_the_folder_have_it(command, tmp_path: Path) -> None:
    (tmp_path / "a.toml").write_text(COULOMB, "utf-8")
    given = ("torque", str(tmp_path / "a.toml"), "--interval", "--samples", "64")
    _, out, _ = command(*given, "--json")
    found = json.loads(out)["prediction"]
    assert (found["samples"], len(found["points"])) == (64, 2)
    fast = found["points"][1]
    assert fast["total_low"] < fast["total_median"] < fast["total_high"]
    assert {each["key"] for each in found["inputs"]} >= {"friction.coefficient", "operation.axial_load"}
    _, out, _ = command(*given, "--details", "--out", str(tmp_path / "new"))
    assert "95 % interval of the total, N mm" in out
    assert (tmp_path / "new" / "interval.png").read_bytes()[:4] == b"\x89PNG"
    written = json.loads((tmp_path / "new" / "torque.json").read_text("utf-8"))["prediction"]
    assert written["points"] == found["points"]


def test_a_series_loses_only_its_bad_points(command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The torque of the others is that of a series without the bad one."""
    monkeypatch.chdir(tmp_path)
    text = scene_text("6206", axial_load="700 N")
    text = text.replace("[friction]\n", '[friction]\nspin_rule = "balanced"\n')  # free balls take seconds
    assert 'spin_rule = "balanced"' in text
    for name, loads in (("bad", ["100 N", "-9e7 N", "300 N"]), ("good", ["100 N", "300 N"])):
        (tmp_path / f"{name}.toml").write_text(text.replace('radial_load = "0 N"', f"radial_load = {loads}"), "utf-8")
    refused = command("torque", "bad.toml", "--out", "none")
    assert (refused.status, refused.err.count("\n")) == (2, 1)
    good = json.loads(command("torque", "good.toml", "--json").out)
    kept = command("torque", "bad.toml", "--keep-going", "--json")
    found = json.loads(kept.out)
    assert kept.status == 3
    assert [found["points"][place] for place in (0, 2)] == good["points"]
    lost = found["points"][1]
    assert (lost["radial_load"], lost["axial_load"], lost["torque_total"]) == (-9e7, 700.0, None)
    assert lost.keys() == good["points"][0].keys()
    (said,) = found["left_out"]
    assert (said["point"], said["radial_load"], good["left_out"]) == (1, -9e7, [])
    assert "lower the load" in said["reason"]
    for name in ("low", "high"):
        band = [point[f"catalogue_{name}"] for point in found["points"]]
        assert [band[0], band[2]] == [point[f"catalogue_{name}"] for point in good["points"]]
        assert band[1] is None
    worse = text.replace('radial_load = "0 N"', 'radial_load = ["8e7 N", "9e7 N"]')
    (tmp_path / "worse.toml").write_text(worse, "utf-8")
    assert command("torque", "worse.toml", "--keep-going").status == 2
    assert command("torque", "bad.toml", "--keep-going", "--out", "kept.csv").status == 3
    head, *lines = csv.reader((tmp_path / "kept.csv").read_text("utf-8").splitlines())
    table = [dict(zip(head, line, strict=True)) for line in lines]
    assert [row["point"] for row in table] == ["1", "2", "3"]
    assert [row["radial_load [N]"] for row in table] == ["100", "-90000000", "300"]
    totals = [row["torque_total [N mm]"] for row in table]
    assert totals[1] == ""
    assert [float(totals[0]), float(totals[2])] == pytest.approx(
        [1e3 * each["torque_total"] for each in good["points"]]
    )


def test_several_scenes_are_one_table_with_their_names_and_one_figure(command, tmp_path: Path) -> None:
    (tmp_path / "series.toml").write_text(SERIES, "utf-8")
    scenes = (str(tmp_path / "series.toml"), "6205-dry")
    for ending in ("csv", "png"):
        assert command("torque", *scenes, "--out", str(tmp_path / f"two.{ending}")).status == DONE
    rows = list(csv.DictReader((tmp_path / "two.csv").read_text("utf-8").splitlines()))
    names = [(row["scene"], row["point"]) for row in rows]
    assert names[:2] == [(scenes[0], "1"), (scenes[0], "2")]
    assert {scene for scene, _ in names} == {*scenes}
    for name in scenes:
        alone = tmp_path / "alone.csv"
        command("torque", name, "--out", str(alone), "--force")
        for row in csv.DictReader(alone.read_text("utf-8").splitlines()):
            (both,) = (each for each in rows if (each["scene"], each["point"]) == (name, row["point"]))
            assert row.items() <= both.items()
            assert not any(both[column] for column in both.keys() - row.keys() - {"scene"})
    assert (tmp_path / "two.png").read_bytes().startswith(b"\x89PNG")
    assert command("torque", *scenes, "--out", str(tmp_path / "two.csv")).status == INPUT_AT_FAULT  # it exists


LIST = """\
Bearing;radial load [kN];axial load;speed [rpm];oil;pieces
6206;1,2;;3000;;4
62066;2,5;;3000;;1
6206;0,9;200 N;;ISO VG 68;2
"""
ALONE = {
    "6206": ("--radial-load", "1.2 kN", "--speed", "3000 rpm"),
    "6206 (2)": ("--radial-load", "0.9 kN", "--axial-load", "200 N", "--oil", "ISO VG 68"),
}
BOTH = ("--temperature", "71C", "--set", "friction.spin_rule=balanced")  # free balls take seconds


def test_a_list_gives_each_bearing_its_own_row(command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "list.csv").write_text(LIST, "utf-16")
    refused = command("torque", "list.csv", *BOTH, "--out", "none.csv")
    assert (refused.status, refused.out) == (INPUT_AT_FAULT, "")
    assert "list.csv: row 2 (line 3): bearing '62066' is not in the catalogue" in refused.err
    kept = command("torque", "list.csv", *BOTH, "--keep-going", "--json", "--quiet")
    assert kept.status == NOT_SOLVED
    assert [line for line in kept.err.splitlines() if "pieces" in line] == [
        "fembearing: warning: list.csv: columns that are not read: pieces"
    ]
    assert "skipped: list.csv: row 2 (line 3): bearing '62066'" in kept.err
    found = json.loads(kept.out)
    assert found.keys() == ALONE.keys()
    for name, words in ALONE.items():
        alone = json.loads(command("torque", "6206", *words, *BOTH, "--json").out)
        assert found[name]["points"] == alone["points"]
    assert command("torque", "list.csv", *BOTH, "--keep-going", "--out", "some.csv").status == NOT_SOLVED
    rows = list(csv.DictReader((tmp_path / "some.csv").read_text("utf-8").splitlines()))
    assert [row["scene"] for row in rows] == [*ALONE]
    assert {path.name for path in tmp_path.iterdir()} == {"list.csv", "some.csv"}
