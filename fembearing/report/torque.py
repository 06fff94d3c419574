"""The record of a torque: a row for each operating point, and all that is said of it, as JSON holds it."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated

from annotated_types import MinLen

from analytic.columns import Point, rows_of
from analytic.effects import Effect
from analytic.prediction.rows import COVERED
from analytic.prediction.spreads import UncertainInput
from analytic.result import PairPart
from analytic.rows import Count, NotNegative, Positive
from analytic.scene import ArrangementKind, Clearances
from analytic.scene_torque import SceneTorque
from analytic.scenefile.inputs import StatedInput
from analytic.standing import Standing
from analytic.verdicts import Verdicts
from fembearing.plain_types import plain

if TYPE_CHECKING:  # with SciPy's statistics, which take half a second to import
    from analytic.prediction.prediction import Prediction

Points = tuple[Mapping[str, float | None], ...]  # the numbers of each operating point by the names of `COLUMNS`
Rows = tuple[Point, ...]  # the same with texts, lists and groups


@dataclass(frozen=True, kw_only=True)
class MakersContent:
    """What the makers' formulas give."""

    note: str  # whose models hold, or why none does
    torque: Mapping[str, tuple[float | None, ...]]  # at each point, N m, by the name of the model; None: does not hold


@dataclass(frozen=True, kw_only=True)
class OtherCandidate:
    """The balls that the ratings fit nearly as well, and the total torque with them at each point."""

    ball_count: int
    ball_diameter: Positive  # m
    total: tuple[float | None, ...]  # N m


@dataclass(frozen=True, kw_only=True)
class PairContent:
    """A pair of bearings."""

    kind: ArrangementKind
    at_standstill: Mapping[str, float]  # preload, N; the offset that it closes and the distance of the middles, m
    points: Points  # of the shaft, m, rad and N/m, and of each bearing in its own frame, N, N m; flags are 0 or 1


@dataclass(frozen=True, kw_only=True)
class PredictionContent:
    """The 95 % interval by samples."""

    covered: float  # probability
    points: Points  # ends, median and standard errors of the total, of its parts, and by each cause alone, N m
    # Sobol indices of the total and their standard errors: of each input, at each point that has a torque
    indices: Mapping[str, tuple[tuple[float, ...], ...]]
    inputs: tuple[UncertainInput, ...]
    not_varied: tuple[str, ...]  # what the interval does not know, in words
    samples: Count
    failed: int  # of them
    reasons: tuple[str, ...]  # why
    seed: int
    seconds: NotNegative
    evaluation_seconds: NotNegative


@dataclass(frozen=True, kw_only=True)
class TorqueContent:
    """What JSON holds of a friction torque; SI."""

    points: Annotated[Points, MinLen(1)]
    cage: Rows | None  # see Columns of the cage; None: it does not count
    ring: Rows | None  # see Columns of the ring; None for a pair
    gap_roughness: Positive | None  # m
    clearances: Clearances | None
    pair: PairContent | None
    effects: tuple[Effect, ...]
    warnings: tuple[str, ...]
    measured_points: tuple[int, ...]  # at which shares of effects are measured, from 0
    provenance: Mapping[str, str]
    seconds: NotNegative
    tolerance: Positive
    makers: MakersContent
    verdicts: Verdicts
    notes: tuple[str, ...]  # none of them is judged
    inputs: tuple[StatedInput, ...]
    other_candidate: OtherCandidate | None
    prediction: PredictionContent | None
    standing: Standing  # how far the torque can be trusted, in one word
    left_out: Rows  # points without a torque: number from 0, loads, speed and reason; their other numbers are null


def content_of(result: SceneTorque) -> TorqueContent:
    """What JSON holds of a torque. A number that is not known is None, also at a point without a torque."""
    friction, places = result.friction, result.places
    makers = {name: tuple(plain(values)) for name, values in result.makers.items()}
    of_torque = ("gap_roughness", "clearances", "warnings", "provenance", "seconds")
    return TorqueContent(
        points=result.points,
        cage=None if friction.cage is None else rows_of(places.columns(friction.cage.columns())),
        ring=None if friction.ring is None else rows_of(places.columns(friction.ring.columns())),
        pair=None if friction.pair is None else _pair(friction.pair, result),
        effects=tuple(friction.effects),
        measured_points=friction.effects.among(places.computed).points,
        **{name: getattr(friction, name) for name in of_torque},
        tolerance=result.scene.tolerance,
        makers=MakersContent(note=result.catalogue.note, torque=makers),
        verdicts=result.verdicts,
        notes=result.notes,
        inputs=result.inputs,
        other_candidate=_other(result),
        prediction=None if result.prediction is None else _prediction(result.prediction, result),
        standing=result.standing,
        left_out=places.left_out,
    )


def _pair(pair: PairPart, result: SceneTorque) -> PairContent:
    of_pair = {name: getattr(pair.equilibrium, name) for name in ("preload", "offset", "distance")}
    return PairContent(kind=pair.kind, at_standstill=of_pair, points=rows_of(result.places.columns(pair.columns())))


def _prediction(prediction: "Prediction", result: SceneTorque) -> PredictionContent:
    same = ("inputs", "not_varied", "samples", "failed", "reasons", "seed", "seconds", "evaluation_seconds")
    return PredictionContent(
        covered=COVERED,
        points=rows_of(result.places.columns(prediction.columns())),
        indices={name: tuple(map(tuple, values.tolist())) for name, values in vars(prediction.indices).items()},
        **{name: getattr(prediction, name) for name in same},
    )


def _other(result: SceneTorque) -> OtherCandidate | None:
    """Balls and total of the other candidate."""
    other = result.scene.bearing.other_candidate
    if other is None or result.other_candidate is None:
        return None
    total = result.places.columns({"total": result.other_candidate.torque.total})["total"]
    return OtherCandidate(
        ball_count=other.ball_count, ball_diameter=other.ball_diameter, total=tuple(plain(total.tolist()))
    )


def cage_motion(torque: SceneTorque) -> tuple[Point, ...] | None:
    """Each operating point with the columns of OF_CAGE and OF_MOTION; None where no cage moved."""
    part = torque.friction.cage
    if part is None or not any(part.motion):
        return None
    return rows_of({**part.columns(), "inner_speed": torque.friction.inner_speed, **part.motion_columns()})
