"""What else the torque and its parts are compared with, and what each comparison is worth."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.kinematics import ruled_motion
from analytic.loads.numbers import bearing_numbers
from analytic.loads.race_contacts import contact_under
from analytic.loads.thrust import thrust_equilibrium
from analytic.makers import scene_band
from analytic.oil.rolling import (
    OILED_FRICTION,
    hysteresis_moment,
    inlet_shear_factor,
    per_minute,
    slow_rolling_moment,
    square_millimetres,
)
from analytic.oil.viscosity import oil_numbers
from analytic.scene import Array, Operation, Scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque
from validation.benchmarks.rigidity import GROOVES, axial_rigidity_of_pair
from validation.film import run as film
from validation.measured.anchor import Anchor, published_columns
from validation.measured.bearings import whole_bearings
from validation.measured.makers import makers_parts
from validation.study import SCENES, published

# SKF's constants of all thrust ball bearings, in the Russian text of its catalogue of 2016; mm, N, N mm
SKF_THRUST = (1.03e-6, 0.016)  # R_1, S_1
# Base oil and surface tension, N/m, of the two measured greases
GREASES = (
    ('["102.8 cSt at 40 degC", "10.3 cSt at 100 degC"]', 0.0171),
    ('["474.5 cSt at 40 degC", "31.4 cSt at 100 degC"]', 0.0276),
)
GREASED_6209 = """
name = "6209 greased"
tolerance = "5 %"
[bearing]
catalog = "6209"
[operation]
axial_load = "513 N"
inner_speed = "4000 rpm"
[lubricant]
viscosity = {oil}
base_oil = "mineral"
temperature = "61 degC"
supply = "grease"
surface_tension = "{tension} N/m"
[surface]
finish = "superfinished"
[friction]
spin_rule = "balanced"
"""
SKF_BOUNDARY, SKF_FILM = 0.12, 0.05  # mu_bl, mu_EHL [SKF2018]
THRUST_51205 = """
name = "51205, dimensions assumed"
tolerance = "5 %"
[bearing]
kind = "thrust"
ball_count = 12
ball_diameter = "7.938 mm"
pitch_diameter = "36 mm"
conformity = 0.524
bore_diameter = "25 mm"
outside_diameter = "47 mm"
[operation]
axial_load = "1000 N"
inner_speed = ["100 rpm", "500 rpm", "1500 rpm"]
[lubricant]
name = "ISO VG 68"
temperature = "40 degC"
[surface]
finish = "ground and honed"
[friction]
hysteresis_loss = 0.007
[effects]
starvation = "off"
"""


def others() -> list[Anchor]:
    """All anchors but the spin-downs."""
    return [
        _films(),
        *whole_bearings(),
        *_catalogues(),
        *makers_parts(),
        _thrust_catalogue(),
        *_rolling_formulas(),
        *_slow_rolling(),
        *_greased(),
        _rigidity(),
    ]


def _films() -> Anchor:
    found = film.compare()
    return Anchor(
        what="central film, circular contact, 0.02 to 0.7 m/s, 0.50 GPa",
        source="films measured by interferometry [Wittek]",
        kind="measured",
        theirs=1e9 * found.measured[found.judged],
        ours=1e9 * found.computed[found.judged],
        unit="nm",
        uncertainty=1e9 * found.uncertainty[found.judged],
        worth="tests the film at ellipticity 1 and 0.5 GPa; races have 0.03 to 0.07 and 1 to 3 GPa",
    )


def _catalogues() -> Iterator[Anchor]:
    for name, words in (
        ("6205_radial", "6205, 1500 N radial and 200 N axial, 100 to 1500 rpm"),
        ("6205_physical", "6205, 1000 N axial, races of Sq 1 um, 100 to 500 rpm"),
    ):
        scene = load_scene(SCENES / f"{name}.toml")
        total = friction_torque(replace(scene, cage=None)).torque.total
        for model, values in scene_band(scene).values.items():
            if np.isfinite(values).any():
                yield Anchor(
                    what=f"torque of a {words}",
                    source=model,
                    kind="maker's formula" if model == "SKF" else "formula",
                    theirs=1e3 * values,
                    ours=1e3 * total,
                    unit="N mm",
                    worth="a fit to unpublished tests of usual bearings; oil, finish and loss factor here are assumed",
                )


def _thrust_catalogue() -> Anchor:
    scene = parse_scene(THRUST_51205, origin="51205")
    return Anchor(
        what="torque of a thrust bearing 51205 as assumed, 1000 N, 100 to 1500 rpm",
        source="SKF, thrust ball bearings",
        kind="maker's formula",
        theirs=1e3 * skf_thrust_torque(scene),
        ours=1e3 * friction_torque(scene).torque.total,
        unit="N mm",
        worth="a fit to unpublished tests; number of balls, oil and finish are assumed, both without starvation",
    )


def skf_thrust_torque(scene: Scene) -> Array:
    """M_rr + M_sl of a thrust ball bearing, N m, without starvation.

    G_rr = R_1 d_m^1.83 F_a^0.54, M_rr = phi_ish G_rr (nu n)^0.6;  G_sl = S_1 d_m^0.05 F_a^(4/3), M_sl = G_sl mu,
    mu = phi_bl mu_bl + (1 - phi_bl) mu_EHL, phi_bl = exp(-2.6e-8 (n nu)^1.4 d_m);  d_m = (d + D)/2, mm, N, 1/min, mm2/s
    """
    bearing, oil, operation = scene.bearing, scene.lubricant, scene.operation.as_series()
    assert bearing.bore_diameter is not None
    assert bearing.outside_diameter is not None
    mean = (bearing.bore_diameter + bearing.outside_diameter) / 2
    kinematic = oil_numbers(oil).viscosity / oil.density
    moved = per_minute(operation.inner_speed) * square_millimetres(kinematic)
    heated = inlet_shear_factor(mean_diameter=mean, ring_speed=operation.inner_speed, kinematic_viscosity=kinematic)
    rolling = heated * SKF_THRUST[0] * (1e3 * mean) ** 1.83 * operation.axial_load**0.54 * moved**0.6
    boundary = np.exp(-2.6e-8 * moved**1.4 * 1e3 * mean)
    friction = boundary * SKF_BOUNDARY + (1 - boundary) * SKF_FILM
    sliding = SKF_THRUST[1] * (1e3 * mean) ** 0.05 * operation.axial_load ** (4 / 3)
    return (rolling + sliding * friction) / 1e3


def _rolling_formulas() -> Iterator[Anchor]:
    for name, words in (
        ("thrust_rig_3mm", "rig, balls of 3 mm"),
        ("thrust_rig_6mm", "rig, balls of 6.35 mm"),
        ("6205_radial", "6205, 1500 N radial and 200 N axial"),
    ):
        scene = load_scene(SCENES / f"{name}.toml")
        assert scene.lubricant is not None
        ours, other = (
            friction_torque(replace(scene, lubricant=replace(scene.lubricant, rolling_formula=formula))).torque.rolling
            for formula in ("numerical", "houpert")
        )
        assert ours is not None
        assert other is not None
        yield Anchor(
            what=f"rolling torque, {words}",
            source="formula of [Houpert1987]",
            kind="formula",
            theirs=1e3 * other,
            ours=1e3 * ours,
            unit="N mm",
            worth="the model against an older formula: not an error of either",
        )


def _slow_rolling() -> Iterator[Anchor]:
    """Both laws of elastic rolling against measured resistances to slow rolling."""
    laws: dict[str, list[Array]] = {"hysteresis, loss factor 0.007": [], "Houpert's law, mu = 0.05": []}
    for name in ("thrust_rig_3mm", "thrust_rig_6mm", "6205_physical"):
        scene = load_scene(SCENES / f"{name}.toml")
        contacts, scale = _contacts(scene), scene.bearing.ball_diameter
        moments = (
            hysteresis_moment(contacts, hysteresis_loss=scene.loss_factor),
            slow_rolling_moment(contacts, friction_coefficient=OILED_FRICTION),
        )
        for ratios, moment in zip(laws.values(), moments, strict=True):
            ratios.append(np.ravel(moment / (contacts.load * scale)))
    for source, case, value in measured_resistances():
        for law, ratios in laws.items():
            yield Anchor(
                what=f"elastic rolling of a contact, {law}: rig and 6205",
                source=f"slow rolling of {case} [{source}]",
                kind="second hand",
                theirs=value,
                ours=np.concatenate(ratios),
                unit="Q D",
                worth="measured with little or no oil, and slip by conformity is in it; the rig is hardly known",
            )


def _greased() -> Iterator[Anchor]:
    """Films of a greased 6209 over flooded ones, against the paper's law for all loads, which is not the model's."""
    rows = published_columns("grease_film.csv")
    for words, chosen in (("axial loads", rows["radial_N"] == 0), ("radial and both loads", rows["radial_N"] > 0)):
        ours, theirs = [], []
        for base_oil, tension in GREASES:
            scene = parse_scene(GREASED_6209.format(oil=base_oil, tension=tension), origin="6209")
            loads = {"axial_load": rows["axial_N"][chosen], "radial_load": rows["radial_N"][chosen]}
            speed = np.full(chosen.sum(), scene.operation.inner_speed[0])
            scene = replace(scene, operation=Operation(**loads, inner_speed=speed))
            found, flooded = (
                friction_torque(replace(scene, effects={"starvation": decision})) for decision in ("on", "off")
            )
            orbit, ball = scene.bearing.pitch_diameter / 2, scene.bearing.ball_radius
            moved = scene.lubricant.viscosity * speed * (orbit**2 - ball**2) / (2 * orbit)
            lengths = found.inner.semi_axis_transverse / (1e-6 * rows["z_r_um"][chosen])
            theirs.append(7.305 * (moved * lengths / tension) ** -0.34)
            ours.append(found.film.inner / flooded.film.inner)
        yield Anchor(
            what=f"film of a greased 6209 over the flooded one, two greases, 4000 rpm, {words}",
            source="law for all loads [Shetty2024]",
            kind="formula",
            theirs=np.array(theirs),
            ours=np.array(ours),
            unit="1",
            worth="both are fits to the same measured films, whose points were not read off",
        )


def measured_resistances() -> Iterator[tuple[str, str, float]]:
    """Source, case, and moment over load and ball diameter."""
    for row in published("slow_rolling_resistance.csv"):
        yield row["source"], row["case"], float(row["moment_over_load_diameter"])


def _contacts(scene: Scene) -> ContactNumbers:
    """(2,) on inner and outer race at the first operating point, at rest."""
    axial, numbers = float(scene.operation.as_series().axial_load[0]), bearing_numbers(scene.bearing)
    ball = thrust_equilibrium(scene.bearing, scene.contact_angle, axial_load=axial)[()]
    motion = ruled_motion(numbers, 1.0, *ball["angle"].tolist())
    races = (numbers.inner, motion.inner_rolling_rate), (numbers.outer, motion.outer_rolling_rate)
    contacts = [
        contact_under(race, unit, ball["angle"][side], ball["load"][side], rate, 0.0)
        for side, ((race, rate), unit) in enumerate(zip(races, (ball["inner_unit"], ball["outer_unit"]), strict=True))
    ]
    return ContactNumbers(*np.array(contacts).T)


def _rigidity() -> Anchor:
    rows = published_columns("gmn_axial_rigidity.csv")
    ours = np.array([axial_rigidity_of_pair(groove, rows["preload_N"]) for groove in GROOVES])
    return Anchor(
        what=f"axial rigidity of a preloaded pair, 100 to 600 N, groove radii {GROOVES[0]:g} to {GROOVES[-1]:g} D",
        source="a maker's catalogue [GMN]",
        kind="maker's formula",
        theirs=rows["axial_rigidity_of_pair_N_per_um"],
        ours=1e-6 * ours,
        unit="N/um",
        worth="calculated by the maker; the groove radii are not known",
    )
