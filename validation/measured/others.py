"""What else the torque and its parts are compared with, and what each comparison is worth."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.kinematics import ruled_motion
from analytic.loads.numbers import bearing_numbers
from analytic.loads.race_contacts import contact_under
from analytic.loads.thrust import thrust_equilibrium
from analytic.makers import case_of, scene_band, skf_parts
from analytic.oil.rolling import (
    OILED_FRICTION,
    THRUST,
    hysteresis_moment,
    replenishment_factor,
    slow_rolling_moment,
)
from analytic.scene import Array, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from validation.benchmarks.rigidity import GROOVES, axial_rigidity_of_pair
from validation.film import run as film
from validation.measured.anchor import Anchor, anchor, published_columns
from validation.measured.bearings import whole_bearings
from validation.measured.makers import makers_parts
from validation.study import SCENES, published

# Base oil and surface tension, N/m, of the two measured greases
GREASES = (
    (["102.8 cSt at 40 degC", "10.3 cSt at 100 degC"], 0.0171),
    (["474.5 cSt at 40 degC", "31.4 cSt at 100 degC"], 0.0276),
)
HERE = Path(__file__).parent


def others() -> Iterator[Anchor]:
    """All anchors but the spin-downs."""
    found = film.compare()
    films = (1e9 * each[found.judged] for each in (found.measured, found.computed, found.uncertainty))
    yield anchor("films", **dict(zip(("theirs", "ours", "uncertainty"), films, strict=True)))
    yield from whole_bearings()
    yield from _catalogues()
    yield from makers_parts()
    scene = load_scene(HERE / "thrust_51205.toml")
    ours = friction_torque(scene).torque.total
    yield anchor("thrust_catalogue", theirs=1e3 * skf_thrust_torque(scene), ours=1e3 * ours)
    yield from _rolling_formulas()
    yield from _slow_rolling()
    yield from _greased()
    rows = published_columns("gmn_axial_rigidity.csv")
    rigidity = 1e-6 * np.array([axial_rigidity_of_pair(groove, rows["preload_N"]) for groove in GROOVES])
    printed, ends = rows["axial_rigidity_of_pair_N_per_um"], {"first": GROOVES[0], "last": GROOVES[-1]}
    yield anchor("rigidity", theirs=printed, ours=rigidity, **ends)


def _catalogues() -> Iterator[Anchor]:
    for name, words in (
        ("6205_radial", "6205, 1500 N radial and 200 N axial, 100 to 1500 rpm"),
        ("6205_physical", "6205, 1000 N axial, races of Sq 1 um, 100 to 500 rpm"),
    ):
        scene = load_scene(SCENES / f"{name}.toml")
        ours = 1e3 * friction_torque(replace(scene, cage=None)).torque.total
        for model, values in scene_band(scene).values.items():
            if np.isfinite(values).any():
                key = "makers_formula" if model == "SKF" else "formula"
                yield anchor(key, theirs=1e3 * values, ours=ours, words=words, model=model)


def skf_thrust_torque(scene: Scene) -> Array:
    """SKF's torque of a thrust ball bearing, N m, without starvation."""
    case = case_of(scene)
    rolling, sliding = skf_parts(case, lubrication="oil_bath")
    known = ("bore_diameter", "outside_diameter", "ring_speed", "kinematic_viscosity")
    left = replenishment_factor(**{name: getattr(case, name) for name in known}, supply="oil_bath", geometry=THRUST)
    return rolling / left + sliding


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
        yield anchor("rolling", theirs=1e3 * other, ours=1e3 * ours, words=words)


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
            ours = np.concatenate(ratios)
            yield anchor("slow_rolling", theirs=value, ours=ours, law=law, case=case, source=source)


def _greased() -> Iterator[Anchor]:
    """Films of a greased 6209 over flooded ones, against the paper's law for all loads, which is not the model's."""
    rows = published_columns("grease_film.csv")
    for words, chosen in (("axial loads", rows["radial_N"] == 0), ("radial and both loads", rows["radial_N"] > 0)):
        ours, theirs = [], []
        for base_oil, tension in GREASES:
            grease = {"lubricant.viscosity": base_oil, "lubricant.surface_tension": f"{tension} N/m"}
            scene = load_scene(HERE / "greased_6209.toml", settings=grease)
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
        yield anchor("greased", theirs=np.array(theirs), ours=np.array(ours), words=words)


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
