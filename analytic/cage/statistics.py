"""Torque and forces of a cage in motion as distributions: over seeds, with the start of each motion thrown away.

Every seed disturbs the beginning a little, runs for a start-up that nobody counts, and then for a measured time in
blocks. The torque is the power lost to sliding and drag over the speed of the ring. The largest force of a contact
grows with the time: what is told is the median over blocks of the largest force in a block, with the block's length.

The regime, by the cage's centre in the bearing's frame: `rest` where it keeps its place to within a quarter of the
pocket's room, `whirl` where it goes round at a distance steady to within a tenth of the room, else `irregular`. It is
that of each block and of all measured time alike: what creeps or swings slower than a block is `irregular`.
"""

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from analytic.cage.motion import STEPS_PER_CONTACT, CageMotion, Passage
from analytic.cage.steady import DrivenCage
from analytic.effects.bounds import whirl_number
from analytic.errors import InputError, require_positive
from analytic.scene import CageStart

Regime = Literal["rest", "whirl", "irregular", "mixed"]
CONFIDENCE = 0.95
BLOCKS = 10  # of the measured time of each seed
STEADY_PLACE = 0.25  # of the room: root mean square of the place about its mean
STEADY_DISTANCE = 0.1  # of the room, likewise
DURATION = 0.2  # s: ten swings of a resting cage, a hundred turns of a whirling one
SEEDS = 4


@dataclass(frozen=True, kw_only=True)
class OtherStart:
    """Where the same cage comes to from another beginning."""

    start: CageStart
    state: Regime
    torque: float  # N m


@dataclass(frozen=True, kw_only=True)
class CageStatistics:
    """What the motion of a cage comes to at one operating point; intervals are (low, high) at 95 %."""

    torque: float  # mean power of sliding and of drag over the ring's speed, N m
    torque_interval: tuple[float, float]  # of the mean
    drag_torque: float  # the part of it that the oil around the cage takes, N m
    damping_torque: float  # power that impacts lose, likewise; in no torque above
    signed_moment: float  # mean moment of the balls on the cage about the axis, N m
    mean_force: float  # mean of the sum of all normal forces in the pockets, N
    max_force: float  # of one contact: median over blocks of the largest, N
    max_force_interval: tuple[float, float]  # of that median
    block_maxima: tuple[float, ...]  # the largest of each block, seed after seed, N
    block: float  # length of a block, s
    duration: float  # measured, of all seeds together, s
    state: Regime  # mixed: seeds came to different ones
    start: CageStart
    other: OtherStart | None  # None: the cage cannot whirl, and there is one steady motion

    @property
    def largest_force(self) -> float:
        """Seen at all, N."""
        return max(self.block_maxima)


@lru_cache(maxsize=256)
def measured_motion(
    cage: DrivenCage,
    *,
    start: CageStart,
    seeds: int = SEEDS,
    duration: float = DURATION,
    steps_per_contact: float = STEPS_PER_CONTACT,
) -> CageStatistics:
    """Run the cage from one beginning, once for each seed; kept, so that the same question is answered at once.

    duration : measured, of each seed, s; as much again goes before it uncounted, and a `ramp` takes that time
    Where the cage could whirl, one more motion tells whether another beginning leads elsewhere.
    Raises InputError for a bearing at standstill, fewer than two seeds, or a duration in which the cage does not cross
    its pockets even once; MotionError where a motion comes apart.
    """
    require_positive(duration=duration, **{"magnitude of ring_speed": abs(cage.ring_speed)})
    if not duration >= cage.crossing_time:
        raise InputError(
            f"duration {duration!r} s of the cage's motion is too short: the cage crosses its pockets once in "
            f"{cage.crossing_time:.3g} s; measure ten times that or more"
        )
    if not seeds >= 2:
        raise InputError(f"seeds must be at least 2, got {seeds!r}: one motion tells nothing of its spread")
    runs = [_blocks(cage, start, seed, duration, steps_per_contact) for seed in range(seeds)]
    states: list[Regime] = [_state(cage, run) for run in runs]
    torques = np.array([_torque(cage, run) for run in runs])
    maxima = np.array([block.max_force for run in runs for block in run])
    state: Regime = states[0] if states.count(states[0]) == seeds else "mixed"

    def mean(name: str) -> float:
        return float(np.mean([getattr(block, name) for run in runs for block in run]))

    over_speed = 1 / abs(cage.ring_speed)
    return CageStatistics(
        torque=float(torques.mean()),
        torque_interval=_of_mean(torques),
        drag_torque=mean("drag_power") * over_speed,
        damping_torque=mean("damping_power") * over_speed,
        signed_moment=mean("moment"),
        mean_force=mean("force"),
        max_force=float(np.median(maxima)),
        max_force_interval=_of_median(maxima),
        block_maxima=tuple(maxima.tolist()),
        block=duration / BLOCKS,
        duration=seeds * duration,
        state=state,
        start=start,
        other=_other(cage, state, start, duration, steps_per_contact),
    )


def _blocks(cage: DrivenCage, start: CageStart, seed: int, duration: float, steps_per_contact: float) -> list[Passage]:
    motion = CageMotion(cage, begin=start, seed=seed, ramp=duration, steps_per_contact=steps_per_contact)
    motion.advance(duration)
    return [motion.advance(duration / BLOCKS) for _ in range(BLOCKS)]


def _torque(cage: DrivenCage, run: list[Passage]) -> float:
    return float(np.mean([block.slip_power + block.land_power + block.drag_power for block in run])) / abs(
        cage.ring_speed
    )


def _state(cage: DrivenCage, run: list[Passage]) -> Regime:
    """Of blocks of one length."""
    places, distances = np.array([block.place for block in run]), np.array([block.distance for block in run])
    unrest, wobble = np.array([block.unrest for block in run]), np.array([block.wobble for block in run])
    whole = _regime(
        cage,
        unrest=float(np.sqrt(np.mean(unrest**2) + np.sum(places.var(axis=0)))),
        wobble=float(np.sqrt(np.mean(wobble**2) + distances.var())),
    )
    alike = all(_regime(cage, unrest=block.unrest, wobble=block.wobble) == whole for block in run)
    return whole if alike else "irregular"


def _regime(cage: DrivenCage, *, unrest: float, wobble: float) -> Regime:
    room = cage.room if cage.land is None else min(cage.room, cage.land.room)
    if unrest < STEADY_PLACE * room:
        return "rest"
    return "whirl" if wobble < STEADY_DISTANCE * room else "irregular"


def _other(
    cage: DrivenCage, state: Regime, start: CageStart, duration: float, steps_per_contact: float
) -> OtherStart | None:
    """From rest where the cage whirls or tumbles, from whirl where it rests."""
    pull = float(np.linalg.norm(cage.gravity))
    could = whirl_number(
        ball_speed=abs(cage.ball_speed), ball_radius=cage.ball_radius, clearance=2 * cage.room, gravity=pull
    )
    if could < 1:
        return None
    begin: CageStart = "whirl" if state == "rest" else "rest"
    if begin == start:
        begin = "sudden"
    run = _blocks(cage, begin, 0, duration, steps_per_contact)
    return OtherStart(start=begin, state=_state(cage, run), torque=_torque(cage, run))


def _of_mean(values: np.ndarray) -> tuple[float, float]:
    """By Student's t, of values that know nothing of each other."""
    if np.ptp(values) <= 1e-12 * np.abs(values).max():  # nothing to spread
        return float(values.min()), float(values.max())
    from scipy.stats import ttest_1samp  # half a second to import, which few scenes need

    found = ttest_1samp(values, 0.0).confidence_interval(CONFIDENCE)
    return float(found.low), float(found.high)


def _of_median(values: np.ndarray) -> tuple[float, float]:
    """Between order statistics, whatever the distribution."""
    from scipy.stats import quantile_test

    found = quantile_test(values, p=0.5).confidence_interval(CONFIDENCE)
    return float(found.low), float(found.high)
