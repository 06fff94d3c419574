"""The torque by sliding of free balls at many points, and a sample of them where there are many.

`analytic.free_ball.passes` says how loads, rotation and friction of a point settle together.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.contact.factors import ContactCorrection
from analytic.contact.hertz import HertzContact, HertzNumbers, contact_modulus, loaded_contact
from analytic.errors import ConvergenceError

from analytic.free_ball.passes import (
    FreeModel,
    FreeSettings,
    FreeSpace,
    no_start,
    settle_ring_points,
    settle_thrust_points,
    write_law_powers,
)
from analytic.free_ball.rotation import COARSE, QUADRATURES, STIFFER, Creep, quadrature_of
from analytic.free_ball.rounds import SKIDS
from analytic.free_ball.turning import ENOUGH, FreeNumbers, ball_rows
from analytic.loads.balls import LoadedBalls, LoadEffects, balls_between
from analytic.loads.kinematics import BallKinematics, BallMotion
from analytic.loads.race_contacts import unit_contacts
from analytic.loads.ring_balance import BallRows, ring_points, ring_work
from analytic.loads.ring_rounds import SETTLED, RingLoads, Rounds
from analytic.loads.ring_series import factors_of, require_settled, ring_numbers
from analytic.loads.thrust import unsettled
from analytic.numerics.interpolated import sampled_series
from analytic.oil.race_resistance import RaceResistance
from analytic.oil.viscosity import OilNumbers
from analytic.scene import Array, Bearing, ContactAngle, Operation, SlidingMethod
from analytic.sliding.methods import Sliding

METHODS: dict[Creep, SlidingMethod] = {"none": "free_ball", "closed": "closed_creep", "marched": "marched_creep"}
SERIES = 130  # from this number of points on, a sample of them costs less
BETWEEN = 1.25  # times the largest error at the points of a sample: what lies between them
# Of the allowed error, at the points of a sample. The rest is for what lies between them: errors of a quadrature change
# sign with the load, and four times their noise counts there.
METHODS_PART = 0.2
POSITIVE = ("inner_entrainment", "outer_entrainment", "inner_rolling_rate", "outer_rolling_rate", "ball_speed")
Points = NDArray[np.intp]


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeProblem:
    """n operating points with free balls."""

    bearing: Bearing
    contact_angle: ContactAngle
    operation: Operation  # every array (n,)
    effects: LoadEffects
    creep: Creep
    correction: ContactCorrection | None  # factors on Hertz's contacts: (n,) under thrust, (n, m) on a ring
    resistance: RaceResistance
    oil: OilNumbers  # at its temperature
    other: Array  # (n,) N m, about what resists the balls besides sliding

    def at(self, points: Points) -> "FreeProblem":
        operation = Operation(**{name: values[points] for name, values in vars(self.operation).items()})
        correction = None if self.correction is None else self.correction.mapped(lambda factor: factor[points])
        return replace(self, operation=operation, correction=correction, other=self.other[points])

    @property
    def is_ring(self) -> bool:
        """The balls differ; else one stands for all under thrust."""
        return (self.effects.load_distribution and not self.operation.is_thrust) or self.effects.down is not None


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeSliding:
    """The balls, and the torque by their sliding."""

    balls: LoadedBalls
    sliding: Sliding


def slide_freely(problem: FreeProblem, ruled: LoadedBalls, *, allowed: Array) -> FreeSliding:
    """The balls and their torque, from balls by closed kinematics.

    allowed : (n,) error, relative to the whole torque
    Raises ConvergenceError where a ball finds no steady rotation, or loads and rotation do not settle.
    """
    if ruled.alike > 1 and np.count_nonzero(problem.operation.inner_speed) >= SERIES:
        sampled = _sampled(problem, ruled, allowed=allowed)
        if sampled is not None:
            return sampled
    return _settled(problem, allowed=allowed)


def free_settings(bearing: Bearing, *, creep: Creep, inertia: tuple[bool, bool]) -> FreeSettings:
    """How the balls of a bearing turn freely; inertia : whether centrifugal force and gyroscopic moment count."""
    softer = 1 / STIFFER if creep == "none" else 1.0
    inner, outer = (
        softer * 32 / (3 * np.pi**2 * float(contact_modulus(bearing.ball_material, groove.material)))
        for groove in (bearing.inner, bearing.outer)
    )
    above = 0.0 if bearing.kind == "thrust" else bearing.outer.groove_radius  # the profile's centre over the bottom
    free = FreeNumbers(float(bearing.outer.bottom_radius - above), (inner, outer), *inertia)
    quadratures = tuple(quadrature_of(nodes, marched=creep == "marched") for nodes in (COARSE, *QUADRATURES))
    return FreeSettings(free, quadratures)


def settled_points(
    model: FreeModel, loads: RingLoads, oil: OilNumbers, *, is_ring: bool, allowed: Array
) -> tuple[FreeSpace, Array]:
    """Balls and ends of n points, as `settle_thrust_points` and `settle_ring_points` write them."""
    count, balls = len(loads.force), len(model.ring.rows.travel) if is_ring else 1
    space = FreeSpace(ring_points(count, balls), ball_rows((count, balls)), no_start(count, balls))
    ends = np.full((count, 7), np.nan)
    allowed = np.array(allowed, dtype=np.float64)
    if is_ring:
        settle_ring_points(model, loads, oil, space, ring_work(balls), allowed, ends)
    else:
        settle_thrust_points(model, loads, oil, space, allowed, ends)
    return space, ends


def _settled(problem: FreeProblem, *, allowed: Array) -> FreeSliding:
    """Every point by itself. Raises as `slide_freely` does."""
    bearing, effects, operation = problem.bearing, problem.effects, problem.operation
    count, is_ring = operation.inner_speed.size, problem.is_ring
    ring, arm = ring_numbers(bearing, problem.contact_angle, down=effects.down)
    inertia = (bool(effects.centrifugal), bool(effects.gyroscopic))
    settings = free_settings(bearing, creep=problem.creep, inertia=inertia)
    model = FreeModel(ring, problem.resistance, settings)
    force = np.zeros((count, 5))
    force[:, 0] = operation.axial_load
    if effects.load_distribution:
        force[:, 1], force[:, 4] = operation.radial_load, np.asarray(operation.moment) / arm
    loads = RingLoads(
        force,
        np.array(operation.inner_speed, dtype=np.float64),
        inertia,
        factors_of(problem.correction or ContactCorrection()),
    )
    space, ends = settled_points(model, loads, problem.oil, is_ring=is_ring, allowed=allowed)
    _require_settled(problem, ring.rows, loads, space, ends)
    write_law_powers(settings.quadratures, space)
    load, angle = (np.moveaxis(each, 1, 0) for each in (space.point.load, space.point.angle))
    contacts = tuple(
        loaded_contact(
            HertzContact(**dict(zip(HertzNumbers._fields, np.moveaxis(space.point.unit[:, race], 1, 0), strict=True))),
            load=load[race],
        )
        for race in (0, 1)
    )
    motion = dict(zip(BallMotion._fields, np.moveaxis(space.balls.motion, 2, 0), strict=True))
    torque, spin, error = ends[:, 4:].T
    law, unit = (np.moveaxis(space.balls.outcomes[..., power], 2, 0) for power in (LAW_POWER, UNIT_POWER))
    return FreeSliding(
        balls=balls_between(
            bearing,
            method="ring" if is_ring else "thrust",
            load=load,
            angle=angle,
            contacts=(contacts[0], contacts[1]),
            motion=BallKinematics(**motion),
        ),
        sliding=Sliding(
            spin=spin,
            conformity=torque - spin,
            coefficient=np.divide(law, unit, out=np.zeros_like(law), where=unit > 0),
            method=METHODS[problem.creep],
            error=np.divide(error, torque, out=np.zeros_like(error), where=torque > 0),
        ),
    )


def _require_settled(problem: FreeProblem, rows: BallRows, loads: RingLoads, space: FreeSpace, ends: Array) -> None:
    if np.all(ends[:, 0] == SETTLED):
        return
    worst = int(np.argmax(ends[:, 0] != SETTLED))  # those behind it were not tried
    end, _, left, tolerance = ends[worst, :4]
    if end == SKIDS:
        residual = space.balls.residual[worst]
        ball = int(np.argmax(np.where(np.isnan(residual), np.inf, residual)))
        inner, outer = space.balls.contacts[worst, ball, :, LOAD]
        raise ConvergenceError(
            iterations=MOST_STEPS,
            residual=float(left),
            tolerance=ENOUGH,
            unit="of its friction",
            problem=f"the rotation of ball {ball} under {inner:.4g} N on the inner and {outer:.4g} N on the outer race",
            remedy='Raise the load or lower the speed, or give friction.spin_rule = "outer_control".',
        )
    if not problem.is_ring:
        raise unsettled(loads.force[worst : worst + 1, 0] / problem.bearing.ball_count, left, tolerance)
    last = ends[: worst + 1]
    rounds = Rounds(last[:, 0].astype(np.int64), last[:, 1].astype(np.int64), last[:, 2], last[:, 3])
    require_settled(problem.bearing, rows, loads.inner_speed, loads, space.point, rounds)


def _sampled(problem: FreeProblem, ruled: LoadedBalls, *, allowed: Array) -> FreeSliding | None:
    """All balls alike, from a sample of the points; None where that does not pay or is not accurate enough.

    Loads, speeds and torques vary with load and speed in a smooth way, as logarithms. Errors are relative to the whole
    torque: that by sliding may be a small part of it.
    """
    count = problem.operation.inner_speed.size
    moving, standing = np.flatnonzero(problem.operation.inner_speed), np.flatnonzero(problem.operation.inner_speed == 0)
    others = problem.other
    worst = 0.0

    def settled(at: Points) -> Array:
        nonlocal worst
        part = _settled(problem.at(at), allowed=METHODS_PART * allowed[at] / BETWEEN)
        torque = part.sliding.spin + part.sliding.conformity
        worst = max(worst, BETWEEN * float(np.max(part.sliding.error * _share(torque, others[at]))))
        return _quantities(part)

    def missed(interpolated: Array, true: Array, some: Points) -> Array:
        wrong = np.abs(np.expm1((interpolated - true)[:, :3]))  # loads and torque
        wrong[:, 2] *= _share(np.exp(true[:, 2]), others[moving[some]])
        return wrong.max(axis=1)

    still = settled(standing) if standing.size else None
    series = sampled_series(
        lambda some: settled(moving[some]),
        np.log(np.stack([ruled.load[0, moving, 0], np.abs(problem.operation.inner_speed[moving])], axis=1)),
        missed=missed,
        allowed=lambda: float(np.min(allowed)) - worst,
    )
    if series is None:
        return None
    values = np.zeros((count, series.values.shape[1]))
    values[moving] = series.values
    if still is not None:
        values[standing] = still
    share = _share(np.exp(values[:, 2]), others)
    error = np.divide(worst + series.error, share, out=np.zeros_like(share), where=share > 0)
    return _from_quantities(problem, values, error=error, computed=series.at.size + standing.size)


def _share(torque: Array, others: Array) -> Array:
    """(n,) of the torque by sliding in the whole torque."""
    whole = torque + others
    return np.divide(torque, whole, out=np.zeros_like(whole), where=whole > 0)


def _quantities(free: FreeSliding) -> Array:
    """(n, q): logarithms of loads, torque, friction coefficients and speeds; angles, pitch, share of spin, spin."""
    balls, sliding, motion = free.balls, free.sliding, free.balls.motion
    torque = sliding.spin + sliding.conformity
    positive = [balls.load[0, :, 0], balls.load[1, :, 0], torque, *sliding.coefficient[..., 0]]
    positive += [getattr(motion, name)[:, 0] for name in POSITIVE]
    share = np.divide(sliding.spin, torque, out=np.zeros_like(torque), where=torque > 0)
    rest = [*balls.contact_angle[..., 0], motion.cage_speed[:, 0], motion.spin_difference[:, 0], motion.pitch[:, 0]]
    return np.stack([*np.log(np.maximum(positive, 1e-300)), *rest, share], axis=1)


def _from_quantities(problem: FreeProblem, values: Array, *, error: Array, computed: int) -> FreeSliding:
    bearing, radius, half = problem.bearing, problem.bearing.ball_radius, problem.bearing.pitch_diameter / 2
    count = 5 + len(POSITIVE)
    inner_load, outer_load, torque, inner_friction, outer_friction, *speeds = np.exp(values[:, :count]).T
    inner_angle, outer_angle, cage_speed, spin_difference, pitch, share = values[:, count:].T
    inner, outer = unit_contacts(
        bearing,
        inner_angle=np.abs(inner_angle),
        outer_angle=np.abs(outer_angle),
        correction=problem.correction or ContactCorrection(),
    )
    balls = balls_between(
        bearing,
        method="thrust",
        load=np.stack([inner_load, outer_load])[..., None],
        angle=np.stack([inner_angle, outer_angle])[..., None],
        contacts=(loaded_contact(inner, load=inner_load), loaded_contact(outer, load=outer_load)),
        motion=BallKinematics(
            inner_radius=half - radius * np.cos(inner_angle),
            outer_radius=half + radius * np.cos(outer_angle),
            cage_speed=cage_speed,
            spin_difference=spin_difference,
            pitch=pitch,
            **dict(zip(POSITIVE, speeds, strict=True)),
        ),
    )
    return FreeSliding(
        balls=balls,
        sliding=Sliding(
            spin=torque * share,
            conformity=torque * (1 - share),
            coefficient=np.stack([inner_friction, outer_friction])[..., None],
            method=METHODS[problem.creep],
            error=error,
            computed=computed,
        ),
    )
