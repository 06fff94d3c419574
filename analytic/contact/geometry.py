"""Where a ball meets a race: the geometry of one contact at a contact angle.

The contact angle is measured from the radial plane, and the centre of the contact lies on the groove's profile at that
angle. The transverse direction follows this profile. A radius is positive where the race is convex (inner ring).
Source: [Harris2007] section 2.
"""

from dataclasses import replace
from functools import lru_cache
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.hertz import ball_share, contact_modulus
from analytic.contact.rolling_contact import deformed_radius
from analytic.errors import InputError, require_non_negative
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import formula
from analytic.scene import Array, Bearing, Cage, Contact, Groove, Ring, Wall
from analytic.words import angle_of, length_of

Race = Literal["inner", "outer"]
RACES: tuple[Race, Race] = ("inner", "outer")
# Lowest, typical and highest height of a shoulder over the ball's diameter. Shoulder diameters that GMN and SKF print
# give 0.19 +- 0.03 in 29 deep-groove bearings; 0.1 is below all of them.
USUAL_SHOULDERS = (0.1, 0.19, 0.25)


class RaceNumbers(NamedTuple):
    """A ball on one race of a bearing in numbers, for compiled formulas."""

    side: float  # 1: inner race, which is convex in the direction of rolling; -1: outer race
    ball_radius: float  # r, m
    pitch_diameter: float  # d_m, m
    groove_radius: float  # r_g, m
    curvature_transverse: float  # 1/r - 1/r_g, 1/m
    modulus: float  # E*, Pa
    deformed_radius: float  # R, of the contact surface, m
    bottom_angle: float  # of the groove's bottom to the radial plane, rad: 0, in a thrust bearing pi/2
    near_shoulder: float  # angle on the profile from the bottom to the near shoulder, rad; NaN: not known
    far_shoulder: float  # likewise to the far one
    ball_poisson_ratio: float
    race_poisson_ratio: float
    ball_share: float  # of the ball in the compliance 1/E*


@lru_cache(maxsize=64)
def race_numbers(bearing: Bearing, race: Race) -> RaceNumbers:
    """The numbers of a race; raises InputError if the groove is no wider than the ball."""
    groove, ball, radius = _groove(bearing, race), bearing.ball_material, bearing.ball_radius
    near, far = (
        np.nan if width is None else float(np.arcsin(width / groove.groove_radius)) for width in groove.half_widths
    )
    numbers = RaceNumbers(
        side=1.0 if race == "inner" else -1.0,
        ball_radius=radius,
        pitch_diameter=bearing.pitch_diameter,
        groove_radius=groove.groove_radius,
        curvature_transverse=(groove.groove_radius - radius) / (radius * groove.groove_radius),
        modulus=contact_modulus(ball, groove.material),
        deformed_radius=deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter),
        bottom_angle=np.pi / 2 if bearing.kind == "thrust" else 0.0,
        near_shoulder=near,
        far_shoulder=far,
        ball_poisson_ratio=ball.poisson_ratio,
        race_poisson_ratio=groove.material.poisson_ratio,
        ball_share=ball_share(ball, groove.material),
    )
    return RaceNumbers(*map(float, numbers))  # a kernel would be compiled anew for an integer


@compiled
def curvature_of_race(race: RaceNumbers, contact_angle: float) -> float:
    """Curvature of the race in the direction of rolling at the contact's centre, 1/m; positive on the inner race.

    contact_angle : al, rad, in [-pi/2, pi/2]
    """
    flat = abs(contact_angle) >= np.pi / 2
    cosine = 0.0 if flat else np.cos(contact_angle)
    return race.side * cosine / (race.pitch_diameter / 2 - race.side * race.ball_radius * cosine)


@formula
def rolling_curvature(race: RaceNumbers, contact_angle: float) -> float:
    """Relative curvature 1/R_x of ball and race in the direction of rolling, 1/m; al in [-pi/2, pi/2], rad.

    1/r + cos(al)/(d_m/2 - r cos(al)) on the inner race, 1/r - cos(al)/(d_m/2 + r cos(al)) on the outer
    """
    return 1 / race.ball_radius + curvature_of_race(race, contact_angle)


@formula
def distances_to_shoulders(
    race: RaceNumbers, shoulders: tuple[float, float], contact_angle: float
) -> tuple[float, float]:
    """Distances from the contact's centre to both shoulders in the tangent plane, m.

    shoulders : angles asin(w/r_g) of the near and the far one on the profile from the groove's bottom, rad, where w is
        the half-width of the groove
    contact_angle : al, rad, in [-pi/2, pi/2]; negative where a moment presses the ball on the far side of the groove;
        pi/2 in a thrust bearing, whose balls touch the bottom of the groove
    First the shoulder that the contact has moved towards, then the other: r_g sin(asin(w/r_g) -+ |al|), at most r_g. If
    one is negative, the centre lies beyond that shoulder.
    """
    near, far = shoulders
    angle = abs(contact_angle) - race.bottom_angle
    towards, away = (far, near) if contact_angle < 0 else (near, far)
    return (race.groove_radius * np.sin(towards - angle), race.groove_radius * np.sin(min(away + angle, np.pi / 2)))


@compiled
def cut_off_share(distance: float, semi_axis: float) -> float:
    """Share of an ellipse's load beyond a line across it: (2 - 3 t + t^3)/4, t = distance/semi_axis up to 1.

    distance : of the line from the centre, m, >= 0;  semi_axis : b, to which the line is perpendicular, m, > 0
    Hertz's pressure, integrated along rolling, is a parabola over b.
    """
    t = min(distance, semi_axis) / semi_axis
    return (1 - t) ** 2 * (2 + t) / 4


def race_curvatures(bearing: Bearing, race: Race, *, contact_angle: ArrayLike) -> tuple[Array, Array]:
    """Relative curvatures (rolling, transverse) of ball on race, 1/m, each with the shape of contact_angle.

    contact_angle : al, rad, in [0, pi/2]; pi/2 in a thrust bearing
    Along rolling as `rolling_curvature`; transverse 1/r - 1/r_g.
    Raises InputError if contact_angle is out of its range or the groove is no wider than the ball.
    """
    angle, numbers = require_contact_angle(bearing, contact_angle), race_numbers(bearing, race)
    return rolling_curvature(numbers, angle), np.full_like(angle, numbers.curvature_transverse)


def shoulder_distances(bearing: Bearing, race: Race, *, contact_angle: ArrayLike) -> tuple[Array, Array]:
    """`distances_to_shoulders` of a race, m; NaN where the half-width is not known. Raises as race_curvatures."""
    require_contact_angle(bearing, np.abs(contact_angle))
    numbers = race_numbers(bearing, race)
    return distances_to_shoulders(numbers, (numbers.near_shoulder, numbers.far_shoulder), contact_angle)


def with_shoulders(bearing: Bearing, height: float) -> Bearing:
    """The same with shoulders of a height, over the ball's diameter, where they are not known; itself if they are."""
    if bearing.inner.shoulder_half_width is not None and bearing.outer.shoulder_half_width is not None:
        return bearing

    def completed(groove: Groove) -> Groove:
        if groove.shoulder_half_width is not None:
            return groove
        bottom = groove.groove_radius - height * bearing.ball_diameter  # of the profile's centre over the shoulder
        return replace(groove, shoulder_half_width=float(np.sqrt(groove.groove_radius**2 - bottom**2)))

    return replace(bearing, inner=completed(bearing.inner), outer=completed(bearing.outer))


def known_half_widths(bearing: Bearing, race: Race) -> tuple[float, float]:
    """Middle of the groove to the near and to the far shoulder, m. Raises InputError where they are not known."""
    near, far = _groove(bearing, race).half_widths
    if near is None or far is None:
        low, high = (round(1e3 * share * bearing.ball_diameter, 2) for share in (0.15, 0.25))
        unknown = [each for each in RACES if None in _groove(bearing, each).half_widths]
        keys = " and ".join(f"bearing.{each}.shoulder_height" for each in unknown)
        raise InputError(
            f"the heights of the shoulders of the {' and the '.join(unknown)} ring are not known: give {keys}, usual "
            f'are 0.15 to 0.25 of the ball diameter, "{low:g} mm" to "{high:g} mm"'
        )
    return near, far


def race_contact(bearing: Bearing, race: Race, *, contact_angle: float, ball_load: float) -> Contact:
    """One ball on one race, as an elastic solution needs it.

    contact_angle : al, rad, in [-pi/2, pi/2]; see `shoulder_distances`
    ball_load : Q, N, >= 0
    Raises InputError if an argument is out of range, if the shoulders are not known, or if the contact's centre lies at
    or beyond one of them.
    """
    require_non_negative(ball_load=ball_load)
    angle = require_contact_angle(bearing, abs(contact_angle))
    groove = _groove(bearing, race)
    near, far = known_half_widths(bearing, race)
    half_widths = (far, near) if contact_angle < 0 else (near, far)
    shoulder, far_shoulder = map(float, shoulder_distances(bearing, race, contact_angle=contact_angle))
    for distance, half_width in zip((shoulder, far_shoulder), half_widths, strict=True):
        if distance <= 0:
            shoulder_angle = float(np.arcsin(half_width / groove.groove_radius))
            raise InputError(
                f"contact_angle {angle_of(contact_angle)} is beyond the {race} race's shoulder at "
                f"{angle_of(shoulder_angle)} (half-width {length_of(half_width)} of a groove of radius "
                f"{length_of(groove.groove_radius)}): "
                "lower the load, reduce the clearance or raise shoulder_half_width"
            )
    curvature = float(curvature_of_race(race_numbers(bearing, race), float(angle)))
    return Contact(
        pair=race,
        ball_radius=bearing.ball_radius,
        groove_radius=groove.groove_radius,
        rolling_radius=1 / curvature if curvature else np.inf,
        shoulder=shoulder,
        far_shoulder=far_shoulder,
        contact_angle=float(angle),
        load=float(ball_load),
        ball_material=bearing.ball_material,
        race_material=groove.material,
        ring=_ring(bearing, race, half_widths),
    )


def pocket_contact(bearing: Bearing, cage: Cage, *, load: float) -> Contact:
    """A ball in its cage pocket: a sphere in a spherical seat, loaded along the pocket's axis.

    load : N, >= 0
    Raises InputError if the load is out of range or the pocket is not wider than the ball.
    """
    require_non_negative(load=load)
    radius = cage.pocket_diameter / 2
    if not radius > bearing.ball_radius:
        raise InputError(
            f"pocket_diameter {cage.pocket_diameter!r} m must exceed ball_diameter {bearing.ball_diameter!r} m: "
            "the ball needs clearance"
        )
    rim = float(np.sqrt(radius**2 - (radius - cage.pocket_depth) ** 2))
    return Contact(
        pair="pocket",
        ball_radius=bearing.ball_radius,
        groove_radius=radius,
        rolling_radius=-radius,
        shoulder=rim,
        far_shoulder=rim,
        contact_angle=0.0,
        load=float(load),
        ball_material=bearing.ball_material,
        race_material=cage.material,
        wall=Wall(thickness=cage.wall_thickness, depth=cage.pocket_depth),
    )


def _ring(bearing: Bearing, race: Race, half_widths: tuple[float, float]) -> Ring | None:
    """The ring behind the groove; None if its seat or width is not known, and for a washer."""
    groove = _groove(bearing, race)
    seat = bearing.bore_diameter if race == "inner" else bearing.outside_diameter
    if seat is None or bearing.width is None or bearing.kind == "thrust":
        return None
    return Ring(
        bottom_radius=groove.bottom_radius, seat_radius=seat / 2, width=bearing.width, shoulder_half_widths=half_widths
    )


def require_contact_angle(bearing: Bearing, contact_angle: ArrayLike) -> Array:
    """Contact angles as an array; raises InputError unless they lie in [0, pi/2] rad, in a thrust bearing at pi/2."""
    require_non_negative(contact_angle=contact_angle)
    angle = np.asarray(contact_angle, dtype=np.float64)
    if np.any(angle > np.pi / 2):
        raise InputError(f"contact_angle must be at most pi/2 rad, got {float(angle.max())!r}; is it in degrees?")
    if bearing.kind == "thrust" and np.any(angle < np.pi / 2):
        raise InputError(
            f"a thrust bearing has a contact angle of 90 degrees, got {angle_of(float(angle.min()))}: give pi/2 rad"
        )
    return angle


def _groove(bearing: Bearing, race: Race) -> Groove:
    """The groove of the race; raises InputError if ball and groove do not meet in a point contact."""
    if race not in ("inner", "outer"):
        raise InputError(f'race must be "inner" or "outer", got {race!r}')
    groove = bearing.inner if race == "inner" else bearing.outer
    if not groove.groove_radius > bearing.ball_radius > 0:
        raise InputError(
            f"{race} groove_radius {length_of(groove.groove_radius, '.6g')} must exceed the ball radius "
            f"{length_of(bearing.ball_radius, '.6g')}: "
            "at conformity 0.5 the contact is a line, not a point; usual are 0.51 to 0.54 ball diameters"
        )
    near, far = groove.shoulder_half_width, groove.far_shoulder_half_width
    if near is not None and not 0 < near < groove.groove_radius:
        raise InputError(
            f"{race} shoulder_half_width {length_of(near)} must lie between 0 and groove_radius "
            f"{length_of(groove.groove_radius)}"
        )
    if far is not None and not 0 <= far < groove.groove_radius:
        raise InputError(
            f"{race} far_shoulder_half_width {length_of(far)} must be at least 0, which is a counterbored ring, and "
            f"below groove_radius {length_of(groove.groove_radius)}"
        )
    return groove
