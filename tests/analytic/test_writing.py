"""Files and folders that are made in named steps: stopped at any of them, they are whole or not there."""

import errno
import os
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

import pytest

from analytic import writing
from analytic.errors import InputError, StorageError

STOPPED = """
import os, signal, sys
from pathlib import Path
from analytic import writing

where, what, target = sys.argv[1], sys.argv[2], Path(sys.argv[3])

def at_step(step, path):
    if step == where:
        os.kill(os.getpid(), signal.SIGKILL)

writing.at_step = at_step
if what == "folder":
    with writing.new_folder(target) as folder:
        writing.write(folder / "a.txt", "whole")
        writing.write(folder / "b.txt", "whole")
else:
    with (writing.new_file if what == "file" else writing.replaced_file)(target) as file:
        file.write_text("whole")
"""  # the program that a test kills at a step of its write
POSIX = pytest.mark.skipif(os.name == "nt", reason="locks and signals of POSIX")


def stopped(where: str, what: str, target: Path) -> int:
    return subprocess.run([sys.executable, "-c", STOPPED, where, what, str(target)], check=False).returncode


@POSIX
@pytest.mark.parametrize("what", ["folder", "file", "replaced"])
@pytest.mark.parametrize("where", ["make", "write", "written", "rename", "renamed"])
def test_a_process_killed_at_any_step_leaves_all_or_nothing_once_another_has_run(
    tmp_path: Path, where: str, what: str
) -> None:
    target = tmp_path / "made"
    if what == "replaced":
        target.write_text("before")
    assert stopped(where, what, target) == -signal.SIGKILL
    if where == "renamed":
        read = {path.name: path.read_text() for path in target.iterdir()} if what == "folder" else target.read_text()
        assert read == (
            {"a.txt": "whole", "b.txt": "whole", ".fembearing": "a.txt\nb.txt\n"} if what == "folder" else "whole"
        )
    elif what == "replaced":
        assert target.read_text() == "before"
    else:
        assert not target.exists()
    with writing.new_file(tmp_path / "next"):
        pass
    assert {path.name for path in tmp_path.iterdir()} <= {"made", "next"}


@POSIX
def test_what_a_living_process_makes_is_left_alone_and_so_is_what_is_not_ours(tmp_path: Path) -> None:
    wait = STOPPED.replace("os.kill(os.getpid(), signal.SIGKILL)", "sys.stdin.read()")
    running = subprocess.Popen(
        [sys.executable, "-c", wait, "rename", "folder", str(tmp_path / "made")], stdin=subprocess.PIPE
    )
    try:
        while not list(tmp_path.glob(".fembearing-*/made/b.txt")):
            time.sleep(0.01)
        (tmp_path / ".fembearing-mine").mkdir()
        before = set(tmp_path.iterdir())
        writing.remove_leftovers(tmp_path)
        assert set(tmp_path.iterdir()) == before
    finally:
        running.communicate()
    assert running.returncode == 0
    assert sorted(path.name for path in (tmp_path / "made").iterdir()) == [".fembearing", "a.txt", "b.txt"]


@pytest.mark.parametrize(
    ("number", "kind", "words"),
    [
        (errno.ENOSPC, StorageError, "free some space"),
        (errno.EFBIG, StorageError, "ulimit -f"),
        (errno.EIO, StorageError, "Input/output error"),
        (errno.EROFS, InputError, "a folder that you may write"),
        (errno.ENAMETOOLONG, InputError, "File name too long"),
    ],
)
def test_a_disk_that_fails_is_not_a_wrong_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, kind: type[Exception], words: str
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(Path, "mkdir", fail)
    with pytest.raises(kind, match=words), writing.new_folder(tmp_path / "made"):
        pass
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("at", ["write", "written", "rename"])
def test_a_full_disk_at_any_write_leaves_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, at: str) -> None:
    def full(step: str, path: Path) -> None:
        if step == at and path.name in ("b.txt", "made"):
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    def both() -> None:
        with writing.new_folder(tmp_path / "made") as folder:
            writing.write(folder / "a.txt", b"\x00\xff")
            writing.write(folder / "b.txt", "umlaut \u00e4")

    monkeypatch.setattr(writing, "at_step", full)
    with pytest.raises(StorageError, match="cannot be written: No space left on device; free some space"):
        both()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("stop", [KeyboardInterrupt(), SystemExit(143), OSError(errno.ENOSPC, "full")])
def test_a_signal_before_the_scratch_is_removed_does_not_leave_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, stop: BaseException
) -> None:
    def stopped(step: str, _: Path) -> None:
        if step == "remove":
            raise stop

    monkeypatch.setattr(writing, "at_step", stopped)
    ended = suppress(OSError) if isinstance(stop, OSError) else pytest.raises(type(stop))
    with ended, writing.new_folder(tmp_path / "made") as folder:
        writing.write(folder / "a.txt", "a")
    assert [path.name for path in tmp_path.iterdir()] == ["made"]


def test_what_is_written_is_what_is_read(tmp_path: Path) -> None:
    steps: list[tuple[str, str]] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(writing, "at_step", lambda step, path: steps.append((step, path.name)))
        with writing.new_folder(tmp_path / "made") as folder:
            writing.write(folder / "a.bin", b"\x00\r\n\xff")
            writing.write(folder / "b.txt", "1 \u00b5m\n")
    assert (tmp_path / "made/a.bin").read_bytes() == b"\x00\r\n\xff"
    assert (tmp_path / "made/b.txt").read_bytes() == "1 \u00b5m\n".encode()  # no system's own line ends
    hidden = steps[0][1]
    assert hidden.startswith(".fembearing-")
    inside = [(step, name) for name in ("a.bin", "b.txt", ".fembearing") for step in ("write", "written")]
    assert steps == [("make", hidden), *inside, ("rename", "made"), ("renamed", "made"), ("remove", hidden)]


def test_a_removed_folder_is_never_half_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder = tmp_path / "maps"
    folder.mkdir()
    for name in ("a.png", "b.png"):
        (folder / name).touch()
    seen: dict[str, bool] = {}
    monkeypatch.setattr(writing, "at_step", lambda step, _: seen.update({step: folder.exists()}))
    writing.remove_whole(folder)
    assert seen == {"rename": True, "renamed": False, "remove": False}
    assert list(tmp_path.iterdir()) == []


@POSIX
@pytest.mark.parametrize("where", ["make", "write", "written", "rename", "renamed"])
def test_a_folder_that_is_replaced_is_the_old_or_the_new_one_wherever_the_process_is_killed(
    tmp_path: Path, where: str
) -> None:
    target = tmp_path / "made"
    with writing.new_folder(target) as folder:
        writing.write(folder / "old.txt", "old")
    forced = STOPPED.replace("writing.at_step = at_step", "writing.at_step = at_step\nwriting.REPLACES.set(True)")
    given = [sys.executable, "-c", forced, where, "folder", str(target)]
    assert subprocess.run(given, check=False).returncode == -signal.SIGKILL
    names = {path.name for path in target.iterdir()}
    assert names == ({".fembearing", "a.txt", "b.txt"} if where == "renamed" else {".fembearing", "old.txt"})


def test_a_folder_comes_back_if_the_new_one_cannot_take_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with writing.new_folder(tmp_path / "made") as folder:
        writing.write(folder / "old.txt", "old")
    rename = Path.rename

    def fails_once(self: Path, target: Path) -> Path:
        if self.parent.name.startswith(".fembearing-"):
            raise OSError(errno.EIO, os.strerror(errno.EIO))
        return rename(self, target)

    before = writing.REPLACES.set(True)
    monkeypatch.setattr(Path, "rename", fails_once)
    with pytest.raises(StorageError), writing.new_folder(tmp_path / "made") as folder:
        (folder / "new.txt").touch()
    writing.REPLACES.reset(before)
    assert [path.name for path in tmp_path.iterdir()] == ["made"]
    assert (tmp_path / "made" / "old.txt").read_text() == "old"
