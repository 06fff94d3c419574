"""How far the torque could be from the truth because a formula in it is, and not because of how it is computed."""

from dataclasses import replace

import numpy as np

from analytic.contact.factors import ContactCorrection
from analytic.oil.film import FORMULA_UNCERTAINTY
from analytic.result import FrictionTorque
from analytic.scene import Scene
from analytic.torque import friction_torque

COVERAGE = 2.0  # standard uncertainties to a half-width of 95 %


def with_model_uncertainty(
    scene: Scene, found: FrictionTorque, *, correction: ContactCorrection | None = None
) -> FrictionTorque:
    """The torque of a scene with the part of its uncertainty that measurements of films give.

    found : friction_torque(scene, correction=correction), at the film that the formula gives
    The torque is computed again, by the same effects and rungs, with every film thicker and thinner by twice the
    formula's standard uncertainty of 11 % against measured films (`validation/film.py`); the larger change counts.
    Without a film nothing is known. What the other formulas miss of the truth - rolling, asperities, traction, the oil
    itself - no measurement here tells, and so the true uncertainty is larger.
    """
    if found.film.inner is None:
        return found
    same = found.settled(scene)
    total = found.torque.total
    changes = [
        np.abs(friction_torque(same, correction=correction, film_factor=factor).torque.total - total)
        for factor in (1 - COVERAGE * FORMULA_UNCERTAINTY, 1 + COVERAGE * FORMULA_UNCERTAINTY)
    ]
    largest = np.maximum(*changes)
    return replace(found, model_uncertainty=np.divide(largest, total, out=np.zeros_like(total), where=total > 0))
