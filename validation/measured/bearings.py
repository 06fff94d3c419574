"""Whole bearings: a film, heats and cage speeds that were measured, and how a radial load changes the loss."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from analytic.catalog.bearing_rows import find_bearing
from analytic.oil.variation import OIL_LOSS_FACTORS, Variation
from analytic.result import FrictionTorque
from analytic.scene import Array, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from validation.measured.anchor import Anchor, anchor, published_columns
from validation.study import published

HERE = Path(__file__).parent
UNIFORM = 3**-0.5  # standard deviation over half the width of a uniform distribution
# Standard, relative: bulk modulus and reflection; the inputs' part, of the power 0.67 and 0.53 of the film
FILM_MEASURED, FILM_VISCOSITY, FILM_PRESSURE_VISCOSITY = 0.15, 0.67 * 0.1, 0.53 * 0.15  # judgement
HEAT_READ = 0.03  # relative, standard
HOT_OIL = (2e-3, 3.3e-3)  # Pa s, of the oil between the inlet and the contacts; nobody measured it
# Of a 6016, by the columns of its file
FILM_6016 = {
    "bearing.ball_diameter": "{ball_diameter_mm} mm",
    "bearing.pitch_diameter": "{pitch_diameter_mm} mm",
    "operation.inner_speed": "{speed_rpm} rpm",
    "lubricant.viscosity": "{viscosity_Pa_s} Pa s",
    "lubricant.pressure_viscosity": "{pressure_viscosity_per_GPa}e-9 1/Pa",
}


def losses(oil_share: str, land: str, pocket: str) -> dict[str, Any]:
    """Oil between the rings, and clearances of the cage on its land and in its pockets."""
    return {
        "losses.oil_flow": "760 ml/min",  # as printed
        "losses.oil_share": oil_share,
        "losses.land": {"ring": "inner", "diameter": "42 mm", "clearance": land, "width": "6 mm"},
        "losses.pockets": {"clearance": pocket, "thickness": "2.5 mm"},
    }


# What nobody states, from the least to the most loss, judgements
OIL_LOSSES = losses("0.2 %", "0.5 mm", "0.4 mm"), losses("2 %", "0.2 mm", "0.15 mm")
CAGE_BIAS = 3e-3  # of a cage speed, relative, as stated there
RADIAL_LOADS = (0.0, 250.0, 500.0, 750.0, 1000.0, 1500.0)  # N, added to the thrust
THRUST = 1000.0  # N
SHOULDER = 0.2  # height over ball diameter, usual


def whole_bearings() -> Iterator[Anchor]:
    yield from film_6016()
    yield from heats()
    yield from cage_speeds()
    yield from radial_load_added()


def film_6016() -> Iterator[Anchor]:
    """Central film at the heaviest ball of a 6016, outer race, and the load of that ball."""
    row = published("film_6016.csv")[0]
    settings = {key: text.format(**row) for key, text in FILM_6016.items()}
    found, measured = friction_torque(load_scene(HERE / "film_6016.toml", settings=settings)), float(row["film_um"])
    assert found.film.outer is not None
    share = np.sqrt(FILM_MEASURED**2 + FILM_VISCOSITY**2 + FILM_PRESSURE_VISCOSITY**2)
    yield anchor("film_6016", theirs=measured, ours=1e6 * found.film.outer, uncertainty=share * measured)
    yield anchor("load_6016", theirs=float(row["ball_load_N"]), ours=found.ball_load)


def heat_scene(speeds: Array, viscosity: float, lost: dict[str, Any]) -> Scene:
    """speeds : rpm;  viscosity : Pa s;  lost : settings of the losses"""
    moved = {"operation.inner_speed": [f"{rpm:g} rpm" for rpm in speeds], "lubricant.viscosity": f"{viscosity} Pa s"}
    return load_scene(HERE / "heat_35mm.toml", settings=moved | lost)


def heats() -> Iterator[Anchor]:
    """Friction power of the races against the heat of the oil; then with the losses of the oil, from least to most."""
    rows = published_columns("heat_35mm.csv")
    theirs, rpm = rows["heat_W"], rows["speed_rpm"]
    found = [friction_torque(heat_scene(rpm, oil, {})) for oil in HOT_OIL]
    thin, thick = (each.torque.total * each.inner_speed for each in found)
    numerical = found[1].numerical_uncertainty / 2 * thick  # stated is 95 %
    spread = np.sqrt((HEAT_READ * theirs) ** 2 + (UNIFORM * (thick - thin) / 2) ** 2 + numerical**2)
    yield anchor("heat", theirs=theirs, ours=(thin + thick) / 2, uncertainty=spread)
    ends = []
    for viscosity, lost, factor in zip(HOT_OIL, OIL_LOSSES, OIL_LOSS_FACTORS, strict=True):
        each = friction_torque(heat_scene(rpm, viscosity, lost), variation=Variation(oil_losses=factor))
        ends.append(each.torque.total * each.inner_speed)
    low, high = ends
    spread = np.sqrt((HEAT_READ * theirs) ** 2 + (UNIFORM * (high - low) / 2) ** 2)
    yield anchor("heat_with_oil", theirs=theirs, ours=(low + high) / 2, uncertainty=spread, low=low, high=high, rpm=rpm)


def of_catalogue(designation: str, *, rpm: str, grade: int, **loads: object) -> FrictionTorque:
    """A bearing of the catalogue in ISO VG `grade`; loads : by key of [operation]"""
    height = f"{1e3 * SHOULDER * find_bearing(designation).ball_diameter} mm"
    settings = {f"operation.{key}": value for key, value in loads.items()} | {
        "bearing.catalog": designation,
        "bearing.inner.shoulder_height": height,
        "bearing.outer.shoulder_height": height,
        "operation.inner_speed": f"{rpm} rpm",
        "lubricant.name": f"ISO VG {grade}",
    }
    return friction_torque(load_scene(HERE / "catalogue.toml", settings=settings))


def cage_speeds() -> Iterator[Anchor]:
    """Cage speed over that of balls at zero contact angle that roll without slip."""
    for key, known in (("cage_speed_loaded", True), ("cage_speed_unknown", False)):
        own = [row for row in published("cage_speed.csv") if bool(row["radial_N"]) is known]
        theirs = np.array([1 - float(row["slip_percent"]) / 100 for row in own])
        yield anchor(key, theirs=theirs, ours=np.array([rolling_cage(row) for row in own]), uncertainty=CAGE_BIAS)


def rolling_cage(row: dict[str, str]) -> float:
    """(1 - g cos a)/(1 - g), g = D/d_m, with the loaded contact angle a; 1 where the load is not known."""
    if not row["radial_N"]:
        return 1.0
    loads = {"axial_load": "0 N", "radial_load": f"{row['radial_N']} N", "moment": "0 N m"}
    found = of_catalogue(row["bearing"], rpm=row["speed_rpm"], grade=32, **loads)
    bearing = find_bearing(row["bearing"])
    share = bearing.ball_diameter / bearing.pitch_diameter
    return float((1 - share * np.cos(found.contact_angle[0])) / (1 - share))


def radial_load_added() -> Iterator[Anchor]:
    """Torque with a radial load over that without it, in whole and by rolling; the load acts at the load centre."""
    totals, rolling = [], []
    for name in ("NSK 7210 C", "NSK 7210 A5"):
        bearing = find_bearing(name)
        assert bearing.nominal_angle is not None
        moment = -np.array(RADIAL_LOADS) * np.tan(bearing.nominal_angle) * bearing.pitch_diameter / 2  # else it tilts
        loads = {
            "axial_load": [f"{THRUST:g} N"] * len(RADIAL_LOADS),
            "radial_load": [f"{each:g} N" for each in RADIAL_LOADS],
            "moment": [f"{each:g} N m" for each in moment],
        }
        for rpm in ("2000", "8000"):
            torque = of_catalogue(name, rpm=rpm, grade=46, **loads).torque
            for ratios, part in ((totals, torque.total), (rolling, torque.rolling)):
                assert part is not None
                ratios.append(part[1:] / part[0])
    for part, ours in (("torque", totals), ("rolling", rolling)):
        yield anchor("radial_load_added", theirs=1.0, ours=np.array(ours), part=part)
