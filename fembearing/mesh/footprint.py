"""The expected contact, which the mesh follows: an ellipse, cut off at a shoulder of the groove.

Where the ellipse ends before the nearer shoulder, a quarter of it is meshed by default, with that shoulder on both
sides. A longer ellipse is cut off where it reaches a shoulder: half of it is meshed, y < 0 and y > 0, unless both
shoulders are equally near.
"""

import math
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from analytic.errors import InputError
from analytic.scene import Array, Contact
from analytic.words import length_of

ROUND_OFF = 1e-9  # of a coordinate
UNCUT = (math.inf, math.inf)
NEARLY = 0.995  # largest shoulder distance in the mesh, in semi-axes; an error of 1 % in the mesh does no harm
# Which side of y = 0 a quarter has; "mean": the mean of both quarters; "both": no quarter, half of the contact
Sides = Literal["mean", "even", "above", "below", "both"]
MOST_OVERRUN = 3.0  # semi-axis of the mesh over the shoulder distance; beyond, too little of the ellipse is left


@dataclass(frozen=True, kw_only=True)
class Footprint:
    """Semi-axes of the expected ellipse, and the distances of the shoulders that cut it off."""

    semi_axes: tuple[float, float]  # rolling and transverse, m
    shoulders: tuple[float, float] = UNCUT  # m, at y < 0 and at y > 0; inf where the ellipse ends before the shoulder
    half: bool = False  # whether both sides of y = 0 are meshed

    @property
    def parts(self) -> int:
        """Number of equal parts of the contact, of which one is meshed."""
        return 2 if self.half else 4

    @property
    def cut(self) -> bool:
        """Whether a shoulder ends the contact on either side."""
        return self.shoulders != UNCUT

    def holds(self, y: Array) -> NDArray[np.bool_]:
        """Whether contact is possible at a place: up to a shoulder and on it.

        Parameters
        ----------
        y : ndarray, any shape
            Transverse place, m.

        Returns
        -------
        ndarray of bool
            Of the shape of y.
        """
        below, above = self.shoulders
        return (-(1 + ROUND_OFF) * below <= y) & (y <= (1 + ROUND_OFF) * above)

    @property
    def ends(self) -> tuple[float, float]:
        """`shoulders` in semi-axes, below 1 where they cut the ellipse off."""
        below, above = (
            min(shoulder / self.semi_axes[1], NEARLY) if math.isfinite(shoulder) else shoulder
            for shoulder in self.shoulders
        )
        return below, above


def footprint_of(contact: Contact, semi_axes: tuple[float, float]) -> Footprint:
    """The footprint of an ellipse of `semi_axes`, m. Raises InputError where a shoulder leaves too little of it."""
    transverse, nearer = semi_axes[1], contact.nearer_shoulder
    if transverse > MOST_OVERRUN * nearer:
        raise InputError(
            f"{contact.pair}: {contact.load:g} N spread the contact to {length_of(transverse)} across, its shoulder "
            f"stands at {length_of(nearer)}: the mesh holds up to {MOST_OVERRUN:g} times that. Lower the load or the "
            "contact angle, or raise shoulder_half_width"
        )
    below, above = (distance if transverse > distance else math.inf for distance in shoulders_of(contact))
    return Footprint(semi_axes=semi_axes, shoulders=(below, above), half=below != above)


def shoulders_of(contact: Contact) -> tuple[float, float]:
    """Distances of the shoulders at y < 0 and at y > 0, m."""
    return contact.far_shoulder, contact.shoulder


def is_symmetric(contact: Contact) -> bool:
    """Whether both sides of y = 0 are mirror images: at a contact angle they are not even with equal shoulders."""
    return contact.shoulder == contact.far_shoulder and contact.tilt == 0


def as_quarter(contact: Contact, sides: Sides) -> Contact:
    """The contact whose side y > 0 a quarter has.

    "above" and "below": the true sides; otherwise the nearer shoulder, and a land parallel to the tangent plane
    """
    if sides == "above":
        return contact
    if sides == "below":
        mirrored = {"shoulder": contact.far_shoulder, "far_shoulder": contact.shoulder}
        return replace(contact, **mirrored, contact_angle=-contact.contact_angle)
    nearer = contact.nearer_shoulder
    return replace(contact, shoulder=nearer, far_shoulder=nearer, contact_angle=0.0)
