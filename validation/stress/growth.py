"""Memory that a process gains by calling the same functions many times.

The scene has oil and rough surfaces, and no two calls have the same load: what is kept for
each new load counts.
"""

import ctypes
import gc
import multiprocessing
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

import fembearing
from analytic import friction_torque, load_scene
from analytic.scene import Scene

STATM = Path("/proc/self/statm")  # Linux
PAGE = 4096  # bytes
WARM = 0.1  # share of the calls before the memory is first measured: they fill caches
LEAST_WARM = 3  # calls: the second contact still fills caches, by some 50 MB
SPEED = np.array([27.0])  # rad/s
MOST = {"friction_torque": 5e6, "solve_contact": 50e6}  # bytes


def growth_of(function: str, calls: int, *, seconds: float = np.inf) -> tuple[int, float]:
    """Calls of one function in a process of its own, as many as there is time for, and bytes gained after a tenth."""
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        return pool.submit(_measure, function, calls, seconds).result()


def _measure(function: str, calls: int, seconds: float) -> tuple[int, float]:
    call = {"friction_torque": _torque, "solve_contact": _contact}[function](calls)
    begun, done = time.monotonic(), 0

    def call_until(share: float) -> float:
        """The memory after this share of the calls, or of the time."""
        nonlocal done
        while done < max(share * calls, LEAST_WARM) and time.monotonic() - begun < share * seconds:
            call(done)
            done += 1
        return resident()

    gained = -call_until(WARM)
    gained += call_until(1.0)
    return done, gained


def oiled() -> Scene:
    """The built-in scene, without its cage, whose motion would take seconds a call."""
    return replace(load_scene("paper_6205"), cage=None)


def loads(least: float, most: float, calls: int) -> NDArray[np.float64]:
    """As many loads, N, as calls, none twice and in no order."""
    return np.random.default_rng(calls).permutation(np.geomspace(least, most, calls))


def _torque(calls: int) -> Callable[[int], object]:
    scene, drawn = oiled(), loads(50.0, 2000.0, calls)

    def call(number: int) -> object:
        operation = replace(scene.operation, axial_load=drawn[number : number + 1], inner_speed=SPEED)
        return friction_torque(replace(scene, operation=operation))

    return call


def _contact(calls: int) -> Callable[[int], object]:
    scene, drawn = oiled(), loads(50.0, 500.0, calls)
    return lambda number: fembearing.solve_contact(scene, pair="inner", load=float(drawn[number]), tolerance=0.9)


def resident() -> float:
    """Memory of this process, bytes, when nothing is waiting to be freed."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    return PAGE * int(STATM.read_text().split()[1])
