"""The way in: version, help, completion, lists, and the scene of a bearing of the catalogue."""

import json
import os
import re
import subprocess
import sys
import tomllib
from importlib.metadata import version
from pathlib import Path

import pytest
from jsonschema import Draft7Validator

from analytic import catalog
from analytic.catalog.bearing_rows import bearing_names, find_bearing
from analytic.effects import TABLE
from fembearing import cli

COMMANDS = tuple(cli.COMMANDS)


def test_the_version_is_that_of_the_package(command) -> None:
    assert command("--version") == (0, f"fembearing {version('fembearing')}\n", "")


def test_h_is_help_everywhere(command) -> None:
    assert command("-h").out == command("--help").out != ""
    for name in COMMANDS:
        short = command(name, "-h")
        assert short == command(name, "--help")
        assert short.status == 0
        assert f"Example: fembearing {name}" in short.out


SLOW = {"numpy", "scipy", "pydantic", "pint", "rich", "llvmlite", "numba", "skfem", "pyvista", "matplotlib"}


def loaded_by(*lines: str, folder: Path, whole: bool = False) -> set[str]:
    """Packages that a process has imported at the end of these commands; whole : and the modules in them."""
    show = (
        "import sys; from fembearing import cli\n"
        "for line in sys.argv[1:]:\n"
        "    sys.argv = ['fembearing', *line.split()]\n"
        "    try: cli.main()\n"
        "    except SystemExit as stop: assert not stop.code, line\n"
        "print(*sys.modules, file=sys.stderr)"
    )
    run = [sys.executable, "-c", show, *lines]
    done = subprocess.run(run, cwd=folder, capture_output=True, text=True, check=True)
    modules = done.stderr.splitlines()[-1].split()
    return {name for name in modules if whole} | {name.partition(".")[0] for name in modules}


def test_version_and_help_load_nothing_slow(tmp_path: Path) -> None:
    loaded = loaded_by("--version", "--help", folder=tmp_path)
    assert "typer" in loaded
    assert not SLOW & loaded
    loaded = loaded_by(*(f"{name} --help" for name in COMMANDS), folder=tmp_path)
    assert not {"numba", "numpy", "rich"} & loaded  # half of the time of the help


def test_the_torque_of_a_dry_scene_loads_only_what_it_computes_with(command, tmp_path: Path) -> None:
    assert command("torque", "6205-dry").status == 0  # what it compiles is then kept
    loaded = loaded_by("torque 6205-dry", folder=tmp_path, whole=True)
    assert "numpy" in loaded
    slow = {"pint", "xarray", "matplotlib", "skfem", "meshio", "pyvista", "pymklpardiso", "jinja2", "pandas", "netCDF4"}
    slow |= {f"scipy.{part}" for part in ("stats", "optimize", "interpolate", "sparse", "integrate")}
    ask = [sys.executable, "-c", "import sys, scipy.linalg; print(*sys.modules)"]  # of SciPy 1.15: sparse too
    slow -= {*subprocess.run(ask, capture_output=True, text=True, check=True).stdout.split()}
    assert not slow & loaded


def test_a_command_that_computes_nothing_does_not_import_numba(tmp_path: Path) -> None:
    loaded = loaded_by("list effects", "list bearings 62", "init 6206", folder=tmp_path)
    assert "typer" in loaded
    assert "numba" not in loaded


def test_a_shell_completes_commands_topics_and_scenes(tmp_path: Path) -> None:
    (tmp_path / "62-mine.toml").touch()
    (tmp_path / "62.txt").touch()

    asked = ("to", "list ma", "contact --pair ou", "torque 62", "init 7208BEP", "init 7208")
    run = (
        "import os, sys; from fembearing.cli import main\n"
        "for words in sys.argv[1:]:\n"
        "    sys.argv = ['fembearing']\n"
        "    os.environ |= {'COMP_WORDS': f'fembearing {words}', 'COMP_CWORD': str(words.count(' ') + 1)}\n"
        "    try: main()\n"
        "    except SystemExit as stop: assert not stop.code, words\n"
        "    print(flush=True), print('--', flush=True)"
    )
    path = os.pathsep.join([str(Path(cli.__file__).parents[2]), os.environ.get("PYTHONPATH", "")])
    environment = {**os.environ, "_FEMBEARING_COMPLETE": "complete_bash", "PYTHONPATH": path}
    done = subprocess.run(
        [sys.executable, "-c", run, *asked], env=environment, cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, done.stderr
    command, topic, pair, scene, other, bearing = (part.split() for part in done.stdout.split("--\n")[:-1])
    assert command == ["torque"]
    assert topic == ["materials"]
    assert pair == ["outer"]
    assert {"62-mine.toml", "6206"} <= set(scene)
    assert "62.txt" not in scene
    assert other == []
    assert "7208A5" in bearing


def test_lists_are_whole(command) -> None:
    def names(topic: str, key: str) -> list[str]:
        return [row[key] for row in json.loads(command("list", topic, "--json").out)[topic]]

    assert names("bearings", "designation") == list(bearing_names())
    assert names("oils", "oil") == list(catalog.oil_names())
    assert names("materials", "material") == list(catalog.names("materials"))
    assert names("scenes", "scene") == list(catalog.names("scenes"))
    assert names("effects", "effect") == [entry.name for entry in TABLE]


def test_a_bearing_in_the_list(command) -> None:
    bearing = find_bearing("7208B")
    (row,) = json.loads(command("list", "bearings", "7208 b", "--json").out)["bearings"]
    for key in ("bore", "ball_count", "ball_diameter", "nominal_angle", "static_load_rating", "grade"):
        assert row[key] == getattr(bearing, key)
    line = next(line for line in command("list", "bearings", "7208b").out.splitlines() if "7208 B" in line)
    assert (
        re.sub(" +", " ", line)
        .strip()
        .endswith(f"40 80 18 {bearing.ball_count} {1e3 * bearing.ball_diameter:g} 40 34.5 24 {bearing.grade}")
    )  # d, D, B, Z, Dw, angle, C, C0: the maker prints 40 x 80 x 18 mm, 34.5 and 24 kN
    inch = command("list", "bearings", "7208b", "--units", "inch").out
    assert "1.575 3.15 0.7087" in re.sub(" +", " ", inch)  # 40, 80 and 18 mm over 25.4 mm


def test_init_writes_a_scene_and_its_schema(command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    told = command("init", "6305-2RS/C3")
    assert told.status == 0
    assert told.out.splitlines()[-1] == "next: fembearing torque 6305-2RS-C3.toml"
    text = (tmp_path / "6305-2RS-C3.toml").read_text("utf-8")
    directive = re.match(r"#:schema (\S+)\n", text)
    assert directive
    schema = json.loads((tmp_path / directive[1]).read_text("utf-8"))
    assert list(Draft7Validator(schema).iter_errors(tomllib.loads(text))) == []


def test_init_replaces_nothing(command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "fembearing-scene.schema.json").write_text("{}")
    (tmp_path / "mine.toml").write_text("mine")
    refused = command("init", "6206", "--out", "mine.toml")
    assert (refused.status, refused.out) == (2, "")
    assert (
        refused.err
        == "fembearing: --out 'mine.toml' exists already: give a new name, remove it first, or give --force\n"
    )
    assert (tmp_path / "mine.toml").read_text() == "mine"
    assert command("init", "6206", "--out", "other name.toml").out.splitlines()[-1].endswith("torque 'other name.toml'")
    assert (tmp_path / "fembearing-scene.schema.json").read_text() == "{}"


def test_draw_writes_the_bearing_to_scale(command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    told = command("draw", "6305/C3", "--set", "bearing.ball_count=7")
    assert told.status == 0
    (file,) = tmp_path.iterdir()
    assert told.out == f"file: {file.name}\n"
    assert file.read_bytes().startswith(b"<?xml")
    refused = command("draw", "6305/C3", "--out", "mine.docx")
    assert refused.status == 2
    assert "give a file that ends with .svg, .png, .pdf" in refused.err
