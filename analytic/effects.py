"""Every effect of a friction torque: what it is, what it needs, and what it contributes to a torque.

An effect is computed if its input is there (given, derived, or a default with the origin "assumed"), it can act, and
the scene does not switch it off. Nothing is left out because it is small. What an effect contributes is measured when
somebody reads it, by one more solution without it; docs/effects.md lists the entries.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np

from analytic.errors import InputError
from analytic.oil.inlets import starvation_source
from analytic.scene import Decision, Scene
from analytic.words import percent_of

SWITCHED_OFF = "off in the scene"
COMPUTED_WORDS = "computed"
ShareKind = Literal["part", "measured", "estimate", "unknown"]


@dataclass(frozen=True, kw_only=True)
class Need:
    """What an effect needs from the scene."""

    keys: str  # of the scene file
    lacks: Callable[[Scene], str | None]  # what is missing, in words; None: nothing


@dataclass(frozen=True, kw_only=True)
class Entry:
    """One effect."""

    name: str
    meaning: str
    kind: Literal["computed", "cage", "declared", "oil", "limit"]
    needs: Need | None = None
    idle: str = ""  # why it is off in a scene that has what it needs
    given: str = COMPUTED_WORDS  # why it is on

    def lacks(self, scene: Scene) -> str | None:
        """What the scene lacks for it, in words; None: nothing."""
        return None if self.needs is None else self.needs.lacks(scene)


@dataclass(frozen=True, kw_only=True)
class Effect:
    """One physical contribution, of all operating points alike."""

    name: str  # as in `scene.effects`
    decision: Literal["on", "off"]  # whether it counts
    # Of the total: the largest change of the torque without it at the points that are named; of its part of the torque
    # where it has one; of what lacks its input by one line of physics. None: not known.
    share: float | None
    reason: str  # in words, or the limit
    share_is: ShareKind = "unknown"  # what the share is

    def __str__(self) -> str:
        return f"{self.name}: {self.decision}, {self.reason}"


class Effects(Sequence[Effect]):
    """Every effect of a torque in the order of TABLE; their shares are measured when somebody reads them."""

    def __init__(
        self,
        make: Callable[[], Mapping[str, Effect]],
        measure: Callable[[str], float] | None = None,
        points: tuple[int, ...] = (),
    ) -> None:
        """make : gives them by name;  measure : the share of one that is "measured";  points : at which, from 0"""
        self._make, self._measure, self.points = make, measure, points

    @cached_property
    def _made(self) -> dict[str, Effect]:
        return dict(self._make())

    @property
    def unmeasured(self) -> tuple[Effect, ...]:
        """The same without a solution: a share that takes one is None."""
        return tuple(self._made.values())

    def among(self, numbers: Sequence[int]) -> "Effects":
        """The same where the points are some of a longer series; numbers : theirs in it, from 0"""
        return Effects(self._make, self._measure, tuple(int(numbers[point]) for point in self.points))

    @property
    def decisions(self) -> dict[str, Literal["on", "off"]]:
        """Whether each effect counts, by its name."""
        return {name: effect.decision for name, effect in self._made.items()}

    def __str__(self) -> str:
        """One line for each effect: name, decision and reason. It measures no share."""
        return "\n".join(map(str, self._made.values()))

    def __repr__(self) -> str:
        on = [name for name, decision in self.decisions.items() if decision == "on"]
        return f"Effects({len(on)} of {len(self)} on: {', '.join(on)})"

    def __getitem__(self, index: Any) -> Any:
        return self._all[index]

    def __len__(self) -> int:
        return len(TABLE)

    def __getstate__(self) -> dict[str, Any]:
        made = {effect.name: effect for effect in self._all}
        return {"_made": made, "_make": None, "_measure": None, "points": self.points}

    @cached_property
    def _all(self) -> tuple[Effect, ...]:
        measure = self._measure
        if measure is None:
            return self.unmeasured
        return tuple(
            _measured(effect, measure(effect.name)) if effect.share_is == "measured" else effect
            for effect in self.unmeasured
        )


def _measured(effect: Effect, share: float) -> Effect:
    return replace(effect, share_is="unknown") if np.isnan(share) else replace(effect, share=share)


def size_of(share: float) -> str:
    """How large an effect of this share of the torque is, in words."""
    return "larger than the torque" if not share <= 1 else f"{percent_of(share, 2)} of the torque"


def _lubricant(scene: Scene) -> str | None:
    return "no lubricant is given: add a table [lubricant]" if scene.lubricant is None else None


def _ring_diameters(scene: Scene) -> str | None:
    if scene.lubricant is not None and starvation_source(scene.bearing, scene.lubricant) is not None:
        return None
    if scene.bearing.bore_diameter is None or scene.bearing.outside_diameter is None:
        return _lubricant(scene) or "bearing.bore_diameter and bearing.outside_diameter are not given"
    return _lubricant(scene)


def ruled(scene: Scene) -> str | None:
    """Why closed kinematics turn the balls, in words; None: they turn as friction has it."""
    if scene.spin_rule != "free":
        return f'friction.spin_rule = "{scene.spin_rule}" prescribes the rotation of the balls: use "free"'
    if scene.microslip != "derived":
        return f'friction.microslip = "{scene.microslip}" has no creep: use "derived"'
    off = [name for name in ("spin", "conformity") if scene.effects.get(name) == "off"]
    return f'effects.{off[0]} = "off" neglects a part of the slip: use "auto"' if off else None


NO_CAGE = 'give a table [cage] of pocket_clearance, wall_thickness, mass and material, or cage = "none"'


def _cage(scene: Scene) -> str | None:
    if scene.cage is not None:
        return None
    return (
        "left out by the scene, or no web between the balls"
        if scene.effects.get("cage") == "off"
        else f"no cage is given: {NO_CAGE}"
    )


def _cage_of_rings(scene: Scene) -> str | None:
    if scene.cage is not None and scene.bearing.kind == "thrust":
        return "not modelled in a thrust bearing: its cage rests on its balls"
    return _cage(scene)


def _moving_cage(scene: Scene) -> str | None:
    if (lacks := _cage_of_rings(scene)) is not None or (scene.cage is not None and scene.cage.start is not None):
        return lacks
    return 'cage.start is not given: give "rest", "ramp", "sudden" or "whirl"'


LACKS_SEALS = 'losses.seals is not given: give for example "5 N mm"'


def _seals(scene: Scene) -> str | None:
    if scene.losses.seals is not None:
        return None
    seals = scene.bearing.seals
    if seals is None:
        return LACKS_SEALS
    return f"{LACKS_SEALS}; {seals}" if scene.bearing.seals_rub else f"no drag: {seals}"


def _not_given(name: str, example: str) -> Callable[[Scene], str | None]:
    lacks = f'losses.{name} is not given: give for example "{example}"'
    return lambda scene: lacks if getattr(scene.losses, name) is None else None


def _no_gaps(scene: Scene) -> str | None:
    if scene.losses.land is not None or scene.losses.pockets is not None:
        return None
    if scene.cage is not None and not scene.cage.gives_way:
        return "losses.land is not given; [cage] includes the friction in the pockets"
    return "losses.land or losses.pockets are not given"


def _held_angle(scene: Scene) -> str | None:
    if scene.bearing.kind == "thrust":
        return "not modelled in a thrust bearing: balls in the middle of their grooves"
    if scene.contact_angle.rule == "given":
        return 'contact_angle.rule = "given" fixes the contact angle: use "solved"'
    return None


def _no_bath(scene: Scene) -> str | None:
    if scene.lubricant is not None and scene.lubricant.supply != "oil_bath":
        return f'no oil around unloaded balls with lubricant.supply = "{scene.lubricant.supply}"'
    return _lubricant(scene) or _held_angle(scene)


SOLVED_ANGLE = Need(keys='`contact_angle.rule = "solved"`', lacks=_held_angle)
TURNING_BALL = Need(  # the moment moves no load of a ball at 90 degrees, and so leaves its angle alone
    keys='`contact_angle.rule = "solved"`, or a thrust bearing',
    lacks=lambda scene: None if scene.bearing.kind == "thrust" else _held_angle(scene),
)
FREE = Need(keys='`spin_rule = "free"`', lacks=ruled)
LUBRICANT = Need(keys="`[lubricant]`", lacks=_lubricant)
LUBRICATED_SURFACE = Need(
    keys="`[lubricant]` and `[surface]`",
    lacks=lambda scene: (
        None if scene.friction_coefficient is None else "the friction coefficient is given: give [surface] instead"
    ),
)
RING_DIAMETERS = Need(
    keys="`[lubricant]` with `starvation_degree`, or `bore_diameter` and `outside_diameter`, or grease in a deep "
    "groove bearing",
    lacks=_ring_diameters,
)

TABLE = (
    Entry(
        name="load_distribution",
        kind="computed",
        meaning="unequal ball loads by a radial load or a moment",
        needs=SOLVED_ANGLE,
    ),
    Entry(name="centrifugal", kind="computed", meaning="centrifugal force on the balls", needs=SOLVED_ANGLE),
    Entry(name="gyroscopic", kind="computed", meaning="gyroscopic moment on the balls", needs=TURNING_BALL),
    Entry(name="weight", kind="computed", meaning="weight of the balls", needs=SOLVED_ANGLE),
    Entry(
        name="finite_geometry", kind="computed", meaning="the true shapes of ball and groove, which are no half spaces"
    ),
    Entry(
        name="asperities",
        kind="computed",
        meaning="load on asperities beside the oil film",
        needs=LUBRICATED_SURFACE,
        idle='no sliding without spin and conformity: give effects.conformity = "auto"',
    ),
    Entry(
        name="inlet_heating",
        kind="computed",
        meaning="oil at the inlets that its own shear heats",
        needs=LUBRICANT,
        idle='nothing slides or rolls in oil: give effects.rolling = "auto"',
    ),
    Entry(
        name="starvation",
        kind="computed",
        meaning="inlets to which the oil does not return in time",
        needs=RING_DIAMETERS,
        idle='nothing slides or rolls in oil: give effects.rolling = "auto"',
    ),
    Entry(name="spin", kind="computed", meaning="spin of the balls about the contact normals"),
    Entry(
        name="conformity", kind="computed", meaning="sliding because the contact is curved in the transverse direction"
    ),
    Entry(
        name="creep",
        kind="computed",
        meaning="elastic creep of the surfaces, with balls that find their own axis and orbital speed",
        needs=FREE,
        idle="nothing slides",
    ),
    Entry(
        name="hysteresis",
        kind="computed",
        meaning="energy lost by elastic rolling: hysteresis of the bodies, or Houpert's law of slow rolling",
    ),
    Entry(
        name="rolling",
        kind="computed",
        meaning="hydrodynamic resistance of the oil in the inlets to rolling",
        needs=LUBRICANT,
    ),
    Entry(
        name="unloaded_balls",
        kind="computed",
        meaning="hydrodynamic resistance to rolling of balls that carry no load",
        needs=Need(keys='`[lubricant]` with `supply = "oil_bath"`, `contact_angle.rule = "solved"`', lacks=_no_bath),
        idle='no ball without load rolls: give effects.rolling and effects.load_distribution "auto"',
    ),
    Entry(
        name="cage",
        kind="cage",
        meaning="friction of the cage that slides on its balls",
        needs=Need(keys="`[cage]`", lacks=_cage),
    ),
    Entry(
        name="cage_dynamics",
        kind="cage",
        meaning="motion of a cage that does not rest on its balls",
        needs=Need(keys="`[cage]` with `start`", lacks=_moving_cage),
        idle='the cage is neglected: give effects.cage = "auto"',
    ),
    Entry(
        name="ball_dynamics",
        kind="cage",
        meaning="motion of balls that the cage brakes, together with the cage",
        needs=Need(keys="`[cage]` with `start`", lacks=_moving_cage),
        idle="cage at rest, small forces on the balls",
    ),
    Entry(
        name="seals",
        kind="declared",
        meaning="torque of the seals",
        needs=Need(keys="`seals` in `[losses]`", lacks=_seals),
        given="declared by the scene",
    ),
    Entry(
        name="drag",
        kind="declared",
        meaning="torque of the oil that balls and cage stir",
        needs=Need(keys="`drag` in `[losses]`", lacks=_not_given("drag", "2 N mm")),
        given="declared by the scene",
    ),
    Entry(
        name="through_flow",
        kind="oil",
        meaning="torque that accelerates the oil flowing through the bearing to the speed of the cage",
        needs=Need(keys="`oil_flow` in `[losses]`", lacks=_not_given("oil_flow", "0.8 l/min")),
        given="from losses.oil_flow",
    ),
    Entry(
        name="cage_shear",
        kind="oil",
        meaning="torque of the oil that is sheared in the gaps of the cage",
        needs=Need(keys="`land` or `pockets` in `[losses]`", lacks=_no_gaps),
        given="from losses.land or losses.pockets",
    ),
    Entry(
        name="ball_drag",
        kind="oil",
        meaning="torque of balls that move through oil and air",
        needs=Need(keys="`oil_share` in `[losses]`", lacks=_not_given("oil_share", "2 %")),
        given="from losses.oil_share",
    ),
    Entry(name="plasticity", kind="limit", meaning="plastic contact; not modelled"),
    Entry(
        name="shoulder",
        kind="limit",
        meaning="a contact ellipse cut off by a shoulder of its race; not modelled",
        idle="no ball is loaded",
    ),
)
ENTRIES = {entry.name: entry for entry in TABLE}


def _names(*kinds: str) -> tuple[str, ...]:
    return tuple(entry.name for entry in TABLE if entry.kind in kinds)


COMPUTED = _names("computed")
DECLARED = _names("declared")
OIL_LOSSES = _names("oil")
LIMITS = _names("limit")
CHOSEN = _names("computed", "cage")  # a scene may say on or off
CAGE_OFF: dict[str, Decision] = dict.fromkeys(("cage", "cage_dynamics", "ball_dynamics"), "off")


def require_known(scene: Scene) -> None:
    """Raise InputError for effects that nobody can choose, or that the scene demands without their input."""
    known = (*CHOSEN, *OIL_LOSSES, *LIMITS)
    if unknown := set(scene.effects) - {*known}:
        raise InputError(f"effects.{min(unknown)} is not an effect to choose; known: {', '.join(known)}")
    for name, choice in scene.effects.items():
        if choice != "on":
            continue
        if name in LIMITS:
            raise InputError(f'effects.{name} = "on" is refused: not modelled; give "auto" or "off"')
        if (lacks := ENTRIES[name].lacks(scene)) is not None:
            raise InputError(f'effects.{name} = "on" is refused: {lacks}')


def counted_effects(scene: Scene) -> dict[str, bool]:
    """Each effect of balls, races and cage: whether it has its input, and the scene does not switch it off."""
    off = {name for name, choice in scene.effects.items() if choice == "off"}
    on = {name: name not in off and ENTRIES[name].lacks(scene) is None for name in CHOSEN}
    slides = scene.has_friction and (on["spin"] or on["conformity"])
    on["asperities"] &= slides
    on["creep"] &= slides
    if not (on["rolling"] or (slides and scene.friction_coefficient is None)):
        on["inlet_heating"] = on["starvation"] = False
    on["unloaded_balls"] &= on["rolling"] and (on["load_distribution"] or on["weight"])
    return on


def turns_freely(scene: Scene, counted: Mapping[str, bool]) -> bool:
    """Whether friction turns the balls, and no rule; counted : `counted_effects`"""
    return (counted["spin"] or counted["conformity"]) and ruled(scene) is None


def idle_reason(scene: Scene, name: str, *, counted: bool) -> str | None:
    """Why an effect with its input has nothing to act on at the scene's operating points, in words; None: it acts."""
    if name == "load_distribution" and scene.operation.is_thrust:
        return "pure thrust: equal ball loads"
    if name in ("centrifugal", "gyroscopic") and not np.any(scene.operation.inner_speed):
        return "no rotation"
    if name == "weight" and scene.down is None and scene.operation.is_thrust:
        return (
            "under thrust the weights of balls that are alike cancel around a level axis to first order; give "
            "operation.down, the direction of gravity along x, y and z, to compute each ball"
        )
    if name == "unloaded_balls" and scene.operation.is_thrust and scene.down is None:
        return "every ball carries load"
    return None if counted else ENTRIES[name].idle
