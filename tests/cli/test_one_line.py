"""`fembearing torque` of a bearing in one line, of several scenes, and of a scene from standard input."""

import io
import json
from pathlib import Path
from typing import Any

import pytest

import analytic
from analytic.scenefile.template import scene_text

LINE: dict[str, Any] = {
    "radial_load": "3kN",
    "axial_load": "200N",
    "speed": "2900rpm",
    "oil": "ISO VG 46",
    "temperature": "65C",
    "supply": "grease",
}
OPTIONS = [word for name, value in LINE.items() for word in (f"--{name.replace('_', '-')}", value)]


def without_time(out: str) -> dict[str, Any]:
    """Without what a designation leaves open either, which the file of a scene gives."""
    told = json.loads(out)
    return told | {
        "seconds": None,
        "inputs": [each for each in told["inputs"] if "none was given" not in each["source"]],
    }


def test_one_line_is_the_file_that_init_writes_and_python(
    command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    line = command("torque", "6308", *OPTIONS, "--json")
    assert command("init", "6308", *OPTIONS, "-o", "a.toml").status == 0
    file = command("torque", "a.toml", "--json")
    assert (line.status, line.err) == (file.status, "") == (0, "")
    assert without_time(line.out) == without_time(file.out)
    (point,) = json.loads(line.out)["points"]
    result = analytic.friction_torque("6308", **LINE)
    assert point["torque_total"] == result.torque.total[0]
    assert (point["radial_load"], point["axial_load"]) == (3000.0, 200.0)


def test_what_is_assumed_is_told_and_a_setting_takes_its_place(command) -> None:
    (told,) = (line for line in command("torque", "6308").out.splitlines() if line.startswith("assumed: "))
    for part in ("operation.inner_speed = 1000 rpm", "lubricant.supply = oil_bath", "friction.hysteresis_loss = 0.007"):
        assert part in told
    ended = command("torque", "6308", *OPTIONS, "--set", "friction.hysteresis_loss=0,004", "--details")
    (told,) = (line for line in ended.out.splitlines() if line.startswith("assumed: "))
    assert "operation.inner_speed" not in told
    assert "hysteresis" not in told
    assert "surface.finish = ground and honed" in told
    assert "Printed, derived and assumed inputs" in ended.out
    assert "assumed: " not in command("torque", "6205-dry").out


def test_scenes_side_by_side(command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """One row each, with the torque that each has alone; a series from its lowest to its highest."""
    monkeypatch.chdir(tmp_path)
    Path("a.toml").write_text(scene_text("6206"), "utf-8")
    # Slow enough for oil outside the contacts to be neglected
    series = ("--set", 'operation.inner_speed=["700 rpm", "1300 rpm"]')
    ended = command("torque", "a.toml", "6308", *series)
    rows = {line.split()[0]: line for line in ended.out.splitlines() if " %" in line and line[0] != " "}
    assert ended.status == 0
    assert max(map(len, ended.out.splitlines()[:6])) <= 80
    found = json.loads(command("torque", "a.toml", "6308", *series, "--json").out)
    for name in ("a.toml", "6308"):
        alone = json.loads(command("torque", name, *series, "--json").out)
        assert found[name] | {"seconds": None} == alone | {"seconds": None}
        low, high = (1e3 * point["torque_total"] for point in alone["points"])
        assert f" {low:.4g}-{high:.4g} " in rows[name]
        assert alone["standing"]["word"] in rows[name]
    assert "6308: assumed: " in ended.out
    assert "a.toml: assumed: " not in ended.out


def test_a_scene_from_standard_input(command, monkeypatch: pytest.MonkeyPatch) -> None:
    def given(content: bytes, *words: str) -> Any:
        monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(content)))
        return command("torque", "-", *words)

    text = scene_text("6206").encode()
    alone = without_time(command("torque", "6206", "--json").out)
    assert without_time(given(text, "--json").out) == alone
    faster_text = given(text, "--set", "operation.inner_speed=2900rpm", "--json").out
    faster = json.loads(faster_text)
    assert faster["points"][0]["torque_total"] > alone["points"][0]["torque_total"]
    assert "assumed: " not in given(text).out  # a scene that says everything
    for content, words in (
        (b"\xff\xfe", "standard input: byte 0 is not UTF-8"),
        (b"name = ", "standard input: not TOML"),
        (b"#" * 300_000, "standard input: has more than 256000 bytes"),
        (b"", "bearing is missing"),
    ):
        ended = given(content)
        assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1)
        assert words in ended.err
    option = given(text, "--speed", "2900 rpm", "--json").out
    assert without_time(option) == without_time(faster_text)


def test_without_a_command_there_is_help(command) -> None:
    bare = command()
    assert bare == command("--help")
    assert (bare.status, bare.err) == (0, "")
    assert "torque" in bare.out
