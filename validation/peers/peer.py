"""What every peer's program does alike: a case comes as JSON on standard input, a result goes out as JSON.

In: a case of `cases.py` and its refinement. Out: the four quantities in SI units, the unknowns, seconds of importing
and of solving, and the largest resident memory; or why the peer was skipped.
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
    """Answer one case. `load` imports what the peer needs, timed apart from solving, and returns the solver."""
    start = time.perf_counter()
    try:
        solve = load()
    except ModuleNotFoundError as problem:
        _tell({"skipped": f"{problem.name} is not installed"})
        return
    except SkippedError as problem:
        _tell({"skipped": str(problem)})
        return
    imported = time.perf_counter()
    case = json.load(sys.stdin)
    found = solve(case, case["refinement"])
    seconds = {"import_seconds": imported - start, "solve_seconds": time.perf_counter() - imported}
    _tell({**found, **seconds, "memory": _peak_memory()})


def _tell(answer: dict[str, Any]) -> None:
    sys.stdout.write(json.dumps(answer) + "\n")


def _peak_memory() -> int | None:
    """Bytes: the larger of this process and of a solver that it ran as a program of its own; None if not recorded."""
    try:
        import resource
    except ModuleNotFoundError:  # Windows
        return None
    unit = 1 if sys.platform == "darwin" else 1024  # ru_maxrss is in bytes there, in kilobytes elsewhere
    return unit * max(resource.getrusage(who).ru_maxrss for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))


def semi_axis(position: "NDArray", force: "NDArray") -> float:
    """sqrt(5 sum(F s^2)/sum(F)), m: that of the semi-ellipsoidal pressure with the same second moment.

    position : s, m, and force : F, N, of one shape
    """
    return float((5 * (force * position**2).sum() / force.sum()) ** 0.5)


def peak_pressure(
    x: "NDArray", y: "NDArray", pressure: "NDArray", area: "NDArray", *, semi_axes: tuple[float, float]
) -> float:
    """Pressure at the centre, Pa, by the rule that ours uses too: p^2 fitted over the inner half of the ellipse.

    p^2 is c0 + c1 x^2 + c2 y^2 where the pressure is semi-ellipsoidal; points count by their `area`, m^2.
    """
    import numpy as np

    along, across = (x / semi_axes[0]) ** 2, (y / semi_axes[1]) ** 2
    inner = along + across < 0.5
    weight = np.sqrt(area[inner])
    terms = np.column_stack([np.ones(inner.sum()), along[inner], across[inner]])
    fitted = np.linalg.lstsq(terms * weight[:, None], pressure[inner] ** 2 * weight, rcond=None)[0]
    return float(np.sqrt(fitted[0]))
