"""How fast is a sweep?

    python validation/benchmarks/sweep.py [--points 100000] [--radial 256] [--contacts 100] [--workers 2] [--repeats 3]

Runs the command `fembearing sweep`, including the start of Python and the maps:
- a torque map over load and speed, with a tenth of the points and with all, which shows how memory grows;
- the same command again, when all points are stored;
- a torque map under radial load with sinh traction, where every point is integrated, on one worker and on several;
- contacts on one worker and on several. They are contacts of half spaces at 5 %, for which finite elements take half
  the time of true shapes: some minutes in all.
Prints wall times: the machine should be idle. Where it is not, repeats on one worker and on several take turns, and the
ratio is the median of the pairs.
"""

import json
import resource
import subprocess
import sys
import time
from pathlib import Path
from statistics import median
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
RADIAL_SCENE = SCENE.with_name("6205_radial.toml")
RADIAL = """
scene = {scene}
[axes]
lubricant.traction = ["eyring_sinh"]
operation.radial_load = {{ from = "300 N", to = "3 kN", count = {loads}, spacing = "log" }}
operation.inner_speed = {{ from = "200 rpm", to = "5000 rpm", count = 8 }}
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
    radial: Annotated[int, typer.Option(help="Points of the map under radial load, at least 16; 0: none.")] = 256,
    contacts: Annotated[int, typer.Option(help="Points of the contact sweep, at least 4; 0: none.")] = 100,
    workers: Annotated[int, typer.Option(help="Processes.")] = 2,
    repeats: Annotated[int, typer.Option(help="Of the pairs on one worker and on several.")] = 1,
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
        ratios = []
        for name, text, place_of_scene, loads in (
            ("radial map", RADIAL, RADIAL_SCENE, radial // 8),
            ("contacts", CONTACTS, SCENE, contacts // 2),
        ):
            if not loads:
                continue
            grid, pairs = text.format(scene=json.dumps(str(place_of_scene)), loads=loads), []
            for number in range(repeats):
                alone = measure(name, grid, folder / f"{name} one {number}", 1)
                pairs.append(alone / measure(name, grid, folder / f"{name} several {number}", workers))
            ratios.append(f"{name} on {workers} workers: {median(pairs):.2f} times as fast as on one")
        table.caption = "\n".join(ratios)
    out.print(table)


def timed(grid: str, folder: Path, workers: int) -> tuple[float, int]:
    """Seconds and points of one command."""
    file = folder.with_suffix(".toml")
    file.write_text(grid, "utf-8")
    command = [sys.executable, "-m", "fembearing.cli", "sweep", str(file), "--out", str(folder), "--json"]
    started = time.perf_counter()
    done = subprocess.run([*command, "--workers", str(workers)], stdout=subprocess.PIPE, check=True)
    return time.perf_counter() - started, json.loads(done.stdout)["points"]


if __name__ == "__main__":
    typer.run(main)
