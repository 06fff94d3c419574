"""Makers' formulas part by part: SKF's rolling and sliding, and FAG's whole torque, of seven deep groove bearings."""

import math
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from analytic.catalog.bearing_rows import CatalogBearing, find_bearing
from analytic.errors import InputError
from analytic.makers import ANGULAR_SERIES, CatalogueCase, case_of, skf_parts
from analytic.oil.rolling import per_minute, ring_diameters, square_millimetres
from analytic.scene import Array, Scene
from analytic.scenefile.read import SEATED, scene_of
from analytic.torque import friction_torque
from validation.measured.anchor import Anchor, anchor
from validation.study import markdown, published

BEARINGS = ("6004", "6204", "6205", "6208", "6212", "6305", "6310")
LOADS = {"radial": "0.05 C radial", "axial": "0.02 C0 axial"}
SKF_FILM = 0.05  # SKF's coefficient of a full film of mineral oil
GRADES = ("printed", "A", "B")  # of the balls in the catalogue
RADIAL_SHARE, AXIAL_SHARE = 0.05, 0.02  # of C, of C0
DOWN = {"radial": [1, 0, 0], "axial": [0, 0, 1]}  # the shaft lies, or it stands
LEAST_STIRRED = 2000.0  # nu n, mm2/s 1/min: below, FAG's M_0 has another form


def loads_of(bearing: CatalogBearing, case: str) -> tuple[float, float, float]:
    """(radial, axial) load, N, and moment about the bearing's middle, N m.

    An angular contact bearing under a radial load alone slides apart, so it also carries the thrust from which all its
    balls are loaded. Its radial load acts at its load centre, where the lines of contact meet the axis; anywhere else a
    single bearing tilts, until balls run on a shoulder.
    """
    if case == "axial":
        return 0.0, AXIAL_SHARE * bearing.static_load_rating, 0.0
    radial = RADIAL_SHARE * bearing.dynamic_load_rating
    slope = 0.0 if bearing.nominal_angle is None else math.tan(bearing.nominal_angle)
    return radial, SEATED * radial * slope, -radial * slope * bearing.pitch_diameter / 2


def scene_at(bearing: CatalogBearing, case: str) -> Scene:
    """One bearing under one load at 1000 rpm in ISO VG 68 of 60 degC, with ground and honed races and free balls."""
    radial, axial, moment = loads_of(bearing, case)
    document: dict[str, Any] = {
        "name": f"{bearing.designation}, {case}",
        "tolerance": "5 %",
        "bearing": {"catalog": bearing.designation},
        "operation": {
            "radial_load": f"{radial!r} N",
            "axial_load": f"{axial!r} N",
            "moment": f"{moment!r} N m",
            "inner_speed": "1000 rpm",
            "down": DOWN[case],
        },
        "lubricant": {"name": "ISO VG 68", "temperature": "60 degC"},
        "surface": {"finish": "ground and honed"},
        "friction": {"hysteresis_loss": 0.007, "spin_rule": "free"},
    }
    return scene_of(document, origin=bearing.designation)


def fag_torque(case: CatalogueCase) -> tuple[Array, Array]:
    """FAG's M_0 + M_1 in an oil bath with the least and with the largest of the factors printed, N m.

    M_0 = 1e-7 f_0 (nu n)^(2/3) d_m^3,  M_1 = f_1 (P_0/C_0)^x P_1 d_m,  N mm
    with d_m = (d + D)/2 in mm, nu in mm2/s, n in 1/min,
    P_1 = max(F_r, k F_a - 0.1 F_r),  P_0 = max(F_r, X_0 F_r + Y_0 F_a).  Source: [FAG2002].
    Raises InputError below nu n = 2000 mm2/s 1/min.
    """
    bore, outside = ring_diameters(case.bore_diameter, case.outside_diameter)
    mean = (bore + outside) / 2
    load, thrust = np.asarray(case.radial_load, float), np.asarray(case.axial_load, float)
    stirred = square_millimetres(case.kinematic_viscosity) * per_minute(case.ring_speed)
    if np.any(stirred < LEAST_STIRRED):
        raise InputError(f"viscosity times speed is {np.min(stirred):.3g} mm2/s 1/min: at least {LEAST_STIRRED:g}")
    kind = case.series if case.series in ANGULAR_SERIES else "deep groove"
    row = next(row for row in published("fag_friction.csv") if row["kind"] == kind)
    factors = {name: float(value) for name, value in row.items() if name != "kind"}
    static = np.maximum(load, factors["static_radial"] * load + factors["static_axial"] * thrust)
    working = np.maximum(load, factors["thrust_factor"] * thrust - 0.1 * load)
    share = (static / np.asarray(case.static_rating)) ** factors["exponent"]

    def torque(end: str) -> Array:
        viscous = 1e-7 * factors[f"f0_{end}"] * stirred ** (2 / 3) * mean**3
        return (viscous + factors[f"f1_{end}"] * share * working * mean) / 1e3

    return torque("low"), torque("high")


def makers_parts() -> Iterator[Anchor]:
    """Both parts of SKF's torque; ours as they are, with another law of elastic rolling, and with less. Then FAG's."""
    for case, load in LOADS.items():
        scenes = [scene_at(find_bearing(name), case) for name in BEARINGS]
        words = f"of {len(BEARINGS)} deep groove bearings, {load}, 1000 rpm"
        theirs = 1e3 * np.hstack([skf_parts(case_of(each), lubrication="oil_bath") for each in scenes])
        ours = parts(scenes)
        houpert = parts([replace(each, elastic_rolling="houpert") for each in scenes])
        told = "; both laws have a friction coefficient of 0.05"
        found = [(ours, 1, "", ""), (houpert, 1, ", elastic rolling by Houpert's law", told), (ours, 0, "", "")]
        if case == "radial":  # under thrust every ball is loaded
            bare = parts([replace(each, effects={**each.effects, "unloaded_balls": "off"}) for each in scenes])
            found.append((bare, 0, ", without unloaded balls", ""))
        for own, part, more, note in found:
            name = ("rolling", "sliding")[part]
            yield anchor("skf_part", theirs=theirs[part], ours=own[part], part=name, words=words, more=more, note=note)
        of_fag = 1e3 * np.hstack([fag_torque(case_of(each)) for each in scenes])
        for end, torque in zip(("least", "largest"), of_fag, strict=True):
            yield anchor("fag", theirs=torque, ours=np.sum(ours, axis=0), words=words, end=end)


def sliding_page() -> Iterator[str]:
    """sliding.md, in Markdown: what the ratio of our sliding to SKF's sliding part is made of."""
    heads = ("= friction coefficient over 0.05", "x geometry", "x 0.05 over SKF's coefficient")
    yield from markdown(("load", "ours over SKF's", *heads), _split())


def _split() -> Iterator[tuple[str, ...]]:
    for case, load in LOADS.items():
        scenes = [scene_at(find_bearing(name), case) for name in BEARINGS]
        at_film_friction = [replace(each, surface=None, friction_coefficient=SKF_FILM) for each in scenes]
        # Endlessly thick oil has SKF's coefficient of a full film.
        cases = [case_of(each) for each in scenes]
        theirs, in_film = (
            1e3 * np.hstack([skf_parts(each, lubrication="oil_bath")[1] for each in of_oil])
            for of_oil in (cases, [each._replace(kinematic_viscosity=1.0) for each in cases])
        )
        ours, same_coefficient = slips(scenes), slips(at_film_friction)
        factors = ours / theirs, ours / same_coefficient, same_coefficient / in_film, in_film / theirs
        yield load, *(f"{np.min(each):.2f} to {np.max(each):.2f}" for each in factors)


def slips(scenes: list[Scene]) -> Array:
    """Sliding by spin and conformity, N mm, (scenes,)."""
    found = [friction_torque(scene).torque for scene in scenes]
    return 1e3 * np.array([each.spin[0] + each.conformity[0] for each in found])


def parts(scenes: list[Scene]) -> tuple[Array, Array]:
    """Hydrodynamic rolling, and all else: sliding in the contacts and elastic rolling, N mm, each (scenes,)."""
    found = [friction_torque(scene).torque for scene in scenes]
    rolling = np.array([0.0 if each.rolling is None else each.rolling[0] for each in found])
    return 1e3 * rolling, 1e3 * (np.array([each.total[0] for each in found]) - rolling)
