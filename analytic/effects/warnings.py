"""What the reader has to know before using the numbers of a friction torque."""

from collections.abc import Iterator

import numpy as np

from analytic.effects.ledger import Choices, size_of
from analytic.oil.lubricated_races import LubricatedRaces
from analytic.oil.mixed import MixedContact
from analytic.oil.rolling import RollingResistance
from analytic.scene import Scene

RACES = ("inner", "outer")

MOLECULE = 1e-9  # m, of an oil, its size


def doubts(
    scene: Scene,
    choices: Choices,
    *,
    watched: list[str],
    oiled: LubricatedRaces | None,
    shared: MixedContact | None,
    resistance: RollingResistance | None,
) -> list[str]:
    """Every warning; watched: those of `analytic.effects.limits`."""
    warnings = [*scene.warnings]
    if scene.friction_coefficient is not None:
        warnings.append(
            f"the friction coefficient {scene.friction_coefficient:g} comes from the scene, not from a lubrication "
            "model"
        )
    if scene.microslip == "as_printed":
        warnings.append(
            'friction.microslip = "as_printed" is no model: equations 2 to 7 as the paper prints them have M_z and M_r '
            "exchanged without spin and from a spin-to-roll ratio of 1/2 on, equation 2 lacks its factor 0.322, and "
            'both moments jump there; "derived" has them right'
        )
    if scene.cage is None:
        warnings.append("the total is without a cage: add a table [cage]")
    if scene.lubricant is None and scene.effects.get("rolling") != "off":
        warnings.append("rolling needs [lubricant]: the total is too low by the hydrodynamic resistance to it")
    if oiled is not None:
        warnings += oiled.roughness.warnings
    for race, name in enumerate(RACES):
        if shared is not None:
            warnings += _doubts_of_film(shared, race)
        if resistance is not None and np.any(resistance.outside_range[race]):
            warnings.append(
                f"rolling on the {name} race is extrapolated: its formula is for slow rolling of contacts that are "
                "longer across it than along"
            )
    return [*warnings, *watched, *_doubts_of_choices(scene, choices)]


def _doubts_of_choices(scene: Scene, choices: Choices) -> Iterator[str]:
    """Effects that are left out for another reason than their size, and could be larger than the tolerance."""
    for effect in choices.made.values():
        if effect.decision == "off" and effect.share is not None and effect.share > scene.tolerance:
            beyond = ", more than the tolerance" if effect.share <= 1 else ""
            yield f"{effect.name} is left out and {size_of(effect.share)}{beyond}: {effect.reason}"


def _doubts_of_film(shared: MixedContact, race: int) -> Iterator[str]:
    name = RACES[race]
    if np.any(shared.without_film):
        yield (
            f"at standstill the {name} contact has no film and asperities carry all of the load: slow running need not "
            "come to the same, as it may leave a share to the oil"
        )
    film = shared.film_thickness[race]
    thin = (film < MOLECULE) & ~np.broadcast_to(shared.without_film, shared.film_thickness.shape)[race]
    if np.any(thin):
        yield (
            f"the film on the {name} race is down to {film[thin].min():.2g} m, less than a molecule of about "
            f"{MOLECULE:g} m: no formula for oil holds there, and boundary friction is likelier"
        )
    if np.any(shared.outside_range[race]):
        yield f"the film on the {name} race is extrapolated: its ellipse is not of a shape that was fitted"
    if np.any(shared.capped[race]):
        yield f"the film on the {name} race is as thick as the bodies leave room for: the formula gave more"
