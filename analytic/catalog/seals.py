"""The drag of rubbing seals by SKF's formula: an estimate for lack of a measured or declared one.

For both seals of a bearing, with the diameter d_s of the seal's counterface in mm:
    M_seal = K_S1 d_s^beta + K_S2,  N mm
The constants depend on the type of the seals and on the outside diameter. Source: [SKFSeals].
"""

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.catalog.suffixes import Suffix, seal_contact, seal_sides
from analytic.errors import InputError, require_positive

# Type of seal: (outside diameter above, up to, mm; beta, K_S1, K_S2). RSH touches, RSL touches lightly.
DEEP_GROOVE = {
    "RSL": ((0.0, 25.0, 0.0, 0.0, 0.0), (25.0, 52.0, 2.25, 0.0018, 0.0)),
    "RSH": ((0.0, 52.0, 2.25, 0.028, 2.0),),
    "RS1": (
        (0.0, 62.0, 2.25, 0.023, 2.0),
        (62.0, 80.0, 2.25, 0.018, 20.0),
        (80.0, 100.0, 2.25, 0.018, 15.0),
        (100.0, float("inf"), 2.25, 0.018, 0.0),
    ),
}
ANGULAR_CONTACT = {"RS1": ((30.0, 120.0, 2.0, 0.014, 10.0),)}


def seal_torque(bearing: CatalogBearing, *, counterface: float) -> float:
    """The drag of the seals that the bearing's designation names, N m; 0 if they do not touch.

    counterface : d_s, m, > 0: the diameter that the seals touch, about that of the inner ring's shoulder
    Rubbing seals of other makers, DDU or LLU for example, are taken as SKF's RS1, and light ones as RSL. Of seals on
    one side the drag is half of that of both.
    Raises InputError, in one line, if the designation names no seals, or if SKF has no constants for them at this size.
    """
    require_positive(counterface=counterface)
    if not bearing.seal_suffixes:
        raise InputError(f"{bearing.designation} names no seals to estimate the drag of; leave the key out")
    return sum(_torque(bearing, seals, 1e3 * counterface) for seals in bearing.seal_suffixes)


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
    for above, up_to, power, scale, offset in _table(bearing).get(kind, ()):
        if above < outside <= up_to:
            both = scale * counterface**power + offset
            return both * seal_sides(seals) / 2 * 1e-3
    sizes = " and ".join(f"{above:g} to {up_to:g} mm" for above, up_to, *_ in _table(bearing).get(kind, ()))
    has = f"has constants for {sizes} alone" if sizes else "has no constants"
    raise InputError(
        f"the drag of {seals.text} cannot be estimated: SKF {has} for {kind} seals of {bearing.kind} bearings, and "
        f"{bearing.designation} has an outside diameter of {outside:g} mm; declare the drag, for example 5 N mm"
    )


def _table(bearing: CatalogBearing) -> dict[str, tuple[tuple[float, float, float, float, float], ...]]:
    return DEEP_GROOVE if bearing.kind == "deep groove" else ANGULAR_CONTACT
