"""A peer in a process of its own: read a case as JSON from standard input and write the result as JSON.

The peer is a module of this folder with a function `solve`, named on the command line. Input: a case of cases.toml and
its refinement. Output: the four quantities in SI units, the number of unknowns, seconds for imports and for solving,
and the peak resident memory; or the reason why the peer was skipped.
"""

import json
import sys
import time
from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import NDArray


def answer(peer: str) -> dict[str, Any]:
    """The answer to a case; a peer that cannot run on this machine raises an ImportError when it is imported."""
    start = time.perf_counter()
    try:
        solve = import_module(f"validation.peers.{peer}").solve
    except ImportError as problem:
        return {"skipped": f"{problem.name} is not installed" if problem.name else str(problem)}
    imported = time.perf_counter()
    case = json.load(sys.stdin)
    found = solve(case, case["refinement"])
    seconds = {"import_seconds": imported - start, "solve_seconds": time.perf_counter() - imported}
    return {**found, **seconds, "memory": _peak_memory()}


def _peak_memory() -> int | None:
    """Bytes, the larger of this process and its child processes; None where the system does not record it."""
    try:
        import resource
    except ModuleNotFoundError:  # Windows
        return None
    unit = 1 if sys.platform == "darwin" else 1024  # ru_maxrss is in bytes on macOS, in kilobytes elsewhere
    return unit * max(resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))


def semi_axis(position: "NDArray", force: "NDArray") -> float:
    """sqrt(5 sum(F s^2)/sum(F)), m: semi-axis of the semi-ellipsoidal pressure with the same second moment.

    position : s, m;  force : F, N; arrays of one shape
    """
    return float((5 * (force * position**2).sum() / force.sum()) ** 0.5)


def peak_pressure(
    x: "NDArray", y: "NDArray", pressure: "NDArray", area: "NDArray", *, semi_axes: tuple[float, float]
) -> float:
    """Pressure at the centre, Pa, as in fembearing: a fit of p^2 over the inner half of the ellipse.

    For a semi-ellipsoidal pressure p^2 is c0 + c1 x^2 + c2 y^2. The weight of a point is its `area`, m^2.
    """
    import numpy as np

    rolling, transverse = (x / semi_axes[0]) ** 2, (y / semi_axes[1]) ** 2
    inner = rolling + transverse < 0.5
    weight = np.sqrt(area[inner])
    terms = np.column_stack([np.ones(inner.sum()), rolling[inner], transverse[inner]])
    fitted = np.linalg.lstsq(terms * weight[:, None], pressure[inner] ** 2 * weight, rcond=None)[0]
    return float(np.sqrt(fitted[0]))


if __name__ == "__main__":
    sys.stdout.write(json.dumps(answer(sys.argv[1])) + "\n")
