"""A bearing in the numbers that compiled formulas take, and its play."""

from typing import NamedTuple

import numpy as np

from analytic.contact.geometry import RACES, RaceNumbers, race_numbers
from analytic.errors import InputError, require_non_negative
from analytic.scene import Bearing, ContactAngle
from analytic.words import MILLIMETRE


class BearingNumbers(NamedTuple):
    """A bearing at rest, without load."""

    inner: RaceNumbers
    outer: RaceNumbers
    ball_count: float  # Z
    ball_mass: float  # kg
    ball_radius: float  # r, m
    pitch_diameter: float  # d_m, m
    groove_centre_distance: float  # A0, m
    play: float  # A0 (1 - cos al0), m; negative is preload; NaN where the contact angle is given
    free_angle: float  # al0, rad; NaN: a preload has none, and a given contact angle needs none
    given_angle: float  # al, rad, under any load; NaN: solved


def bearing_numbers(bearing: Bearing, contact_angle: ContactAngle | None = None) -> BearingNumbers:
    """The numbers of a bearing; None leaves the contact angle and the play open (NaN).

    Raises InputError as play_and_free_angle does, and if a groove is no wider than the ball.
    """
    races = race_numbers(bearing, "inner"), race_numbers(bearing, "outer")
    play, free, given = np.nan, None, None
    if contact_angle is not None and contact_angle.rule == "given":
        given = contact_angle.value
    elif contact_angle is not None:
        play, free = play_and_free_angle(bearing, contact_angle)
    return BearingNumbers(
        *races,
        ball_count=float(bearing.ball_count),
        ball_mass=float(bearing.ball_mass),
        ball_radius=float(bearing.ball_radius),
        pitch_diameter=float(bearing.pitch_diameter),
        groove_centre_distance=float(bearing.groove_centre_distance),
        play=float(play),
        free_angle=np.nan if free is None else float(free),
        given_angle=np.nan if given is None else float(given),
    )


def free_angle(bearing: Bearing) -> float | None:
    """al0, rad: the contact angle at which play ends and load begins; None for a preloaded bearing.

    cos al0 = 1 - P_d/(2 A0), written 2 sin^2(al0/2) = P_d/(2 A0) to stay exact at small clearance.
    Raises InputError if a groove is no wider than the ball, or if P_d >= 2 A0 (nothing stops the rings).
    """
    for race in RACES:
        race_numbers(bearing, race)  # refuses an impossible groove
    clearance, distance = bearing.diametral_clearance, bearing.groove_centre_distance
    if clearance < 0:
        return None
    if not clearance < 2 * distance:
        raise InputError(
            f"diametral clearance {MILLIMETRE.written(clearance, '.6g')} must be below 2 A0 = "
            f"{MILLIMETRE.written(2 * distance, '.6g')} (A0 = r_gi + r_go - D): check bottom_radius of both rings and "
            "ball_diameter"
        )
    return float(2 * np.arcsin(np.sqrt(clearance / (4 * distance))))


def play_and_free_angle(bearing: Bearing, contact_angle: ContactAngle) -> tuple[float, float | None]:
    """(A0 (1 - cos al0), al0) in m and rad: from contact_angle.free, or else from the clearance.

    A preload has no al0 and a play of P_d/2 < 0. Raises InputError as free_angle does, and for an angle out of range.
    """
    free = contact_angle.free
    if free is None:
        return bearing.diametral_clearance / 2, free_angle(bearing)
    require_non_negative(free=free)
    if not free < np.pi / 2:
        raise InputError(f"the free contact angle must be below pi/2 rad, got {free!r}; is it in degrees?")
    return float(2 * bearing.groove_centre_distance * np.sin(free / 2) ** 2), free
