"""Memory that a process gains by calling the same functions many times.

The scene has oil and rough surfaces, and no two calls have the same load: what is kept for each new load counts.
"""

import ctypes
import gc
import multiprocessing
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

import fembearing
from analytic import friction_torque, load_scene
from analytic.prediction.duty import cycle_with_torques
from analytic.scene import Scene
from analytic.scenefile.columns import read_cycle
from analytic.scenefile.read import load_by_temperature
from analytic.scenefile.template import scene_text as template
from analytic.standing import worst_standing
from fembearing.check.creep.scene_creep import creep_of
from fembearing.check.film.scene_film import film_of
from fembearing.report.files import compared_files, duty_files, solution_files, write_all, write_creep
from validation.stress.damage import CYCLE, MEASURED
from validation.stress.tab import tab

STATM = Path("/proc/self/statm")  # Linux
PAGE = 4096  # bytes
WARM = 0.1  # share of the calls before the memory is first measured: they fill caches
LEAST_WARM = 3  # calls: the second contact still fills caches, by some 50 MB
SPEED = np.array([27.0])  # rad/s
LOOSE = 0.9  # required accuracy: coarse meshes and grids
LIGHTEST, HEAVIEST = 50.0, 2000.0  # N of thrust


def growth_of(function: str, calls: int, *, seconds: float = np.inf) -> tuple[int, float]:
    """Calls of one function in a process of its own, as many as there is time for, and bytes gained after a tenth."""
    with ProcessPoolExecutor(1, multiprocessing.get_context("spawn")) as pool:
        return pool.submit(_measure, function, calls, seconds).result()


def _measure(function: str, calls: int, seconds: float) -> tuple[int, float]:
    scene = replace(load_scene("paper_6205"), cage=None)  # the motion of its cage would take seconds a call
    loads = np.random.default_rng(calls).permutation(np.geomspace(LIGHTEST, HEAVIEST, calls))  # none twice, in no order
    begun, done = time.monotonic(), 0

    def call_until(share: float) -> float:
        """The memory after this share of the calls, or of the time."""
        nonlocal done
        while done < max(share * calls, LEAST_WARM) and time.monotonic() - begun < share * seconds:
            operation = replace(scene.operation, axial_load=loads[done : done + 1], inner_speed=SPEED)
            with tempfile.TemporaryDirectory() as folder:
                FUNCTIONS[function].call(replace(scene, operation=operation), Path(folder))
            done += 1
        return resident()

    gained = -call_until(WARM)
    gained += call_until(1.0)
    return done, gained


def _contact(scene: Scene, _: Path) -> None:
    load = float(scene.operation.axial_load[0]) / 4
    fembearing.solve_contact(scene, pair="inner", load=load, tolerance=LOOSE)


def _compare(scene: Scene, folder: Path) -> None:
    (folder / "measured.csv").write_text(MEASURED, "utf-8")
    write_all(compared_files(fembearing.compare_measured(scene, folder / "measured.csv", samples=64), scene), folder)


def _duty(scene: Scene, folder: Path) -> None:
    (folder / "cycle.csv").write_text(CYCLE, "utf-8")
    cycle, torques = cycle_with_torques(load_by_temperature(scene), read_cycle(folder / "cycle.csv"))
    write_all(duty_files(cycle, worst_standing(torques), scene), folder)


def _export(scene: Scene, folder: Path) -> None:
    over = {"speed": "0 rpm to 3000 rpm in 3", "axial_load": "200 N to 900 N in 2"}
    fembearing.export(scene, to="csv", out=folder / "torque.csv", over=over)


def _page(scene: Scene, _: Path) -> None:
    """Each call opens a page of its own."""
    tab().open()
    tab().shows(template("6206", radial_load=f"{scene.operation.axial_load[0]} N"))


class Function(NamedTuple):
    """What is called, and what it may gain."""

    call: Callable[[Scene, Path], object]  # of a scene, and a folder that is removed afterwards
    most: float  # bytes


FUNCTIONS = {
    "friction_torque": Function(lambda scene, _: friction_torque(scene), 5e6),
    "solve_contact": Function(_contact, 50e6),
    "film": Function(
        lambda scene, folder: write_all(solution_files(film_of(scene, pair="outer", tolerance=LOOSE)), folder), 50e6
    ),
    "creep": Function(lambda scene, folder: write_creep(creep_of(scene, tolerance=LOOSE), folder), 50e6),
    "compare": Function(_compare, 20e6),
    "duty": Function(_duty, 20e6),
    "export": Function(_export, 20e6),
    "draw": Function(lambda scene, folder: fembearing.draw_bearing(scene, out=folder / "a.svg"), 20e6),
    "page": Function(_page, 50e6),
}


def resident() -> float:
    """Memory of this process, bytes, when nothing is waiting to be freed."""
    gc.collect()
    ctypes.CDLL(None).malloc_trim(0)
    return PAGE * int(STATM.read_text().split()[1])
