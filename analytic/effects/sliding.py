"""Decisions about conformity, asperities, inlet heating, starvation, spin and creep, before anything slides.

The torque is estimated with an effect and without it, from stresses at the mean pressure and the mean sliding speed of
each contact. The change counts times the largest error of such a stress (`analytic.sliding.levers.largest_error`). It
is estimated twice, for balls that only roll and for races that take all spin, and the larger share counts.
"""

from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES, PER_GYROSCOPIC_SLIP, ruled
from analytic.errors import InputError
from analytic.free_ball.rotation import Creep
from analytic.loads.balls import LoadedBalls
from analytic.loads.inertia import gyroscopic_moment, ratio
from analytic.numerics.interpolated import far_points
from analytic.oil.inlets import Inlets
from analytic.oil.lubricated_races import LubricatedRaces
from analytic.oil.mixed import MixedContact
from analytic.oil.traction import MixedTraction
from analytic.scene import Array, Scene
from analytic.sliding.creep import creep_shares
from analytic.sliding.levers import full_spin_lever, largest_error, largest_spin_lever, rolling_lever
from analytic.words import percent_of

LIGHT = 0.01  # of the heaviest ball's load: a film of a lighter ball hardly changes the torque
# Of the heaviest ball's load, a judgement: a lighter ball is at the edge of the loaded zone, and its slip costs little.
IN_LOADED_ZONE = 0.1
SERIES, LOOKED_AT = 500, 64  # points from which on some are looked at first, and how many
TURNING_FREELY = ("free_ball", "closed_creep", "marched_creep")  # methods of sliding for free balls


@dataclass(frozen=True, kw_only=True, eq=False)
class Resisting:
    """What resists the motion of the loaded balls, before it is decided which effects count."""

    balls: LoadedBalls
    constant: Array  # (n,) N m: torques that none of the effects here change
    rolling: Array | None  # (2, n, m) N m, of flooded and isothermal inlets; None: left out
    inlets: Inlets | None  # None: no lubricant
    oiled: LubricatedRaces | None  # None: the friction coefficient is given, or nothing slides
    friction_coefficient: float = 0.0  # where it is given

    @cached_property
    def starvation_thins(self) -> bool:
        """Whether an inlet is so starved that its film is thinner."""
        starvation = None if self.inlets is None else self.inlets.starvation
        return starvation is not None and bool(np.any(starvation.film_factor < 1))

    def at(self, points: NDArray[np.intp]) -> "Resisting":
        """The same at some operating points."""
        return replace(
            self,
            balls=self.balls.at(points),
            constant=self.constant[points],
            rolling=None if self.rolling is None else self.rolling[:, points],
            inlets=None if self.inlets is None else self.inlets.at(points),
            oiled=None if self.oiled is None else self.oiled.at(points),
        )

    def far_points(self, ring_speed: Array) -> NDArray[np.intp]:
        """Some points that differ most in load and speed; ring_speed : w, (n,), rad/s."""
        load = self.balls.load.max(axis=(0, 2))
        moving = np.flatnonzero((ring_speed != 0) & (load > 0))
        return moving[far_points(np.log(np.stack([load, np.abs(ring_speed)], axis=1)[moving]), LOOKED_AT)]


@dataclass(frozen=True, kw_only=True)
class Regime:
    """What is computed of inlets and surfaces."""

    asperities: bool
    inlet_heating: bool
    starvation: bool


def decide_whether_sliding(ledger: Ledger) -> bool:
    """Settle conformity. Whether sliding has to be computed: by conformity, or by spin unless the scene says off."""
    return ledger.decide("conformity") or not ledger.rules_out("spin")


def decide_sliding(scene: Scene, resisting: Resisting, ledger: Ledger, *, slides: bool) -> "Estimate":
    """Settle asperities, inlet_heating, starvation and spin; return the estimate that they come from.

    slides : whether spin or conformity is computed; if not, inlets act on rolling alone
    In a long series far points are looked at first: where an effect counts at one of them, the others may stay unknown.
    """
    estimate, count, far, at_far = Estimate(resisting, ledger, slides=slides), resisting.constant.size, None, None
    if count >= SERIES:
        far = resisting.far_points(scene.operation.as_series().inner_speed)
        at_far = Estimate(resisting.at(far), ledger, slides=slides) if far.size else None

    def change(name: str, regime: Regime, other: Regime) -> Array:
        if at_far is not None and not ledger.rules_out(name):
            bound = np.zeros(count)
            bound[far] = at_far.change(regime, other)
            if not ledger.fits(bound):
                return bound
        return estimate.change(regime, other)

    regime = Regime(
        asperities=resisting.oiled is not None and not ledger.rules_out("asperities"),
        inlet_heating=resisting.inlets is not None and not ledger.rules_out("inlet_heating"),
        starvation=resisting.inlets is not None
        and resisting.inlets.starvation is not None
        and not ledger.rules_out("starvation"),
    )
    rolls, shears, thins = resisting.rolling is not None, resisting.oiled is not None, resisting.starvation_thins
    acts = {"asperities": slides, "inlet_heating": rolls or shears, "starvation": rolls or (shears and thins)}
    for name, can_act in acts.items():
        other = replace(regime, **{name: not getattr(regime, name)})
        possible = can_act and ENTRIES[name].lacks(scene) is None
        bound = change(name, regime, other) if possible else None
        demanded = _carried(estimate.mixed(regime), scene.tolerance) if name == "asperities" and possible else None
        on = ledger.decide(name, bound=bound, lacks=None if can_act else ENTRIES[name].idle, demanded=demanded)
        regime = replace(regime, **{name: on})
    estimate.regime = regime
    estimate.spin_share = estimate.spin(scene, regime) if slides else None
    ledger.decide("spin", bound=estimate.spin_share)
    return estimate


def mixed_contacts(ledger: Ledger, resisting: Resisting) -> MixedContact | None:
    """The load shared by oil and surfaces as it was decided; None where they do not share it."""
    inlets = resisting.inlets
    if resisting.oiled is None or inlets is None:
        return None
    factor = inlets.film_factor(heats=ledger.is_on("inlet_heating"), starves=ledger.is_on("starvation"))
    return resisting.oiled.mixed(asperities=ledger.is_on("asperities"), film_factor=factor)


def decide_creep(scene: Scene, estimate: "Estimate", ledger: Ledger, *, slides: bool) -> Creep | None:
    """Settle creep; how the surfaces of balls creep that turn freely, or None where closed kinematics turn them.

    Raises InputError for a method of sliding for free balls where something else in the scene says otherwise.
    """
    wanted = {"closed_creep": "closed", "marched_creep": "marched"}.get(scene.sliding)
    contrary = ruled(scene)
    if wanted is not None and ledger.rules_out("creep"):
        contrary = contrary or 'effects.creep = "off" leaves the creep out: use "auto"'
    if slides and contrary is not None and scene.sliding in TURNING_FREELY:
        raise InputError(f'friction.sliding = "{scene.sliding}" cannot be had: {contrary}')
    on = ledger.decide(
        "creep",
        bound=estimate.creep() if slides else None,
        lacks=None if slides else ENTRIES["creep"].idle,
        demanded=None if wanted is None else f'friction.sliding = "{scene.sliding}" has it',
    )
    if slides and contrary is None:
        _decide_gyroscopic_slip(scene, estimate, ledger)
    inert = ledger.is_on("centrifugal") or ledger.is_on("gyroscopic")
    if not slides or contrary is not None or not (on or inert or scene.sliding != "auto"):
        return None
    if not ledger.is_on("spin"):
        ledger.settle("spin", on=True, share=estimate.spin_share, reason=ENTRIES["spin"].given)
    if on:
        return "closed" if scene.sliding == "closed_creep" else "marched"
    return "none"


def _decide_gyroscopic_slip(scene: Scene, estimate: "Estimate", ledger: Ledger) -> None:
    """Put gyroscopic on where friction can hardly hold the moment, however little the moment does to the loads."""
    entry = ENTRIES["gyroscopic"]
    if ledger.is_on("gyroscopic") or ledger.rules_out("gyroscopic") or entry.lacks(scene) is not None:
        return
    share = estimate.gyroscopic(scene)
    if not ledger.leaves_out(PER_GYROSCOPIC_SLIP * share):
        reason = f"holding the moment takes up to {percent_of(np.max(share), 2)} of the friction across the grooves"
        ledger.settle("gyroscopic", on=True, share=PER_GYROSCOPIC_SLIP * share, reason=reason)


def _carried(mixed: MixedContact | None, tolerance: float) -> str | None:
    """Why asperities count whatever they change, in words: else film and share would not be those of the contact."""
    share = 0.0 if mixed is None else float(np.max(mixed.asperity_share))
    return f"asperities carry up to {percent_of(share, 2)} of a contact's load" if share > tolerance else None


class _Torque(NamedTuple):
    """What resists in one regime; arrays (2, n, m)."""

    mixed: MixedContact | None
    traction: MixedTraction | None  # None: by a given coefficient
    friction: tuple[Array, ...]  # N, at each of the levers
    boundary: Array  # N, part of the friction by asperities and films of a molecule
    rolling: Array  # N m


class Estimate:
    """The torque of balls that only roll, and of races that take all spin, without integrals over the contacts."""

    def __init__(self, resisting: Resisting, ledger: Ledger, *, slides: bool) -> None:
        self.resisting = resisting
        balls, oiled = resisting.balls, resisting.oiled
        # Only what counts: without conformity the least torque by sliding is 0.
        self.rolls = rolling_lever(balls) * (slides and ledger.is_on("conformity"))
        spins = slides and not ledger.rules_out("spin")
        self.levers = (self.rolls, self.rolls + largest_spin_lever(balls)) if spins else (self.rolls,)
        self.uneven = 1 + largest_error(balls, None if oiled is None else oiled.lubricant)
        self.known: dict[Regime, _Torque] = {}
        self.spin_share: Array | None = None  # bound on what spin adds, in the regime that was decided
        self.regime: Regime | None = None  # that was decided

    @property
    def decided(self) -> MixedContact | None:
        """The load shared by oil and surfaces in the regime that was decided; None where they do not share it."""
        assert self.regime is not None
        return self.mixed(self.regime)

    def mixed(self, regime: Regime) -> MixedContact | None:
        return self._at(regime).mixed

    def change(self, first: Regime, second: Regime) -> Array:
        """(n,) estimate of the change between two regimes, over the smaller torque of both."""
        total, before, after = self.resisting.balls.total, self._at(first), self._at(second)
        shares = []
        boundary = before.boundary - after.boundary
        for lever, one, other in zip(self.levers, before.friction, after.friction, strict=True):
            # What asperities add and what they take from the oil cancel at the mean stress alone: both count.
            changed = self.uneven * (np.abs(boundary) + np.abs(one - other - boundary))
            moved = total(changed * lever + np.abs(before.rolling - after.rolling))
            least = np.minimum(total(one * lever + before.rolling), total(other * lever + after.rolling))
            shares.append(_over(moved, least + self.resisting.constant))
        return np.max(shares, axis=0)

    def spin(self, scene: Scene, regime: Regime) -> Array:
        """(n,) estimate from above of what spin adds, over the torque without it."""
        _, _, friction, _, rolling = self._at(regime)
        if len(self.levers) < 2:
            return np.zeros_like(self.resisting.constant)
        with_spin, without = friction[1] * self.levers[1], friction[0] * self.rolls
        rise = self.uneven * np.maximum(with_spin - without, 0.0)
        least = {"inner_control": rise[1], "outer_control": rise[0]}.get(scene.spin_rule, rise.min(axis=0))
        total = self.resisting.balls.total
        return _over(total(least[None]), total(without + rolling) + self.resisting.constant)

    def creep(self) -> Array:
        """(n,) estimate of the change of the torque by sliding that elastic creep makes, in the regime decided."""
        assert self.regime is not None
        return creep_shares(self.resisting.balls, np.max(self._at(self.regime).friction, axis=0))

    def gyroscopic(self, scene: Scene) -> Array:
        """(n,) gyroscopic moment of a ball over what friction across both grooves holds, in the regime decided."""
        assert self.regime is not None
        friction = np.min(self._at(self.regime).friction, axis=0)
        return self._gyroscopic(scene, friction).max(axis=1)

    def gyroscopic_hold(self, scene: Scene) -> Array:
        """(n,) gyroscopic moment over the most that friction across both grooves holds, in the loaded zone."""
        largest = self.resisting.balls.load.max(axis=0)
        carries = largest >= IN_LOADED_ZONE * largest.max(axis=1, keepdims=True)
        return np.where(carries, self._gyroscopic(scene, self._most_friction), 0.0).max(axis=1)

    def sliding_number(self) -> Array | None:
        """(2, n) rolling force of the oil on all balls over the most friction of each race; None without rolling.

        A race turns its balls against this force. Beyond 1 it cannot, and the balls skid.
        """
        assert self.regime is not None
        if self.resisting.rolling is None:
            return None
        balls = self.resisting.balls
        force = self._at(self.regime).rolling / (2 * balls.motion.entrainment_speed)
        return ratio(force.sum(axis=2), over=self._most_friction.sum(axis=2))

    @cached_property
    def _most_friction(self) -> Array:
        """(2, n, m) N: of contacts that slide as fast as they roll, in the regime that was decided."""
        assert self.regime is not None
        balls, oiled, traction = self.resisting.balls, self.resisting.oiled, self._at(self.regime).traction
        if oiled is None or traction is None:
            return self.resisting.friction_coefficient * balls.load
        return traction.force(balls.contacts)(np.abs(oiled.ring_speed)[:, None] * balls.motion.entrainment_speed)

    def _gyroscopic(self, scene: Scene, friction: Array) -> Array:
        """(n, m) gyroscopic moment of a ball over what friction across both grooves holds; friction : (2, n, m), N."""
        balls, bearing = self.resisting.balls, scene.bearing
        speed = scene.operation.as_series().inner_speed[:, None]
        moment = gyroscopic_moment(
            ball_mass=bearing.ball_mass,
            ball_diameter=bearing.ball_diameter,
            ball_speed=speed * balls.motion.ball_speed,
            cage_speed=speed * balls.motion.cage_speed,
            axis_angle=balls.motion.pitch,
        )
        held = bearing.ball_radius * np.where(balls.load.min(axis=0) > 0, friction.sum(axis=0), np.inf)
        return _over(np.abs(moment), held)

    def _at(self, regime: Regime) -> _Torque:
        if regime not in self.known:
            self.known[regime] = self._computed(regime)
        return self.known[regime]

    def _computed(self, regime: Regime) -> _Torque:
        balls, inlets, oiled = self.resisting.balls, self.resisting.inlets, self.resisting.oiled
        rolling = np.zeros_like(balls.load)
        if self.resisting.rolling is not None and inlets is not None:
            factor = inlets.rolling_factor(heats=regime.inlet_heating, starves=regime.starvation)
            rolling = self.resisting.rolling * factor
        if regime.starvation and not self.resisting.starvation_thins:
            return self._at(replace(regime, starvation=False))._replace(rolling=rolling)
        if oiled is None or inlets is None:
            force = self.resisting.friction_coefficient * balls.load
            return _Torque(None, None, tuple(force for _ in self.levers), force, rolling)
        factor = inlets.film_factor(heats=regime.inlet_heating, starves=regime.starvation)
        mixed = oiled.mixed(asperities=regime.asperities, film_factor=factor)
        traction = oiled.traction(mixed)
        friction = traction.force(balls.contacts)
        speed = np.abs(oiled.ring_speed)[:, None]
        slips = (self.rolls, self.rolls + full_spin_lever(balls))[: len(self.levers)]
        boundary = oiled.surface.boundary_friction * mixed.boundary_share * balls.load
        return _Torque(mixed, traction, tuple(friction(speed * np.stack(slips))), boundary, rolling)


def _over(part: Array | float, floor: Array) -> Array:
    """part/floor: an estimate of the share of an effect; infinite where there is no other torque."""
    part, floor = np.broadcast_arrays(part, floor)
    return np.divide(part, floor, out=np.where(part > 0, np.inf, 0.0), where=floor > 0)
