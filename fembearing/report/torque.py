"""The record of a torque: a row for each operating point, and all that is said of it, as JSON holds it."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Annotated, Any, Literal

from annotated_types import MinLen

from analytic.cage.statistics import OtherStart
from analytic.cage.torque import CagePoint
from analytic.effects import Effect
from analytic.left_out import LeftOut, Places
from analytic.prediction.rows import PredictionRows
from analytic.result import PairRows, TorquePoint
from analytic.rows import NotNegative, Positive, Two
from analytic.scene import CageStart, Clearances
from analytic.scene_torque import SceneTorque
from analytic.scenefile.inputs import StatedInput
from analytic.standing import Standing
from analytic.verdicts import Verdicts
from fembearing.plain_types import plain

KIND, FORMAT = "fembearing torque", 6  # what the JSON is; the number rises when a key changes its name or meaning


@dataclass(frozen=True, kw_only=True)
class Band:
    """The catalogue band at each point, N m; None where there is none."""

    low: tuple[float, ...] | None
    high: tuple[float, ...] | None
    values: Mapping[str, tuple[float | None, ...]]  # by name of the model; None where it does not hold
    note: str


@dataclass(frozen=True, kw_only=True)
class OtherCandidate:
    """The balls that the ratings fit nearly as well, and the total torque with them at each point."""

    ball_count: int
    ball_diameter: Positive  # m
    total: tuple[float, ...]  # N m


@dataclass(frozen=True, kw_only=True)
class TorqueRecord:
    """The friction torque that `fembearing torque` computes; SI."""

    points: Annotated[tuple[TorquePoint, ...], MinLen(1)]
    gap_roughness: Positive | None  # m
    clearances: Clearances | None
    pair: PairRows | None
    effects: tuple[Effect, ...]
    warnings: tuple[str, ...]
    measured_points: tuple[int, ...]  # at which shares of effects are measured, from 0
    provenance: Mapping[str, str]
    seconds: NotNegative
    tolerance: Positive
    catalogue_band: Band
    verdicts: Verdicts
    notes: tuple[str, ...]  # none of them is judged
    inputs: tuple[StatedInput, ...]
    other_candidate: OtherCandidate | None
    interval: tuple[Two | None, ...]  # ends of 95 % at each point, N m, by samples or to first order; None: not known
    prediction: PredictionRows | None
    standing: Standing  # how far the torque can be trusted, in one word
    left_out: tuple[LeftOut, ...]  # points without a torque: their numbers are null

    def __post_init__(self) -> None:
        """Raises ValueError for half a catalogue band, and for what belongs to other points."""
        band, count = self.catalogue_band, len(self.points)
        if (band.low is None) != (band.high is None):
            raise ValueError("has half a catalogue_band")
        for side in (band.low, band.high):
            if side is not None and len(side) != count:
                raise ValueError(f"has {len(side)} values of catalogue_band at {count} points")
        for series in (self.interval, *band.values.values()):
            if len(series) != count:
                raise ValueError(f"has {len(series)} intervals, or values of a maker, at {count} points")
        for check in self.verdicts.physical:
            if check.point >= count:
                raise ValueError(f"has a verdict on point {check.point}, and {count} points")
        if self.prediction is not None and len(self.prediction.points) != count:
            raise ValueError(f"has a prediction of {len(self.prediction.points)} points, and {count} points")

    @property
    def computed(self) -> list[int]:
        """The numbers of the points that have a torque, from 0."""
        return Places(size=len(self.points), left_out=self.left_out).computed


@dataclass(frozen=True, kw_only=True)
class CageMotionPoint(CagePoint):
    """An operating point of a cage that moved somewhere; torque, start and block are None where it rests."""

    inner_speed: float  # rad/s
    torque: float | None  # N m
    start: CageStart | None
    block: float | None  # s
    other: OtherStart | None


@dataclass(frozen=True, kw_only=True)
class TorqueFile(TorqueRecord):
    """What `torque --json` prints."""

    kind: Literal["fembearing torque"] = KIND
    format: Literal[6] = FORMAT


def torque_record(result: SceneTorque, *, measured: bool = False) -> TorqueRecord:
    """The record of a torque; measured : whether with the shares of effects that take another solution"""
    return TorqueRecord(**_content(result, measured=measured))


def torque_file(result: SceneTorque) -> TorqueFile:
    """The record with its kind and format."""
    return TorqueFile(**_content(result, measured=True))


def _content(result: SceneTorque, *, measured: bool) -> dict[str, Any]:
    friction, rows, effects = result.friction, result.places.rows, result.friction.effects
    pair = None if friction.pair is None else friction.pair.rows
    prediction = None if result.prediction is None else result.prediction.rows
    of_torque = ("gap_roughness", "clearances", "warnings", "provenance", "seconds")
    return {
        "points": rows(friction.rows),
        "pair": pair and replace(pair, points=rows(pair.points)),
        "effects": tuple(effects) if measured else effects.unmeasured,
        "measured_points": effects.among(result.places.computed).points,
        **{name: getattr(friction, name) for name in of_torque},
        "tolerance": result.scene.tolerance,
        "catalogue_band": _band(result),
        "verdicts": result.verdicts,
        "notes": result.notes,
        "inputs": result.inputs,
        "other_candidate": _other(result),
        "interval": rows(_interval(result)),
        "standing": result.standing,
        "prediction": prediction and replace(prediction, points=rows(prediction.points)),
        "left_out": result.left_out,
    }


def _interval(result: SceneTorque) -> list[Two | None]:
    """Both ends at each operating point that has a torque."""
    if result.interval is None:
        return [None] * result.friction.inner_speed.size
    return [(float(low), float(high)) for low, high in result.interval.T]


def _band(result: SceneTorque) -> Band:
    """The catalogue band at every point."""
    band, note = result.catalogue.band, result.catalogue.note
    if band is None:
        return Band(low=None, high=None, values={}, note=note)
    rows = result.places.rows
    return Band(
        low=rows(band.low.tolist()),
        high=rows(band.high.tolist()),
        values={name: rows(plain(each)) for name, each in band.values.items()},
        note=note,
    )


def _other(result: SceneTorque) -> OtherCandidate | None:
    """Balls and total of the other candidate."""
    other = result.scene.bearing.other_candidate
    if other is None or result.other_candidate is None:
        return None
    total = result.places.rows(result.other_candidate.torque.total.tolist())
    return OtherCandidate(ball_count=other.ball_count, ball_diameter=other.ball_diameter, total=total)


def cage_motion(torque: SceneTorque) -> tuple[CageMotionPoint, ...] | None:
    """Each operating point, None where no cage moved."""
    part = torque.friction.cage
    if part is None or not any(part.motion):
        return None
    return tuple(
        CageMotionPoint(
            **vars(part.row(point)),
            inner_speed=float(torque.friction.inner_speed[point]),
            **{name: motion and getattr(motion, name) for name in ("torque", "start", "block", "other")},
        )
        for point, motion in enumerate(part.motion)
    )
