"""The friction torque of a scene with all that is shown beside it."""

from dataclasses import dataclass
from typing import Any

import numpy as np

from analytic.result import FrictionTorque
from analytic.scene import Scene
from analytic.torque import friction_torque, with_model_uncertainty
from fembearing.compare.torque.catalogue import BesideCatalogue, beside_catalogue


@dataclass(frozen=True, kw_only=True, eq=False)
class SceneTorque:
    """Torque, uncertainties and catalogue band of one scene."""

    scene: Scene
    found: FrictionTorque
    catalogue: BesideCatalogue

    @property
    def within_tolerance(self) -> bool:
        """Whether the numerical uncertainty is, at every operating point."""
        return bool(np.all(self.found.numerical_uncertainty <= self.scene.tolerance))

    def to_json(self) -> dict[str, Any]:
        return self.found.to_json() | {"tolerance": self.scene.tolerance, "catalogue_band": self.catalogue.to_json()}


def torque_of_scene(scene: Scene) -> SceneTorque:
    """Compute it. Raises InputError as friction_torque does."""
    found = with_model_uncertainty(scene, friction_torque(scene))
    return SceneTorque(scene=scene, found=found, catalogue=beside_catalogue(scene))
