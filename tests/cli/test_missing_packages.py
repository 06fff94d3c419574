"""What smaller installations do: the packages that they lack are blocked in a process of its own."""

import csv
import json
import os
import subprocess
import sys
from collections.abc import Collection
from pathlib import Path

import pytest

from analytic.errors import BROUGHT_BY
from fembearing import cli
from tests.analytic.scenefile.scene_texts import MOVING

EXTRAS = [module for module, (_, extra) in BROUGHT_BY.items() if extra]  # lacking in a plain installation
ALL_BUT_TORQUE = [*BROUGHT_BY, "pymklpardiso"]  # lacking where requirements-torque.txt is installed alone
SCENE = """\
name = "small"
tolerance = "5 %"
[bearing]
catalog = "6205"
[operation]
axial_load = "600 N"
inner_speed = "300 rpm"
[friction]
coefficient = 0.05
"""
GRID = 'scene = "6205-dry"\n[axes]\noperation.axial_load = ["200 N", "600 N"]\n'


def without(modules: Collection[str], code: str, *arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    """Run Python where none of the modules can be imported."""
    block = f"import sys; sys.modules.update(dict.fromkeys({list(modules)}))\n"
    environment = os.environ | {"PYTHONPATH": str(Path(cli.__file__).parents[2])}
    return subprocess.run(
        [sys.executable, "-c", block + code, *arguments],
        cwd=cwd,
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )


def command_without(modules: Collection[str], *arguments: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    """Run a command of ours there."""
    code = "sys.argv[0] = 'fembearing'; from fembearing.cli import main; main()"
    return without(modules, code, *arguments, cwd=cwd)


@pytest.mark.parametrize("lacking", [EXTRAS, ALL_BUT_TORQUE], ids=["plain", "torque"])
def test_a_torque_needs_no_extra_and_no_finite_elements(lacking: list[str], tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(SCENE, "utf-8")
    told = command_without(lacking, "torque", "s.toml", "--json", "--interval", "--samples", "64", cwd=tmp_path)
    assert told.returncode in (0, 1, 3), told.stderr
    (interval,), (point,) = (json.loads(told.stdout)[key] for key in ("interval", "points"))
    assert interval[0] < (total := point["torque"]["total"]) < interval[1]
    done = command_without(lacking, "torque", "s.toml", "--out", "t.csv", cwd=tmp_path)
    assert done.returncode == told.returncode, done.stderr
    (row,) = csv.DictReader((tmp_path / "t.csv").read_text("utf-8").splitlines())
    assert float(row["torque_total [N mm]"]) == pytest.approx(total * 1e3, rel=1e-14)  # 15 digits are written
    code = "import analytic; print(analytic.friction_torque(analytic.load_scene('s.toml')).torque.total[0])"
    assert float(without(lacking, code, cwd=tmp_path).stdout) == total


def test_a_plain_installation_checks_contacts(tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(SCENE, "utf-8")
    done = command_without(EXTRAS, "validate", "s.toml", "--no-film", "--no-creep", "--json", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout)["verdict"]["overall"] == "pass"


@pytest.mark.parametrize(
    ("lacking", "line", "words"),
    [
        (EXTRAS, "sweep grid.toml --out new", 'sweep needs dask: pip install "fembearing[sweep]"'),
        (["netCDF4"], "sweep grid.toml --out new", 'sweep needs netCDF4: pip install "fembearing[sweep]"'),
        (ALL_BUT_TORQUE, "validate 6205-dry --out new", "validate needs scikit-fem: pip install fembearing"),
        (ALL_BUT_TORQUE, "contact 6205-dry --pair inner", "contact needs scikit-fem: pip install fembearing"),
        (ALL_BUT_TORQUE, "mesh 6205-dry --out new", "mesh needs scikit-fem: pip install fembearing"),
        (ALL_BUT_TORQUE, "torque 6205-dry --out new", "--out 'new' needs matplotlib: pip install fembearing"),
        (ALL_BUT_TORQUE, "torque 6205-dry --out new.html", "--out 'new.html' needs matplotlib: pip install fembearing"),
    ],
)
def test_what_lacks_a_package_says_in_one_line_how_to_install_it(
    lacking: list[str], line: str, words: str, tmp_path: Path
) -> None:
    (tmp_path / "grid.toml").write_text(GRID, "utf-8")
    done = command_without(lacking, *line.split(), cwd=tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (2, "", f"fembearing: {words}\n")
    assert [path.name for path in tmp_path.iterdir()] == ["grid.toml"]  # nothing is left


def test_python_says_it_too(tmp_path: Path) -> None:
    code = "import analytic, fembearing\n{}"
    datasets = "analytic.friction_torque(analytic.load_scene('6205-dry')).to_dataset()"
    for lacking, call, words in (
        (EXTRAS, datasets, 'a dataset needs xarray: pip install "fembearing[sweep]"'),
        (EXTRAS, "fembearing.run_sweep('g.toml', out='o')", 'sweep needs dask: pip install "fembearing[sweep]"'),
        (ALL_BUT_TORQUE, "fembearing.validate", "fembearing.validate needs scikit-fem: pip install fembearing"),
    ):
        done = without(lacking, code.format(call), cwd=tmp_path)
        assert done.stderr.splitlines()[-1] == f"analytic.errors.MissingPackageError: {words}"


def test_a_folder_without_netcdf_says_that_the_series_of_the_cage_is_missing(tmp_path: Path) -> None:
    (tmp_path / "s.toml").write_text(MOVING, "utf-8")
    done = command_without(EXTRAS, "torque", "s.toml", "--out", "new", cwd=tmp_path)
    lacking = 'there is no series of the cage\'s motion: it needs xarray: pip install "fembearing[sweep]"'
    assert lacking in done.stderr
    assert {"1-cage.png", "1-cage-forces.png", "torque.json"} < {path.name for path in (tmp_path / "new").iterdir()}
    motion = json.loads((tmp_path / "new/torque.json").read_text("utf-8"))["cage_motion"]
    assert motion["points"][0]["series"] is None
    assert motion["lacking"] == lacking
