"""Where a ball lies between its grooves, and the forces across them. Coordinates are radial and axial."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from scipy.optimize import brentq

from analytic.contact.geometry import RACES, Race, race_curvatures, race_numbers
from analytic.contact.hertz import hertz_contact
from analytic.scene import Array, Bearing

LEAST_ANGLE, MOST_ANGLE = 1e-5, 1.55  # rad, between which a thrust finds its angle
LAST_STEP = 1e-10  # rad


class UnitContact(NamedTuple):
    """A contact under 1 N."""

    semi_axis_rolling: float  # m
    semi_axis_transverse: float  # m
    approach: float  # m


class Lie(NamedTuple):
    """How a ball lies: on inner and outer race."""

    angles: tuple[float, float]  # al, rad
    loads: tuple[float, float]  # Q, N; 0 without contact
    orbit: float  # r_m, m


def unit_under(bearing: Bearing, race: Race, angle: float) -> UnitContact:
    """A contact at a contact angle, rad, in [-pi/2, pi/2], by Hertz."""
    along, across = race_curvatures(bearing, race, contact_angle=abs(angle))
    modulus = race_numbers(bearing, race).modulus
    unit = hertz_contact(curvature_x=along, curvature_y=across, load=1.0, modulus=modulus)
    return UnitContact(float(unit.semi_axis_x), float(unit.semi_axis_y), float(unit.approach))


def free_lengths(bearing: Bearing) -> tuple[float, float]:
    """r_g - r of the inner and the outer groove, m: from the centres of both to that of a ball without load."""
    return bearing.inner.groove_radius - bearing.ball_radius, bearing.outer.groove_radius - bearing.ball_radius


@dataclass(frozen=True, kw_only=True)
class HeldBall:
    """What holds a ball: thrust on a ring that is free along the axis, or a ring in its place, or a given angle."""

    bearing: Bearing
    centre: float  # radius of the circle on which the outer groove's centre of curvature lies, m
    thrust: float  # Fa/Z, N, > 0; without a part where the ring is held
    radial: float | None = None  # centre of the inner groove over that of the outer one, m; None: `angle` is given
    axial: float | None = None  # likewise along the axis, m; None: the thrust places the ring
    angle: float | None = None  # al, given, rad

    def at_rest(self) -> Lie:
        """Without friction.

        Returns
        -------
        Lie
            Equal angles and loads on both races.
        """
        angle = self._angle_at_rest()
        approaches = [unit_under(self.bearing, race, angle).approach for race in RACES]
        if self.axial is None:
            load = self.thrust / float(np.sin(angle))
        else:
            stretch = np.hypot(self.radial or 0.0, self.axial) - sum(free_lengths(self.bearing))
            load = float(max(stretch, 0.0) / sum(approaches)) ** 1.5
        orbit = self.centre + (free_lengths(self.bearing)[1] + approaches[1] * load ** (2 / 3)) * np.cos(angle)
        return Lie((angle, angle), (load, load), float(orbit))

    def _angle_at_rest(self) -> float:
        radial = self.radial
        if radial is None:
            return self.angle or 0.0
        if self.axial is not None:
            return float(np.arctan2(self.axial, radial))

        def too_short(angle: float) -> float:
            load = self.thrust / np.sin(angle)
            reach = sum(unit_under(self.bearing, race, angle).approach for race in RACES) * load ** (2 / 3) + sum(
                free_lengths(self.bearing)
            )
            return radial - reach * np.cos(angle)

        return float(brentq(too_short, LEAST_ANGLE, MOST_ANGLE, xtol=LAST_STEP))

    def coordinates(self, lie: Lie, units: tuple[UnitContact, UnitContact]) -> Array:
        """What a search moves.

        Parameters
        ----------
        lie : Lie
            How the ball lies.
        units : tuple of UnitContact
            Its contacts.

        Returns
        -------
        ndarray
            Ball over the outer groove's centre, radial and axial, then, under thrust, that of the inner groove along
            the axis, m; empty where the angle is given.
        """
        if self.radial is None:
            return np.zeros(0)
        reach = [
            length + unit.approach * load ** (2 / 3)
            for length, unit, load in zip(free_lengths(self.bearing), units, lie.loads, strict=True)
        ]
        ball = reach[1] * np.cos(lie.angles[1]), reach[1] * np.sin(lie.angles[1])
        ring = [] if self.axial is not None else [ball[1] + reach[0] * np.sin(lie.angles[0])]
        return np.array([*ball, *ring])

    def moved(self, place: Array, step: Array) -> Array:
        """Its coordinates after a step of a search.

        Under thrust the ball and the ring move round the grooves' centres of curvature: along a straight line the
        arms would grow by the square of the step, which exceeds the approach of a light contact.

        Parameters
        ----------
        place, step : ndarray
            Of `coordinates` and their change, m.

        Returns
        -------
        ndarray
            New coordinates, m, equal to place + step to first order.
        """
        straight = place + step
        if self.radial is None or self.axial is not None:
            return straight
        outer, inner = np.array(place[:2]), np.array([self.radial - place[0], place[2] - place[1]])
        size, inner_size = float(np.hypot(*outer)), float(np.hypot(*inner))
        longer = size + float(outer @ step[:2]) / size
        turned = np.arctan2(outer[1], outer[0]) + float(outer[0] * step[1] - outer[1] * step[0]) / size**2
        ball = longer * np.cos(turned), longer * np.sin(turned)
        reach = inner_size + float(inner @ [-step[0], step[2] - step[1]]) / inner_size
        square = (reach - (self.radial - ball[0])) * (reach + (self.radial - ball[0]))
        if square <= 0:  # too far for this
            return straight
        return np.array([*ball, ball[1] + np.copysign(np.sqrt(square), inner[1])])

    def lie(self, place: Array, units: tuple[UnitContact, UnitContact]) -> Lie:
        """How the ball lies at its coordinates.

        Parameters
        ----------
        place : ndarray
            Of `coordinates`, m.
        units : tuple of UnitContact
            Its contacts.

        Returns
        -------
        Lie
            Angles and loads.
        """
        if self.radial is None:
            return self.at_rest()
        ring = place[2] if self.axial is None else self.axial
        arms = (self.radial - place[0], ring - place[1]), (place[0], place[1])
        loads = tuple(
            max((np.hypot(*arm) - length) / unit.approach, 0.0) ** 1.5
            for arm, length, unit in zip(arms, free_lengths(self.bearing), units, strict=True)
        )
        angles = tuple(float(np.arctan2(arm[1], arm[0])) for arm in arms)
        return Lie((angles[0], angles[1]), (float(loads[0]), float(loads[1])), self.centre + float(place[0]))

    def lacks(self, lie: Lie, across: tuple[float, float], outward: float) -> Array:
        """What the equilibrium of forces lacks.

        Parameters
        ----------
        lie : Lie
            How the ball lies.
        across : tuple of float
            Friction on the ball across both grooves, N.
        outward : float
            Centrifugal force, N.

        Returns
        -------
        ndarray
            Of the ball, radial and axial, and under thrust of the inner ring along the axis, N.
        """
        if self.radial is None:
            return np.zeros(0)
        (inner, outer), (q_i, q_o), (t_i, t_o) = lie.angles, lie.loads, across
        push = q_i * np.sin(inner) - t_i * np.cos(inner)
        ball = [
            q_i * np.cos(inner) + t_i * np.sin(inner) - q_o * np.cos(outer) - t_o * np.sin(outer) + outward,
            push - q_o * np.sin(outer) + t_o * np.cos(outer),
        ]
        return np.array(ball if self.axial is not None else [*ball, push - self.thrust])
