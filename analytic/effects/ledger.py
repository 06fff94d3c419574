"""The decisions of one scene: which effects are computed, and what leaving out the others can change.

`auto` leaves an effect out where what it may change fits into what remains of half the scene's tolerance. A trial
shows that (`analytic.effects.trial`), or a bound where a trial would cost more than the rest. All that is left out
compounds to less than that half; the other half is for the method by which sliding is integrated. One decision holds
for the whole series. Every effect of `analytic.effects.table` must be settled, whatever the scene.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from analytic.effects.table import CHOSEN, ENTRIES, LIMITS, OIL_LOSSES, TRIED
from analytic.errors import InputError
from analytic.scene import Array, Scene
from analytic.words import percent_of

SHARE_OF_TOLERANCE = 0.5
SWITCHED_OFF = "off in the scene"  # how the reason of an effect begins that the scene switches off
ShareKind = Literal["part", "trial", "bound", "unbounded", "unknown"]


@dataclass(frozen=True, kw_only=True)
class Effect:
    """One physical contribution, decided for the whole series."""

    name: str  # as in `scene.effects`
    decision: Literal["on", "off"]  # whether it counts
    # The largest share of the total over the series: of its part of the torque where it has one, else a bound. Infinite
    # where it could be of any size, None where it is not known.
    share: float | None
    reason: str  # in words, with the bound or the limit
    share_is: ShareKind = "unknown"  # what the share is; see `FrictionTorque.shares`

    def __str__(self) -> str:
        return f"{self.name}: {self.decision}, {self.reason}"


class Effects(Sequence[Effect]):
    """Every effect of a torque in the order of the table; shares by trial are measured when somebody reads them."""

    def __init__(
        self, made: Mapping[str, Effect], measure: Callable[[str], float] | None, tried: frozenset[str] = frozenset()
    ) -> None:
        """made : by name;  measure : the share of one of those that are `tried` and count; None: all are known"""
        self._made, self._measure, self._tried = dict(made), measure, tried

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
        return len(self._made)

    def __getstate__(self) -> dict[str, Any]:
        return {"_made": {effect.name: effect for effect in self._all}, "_measure": None, "_tried": frozenset()}

    @cached_property
    def _all(self) -> tuple[Effect, ...]:
        measure = self._measure
        if measure is None:
            return tuple(self._made.values())
        return tuple(
            replace(effect, share=measure(effect.name))
            if effect.decision == "on" and effect.name in self._tried
            else effect
            for effect in self._made.values()
        )


def size_of(share: float) -> str:
    """How large an effect can be whose bound is this share of the torque, in words."""
    if np.isinf(share):
        return "no bound known"
    return "larger than the torque" if share > 1 else f"up to {percent_of(share, 2)} of the torque"


class Ledger:
    """The decisions for one scene, as they are made."""

    def __init__(self, scene: Scene, points: int) -> None:
        """points : operating points of the scene. Raises InputError for effects that nobody can choose."""
        known = (*CHOSEN, *OIL_LOSSES, *LIMITS)
        unknown = set(scene.effects) - {*known}
        if unknown:
            raise InputError(f"effects.{min(unknown)} is not an effect to choose; known: {', '.join(known)}")
        for name in LIMITS:
            if scene.effects.get(name) == "on":
                raise InputError(f'effects.{name} = "on" is refused: not modelled; give "auto" or "off"')
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
            unknown = "; size not computed" if bound is None else ""
            return self._settle(name, on=False, share=bound, reason=f"{SWITCHED_OFF}{unknown}")
        if lacks is not None:
            return self._settle(name, on=False, share=bound, reason=lacks)
        if wanted == "on":
            return self._settle(name, on=True, share=bound, reason="on in the scene")
        if demanded is not None:
            return self._settle(name, on=True, share=bound, reason=demanded)
        if bound is None:
            return self._settle(name, on=True, share=None, reason="always computed: no cheap bound")
        worst = _largest(bound)
        if self.leaves_out(bound):
            reason = f"{size_of(worst)}, within the budget of {percent_of(self.budget)}" if worst else "no effect here"
            return self._settle(name, on=False, share=bound, reason=reason)
        reason = size_of(worst)
        if worst <= 1:
            point = int(np.argmax(self._with(bound)))
            remaining = (self.budget - self.left_out[point]) / (1 + self.left_out[point])
            reason = f"{size_of(bound[point])}, exceeds the remaining budget of {percent_of(remaining)}"
        return self._settle(name, on=True, share=bound, reason=reason)

    def leaves_out(self, bound: Array) -> bool:
        """Whether something with this bound, (n,), fits into what the budget leaves; if so, it counts as left out."""
        if _largest(self._with(bound)) > self.budget:
            return False
        self.left_out = self._with(bound)
        return True

    def leaves_out_at(self, bound: Array) -> NDArray[np.bool_]:
        """(n,) where something with this bound fits into what the budget leaves; there it counts as left out."""
        fits = self._with(bound) <= self.budget
        self.left_out = np.where(fits, self._with(bound), self.left_out)
        return fits

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

    def effects(self, parts: Mapping[str, Array], total: Array, measure: Callable[[str], float]) -> Effects:
        """Every effect; one with a part of the torque has its largest share for a bound.

        measure : the share of an effect that counts, by trial
        """
        unsettled = [name for name in ENTRIES if name not in self.made]
        if unsettled:
            raise RuntimeError(f"effects without a decision: {', '.join(unsettled)}")
        made = {
            name: replace(self.made[name], share=_largest(share_in(parts[name], total)))
            if name in parts
            else self.made[name]
            for name in ENTRIES
        }
        tried = frozenset(name for name in TRIED if name not in parts and made[name].reason != ENTRIES[name].given)
        return Effects(made, measure, tried)

    def _with(self, bound: Array) -> Array:
        return self.left_out + (1 + self.left_out) * bound

    def _settle(self, name: str, *, on: bool, share: Array | float | None, reason: str) -> bool:
        if not on and self.scene.effects.get(name) == "on":
            raise InputError(f'effects.{name} = "on" is refused: {reason}')
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
