"""Every effect of the friction torque: what it is, what a scene has to give for it, and what bounds its share.

The order is that of the decisions: what costs most to compute comes first, so that leaving it out comes first too.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

from analytic.scene import Scene

Lacks = Callable[[Scene], str | None]  # what the scene lacks, in words; None: nothing


@dataclass(frozen=True, kw_only=True)
class Entry:
    """One effect."""

    name: str
    meaning: str
    kind: Literal["computed", "cage", "declared", "limit"]
    lacks: Lacks = lambda _: None
    bound: str | None = None  # on its share of the torque; None: no bound that is cheaper than the effect is known


def _held_angle(scene: Scene) -> str | None:
    if scene.contact_angle.rule == "given":
        return 'contact_angle.rule = "given" holds the angle that it would change: use "solved"'
    return None


def _lubricant(scene: Scene) -> str | None:
    return "no lubricant is given: add a table [lubricant]" if scene.lubricant is None else None


def _lubricated_surface(scene: Scene) -> str | None:
    return None if scene.friction_coefficient is None else "the friction coefficient is given: give [surface] instead"


def _ring_diameters(scene: Scene) -> str | None:
    if scene.bearing.bore_diameter is None or scene.bearing.outside_diameter is None:
        return _lubricant(scene) or "bearing.bore_diameter and bearing.outside_diameter are not given"
    return _lubricant(scene)


def _hysteresis_loss(scene: Scene) -> str | None:
    if scene.hysteresis_loss is None:
        lost = "the share of elastic energy lost in each cycle, for steel 0.004-0.01"
        return f"friction.hysteresis_loss is not given: {lost}"
    return None


def _cage(scene: Scene) -> str | None:
    return "no cage is given: add a table [cage]" if scene.cage is None else None


TABLE = (
    Entry(
        name="load_distribution",
        kind="computed",
        meaning="unequal ball loads by a radial load or a moment",
        lacks=_held_angle,
        bound="1.25 (Fr tan al + 2 M/d_m)/Fa",
    ),
    Entry(
        name="centrifugal",
        kind="computed",
        meaning="centrifugal force on the balls",
        lacks=_held_angle,
        bound="4.5 times the force over the ball load, and 10 times its cube root for balls that the loads leave free",
    ),
    Entry(
        name="gyroscopic",
        kind="computed",
        meaning="gyroscopic moment on the balls",
        lacks=_held_angle,
        bound="the axial pull of the friction that holds the moment, over a ball's thrust",
    ),
    Entry(
        name="finite_geometry",
        kind="computed",
        meaning="the true shapes of ball and groove, which are no half spaces",
        bound="0.5 (b/r)^2 under thrust",
    ),
    Entry(
        name="asperities",
        kind="computed",
        meaning="load on asperities beside the oil film",
        lacks=_lubricated_surface,
        bound="their share of the load at the film of smooth surfaces, times boundary friction",
    ),
    Entry(
        name="inlet_heating",
        kind="computed",
        meaning="oil at the inlets that its own shear heats",
        lacks=_lubricant,
        bound="the rolling torque lost, and the friction that a thinner film adds",
    ),
    Entry(
        name="starvation",
        kind="computed",
        meaning="inlets to which the oil does not return in time",
        lacks=_ring_diameters,
        bound="the rolling torque lost",
    ),
    Entry(
        name="spin",
        kind="computed",
        meaning="spin of the balls about the contact normals",
        bound="the friction of the race that spins in full, less that of races that only roll",
    ),
    Entry(
        name="conformity",
        kind="computed",
        meaning="sliding because the contact is curved across rolling",
    ),
    Entry(
        name="hysteresis",
        kind="computed",
        meaning="elastic energy lost by the bodies in each cycle",
        lacks=_hysteresis_loss,
    ),
    Entry(
        name="rolling",
        kind="computed",
        meaning="hydrodynamic resistance of the oil in the inlets to rolling",
        lacks=_lubricant,
    ),
    Entry(name="cage", kind="cage", meaning="friction of the cage that slides on its balls", lacks=_cage),
    Entry(
        name="cage_dynamics",
        kind="cage",
        meaning="motion of a cage that does not rest on its balls",
        lacks=_cage,
        bound="the friction of a cage that whirls, against all its balls",
    ),
    Entry(name="seals", kind="declared", meaning="torque of the seals, declared in [losses]"),
    Entry(name="drag", kind="declared", meaning="torque of the oil that balls and cage stir, declared in [losses]"),
    Entry(name="elastic_creep", kind="limit", meaning="slip by the elasticity of the surfaces; not modelled"),
    Entry(name="plasticity", kind="limit", meaning="plastic contact; not modelled"),
    Entry(name="shoulder", kind="limit", meaning="a contact ellipse cut off by its race's shoulder; not modelled"),
)
ENTRIES = {entry.name: entry for entry in TABLE}


def _names(*kinds: str) -> tuple[str, ...]:
    return tuple(entry.name for entry in TABLE if entry.kind in kinds)


COMPUTED = _names("computed")
DECLARED = _names("declared")
LIMITS = _names("limit")
CHOSEN = _names("computed", "cage")  # a scene may say on or off
