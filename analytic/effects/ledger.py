"""The decisions of one scene: which effects are computed, and what leaving out the others can change.

`auto` leaves an effect out where the bound on its share of the torque fits into what remains of half the scene's
tolerance. The other half is for the method by which sliding is integrated. The bounds of everything that `auto` leaves
out compound to less than that half. An effect without a cheap bound is always computed, and so is one that the state
of the balls demands. One decision holds for the whole series, by its worst point. Every effect of
`analytic.effects.table` must be settled, whatever the scene.
"""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from analytic.effects.table import CHOSEN, ENTRIES, LIMITS
from analytic.errors import InputError
from analytic.scene import Array, Scene
from analytic.words import percent_of

SHARE_OF_TOLERANCE = 0.5


@dataclass(frozen=True, kw_only=True)
class Effect:
    """One physical contribution, decided for the whole series."""

    name: str  # as in `scene.effects`
    decision: Literal["on", "off"]  # whether it counts
    # The largest share of the total over the series: of its part of the torque where it has one, else a bound. Infinite
    # where it could be of any size, None where it is not known.
    share: float | None
    reason: str  # in words, with the bound or the limit


def size_of(share: float) -> str:
    """How large an effect can be whose bound is this share of the torque, in words."""
    if np.isinf(share):
        return "could be of any size"
    return "could exceed the torque" if share > 1 else f"could be {percent_of(share, 2)} of the torque"


class Ledger:
    """The decisions for one scene, as they are made."""

    def __init__(self, scene: Scene, points: int) -> None:
        """points : operating points of the scene. Raises InputError for effects that nobody can choose."""
        unknown = set(scene.effects) - {*CHOSEN, *LIMITS}
        if unknown:
            known = ", ".join((*CHOSEN, *LIMITS))
            raise InputError(f"effects.{min(unknown)} is not an effect to choose; known: {known}")
        for name in LIMITS:
            if scene.effects.get(name) == "on":
                raise InputError(f'effects.{name} = "on" cannot be had: not modelled; give "auto" or "off"')
        self.scene = scene
        self.budget = SHARE_OF_TOLERANCE * scene.tolerance
        self.left_out = np.zeros(points)  # bounds of what auto leaves out, compounded, at each point
        self.made: dict[str, Effect] = {}

    def decide(
        self, name: str, *, bound: Array | None = None, lacks: str | None = None, demanded: str | None = None
    ) -> bool:
        """Whether to compute the effect.

        bound : (n,) bound on its share of the torque; None: no bound is known, or it needs the missing input
        lacks : a reason besides a missing input why the effect cannot act, in words
        demanded : why auto computes it whatever the tolerance, in words
        Raises InputError if the scene says on and nothing can be computed.
        """
        wanted, missing = self.scene.effects.get(name, "auto"), ENTRIES[name].lacks(self.scene)
        if missing is not None:
            return self._settle(name, on=False, share=bound, reason=missing)
        if wanted == "off":
            unknown = "; how much it would add is not computed" if bound is None else ""
            return self._settle(name, on=False, share=bound, reason=f"the scene says off{unknown}")
        if lacks is not None:
            return self._settle(name, on=False, share=bound, reason=lacks)
        if wanted == "on":
            return self._settle(name, on=True, share=bound, reason="the scene says on")
        if bound is None:
            return self._settle(name, on=True, share=None, reason="always computed: no cheaper bound is known")
        if demanded is not None:
            return self._settle(name, on=True, share=bound, reason=demanded)
        worst, limit = _largest(bound), percent_of(self.budget)
        if self.leaves_out(bound):
            reason = f"at most {percent_of(worst, 2)} of the torque, within the {limit} that may be left out"
            return self._settle(name, on=False, share=bound, reason=reason)
        reason, before = size_of(worst), _largest(self.left_out)
        if worst <= 1:
            reason += f", more than the {limit} that may be left out"
            reason += f", {percent_of(before, 2)} of it already" if before > 0 else ""
        return self._settle(name, on=True, share=bound, reason=reason)

    def leaves_out(self, bound: Array) -> bool:
        """Whether something with this bound, (n,), fits into what the budget leaves; if so, it counts as left out."""
        if not self.fits(bound):
            return False
        self.left_out = self._with(bound)
        return True

    def leaves_out_at(self, bound: Array) -> NDArray[np.bool_]:
        """(n,) where something with this bound fits into what the budget leaves; there it counts as left out."""
        fits = self._with(bound) <= self.budget
        self.left_out = np.where(fits, self._with(bound), self.left_out)
        return fits

    def fits(self, bound: Array) -> bool:
        """Whether something with this bound, (n,), fits into what the budget leaves."""
        return _largest(self._with(bound)) <= self.budget

    def settle(self, name: str, *, on: bool, reason: str, share: Array | float | None = None) -> None:
        """Record an effect about which there is nothing to decide, with its bound where one is known.

        Raises InputError if the scene says on and the effect is off.
        """
        self._settle(name, on=on, share=share, reason=reason)

    def not_applied(self, name: str, reason: str) -> None:
        """Record that an effect was decided on and has no answer here: off, whatever the scene says, with its bound."""
        self.made[name] = replace(self.made[name], decision="off", reason=reason)

    def rules_out(self, name: str) -> bool:
        """Whether the scene says off, before the effect is settled."""
        return self.scene.effects.get(name) == "off"

    def is_on(self, name: str) -> bool:
        return self.made[name].decision == "on"

    def effects(self, parts: Mapping[str, Array], total: Array) -> tuple[Effect, ...]:
        """Every effect in the order of the table; one with a part of the torque has its largest share for a bound."""
        unsettled = [name for name in ENTRIES if name not in self.made]
        if unsettled:
            raise RuntimeError(f"effects without a decision: {', '.join(unsettled)}")
        return tuple(
            replace(self.made[name], share=_largest(share_in(parts[name], total))) if name in parts else self.made[name]
            for name in ENTRIES
        )

    def _with(self, bound: Array) -> Array:
        return self.left_out + (1 + self.left_out) * bound

    def _settle(self, name: str, *, on: bool, share: Array | float | None, reason: str) -> bool:
        if not on and self.scene.effects.get(name) == "on":
            raise InputError(f'effects.{name} = "on" cannot be had: {reason}')
        self.made[name] = Effect(
            name=name,
            decision="on" if on else "off",
            share=None if share is None else _largest(share),
            reason=reason,
        )
        return on


def share_in(part: Array, total: Array) -> Array:
    """part/total, 0 where there is nothing to share."""
    return np.divide(part, total, out=np.zeros(np.broadcast(part, total).shape), where=total > 0)


def _largest(share: Array | float) -> float:
    return float(np.max(share, initial=0.0))
