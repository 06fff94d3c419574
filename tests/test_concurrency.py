"""Threads and processes that work at the same time: each has the numbers that it has alone."""

import os
import pickle
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from threading import Barrier
from typing import Any

import numpy as np
import pytest

import fembearing
from analytic import friction_torque, load_scene, torque_function
from tests.sweep.swept import SCENE

THREADS = 4
GRID = """
[axes]
friction.coefficient = [0.03, 0.05, 0.07, 0.11]
"operation.inner_speed" = ["100 rpm", "450 rpm", "700 rpm"]
"operation.axial_load" = { from = "100 N", to = "900 N", count = 12, spacing = "log" }
"""


@pytest.mark.parametrize("rule", ["balanced", "free"])
def test_threads_that_share_a_function_have_the_numbers_of_one(rule: Any) -> None:
    scene = replace(load_scene("paper_6205"), spin_rule=rule, effects={"cage": "off"})
    function = torque_function(scene)
    points = [(float(load), speed) for load in np.linspace(210.0, 930.0, 12) for speed in (17.0, 63.0)]

    def torque(point: tuple[float, float]) -> float:
        return function(axial_load=point[0], inner_speed=point[1], temperature=300.0 + point[0] / 50)

    alone = [torque(point) for point in points]
    together = Barrier(THREADS)

    def torques(first: int) -> list[float]:
        together.wait()
        order = [*points[first:], *points[:first]]
        found = dict(zip(order, map(torque, order), strict=True))
        return [found[point] for point in points]

    with ThreadPoolExecutor(THREADS) as pool:
        for found in pool.map(torques, range(0, 6 * THREADS, 6)):
            assert found == alone
    with ThreadPoolExecutor(1) as pool:  # a copy by pickle has a lock of its own
        assert pool.submit(pickle.loads(pickle.dumps(function)), axial_load=370.0, inner_speed=-29.0).result() > 0


def test_threads_that_load_and_compute_scenes_do_not_mix() -> None:
    """Names, units and oils are read by libraries that keep tables of their own."""
    scenes: list[tuple[str, dict[str, Any]]] = [
        ("6206", {"axial_load": "730 N", "speed": "410 rpm"}),
        ("6308", {"axial_load": "2.1 kN"}),
        ("7208B", {"axial_load": "640 N"}),
        ("61804", {"axial_load": "150 N", "speed": "90 rpm"}),
    ]

    def torque(given: tuple[str, dict[str, Any]]) -> float:
        scene = replace(load_scene(given[0], **given[1]), spin_rule="balanced")
        return float(friction_torque(scene).torque.total[0])

    alone = [torque(given) for given in scenes]
    assert len(set(alone)) == len(scenes)
    with ThreadPoolExecutor(THREADS) as pool:
        assert list(pool.map(torque, 3 * scenes)) == 3 * alone


def started(*words: str, folder: Path) -> subprocess.Popen[str]:
    """A command in a process of its own."""
    return subprocess.Popen(
        [sys.executable, "-m", "fembearing", *words],
        env={**os.environ, "PYTHONPATH": str(Path(fembearing.__file__).parents[1])},
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )


def ended(process: subprocess.Popen[str]) -> tuple[int, str, str]:
    """Status, standard output and standard error."""
    out, said = process.communicate(timeout=900)
    return process.returncode, out, said


@pytest.mark.slow  # starts commands
@pytest.mark.skipif(sys.platform == "win32", reason="folders are locked on POSIX systems")
def test_of_two_sweeps_in_one_folder_one_is_refused_and_the_other_is_whole(
    command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "grid.toml").write_text(f"{SCENE}\n{GRID}", "utf-8")
    sweep = ("sweep", "grid.toml", "--out", "out", "--workers", "1")  # each worker takes a second to start
    both = [started(*sweep, folder=tmp_path) for _ in range(2)]
    ends = sorted(map(ended, both))
    assert ends[0][0] == 0, ends[0]
    assert ends[0][1].startswith("144 points: 144 computed")
    assert ends[1][0] == 2, ends[1]
    assert "another sweep is at work there" in ends[1][2]
    assert ends[1][2].count("\n") == 1
    monkeypatch.chdir(tmp_path)
    status, out, said = command(*sweep)
    assert (status, said) == (0, "")
    assert out.startswith("144 points: 0 computed, 144 from before, 0 failed")
