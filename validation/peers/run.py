"""Our finite elements against other solvers, on cases with an exact answer by Hertz: python validation/peers/run.py

Each solver computes each case with several refinements, each in its own process, all finite elements on one mesh with
one far field, so that only the solver differs. Prints the errors against exact Hertz with seconds and memory. Writes
peers.json and peers.png. Unknowns are the free ones of one body. A solver that is not installed is skipped. A solver
that fails is listed, and the exit status is then 1. --long adds the finest refinement of each solver.
"""

# Standard library only until every peer has run: the peak memory of a child starts at the memory of its parent.
import argparse
import contextlib
import itertools
import json
import os
import platform
import statistics
import subprocess
import sys
import time
import tomllib
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
CASES = tomllib.loads((HERE / "cases.toml").read_text("utf-8"))
LIMIT = 600.0  # s, for one process
NAMES = {
    "ours": "fembearing, finite elements",
    "tamaas": "Tamaas, boundary elements",
    "ngsolve": "NGSolve, finite elements",
    "calculix": "CalculiX, finite elements",
}
# Module, refinements, and those added by --long, of each peer
LADDERS: dict[str, tuple[str, tuple[int, ...], tuple[int, ...]]] = {
    "ours": ("ours", (1, 2, 3, 4), (6,)),
    "tamaas": ("tamaas_bem", (16, 32, 64, 128, 256), (512,)),
    "ngsolve": ("ngsolve_contact", (1, 2, 3, 4), (6,)),
    "calculix": ("calculix", (1, 2, 3), (4,)),
}


def main(argv: list[str] | None = None) -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--peers", nargs="+", choices=NAMES, default=list(NAMES), metavar="PEER", help=", ".join(NAMES))
    parser.add_argument("--cases", nargs="+", choices=CASES, default=list(CASES), metavar="CASE", help=", ".join(CASES))
    parser.add_argument("--out", type=Path, default=HERE, help="folder for peers.json and peers.png")
    parser.add_argument("--repeats", type=int, default=1, help="processes for each row; their median counts")
    parser.add_argument("--steps", type=int, help="number of refinements of each solver, coarsest first")
    parser.add_argument("--long", action="store_true", help="add the finest refinement of each solver")
    options = parser.parse_args(argv)
    for name in ("repeats", "steps"):
        if getattr(options, name) is not None and getattr(options, name) < 1:
            parser.error(f"--{name} must be at least 1, got {getattr(options, name)}")
    start = time.perf_counter()
    rows, skipped = [], {}
    for peer in dict.fromkeys(options.peers):
        module, ordinary, finest = LADDERS[peer]
        ladder = (ordinary + (finest if options.long else ()))[: options.steps]
        for name, refinement in itertools.product(dict.fromkeys(options.cases), ladder):
            row = measured(module, CASES[name], refinement, repeats=options.repeats)
            if "skipped" in row:
                skipped[peer] = row["skipped"]
                sys.stderr.write(f"{peer} skipped: {row['skipped']}\n")
                break
            rows.append({"peer": peer, "case": name, "refinement": refinement, **row})
            sys.stderr.write(f"{peer} {name} {refinement}: {row.get('failed') or row['solve_seconds']}\n")
    from validation.peers.shown import draw, exact_answer, print_table, with_errors

    exact = {name: exact_answer(CASES[name]) for name in options.cases}
    result = {
        "command": sys.argv if argv is None else ["run.py", *argv],
        "machine": f"{platform.machine()}, {os.cpu_count()} cores, {platform.system()}, "
        f"Python {platform.python_version()}",
        "versions": versions(),
        "seconds": time.perf_counter() - start,
        "cases": {name: CASES[name] | {"exact": exact[name]} for name in options.cases},
        "rows": list(with_errors(rows, exact)),
        "skipped": skipped,
    }
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "peers.json").write_text(json.dumps(result, indent=1) + "\n", "utf-8")
    print_table(result)
    if any("errors" in row for row in result["rows"]):
        draw(result, options.out / "peers.png", names=NAMES)
    return 1 if any("failed" in row for row in rows) else 0


def versions() -> dict[str, str]:
    """Versions of the installed peers, by package or program."""
    installed = {}
    for package in ("fembearing", "tamaas", "ngsolve"):
        with contextlib.suppress(PackageNotFoundError):
            installed[package] = version(package)
    with contextlib.suppress(OSError):
        installed["ccx"] = subprocess.run(["ccx", "-v"], capture_output=True, text=True).stdout.split()[-1]
    return installed


def measured(module: str, case: dict[str, Any], refinement: int, *, repeats: int) -> dict[str, Any]:
    """One row: the answer of a peer, with median seconds and largest memory over its processes."""
    answers = []
    for _ in range(repeats):
        answers.append(answer_of(module, case, refinement))
        if "skipped" in answers[-1] or "failed" in answers[-1]:
            return answers[-1]
    clocks = ("import_seconds", "solve_seconds", "process_seconds")
    seconds = {clock: statistics.median(answer[clock] for answer in answers) for clock in clocks}
    solving = [answer["solve_seconds"] for answer in answers]
    return {
        **answers[-1],
        **seconds,
        "spread_seconds": max(solving) - min(solving),
        "memory": max((answer["memory"] for answer in answers if answer["memory"]), default=None),
        "repeats": repeats,
    }


def answer_of(module: str, case: dict[str, Any], refinement: int) -> dict[str, Any]:
    """The answer of a peer to a case, or `skipped` or `failed` with the reason."""
    question = json.dumps({**case, "refinement": refinement})
    start = time.perf_counter()
    try:
        command = [sys.executable, HERE / "peer.py", module]
        done = subprocess.run(command, input=question, capture_output=True, text=True, timeout=LIMIT)
        lines = done.stdout.splitlines()
        if done.returncode or not lines:
            last = (done.stderr.splitlines() or ["no message"])[-1]
            return {"failed": f"ended with status {done.returncode}: {last}"}
        answer = json.loads(lines[-1])  # a library may print earlier lines
    except subprocess.TimeoutExpired:
        return {"failed": f"no answer within {LIMIT:g} s"}
    except (OSError, json.JSONDecodeError) as problem:
        return {"failed": f"no answer: {problem}"}
    return {**answer, "process_seconds": time.perf_counter() - start}


if __name__ == "__main__":
    sys.exit(main())
