"""What the reader has to know before using the numbers of a friction torque."""

from collections.abc import Iterator

import numpy as np

from analytic.balls import LoadedBalls
from analytic.contact import Race, shoulder_distance
from analytic.effects import Choices
from analytic.errors import InputError
from analytic.lubrication import LubricatedRaces
from analytic.mixed import MixedContact
from analytic.race import SlidingContact, sliding_number
from analytic.rolling import RollingResistance
from analytic.scene import Operation, Scene
from analytic.sliding import Sliding

STATIC_LIMIT = 4.2e9  # Pa, peak pressure that leaves a dent of 1e-4 ball diameters (ISO 76, ball bearings)
LEAST_SLIDING = 3.0  # of the sliding number: below, elastic creep takes a good part of the slip
RACES: tuple[Race, Race] = ("inner", "outer")


def doubts(
    scene: Scene,
    operation: Operation,
    balls: LoadedBalls,
    choices: Choices,
    *,
    oiled: LubricatedRaces | None,
    shared: MixedContact | None,
    slid: Sliding | None,
    resistance: RollingResistance | None,
) -> list[str]:
    """In the order of their weight; decides on the effects that are only watched.

    Raises InputError for a contact that has left its race.
    """
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
    warnings.append("the cage is not modelled yet: the total is too low by it")
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
    for race in range(len(RACES)):
        warnings += _doubts_of_contact(scene, operation, balls, race, slid)
    warnings += _doubts_of_choices(scene, choices)
    return warnings


def _doubts_of_contact(
    scene: Scene, operation: Operation, balls: LoadedBalls, race: int, slid: Sliding | None
) -> Iterator[str]:
    name, loaded = RACES[race], balls.load[race] > 0
    angle, b = np.abs(balls.contact_angle[race]), balls.contact.semi_axis_y[race]
    room = np.where(loaded, shoulder_distance(scene.bearing, name, contact_angle=angle), np.inf)
    point, ball = np.unravel_index(np.argmin(room), room.shape)
    if room[point, ball] <= 0:
        raise InputError(
            f"operation.axial_load = {operation.axial_load[point]:g} N: the contact moves to {angle[point, ball]:.4f} "
            f"rad, beyond the {name} race's shoulder: lower the load, reduce the clearance or raise shoulder_half_width"
        )
    point, ball = np.unravel_index(np.argmax(b - room), room.shape)
    if b[point, ball] > room[point, ball]:
        yield (
            f"the contact ellipse passes the {name} race's shoulder: semi-axis {b[point, ball]:.4g} m, room "
            f"{room[point, ball]:.4g} m; the true contact is cut off there and its pressure higher"
        )
    peak = float(np.max(balls.contact.peak_pressure[race]))
    if peak > STATIC_LIMIT:
        yield (
            f"peak pressure on the {name} race {peak:.4g} Pa is above the static limit {STATIC_LIMIT:.2g} Pa: the "
            "contact is no longer elastic"
        )
    if slid is None:
        return
    creep = sliding_number(
        SlidingContact(
            friction_coefficient=slid.coefficient[race],
            load=balls.load[race],
            semi_axis_rolling=balls.contact.semi_axis_x[race],
            semi_axis_transverse=b,
            deformed_radius=balls.deformed_radius[race],
            rolling_rate=balls.rolling_rate[race],
        ),
        entrainment_speed=balls.motion.entrainment_speed,
        curvature_rolling=balls.curvature_along[race],
    )
    least = float(np.min(creep, where=loaded, initial=np.inf))
    if least < LEAST_SLIDING:
        yield (
            f"the sliding number of the {name} contact is {least:.3g}, below {LEAST_SLIDING:g}: elastic creep takes "
            "part of the slip, and spin and conformity come out too large"
        )


def _doubts_of_choices(scene: Scene, choices: Choices) -> Iterator[str]:
    """Effects that are left out for another reason than their size, and could be larger than the tolerance."""
    for effect in choices.made.values():
        if effect.decision == "off" and effect.share is not None and effect.share > scene.tolerance:
            yield (
                f"{effect.name} is left out and could be {effect.share:.2g} of the torque, more than the tolerance: "
                f"{effect.reason}"
            )


def _doubts_of_film(shared: MixedContact, race: int) -> Iterator[str]:
    name = RACES[race]
    if np.any(shared.without_film):
        yield (
            f"at standstill the {name} contact has no film and asperities carry all of the load: slow running need not "
            "come to the same, as it may leave a share to the oil"
        )
    if np.any(shared.outside_range[race]):
        yield f"the film on the {name} race is extrapolated: its ellipse is not of a shape that was fitted"
    if np.any(shared.capped[race]):
        yield f"the film on the {name} race is as thick as the bodies leave room for: the formula gave more"
