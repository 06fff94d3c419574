"""A tree of the project, this one or that of an earlier commit, and what is measured in it. Standard library only."""

import json
import os
import resource
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import IO, Any

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[1]
PACKAGES = ("analytic", "fembearing")
LIMIT = 3600.0  # s, for one answer
ONE_THREAD = {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
BYTE_CODE = {"PYTHONDONTWRITEBYTECODE": ""}  # it is kept, as that of an installed package
COMMAND = ("-c", "from fembearing.cli import main; main()")


class CommitMissingError(Exception):
    """The history does not have a commit."""


@dataclass(frozen=True, kw_only=True)
class Sample:
    """One measurement, seconds."""

    wall: float
    cpu: float
    result: float | None = None
    note: str = ""


class FailedError(Exception):
    """A tree cannot do a job."""


class Tree:
    """A folder with the packages, and the process that measures in it.

    folder : absolute
    """

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self._server: subprocess.Popen[str] | None = None

    def close(self) -> None:
        _end(self._server)

    def job(self, name: str, *, fresh: bool = False) -> Sample:
        """Measure a job of `jobs.py`. Raises FailedError.

        fresh : in a process of its own
        """
        server = self._server
        if fresh or server is None or server.poll() is not None:
            server = self._start()
        if not fresh:
            self._server = server
        try:
            return self._asked(server, name)
        finally:
            if fresh:
                _end(server)

    def command(self, *arguments: str, python: bool = False, threads: bool = False) -> Sample:
        """Measure a whole process: of fembearing, or of Python. Raises FailedError.

        threads : whether it may use as many as it likes
        """
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        with tempfile.TemporaryDirectory() as folder:
            started = time.perf_counter()
            try:
                done = subprocess.run(
                    [sys.executable, *(() if python else COMMAND), *arguments],
                    cwd=folder,
                    env=self._environment(threads=threads),
                    capture_output=True,
                    text=True,
                    timeout=LIMIT,
                )
            except subprocess.TimeoutExpired as problem:
                raise FailedError(f"no answer within {LIMIT:g} s") from problem
            wall = time.perf_counter() - started
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if done.returncode:
            raise FailedError(f"status {done.returncode}: {_last_line(done.stderr)}")
        return Sample(wall=wall, cpu=after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime)

    def _environment(self, *, threads: bool = False) -> dict[str, str]:
        return os.environ | {"PYTHONPATH": str(self.folder)} | BYTE_CODE | ({} if threads else ONE_THREAD)

    def _start(self) -> subprocess.Popen[str]:
        return subprocess.Popen(
            [sys.executable, "-P", str(HERE / "jobs.py"), str(self.folder)],
            cwd=tempfile.gettempdir(),
            env=self._environment(),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )

    def _asked(self, server: subprocess.Popen[str], name: str) -> Sample:
        clock = threading.Timer(LIMIT, server.kill)
        clock.start()
        try:
            _pipe(server.stdin).write(name + "\n")
            _pipe(server.stdin).flush()
            line = _pipe(server.stdout).readline()
        except BrokenPipeError:
            line = ""
        finally:
            clock.cancel()
        if not line:
            raise FailedError(f"its process ended with status {server.wait()}")
        answer: dict[str, Any] = json.loads(line)
        if "failed" in answer:
            raise FailedError(answer["failed"])
        return Sample(**answer)


def _pipe(pipe: IO[str] | None) -> IO[str]:
    assert pipe is not None
    return pipe


def _end(server: subprocess.Popen[str] | None) -> None:
    if server is not None:
        server.kill()
        server.communicate()


def _last_line(text: str) -> str:
    return (text.strip().splitlines() or ["no message"])[-1]


@contextmanager
def checked_out(commit: str, *, root: Path = ROOT) -> Iterator[Path]:
    """A temporary worktree of a commit. Raises CommitMissingError."""
    if _git(root, "cat-file", "-e", f"{commit}^{{commit}}") is None:
        raise CommitMissingError(f"commit {commit[:9]} is not in this clone; `git fetch --unshallow` brings it")
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place).resolve() / "tree"
        if _git(root, "worktree", "add", "--detach", str(folder), commit) is None:
            raise CommitMissingError(f"commit {commit[:9]} cannot be checked out beside this tree")
        try:
            yield folder
        finally:
            _git(root, "worktree", "remove", "--force", str(folder))


def last_change(*, root: Path = ROOT) -> str | None:
    """The last commit that changed the packages; None where they differ from it, or without git."""
    status = _git(root, "status", "--porcelain", "--", *PACKAGES)
    return None if status is None or status else _git(root, "log", "-1", "--format=%H", "--", *PACKAGES)


def _git(root: Path, *arguments: str) -> str | None:
    """What git prints; None where it fails or is missing."""
    try:
        done = subprocess.run(["git", "-C", str(root), *arguments], capture_output=True, text=True)
    except OSError:
        return None
    return None if done.returncode else done.stdout.strip()
