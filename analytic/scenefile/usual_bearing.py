"""The scene of a bearing of the catalogue as far as nobody gives another: its document, without dimensions."""

import math
from typing import Any

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.scenefile.choice import Choice
from analytic.scenefile.usual_oil import suited_oil

RADIAL_SHARE, AXIAL_SHARE = 0.05, 0.02  # of C0: a light load on a deep groove, and on an angular contact bearing


def usual_scene(designation: str, bearing: CatalogBearing, choice: Choice) -> dict[str, Any]:
    """The document of a scene file with the tables bearing, operation, lubricant, surface and friction.

    designation : as it was given;  choice : values in place of the usual ones, as a scene file has them
    """
    radial, axial = (load if load is not None else "0 N" for load in (choice.radial_load, choice.axial_load))
    if is_light(choice):
        share, is_radial = light_share(bearing), bearing.nominal_angle is None
        load = f"{float(f'{share * bearing.static_load_rating:.2g}'):g} N"
        radial, axial = (load, axial) if is_radial else (radial, load)
    oil = choice.oil or suited_oil(
        mean_diameter=bearing.pitch_diameter, speed=choice.speed, temperature=choice.temperature
    )
    supply = choice.supply or ("grease" if bearing.seal_suffixes else None)  # for life
    return {
        "name": designation,
        "tolerance": "5 %",
        "bearing": {"catalog": designation, **_play(bearing)},
        "operation": {"radial_load": radial, "axial_load": axial, "inner_speed": choice.speed},
        "lubricant": {"name": oil, "temperature": choice.temperature, **({} if supply is None else {"supply": supply})},
        "surface": {"finish": "ground and honed"},
        "friction": {"hysteresis_loss": 0.007},
    }


def is_light(choice: Choice) -> bool:
    """Whether nobody gives a load, so that the scene has a light one."""
    return choice.radial_load is None and choice.axial_load is None


def light_share(bearing: CatalogBearing) -> float:
    """The light load over C0."""
    return RADIAL_SHARE if bearing.nominal_angle is None else AXIAL_SHARE


def _play(bearing: CatalogBearing) -> dict[str, Any]:
    """What says how far the rings are apart."""
    if bearing.nominal_angle is not None:
        return {"contact_angle": {"nominal": f"{math.degrees(bearing.nominal_angle):g} deg"}}
    return {"clearance": bearing.clearance_group or "CN"}
