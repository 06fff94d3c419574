"""Torque and forces of a moving cage as distributions over seeds.

Every seed disturbs the beginning of a motion a little. The motion first runs for a start-up time that is not counted,
and then for a measured time in blocks. The torque is the power lost by sliding and drag over the speed of the ring. The
largest force of a contact grows with the measured time, so the result is the median over blocks of the largest force in
a block, with the length of a block.

The state follows from the place of the cage centre in the frame of the bearing. `rest`: it stays within a quarter of
the half clearance. `whirl`: it circles at a distance that is steady within a tenth of the half clearance. Else
`irregular`. Each block and the whole measured time must agree: a motion that creeps or swings more slowly than a block
is `irregular`.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING, Literal

import numpy as np
from scipy.special import bdtr, stdtrit

from analytic.cage.raceways import Raceways
from analytic.cage.steady import DrivenCage, whirl_number
from analytic.errors import InputError, require_positive
from analytic.scene import Cage, CageStart

if TYPE_CHECKING:  # a motion is slow to import, and few cages move
    from analytic.cage.motion import MeanMotion

State = Literal["rest", "whirl", "irregular", "mixed"]
CONFIDENCE = 0.95
BLOCKS = 10  # of the measured time of each seed
STEADY_PLACE = 0.25  # of the half clearance: root mean square distance of the place from its mean
STEADY_DISTANCE = 0.1  # of the half clearance: root mean square deviation of the distance


@dataclass(frozen=True, kw_only=True)
class OtherStart:
    """The motion of the same cage from another start."""

    start: CageStart  # from which it begins
    state: State  # in which it ends: the regime
    torque: float  # N m


@dataclass(frozen=True, kw_only=True)
class CageStatistics:
    """The motion of a cage at one operating point; intervals are (low, high) at 95 %."""

    torque: float  # mean power of sliding and drag over the speed of the ring, N m
    torque_interval: tuple[float, float]  # of the mean, N m
    damping_torque: float  # power lost in impacts over the speed of the ring, N m; not part of `torque`
    signed_moment: float  # mean moment of the balls on the cage about the axis, N m
    mean_force: float  # mean sum of all normal forces in the pockets, N
    max_force: float  # of one contact: median over blocks of the largest, N
    max_force_interval: tuple[float, float]  # of that median, N
    block_maxima: tuple[float, ...]  # largest force in each block, seed after seed, N
    block: float  # length of a block, s
    duration: float  # measured time of all seeds together, s
    state: State  # mixed: not the same for all seeds
    whirl_speed: float  # mean angular speed of the cage centre about the axis, with the sign of the orbit, rad/s
    wobble: float  # root mean square deviation of the centre's distance from the axis, over each seed, m
    start: CageStart  # from which the motions began
    other: OtherStart | None  # None: the cage cannot whirl, so there is only one steady motion
    race_excess_torque: float = 0.0  # slip in the races that the cage adds, over the ring's speed, N m; by free balls
    race_excess_interval: tuple[float, float] = (0.0, 0.0)  # of its mean, N m


@lru_cache(maxsize=256)
def measured_motion(
    cage: DrivenCage,
    *,
    races: Raceways | None = None,
    start: CageStart,
    seeds: int = Cage.seeds,
    duration: float = Cage.duration,
    steps_per_contact: float = Cage.steps_per_contact,
) -> CageStatistics:
    """Run the motion from one start, once for each seed; the result is cached.

    races : on which the balls move freely; None: the motion of the balls is given
    duration : measured time of each seed, s; a start-up of the same length comes first, during which a `ramp` rises
    Where the cage could whirl, one more motion shows whether another start leads to another state.
    Raises InputError for a bearing at standstill, fewer than two seeds, or a duration in which the cage does not cross
    its pockets even once; MotionError if a motion diverges.
    """
    require_positive(duration=duration, **{"magnitude of ring_speed": abs(cage.ring_speed)})
    if not duration >= cage.crossing_time:
        raise InputError(
            f"duration {duration!r} s of the cage's motion is too short: the cage crosses its pockets once in "
            f"{cage.crossing_time:.3g} s; measure ten times that or more"
        )
    if not seeds >= 2:
        raise InputError(f"seeds must be at least 2, got {seeds!r}: one motion does not show the spread")

    from analytic.cage.motion import CageMotion

    def blocks(begin: CageStart, seed: int) -> "list[MeanMotion]":
        """The measured time of one seed in blocks."""
        motion = CageMotion(cage, races, begin=begin, seed=seed, ramp=duration, steps_per_contact=steps_per_contact)
        motion.advance(duration)
        return [motion.advance(duration / BLOCKS) for _ in range(BLOCKS)]

    runs = [blocks(start, seed) for seed in range(seeds)]
    states: list[State] = [_state(cage, run) for run in runs]
    torques = np.array([_torque(cage, run) for run in runs])
    maxima = np.array([block.max_force for run in runs for block in run])
    state: State = states[0] if states.count(states[0]) == seeds else "mixed"

    def mean(name: str) -> float:
        return float(np.mean([getattr(block, name) for run in runs for block in run]))

    over_speed = 1 / abs(cage.ring_speed)
    # Power of slip in the raceways beyond that of the same balls without a cage; 0 for prescribed balls
    excess = np.array([np.mean([block.race_power - block.alone_power for block in run]) for run in runs]) * over_speed
    return CageStatistics(
        torque=float(torques.mean()),
        torque_interval=_of_mean(torques),
        damping_torque=mean("damping_power") * over_speed,
        signed_moment=mean("moment"),
        mean_force=mean("force"),
        max_force=float(np.median(maxima)),
        max_force_interval=_of_median(maxima),
        block_maxima=tuple(maxima.tolist()),
        block=duration / BLOCKS,
        duration=seeds * duration,
        state=state,
        whirl_speed=mean("circling"),
        wobble=float(np.sqrt(np.mean([_wobble(run) ** 2 for run in runs]))),
        start=start,
        other=_other(cage, state, start, blocks),
        race_excess_torque=float(excess.mean()),
        race_excess_interval=_of_mean(excess),
    )


def _torque(cage: DrivenCage, blocks: "list[MeanMotion]") -> float:
    power = np.mean([block.slip_power + block.land_power + block.drag_power for block in blocks])
    return float(power) / abs(cage.ring_speed)


def _state(cage: DrivenCage, blocks: "list[MeanMotion]") -> State:
    """The state of the blocks of one seed, all of one length."""
    places = np.array([block.place for block in blocks])
    around_place = np.array([block.place_deviation for block in blocks])
    whole = _steady_state(
        cage,
        place_deviation=float(np.sqrt(np.mean(around_place**2) + np.sum(places.var(axis=0)))),
        distance_deviation=_wobble(blocks),
    )
    of_blocks = {
        _steady_state(cage, place_deviation=block.place_deviation, distance_deviation=block.distance_deviation)
        for block in blocks
    }
    return whole if of_blocks == {whole} else "irregular"


def _wobble(blocks: "list[MeanMotion]") -> float:
    """Root mean square deviation of the distance from the axis over blocks of one length, m."""
    within = np.mean([block.distance_deviation**2 for block in blocks])
    return float(np.sqrt(within + np.var([block.distance for block in blocks])))


def _steady_state(cage: DrivenCage, *, place_deviation: float, distance_deviation: float) -> State:
    free = cage.half_clearance if cage.land is None else min(cage.half_clearance, cage.land.half_clearance)
    if place_deviation < STEADY_PLACE * free:
        return "rest"
    return "whirl" if distance_deviation < STEADY_DISTANCE * free else "irregular"


def _other(
    cage: DrivenCage, state: State, start: CageStart, blocks: "Callable[[CageStart, int], list[MeanMotion]]"
) -> OtherStart | None:
    """A motion from whirl for a cage that rests, else from rest; "sudden" if that is the given start already."""
    number = whirl_number(
        ball_speed=abs(cage.ball_speed),
        ball_radius=cage.ball_radius,
        half_clearance=cage.half_clearance,
        gravity=float(np.linalg.norm(cage.gravity)),
    )
    if number < 1:
        return None
    other: CageStart = "whirl" if state == "rest" else "rest"
    if other == start:
        other = "sudden"
    run = blocks(other, 0)
    return OtherStart(start=other, state=_state(cage, run), torque=_torque(cage, run))


def _of_mean(values: np.ndarray) -> tuple[float, float]:
    """Interval of the mean of independent values, by Student's t."""
    if np.ptp(values) <= 1e-12 * np.abs(values).max():  # equal values but for round-off
        return float(values.min()), float(values.max())
    half = stdtrit(values.size - 1, (1 + CONFIDENCE) / 2) * values.std(ddof=1) / math.sqrt(values.size)
    return float(values.mean() - half), float(values.mean() + half)


def _of_median(values: np.ndarray) -> tuple[float, float]:
    """Interval of the median between order statistics, for any distribution; NaN for less than six values."""
    below = bdtr(np.arange(values.size), values.size, 0.5)  # probability that so many or fewer lie below the median
    outside = int(np.sum(below <= (1 - CONFIDENCE) / 2))
    if not outside:
        return math.nan, math.nan
    ordered = np.sort(values)
    return float(ordered[outside - 1]), float(ordered[-outside])
