"""A ball between two races: how it turns and lies, and what friction it meets, without a formula for friction.

The ball has four freedoms: v = (r_m w_c, r w_phi, r w_rho, r w_z), the speed along its orbit of radius r_m and its
rotation along the orbit, outward and along the bearing axis. Up to three more are where it lies between the grooves.
The contacts give their forces and the derivatives of these by the creepages (`fembearing.creep.rolling`), which close
Newton's method on the few equations of the ball.
"""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from analytic.contact.geometry import RACES, Race, race_numbers
from analytic.errors import ConvergenceError, InputError, SingularError
from analytic.oil.traction import PointLaw
from analytic.scene import Array, Bearing
from fembearing.creep.friction import sliding_law
from fembearing.creep.half_space import HalfSpaces, Influence
from fembearing.creep.kinematics import RaceMotion, RigidSlip, rigid_slip, slip_rates
from fembearing.creep.place import HeldBall, Lie, UnitContact, free_lengths, unit_under
from fembearing.creep.rolling import RollingFriction, RollingSurfaces, pressed_slip, rolling_friction, rolling_surfaces
from fembearing.creep.strips import Strips, ellipse_strips, hertz_pressure

MOST_STEPS = 80  # of the ball; 5 to 15 are usual
SETTLED = 1e-6  # what the ball lacks, over all friction
NEARLY = 1e-3  # likewise: from here on the slip is taken at the same places, so that derivatives are exact
# Surfaces that creep more let Newton's method come from far. Each way is softer so many times, one after another; the
# first is for a start that is near, the others are tried where one before ends short.
WAYS = (), (100.0, 10.0), (1e3, 300.0, 100.0, 30.0, 10.0, 5.0, 2.5, 1.5)
ROUGHLY = 1e-2  # what the ball may lack before the last
LEAST_SHARE = 1 / 128  # of the longest step
MOST_CHANGE, TINY = 0.5, 1e-300  # of the slip of a contact by a step
LEAST_GAIN = 0.1  # of what the ball lacks, by a whole step
DIFFERENCE = 1e-6  # of the ball's radius, or of a hundredth of the groove's length, for derivatives of the equations
OF_APPROACH = 1e-3  # most of the approach of a contact for these: its load goes as the power 1.5 of it
ROLLS = 0.35  # y/b where a long contact that rolls freely between rigid surfaces does not slip


class Grid(NamedTuple):
    """How finely a contact is cut."""

    strips: int
    cells: int  # of a strip


@dataclass(frozen=True, kw_only=True)
class Elasticity:
    """How one contact deforms, in place of half spaces under Hertz's pressure."""

    influence: Influence
    pressure: Callable[[Strips], Array] | None = None  # Pa, (strips, cells); it is scaled to the load; None: Hertz's


class RaceCreep(NamedTuple):
    """One contact of a ball that has settled. Torques are about the bearing axis, as power over the ring's speed."""

    load: float  # Q, N
    angle: float  # al, rad
    semi_axis_rolling: float  # a, m
    semi_axis_transverse: float  # b, m
    side: float  # 1 where the contact's x, which points to its leading edge, is along the orbit, else -1
    rolling_speed: float  # V over the ring's speed, m
    friction: RollingFriction  # creepages, forces, slip share, and maps
    spin_moment: float  # on the ball about n, N m
    rolling_moment: float  # int (t_x y^2/2 - t_y x y) dA/R, N m
    transverse_force: float  # on the ball along t, N
    torque: float  # by sliding, N m
    spin_torque: float  # part of it by spin


@dataclass(frozen=True, kw_only=True, eq=False)
class TurnedBall:
    """A ball that turns steadily."""

    velocity: Array  # (4,) v over the ring's speed, m
    races: tuple[RaceCreep, RaceCreep]  # inner and outer
    orbit: float  # r_m, m
    steps: int  # of Newton's method

    @property
    def torque(self) -> float:
        """By sliding of this ball on both races, about the bearing axis, N m."""
        return self.races[0].torque + self.races[1].torque


@dataclass(frozen=True, kw_only=True, eq=False)
class TurningBall:
    """A ball, what holds it, and what its races resist."""

    held: HeldBall
    laws: tuple[PointLaw, PointLaw]  # of traction on inner and outer race
    speed: float  # w of the inner ring, rad/s, >= 0
    inertia: bool = True  # whether centrifugal force and gyroscopic moment count
    elasticity: tuple[Elasticity, Elasticity] | None = None  # of both contacts; None: half spaces, Hertz's pressure


@dataclass(frozen=True, kw_only=True, eq=False)
class _Contact:
    """One race with the strips of its contact under one load."""

    motion: RaceMotion
    unit: UnitContact
    law: PointLaw
    load: float  # N
    surfaces: RollingSurfaces
    pressure: Array  # (strips, cells) Pa
    pressed: Array  # slip by pressure

    def solved(
        self, slip: RigidSlip, load: float, speed: float, start: RollingFriction | None, follows: bool
    ) -> RollingFriction:
        """Friction under another load, N; speed : w, rad/s."""
        factor = (load / self.load) ** (1 / 3)
        pressure = factor * self.pressure
        return rolling_friction(
            self.surfaces.scaled(factor),
            slip.creepages,
            pressure=pressure,
            law=sliding_law(self.law, pressure=pressure, speed=slip.rolling_speed * speed),
            pressed=factor * self.pressed,
            start=start,
            follows=follows,
        )

    def softer(self, times: float) -> "_Contact":
        return replace(self, surfaces=replace(self.surfaces, gradient=times * self.surfaces.gradient))


class _Met(NamedTuple):
    """What the contacts do in one state of the ball."""

    loads: tuple[float, float]
    frictions: tuple[RollingFriction, RollingFriction]

    @property
    def friction(self) -> float:
        """Sum of its magnitudes, N."""
        return sum(float(np.sum(np.hypot(*each.traction) * each.strips.area)) for each in self.frictions)


def turn_ball(ball: TurningBall, grid: Grid, start: TurnedBall | None = None) -> TurnedBall:
    """The ball where no force and no moment is left on it.

    start : of another grid, from which the search begins
    Raises InputError for a ball that one race does not touch, or without friction, and ConvergenceError where Newton's
    method ends short, as with a friction far above 1.
    """
    if not any(law.boundary + law.plain + law.limit > 0 for law in ball.laws):
        raise InputError("both races are without friction, and nothing turns the ball: give a coefficient above 0")
    lie = ball.held.at_rest() if start is None else _lie_of(start)
    motions = race_motions(ball.held.bearing)
    velocity = _rolling_freely(ball.held, motions, lie) if start is None else start.velocity
    contacts = tuple(
        _cut(ball, k, motion, lie, rigid_slip(motion, lie.angles[k], lie.orbit, velocity), grid)
        for k, motion in enumerate(motions)
    )
    units = contacts[0].unit, contacts[1].unit
    state = np.concatenate([velocity, ball.held.coordinates(lie, units)])
    search, ways = _Search(ball, (contacts[0], contacts[1])), WAYS if start is not None else WAYS[1:]
    for way in ways[:-1]:
        with suppress(ConvergenceError):
            return _along(way, search, state)
    return _along(ways[-1], search, state)


def _along(way: tuple[float, ...], search: "_Search", state: Array) -> TurnedBall:
    """From softer surfaces to the true ones."""
    for times in way:
        softer = search.contacts[0].softer(times), search.contacts[1].softer(times)
        state = _Search(search.ball, softer).settled(state, ROUGHLY)[0]
    return search.turned(*search.settled(state, SETTLED))


def _lie_of(turned: TurnedBall) -> Lie:
    inner, outer = turned.races
    return Lie((inner.angle, outer.angle), (inner.load, outer.load), turned.orbit)


def race_motions(bearing: Bearing) -> tuple[RaceMotion, RaceMotion]:
    """The surfaces of both bodies meet where their shares of the compliance place them."""
    radius = bearing.ball_radius

    def motion(race: Race, sign: float) -> RaceMotion:
        numbers = race_numbers(bearing, race)
        curvature = 1 / radius - numbers.ball_share * numbers.curvature_transverse
        return RaceMotion(sign=sign, ball_radius=radius, surface_radius=1 / curvature)

    return motion("inner", -1.0), motion("outer", 1.0)


def _rolling_freely(held: HeldBall, motions: tuple[RaceMotion, RaceMotion], lie: Lie) -> Array:
    """A velocity to begin with: no slip along rolling at y = ROLLS b, equal spin, no rotation along the orbit."""
    rows, right = np.zeros((4, 4)), np.zeros(4)
    for k, motion in enumerate(motions):
        rates, added = slip_rates(motion, lie.angles[k], lie.orbit)
        square = (ROLLS * unit_under(held.bearing, RACES[k], lie.angles[k]).semi_axis_transverse) ** 2 * lie.loads[
            k
        ] ** (2 / 3)
        rows[k], right[k] = rates[0] + rates[1] * square, -(added[0] + added[1] * square)
        rows[2] -= motion.sign * rates[3]
        right[2] += motion.sign * added[3]
    rows[3, 1] = 1.0
    return np.asarray(np.linalg.solve(rows, right), dtype=float)


def _cut(ball: TurningBall, k: int, motion: RaceMotion, lie: Lie, slip: RigidSlip, grid: Grid) -> _Contact:
    """A contact in strips that meet where the slip along rolling turns round."""
    bearing, race, load = ball.held.bearing, RACES[k], lie.loads[k]
    unit = unit_under(ball.held.bearing, race, lie.angles[k])
    if not load > 0:
        raise InputError(f"the {race} race does not touch the ball: give it a load, or leave the ball out")
    size, given = load ** (1 / 3), slip.creepages
    roots = np.roots([given.along_bend, -given.spin, given.along])
    strips = ellipse_strips(
        semi_axis_rolling=size * unit.semi_axis_rolling,
        semi_axis_transverse=size * unit.semi_axis_transverse,
        count=grid.strips,
        cells=grid.cells,
        sides=sorted(roots.real[np.isreal(roots)].tolist()),
    )
    material = (bearing.inner if k == 0 else bearing.outer).material
    elastic = (
        ball.elasticity[k]
        if ball.elasticity
        else Elasticity(influence=HalfSpaces(ball=bearing.ball_material, race=material))
    )
    pressure = elastic.pressure(strips) if elastic.pressure else hertz_pressure(strips, load=load)
    pressure = pressure * load / np.sum(pressure * strips.area)
    return _Contact(
        motion=motion,
        unit=unit,
        law=ball.laws[k],
        load=load,
        surfaces=rolling_surfaces(strips, elastic.influence),
        pressure=pressure,
        pressed=pressed_slip(strips, elastic.influence, pressure),
    )


class _Search(NamedTuple):
    """Newton's method with strips that stay. A state is the ball's velocity and its coordinates."""

    ball: TurningBall
    contacts: tuple[_Contact, _Contact]

    def lie(self, state: Array) -> Lie:
        return self.ball.held.lie(state[4:], (self.contacts[0].unit, self.contacts[1].unit))

    def moved(self, state: Array, step: Array) -> Array:
        return np.concatenate([state[:4] + step[:4], self.ball.held.moved(state[4:], step[4:])])

    def slips(self, state: Array, lie: Lie) -> tuple[RigidSlip, RigidSlip]:
        inner, outer = (
            rigid_slip(contact.motion, angle, lie.orbit, state[:4])
            for contact, angle in zip(self.contacts, lie.angles, strict=True)
        )
        return inner, outer

    def met(self, state: Array, last: _Met | None, follows: bool = True) -> _Met:
        """The contacts, solved; last, follows : where this begins, as in `rolling_friction`."""
        lie = self.lie(state)
        if not min(lie.loads) > 0:
            raise ConvergenceError(iterations=0, residual=np.nan, tolerance=SETTLED, problem="a ball off its race")
        inner, outer = (
            contact.solved(slip, load, self.ball.speed, last and last.frictions[k], follows)
            for k, (contact, slip, load) in enumerate(
                zip(self.contacts, self.slips(state, lie), lie.loads, strict=True)
            )
        )
        return _Met(lie.loads, (inner, outer))

    def lacks(self, state: Array, met: _Met) -> Array:
        """Of the equilibrium, N, where contacts follow their derivatives and loads from those that were solved."""
        lie, velocity, across = self.lie(state), state[:4], []
        force, held = np.zeros(4), self.ball.held
        for slip, load, solved_load, solved in zip(self.slips(state, lie), lie.loads, *met, strict=True):
            change = np.array(slip.creepages) - np.array(solved.creepages)
            forces = solved.forces * load / solved_load + solved.response @ change
            force += slip.rates.T @ forces
            across.append(float(forces[2]))
        speed = self.ball.speed if self.ball.inertia else 0.0
        gyro = 0.4 * held.bearing.ball_mass * speed**2 / lie.orbit
        force += gyro * velocity[0] * np.array([0, -velocity[2], velocity[1], 0])
        outward = held.bearing.ball_mass * (speed * velocity[0]) ** 2 / lie.orbit
        return np.concatenate([force, held.lacks(lie, (across[0], across[1]), outward)])

    def step(self, state: Array, met: _Met) -> Array:
        """Of Newton's method; the derivatives of the equations are differences, those of the contacts are in them."""
        size, length = len(state) - 4, self._length(met)
        scale = np.concatenate([np.full(4, self.ball.held.bearing.ball_radius), np.full(size, length)])
        columns = [
            self.lacks(state + move, met) - self.lacks(state - move, met) for move in np.diag(DIFFERENCE * scale)
        ]
        tangent = np.stack(columns, axis=1) / (2 * DIFFERENCE)
        try:
            return np.asarray(-scale * np.linalg.solve(tangent, self.lacks(state, met)), dtype=float)
        except np.linalg.LinAlgError:
            problem = "the ball slides all over, and its friction does not change with its rotation"
            raise SingularError(problem=problem, remedy="Take less speed, or more friction.") from None

    def longest(self, state: Array, step: Array) -> float:
        """Share of a step that changes the slip of a contact by `MOST_CHANGE` of itself: beyond, friction is level."""
        lie, moved = self.lie(state), self.moved(state, step)
        there = self.lie(moved)
        shares = []
        for contact, load, now, then in zip(
            self.contacts, lie.loads, self.slips(state, lie), self.slips(moved, there), strict=True
        ):
            b = contact.unit.semi_axis_transverse * load ** (1 / 3)
            sizes = np.array([1, b**2, 1, b])
            slip, change = np.array(now.creepages) * sizes, (np.array(then.creepages) - now.creepages) * sizes
            shares.append(MOST_CHANGE * np.sum(np.abs(slip)) / max(float(np.sum(np.abs(change))), TINY))
        return min(shares)

    def _length(self, met: _Met) -> float:
        """Of the ball's place, m: the share `DIFFERENCE` of it is far below the approach of a light contact too."""
        approach = min(
            contact.unit.approach * load ** (2 / 3) for contact, load in zip(self.contacts, met.loads, strict=True)
        )
        return min(0.01 * free_lengths(self.ball.held.bearing)[0], OF_APPROACH / DIFFERENCE * approach)

    def settled(self, state: Array, accuracy: float) -> tuple[Array, _Met, int]:
        """State, contacts and steps; accuracy : of what the ball lacks, over all friction.

        The places where slip is taken stop following it when that no longer helps.
        """
        met, follows, share = self.met(state, self.met(state, None)), True, 1.0
        lacks = float(np.linalg.norm(self.lacks(state, met)))
        for number in range(MOST_STEPS):
            if lacks <= accuracy * met.friction:
                return state, met, number
            follows = follows and lacks > NEARLY * met.friction
            step = self.step(state, met)
            share = min(1.0, 4 * share, self.longest(state, step))
            least = LEAST_SHARE * share
            while share >= least:
                trial = self.moved(state, share * step)
                try:
                    there = self.met(trial, met, follows)
                except ConvergenceError:  # too far
                    share /= 2
                    continue
                left = float(np.linalg.norm(self.lacks(trial, there)))
                if left <= (1 - LEAST_GAIN * share) * lacks:
                    state, met, lacks = trial, there, left
                    break
                share /= 2
            else:
                if not follows:
                    break
                follows = False
        raise ConvergenceError(
            iterations=MOST_STEPS,
            residual=float(lacks),
            tolerance=float(accuracy * met.friction),
            problem="the rotation of the ball",
            remedy="Give less friction or less speed, or more load.",
        )

    def turned(self, state: Array, met: _Met, steps: int) -> TurnedBall:
        lie = self.lie(state)
        slips = self.slips(state, lie)
        inner, outer = (
            _race_creep(contact, slip, angle, load, friction)
            for contact, slip, angle, load, friction in zip(
                self.contacts, slips, lie.angles, lie.loads, met.frictions, strict=True
            )
        )
        return TurnedBall(velocity=state[:4], races=(inner, outer), orbit=lie.orbit, steps=steps)


def _race_creep(contact: _Contact, slip: RigidSlip, angle: float, load: float, friction: RollingFriction) -> RaceCreep:
    size, creepages = load ** (1 / 3), friction.creepages
    return RaceCreep(
        load=load,
        angle=angle,
        semi_axis_rolling=size * contact.unit.semi_axis_rolling,
        semi_axis_transverse=size * contact.unit.semi_axis_transverse,
        side=slip.side,
        rolling_speed=slip.rolling_speed,
        friction=friction,
        spin_moment=slip.side * friction.spin_moment,
        rolling_moment=friction.bend_moment / (2 * contact.motion.surface_radius),
        transverse_force=friction.force_across,
        torque=friction.power * slip.rolling_speed,
        spin_torque=-friction.spin_moment * creepages.spin * slip.rolling_speed,
    )
