"""Which effects a scene calls for, and how large those left out could be.

`auto` leaves an effect out where a cheap bound on its share of the torque fits into what is left of half the scene's
tolerance; the other half is for the rung by which sliding is integrated. The bounds of all that `auto` leaves out add
up to less than that half. An effect whose bound would cost as much as itself is always computed. One decision holds for
the whole series, by its worst point.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np

from analytic.errors import InputError
from analytic.scene import Array, Scene

# In the order in which they are decided: the dearest first, so that leaving it out comes first.
COMPUTED = (
    "load_distribution",  # balls loaded unequally by radial load and moment
    "centrifugal",  # force on the balls
    "gyroscopic",  # moment on the balls
    "finite_geometry",  # of the contacts: ball and groove are no half spaces
    "asperities",  # that carry load beside the film
    "inlet_heating",  # of the oil by its own shear
    "starvation",  # of the inlets: oil that does not flow back in time
    "spin",
    "conformity",
    "hysteresis",
    "rolling",  # against the oil in the inlets
)
# Decided after the races (analytic.cage.torque): the cage that slides on balls that carry it, and its motion, where it
# does not just rest.
OF_CAGE = ("cage", "cage_dynamics")
DECLARED = ("seals", "drag")  # torques that the scene tells, in [losses]
# Watched by a number or a bound, and warned of; nothing in the model computes them (analytic.effects.limits).
WATCHED = ("elastic_creep", "plasticity", "shoulder")
EFFECTS = COMPUTED + OF_CAGE + DECLARED + WATCHED
SHARE_OF_TOLERANCE = 0.5


@dataclass(frozen=True, kw_only=True)
class Effect:
    """One physical contribution, decided for the whole series."""

    name: str
    decision: Literal["on", "off"]
    # Of the total, the largest over the series: that of its part of the torque where it has one, else a bound; infinite
    # where nothing bounds it, None where that is not known.
    share: float | None
    reason: str


def size_of(share: float) -> str:
    """How large an effect can be whose bound is this share of the torque, in words."""
    if np.isinf(share):
        return "nothing bounds it"
    return "could exceed the torque" if share > 1 else f"could be {share:.2g} of the torque"


class Choices:
    """The decisions for one scene, as they are made."""

    def __init__(self, scene: Scene, points: int) -> None:
        known = COMPUTED + OF_CAGE + WATCHED
        unknown = set(scene.effects) - set(known)
        if unknown:
            raise InputError(f"effects.{min(unknown)} is not an effect to choose; known: {', '.join(known)}")
        for name in WATCHED:
            if scene.effects.get(name) == "on":
                raise InputError(f'effects.{name} = "on" cannot be had: not modelled; give "auto" or "off"')
        self.asked = scene.effects
        self.budget = SHARE_OF_TOLERANCE * scene.tolerance
        self.left_out = np.zeros(points)  # sum of the bounds of what auto leaves out, at each point
        self.made: dict[str, Effect] = {}

    def calls_for(self, name: str, *, share: Array | None, lacks: str | None = None) -> bool:
        """Whether to compute the effect.

        share : (n,) bound on its share of the torque; None: always worth computing, or not known for lack of input
        lacks : what the scene would have to give for it, in words
        Raises InputError if the scene wants it on and lacks what it takes.
        """
        asked, worst = self.asked.get(name, "auto"), None if share is None else float(np.max(share, initial=0.0))
        if lacks is not None:
            if asked == "on":
                raise InputError(f'effects.{name} = "on" cannot be had: {lacks}')
            return self._decided(name, on=False, share=worst, reason=lacks)
        if asked == "off":
            unknown = "; how much it would add is not computed" if worst is None else ""
            return self._decided(name, on=False, share=worst, reason=f"the scene says off{unknown}")
        if asked == "on":
            return self._decided(name, on=True, share=worst, reason="the scene says on")
        if share is None or worst is None:
            return self._decided(name, on=True, share=None, reason="always computed: no cheaper bound is known")
        largest = float(np.max(self.left_out + share, initial=0.0))
        if largest <= self.budget:
            self.left_out = self.left_out + share
            reason = f"at most {worst:.2g} of the torque, within what {self.budget:.2g} leaves"
            return self._decided(name, on=False, share=worst, reason=reason)
        reason, before = size_of(worst), float(np.max(self.left_out, initial=0.0))
        if worst <= 1:
            reason += f", more than {self.budget:.2g} leaves"
            reason += f" with {before:.2g} already left out" if before > 0 else ""
        return self._decided(name, on=True, share=worst, reason=reason)

    def settled(self, name: str, *, on: bool, reason: str, share: Array | None = None) -> None:
        """An effect about which there is nothing to decide, with its bound where one is known."""
        self._decided(name, on=on, share=None if share is None else float(np.max(share, initial=0.0)), reason=reason)

    def on(self, name: str) -> bool:
        return self.made[name].decision == "on"

    def _decided(self, name: str, *, on: bool, share: float | None, reason: str) -> bool:
        self.made[name] = Effect(name=name, decision="on" if on else "off", share=share, reason=reason)
        return on


def share_in(part: Array, total: Array) -> Array:
    """part/total, 0 where there is nothing to share."""
    return np.divide(part, total, out=np.zeros(np.broadcast(part, total).shape), where=total > 0)
