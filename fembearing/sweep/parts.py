"""The pieces of a sweep: which points are computed together, and how.

Points that differ only in load and speed form one long series of the torque model, which needs little time for each
point; any other point is a scene of its own. The pieces depend only on the grid, never on the number of workers, so
that a sweep gives the same numbers on any machine. Effects are decided for the points of one scene in one piece; a jump
between pieces is within the tolerance of the scene, since the uncertainties of both pieces are.
"""

import traceback
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from itertools import pairwise
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.columns import CONTACT_COLUMNS, OF_TORQUE, VERDICT
from analytic.errors import FembearingError
from analytic.labelled import Column
from analytic.prediction.formulas import with_model_uncertainty
from analytic.scene import Scene
from analytic.torque import friction_torque
from fembearing.sweep.grid import Grid

MOST_THRUST = 1000  # points in one piece under thrust: about 3 s with free balls
MOST_SCENES = 50  # in one piece: about 3 s
MOST_RADIAL = 16  # points in one piece, where each ball carries another load: 10 s with free balls and a film
RADIAL = ("operation.radial_load", "operation.moment", "operation.tilt")
REASON = "failure"
FAILURE = {REASON: Column("", "why a point failed; empty where not")}  # without a unit: words
JUDGEMENT = {VERDICT: Column("", "verdict on Hertz by the scene's tolerance")}
INTERVAL = {  # what a grid with samples has besides
    "torque_low": Column("N m", "lower end of the 95 % interval of the friction torque"),
    "torque_median": Column("N m", "median of the friction torque"),
    "torque_high": Column("N m", "upper end of the 95 % interval of the friction torque"),
    "torque_low_error": Column("N m", "standard error of the lower end"),
    "torque_high_error": Column("N m", "standard error of the upper end"),
}


Piece = range  # the numbers of its points, as in `Grid`


@dataclass(frozen=True, kw_only=True, eq=False)
class Part:
    """Results at the n points of a piece."""

    values: dict[str, NDArray[Any]]  # (n,): numbers, NaN where there is none; or words, empty where there is none
    warnings: dict[str, None] = field(default_factory=dict)  # a set that keeps its order
    defects: list[str] = field(default_factory=list)  # tracebacks of exceptions that are our bugs


@dataclass(frozen=True, kw_only=True)
class Failure:
    """What came of points instead of results."""

    reason: str  # in one line
    defect: str | None = None  # the traceback, if it is our bug


def pieces(grid: Grid) -> Iterator[Piece]:
    """All points, in pieces of a few seconds; each contact, and each scene with a moving cage, is its own piece."""
    length, size = grid.length, grid.size
    together = MOST_RADIAL if _is_radial(grid) else MOST_THRUST
    if grid.what == "contact" or _cage_may_move(grid):
        ends = range(size + 1)
    elif grid.samples is not None:  # some hundred torques of each series
        ends = range(0, size + 1, length)
    elif length > together:
        each = ceil(length / together)
        inside = [length * number // each for number in range(each)]
        ends = [*(scene * length + end for scene in range(size // length) for end in inside), size]
    else:
        ends = [*range(0, size, length * max(1, min(MOST_SCENES, together // length))), size]
    for start, stop in pairwise(ends):
        yield Piece(start, stop)


def column_notes(grid: Grid) -> dict[str, Column]:
    """Unit and meaning of each column; a column of words has no unit."""
    if grid.what == "contact":
        return FAILURE | JUDGEMENT | CONTACT_COLUMNS
    return FAILURE | OF_TORQUE | (INTERVAL if grid.samples is not None else {})


def blank(grid: Grid, size: int) -> dict[str, NDArray[Any]]:
    """The columns of a grid without any result, (size,)."""
    return {
        name: np.full(size, np.nan) if note.unit else np.full(size, "", dtype=object)
        for name, note in column_notes(grid).items()
    }


def compute_part(grid: Grid, piece: Piece) -> Part:
    """Compute all points of a piece. Any failure at a point is recorded as its reason, and the others continue."""
    part = Part(values=blank(grid, len(piece)))
    for variant in range(piece.start // grid.length, ceil(piece.stop / grid.length)):
        first = variant * grid.length
        places = np.arange(max(first, piece.start), min(first + grid.length, piece.stop)) - first
        scene = _tried(partial(grid.scene, variant))
        if isinstance(scene, Failure):
            _record(part, places + first - piece.start, scene)
            continue
        compute = partial(_contact, grid, scene, variant) if grid.what == "contact" else partial(_torque, grid, scene)
        _compute(compute, places, first - piece.start, part)
    return part


def _compute(
    compute: Callable[[NDArray[np.intp]], dict[str, Any]], places: NDArray[np.intp], offset: int, part: Part
) -> None:
    """Compute points, or where that fails each half of them, so that a failing point does not affect the others.

    places : in their series;  offset : of the series in the part
    """
    result = _tried(partial(compute, places))
    if not isinstance(result, Failure):
        part.warnings.update(dict.fromkeys(result.pop("warnings")))
        for name, values in result.items():
            part.values[name][places + offset] = values
    elif places.size == 1:
        _record(part, places + offset, result)
    else:
        for half in np.array_split(places, 2):
            _compute(compute, half, offset, part)


def _tried(function: Callable[[], Any]) -> Any:
    """What the function returns, or a Failure."""
    try:
        return function()
    except (FembearingError, MemoryError) as problem:
        return Failure(reason=_in_one_line(problem))
    except Exception as problem:  # a bug costs no other point; `run_sweep` raises it when all of them are done
        return Failure(reason=f"a defect of fembearing: {_in_one_line(problem)}", defect=traceback.format_exc())


def _record(part: Part, at: NDArray[np.intp], failure: Failure) -> None:
    part.values[REASON][at] = failure.reason
    if failure.defect is not None:
        part.defects.append(failure.defect)


def _cage_may_move(grid: Grid) -> bool:
    """Whether the motion of a cage is computed, which takes seconds for each point."""
    cage = grid.document.get("cage")
    return (isinstance(cage, dict) and "start" in cage) or any(axis.key == "cage.start" for axis in grid.axes)


def _is_radial(grid: Grid) -> bool:
    """Whether balls may carry unlike loads, so that a series of the torque model integrates every one of them."""
    return any(axis.key in RADIAL for axis in grid.axes) or not grid.first_scene().operation.is_thrust


def _contact(grid: Grid, scene: Scene, variant: int, _places: NDArray[np.intp]) -> dict[str, Any]:
    """The columns of a contact, and its warnings."""
    from fembearing.check.contact.solution import solve_contact

    settings: dict[str, Any] = grid.settings(variant)
    solution = solve_contact(
        scene,
        pair=settings.get("pair", "inner"),
        load=settings.get("ball_load"),
        accuracy=settings.get("accuracy"),
        geometry=settings.get("geometry", "real"),
    )
    return {**solution.columns(), VERDICT: solution.numbers.verdict, "warnings": solution.numbers.warnings}


def _torque(grid: Grid, scene: Scene, places: NDArray[np.intp]) -> dict[str, Any]:
    """The columns of points of a series, and its warnings; points without an interval have the reason besides."""
    series = _at(grid, scene, places)
    result = with_model_uncertainty(series, friction_torque(series))
    found = {name: values for name, values in result.columns().items() if name in OF_TORQUE}
    found |= {"warnings": result.warnings}
    if grid.samples is None:
        return found
    from analytic.prediction.prediction import predicted_interval  # with SciPy's statistics: half a second

    try:
        interval = predicted_interval(series, result, samples=grid.samples)
    except FembearingError as problem:
        return found | {REASON: f"no interval: {_in_one_line(problem)}"}
    return found | {f"torque_{name}": values for name, values in vars(interval).items()}


def _at(grid: Grid, scene: Scene, places: NDArray[np.intp]) -> Scene:
    """The scene at these points of its series."""
    series = grid.series
    if not series:
        return scene
    indices = np.unravel_index(places, tuple(len(axis.values) for axis in series))
    values = {name: np.resize(value, places.size) for name, value in scene.operation.points.items()}
    for axis, index in zip(series, indices, strict=True):
        values[axis.key.rpartition(".")[2]] = np.array(axis.values, dtype=np.float64)[index]
    return replace(scene, operation=replace(scene.operation, **values))


def _in_one_line(problem: BaseException) -> str:
    """The message, with the class of an exception that is not ours."""
    words = " ".join(str(problem).split())
    return words if isinstance(problem, FembearingError) else f"{type(problem).__name__}: {words}"
