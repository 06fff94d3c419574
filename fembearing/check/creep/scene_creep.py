"""Friction of the heaviest ball on both races: formula and production against the numerical reference.

The formula is that of equations 2 to 7 of [Paper], the production marched creep, the reference `fembearing.creep`. All
have the same loads at rest, the same law of traction and Hertz's contacts, without finite geometry and without weight.
"""

import time
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from threadpoolctl import threadpool_limits

from analytic.brief import Brief
from analytic.columns import COORDINATES
from analytic.contact.geometry import RACES, Race
from analytic.errors import InputError, require_positive
from analytic.progress import Progress, silent
from analytic.rows import OperatingPoint, Positive
from analytic.scene import Material, Scene
from fembearing.check.comparison import Comparison, compared
from fembearing.check.contact.scene_contact import OfPair, balls_of, heaviest_place, traced_to_load
from fembearing.check.creep.meshed_bodies import with_meshed_bodies
from fembearing.check.creep.production import ProducedBall, Production, by_formula, by_march, produced
from fembearing.creep.ball import RaceCreep, TurningBall
from fembearing.creep.reference import CreepReference, RaceFriction, creep_reference
from fembearing.fem.compliance import Compliance
from fembearing.grid_convergence import Estimate

LEAST_SHARE = 0.02  # of the torque by sliding, of balls that are not solved but change as the last one that was
MOST_BALLS = 6  # that are solved
SCALED, MOST_SCALINGS = 1e-6, 60  # relative error of the ball's load; largest number of steps
NO_FRICTION = "without friction nothing resists slip"
NO_SPIN = 1e-9  # of the slip by conformity


@dataclass(frozen=True, kw_only=True)
class RaceNumbers:
    """One race of the heaviest ball. Moments resist; creepages are slip over the rolling speed, along to the front."""

    contact_angle: float  # of the reference, rad
    load: float  # likewise, N
    semi_axis_rolling: Positive  # a, m
    semi_axis_transverse: Positive  # b, m
    # creepage_along of the centre, < 0: the ball is slower than its race; creepage_across; spin_creepage >= 0, 1/m;
    # spin_moment, and rolling_moment = int (t_x y^2/2 - t_y x y) dA/R, N m; transverse_force on the ball across the
    # groove, N; slip_share of the area; power, W
    quantities: dict[str, Comparison]


@dataclass(frozen=True, kw_only=True)
class CreepNumbers:
    """Friction of the heaviest ball and the torque by sliding of all balls, SI."""

    point: OperatingPoint
    friction_coefficient: float | None  # given; None: by oil and surfaces
    races: dict[Race, RaceNumbers]
    torque: Comparison  # by sliding, of all balls about the bearing axis, N m
    solved_balls: int  # by the reference, of those that differ
    different_balls: int
    strips: int  # of the finest grid
    cells: int  # of a strip
    tolerance: Positive  # asked of the torque, relative
    seconds: float  # of the reference
    production_seconds: float
    warnings: tuple[str, ...]
    compliance: Compliance = "half-space"  # of the reference
    bearing: OfPair | None = None  # of a pair

    @property
    def load(self) -> float:
        """Of the ball, the larger one of both races, N."""
        return max(race.load for race in self.races.values())

    @property
    def relative_uncertainty(self) -> float:
        """Of the torque."""
        return self.torque.uncertainty / abs(self.torque.reference)

    @property
    def change(self) -> float:
        """Of the torque by sliding, from production to reference, relative."""
        return self.torque.reference / self.torque.production - 1

    @property
    def spins(self) -> bool:
        """Whether spin takes part in the slip."""
        slip = (
            (race.semi_axis_transverse * race.quantities["spin_creepage"].production, race.quantities["creepage_along"])
            for race in self.races.values()
        )
        return any(spin > NO_SPIN * abs(along.production) for spin, along in slip)


@dataclass(frozen=True, kw_only=True, eq=False)
class SceneCreep(Brief):
    """The numbers, and the heaviest ball of the reference with its maps."""

    numbers: CreepNumbers
    reference: CreepReference
    ball: TurningBall
    place: int  # number of its operating point in the scene

    def _facts(self) -> Iterator[str]:
        found = self.numbers
        yield from (f"{found.races['inner'].load:.4g} N", f"torque by sliding {1e3 * found.torque.reference:.4g} N mm")
        yield f"production {found.torque.difference:+.1%}"


def creep_of(
    scene: Scene,
    *,
    load: float | None = None,
    inner_speed: float | None = None,
    friction: float | None = None,
    tolerance: float | None = None,
    compliance: Compliance = "half-space",
    progress: Progress = silent,
) -> SceneCreep:
    """Solve the friction of the heaviest ball, and compare formula and production with it.

    load : of the heaviest ball, N, > 0: all loads of its operating point are scaled; None: the scene's
    inner_speed : of the inner ring, rad/s, of either sign, not 0; None: at the operating point of the heaviest ball
    friction : coefficient of both races, in place of the scene's; dimensionless
    tolerance : required of the torque by sliding, relative; None: the scene's
    compliance : of the reference: half spaces, or ball and race of true shape by finite elements
    progress : called with the share done, 0 to 1, and the name of the current step
    Under a radial load or a moment the ring stays where production places it. Balls that differ are solved one by one.
    Raises InputError for a scene without friction, standstill, what no method covers, and meshed bodies whose contact a
    shoulder cuts off; ConvergenceError where the ball slides all over, or the iteration does not converge.
    """
    limit = scene.tolerance if tolerance is None else tolerance
    require_positive(tolerance=limit)
    given, place = scene_at_heaviest(scene, load=load, inner_speed=inner_speed, friction=friction)
    progress(0.0, "friction by production")
    begun = time.perf_counter()
    production = produced(given)
    formula, march = by_formula(production), by_march(production)
    between = time.perf_counter()
    with threadpool_limits(1, "blas"):
        reference, uncertainty, solved = reference_torque(
            production, tolerance=limit, compliance=compliance, progress=progress
        )
    heaviest, ball = solved[0], production.balls[0]
    races: dict[Race, RaceNumbers] = {
        name: _race(getattr(heaviest, name), race, ball.mirrored, (formula[k], march[k]), ball.turning.speed)
        for k, (name, race) in enumerate(zip(RACES, heaviest.finest.races, strict=True))
    }
    grid = heaviest.grids[-1]
    numbers = CreepNumbers(
        point=OperatingPoint(**{name: float(getattr(given.operation.as_series(), name)[0]) for name in COORDINATES}),
        friction_coefficient=given.friction_coefficient,
        races=races,
        torque=compared(production.torque, reference, uncertainty, formula=production.formula),
        solved_balls=len(solved),
        different_balls=len(production.balls),
        strips=grid.strips,
        cells=grid.cells,
        tolerance=limit,
        seconds=time.perf_counter() - between,
        production_seconds=between - begun,
        warnings=tuple(_warnings(given)),
        compliance=compliance,
    )
    return SceneCreep(numbers=numbers, reference=heaviest, ball=ball.turning, place=place)


def scene_at_heaviest(
    scene: Scene, *, load: float | None = None, inner_speed: float | None = None, friction: float | None = None
) -> tuple[Scene, int]:
    """The scene at the operating point of its heaviest ball alone, and its number; arguments of `creep_of`.

    Raises InputError as `creep_of`.
    """
    if friction is not None:
        if not 0 < friction < np.inf:
            raise InputError(f"friction = {friction:g}: {NO_FRICTION}; give a coefficient above 0")
        scene = replace(scene, friction_coefficient=friction)
    if not scene.has_friction:
        raise InputError(
            "the scene gives no friction: add [friction] coefficient, or both [lubricant] and [surface], or give "
            "--friction"
        )
    if scene.friction_coefficient == 0:
        raise InputError(f"friction.coefficient = 0: {NO_FRICTION}; give one above 0, or --friction")
    operation = scene.operation.as_series()
    point, _ = heaviest_place(balls_of(scene))
    alone = operation.at(np.array([point]))
    if inner_speed is not None:
        alone = replace(alone, inner_speed=np.array([inner_speed]))
    if alone.inner_speed[0] == 0:
        raise InputError("operation.inner_speed = 0: at standstill nothing rolls; give --speed or another scene")
    scene = replace(scene, operation=alone)
    return scene if load is None else _scaled_to(scene, load), point


def _scaled_to(scene: Scene, load: float) -> Scene:
    """The scene with all its loads times one factor, so that the heaviest ball has this load."""
    require_positive(ball_load=load)
    with traced_to_load(scene, pair="inner", load=load):
        for _ in range(MOST_SCALINGS):
            ratio = load / float(balls_of(scene)["load"].max())
            if abs(ratio - 1) <= SCALED:
                return scene
            operation = scene.operation
            larger = {name: ratio * getattr(operation, name) for name in ("axial_load", "radial_load", "moment")}
            scene = replace(scene, operation=replace(operation, **larger))
        raise InputError("no factor on the loads of the operating point reaches it; give a larger load, or less speed")


def _balls_to_solve(production: Production) -> tuple[ProducedBall, ...]:
    """The heaviest balls, until what is left loses little."""
    balls, left = [], sum(ball.number * ball.torque for ball in production.balls)
    enough = LEAST_SHARE * left
    for ball in production.balls[:MOST_BALLS]:
        if balls and left <= enough:
            break
        balls.append(ball)
        left -= ball.number * ball.torque
    return tuple(balls)


def reference_torque(
    production: Production,
    *,
    tolerance: float,
    compliance: Compliance = "half-space",
    progress: Progress = silent,
) -> tuple[float, float, list[CreepReference]]:
    """Torque by sliding of all balls and its uncertainty, N m, and the balls that were solved, the heaviest first.

    tolerance : of the torque of each ball, relative;  compliance : of the elastic bodies
    What is not solved changes as the last ball does, and is as uncertain as it changes.
    """
    balls, solved = _balls_to_solve(production), []
    for number, ball in enumerate(balls):
        progress(number / len(balls), f"friction of ball {number + 1} of {len(balls)} by the reference")
        turning = ball.turning if compliance == "half-space" else with_meshed_bodies(production.scene, ball)
        solved.append(creep_reference(turning, tolerance=tolerance))
    torque = sum(ball.number * each.torque.value for ball, each in zip(balls, solved, strict=True))
    uncertainty = sum(ball.number * each.torque.uncertainty for ball, each in zip(balls, solved, strict=True))
    left = production.torque - sum(ball.number * ball.torque for ball in balls)
    ratio = solved[-1].torque.value / balls[-1].torque
    return float(torque + ratio * left), float(uncertainty + abs((ratio - 1) * left)), solved


def _race(
    estimates: RaceFriction[Estimate],
    race: RaceCreep,
    mirrored: bool,
    methods: tuple[RaceFriction[float], RaceFriction[float]],
    speed: float,
) -> RaceNumbers:
    """One race; methods : formula and production;  speed : of the ring, rad/s"""
    side, spin = -1.0 if mirrored else 1.0, float(np.sign(race.friction.creepages.spin))
    signs = {"spin_creepage": spin, "spin_moment": -race.side * spin, "rolling_moment": -1.0}
    signs |= {"creepage_across": side, "transverse_force": side}
    quantities = {}
    for name, each, formula, march in zip(RaceFriction._fields, estimates, *methods, strict=True):
        value = signs.get(name, 1.0) * each.value
        unit = speed if name == "torque" else 1.0
        quantities["power" if name == "torque" else name] = compared(
            unit * march,
            unit * (min(value, 1.0) if name == "slip_share" else value),
            unit * each.uncertainty,
            formula=unit * formula,
        )
    return RaceNumbers(
        contact_angle=race.angle * side,
        load=race.load,
        semi_axis_rolling=race.semi_axis_rolling,
        semi_axis_transverse=race.semi_axis_transverse,
        quantities=quantities,
    )


def _warnings(scene: Scene) -> Iterator[str]:
    bearing, friction = scene.bearing, scene.friction_coefficient
    for race in RACES:
        beta = abs(_dundurs(bearing.ball_material, getattr(bearing, race).material))
        if beta > 0:
            size = "mu beta" if friction is None else f"mu beta, {100 * friction * beta:.2g} % of it"
            yield (
                f"ball and {race} race are of unlike materials: how tractions change the pressure is left out, an "
                f"effect of the order of {size} (beta = {beta:.2g})"
            )


def _dundurs(*bodies: Material) -> float:
    """Dundurs' second constant of two bodies, [Johnson1985] section 5.1."""
    softness = [(1 + each.poisson_ratio) / each.youngs_modulus for each in bodies]  # 1/(2 G)
    ball, other = ((1 - 2 * each.poisson_ratio) * part for each, part in zip(bodies, softness, strict=True))
    whole = sum(2 * (1 - each.poisson_ratio) * part for each, part in zip(bodies, softness, strict=True))
    return (ball - other) / whole
