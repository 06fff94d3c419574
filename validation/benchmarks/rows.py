"""The rows of the table: the jobs of `jobs.py`, and whole commands. Standard library only."""

import json
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Literal

from validation.benchmarks.jobs import JOBS, Job, dry_file, scene_file
from validation.benchmarks.trees import Sample, Tree

LONG_ENOUGH = 20.0  # s, of a sweep on one worker, so that its start does not count
MAP = """
scene = {scene}
[axes]
operation.radial_load = ["{radial}"]
operation.axial_load = {{ from = "200 N", to = "2 kN", count = {points}, spacing = "log" }}
operation.inner_speed = ["500 rpm", "1500 rpm"]
"""
CONTACTS = """
what = "contact"
scene = {scene}
accuracy = "1 %"
[axes]
pair = ["inner", "outer"]
ball_load = {{ from = "100 N", to = "600 N", count = {points}, spacing = "log" }}
operation.inner_speed = ["100 rpm"]
"""


# The cheapest method of sliding just misses the tolerance since the error between far points counts 1.25 times, so
# 100 of the 200 points are integrated over the ellipse: its torque moves by 2 %. The goal: to judge such a series
# more cheaply.
KNOWN_LOSSES = {"short_series": 8.0}


@dataclass(frozen=True, kw_only=True)
class Row:
    """A figure, measured in one tree after another."""

    name: str
    title: str
    measure: Callable[[Tree], Sample]
    goal: float | None = None
    worst: float = 1.5  # times as bad as at the recorded commit
    unit: Literal["s", "times"] = "s"  # times as fast: more is better
    clock: Literal["cpu", "wall"] = "cpu"
    once: bool = False
    short: bool = False

    def best(self, samples: list[Sample]) -> float:
        """The figure of some samples: noise only adds to a time."""
        return (min if self.unit == "s" else max)(getattr(sample, self.clock) for sample in samples)


def job_row(name: str, job: Job) -> Row:
    return Row(
        name=name,
        title=job.title,
        measure=lambda tree: tree.job(name, fresh=job.fresh),
        goal=job.goal,
        clock=job.clock,
        once=job.once,
        short=job.short,
        worst=KNOWN_LOSSES.get(name, 1.5),
    )


def first_call(tree: Tree) -> Sample:
    program = "import sys, analytic; analytic.friction_torque(analytic.load_scene(sys.argv[1]))"
    return tree.command("-c", program, str(scene_file(tree.folder, "6205_physical")), python=True)


def speed_up(tree: Tree, *, grid: str, points: int, most: int) -> Sample:
    """How many times as fast two workers are as one, on a sweep that takes long enough."""
    while (alone := sweep(tree, grid, points=points, workers=1).wall) < LONG_ENOUGH and points < most:
        points = min(most, 4 * points)
    together = sweep(tree, grid, points=points, workers=2).wall
    note = f"{2 * points} points: {alone:.1f} s on one, {together:.1f} s on two"
    return Sample(wall=alone / together, cpu=alone / together, note=note)


def sweep(tree: Tree, grid: str, *, points: int, workers: int, radial: str = "1 kN") -> Sample:
    scene = json.dumps(str(scene_file(tree.folder, "6205_physical")))
    with TemporaryDirectory() as place:
        file = Path(place) / "grid.toml"
        file.write_text(grid.format(scene=scene, points=points, radial=radial), "utf-8")
        return tree.command("sweep", str(file), "--out", f"{place}/out", "--json", "--workers", str(workers))


def validate(tree: Tree, *, report: bool) -> Sample:
    with TemporaryDirectory() as place:
        out = ("--out", f"{place}/report") if report else ()
        return tree.command("validate", str(dry_file(tree.folder)), "--json", *out, threads=True)


COMMANDS = (
    Row(
        name="validate",
        title="fembearing validate, built-in with a coefficient",
        measure=partial(validate, report=False),
        goal=4.0,
        clock="wall",
    ),
    Row(
        name="validate_out",
        title="the same with its report",
        measure=partial(validate, report=True),
        goal=10.0,
        clock="wall",
    ),
    Row(
        name="first_call",
        title="first torque in a fresh process, 6205_physical",
        measure=first_call,
        goal=0.4,
    ),
    Row(
        name="version",
        title="fembearing --version",
        measure=lambda tree: tree.command("--version"),
        goal=0.15,
        short=True,
    ),
    Row(
        name="help",
        title="fembearing --help",
        measure=lambda tree: tree.command("--help"),
        goal=0.15,
    ),
    Row(
        name="torque",
        title="fembearing torque, built-in with a coefficient",
        measure=lambda tree: tree.command("torque", str(dry_file(tree.folder)), "--json"),
        goal=0.5,
        # A known loss: numba's own cache imports numba and scipy.linalg, 0.6 s, where our loader needed neither. The
        # goal is missed until commands with dry contacts do without compiled code, or the record is renewed.
        worst=3.0,
        short=True,
    ),
    Row(
        name="sweep_start",
        title="fembearing sweep of 4 thrust points, one worker",
        measure=partial(sweep, grid=MAP, points=2, workers=1, radial="0 N"),
    ),
    Row(
        name="sweep_contacts",
        title="sweep of contacts: two workers against one",
        measure=partial(speed_up, grid=CONTACTS, points=4, most=64),
        goal=1.7,
        unit="times",
        clock="wall",
        once=True,
    ),
    Row(
        name="sweep_radial",
        title="sweep of torques under radial load: two workers against one",
        measure=partial(speed_up, grid=MAP, points=32, most=65_536),
        goal=1.7,
        unit="times",
        clock="wall",
        once=True,
    ),
)
ROWS = (*(job_row(name, job) for name, job in JOBS.items()), *COMMANDS)
