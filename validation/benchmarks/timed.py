"""A row of rows.toml in a process of its own, for run.py: standard input has the row, the tree and the scenes.

The names here are those that a row may use. `analytic` and `fembearing` are those of the tree, which may be older.
"""

import json
import resource
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

import numpy as np

import analytic
from analytic import friction_torque, hertz_contact, load_scene, predict, torque_function  # noqa: F401 - of the rows
from analytic.scene import Operation

row, tree, scenes = json.load(sys.stdin)
assert Path(analytic.__file__).is_relative_to(tree), f"analytic comes from {analytic.__file__}"
sys.path.append(str(Path(scenes).parents[1]))  # of the programs in validation
loads = (620.0 * (1 + 0.07 * number) for number in range(10**6))


def scene(name, **fields):
    return replace(load_scene(name if name == "6205-dry" else f"{scenes}/{name}.toml"), **fields)


def at(scene, points=1, radial=0.0, **fields):
    random = np.random.default_rng(5)
    axial, speed = random.uniform(100, 2000, points), random.uniform(10, 150, points)
    if points == 1:
        axial[:], speed[:] = 1000.0, 52.0
    operation = Operation(axial_load=axial, inner_speed=speed, radial_load=radial)
    return replace(scene, operation=operation, **fields)


def ruled(scene):
    return replace(scene, spin_rule="outer_control")


dry = scene("6205-dry")


def uncaged():
    return replace(dry, cage=None, spin_rule="balanced")


def thrust():
    return load_scene("6206", axial_load=1000.0, speed=300.0)


def radial():
    return load_scene("6206", radial_load=2000.0, speed=300.0)


def whirling():
    cage = replace(dry.cage, start="whirl", duration=0.02)
    return replace(at(uncaged()), cage=cage, effects={"cage_dynamics": "on"})


def solve(load=620.0, **options):
    from fembearing import solve_contact

    return solve_contact(dry, load=load, **options).numbers.reference.approach


def series(loads):
    from fembearing import solve_load_series

    return solve_load_series(dry, pair="inner", loads=loads).meshes


def sweep(points, workers):
    Path("grid.toml").write_text(
        f"scene = {json.dumps(f'{scenes}/6205_physical.toml')}\n"
        '[axes]\noperation.inner_speed = ["500 rpm", "1500 rpm"]\n'
        f'operation.axial_load = {{ from = "200 N", to = "2 kN", count = {points} }}\n',
        "utf-8",
    )
    return command("sweep", "grid.toml", "--out", tempfile.mkdtemp(dir=".") + "/out", "--workers", str(workers))


def command(*arguments):
    program = "from fembearing.cli import main; main()"
    done = subprocess.run([sys.executable, "-P", "-c", program, *arguments], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise RuntimeError(done.stderr.strip().splitlines()[-1])
    return float("nan")


def processor():
    both = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(each.ru_utime + each.ru_stime for each in both)


if row["scene"]:
    one = eval(row["scene"])
    row["call"] = "friction_torque(one).torque.total[0]"
exec(row["setup"])
call = eval(f"lambda: {row['call']}")
number = 1
if not row["first"]:
    result, start = float(call()), time.perf_counter()
    call()
    number = max(1, round(0.05 / (time.perf_counter() - start)))
wall, cpu = time.perf_counter(), processor()
for _ in range(number):
    found = call()
wall, cpu = time.perf_counter() - wall, processor() - cpu
result = float(found) if row["first"] else result
figures = {"wall": wall / number, "cpu": cpu / number, "result": result if result == result else None}
sys.stdout.write(json.dumps(figures) + "\n")
