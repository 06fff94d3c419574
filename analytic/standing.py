"""How far a torque can be trusted, in one word and the reason for it."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields, replace
from itertools import chain
from operator import attrgetter, itemgetter
from typing import Literal

import numpy as np

from analytic.effects import ENTRIES, OIL_LOSSES, Effect, size_of
from analytic.limits import too_fast
from analytic.makers import CatalogueBand, beside_catalogue, of_open_bearing
from analytic.result import FrictionTorque, TorqueParts
from analytic.scene import Array, Scene
from analytic.verdicts import PHYSICAL_ORDER, PhysicalCheck, Verdicts, numerical_check, physical_checks
from analytic.words import percent_of

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
    torque: TorqueParts,
    effects: Iterable[Effect],
    verdicts: Verdicts,
    band: CatalogueBand | None,
) -> Standing:
    """Of a torque; a speed beyond usual practice is named with any word.

    torque, band : arrays (n,), N m
    """

    def said(word: Word, reason: str) -> Standing:
        return Standing(word=word, reason="; ".join(filter(None, (too_fast(scene), reason))))

    if verdicts.overall == "fail":
        return said("fail", verdicts.reason)
    off = [each for each in effects if each.decision == "off" and not _chosen(scene, each.name)]
    sizes = [(_size(scene, each), each) for each in off]
    large = [(share, each) for share, each in sizes if share > scene.tolerance]
    estimated = [(share, each) for share, each in large if each.name in OIL_LOSSES and share <= MOST_ESTIMATED]
    lacking = [each for each in large if each not in estimated]
    if lacking:
        return said("incomplete", _lack(lacking, scene.tolerance))
    if verdicts.overall == "undecided":
        return said("undecided", verdicts.reason)
    without = "".join(
        f"; without {each.name}, some {percent_of(share, 2)} by usual values" for share, each in estimated
    )
    if band is None:
        return said("check", f"no maker's formula holds for this bearing{without}; {UNMEASURED}")
    compared, words = of_open_bearing(torque)
    after = f", {words}" if words else ""
    return said("check", f"{_place(compared, band)} the makers' formulas{after}{without}; {UNMEASURED}")


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
    sides = band.sides(total)
    some = "" if total.size == 1 or sum(sides.values()) == total.size else "in part "
    return some + " and ".join(sides) if sides else "inside"


@dataclass(frozen=True, kw_only=True)
class WorstStanding(Standing):
    """The standing of all points together, which is that of the worst."""

    points: int | None  # that fail or are undecided; None: the word says neither
    size: int  # number of all points that were checked

    def line(self, noun: Literal["points", "turning steps"]) -> str:
        """Word, number of points and reason.

        Parameters
        ----------
        noun : {"points", "turning steps"}
            What the points are.

        Returns
        -------
        str
            One line.
        """
        where = "" if self.points is None else f" at {self.points} of {self.size} {noun}"
        return f"{self.word}{where}: {self.reason}"


def worst_standing(torques: Sequence[tuple[Scene, FrictionTorque]]) -> WorstStanding:
    """The standing of at least one series of torques, each with its scene, which differ in oil and operating points."""
    verdicts = [_verdicts(scene, friction) for scene, friction in torques]
    together = Verdicts(
        numerical=max(
            (each.numerical for each in verdicts if each.numerical is not None), key=attrgetter("uncertainty")
        ),
        physical=tuple(_worst_checks(chain.from_iterable(each.physical for each in verdicts))),
    )
    standing = standing_of(
        _joined_scene([scene for scene, _ in torques]),
        torque=_joined_parts([friction.torque for _, friction in torques]),
        effects=_largest_effects(chain.from_iterable(friction.effects.unmeasured for _, friction in torques)),
        verdicts=together,
        band=_joined_band([beside_catalogue(scene, friction.pair).band for scene, friction in torques]),
    )
    words = [
        _verdicts(scene, friction.at(np.array([point]))).overall
        for scene, friction in torques
        for point in range(friction.inner_speed.size)
    ]
    counts = standing.word in ("fail", "undecided")
    return WorstStanding(**vars(standing), points=words.count(standing.word) if counts else None, size=len(words))


def _verdicts(scene: Scene, friction: FrictionTorque) -> Verdicts:
    return Verdicts(numerical=numerical_check(friction, tolerance=scene.tolerance), physical=physical_checks(friction))


def _joined_parts(series: Sequence[TorqueParts]) -> TorqueParts:
    """A part that one series does not have is 0 there."""

    def joined(name: str) -> Array | None:
        parts = [(getattr(each, name), each.total) for each in series]
        if all(part is None for part, _ in parts):
            return None
        return np.concatenate([np.zeros_like(total) if part is None else part for part, total in parts])

    return TorqueParts(**{field.name: joined(field.name) for field in fields(TorqueParts)})  # pyright: ignore[reportArgumentType]


def _worst_checks(checks: Iterable[PhysicalCheck]) -> Iterable[PhysicalCheck]:
    """The most serious check of each limit and place."""
    by_severity = sorted(checks, key=lambda check: PHYSICAL_ORDER.index(check.verdict), reverse=True)
    return {(check.name, check.where): check for check in by_severity}.values()


def _largest_effects(effects: Iterable[Effect]) -> Iterable[Effect]:
    """Each effect once: where it is neglected with the largest share, if it is neglected anywhere."""
    ascending = sorted(effects, key=lambda each: (each.decision == "off", each.share or 0.0))
    return {each.name: each for each in ascending}.values()


def _joined_scene(scenes: Sequence[Scene]) -> Scene:
    """The first scene with the operating points of all."""
    series = [scene.operation.as_series().points for scene in scenes]
    joined = {name: np.concatenate([each[name] for each in series]) for name in series[0]}
    return replace(scenes[0], operation=replace(scenes[0].operation, **joined))


def _joined_band(bands: Sequence[CatalogueBand | None]) -> CatalogueBand | None:
    """The band over the operating points of all; None where a series has none."""
    known = [band for band in bands if band is not None]
    if len(known) < len(bands):
        return None
    low, high = (np.concatenate([np.atleast_1d(getattr(band, end)) for band in known]) for end in ("low", "high"))
    return replace(known[0], low=low, high=high)
