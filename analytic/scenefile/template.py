"""The scene of a bearing of the catalogue, as a file to edit: `fembearing init` writes it."""

import json
import textwrap
from collections.abc import Iterator, Mapping
from typing import Any, Unpack

from analytic.catalog.bearing_rows import CatalogBearing, clearance_group, find_bearing
from analytic.catalog.suffixes import seal_contact
from analytic.errors import InputError
from analytic.given import OperatingOptions
from analytic.quantity import SI
from analytic.scene import Origin
from analytic.scenefile.find import may_be_a_bearing
from analytic.scenefile.setting import given_values
from analytic.scenefile.tables import SHOULDER
from analytic.scenefile.usual import cage_sizes, is_light, light_share, usual_values
from analytic.words import shown

SCHEMA_NAME = "fembearing-scene.schema.json"  # of the file beside the scene
GROUPS = ("CN", "C3")  # whose spans are told beside the bearing's own group
WIDTH = 118  # characters of a line
COLUMN = 41  # where comments begin

OPERATION = """\
#down = [0, 0, 1]                         # gravity along the thrust; else along the radial load, across the axis
#tilt = "free"                            # else the shaft holds the inner ring straight, or at "0.3 mrad"
#moment = "0 N m"                         # on a ring that tilts freely
"""
NAMES = "names: `fembearing list oils`"
SUPPLIES = '"oil_bath", "oil_jet", "oil_spot" or "grease"'
REST = """\

[surface]
FINISH
[friction]
LOSS#elastic_rolling = "houpert"              # Houpert's law of slow rolling in place of hysteresis

# Optional tables: remove the # of each line.

#[mounting]                               # seats and temperatures, which change the clearance
#shaft_interference = "5 um"              # on the diameter
#housing_interference = "0 um"
#inner_temperature = "65 degC"            # inner ring and shaft; give outer_temperature too
#outer_temperature = "60 degC"            # outer ring and housing

"""
MORE = """\
#drag = "2 N mm"                          # oil drag on balls and cage
#oil_share = "2 %"                        # in place of drag: volume share of oil between the rings
#oil_flow = "0.8 l/min"                   # oil flow through the bearing; leaves at the speed of the cage
#land = { ring = "inner", diameter = "LAND mm", clearance = "0.3 mm", width = "4 mm" } # oil shear, on the diameter
#pockets = { clearance = "0.2 mm", thickness = "2 mm" } # oil shear, on the diameter; not with [cage]

#[measured]                               # measured torques for `fembearing compare`
#file = "data.csv"                        # columns: inner_speed [rpm], torque [N mm], uncertainty [N mm]

#[effects]                                # "auto": where its input is there; or "on", "off"
#creep = "auto"
#rolling = "auto"
"""


def scene_text(designation: str, **options: Unpack[OperatingOptions]) -> str:
    """The scene of a bearing of the catalog, in TOML with comments, as `fembearing init` writes it.

    Parameters
    ----------
    designation : str
        As in the catalog, "6206", or with suffixes, "6305-2RS/C3".
    **options : float, str or list
        As of `load_scene`, in place of the usual values. They are not checked here.

    Returns
    -------
    str
        A whole scene for `parse_scene`; optional keys are comments.

    Raises
    ------
    InputError
        A designation that the catalog does not have.
    """
    if not may_be_a_bearing(designation):
        raise InputError(f"{shown(designation)} is no designation; give one as 6206")
    bearing = find_bearing(designation)
    given, _ = given_values({}, options)
    usual = usual_values(designation, bearing, given) | {key: _written(value) for key, value in given.items()}
    name = _quoted(designation)
    light = light_share(bearing) if is_light({*given}) else None
    accuracy = _line(f"tolerance = {_quoted(usual['tolerance'])}", "required accuracy of the torque, limit for Hertz")
    warnings = "".join(_prose(f"Note: {warning}") for warning in bearing.warnings)
    inside = f"{_play(bearing, usual)}{_dimensions(bearing)}"
    oil = _oil(usual, is_given="lubricant.name" in given)
    return "\n".join(
        (
            f"#:schema {SCHEMA_NAME}\n{_prose(_headline(bearing))}name = {name}\n{accuracy}",
            f"[bearing]\ncatalog = {name}\n{warnings}{inside}",
            f"[operation]\n{_operation(usual, light)}{OPERATION}",
            f"[lubricant]\n{oil}{_rest(usual)}{_cage(bearing)}\n{_seals(bearing)}{_more(bearing)}",
        )
    )


def _headline(bearing: CatalogBearing) -> str:
    sizes = " x ".join(f"{1e3 * size:g}" for size in (bearing.bore, bearing.outside, bearing.width))
    ratings = f"C {bearing.dynamic_load_rating / 1e3:g} kN, C0 {bearing.static_load_rating / 1e3:g} kN"
    seals = f" Seals: {bearing.seals}." if bearing.seals else ""
    return f"{bearing.designation}, {bearing.kind} ball bearing, {sizes} mm, {ratings} ({bearing.maker}).{seals}"


def _play(bearing: CatalogBearing, usual: Mapping[str, Any]) -> str:
    """The line that says how far the rings are apart."""
    if bearing.nominal_angle is not None:
        angle = f"contact_angle = {{ nominal = {_quoted(usual['bearing.contact_angle.nominal'])} }}"
        return _line(angle, "unloaded; the clearance follows from it")
    own = usual["bearing.clearance"]
    spans = "; ".join(_span(bearing, group) for group in dict.fromkeys((own, *GROUPS)))
    return _line(f"clearance = {_quoted(own)}", f"{spans}; or a length, unmounted")


def _span(bearing: CatalogBearing, group: str) -> str:
    try:
        low, high = (1e6 * end for end in clearance_group(bearing.bore, group))
    except InputError:
        return f"{group}: not known for this bore"
    return f"{group}: {low:g} to {high:g} um"


def _dimensions(bearing: CatalogBearing) -> str:
    """The dimensions inside, each as a comment that may become a key."""
    intro = (
        f"Internal dimensions, grade {bearing.grade}: remove the # of a key to give your own. +-: standard deviation."
    )
    text, told = _prose(intro), ""
    for key, value, unit in _inside(bearing):
        origin = bearing.origins[key]
        source = "from the same" if origin.source == told else origin.source
        told = origin.source
        text += _prose(f"{_standing(origin, unit)}: {source}", bullet="- ")
        text += f"#{key} = {value}\n" if value is not None else f"#{key} is not known\n"
    return text


def _inside(bearing: CatalogBearing) -> Iterator[tuple[str, str | None, str]]:
    """(key, value as in a scene file, unit) of each dimension."""
    yield "ball_count", str(bearing.ball_count), ""
    yield "ball_diameter", _millimetres(bearing.ball_diameter), "mm"
    yield "pitch_diameter", _millimetres(bearing.pitch_diameter), "mm"
    for ring, conformity, half_width in zip(
        ("inner", "outer"), bearing.conformity, bearing.shoulder_half_width, strict=True
    ):
        yield f"{ring}.conformity", f"{conformity:g}", ""
        yield f"{ring}.shoulder_half_width", _millimetres(half_width), "mm"
    for ring, half_width in zip(("inner", "outer"), bearing.far_half_width, strict=True):
        if half_width is not None:
            yield f"{ring}.far_shoulder_half_width", _millimetres(half_width), "mm"


def _millimetres(length: float | None) -> str | None:
    return None if length is None else f'"{1e3 * length:.7g} mm"'


def _standing(origin: Origin, unit: str) -> str:
    """Status and uncertainty of a dimension."""
    if not origin.uncertainty:
        return origin.status
    return f"{origin.status}, +- {origin.uncertainty * (1e3 if unit else 1):.2g} {unit}".rstrip()


def _operation(usual: Mapping[str, Any], light: float | None) -> str:
    """Loads and speed; light : the usual load over C0, where nobody gave one."""
    words = "along x, normal to the shaft"
    if light is not None:
        words = f"{'0' if usual['operation.radial_load'] == '0 N' else f'{light:g} C0, a light load'}; {words}"
    return (
        _line(f"radial_load = {_quoted(usual['operation.radial_load'])}", words)
        + _line(f"axial_load = {_quoted(usual['operation.axial_load'])}", "along the shaft, at least 0")
        + _line(
            f"inner_speed = {_quoted(usual['operation.inner_speed'])}", 'inner ring; a series: ["500 rpm", "1000 rpm"]'
        )
    )


def _oil(usual: Mapping[str, Any], *, is_given: bool) -> str:
    supply = f"supply = {_quoted(usual['lubricant.supply'])}" if "lubricant.supply" in usual else '#supply = "grease"'
    return (
        _line(f"name = {_quoted(usual['lubricant.name'])}", f"{'' if is_given else 'kappa nearest 2; '}{NAMES}")
        + _line(f"temperature = {_quoted(usual['lubricant.temperature'])}", "at the inlets of the contacts")
        + _line(supply, SUPPLIES)
    )


def _rest(usual: Mapping[str, Any]) -> str:
    """The tables of surfaces and friction, and optional ones in comments."""
    finish = _line(f"finish = {_quoted(usual['surface.finish'])}", 'or Ra = "0.05 um" of each surface')
    loss = _line(
        f"hysteresis_loss = {usual['friction.hysteresis_loss']}", "assumed; usual 0.003 to 0.025, not measured"
    )
    return REST.replace("FINISH", finish).replace("LOSS", loss)


def _cage(bearing: CatalogBearing) -> str:
    """The table of a cage in comments, scaled to the balls."""
    steel, peek = (cage_sizes(bearing, material=name) for name in ("steel", "peek"))
    if not steel:
        return ""
    millimetres = {key: f"{1e3 * steel[key]:.2g} mm" for key in ("pocket_clearance", "wall_thickness")}
    masses = [f"{float(f'{1e3 * each:.2g}'):g} g" for each in (steel["mass"], peek["mass"])]
    return (
        _line("#[cage]", "your own in place of the assumed one, scaled from the sheet cage of a 6205")
        + "".join(f'#{key} = "{length}"\n' for key, length in millimetres.items())
        + _line(f'#mass = "{masses[0]}"', f"of PEEK {masses[1]}")
        + _line('#material = "steel"', 'or "peek"')
    )


def _seals(bearing: CatalogBearing) -> str:
    """The head of the table of losses in comments, with its first key."""
    rub = any(seal_contact(suffix) != "none" for suffix in bearing.seal_suffixes)
    words = 'both seals, in place of SKF\'s formula; "off": no drag' if rub else "both seals"
    return _line("#[losses]", "known losses, added to the torque") + _line('#seals = "5 N mm"', words)


def _more(bearing: CatalogBearing) -> str:
    """The other losses and tables, in comments, with the shoulder of the inner ring."""
    land = bearing.pitch_diameter - (1 - 2 * SHOULDER) * bearing.ball_diameter
    return MORE.replace("LAND mm", f"{1e3 * land:.3g} mm")


def _written(value: object) -> Any:
    """A value as a scene file has it: a number in SI with its unit."""
    if isinstance(value, list):
        return [_written(each) for each in value]
    return repr(value) if isinstance(value, SI) else value


def _quoted(value: object) -> str:
    """A text, a number, a switch or a list of them in TOML."""
    return json.dumps(value, ensure_ascii=False)


def _line(setting: str, words: str) -> str:
    return f"{setting:<{COLUMN}} # {words}\n"


def _prose(text: str, *, bullet: str = "") -> str:
    lines = textwrap.wrap(bullet + text, WIDTH - 2, subsequent_indent=" " * len(bullet), break_on_hyphens=False)
    return "".join(f"# {line}\n" for line in lines)
