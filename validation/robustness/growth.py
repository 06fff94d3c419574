"""Memory that a process gains by calling the same functions many times."""

import ctypes
import gc
import multiprocessing
from collections.abc import Callable
from dataclasses import dataclass, replace
from multiprocessing.connection import Connection
from pathlib import Path

import numpy as np

import fembearing
from analytic import friction_torque, load_scene

STATM = Path("/proc/self/statm")  # Linux
PAGE = 4096  # bytes
WARM = 0.1  # share of the calls before the memory is first measured: they fill caches
MOST = {"friction_torque": 5e6, "solve_contact": 50e6}  # bytes


@dataclass(frozen=True)
class Growth:
    """Memory gained by calls of one function in a process of their own."""

    function: str
    calls: int
    gained: float  # bytes, after the first tenth of the calls

    @property
    def fault(self) -> str:
        return "" if self.gained < MOST[self.function] else f"grows by {self.gained / 1e6:.1f} MB"


def growth_of(function: str, calls: int) -> Growth:
    receiver, sender = multiprocessing.Pipe(duplex=False)
    process = multiprocessing.Process(target=_measure, args=(function, calls, sender))
    process.start()
    sender.close()
    try:
        gained = receiver.recv()
    except EOFError:
        gained = np.inf
    process.join()
    return Growth(function, calls, gained)


def _measure(function: str, calls: int, sender: Connection) -> None:
    call = {"friction_torque": _torque, "solve_contact": _contact}[function]()
    warm = max(round(WARM * calls), 1)
    for number in range(warm):
        call(number)
    before = resident()
    for number in range(warm, calls):
        call(number)
    sender.send(resident() - before)


def _torque() -> Callable[[int], object]:
    scene = load_scene("6205-dry")
    loads = np.geomspace(50.0, 2000.0, 97)

    def call(number: int) -> object:
        operation = replace(scene.operation, axial_load=np.array([loads[number % loads.size]]))
        return friction_torque(replace(scene, operation=operation))

    return call


def _contact() -> Callable[[int], object]:
    scene = load_scene("6205-dry")
    loads = np.geomspace(50.0, 500.0, 7)
    return lambda number: fembearing.solve_contact(scene, pair="inner", load=loads[number % loads.size], tolerance=0.9)


def resident() -> float:
    """Memory of this process, bytes, when nothing is waiting to be freed."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    return PAGE * int(STATM.read_text().split()[1])
