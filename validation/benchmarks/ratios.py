"""Error and price of the finite elements at every shape of contact: python validation/benchmarks/ratios.py

Solves the Hertzian idealisation at curvature ratios from 1 to 30 to 0.1 % and to 0.05 %, two ways: `mesh`, one mesh
made for the ellipse known to 1 %, on the coarsest level whose four errors are that small; `reference`, what
`fembearing contact` does for an asked accuracy, size of the ellipse and interval included. Prints the errors of
approach, both semi-axes and peak pressure against exact Hertz, with seconds and peak memory of a process of its own
each, and writes them with machine and command to ratios.json in validation/reports (--out names another folder).
Seconds are those of a warm process: a first, other contact is solved before the clock starts. The exit status is 1 if
any row fails.
"""

# Standard library only in the parent: a child's record of its largest memory starts at that of its parent.
import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

REPORTS = Path(__file__).resolve().parents[1] / "reports"
RATIOS = (1.0, 1.5, 2.0, 3.0, 5.0, 8.0, 13.0, 20.0, 30.0)  # of the relative curvature along rolling to that across
ASKED = {1e-3: (1.0, 0.5), 5e-4: (3.0, 1.0)}  # accuracy: s and GB that the project aims at
LEVELS = (1, 2, 3, 4)
WAYS = ("mesh", "reference")
RADIUS, LOAD = 3.97e-3, 620.0  # m, N: neither changes a relative error
KNOWN = 1.01  # the ellipse that a mesh is made for, over the true one
HEADS = {"approach": "approach", "semi_axis_rolling": "a", "semi_axis_transverse": "b", "peak_pressure": "p0"}
GIGABYTE = 1e9


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ratios", nargs="+", type=float, default=RATIOS, metavar="RATIO", help="of curvatures, >= 1")
    parser.add_argument("--ways", nargs="+", choices=WAYS, default=WAYS, help="how the contact is solved")
    parser.add_argument("--repeats", type=int, default=1, help="processes for each row, of which the median counts")
    parser.add_argument("--out", type=Path, default=REPORTS, help="folder for ratios.json")
    asked = parser.parse_args(argv)
    if asked.repeats < 1 or min(asked.ratios) < 1:
        parser.error("--repeats and --ratios must be at least 1")
    rows = []
    heads = ("ratio", "asked, %", "way", "level", *HEADS.values(), "s", "GB")
    sys.stdout.write(" ".join(f"{head:>9}" for head in heads) + "\n")
    for ratio in asked.ratios:
        for accuracy in ASKED:
            for way in asked.ways:
                row = measured(ratio, accuracy, way, repeats=asked.repeats)
                rows.append(row)
                sys.stdout.write(line(row) + "\n")
                sys.stdout.flush()
    result = {
        "command": sys.argv if argv is None else ["ratios.py", *argv],
        "machine": f"{platform.machine()}, {os.cpu_count()} cores, {platform.system()}, "
        f"Python {platform.python_version()}",
        "aims": [{"accuracy": accuracy, "seconds": s, "gigabytes": gb} for accuracy, (s, gb) in ASKED.items()],
        "rows": rows,
    }
    asked.out.mkdir(parents=True, exist_ok=True)
    (asked.out / "ratios.json").write_text(json.dumps(result, indent=1) + "\n", "utf-8")
    return 1 if any("failed" in row for row in rows) else 0


def line(row: dict[str, Any]) -> str:
    start = f"{row['ratio']:9g} {100 * row['accuracy']:9g} {row['way']:>9}"
    if "failed" in row:
        return f"{start} failed: {row['failed']}"
    errors = " ".join(f"{100 * row['errors'][name]:+8.4f}%" for name in HEADS)
    seconds, gigabytes = ASKED[row["accuracy"]]
    missed = [
        word
        for word, over in (
            ("error", row["worst"] > row["accuracy"]),
            ("time", row["seconds"] > seconds),
            ("memory", row["memory"] > gigabytes * GIGABYTE),
        )
        if over
    ]
    verdict = f"misses its {' and '.join(missed)}" if missed else "as asked"
    return f"{start} {row['level']:9} {errors} {row['seconds']:9.2f} {row['memory'] / GIGABYTE:9.2f} {verdict}"


def measured(ratio: float, accuracy: float, way: str, *, repeats: int) -> dict[str, Any]:
    """One row; of a mesh, the coarsest level that is accurate enough, or the finest."""
    case = {"ratio": ratio, "accuracy": accuracy, "way": way}
    found: dict[str, Any] = {}
    for level in LEVELS if way == "mesh" else (None,):
        found = answer({**case, "level": level})
        if "failed" in found or found["worst"] <= accuracy:
            break
    if "failed" in found:
        return case | found
    more = [answer({**case, "level": found["level"]}) for _ in range(repeats - 1)]
    every = [found, *(each for each in more if "failed" not in each)]
    return {
        **case,
        **found,
        "seconds": statistics.median(each["seconds"] for each in every),
        "memory": max(each["memory"] for each in every),
        "repeats": len(every),
    }


def answer(case: dict[str, Any]) -> dict[str, Any]:
    """What a process of its own says of a case: an answer or `failed`."""
    done = subprocess.run(
        [sys.executable, "-c", "import ratios; ratios.serve()"],
        input=json.dumps(case),
        capture_output=True,
        text=True,
        check=False,
        cwd=Path(__file__).parent,
    )
    if done.returncode:
        return {"failed": (done.stderr.splitlines() or ["without a word"])[-1]}
    return json.loads(done.stdout.splitlines()[-1])


def serve() -> None:
    """Solve the case on standard input; the answer, SI and relative, goes to standard output."""
    import resource

    case = json.load(sys.stdin)
    solved(case | {"ratio": 1.7, "level": 1, "accuracy": 0.5})  # warm
    start = time.perf_counter()
    found = solved(case)
    found["seconds"] = time.perf_counter() - start
    unit = 1 if sys.platform == "darwin" else 1024  # ru_maxrss is in bytes there, in kilobytes elsewhere
    found["memory"] = unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    sys.stdout.write(json.dumps(found) + "\n")


def solved(case: dict[str, Any]) -> dict[str, Any]:
    """Errors against exact Hertz, and the level that gave them."""
    from math import inf

    from analytic.contact.hertz import contact_modulus, hertz_contact
    from analytic.scene import Contact, Material
    from fembearing.compare.contact.mesh_refinement import solve_reference
    from fembearing.fem.solution import solve_on_mesh
    from fembearing.mesh.recipe import load_recipe
    from fembearing.progress import silent

    steel = Material(name="steel", youngs_modulus=206e9, poisson_ratio=0.3, density=7850.0, source="the case's")
    contact = Contact(
        pair="outer",
        ball_radius=RADIUS,
        groove_radius=inf if case["ratio"] == 1 else RADIUS / (1 - 1 / case["ratio"]),
        rolling_radius=inf,  # a straight groove
        shoulder=inf,
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
    if case["way"] == "mesh":
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
