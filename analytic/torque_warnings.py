"""What the reader has to know before using the numbers of a friction torque."""

from collections.abc import Iterator, Mapping

import numpy as np

from analytic.contact import Race, race_curvatures, shoulder_distance
from analytic.equilibrium import ThrustEquilibrium
from analytic.errors import InputError
from analytic.hertz import HertzContact
from analytic.kinematics import BallKinematics
from analytic.lubrication import LubricatedRace
from analytic.race import SlidingContact, sliding_number
from analytic.rolling import RollingResistance
from analytic.roughness import GapRoughness
from analytic.scene import Scene

STATIC_LIMIT = 4.2e9  # Pa, peak pressure that leaves a dent of 1e-4 ball diameters (ISO 76, ball bearings)
LEAST_SLIDING = 3.0  # of the sliding number: below, elastic creep takes a good part of the slip


def doubts(
    scene: Scene,
    balls: ThrustEquilibrium,
    motion: BallKinematics,
    sliding: Mapping[Race, SlidingContact],
    *,
    roughness: GapRoughness | None,
    oiled: Mapping[Race, LubricatedRace],
    resistance: Mapping[Race, RollingResistance],
) -> list[str]:
    """In the order of their weight. Raises InputError for a contact that has left its race."""
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
    if roughness is not None:
        warnings += roughness.warnings
    warnings += _doubts_of_film(oiled)
    for race, found in resistance.items():
        if np.any(found.outside_range):
            warnings.append(
                f"rolling on the {race} race is extrapolated: its formula is for slow rolling of contacts that are "
                "longer across it than along"
            )
    contacts: dict[Race, HertzContact] = {"inner": balls.inner, "outer": balls.outer}
    for race, contact in contacts.items():
        room = shoulder_distance(scene.bearing, race, contact_angle=balls.contact_angle)
        worst = int(np.argmin(room))
        if room[worst] <= 0:
            raise InputError(
                f"operation.axial_load = {scene.operation.axial_load[worst]:g} N: the contact moves to "
                f"{balls.contact_angle[worst]:.4f} rad, beyond the {race} race's shoulder: lower the load, reduce the "
                "clearance or raise shoulder_half_width"
            )
        worst = int(np.argmax(contact.semi_axis_y - room))
        if contact.semi_axis_y[worst] > room[worst]:
            warnings.append(
                f"the contact ellipse passes the {race} race's shoulder: semi-axis {contact.semi_axis_y[worst]:.4g} m, "
                f"room {room[worst]:.4g} m; the true contact is cut off there and its pressure higher"
            )
        peak = float(np.max(contact.peak_pressure))
        if peak > STATIC_LIMIT:
            warnings.append(
                f"peak pressure on the {race} race {peak:.4g} Pa is above the static limit {STATIC_LIMIT:.2g} Pa: "
                "the contact is no longer elastic"
            )
        curvature, _ = race_curvatures(scene.bearing, race, contact_angle=balls.contact_angle)
        creep = sliding_number(
            sliding[race], entrainment_speed=motion.entrainment_speed, curvature_rolling=curvature
        ).min()
        if creep < LEAST_SLIDING:
            warnings.append(
                f"the sliding number of the {race} contact is {creep:.3g}, below {LEAST_SLIDING:g}: elastic creep "
                "takes part of the slip, and spin and conformity come out too large"
            )
    return warnings


def _doubts_of_film(oiled: Mapping[Race, LubricatedRace]) -> Iterator[str]:
    for race, found in oiled.items():
        shared = found.shared
        if np.any(shared.without_film):
            yield (
                f"at standstill the {race} contact has no film and asperities carry all of the load: slow running "
                "need not come to the same, as it may leave a share to the oil"
            )
        if np.any(shared.outside_range):
            yield f"the film on the {race} race is extrapolated: its ellipse is not of a shape that was fitted"
        if np.any(shared.capped):
            yield f"the film on the {race} race is as thick as the bodies leave room for: the formula gave more"
