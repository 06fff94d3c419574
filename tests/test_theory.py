"""The pages of theory: every name exists, printed numbers are computed."""

import importlib
import re
from pathlib import Path

import numpy as np
import pytest

from analytic.cage.steady import hanging_torque
from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import contact_modulus
from analytic.contact.rolling_contact import elliptic_contact
from analytic.loads.kinematics import ball_kinematics
from analytic.loads.state import approaches
from analytic.loads.thrust import thrust_equilibrium
from analytic.numerics.records import Records
from analytic.oil.film import central_film
from analytic.scene import STANDARD_GRAVITY, ContactAngle
from analytic.sliding.long_ellipse import microslip_moments
from tests.analytic.specimens import BEARING_6205 as BEARING
from tests.analytic.specimens import loaded_contacts

FOLDER = Path(__file__).resolve().parents[1] / "docs/theory"
TEXTS = {page.stem: page.read_text("utf-8") for page in sorted(FOLDER.glob("*.md"))}
ANGLE, THRUST = 0.18, 1000.0  # rad, N: of the paper


def thing(name: str) -> object:
    """What a dotted name means; an error where there is no such thing."""
    module, _, attribute = name.rpartition(".")
    try:
        return importlib.import_module(name)
    except ModuleNotFoundError:
        return getattr(importlib.import_module(module), attribute)


@pytest.mark.parametrize("page", TEXTS)
def test_every_dotted_name_exists_and_has_a_docstring(page: str) -> None:
    names = re.findall(r"\b(?:analytic|fembearing)(?:\.\w+)+", TEXTS[page])
    assert names or page == "index"
    assert [name for name in names if not thing(name).__doc__] == []


def under_thrust(angle: ContactAngle) -> Records:
    return thrust_equilibrium(BEARING, angle, axial_load=THRUST)


def says(page: str, *numbers: str) -> None:
    text = " ".join(TEXTS[page].split())
    assert [number for number in numbers if number not in text] == []


def test_the_contact_on_the_page_of_geometry_is_computed() -> None:
    thrust = under_thrust(ContactAngle(rule="given", value=ANGLE))
    says("geometry-and-contact", f"{thrust['load'][0]:.1f} N", f"{BEARING.diametral_clearance * 1e3:.3f} mm")
    for hertz in loaded_contacts(thrust):
        axes = (hertz.semi_axis_x, hertz.semi_axis_y)
        says("geometry-and-contact", *(f"{float(axis) * 1e3:.4g} mm" for axis in axes))
        says("geometry-and-contact", f"{float(hertz.peak_pressure) / 1e9:.4g} GPa")
        says("geometry-and-contact", f"{float(hertz.approach) * 1e6:.3f} um")


def test_018_rad_cannot_be_the_angle_under_load() -> None:
    thrust = under_thrust(ContactAngle(rule="given", value=ANGLE))
    distance = BEARING.groove_centre_distance
    cosine = (distance + float(approaches(thrust).sum())) / distance * np.cos(ANGLE)
    assert cosine > 1
    says("loads-and-equilibrium", f"= {cosine:.3f} > 1", f"{thrust['load'][0]:.0f} N")
    free = under_thrust(ContactAngle(rule="solved", free=ANGLE))
    says("loads-and-equilibrium", f"{free['angle'][0]:.3f} rad", f"{free['load'][0]:.0f} N")


def test_the_films_on_their_page_are_computed() -> None:
    rolling, transverse = race_curvatures(BEARING, "inner", contact_angle=ANGLE)
    motion = ball_kinematics(np.pi / 30, ANGLE, ANGLE, BEARING.pitch_diameter, BEARING.ball_diameter)
    contact = elliptic_contact(
        curvature_rolling=rolling,
        curvature_transverse=transverse,
        load=under_thrust(ContactAngle(rule="given", value=ANGLE))["load"][0],
        modulus=contact_modulus(BEARING.ball_material, BEARING.inner.material),
    )
    film = central_film(
        contact,
        entrainment_speed=np.array([100.0, 500.0]) * motion.inner_entrainment,
        viscosity=0.06,
        pressure_viscosity=2e-8,
    ).thickness
    says("film", f"{film[0] * 1e6:.4f} um at 100 1/min", f"{film[1] * 1e6:.3f} um at 500 1/min")


def test_the_moments_at_the_ends_of_the_range_are_those_of_the_table() -> None:
    def moments(spin: float) -> tuple[float, float]:
        found = microslip_moments(
            friction_force=7.0, semi_axis_transverse=3e-4, deformed_radius=0.005, spin_to_roll=spin
        )
        return float(found[0]) / (7.0 * 3e-4), float(found[1]) / (7.0 * 3e-4**2 / 0.005)

    assert moments(0.0)[0] == 0.0
    assert moments(0.61) == (0.375, 0.0)
    says("traction-and-sliding", f"{moments(0.0)[1]:.4f}", f"{4 * moments(0.0)[1]:.4f}")
    says("traction-and-sliding", f"{1 / (4 * moments(0.0)[1]):.2f} times too large")


def test_the_torque_of_a_resting_cage_is_computed() -> None:
    motion = ball_kinematics(1.0, ANGLE, ANGLE, BEARING.pitch_diameter, BEARING.ball_diameter)
    torque = hanging_torque(0.1, 6.58e-3 * STANDARD_GRAVITY, motion.ball_speed * BEARING.ball_radius, ANGLE)
    says("cage", f"{float(torque) * 1e3:.3f} N mm")
