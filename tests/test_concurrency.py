"""Threads and processes that work at the same time: each has the numbers that it has alone."""

import pickle
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from threading import Barrier
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque, load_scene, torque_function

THREADS = 4


@pytest.mark.parametrize("rule", ["balanced", "free"])
def test_threads_that_share_a_function_have_the_numbers_of_one(rule: Any) -> None:
    scene = replace(load_scene("paper_6205"), spin_rule=rule, effects={"cage": "off"})
    function = torque_function(scene)
    points = [(float(load), speed) for load in np.linspace(210.0, 930.0, 3) for speed in (17.0, 63.0)]

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
        for found in pool.map(torques, range(THREADS)):
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
