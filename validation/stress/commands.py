"""The command line, run in a process of its own: what it says, how long it takes, and what it leaves.

Whatever its input is, a command ends with a documented status; a failure is one line; no number is silently missing;
what it writes is whole or absent. Extreme scenes and damaged files go through every command that takes them.
"""

import csv
import json
import math
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Generator, Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from threading import Timer

import numpy as np

from validation.stress.damage import CYCLE, FEW, INPUTS, MEASURED, damaged_input, place_in
from validation.stress.extreme import extreme_scene, numbers
from validation.stress.watched import LARGEST, SLOWEST, Tried
from validation.study import ROOT

PROGRAM = ("-c", "from fembearing.cli import main; main()")
DOCUMENTED = (0, 1, 2, 3)
FAILURES = {2: "input", 3: "not solved", 71: "memory", 74: "input and output"}  # each in one line
COMPILING, COMPILED_WITHIN = "fembearing: compiling ", 120.0  # s of the processor, once for a machine
CHATTER = (
    *(COMPILING, "fembearing: compiled formulas cannot be kept", "fembearing: warning: "),
    *("fembearing: the cage did not move", "fembearing: there is no picture", "fembearing: the picture "),
)
SOLVED_WITHIN = 120.0  # s of the processor: a film or creep on the grids that its convergence asks for
RANGE = ("--speed", "0 rpm to 3000 rpm in 3", "--axial-load", "200 N to 900 N in 2")
DEAF = 600.0  # s of the clock, on a busy machine
NOT_A_NUMBER = re.compile(r"(?<![\w.-])[-+]?(nan|inf)(?![\w.-])", re.IGNORECASE)
FOLDER = {"torque.json", "torque.csv", "torque.png"}
OUTCOMES = {0: "done", 1: "done", 2: "refused", 3: "not solved"}
READ_MESH = """
import sys
from pathlib import Path
from fembearing.cli.boundary import guarded
from fembearing.mesh.meshfile import read_body
sys.exit(guarded(lambda: print(read_body(Path("body.vtu"), name="ball"))))
"""
COMMANDS = {  # of a damaged file
    "mesh": (),
    "cycle": ("duty", "6205-dry", "cycle.csv", "--out", "out"),
    "measured torques": ("compare", "6205-dry", "measured.csv", "--samples", str(FEW), "--out", "out"),
    "grid": ("sweep", "grid.toml", "--out", "out", "--workers", "1"),
    "height map": ("torque", "scene.toml"),
}


@dataclass(frozen=True)
class Run:
    """A command that ended."""

    status: int  # negative: the signal
    out: str
    err: str
    seconds: float  # of the processor, with its children
    memory: float  # bytes, of the largest process

    @property
    def complaints(self) -> list[str]:
        """The lines on standard error that say what failed."""
        return [line for line in self.err.splitlines() if not line.startswith(CHATTER)]


@dataclass(frozen=True)
class Limits:
    """What a command is started with."""

    sizes: Mapping[int, int] = field(default_factory=dict)  # of resource.RLIMIT_
    environment: Mapping[str, str | None] = field(default_factory=dict)  # None: not there
    closed: tuple[int, ...] = ()  # streams
    before: tuple[str, ...] = ()  # a command that starts it

    def apply(self) -> None:
        """In the new process."""
        for which, size in self.sizes.items():
            resource.setrlimit(which, (size, size))
        for stream in self.closed:
            os.close(stream)


FREE = Limits()


def run(arguments: Sequence[str], cwd: Path, limits: Limits = FREE, program: Sequence[str] = PROGRAM) -> Run:
    """Run a command in a folder; it and its children are ended after DEAF seconds."""
    # Byte code that a limit cuts short would be kept, and end every later start: Python 3.11 does not look.
    own = {"PYTHONPATH": str(ROOT), "OMP_NUM_THREADS": "1", "PYTHONDONTWRITEBYTECODE": "1"}
    environment = {**os.environ, **own, **limits.environment}
    process = subprocess.Popen(
        [*limits.before, sys.executable, *program, *arguments],
        cwd=cwd,
        env={name: value for name, value in environment.items() if value is not None},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,  # no files: their size may be limited
        stderr=subprocess.PIPE,
        start_new_session=True,
        preexec_fn=limits.apply,
    )
    ending = Timer(DEAF, os.killpg, (process.pid, signal.SIGKILL))
    ending.start()
    with ThreadPoolExecutor(1) as pool:
        err = pool.submit(process.stderr.read)
        texts = [process.stdout.read(), err.result()]
    _, state, usage = os.wait4(process.pid, 0)
    ending.cancel()
    process.returncode = os.waitstatus_to_exitcode(state)
    out, complaints = (text.decode("utf-8", "replace") for text in texts)
    return Run(process.returncode, out, complaints, usage.ru_utime + usage.ru_stime, 1024 * usage.ru_maxrss)


def fault_of(done: Run, *, base: float = 0.0, allowed: Sequence[int] = DOCUMENTED, slowest: float = SLOWEST) -> str:
    """What is wrong with how a command ended; "" where nothing is.

    base : memory of a command that does little, bytes
    """
    if "Traceback" in done.err:
        return f"traceback: {done.err.strip().splitlines()[-1]:.200}"
    if done.status not in allowed:
        return f"status {done.status}: {done.err.strip()[-200:]}"
    if done.status == 1 and not done.out and allowed is DOCUMENTED:  # with little memory Python itself ends with 1
        return "status 1 without a result"
    if done.status in FAILURES and not done.out and len(done.complaints) != 1:
        return f"{len(done.complaints)} lines for one failure: {done.err.strip()[-300:]!r}"
    if done.status == 2 and done.out:
        return f"a result beside a refusal: {done.out[:100]!r}"
    if done.seconds > (COMPILED_WITHIN if COMPILING in done.err else slowest):
        return f"{done.seconds:.0f} s"
    if done.memory - base > LARGEST:
        return f"{(done.memory - base) / 1e6:.0f} MB"
    return ""


def _strange(text: str) -> str:
    """The first number in JSON that is none."""
    for place, number in numbers(json.loads(text)):
        if not math.isfinite(number):
            return f"{place} = {number}"
    return ""


def _cells(_: object, path: Path) -> str:
    with path.open(newline="", encoding="utf-8") as file:
        for cell in (cell for row in csv.reader(line for line in file if not line.startswith("#")) for cell in row):
            if NOT_A_NUMBER.fullmatch(cell.strip()):
                return f"a cell of {path.name} is {cell}"
    return ""


def _text(done: Run, _: Path) -> str:
    found = NOT_A_NUMBER.search(done.out)
    return f"the text shows {found.group()}" if found else ""


def _json(done: Run, _: Path) -> str:
    return _strange(done.out)


def _folder(done: Run, target: Path) -> str:
    lacking = FOLDER - {path.name for path in target.iterdir()}
    if lacking:
        return f"the folder lacks {', '.join(lacking)}"
    text = (target / "torque.json").read_text("utf-8")
    return _strange(text) or _cells(done, target / "torque.csv")


def _files(done: Run, target: Path) -> str:
    """Of numbers and tables in a folder."""
    faults = [_strange(path.read_text("utf-8")) for path in target.glob("*.json")]
    return next(filter(None, [*faults, *(_cells(done, path) for path in target.glob("*.csv"))]), "")


def _page(_: Run, target: Path) -> str:
    found = re.search(r">\s*[-+]?(nan|inf)\s*<", target.read_text("utf-8"))
    return f"the page shows {found.group()}" if found else ""


@dataclass(frozen=True)
class Face:
    """A command of a scene, and how its result is looked at."""

    command: tuple[str, ...]
    fault: Callable[[Run, Path], str]  # of what it prints, or writes to the target
    target: str = "out"
    slowest: float = SLOWEST  # s of the processor


FACES = {
    "text": Face(("torque", "scene.toml"), _text),
    "json": Face(("torque", "scene.toml", "--json"), _json),
    "csv": Face(("torque", "scene.toml", "--out", "torque.csv"), _cells, "torque.csv"),
    "folder": Face(("torque", "scene.toml", "--out", "torque"), _folder, "torque"),
    "page": Face(("torque", "scene.toml", "--out", "torque.html"), _page, "torque.html"),
    "film": Face(("film", "scene.toml", "--tolerance", "0.9", "--json"), _json, slowest=SOLVED_WITHIN),
    "creep": Face(("creep", "scene.toml", "--tolerance", "0.9", "--json"), _json, slowest=SOLVED_WITHIN),
    "compare": Face(("compare", "scene.toml", "measured.csv", "--samples", "64", "--out", "out"), _files),
    "duty": Face(("duty", "scene.toml", "cycle.csv", "--out", "out"), _files),
    "export": Face(("export", "scene.toml", "--to", "csv", *RANGE, "--out", "out.csv"), _cells, "out.csv"),
    "draw": Face(("draw", "scene.toml", "--out", "out.svg"), _page, "out.svg"),
}


def scenes_through_faces(seeds: Iterable[int], folder: Path, base: float) -> Generator[Tried]:
    """Extreme scenes, each through another command; base : memory of a command, bytes."""
    for seed in seeds:
        text, face = extreme_scene(np.random.default_rng(seed)), list(FACES)[seed % len(FACES)]
        with tempfile.TemporaryDirectory(dir=folder) as place:
            (Path(place) / "scene.toml").write_text(text, "utf-8")
            done, fault = _through(FACES[face], Path(place), base)
        yield _tried(face, seed, done, fault, base, text.encode())


def damaged_through_commands(seeds: Iterable[int], folder: Path, base: float) -> Generator[Tried]:
    """The commands that read a file of each kind, of scenes all; of a mesh the reader, as no command takes one."""
    for seed in seeds:
        given, place = damaged_input(seed, folder), place_in(folder)
        if given.kind == "height map":
            name = next(place.iterdir()).name
            mapped = (INPUTS / "mapped.toml").read_text("utf-8").replace("PATH", name)
            (place / "scene.toml").write_text(mapped, "utf-8")
        if given.kind == "scene":
            face = list(FACES.values())[seed // len(COMMANDS) % len(FACES)]
            done, fault = _through(face, place, base)
        else:
            program = ("-c", READ_MESH) if given.kind == "mesh" else PROGRAM
            done = run(COMMANDS[given.kind], place, program=program)
            fault = fault_of(done, base=base)
        yield _tried(given.kind, seed, done, fault, base, given.content)


def _through(face: Face, place: Path, base: float) -> tuple[Run, str]:
    """A command of the scene in a folder, and what is wrong with how it ended, or with what it shows or writes."""
    (place / "cycle.csv").write_text(CYCLE, "utf-8")
    (place / "measured.csv").write_text(MEASURED, "utf-8")
    done, target = run(face.command, place), place / face.target
    if fault := fault_of(done, base=base, slowest=face.slowest):
        return done, fault
    if done.status not in (0, 1) and not (done.status == 3 and done.out):
        return done, f"{target.name} is left of a failure" if os.path.lexists(target) else ""
    try:
        return done, face.fault(done, target)
    except (OSError, ValueError) as problem:
        return done, f"{' '.join(face.command)}: {problem}"


def _tried(kind: str, seed: int, done: Run, fault: str, base: float, content: bytes) -> Tried:
    outcome = fault or OUTCOMES[done.status]
    return Tried(kind, seed, outcome, done.seconds, max(done.memory - base, 0.0), content if fault else b"")
