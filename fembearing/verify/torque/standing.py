"""How far a torque can be trusted, in one word and the reason for it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from operator import itemgetter
from typing import Literal

import numpy as np

from analytic.effects import ENTRIES, OIL_LOSSES, Effect, size_of
from analytic.limits import too_fast
from analytic.result import TorqueParts
from analytic.scene import Array, Scene
from analytic.words import percent_of
from fembearing.verify.torque.catalogue import of_open_bearing
from fembearing.verify.torque.catalogue_models import CatalogueBand
from fembearing.verify.torque.verdicts import Verdicts

Word = Literal["fail", "incomplete", "undecided", "check"]
UNMEASURED = "no measured torque of such a bearing is known"
# Of the torque, a judgement: the 95 % interval of ordinary bearings reaches some 20 to 40 % up, and a loss below this
# moves the torque within it.
MOST_ESTIMATED = 0.2


@dataclass(frozen=True, kw_only=True)
class Standing:
    """The first that applies of

    - fail: a comparison or a physical limit fails
    - incomplete: an effect lacks its input and could exceed the tolerance by its estimate; a loss of the oil,
        whose size is estimated, only from MOST_ESTIMATED on; seals that rub and that nobody declares always, as their
        size is not known
    - undecided: the solver error exceeds the tolerance, or a limit is not known
    - check: none of these; the reason says where the torque lies by the makers' formulas

    No torque passes: nothing here compares it with a measured one, which `fembearing compare` does.
    """

    word: Word
    reason: str


def standing_of(
    scene: Scene,
    *,
    torque: TorqueParts[Array],
    effects: Iterable[Effect],
    verdicts: Verdicts,
    band: CatalogueBand | None,
) -> Standing:
    """Of a torque; a speed beyond usual practice is named with any word.

    torque, band : arrays (n,), N m
    """
    standing = _standing(scene, torque=torque, effects=effects, verdicts=verdicts, band=band)
    speed = too_fast(scene)
    return standing if speed is None else replace(standing, reason=f"{speed}; {standing.reason}")


def _standing(
    scene: Scene,
    *,
    torque: TorqueParts[Array],
    effects: Iterable[Effect],
    verdicts: Verdicts,
    band: CatalogueBand | None,
) -> Standing:
    if verdicts.overall == "fail":
        return Standing(word="fail", reason=verdicts.reason)
    off = [each for each in effects if each.decision == "off" and not _chosen(scene, each.name)]
    sizes = [(_size(scene, each), each) for each in off]
    large = [(share, each) for share, each in sizes if share > scene.tolerance]
    estimated = [(share, each) for share, each in large if each.name in OIL_LOSSES and share <= MOST_ESTIMATED]
    lacking = [each for each in large if each not in estimated]
    if lacking:
        return Standing(word="incomplete", reason=_lack(lacking, scene.tolerance))
    if verdicts.overall == "undecided":
        return Standing(word="undecided", reason=verdicts.reason)
    without = "".join(
        f"; without {each.name}, some {percent_of(share, 2)} by usual values" for share, each in estimated
    )
    if band is None:
        return Standing(word="check", reason=f"no maker's formula holds for this bearing{without}; {UNMEASURED}")
    compared, words = of_open_bearing(torque)
    after = f", {words}" if words else ""
    return Standing(word="check", reason=f"{_place(compared, band)} the makers' formulas{after}{without}; {UNMEASURED}")


def _size(scene: Scene, effect: Effect) -> float:
    """Its share of the torque; infinite: it is there, and its size is not known; 0: it is not there."""
    if effect.share is not None:
        return effect.share
    return np.inf if effect.name == "seals" and scene.bearing.seals_rub else 0.0


def _lack(lacking: Sequence[tuple[float, Effect]], tolerance: float) -> str:
    """The largest of the effects that are off and exceed the tolerance, with its share and what it lacks, in words."""
    share, effect = max(lacking, key=itemgetter(0))
    others = [each.name for _, each in lacking if each is not effect]
    return (
        f"{effect.name} ({ENTRIES[effect.name].meaning}) is neglected, {size_of(share)}, tolerance "
        f"{percent_of(tolerance)}: {effect.reason}{_accepting(effect.name)}"
        + (f"; also neglected: {', '.join(others)}" if others else "")
    )


def _accepting(name: str) -> str:
    """What accepts that it is neglected; seals are declared, 0 for none."""
    return '; losses.seals = "0 N mm" accepts this' if name == "seals" else f'; effects.{name} = "off" accepts this'


def _chosen(scene: Scene, effect: str) -> bool:
    """Whether the scene itself switches the effect off: by its name, or by a rule for the rotation of the balls."""
    return scene.effects.get(effect, "auto") != "auto" or (effect == "creep" and scene.spin_rule != "free")


def _place(total: Array, band: CatalogueBand) -> str:
    """Where the torque lies by the band: inside at all points, or on which side at all or some."""
    sides = [name for name, points in (("below", total < band.low), ("above", total > band.high)) if np.any(points)]
    some = "" if total.size == 1 or np.all((total < band.low) | (total > band.high)) else "in part "
    return some + " and ".join(sides) if sides else "inside"
