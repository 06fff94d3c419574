"""Every effect of the friction torque: what it is, what it needs, and what bounds its share where no trial shows it.

The order is that of the decisions: what costs most to compute comes first, so that leaving it out comes first too.
The factors of the bounds stand here alone; docs/effects.md lists the entries and refers to these bounds.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from analytic.cage.drive import LARGEST_GRIP
from analytic.contact.geometry import USUAL_SHOULDERS
from analytic.oil.inlets import starvation_source
from analytic.scene import Scene
from analytic.sliding.creep import PER_ROLL_CREEP, PER_SPIN_CREEP
from analytic.words import pressure_of

# Change of the torque over how unequal the balls' loads are: below 0.7 where they are little so, 1.13 at most.
PER_DISTRIBUTION = 1.25
# Change of the torque over the centrifugal force's share of the ball load: 4/3 to 5/3 by the outer race's load alone.
# The contact angles change too: 4.0 at most (tests/analytic/effects/test_effect_bounds.py compares with measured ones).
PER_CENTRIFUGAL = 4.5
LEAST_WHIRL = 1.0  # of the whirl number: a cage cannot whirl below
# Simulated time that `auto` allows, with start-up and all seeds, s: about ten minutes of computing in default steps
LONGEST_MOTION = 500.0
LONGEST_FREE_MOTION = 4.0  # s, the same of balls and cage together, at 4 to 10 us a step: minutes too
# Change of the torque by sliding over the share of friction across the grooves that holds the gyroscopic moment: slip
# across the groove comes with it, and near 1 the ball's axis follows.
PER_GYROSCOPIC_SLIP = 3.0
# Change of the torque over the weight's share of the ball load, of free balls that friction does not hold against it:
# 0.16 at most of one that hardly slides, and 6 times the share of sliding besides (validation/adversary/run.py).
PER_WEIGHT_SLIP, PER_WEIGHT_SLIDING = 0.5, 8.0
# Power of the load with which friction across the grooves over the load grows, at most: 0.2 in marched creep with mixed
# friction (0.022 of the load at 0.16 N, 0.035 at 1.7 N); that of a viscous oil would be near 1 at light load.
WEDGING_POWER = 1.0
# Change of the torque over the oil's force against rolling, in friction: a ball that lags behind rolls more slowly.
# 1.45 at most (validation/adversary/run.py).
PER_LAG = 3.0
# Change of the torque of balls by rule over the change of their rolling speed by conformity and by the orbit's radius
# (`analytic.effects.trial.rolls_otherwise`). Free balls differed by a third of this bound at most in 120 draws of
# validation/adversary/drawn.py; tests/analytic/effects/test_trial.py has a scene for each part.
PER_CONFORMITY, PER_ORBIT = 0.5, 2.0
# Share of an ellipse's load beyond a shoulder, by Hertz, up to which its torque is known; and the change of the torque
# over that share. By finite elements the loss by conformity falls by 1.6 shares at most, by spin by 0.7
# (tests/fem/test_shoulder.py); the load's centroid moves as well, and with it the contact angle.
MOST_CUT, PER_CUT_SHARE = 0.1, 4.0
RULED = ("single_coefficient", "along_axis", "over_ellipse")  # methods of sliding with closed kinematics
# -ln of the replenishment factor, ln 2: less than half of rolling is left, so the torque of a start is another one. A
# judgement, as [SKF2018] states no range.
MOST_STARVED = 0.693
STATIC_LIMIT = 4.2e9  # Pa, peak pressure that leaves a dent of 1e-4 ball diameters (ISO 76, ball bearings)
# What losses of the oil without their input are estimated by: share of oil between the rings, by supply, a judgement;
# clearance and thickness of a cage in its pockets over the ball diameter, those of the cage of [Paper]; rise of the
# temperature of oil that a jet sends through, K, a judgement; and its specific heat, J/(kg K).
USUAL_SHARE: dict[str, float] = {"oil_bath": 0.05, "oil_jet": 0.02}
USUAL_POCKETS = (0.025, 0.11)
JET_RISE, OIL_HEAT = 20.0, 2000.0


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
    # On its share of the torque where no trial shows it, or the limit that is checked; None: always tried or computed.
    bound: str | None = None
    idle: str = ""  # why it is off in a scene that has what it needs
    given: str = ""  # why it is on without a decision

    def lacks(self, scene: Scene) -> str | None:
        """What the scene lacks for it, in words; None: nothing."""
        return None if self.needs is None else self.needs.lacks(scene)


def _lubricant(scene: Scene) -> str | None:
    return "no lubricant is given: add a table [lubricant]" if scene.lubricant is None else None


def _ring_diameters(scene: Scene) -> str | None:
    if scene.lubricant is not None and starvation_source(scene.bearing, scene.lubricant) is not None:
        return None
    if scene.bearing.bore_diameter is None or scene.bearing.outside_diameter is None:
        return _lubricant(scene) or "bearing.bore_diameter and bearing.outside_diameter are not given"
    return _lubricant(scene)


def ruled(scene: Scene) -> str | None:
    """Why closed kinematics turn the balls, in words; None: they turn freely where that counts."""
    if scene.spin_rule != "free":
        return f'friction.spin_rule = "{scene.spin_rule}" prescribes the rotation of the balls: use "free"'
    if scene.microslip != "derived":
        return f'friction.microslip = "{scene.microslip}" has no creep: use "derived"'
    if scene.sliding in RULED:
        return f'friction.sliding = "{scene.sliding}" has no creep: use "auto"'
    off = [name for name in ("spin", "conformity") if scene.effects.get(name) == "off"]
    return f'effects.{off[0]} = "off" neglects a part of the slip: use "auto"' if off else None


def _no_creep(scene: Scene) -> str | None:
    return 'friction.sliding = "free_ball" has no creep: use "auto"' if scene.sliding == "free_ball" else ruled(scene)


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


def _seals(scene: Scene) -> str | None:
    if scene.losses.seals is not None:
        return None
    seals = scene.bearing.seals
    if seals is None:
        return "not declared"
    return f"not declared: {seals}" if scene.bearing.seals_rub else f"no drag: {seals}"


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
        return "not modelled in a thrust bearing: balls in the middle of their grooves; bound in the uncertainty"
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
DOWN = Need(
    keys='`contact_angle.rule = "solved"` and `down`',
    lacks=lambda scene: (
        SOLVED_ANGLE.lacks(scene)
        or (
            "operation.down is needed: the direction of gravity along x, y and z, of a pair O or X across its axis"
            if scene.down is None
            else None
        )
    ),
)
FREE = Need(keys='`spin_rule = "free"`, `sliding = "auto"` or with creep', lacks=_no_creep)
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
        bound=f"at a given angle {PER_DISTRIBUTION:g} (Fr tan al + 2 M/d_m)/Fa",
    ),
    Entry(
        name="centrifugal",
        kind="computed",
        meaning="centrifugal force on the balls",
        needs=SOLVED_ANGLE,
        bound=f"at a given angle {PER_CENTRIFUGAL:g} times the force over the load of the lightest ball",
    ),
    Entry(
        name="gyroscopic",
        kind="computed",
        meaning="gyroscopic moment on the balls",
        needs=TURNING_BALL,
        bound="at a given angle the friction that holds the moment, over the load of the lightest ball; for the slip "
        f"across the grooves of balls by rule {PER_GYROSCOPIC_SLIP:g} times the moment over what friction holds",
    ),
    Entry(
        name="weight",
        kind="computed",
        meaning="weight of the balls",
        needs=DOWN,
        bound=f"without its direction {PER_CENTRIFUGAL:g} times the weight over the load of the lightest ball, or the "
        "spread over several directions where that is too much; for free balls that slip under it "
        f"{PER_WEIGHT_SLIP:g} times the weight over their mean load, and {PER_WEIGHT_SLIDING:g} times that of sliding. "
        "Both, and that of a radial load, grow by "
        f"1/(1 - {3 * WEDGING_POWER:g} X/delta) where friction across the grooves needs the part X of the approach "
        "delta; beyond a growth of 2 the free balls themselves show what a weight in an unknown direction changes",
    ),
    Entry(
        name="finite_geometry",
        kind="computed",
        meaning="the true shapes of ball and groove, which are no half spaces",
        given="factors on the contacts given in the call",
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
    Entry(
        name="spin",
        kind="computed",
        meaning="spin of the balls about the contact normals",
        given="always computed for free balls",
    ),
    Entry(
        name="conformity", kind="computed", meaning="sliding because the contact is curved in the transverse direction"
    ),
    Entry(
        name="creep",
        kind="computed",
        meaning="elastic creep of the surfaces, with balls that find their own axis and orbital speed",
        needs=FREE,
        bound=f"{PER_SPIN_CREEP:g} and {PER_ROLL_CREEP:g} over the ratios of slip by spin and by conformity to "
        f"the creep at which the surfaces slide everywhere, and {PER_LAG:g} times the oil's force against rolling over "
        "the most friction",
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
        idle="every ball carries load",
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
        bound=f"the friction of a cage that whirls, against all its balls; 0 below a whirl number of {LEAST_WHIRL:g}",
        idle='the cage is neglected: give effects.cage = "auto"',
    ),
    Entry(
        name="ball_dynamics",
        kind="cage",
        meaning="motion of balls that the cage brakes, together with the cage",
        needs=Need(keys="`[cage]` with `start`", lacks=_moving_cage),
        bound=f"computed where the grip number of the cage exceeds {LARGEST_GRIP:g}, or balls lead farther than the "
        "pockets leave free",
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
        needs=Need(
            keys="`drag` in `[losses]`", lacks=lambda scene: "not declared" if scene.losses.drag is None else None
        ),
        given="declared by the scene",
    ),
    Entry(
        name="through_flow",
        kind="oil",
        meaning="torque that accelerates the oil flowing through the bearing to the speed of the cage",
        needs=Need(keys="`oil_flow` in `[losses]`", lacks=_not_given("oil_flow", "0.8 l/min")),
        bound="with an oil jet x/(1 - x), x the square of the inner race's speed over the heat of a rise "
        f"by {JET_RISE:g} K",
        given="from losses.oil_flow",
    ),
    Entry(
        name="cage_shear",
        kind="oil",
        meaning="torque of the oil that is sheared in the gaps of the cage",
        needs=Need(keys="`land` or `pockets` in `[losses]`", lacks=_no_gaps),
        bound="with an oil bath or jet and without `[cage]` pockets of "
        f"{USUAL_POCKETS[0]:g} ball diameters clearance and {USUAL_POCKETS[1]:g} thickness",
        given="from losses.land or losses.pockets",
    ),
    Entry(
        name="ball_drag",
        kind="oil",
        meaning="torque of balls that move through oil and air",
        needs=Need(keys="`oil_share` in `[losses]`", lacks=_not_given("oil_share", "2 %")),
        bound="without `drag` a share of "
        + ", ".join(f"{share:g} with `{supply}`" for supply, share in USUAL_SHARE.items()),
        given="from losses.oil_share",
    ),
    Entry(
        name="plasticity",
        kind="limit",
        meaning="plastic contact; not modelled",
        bound=f"a peak pressure above {pressure_of(STATIC_LIMIT)}, the static limit of [ISO76]",
    ),
    Entry(
        name="shoulder",
        kind="limit",
        meaning="a contact ellipse cut off by a shoulder of its race; not modelled",
        bound="a semi-axis that exceeds the distance to the nearer shoulder; an unknown one has a height of "
        f"{USUAL_SHOULDERS[0]:g} ball diameters",
        idle="no ball is loaded",
    ),
)
ENTRIES = {entry.name: entry for entry in TABLE}


def _names(*kinds: str) -> tuple[str, ...]:
    return tuple(entry.name for entry in TABLE if entry.kind in kinds)


COMPUTED = _names("computed")
TRIED = tuple(name for name in COMPUTED if name != "creep")  # a trial shows their shares
DECLARED = _names("declared")
OIL_LOSSES = _names("oil")
LIMITS = _names("limit")
CHOSEN = _names("computed", "cage")  # a scene may say on or off
