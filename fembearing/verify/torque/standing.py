"""How far a torque can be trusted, in one word and the reason for it."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from analytic.effects.warnings import too_fast
from analytic.scene import Array, Scene
from analytic.words import percent_of
from fembearing.verify.torque.catalogue_models import CatalogueBand
from fembearing.verify.torque.verdicts import Verdicts

Word = Literal["fail", "incomplete", "undecided", "check"]
UNMEASURED = "no measured torque of such a bearing is known"


@dataclass(frozen=True, kw_only=True)
class Standing:
    """The first that applies of

    - fail: a comparison or a physical limit fails
    - incomplete: an effect that `auto` cannot decide is left out and could exceed the tolerance
    - undecided: the solver error exceeds the tolerance, or a limit is not known
    - check: none of these; the reason says where the torque lies by the makers' formulas

    No torque passes: nothing here compares it with a measured one, which `fembearing compare` does.
    """

    word: Word
    reason: str


def standing_of(
    scene: Scene, *, total: Array, shares: dict[str, float], verdicts: Verdicts, band: CatalogueBand | None
) -> Standing:
    """Of a torque; a speed beyond usual practice is named with any word.

    total : N m, (n,);  shares : of the total, of the effects that are off, at most;  band : arrays (n,), N m
    """
    standing = _standing(scene, total=total, shares=shares, verdicts=verdicts, band=band)
    speed = too_fast(scene)
    return standing if speed is None else replace(standing, reason=f"{speed}; {standing.reason}")


def _standing(
    scene: Scene, *, total: Array, shares: dict[str, float], verdicts: Verdicts, band: CatalogueBand | None
) -> Standing:
    if verdicts.overall == "fail":
        return Standing(word="fail", reason=verdicts.reason)
    lacking = {name: share for name, share in shares.items() if share > scene.tolerance and not _chosen(scene, name)}
    if lacking:
        name = max(lacking, key=lacking.__getitem__)
        size = (
            f"could be {percent_of(lacking[name], 2)} of the torque"
            if np.isfinite(lacking[name])
            else "is of unknown size"
        )
        return Standing(word="incomplete", reason=f"{name} is left out and {size}; see --details")
    if verdicts.overall == "undecided":
        return Standing(word="undecided", reason=verdicts.reason)
    if band is None:
        return Standing(word="check", reason=f"no maker's formula holds for this bearing; {UNMEASURED}")
    return Standing(word="check", reason=f"{_place(total, band)} the makers' formulas; {UNMEASURED}")


def _chosen(scene: Scene, effect: str) -> bool:
    """Whether the scene itself leaves the effect out: by its name, or by a rule that says how the balls turn."""
    return scene.effects.get(effect, "auto") != "auto" or (effect == "creep" and scene.spin_rule != "free")


def _place(total: Array, band: CatalogueBand) -> str:
    """Where the torque lies by the band: inside at all points, or on which side at all or some."""
    sides = [name for name, points in (("below", total < band.low), ("above", total > band.high)) if np.any(points)]
    some = "" if total.size == 1 or np.all((total < band.low) | (total > band.high)) else "in part "
    return some + " and ".join(sides) if sides else "inside"
