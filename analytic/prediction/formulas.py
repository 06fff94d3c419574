"""What the uncertainty of the model's formulas does to a friction torque."""

from dataclasses import replace
from types import MappingProxyType

import numpy as np

from analytic.numerics.elements import share_in
from analytic.oil.film import FILM_FACTORS
from analytic.oil.variation import (
    COVERAGE,
    GREASE_SPREAD,
    HEATING_SPREAD,
    NOMINAL,
    OIL_LOSS_FACTORS,
    ROLLING_SPREAD,
    SURFACE_SPREAD,
    UNLOADED_SPREAD,
    Variation,
)
from analytic.prediction.evaluation import parts_of, without_moving_cage
from analytic.prediction.settled import level_of_changes
from analytic.result import FrictionTorque
from analytic.scene import Array, Scene

# How far the oil may reach ahead of a contact, over the reach of the scene: a judgement. In a bath, whose oil is taken
# to reach 0.9 of the ball's radius, these are 0.45 and 1 radii.
REACHES = (0.5, 1.1)


def with_model_uncertainty(scene: Scene, result: FrictionTorque) -> FrictionTorque:
    """The torque of a scene with the part of its model uncertainty that is known, 95 %.

    result : friction_torque(scene)
    The kernel computes the torque again, with the same effects and methods, and each change is a part:
        traction: the oil's shear stress by the factors exp(-2 s) and exp(2 s) with its spread s, and by the other law
            of thickening
        film: films thicker and thinner by twice the standard uncertainty of their formula, 15 % of ln h
        gap: the measured law of the load on asperities, and as far to the other side
        surfaces: asperities that press more and less by twice the spread between surfaces of equal statistics
        rolling: a resistance to rolling of 0.94 and 1.06 times that of the numerical fit, and of 0.61 and 1.65 times
            that of the closed formula, as far as either counts
        reach: oil that reaches 0.5 and 1.1 times as far ahead of each contact
        heating: the factors for heating of the inlets by the powers 0.61 and 1.65
        starvation: flooded inlets in place of those that the replenishment factor starves, and the square of the factor
        grease_film: the films measured with grease by 0.74 and 1.35, with the rolling that belongs to them
        unloaded_balls: their rolling by the factors 0.61 and 1.65
        oil_losses: the losses by oil outside the contacts by the factors 0.5 and 2
        elastic_rolling: the other law of elastic rolling, `hysteresis` or `houpert`, and as far to the other side, up
            to the law of dry contacts
    The largest change counts. The parts are independent, so the root of the sum of their squares is the whole.
    A cage that moves keeps its torque. The errors of the oil's own properties, of traction and of the inputs come on
    top, so the true uncertainty is larger.
    """
    variations: dict[str, list[tuple[Scene, Variation]]] = {}
    same = without_moving_cage(scene, result.settled())
    lubricant = scene.lubricant
    if scene.surface is not None and result.film.inner is not None:
        variations["film"] = [(same, Variation(film=factor)) for factor in FILM_FACTORS]
        assert lubricant is not None  # which has the film
        factors = [np.exp(sign * COVERAGE * lubricant.traction_spread) for sign in (-1, 1)]
        other = replace(lubricant, thickening="roelands" if lubricant.thickening == "modulus" else "modulus")
        variations["traction"] = [(same, Variation(traction=factor)) for factor in factors]
        variations["traction"].append((replace(same, lubricant=other), NOMINAL))
        if result.is_on("asperities"):
            variations["gap"] = [(same, Variation(asperity_share=step)) for step in (-1.0, 1.0)]
            factors = [np.exp(sign * COVERAGE * SURFACE_SPREAD) for sign in (-1, 1)]
            variations["surfaces"] = [(same, Variation(asperity_pressure=factor)) for factor in factors]
    if result.torque.rolling is not None and lubricant is not None:
        factors = [np.exp(sign * COVERAGE * ROLLING_SPREAD) for sign in (-1, 1)]
        variations["rolling"] = [(same, Variation(rolling_error=factor)) for factor in factors]
        oils = [
            replace(lubricant, reach=replace(lubricant.reach, ahead=factor * lubricant.reach.ahead))
            for factor in REACHES
        ]
        variations["reach"] = [(replace(same, lubricant=oil), NOMINAL) for oil in oils]
        if result.is_on("inlet_heating"):
            factors = [np.exp(sign * COVERAGE * HEATING_SPREAD) for sign in (-1, 1)]
            variations["heating"] = [(same, Variation(heating=factor)) for factor in factors]
    if lubricant is not None and lubricant.starves_by_replenishment(scene.bearing) and result.is_on("starvation"):
        variations["starvation"] = [(same, Variation(starvation=step)) for step in (-1.0, 1.0)]
    if lubricant is not None and lubricant.starves_as_measured(scene.bearing) and result.is_on("starvation"):
        factors = [np.exp(sign * COVERAGE * GREASE_SPREAD) for sign in (-1, 1)]
        variations["grease_film"] = [(same, Variation(grease_film=factor)) for factor in factors]
    if result.is_on("unloaded_balls"):
        factors = [np.exp(sign * COVERAGE * UNLOADED_SPREAD) for sign in (-1, 1)]
        variations["unloaded_balls"] = [(same, Variation(unloaded_balls=factor)) for factor in factors]
    if scene.losses.has_oil:
        variations["oil_losses"] = [(same, Variation(oil_losses=factor)) for factor in OIL_LOSS_FACTORS]
    if result.is_on("hysteresis") and scene.loss_factor:
        variations["elastic_rolling"] = [(same, Variation(elastic_rolling=step)) for step in (-1.0, 1.0)]
    if not variations:
        return result
    level = level_of_changes(same)
    base = parts_of(same, NOMINAL, level).total

    def change(varied: Scene, variation: Variation) -> Array:
        return share_in(np.abs(parts_of(varied, variation, level).total - base), result.torque.total)

    parts = {name: np.max([change(*each) for each in pairs], axis=0) for name, pairs in variations.items()}
    whole = np.sqrt(np.sum([part**2 for part in parts.values()], axis=0))
    return replace(result, model_uncertainty=whole, model_parts=MappingProxyType(parts)).checked()
