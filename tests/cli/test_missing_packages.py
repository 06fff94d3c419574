"""What smaller installations do: the packages that they lack are blocked in a process of its own.

A process costs a second or two before its first command: each installation has one for all that is asked of it.
"""

import csv
import json
import os
import subprocess
import sys
from pathlib import Path
from typing import NamedTuple

import pytest

from analytic.errors import BROUGHT_BY
from fembearing import cli
from tests.analytic.scenefile.scene_texts import MOVING

EXTRAS = [module for module, (_, extra) in BROUGHT_BY.items() if extra != "check"]
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


RUNS = """
import contextlib, io, json, os, traceback
from pathlib import Path
from fembearing.cli import main

def command(line):
    sys.argv = ["fembearing", *line.split()]
    try:
        main()
    except SystemExit as stop:
        return stop.code or 0

def answer(number, line):
    out, err, status = io.StringIO(), io.StringIO(), 0
    Path(f"{number}").mkdir()
    os.chdir(f"{number}")
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
        try:
            status = exec(line, {}) or 0 if "import" in line else command(line)
        except Exception:
            traceback.print_exc()
            status = 1
    left = sorted(path.name for path in Path().rglob("*"))
    os.chdir("..")
    return status, out.getvalue(), err.getvalue(), left

given = json.loads(sys.stdin.read())
print(json.dumps([answer(number, line) for number, line in enumerate(given)]))
"""


class Answer(NamedTuple):
    status: int
    out: str
    err: str
    left: list[str]  # names of the files that were written


HOW = 'pip install ".[{}]" in the folder of fembearing'
SWEEP = f"sweep needs {{}}: {HOW.format('sweep')}"
THREADS, SOLVER = (f"{{}} needs {each}: {HOW.format('check')}" for each in ("threadpoolctl", "scikit-fem"))
PICTURES = f"--out {{!r}} needs matplotlib: {HOW.format('check')}"
REFUSED = {  # by installation: what lacks a package, with what it says
    "plain": {
        "sweep ../grid.toml --out new": SWEEP.format("xarray"),
        "import fembearing; fembearing.run_sweep('g.toml', out='o')": SWEEP.format("xarray"),
        "import analytic; analytic.friction_torque(analytic.load_scene('6205-dry')).to_dataset()": (
            f"a dataset needs xarray: {HOW.format('sweep')}"
        ),
    },
    "netCDF4": {"sweep ../grid.toml --out new": SWEEP.format("netCDF4")},
    "torque": {
        "validate 6205-dry --out new": THREADS.format("validate"),
        "contact 6205-dry --pair inner": THREADS.format("contact"),
        "contact 6205-dry --mesh new": SOLVER.format("contact"),
        "import fembearing; fembearing.validate": THREADS.format("fembearing.validate"),
        "torque ../rig.xlsx": f"../rig.xlsx needs openpyxl: {HOW.format('check')}",
        "torque 6205-dry --out new": PICTURES.format("new"),
        "torque 6205-dry --out new.html": PICTURES.format("new.html"),
    },
}
TORQUES = [
    "torque ../s.toml --json --interval --samples 64",
    "torque ../s.toml --out t.csv",
    "import analytic; print(analytic.friction_torque(analytic.load_scene('../s.toml')).torque.total[0])",
]
CHECK = "validate ../s.toml --no-film --no-creep --tolerance 90% --json"  # on the coarsest meshes
CAGE = "torque ../moving.toml --out new"
LACKING = {"plain": EXTRAS, "netCDF4": ["netCDF4"], "torque": [*BROUGHT_BY, "pymklpardiso"]}
POSSIBLE = {"plain": [*TORQUES, CHECK, CAGE], "netCDF4": [], "torque": TORQUES}


class Installation(NamedTuple):
    name: str
    folder: Path
    answers: dict[str, Answer]  # by what was asked

    def folder_of(self, line: str) -> Path:
        return self.folder / str(list(self.answers).index(line))


@pytest.fixture(scope="module", params=REFUSED)
def installation(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Installation:
    """Commands of ours, and Python that imports, each in a new folder, where none of the modules can be imported."""
    name, folder = request.param, tmp_path_factory.mktemp(request.param)
    for file, text in (("s.toml", SCENE), ("moving.toml", MOVING), ("grid.toml", GRID), ("rig.xlsx", "PK\3\4")):
        (folder / file).write_text(text, "utf-8")
    lines = [*REFUSED[name], *POSSIBLE[name]]
    done = subprocess.run(
        [sys.executable, "-c", f"import sys; sys.modules.update(dict.fromkeys({LACKING[name]}))\n{RUNS}"],
        cwd=folder,
        env=os.environ | {"PYTHONPATH": str(Path(cli.__file__).parents[2])},
        input=json.dumps(lines),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    answers = (Answer(*each) for each in json.loads(done.stdout))
    return Installation(name, folder, dict(zip(lines, answers, strict=True)))


PLAIN = pytest.mark.parametrize("installation", ["plain"], indirect=True)


@pytest.mark.parametrize("installation", ["plain", "torque"], indirect=True)
def test_a_torque_needs_no_extra_and_no_finite_elements(installation: Installation) -> None:
    told, done, python = (installation.answers[line] for line in TORQUES)
    assert told.status in (0, 1, 3), told.err
    (point,) = json.loads(told.out)["points"]
    assert point["interval_low"] < (total := point["torque_total"]) < point["interval_high"]
    assert done.status == told.status, done.err
    table = installation.folder_of(TORQUES[1]) / "t.csv"
    (row,) = csv.DictReader(table.read_text("utf-8").splitlines())
    assert float(row["torque_total [N mm]"]) == pytest.approx(total * 1e3, rel=1e-14)  # 15 digits are written
    assert float(python.out) == total


@PLAIN
def test_a_plain_installation_checks_contacts(installation: Installation) -> None:
    done = installation.answers[CHECK]
    assert done.status == 0, done.err
    assert json.loads(done.out)["verdict"]["overall"] == "pass"


def test_what_lacks_a_package_says_in_one_line_how_to_install_it(installation: Installation) -> None:
    for line, words in REFUSED[installation.name].items():
        answer = installation.answers[line]
        if "import" in line:
            assert answer.err.splitlines()[-1] == f"analytic.errors.MissingPackageError: {words}"
        else:
            assert answer == (2, "", f"fembearing: {words}\n", [])  # nothing is left


@PLAIN
def test_a_folder_without_netcdf_says_that_the_series_of_the_cage_is_missing(installation: Installation) -> None:
    done, folder = installation.answers[CAGE], installation.folder_of(CAGE) / "new"
    lacking = f"there is no series of the cage's motion: it needs xarray: {HOW.format('sweep')}"
    assert lacking in done.err
    assert {"1-cage.png", "1-cage-forces.png", "torque.json"} < {path.name for path in folder.iterdir()}
    motion = json.loads((folder / "torque.json").read_text("utf-8"))["cage_motion"]
    assert motion["points"][0]["series"] is None
    assert motion["lacking"] == lacking
