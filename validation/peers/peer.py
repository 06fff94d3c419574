"""The common part of all peers: read a case as JSON from standard input and write the result as JSON.

Input: a case of `cases.py` and its refinement. Output: the four quantities in SI units, the number of unknowns, seconds
for imports and for solving, and the peak resident memory; or the reason why the peer was skipped.
"""

import json
import sys
import time
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from numpy.typing import NDArray

Solve = Callable[[dict[str, Any], int], dict[str, Any]]


class SkippedError(Exception):
    """The peer cannot run on this machine."""


def serve(load: Callable[[], Solve]) -> None:
    """Answer one case. `load` imports the modules of the peer, timed apart from solving, and returns the solver."""
    start = time.perf_counter()
    try:
        solve = load()
    except ModuleNotFoundError as problem:
        _write({"skipped": f"{problem.name} is not installed"})
        return
    except SkippedError as problem:
        _write({"skipped": str(problem)})
        return
    imported = time.perf_counter()
    case = json.load(sys.stdin)
    answer = solve(case, case["refinement"])
    seconds = {"import_seconds": imported - start, "solve_seconds": time.perf_counter() - imported}
    _write({**answer, **seconds, "memory": _peak_memory()})


def _write(answer: dict[str, Any]) -> None:
    sys.stdout.write(json.dumps(answer) + "\n")


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
