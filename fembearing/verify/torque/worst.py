"""How far torques that were computed apart can be trusted together, as those of a cycle at several oil temperatures."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, fields, replace
from itertools import chain
from operator import attrgetter
from typing import Literal

import numpy as np

from analytic.effects import Effect
from analytic.result import FrictionTorque, TorqueParts
from analytic.scene import Array, Scene
from analytic.verdicts import PhysicalCheck, numerical_check, physical_checks
from fembearing.verify.torque.catalogue import beside_catalogue
from fembearing.verify.torque.catalogue_models import CatalogueBand
from fembearing.verify.torque.standing import Standing, standing_of
from fembearing.verify.torque.verdicts import Verdicts

SERIOUS = ("fail", "unknown", "pass")  # verdicts of a physical check, the worst first


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


def _joined_parts(series: Sequence[TorqueParts[Array]]) -> TorqueParts[Array]:
    """A part that one series does not have is 0 there."""
    joined = {}
    for name in (field.name for field in fields(TorqueParts)):
        values = [getattr(each, name) for each in series]
        if any(value is not None for value in values):
            at_all = [np.zeros_like(each.total) if value is None else value
                      for each, value in zip(series, values, strict=True)]  # fmt: skip
            joined[name] = np.concatenate(at_all)
        else:
            joined[name] = None
    return TorqueParts(**joined)


def _worst_checks(checks: Iterable[PhysicalCheck]) -> Iterable[PhysicalCheck]:
    """The most serious check of each limit and place."""
    by_severity = sorted(checks, key=lambda check: SERIOUS.index(check.verdict), reverse=True)
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
