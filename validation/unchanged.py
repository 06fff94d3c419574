"""Compare the numbers of two versions of fembearing, command by command.

    python validation/unchanged.py record before          # in the old version: writes before/*.json
    python validation/unchanged.py record after           # in the new one
    python validation/unchanged.py compare before after   # status 1 where a number, text or key differs

Every case is one command with its exit status and its JSON. Times, memory, versions and dates are left out. Only the
command line is called, so both versions may be laid out differently inside. `compare --relative 1e-12` allows for
round-off where two formulas were merged into one.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, TypeGuard

SCENES = Path(__file__).parent / "scenes"
RUN = "from fembearing.cli import main; main()"
# What two runs of one version differ in: when, where and how fast they ran. The choice of a method follows its time.
VARYING = frozenset(
    (
        *(
            "seconds",
            "spread",
            "repeats",
            "warm_up",
            "predicted",
            "price",
            "chosen",
            "choices",
            "memory",
            "peak_memory",
        ),
        *("file", "maps", "date", "command", "python", "platform", "processor", "cores", "versions"),
        *("fembearing", "numpy", "scipy"),
    )
)

OIL = """
[lubricant]
viscosity = "0.028 Pa s"
pressure_viscosity = "2.1e-8 1/Pa"
eyring_stress = "5 MPa"
traction = "{traction}"
{more}
[surface]
rms_roughness = "{roughness}"
autocorrelation = {{ kind = "{kind}", length = "23 um", spacing = "1 um" }}
"""
SINH = OIL.format(traction="eyring_sinh", more="", roughness="0.07 um", kind="gaussian")
EYRING = OIL.format(traction="eyring_constant", more="", roughness="0.4 um", kind="exponential")
BATH = OIL.format(traction="eyring_sinh", more='supply = "oil_bath"', roughness="0.05 um", kind="gaussian")
GREASE = OIL.format(traction="eyring_sinh", more='supply = "grease"', roughness="0.2 um", kind="gaussian")
COEFFICIENT = "\n[friction]\ncoefficient = 0.083\nhysteresis_loss = 0.006\n"
LOSS = "\n[friction]\nhysteresis_loss = 0.006\n"
SOLVED = 'contact_angle = { rule = "solved", free = "0.18 rad" }'
CLEARANCE = 'contact_angle = { rule = "solved" }\nclearance = "0.015 mm"'
GIVEN = 'contact_angle = { rule = "given", value = "0.31 rad" }'
THRUST = 'axial_load = ["140 N", "900 N"]\ninner_speed = ["90 rpm", "2100 rpm"]'
RADIAL = 'axial_load = "350 N"\nradial_load = ["40 N", "1900 N"]\ninner_speed = "740 rpm"'
MOMENT = 'axial_load = "500 N"\nmoment = ["0.4 N m", "3 N m"]\ninner_speed = "1400 rpm"'
FAST = 'axial_load = "420 N"\ninner_speed = ["3000 rpm", "14000 rpm"]'
UNEQUAL = FAST + '\nradial_load = "90 N"'
STANDSTILL = 'axial_load = "600 N"\ninner_speed = ["0 rpm", "0.02 rpm", "3 rpm"]'
CAGE = '\n[cage]\npocket_clearance = "0.2 mm"\n'
WHIRL = CAGE + 'start = "whirl"\nfriction_coefficient = 0.09\nseeds = 2\nduration = "0.02 s"\n'
GUIDED = (
    WHIRL.replace("whirl", "sudden")
    + 'land = { ring = "outer", clearance = "0.3 mm", width = "10 mm" }\ndrag = "1e-6 N m s"\n'
)


def scene(operation: str, *tables: str, angle: str = SOLVED, tolerance: str = "1 %") -> str:
    return (
        f'name = "unchanged"\ntolerance = "{tolerance}"\n[bearing]\ncatalog = "paper_6205"\n{angle}\n'
        f"[operation]\n{operation}\n" + "".join(tables)
    )


def effects(**decisions: str) -> str:
    return "\n[effects]\n" + "".join(f'{name} = "{decision}"\n' for name, decision in decisions.items())


def cases() -> Iterator[tuple[str, list[str], str | None]]:
    """Name, arguments and scene text of each; None: the built-in scene, or a file that the arguments name."""
    every_effect = dict.fromkeys(
        ("load_distribution", "centrifugal", "gyroscopic", "finite_geometry", "spin", "conformity", "hysteresis"), "on"
    )
    oiled = {**every_effect, **dict.fromkeys(("asperities", "inlet_heating", "starvation", "rolling"), "on")}
    torques = {
        "thrust-coefficient": scene(THRUST, COEFFICIENT),
        "thrust-tight": scene(THRUST, COEFFICIENT, tolerance="0.1 %"),
        "thrust-loose": scene(THRUST, SINH, LOSS, tolerance="10 %"),
        "thrust-sinh": scene(THRUST, SINH, LOSS),
        "thrust-sinh-tight": scene(THRUST, SINH, LOSS, tolerance="0.1 %"),
        "thrust-eyring": scene(THRUST, EYRING, LOSS, angle=CLEARANCE),
        "thrust-given": scene(THRUST, SINH, LOSS, angle=GIVEN),
        "thrust-bath": scene(THRUST, BATH, LOSS),
        "thrust-grease": scene(THRUST, GREASE),
        "thrust-everything": scene(THRUST, GREASE, LOSS, effects(**oiled)),
        "thrust-everything-off": scene(THRUST, SINH, LOSS, effects(**dict.fromkeys(list(oiled)[1:-1], "off"))),
        "radial-coefficient": scene(RADIAL, COEFFICIENT, angle=CLEARANCE),
        "radial-sinh": scene(RADIAL, SINH, LOSS, angle=CLEARANCE),
        "radial-everything": scene(RADIAL, BATH, LOSS, effects(**oiled), angle=CLEARANCE),
        "radial-loose": scene(RADIAL, EYRING, LOSS, angle=CLEARANCE, tolerance="10 %"),
        "moment-sinh": scene(MOMENT, SINH, LOSS),
        "moment-everything": scene(MOMENT, EYRING, LOSS, effects(**oiled), angle=CLEARANCE),
        "fast-sinh": scene(FAST, SINH, LOSS),
        "fast-inertia": scene(FAST, COEFFICIENT, effects(**every_effect)),
        "fast-unequal": scene(UNEQUAL, SINH, effects(**oiled | {"hysteresis": "off"}), angle=CLEARANCE),
        "standstill": scene(STANDSTILL, SINH, LOSS),
        "standstill-coefficient": scene(STANDSTILL, COEFFICIENT),
        "one-coefficient": scene(THRUST, SINH, LOSS + 'sliding = "single_coefficient"\n'),
        "along-axis": scene(THRUST, SINH, LOSS + 'sliding = "along_axis"\n'),
        "over-ellipse": scene(THRUST, SINH, LOSS + 'sliding = "over_ellipse"\n'),
        "inner-control": scene(THRUST, SINH, LOSS + 'spin_rule = "inner_control"\n'),
        "outer-control": scene(THRUST, COEFFICIENT + 'spin_rule = "outer_control"\n'),
        "cage-rest": scene(THRUST, SINH, CAGE, LOSS),
        "cage-whirl": scene(FAST, COEFFICIENT, WHIRL),
        "cage-land": scene('axial_load = "700 N"\ninner_speed = "1800 rpm"', COEFFICIENT, GUIDED),
        "cage-lubricated": scene(FAST, SINH, WHIRL.replace("friction_coefficient = 0.09\n", "")),
        "losses": scene(RADIAL, COEFFICIENT, '\n[losses]\nseals = "5 N mm"\ndrag = "2 N mm"\n', angle=CLEARANCE),
        "series": scene(f"axial_load = {[f'{load} N' for load in range(100, 1300)]}\n"
                        f"inner_speed = {[f'{100 + speed} rpm' for speed in range(1200)]}", SINH, LOSS),
        "overloaded": scene('axial_load = "90 kN"\ninner_speed = "100 rpm"', COEFFICIENT),
        "no-friction-refused": scene(THRUST),
    }  # fmt: skip
    for name, text in torques.items():
        yield f"torque-{name}", ["torque", "--json"], text
    yield "torque-builtin", ["torque", "--json"], None
    for file in sorted(SCENES.glob("*.toml")):
        yield f"torque-{file.stem}", ["torque", "--json", str(file)], None
    for pair in ("inner", "outer", "pocket"):
        for geometry in ("real", "hertzian", "wall" if pair == "pocket" else "ring"):
            options = ["--pair", pair, "--geometry", geometry]
            yield f"contact-{pair}-{geometry}", ["contact", "--json", *options], None
    loads = [part for load in ("10 N", "90 N", "800 N") for part in ("--load", load)]
    yield "contact-series", ["contact", "--json", "--pair", "outer", *loads], None
    yield "mesh", ["mesh", "--json", "--out", "meshes", "--level", "1"], None
    yield "validate-builtin", ["validate", "--json", "--out", "report"], None
    yield "validate-radial", ["validate", "--json"], scene(RADIAL, SINH, LOSS, angle=CLEARANCE, tolerance="5 %")
    yield "validate-cage", ["validate", "--json"], scene(FAST, COEFFICIENT, WHIRL, tolerance="5 %")
    yield "cost-builtin", ["cost", "--json"], None
    sweep = '[axes]\noperation.axial_load = ["200 N", "700 N"]\n{}\n'
    yield (
        "sweep-torque",
        ["sweep", "--json", "--out", "swept"],
        'what = "torque"\nscene = "6205-dry"\n'
        + sweep.format('operation.inner_speed = ["100 rpm", "3000 rpm"]\nbearing.conformity = [0.515, 0.53]'),
    )
    yield (
        "sweep-contact",
        ["sweep", "--json", "--out", "swept"],
        'what = "contact"\nscene = "6205-dry"\n'
        + sweep.format('operation.inner_speed = ["100 rpm"]\npair = ["inner", "outer"]'),
    )


def write(line: str, file: Any = sys.stdout) -> None:
    file.write(line + "\n")


def run(case: tuple[str, list[str], str | None], environment: dict[str, str]) -> dict[str, Any]:
    """Status, standard output and what else was written, of one command in a folder of its own."""
    name, arguments, text = case
    with tempfile.TemporaryDirectory() as place:
        if text is not None:
            (Path(place) / "scene.toml").write_text(text)
            arguments = [arguments[0], "scene.toml", *arguments[1:]]
        command = [sys.executable, "-c", RUN, *arguments]
        done = subprocess.run(command, cwd=place, env=environment, capture_output=True, text=True, check=False)
        found: dict[str, Any] = {"case": name, "status": done.returncode, "errors": done.stderr.splitlines()}
        found["output"] = json.loads(done.stdout) if done.stdout else None
        for report in Path(place).glob("report/report.json"):
            found["report"] = json.loads(report.read_text())
        for dataset in Path(place).glob("swept/*.nc"):
            found["dataset"] = values_of(dataset)
    write(f"{name}: status {done.returncode}", file=sys.stderr)
    return found


def values_of(file: Path) -> dict[str, Any]:
    import xarray  # not needed by any other case

    with xarray.open_dataset(file) as dataset:
        return {str(name): dataset[name].values.astype(object).ravel().tolist() for name in dataset.variables}


def differences(before: Any, after: Any, relative: float, path: str = "") -> Iterator[str]:
    """One line for each place where two documents differ."""
    if isinstance(before, dict) and isinstance(after, dict):
        for key in before.keys() | after.keys():
            if key in VARYING:
                continue
            if key not in before or key not in after:
                yield f"{path}.{key}: {'new' if key in after else 'gone'}"
            else:
                yield from differences(before[key], after[key], relative, f"{path}.{key}")
    elif isinstance(before, list) and isinstance(after, list) and len(before) == len(after):
        for index, pair in enumerate(zip(before, after, strict=True)):
            yield from differences(pair[0], pair[1], relative, f"{path}[{index}]")
    elif is_number(before) and is_number(after):
        if not (
            before == after or math.isclose(before, after, rel_tol=relative) or (before != before and after != after)
        ):
            yield f"{path}: {before!r} is now {after!r}"
    elif before != after:
        yield f"{path}: {str(before)[:160]!r} is now {str(after)[:160]!r}"


def is_number(value: Any) -> TypeGuard[float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def record(folder: Path, only: str) -> int:
    chosen = [case for case in cases() if only in case[0]]
    folder.mkdir(parents=True, exist_ok=True)
    # The last digits of a solver depend on its threads.
    environment = os.environ | {"OMP_NUM_THREADS": "1", "PYTHONPATH": os.getcwd()}
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for found in pool.map(lambda case: run(case, environment), chosen):
            (folder / f"{found['case']}.json").write_text(json.dumps(found, indent=1))
    write(f"{len(chosen)} cases in {folder}")
    return 0


def compare(before: Path, after: Path, relative: float) -> int:
    names = sorted({file.name for file in (*before.glob("*.json"), *after.glob("*.json"))})
    changed = 0
    for name in names:
        documents = [
            json.loads(file.read_text()) if (file := place / name).exists() else None for place in (before, after)
        ]
        found = list(differences(documents[0], documents[1], relative))
        changed += bool(found)
        for line in found[:20]:
            write(f"{name}{line}")
        if len(found) > 20:
            write(f"{name}: {len(found) - 20} more")
    write(f"{len(names)} cases, {changed} differ")
    return int(changed > 0)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    recording = commands.add_parser("record", help="run every case with the version in this folder")
    recording.add_argument("folder", type=Path)
    recording.add_argument("--only", default="", help="cases whose name holds this text")
    comparing = commands.add_parser("compare", help="list what differs between two records")
    comparing.add_argument("before", type=Path)
    comparing.add_argument("after", type=Path)
    comparing.add_argument("--relative", type=float, default=0.0, help="largest relative difference; 0: bit by bit")
    given = parser.parse_args()
    if given.command == "record":
        return record(given.folder, given.only)
    return compare(given.before, given.after, given.relative)


if __name__ == "__main__":
    sys.exit(main())
