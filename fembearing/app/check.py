"""The check of a scene in a process of its own, which the page can end: `fembearing.validate` with its report."""

import multiprocessing
import os
import secrets
import signal
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing.connection import Connection
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from analytic.errors import FembearingError
from analytic.processes import ignore_settings
from analytic.writing import new_folder
from fembearing.app.scene_edit import ORIGIN

if TYPE_CHECKING:
    from fembearing.report.report import Report

SPAWNED = multiprocessing.get_context("spawn")  # a fork would copy threads and locks of the server
PATIENCE = 5.0  # s that a killed process has to be gone
GROUPED = hasattr(os, "killpg")  # whether the system ends a process with those that it started
CHECKS: "dict[str, Check]" = {}  # by their tokens, from start to close: those whose files are served


@dataclass(kw_only=True, eq=False)
class Check:
    """A check that waits, runs or has ended; `close` ends it and removes its files."""

    text: str  # of the scene
    share: float = 0.0  # that is done, 0 to 1
    step: str = "waits for the check of another tab"
    problem: str = ""  # why there is no report; empty: none so far
    report: "Report | None" = None  # what is written
    token: str = field(default_factory=lambda: secrets.token_urlsafe(16))  # in the addresses of its files
    _room: TemporaryDirectory[str] = field(default_factory=lambda: TemporaryDirectory(prefix="fembearing-app-"))
    _process: Any = None
    _told: Connection | None = None

    @property
    def folder(self) -> Path:
        """Of the report, once it is done."""
        return Path(self._room.name) / "report"

    @property
    def is_done(self) -> bool:
        """Whether the report is written."""
        return self.report is not None

    @property
    def has_ended(self) -> bool:
        """Whether there is a report, or a reason for which there is none."""
        return self.is_done or bool(self.problem)

    def start(self) -> None:
        """Start the process."""
        CHECKS[self.token] = self
        self._told, tells = SPAWNED.Pipe(duplex=False)
        os.environ["PYTHONSAFEPATH"] = "1"  # else the process would import what lies in the working folder
        self._process = SPAWNED.Process(target=run, args=(self.text, str(self.folder), tells), daemon=True)
        self._process.start()
        tells.close()

    def look(self) -> None:
        """Take what the process has told since."""
        assert self._told is not None, "it was started"
        is_gone = not self._process.is_alive()  # before the pipe is read: nothing comes after
        with suppress(EOFError, OSError):
            while self._told.poll():
                self.share, self.step, self.problem, self.report = self._told.recv()
        if is_gone and not self.has_ended:
            self.problem = f"the process of the check ended with status {self._process.exitcode}; start it again"

    def close(self) -> None:
        """End the process with those that it started, and remove the files."""
        CHECKS.pop(self.token, None)
        if self._process is not None and self._process.is_alive():
            with suppress(OSError):
                if GROUPED and os.getpgid(self._process.pid) == self._process.pid:
                    os.killpg(self._process.pid, signal.SIGKILL)
                else:
                    self._process.kill()
            self._process.join(PATIENCE)
        if self._told is not None:
            self._told.close()
        self._room.cleanup()


def run(text: str, folder: str, tells: Connection) -> None:
    """Check the scene, and tell (share, step, problem, report). The process of a `Check` runs it."""
    if GROUPED:
        os.setpgid(0, 0)  # so that the process that draws the pictures ends with it
    ignore_settings()
    try:
        from analytic import steady_scene
        from analytic.scenefile.read import parse_by_temperature
        from fembearing.check.validation import check_scene
        from fembearing.report.folder import CHECKED, write_report

        scene = steady_scene(parse_by_temperature(text, origin=ORIGIN))
        with new_folder(Path(folder), force=False) as made:
            result = check_scene(scene, progress=lambda share, step: tells.send((CHECKED * share, step, "", None)))
            tells.send((CHECKED, "report", "", None))
            _, report = write_report(result, made)
    except FembearingError as problem:
        tells.send((0.0, "", str(problem), None))
    except Exception as problem:  # the page says it; a traceback would go to the terminal of the server
        words = f"a defect of fembearing, not of your input: {type(problem).__name__}: {problem}; please report it"
        tells.send((0.0, "", words, None))
    else:
        tells.send((1.0, "checked", "", report))
