"""The pieces of a sweep: which points are computed together, and how.

Points that differ only in load and speed form one long series of the torque model, which needs little time for each
point; any other point is a scene of its own. The pieces depend only on the grid, never on the number of workers, so
that a sweep gives the same numbers on any machine. Effects are decided for the points of one scene in one piece; a jump
between pieces is within the tolerance of the scene, since the uncertainties of both pieces are.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import ceil
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.errors import FembearingError
from analytic.labelled import Column
from analytic.prediction.formulas import with_model_uncertainty
from analytic.result import COLUMNS, FrictionTorque
from analytic.scene import Array, Scene
from analytic.torque import friction_torque
from fembearing.sweep.grid import Grid
from fembearing.verify.contact import columns as of_contact

MOST_THRUST = 1000  # points in one piece under thrust: about 3 s with free balls
MOST_SCENES = 50  # in one piece: about 3 s
MOST_RADIAL = 16  # points in one piece, where each ball carries another load: 10 s with free balls and a film
RADIAL = ("operation.radial_load", "operation.moment")
MOST_WARNINGS = 20  # kept for a piece
INTERVAL = {  # what a grid with samples has besides
    "torque_low": Column("N m", "lower end of the 95 % interval of the friction torque"),
    "torque_median": Column("N m", "median of the friction torque"),
    "torque_high": Column("N m", "upper end of the 95 % interval of the friction torque"),
    "torque_low_error": Column("N m", "standard error of the lower end"),
    "torque_high_error": Column("N m", "standard error of the upper end"),
}


@dataclass(frozen=True, kw_only=True)
class Piece:
    """The points from start to stop, numbered as in `Grid`."""

    start: int
    stop: int


@dataclass(frozen=True, kw_only=True, eq=False)
class Part:
    """Results at the n points of a piece."""

    columns: dict[str, Array]  # (n,), NaN where there is no result
    words: dict[str, NDArray[np.str_]] = field(default_factory=dict)  # (n,), empty where there is no result
    reasons: dict[int, str]  # why a point failed, by its number in the piece
    warnings: tuple[str, ...]


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
        yield Piece(start=start, stop=stop)


def column_notes(grid: Grid) -> dict[str, Any]:
    """Unit and meaning of each computed column."""
    if grid.what == "contact":
        return of_contact.COLUMNS
    return COLUMNS if grid.samples is None else COLUMNS | INTERVAL


def compute_part(grid: Grid, piece: Piece) -> Part:
    """Compute all points of a piece. Any failure at a point is recorded as its reason, and the others continue."""
    count = piece.stop - piece.start
    part = Part(
        columns={name: np.full(count, np.nan) for name in column_notes(grid)},
        words={} if grid.what == "torque" else {of_contact.VERDICT: np.zeros(count, dtype="U16")},
        reasons={},
        warnings=(),
    )
    warnings: dict[str, None] = {}  # a set that keeps its order
    for variant in range(piece.start // grid.length, ceil(piece.stop / grid.length)):
        first = variant * grid.length
        points = np.arange(max(first, piece.start), min(first + grid.length, piece.stop))
        try:
            scene = grid.scene(variant)
        except Exception as problem:
            part.reasons.update(dict.fromkeys((points - piece.start).tolist(), _reason(problem)))
            continue
        compute = _contact if grid.what == "contact" else _torque
        for warning in compute(grid, scene, variant, points - first, points - piece.start, part):
            warnings[warning] = None
    return replace(part, warnings=tuple(warnings)[:MOST_WARNINGS])


def _cage_may_move(grid: Grid) -> bool:
    """Whether the motion of a cage is computed, which takes seconds for each point."""
    cage = grid.document.get("cage")
    return (isinstance(cage, dict) and "start" in cage) or any(axis.key == "cage.start" for axis in grid.axes)


def _is_radial(grid: Grid) -> bool:
    """Whether balls may carry unlike loads, so that a series of the torque model integrates every one of them."""
    return any(axis.key in RADIAL for axis in grid.axes) or not grid.first_scene().operation.is_thrust


def _contact(
    grid: Grid, scene: Scene, variant: int, _places: NDArray[np.intp], at: NDArray[np.intp], part: Part
) -> tuple[str, ...]:
    from fembearing.verify.contact.discrepancy import solve_contact

    settings: dict[str, Any] = grid.settings(variant)
    try:
        solution = solve_contact(
            scene,
            pair=settings.get("pair", "inner"),
            load=settings.get("ball_load"),
            accuracy=settings.get("accuracy"),
            geometry=settings.get("geometry", "real"),
        )
    except Exception as problem:
        part.reasons[int(at[0])] = _reason(problem)
        return ()
    for name, value in solution.columns().items():
        part.columns[name][at] = value
    part.words[of_contact.VERDICT][at] = solution.shown_verdict
    return solution.warnings


def _torque(
    grid: Grid, scene: Scene, variant: int, places: NDArray[np.intp], at: NDArray[np.intp], part: Part
) -> tuple[str, ...]:
    """Compute a series, or where that fails each of its halves, so that a failing point does not affect the others."""
    series = _at(grid, scene, places)
    try:
        result = with_model_uncertainty(series, friction_torque(series))
    except Exception as problem:
        if places.size == 1:
            part.reasons[int(at[0])] = _reason(problem)
            return ()
        middle = places.size // 2
        halves = (slice(None, middle), slice(middle, None))
        return tuple(
            warning for half in halves for warning in _torque(grid, scene, variant, places[half], at[half], part)
        )
    for name, values in result.columns().items():
        part.columns[name][at] = values
    if grid.samples is None:
        return result.warnings
    _interval(series, result, grid.samples, at, part)
    return result.warnings


def _interval(series: Scene, result: FrictionTorque, samples: int, at: NDArray[np.intp], part: Part) -> None:
    """Compute the interval of the total. Points without one keep their torque, with the reason."""
    from analytic.prediction.prediction import predicted_interval  # with SciPy's statistics: half a second

    try:
        interval = predicted_interval(series, result, samples=samples)
    except FembearingError as problem:
        part.reasons.update(dict.fromkeys(at.tolist(), f"no interval: {_reason(problem)}"))
        return
    for name, values in vars(interval).items():
        part.columns[f"torque_{name}"][at] = values


def _at(grid: Grid, scene: Scene, places: NDArray[np.intp]) -> Scene:
    """The scene at these points of its series."""
    series = grid.series
    if not series:
        return scene
    indices = np.unravel_index(places, tuple(len(axis.values) for axis in series))
    values = {name: np.resize(value, places.size) for name, value in vars(scene.operation).items()}
    for axis, index in zip(series, indices, strict=True):
        values[axis.key.rpartition(".")[2]] = np.array(axis.values, dtype=np.float64)[index]
    return replace(scene, operation=replace(scene.operation, **values))


def _reason(problem: Exception) -> str:
    """The message in one line, with the class of an exception that is not ours."""
    words = " ".join(str(problem).split())
    return words if isinstance(problem, FembearingError) else f"{type(problem).__name__}: {words}"
