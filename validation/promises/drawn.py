"""The scene at a place: a radial bearing, and what a second row of numbers adds to it or changes in it.

Thrust bearings, pairs, seats, given angles, series of unlike points, more oils, surfaces, laws and losses. Every number
is taken whether it counts or not.
"""

import json
import tempfile
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any, Literal

import numpy as np

from analytic.scene import Autocorrelation
from analytic.surface.roughness import generated_surface

RADIAL_INPUTS = 46  # numbers that `radial_scene` takes at most
INPUTS = RADIAL_INPUTS + 75  # numbers of a place
LONG_SERIES = 12  # operating points
LIGHT_CAGE = 2e-3  # kg/N, mass of a cage over the thrust: a fiftieth in weight
MAP_LENGTH, MAP_SPACING, MAP_POINTS = 20e-6, 2e-6, 128  # m, m, a side
SWITCHED = ("centrifugal", "gyroscopic", "asperities", "starvation", "inlet_heating", "hysteresis", "rolling", "weight",
            "finite_geometry", "unloaded_balls", "creep", "spin", "conformity", "cage")  # fmt: skip


class Draw:
    """Reads the inputs of a scene off a place, one number after the other."""

    def __init__(self, place: Iterable[float]) -> None:
        self.numbers = iter(place)

    def between(self, low: float, high: float) -> float:
        return low + (high - low) * next(self.numbers)

    def power(self, low: float, high: float) -> float:
        """Even in the logarithm."""
        return float(np.exp(self.between(np.log(low), np.log(high))))

    def one_of(self, *choices: str) -> str:
        return choices[min(int(next(self.numbers) * len(choices)), len(choices) - 1)]

    def chance(self, share: float) -> bool:
        return next(self.numbers) < share


def radial_scene(place: Iterable[float], *, tolerance: float) -> dict[str, Any]:
    """The scene at a place, as the document of a scene file."""
    draw = Draw(place)
    ball = draw.power(3e-3, 30e-3)
    radii = {ring: draw.between(0.505, 0.56) * ball for ring in ("inner", "outer")}
    pitch, clearance = ball * draw.between(3.2, 6.5), ball * draw.power(1e-4, 3e-2)
    inner = pitch / 2 - ball / 2 - clearance / 4
    bottoms = {"inner": inner, "outer": inner + ball + clearance / 2}
    shoulder = draw.between(0.38, 0.46) * ball
    balls = int(draw.between(0.5, 0.9) * np.pi * pitch / ball)
    material = draw.one_of("steel", "steel", "silicon_nitride")
    bearing: dict[str, Any] = {
        "name": "drawn",
        "ball_count": max(balls, 5),
        "ball_diameter": f"{ball:.9g} m",
        "ball_mass": f"{np.pi / 6 * ball**3 * (7800 if material == 'steel' else 3200):.9g} kg",
        "ball_material": material,
        "bore_diameter": f"{2 * inner - ball:.9g} m",
        "outside_diameter": f"{2 * bottoms['outer'] + ball:.9g} m",
        "contact_angle": {"rule": "solved", "free": f"{draw.between(0.05, 0.7):.9g} rad"},
    }
    for ring, groove in radii.items():
        bearing[ring] = {
            "bottom_radius": f"{bottoms[ring]:.9g} m",
            "groove_radius": f"{groove:.9g} m",
            "shoulder_half_width": f"{shoulder:.9g} m",
            "material": "steel",
        }
    heaviest = 1e8 * ball**2  # N of thrust: about 2.5 GPa in usual grooves, 4 GPa in open ones
    axial = draw.power(0.1, max(heaviest, 1.0))
    operation: dict[str, Any] = {"axial_load": f"{axial:.9g} N", "inner_speed": f"{draw.power(1e-3, 2e3):.9g} rad/s"}
    radial, moment = draw.power(1e-4, 2.0) * axial, draw.power(1e-4, 0.5) * axial * pitch
    operation |= {"tilt": "free"} if draw.chance(0.7) else {}  # loads the balls less alike than a ring held straight
    operation |= {"radial_load": f"{radial:.9g} N"} if draw.chance(0.35) else {}
    operation |= {"moment": f"{moment:.9g} N m"} if draw.chance(0.2) else {}
    down = [float(f"{draw.between(-1, 1):.6g}") for _ in range(3)]
    operation |= {"down": down} if draw.chance(0.5) else {}
    oiled = draw.chance(0.8)
    oil: dict[str, Any] = {
        "viscosity": f"{draw.power(2e-3, 1.0):.9g} Pa s",
        "pressure_viscosity": f"{draw.between(0.8e-8, 3e-8):.9g} 1/Pa",
        "eyring_stress": f"{draw.power(1e6, 15e6):.9g} Pa",
        "limiting_shear": float(f"{draw.between(0.03, 0.1):.6g}"),
        "traction": draw.one_of("eyring_sinh", "eyring_sinh", "eyring_constant"),
        "supply": draw.one_of("oil_bath", "oil_spot", "grease"),
        "compressible": draw.chance(0.2),
    }
    degree = 1 + draw.power(1e-3, 1e2)
    oil |= {"starvation_degree": float(f"{degree:.9g}")} if draw.chance(0.15) else {}
    length, rms = draw.power(10e-6, 200e-6), draw.power(5e-9, 1e-6)
    kind = draw.one_of(*4 * ("gaussian",), "exponential")
    surface: dict[str, Any] = {
        "rms_roughness": f"{rms:.9g} m",
        "autocorrelation": {"kind": kind, "length": f"{length:.9g} m", "spacing": f"{length / 20:.9g} m"},
        "hardness": "7.8 GPa",
        "boundary_friction": float(f"{draw.between(0.05, 0.2):.6g}"),
    }
    law = draw.one_of("elastic", "truncated", "greenwood_williamson")
    surface |= {"gap": law} if law != "greenwood_williamson" else {"gap": "truncated", "asperities": law}
    friction: dict[str, Any] = {"hysteresis_loss": float(f"{draw.power(1e-3, 2e-2):.6g}")}
    friction["spin_rule"] = draw.one_of(*4 * ("free",), "balanced", "inner_control", "outer_control")
    coefficient = float(f"{draw.power(0.003, 0.2):.6g}")
    document = {"name": "drawn", "tolerance": tolerance, "bearing": bearing, "operation": operation}
    if oiled:
        return document | {"lubricant": oil, "surface": surface, "friction": friction}
    document |= {"lubricant": oil} if draw.chance(0.5) else {}
    return document | {"friction": friction | {"coefficient": coefficient}}


def scene_text(place: tuple[float, ...], *, tolerance: float) -> str:
    """The scene at a place, as a scene file."""
    document = radial_scene(place[:RADIAL_INPUTS], tolerance=tolerance)
    draw, late = Draw(place[RADIAL_INPUTS:-3]), Draw(place[-3:])
    only_thrust, upright, own_friction = late.chance(0.5), late.chance(0.2), late.chance(0.5)
    kind = draw.one_of(*5 * ("radial",), "thrust", "pair", "given", "seats")
    _as_kind(document, kind, draw)
    _series(document, draw, only_thrust=only_thrust)
    _oil(document, draw)
    _surface(document, draw)
    _laws(document, draw)
    _losses(document, draw)
    if kind == "thrust":
        _within_washers(document)
    if "down" in document["operation"] and kind != "pair" and upright:
        document["operation"]["down"] = [0.0, 0.0, -1.0]
    if "cage" in document and own_friction:
        del document["cage"]["friction_coefficient"]  # that of the oil in the pockets, or of the races
    return toml(document)


def size(document: dict[str, Any], path: str) -> float:
    """The number before the unit of a quantity; path : with points."""
    value: Any = document
    for key in path.split("."):
        value = value[key]
    return float(value.split()[0])


def _as_kind(document: dict[str, Any], kind: str, draw: Draw) -> None:
    """Make the bearing a thrust bearing, a pair, one on seats, or one whose angle is given."""
    bearing, operation = document["bearing"], document["operation"]
    ball, axial = size(document, "bearing.ball_diameter"), size(document, "operation.axial_load")
    arrangement, preload, apart = draw.one_of("O", "X", "tandem"), draw.power(0.01, 10) * axial, draw.between(2, 5)
    angle = draw.power(0.02, 0.8)
    shaft, housing, wall = draw.between(-1e-3, 2e-3), draw.between(-1e-3, 1e-3), draw.between(1.1, 2.0)
    warm, hotter = draw.between(10, 110), draw.between(-10, 25)
    if kind == "thrust":
        middle = (size(document, "bearing.inner.bottom_radius") + size(document, "bearing.outer.bottom_radius")) / 2
        washer = {key: bearing["inner"][key] for key in ("groove_radius", "shoulder_half_width", "material")}
        for key in ("contact_angle", "bore_diameter", "outside_diameter"):
            del bearing[key]
        bearing |= {"kind": "thrust", "pitch_diameter": f"{2 * middle:.9g} m", "inner": washer, "outer": dict(washer)}
        bearing["inner"]["shoulder_half_width"] = bearing["outer"]["shoulder_half_width"] = f"{0.35 * ball:.9g} m"
    elif kind == "pair":
        document["arrangement"] = {"kind": arrangement, "distance": f"{apart * ball:.9g} m"}
        if "down" in operation:
            operation["down"][2] = 0.0  # the axis of a pair is level
        if arrangement != "tandem":
            document["arrangement"]["preload"] = f"{preload:.9g} N"
    elif kind == "given":
        bearing["contact_angle"] = {"rule": "given", "value": f"{angle:.9g} rad"}
        operation.pop("radial_load", None)
        operation.pop("moment", None)
    elif kind == "seats":
        del bearing["contact_angle"]
        document["mounting"] = {
            "shaft_interference": f"{shaft * ball:.9g} m",
            "housing_interference": f"{housing * ball:.9g} m",
            "housing_outside_diameter": f"{wall * size(document, 'bearing.outside_diameter'):.9g} m",
            "inner_temperature": f"{warm + hotter:.6g} degC",
            "outer_temperature": f"{warm:.6g} degC",
        }


def _series(document: dict[str, Any], draw: Draw, *, only_thrust: bool) -> None:
    """Make one operating point a few unlike ones, or a long series, under thrust alone or every load."""
    operation = document["operation"]
    points = draw.one_of(*10 * ("1",), "2", "2", "2", "3", "3", "long")
    heaviest = 1e8 * size(document, "bearing.ball_diameter") ** 2  # N, as of the first point
    factors = np.array([[draw.power(0.01, 100) for _ in range(4)] for _ in range(2)])
    if points == "1":
        return
    if points == "long":
        rise = np.linspace(0, 1, LONG_SERIES)
        shuffled = np.arange(LONG_SERIES) * 5 % LONG_SERIES  # loads and speeds do not rise together
        orders = (rise, rise[shuffled], rise[::-1] - 1, rise)
        factors = np.stack([each**order for each, order in zip(factors[0], orders, strict=True)], axis=1)[1:]
        if only_thrust:
            operation.pop("radial_load", None)
            operation.pop("moment", None)
    further = LONG_SERIES - 1 if points == "long" else int(points) - 1
    most = {"axial_load": heaviest, "inner_speed": 3e3, "radial_load": heaviest, "moment": np.inf}
    for column, (key, limit) in enumerate(most.items()):
        if key in operation:
            first, unit = operation[key].split(maxsplit=1)
            values = [float(first), *(min(float(first) * f[column], limit) for f in factors[:further])]
            operation[key] = [f"{value:.9g} {unit}" for value in values]


def _oil(document: dict[str, Any], draw: Draw) -> None:
    ahead, behind, cavitation = draw.power(0.2, 1.0), draw.power(0.2, 1.0), draw.power(1e4, 2e5)
    film, rolling = draw.one_of("numerical", "nijenbanning"), draw.one_of("numerical", "biboulet", "houpert")
    warm, jet, tension = draw.between(20, 100), draw.chance(0.1), draw.power(0.01, 0.05)
    chances = [draw.chance(share) for share in (0.2, 0.2, 0.2, 0.2, 0.2)]
    if (oil := document.get("lubricant")) is None:
        return
    more = (
        {"reach": {"ahead": ahead, "behind": behind}},
        {"cavitation_pressure": f"{-cavitation:.9g} Pa"},
        {"film_formula": film},
        {"rolling_formula": rolling},
        {"temperature": f"{warm:.6g} degC"},
    )
    for chosen, keys in zip(chances, more, strict=True):
        oil |= keys if chosen else {}
    if jet:
        oil["supply"] = "oil_jet"
    if oil["supply"] == "grease":
        oil["surface_tension"] = f"{tension:.6g} N/m"


def _surface(document: dict[str, Any], draw: Draw) -> None:
    kind = draw.one_of(*14 * ("rms",), "map", "map", "Ra", "finish", "ball", "ball")
    mapped, correlation = draw.one_of("20", "60", "200"), draw.one_of("gaussian", "exponential")
    mean, finish = draw.power(5e-9, 5e-7), draw.one_of("ground", "ground and honed", "superfinished")
    if (surface := document.get("surface")) is None:
        return
    if kind in ("map", "Ra", "finish"):
        del surface["rms_roughness"], surface["autocorrelation"]
    if kind == "map":
        path = height_map(int(mapped), correlation)  # pyright: ignore[reportArgumentType]
        surface["height_map"] = {"path": str(path), "spacing": f"{MAP_SPACING:g} m"}
    elif kind == "Ra":
        surface["Ra"] = f"{mean:.9g} m"
    elif kind == "finish":
        surface["finish"] = finish
    elif kind == "ball":
        surface["ball_rms_roughness"] = f"{mean:.9g} m"


def _laws(document: dict[str, Any], draw: Draw) -> None:
    """Laws and effects that a scene chooses."""
    houpert, off, switched = draw.chance(0.2), draw.one_of(*SWITCHED), draw.chance(0.1)
    if houpert:
        document["friction"]["elastic_rolling"] = "houpert"
    if switched:
        document["effects"] = {off: "off"}


def _losses(document: dict[str, Any], draw: Draw) -> None:
    """A cage that slides on its balls, and losses outside the contacts."""
    ball, count = size(document, "bearing.ball_diameter"), document["bearing"]["ball_count"]
    seals, drag, flow = draw.power(1e-6, 1e-1), draw.power(1e-6, 1e-1), draw.power(1e-8, 1e-4)
    share, clearance, thickness = draw.power(1e-3, 0.5), draw.power(5e-3, 5e-2) * ball, draw.between(0.05, 0.2) * ball
    heavy, slippery, axis = draw.power(0.1, 1.0), draw.power(0.01, 0.3), draw.one_of("axial", "radial")
    ring, gap, width = draw.one_of("inner", "outer"), draw.power(5e-3, 5e-2) * ball, draw.between(0.1, 0.5) * ball
    caged, sealed, stirred, flows, sheared, pocketed = (draw.chance(each) for each in (0.25, 0.15, 0.3, 0.15, 0.2, 0.2))
    shares = draw.chance(0.5)
    oiled, bearing = "lubricant" in document, document["bearing"]
    # Races that hardly grip their balls do not turn a heavy cage.
    mass = heavy * min(count * size(document, "bearing.ball_mass"), LIGHT_CAGE * least(document))
    middle = bearing.get("pitch_diameter") or f"{2 * size(document, f'bearing.{ring}.bottom_radius'):.9g} m"
    losses: dict[str, Any] = {"seals": f"{seals:.9g} N m"} if sealed else {}
    if stirred:
        losses |= {"oil_share": share} if shares and oiled else {"drag": f"{drag:.9g} N m"}
    if flows and oiled:
        losses["oil_flow"] = f"{flow:.9g} m^3/s"
    if sheared and oiled:
        losses["land"] = {"ring": ring, "diameter": middle, "clearance": f"{gap:.9g} m", "width": f"{width:.9g} m"}
    if caged:
        document["cage"] = {
            "pocket_clearance": f"{clearance:.9g} m",
            "wall_thickness": f"{thickness:.9g} m",
            "mass": f"{mass:.9g} kg",
            "material": "steel",
            "friction_coefficient": slippery,
            "pocket_axis": axis,
        }
    elif pocketed and oiled:
        losses["pockets"] = {"clearance": f"{clearance:.9g} m", "thickness": f"{thickness:.9g} m"}
    if losses:
        document["losses"] = losses


def least(document: dict[str, Any]) -> float:
    """The smallest axial load, N."""
    loads = document["operation"]["axial_load"]
    return min(float(load.split()[0]) for load in (loads if isinstance(loads, list) else [loads]))


def _within_washers(document: dict[str, Any]) -> None:
    """Leave the loads that a thrust bearing carries, and the speeds at which they hold the balls in their grooves."""
    operation, mass = document["operation"], size(document, "bearing.ball_mass")
    operation.pop("radial_load", None)
    operation.pop("moment", None)
    load, speed = operation["axial_load"], operation["inner_speed"]
    is_series = isinstance(load, list)
    loads, speeds = (load, speed) if is_series else ([load], [speed])
    radius = size(document, "bearing.pitch_diameter") / 2
    slowed = []
    for each, turning in zip(loads, speeds, strict=True):
        of_ball = float(each.split()[0]) / document["bearing"]["ball_count"]
        fastest = 2 * np.sqrt(0.08 * of_ball / (mass * radius))  # centrifugal force: a tenth of the load is refused
        slowed.append(f"{min(float(turning.split()[0]), fastest):.9g} rad/s")
    operation["inner_speed"] = slowed if is_series else slowed[0]


@cache
def height_map(nanometres: int, kind: Literal["gaussian", "exponential"]) -> Path:
    """A file of generated heights with this rms roughness, the same in every process."""
    path = Path(_maps().name) / f"{kind}_{nanometres}.npy"
    correlation = Autocorrelation(kind=kind, length=MAP_LENGTH, spacing=MAP_SPACING)
    found = generated_surface(
        rms_roughness=1e-9 * nanometres, autocorrelation=correlation, points=MAP_POINTS, seed=nanometres
    )
    np.save(path, found.heights)
    return path


@cache
def _maps() -> "tempfile.TemporaryDirectory[str]":
    return tempfile.TemporaryDirectory()


def toml(document: dict[str, Any], before: str = "") -> str:
    """A document of texts, numbers and lists as TOML, a line for each value."""
    lines = []
    for name, value in document.items():
        path = before + (name if name.isidentifier() else json.dumps(name))
        if isinstance(value, dict) and value:
            lines.append(toml(value, f"{path}."))
        else:
            lines.append(f"{path} = {'{}' if value == {} else json.dumps(value, ensure_ascii=False)}")
    return "\n".join(lines)
