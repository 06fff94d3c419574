"""Which effects of balls and races count: by trial, as the torque with an effect and without it.

A few points compute every effect that has its input: leaving one out saves nothing. Only an effect that asks for a
ring of all balls is tried there. In a longer series far points are tried, and an effect is left out whose share of
the torque fits there into half of the tolerance. The balls of a trial turn by closed kinematics, and each contact
slides by one coefficient.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.cage.drive import resting_cage
from analytic.contact.factors import ContactCorrection
from analytic.contact.geometry import RACES, race_numbers
from analytic.effects.ledger import Ledger
from analytic.effects.table import (
    ENTRIES,
    PER_CENTRIFUGAL,
    PER_CONFORMITY,
    PER_DISTRIBUTION,
    PER_GYROSCOPIC_SLIP,
    PER_LAG,
    PER_ORBIT,
    PER_WEIGHT_SLIDING,
    PER_WEIGHT_SLIP,
    TRIED,
    WEDGING_POWER,
    ruled,
)
from analytic.loads.inertia import ratio
from analytic.oil.variation import Variation
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, Operation, Scene
from analytic.sliding.judge import OVER_ELLIPSE, SINGLE_COEFFICIENT
from analytic.solve.freely import BETWEEN, part_by_sliding
from analytic.solve.model import Model, model_of
from analytic.solve.records import OWN_FORCES
from analytic.solve.solution import FAR, Solution, points_of, solved, tried_points
from analytic.words import length_of, percent_of

# Change of the torque over the share by trial, whose balls turn by rule and slide by one coefficient. Of single points
# it was 1.7 at most by other methods of sliding and 4.3 of free balls, both of the balls' weight, where a trial was let
# count once (validation/adversary/run.py, seed 1).
OF_METHODS, OF_FREE_BALLS = 2.5, 6.0
LEAD_COUNTS = 0.5  # of the free clearance of the pockets; balls by rule lead 0.6 to 1.4 times as far as most free ones
FEW = f"always computed for up to {FAR} points"
ON_A_RING = "computed together with the weight"
WITH_LOADS = "neglected with load_distribution, whose share includes it"


@dataclass(frozen=True, kw_only=True, eq=False)
class Trial:
    """The kernel at the points of a scene that are tried, with any effects."""

    scene: Scene
    operation: Operation  # every array (n,)
    model: Model  # of the scene, with every effect that it has the input for
    points: Array  # (n, 5) of the scene
    tried: NDArray[np.intp]  # (k,) numbers of those that are tried
    known: dict[Any, Solution] = field(default_factory=dict)  # by effects, method, and whether it is judged

    def solved(
        self, counted: Mapping[str, bool], method: int = SINGLE_COEFFICIENT, *, judges: bool = False
    ) -> Solution:
        """The tried points with these effects.

        method : of sliding;  judges : it judges itself, which for spin alone costs more than all else
        """
        judges = judges or counted.get("conformity", False)
        key = tuple(sorted(counted.items())), method, judges
        if key not in self.known:
            model = self.model.counting(counted).with_numbers(method=method, judges=judges).at(self.tried)
            self.known[key] = solved(model, self.points[self.tried])
        return self.known[key]

    def share(self, counted: Mapping[str, bool], *names: str) -> Array:
        """(k,) change of the race torque when these effects change sides, over that with `counted`.

        Infinite where there is no torque to compare with.
        """
        return _change(self._changed(counted, names).race_torque[None], self.solved(counted).race_torque[None])

    def share_by_parts(self, counted: Mapping[str, bool], *names: str) -> Array:
        """(k,) the same with the changes of all parts added by size: they may cancel in a trial, not in the torque.

        That of conformity is integrated over the ellipse: one coefficient has none of it where spin decides the sign
        of the slip everywhere, since friction on both halves of the ellipse then cancels.
        """
        method = OVER_ELLIPSE if "conformity" in names else method_of_changes(self.scene)
        other, base = self._changed(counted, names, method), self.solved(counted, method)
        return _change(other.race_parts, base.race_parts)

    def _changed(
        self, counted: Mapping[str, bool], names: tuple[str, ...], method: int = SINGLE_COEFFICIENT
    ) -> Solution:
        return self.solved({**counted, **{name: not counted[name] for name in names}}, method)

    def measure(self, counted: Mapping[str, bool]) -> Callable[[str], float]:
        """What gives the largest share of an effect that counts."""
        return lambda name: float(self.share(counted, name).max())

    @cached_property
    def under_thrust(self) -> Solution:
        """All points under their thrust alone, without any other effect."""
        return solved(self.model.counting({}), self.points)

    def further(self, name: str) -> Array | float:
        """(n,) factor on the share of an effect by trial, for points with a lighter ball than any tried one; from 1 on.

        It is the force that acts on a ball over its least load, over the largest such ratio at the tried points; 1 for
        other effects than OWN_FORCES. Infinite where a ball of an untried point alone has no load.
        """
        if self.is_of_all or name not in OWN_FORCES:
            return 1.0
        share = self.under_load.points[f"{name}_share"]
        most = share[self.tried].max()
        return np.fmax(share / most, 1.0) if 0 < most < np.inf else 1.0  # a point that does not settle so has no share

    @cached_property
    def under_load(self) -> Solution:
        """All points under their loads and the weights of the balls alone."""
        can = possible(self.scene)
        counted = {name: can[name] for name in ("load_distribution", "weight")}
        return solved(self.model.counting(counted), self.points, keeps_balls=False)

    @property
    def is_of_all(self) -> bool:
        """Whether every operating point is tried."""
        return len(self.tried) == len(self.points)


def trial_of(scene: Scene, operation: Operation, correction: ContactCorrection | None, variation: Variation) -> Trial:
    """A trial of the scene at its operating points, or at far ones of many; arguments as of `friction_torque`."""
    model = model_of(scene, possible(scene), correction=correction, variation=variation)
    points = points_of(operation, model.temperature)
    return Trial(
        scene=scene,
        operation=operation,
        model=model,
        points=points,
        tried=tried_points(points, float(model.numbers.arm)),
    )


def possible(scene: Scene) -> dict[str, bool]:
    """Each effect of balls and races: whether it has its input, can act, and is not ruled out."""
    found = {
        name: ENTRIES[name].lacks(scene) is None and scene.effects.get(name) != "off" and _acts(scene, name)
        for name in TRIED
    }
    return found | {name: found[name] and _has_effect(scene, name, found) for name in found}


def decide_effects(ledger: Ledger, trial: Trial, base: Solution, *, has_factors: bool) -> dict[str, bool]:
    """Settle every effect of balls and races but creep; which of them count.

    base : with every effect that is possible;  has_factors : the call gives the factors on the contacts
    """
    scene = ledger.scene
    counted = possible(scene)
    # A ring of all balls, where one would stand for all, costs the same for unequal loads and for weights: it has both.
    both = counted["load_distribution"] and counted["weight"]
    for name in TRIED:
        entry, wanted = ENTRIES[name], scene.effects.get(name, "auto")
        if name == "finite_geometry" and has_factors:
            ledger.settle(name, on=True, reason=entry.given)
        elif entry.lacks(scene) is not None:
            share = _share_without_input(trial, base, name)
            ledger.decide(name, bound=None if share is None else _at_all(ledger, share))
        elif counted[name]:
            alike = name == "load_distribution" or (name == "weight" and not counted["load_distribution"])
            demanded = FEW if trial.is_of_all and not alike else _demanded(name, base, scene)
            if both and alike and scene.effects.get("weight") == "on":
                demanded = ON_A_RING
            trying = wanted == "auto" and demanded is None
            names = (name, "weight") if both and name == "load_distribution" else (name,)
            bound = None
            if trying:
                tried = left_out_at_all(ledger, trial.share_by_parts(counted, *names))
                bound = np.multiply(tried, trial.further(name), out=np.zeros_like(tried), where=tried > 0)
            if bound is not None and ruled(scene) is None:
                bound = bound + unseen_by_trial(ledger, trial, counted, names)
            if both and name == "weight" and trying and not counted["load_distribution"]:
                ledger.settle(name, on=False, share=bound, reason=WITH_LOADS)
                counted[name] = False
            else:
                counted[name] = ledger.decide(name, bound=bound, demanded=demanded)
        elif wanted == "off":
            acts = _acts(scene, name) and _has_effect(scene, name, counted)
            ledger.decide(name, bound=_at_all(ledger, trial.share(counted, name) if acts else np.zeros(1)))
        else:
            ledger.decide(name, bound=np.zeros_like(ledger.left_out), lacks=_idle(name))
    return counted


def unseen_by_trial(ledger: Ledger, trial: Trial, counted: Mapping[str, bool], names: tuple[str, ...]) -> Array:
    """(n,) change of the torque of free balls by effects, beyond that by trial, whose balls turn by rule."""
    bearing, found = ledger.scene.bearing, trial.solved(counted)
    lags = np.minimum(found.sliding_number.max(axis=0), 1.0)
    change = np.zeros_like(ledger.left_out)
    if "gyroscopic" in names:
        change = change + slip_by_gyroscopic_moment(ledger, found)
    if "weight" in names:
        change = change + at_all_points(ledger, slip_by_weight(bearing, found))
    if "conformity" in names:  # a ball that lags slides along rolling, where conformity adds to its slip
        change = change + at_all_points(ledger, PER_LAG * found.sliding_number.max(axis=0))
    if "load_distribution" in names and lags.any():  # balls that lag where their loads are small
        unequal = unequal_loads(ledger.scene, trial.operation, trial.under_thrust)
        change = change + PER_DISTRIBUTION * unequal * lags.max()
    if "asperities" in names:  # they are a part of the friction that keeps balls from slipping and lagging
        part = part_by_asperities(found, trial.solved({**counted, "asperities": False}))
        slips = slip_by_gyroscopic_moment(ledger, found) + at_all_points(ledger, slip_by_weight(bearing, found) + lags)
        held = _at_all(ledger, part)
        change = change + np.multiply(held, slips, out=np.zeros_like(slips), where=held > 0)
    return change


def part_by_asperities(found: Solution, without: Solution) -> Array:
    """(k,) largest change of a ball's friction on a race by asperities, over the larger of both; 1 at most."""
    friction, other = (each.balls["friction_coefficient"] for each in (found, without))
    return ratio(np.abs(friction - other), over=np.maximum(friction, other)).max(axis=(1, 2))


def slip_by_gyroscopic_moment(ledger: Ledger, found: Solution) -> Array:
    """(n,) change of the torque by slip across the grooves, which a trial does not show: its balls turn by rule.

    found : at the tried points
    """
    used = np.nan_to_num(found.balls["gyroscopic_use"], nan=np.inf, posinf=np.inf).max(axis=1)
    return at_all_points(ledger, PER_GYROSCOPIC_SLIP * used)


def slip_by_weight(bearing: Bearing, found: Solution) -> Array:
    """(n,) change of the torque of free balls that slip under their weight, which a trial does not show.

    Friction holds a ball against the part of its weight along the orbit; balls count by their loads. Sliding changes
    by more than rolling.
    """
    weight, load = bearing.ball_mass * STANDARD_GRAVITY, found.balls["load"]
    friction = np.where(load > 0, found.balls["friction_coefficient"] * load, np.inf).min(axis=2)
    friction = np.where(np.isfinite(friction), friction, 0.0)  # a ball without load has none
    slips = np.minimum(ratio(weight, over=friction), 1.0).mean(axis=1)
    change = PER_WEIGHT_SLIP + PER_WEIGHT_SLIDING * part_by_sliding(found)
    # Balls that lag, since friction hardly drives them, lag behind unequally where their weights make loads unequal.
    lag = np.minimum(found.sliding_number.max(axis=0), 1.0)
    lags = PER_DISTRIBUTION * lag * np.minimum(ratio(weight, over=load.min(axis=2).mean(axis=1)), 1.0)
    return change * slips * ratio(weight, over=load.max(axis=2).mean(axis=1)) + lags


def rolls_otherwise(bearing: Bearing, found: Solution) -> Array:
    """(n,) change of the torque by how fast free balls roll, which a trial does not show: its balls turn by rule.

    By rule a ball rolls in the middle of each contact. Friction leaves no force along rolling: the slip by conformity,
    y^2/(2 r r_d) of the speed with the radius r_d of the deformed contact, is zero at some y, at most at b. By rule a
    ball goes round on the pitch diameter; in grooves of unlike radii its orbit is (r_gi - r_go) (1 - cos al)/2 wider.
    """
    conforms = np.zeros(len(found.points))
    for k, race in enumerate(RACES):
        widest = found.balls["semi_axis_transverse"][..., k].max(axis=1)
        deformed = race_numbers(bearing, race).deformed_radius
        conforms = np.maximum(conforms, widest**2 / (2 * bearing.ball_radius * deformed))
    if bearing.kind == "thrust":
        return PER_CONFORMITY * conforms
    angle = np.abs(found.balls["angle"]).max(axis=(1, 2))
    wider = abs(bearing.inner.groove_radius - bearing.outer.groove_radius) / 2 * (1 - np.cos(angle))
    return PER_CONFORMITY * conforms + PER_ORBIT * wider / (bearing.pitch_diameter / 2 - bearing.ball_radius)


def growth_by_wedging(bearing: Bearing, by_rule: Solution, found: Solution) -> Array:
    """(n,) factor on what unequal loads and weights do to balls by rule, for free ones that friction wedges; from 1 on.

    by_rule, found : the balls at the same points, by rule and free
    Friction across both grooves, f times the load, leans the lines of contact apart by 2 f. The way between the centres
    of the grooves then is longer by X = l (al_i - al_o)^2/2 with 1/l = 1/(r_gi - r) + 1/(r_go - r), and the ring sees
    the approach delta - X. With f as the load to the power p, a load changes by 1/(1 - 3 p X/delta) of what delta alone
    lets it. Infinite where one approach belongs to several loads. The centrifugal force leans the lines too, by a part
    that falls with the load: it does not soften the ball, and is taken off as by rule. Source: derived here.
    """
    inner, outer = (groove.groove_radius - bearing.ball_radius for groove in (bearing.inner, bearing.outer))
    length = inner * outer / (inner + outer)
    apart, straight = (each.balls["angle"][..., 0] - each.balls["angle"][..., 1] for each in (found, by_rule))
    load = found.balls["load"].min(axis=2)
    longer = np.sum(load * length / 2 * (apart - straight) ** 2, axis=1)
    approach = np.sum(load * found.balls["approach"].sum(axis=2), axis=1)
    left = 1 - 3 * WEDGING_POWER * ratio(longer, over=approach)
    return np.divide(1.0, left, out=np.full_like(left, np.inf), where=left > 0)


def _change(parts: Array, base: Array) -> Array:
    """(k,) sum of the changes of parts, (p, k), over their sum."""
    change, whole = np.nan_to_num(np.abs(parts - base), nan=np.inf).sum(axis=0), base.sum(axis=0)
    return np.divide(change, whole, out=np.where(change > 0, np.inf, 0.0), where=whole > 0)


def _at_all(ledger: Ledger, share: Array) -> Array:
    """(n,) the largest share at the tried points, (k,), for all, or their own where all are tried."""
    return share if share.size == ledger.left_out.size else np.full_like(ledger.left_out, share.max())


def method_of_changes(scene: Scene) -> int:
    """The cheapest method of sliding that shows what an effect changes.

    The torque by spin alone, of a scene whose conformity is off, follows the creep in first order: one coefficient then
    shows too little.
    """
    return OVER_ELLIPSE if scene.effects.get("conformity") == "off" else SINGLE_COEFFICIENT


def of_methods(scene: Scene) -> float:
    """Change of the torque over a share by trial, at most."""
    return OF_FREE_BALLS if ruled(scene) is None else OF_METHODS


def left_out_at_all(ledger: Ledger, share: Array) -> Array:
    """(n,) what an effect may change at any point, from its share by trial at those that are tried, (k,)."""
    return at_all_points(ledger, of_methods(ledger.scene) * share)


def at_all_points(ledger: Ledger, share: Array) -> Array:
    """(n,) a share at any point, from those at the tried ones, (k,); more between them."""
    return _at_all(ledger, share if share.size == ledger.left_out.size else BETWEEN * share)


def _acts(scene: Scene, name: str) -> bool:
    """Whether the operating points of a scene let an effect change anything."""
    if name == "load_distribution":
        return not scene.operation.is_thrust or scene.effects.get(name) == "on"
    if name in ("centrifugal", "gyroscopic"):
        return bool(np.any(scene.operation.inner_speed)) or scene.effects.get(name) == "on"
    return True


def _idle(name: str) -> str:
    """Why an effect with its input has nothing to act on, in words."""
    if name == "load_distribution":
        return "pure thrust: equal ball loads"
    return "no rotation" if name in ("centrifugal", "gyroscopic") else ENTRIES[name].idle


def _has_effect(scene: Scene, name: str, counted: Mapping[str, bool]) -> bool:
    """Whether there is something that an effect of the oil can act on."""
    slides = counted["spin"] or counted["conformity"]
    if name == "asperities":
        return slides
    if name == "unloaded_balls":
        asked = scene.effects.get(name) == "on"
        return asked or (counted["rolling"] and (counted["load_distribution"] or counted["weight"]))
    in_oil = counted["rolling"] or (slides and scene.friction_coefficient is None)
    return in_oil if name in ("inlet_heating", "starvation") else True


def _demanded(name: str, base: Solution, scene: Scene) -> str | None:
    """Why an effect counts whatever it changes of the race torque, in words.

    Without asperities film and share would not be those of the contact. Unequal balls that lead farther than the
    pockets leave free squeeze the cage, which the race torque does not show.
    """
    if name == "asperities":
        share = float(np.nan_to_num(base.balls["asperity_share"]).max())
        return f"asperities carry up to {percent_of(share, 2)} of a contact's load" if share > scene.tolerance else None
    if name in ("load_distribution", "weight") and scene.cage is not None and scene.effects.get("cage") != "off":
        lead, room = float(np.abs(base.points["ball_lead"]).max()), resting_cage(scene.bearing, scene.cage).room
        if lead > LEAD_COUNTS * room:
            return f"ball lead up to {length_of(lead)}, free clearance of the pockets {length_of(room)}"
    return None


def _share_without_input(trial: Trial, base: Solution, name: str) -> Array | None:
    """(k,) about, of an effect that lacks its input; None: not known."""
    if name == "load_distribution":
        return PER_DISTRIBUTION * unequal_loads(trial.scene, trial.operation, trial.under_thrust)
    if name in ("centrifugal", "gyroscopic", "weight"):
        return (1.0 if name == "gyroscopic" else PER_CENTRIFUGAL) * base.points[f"{name}_share"]
    return None


def unequal_loads(scene: Scene, operation: Operation, found: Solution) -> Array:
    """(n,) (Fr tan(al) + 2 M/d_m)/Fa: how unequal radial load and moment make balls that thrust loads alike.

    operation : every array (n,);  found : under the thrust of these points alone
    The ratio is infinite without axial load.
    """
    angle = np.nan_to_num(np.abs(found.balls["angle"]).max(axis=(1, 2)))
    radial, moment = np.abs(operation.radial_load), np.abs(operation.moment)
    other = radial * np.tan(angle) + 2 * moment / scene.bearing.pitch_diameter
    # Without thrust there is no angle.
    return ratio(np.where(operation.axial_load > 0, other, radial + moment), over=operation.axial_load)
