"""What follows from the keys of a scene: rules, each with what it needs, what it gives, and where that comes from.

They run after the catalogue has filled what nobody gives, and before the scene is made. A rule fires where everything
that it needs is there and what it gives is not, so that a value that a user gives always stays.
"""

import math
from collections.abc import Callable, Iterator
from operator import add, mul, sub
from typing import Any, NamedTuple

import numpy as np

from analytic import catalog
from analytic.catalog.bearing_rows import clearance_group
from analytic.quantity import in_si
from analytic.scene import Origin
from analytic.scenefile.keys import RINGS, Values

SPAN = 12**0.5  # of a uniform distribution, over its standard deviation
ANGLE_SPREAD = np.radians(1.5)  # standard deviation of a nominal contact angle; judgement, no tolerance was read
RMS_OVER_RA = math.sqrt(math.pi / 2)  # Sq/Ra of gaussian heights: E|z| = sigma sqrt(2/pi)
BALL_RA = 0.020e-6  # m: limit of grade 10 of ISO 3290 [ISO3290], of balls in common bearings
BALL, PITCH = "bearing.ball_diameter", "bearing.pitch_diameter"
BOTTOMS = tuple(f"bearing.{ring}.bottom_radius" for ring in RINGS)
PROFILES = tuple(f"bearing.{ring}.groove_radius" for ring in RINGS)
GAP = "bearing.diametral_clearance"  # no key of a file: the length that clearance, its group or an angle gives


# Keys that say the same: the scene has one of each line. A value that is given takes the place of the others.
RIVALS = (
    ("bearing.clearance", "bearing.contact_angle.nominal", "bearing.contact_angle.free"),
    *(
        tuple(f"bearing.{ring}.{key}" for key in keys)
        for ring in RINGS
        for keys in (
            ("groove_radius", "conformity"),
            ("shoulder_half_width", "shoulder_height", "shoulder_diameter"),
            ("far_shoulder_half_width", "far_shoulder_height", "far_shoulder_diameter"),
        )
    ),
    ("cage.pocket_clearance", "cage.pocket_diameter"),
    ("surface.rms_roughness", "surface.Ra", "surface.finish", "surface.height_map.path"),
)


def rivals_of(key: str) -> tuple[str, ...]:
    """The keys that say the same as this one."""
    return tuple(other for keys in RIVALS if key in keys for other in keys if other != key)


class Rule(NamedTuple):
    """One way to a value."""

    needs: tuple[str, ...]
    gives: str
    function: Callable[..., Any]  # of what it needs; None: it does not apply
    origin: Callable[..., Origin] | None = None  # of the same; None: that of what it needs


def apply_rules(values: Values) -> None:
    """Apply the rules, in their order; `values.origins` then has where they say that values come from."""
    for rule in RULES:
        needed = [values[path] for path in rule.needs]
        if values[rule.gives] is not None or any(each is None for each in needed):
            continue
        value = rule.function(*needed)
        if value is not None:
            values[rule.gives] = value
            if rule.origin is not None:
                values.origins[rule.gives] = rule.origin(*needed)


def _middle(group: object, bore: float) -> float | None:
    return sum(clearance_group(bore, group)) / 2 if isinstance(group, str) else None


def _of_group(group: str, bore: float) -> Origin:
    low, high = clearance_group(bore, group)
    words = f"middle of the group {group} of [ISO5753], {low * 1e6:g} to {high * 1e6:g} um, unmounted"
    return Origin(status="printed", uncertainty=(high - low) / SPAN, source=words)


def _closing(angle: float, inner: float, outer: float, ball: float) -> float:
    """The clearance that closes at an unloaded contact angle: 2 A_0 (1 - cos(angle))."""
    return float(2 * (inner + outer - ball) * (1 - np.cos(angle)))


def _of_angle(angle: float, inner: float, outer: float, ball: float) -> Origin:
    spread = float(2 * (inner + outer - ball) * np.sin(angle) * ANGLE_SPREAD)
    words = f"closes at the unloaded contact angle of {np.degrees(angle):.4g} deg"
    return Origin(status="derived", uncertainty=spread, source=words)


def _half_width(height: float, profile: float) -> float | None:
    return math.sqrt(height * (2 * profile - height)) if 0 <= height < profile else None


def _shoulders(ring: str, bottom: str, profile: str, height: Callable[[float, float], float]) -> Iterator[Rule]:
    """Of both shoulders of a ring; height : of a shoulder by its radius and that of the bottom"""
    for near in ("", "far_"):
        diameter = f"{ring}.{near}shoulder_diameter", bottom
        yield Rule(diameter, f"{ring}.{near}shoulder_height", lambda wide, low: height(wide / 2, low))
        yield Rule((f"{ring}.{near}shoulder_height", profile), f"{ring}.{near}shoulder_half_width", _half_width)


def _of_ra(_ra: float) -> Origin:
    return Origin(status="given", uncertainty=None, source="Ra of the scene, gaussian heights: Sq = Ra sqrt(pi/2)")


def _rms_of_finish(finish: str) -> float:
    return in_si(catalog.rows("finishes")[finish]["Ra [um]"], "um") * RMS_OVER_RA


def _of_finish(finish: str) -> Origin:
    row = catalog.rows("finishes")[finish]
    low, high = (in_si(row[f"{column} [um]"], "um") for column in ("low", "high"))
    deviation = (high - low) / 2 / math.sqrt(3) * RMS_OVER_RA
    return Origin(status="assumed", uncertainty=deviation, source=f"finish {finish!r}: {row['source']}")


def _of_grade(_finish: str) -> Origin:
    source = "Ra of grade 10 of ISO 3290, 0.020 um, the limit for its balls [ISO3290]"
    return Origin(status="assumed", uncertainty=None, source=source)


RULES = (
    *(Rule((f"bearing.{ring}.conformity", BALL), f"bearing.{ring}.groove_radius", mul) for ring in RINGS),
    *(Rule(("bearing.conformity", BALL), profile, mul) for profile in PROFILES),
    # The grooves of a thrust bearing lie on the circle of its ball centres.
    *(
        Rule(("bearing.kind", PITCH), bottom, lambda kind, pitch: pitch / 2 if kind == "thrust" else None)
        for bottom in BOTTOMS
    ),
    Rule((*BOTTOMS, BALL), GAP, lambda inner, outer, ball: 2 * (outer - inner - ball)),
    Rule(("bearing.clearance",), GAP, lambda given: given if isinstance(given, float) else None),
    Rule(("bearing.clearance", "bearing.bore_diameter"), GAP, _middle, _of_group),
    *(
        Rule((f"bearing.contact_angle.{name}", *PROFILES, BALL), GAP, _closing, _of_angle)
        for name in ("nominal", "free", "value")
    ),
    Rule((PITCH, BALL, GAP), BOTTOMS[0], lambda pitch, ball, gap: (pitch - (ball + gap / 2)) / 2),
    Rule((PITCH, BALL, GAP), BOTTOMS[1], lambda pitch, ball, gap: (pitch + (ball + gap / 2)) / 2),
    Rule(
        ("bearing.ball_material", BALL),
        "bearing.ball_mass",
        lambda material, ball: float(material.density * np.pi / 6 * ball**3),  # solid
    ),
    *(
        rule
        for ring, bottom, profile, height in zip(
            RINGS, BOTTOMS, PROFILES, (sub, lambda half, low: low - half), strict=True
        )
        for rule in _shoulders(f"bearing.{ring}", bottom, profile, height)
    ),
    Rule(("cage.pocket_clearance", BALL), "cage.pocket_diameter", add),
    Rule(("cage.pocket_diameter",), "cage.pocket_depth", lambda diameter: diameter / 2),
    Rule(
        ("cage.pocket_approach.load", "cage.pocket_approach.approach"),
        "cage.pocket_stiffness",
        lambda load, approach: load / approach**1.5,
    ),
    Rule(("surface.Ra",), "surface.rms_roughness", lambda ra: ra * RMS_OVER_RA, _of_ra),
    Rule(("surface.finish",), "surface.rms_roughness", _rms_of_finish, _of_finish),
    Rule(("surface.finish",), "surface.ball_rms_roughness", lambda _: BALL_RA * RMS_OVER_RA, _of_grade),
    *(
        Rule(("mounting.mounting_temperature",), f"mounting.{ring}_temperature", lambda temperature: temperature)
        for ring in RINGS
    ),
)
