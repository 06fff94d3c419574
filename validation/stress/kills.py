"""Commands that are killed at named steps of their writing.

What they write must be whole or absent; the same command again must end as if nothing had happened, with the same
numbers to the last bit, and nothing may be left beside its output. What differs between two runs that nobody disturbed,
as times do, is not compared.
"""

import json
import os
import shutil
import tempfile
from collections.abc import Generator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import xarray

from analytic.writing import HIDDEN
from validation.stress.commands import Run, fault_of, run
from validation.stress.damage import CYCLE, FEW, MEASURED
from validation.stress.extreme import leaves

VICTIM = Path(__file__).with_name("victim.py")
NEVER = 10**9
STATUS = {"kill": -9, "term": 143, "full": 74}
SLOWEST = 90.0  # s of the processor: a report with pictures takes some
SCENE = """
name = "killed"
tolerance = "5 %"
[bearing]
catalog = "paper_6205"
[operation]
axial_load = "300 N"
inner_speed = ["250 rpm", "700 rpm"]
[friction]
coefficient = 0.09
hysteresis_loss = 0.007
spin_rule = "balanced"
"""
GRID = """
scene = "scene.toml"
[axes]
operation.inner_speed = ["250 rpm", "700 rpm"]
bearing.inner.conformity = [0.513, 0.517, 0.522]
operation.axial_load = { from = "120 N", to = "900 N", count = 7, spacing = "log" }
"""
OILED = ("paper_6205", "--tolerance", "0.9", "--out", "out")
COMMANDS = {  # each with what it writes; a few kills take the first ones, which are quick
    "torque": (("torque", "scene.toml", "--out", "out"), "out"),
    "torque, one file": (("torque", "scene.toml", "--out", "out.csv"), "out.csv"),
    "sweep": (("sweep", "grid.toml", "--out", "out", "--workers", "1"), "out"),
    "duty": (("duty", "scene.toml", "cycle.csv", "--out", "out"), "out"),
    "compare": (("compare", "measured.csv", "scene.toml", "--samples", str(FEW), "--out", "out"), "out"),
    "export": (("export", "scene.toml", "--to", "csv", "--out", "out.csv"), "out.csv"),
    "export, netCDF": (("export", "scene.toml", "--to", "netcdf", "--out", "out.nc"), "out.nc"),
    "draw": (("draw", "scene.toml", "--out", "out.svg"), "out.svg"),
    "film": (("film", *OILED), "out"),
    "creep": (("creep", *OILED), "out"),
    "report": (("report", "report/report.json", "--out", "out.html"), "out.html"),
    "validate": (("validate", "6205-dry", "--tolerance", "0.9", "--out", "out"), "out"),
}
FILES = {"scene.toml": SCENE, "grid.toml": GRID, "cycle.csv": CYCLE, "measured.csv": MEASURED}
GROWS = ("sweep",)  # whose folder is there while it works, and is continued
Content = dict[str, Any]  # of all files, by path and by place in them


@dataclass(frozen=True)
class Killed:
    """One command that was disturbed, and started again."""

    command: str
    what: str
    step: str
    fault: str  # "" where there is none


def kills(count: int, seed: int, report: Path, solved: Path) -> Generator[Killed]:
    """Disturb the commands `count` times in turn, at random steps: nine times of ten by a kill.

    report : a folder with a report;  solved : a file with its contacts, pickled
    """
    rng = np.random.default_rng(seed)
    with tempfile.TemporaryDirectory() as folder:
        stages: dict[str, Stage] = {}
        ahead: dict[str, list[int]] = {}
        for number in range(count):
            name = list(COMMANDS)[number % len(COMMANDS)]
            stage = stages[name] = stages.get(name) or Stage(Path(folder), name, solved, report)
            ahead[name] = ahead.get(name) or [int(step) for step in rng.permutation(len(stage.steps))]
            step = ahead[name].pop()
            what = "kill" if rng.random() < 0.9 else str(rng.choice(["term", "full"]))
            yield Killed(name, what, stage.steps[step], stage.disturbed(step, what))


class Stage:
    """One command, its undisturbed outcome, and a folder for each disturbed one."""

    def __init__(self, folder: Path, name: str, solved: Path, report: Path) -> None:
        self.folder, self.name, self.solved, self.report = folder, name, solved, report
        self.arguments, self.output = COMMANDS[name]
        first, second = (self._whole(f"{name} {number}") for number in range(2))
        self.expected = {place: value for place, value in first.items() if second.get(place) == value}
        self.files = {place.partition("::")[0] for place in first}
        self.steps = (folder / f"{name} 0.steps").read_text("utf-8").splitlines()

    def _whole(self, name: str) -> Content:
        place = self._place(name)
        done = self._run(place, NEVER, "kill")
        if done.status not in (0, 1, 3):
            raise RuntimeError(f"{self.name}: {done.err}")
        content = content_of(place)
        shutil.rmtree(place)
        return content

    def disturbed(self, step: int, what: str) -> str:
        """Disturb the command at a step, and start it again; what is wrong then."""
        place = self._place(f"{self.name} disturbed")
        try:
            return self._disturbed(place, step, what)
        finally:
            shutil.rmtree(place)

    def _disturbed(self, place: Path, step: int, what: str) -> str:
        done = self._run(place, step, what)
        named = self.steps[step].startswith(
            ("renamed", "remove")
        )  # what is removed may stay, what has its name is done
        if done.status != STATUS[what] and not (what == "full" and named):
            return f"status {done.status} after {what}: {done.err.strip()[-200:]}"
        is_there = os.path.lexists(place / self.output)
        if is_there and self.name not in GROWS and (fault := self._difference(place, hidden_too=False)):
            return f"half an output: {fault}"
        if what != "kill" and (left := hidden_in(place)):
            return f"left at once: {', '.join(left)}"
        if not is_there or self.name in GROWS or self.name == "report":
            done = self._run(place, NEVER, "kill")
            if fault := fault_of(done, slowest=SLOWEST):
                return f"again: {fault}"
        else:  # its output is whole; another run in the same folder clears up what is left beside it
            run(("torque", "scene.toml", "--out", "other.csv"), place)
            (place / "other.csv").unlink(missing_ok=True)
        return self._difference(place, hidden_too=True)

    def _difference(self, place: Path, *, hidden_too: bool) -> str:
        found = content_of(place)
        files = {name.partition("::")[0] for name in found}
        if not hidden_too:
            files = {name for name in files if not any(part.startswith(HIDDEN) for part in Path(name).parts)}
        if files - self.files:
            return f"left over: {', '.join(sorted(files - self.files))}"
        if self.files - files:
            return f"missing: {', '.join(sorted(self.files - files))}"
        changed = [name for name, value in self.expected.items() if found.get(name) != value]
        return f"another value: {changed[0]} and {len(changed) - 1} more" if changed else ""

    def _place(self, name: str) -> Path:
        place = self.folder / name
        place.mkdir()
        for file, text in FILES.items():
            (place / file).write_text(text, "utf-8")
        if self.name == "report":
            shutil.copytree(self.report, place / "report")
        return place

    def _run(self, place: Path, step: int, what: str) -> Run:
        steps, solved = self.folder / f"{place.name}.steps", self.solved if self.name == "validate" else "-"
        program = (str(VICTIM), str(step), what, str(steps), str(solved))
        return run(self.arguments, place, program=program)


def content_of(folder: Path) -> Content:
    """The content of all files: of JSON every value by its place, of netCDF every variable, else the bytes."""
    content: Content = {}
    for path in sorted(folder.rglob("*")):
        name = path.relative_to(folder).as_posix()
        if path.is_dir():
            if path.name.startswith("."):
                content[name] = "a hidden folder"
        elif path.suffix == ".json":
            content |= {f"{name}::{place}": value for place, value in leaves(json.loads(path.read_text("utf-8")))}
        elif path.suffix == ".nc":
            with xarray.open_dataset(path, engine="netcdf4") as dataset:
                content |= {f"{name}::{key}": each.values.tobytes() for key, each in dataset.variables.items()}
        else:
            content[name] = path.read_bytes()
    return content


def hidden_in(folder: Path) -> list[str]:
    return [path.name for path in folder.iterdir() if path.name.startswith(".")]
