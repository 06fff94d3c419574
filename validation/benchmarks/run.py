"""How fast is this tree beside another? python validation/benchmarks/run.py [--against COMMIT_OR_WHEEL] [--short]

Each row is an expression with its set-up. It is timed in this tree and in another one in turns, each time in a new
process: the expression is repeated for a twentieth of a second once it is warm, or is called once where the first call
of a process counts. The table has the medians of both trees, the median of the ratios of the pairs, and the difference
of the results. Seconds are those of the processor with its children; wall seconds where several processes work.

The exit status is 1 if a row fails in one of the trees, or if it takes more than 1.3 times as long as in the other tree
in each of three attempts. --json FILE also writes all figures. The machine should be idle for figures to quote.
"""

import argparse
import json
import os
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import median
from typing import Any, Literal

from rich.progress import track

from validation.study import machine, progress
from validation.study import show as show_table

ROOT = Path(__file__).resolve().parents[2]
AGAINST = "c3f112b4"  # renewed after a change that is slower on purpose
ATTEMPTS, PAIRS = 3, 3
SLOWER = 1.3  # times, in each of three attempts: pairs scatter on a machine that does something else too
LIMIT = 3600.0  # s, for one process
ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"), "1")


@dataclass(frozen=True, kw_only=True)
class Row:
    """What is timed; goal : s."""

    title: str
    call: str
    setup: str = ""
    goal: float | None = None
    clock: Literal["cpu", "wall"] = "cpu"
    first: bool = False  # whether the first call of a process counts
    short: bool = False  # whether the short form has it


PHYSICAL, BY_RULE = 'scene("6205_physical")', 'scene("6205_physical", spin_rule="balanced")'
DRY = 'scene("6205-dry", cage=None, spin_rule="balanced")'
POINT, VALIDATE = "friction_torque(one).torque.total[0]", 'command("validate", "6205-dry", "--json"{})'
FIRST, NEXT = 'solve(pair="{}", accuracy={})', 'solve(pair="inner", accuracy=1e-3, load=next(loads))'
CALL = "torque(axial_load={}, inner_speed=300.0, radial_load={})"
FREE, RULED = 'load_scene("6206", {}, speed=300.0)', 'ruled(load_scene("6206", {}, speed=300.0))'
THRUST, RADIAL = "axial_load=1000.0", "radial_load=2000.0"
MOVING = (
    f"cage = replace(dry.cage, start='whirl', duration=0.02); "
    f"one = replace(at({DRY}), cage=cage, effects={{'cage_dynamics': 'on'}})"
)
SWEEP = 'command("sweep", grid({}), "--out", tempfile.mkdtemp(dir=".") + "/out", "--workers", "{}")'
ROWS = {
    "contact": Row(
        title="contact in its groove to 0.1 %", call=FIRST.format("inner", 1e-3), goal=0.5, clock="wall", first=True
    ),
    "next_contact": Row(title="the same, the next load", call=NEXT, goal=0.2, clock="wall", short=True),
    "contact_outer": Row(
        title="contact of the outer race to 0.1 %", call=FIRST.format("outer", 1e-3), goal=0.5, clock="wall", first=True
    ),
    "fine_contact": Row(
        title="contact to 0.05 %", call=FIRST.format("inner", 5e-4), goal=1.5, clock="wall", first=True
    ),
    "dry_point": Row(
        title="torque point, a coefficient given", setup=f"one = at({DRY})", call=POINT, goal=0.1e-3, short=True
    ),
    "thrust_point": Row(
        title="torque point, thrust, closed kinematics", setup=f"one = {RULED.format(THRUST)}", call=POINT, goal=0.3e-3,
        short=True
    ),
    "radial_point": Row(
        title="torque point, radial, closed kinematics", setup=f"one = {RULED.format(RADIAL)}", call=POINT, goal=0.8e-3,
        short=True
    ),
    "free_point": Row(
        title="torque point, thrust, free balls", setup=f"one = {FREE.format(THRUST)}", call=POINT, goal=1e-3,
        short=True
    ),
    "free_radial_point": Row(
        title="torque point, radial, free balls", setup=f"one = {FREE.format(RADIAL)}", call=POINT, goal=4e-3,
        short=True
    ),
    "thrust_call": Row(
        title="call of torque_function, thrust, closed", setup=f"torque = torque_function({RULED.format(THRUST)})",
        call=CALL.format(1000.0, 0.0), goal=0.03e-3
    ),
    "radial_call": Row(
        title="the same, radial, closed", setup=f"torque = torque_function({RULED.format(RADIAL)})",
        call=CALL.format(0.0, 2000.0), goal=0.15e-3
    ),
    "free_call": Row(
        title="the same, thrust, free", setup=f"torque = torque_function({FREE.format(THRUST)})",
        call=CALL.format(1000.0, 0.0), goal=0.6e-3
    ),
    "free_radial_call": Row(
        title="the same, radial, free", setup=f"torque = torque_function({FREE.format(RADIAL)})",
        call=CALL.format(0.0, 2000.0), goal=3e-3
    ),
    "harris": Row(
        title="a plain Harris model, thrust", setup="from validation.benchmarks.harris import plain_torque",
        call="plain_torque(1000.0, 0.0, 300.0)"
    ),
    "harris_radial": Row(
        title="the same, radial", setup="from validation.benchmarks.harris import plain_torque",
        call="plain_torque(0.0, 2000.0, 300.0)"
    ),
    "radial_series": Row(
        title="10 000 points, radial, closed", setup=f"one = at({RULED.format(RADIAL)}, points=10_000, radial=1e3)",
        call=POINT, goal=2.0, clock="wall", first=True
    ),
    "thrust_series": Row(
        title="100 000 thrust points, closed", setup=f"one = at({RULED.format(THRUST)}, points=100_000)", call=POINT,
        clock="wall", first=True
    ),
    "free_series": Row(
        title="1000 points, radial, free", setup=f"one = at({FREE.format(RADIAL)}, points=1000, radial=1e3)",
        call=POINT, clock="wall", first=True
    ),
    "short_series": Row(
        title="200 thrust points", setup=f"one = at({BY_RULE}, points=200)", call=POINT, short=True
    ),
    "first_order": Row(
        title="95 % interval, to first order", setup="from analytic.prediction.first_order import first_order_ends; "
        f"one = {FREE.format(THRUST)}; nominal = friction_torque(one)", call="first_order_ends(one, nominal)[1, 0]",
        goal=0.08
    ),
    "interval": Row(
        title="the same, 1000 samples", call=f"predict({FREE.format(THRUST)}, samples=1000).total.high[0]", goal=1.5,
        clock="wall", first=True
    ),
    "cage": Row(title="torque with a whirling cage, 0.02 s", setup=MOVING, call=POINT),
    "hertz": Row(
        title="one million Hertz contacts", setup="curvature = np.geomspace(37.0, 3.7e7, 10**6)",
        call="hertz_contact(curvature_x=curvature, curvature_y=37.0, load=620.0, modulus=1.13e11).approach[0]"
    ),
    "ring": Row(
        title="equilibrium of a ring at 500 rad/s", setup="from analytic.loads.ring import ring_equilibrium",
        call="ring_equilibrium(dry.bearing, dry.contact_angle, axial_load=300.0, radial_load_x=500.0, "
        "inner_speed=500.0).balls['load'].max()",
    ),
    "first_call": Row(title="first torque of a process", call=f"friction_torque(at({PHYSICAL})).torque.total[0]",
                      goal=0.4, first=True),
    "help": Row(title="fembearing --help", call='command("--help")', goal=0.1, short=True),
    "torque_help": Row(title="fembearing torque --help", call='command("torque", "--help")', goal=0.1),
    "torque": Row(
        title="fembearing torque", call='command("torque", "6206", "--radial-load", "2kN")', goal=0.7, clock="wall",
        short=True
    ),
    "contact_command": Row(
        title="fembearing contact to 5 %", call='command("contact", "--tolerance", "5%", "--json")', goal=1.4,
        clock="wall"
    ),
    "validate": Row(title="fembearing validate", call=VALIDATE.format(""), goal=4.0, clock="wall"),
    "validate_out": Row(
        title="the same with its report", call=VALIDATE.format(', "--out", tempfile.mkdtemp() + "/out"'),
        goal=10.0, clock="wall"
    ),
    "sweep": Row(title="sweep of 4 points", call=SWEEP.format(2, 1)),
    "sweep_one": Row(title="sweep of 8192 points, one worker", call=SWEEP.format(4096, 1), clock="wall", first=True),
    "sweep_two": Row(title="the same, two workers", call=SWEEP.format(4096, 2), clock="wall", first=True),
}  # fmt: skip
# The child: standard input has a row and the folders, standard output gets its figures.
CHILD = """
import json, os, resource, subprocess, sys, tempfile, time
from dataclasses import replace
from pathlib import Path
import numpy as np
import analytic
from analytic import friction_torque, hertz_contact, load_scene, predict, torque_function
from analytic.scene import Operation

row, tree, scenes = json.load(sys.stdin)
assert Path(analytic.__file__).is_relative_to(tree), f"analytic comes from {analytic.__file__}"
sys.path.append(str(Path(scenes).parents[1]))  # of the programs in validation
loads = (620.0 * (1 + 0.07 * number) for number in range(10**6))

def file(name):
    return name if name == "6205-dry" else f"{scenes}/{name}.toml"

def scene(name, **fields):
    return replace(load_scene(file(name)), **fields)

def at(scene, points=1, radial=0.0, **fields):
    random = np.random.default_rng(5)
    axial, speed = random.uniform(100, 2000, points), random.uniform(10, 150, points)
    if points == 1:
        axial[:], speed[:] = 1000.0, 52.0
    operation = Operation(axial_load=axial, inner_speed=speed, radial_load=radial)
    return replace(scene, operation=operation, **fields)

dry = scene("6205-dry")

def ruled(scene):
    return replace(scene, spin_rule="outer_control")

def solve(load=620.0, **options):
    from fembearing import solve_contact
    return solve_contact(dry, load=load, **options).numbers.reference.approach

def grid(points):
    text = (f'scene = {json.dumps(file("6205_physical"))}\\n[axes]\\noperation.inner_speed = ["500 rpm", "1500 rpm"]\\n'
            f'operation.axial_load = {{ from = "200 N", to = "2 kN", count = {points} }}\\n')
    Path("grid.toml").write_text(text, "utf-8")
    return "grid.toml"

def command(*arguments):
    program = "from fembearing.cli import main; main()"
    done = subprocess.run([sys.executable, "-P", "-c", program, *arguments], capture_output=True, text=True)
    if done.returncode not in (0, 1):
        raise RuntimeError(done.stderr.strip().splitlines()[-1])
    return float("nan")

def processor():
    both = map(resource.getrusage, (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    return sum(each.ru_utime + each.ru_stime for each in both)

exec(row["setup"])
call = eval("lambda: " + row["call"])
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
print(json.dumps({"wall": wall / number, "cpu": cpu / number, "result": result if result == result else None}))
"""


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--against", default=AGAINST, metavar="COMMIT_OR_WHEEL")
    parser.add_argument("--rows", nargs="+", choices=ROWS, metavar="ROW", help=", ".join(ROWS))
    parser.add_argument("--short", action="store_true", help="some rows only")
    parser.add_argument("--pairs", type=int, default=PAIRS, help="turns of each row")
    parser.add_argument("--json", type=Path, metavar="FILE")
    options = parser.parse_args()
    names = options.rows or [name for name, row in ROWS.items() if row.short or not options.short]
    with tempfile.TemporaryDirectory() as place:
        trees = [ROOT, *unpacked(options.against, Path(place).resolve())]
        found = {}
        for name in track(names, "rows", console=progress):
            found[name] = measured(ROWS[name], trees, pairs=options.pairs)
    show(found, against=options.against)
    if options.json:
        about = {"machine": machine(), "against": options.against, "rows": found}
        options.json.write_text(json.dumps(about, indent=1) + "\n", "utf-8")
    return int(any(each.get("failed") or each.get("ratio", 0.0) > SLOWER for each in found.values()))


def unpacked(against: str, place: Path) -> list[Path]:
    """A folder with the packages of a wheel or a commit; none where this clone lacks the commit."""
    if against.endswith(".whl"):
        zipfile.ZipFile(against).extractall(place)
        return [place]
    archive = place / "tree.tar"
    git = ("git", "-C", str(ROOT), "archive", "-o", str(archive), against, "analytic", "fembearing", "meshes")
    try:
        subprocess.run(git, check=True, capture_output=True, text=True)
    except (OSError, subprocess.CalledProcessError) as problem:
        reason = str(getattr(problem, "stderr", None) or problem).strip()
        progress.print(f"Nothing is compared, {against} is not in this clone: {reason}")
        return []
    with tarfile.open(archive) as tree:
        tree.extractall(place, filter="data")
    return [place]


def measured(row: Row, trees: list[Path], *, pairs: int) -> dict[str, Any]:
    """Figures of a row in both trees; a row that seems slower is measured again."""
    samples: list[list[dict[str, Any]]] = []
    found: dict[str, Any] = {"title": row.title, "clock": row.clock, "goal": row.goal}
    for attempt in range(ATTEMPTS):
        try:
            if row.first and attempt == 0:  # formulas that a tree has not compiled yet do not count
                for tree in trees:
                    timed(row, tree)
            for turn in range(pairs):
                order = trees if turn % 2 == 0 else trees[::-1]
                pair = {tree: timed(row, tree) for tree in order}
                samples.append([pair[tree] for tree in trees])
        except RuntimeError as problem:
            return found | {"failed": str(problem)}
        figures = [[sample[row.clock] for sample in pair] for pair in samples[attempt * pairs :]]
        found["seconds"] = [median(column) for column in zip(*figures, strict=True)]
        if len(trees) == 1:
            break
        found["ratio"] = median(now / then for now, then in figures)
        found["pairs"] = [now / then for now, then in figures]
        now, then = (sample["result"] for sample in samples[0])
        found["result_differs_by"] = now / then - 1 if now is not None and then else None
        if found["ratio"] <= SLOWER:
            break
    return found


def timed(row: Row, tree: Path) -> dict[str, Any]:
    """Seconds and result of one process. Raises RuntimeError."""
    environment = os.environ | {"PYTHONPATH": str(tree), "PYTHONDONTWRITEBYTECODE": ""}
    environment |= {} if '"validate"' in row.call else ONE_THREAD
    given = json.dumps([asdict(row), str(tree), str(ROOT / "validation" / "scenes")])
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-P", "-c", CHILD]
        done = subprocess.run(
            command, input=given, cwd=folder, env=environment, capture_output=True, text=True, timeout=LIMIT
        )
    if done.returncode:
        raise RuntimeError(f"{tree}: {(done.stderr.strip().splitlines() or ['no message'])[-1]}")
    return json.loads(done.stdout.splitlines()[-1])


def show(found: dict[str, dict[str, Any]], *, against: str) -> None:
    heads = ("row", "what", "this tree, s", f"{against[:12]}, s", "ratio", "goal, s", "result differs by")
    rows = []
    for name, each in found.items():
        seconds = [f"{value:.3g}" for value in each.get("seconds", ())] + ["", ""]
        ratio, differs = each.get("ratio"), each.get("result_differs_by")
        verdict = "" if ratio is None else f"{ratio:.2f}" + (" SLOWER" if ratio > SLOWER else "")
        title = each["title"] + (", wall" if each["clock"] == "wall" else "")
        goal = f"{each['goal']:g}" if each["goal"] else ""
        change = "" if differs is None else f"{differs:+.1e}"
        rows.append((name, title, *seconds[:2], each.get("failed", verdict), goal, change))
    show_table(heads, rows, machine())


if __name__ == "__main__":
    sys.exit(main())
