"""The folder of a torque: whole or not at all, and with a word on what it lacks."""

import json
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest
import xarray

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scene_torque import SceneTorque, torque_of_scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.writing import LISTING
from fembearing import cli
from fembearing.plain_types import plain
from fembearing.provenance import provenance_of
from fembearing.report import torque_folder as module
from fembearing.report.torque_folder import torque_with_files, write_torque
from tests.analytic.scenefile.scene_texts import MOVING
from tests.analytic.specimens import present

ALWAYS = {"torque.json", "torque.csv", "torque.png", "torque.svg"}
TWO = MOVING.replace('inner_speed = "500 rpm"', 'inner_speed = ["500 rpm", "200 rpm"]')
DIES = (sys.executable, "-c", "import os, signal; os.kill(os.getpid(), signal.SIGABRT)")  # as VTK without GL does


class Made(NamedTuple):
    scene: Scene
    result: SceneTorque
    folder: Path
    steps: list[float]


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Made:
    scene = parse_scene(TWO, origin="here")
    folder = tmp_path_factory.mktemp("torque") / "made"
    steps: list[float] = []
    result, lacking = torque_with_files(scene, out=folder, progress=lambda share, _: steps.append(share))
    assert lacking is None
    return Made(scene, result, folder, steps)


def test_each_point_has_series_plot_and_picture(made: Made) -> None:
    files = {f"{point}-cage{end}" for point in (1, 2) for end in (".nc", ".png", "-forces.png")}
    assert {path.name for path in made.folder.iterdir()} == files | ALWAYS | {LISTING}
    assert [path.name for path in made.folder.parent.iterdir()] == ["made"]  # nothing beside it
    content = json.loads((made.folder / "torque.json").read_text("utf-8"))
    assert content["points"] == plain(made.result.points)
    assert content["run"]["scene_sha256"] == provenance_of(made.scene).scene_sha256
    assert content["cage_motion"]["lacking"] is None
    for point, told in enumerate(content["cage_motion"]["points"], start=1):
        assert (told["point"], told["state"]) == (point, "rest")
        assert told["series"] == f"{point}-cage.nc"
        assert "The cage rests" in told["plot"]["caption"]
        assert "10 times as large" in told["picture"]["caption"]
        for kind, end in (("plot", "-forces.png"), ("picture", ".png")):
            assert told[kind]["file"] == f"{point}-cage{end}"
            assert (made.folder / told[kind]["file"]).read_bytes().startswith(b"\x89PNG")
    assert made.steps == sorted(made.steps)
    assert made.steps[-1] < 1


def test_a_series_tells_where_it_comes_from_and_agrees_with_the_torque(made: Made) -> None:
    torque = present(made.result.friction.torque.cage)
    for point, rpm in enumerate((500, 200)):
        read = xarray.load_dataset(made.folder / f"{point + 1}-cage.nc")
        assert read.attrs["scene_sha256"] == provenance_of(made.scene).scene_sha256
        assert json.loads(read.attrs["scene_content"])["name"] == "mine"
        assert json.loads(read.attrs["versions"])["numpy"] == np.__version__
        np.testing.assert_allclose(read.attrs["inner_speed_rad_per_s"], rpm * np.pi / 30)
        assert (read.attrs["start"], read.attrs["state_of_all_seeds"]) == ("rest", "rest")
        assert read.attrs["start_up_s"] == 0.01
        assert float(read["time"][-1]) == pytest.approx(0.02, rel=0.01)  # as much again is measured
        measured = read["slip_power"].where(read["time"] > 0.01).mean() / read.attrs["inner_speed_rad_per_s"]
        np.testing.assert_allclose(measured, torque[point], rtol=0.02)  # of seeds that all rest


def test_without_a_moving_cage_there_are_numbers_and_the_reason(tmp_path: Path) -> None:
    _, lacking = torque_with_files(load_scene("6205-dry"), out=tmp_path / "made")
    assert lacking is not None
    assert "the cage did not move" in lacking
    assert "cage.start is not given" in lacking
    assert {path.name for path in (tmp_path / "made").iterdir()} == ALWAYS | {LISTING}
    content = json.loads((tmp_path / "made" / "torque.json").read_text("utf-8"))
    assert content["cage_motion"] == {"points": [], "lacking": lacking}
    bare = parse_scene(MOVING.partition("[cage]")[0], origin="here")
    assert torque_with_files(bare, out=tmp_path / "bare")[1] is None  # a scene without a cage lacks nothing


def test_where_vtk_cannot_draw_all_else_is_there(tmp_path: Path) -> None:
    """Other ways to fail are those of the pictures of contacts, by the same function."""
    lacking = present(write_torque(torque_of_scene(parse_scene(MOVING, origin="here")), tmp_path, renderer=DIES))
    assert "there is no picture of the cage" in lacking
    assert "signal 6" in lacking
    assert {path.name for path in tmp_path.iterdir()} == ALWAYS | {"1-cage.nc", "1-cage-forces.png"}
    content = json.loads((tmp_path / "torque.json").read_text("utf-8"))["cage_motion"]
    assert content["lacking"] == lacking
    assert content["points"][0]["picture"] is None


def test_nothing_is_left_of_a_folder_that_fails(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(module, "numbers_file", fail)
    with pytest.raises(KeyboardInterrupt):
        torque_with_files(load_scene("6205-dry"), out=tmp_path / "made")
    assert list(tmp_path.iterdir()) == []


def test_what_exists_is_refused_before_anything_is_computed(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "torque_of_scene", None)  # would not be called
    with pytest.raises(InputError, match="exists already"):
        torque_with_files(load_scene("6205-dry"), out=tmp_path)


def test_the_command_says_where_the_folder_is_and_what_it_lacks(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    for flags, said in (((), f"folder: {tmp_path / 'first'}"), (("--json",), '"tolerance"')):
        out = tmp_path / ("second" if flags else "first")
        monkeypatch.setattr("sys.argv", ["fembearing", "torque", "6205-dry", "--out", str(out), *flags])
        with pytest.raises(SystemExit) as stop:
            cli.main()
        captured = capsys.readouterr()
        assert not stop.value.code
        assert said in captured.out
        assert "the cage did not move" in captured.err
        assert (out / "torque.json").is_file()
        if flags:
            json.loads(captured.out)  # nothing else on it


def test_a_torque_without_a_moving_cage_loads_nothing_that_packs_or_renders(tmp_path: Path) -> None:
    """A file of numbers draws nothing either."""
    show = (
        "import sys; from fembearing import cli\n"
        "for out in sys.argv[1:]:\n"
        "    sys.argv = ['fembearing', *'torque 6205-dry --json --out'.split(), out]\n"
        "    try: cli.main()\n"
        "    except SystemExit as stop: assert not stop.code\n"
        "    print(*{name.partition('.')[0] for name in sys.modules}, file=sys.stderr)"
    )
    run = [sys.executable, "-c", show, str(tmp_path / "made.json"), str(tmp_path / "made")]
    said = subprocess.run(run, capture_output=True, check=True, text=True).stderr.splitlines()
    file, folder = (set(line.split()) for line in said if " fembearing " in f" {line} ")
    packing = {"vtk", "vtkmodules", "pyvista", "xarray", "netCDF4"}
    assert {"matplotlib", *packing} & file == set()
    assert {"matplotlib", *packing} & folder == {"matplotlib"}


def test_a_cage_in_a_bearing_at_rest_has_no_series_for_nothing_turns(tmp_path: Path) -> None:
    still = torque_of_scene(parse_scene(MOVING.replace('"500 rpm"', '"0 rpm"'), origin="here"))
    assert present(write_torque(still, tmp_path)).endswith("no series, plot or picture of it: nothing turns")
