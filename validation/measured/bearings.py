"""Whole bearings: a film, heats and cage speeds that were measured, and how a radial load changes the loss."""

from collections.abc import Iterator

import numpy as np

from analytic.catalog.bearing_rows import find_bearing
from analytic.oil.variation import OIL_LOSS_FACTORS, Variation
from analytic.scene import Array, Scene
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from validation.measured.anchor import Anchor, published_columns
from validation.study import published

UNIFORM = 3**-0.5  # standard deviation over half the width of a uniform distribution
# Standard, relative: bulk modulus and reflection; the inputs' part, of the power 0.67 and 0.53 of the film
FILM_MEASURED, FILM_VISCOSITY, FILM_PRESSURE_VISCOSITY = 0.15, 0.67 * 0.1, 0.53 * 0.15  # judgement
HEAT_READ = 0.03  # relative, standard
HOT_OIL = (2e-3, 3.3e-3)  # Pa s, of the oil between the inlet and the contacts; nobody measured it
FLOW = '\n[losses]\noil_flow = "760 ml/min"\n'  # as printed
# What nobody states, from the least to the most loss, judgements: share of oil between the rings, gaps of the cage
LEAST_OIL = (
    FLOW
    + """oil_share = "0.2 %"
land = { ring = "inner", diameter = "42 mm", clearance = "0.5 mm", width = "6 mm" }
pockets = { clearance = "0.4 mm", thickness = "2.5 mm" }
"""
)
MOST_OIL = (
    FLOW
    + """oil_share = "2 %"
land = { ring = "inner", diameter = "42 mm", clearance = "0.2 mm", width = "6 mm" }
pockets = { clearance = "0.15 mm", thickness = "2.5 mm" }
"""
)
CAGE_BIAS = 3e-3  # of a cage speed, relative, as stated there
RADIAL_LOADS = (250.0, 500.0, 750.0, 1000.0, 1500.0)  # N, added to the thrust
THRUST = 1000.0  # N
SHOULDER = 0.2  # height over ball diameter, usual
FILM_6016 = """
name = "6016"
tolerance = "5 %"
[bearing]
ball_count = 14
ball_diameter = "{ball_diameter_mm} mm"
pitch_diameter = "{pitch_diameter_mm} mm"
conformity = 0.52
clearance = "0 mm"
[operation]
axial_load = "0 N"
radial_load = "15 kN"
inner_speed = "{speed_rpm} rpm"
[lubricant]
viscosity = "{viscosity_Pa_s} Pa s"
pressure_viscosity = "{pressure_viscosity_per_GPa}e-9 1/Pa"
base_oil = "mineral"
[surface]
finish = "ground and honed"
[friction]
hysteresis_loss = 0.007
"""
HEAT_35MM = """
name = "angular contact bearing, bore 35 mm"
tolerance = "5 %"
[bearing]
ball_count = 16
ball_diameter = "7.14 mm"
pitch_diameter = "46.5 mm"
inner = {{ conformity = 0.535, shoulder_height = "1.4 mm" }}
outer = {{ conformity = 0.535, shoulder_height = "1.4 mm" }}
contact_angle = {{ nominal = "24 deg" }}
[operation]
axial_load = "667 N"
inner_speed = {speeds}
[lubricant]
viscosity = "{viscosity} Pa s"
base_oil = "ester"
[surface]
finish = "superfinished"
[friction]
hysteresis_loss = 0.007
"""
CATALOGUE = """
name = "{bearing}"
tolerance = "5 %"
[bearing]
catalog = "{bearing}"
inner = {{ shoulder_height = "{shoulder} mm" }}
outer = {{ shoulder_height = "{shoulder} mm" }}
[operation]
axial_load = {axial}
radial_load = {radial}
moment = {moment}
inner_speed = "{rpm} rpm"
down = [1, 0, 0]
[lubricant]
name = "ISO VG {grade}"
temperature = "60 degC"
[surface]
finish = "ground and honed"
[friction]
hysteresis_loss = 0.007
"""


def whole_bearings() -> Iterator[Anchor]:
    yield from film_6016()
    yield heat_35mm()
    yield heat_35mm_with_oil()
    yield from cage_speeds()
    yield from radial_load_added()


def film_6016() -> Iterator[Anchor]:
    """Central film at the heaviest ball of a 6016, outer race, and the load of that ball."""
    row = published("film_6016.csv")[0]
    found = friction_torque(parse_scene(FILM_6016.format(**row), origin="6016"))
    assert found.film.outer is not None
    measured = float(row["film_um"])
    share = np.sqrt(FILM_MEASURED**2 + FILM_VISCOSITY**2 + FILM_PRESSURE_VISCOSITY**2)
    yield Anchor(
        what="central film in a 6016 at its heaviest ball, outer race, 15 kN radial, 506 rpm",
        source="ultrasound [Zhang2006]",
        kind="measured",
        theirs=measured,
        ours=1e6 * found.film.outer,
        unit="um",
        uncertainty=share * measured,
        worth="one point in a whole bearing; groove radius and clearance are assumed",
    )
    yield Anchor(
        what="load of the heaviest ball of that 6016",
        source="five times the mean load, printed in [Zhang2006]",
        kind="formula",
        theirs=float(row["ball_load_N"]),
        ours=found.ball_load,
        unit="N",
        worth="theirs is usual for a bearing with clearance, ours has none; the film hardly depends on it",
    )


def heat_scene(speeds: Array, viscosity: float, losses: str = "") -> Scene:
    """speeds : rpm;  viscosity : Pa s;  losses : a table of a scene file"""
    text = HEAT_35MM.format(speeds=[f"{rpm:g} rpm" for rpm in speeds], viscosity=viscosity)
    return parse_scene(text + losses, origin="")


def heat_35mm() -> Anchor:
    """Friction power of the races against the heat of the oil."""
    rows = published_columns("heat_35mm.csv")
    found = [friction_torque(heat_scene(rows["speed_rpm"], oil)) for oil in HOT_OIL]
    thin, thick = (each.torque.total * each.inner_speed for each in found)
    inputs = UNIFORM * (thick - thin) / 2
    numerical = found[1].numerical_uncertainty / 2 * thick  # stated is 95 %
    return Anchor(
        what="heat of an angular contact bearing, bore 35 mm, 667 N of thrust, 28 000 to 72 000 rpm",
        source="[Parker1984]",
        kind="second hand",
        theirs=rows["heat_W"],
        ours=(thin + thick) / 2,
        unit="W",
        uncertainty=np.sqrt((HEAT_READ * rows["heat_W"]) ** 2 + inputs**2 + numerical**2),
        worth="ours is the friction of the races, without oil that is accelerated, stirred and sheared at the cage",
    )


def heat_35mm_with_oil() -> Anchor:
    """The same with the losses of the oil: from thin oil, wide gaps and slow through-flow to the contrary."""
    rows = published_columns("heat_35mm.csv")
    low, high = heat_with_oil(rows["speed_rpm"])
    return Anchor(
        what="the same heat with the losses of the oil outside the contacts, for assumed gaps and shares of oil",
        source="[Parker1984]",
        kind="second hand",
        theirs=rows["heat_W"],
        ours=(low + high) / 2,
        unit="W",
        uncertainty=np.sqrt((HEAT_READ * rows["heat_W"]) ** 2 + (UNIFORM * (high - low) / 2) ** 2),
        worth=f"ours lies between {low[0]:.0f} and {high[0]:.0f} W at {rows['speed_rpm'][0]:.0f} rpm, and between "
        f"{low[-1]:.0f} and {high[-1]:.0f} W at {rows['speed_rpm'][-1]:.0f}: nobody states gaps and share of oil, "
        "so it tests little",
    )


def heat_with_oil(speeds: Array) -> tuple[Array, Array]:
    """Heat with the least and with the most loss, W; speeds : rpm"""
    ends = []
    for viscosity, losses, factor in zip(HOT_OIL, (LEAST_OIL, MOST_OIL), OIL_LOSS_FACTORS, strict=True):
        found = friction_torque(heat_scene(speeds, viscosity, losses), variation=Variation(oil_losses=factor))
        ends.append(found.torque.total * found.inner_speed)
    return ends[0], ends[1]


def cage_speeds() -> Iterator[Anchor]:
    """Cage speed over that of balls at zero contact angle that roll without slip."""
    rows = published("cage_speed.csv")
    for known, words, worth in (
        (True, "6203, 400 and 1000 N radial", "bounds the mean slip of the balls, 0 in the model, to some 0.5 %"),
        (False, "6205 and 6203, load unknown", "tests no slip: a contact angle of 8 to 9 degrees would explain it"),
    ):
        own = [row for row in rows if bool(row["radial_N"]) is known]
        yield Anchor(
            what=f"cage speed over that of pure rolling at zero contact angle, {words}",
            source="vibration records [PhysGate]",
            kind="second hand",
            theirs=np.array([1 - float(row["slip_percent"]) / 100 for row in own]),
            ours=np.array([rolling_cage(row) for row in own]),
            unit="1",
            uncertainty=CAGE_BIAS,
            worth=worth,
        )


def rolling_cage(row: dict[str, str]) -> float:
    """(1 - g cos a)/(1 - g), g = D/d_m, with the loaded contact angle a; 1 where the load is not known."""
    bearing = find_bearing(row["bearing"])
    if not row["radial_N"]:
        return 1.0
    loads = {"axial": '"0 N"', "radial": f'"{row["radial_N"]} N"', "moment": '"0 N m"', "rpm": row["speed_rpm"]}
    shoulder = 1e3 * SHOULDER * bearing.ball_diameter
    text = CATALOGUE.format(bearing=row["bearing"], shoulder=shoulder, grade=32, **loads)
    found = friction_torque(parse_scene(text, origin=row["bearing"]))
    share = bearing.ball_diameter / bearing.pitch_diameter
    return float((1 - share * np.cos(found.contact_angle[0])) / (1 - share))


def radial_load_added() -> Iterator[Anchor]:
    """Torque with a radial load over that without it, in whole and by rolling; the load acts at the load centre."""
    totals, rolling = [], []
    radial = np.array([0.0, *RADIAL_LOADS])
    for name in ("NSK 7210 C", "NSK 7210 A5"):
        bearing = find_bearing(name)
        assert bearing.nominal_angle is not None
        moment = -radial * np.tan(bearing.nominal_angle) * bearing.pitch_diameter / 2  # else the ring tilts
        loads = {
            "shoulder": 1e3 * SHOULDER * bearing.ball_diameter,
            "axial": [f"{THRUST:g} N"] * radial.size,
            "radial": [f"{each:g} N" for each in radial],
            "moment": [f"{each:g} N m" for each in moment],
        }
        for rpm in (2000, 8000):
            found = friction_torque(
                parse_scene(CATALOGUE.format(bearing=name, rpm=rpm, grade=46, **loads), origin=name)
            )
            for ratios, part in ((totals, found.torque.total), (rolling, found.torque.rolling)):
                assert part is not None
                ratios.append(part[1:] / part[0])
    for words, ours in (("torque", totals), ("rolling", rolling)):
        yield Anchor(
            what=f"{words} of NSK 7210 C and A5 with 250 to 1500 N radial beside 1000 N of thrust over that without",
            source="power losses that do not change [Darul2024]",
            kind="trend",
            theirs=1.0,
            ours=np.array(ours),
            unit="1",
            worth="in words, for N d_m up to 1e6 and loads up to 5 % of C0, no numbers; the load at the load centre",
        )
