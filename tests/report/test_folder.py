"""The report's folder: whole or not at all, and refused before anything is computed."""

import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import pytest

from analytic.errors import InputError
from analytic.scenefile.read import load_scene
from analytic.writing import LISTING, new_folder
from fembearing.check.validation import Validation
from fembearing.cli.boundary import end
from fembearing.plain_types import plain
from fembearing.report import folder as module
from fembearing.report.figures import page_plots
from fembearing.report.folder import validate
from fembearing.report.pictures import draw as pictures
from fembearing.report.report import report_of

BROKEN = ("/nowhere/python",)  # a renderer that draws nothing


@pytest.fixture
def solved(checked: Validation, monkeypatch: pytest.MonkeyPatch) -> Validation:
    """One race of the built-in scene, already solved; a page without plots, which take seconds."""
    short = replace(checked, contacts=checked.contacts[:1], creep=())
    monkeypatch.setattr(module, "check_scene", lambda *_, **__: short)
    monkeypatch.setattr(page_plots, "PLOTS", ())
    return short


def test_a_report_holds_page_numbers_pictures_and_meshes(solved: Validation, tmp_path: Path) -> None:
    out = tmp_path / "report"
    steps: list[tuple[float, str]] = []
    validate(solved.scene, out=out, progress=lambda share, step: steps.append((share, step)))
    names = {path.name for path in out.iterdir()}
    made = {f"inner-real-{part}" for part in ("upper.vtu", "lower.vtu", "pressure.png", "section.png", "view.html")}
    assert names == made | {"report.html", "report.json", "cost.csv", LISTING}
    assert [path.name for path in tmp_path.iterdir()] == ["report"]  # nothing beside it
    content = json.loads((out / "report.json").read_text("utf-8"))
    assert content["contacts"] == plain(report_of(solved).contacts)
    assert {picture["file"] for picture in content["pictures"]} <= names
    assert [step for _, step in steps] == ["report"]


def test_the_folder_is_open_to_those_whom_the_umask_lets_in(tmp_path: Path) -> None:
    old = os.umask(0o027)
    try:
        with new_folder(tmp_path / "new"):
            pass
    finally:
        os.umask(old)
    assert stat.S_IMODE((tmp_path / "new").stat().st_mode) == 0o750


@pytest.mark.parametrize("kind", ["folder", "file", "dangling link", "no folder above", "a file above"])
def test_a_folder_that_cannot_be_made_is_refused_before_anything_is_computed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    monkeypatch.setattr(module, "check_scene", None)  # would not be called
    out = tmp_path / "there"
    if kind == "folder":
        out.mkdir()
    elif kind in ("file", "a file above"):
        out.write_text("mine")
    elif kind == "dangling link":
        out.symlink_to(tmp_path / "nowhere")
    before = [*tmp_path.iterdir()]
    above = kind.endswith("above")
    with pytest.raises(InputError, match="cannot be made in" if above else r"there.* exists already") as refusal:
        validate(load_scene("6205-dry"), out=out / "report" if above else out)
    assert "\n" not in str(refusal.value)
    assert [*tmp_path.iterdir()] == before


@pytest.mark.parametrize("where", ["check_scene", "report_page"])
def test_nothing_is_left_of_a_report_that_fails(
    solved: Validation, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, where: str
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(pictures.draw_pictures, "__kwdefaults__", {"renderer": BROKEN})
    monkeypatch.setattr(module, where, fail)
    with pytest.raises(KeyboardInterrupt):
        validate(solved.scene, out=tmp_path / "report")
    assert list(tmp_path.iterdir()) == []


def test_a_folder_made_meanwhile_is_kept(tmp_path: Path) -> None:
    out = tmp_path / "report"

    def race() -> None:
        with new_folder(out) as place:
            (place / "ours").write_text("ours")
            out.mkdir()
            (out / "theirs").write_text("theirs")

    with pytest.raises(InputError, match="exists already"):
        race()
    assert [path.name for path in out.iterdir()] == ["theirs"]
    assert [path.name for path in tmp_path.iterdir()] == ["report"]


def test_without_a_renderer_one_warning_says_why_and_there_are_no_pictures(
    solved: Validation, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(pictures.draw_pictures, "__kwdefaults__", {"renderer": BROKEN})
    result = validate(solved.scene, out=tmp_path / "report")
    assert "no pictures of contacts and friction: the renderer could not be started" in result.warnings[-1]
    content = json.loads((tmp_path / "report" / "report.json").read_text("utf-8"))
    assert content["warnings"] == list(result.warnings)
    assert content["pictures"] == []
    assert not list((tmp_path / "report").glob("*.png"))
    assert "<img" not in (tmp_path / "report" / "report.html").read_text("utf-8")


@pytest.mark.skipif(os.name == "nt", reason="Windows ends a process without a signal")
def test_a_second_signal_does_not_stop_the_clearing_up(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The first is an exception; the second comes while the folder is removed."""
    remove = shutil.rmtree

    def signalled(*given: object, **how: object) -> None:
        os.kill(os.getpid(), signal.SIGTERM)
        remove(*given, **how)  # pyright: ignore[reportArgumentType, reportCallIssue]

    monkeypatch.setattr(shutil, "rmtree", signalled)
    before = signal.signal(signal.SIGTERM, end)
    try:
        with pytest.raises(SystemExit), new_folder(tmp_path / "report"):
            os.kill(os.getpid(), signal.SIGTERM)
    finally:
        signal.signal(signal.SIGTERM, before)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="Windows ends a process without a signal")
def test_a_signal_as_the_folder_is_made_leaves_nothing(tmp_path: Path) -> None:
    """It comes before any block that clears up is entered."""
    program = """
import os, signal, sys
from pathlib import Path
from analytic.writing import new_folder
from fembearing.cli.boundary import end
signal.signal(signal.SIGTERM, end)
make = os.mkdir
def mkdir(*given, **how):
    make(*given, **how)
    os.kill(os.getpid(), signal.SIGTERM)
os.mkdir = mkdir
with new_folder(Path(sys.argv[1])):
    pass
"""
    run = subprocess.run([sys.executable, "-c", program, str(tmp_path / "report")])
    assert run.returncode == 143
    assert list(tmp_path.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="Windows ends a process without a signal")
def test_a_process_that_is_told_to_end_leaves_nothing(tmp_path: Path) -> None:
    run = subprocess.Popen([sys.executable, "-m", "fembearing", "validate", "--out", str(tmp_path / "report")])
    try:
        for _ in range(600):  # the folder is there before anything is computed
            if list(tmp_path.iterdir()):
                break
            time.sleep(0.1)
        assert list(tmp_path.iterdir())
        run.terminate()
        assert run.wait(timeout=30) == 143
    finally:
        run.kill()
    assert list(tmp_path.iterdir()) == []
