"""What no process of ours does: run what lies in the working folder, which may be a folder of others' files."""

import operator
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest

from analytic.numerics.machine_code import build_process
from analytic.processes import MODULE, environment
from fembearing.app.check import Check
from fembearing.report.pictures.draw import RENDERER, rendered
from fembearing.sweep.cluster import each_done


def check(_: Path) -> None:
    """Of the page: a scene that is none."""
    started = Check(text="no scene")
    started.start()
    end = time.monotonic() + 100  # s; it takes two
    while not started.has_ended and time.monotonic() < end:
        started.look()
        time.sleep(0.05)
    started.close()
    assert "defect" not in started.problem
    assert "status" not in started.problem


STARTS = {
    "sweep": lambda _: list(each_done(operator.neg, [7], workers=1)),
    "pictures": lambda _: rendered([], RENDERER),
    "compiler": lambda folder: build_process([], [], folder).wait(),
    "check of the page": check,
}


@pytest.mark.parametrize("start", STARTS)
def test_a_file_in_the_working_folder_is_not_imported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, start: str
) -> None:
    others, mine = tmp_path / "others", tmp_path / "mine"
    others.mkdir()
    mine.mkdir()
    for name in ("analytic", "fembearing", "multiprocessing", "numba", "numpy", "pickle", "pyvista", "json", "runpy"):
        (others / f"{name}.py").write_text(f"open({str(mine / name)!r}, 'w')", "utf-8")
    monkeypatch.chdir(others)
    monkeypatch.setattr(sys, "path", [each for each in sys.path if each])
    STARTS[start](mine)
    assert [*mine.iterdir()] == []


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no pipes in folders")
def test_settings_of_pictures_in_the_working_folder_are_not_read(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They could have LaTeX run. A pipe would be waited for."""
    monkeypatch.chdir(tmp_path)
    os.mkfifo("matplotlibrc")
    command = [*MODULE, "fembearing", "draw", "6205-dry", "--out", "new.svg"]
    done = subprocess.run(command, env=environment(), capture_output=True, text=True, timeout=100)
    assert done.returncode == 0, done.stderr
    assert rendered([], RENDERER) is None
