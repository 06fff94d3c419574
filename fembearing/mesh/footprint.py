"""Where a contact is expected, so that the mesh can follow it: an ellipse, cut off at a shoulder of the groove.

An ellipse that ends before the nearer shoulder leaves the contact symmetric, and a quarter of it is meshed. From where
it reaches over, the contact is cut off on that side alone, unless the contact angle is zero: half of it is meshed then,
y < 0 and y > 0.
"""

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from analytic.errors import InputError
from analytic.scene import Contact

Array = NDArray[np.float64]
ROUND_OFF = 1e-9  # of a coordinate
UNCUT = (math.inf, math.inf)
NEARLY = 0.995  # of a semi-axis: an ellipse reaching less far over is meshed as one that does; 1 % off does no harm
MOST_OVERRUN = 3.0  # semi-axis of the mesh over the room: beyond, little of the ellipse is left to follow
STEEPEST = 1.2  # rad, profile angle up to which a groove is meshed as a height over the plane tangent at the contact


@dataclass(frozen=True, kw_only=True)
class Footprint:
    """Semi-axes in m, and how far the contact can reach at y < 0 and at y > 0; inf where the ellipse itself ends it."""

    semi_axes: tuple[float, float]  # along rolling and transverse, m
    room: tuple[float, float] = UNCUT  # m
    half: bool = False  # both sides of y = 0 are meshed, not one

    @property
    def parts(self) -> int:
        """Of the whole contact, as many as are alike: one is meshed."""
        return 2 if self.half else 4

    @property
    def cut(self) -> bool:
        """Whether a shoulder ends the contact on either side."""
        return self.room != UNCUT

    def holds(self, y: Array) -> NDArray[np.bool_]:
        """Whether contact may be at y, m: up to a shoulder and on it."""
        below, above = self.room
        return (-(1 + ROUND_OFF) * below <= y) & (y <= (1 + ROUND_OFF) * above)

    @property
    def ends(self) -> tuple[float, float]:
        """`room` in semi-axes, where it cuts the ellipse off."""
        below, above = (min(room / self.semi_axes[1], NEARLY) if math.isfinite(room) else room for room in self.room)
        return below, above


def footprint_of(contact: Contact, semi_axes: tuple[float, float]) -> Footprint:
    """What the mesh follows for an ellipse of `semi_axes`, m. Raises InputError where a shoulder leaves too little."""
    across = semi_axes[1]
    if across <= contact.shoulder:
        return Footprint(semi_axes=semi_axes)
    if across > MOST_OVERRUN * contact.shoulder:
        raise InputError(
            f"{contact.pair}: {contact.load:g} N spread the contact to {across:.3g} m across, its shoulder stands at "
            f"{contact.shoulder:.3g} m: the mesh holds up to {MOST_OVERRUN:g} times that. Lower the load or the "
            "contact angle, or raise shoulder_half_width"
        )
    further = farther_shoulder(contact)
    room = further if across > further else math.inf
    return Footprint(semi_axes=semi_axes, room=(room, contact.shoulder), half=room != contact.shoulder)


def farther_shoulder(contact: Contact) -> float:
    """Distance to the other shoulder on the plane tangent at the contact's centre, m.

    Two contact angles further round the groove's profile than the nearer one, but no further than `STEEPEST`.
    """
    if contact.shoulder >= contact.groove_radius:
        return contact.shoulder
    nearer = math.asin(contact.shoulder / contact.groove_radius)
    farther = max(nearer, min(nearer + 2 * contact.contact_angle, STEEPEST))
    return contact.shoulder if farther == nearer else contact.groove_radius * math.sin(farther)
