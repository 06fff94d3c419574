"""The friction torque of a scene, as the command `torque` computes it, with what is shown next to it."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.effects.table import STATIC_LIMIT
from analytic.result import FrictionTorque
from analytic.scene import Scene
from analytic.torque import friction_torque
from analytic.uncertainty import with_model_uncertainty
from fembearing.compare.torque.catalogue import BesideCatalogue, beside_catalogue


@dataclass(frozen=True, kw_only=True, eq=False)
class SceneTorque:
    """Torque, uncertainties and catalogue band of one scene."""

    scene: Scene
    friction: FrictionTorque
    catalogue: BesideCatalogue

    @property
    def within_tolerance(self) -> bool:
        """Whether the numerical uncertainty is, at every operating point."""
        return bool(np.all(self.friction.numerical_uncertainty <= self.scene.tolerance))

    @property
    def doubts(self) -> tuple[str, ...]:
        """Why the total may be far from the truth although it is computed within the tolerance; a sentence each."""
        return tuple(self._doubts())

    def _doubts(self) -> Iterator[str]:
        if not self.within_tolerance:
            worst = float(np.max(self.friction.numerical_uncertainty))
            limit = self.scene.tolerance
            if np.isfinite(worst):
                yield f"The numerical uncertainty of the torque, {worst:.2g}, is beyond the tolerance {limit:g}."
            else:
                yield f"The numerical uncertainty of the torque is not known: {'; '.join(self.friction.unknown)}."
        for race in ("inner", "outer"):
            yield from static_doubt(race, getattr(self.friction, race).peak_pressure)
        band, total = self.catalogue.band, self.friction.torque.total
        if band is not None and (outside := np.count_nonzero((total < band.low) | (total > band.high))):
            yield f"The torque is outside the catalogue band at {outside} of {total.size} operating points."

    def to_json(self) -> dict[str, Any]:
        """The torque as plain types, SI, with the catalogue band, None where there is none."""
        return self.friction.to_json() | {
            "tolerance": self.scene.tolerance,
            "catalogue_band": self.catalogue.to_json(),
            "doubts": list(self.doubts),
        }


def static_doubt(race: str, peak_pressure: Any) -> Iterator[str]:
    """One sentence where a peak pressure by Hertz, Pa, one or an array, is past the static limit."""
    largest = float(np.max(peak_pressure))
    if largest > STATIC_LIMIT:
        yield (
            f"The peak pressure on the {race} race, {largest * 1e-9:.2f} GPa, is past the static limit of "
            f"{STATIC_LIMIT * 1e-9:g} GPa: the race yields, and elastic contact no longer describes it."
        )


def torque_of_scene(scene: Scene) -> SceneTorque:
    """The torque of a scene. Raises InputError as friction_torque does."""
    friction = with_model_uncertainty(scene, friction_torque(scene))
    return SceneTorque(scene=scene, friction=friction, catalogue=beside_catalogue(scene))
