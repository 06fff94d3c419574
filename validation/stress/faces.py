"""Extreme scenes and damaged files through commands in processes of their own."""

import tempfile
from collections.abc import Generator, Iterable
from pathlib import Path

import numpy as np

from validation.stress.commands import FACES, PROGRAM, Run, face_fault, fault_of, run
from validation.stress.damage import CYCLE, FEW, MEASURED, Files
from validation.stress.extreme import extreme_scene
from validation.stress.watched import Tried

OUTCOMES = {0: "done", 1: "done", 2: "refused", 3: "not solved"}
MAPPED = """
name = "mapped"
tolerance = "5 %"
[bearing]
catalog = "paper_6205"
[operation]
axial_load = "300 N"
inner_speed = "250 rpm"
[lubricant]
name = "ISO VG 46"
[surface]
height_map = { path = "PATH", spacing = "2 um" }
"""
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


def scenes_through_faces(seeds: Iterable[int], folder: Path, base: float) -> Generator[Tried]:
    """Extreme scenes, each through another command; base : memory of a command, bytes."""
    for seed in seeds:
        text, face = extreme_scene(np.random.default_rng(seed)), list(FACES)[seed % len(FACES)]
        with tempfile.TemporaryDirectory(dir=folder) as place:
            (Path(place) / "scene.toml").write_text(text, "utf-8")
            done, fault = _through(face, Path(place), base)
        yield _tried(face, seed, done, fault, base, text.encode())


def _through(face: str, place: Path, base: float) -> tuple[Run, str]:
    """A command of the scene in a folder, and what is wrong with how it ended."""
    (place / "cycle.csv").write_text(CYCLE, "utf-8")
    (place / "measured.csv").write_text(MEASURED, "utf-8")
    done = run(FACES[face].command, place)
    return done, fault_of(done, base=base, slowest=FACES[face].slowest) or face_fault(face, done, place)


def damaged_through_commands(seeds: Iterable[int], files: Files, base: float) -> Generator[Tried]:
    """The commands that read a file of each kind, of scenes all; of a mesh the reader, as no command takes one."""
    for seed in seeds:
        given = files.input(seed)
        place = files.place
        if given.kind == "height map":
            name = next(place.iterdir()).name
            (place / "scene.toml").write_text(MAPPED.replace("PATH", name), "utf-8")
        if given.kind == "scene":
            face = list(FACES)[seed // len(COMMANDS) % len(FACES)]
            done, fault = _through(face, place, base)
        else:
            program = ("-c", READ_MESH) if given.kind == "mesh" else PROGRAM
            done = run(COMMANDS[given.kind], place, program=program)
            fault = fault_of(done, base=base)
        yield _tried(given.kind, seed, done, fault, base, given.content)


def _tried(kind: str, seed: int, done: Run, fault: str, base: float, content: bytes) -> Tried:
    outcome = fault or OUTCOMES[done.status]
    return Tried(kind, seed, outcome, done.seconds, max(done.memory - base, 0.0), content if fault else b"")
