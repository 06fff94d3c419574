"""The scene of a bearing of the catalogue as far as nobody gives another: its values by key, as a file has them.

The oil is an ISO VG class of mineral oil, the one whose viscosity at the oil's temperature is nearest, in the
logarithm, to twice the reference viscosity of [ISO281], kappa = 2: a full film, as designers choose it. Very slow
bearings end at VG 460, very fast ones at VG 10, and cold or hot oil at the ends of the classes' data. The cage is
that of the 6205 of [Paper], scaled to its balls.
"""

import math
from collections.abc import Collection, Mapping
from typing import Any, Protocol

import numpy as np

from analytic.catalog.bearing_rows import CatalogBearing
from analytic.given import USUAL_SPEED, USUAL_TEMPERATURE
from analytic.quantity import range_of
from analytic.scene import USUAL_LOSS, Material, Origin, Scene
from analytic.scenefile.fill import BOTTOMS, rivals_of
from analytic.scenefile.keys import scene_key
from analytic.scenefile.oil import named_oil, viscosities_of
from analytic.words import MILLIMETRE, RPM

# Over the ball diameter, of the 6205 of [Paper]: clearance in the pockets; thickness of two steel sheets and of a
# moulded cage; and the width of the sheets that gives their mass of 6.58 g. Each sheet follows the pitch circle and
# half of every ball.
POCKET, SHEET, MOULDED, SHEET_WIDTH = 0.025, 0.113, 0.189, 0.36
WEB = 0.8  # of the web between pockets: the thickest sheet
DENSITY = {"steel": 7850.0, "peek": 1300.0}  # kg/m^3
LIGHT = 2000.0  # kg/m^3: plastics are lighter
PLASTIC = ("plastic", "polyamide", "phenolic")  # in the meaning of a suffix
# Of ball on pocket: below the boundary friction of steel, 0.09 to 0.15, as films carry a part; judgement
FRICTION = 0.1
# Standard deviation of friction times mass over the value, judgement: the torque is in proportion to both.
SPREAD = 0.5
_SIZE = Origin(status="assumed", uncertainty=None, source="cage of the 6205 of [Paper], scaled by the ball diameter")
ORIGINS = {
    **dict.fromkeys(("pocket_clearance", "wall_thickness", "mass"), _SIZE),
    "material": Origin(status="assumed", uncertainty=None, source="by the suffix of the cage; pressed steel without"),
    "friction_coefficient": Origin(
        status="assumed",
        uncertainty=SPREAD * FRICTION,
        source="judgement: boundary friction of steel less what films carry; the spread includes that of the mass",
    ),
}
RADIAL_SHARE, AXIAL_SHARE = 0.05, 0.02  # of C0: a light load on a deep groove, and on an angular contact bearing
CLASSES = (10, 15, 22, 32, 46, 68, 100, 150, 220, 320, 460)  # of ISO 3448
RATIO = 2.0  # kappa, viscosity over nu_1
THICKEST = 1.0  # m^2/s: at standstill nu_1 is infinite
WITHOUT_SPEED = "ISO VG 68"  # beside a speed or a temperature that the scene will refuse
LOADS = ("operation.radial_load", "operation.axial_load")
OTHER_LOADS = ("operation.moment", "arrangement.preload", "arrangement.offset")  # beside which there is no usual load
# How keys of the usual values that a user reads begin
TOLD = ("bearing.clearance", "operation.", "lubricant.", "surface.", "friction.")


class Balls(Protocol):
    """What the size of a cage follows from."""

    @property
    def ball_count(self) -> int: ...
    @property
    def ball_diameter(self) -> float: ...  # m
    @property
    def pitch_diameter(self) -> float: ...  # m


def cage_sizes(bearing: Balls, *, material: str) -> dict[str, float]:
    """Pocket clearance and wall thickness, m, and mass, kg, by the keys of [cage]; empty: the balls leave no web.

    material : "steel" of two pressed sheets, "peek" of a moulded cage
    """
    ball, count, pitch = bearing.ball_diameter, bearing.ball_count, bearing.pitch_diameter
    web = pitch * math.sin(math.pi / count) - (1 + POCKET) * ball
    sheet = min((SHEET if material == "steel" else MOULDED) * ball, WEB * web)
    if sheet <= 0:
        return {}
    around = math.pi * pitch + count * (math.pi / 2 - 1) * ball
    mass = DENSITY[material] * 2 * sheet * SHEET_WIDTH * ball * around
    return {"pocket_clearance": POCKET * ball, "wall_thickness": sheet, "mass": mass}


def assumed_cage(bearing: Balls, suffixes: Collection[str], *, material: Material | None = None) -> dict[str, Any]:
    """The same with the name of the material.

    suffixes : meanings of those of the designation: a plastic is moulded; all others count as pressed steel
    material : that is given, in place of the usual one; one as light as a plastic is moulded
    """
    by_suffix = any(word in meaning for meaning in suffixes for word in PLASTIC)
    is_moulded = by_suffix if material is None else material.density < LIGHT
    kind = "peek" if is_moulded else "steel"
    sizes = cage_sizes(bearing, material=kind)
    if sizes and material is not None:
        sizes["mass"] *= material.density / DENSITY[kind]
    return sizes | {"material": kind} if sizes else {}


def usual_values(designation: str, bearing: CatalogBearing, given: Mapping[str, Any]) -> dict[str, Any]:
    """The values that nobody gave, by key, in the order of a file.

    designation : as it was given;  given : what someone gave, by key, as a scene file has it
    """
    keys, is_thrust = {*given}, given.get("bearing.kind") == "thrust"
    speed, temperature = (
        _asked(given, "operation.inner_speed", USUAL_SPEED),
        _asked(given, "lubricant.temperature", USUAL_TEMPERATURE),
    )
    radial = axial = "0 N"
    if is_light(keys):
        load = f"{float(f'{light_share(bearing) * bearing.static_load_rating:.2g}'):g} N"
        radial, axial = (load, axial) if bearing.nominal_angle is None and not is_thrust else (radial, load)
    name = suited_oil(mean_diameter=bearing.pitch_diameter, speed=speed, temperature=temperature)
    usual = {
        "name": designation,
        "tolerance": "5 %",
        "bearing.catalog": designation,
        **({} if is_thrust else _play(bearing)),
        "operation.radial_load": radial,
        "operation.axial_load": axial,
        "operation.inner_speed": USUAL_SPEED,
        **_oil(name, temperature, given, keys),
        "lubricant.temperature": USUAL_TEMPERATURE,
        **({"lubricant.supply": "grease"} if bearing.seal_suffixes else {}),  # for life
        "surface.finish": "ground and honed",
        "friction.hysteresis_loss": USUAL_LOSS,
    }
    replaced = keys | {rival for key in keys for rival in rivals_of(key)}
    if {*BOTTOMS} & keys:
        replaced.add("bearing.clearance")
    if bearing.clearance_group is not None and "bearing.clearance" not in keys:
        replaced.discard("bearing.clearance")  # the designation gives it
    if "friction.coefficient" in keys and not any(key.startswith("surface.") for key in keys):
        replaced.add("surface.finish")
    return {key: value for key, value in usual.items() if key not in replaced}


def told_values(
    usual: Mapping[str, Any], bearing: CatalogBearing, scene: Scene, given: Mapping[str, Any]
) -> dict[str, str]:
    """What a user reads of the usual values of a scene, by key, as a file has them; given : as of `usual_values`"""
    told = {key: str(value) for key, value in usual.items() if key.startswith(TOLD)}
    if bearing.clearance_group is not None:  # the designation says it
        told.pop("bearing.clearance", None)
    if scene.lubricant is not None and "lubricant.supply" not in given:
        told.setdefault("lubricant.supply", scene.lubricant.supply)
    if "seals" in scene.losses.origins:
        told["losses.seals"] = "estimate"
    return told


def _asked(given: Mapping[str, Any], key: str, usual: Any) -> Any:
    value = given.get(key)
    return usual if value is None else value


def is_light(keys: set[str]) -> bool:
    """Whether the scene has a light load, as nobody gives one; keys : that someone gave"""
    return not keys & {*LOADS, *OTHER_LOADS}


def light_share(bearing: CatalogBearing) -> float:
    """The light load over C0."""
    return RADIAL_SHARE if bearing.nominal_angle is None else AXIAL_SHARE


def _play(bearing: CatalogBearing) -> dict[str, Any]:
    """What says how far the rings are apart."""
    if bearing.nominal_angle is not None:
        return {"bearing.contact_angle.nominal": f"{math.degrees(bearing.nominal_angle):g} deg"}
    return {"bearing.clearance": bearing.clearance_group or "CN"}


def _oil(name: str, temperature: Any, given: Mapping[str, Any], keys: set[str]) -> dict[str, Any]:
    """The usual oil, without its name where given keys say another oil.

    Beside a base oil alone stay the viscosities of its class. A viscosity that is given is one of mineral oil, and
    without a temperature of its own that at the oil's.
    """
    own = {key for key in ("name", "viscosity", "base_oil", "reference_temperature") if f"lubricant.{key}" in keys}
    if "name" in own or not own:
        return {"lubricant.name": name}
    if "viscosity" in own:
        parts = given["lubricant.viscosity"]
        has_own = isinstance(parts, list) or " at " in str(parts)
        usual = {"lubricant.base_oil": "mineral"}
        return usual if has_own else usual | {"lubricant.reference_temperature": temperature}
    return {"lubricant.viscosity": viscosities_of(name)} if "reference_temperature" not in own else {}


def reference_viscosity(*, ring_speed: float, mean_diameter: float) -> float:
    """nu_1 of [ISO281], m^2/s: 45000 n^-0.83 d_m^-0.5 mm^2/s below n = 1000 rev/min, from there 4500 (n d_m)^-0.5.

    ring_speed : rad/s, of either sign; infinite viscosity at 0;  mean_diameter : d_m, of the ball centres, m
    """
    speed, diameter = RPM.number(abs(ring_speed)), MILLIMETRE.number(mean_diameter)
    if speed == 0.0:
        return np.inf
    slow = 45000 * speed**-0.83 / np.sqrt(diameter)
    return 1e-6 * (slow if speed < 1000 else 4500 / np.sqrt(speed * diameter))


def suited_oil(*, mean_diameter: float, speed: object, temperature: object) -> str:
    """The name of the oil.

    mean_diameter : of the ball centres, m
    speed, temperature : of inner ring and oil, as a scene file has them; of a series the largest speed counts
    """
    try:
        parts = range_of(speed) if isinstance(speed, str) else None
        series = speed if isinstance(speed, list) else [speed] if parts is None else [parts.first, parts.last]
        speeds = [abs(scene_key("operation.inner_speed").read(each)) for each in series]
        wanted = RATIO * reference_viscosity(ring_speed=max(speeds), mean_diameter=mean_diameter)
        kelvin = scene_key("lubricant.temperature").read(temperature)
    except ValueError:
        return WITHOUT_SPEED
    return min((f"ISO VG {grade}" for grade in CLASSES), key=lambda name: _distance(name, kelvin, wanted))


def _distance(name: str, temperature: float, wanted: float) -> float:
    """In the logarithm of the viscosity; K, m^2/s."""
    line = named_oil(name).line
    assert line is not None
    viscosity = line.kinematic_viscosity(min(max(temperature, line.coldest), line.hottest))
    return abs(np.log(viscosity / min(wanted, THICKEST)))
