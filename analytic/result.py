"""What the friction torque of a scene is told with: parts, contacts, effects, warnings, and their JSON."""

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any, Literal

import numpy as np

from analytic.cage.torque import CAGE_KEYS, CagePart
from analytic.effects.ledger import Effect
from analytic.effects.table import CHOSEN, DECLARED
from analytic.scene import Array, Scene, Sliding
from analytic.torque_columns import torque_dataset, torque_html


@dataclass(frozen=True, kw_only=True, eq=False)
class TorqueParts:
    """N m, each (n,); None where a part was left out or is not modelled."""

    total: Array  # the sum of what was computed and declared
    race: Array  # spin + conformity + hysteresis + rolling, as far as computed
    spin: Array | None
    conformity: Array | None
    hysteresis: Array | None
    rolling: Array | None = None
    cage: Array | None = None  # sliding on balls and land, and drag
    declared: Array | None = None  # seals and drag, as the scene tells them


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionCoefficients:
    """Of each contact, (n,); None where there is no such contact, or nothing that slides was asked for."""

    inner: Array | None = None
    outer: Array | None = None
    pocket: Array | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class OnRaces:
    """A quantity of the contacts on both races, each (n,); None where it is not known."""

    inner: Array | None = None
    outer: Array | None = None


@dataclass(frozen=True, kw_only=True, eq=False)
class LoadedContact:
    """One ball on one race, each (n,)."""

    load: Array  # Q, N
    semi_axis_rolling: Array  # a, m
    semi_axis_transverse: Array  # b, m
    peak_pressure: Array  # p0, Pa
    approach: Array  # delta, m


@dataclass(frozen=True, kw_only=True, eq=False)
class FrictionTorque:
    """The friction torque at every operating point of a scene; arrays have the shape (n,)."""

    inner_speed: Array  # rad/s
    axial_load: Array  # N
    contact_angle: Array  # al, loaded, the mean of both races, rad; this and what follows of the heaviest ball
    ball_load: Array  # Q, on the race where it is larger, N
    torque: TorqueParts
    # Of the total, relative: bounds on what auto left out and on the rung of sliding; infinite where none is known.
    numerical_uncertainty: Array
    friction_coefficient: FrictionCoefficients
    film: OnRaces  # h, between the mean planes, m; None without a lubrication model
    asperity_share: OnRaces  # s, of the load, 0 to 1; likewise
    inner: LoadedContact
    outer: LoadedContact
    effects: tuple[Effect, ...]
    sliding: Sliding  # the rung that integrated it; auto: nothing slides
    warnings: tuple[str, ...]
    provenance: Mapping[str, str]
    seconds: float  # that the computation took
    cage: CagePart | None = None  # what its torque comes from; None: left out
    model_uncertainty: Array | None = None  # of the total, relative, 95 %; see analytic.torque
    gap_roughness: float | None = None  # Sq of ball and race together, that the film is compared with, m

    def settled(self, scene: Scene) -> Scene:
        """The scene with every effect and rung decided as here, whatever bounds would say of a change of it."""
        decisions = {effect.name: effect.decision for effect in self.effects if effect.name in CHOSEN}
        return replace(scene, effects={**scene.effects, **decisions}, sliding=self.sliding)

    def to_json(self) -> dict[str, Any]:
        """Plain Python numbers, texts, lists and dicts, all SI; None where a part was left out or is not modelled."""
        return {
            "points": [self._point(index) for index in range(self.inner_speed.size)],
            "gap_roughness": self.gap_roughness,
            "effects": self.effects_to_json(),
            "warnings": list(self.warnings),
            "provenance": dict(self.provenance),
            "seconds": self.seconds,
        }

    def effects_to_json(self) -> list[dict[str, Any]]:
        """Each effect with what its share is: of a part of its own, a bound, unbounded or unknown (both None)."""
        return [
            asdict(effect)
            | {"share": None if effect.share is None else _finite(effect.share), "share_is": self._kind_of(effect)}
            for effect in self.effects
        ]

    def _kind_of(self, effect: Effect) -> Literal["part", "bound", "unbounded", "unknown"]:
        if effect.share is None:
            return "unknown"
        if not np.isfinite(effect.share):
            return "unbounded"
        return "part" if getattr(self.torque, effect.name, None) is not None or effect.name in DECLARED else "bound"

    def to_xarray(self) -> Any:
        """An xarray.Dataset over the operating points, with units."""
        return torque_dataset(self)

    def _repr_html_(self) -> str:
        """A table in a notebook."""
        return torque_html(self)

    def _point(self, index: int) -> dict[str, Any]:
        def here(group: object) -> dict[str, float | None]:
            return {name: None if values is None else float(values[index]) for name, values in vars(group).items()}

        model = None if self.model_uncertainty is None else float(self.model_uncertainty[index])
        return {
            "inner_speed": float(self.inner_speed[index]),
            "axial_load": float(self.axial_load[index]),
            "contact_angle": float(self.contact_angle[index]),
            "torque": here(self.torque),
            "friction_coefficient": here(self.friction_coefficient),
            "film": here(self.film),
            "asperity_share": here(self.asperity_share),
            "contact": {"inner": here(self.inner), "outer": here(self.outer)},
            "uncertainty": {"numerical": _finite(self.numerical_uncertainty[index]), "model": model},
            "cage": dict.fromkeys(CAGE_KEYS) if self.cage is None else self.cage.at(index),
        }


def _finite(value: float) -> float | None:
    return float(value) if np.isfinite(value) else None
