"""--quiet, --verbose, --force, --units and the options of a scene, in every command that has them."""

import json
import re
from pathlib import Path

import pytest

from analytic.given import KEYS
from analytic.units import INCH, POUND
from fembearing.cli import COMMANDS, command_of


def test_options_of_the_same_name_are_the_same_in_every_command() -> None:
    seen: dict[str, set[str]] = {}
    for name in COMMANDS:
        for option in command_of(name).params:
            if option.name in {"quiet", "verbose", "force", "units", *KEYS}:
                seen.setdefault(option.name, set()).add(f"{option.opts} {option.help}")
    assert {name: len(texts) for name, texts in seen.items()} == dict.fromkeys(seen, 1)
    assert {*KEYS} < seen.keys()


@pytest.mark.parametrize("name", sorted({*COMMANDS} - {"app", "init", "list", "sweep"}))
def test_every_command_of_a_scene_takes_its_options(name: str) -> None:
    assert {*KEYS, "texts", "units"} <= {option.name for option in command_of(name).params}


def test_an_option_changes_the_scene_of_a_contact(command) -> None:
    """Its load is that of the heaviest ball."""
    solve = ("contact", "6205-dry", "--geometry", "hertzian", "--tolerance", "90 %", "--json")
    options = ((), ("--axial-load", "90 N"), ("--set", "operation.axial_load=90N"))
    usual, by_option, by_key = (json.loads(command(*solve, *given).out)["load"] for given in options)
    assert usual > by_option == by_key


def test_quiet_leaves_errors_alone_on_standard_error(command) -> None:
    usual = command("torque", "6206", "--speed", "700")
    quiet = command("torque", "6206", "--speed", "700", "-q")
    assert "is read as 700 rpm" in usual.err
    assert (quiet.status, quiet.out) == (usual.status, usual.out)
    (read,) = [line for line in quiet.err.splitlines() if "compiling" not in line]
    assert "inner_speed = 700 has no unit and is read as 700 rpm" in read  # it changes the number
    assert command("torque", "62067", "--quiet").err.count("\n") == 1
    assert command("torque", "6206", "--speed", "700").err == usual.err  # it counts for one command


def test_verbose_tells_each_step_and_its_time(command) -> None:
    told = command("torque", "6205-dry", "-v").err.splitlines()
    assert re.fullmatch(r"fembearing: \d+\.\d s, 0% done: torque", told[0])
    assert any(re.fullmatch(r"fembearing: \d+\.\d s in all", line) for line in told)
    assert "exclude each other" in command("torque", "6205-dry", "-v", "-q").err


def test_force_replaces_what_fembearing_wrote_and_nothing_else(
    command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    run = ("torque", "6205-dry", "-o", "out")
    assert command(*run).status == 0
    first = sorted(path.name for path in Path("out").iterdir())
    assert "give --force" in command(*run).err
    Path("out", "torque.csv").unlink()
    assert command(*run, "--force").status == 0
    assert sorted(path.name for path in Path("out").iterdir()) == first
    assert [path.name for path in tmp_path.iterdir()] == ["out"]
    Path("out", "mine.txt").touch()
    refused = command(*run, "--force")
    assert (refused.status, refused.err.count("\n")) == (2, 1)
    assert "'mine.txt' in it is not of fembearing" in refused.err
    assert sorted(path.name for path in Path("out").iterdir()) == sorted([*first, "mine.txt"])
    Path("other").mkdir()
    assert "no folder that fembearing made" in command("torque", "6205-dry", "-o", "other", "--force").err
    assert "it is no file" in command("init", "6206", "-o", "other", "--force").err


def test_a_command_that_fails_replaces_nothing(command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    assert command("torque", "6205-dry", "-o", "out").status == 0
    before = Path("out", "torque.json").read_bytes()
    failed = command("torque", "6206", "--radial-load", "90000 kN", "-o", "out", "--force")
    assert failed.status == 2
    assert Path("out", "torque.json").read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == ["out"]


def test_units_change_what_is_shown_and_no_number_of_json(command) -> None:
    metric, inch = (command("torque", "6206", "--units", system) for system in ("metric", "inch"))
    assert "N mm" in metric.out
    assert "lbf in" in inch.out
    assert "140 degF" in inch.out  # 60 degC
    (row,) = (line.split() for line in metric.out.splitlines() if re.match(r" *1 +1000 ", line))
    (other,) = (line.split() for line in inch.out.splitlines() if re.match(r" *1 +1000 ", line))
    assert float(other[2]) == pytest.approx(float(row[2]) * 1e-3 / (POUND * INCH), rel=1e-3)  # four digits are shown
    found = [json.loads(command("torque", "6206", "--units", system, "--json").out) for system in ("metric", "inch")]
    assert found[0] | {"seconds": None} == found[1] | {"seconds": None}
