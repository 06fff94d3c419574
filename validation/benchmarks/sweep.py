"""How fast is a sweep? python validation/benchmarks/sweep.py [--points 100000] [--contacts 100] [--workers 2]

Runs the command `fembearing sweep`, including the start of Python and the maps:
- a torque map over load and speed, with a tenth of the points and with all, which shows how memory grows;
- the same command again, when all points are stored;
- contacts on one worker and on several. They are contacts of half spaces at 5 %, for which finite elements take half
  the time of true shapes: some minutes in all.
Every process has one thread, so that workers are compared and not threads. Prints wall times: the machine should be
idle.
"""

import json
import os
import resource
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated

import typer
from rich.console import Console
from rich.table import Table

from machine import machine, versions

SCENE = Path(__file__).resolve().parents[1] / "scenes" / "6205_physical.toml"
MAP = """
scene = {scene}
[axes]
operation.axial_load = {{ from = "100 N", to = "2 kN", count = {loads}, spacing = "log" }}
operation.inner_speed = {{ from = "100 rpm", to = "5000 rpm", count = {speeds} }}
"""
CONTACTS = """
what = "contact"
scene = {scene}
accuracy = "5 %"
geometry = "hertzian"
[axes]
pair = ["inner", "outer"]
ball_load = {{ from = "20 N", to = "600 N", count = {loads}, spacing = "log" }}
operation.inner_speed = ["100 rpm"]
"""
out = Console(width=100)


def main(
    points: Annotated[int, typer.Option(help="Points of the torque map, at least 80.")] = 100_000,
    contacts: Annotated[int, typer.Option(help="Points of the contact sweep, at least 4; 0: none.")] = 100,
    workers: Annotated[int, typer.Option(help="Processes.")] = 2,
) -> None:
    table = Table(title=f"{machine()}; {versions('numpy', 'scipy', 'xarray')}")
    for head in ("sweep", "points", "workers", "seconds", "largest process, MB"):
        table.add_column(head, justify="left" if head == "sweep" else "right")

    def measure(name: str, grid: str, folder: Path, count: int) -> float:
        seconds, computed = timed(grid, folder, count)
        memory = (
            resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        )  # largest so far: sweeps go from small to large
        table.add_row(name, str(computed), str(count), f"{seconds:.2f}", f"{memory:.0f}")
        return seconds

    with TemporaryDirectory() as place:
        folder, scene = Path(place), json.dumps(str(SCENE))
        speeds = min(200, points // 20)
        for loads in (points // 10 // speeds, points // speeds):
            grid = MAP.format(scene=scene, loads=loads, speeds=speeds)
            measure("torque map", grid, folder / f"map {loads}", workers)
        measure("the same again", grid, folder / f"map {loads}", workers)
        if contacts:
            grid = CONTACTS.format(scene=scene, loads=contacts // 2)
            alone = measure("contacts", grid, folder / "one", 1)
            together = measure("contacts", grid, folder / "several", workers)
            measure("the same again", grid, folder / "several", workers)
            table.caption = f"contacts on {workers} workers: {alone / together:.2f} times as fast as on one"
    out.print(table)


def timed(grid: str, folder: Path, workers: int) -> tuple[float, int]:
    """Seconds and points of one command."""
    file = folder.with_suffix(".toml")
    file.write_text(grid, "utf-8")
    command = [sys.executable, "-m", "fembearing.cli", "sweep", str(file), "--out", str(folder), "--json"]
    one_thread = os.environ | {"OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}
    started = time.perf_counter()
    done = subprocess.run([*command, "--workers", str(workers)], stdout=subprocess.PIPE, env=one_thread, check=True)
    return time.perf_counter() - started, json.loads(done.stdout)["points"]


if __name__ == "__main__":
    typer.run(main)
