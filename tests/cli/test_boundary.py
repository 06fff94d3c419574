"""The outer boundary: whatever fails in a command, there is one line on standard error and a status that says what."""

import errno
import os
import signal
import subprocess
import sys
from asyncio import CancelledError
from pathlib import Path

import pytest

from analytic.errors import ResourceError, StorageError
from fembearing import cli
from fembearing.cli import listing

POSIX = pytest.mark.skipif(os.name == "nt", reason="signals, limits and devices of POSIX")
RUN = f'"{sys.executable}" -m fembearing'


def in_shell(line: str, *, cwd: Path, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        ["bash", "-c", line],
        cwd=cwd,
        # Byte code that a limit cuts short would be kept, and end every later start: Python 3.11 does not look.
        env=os.environ
        | {"PYTHONPATH": str(Path(cli.__file__).parents[2]), "PYTHONDONTWRITEBYTECODE": "1"}
        | environment,
        capture_output=True,
        text=True,
        check=False,
    )


@pytest.mark.parametrize(
    ("problem", "status", "words"),
    [
        (KeyError("left"), 70, ["a defect of fembearing", "KeyError: 'left'", "fembearing/cli/", "docs/commands.md"]),
        (RecursionError("maximum recursion depth exceeded"), 70, ["RecursionError"]),
        (MemoryError("Unable to allocate 3.1 GiB"), 71, ["3.1 GiB", "free some"]),
        (OSError(errno.ENOMEM, "Cannot allocate memory"), 71, ["Cannot allocate memory"]),
        (RuntimeError("can't start new thread"), 71, ["can't start new thread"]),
        (ImportError("libx.so: failed to map segment from shared object"), 71, ["libx.so", "ulimit -v"]),
        (ResourceError("a process ended; free some memory"), 71, ["a process ended"]),
        (StorageError("'a.csv' cannot be written"), 74, ["'a.csv'"]),
        (OSError(errno.EIO, "Input/output error", "/disk/a"), 74, ["'/disk/a'", "Input/output error", "check"]),
        (PermissionError(errno.EACCES, "Permission denied", "a"), 74, ["'a'", "permissions"]),
        (OSError(errno.ENOSPC, "No space left on device"), 74, ["the result", "No space left", "check disk"]),
        (KeyboardInterrupt(), 130, []),
        (CancelledError(), 70, ["a defect of fembearing", "CancelledError"]),  # of asyncio: no Exception
        (TimeoutError("timed out after 5 s"), 74, ["another process", "timed out after 5 s"]),
        (BrokenPipeError(errno.EPIPE, "Broken pipe"), 141, []),
    ],
)
@pytest.mark.parametrize("debug", [False, True])
def test_every_failure_has_its_status_and_one_line(
    monkeypatch: pytest.MonkeyPatch,
    capfd: pytest.CaptureFixture[str],
    problem: BaseException,
    status: int,
    words: list[str],
    debug: bool,
) -> None:
    def fail(*_: object) -> None:
        raise problem

    monkeypatch.setitem(listing.ROWS, "materials", fail)
    monkeypatch.setattr("sys.argv", ["fembearing", *(["--debug"] if debug else []), "list", "materials"])
    saved = os.dup(1)  # a closed pipe is taken away
    try:
        with pytest.raises(SystemExit) as stop:
            cli.main()
    finally:
        os.dup2(saved, 1)
        os.close(saved)
    told = capfd.readouterr().err
    assert stop.value.code == status
    assert all(word in told for word in words), told
    assert ("Traceback" in told) == (debug and status not in (130, 141))  # nothing failed there
    if not debug:
        assert told.count("\n") == (1 if words else 0)


def test_the_statuses_are_in_help_and_page(command) -> None:
    page = (Path(__file__).parents[2] / "docs/commands.md").read_text("utf-8")
    told = " ".join(command("--help").out.split())
    for status in (0, 1, 2, 3, 70, 71, 74, 130, 141, 143):
        assert f"\n| {status} | " in page
        assert f" {status}" in told.partition("Exit status")[2]
    assert "\n## A defect of fembearing\n" in page  # which the line of status 70 names


@POSIX
@pytest.mark.parametrize(
    ("line", "status", "lines"),
    [
        ("list oils > /dev/full", 74, 1),
        ("list oils 0<&- 2>&-", 0, 0),
        ("list nothing 2>/dev/full", 2, 0),
        ("--help > /dev/full", 74, 1),
        ("--help | true; exit ${PIPESTATUS[0]}", 141, 0),
        ("list bearings | true; exit ${PIPESTATUS[0]}", 141, 0),
        ("torque 6205-dry 2>/dev/full", 0, 0),  # its warnings are lost, its result is not
        ("torque 6205-dry --out t.csv 2>&- && grep -q torque_total t.csv", 0, 0),
    ],
)
def test_streams_that_are_closed_or_full(tmp_path: Path, line: str, status: int, lines: int) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    done = in_shell(f"{RUN} {line}", cwd=tmp_path)
    assert (done.returncode, done.stderr.count("\n")) == (status, lines), done.stderr
    assert "Traceback" not in done.stderr


@POSIX
def test_a_working_folder_that_is_gone(tmp_path: Path) -> None:
    lines = [f"{RUN} {rest}; echo $?" for rest in ("list oils >&2", "init 6206 >&2", "torque 6205-dry --out new >&2")]
    done = in_shell(f"mkdir here; cd here; rmdir ../here; {'; '.join(lines)}", cwd=tmp_path)
    assert done.stdout.split() == ["0", "2", "2"]
    assert "Traceback" not in done.stderr
    assert list(tmp_path.iterdir()) == []


@POSIX
def test_a_locale_without_letters_loses_letters_and_nothing_else(tmp_path: Path) -> None:
    """ASCII on every stream, which Python would avoid in the locale C."""
    locale = {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"}
    scene = (tmp_path / "\u00e9.toml").write_text('name = "\u00b5"\nbad = 1\n', "utf-8") and "\u00e9.toml"
    for rest, status in (("list effects", 0), ("torque 6205-dry", 0), (f"torque {scene}", 2)):
        done = in_shell(f"{RUN} {rest}", cwd=tmp_path, **locale)
        assert done.returncode == status, done.stderr
        assert "Traceback" not in done.stderr


@POSIX
@pytest.mark.parametrize(
    "rest",
    ["torque 6205-dry --out t", "contact --level 1 --mesh m", "init 6206 --out s.toml"],  # two folders and a file
)
def test_a_limit_of_file_sizes_leaves_nothing(tmp_path: Path, rest: str) -> None:
    done = in_shell(f"ulimit -f 1; {RUN} {rest}", cwd=tmp_path, FEMBEARING_CACHE=os.environ.get("FEMBEARING_CACHE", ""))
    assert done.returncode == 74, done.stderr
    assert "cannot be written: File too large; raise the limit of file sizes (ulimit -f)" in done.stderr
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


@POSIX
@pytest.mark.parametrize(("number", "status"), [(signal.SIGTERM, 143), (signal.SIGHUP, 129)])
def test_a_process_that_is_asked_to_end_cleans_up(tmp_path: Path, number: signal.Signals, status: int) -> None:
    held = (
        "import signal, sys, time\nfrom pathlib import Path\nfrom fembearing import cli\n"
        f"signal.signal({int(number)}, signal.SIG_DFL)\n"  # nohup ignores it, and so would we
        "def write(*_):\n    print('write', flush=True)\n"
        "    for _ in range(6000):\n        time.sleep(0.01)\n"  # a signal just before a long one waits for it
        "Path.write_text = write\n"
        "sys.argv = ['fembearing', 'init', '6206']\ncli.main()"
    )
    running = subprocess.Popen([sys.executable, "-c", held], cwd=tmp_path, stdout=subprocess.PIPE, text=True)
    try:
        assert running.stdout is not None
        assert running.stdout.readline() == "write\n"
        running.send_signal(number)
        assert running.wait(timeout=30) == status
    finally:
        running.kill()
        running.communicate()
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(("options", "shown"), [("", False), ("-W default", True)])
def test_a_warning_of_a_library_is_shown_to_who_asks_python_for_it(tmp_path: Path, options: str, shown: bool) -> None:
    warn = "import warnings; from fembearing.cli.boundary import guarded\nguarded(lambda: warnings.warn('header'))"
    done = in_shell(f'"{sys.executable}" {options} -c "{warn}"', cwd=tmp_path, PYTHONWARNINGS="")
    assert done.returncode == 0
    assert ("UserWarning: header" in done.stderr) == shown
    assert done.stderr == "" or shown
