"""Error and cost of the finite elements at every shape of contact: python validation/benchmarks/ratios.py

Solves the Hertzian idealisation at curvature ratios from 1 to 30 to 0.1 % and to 0.05 % by two methods. `mesh` is one
mesh made for the ellipse known to 1 %, on the coarsest level whose four errors are small enough. `reference` is the
procedure of `fembearing contact` for a given accuracy, which includes the size of the ellipse and the interval. Prints
the errors of approach, both semi-axes and peak pressure against exact Hertz, with seconds and peak memory, and writes
them with machine and command to ratios.json in this folder (--out names another folder). Each row has its own
process, which solves another contact before the clock starts. The exit status is 1 if any row fails.
"""

# The parent imports the standard library only: the peak memory of a child starts at the memory of its parent.
import argparse
import json
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

from validation.benchmarks.machine import machine

HERE = Path(__file__).resolve().parent
RATIOS = (1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 13.0, 20.0, 30.0)  # rolling over transverse relative curvature
TARGETS = {1e-3: (1.0, 0.5), 5e-4: (3.0, 1.0)}  # accuracy: target seconds and GB
LEVELS = (1, 2, 3, 4)
METHODS = ("mesh", "reference")
RADIUS, LOAD = 3.97e-3, 620.0  # m, N; relative errors do not depend on them
KNOWN = 1.01  # size of the ellipse for which a mesh is made, over the true one
HEADS = {"approach": "approach", "semi_axis_rolling": "a", "semi_axis_transverse": "b", "peak_pressure": "p0"}
GIGABYTE = 1e9


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument(
        "--ratios", nargs="+", type=float, default=RATIOS, metavar="RATIO", help="curvature ratios, >= 1"
    )
    parser.add_argument("--methods", nargs="+", choices=METHODS, default=METHODS, help="how the contact is solved")
    parser.add_argument("--repeats", type=int, default=1, help="processes for each row; their median counts")
    parser.add_argument("--out", type=Path, default=HERE, help="folder for ratios.json")
    options = parser.parse_args(argv)
    if options.repeats < 1 or min(options.ratios) < 1:
        parser.error("--repeats and --ratios must be at least 1")
    rows = []
    heads = ("ratio", "target, %", "method", "level", *HEADS.values(), "s", "GB")
    sys.stdout.write(" ".join(f"{head:>9}" for head in heads) + "\n")
    for ratio in options.ratios:
        for accuracy in TARGETS:
            for method in options.methods:
                row = measured(ratio, accuracy, method, repeats=options.repeats)
                rows.append(row)
                sys.stdout.write(line(row) + "\n")
                sys.stdout.flush()
    result = {
        "command": sys.argv if argv is None else ["ratios.py", *argv],
        "machine": machine(),
        "targets": [{"accuracy": accuracy, "seconds": s, "gigabytes": gb} for accuracy, (s, gb) in TARGETS.items()],
        "rows": rows,
    }
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "ratios.json").write_text(json.dumps(result, indent=1) + "\n", "utf-8")
    return 1 if any("failed" in row for row in rows) else 0


def line(row: dict[str, Any]) -> str:
    start = f"{row['ratio']:9g} {100 * row['accuracy']:9g} {row['method']:>9}"
    if "failed" in row:
        return f"{start} failed: {row['failed']}"
    errors = " ".join(f"{100 * row['errors'][name]:+8.4f}%" for name in HEADS)
    seconds, gigabytes = TARGETS[row["accuracy"]]
    missed = [
        word
        for word, over in (
            ("error", row["worst"] > row["accuracy"]),
            ("time", row["seconds"] > seconds),
            ("memory", row["memory"] > gigabytes * GIGABYTE),
        )
        if over
    ]
    verdict = f"misses its target of {' and '.join(missed)}" if missed else "meets its targets"
    return f"{start} {row['level']:9} {errors} {row['seconds']:9.2f} {row['memory'] / GIGABYTE:9.2f} {verdict}"


def measured(ratio: float, accuracy: float, method: str, *, repeats: int) -> dict[str, Any]:
    """One row. `mesh` takes the coarsest level that is accurate enough, or the finest."""
    case = {"ratio": ratio, "accuracy": accuracy, "method": method}
    first: dict[str, Any] = {}
    for level in LEVELS if method == "mesh" else (None,):
        first = answer({**case, "level": level})
        if "failed" in first or first["worst"] <= accuracy:
            break
    if "failed" in first:
        return case | first
    more = [answer({**case, "level": first["level"]}) for _ in range(repeats - 1)]
    every = [first, *(each for each in more if "failed" not in each)]
    return {
        **case,
        **first,
        "seconds": statistics.median(each["seconds"] for each in every),
        "memory": max(each["memory"] for each in every),
        "repeats": len(every),
    }


def answer(case: dict[str, Any]) -> dict[str, Any]:
    """The answer of a new process to a case, or `failed` with the reason."""
    done = subprocess.run(
        [sys.executable, "-c", "import ratios; ratios.serve()"],
        input=json.dumps(case),
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).parent,
    )
    if done.returncode:
        return {"failed": (done.stderr.splitlines() or ["no message"])[-1]}
    return json.loads(done.stdout.splitlines()[-1])


def serve() -> None:
    """Solve the case on standard input and write the answer, SI and relative, to standard output."""
    import resource

    case = json.load(sys.stdin)
    solved(case | {"ratio": 1.7, "level": 1, "accuracy": 0.5})  # warm
    start = time.perf_counter()
    result = solved(case)
    result["seconds"] = time.perf_counter() - start
    unit = 1 if sys.platform == "darwin" else 1024  # ru_maxrss is in bytes on macOS, in kilobytes elsewhere
    result["memory"] = unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    sys.stdout.write(json.dumps(result) + "\n")


def solved(case: dict[str, Any]) -> dict[str, Any]:
    """Errors against exact Hertz, and the level used."""
    from math import inf

    from analytic.contact.hertz import contact_modulus, hertz_contact
    from analytic.scene import Contact, Material
    from fembearing.fem.solution import solve_on_mesh
    from fembearing.mesh.recipe import load_recipe
    from fembearing.progress import silent
    from fembearing.verify.contact.reference import solve_reference

    steel = Material(name="steel", youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0, source="benchmark")
    contact = Contact(
        pair="outer",
        ball_radius=RADIUS,
        groove_radius=inf if case["ratio"] == 1 else RADIUS / (1 - 1 / case["ratio"]),
        rolling_radius=inf,  # a straight groove
        shoulder=inf,
        far_shoulder=inf,
        contact_angle=0.0,
        load=LOAD,
        ball_material=steel,
        race_material=steel,
    )
    hertz = hertz_contact(
        curvature_x=1 / RADIUS,
        curvature_y=1 / RADIUS / case["ratio"],
        load=LOAD,
        modulus=contact_modulus(steel, steel),
    )
    exact = {
        "approach": float(hertz.approach),
        "semi_axis_rolling": float(hertz.semi_axis_x),
        "semi_axis_transverse": float(hertz.semi_axis_y),
        "peak_pressure": float(hertz.peak_pressure),
    }
    recipe = load_recipe("hertzian")
    if case["method"] == "mesh":
        ellipse = KNOWN * exact["semi_axis_rolling"], KNOWN * exact["semi_axis_transverse"]
        finest = solve_on_mesh(contact, recipe=recipe, level=case["level"], semi_axes=ellipse)
        values = vars(finest.quantities)
    else:
        reference = solve_reference(contact, recipe=recipe, accuracy=case["accuracy"], progress=silent)
        finest = reference.meshes[-1]
        values = {name: part.value for name, part in reference.estimates.items()}
    errors = {name: values[name] / exact[name] - 1 for name in HEADS}
    worst = max(map(abs, errors.values()))
    return {"level": finest.level, "unknowns": finest.unknowns, "errors": errors, "worst": worst}


if __name__ == "__main__":
    sys.exit(main())
