"""The drag of rubbing seals by SKF's formula: assumed for lack of a measured or declared one.

For both seals of a bearing, with the diameter d_s of the seal's counterface in mm:
    M_seal = K_S1 d_s^beta + K_S2,  N mm
The constants depend on the type of the seals and on the outside diameter. Source: [SKFSeals]. Outside its sizes, and
for other makers' seals, they are assumed: see `DEEP_GROOVE`.
"""

import math

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.catalog.suffixes import Suffix, seal_contact, seal_sides
from analytic.errors import InputError, require_positive

# Type of seal: (outside diameter up to, mm; beta, K_S1, K_S2). RSH touches, RSL touches lightly.
_RS1 = (
    (62.0, 2.25, 0.023, 2.0),
    (80.0, 2.25, 0.018, 20.0),
    (100.0, 2.25, 0.018, 15.0),
    (float("inf"), 2.25, 0.018, 0.0),
)
_RSL = ((25.0, 0.0, 0.0, 0.0), (float("inf"), 2.25, 0.0018, 0.0))  # SKF: up to 52 mm
_ANGULAR = ((float("inf"), 2.0, 0.014, 10.0),)  # SKF: RS1, above 30 up to 120 mm
DEEP_GROOVE = {"RSL": _RSL, "RSH": ((52.0, 2.25, 0.028, 2.0), *_RS1), "RS1": _RS1}  # SKF: RSH up to 52 mm
ANGULAR_CONTACT = {"RSL": _RSL, "RSH": _ANGULAR, "RS1": _ANGULAR}
# Standard deviations of the logarithm, by judgement: seals scatter with maker, grease, speed and wear, and the numbers
# are those of one maker. Evenly within a factor of 2; of light seals, which may barely touch, within a factor of 3.
SPREAD, LIGHT_SPREAD = math.log(2) / 3**0.5, math.log(3) / 3**0.5


def seal_torque(bearing: CatalogBearing, *, counterface: float) -> float:
    """The drag of the seals that the bearing's designation names, N m; 0 if they do not touch.

    counterface : d_s, m, > 0: the diameter that the seals touch, about that of the inner ring's shoulder
    Rubbing seals of other makers, DDU or LLU for example, are taken as SKF's RS1, and light ones as RSL. Of seals on
    one side the drag is half of that of both.
    Raises InputError, in one line, if the designation names no seals.
    """
    require_positive(counterface=counterface)
    if not bearing.seal_suffixes:
        raise InputError(f"{bearing.designation} names no seals to estimate the drag of; leave the key out")
    return sum(_torque(bearing, seals, 1e3 * counterface) for seals in bearing.seal_suffixes)


def seal_spread(bearing: CatalogBearing) -> float:
    """The standard deviation of the logarithm of the drag."""
    contacts = {seal_contact(seals) for seals in bearing.seal_suffixes}
    return SPREAD if "rubs" in contacts else LIGHT_SPREAD


def seal_type(seals: Suffix) -> str | None:
    """SKF's type of seal whose constants hold for a suffix; None: the seals do not touch."""
    contact = seal_contact(seals)
    if contact == "none":
        return None
    if contact == "rubs lightly":
        return "RSL"
    return "RSH" if seals.text.endswith("RSH") else "RS1"


def _torque(bearing: CatalogBearing, seals: Suffix, counterface: float) -> float:
    """counterface : mm"""
    kind, outside = seal_type(seals), 1e3 * bearing.outside
    if kind is None:
        return 0.0
    rows = (DEEP_GROOVE if bearing.kind == "deep groove" else ANGULAR_CONTACT)[kind]
    power, scale, offset = next(constants for up_to, *constants in rows if outside <= up_to)
    return (scale * counterface**power + offset) * seal_sides(seals) / 2 * 1e-3
